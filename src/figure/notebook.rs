//! What Rust's kernel for Jupyter, evcxr, shows of a value that stands at the end of a cell.
//!
//! ```text
//!   In [2]:  lab                        the kernel calls evcxr_display, and reads from what it prints
//!   Out[2]:  ┌─────────┐                  EVCXR_BEGIN_CONTENT image/svg+xml
//!            │ picture │                  …
//!            └─────────┘                  EVCXR_END_CONTENT
//! ```
//!
//! Source: evcxr's own pages, *Evcxr Jupyter Kernel*, section "Custom output". `examples/notebook.ipynb` is a notebook.

use crate::figure::{self, Figure, FigureError, FigureOptions, Page, escaped};
use crate::plane::Subdivision;
use std::fmt::Display;
use std::sync::atomic::{AtomicU32, Ordering};

/// The height of a page in a notebook, in px.
const PAGE: u32 = 620;

/// Pictures of structures so far: each has ids of its own, for all stand in one page.
static PICTURES: AtomicU32 = AtomicU32::new(0);

/// One piece of output, as the kernel reads it.
fn content(kind: &str, text: &str) -> String {
    format!("EVCXR_BEGIN_CONTENT {kind}\n{}\nEVCXR_END_CONTENT", text.trim_end())
}

fn svg(figure: &Figure) -> String {
    content("image/svg+xml", &figure.to_svg())
}

/// A frame, so that the style and the script of the page stay in it.
fn framed(page: &str) -> String {
    let page = escaped(page);
    let frame = format!(
        "<iframe title=\"a structure to walk in\" srcdoc=\"{page}\" style=\"width:100%;height:{PAGE}px;border:0\">\
         </iframe>"
    );
    content("text/html", &frame)
}

/// The picture, or the reason why there is none.
fn picture<E: Display>(name: &str, draw: impl FnOnce(&FigureOptions) -> Result<Figure, E>) -> String {
    let number = PICTURES.fetch_add(1, Ordering::Relaxed) + 1;
    match draw(&FigureOptions::new(format!("{name} {number}"))) {
        Ok(figure) => svg(&figure),
        Err(error) => content("text/plain", &format!("no picture: {error}")),
    }
}

impl Figure {
    /// Shows the figure below the cell of a notebook. Two figures of one title have the same ids: give them titles of
    /// their own. `println!("{}", figure.to_svg())` writes the SVG anywhere else.
    pub fn evcxr_display(&self) {
        println!("{}", svg(self));
    }
}

impl Page {
    /// Shows the page in a frame below the cell of a notebook.
    pub fn evcxr_display(&self) {
        println!("{}", framed(self.to_html()));
    }
}

impl Subdivision {
    /// Shows the structure below the cell of a notebook, as [`figure::structure`](figure::structure()) draws it.
    pub fn evcxr_display(&self) {
        println!("{}", picture::<FigureError>("Subdivision", |options| figure::structure(self, options)));
    }
}

#[cfg(feature = "solid")]
impl crate::solid::Polyhedron {
    /// Shows the solid below the cell of a notebook, as [`figure::solid`] draws it from the usual place, with hidden
    /// lines dashed.
    pub fn evcxr_display(&self) {
        let draw = |options: &FigureOptions| {
            figure::solid(self, &figure::Camera::default(), figure::HiddenLines::default(), options)
        };
        println!("{}", picture("Polyhedron", draw));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn output_stands_between_two_lines_that_the_kernel_knows() {
        let lab = Subdivision::lab_rectangle();
        let draw = |options: &FigureOptions| figure::structure(&lab, options);
        let [first, second] = [picture("Lab", draw), picture("Lab", draw)];
        for shown in [&first, &second] {
            let lines: Vec<&str> = shown.lines().collect();
            assert_eq!(lines[0], "EVCXR_BEGIN_CONTENT image/svg+xml");
            assert!(lines[1].starts_with("<svg"), "{}", lines[1]);
            assert_eq!(lines[lines.len() - 2..], ["</svg>", "EVCXR_END_CONTENT"]);
        }
        assert_ne!(first, second, "ids of their own");
    }

    #[test]
    fn a_structure_without_a_picture_says_why() {
        let shown = picture("None", |_| {
            Err::<Figure, _>(FigureError::NoPosition { vertices: 3, example: crate::ids::VertexId::new(0) })
        });
        assert!(shown.starts_with("EVCXR_BEGIN_CONTENT text/plain\nno picture: none of the 3 vertices"), "{shown}");
    }

    #[test]
    fn a_page_stays_in_its_frame() {
        let page = figure::page(&Subdivision::lab_rectangle(), &FigureOptions::new("Lab")).unwrap();
        let shown = framed(page.to_html());
        assert!(shown.starts_with("EVCXR_BEGIN_CONTENT text/html\n<iframe title="));
        assert_eq!(shown.matches('<').count(), 2, "everything of the page is escaped");
    }
}
