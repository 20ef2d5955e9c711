//! Both views side by side in one set of numbers: those of the second follow those of the first.

use super::super::flat::{Flat, NONE};
use super::difference::which;
use super::{Difference, IsomorphismOptions, VertexKey, View};
use crate::geometry::grouping::Groups;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};

/// Two legal views as one structure, with exact labels: partners must have equal labels.
pub(super) struct World {
    pub(super) origin: Vec<u32>,
    pub(super) twin: Vec<u32>,
    pub(super) next: Vec<u32>,
    pub(super) prev: Vec<u32>,
    pub(super) face: Vec<u32>,
    /// Live elements of both views, those of the first view first.
    pub(super) vertices: Vec<u32>,
    pub(super) half_edges: Vec<u32>,
    pub(super) faces: Vec<u32>,
    /// The number of the second view's first vertex, half-edge and face.
    pub(super) split: Split,
    pub(super) vertex_label: Vec<u32>,
    pub(super) label: Vec<u32>,
    pub(super) face_label: Vec<u32>,
    /// One half-edge for each cycle, grouped by face.
    pub(super) cycles: Groups<u32>,
    /// The isolated vertices, grouped by the face that lists them.
    pub(super) isolated: Groups<u32>,
    /// Isolated vertices that no face lists.
    pub(super) adrift: Vec<u32>,
}

/// Where the second view's numbers begin.
#[derive(Clone, Copy)]
pub(super) struct Split {
    pub(super) vertex: u32,
    pub(super) half_edge: u32,
    pub(super) face: u32,
}

/// What something of the world is called in the view that it is from.
impl Split {
    pub(super) fn vertex(self, v: u32) -> VertexId {
        VertexId(v - if v < self.vertex { 0 } else { self.vertex })
    }

    pub(super) fn half_edge(self, h: u32) -> HalfEdgeId {
        HalfEdgeId(h - if h < self.half_edge { 0 } else { self.half_edge })
    }

    pub(super) fn face(self, f: u32) -> FaceId {
        FaceId(f - if f < self.face { 0 } else { self.face })
    }
}

impl World {
    pub(super) fn new<A: View + ?Sized, B: View + ?Sized>(
        a: &A,
        b: &B,
        options: &IsomorphismOptions,
    ) -> Result<Self, Difference> {
        let sides = [Flat::read(a), Flat::read(b)];
        let [first, second] = &sides;
        let split = Split {
            vertex: first.outgoing.len() as u32,
            half_edge: first.next.len() as u32,
            face: first.boundary.len() as u32,
        };
        counts(first, second)?;
        let moved = |to: u32, shift: u32| if to == NONE { NONE } else { to + shift };
        let join = |column: for<'f> fn(&'f Flat<'_>) -> &'f [u32], shift: u32| -> Vec<u32> {
            column(first).iter().copied().chain(column(second).iter().map(|&to| moved(to, shift))).collect()
        };
        let twins = |flat: &Flat<'_>, shift: u32| -> Vec<u32> {
            (0..flat.next.len() as u32).map(|h| moved(flat.twin(h), shift)).collect()
        };
        let both = |a: Vec<u32>, b: Vec<u32>, shift: u32| -> Vec<u32> {
            a.into_iter().chain(b.into_iter().map(|x| x + shift)).collect()
        };
        let shifts = [Split { vertex: 0, half_edge: 0, face: 0 }, split];
        let with_shift = || sides.iter().zip(shifts);
        let cycles = with_shift().flat_map(|(flat, shift)| {
            flat.listed_cycles().map(move |(f, h)| ((f + shift.face) as usize, h + shift.half_edge))
        });
        let isolated = with_shift().flat_map(|(flat, shift)| {
            flat.listed_vertices().map(move |(f, v)| ((f + shift.face) as usize, v + shift.vertex))
        });
        let face_bound = first.boundary.len() + second.boundary.len();
        let mut world = Self {
            origin: join(|flat| &flat.origin, split.vertex),
            twin: [twins(first, 0), twins(second, split.half_edge)].concat(),
            next: join(|flat| &flat.next, split.half_edge),
            prev: join(|flat| &flat.prev, split.half_edge),
            face: join(|flat| &flat.face, split.face),
            vertices: both(first.vertices().collect(), second.vertices().collect(), split.vertex),
            half_edges: both(first.half_edges().collect(), second.half_edges().collect(), split.half_edge),
            faces: both(first.faces().collect(), second.faces().collect(), split.face),
            split,
            vertex_label: Vec::new(),
            label: Vec::new(),
            face_label: Vec::new(),
            cycles: Groups::new(face_bound, cycles),
            isolated: Groups::new(face_bound, isolated),
            adrift: Vec::new(),
        };
        world.adrift = world.find_adrift(first.outgoing.len() + second.outgoing.len());
        world.set_labels(&sides, options)?;
        Ok(world)
    }

    /// The vertices without edges that no face lists.
    fn find_adrift(&self, vertex_bound: usize) -> Vec<u32> {
        let mut has_place = vec![false; vertex_bound];
        self.half_edges.iter().for_each(|&h| has_place[self.origin[h as usize] as usize] = true);
        for &f in &self.faces {
            self.isolated.of(f as usize).iter().for_each(|&v| has_place[v as usize] = true);
        }
        self.vertices.iter().copied().filter(|&v| !has_place[v as usize]).collect()
    }

    fn set_labels(&mut self, sides: &[Flat<'_>; 2], options: &IsomorphismOptions) -> Result<(), Difference> {
        let is_fixed = |element: Element| options.fixed.is_some_and(|is_fixed| is_fixed(element));
        let split = self.split;
        let fixed_vertex = |v: u32| Some(split.vertex(v)).filter(|&v| is_fixed(v.into())).map_or(NONE, |v| v.0);
        let fixed_half_edge = |h: u32| Some(split.half_edge(h)).filter(|&h| is_fixed(h.into())).map_or(NONE, |h| h.0);
        let fixed_face = |f: u32| Some(split.face(f)).filter(|&f| is_fixed(f.into())).map_or(NONE, |f| f.0);
        let key = |v: u32| -> VertexKey {
            options.keys.map_or([0, 0], |keys| keys[usize::from(v >= split.vertex)](split.vertex(v)))
        };
        let stored = |h: u32| {
            let (flat, h) = (&sides[usize::from(h >= split.half_edge)], h as usize);
            let (v, f) = (split.vertex(self.origin[h]), split.face(self.face[h]));
            let h = split.half_edge(h as u32).0;
            options.representatives.then(|| (flat.outgoing[v.index()] == h, flat.boundary[f.index()] == h))
        };
        let face_state = |f: u32| {
            let (flat, f) = (&sides[usize::from(f >= split.face)], split.face(f));
            (flat.outer == Some(f.0), flat.hole[f.index()])
        };
        let vertex_bound = split.vertex as usize + sides[1].outgoing.len();
        self.vertex_label = intern(&self.vertices, vertex_bound, |v| (fixed_vertex(v), key(v)));
        let vertex_label = &self.vertex_label;
        let start = |h: u32| vertex_label[self.origin[h as usize] as usize];
        self.label = intern(&self.half_edges, self.next.len(), |h| (start(h), fixed_half_edge(h), stored(h)));
        let face_bound = split.face as usize + sides[1].boundary.len();
        self.face_label =
            intern(&self.faces, face_bound, |f| (fixed_face(f), face_state(f), self.cycles.of(f as usize).len()));

        let vertex = |v| (split.vertex(v).into(), fixed_vertex(v) != NONE);
        unpaired(&self.vertices, split.vertex, &self.vertex_label, vertex)?;
        let half_edge = |h| (split.half_edge(h).into(), fixed_half_edge(h) != NONE);
        unpaired(&self.half_edges, split.half_edge, &self.label, half_edge)?;
        let face = |f| (split.face(f).into(), fixed_face(f) != NONE);
        unpaired(&self.faces, split.face, &self.face_label, face)
    }
}

