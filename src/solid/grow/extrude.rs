//! Extrusion of selected faces, by the two primitives.
//!
//! ```text
//!          │ inner                    │ inner                       │ inner
//!          │ edges                    │                             │
//!      S   │   S               S    w ●    S                 S    w ●─────────●  S
//!          │              ==>         │                ==>          │  wall   │
//!   ──●────●────●──            ──●────●────●──               ──●────●────●────●──
//!       not S  v  e                   v   e                         v   e
//! ```
//!
//! 1. Every corner v of the border of the selection S: split v, so that all edges strictly inside S move to the new
//!    vertex w (a spur, if there are none). Then the faces of S run w, v, along each border edge, and up again.
//! 2. Every border edge e: split its face from the second w to the first. The part with e is the wall.
//!
//! The selected faces keep their ids: they are the caps. Where S touches a vertex twice, it gets two new ones.

use super::{GrowError, Primitives};
use crate::geometry::grouping::sorted;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::solid::Selection;

/// A new face beside an extruded one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Wall {
    /// The wall.
    pub face: FaceId,
    /// Its half-edge at the foot: the old border of the selection.
    pub foot: HalfEdgeId,
    /// The face beyond the foot, which was not selected.
    pub below: FaceId,
}

/// What [`extrude`] made.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Extruded {
    /// For each corner of the border: the old vertex at the foot and the new one above it.
    pub lifted: Vec<(VertexId, VertexId)>,
    /// The vertices with selected faces all round, each once: they belong to the caps and move with them.
    pub inner: Vec<VertexId>,
    /// The walls, one for each border edge.
    pub walls: Vec<Wall>,
}

/// Lifts the faces that have a bit of `mask` in `selection`: their border is doubled and joined by walls of four
/// sides. The caller moves the new vertices where they belong.
///
/// With b border edges: V + b, E + 2b, F + b. Cost: O(length of the selection + sides of the selected faces), and a sort
/// of their vertices.
///
/// # Errors
/// [`GrowError`]: a selected face does not exist or has fewer than three sides, there is no border, or the structure
/// is full.
///
/// ```
/// use dcel_kit::{FaceId, solid::{Selection, grow::extrude}, topology::Dcel};
/// let mut cube = Dcel::polygon(4)?;
/// let mut top = Selection::new();
/// top.add(FaceId::new(1), 1);
/// let made = extrude(&mut cube, &top, 1)?;
/// assert_eq!((made.lifted.len(), made.walls.len()), (4, 4));
/// assert_eq!((cube.vertex_count(), cube.edge_count(), cube.face_count()), (8, 12, 6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn extrude(on: &mut impl Primitives, selection: &Selection<FaceId>, mask: u8) -> Result<Extruded, GrowError> {
    extrude_faces(on, selection.ids(mask), |f| selection.has(f, mask))
}

/// [`extrude`] for who knows the selected faces without a look at all: `is_in` is true for `faces` and no others.
pub(super) fn extrude_faces(
    on: &mut impl Primitives,
    faces: impl IntoIterator<Item = FaceId>,
    is_in: impl Fn(FaceId) -> bool,
) -> Result<Extruded, GrowError> {
    let dcel = on.dcel();
    let mut border = Vec::new();
    let mut touched = Vec::new();
    let mut selected = 0;
    for face in faces {
        dcel.check(face)?;
        selected += 1;
        let first = border.len();
        let mut sides = 0;
        for h in dcel.incident_half_edges(face) {
            sides += 1;
            touched.push(dcel.origin(h));
            if !is_in(dcel.face(h.twin())) {
                border.push(h);
            }
        }
        if sides < 3 && border.len() > first {
            return Err(GrowError::FewSides { h: border[first], face, sides, least: 3 });
        }
    }
    if border.is_empty() {
        return Err(GrowError::NoBorder { selected, faces: dcel.face_count() });
    }
    dcel.room_for(border.len(), 2 * border.len(), border.len())?;
    let rim: Vec<VertexId> = sorted(border.iter().map(|&h| dcel.origin(h)).collect());
    let mut touched = sorted(touched);
    touched.retain(|v| rim.binary_search(v).is_err());

    let mut lifted = Vec::with_capacity(border.len());
    for &h in &border {
        let dcel = on.dcel();
        let first = dcel.ccw(h);
        let mut last = first;
        while is_in(dcel.face(last)) {
            last = dcel.ccw(last);
        }
        let foot = dcel.origin(h);
        let (_, top) = on.split_vertex(first, last)?;
        lifted.push((foot, top));
    }
    let mut walls = Vec::with_capacity(border.len());
    for &foot in &border {
        let dcel = on.dcel();
        let below = dcel.face(foot.twin());
        let (down, after_up) = (dcel.prev(foot), dcel.next(dcel.next(foot)));
        let (_, face) = on.split_face(after_up, down)?;
        walls.push(Wall { face, foot, below });
    }
    Ok(Extruded { lifted, inner: touched, walls })
}
