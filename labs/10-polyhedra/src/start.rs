//! The polyhedra that cases start from.
//!
//! ```text
//!   solid 0 0 0  1 0 0  0 1 0  0 0 1 / 0 2 1 / 0 1 3 / 1 2 3 / 2 0 3      points, then the corners of each face
//!   faces 0 2 1 / 0 1 3 / 1 2 3 / 2 0 3                                   the same with all points at (0, 0, 0)
//! ```
//!
//! The corners of a face are counter-clockwise seen from outside. The i-th corner that is written is the origin of the
//! half-edge hi, and the first time that a vertex or a face is written, it gets its half-edge.

use crate::harness::{places, whole};
use crate::polyhedron::{Point, Polyhedron};
use std::collections::HashMap;

/// `solid x y z … / 0 1 2 / …`
pub fn solid(words: &[&str]) -> Result<Polyhedron, String> {
    let mut parts = words.split(|word| *word == "/");
    let points = places(parts.next().unwrap_or_default())?;
    surface(points, &parts.map(corners).collect::<Result<Vec<_>, _>>()?)
}

/// `faces 0 1 2 / …`
pub fn faces(words: &[&str]) -> Result<Polyhedron, String> {
    let faces = words.split(|word| *word == "/").map(corners).collect::<Result<Vec<_>, _>>()?;
    let vertices = faces.iter().flatten().max().map_or(0, |v| v + 1);
    if vertices > MOST {
        return Err(format!("vertex {} is too large a number; count them from 0", vertices - 1));
    }
    surface(vec![[0.0; 3]; vertices], &faces)
}

/// `torus N M`: N times M faces with four corners, N round the hole and M round the tube, all points at (0, 0, 0). The
/// vertex number i M + j is the j-th of the i-th ring.
pub fn torus(words: &[&str]) -> Result<Polyhedron, String> {
    let &[n, m] = words else { return Err("it takes two numbers".to_owned()) };
    let (n, m) = (whole(n)?, whole(m)?);
    if n.min(m) < 3 || n.saturating_mul(m) > MOST {
        return Err(format!("each number is at least 3, and there are at most {MOST} faces"));
    }
    let at = |i: usize, j: usize| i % n * m + j % m;
    let cells = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    let faces: Vec<_> = cells.map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect();
    surface(vec![[0.0; 3]; n * m], &faces)
}

/// `frame`: a square picture frame, a polyhedron with a hole through it. All of its 16 faces are flat.
pub fn frame(words: &[&str]) -> Result<Polyhedron, String> {
    if !words.is_empty() {
        return Err("it stands alone in its line".to_owned());
    }
    let profile = [(1.0, 0.0), (3.0, 0.0), (3.0, 2.0), (1.0, 2.0)];
    let sides = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let points = sides.iter().flat_map(|(x, y)| profile.map(|(r, z)| [r * x, r * y, z])).collect();
    let at = |i: usize, j: usize| i % 4 * 4 + j % 4;
    let cells = (0..16).map(|k| (k / 4, k % 4));
    let faces: Vec<_> = cells.map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect();
    surface(points, &faces)
}

/// `platonic cube`
pub fn platonic(words: &[&str]) -> Result<Polyhedron, String> {
    let text = match words {
        ["tetrahedron"] => TETRAHEDRON,
        ["cube"] => CUBE,
        ["octahedron"] => OCTAHEDRON,
        ["dodecahedron"] => DODECAHEDRON,
        ["icosahedron"] => ICOSAHEDRON,
        _ => return Err("there are tetrahedron, cube, octahedron, dodecahedron and icosahedron".to_owned()),
    };
    solid(&text.split_whitespace().collect::<Vec<_>>())
}

/// So many faces or vertices a start can have.
const MOST: usize = 1_000_000;

fn corners(words: &[&str]) -> Result<Vec<usize>, String> {
    words.iter().map(|word| whole(word)).collect()
}

