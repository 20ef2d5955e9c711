//! Solids in the look of all figures: what the eye sees as a half-edge structure, what is hidden as dashed lines.
//!
//! ```text
//!        ●─────────●          faces that are seen whole: tints, half-edges, names, as in the structure figure
//!       ╱ ╲  f2   ╱│          edges, or parts of edges, behind faces: dashed, or left out
//!      ●───●─────● │          seen parts of other edges: plain lines
//!      │ ┊    f0 │f1
//!      │ ●┄┄┄┄┄┄┄│┄●
//!      ●─────────●╱           seen parts of other faces: grey
//! ```
//!
//! Which part of an edge is hidden is found by cutting it where it passes behind an outline, and asking for each part
//! whether a face is in front of it. This is right for every surface that does not pass through itself.
//!
//! ```text
//!   camera.rs  Where a solid is looked at from, and how it falls on the paper
//!   seen.rs    What is seen: whole faces, parts of faces, parts of edges
//!   hidden.rs  Which parts of edges are hidden
//!   parts.rs   The visible parts of faces that are partly hidden
//!   inside.rs  Whether a place of the paper lies in a face, by the number of its sides to the right
//!   tree.rs    Boxes in a balanced tree, to find the few that matter at a place of the paper
//! ```

mod camera;
mod hidden;
mod inside;
mod parts;
mod seen;
mod tree;

pub use crate::figure::kinds::solid::camera::Camera;
pub(in crate::figure) use crate::figure::kinds::solid::camera::UP;

use crate::figure::kinds::solid::seen::{Piece, Seen};
use crate::figure::sketch::{Backdrop, Role, Sketch, SketchError};
use crate::figure::{FaceLabels, Figure, FigureOptions};
use crate::ids::{FaceId, VertexId};
use crate::plane::{PlanarView, Point};
use crate::solid::Polyhedron;
use crate::topology::{Dcel, View};

/// Solids with more faces than this show no names: the tooltips have them.
const NAMED: usize = 60;

/// What becomes of hidden lines.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[non_exhaustive]
pub enum HiddenLines {
    /// They are dashed.
    #[default]
    Dashed,
    /// They are left out.
    LeftOut,
}

/// Draws a solid as `camera` sees it. The title of the options is that of the figure; if they choose faces, only
/// those of them are drawn as faces. What is seen of a face that is partly hidden is grey. Solids with more than 60 faces
/// show no names.
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
    let Shown { sketch, projected, faces } = Shown::new(solid, camera.view(solid), lines);
    let chosen = options.faces.clone();
    let faces = faces.into_iter().filter(|f| chosen.as_ref().is_none_or(|chosen| chosen.contains(f)));
    let mut options = options.clone().faces(faces);
    if solid.face_count() > NAMED {
        options = options.vertex_labels(false).half_edge_labels(false).face_labels(FaceLabels::Off);
    }
    sketch.over(&projected, Backdrop::InFront, &options)
}

/// What is to be drawn of a solid.
pub(in crate::figure) struct Shown<'a> {
    /// The edges, or parts of edges, that are no sides of faces that are drawn.
    pub(in crate::figure) sketch: Sketch,
    pub(in crate::figure) projected: Projected<'a>,
    /// The faces that are seen whole.
    pub(in crate::figure) faces: Vec<FaceId>,
}

impl<'a> Shown<'a> {
    fn new(solid: &'a Polyhedron, view: camera::Picture, lines: HiddenLines) -> Self {
        let seen = Seen::new(solid, &view);
        let mut sketch = Sketch::new();
        for part in &seen.parts {
            sketch.region(Role::Plain, part.iter().map(|ring| ring.iter().copied())).plain().title("partly seen face");
        }
        for Piece { ends, is_hidden } in &seen.pieces {
            let path = match (*is_hidden, lines) {
                (true, HiddenLines::LeftOut) => continue,
                (true, HiddenLines::Dashed) => sketch.path(Role::Dimmed, *ends).dashed(),
                (false, _) => sketch.path(Role::Plain, *ends).as_edge(),
            };
            path.title(if *is_hidden { "hidden edge" } else { "edge" });
        }
        Self { sketch, projected: Projected { dcel: solid.topology(), view }, faces: seen.faces }
    }

    /// Where a point in space falls on the paper.
    pub(in crate::figure) fn place(&self, p: [f64; 3]) -> Point {
        self.projected.view.place(p)
    }

    /// Where the vertices are on the paper.
    pub(in crate::figure) fn points(&self) -> impl Iterator<Item = Point> {
        self.projected.dcel.vertices().map(|v| self.projected.view.points[v])
    }
}

impl Camera {
    /// Several states of one solid, seen from one place: that from which the first of them is seen. The direction `up`
    /// points up on the paper.
    pub(in crate::figure) fn film<'a>(
        &self,
        solids: &'a [Polyhedron],
        lines: HiddenLines,
        up: [f64; 3],
    ) -> Vec<Shown<'a>> {
        let first = solids.first().map(camera::Whole::of).unwrap_or_default();
        let show = |solid| Shown::new(solid, self.view_of(solid, first, up), lines);
        solids.iter().map(show).collect()
    }
}

/// A solid with the positions of its picture.
pub(in crate::figure) struct Projected<'a> {
    dcel: &'a Dcel,
    view: camera::Picture,
}

impl View for Projected<'_> {
    crate::topology::pointers_of_dcel!(dcel);
}

impl PlanarView for Projected<'_> {
    fn position(&self, v: VertexId) -> Option<Point> {
        self.has_vertex(v).then(|| self.view.points[v])
    }
}
