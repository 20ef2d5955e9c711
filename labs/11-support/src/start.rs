//! The meshes that cases start from.

use crate::dcel::{Face, HalfEdge, Mesh, NO_HALF_EDGE, Place, Vertex};
use crate::harness::{places, whole};
use std::collections::BTreeMap;

/// The gem of the handout.
const GEM: [Place; 8] = [
    [0.0, 0.0, -60.0],
    [120.0, -20.0, -10.0],
    [60.0, 100.0, 0.0],
    [-70.0, 90.0, -10.0],
    [-120.0, -10.0, 0.0],
    [-40.0, -110.0, 0.0],
    [70.0, -100.0, -10.0],
    [20.0, 10.0, 150.0],
];
/// The direction of the picture: upwards, and a little to the right.
pub const DIRECTION: Place = [1.0, 2.0, 5.0];
/// Where the climb of the picture begins: the lowest corner.
pub const FROM: usize = 0;

/// `empty`: no vertex yet.
pub fn empty(words: &[&str]) -> Result<Mesh, String> {
    alone(words)?;
    Ok(Mesh::default())
}

/// `gem`: a pyramid with six sides above and below.
pub fn gem(words: &[&str]) -> Result<Mesh, String> {
    alone(words)?;
    let mut triangles = Vec::new();
    for k in 1..=6 {
        let next = k % 6 + 1;
        triangles.push([k, next, 7]);
        triangles.push([next, k, 0]);
    }
    Ok(build(&GEM, &triangles))
}

fn alone(words: &[&str]) -> Result<(), String> {
    if words.is_empty() { Ok(()) } else { Err("it stands alone in its line".to_owned()) }
}

/// `soup x y z x y z … / i j k … / v …`: points, then the corners of triangles by number, counter-clockwise from outside,
/// then, if there are any, the vertices that are free, in the order in which they became so.
pub fn soup(words: &[&str]) -> Result<Mesh, String> {
    let mut parts = words.split(|&word| word == "/");
    let (Some(points), Some(corners), free, None) = (parts.next(), parts.next(), parts.next(), parts.next()) else {
        return Err("write the points, one `/`, then the corners of the triangles".to_owned());
    };
    let (points, corners) = (places(points)?, corners.iter().map(|word| whole(word)).collect::<Result<Vec<_>, _>>()?);
    if !corners.len().is_multiple_of(3) || corners.iter().any(|&v| v >= points.len()) {
        return Err("each triangle has three corners, which are numbers of points".to_owned());
    }
    let triangles: Vec<[usize; 3]> = corners.chunks_exact(3).map(|three| [three[0], three[1], three[2]]).collect();
    let mut mesh = build(&points, &triangles);
    for word in free.unwrap_or_default() {
        let v = whole(word)?;
        if v >= points.len() || corners.contains(&v) || mesh.free_vertices.contains(&v) {
            return Err(format!("{v} cannot be free: it is no point, or a corner of a triangle, or named twice"));
        }
        mesh.vertices[v].live = false;
        mesh.free_vertices.push(v);
    }
    Ok(mesh)
}

/// `cube N`: a cube whose sides are cut into N times N squares, each of two triangles.
pub fn cube(words: &[&str]) -> Result<Mesh, String> {
    let &[n] = words else { return Err("it takes one number".to_owned()) };
    let n = whole(n)?;
    if n == 0 || n > 200 {
        return Err("from 1 to 200".to_owned());
    }
    let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for (axis, end) in [(0, 0), (0, n), (1, 0), (1, n), (2, 0), (2, n)] {
        for i in 0..n {
            for j in 0..n {
                let mut corner = |di: usize, dj: usize| {
                    let mut at = [end; 3];
                    at[(axis + 1) % 3] = i + di;
                    at[(axis + 2) % 3] = j + dj;
                    *numbers.entry(at).or_insert_with(|| {
                        points.push(at.map(|x| x as f64));
                        points.len() - 1
                    })
                };
                let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                let two = if end == n { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
                triangles.extend(two);
            }
        }
    }
    Ok(build(&points, &triangles))
}

fn build(points: &[Place], triangles: &[[usize; 3]]) -> Mesh {
    let mut mesh = Mesh::default();
    for &pos in points {
        mesh.vertices.push(Vertex { outgoing_half_edge: None, pos, live: true });
    }
    for (number, &[a, b, c]) in triangles.iter().enumerate() {
        let mut sides = [0; 3];
        for (side, (from, to)) in sides.iter_mut().zip([(a, b), (b, c), (c, a)]) {
            *side = match mesh.half_edge_between(from, to) {
                Some(h) => h,
                None => {
                    let h = mesh.half_edges.len();
                    let one = HalfEdge { origin: Some(from), twin: Some(h + 1), live: true, ..NO_HALF_EDGE };
                    mesh.half_edges.push(one);
                    mesh.half_edges.push(HalfEdge { origin: Some(to), twin: Some(h), ..one });
                    mesh.edges.insert((from, to), h);
                    mesh.edges.insert((to, from), h + 1);
                    h
                }
            };
            mesh.vertices[from].outgoing_half_edge.get_or_insert(*side);
        }
        for i in 0..3 {
            let h = &mut mesh.half_edges[sides[i]];
            h.face = Some(number);
            h.next = Some(sides[(i + 1) % 3]);
            h.prev = Some(sides[(i + 2) % 3]);
        }
        mesh.faces.push(Face { incident_half_edge: Some(sides[0]), live: true });
    }
    mesh
}
