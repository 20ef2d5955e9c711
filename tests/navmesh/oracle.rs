//! Slow answers: what is where by looking at everything; shortest paths by a visibility graph and Dijkstra.
//!
//! ```text
//!   a node: a vertex in one of its wedges, or a point inside a triangle
//!   an edge: a segment that crosses no border, passes no vertex, and leaves both ends into their wedges
//! ```

use crate::maps::Map;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{left_to_right, orientation};

/// The free triangles of a map and what follows from them.
pub(crate) struct Oracle<'a> {
    map: &'a Map,
    pub(crate) free: Vec<bool>,
    /// Sides of free triangles that no other free triangle has.
    borders: Vec<[u32; 2]>,
    /// (vertex, free triangles of one wedge)
    wedges: Vec<(u32, Vec<usize>)>,
}

/// A node of the visibility graph.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) point: Point,
    /// The triangles one stands in there.
    pub(crate) triangles: Vec<usize>,
    vertex: Option<u32>,
}

impl<'a> Oracle<'a> {
    pub(crate) fn new(map: &'a Map, free: Vec<bool>) -> Self {
        let mut oracle = Self { map, free, borders: Vec::new(), wedges: Vec::new() };
        for t in oracle.free_triangles().collect::<Vec<_>>() {
            for side in sides(map.triangles[t]) {
                if oracle.across(t, side).is_none() {
                    oracle.borders.push(side);
                }
            }
        }
        for v in 0..map.points.len() as u32 {
            let mut left: Vec<usize> = oracle.free_triangles().filter(|&t| map.triangles[t].contains(&v)).collect();
            while let Some(first) = left.pop() {
                let mut wedge = vec![first];
                let mut i = 0;
                while i < wedge.len() {
                    for side in sides(map.triangles[wedge[i]]).into_iter().filter(|side| side.contains(&v)) {
                        let next = oracle.across(wedge[i], side).filter(|next| left.contains(next));
                        left.retain(|&t| Some(t) != next);
                        wedge.extend(next);
                    }
                    i += 1;
                }
                oracle.wedges.push((v, wedge));
            }
        }
        oracle
    }

    pub(crate) fn all_free(map: &'a Map) -> Self {
        Self::new(map, vec![true; map.triangles.len()])
    }

