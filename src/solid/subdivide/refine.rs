//! The connectivity of the finer surface, by formulas.
//!
//! Every half-edge h of the coarse surface gives a corner, and two halves of an edge:
//!
//! ```text
//!                        ●──────E(prev h)────── ...        E(h): the vertex on the edge of h
//!            prev(h) of  │         │                       edge number h  =  (2h, 2h + 1)
//!             the coarse │ corner  │ spoke(h)                2h      origin(h) -> E(h)
//!              surface   │  of h   v                         2h + 1  E(h) -> origin(h)
//!                        ●───2h───>E(h)───────> ...
//!                   origin(h)      h of the coarse surface
//! ```
//!
//! Half-edges of boundary faces have no corner. The others are counted: h is corner number k(h). Face number k is
//! the corner's; beside the 2E half edges, edge number 2E + k is its inner edge: from E(h) to the middle of the face
//! (Catmull–Clark), or from E(h) to E(prev h) (Loop). Boundary faces follow after all others.

use super::super::{Polyhedron, Selection};
use super::SubdivideError;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, MAX_IDS, VertexMap};
use crate::topology::{Columns, Dcel, TooMany};
use std::borrow::Cow;

/// A surface without removed elements, and its creases.
pub(super) struct Coarse<'a> {
    pub(super) solid: Cow<'a, Polyhedron>,
    pub(super) creases: Cow<'a, Selection<EdgeId>>,
    /// The number k of each half-edge's corner; `u32::MAX` for those of boundary faces.
    pub(super) corner: Vec<u32>,
    /// The half-edge of each corner.
    pub(super) corners: Vec<HalfEdgeId>,
    /// Whether each face is a boundary face.
    pub(super) is_boundary: Vec<bool>,
}

const NO_CORNER: u32 = u32::MAX;
/// Vertices whose places one thread computes at a time.
pub(super) const PIECE: usize = 1 << 14;

impl<'a> Coarse<'a> {
    pub(super) fn new(solid: &'a Polyhedron, creases: &'a Selection<EdgeId>) -> Self {
        let d = solid.topology();
        let bounds = [d.vertex_bound(), d.edge_bound(), d.face_bound()];
        let (solid, creases) = if bounds == [d.vertex_count(), d.edge_count(), d.face_count()] {
            (Cow::Borrowed(solid), Cow::Borrowed(creases))
        } else {
            let (solid, creases) = compacted(solid, creases);
            (Cow::Owned(solid), Cow::Owned(creases))
        };
        let d = solid.topology();
        let mut is_boundary = vec![false; d.face_bound()];
        solid.boundary_faces().for_each(|f| is_boundary[f.index()] = true);
        let mut corner = vec![NO_CORNER; d.half_edge_bound()];
        let mut corners = Vec::with_capacity(d.half_edge_bound());
        for h in d.half_edges() {
            if !is_boundary[d.face(h).index()] {
                corner[h.index()] = corners.len() as u32;
                corners.push(h);
            }
        }
        Self { solid, creases, corner, corners, is_boundary }
    }

    pub(super) fn dcel(&self) -> &Dcel {
        self.solid.topology()
    }

    pub(super) fn has_corner(&self, h: HalfEdgeId) -> bool {
        self.corner[h.index()] != NO_CORNER
    }

    /// Whether the edge of `h` keeps its curve: a crease, or a border.
    #[inline]
    pub(super) fn is_sharp(&self, h: HalfEdgeId) -> bool {
        self.creases.mask(h.edge()) != 0 || !self.has_corner(h) || !self.has_corner(h.twin())
    }

    /// Fails if so many elements do not fit.
    pub(super) fn room(vertices: usize, edges: usize, faces: usize) -> Result<(), SubdivideError> {
        if vertices > MAX_IDS || edges > MAX_IDS / 2 || faces > MAX_IDS {
            return Err(TooMany.into());
        }
        Ok(())
    }

    /// Both halves of each crease.
    pub(super) fn finer_creases(&self) -> Selection<EdgeId> {
        let mut finer = Selection::new();
        for e in self.creases.ids(u8::MAX).filter(|&e| self.dcel().has_edge(e)) {
            e.half_edges().into_iter().for_each(|h| finer.add(EdgeId::new(h.number()), self.creases.mask(e)));
        }
        finer
    }
}

