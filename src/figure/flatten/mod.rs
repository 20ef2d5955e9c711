//! Structures without coordinates on paper.
//!
//! ```text
//!   genus 0:  one face is the outside, the rest lies in a circle        genus > 0:  cut open until one disc is left
//!
//!            ●───────●                                                      v0 ──a──▸ v0
//!           ╱ ╲     ╱ ╲      each vertex in the middle                       │         │     sides with the same
//!          ●   ●───●   ●     of its neighbours (Tutte)                       b         b     letter are one edge
//!           ╲ ╱     ╲ ╱                                                      ▾         ▾
//!            ●───────●                                                      v0 ──a──▸ v0
//! ```
//!
//! **Cut.** The faces of a component hang together by a spanning tree of the dual graph; the edges across which no two
//! faces hang together are cut, and what dangles of the cut is sewn up again. What is left of genus g > 0 is a disc whose
//! sides are the cut edges, each twice; with genus 0 nothing is left of the cut. Edges that were cut in the last state
//! are cut first.
//!
//! **Bends.** A loop, and each edge that runs beside another one, gets two bends, so that straight pieces do.
//!
//! **Places.** Each face gets a ring of helping points, one a corner, and one in their middle, all joined: so the disc is
//! cut into triangles, no two of which have the same corners, however often a face meets a vertex. Its border stands on a
//! circle, all else in the middle of what it is joined to. Then no two corners coincide and no two edges cross (Tutte
//! 1963; for triangles Floater 2003). The next state begins with the places of the last one, its new corners in the
//! middle of their neighbours. It goes towards the places found anew only as far as it must: by 0, 1, 2 or 3 quarters of
//! the way while that leaves faces the right way round and vertices clear of edges, else all of it.
//!
//! ```text
//!   cut.rs   which edges are cut, corners, bends       disc.rs   triangles, circle, middle places
//!   plate.rs a table that can be drawn                 clear.rs  is a drawing sound, and how clear
//! ```

mod clear;
mod cut;
mod disc;
mod plate;

