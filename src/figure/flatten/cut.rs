//! A structure cut open: which edges are cut, which corners are one vertex of the drawing, which edges are bent.

use super::clear;
use super::disc::{Disc, RADIUS, Web};
use crate::geometry::grouping::Joined;
use crate::ids::{EdgeId, FaceId, FaceMap, HalfEdgeId, HalfEdgeMap, VertexId, VertexMap};
use crate::topology::Dcel;
use std::collections::{BTreeMap, BTreeSet};

/// Where the circles of two components stand, in radii.
const APART: f64 = 2.6;
/// A drawing need not be clearer than this share of the radius.
const CLEAR: f64 = 0.12;

/// A structure spread out on paper. Its *nodes* are the vertices of the drawing: a vertex on a cut is several of them.
#[derive(Clone, Debug, Default)]
pub(in crate::figure) struct Spread {
    /// The node that each half-edge leaves.
    pub(super) node: HalfEdgeMap<u32>,
    /// The vertex of each node.
    pub(super) vertex: Vec<VertexId>,
    /// Where the nodes are.
    pub(super) at: Vec<[f64; 2]>,
    /// The two bends of the edges that have some, from the even half-edge's origin on.
    pub(super) bends: BTreeMap<EdgeId, [[f64; 2]; 2]>,
    /// The half-edges along the cuts, component by component, counter-clockwise.
    pub(super) sides: Vec<HalfEdgeId>,
    /// A half-edge of the outside of each component of genus 0.
    pub(super) outside: Vec<HalfEdgeId>,
}

/// The cut of one component.
struct Part {
    faces: Vec<FaceId>,
    sides: Vec<HalfEdgeId>,
    outside: Option<HalfEdgeId>,
    nodes: Vec<u32>,
}

impl Spread {
    /// Spreads a structure out, near to how it lay before.
    ///
    /// Cost: O(n) steps of a solver, O(n) each, and O(n²) to look for crossings.
    pub(in crate::figure) fn new(dcel: &Dcel, before: Option<&Self>) -> Self {
        Self::with_room(dcel, before, &VertexMap::filled(dcel.vertex_bound(), 1.0))
    }

    /// The same, where vertices have more or less room: above 0 and at most 1.
    pub(in crate::figure) fn with_room(dcel: &Dcel, before: Option<&Self>, room: &VertexMap<f64>) -> Self {
        let mut out = Self::default();
        let is_cut = cut(dcel, before);
        let outside = outside(dcel, before);
        out.node = HalfEdgeMap::filled(dcel.half_edge_bound(), u32::MAX);
        let mut parts: Vec<Part> = Vec::new();
        let mut seen = FaceMap::filled(dcel.face_bound(), false);
        for v in dcel.vertices() {
            let Some(first) = dcel.outgoing(v) else {
                out.vertex.push(v);
                let nodes = vec![out.vertex.len() as u32 - 1];
                parts.push(Part { faces: Vec::new(), sides: Vec::new(), outside: None, nodes });
                continue;
            };
            if !seen[dcel.face(first)] {
                let faces = component(dcel, dcel.face(first), &mut seen);
                let nodes = out.corners(dcel, &faces, &is_cut);
                let sides = sides(dcel, &faces, &is_cut);
                let outside = outside[dcel.face(first)].filter(|_| sides.is_empty());
                parts.push(Part { faces, sides, outside, nodes });
            }
        }
        out.at = vec![[0.0; 2]; out.vertex.len()];
        for (i, part) in parts.iter().enumerate() {
            let shift = APART * RADIUS * i as f64;
            out.place(dcel, part, shift, before, room);
            out.sides.extend(&part.sides);
            out.outside.extend(part.outside);
        }
        out
    }

    /// The nodes of a component.
    fn corners(&mut self, dcel: &Dcel, faces: &[FaceId], is_cut: &BTreeSet<EdgeId>) -> Vec<u32> {
        let mut nodes = Vec::new();
        for h in faces.iter().flat_map(|&f| dcel.incident_half_edges(f)) {
            if self.node[h] != u32::MAX {
                continue;
            }
            let node = self.vertex.len() as u32;
            // From the first half-edge clockwise after a cut, counter-clockwise up to the next one.
            let mut first = h;
            while !is_cut.contains(&first.edge()) {
                first = dcel.cw(first);
                if first == h {
                    break;
                }
            }
            let mut at = first;
            loop {
                self.node[at] = node;
                at = dcel.ccw(at);
                if at == first || is_cut.contains(&at.edge()) {
                    break;
                }
            }
            self.vertex.push(dcel.origin(h));
            nodes.push(node);
        }
        nodes
    }

    /// The node at which a half-edge ends.
    pub(super) fn end(&self, dcel: &Dcel, h: HalfEdgeId) -> u32 {
        self.node[dcel.next(h)]
    }

    /// Where a half-edge began before, and whether at the same vertex.
    fn former(&self, before: &Self, h: HalfEdgeId) -> Option<([f64; 2], bool)> {
        let node = before.node.get(h).copied().filter(|&node| node != u32::MAX)? as usize;
        Some((before.at[node], before.vertex[node] == self.vertex[self.node[h] as usize]))
    }

