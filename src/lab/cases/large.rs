//! The large structures that a driver makes of one line, as tables: a case need not print them to know them.
//!
//! ```text
//!   convex 300        wheel 40             grid 150 150
//!   one polygon       triangles round v0   square cells, row by row from below; first all edges to the right,
//!                                          then all edges upwards
//!   lattice 150 150   the same with every row half a cell further to the right, each cell cut in two triangles
//! ```
//!
//! The k-th edge has the half-edges h(2k), which runs from the first of its ends, and h(2k + 1). Written independently
//! of the drivers: an edge knows its ends and its two faces, and the links follow from these.

use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// An edge: from, to, the face on its left, the face on its right.
type Edge = [usize; 4];

/// A convex polygon: its corners lie on the parabola y = x².
#[must_use]
pub fn convex(corners: usize) -> Table {
    let edges: Vec<Edge> = (0..corners).map(|k| [k, (k + 1) % corners, 1, 0]).collect();
    let places = (0..corners).map(on_parabola).collect();
    structure(places, &edges, |v| 2 * v, |f| 1 - f)
}

/// Triangles round v0; v1, v2, … are the corners of a convex polygon.
#[must_use]
pub fn wheel(spokes: usize) -> Table {
    let n = spokes;
    let end = (n.max(1) - 1) as f64;
    let mut places = vec![[end / 2.0, (end / 2.0 * (end / 2.0) + end / 2.0 * end) / 2.0]];
    places.extend((0..n).map(on_parabola));
    let edges: Vec<Edge> = (0..n)
        .flat_map(|k| [[0, k + 1, k + 1, if k == 0 { n } else { k }], [k + 1, (k + 1) % n + 1, k + 1, 0]])
        .collect();
    structure(places, &edges, |v| if v == 0 { 0 } else { 4 * v - 2 }, |f| if f == 0 { 3 } else { 4 * f - 4 })
}

/// Square cells. A grid of one size is made once.
#[must_use]
pub fn grid(columns: usize, rows: usize) -> Arc<Table> {
    type Made = BTreeMap<[usize; 2], Arc<Table>>;
    static MADE: OnceLock<Mutex<Made>> = OnceLock::new();
    let mut made = MADE.get_or_init(Mutex::default).lock().unwrap_or_else(PoisonError::into_inner);
    Arc::clone(made.entry([columns, rows]).or_insert_with(|| Arc::new(new_grid(columns, rows))))
}

fn new_grid(n: usize, m: usize) -> Table {
    let places = (0..=m).flat_map(|y| (0..=n).map(move |x| [x as f64, y as f64])).collect();
    let vertex = |x: usize, y: usize| y * (n + 1) + x;
    let cell = |x: usize, y: usize| if x < n && y < m { 1 + y * n + x } else { 0 };
    let mut edges: Vec<Edge> = Vec::with_capacity(n * (m + 1) + m * (n + 1));
    for y in 0..=m {
        let below = y.wrapping_sub(1);
        edges.extend((0..n).map(|x| [vertex(x, y), vertex(x + 1, y), cell(x, y), cell(x, below)]));
    }
    for y in 0..m {
        edges.extend((0..=n).map(|x| [vertex(x, y), vertex(x, y + 1), cell(x.wrapping_sub(1), y), cell(x, y)]));
    }
    let up = |x: usize, y: usize| 2 * (n * (m + 1) + y * (n + 1) + x);
    let outgoing = |v: usize| match (v % (n + 1), v / (n + 1)) {
        (x, y) if x < n => 2 * (y * n + x),
        (x, y) if y < m => up(x, y),
        (x, y) => up(x, y - 1) + 1,
    };
    let boundary = |f: usize| if f == 0 { up(0, 0) } else { 2 * (f - 1) };
    structure(places, &edges, outgoing, boundary)
}

