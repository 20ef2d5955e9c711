//! Which polygons cover each face.
//!
//! ```text
//!   f0 ──A── f1 ──B── f2        From f0, which nothing covers, every face is reached over edges. Over an edge of A,
//!    │        │                 being covered by A changes. Only these changes are kept, with the edge by which each
//!    B        C                 face is reached: 100,000 polygons inside each other take no more room than apart.
//!    │        │
//!   f3       f4                 f4 is covered by A and C
//! ```

use crate::geometry::grouping::grouped;
use crate::ids::{FaceId, FaceMap, HalfEdgeId, must_be_below};
use crate::plane::Subdivision;
use crate::topology::PolygonList;
use std::collections::BTreeSet;

/// Lists of numbers, one for each edge.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Lists {
    ends: Vec<u32>,
    list: Vec<u32>,
}

impl Lists {
    /// Appends a number to the list at hand.
    pub(super) fn push(&mut self, number: u32) {
        self.list.push(number);
    }

    /// Ends the list at hand.
    pub(super) fn end(&mut self) {
        self.ends.push(self.list.len() as u32);
    }

    /// The number of lists that have ended.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    pub(super) fn of(&self, i: usize) -> &[u32] {
        let start = i.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.list[start as usize..self.ends[i] as usize]
    }

    /// Some of the lists, in another order.
    pub(super) fn chosen(&self, which: impl Iterator<Item = usize>) -> Self {
        let mut chosen = Self::default();
        for i in which {
            chosen.list.extend_from_slice(self.of(i));
            chosen.end();
        }
        chosen
    }
}

/// The ways from f0 to all faces.
#[derive(Clone, PartialEq, Debug, Default)]
struct Tree {
    /// The half-edge in each face over which it was reached; none for f0.
    entered: FaceMap<Option<HalfEdgeId>>,
    /// The face from which each was reached.
    parents: FaceMap<Option<FaceId>>,
    /// The faces in the order of a walk round the tree: what was reached from a face follows it before anything else.
    order: Vec<FaceId>,
}

impl Tree {
    /// Breadth first, so that the ways are short. O(half-edges).
    fn new(s: &Subdivision) -> Self {
        let bound = s.dcel.face_bound();
        let mut tree = Self {
            entered: FaceMap::filled(bound, None),
            parents: FaceMap::filled(bound, None),
            order: Vec::with_capacity(bound),
        };
        let mut reached = vec![s.outer_face()];
        let mut next = 0;
        while let Some(&f) = reached.get(next) {
            next += 1;
            for h in s.all_half_edges(f) {
                let there = s.dcel.face(h.twin());
                if there != s.outer_face() && tree.parents[there].is_none() {
                    (tree.entered[there], tree.parents[there]) = (Some(h.twin()), Some(f));
                    reached.push(there);
                }
            }
        }
        let parent = |i: usize| tree.parents[reached[i + 1]].map_or(0, FaceId::index);
        let (starts, list) = grouped(bound, reached.len() - 1, parent);
        let mut stack = vec![s.outer_face()];
        while let Some(f) = stack.pop() {
            tree.order.push(f);
            let children = &list[starts[f.index()] as usize..starts[f.index() + 1] as usize];
            stack.extend(children.iter().rev().map(|&i| reached[i as usize + 1]));
        }
        tree
    }

    /// Walks round the tree: `step` is called with a face whenever it is entered from its parent or left again, `visit`
    /// after it was entered. `state` is handed to both.
    fn round<T>(&self, state: &mut T, mut step: impl FnMut(&mut T, FaceId), mut visit: impl FnMut(&mut T, FaceId)) {
        let mut way: Vec<FaceId> = Vec::new();
        for &f in &self.order {
            if let Some(parent) = self.parents[f] {
                while let Some(left) = way.pop_if(|last| *last != parent) {
                    step(state, left);
                }
                step(state, f);
                way.push(f);
            }
            visit(state, f);
        }
    }
}

