//! Frames of surfaces in space: all seen from one place, at one scale.
//!
//! ```text
//!   start          remove_face f0          extrude_face f1 1
//!   ┌───────┐      ┌───────┐               ┌───────┐        new elements in the colour of what is new; hidden lines
//!   │ cube  │      │  box  │               │       │        dashed, as in the figure of a solid
//!   └───────┘      └───────┘               └───────┘
//! ```

use super::frames::Frame;
use crate::figure::canvas::scene::{Node, Scene};
use crate::figure::kinds::solid::{Camera, HiddenLines, Shown, UP};
use crate::figure::sketch::{self, Backdrop, Canvas, Drawing};
use crate::figure::structure::look::Mark;
use crate::figure::structure::part::Part;
use crate::figure::structure::picture::Picture;
use crate::figure::{Detail, FigureError, FigureOptions};
use crate::plane::{PlanarView, Point};
use crate::solid::Polyhedron;

/// The scene of one frame, what is drawn in each, and with how much detail.
pub(super) fn draw(
    solids: &[Polyhedron],
    frames: &[Frame],
    options: &FigureOptions,
) -> Result<(Scene, Vec<Vec<Node>>, Detail), FigureError> {
    let shown: Vec<Shown<'_>> = Camera::default().film(solids, HiddenLines::Dashed, UP);
    let points: Vec<Point> = shown.iter().flat_map(Shown::points).collect();
    let fits = shown.iter().map(|state| {
        let part: &dyn PlanarView = &Part::new(&state.projected, &state.faces)?;
        Ok(Picture::survey(part, options, points.clone())?.choose(options))
    });
    let fit = sketch::common_fit(fits.collect::<Result<_, FigureError>>()?);
    let (fit, detail) = fit.unwrap_or_else(|| sketch::lone_fit(points.clone(), options));
    let mut drawings = Vec::with_capacity(frames.len());
    for (i, frame) in frames.iter().enumerate() {
        let Shown { sketch, projected, faces } = &shown[frame.areas];
        let mut look = Backdrop::InFront.look(&i.to_string());
        for (elements, mark) in [(&frame.marked, Mark::Hot), (&frame.added, Mark::New)] {
            elements.iter().for_each(|&element| look.mark(element, mark));
        }
        let canvas = Canvas::new(fit, options);
        let mut drawing = Drawing::new(sketch, &canvas);
        let part: &dyn PlanarView = &Part::new(projected, faces)?;
        let (picture, notes) = Picture::survey(part, options, points.clone())?.place(part, options, fit, detail);
        let mut below = sketch::Below::new(picture, notes, &look, &drawing.ink());
        let lines = drawing.nodes(&mut below.crowd, options.style.map_text, 1, &format!("{i}-"));
        drawings.push(Backdrop::InFront.layers(below.nodes, lines));
    }
    let roles = sketch::roles(shown.iter().map(|state| &state.sketch));
    let scene = sketch::scene(options, "dcel-strip", (fit.size, fit.scale), &roles, Vec::new(), &[]);
    Ok((scene, drawings, detail))
}
