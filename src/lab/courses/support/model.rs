//! What a mesh should be: its vertices, and its triangles as sides with the corner across.
//!
//! ```text
//!        c             triangles: (a, b) ─▶ c   (b, c) ─▶ a   (c, a) ─▶ b
//!      ╱   ╲           there are no half-edges here, and no free lists but that of the vertices: what the student's
//!     a ──▶ b          program keeps is compared with it, not with another half-edge structure
//! ```

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// A point or a direction.
pub(super) type Place = [f64; 3];

/// A mesh.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Model {
    /// The vertices by number; `None` where one is free.
    pub(super) vertices: Vec<Option<Place>>,
    /// The vertices that are free; the last one is used first.
    free: Vec<usize>,
    /// The corner across each side.
    pub(super) across: BTreeMap<(usize, usize), usize>,
    /// How many edges there are.
    edges: usize,
    /// The most edges and triangles that there were at a time.
    pub(super) most: [usize; 2],
}

impl Model {
    /// The mesh of some triangles.
    pub(super) fn new(points: &[Place], triangles: &[[usize; 3]]) -> Self {
        let mut model = Self { vertices: points.iter().copied().map(Some).collect(), ..Self::default() };
        for &triangle in triangles {
            model.add_face(triangle);
        }
        model
    }

    /// The mesh of some sides with the corners across them. They may be those of a student, and not fit together.
    pub(super) fn of_sides(vertices: Vec<Option<Place>>, across: BTreeMap<(usize, usize), usize>) -> Self {
        let edges = across.keys().filter(|&&(a, b)| a < b || !across.contains_key(&(b, a))).count();
        Self { vertices, across, edges, ..Self::default() }
    }

    /// With these vertices free, the last one to be used first; none of them has a triangle.
    pub(super) fn with_free(mut self, free: &[usize]) -> Self {
        free.iter().for_each(|&v| self.remove_vertex(v));
        self
    }

    /// The number that a new vertex gets.
    pub(super) fn add_vertex(&mut self, place: Place) -> usize {
        let v = self.free.pop().unwrap_or(self.vertices.len());
        self.vertices.resize(self.vertices.len().max(v + 1), None);
        self.vertices[v] = Some(place);
        v
    }

    /// Why a triangle cannot be added.
    pub(super) fn refusal(&self, [a, b, c]: [usize; 3]) -> Option<String> {
        if a == b || b == c || c == a {
            return Some("two of the corners are the same".to_owned());
        }
        if let Some(v) = [a, b, c].into_iter().find(|&v| self.place(v).is_none()) {
            return Some(format!("v{v} is no vertex"));
        }
        let taken = [(a, b), (b, c), (c, a)].into_iter().find(|side| self.across.contains_key(side));
        taken.map(|(a, b)| format!("the half-edge from v{a} to v{b} has a face already"))
    }

    /// Adds a triangle if that can be.
    pub(super) fn add_face(&mut self, corners: [usize; 3]) -> bool {
        let [a, b, c] = corners;
        let is_legal = self.refusal(corners).is_none();
        if is_legal {
            self.edges += self.unshared(corners);
            self.across.extend([((a, b), c), ((b, c), a), ((c, a), b)]);
            let now = [self.edges, self.across.len() / 3];
            self.most = [0, 1].map(|i| self.most[i].max(now[i]));
        }
        is_legal
    }

    /// Removes the triangle on the left of a side, if there is one.
    pub(super) fn remove_face(&mut self, a: usize, b: usize) -> bool {
        let Some(c) = self.across.get(&(a, b)).copied() else { return false };
        for side in [(a, b), (b, c), (c, a)] {
            self.across.remove(&side);
        }
        // Sides that do not fit together are removed without a panic.
        self.edges = self.edges.saturating_sub(self.unshared([a, b, c]));
        true
    }

    /// Removes a vertex and its triangles.
    pub(super) fn remove_vertex(&mut self, v: usize) {
        for (a, b) in self.sides_from(v) {
            self.remove_face(a, b);
        }
        if let Some(place) = self.vertices.get_mut(v).filter(|place| place.is_some()) {
            *place = None;
            self.free.push(v);
        }
    }