/// What covers the face at hand, while faces are visited.
struct Inside<'a> {
    polygons: &'a PolygonList,
    polygon_of: Vec<u32>,
    /// Whether each ring goes round it an odd number of times.
    ring: Vec<bool>,
    /// How many inner rings of each polygon do.
    holes: Vec<u32>,
    hollow: &'a [bool],
}

impl<'a> Inside<'a> {
    fn new(polygons: &'a PolygonList, hollow: &'a [bool]) -> Self {
        let mut polygon_of = vec![0; polygons.cycle_count()];
        for p in 0..polygons.face_count() {
            polygons.cycle_range(p).for_each(|ring| polygon_of[ring] = p as u32);
        }
        let ring = vec![false; polygon_of.len()];
        Self { polygons, polygon_of, ring, holes: vec![0; polygons.face_count()], hollow }
    }

    fn first_ring(&self, polygon: u32) -> usize {
        self.polygons.cycle_range(polygon as usize).start
    }

    fn toggle(&mut self, rings: &[u32]) {
        for &ring in rings {
            let inside = &mut self.ring[ring as usize];
            *inside = !*inside;
            let (inside, polygon) = (*inside, self.polygon_of[ring as usize]);
            if ring as usize != self.first_ring(polygon) {
                let holes = &mut self.holes[polygon as usize];
                *holes = if inside { *holes + 1 } else { *holes - 1 };
            }
        }
    }

    fn is_covered_by(&self, polygon: u32) -> bool {
        let holes = self.holes[polygon as usize];
        if self.hollow[polygon as usize] { holes % 2 == 1 } else { self.ring[self.first_ring(polygon)] && holes == 0 }
    }

    /// The polygons that cover one side only of an edge of the face at hand with these rings along it.
    fn changes(&mut self, rings: &[u32], mut change: impl FnMut(u32)) {
        for start in 0..rings.len() {
            let polygon = self.polygon_of[rings[start] as usize];
            if start > 0 && self.polygon_of[rings[start - 1] as usize] == polygon {
                continue;
            }
            let count = rings[start..].iter().take_while(|&&ring| self.polygon_of[ring as usize] == polygon).count();
            let own = &rings[start..start + count];
            let before = self.is_covered_by(polygon);
            self.toggle(own);
            if self.is_covered_by(polygon) != before {
                change(polygon);
            }
            self.toggle(own);
        }
    }
}

/// Whether each polygon has inner rings that go round something, and an outer ring that does not: no edge has it on one
/// side only. `rings` are the rings along each edge.
pub(super) fn hollow(polygons: &PolygonList, rings: &Lists) -> Vec<bool> {
    let mut bounds = vec![false; polygons.cycle_count()];
    rings.list.iter().for_each(|&ring| bounds[ring as usize] = true);
    let of = |p| {
        let own = polygons.cycle_range(p);
        !bounds[own.start] && bounds[own].contains(&true)
    };
    (0..polygons.face_count()).map(of).collect()
}

/// For each edge the polygons that cover just one side of it. `rings` are the rings along each edge.
pub(super) fn changes_over_edges(s: &Subdivision, polygons: &PolygonList, rings: &Lists, hollow: &[bool]) -> Lists {
    let mut found: Vec<(u32, u32)> = Vec::new();
    let tree = Tree::new(s);
    let step = |inside: &mut Inside<'_>, f: FaceId| {
        if let Some(h) = tree.entered[f] {
            inside.toggle(rings.of(h.edge().index()));
        }
    };
    tree.round(&mut Inside::new(polygons, hollow), step, |inside, f| {
        for h in s.all_half_edges(f).filter(|h| h.edge().half_edges()[0] == *h) {
            inside.changes(rings.of(h.edge().index()), |polygon| found.push((h.edge().number(), polygon)));
        }
    });
    let (starts, list) = grouped(s.dcel.edge_bound(), found.len(), |i| found[i].0 as usize);
    let mut lists = Lists::default();
    for ends in starts.windows(2) {
        list[ends[0] as usize..ends[1] as usize].iter().for_each(|&i| lists.push(found[i as usize].1));
        lists.end();
    }
    lists
}

