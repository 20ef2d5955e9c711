//! The edits once more, done naively: every face is the plain list of its half-edges, and an edit is cutting and
//! gluing lists. No next, no prev, no free lists, nothing in common with the kit's code.

use dcel_kit::topology::Dcel;
use std::collections::BTreeMap;

/// Faces as cyclic lists of half-edge numbers, and where each half-edge starts. The twin of h is h ^ 1.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Model {
    pub faces: BTreeMap<u32, Vec<u32>>,
    pub origin: BTreeMap<u32, u32>,
}

/// Why the model refuses a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum No {
    Missing,
    OtherFace,
    TooClose,
    SameFace,
    LastEdge,
    NotDegreeTwo,
}

impl Model {
    pub fn polygon(n: u32) -> Self {
        let inside: Vec<u32> = (0..n).map(|i| 2 * i).collect();
        let outside = inside.iter().rev().map(|a| a + 1).collect();
        let origin = (0..n).flat_map(|i| [(2 * i, i), (2 * i + 1, (i + 1) % n)]).collect();
        Self { faces: BTreeMap::from([(0, outside), (1, inside)]), origin }
    }

    pub fn of(dcel: &Dcel) -> Self {
        let list = |f| dcel.incident_half_edges(f).map(dcel_kit::HalfEdgeId::number).collect();
        Self {
            faces: dcel.faces().map(|f| (f.number(), list(f))).collect(),
            origin: dcel.half_edges().map(|a| (a.number(), dcel.origin(a).number())).collect(),
        }
    }

    /// The face of `a` and its list, beginning with `a`.
    fn from(&self, a: u32) -> Result<(u32, Vec<u32>), No> {
        let (&face, list) = self.faces.iter().find(|(_, list)| list.contains(&a)).ok_or(No::Missing)?;
        let (face, mut list) = (face, list.clone());
        let at = list.iter().position(|&b| b == a).unwrap();
        list.rotate_left(at);
        Ok((face, list))
    }

    pub fn degree(&self, vertex: u32) -> usize {
        self.origin.values().filter(|&&x| x == vertex).count()
    }

    pub fn can_split_face(&self, h1: u32, h2: u32) -> Result<(), No> {
        let ((_, list), _) = (self.from(h1)?, self.from(h2)?);
        let at = list.iter().position(|&a| a == h2).ok_or(No::OtherFace)?;
        if at <= 1 || at + 1 == list.len() { Err(No::TooClose) } else { Ok(()) }
    }

    /// Splits with the numbers `a` for the new half-edge and `new` for the new face.
    pub fn split_face(&mut self, h1: u32, h2: u32, a: u32, new: u32) {
        let (old, mut kept) = self.from(h1).unwrap();
        let at = kept.iter().position(|&b| b == h2).unwrap();
        let mut moved = kept.split_off(at);
        kept.push(a ^ 1);
        moved.push(a);
        self.faces.insert(old, kept);
        self.faces.insert(new, moved);
        let ends = [self.origin[&h1], self.origin[&h2]];
        self.origin.extend([(a, ends[0]), (a ^ 1, ends[1])]);
    }

    /// Splits with the numbers `m` for the new vertex and `c` for the half-edge after `a`.
    pub fn split_edge(&mut self, a: u32, m: u32, c: u32) {
        let (face, mut list) = self.from(a).unwrap();
        list.insert(1, c);
        self.faces.insert(face, list);
        let (face, mut list) = self.from(a ^ 1).unwrap();
        list.push(c ^ 1);
        self.faces.insert(face, list);
        let end = self.origin[&(a ^ 1)];
        self.origin.extend([(c, m), (c ^ 1, end), (a ^ 1, m)]);
    }

    pub fn can_join_faces(&self, a: u32) -> Result<(), No> {
        let ((f, one), (g, other)) = (self.from(a)?, self.from(a ^ 1)?);
        match (f == g, one.len() + other.len()) {
            (true, _) => Err(No::SameFace),
            (_, 2) => Err(No::LastEdge),
            _ => Ok(()),
        }
    }

    pub fn join_faces(&mut self, a: u32) {
        let ((gone, one), (kept, other)) = (self.from(a).unwrap(), self.from(a ^ 1).unwrap());
        self.faces.remove(&gone);
        self.faces.insert(kept, [&one[1..], &other[1..]].concat());
        self.origin.retain(|b, _| b >> 1 != a >> 1);
    }

    pub fn can_join_edges(&self, a: u32) -> Result<(), No> {
        self.from(a)?;
        let vertex = self.origin[&(a ^ 1)];
        let is_loop = self.origin[&a] == vertex;
        if self.degree(vertex) == 2 && !is_loop { Ok(()) } else { Err(No::NotDegreeTwo) }
    }

    pub fn join_edges(&mut self, a: u32) {
        let vertex = self.origin[&(a ^ 1)];
        let c = *self.origin.iter().find(|&(&b, &x)| x == vertex && b != a ^ 1).unwrap().0;
        let end = self.origin[&(c ^ 1)];
        self.faces.values_mut().for_each(|list| list.retain(|b| b >> 1 != c >> 1));
        self.origin.retain(|b, _| b >> 1 != c >> 1);
        self.origin.insert(a ^ 1, end);
    }

    /// Panics with the first difference between the model and the structure, every pointer being asked.
    pub fn assert_matches(&self, dcel: &Dcel, context: &str) {
        let live: Vec<u32> = dcel.half_edges().map(dcel_kit::HalfEdgeId::number).collect();
        assert_eq!(live, self.origin.keys().copied().collect::<Vec<_>>(), "live half-edges, {context}");
        let live: Vec<u32> = dcel.faces().map(dcel_kit::FaceId::number).collect();
        assert_eq!(live, self.faces.keys().copied().collect::<Vec<_>>(), "live faces, {context}");
        let vertices: std::collections::BTreeSet<u32> = self.origin.values().copied().collect();
        let live: Vec<u32> = dcel.vertices().map(dcel_kit::VertexId::number).collect();
        assert_eq!(live, vertices.into_iter().collect::<Vec<_>>(), "live vertices, {context}");
        assert_eq!(
            (dcel.vertex_count(), dcel.half_edge_count(), dcel.face_count()),
            (live.len(), self.origin.len(), self.faces.len()),
            "counts, {context}"
        );
        for (&a, &start) in &self.origin {
            assert_eq!(dcel.origin(super::h(a)).number(), start, "h{a}.origin, {context}");
        }
        for (&face, list) in &self.faces {
            for (i, &a) in list.iter().enumerate() {
                let b = list[(i + 1) % list.len()];
                assert_eq!(dcel.face(super::h(a)).number(), face, "h{a}.face, {context}");
                assert_eq!(dcel.next(super::h(a)).number(), b, "h{a}.next, {context}");
                assert_eq!(dcel.prev(super::h(b)).number(), a, "h{b}.prev, {context}");
            }
            let boundary = dcel.half_edge(super::f(face)).expect("a boundary").number();
            assert!(list.contains(&boundary), "f{face}.half_edge = h{boundary}, {context}");
        }
        for x in dcel.vertices() {
            let a = dcel.outgoing(x).expect("an outgoing half-edge");
            assert_eq!(self.origin[&a.number()], x.number(), "{x}.outgoing = {a}, {context}");
        }
    }
}