    /// Finds the places of a component.
    fn place(&mut self, dcel: &Dcel, part: &Part, shift: f64, before: Option<&Self>, room: &VertexMap<f64>) {
        let Some(&first) = part.nodes.first().filter(|_| !part.faces.is_empty()) else {
            part.nodes.iter().for_each(|&node| self.at[node as usize] = [shift, 0.0]);
            return;
        };
        let bent = self.bent(dcel, part);
        let web = self.web(dcel, part, &bent, first as usize, room);
        let back = |p: [f64; 2]| [p[0] - shift, p[1]];
        let mut known: Vec<Option<[f64; 2]>> = vec![None; web.drawn];
        if let Some(before) = before {
            // First what is still the same vertex; then a vertex that was split off, if nobody else stays there.
            let mut taken: BTreeSet<[u64; 2]> = BTreeSet::new();
            for is_same in [true, false] {
                for h in part.faces.iter().flat_map(|&f| dcel.incident_half_edges(f)) {
                    let i = (self.node[h] - first) as usize;
                    let former = self.former(before, h).filter(|former| former.1 == is_same && known[i].is_none());
                    let Some((at, _)) = former else { continue };
                    let bits = at.map(f64::to_bits);
                    if taken.insert(bits) {
                        known[i] = Some(back(at));
                    }
                }
            }
            for (e, &i) in bent.iter().zip(&web.bends) {
                let is_same = e.half_edges().iter().all(|&h| self.former(before, h).is_some_and(|former| former.1));
                let Some(bends) = before.bends.get(e).filter(|_| is_same) else { continue };
                (known[i], known[i + 1]) = (Some(back(bends[0])), Some(back(bends[1])));
            }
        }
        let disc = Disc::new(&web);
        let anew = disc.places(&known);
        let places = match known.iter().any(Option::is_some) {
            false => anew,
            true => {
                let near = disc.places_near(&known);
                let enough = (0.5 * clear::clearance(&web, &anew)).min(CLEAR * RADIUS);
                let part_way = |t: f64| -> Vec<[f64; 2]> {
                    near.iter().zip(&anew).map(|(a, b)| [0, 1].map(|i| a[i] + t * (b[i] - a[i]))).collect()
                };
                let sound =
                    |places: &Vec<[f64; 2]>| clear::is_sound(&web, places) && clear::clearance(&web, places) >= enough;
                [0.0, 0.25, 0.5, 0.75].into_iter().map(part_way).find(sound).unwrap_or(anew)
            }
        };
        for (&node, &[x, y]) in part.nodes.iter().zip(&places) {
            self.at[node as usize] = [x + shift, y];
        }
        for (&e, &i) in bent.iter().zip(&web.bends) {
            self.bends.insert(e, [places[i], places[i + 1]].map(|[x, y]| [x + shift, y]));
        }
    }

    /// The edges that need bends: loops, and all but one of those that join the same two nodes; that one is on the border
    /// of the drawing if it can be.
    fn bent(&self, dcel: &Dcel, part: &Part) -> Vec<EdgeId> {
        let cut: BTreeSet<EdgeId> = part.sides.iter().map(|h| h.edge()).collect();
        let mut joined: BTreeSet<[u32; 2]> = BTreeSet::new();
        let ends = |h: HalfEdgeId| {
            let (a, b) = (self.node[h], self.end(dcel, h));
            [a.min(b), a.max(b)]
        };
        joined.extend(part.sides.iter().map(|&h| ends(h)));
        let border = part.outside.into_iter().flat_map(|h| dcel.cycle(h)).map(HalfEdgeId::edge);
        let inner = part.faces.iter().flat_map(|&f| dcel.incident_half_edges(f)).map(HalfEdgeId::edge);
        let mut known: BTreeSet<EdgeId> = BTreeSet::new();
        let mut bent: BTreeSet<EdgeId> = BTreeSet::new();
        for e in border.chain(inner).filter(|e| !cut.contains(e)) {
            let [a, b] = ends(e.half_edges()[0]);
            if known.insert(e) && (a == b || !joined.insert([a, b])) {
                bent.insert(e);
            }
        }
        bent.into_iter().collect()
    }

    /// The walks round the faces of a component, by its nodes from 0 and then the bends.
    fn web(&self, dcel: &Dcel, part: &Part, bent: &[EdgeId], first: usize, room: &VertexMap<f64>) -> Web {
        let bends: Vec<usize> = (0..bent.len()).map(|i| part.nodes.len() + 2 * i).collect();
        let walk = |cycle: &mut dyn Iterator<Item = HalfEdgeId>| -> Vec<usize> {
            let mut out = Vec::new();
            for h in cycle {
                out.push(self.node[h] as usize - first);
                if let Ok(i) = bent.binary_search(&h.edge()) {
                    let [one, two] = if h.edge().half_edges()[0] == h { [0, 1] } else { [1, 0] };
                    out.extend([bends[i] + one, bends[i] + two]);
                }
            }
            out
        };
        let outside = part.outside.map(|h| dcel.face(h));
        let inner = part.faces.iter().filter(|&&f| Some(f) != outside);
        let faces = inner.map(|&f| walk(&mut dcel.incident_half_edges(f))).collect();
        let border = match part.outside {
            Some(h) => {
                let mut border = walk(&mut dcel.cycle(h));
                border.reverse();
                border
            }
            None => part.sides.iter().map(|&h| self.node[h] as usize - first).collect(),
        };
        let mut rooms: Vec<f64> = part.nodes.iter().map(|&node| room[self.vertex[node as usize]]).collect();
        for &e in bent {
            let ends = e.half_edges().map(|h| room[dcel.origin(h)]);
            rooms.extend([ends[0].max(ends[1]); 2]);
        }
        Web { drawn: part.nodes.len() + 2 * bent.len(), faces, border, bends, room: rooms }
    }
}

