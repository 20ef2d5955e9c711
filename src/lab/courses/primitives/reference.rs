//! The two primitives on tables, and what is made of them. The tests compare them with the kernel and with the shapes
//! that the kit grows.

use crate::cases::cycles::{link, row_mut};
use dcel_kit::topology::{Dcel, FaceRow, HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

/// The half-edges round the face of `first`, from it on; `None` if they do not come back.
pub(super) fn round(table: &Table, first: HalfEdgeId) -> Option<Vec<HalfEdgeId>> {
    let mut all = vec![first];
    loop {
        let h = table.next(*all.last()?)?;
        if h == first {
            return Some(all);
        }
        if all.len() > table.half_edges.len() {
            return None;
        }
        all.push(h);
    }
}

/// The half-edge that starts where `h` starts, next to it counter-clockwise.
pub(super) fn turned(table: &Table, h: HalfEdgeId) -> Option<HalfEdgeId> {
    table.twin(table.prev(h)?)
}

fn edit(table: &mut Table, h: HalfEdgeId, change: impl FnOnce(&mut HalfEdgeRow)) {
    if let Some(row) = row_mut(table, h) {
        change(row);
    }
}

fn chain(table: &mut Table, all: &[HalfEdgeId]) {
    for pair in all.windows(2) {
        link(table, pair[0], pair[1]);
    }
}

/// Two new half-edges, twins, with their origins and faces.
fn pair(table: &mut Table, ends: [VertexId; 2], faces: [FaceId; 2]) -> [HalfEdgeId; 2] {
    let first = table.half_edges.len() as u32;
    let new = [HalfEdgeId::new(first), HalfEdgeId::new(first + 1)];
    for side in 0..2 {
        table.half_edges.push(Some(HalfEdgeRow {
            origin: Some(ends[side]),
            face: Some(faces[side]),
            twin: Some(new[1 - side]),
            next: None,
            prev: None,
        }));
    }
    new
}

/// Moves the half-edges from `first` on, up to but without `last`, to a new vertex.
pub(super) fn split_vertex(table: &mut Table, first: HalfEdgeId, last: HalfEdgeId) -> Option<HalfEdgeId> {
    let stays = table.origin(last)?;
    let fresh = VertexId::new(table.vertices.len() as u32);
    let mut fan = Vec::new();
    let mut h = first;
    while h != last {
        fan.push(h);
        h = turned(table, h)?;
        if fan.len() > table.half_edges.len() {
            return None;
        }
    }
    let [in_first, in_last] = [table.twin(first)?, table.twin(last)?];
    let [out_first, out_last] = [table.next(in_first)?, table.next(in_last)?];
    let [out, back] = pair(table, [stays, fresh], [table.face(in_last)?, table.face(in_first)?]);
    table.vertices.push(Some(VertexRow { position: Some([0.0; 2]), outgoing: Some(back) }));
    if fan.is_empty() {
        chain(table, &[in_first, out, back, out_first]);
    } else {
        chain(table, &[in_first, back, out_first]);
        chain(table, &[in_last, out, out_last]);
    }
    for h in fan {
        edit(table, h, |row| row.origin = Some(fresh));
    }
    if let Some(Some(row)) = table.vertices.get_mut(stays.index()) {
        row.outgoing = Some(out);
    }
    Some(out)
}

/// Splits the face of both: the new face is on the left of the half-edge that is returned.
pub(super) fn split_face(table: &mut Table, h1: HalfEdgeId, h2: HalfEdgeId) -> Option<HalfEdgeId> {
    let (kept, fresh) = (table.face(h1)?, FaceId::new(table.faces.len() as u32));
    let [in1, in2] = [table.prev(h1)?, table.prev(h2)?];
    let [there, back] = pair(table, [table.origin(h1)?, table.origin(h2)?], [fresh, kept]);
    chain(table, &[in1, there, h2]);
    chain(table, &[in2, back, h1]);
    for h in round(table, there)? {
        edit(table, h, |row| row.face = Some(fresh));
    }
    table.faces.push(Some(FaceRow { half_edge: Some(there), ..FaceRow::default() }));
    if let Some(Some(row)) = table.faces.get_mut(kept.index()) {
        row.half_edge = Some(back);
    }
    Some(there)
}

/// A vertex in the face of `h`, with a spoke to each corner.
pub(super) fn pole(table: &mut Table, h: HalfEdgeId) -> Option<()> {
    let corners = round(table, h)?;
    let foot = turned(table, h)?;
    let mut back = split_vertex(table, foot, foot).and_then(|out| table.twin(out))?;
    for &corner in &corners[1..] {
        back = split_face(table, corner, back).and_then(|spoke| table.twin(spoke))?;
    }
    Some(())
}

/// Cuts the edge of `h` in pieces: at its origin, or from its other end if that is the tip of a spur, where a split makes
/// another spur.
pub(super) fn divide(table: &mut Table, h: HalfEdgeId, pieces: usize) -> Option<()> {
    let side = if turned(table, h)? == h { table.twin(h)? } else { h };
    for _ in 1..pieces {
        let after = turned(table, side)?;
        split_vertex(table, side, after)?;
    }
    Some(())
}

/// Cuts a face of 2(n + m) sides in n times m quads: row by row, from the bottom.
pub(super) fn fill(table: &mut Table, h: HalfEdgeId, n: usize, m: usize) -> Option<()> {
    let sides = round(table, h)?;
    if sides.len() != 2 * (n + m) {
        return None;
    }
    // From a corner on the right to the one across, so that the new face lies below; then columns, in each row.
    let mut starts = vec![h];
    for j in 1..m {
        let across = split_face(table, sides[n + j], sides[2 * (n + m) - j])?;
        let above = table.twin(across)?;
        divide(table, above, n)?;
        let mut first = above;
        for _ in 1..n {
            first = table.prev(first)?;
        }
        starts.push(first);
    }
    for start in starts {
        let row = round(table, start)?;
        for i in 1..n {
            split_face(table, row[i], row[2 * n + 1 - i])?;
        }
    }
    Some(())
}

/// Puts a wall under each side of the face of `h`. Returns the half-edge above `h`.
pub(super) fn extrude(table: &mut Table, h: HalfEdgeId) -> Option<HalfEdgeId> {
    let corners = round(table, h)?;
    let mut tips = Vec::new();
    for &corner in &corners {
        let foot = turned(table, corner)?;
        tips.push(split_vertex(table, foot, foot).and_then(|out| table.twin(out))?);
    }
    let mut top = None;
    for i in 0..tips.len() {
        let end = tips.get(i + 1).copied().or(top)?;
        let wall = split_face(table, end, tips[i])?;
        top = top.or(table.twin(wall));
    }
    top
}

/// Both sides of a polygon.
pub(super) fn ring(sides: usize) -> Option<Table> {
    Some(Table::from_view(&Dcel::polygon(sides).ok()?))
}

/// Both sides of a square, each cut in n times m.
pub(super) fn grid(n: usize, m: usize) -> Option<Table> {
    let mut table = ring(2 * (n + m))?;
    fill(&mut table, HalfEdgeId::new(0), n, m)?;
    fill(&mut table, HalfEdgeId::new(2 * n as u32 - 1), n, m)?;
    Some(table)
}

/// The seed of the torus, its two edges cut; and the first piece of the first.
pub(super) fn torus_to_fill(n: usize, m: usize) -> Option<(Table, HalfEdgeId)> {
    let mut table = Table::from_view(&Dcel::torus());
    let mut first = HalfEdgeId::new(0);
    divide(&mut table, first, n)?;
    divide(&mut table, HalfEdgeId::new(2), m)?;
    for _ in 1..n {
        first = table.prev(first)?;
    }
    Some((table, first))
}

/// A torus of n times m quads.
pub(super) fn torus(n: usize, m: usize) -> Option<Table> {
    let (mut table, first) = torus_to_fill(n, m)?;
    fill(&mut table, first, n, m)?;
    Some(table)
}

/// A ring, extruded; with a vertex instead of a face on top, or at the bottom.
pub(super) fn tube(sides: usize, walls: usize, [top, bottom]: [bool; 2]) -> Option<Table> {
    let mut table = ring(sides)?;
    let mut above = HalfEdgeId::new(0);
    for _ in 0..walls {
        above = extrude(&mut table, above)?;
    }
    if top {
        pole(&mut table, above)?;
    }
    if bottom {
        pole(&mut table, HalfEdgeId::new(1))?;
    }
    Some(table)
}

/// A cube with faces of so many times so many squares.
pub(super) fn cube(steps: usize) -> Option<Table> {
    let mut table = tube(4, 1, [false; 2])?;
    let edges = (0..table.half_edges.len() as u32).step_by(2).map(HalfEdgeId::new);
    for h in edges {
        divide(&mut table, h, steps)?;
    }
    let corners = 8;
    for f in 0..6 {
        let all = round(&table, table.half_edge(FaceId::new(f))?)?;
        let first = all.into_iter().find(|&h| table.origin(h).is_some_and(|v| v.index() < corners))?;
        fill(&mut table, first, steps, steps)?;
    }
    Some(table)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::{isomorphic, measure};

    fn h(number: u32) -> HalfEdgeId {
        HalfEdgeId::new(number)
    }

    #[test]
    fn the_primitives_are_those_of_the_kernel() {
        let seeds = [Dcel::polygon(4).unwrap(), Dcel::polygon(5).unwrap(), Dcel::torus()];
        for mut dcel in seeds {
            let mut table = Table::from_view(&dcel);
            for (first, count) in [(0, 1), (2, 0), (0, 2), (1, 1), (4, 0)] {
                let mut last = h(first);
                (0..count).for_each(|_| last = dcel.ccw(last));
                dcel.split_vertex(h(first), last).unwrap();
                split_vertex(&mut table, h(first), last).unwrap();
                assert!(isomorphic(&table, &dcel).is_ok());
            }
            let round: Vec<HalfEdgeId> = dcel.cycle(h(0)).collect();
            dcel.split_face(round[0], round[2]).unwrap();
            split_face(&mut table, round[0], round[2]).unwrap();
            isomorphic(&table, &dcel).unwrap();
        }
    }

    /// V, E, F and the number of vertices of degree 3, by the formulas of the shapes.
    #[test]
    fn the_surfaces_have_as_many_elements_as_the_formulas_say() {
        let counts = |table: &Table| {
            let counts = measure(table);
            assert!(dcel_kit::topology::first_violation(table).is_none());
            [counts.vertices, counts.edges, counts.faces, counts.genus() as usize]
        };
        for (n, m) in [(3, 2), (4, 1), (3, 5), (5, 5)] {
            assert_eq!(counts(&grid(n, m).unwrap()), [2 * n * m + 2, 4 * n * m, 2 * n * m, 0]);
            assert_eq!(counts(&torus(n, m).unwrap()), [n * m, 2 * n * m, n * m, 1]);
            assert_eq!(counts(&tube(n, m, [false; 2]).unwrap()), [n * (m + 1), n * (2 * m + 1), n * m + 2, 0]);
            assert_eq!(counts(&tube(n, m - 1, [true, false]).unwrap()), [n * m + 1, 2 * n * m, n * m + 1, 0]);
            let bands = m + 1;
            assert_eq!(
                counts(&tube(n, bands - 2, [true; 2]).unwrap()),
                [n * (bands - 1) + 2, n * (2 * bands - 1), n * bands, 0]
            );
            assert_eq!(counts(&cube(n).unwrap()), [6 * n * n + 2, 12 * n * n, 6 * n * n, 0]);
        }
    }

    /// Every face of a filled torus has four sides, and every vertex four edges: with the genus that says what it is,
    /// up to how it is wound; the walk straight ahead says that.
    #[test]
    fn straight_ahead_the_torus_comes_back_after_n_and_after_m_steps() {
        for (n, m) in [(3, 4), (5, 3)] {
            let table = torus(n, m).unwrap();
            let ahead = |h: HalfEdgeId| table.next(table.twin(table.next(h)?)?);
            let steps = |first: HalfEdgeId| {
                let mut h = ahead(first).unwrap();
                let mut count = 1;
                while h != first {
                    h = ahead(h).unwrap();
                    count += 1;
                }
                count
            };
            assert_eq!([steps(h(0)), steps(h(2))], [n, m]);
        }
    }
}