/// Which polygons cover each face of a subdivision that was made of polygons.
///
/// It belongs to the subdivision as it was made: edits of the subdivision do not change it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Cover {
    tree: Tree,
    /// The polygons that cover just one of a face and its parent, by the number of the face.
    changes: Lists,
    /// How many polygons cover each face.
    counts: FaceMap<u32>,
}

impl Cover {
    /// `changes` are the polygons that cover just one side of each edge.
    pub(super) fn new(s: &Subdivision, changes: &Lists) -> Self {
        let tree = Tree::new(s);
        let mut own = Lists::default();
        for entered in tree.entered.as_slice() {
            if let Some(h) = entered {
                changes.of(h.edge().index()).iter().for_each(|&polygon| own.push(polygon));
            }
            own.end();
        }
        let mut cover = Self { tree, changes: own, counts: FaceMap::default() };
        let mut counts = FaceMap::filled(s.dcel.face_bound(), 0);
        cover.visit(|f, polygons| counts[f] = polygons.len() as u32);
        cover.counts = counts;
        cover
    }

    /// How many polygons cover `f`. O(1).
    ///
    /// # Panics
    /// If there is no such face: `there is no f99: there are 4 faces`.
    #[must_use]
    #[track_caller]
    pub fn count(&self, f: FaceId) -> u32 {
        must_be_below(f, f.index(), self.counts.len());
        self.counts[f]
    }

    /// The polygons that cover `f`, in increasing order. O(the number of faces between `f` and f0).
    #[must_use]
    #[track_caller]
    pub fn polygons(&self, f: FaceId) -> Vec<u32> {
        must_be_below(f, f.index(), self.counts.len());
        let mut inside = BTreeSet::new();
        let mut face = Some(f);
        while let Some(f) = face {
            self.toggle(&mut inside, f);
            face = self.tree.parents[f];
        }
        inside.into_iter().collect()
    }

    /// The faces that no polygon covers, in increasing order; f0 is the first of them.
    pub fn uncovered(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.counts.iter().filter(|(_, count)| **count == 0).map(|(f, _)| f)
    }

    /// Calls `each` with every face and the polygons that cover it. O(edges log polygons) for all faces, however many
    /// polygons cover each of them.
    pub fn visit(&self, mut each: impl FnMut(FaceId, &BTreeSet<u32>)) {
        let step = |inside: &mut BTreeSet<u32>, f| self.toggle(inside, f);
        self.tree.round(&mut BTreeSet::new(), step, |inside, f| each(f, inside));
    }

    /// How many of the marked polygons cover each face. O(edges) for all faces, however many polygons cover each of them.
    #[cfg(feature = "io")]
    pub(crate) fn count_marked(&self, marked: &[bool]) -> FaceMap<u32> {
        let mut counts = FaceMap::filled(self.counts.len(), 0);
        let step = |(inside, count): &mut (Vec<bool>, u32), f: FaceId| {
            for &polygon in self.changes.of(f.index()).iter().filter(|&&polygon| marked[polygon as usize]) {
                let is_inside = &mut inside[polygon as usize];
                *is_inside = !*is_inside;
                *count = if *is_inside { *count + 1 } else { *count - 1 };
            }
        };
        self.tree.round(&mut (vec![false; marked.len()], 0), step, |state, f| counts[f] = state.1);
        counts
    }

    fn toggle(&self, inside: &mut BTreeSet<u32>, f: FaceId) {
        for &polygon in self.changes.of(f.index()) {
            if !inside.remove(&polygon) {
                inside.insert(polygon);
            }
        }
    }
}