pub(in crate::figure) use cut::Spread;
pub(in crate::figure) use plate::{Names, Placed, set_positions};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::{HalfEdgeId, VertexId};
    use crate::plane::Point;
    use crate::plane::predicates::orientation;
    use crate::topology::{Dcel, Table, View, measure};
    use std::collections::BTreeMap;

    fn next(state: &mut u64, below: usize) -> usize {
        *state ^= *state << 13;
        *state ^= *state >> 7;
        *state ^= *state << 17;
        (*state % below.max(1) as u64) as usize
    }

    /// An edit somewhere; most of the time a split.
    fn edit(dcel: &mut Dcel, seed: &mut u64) {
        let all: Vec<HalfEdgeId> = dcel.half_edges().collect();
        let a = all[next(seed, all.len())];
        let face: Vec<HalfEdgeId> = dcel.cycle(a).collect();
        let star: Vec<HalfEdgeId> = dcel.star(a).collect();
        let (b, c) = (face[next(seed, face.len())], star[next(seed, star.len())]);
        match next(seed, 9) {
            0 | 1 => drop(dcel.split_face(a, b)),
            2 | 3 => drop(dcel.split_vertex(a, c)),
            4 => drop(dcel.split_edge(a)),
            5 => drop(dcel.flip_edge(a)),
            6 => drop(dcel.join_faces(a)),
            7 => drop(dcel.join_vertices(a)),
            _ => drop(dcel.join_edges(a)),
        }
    }

    /// The drawing as exact predicates see it: every half-edge runs from its own place to that of the next one, edges meet
    /// at common ends alone, and each face has its inside on the left.
    fn check(dcel: &Dcel, placed: &Placed, what: &str) {
        let table = &placed.table;
        let at = |v: VertexId| table.vertices[v.index()].and_then(|row| row.position).map(Point::from).unwrap();
        let all: Vec<HalfEdgeId> = (0..table.half_edges.len() as u32).map(HalfEdgeId::new).collect();
        let live = || all.iter().copied().filter(|&h| table.has_half_edge(h));
        let end = |h: HalfEdgeId| table.origin(table.next(h).unwrap()).unwrap();
        let ends: Vec<[VertexId; 2]> = live().map(|h| [table.origin(h).unwrap(), end(h)]).collect();
        for (i, &[a, b]) in ends.iter().enumerate() {
            assert_ne!(at(a), at(b), "{what}: an edge without length");
            for &[c, d] in &ends[..i] {
                let [p, q, r, s] = [a, b, c, d].map(at);
                let shared = [a, b].iter().filter(|v| [c, d].contains(v)).count();
                let across = |p, q, r, s| orientation(p, q, r) != orientation(p, q, s);
                let crossed = across(p, q, r, s) && across(r, s, p, q);
                assert!(shared > 0 || !crossed, "{what}: {a}{b} crosses {c}{d}");
                assert!(shared < 2 || [a, b] == [d, c], "{what}: {a}{b} and {c}{d} lie on each other");
            }
        }
        for f in dcel.faces().filter(|&f| table.has_face(f) && table.outer_face != Some(f)) {
            let Some(first) = dcel.half_edge(f) else { continue };
            let mut area = 0.0;
            let mut h = first;
            loop {
                let (p, q) = (at(table.origin(h).unwrap()), at(end(h)));
                area += p.x * q.y - q.x * p.y;
                h = table.next(h).unwrap();
                if h == first {
                    break;
                }
            }
            assert!(area > 0.0, "{what}: {f} is inside out");
        }
        let mut sides: BTreeMap<usize, Vec<HalfEdgeId>> = BTreeMap::new();
        placed.sides.iter().for_each(|&(h, letter)| sides.entry(letter).or_default().push(h));
        assert!(sides.values().all(|pair| pair.len() == 2 && pair[0].twin() == pair[1]), "{what}: sides in pairs");
        let genus = measure(dcel).genus() as usize;
        assert!(
            placed.sides.len() >= 4 * genus && (genus > 0 || placed.sides.is_empty()),
            "{what}: {:?}",
            placed.sides
        );
    }

    #[test]
    fn scripts_of_random_edits_are_laid_out_without_crossings() {
        for (number, start) in
            [Dcel::polygon(1), Dcel::polygon(2), Dcel::polygon(6), Ok(Dcel::torus())].into_iter().enumerate()
        {
            for round in 1..=6_u64 {
                let mut seed = round * 7919 + number as u64;
                let mut dcel = start.clone().unwrap();
                let mut before: Option<Spread> = None;
                for step in 0..14 {
                    // In every other round some vertices have more room than others.
                    let room = |i: usize| if round % 2 == 0 { [1.0, 0.5, 0.25, 0.15][(i + step) % 4] } else { 1.0 };
                    let rooms: Vec<f64> = (0..dcel.vertex_bound()).map(room).collect();
                    let spread = Spread::with_room(&dcel, before.as_ref(), &rooms.into());
                    let table = Table::from_view(&dcel);
                    let what = format!("start {number}, round {round}, step {step}");
                    check(&dcel, &Placed::new(&table, &spread, &mut Names::beyond([&table])), &what);
                    before = Some(spread);
                    edit(&mut dcel, &mut seed);
                }
            }
        }
    }

    #[test]
    fn a_ring_is_a_regular_polygon_and_a_split_of_its_face_moves_nothing() {
        let mut ring = Dcel::polygon(6).unwrap();
        let first = Spread::new(&ring, None);
        let sides: Vec<f64> = (0..6)
            .map(|i| {
                let [p, q] = [first.at[i], first.at[(i + 1) % 6]];
                ((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])).sqrt()
            })
            .collect();
        assert!(sides.iter().all(|side| (side - 100.0).abs() < 1e-9), "{sides:?}");
        ring.split_face(HalfEdgeId::new(2), HalfEdgeId::new(8)).unwrap();
        let second = Spread::new(&ring, Some(&first));
        let place = |spread: &Spread, v| spread.vertex.iter().position(|&w| w == v).map(|i| spread.at[i]);
        assert!(ring.vertices().all(|v| place(&first, v) == place(&second, v)));
    }

    #[test]
    fn the_sides_of_a_ring_are_as_long_as_the_room_of_their_ends() {
        let ring = Dcel::polygon(40).unwrap();
        let rooms: Vec<f64> = (0..40).map(|i| if (10..13).contains(&i) { 1.0 } else { 0.15 }).collect();
        let spread = Spread::with_room(&ring, None, &rooms.into());
        let place = |i: usize| spread.at[spread.vertex.iter().position(|v| v.index() == i % 40).unwrap()];
        let long = |i: usize| {
            let [p, q] = [place(i), place(i + 1)];
            ((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])).sqrt()
        };
        assert!(spread.at.iter().all(|[x, y]| (x * x + y * y - 1e4).abs() < 1e-6), "on the circle");
        assert!((long(10) - long(11)).abs() < 1e-9 && long(10) > 10.0 * long(20), "{} {}", long(10), long(20));
        assert!(long(9) < long(10) && long(9) > 2.0 * long(20), "{} {} {}", long(9), long(10), long(20));
    }

    #[test]
    fn the_torus_is_a_square_with_level_sides() {
        let square = Spread::new(&Dcel::torus(), None);
        let sides: Vec<u32> = square.sides.iter().map(|h| h.number()).collect();
        assert_eq!(sides, [0, 2, 1, 3], "h0 to the right, h2 up, h1 back, h3 down");
        let half = 100.0 * 0.5_f64.sqrt();
        for (h, corner) in square.sides.iter().zip([[-half, -half], [half, -half], [half, half], [-half, half]]) {
            let at = square.at[square.node[*h] as usize];
            assert!((0..2).all(|i| (at[i] - corner[i]).abs() < 1e-9), "{h}: {at:?}");
        }
    }
}
