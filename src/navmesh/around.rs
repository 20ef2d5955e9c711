//! Round a vertex: fans, wedges, and where a path may bend.
//!
//! ```text
//!    hole ╲ f2 ╱ hole         A fan: the faces round a vertex between two holes, whether or not one may pass from one
//!      f3 ╲  ╱ f1           to the next. A wedge: those of a fan between two closed sides, blocked faces left out.
//!    ───── ● ─────          With two wedges (a double corner) nobody may squeeze through the vertex.
//!      f4    f5
//!                           If a wedge is more than half a turn, a shortest path may bend round the vertex in it.
//! ```

use super::marks::{CLOSED, ID, NONE, TURN};
use super::mesh::NavMesh;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Subdivision;
use crate::plane::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

impl NavMesh {
    /// Finds for each vertex the faces its fans start from: the last one before a hole in clockwise order, or any
    /// face if there is no hole. O(n).
    pub(super) fn find_fans(&mut self) {
        for f in 0..self.faces.len() as u32 {
            for s in self.range(FaceId::new(f)) {
                let v = self.sides[s].origin & ID;
                if self.fans[v as usize] == NONE {
                    self.fans[v as usize] = f;
                }
            }
        }
        let mut found = vec![false; self.fans.len()];
        for f in 0..self.faces.len() as u32 {
            for s in self.range(FaceId::new(f)) {
                let v = self.sides[s].origin & ID;
                if self.has_face(FaceId::new(self.sides[s].across & ID)) {
                    continue;
                }
                if std::mem::replace(&mut found[v as usize], true) {
                    self.more_fans.entry(v).or_default().push(f);
                } else {
                    self.fans[v as usize] = f;
                }
            }
        }
    }

    /// Finds the fans of one vertex anew, from the map. O(degree of v).
    pub(super) fn find_fans_of(&mut self, map: &Subdivision, v: VertexId) {
        let behind_hole = |&h: &HalfEdgeId| self.has_face(map.face(h)) && !self.has_face(map.face(h.twin()));
        let starts: Vec<u32> = map.outgoing_half_edges(v).filter(behind_hole).map(|h| map.face(h).number()).collect();
        let any = map.incident_faces(v).find(|&f| self.has_face(f)).map_or(NONE, FaceId::number);
        self.fans[v.index()] = starts.first().copied().unwrap_or(any);
        if starts.len() > 1 {
            self.more_fans.insert(v.number(), starts[1..].to_vec());
        } else {
            self.more_fans.remove(&v.number());
        }
    }

    /// The faces of the mesh round `v`, fan by fan, counter-clockwise in each; blocked ones are among them.
    ///
    /// Cost: O(number of these faces), times log n where they have many sides.
    #[must_use]
    pub fn faces_around(&self, v: VertexId) -> Vec<FaceId> {
        self.fan_starts(v).flat_map(|f| self.fan(v, f)).collect()
    }

    /// The wedges at `v`: for each the faces, counter-clockwise, between which one may pass round `v`. Two or more
    /// wedges make a double corner: being at `v` one has to say in which.
    ///
    /// Cost: O(number of faces round v), times log n where they have many sides.
    #[must_use]
    pub fn wedges(&self, v: VertexId) -> Vec<Vec<FaceId>> {
        let mut wedges = Vec::new();
        for start in self.fan_starts(v) {
            let mut fan = self.fan(v, start);
            // A fan all round the vertex starts anew behind a closed side, if it has one.
            if let Some(first) = fan.iter().position(|&f| self.is_closed_before(v, f)) {
                fan.rotate_left(first);
            }
            let mut wedge = Vec::new();
            for f in fan {
                if self.is_closed_before(v, f) && !wedge.is_empty() {
                    wedges.push(std::mem::take(&mut wedge));
                }
                if !self.is_blocked(f) {
                    wedge.push(f);
                }
            }
            if !wedge.is_empty() {
                wedges.push(wedge);
            }
        }
        wedges
    }

    /// Whether a closed side starts or ends at `v`. O(number of faces round v).
    pub(super) fn is_on_border(&self, v: VertexId) -> bool {
        self.faces_around(v).into_iter().any(|f| {
            [self.side_from(f, v.number()), self.side_to(f, v.number())]
                .into_iter()
                .flatten()
                .any(|s| self.sides[s].across & CLOSED != 0)
        })
    }

    /// Marks at which corners round `v` a path may bend: those of one wedge at most.
    pub(super) fn mark_turns(&mut self, v: VertexId) {
        for f in self.faces_around(v) {
            if let Some(s) = self.side_from(f, v.number()) {
                self.sides[s].origin = v.number();
            }
        }
        for wedge in self.wedges(v) {
            if self.is_more_than_half_a_turn(v, &wedge) {
                for f in wedge {
                    if let Some(s) = self.side_from(f, v.number()) {
                        self.sides[s].origin |= TURN;
                    }
                }
            }
        }
    }

    /// [`mark_turns`](Self::mark_turns) for all vertices with a closed side. O(n).
    pub(super) fn mark_all_turns(&mut self) {
        let mut at_closed_side = vec![false; self.points.len()];
        for f in self.faces() {
            for s in self.range(f).filter(|&s| self.sides[s].across & CLOSED != 0) {
                self.ends(f, s).into_iter().for_each(|v| at_closed_side[v.index()] = true);
            }
        }
        for v in (0..self.points.len()).filter(|&v| at_closed_side[v]) {
            self.mark_turns(VertexId::new(v as u32));
        }
    }

    fn fan_starts(&self, v: VertexId) -> impl Iterator<Item = FaceId> + '_ {
        let first = self.fans.get(v.index()).copied().filter(|&f| f != NONE);
        let more = self.more_fans.get(&v.number()).map_or(&[][..], Vec::as_slice);
        first.into_iter().chain(more.iter().copied()).map(FaceId::new)
    }

    /// The faces round `v` counter-clockwise from `start` to the next hole.
    fn fan(&self, v: VertexId, start: FaceId) -> Vec<FaceId> {
        let mut fan = vec![start];
        let mut at = start;
        while let Some(s) = self.side_to(at, v.number()) {
            at = FaceId::new(self.sides[s].across & ID);
            if at == start || !self.has_face(at) || fan.len() > self.faces.len() {
                break;
            }
            fan.push(at);
        }
        fan
    }

    /// Whether the side of `f` that starts at `v`, the first of `f` in counter-clockwise order, is closed.
    fn is_closed_before(&self, v: VertexId, f: FaceId) -> bool {
        self.side_from(f, v.number()).is_none_or(|s| self.sides[s].across & CLOSED != 0)
    }

    fn is_more_than_half_a_turn(&self, v: VertexId, wedge: &[FaceId]) -> bool {
        let [Some(&first), Some(&last)] = [wedge.first(), wedge.last()] else { return false };
        if !self.is_closed_before(v, first) {
            return false; // free all round
        }
        let [Some(s), Some(t)] = [self.side_from(first, v.number()), self.side_to(last, v.number())] else {
            return false;
        };
        let at = self.points[v.index()];
        let [from, to] = [self.ends(first, s)[1], self.ends(last, t)[0]].map(|v| self.points[v.index()]);
        match orientation(at, from, to) {
            Ordering::Less => true,
            Ordering::Greater => false,
            // Straight on, or once round the end of a wall.
            Ordering::Equal => left_to_right(at, from) == left_to_right(at, to),
        }
    }
}