fn compacted(solid: &Polyhedron, creases: &Selection<EdgeId>) -> (Polyhedron, Selection<EdgeId>) {
    let mut dcel = solid.topology().clone();
    let map = dcel.compact();
    let mut points = VertexMap::filled(dcel.vertex_bound(), [0.0; 3]);
    for (old, new) in map.vertices.iter() {
        if let Some(new) = *new {
            points[new] = solid.point(old);
        }
    }
    let boundary_faces = solid.boundary_faces().filter_map(|f| map.faces[f]).collect();
    let mut finer = Selection::new();
    for e in creases.ids(u8::MAX) {
        if let Some(new) = map.edges.get(e).copied().flatten() {
            finer.add(new, creases.mask(e));
        }
    }
    (Polyhedron::assembled(dcel, points, boundary_faces), finer)
}

/// The columns of the finer structure while they are written.
pub(super) struct Fine {
    columns: Columns,
}

impl Fine {
    /// Room for everything, and what both schemes share: the two parts of each edge, the stored half-edges of the
    /// vertices, and the boundary faces, numbered from `faces` on.
    pub(super) fn new(coarse: &Coarse<'_>, vertices: usize, edges: usize, faces: usize) -> Self {
        let d = coarse.dcel();
        let column = || vec![0; 2 * edges];
        let mut fine = Self {
            columns: Columns {
                origin: column(),
                next: column(),
                prev: column(),
                face: column(),
                outgoing: vec![Columns::NONE; vertices],
                boundary: vec![0; faces],
            },
        };
        let old = d.vertex_bound() as u32;
        for v in d.vertices() {
            fine.columns.outgoing[v.index()] = d.outgoing(v).map_or(Columns::NONE, |h| 2 * h.number());
        }
        for e in d.edges() {
            fine.columns.outgoing[(old + e.number()) as usize] = 4 * e.number() + 1;
        }
        for h in d.half_edges() {
            let middle = old + h.edge().number();
            fine.columns.origin[2 * h.index()] = d.origin(h).number();
            fine.columns.origin[2 * h.index() + 1] = middle;
        }
        for f in d.faces().filter(|f| coarse.is_boundary[f.index()]) {
            let face = FaceId::new(fine.columns.boundary.len() as u32);
            fine.columns.boundary.push(d.half_edge(f).map_or(Columns::NONE, |h| 2 * h.number()));
            for h in d.incident_half_edges(f) {
                let (first, second) = (2 * h.number(), 2 * h.twin().number() + 1);
                fine.link(first, second, face);
                fine.link(second, 2 * d.next(h).number(), face);
            }
        }
        fine
    }

    /// `b` follows `a` round the face.
    #[inline]
    fn link(&mut self, a: u32, b: u32, face: FaceId) {
        self.columns.next[a as usize] = b;
        self.columns.prev[b as usize] = a;
        self.columns.face[a as usize] = face.number();
    }

    /// A face from its half-edges in order; its boundary is the first of them.
    #[inline]
    pub(super) fn face(&mut self, face: u32, around: &[u32]) {
        self.columns.boundary[face as usize] = around[0];
        for (i, &a) in around.iter().enumerate() {
            self.link(a, around[(i + 1) % around.len()], FaceId::new(face));
        }
    }

    /// The inner edge with half-edges `a` and `a + 1`, from vertex `u` to vertex `v`.
    #[inline]
    pub(super) fn inner_edge(&mut self, a: u32, u: u32, v: u32) {
        self.columns.origin[a as usize] = u;
        self.columns.origin[a as usize + 1] = v;
    }

    /// The half-edge stored with a vertex.
    #[inline]
    pub(super) fn set_outgoing(&mut self, v: u32, a: u32) {
        self.columns.outgoing[v as usize] = a;
    }

    /// The finished surface; `faces` are those that are no boundary faces.
    pub(super) fn finish(self, points: Vec<[f64; 3]>, faces: usize) -> Polyhedron {
        let boundary_faces = (faces..self.columns.boundary.len()).map(|f| FaceId::new(f as u32)).collect();
        Polyhedron::assembled(Dcel::from_columns(self.columns), points.into(), boundary_faces)
    }
}
