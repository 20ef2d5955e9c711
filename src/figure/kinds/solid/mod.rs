//! Solids in the look of all figures: what the eye sees as a half-edge structure, what is hidden as dashed lines.
//!
//! ```text
//!        ●─────────●          faces that are seen whole: tints, half-edges, names, as in the structure figure
//!       ╱ ╲  f2   ╱│          edges, or parts of edges, behind faces: dashed, or left out
//!      ●───●─────● │          seen parts of other edges: plain lines
//!      │ ┊    f0 │f1
//!      │ ●┄┄┄┄┄┄┄│┄●
//!      ●─────────●╱
//! ```
//!
//! Which part of an edge is hidden is found by cutting it where it passes behind an outline, and asking for each part
//! whether a face is in front of it. This is right for every surface that does not pass through itself.

mod camera;
mod hidden;
mod inside;
mod tree;

pub use crate::figure::kinds::solid::camera::Camera;

use crate::figure::kinds::solid::hidden::{Piece, Seen};
use crate::figure::sketch::{Backdrop, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::ids::{VertexId, VertexMap};
use crate::plane::{PlanarView, Point};
use crate::solid::Polyhedron;
use crate::topology::{Dcel, View};

/// What becomes of hidden lines.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum HiddenLines {
    /// They are dashed.
    #[default]
    Dashed,
    /// They are left out.
    LeftOut,
}

/// Draws a solid as `camera` sees it. The title of the options is that of the figure; if they choose faces, only
/// those of them are drawn as faces.
///
/// Cost: O(E) for convex solids. For others about O((E + k) log E), if edges pass in front of or behind outlines at k
/// places of the paper: faces and outlines are found by trees over their boxes. That is so where faces are about as long
/// as wide. Where very many long narrow walls stand behind each other, as in a comb, k is up to E², and boxes overlap, so
/// that each place costs up to O(E).
///
/// # Errors
/// [`SketchError`]: a solid without vertices has nothing to draw.
///
/// ```
/// use dcel_kit::figure::{Camera, FigureOptions, HiddenLines, solid};
/// use dcel_kit::solid::{Platonic, Polyhedron};
/// let cube = Polyhedron::platonic(Platonic::Cube);
/// let figure = solid(&cube, &Camera::default(), HiddenLines::Dashed, &FigureOptions::new("A cube"))?;
/// assert!(figure.to_svg().contains("data-origin"));
/// # Ok::<(), dcel_kit::figure::sketch::SketchError>(())
/// ```
pub fn solid(
    solid: &Polyhedron,
    camera: &Camera,
    lines: HiddenLines,
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    let view = camera.view(solid);
    let seen = Seen::new(solid, &view);
    let mut sketch = Sketch::new();
    for Piece { ends, is_hidden } in &seen.pieces {
        let path = match (*is_hidden, lines) {
            (true, HiddenLines::LeftOut) => continue,
            (true, HiddenLines::Dashed) => sketch.path(Role::Dimmed, *ends).dashed(),
            (false, _) => sketch.path(Role::Plain, *ends),
        };
        path.title(if *is_hidden { "hidden edge" } else { "edge" });
    }
    let projected = Projected { dcel: solid.topology(), points: view.points };
    let chosen = options.faces.clone();
    let faces = seen.faces.into_iter().filter(|f| chosen.as_ref().is_none_or(|chosen| chosen.contains(f)));
    let options = options.clone().faces(faces);
    sketch.over(&projected, Backdrop::Plain, &options)
}

/// A solid with the positions of its picture.
struct Projected<'a> {
    dcel: &'a Dcel,
    points: VertexMap<Point>,
}

impl View for Projected<'_> {
    crate::topology::pointers_of_dcel!(dcel);
}

impl PlanarView for Projected<'_> {
    fn position(&self, v: VertexId) -> Option<Point> {
        self.has_vertex(v).then(|| self.points[v])
    }
}