/// Cells that lean to the right, each cut along its short diagonal: all triangles are alike and acute, so they are those
/// of Delaunay. Edges to the right come first, then those upwards, then the diagonals, which run up to the left.
#[must_use]
pub fn lattice(n: usize, m: usize) -> Table {
    let places = (0..=m).flat_map(|y| (0..=n).map(move |x| [x as f64 + y as f64 / 2.0, y as f64])).collect();
    let vertex = |x: usize, y: usize| y * (n + 1) + x;
    // The lower and the upper triangle of a cell; outside of all cells the outer face.
    let face = |x: usize, y: usize, upper: usize| if x < n && y < m { 1 + upper + 2 * (y * n + x) } else { 0 };
    let before = |x: usize| x.wrapping_sub(1);
    let rows = |last: usize, most: usize| (0..last).flat_map(move |y| (0..most).map(move |x| (x, y)));
    let right = rows(m + 1, n).map(|(x, y)| [vertex(x, y), vertex(x + 1, y), face(x, y, 0), face(x, before(y), 1)]);
    let up = rows(m, n + 1).map(|(x, y)| [vertex(x, y), vertex(x, y + 1), face(before(x), y, 1), face(x, y, 0)]);
    let across = rows(m, n).map(|(x, y)| [vertex(x + 1, y), vertex(x, y + 1), face(x, y, 0), face(x, y, 1)]);
    let edges: Vec<Edge> = right.chain(up).chain(across).collect();
    let first_up = n * (m + 1);
    let first_across = first_up + (n + 1) * m;
    // The edge to the right if there is one, else the edge upwards, else that which comes from below.
    let outgoing = |v: usize| match (v % (n + 1), v / (n + 1)) {
        (x, y) if x < n => 2 * (y * n + x),
        (x, y) if y < m => 2 * (first_up + y * (n + 1) + x),
        (x, y) => 2 * (first_up + (y - 1) * (n + 1) + x) + 1,
    };
    let boundary = |f: usize| match f.checked_sub(1) {
        None => 2 * first_up,
        Some(f) => 2 * (first_across + f / 2) + f % 2,
    };
    structure(places, &edges, outgoing, boundary)
}

fn on_parabola(k: usize) -> [f64; 2] {
    [k as f64, (k * k) as f64]
}

/// The structure of these edges, in which no face comes to a vertex twice.
fn structure(
    places: Vec<[f64; 2]>,
    edges: &[Edge],
    outgoing: impl Fn(usize) -> usize,
    boundary: impl Fn(usize) -> usize,
) -> Table {
    let half_edge = |h: usize| HalfEdgeId::new(h as u32);
    let mut starting: Vec<Vec<(usize, usize)>> = vec![Vec::new(); places.len()];
    for (k, &[from, to, left, right]) in edges.iter().enumerate() {
        starting[from].push((left, 2 * k));
        starting[to].push((right, 2 * k + 1));
    }
    let mut half_edges = vec![HalfEdgeRow::default(); 2 * edges.len()];
    let mut faces = 1;
    for (k, &[from, to, left, right]) in edges.iter().enumerate() {
        faces = faces.max(left + 1).max(right + 1);
        for (h, twin, from, to, face) in [(2 * k, 2 * k + 1, from, to, left), (2 * k + 1, 2 * k, to, from, right)] {
            // It is followed by the half-edge of its face that starts where it ends.
            let next = starting[to].iter().find(|&&(other, _)| other == face).map_or(h, |&(_, next)| next);
            half_edges[next].prev = Some(half_edge(h));
            let row = &mut half_edges[h];
            row.origin = Some(VertexId::new(from as u32));
            row.face = Some(FaceId::new(face as u32));
            row.twin = Some(half_edge(twin));
            row.next = Some(half_edge(next));
        }
    }
    let vertex = |(v, place)| Some(VertexRow { position: Some(place), outgoing: Some(half_edge(outgoing(v))) });
    let face = |f| Some(FaceRow { half_edge: Some(half_edge(boundary(f))), ..FaceRow::default() });
    Table {
        outer_face: Some(FaceId::new(0)),
        vertices: places.into_iter().enumerate().map(vertex).collect(),
        half_edges: half_edges.into_iter().map(Some).collect(),
        faces: (0..faces).map(face).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::violations;

    #[test]
    fn large_structures_obey_the_laws_and_have_the_sizes_that_they_say() {
        let sizes = |table: &Table| [table.vertices.len(), table.half_edges.len(), table.faces.len()];
        assert_eq!(sizes(&convex(300)), [300, 600, 2]);
        assert_eq!(sizes(&wheel(40)), [41, 160, 41]);
        assert_eq!(sizes(&grid(20, 15)), [336, 1270, 301]);
        assert_eq!(sizes(&lattice(20, 15)), [336, 1870, 601]);
        let all = [convex(3), convex(300), wheel(3), wheel(40), grid(1, 1).as_ref().clone(), new_grid(20, 15)];
        for table in all.into_iter().chain([lattice(1, 1), lattice(20, 15)]) {
            assert_eq!(violations(&table), []);
        }
    }
}