/// The faces of the component of a face, the lowest numbers first.
fn component(dcel: &Dcel, first: FaceId, seen: &mut FaceMap<bool>) -> Vec<FaceId> {
    let mut faces = vec![first];
    seen[first] = true;
    let mut i = 0;
    while let Some(&f) = faces.get(i) {
        for h in dcel.incident_half_edges(f) {
            // Round the vertex, too: faces that meet in a vertex alone are of one component.
            for g in dcel.star(h).map(|g| dcel.face(g)) {
                if !std::mem::replace(&mut seen[g], true) {
                    faces.push(g);
                }
            }
        }
        i += 1;
    }
    faces.sort_unstable();
    faces
}

/// The edges to be cut.
fn cut(dcel: &Dcel, before: Option<&Spread>) -> BTreeSet<EdgeId> {
    let was_cut: BTreeSet<EdgeId> = before.iter().flat_map(|s| &s.sides).map(|h| h.edge()).collect();
    let was_there = |e: EdgeId| before.is_some_and(|s| s.node.get(e.half_edges()[0]).is_some_and(|&n| n != u32::MAX));
    let rank = |e: &EdgeId| match (was_cut.contains(e), was_there(*e)) {
        (true, _) => 2,
        (false, true) => 0,
        (false, false) => 1,
    };
    let mut edges: Vec<EdgeId> = dcel.edges().collect();
    edges.sort_by_key(|e| (rank(e), *e));
    // A spanning tree of the dual graph.
    let mut joined = Joined::none(dcel.face_bound());
    let mut is_cut: BTreeSet<EdgeId> = BTreeSet::new();
    for e in edges {
        let [a, b] = e.half_edges().map(|h| dcel.face(h).number());
        if !joined.join(a, b) {
            is_cut.insert(e);
        }
    }
    // What dangles of the cut is sewn up.
    let mut degree = VertexMap::filled(dcel.vertex_bound(), 0_u32);
    for h in is_cut.iter().flat_map(|e| e.half_edges()) {
        degree[dcel.origin(h)] += 1;
    }
    let mut ends: Vec<VertexId> = dcel.vertices().filter(|&v| degree[v] == 1).collect();
    while let Some(v) = ends.pop() {
        let Some(h) = dcel.outgoing_half_edges(v).find(|h| is_cut.contains(&h.edge())) else { continue };
        is_cut.remove(&h.edge());
        for v in [v, dcel.destination(h)] {
            degree[v] -= 1;
            if degree[v] == 1 {
                ends.push(v);
            }
        }
    }
    is_cut
}

/// For each face a half-edge of the outside of its component: the face that was outside before, else the one with the
/// most half-edges, and of these the first.
fn outside(dcel: &Dcel, before: Option<&Spread>) -> FaceMap<Option<HalfEdgeId>> {
    let mut out = FaceMap::filled(dcel.face_bound(), None);
    let mut seen = FaceMap::filled(dcel.face_bound(), false);
    for f in dcel.faces() {
        if seen[f] || dcel.half_edge(f).is_none() {
            continue;
        }
        let faces = component(dcel, f, &mut seen);
        let former = before.iter().flat_map(|s| &s.outside).copied();
        let former = former.filter(|&h| dcel.has_half_edge(h)).map(|h| dcel.face(h)).find(|f| faces.contains(f));
        let size = |f: &FaceId| dcel.incident_half_edges(*f).count();
        let largest = faces.iter().copied().rev().max_by_key(size);
        let chosen = former.or(largest).and_then(|f| dcel.half_edge(f));
        faces.iter().for_each(|&f| out[f] = chosen);
    }
    out
}

/// The cut half-edges of a component in their order round the disc; the lowest one first.
fn sides(dcel: &Dcel, faces: &[FaceId], is_cut: &BTreeSet<EdgeId>) -> Vec<HalfEdgeId> {
    let all = || faces.iter().flat_map(|&f| dcel.incident_half_edges(f));
    let Some(first) = all().filter(|h| is_cut.contains(&h.edge())).min() else { return Vec::new() };
    let mut out = Vec::new();
    let mut at = first;
    loop {
        out.push(at);
        at = dcel.next(at);
        while !is_cut.contains(&at.edge()) {
            at = dcel.cw(at);
        }
        if at == first {
            return out;
        }
    }
}
