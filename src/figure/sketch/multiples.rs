//! Small multiples: pictures of one layout side by side, to be compared place by place.
//!
//! ```text
//!   before                  the cone                after
//!   ┌──────────────┐        ┌──────────────┐        ┌──────────────┐
//!   │  ●       ●   │        │  ●  ◢▒▒▒▒●   │        │  ●────────●  │    one scale, one frame;
//!   └──────────────┘        └──────────────┘        └──────────────┘    FIG-p1-… FIG-p2-… FIG-p3-…
//! ```

use crate::figure::canvas::crop;
use crate::figure::canvas::scene::Node;
use crate::figure::canvas::vector::Xy;
use crate::figure::layout::crowd::{Crowd, INK};
use crate::figure::layout::fit::Fit;
use crate::figure::layout::grid::{self, Panel};
use crate::figure::sketch::{self, Backdrop, Canvas, Drawing, Entry, Role, Sketch, SketchError};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::picture::Picture;
use crate::figure::structure::skeleton::vertices;
use crate::figure::{Detail, Figure, FigureError, FigureOptions};
use crate::plane::{PlanarView, Point};

/// Panels of one layout: sketches, structures, or both in one.
///
/// ```
/// use dcel_kit::figure::FigureOptions;
/// use dcel_kit::figure::sketch::{Multiples, Role, Sketch};
/// use dcel_kit::plane::Subdivision;
///
/// let lab = Subdivision::lab_rectangle();
/// let mut path = Sketch::new();
/// path.path(Role::Main, [[-200.0, -100.0], [200.0, 100.0]]);
/// let mut panels = Multiples::new();
/// panels.structure("1", "the domain", &lab);
/// panels.sketch("2", "the path alone", path);
/// let svg = panels.figure(&FigureOptions::new("Steps"))?.to_svg();
/// assert!(svg.contains("id=\"steps-p1-h0\"") && svg.contains("id=\"steps-p2-s-path-1\""));
/// # Ok::<(), dcel_kit::figure::sketch::SketchError>(())
/// ```
#[derive(Default)]
pub struct Multiples<'a> {
    panels: Vec<Content<'a>>,
    columns: Option<usize>,
}

/// Panels that are drawn, and not yet arranged.
pub(in crate::figure) struct Drawn {
    pub(in crate::figure) panels: Vec<Panel>,
    pub(in crate::figure) fit: Fit,
    pub(in crate::figure) detail: Detail,
    pub(in crate::figure) roles: Vec<Role>,
    pub(in crate::figure) legend: Vec<Entry>,
    pub(in crate::figure) notes: Vec<String>,
}

/// The structure of a panel, and how it lies under the sketch.
type Under<'a> = Option<(&'a dyn PlanarView, Backdrop)>;

struct Content<'a> {
    heading: String,
    text: String,
    view: Under<'a>,
    sketch: Sketch,
}

