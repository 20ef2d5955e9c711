//! Inputs of the benchmarks, the same in every run.

use crate::Random;

/// A list of triangles over the vertices `0 .. vertices`.
pub struct Triangles {
    /// What the tables call it.
    pub name: &'static str,
    /// The number of vertices.
    pub vertices: usize,
    /// Three corners each, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
}

/// A square grid of about `count` triangles, row by row.
pub fn ordered(count: usize) -> Triangles {
    let side = ((count / 2) as f64).sqrt().round() as u32;
    let at = |x: u32, y: u32| y * (side + 1) + x;
    let triangles = (0..side)
        .flat_map(|y| (0..side).map(move |x| (x, y)))
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    Triangles { name: "ordered", vertices: ((side + 1) * (side + 1)) as usize, triangles }
}

/// The same grid with vertices and triangles renumbered at random.
pub fn shuffled(count: usize) -> Triangles {
    let mut random = Random::new(1);
    let grid = ordered(count);
    let mut new: Vec<u32> = (0..grid.vertices as u32).collect();
    random.shuffle(&mut new);
    let mut triangles: Vec<_> = grid.triangles.iter().map(|t| t.map(|v| new[v as usize])).collect();
    random.shuffle(&mut triangles);
    Triangles { name: "shuffled", vertices: grid.vertices, triangles }
}

/// The Delaunay triangulation of random points, as its program lists it: about `count` triangles.
pub fn delaunay(count: usize) -> Triangles {
    let mut random = Random::new(2);
    let points: Vec<_> = (0..count / 2).map(|_| delaunator::Point { x: random.unit(), y: random.unit() }).collect();
    let corners = delaunator::triangulate(&points).triangles;
    let triangles = corners.chunks_exact(3).map(|t| [t[0] as u32, t[1] as u32, t[2] as u32]).collect();
    Triangles { name: "Delaunay", vertices: points.len(), triangles }
}

/// The three orders of the tables.
pub fn three_orders(count: usize) -> [Triangles; 3] {
    [ordered(count), shuffled(count), delaunay(count)]
}