    pub(crate) fn free_triangles(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.free.len()).filter(|&t| self.free[t])
    }

    /// The free triangle on the other side of a side.
    pub(crate) fn across(&self, t: usize, [a, b]: [u32; 2]) -> Option<usize> {
        self.free_triangles().find(|&u| u != t && sides(self.map.triangles[u]).contains(&[b, a]))
    }

    pub(crate) fn neighbours(&self, t: usize) -> Vec<usize> {
        sides(self.map.triangles[t]).into_iter().filter_map(|side| self.across(t, side)).collect()
    }

    /// How far a point is from the nearest border.
    pub(crate) fn clearance(&self, p: Point) -> f64 {
        self.clearance_along([p, p])
    }

    /// How far a segment that crosses no border is from the nearest one.
    pub(crate) fn clearance_along(&self, [a, b]: [Point; 2]) -> f64 {
        let borders = self.borders.iter().map(|side| side.map(|v| self.map.points[v as usize]));
        let ends = |[c, d]: [Point; 2]| {
            [to_segment(a, [c, d]), to_segment(b, [c, d]), to_segment(c, [a, b]), to_segment(d, [a, b])]
        };
        borders.flat_map(ends).fold(f64::INFINITY, f64::min)
    }

    /// Whether a segment crosses a border.
    pub(crate) fn crosses_border(&self, segment: [Point; 2]) -> bool {
        self.borders.iter().any(|side| cross(segment, side.map(|v| self.map.points[v as usize])))
    }

    /// All nodes at vertices.
    pub(crate) fn vertex_nodes(&self) -> Vec<Node> {
        let node = |(v, triangles): &(u32, Vec<usize>)| Node {
            point: self.map.points[*v as usize],
            triangles: triangles.clone(),
            vertex: Some(*v),
        };
        self.wedges.iter().map(node).collect()
    }

    pub(crate) fn inner_node(point: Point, triangle: usize) -> Node {
        Node { point, triangles: vec![triangle], vertex: None }
    }

    /// Whether the segment leads from one node straight to the other, with no vertex on the way.
    fn sees(&self, from: &Node, to: &Node) -> bool {
        let (a, b) = (from.point, to.point);
        let vertices = || self.wedges.iter().map(|&(v, _)| self.map.points[v as usize]);
        a != b
            && self.leaves_into(from, b)
            && self.leaves_into(to, a)
            && !vertices().any(|p| p != a && p != b && orientation(a, b, p).is_eq() && between(a, p, b))
            && !self.borders.iter().any(|&[u, v]| cross([a, b], [u, v].map(|v| self.map.points[v as usize])))
    }

    /// Whether the direction to `p` leads from the node into one of its triangles, or along a side of one.
    fn leaves_into(&self, node: &Node, p: Point) -> bool {
        let Some(v) = node.vertex else { return true };
        node.triangles.iter().any(|&t| {
            let [a, b, c] = self.map.triangles[t];
            let [_, from, to] = [[a, b, c], [b, c, a], [c, a, b]].into_iter().find(|c| c[0] == v).unwrap();
            let [from, to] = [from, to].map(|v| self.map.points[v as usize]);
            orientation(node.point, from, p).is_ge() && orientation(node.point, p, to).is_ge()
        })
    }

    /// The length of the shortest path; `None` if there is none.
    pub(crate) fn shortest(&self, start: &Node, goal: &Node) -> Option<f64> {
        self.distances(start, std::slice::from_ref(goal))[0]
    }

    /// The lengths of the shortest paths to the goals.
    pub(crate) fn distances(&self, start: &Node, goals: &[Node]) -> Vec<Option<f64>> {
        let mut nodes = self.vertex_nodes();
        nodes.push(start.clone());
        let first_goal = nodes.len();
        nodes.extend_from_slice(goals);
        let is_same = |a: &Node, b: &Node| a.point == b.point && a.triangles.iter().any(|t| b.triangles.contains(t));
        let mut length: Vec<f64> =
            nodes.iter().map(|node| if is_same(node, start) { 0.0 } else { f64::INFINITY }).collect();
        let mut done = vec![false; nodes.len()];
        while let Some(i) = (0..nodes.len())
            .filter(|&i| !done[i] && length[i].is_finite())
            .min_by(|&i, &j| length[i].total_cmp(&length[j]))
        {
            done[i] = true;
            for j in (0..nodes.len()).filter(|&j| !done[j]).collect::<Vec<_>>() {
                let far = distance(nodes[i].point, nodes[j].point);
                if length[i] + far < length[j] && (is_same(&nodes[i], &nodes[j]) || self.sees(&nodes[i], &nodes[j])) {
                    length[j] = length[i] + far;
                }
            }
        }
        length[first_goal..].iter().map(|&length| length.is_finite().then_some(length)).collect()
    }
}

pub(crate) fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

pub(crate) fn distance(a: Point, b: Point) -> f64 {
    (b.x - a.x).hypot(b.y - a.y)
}

fn to_segment(p: Point, [a, b]: [Point; 2]) -> f64 {
    let d = [b.x - a.x, b.y - a.y];
    let t = ((p.x - a.x) * d[0] + (p.y - a.y) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
    // No number if the segment is a point.
    let t = if t > 0.0 { t.min(1.0) } else { 0.0 };
    distance(p, Point::new(a.x + d[0] * t, a.y + d[1] * t))
}

/// Of three points on a line, whether `p` is strictly between the others.
pub(crate) fn between(a: Point, p: Point, b: Point) -> bool {
    p != a && p != b && left_to_right(a, p) == left_to_right(p, b)
}

/// Whether two segments cross in a point inside both.
fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let apart = |a, b, c, d| {
        let [one, other] = [orientation(a, b, c), orientation(a, b, d)];
        one.is_ne() && other.is_ne() && one != other
    };
    apart(a, b, c, d) && apart(c, d, a, b)
}

/// The triangles that closed have the point.
pub(crate) fn triangles_with(map: &Map, p: Point) -> Vec<usize> {
    let has = |&t: &usize| {
        let [a, b, c] = map.corners(t);
        orientation(a, b, p).is_ge() && orientation(b, c, p).is_ge() && orientation(c, a, p).is_ge()
    };
    (0..map.triangles.len()).filter(has).collect()
}