    /// Where a vertex is; `None` if there is none of that number.
    pub(super) fn place(&self, v: usize) -> Option<Place> {
        self.vertices.get(v).copied().flatten()
    }

    /// The sides of triangles that start at a vertex.
    pub(super) fn sides_from(&self, v: usize) -> Vec<(usize, usize)> {
        self.across.range((v, 0)..=(v, usize::MAX)).map(|(&side, _)| side).collect()
    }

    /// The vertices at the other ends of the edges of a vertex.
    pub(super) fn neighbours(&self, v: usize) -> BTreeSet<usize> {
        self.sides_from(v).into_iter().flat_map(|side| [side.1, self.across[&side]]).collect()
    }

    /// How many edges of a triangle no other one has.
    fn unshared(&self, [a, b, c]: [usize; 3]) -> usize {
        [(b, a), (c, b), (a, c)].iter().filter(|side| !self.across.contains_key(side)).count()
    }

    /// How many edges the triangles have.
    #[cfg(test)]
    pub(super) fn edges(&self) -> usize {
        let all = self.across.keys().filter(|&&(a, b)| a < b || !self.across.contains_key(&(b, a))).count();
        assert_eq!(all, self.edges, "counted one by one, and kept");
        all
    }

    /// The vertices that exist.
    pub(super) fn live(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.vertices.len()).filter(|&v| self.vertices[v].is_some())
    }

    /// How high a vertex is. Exact: all coordinates of cases that ask for heights are whole numbers below 2^60.
    pub(super) fn height(&self, d: Place, v: usize) -> i128 {
        self.place(v).map_or(0, |place| (0..3).map(|i| d[i] as i128 * place[i] as i128).sum())
    }

    /// Whether a vertex is higher than another.
    pub(super) fn higher(&self, d: Place, a: usize, b: usize) -> Ordering {
        self.height(d, a).cmp(&self.height(d, b))
    }

    /// The highest of the neighbours of a vertex in a direction, if it is higher than the vertex.
    pub(super) fn steepest(&self, v: usize, d: Place) -> Option<usize> {
        let all = self.neighbours(v).into_iter();
        let highest = all.reduce(|best, u| if self.higher(d, u, best).is_gt() { u } else { best })?;
        self.higher(d, highest, v).is_gt().then_some(highest)
    }

    /// A vertex that none is higher than.
    pub(super) fn highest(&self, d: Place) -> Option<usize> {
        self.live().reduce(|best, v| if self.higher(d, v, best).is_gt() { v } else { best })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_and_their_opposites_come_back_to_the_same_mesh() {
        let mut model = Model::new(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], &[[0, 1, 2]]);
        let before = model.clone();
        assert!(model.add_face([0, 3, 1]) && !model.add_face([0, 1, 3]) && !model.add_face([0, 0, 1]));
        assert_eq!((model.edges(), model.across.len()), (5, 6));
        assert_eq!(model.neighbours(0), BTreeSet::from([1, 2, 3]));
        assert!(model.remove_face(1, 0) && !model.remove_face(1, 0));
        assert_eq!(model.across, before.across);
        model.remove_vertex(1);
        assert_eq!((model.across.len(), model.live().count()), (0, 3));
        assert_eq!((model.add_vertex([9.0; 3]), model.add_vertex([8.0; 3])), (1, 4));
    }

    #[test]
    fn heights_are_compared_exactly() {
        let m = 2.0_f64.powi(56);
        let model = Model::new(&[[m, 0.0, 0.0], [m, 1.0, 0.0]], &[]);
        let d = [m, 1.0, 0.0];
        assert!((m * m + 1.0).total_cmp(&(m * m)).is_eq(), "rounding cannot tell them apart");
        assert_eq!((model.higher(d, 1, 0), model.highest(d)), (Ordering::Greater, Some(1)));
    }
}