/// Numbers the distinct values of the elements, equal values getting equal numbers. O(n log n).
fn intern<T: Ord>(elements: &[u32], bound: usize, value: impl Fn(u32) -> T) -> Vec<u32> {
    let mut sorted: Vec<(T, u32)> = elements.iter().map(|&x| (value(x), x)).collect();
    sorted.sort_unstable();
    let mut labels = vec![NONE; bound];
    let mut label = 0;
    for (i, (value, x)) in sorted.iter().enumerate() {
        label += u32::from(i > 0 && sorted[i - 1].0 != *value);
        labels[*x as usize] = label;
    }
    labels
}

/// Fails if a label of a vertex, a face or a fixed half-edge occurs more often on one side than on the other.
fn unpaired(
    elements: &[u32],
    split: u32,
    labels: &[u32],
    describe: impl Fn(u32) -> (Element, bool),
) -> Result<(), Difference> {
    let count = elements.iter().map(|&x| labels[x as usize] as usize + 1).max().unwrap_or(0);
    let mut balance = vec![0_i64; count];
    for &x in elements {
        balance[labels[x as usize] as usize] += if x < split { 1 } else { -1 };
    }
    for &x in elements {
        if balance[labels[x as usize] as usize] * if x < split { 1 } else { -1 } > 0 {
            let (element, fixed) = describe(x);
            // A half-edge's label has its origin in it; that is better told by the pointers.
            if fixed || !matches!(element, Element::HalfEdge(_)) {
                return Err(Difference::Unpaired { element, which: which(x, split), fixed });
            }
        }
    }
    Ok(())
}

fn counts(a: &Flat<'_>, b: &Flat<'_>) -> Result<(), Difference> {
    let count = |flat: &Flat<'_>| {
        [
            (["vertex", "vertices"], flat.vertices().count()),
            (["edge", "edges"], flat.half_edges().count() / 2),
            (["face", "faces"], flat.faces().count()),
            (["outer face", "outer faces"], usize::from(flat.outer.is_some())),
            (["hole face", "hole faces"], flat.hole.iter().filter(|&&hole| hole).count()),
            (["boundary cycle", "boundary cycles"], flat.listed_cycles().count()),
            (["isolated vertex in a face", "isolated vertices in faces"], flat.listed_vertices().count()),
        ]
    };
    for (([one, many], found), (_, expected)) in count(a).into_iter().zip(count(b)) {
        if found != expected {
            return Err(Difference::Count { what: if found == 1 { one } else { many }, found, expected });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{Which, isomorphic_with};
    use super::*;
    use crate::topology::Dcel;

    #[test]
    fn a_fixed_half_edge_that_only_the_second_view_has_is_named_by_its_number_there() {
        let triangle = Dcel::polygon(3).unwrap();
        let mut other = triangle.clone();
        other.split_edge(HalfEdgeId(0)).unwrap();
        other.join_edges(HalfEdgeId(2)).unwrap();
        let gone = triangle.half_edges().find(|&h| !other.has_half_edge(h)).unwrap().into();
        let fixed = |element: Element| element == gone;
        assert_eq!(
            isomorphic_with(&other, &triangle, &IsomorphismOptions::new().fixed(&fixed)),
            Err(Difference::Unpaired { element: gone, which: Which::Second, fixed: true })
        );
    }
}
