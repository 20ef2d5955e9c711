//! Which face of a, and of b, each face of the overlay is part of.
//!
//! ```text
//!    a: P │ Q          Over an edge that comes from a, the label of a changes as it does in a: from P to Q.
//!   ──────┼──── b      Over an edge that comes from b alone it stays. The outer face is part of the outer faces,
//!    a: P │ Q          and over edges every face is reached from there.
//! ```
//!
//! Where rounding has joined several edges of a, they are passed one after another: P | Q and Q | R make P | R.

use crate::geometry::grouping::Groups;
use crate::ids::{EdgeId, FaceId, FaceMap, HalfEdgeId, must_be_below};
use crate::plane::Subdivision;

/// The edges of a source along each edge of the overlay.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Sources {
    /// Half-edges of the source, directed as the even half of the edge.
    by_edge: Groups<HalfEdgeId>,
}

impl Sources {
    /// From the half-edges of a source and the half-edges of the overlay along each of them.
    pub(super) fn new<'a>(
        edges: usize,
        halves: &[HalfEdgeId],
        chain: impl Fn(usize) -> &'a [HalfEdgeId] + Copy,
    ) -> Self {
        let pairs = halves.iter().enumerate().flat_map(|(i, &g)| chain(i).iter().map(move |&h| (h, g)));
        let directed = |(h, g): (HalfEdgeId, HalfEdgeId)| {
            (h.edge().index(), if h == h.edge().half_edges()[0] { g } else { g.twin() })
        };
        Self { by_edge: Groups::new(edges, pairs.map(directed)) }
    }

    #[track_caller]
    pub(super) fn along(&self, e: EdgeId) -> &[HalfEdgeId] {
        must_be_below(e, e.index(), self.by_edge.count());
        self.by_edge.of(e.index())
    }

    /// The label on the right of `h`, if that on its left is `label`.
    ///
    /// Several edges along `h` lay beside each other before rounding: P | Q, Q | R and so on in some order, perhaps with
    /// a Q | P between. Each step into a face but the last is followed by a step out of it, so what remains is a step
    /// out of the first face and one into the last; nothing, if they are the same.
    fn across(&self, source: &Subdivision, h: HalfEdgeId, label: FaceId) -> FaceId {
        let along_h = |g: HalfEdgeId| if h == h.edge().half_edges()[0] { g } else { g.twin() };
        match self.by_edge.of(h.edge().index()) {
            [] => label,
            &[g] => source.dcel.face(along_h(g).twin()),
            list => {
                let sides = |g: HalfEdgeId| [g, g.twin()].map(|g| source.dcel.face(g));
                let steps = list.iter().map(|&g| sides(along_h(g))).flat_map(|[left, right]| [(left, -1), (right, 1)]);
                let mut steps: Vec<(FaceId, i32)> = steps.collect();
                steps.sort_unstable();
                let into = |steps: &&[(FaceId, i32)]| steps.iter().map(|step| step.1).sum::<i32>() > 0;
                steps.chunk_by(|a, b| a.0 == b.0).find(into).map_or(label, |last| last[0].0)
            }
        }
    }
}

impl Subdivision {
    /// By face the faces of a and of b that it lies in, and the faces for which ways disagree, in increasing order. O(E).
    pub(super) fn carry_labels(&self, sources: [&Self; 2], from: [&Sources; 2]) -> ([FaceMap<FaceId>; 2], Vec<FaceId>) {
        let outer = sources.map(Self::outer_face);
        let mut is_known = FaceMap::filled(self.dcel.face_bound(), false);
        let mut labels = FaceMap::filled(self.dcel.face_bound(), outer);
        let mut unsettled = Vec::new();
        let mut queue = vec![self.outer_face()];
        is_known[self.outer_face()] = true;
        while let Some(f) = queue.pop() {
            let [of_a, of_b] = labels[f];
            for h in self.all_half_edges(f) {
                let there = self.dcel.face(h.twin());
                let expected = [from[0].across(sources[0], h, of_a), from[1].across(sources[1], h, of_b)];
                if !is_known[there] {
                    is_known[there] = true;
                    labels[there] = expected;
                    queue.push(there);
                } else if labels[there] != expected {
                    unsettled.push(there);
                }
            }
        }
        unsettled.sort_unstable();
        unsettled.dedup();
        let labels = labels.into_vec();
        ([0, 1].map(|source| labels.iter().map(|both| both[source]).collect::<Vec<_>>().into()), unsettled)
    }
}
