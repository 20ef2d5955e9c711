//! Elements that come back under the ids they had.
//!
//! ```text
//!   ┌─────────┐  e4 goes   ┌─────────┐  e4 comes back   ┌─────────┐      Ids that are kept are used by no other
//!   │ f2 ╱e4  │  ───────>  │   f2    │  ─────────────>  │ f2 ╱e4  │      element in the meantime, so the very edge
//!   │  ╱   f3 │            │         │                  │  ╱   f3 │      comes back, with its halves as they were,
//!   └─────────┘            └─────────┘                  └─────────┘      and the faces beside it.
//! ```

use super::InsertEdgeError;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::plane::{PlaneRecorder, Subdivision};
use crate::topology::{InnerComponent, TooMany};

impl Subdivision {
    /// From now on no other element gets the id of one that is there now, not even after that is removed. O(1).
    pub(crate) fn keep_ids(&mut self) {
        self.dcel.keep_ids();
    }

    /// Takes back [`keep_ids`](Self::keep_ids). O(n).
    pub(crate) fn release_ids(&mut self) {
        self.dcel.release_ids();
    }

    /// [`insert_edge`](Self::insert_edge) under an id that is kept and free; the first half starts at the first vertex.
    ///
    /// # Errors
    /// As there.
    pub(crate) fn insert_edge_as(
        &mut self,
        e: EdgeId,
        [from, to]: [VertexId; 2],
        rec: &mut impl PlaneRecorder,
    ) -> Result<(), InsertEdgeError> {
        let plan = self.plan_edge(from, to)?;
        self.dcel.offer_edge(e);
        let made = self.put_edge(plan, [from, to], rec);
        debug_assert_eq!(made.half_edge.edge(), e, "the id that was offered is the next one");
        if made.half_edge != e.half_edges()[0] {
            self.exchange_halves(e, rec);
        }
        Ok(())
    }

    /// Each half of the edge takes the place of the other.
    fn exchange_halves(&mut self, e: EdgeId, rec: &mut impl PlaneRecorder) {
        let halves = e.half_edges();
        let other = |h: HalfEdgeId| if h.edge() == e { h.twin() } else { h };
        let places = halves.map(|h| {
            let dcel = &self.dcel;
            (dcel.origin(h), dcel.face(h), other(dcel.prev(h)), other(dcel.next(h)))
        });
        for (h, (origin, face, prev, next)) in halves.map(HalfEdgeId::twin).into_iter().zip(places) {
            self.dcel.set_origin(h, origin, rec);
            self.dcel.set_face(h, face, rec);
            self.dcel.set_next(prev, h, rec);
            self.dcel.set_next(h, next, rec);
        }
        for (h, (origin, ..)) in halves.into_iter().zip(places) {
            if self.dcel.outgoing(origin) == Some(h) {
                self.dcel.set_outgoing(origin, Some(h.twin()), rec);
            }
        }
        let [one, another] = places.map(|(_, face, ..)| face);
        for face in [Some(one), (one != another).then_some(another)].into_iter().flatten() {
            match self.dcel.half_edge(face).filter(|h| h.edge() == e) {
                Some(h) => self.dcel.set_half_edge(face, Some(h.twin()), rec),
                None => {
                    let listed =
                        halves.into_iter().find(|&h| self.inner_components(face).contains(&InnerComponent::Cycle(h)));
                    listed.into_iter().for_each(|h| self.rename_inner_component(face, [h, h.twin()], rec));
                }
            }
        }
    }

