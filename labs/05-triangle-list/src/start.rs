//! What cases begin with: vertices, and nothing else yet.

use crate::dcel::Dcel;
use crate::harness::{points, whole};

/// Vertices are numbers here; more than this many are a slip of the keyboard.
const MOST: usize = 1_000_000;

/// `vertices 5`: so many vertices, all at one place.
pub fn vertices(words: &[&str]) -> Result<Dcel, String> {
    let &[count] = words else { return Err("it takes one number".to_owned()) };
    let count = whole(count)?;
    if count > MOST {
        return Err(format!("it takes at most {MOST}, not {count}"));
    }
    Ok(with_vertices(&vec![[0.0, 0.0]; count]))
}

/// `points x y x y …`: a vertex at each point.
pub fn at_points(words: &[&str]) -> Result<Dcel, String> {
    Ok(with_vertices(&points(words)?))
}

/// The vertices, and the outer face, which has no half-edge yet.
pub fn with_vertices(places: &[[f64; 2]]) -> Dcel {
    let mut dcel = Dcel::default();
    dcel.outer_face = dcel.new_face();
    for &[x, y] in places {
        dcel.new_vertex(x, y);
    }
    dcel
}

/// The faces of a line: before the corners of each face stands how many they are, `3 0 1 2 4 0 2 3 4`. The last face
/// may be cut short.
pub fn faces(numbers: &[usize]) -> Vec<Vec<usize>> {
    let mut faces = Vec::new();
    let mut rest = numbers;
    while let Some((&corners, after)) = rest.split_first() {
        let (face, others) = after.split_at(corners.min(after.len()));
        faces.push(face.to_vec());
        rest = others;
    }
    faces
}

/// The triangles of `n` times `n` cells, each cut by a diagonal; the vertices are numbered row by row from 0, n + 1 in
/// a row.
pub fn cut_cells(n: usize) -> Vec<Vec<usize>> {
    let vertex = |x: usize, y: usize| y * (n + 1) + x;
    let mut faces = Vec::new();
    for y in 0..n {
        for x in 0..n {
            faces.push(vec![vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)]);
            faces.push(vec![vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)]);
        }
    }
    faces
}