fn surface(points: Vec<[f64; 3]>, faces: &[Vec<usize>]) -> Result<Polyhedron, String> {
    let mut made = Polyhedron::default();
    for [x, y, z] in points {
        made.new_vertex(Point { x, y, z });
    }
    let mut by_ends = HashMap::new();
    for (number, corners) in faces.iter().enumerate() {
        if corners.len() < 3 {
            return Err(format!("face {number} has {} corners; a face has at least 3", corners.len()));
        }
        if let Some((i, v)) = corners.iter().enumerate().find(|&(i, v)| corners[..i].contains(v)) {
            return Err(format!("face {number} comes to vertex {v} twice, the second time as its corner {i}"));
        }
        if let Some(v) = corners.iter().find(|&&v| v >= made.vertices.len()) {
            return Err(format!("face {number} has a vertex {v}; there are {}", made.vertices.len()));
        }
        let (f, first) = (made.new_face(), made.half_edges.len());
        made.faces[f].incident_half_edge = Some(first);
        for (i, &from) in corners.iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            let h = made.new_half_edge();
            made.half_edges[h].origin = Some(from);
            made.half_edges[h].face = Some(f);
            made.vertices[from].outgoing_half_edge.get_or_insert(h);
            if by_ends.insert((from, to), h).is_some() {
                return Err(format!("two faces go from {from} to {to}, one of them is face {number}; turn it round"));
            }
            if let Some(&twin) = by_ends.get(&(to, from)) {
                made.make_twin(h, twin);
            }
        }
        for i in 0..corners.len() {
            made.make_next(first + i, first + (i + 1) % corners.len());
        }
    }
    check(&made)?;
    Ok(made)
}

/// Is it a closed surface?
fn check(made: &Polyhedron) -> Result<(), String> {
    let mut spokes = vec![0; made.vertices.len()];
    for h in 0..made.half_edges.len() {
        let (from, to) = (made.origin(h), made.origin(made.next(h)));
        spokes[from] += 1;
        if made.half_edges[h].twin.is_none() {
            return Err(format!("the edge from {from} to {to} has a face on one side only"));
        }
    }
    for (v, &count) in spokes.iter().enumerate() {
        if count == 0 {
            return Err(format!("no face has the vertex {v}"));
        }
        let first = made.outgoing_half_edge(v);
        let mut round = 1;
        let mut h = made.next(made.twin(first));
        while h != first {
            round += 1;
            h = made.next(made.twin(h));
        }
        if round < count {
            return Err(format!("the faces at vertex {v} are not one circle round it"));
        }
    }
    Ok(())
}

const TETRAHEDRON: &str = "\
    1 1 1  1 -1 -1  -1 1 -1  -1 -1 1 \
    / 0 1 2 / 0 2 3 / 0 3 1 / 1 3 2";

const CUBE: &str = "\
    -1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1  -1 -1 1  1 -1 1  1 1 1  -1 1 1 \
    / 0 1 5 4 / 0 3 2 1 / 0 4 7 3 / 1 2 6 5 / 2 3 7 6 / 4 5 6 7";

const OCTAHEDRON: &str = "\
    1 0 0  0 1 0  -1 0 0  0 -1 0  0 0 1  0 0 -1 \
    / 0 1 4 / 0 3 5 / 0 4 3 / 0 5 1 / 1 2 4 / 1 5 2 / 2 3 4 / 2 5 3";

const DODECAHEDRON: &str = "\
    1 1 1  1 1 -1  1 -1 1 \
    1 -1 -1  -1 1 1  -1 1 -1 \
    -1 -1 1  -1 -1 -1  0 1.618033988749895 0.6180339887498948 \
    0 1.618033988749895 -0.6180339887498948  0 -1.618033988749895 0.6180339887498948  0 -1.618033988749895 -0.6180339887498948 \
    0.6180339887498948 0 1.618033988749895  -0.6180339887498948 0 1.618033988749895  0.6180339887498948 0 -1.618033988749895 \
    -0.6180339887498948 0 -1.618033988749895  1.618033988749895 0.6180339887498948 0  1.618033988749895 -0.6180339887498948 0 \
    -1.618033988749895 0.6180339887498948 0  -1.618033988749895 -0.6180339887498948 0 \
    / 0 8 4 13 12 / 0 12 2 17 16 / 0 16 1 9 8 / 1 14 15 5 9 / 1 16 17 3 14 / 2 10 11 3 17 / 2 12 13 6 10 / 3 11 7 15 14 \
    / 4 8 9 5 18 / 4 18 19 6 13 / 5 15 7 19 18 / 6 19 7 11 10";

const ICOSAHEDRON: &str = "\
    0 1 1.618033988749895  0 1 -1.618033988749895  0 -1 1.618033988749895 \
    0 -1 -1.618033988749895  1.618033988749895 0 1  -1.618033988749895 0 1 \
    1.618033988749895 0 -1  -1.618033988749895 0 -1  1 1.618033988749895 0 \
    1 -1.618033988749895 0  -1 1.618033988749895 0  -1 -1.618033988749895 0 \
    / 0 2 4 / 0 4 8 / 0 5 2 / 0 8 10 / 0 10 5 / 1 3 7 / 1 6 3 / 1 7 10 \
    / 1 8 6 / 1 10 8 / 2 5 11 / 2 9 4 / 2 11 9 / 3 6 9 / 3 9 11 / 3 11 7 \
    / 4 6 8 / 4 9 6 / 5 7 11 / 5 10 7";