    /// Gives the bounded face `f` another id: one that is kept and free, or any that is free. O(size of the face).
    pub(crate) fn rename_face(
        &mut self,
        f: FaceId,
        to: Option<FaceId>,
        rec: &mut impl PlaneRecorder,
    ) -> Result<FaceId, TooMany> {
        self.dcel.room_for(0, 0, 1)?;
        if let Some(to) = to {
            self.dcel.offer_face(to);
        }
        let new = self.dcel.add_face_record(rec);
        let boundary = self.dcel.half_edge(f);
        if let Some(start) = boundary {
            self.relabel_cycle(start, new, rec);
        }
        self.dcel.set_half_edge(new, boundary, rec);
        let rings = self.take_inner_components(f, rec);
        rings.iter().for_each(|&ring| self.relabel_inner_component(ring, new, rec));
        self.give_inner_components(new, rings, rec);
        if self.is_hole(f) {
            self.mark_hole(new, true, rec);
            self.mark_hole(f, false, rec);
        }
        self.dcel.remove_face_record(f, rec);
        Ok(new)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::{PlaneJournal, Point};
    use crate::topology::NoRecorder;

    /// A square in four triangles round its middle.
    fn square() -> Subdivision {
        let points = [(0., 0.), (2., 0.), (2., 2.), (0., 2.), (1., 1.)].map(Point::from);
        let triangles = [0, 1, 2, 3].map(|i| [i, (i + 1) % 4, 4]);
        Subdivision::from_triangles(points.to_vec(), &triangles).expect("four triangles")
    }

    #[test]
    fn an_edge_comes_back_under_its_id_in_whichever_order_they_went() {
        let first = square();
        let spokes: Vec<EdgeId> =
            first.edges().filter(|e| e.half_edges().iter().all(|&h| first.face(h) != first.outer_face())).collect();
        assert_eq!(spokes.len(), 4);
        for order in [[0, 1, 2, 3], [3, 1, 0, 2], [2, 3, 1, 0]] {
            let mut s = first.clone();
            s.keep_ids();
            let ends = |e: EdgeId| e.half_edges().map(|h| first.origin(h));
            for &e in &spokes {
                s.remove_edge(e).expect("an edge");
            }
            // What is made in the meantime has other numbers.
            let other = s.insert_edge(VertexId::new(0), VertexId::new(2)).is_err();
            assert!(other, "the middle is in the way");
            let between = s.insert_edge(VertexId::new(4), VertexId::new(1)).expect("a free edge");
            assert!(between.half_edge.edge().index() >= first.edge_bound());
            s.remove_edge(between.half_edge.edge()).expect("it is there");
            for i in order {
                let e = spokes[i];
                s.insert_edge_as(e, ends(e), &mut NoRecorder).expect("nothing is in its way");
                assert_eq!(e.half_edges().map(|h| s.origin(h)), ends(e), "{e}: its halves are exchanged");
                assert_eq!(s.geometry_violations(), [], "{e}");
            }
            // The faces have other numbers until they are given theirs.
            for h in spokes.iter().flat_map(|e| e.half_edges()) {
                let (now, wanted) = (s.face(h), first.face(h));
                if now != wanted {
                    if s.has_face(wanted) {
                        s.rename_face(wanted, None, &mut NoRecorder).expect("there is room");
                    }
                    s.rename_face(s.face(h), Some(wanted), &mut NoRecorder).expect("there is room");
                }
            }
            assert_eq!(s.geometry_violations(), []);
            assert!(first.edges().flat_map(EdgeId::half_edges).all(|h| s.face(h) == first.face(h)));
            s.release_ids();
            assert_eq!((s.edge_count(), s.face_count()), (first.edge_count(), first.face_count()));
        }
    }

    #[test]
    fn what_is_taken_back_leaves_no_trace() {
        let mut s = square();
        s.keep_ids();
        let (before, mut journal) = (s.clone(), PlaneJournal::new());
        let spoke = s.edges().find(|e| e.half_edges().iter().all(|&h| s.face(h) != s.outer_face())).expect("a spoke");
        let ends = spoke.half_edges().map(|h| s.origin(h));
        let mut middle = None;
        for round in 0..2 {
            s.remove_edge_with(spoke, &mut journal).expect("an edge");
            if round == 1 {
                middle = Some((s.clone(), journal.len()));
            }
            s.insert_edge_as(spoke, ends, &mut journal).expect("nothing is in its way");
            let face = s.face(spoke.half_edges()[0]);
            s.rename_face(face, None, &mut journal).expect("there is room");
        }
        let (there, mark) = middle.expect("two rounds");
        s.undo(&mut journal, mark);
        assert_eq!(s, there);
        s.undo(&mut journal, 0);
        assert_eq!(s, before);
        // The id is kept all the while.
        s.remove_edge(spoke).expect("an edge");
        s.insert_edge_as(spoke, ends, &mut NoRecorder).expect("nothing is in its way");
    }

    /// A triangle by itself: the edge that closes it has the new face on its left or on its right, whichever way it runs.
    #[test]
    fn the_first_half_starts_at_the_first_vertex_on_either_side_of_an_inner_component() {
        for inside in [false, true] {
            let mut points = [(1., 1.), (3., 1.), (2., 2.)].map(Point::from).to_vec();
            let mut edges = vec![[0, 1], [1, 2], [2, 0]];
            if inside {
                points.extend([(0., 0.), (9., 0.), (0., 9.)].map(Point::from));
                edges.extend([[3, 4], [4, 5], [5, 3]]);
            }
            let given = Subdivision::from_graph(&points, &edges).expect("triangles");
            for (e, turned) in given.edges().take(3).flat_map(|e| [(e, false), (e, true)]) {
                let mut ends = e.half_edges().map(|h| given.origin(h));
                if turned {
                    ends.reverse();
                }
                let (mut s, mut journal) = (given.clone(), PlaneJournal::new());
                s.keep_ids();
                s.remove_edge(e).expect("an edge");
                let open = s.clone();
                s.insert_edge_as(e, ends, &mut journal).expect("nothing is in its way");
                assert_eq!(e.half_edges().map(|h| s.origin(h)), ends, "{e}, inside: {inside}");
                assert_eq!(
                    (crate::topology::violations(&s), s.geometry_violations()),
                    (vec![], vec![]),
                    "{e}, inside: {inside}"
                );
                assert_eq!(s.face_count(), given.face_count());
                s.undo(&mut journal, 0);
                assert_eq!(s, open);
            }
        }
    }

    #[test]
    fn an_id_that_is_no_longer_kept_is_used_again() {
        let mut s = square();
        s.keep_ids();
        let spoke = s.edges().find(|e| e.half_edges().iter().all(|&h| s.face(h) != s.outer_face())).expect("a spoke");
        let [from, to] = spoke.half_edges().map(|h| s.origin(h));
        s.remove_edge(spoke).expect("an edge");
        s.release_ids();
        assert_eq!(s.insert_edge(from, to).expect("a free place").half_edge.edge(), spoke);
    }
}
