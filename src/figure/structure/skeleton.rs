//! What of a view can be drawn: points, the ends of half-edges, edges, closed cycles of faces.
//!
//! The view may be broken in every way. A half-edge ends where its twin starts if the two agree that they are
//! twins, else where its next starts. A cycle is drawn only if it closes. Everything left out is counted, for
//! the notes of the figure.

use crate::figure::canvas::vector::{Bounds, Xy};
use crate::ids::{FaceId, HalfEdgeId, HalfEdgeMap, Id, VertexId, VertexMap};
use crate::plane::PlanarView;
use crate::topology::bounded_cycle;

/// All existing ids of one kind.
pub(crate) fn ids<I: Id>(bound: usize, exists: impl Fn(I) -> bool) -> impl Iterator<Item = I> {
    (0..bound.min(crate::ids::MAX_IDS)).map(I::from_index).filter(move |&id| exists(id))
}

pub(crate) fn half_edges<V: PlanarView + ?Sized>(view: &V) -> impl Iterator<Item = HalfEdgeId> {
    ids(view.half_edge_bound(), |h| view.has_half_edge(h))
}

pub(crate) fn vertices<V: PlanarView + ?Sized>(view: &V) -> impl Iterator<Item = VertexId> {
    ids(view.vertex_bound(), |v| view.has_vertex(v))
}

pub(crate) fn faces<V: PlanarView + ?Sized>(view: &V) -> impl Iterator<Item = FaceId> {
    ids(view.face_bound(), |f| view.has_face(f))
}

/// The twin of `h`, if that is another half-edge of the view whose twin is `h`.
pub(crate) fn mutual_twin<V: PlanarView + ?Sized>(view: &V, h: HalfEdgeId) -> Option<HalfEdgeId> {
    view.twin(h).filter(|&t| t != h && view.has_half_edge(t) && view.twin(t) == Some(h))
}

/// The vertex where `h` ends, as far as the view tells.
pub(crate) fn destination<V: PlanarView + ?Sized>(view: &V, h: HalfEdgeId) -> Option<VertexId> {
    mutual_twin(view, h)
        .and_then(|t| view.origin(t))
        .or_else(|| view.next(h).and_then(|n| view.origin(n)))
        .or_else(|| view.twin(h).filter(|&t| t != h).and_then(|t| view.origin(t)))
}

const NOWHERE: VertexId = VertexId::new(u32::MAX);

/// The drawable part of a view.
#[derive(Clone)]
pub(crate) struct Skeleton {
    /// Where each vertex is on the canvas.
    pub(crate) at: VertexMap<Option<Xy>>,
    /// What lies outside of it cannot be seen; `None`: everything can.
    pub(crate) window: Option<Bounds>,
    ends: HalfEdgeMap<[VertexId; 2]>,
    /// One half-edge of every edge whose two ends have positions, in the order of their numbers.
    pub(crate) edges: Vec<HalfEdgeId>,
}

impl Skeleton {
    /// The ends and the edges; no positions yet. O(half-edges).
    pub(crate) fn new<V: PlanarView + ?Sized>(view: &V) -> Self {
        let mut ends = HalfEdgeMap::filled(view.half_edge_bound(), [NOWHERE; 2]);
        let mut edges = Vec::with_capacity(view.half_edge_bound() / 2);
        let placed = |v: &VertexId| view.position(*v).is_some();
        for h in half_edges(view) {
            let origin = view.origin(h).filter(placed);
            let destination = destination(view, h).filter(placed);
            if let (Some(a), Some(b)) = (origin, destination) {
                ends[h] = [a, b];
                if mutual_twin(view, h).is_none_or(|t| h < t || ends[t] == [NOWHERE; 2]) {
                    edges.push(h);
                }
            }
        }
        Self { at: VertexMap::default(), window: None, ends, edges }
    }

    /// The two ends of `h`, if both have positions.
    pub(crate) fn ends(&self, h: HalfEdgeId) -> Option<[VertexId; 2]> {
        self.ends.get(h).copied().filter(|ends| ends[0] != NOWHERE)
    }

    /// Where `v` is on the canvas.
    pub(crate) fn place(&self, v: VertexId) -> Option<Xy> {
        self.at.get(v).copied().flatten()
    }

    /// The two ends of `h` on the canvas.
    pub(crate) fn segment(&self, h: HalfEdgeId) -> Option<(Xy, Xy)> {
        let [a, b] = self.ends(h)?;
        Some((self.place(a)?, self.place(b)?))
    }
}

/// The closed cycles of some faces in flat arrays.
pub(crate) struct Cycles {
    half_edges: Vec<HalfEdgeId>,
    /// For each cycle its face and the end of its half-edges.
    cycles: Vec<(FaceId, u32)>,
    /// Faces with a cycle that does not close, or that another face has claimed before.
    pub(crate) open: Vec<FaceId>,
}

impl Cycles {
    /// Walks the cycles of the given faces. Each half-edge is walked once, so a broken view costs no more than a
    /// sound one: O(half-edges + rings).
    pub(crate) fn of<V: PlanarView + ?Sized>(view: &V, faces: impl IntoIterator<Item = FaceId>) -> Self {
        let mut walked = HalfEdgeMap::filled(view.half_edge_bound(), false);
        let mut out = Self { half_edges: Vec::new(), cycles: Vec::new(), open: Vec::new() };
        for face in faces {
            let rings = view.inner_components(face).iter().filter_map(|ring| ring.cycle());
            for start in view.half_edge(face).into_iter().chain(rings) {
                if !out.walk(view, face, start, &mut walked) && out.open.last() != Some(&face) {
                    out.open.push(face);
                }
            }
        }
        out
    }

    fn walk<V: PlanarView + ?Sized>(
        &mut self,
        view: &V,
        face: FaceId,
        start: HalfEdgeId,
        walked: &mut HalfEdgeMap<bool>,
    ) -> bool {
        let first = self.half_edges.len();
        for h in bounded_cycle(view, start) {
            if std::mem::replace(&mut walked[h], true) {
                break;
            }
            self.half_edges.push(h);
        }
        let closes = self.half_edges[first..].last().is_some_and(|&last| view.next(last) == Some(start));
        if closes {
            self.cycles.push((face, self.half_edges.len() as u32));
        } else {
            self.half_edges.truncate(first);
        }
        closes
    }

    /// The cycles, those of one face together, in the order in which the faces were given.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (FaceId, &[HalfEdgeId])> {
        let starts = std::iter::once(0).chain(self.cycles.iter().map(|&(_, end)| end as usize));
        starts.zip(&self.cycles).map(|(start, &(face, end))| (face, &self.half_edges[start..end as usize]))
    }
}
