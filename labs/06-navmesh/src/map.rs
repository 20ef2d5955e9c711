//! Meshes: how they are made of triangles, the map of the handout, large ones.
//!
//! The triangle with the number t is the face f(t+1); f0 is the outer face. The k-th edge that the triangles state, each
//! its sides in order, has the half-edges h(2k), on the side that states it first, and h(2k+1), on the other side.

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::{Dcel, HalfEdgeId, Point, VertexId};
use crate::harness::{points, whole};
use std::collections::HashMap;

/// A side between two triangles, as one sees it who goes from one to the other.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Portal {
    /// Its end on the left.
    pub left: VertexId,
    /// Its end on the right.
    pub right: VertexId,
}

/// The points of the map: a room with two partitions and a pillar.
const POINTS: [[f64; 2]; 13] = [
    [-250.0, -150.0],
    [-110.0, -150.0],
    [-80.0, 60.0],
    [-50.0, -150.0],
    [250.0, -150.0],
    [250.0, 150.0],
    [110.0, 150.0],
    [80.0, -60.0],
    [50.0, 150.0],
    [-250.0, 150.0],
    [160.0, 0.0],
    [200.0, 40.0],
    [200.0, -50.0],
];
/// Its triangles.
const TRIANGLES: [[usize; 3]; 13] = [
    [0, 1, 2],
    [0, 2, 9],
    [2, 3, 7],
    [2, 7, 8],
    [2, 8, 9],
    [3, 4, 7],
    [4, 5, 11],
    [4, 12, 7],
    [4, 11, 12],
    [5, 6, 11],
    [6, 7, 10],
    [6, 10, 11],
    [7, 12, 10],
];
/// Where the path of the picture begins.
pub const START: Point = Point { x: -150.0, y: -120.0 };
/// Where it ends.
pub const GOAL: Point = Point { x: 235.0, y: 60.0 };

/// `map`: the map of the handout.
pub fn map(words: &[&str]) -> Result<Dcel, String> {
    if !words.is_empty() {
        return Err("the map is always the same".to_owned());
    }
    build(&POINTS, &TRIANGLES)
}

/// `mesh x y x y … / i j k …`: points, then the corners of counter-clockwise triangles by number from 0.
pub fn mesh(words: &[&str]) -> Result<Dcel, String> {
    let mut halves = words.split(|&word| word == "/");
    let (Some(coordinates), Some(corners), None) = (halves.next(), halves.next(), halves.next()) else {
        return Err("write the points, one `/`, then the corners of the triangles".to_owned());
    };
    let corners: Vec<usize> = corners.iter().map(|word| whole(word)).collect::<Result<_, _>>()?;
    if corners.is_empty() || !corners.len().is_multiple_of(3) {
        return Err(format!("triangles have 3 corners each; {} corners are left over", corners.len() % 3));
    }
    let triangles: Vec<[usize; 3]> = corners.chunks_exact(3).map(|three| [three[0], three[1], three[2]]).collect();
    build(&points(coordinates)?, &triangles)
}

/// `cells N M`: N times M square cells, row by row from below, each cut into two triangles by a diagonal that goes up.
pub fn cells(words: &[&str]) -> Result<Dcel, String> {
    let &[n, m] = words else { return Err("it takes two numbers".to_owned()) };
    let (n, m) = (whole(n)?, whole(m)?);
    if n == 0 || m == 0 || n.saturating_mul(m) > 500_000 {
        return Err("from 1 to 500000 cells".to_owned());
    }
    let points: Vec<[f64; 2]> = (0..=m).flat_map(|y| (0..=n).map(move |x| [x as f64, y as f64])).collect();
    let mut triangles = Vec::new();
    for y in 0..m {
        for x in 0..n {
            let (below, above) = (y * (n + 1) + x, (y + 1) * (n + 1) + x);
            triangles.push([below, below + 1, above + 1]);
            triangles.push([below, above + 1, above]);
        }
    }
    build(&points, &triangles)
}

/// The mesh of some triangles. What is not a triangle belongs to the outer face.
fn build(points: &[[f64; 2]], triangles: &[[usize; 3]]) -> Result<Dcel, String> {
    let mut mesh = Dcel::default();
    mesh.outer_face = mesh.new_face();
    for &[x, y] in points {
        mesh.new_vertex(x, y);
    }
    let mut sides: HashMap<(VertexId, VertexId), HalfEdgeId> = HashMap::new();
    for (number, &[a, b, c]) in triangles.iter().enumerate() {
        if let Some(missing) = [a, b, c].iter().find(|&&v| v >= points.len()) {
            return Err(format!("triangle {number}: there is no point {missing}: there are {}", points.len()));
        }
        let face = mesh.new_face();
        let mut three = Vec::new();
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let side = match sides.get(&(from, to)) {
                None => {
                    let side = mesh.new_half_edge(from);
                    let twin = mesh.new_half_edge(to);
                    mesh.make_twin(side, twin);
                    mesh.half_edges[twin].face = Some(mesh.outer_face);
                    sides.insert((to, from), twin);
                    sides.insert((from, to), side);
                    side
                }
                Some(&side) if mesh.half_edges[side].face == Some(mesh.outer_face) => side,
                Some(_) => return Err(format!("triangle {number}: another one has the side from {from} to {to}")),
            };
            mesh.half_edges[side].face = Some(face);
            mesh.vertices[from].outgoing_half_edge.get_or_insert(side);
            three.push(side);
        }
        for i in 0..3 {
            mesh.make_next(three[i], three[(i + 1) % 3]);
        }
        mesh.faces[face].incident_half_edge = Some(three[0]);
    }
    link_walls(&mut mesh);
    Ok(mesh)
}

/// Links the half-edges of the outer face: each leads on to the first one that is met when one turns clockwise, from the
/// wall that ends at a point, through what is outside.
fn link_walls(mesh: &mut Dcel) {
    let mut from: HashMap<VertexId, Vec<HalfEdgeId>> = HashMap::new();
    let walls: Vec<HalfEdgeId> =
        (0..mesh.half_edges.len()).filter(|&h| mesh.half_edges[h].face == Some(mesh.outer_face)).collect();
    for &h in &walls {
        from.entry(mesh.origin(h)).or_default().push(h);
    }
    for &h in &walls {
        let at = mesh.origin(mesh.twin(h));
        let angle = |g: HalfEdgeId| {
            let (p, q) = (mesh.position(at), mesh.position(mesh.origin(mesh.twin(g))));
            (q.y - p.y).atan2(q.x - p.x)
        };
        // How far one turns clockwise from the wall: a whole turn at a single point.
        let back = angle(mesh.twin(h));
        let turned = |g: HalfEdgeId| (back - angle(g)).rem_euclid(std::f64::consts::TAU);
        let next = from[&at].iter().copied().min_by(|&a, &b| turned(a).total_cmp(&turned(b)));
        if let Some(next) = next {
            mesh.make_next(h, next);
        }
    }
    if let Some(&wall) = walls.first() {
        mesh.faces[mesh.outer_face].incident_half_edge = Some(wall);
    }
}
