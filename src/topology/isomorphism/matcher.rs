//! The map from one side to the other while it grows.
//!
//! ```text
//!    h ──next──> n          h -> g  forces  n = next(h) -> next(g)  and  t = twin(h) -> twin(g):
//!    │           ↓          the image of one half-edge fixes its whole component
//!    g ──next──> ?
//! ```

use super::super::flat::NONE;
use super::explain::first_pointer;
use super::world::World;
use super::{Difference, Matching};
use crate::ids::{FaceId, HalfEdgeId, VertexId};

/// A map from half-edges to half-edges while it grows by walks that may be taken back.
pub(super) struct Matcher<'a> {
    world: &'a World,
    to: Vec<u32>,
    pub(super) face_to: Vec<u32>,
    face_from: Vec<u32>,
    vertex_to: Vec<u32>,
    trail: Vec<(u32, u32)>,
    face_trail: Vec<(u32, u32)>,
}

impl<'a> Matcher<'a> {
    pub(super) fn new(world: &'a World) -> Self {
        Self {
            world,
            to: vec![NONE; world.next.len()],
            face_to: vec![NONE; world.face_label.len()],
            face_from: vec![NONE; world.face_label.len()],
            vertex_to: vec![NONE; world.vertex_label.len()],
            trail: Vec::new(),
            face_trail: Vec::new(),
        }
    }

    /// Follows `next` and `twin` on both sides from `a` and `b` on, as far as labels, faces and earlier pairs
    /// agree. Whether they did all the way; the pairs stay until [`forget`](Self::forget).
    ///
    /// A map that keeps `next` and `twin` reaches all of a component, so between components of equal size it is
    /// one to one.
    pub(super) fn walk(&mut self, face_class: &[u32], a: u32, b: u32) -> bool {
        let world = self.world;
        let mut at = self.trail.len();
        self.to[a as usize] = b;
        self.trail.push((a, b));
        while let Some(&(a, b)) = self.trail.get(at) {
            at += 1;
            let (i, j) = (a as usize, b as usize);
            let (f, g) = (world.face[i], world.face[j]);
            if world.label[i] != world.label[j]
                || face_class[f as usize] != face_class[g as usize]
                || !self.pair_faces(f, g)
            {
                return false;
            }
            for (c, d) in [(world.next[i], world.next[j]), (world.twin[i], world.twin[j])] {
                match self.to[c as usize] {
                    NONE => {
                        self.to[c as usize] = d;
                        self.trail.push((c, d));
                    }
                    known if known == d => {}
                    _ => return false,
                }
            }
        }
        true
    }

    pub(super) fn pair_faces(&mut self, f: u32, g: u32) -> bool {
        let (to, from) = (&mut self.face_to[f as usize], &mut self.face_from[g as usize]);
        if *to == NONE && *from == NONE {
            (*to, *from) = (g, f);
            self.face_trail.push((f, g));
        }
        *to == g && *from == f
    }

    /// Takes back the pairs since the last [`keep`](Self::keep).
    pub(super) fn forget(&mut self) {
        for (a, _) in self.trail.drain(..) {
            self.to[a as usize] = NONE;
        }
        for (f, g) in self.face_trail.drain(..) {
            (self.face_to[f as usize], self.face_from[g as usize]) = (NONE, NONE);
        }
    }

    /// Matches vertices without edges by their labels. O(n log n).
    pub(super) fn match_isolated(&mut self, here: &[u32], there: &[u32]) {
        let [here, there] = [here, there].map(|vertices| {
            let mut sorted = vertices.to_vec();
            sorted.sort_by_key(|&v| self.world.vertex_label[v as usize]);
            sorted
        });
        here.iter().zip(there).for_each(|(&v, w)| self.vertex_to[v as usize] = w);
    }

    pub(super) fn keep(&mut self) {
        self.trail.clear();
        self.face_trail.clear();
    }