impl<'a> Multiples<'a> {
    /// No panels yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    fn add(&mut self, heading: &str, text: &str, view: Under<'a>, sketch: Sketch) -> &mut Self {
        let [heading, text] = [heading, text].map(crate::figure::canvas::text::clean);
        self.panels.push(Content { heading, text, view, sketch });
        self
    }

    /// A panel with a sketch.
    pub fn sketch(&mut self, heading: &str, text: &str, sketch: Sketch) -> &mut Self {
        self.add(heading, text, None, sketch)
    }

    /// A panel with a structure.
    pub fn structure(&mut self, heading: &str, text: &str, view: &'a dyn PlanarView) -> &mut Self {
        self.add(heading, text, Some((view, Backdrop::Plain)), Sketch::new())
    }

    /// A panel with a sketch over a structure.
    pub fn over(
        &mut self,
        heading: &str,
        text: &str,
        view: &'a dyn PlanarView,
        backdrop: Backdrop,
        sketch: Sketch,
    ) -> &mut Self {
        self.add(heading, text, Some((view, backdrop)), sketch)
    }

    /// How many panels stand side by side. Default: as many as a page of 830 px holds, two of the usual width.
    pub fn columns(&mut self, columns: usize) -> &mut Self {
        self.columns = Some(columns.max(1));
        self
    }

    /// Draws the panels. All have the scale and the frame that hold everything in any of them, and the least detail
    /// that one of their structures needs. `width` is that of one panel. Ids read `FIG-p1-…` in the first panel.
    /// Badges are numbered through; one legend serves all.
    ///
    /// # Errors
    /// Those of [`Sketch::over`].
    pub fn figure(&self, options: &FigureOptions) -> Result<Figure, SketchError> {
        let options = &options.of_panels();
        let Drawn { panels, fit, detail, roles, legend, notes } = self.drawn(options)?;
        let usual = || grid::columns(panels.len(), fit.size.x);
        let columns = options.columns.or(self.columns).unwrap_or_else(usual);
        let (nodes, size) = grid::arrange(panels, fit.size, columns);
        let mut scene = sketch::scene(options, "dcel-multiples", (size, fit.scale), &roles, nodes, &legend);
        if options.description.is_none() {
            let headings: Vec<&str> = self.panels.iter().map(|panel| panel.heading.as_str()).collect();
            scene.description = format!("Panels: {}. {}", headings.join("; "), scene.description);
        }
        Ok(Figure { scene, detail, notes })
    }

    /// The drawings, each on a canvas of the size of the fit.
    pub(in crate::figure) fn drawn(&self, options: &FigureOptions) -> Result<Drawn, SketchError> {
        let mut points: Vec<Point> = Vec::new();
        for panel in &self.panels {
            sketch::check(&panel.sketch)?;
            points.extend(sketch::extent(&panel.sketch));
            points.extend(panel.view.iter().flat_map(|(view, _)| vertices(*view).filter_map(|v| view.position(v))));
        }
        let (fit, detail) = self.layout(points, options)?;
        let mut notes = Notes::default();
        let (mut first, mut legends, mut drawn) = (1, Vec::new(), Vec::new());
        for (i, panel) in self.panels.iter().enumerate() {
            let name = format!("p{}", i + 1);
            let canvas = Canvas::new(fit, options);
            let mut drawing = Drawing::new(&panel.sketch, &canvas);
            let ink = drawing.ink();
            let words = |crowd: &mut Crowd, drawing: &mut Drawing<'_>| {
                drawing.nodes(crowd, options.style.map_text, first, &format!("{name}-"))
            };
            let mut nodes = if let Some((view, backdrop)) = panel.view {
                let survey = Picture::survey(view, options, Vec::new())?;
                let (picture, noted) = survey.place(view, options, fit, detail);
                let mut below = sketch::Below::new(picture, noted, &backdrop.look(&name), &ink);
                add_notes(&mut notes, &name, below.notes.0);
                backdrop.layers(below.nodes, words(&mut below.crowd, &mut drawing))
            } else {
                let mut crowd = Crowd::new(fit.size);
                crowd.add_all(ink, INK);
                words(&mut crowd, &mut drawing)
            };
            nodes.push(frame(fit.size));
            add_notes(&mut notes, &name, drawing.notes.0);
            legends.push(panel.sketch.legend(first));
            first += panel.sketch.badges();
            let (heading, text) = (panel.heading.clone(), panel.text.clone());
            drawn.push(Panel { heading, text, id: Some(name), nodes });
        }
        let roles = sketch::roles(self.panels.iter().map(|panel| &panel.sketch));
        Ok(Drawn { panels: drawn, fit, detail, roles, legend: sketch::merged(legends), notes: notes.0 })
    }

    /// One fit for all: that of the structure that needs most, or of the sketches if there is none.
    fn layout(&self, points: Vec<Point>, options: &FigureOptions) -> Result<(Fit, Detail), FigureError> {
        let views = self.panels.iter().filter_map(|panel| panel.view);
        let fits = views.map(|(view, _)| Ok(Picture::survey(view, options, points.clone())?.choose(options)));
        Ok(common_fit(fits.collect::<Result<_, FigureError>>()?).unwrap_or_else(|| sketch::lone_fit(points, options)))
    }
}

/// The fit of the picture with the least detail, and among these the largest one.
pub(in crate::figure) fn common_fit(fits: Vec<(Fit, Detail)>) -> Option<(Fit, Detail)> {
    fits.into_iter().min_by(|(fit, detail), (other, least)| detail.cmp(least).then(other.scale.total_cmp(&fit.scale)))
}

/// A thin line round a panel.
fn frame(size: Xy) -> Node {
    let corners = crop::window(size).grown(-0.5).corners();
    Node::Area { class: "frame", hatch: None, outlines: vec![corners.to_vec()] }
}

fn add_notes(notes: &mut Notes, panel: &str, new: Vec<String>) {
    notes.0.extend(new.into_iter().map(|note| format!("{panel}: {note}")));
}
