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
//!
//! Every half-edge of the finer surface finds its own pointers, so that threads may share them.

use super::super::{Polyhedron, Selection};
use crate::geometry::threads::{halved, pieces, pieces_of};
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::topology::{Columns, Dcel};
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
    let mut solid = solid.clone();
    let map = solid.compact();
    let mut finer = Selection::new();
    for e in creases.ids(u8::MAX) {
        if let Some(new) = map.edges.get(e).copied().flatten() {
            finer.add(new, creases.mask(e));
        }
    }
    (solid, finer)
}

/// How many elements the finer surface has, boundary faces not counted.
pub(super) struct Sizes {
    pub(super) vertices: usize,
    pub(super) edges: usize,
    pub(super) faces: usize,
}

/// The pointers of a half-edge of the finer surface.
#[derive(Clone, Copy)]
pub(super) struct Pointers {
    pub(super) origin: u32,
    pub(super) next: u32,
    pub(super) prev: u32,
    pub(super) face: u32,
}

/// What differs between the two schemes.
pub(super) trait Scheme: Sync {
    /// The last half-edge of the corner whose face the coarse half-edge `h` ends in, before E(h) -> destination(h).
    fn before(&self, h: HalfEdgeId) -> u32;
    /// The two half-edges of the inner edge of corner k, the one of `h`.
    fn inner(&self, k: u32, h: HalfEdgeId) -> [Pointers; 2];
}

impl Coarse<'_> {
    /// The first half-edge of the inner edge of the corner of `h`.
    #[inline]
    pub(super) fn inner(&self, h: HalfEdgeId) -> u32 {
        self.inner_of(self.corner[h.index()])
    }

    /// The first half-edge of the inner edge of corner k.
    #[inline]
    pub(super) fn inner_of(&self, k: u32) -> u32 {
        2 * (2 * self.dcel().edge_bound() as u32 + k)
    }

    /// E(h).
    #[inline]
    pub(super) fn middle(&self, h: HalfEdgeId) -> u32 {
        self.dcel().vertex_bound() as u32 + h.edge().number()
    }

    /// The finer structure, up to the stored half-edges of vertices beyond those on edges, and of faces beyond those of
    /// corners: these are left to the scheme.
    pub(super) fn refined(&self, scheme: &impl Scheme, sizes: &Sizes) -> Columns {
        let d = self.dcel();
        let column = || vec![0; 2 * sizes.edges];
        let mut columns = Columns {
            origin: column(),
            next: column(),
            prev: column(),
            face: column(),
            outgoing: vec![Columns::NONE; sizes.vertices],
            boundary: vec![0; sizes.faces],
        };
        // Boundary faces follow after all others.
        let mut number = vec![0; d.face_bound()];
        for f in d.faces().filter(|f| self.is_boundary[f.index()]) {
            number[f.index()] = columns.boundary.len() as u32;
            columns.boundary.push(d.half_edge(f).map_or(Columns::NONE, |h| 2 * h.number()));
        }
        let Columns { origin, next, prev, face, outgoing, boundary } = &mut columns;
        let [halves, inner] = halved([origin, next, prev, face].map(Vec::as_mut_slice), 4 * d.edge_bound());
        let put = |[origin, next, prev, face]: &mut [&mut [u32]; 4], a: usize, to: Pointers| {
            (origin[a], next[a], prev[a], face[a]) = (to.origin, to.next, to.prev, to.face);
        };
        pieces_of(halves, 2 * PIECE, |first, mut piece| {
            for (i, h) in (0..piece[0].len() / 2).zip((first as u32 / 2..).map(HalfEdgeId::new)) {
                put(&mut piece, 2 * i, self.first_half(h, &number));
                put(&mut piece, 2 * i + 1, self.second_half(h, &number, scheme));
            }
        });
        pieces_of(inner, 2 * PIECE, |first, mut piece| {
            for (i, k) in (0..piece[0].len() / 2).zip(first as u32 / 2..) {
                let [a, b] = scheme.inner(k, self.corners[k as usize]);
                put(&mut piece, 2 * i, a);
                put(&mut piece, 2 * i + 1, b);
            }
        });
        pieces(&mut boundary[..self.corners.len()], PIECE, |first, piece| {
            piece.iter_mut().zip(&self.corners[first..]).for_each(|(stored, h)| *stored = 2 * h.number());
        });
        let (old, on_edges) = outgoing.split_at_mut(d.vertex_bound());
        pieces(old, PIECE, |first, piece| {
            for (v, stored) in (first as u32..).map(VertexId::new).zip(piece) {
                *stored = d.outgoing(v).map_or(Columns::NONE, |h| 2 * h.number());
            }
        });
        pieces(&mut on_edges[..d.edge_bound()], PIECE, |first, piece| {
            (first as u32..).zip(piece).for_each(|(e, stored)| *stored = 4 * e + 1);
        });
        columns
    }

    /// The half-edge from the origin of `h` to E(h).
    #[inline]
    fn first_half(&self, h: HalfEdgeId, number: &[u32]) -> Pointers {
        let d = self.dcel();
        let [next, face] = match self.corner[h.index()] {
            NO_CORNER => [2 * h.twin().number() + 1, number[d.face(h).index()]],
            k => [self.inner_of(k), k],
        };
        Pointers { origin: d.origin(h).number(), next, prev: 2 * d.prev(h).twin().number() + 1, face }
    }

    /// The half-edge from E(h) to the origin of `h`: it lies in the face of the twin of `h`.
    #[inline]
    fn second_half(&self, h: HalfEdgeId, number: &[u32], scheme: &impl Scheme) -> Pointers {
        let d = self.dcel();
        let twin = h.twin();
        let after = d.next(twin);
        let [prev, face] = match self.corner[after.index()] {
            NO_CORNER => [2 * twin.number(), number[d.face(twin).index()]],
            k => [scheme.before(twin), k],
        };
        Pointers { origin: self.middle(h), next: 2 * after.number(), prev, face }
    }

    /// The finished surface; `faces` are those that are no boundary faces.
    pub(super) fn finish(&self, columns: Columns, points: Vec<[f64; 3]>, faces: usize) -> Polyhedron {
        let boundary_faces = (faces..columns.boundary.len()).map(|f| FaceId::new(f as u32)).collect();
        Polyhedron::assembled(Dcel::from_columns(columns), points.into(), boundary_faces)
    }
}
