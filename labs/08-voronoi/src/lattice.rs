//! A large triangulation, made of two numbers.
//!
//! ```text
//!      ●───────●───────●        cells that lean to the right, each cut along its short diagonal; numbers row by row
//!     ╱ ╲     ╱ ╲     ╱         from below: first the edges to the right, then those upwards, then the diagonals,
//!    ╱   ╲   ╱   ╲   ╱          which run up to the left
//!   ●───────●───────●
//! ```

use crate::dcel::{Dcel, FaceId, HalfEdgeId};
use crate::harness::whole;

/// At most so many cells, so that a slip of the hand does not fill the memory.
const MOST: usize = 1_000_000;

/// `lattice N M`: N cells in each of M rows.
pub fn lattice(words: &[&str]) -> Result<Dcel, String> {
    let &[n, m] = words else { return Err("it takes two numbers".to_owned()) };
    let (n, m) = (whole(n)?, whole(m)?);
    if n == 0 || m == 0 || n.saturating_mul(m) > MOST {
        return Err(format!("there are 1 to {MOST} cells"));
    }
    let mut dcel = Dcel::default();
    dcel.outer_face = dcel.new_face();
    for (x, y) in cells(n + 1, m + 1) {
        dcel.new_vertex(x as f64 + y as f64 / 2.0, y as f64);
    }
    let vertex = |x, y| y * (n + 1) + x;
    cells(n, m + 1).for_each(|(x, y)| new_edge(&mut dcel, vertex(x, y), vertex(x + 1, y)));
    cells(n + 1, m).for_each(|(x, y)| new_edge(&mut dcel, vertex(x, y), vertex(x, y + 1)));
    cells(n, m).for_each(|(x, y)| new_edge(&mut dcel, vertex(x + 1, y), vertex(x, y + 1)));
    let right = |x, y| 2 * (y * n + x);
    let up = |x, y| 2 * (n * (m + 1) + y * (n + 1) + x);
    let across = |x, y| 2 * (n * (m + 1) + (n + 1) * m + y * n + x);

    for (x, y) in cells(n, m) {
        let [lower, upper] = [dcel.new_face(), dcel.new_face()];
        close(&mut dcel, &[across(x, y), up(x, y) + 1, right(x, y)], lower);
        close(&mut dcel, &[across(x, y) + 1, up(x + 1, y), right(x, y + 1) + 1], upper);
    }
    // Round the outside: up on the left, to the right above, down, and back.
    let mut border: Vec<HalfEdgeId> = (0..m).map(|y| up(0, y)).collect();
    border.extend((0..n).map(|x| right(x, m)));
    border.extend((0..m).rev().map(|y| up(n, y) + 1));
    border.extend((0..n).rev().map(|x| right(x, 0) + 1));
    let outside = dcel.outer_face;
    close(&mut dcel, &border, outside);

    for (x, y) in cells(n + 1, m + 1) {
        let outgoing = match (x, y) {
            _ if x < n => right(x, y),
            _ if y < m => up(x, y),
            _ => up(x, y - 1) + 1,
        };
        dcel.vertices[vertex(x, y)].outgoing_half_edge = Some(outgoing);
    }
    Ok(dcel)
}

/// The places of so many columns and rows, row by row.
fn cells(columns: usize, rows: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..rows).flat_map(move |y| (0..columns).map(move |x| (x, y)))
}

/// Two half-edges; the first one runs from `from` to `to`.
fn new_edge(dcel: &mut Dcel, from: usize, to: usize) {
    let [h, twin] = [dcel.new_half_edge(from), dcel.new_half_edge(to)];
    dcel.half_edges[h].twin = Some(twin);
    dcel.half_edges[twin].twin = Some(h);
}

/// Links the half-edges round a face, the first of which it refers to.
fn close(dcel: &mut Dcel, around: &[HalfEdgeId], face: FaceId) {
    for (i, &h) in around.iter().enumerate() {
        dcel.make_next(h, around[(i + 1) % around.len()]);
        dcel.half_edges[h].face = Some(face);
    }
    dcel.faces[face].incident_half_edge = around.first().copied();
}