    /// Checks the whole map once more, pointer by pointer, and translates it into ids.
    pub(super) fn finish(mut self) -> Result<Matching, Difference> {
        let (world, split) = (self.world, self.world.split);
        let apart = || first_pointer(world).unwrap_or(Difference::Content { face: FaceId(0) });
        let mut taken = vec![false; self.to.len()];
        for &a in world.half_edges.iter().take_while(|&&a| a < split.half_edge) {
            let b = self.to[a as usize];
            if b == NONE || b < split.half_edge || std::mem::replace(&mut taken[b as usize], true) {
                return Err(apart());
            }
            let (i, j) = (a as usize, b as usize);
            let agree = |column: &[u32]| self.to[column[i] as usize] == column[j];
            let (v, w) = (world.origin[i], world.origin[j]);
            let known = std::mem::replace(&mut self.vertex_to[v as usize], w);
            let keeps = agree(&world.next) && agree(&world.prev) && agree(&world.twin);
            let keeps =
                keeps && self.face_to[world.face[i] as usize] == world.face[j] && world.label[i] == world.label[j];
            if !keeps || (known != NONE && known != w) {
                return Err(apart());
            }
        }
        let mut matching = Matching {
            vertices: vec![None; split.vertex as usize].into(),
            half_edges: vec![None; split.half_edge as usize].into(),
            faces: vec![None; split.face as usize].into(),
        };
        for &v in world.vertices.iter().take_while(|&&v| v < split.vertex) {
            let w = self.vertex_to[v as usize];
            // Its label agrees: that of an origin is part of its half-edge's, and those of all vertices pair up.
            if w == NONE {
                return Err(apart());
            }
            matching.vertices[VertexId(v)] = Some(VertexId(w - split.vertex));
        }
        for &h in world.half_edges.iter().take_while(|&&h| h < split.half_edge) {
            matching.half_edges[HalfEdgeId(h)] = Some(HalfEdgeId(self.to[h as usize] - split.half_edge));
        }
        for &f in world.faces.iter().take_while(|&&f| f < split.face) {
            let g = self.face_to[f as usize];
            if g == NONE || world.face_label[f as usize] != world.face_label[g as usize] {
                return Err(apart());
            }
            matching.faces[FaceId(f)] = Some(FaceId(g - split.face));
        }
        Ok(matching)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::Element;
    use crate::topology::{Dcel, IsomorphismOptions, NoRecorder};

    /// Colours rule most wrong starts out before any walk; the walk must not rely on that.
    #[test]
    fn a_walk_stops_at_labels_faces_and_earlier_pairs_that_disagree() {
        let square = Dcel::polygon(4).unwrap();
        let key = |v: VertexId| [u64::from(v.number() == 0), 0];
        let world = World::new(&square, &square, &IsomorphismOptions::new().keys(&key, &key)).unwrap();
        let mut matcher = Matcher::new(&world);
        let mut walk = |classes: &[u32], a, b| {
            let fits = matcher.walk(classes, a, b);
            matcher.forget();
            fits
        };
        assert!(walk(&world.face_label, 0, 8));
        assert!(!walk(&world.face_label, 0, 10), "v0 with a key onto v1 without");
        let mut classes = world.face_label.clone();
        classes[3] += 1;
        assert!(!walk(&classes, 0, 8), "f1 of one class onto f1 of another");
        let mut matcher = Matcher::new(&world);
        assert!(matcher.pair_faces(1, 2) && !matcher.walk(&world.face_label, 0, 8), "f1 is paired with f0 already");
    }

    /// Walks make no such map; the last check must not rely on that.
    #[test]
    fn a_finished_map_is_refused_if_labels_or_faces_disagree() {
        let square = Dcel::polygon(4).unwrap();
        let finish = |options: &IsomorphismOptions, to: [u32; 8], face_to: [u32; 2]| {
            let world = World::new(&square, &square, options).unwrap();
            let mut matcher = Matcher::new(&world);
            for (a, b) in (0..).zip(to) {
                matcher.to[a] = b + 8;
            }
            for (f, g) in (0..).zip(face_to) {
                matcher.face_to[f] = g + 2;
            }
            matcher.finish().is_ok()
        };
        let key = |v: VertexId| [u64::from(v.number() == 0), 0];
        let is_face = |element| matches!(element, Element::Face(_));
        let (any, keys) = (IsomorphismOptions::new(), IsomorphismOptions::new().keys(&key, &key));
        let faces = IsomorphismOptions::new().fixed(&is_face);
        let turned = [2, 3, 4, 5, 6, 7, 0, 1];
        assert!(finish(&any, turned, [0, 1]));
        assert!(!finish(&keys, turned, [0, 1]), "v0 with a key onto v1 without");
        assert!(!finish(&any, turned, [1, 0]), "the faces go elsewhere than their half-edges");
        let turned_over = [1, 0, 7, 6, 5, 4, 3, 2];
        assert!(finish(&any, turned_over, [1, 0]));
        assert!(!finish(&faces, turned_over, [1, 0]), "f0 onto f1, though both are fixed");
    }

    #[test]
    fn a_finished_map_is_refused_if_a_face_has_no_partner() {
        let mut face = Dcel::new();
        face.add_face_record(&mut NoRecorder);
        let world = World::new(&face, &face, &IsomorphismOptions::new()).unwrap();
        assert!(Matcher::new(&world).finish().is_err());
    }
}
