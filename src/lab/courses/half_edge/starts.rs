//! The structures that cases begin with, beside the rectangle and the polygons.
//!
//! ```text
//!   ┌────────┐      ●     ●        antenna: a dangling edge; a face passes v0 twice
//!   │   /v4  │      │╲   ╱│        bow-tie: the outer face passes v0 twice
//!   v0───────┘      │ v0  │        Only a half-edge names a corner there, a vertex does not.
//!                   ●╱   ╲●
//!   ●              ●
//!   │╲            ╱│               bridge: one face has both sides of an edge
//!   │ v0────────v3 │
//!   ●╱            ╲●               tree: v0──v1──v2, with no face but the outer one
//! ```

use super::spec;
use crate::cases::cycles::from_cycles;
use crate::cases::numbers::{renumbered, store_any};
use crate::cases::random::Random;
use crate::cases::starts::polygon;
use crate::checks::walks::half_edges;
use crate::protocol::Start;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId};

/// A square with an edge from one corner into it that ends nowhere.
pub(super) fn antenna() -> Table {
    let points = [[0.0, 0.0], [8.0, 0.0], [8.0, 7.0], [0.0, 7.0], [3.5, 2.5]];
    from_cycles(&points, &[&[0, 3, 2, 1], &[0, 1, 2, 3, 0, 4]])
}

/// Two triangles that share a vertex.
pub(super) fn bow_tie() -> Table {
    let points = [[0.0, 0.0], [6.0, -4.0], [6.0, 5.0], [-6.0, 4.0], [-6.0, -5.0]];
    from_cycles(&points, &[&[0, 2, 1, 0, 4, 3], &[0, 1, 2], &[0, 3, 4]])
}

/// The smallest structures with dangling edges: a single edge, a path of two, a triangle with an edge inside or outside.
pub(super) fn dangling() -> [Table; 4] {
    let points = [[0.0, 0.0], [9.0, 0.0], [4.0, 8.0], [4.0, 3.0], [13.0, 5.0]];
    [
        from_cycles(&points[..2], &[&[0, 1]]),
        from_cycles(&points[..3], &[&[0, 1, 2, 1]]),
        from_cycles(&points[..4], &[&[0, 2, 1], &[0, 1, 2, 0, 3]]),
        from_cycles(&[points[0], points[1], points[2], points[4]], &[&[0, 2, 1, 3, 1], &[0, 1, 2]]),
    ]
}

/// A bow-tie inside a square: two triangles hang at one corner of it, so a bounded face passes that corner twice.
pub(super) fn hanging_triangle() -> Table {
    let points = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0], [6.0, 2.0], [2.0, 6.0]];
    from_cycles(&points, &[&[0, 3, 2, 1], &[0, 1, 2, 3, 0, 5, 4], &[0, 4, 5]])
}

/// A triangle with an edge that dangles into the outer face.
pub(super) fn outer_antenna() -> Table {
    let points = [[0.0, 0.0], [8.0, 1.0], [3.0, 7.0], [12.0, 5.0]];
    from_cycles(&points, &[&[0, 2, 1, 3, 1], &[0, 1, 2]])
}

/// Two triangles that are joined by an edge.
pub(super) fn bridge() -> Table {
    let points = [[0.0, 0.0], [-5.0, 4.0], [-5.5, -3.0], [6.0, 1.0], [11.0, -3.5], [11.0, 5.0]];
    from_cycles(&points, &[&[0, 3, 5, 4, 3, 0, 2, 1], &[0, 1, 2], &[3, 4, 5]])
}

/// A square with a triangle inside that an edge joins to a corner: a bridge inside a bounded face.
pub(super) fn inner_bridge() -> Table {
    let points = [[0.0, 0.0], [20.0, 0.0], [20.0, 18.0], [0.0, 18.0], [5.0, 4.0], [13.0, 5.0], [7.0, 11.0]];
    from_cycles(&points, &[&[0, 3, 2, 1], &[0, 1, 2, 3, 0, 4, 6, 5, 4], &[4, 5, 6]])
}

/// Three vertices on a path: no face but the outer one, and both ends dangle.
pub(super) fn tree() -> Table {
    from_cycles(&[[0.0, 0.0], [5.0, 1.0], [9.0, 6.0]], &[&[0, 1, 2, 1]])
}

/// A single edge: both of its ends dangle.
pub(super) fn single_edge() -> Table {
    from_cycles(&[[1.0, 2.0], [6.0, 4.5]], &[&[0, 1]])
}

/// Four triangles that share a vertex: the outer face comes to it four times.
pub(super) fn petals() -> Table {
    let points = [
        [0.0, 0.0],
        [6.0, -2.0],
        [6.0, 2.0],
        [2.0, 7.0],
        [-2.0, 6.0],
        [-6.0, 3.0],
        [-7.0, -2.0],
        [-2.0, -6.0],
        [3.0, -7.0],
    ];
    let outer = [0, 2, 1, 0, 8, 7, 0, 6, 5, 0, 4, 3];
    from_cycles(&points, &[&outer, &[0, 1, 2], &[0, 3, 4], &[0, 5, 6], &[0, 7, 8]])
}

/// An antenna whose two corners at one vertex are joined: an edge from a vertex to itself.
pub(super) fn looped() -> Table {
    let table = antenna();
    let all = || half_edges(&table);
    let mut pairs = all().flat_map(|h1| all().map(move |h2| (h1, h2)));
    let split = pairs.find_map(|(h1, h2)| {
        let at_one_vertex = table.origin(h1) == table.origin(h2);
        spec::split_face(&table, h1, h2).filter(|_| at_one_vertex)
    });
    split.map_or_else(Table::default, |(table, _)| table)
}

/// All odd structures, with their names: dangling edges at either end and on either side, bridges, corners that touch,
/// a loop.
pub(super) fn odd() -> [(&'static str, Table); 10] {
    [
        ("antenna", antenna()),
        ("outer_antenna", outer_antenna()),
        ("bow_tie", bow_tie()),
        ("hanging", hanging_triangle()),
        ("petals", petals()),
        ("bridge", bridge()),
        ("inner_bridge", inner_bridge()),
        ("tree", tree()),
        ("single_edge", single_edge()),
        ("looped", looped()),
    ]
}

/// The six-vertex rectangle of the handout.
pub(super) fn rectangle() -> Start {
    Start::line("rectangle")
}

/// Polygons whose coordinates need all of their bits. All usual ways to write the midpoint agree on their edges.
pub(super) fn rounding() -> [Start; 3] {
    [
        polygon(&[[0.1, 0.7], [0.3, 0.2], [0.8, 0.4], [0.6, 0.8]]),
        polygon(&[[1e-30, 0.0], [3e-30, 1e-31], [2e-30, 5e-30]]),
        polygon(&[[1e15, 1e-30], [1_000_000_000_000_001.0, 0.1], [999_999_999_999_999.0, 1e15]]),
    ]
}

/// A square cut in four with a vertex in the middle.
pub(super) fn window() -> Table {
    let mut points = Vec::new();
    for y in [0.0, 4.5, 9.0] {
        points.extend([[0.0, y], [5.5, y], [11.0, y]]);
    }
    let faces: [&[u32]; 5] = [&[0, 3, 6, 7, 8, 5, 2, 1], &[0, 1, 4, 3], &[1, 2, 5, 4], &[4, 5, 8, 7], &[3, 4, 7, 6]];
    from_cycles(&points, &faces)
}

/// The same structure with other numbers for its half-edges, other stored representatives, and another outer face.
pub(super) fn relabelled(table: &Table, random: &mut Random) -> Table {
    let order = random.order(table.half_edges.len());
    let name = |h: HalfEdgeId| HalfEdgeId::new(order[h.index()] as u32);
    let mut out = renumbered(table, |v| v, name, |f| f);
    let all = half_edges(&out);
    store_any(&mut out, all, random);
    out.outer_face = Some(FaceId::new(random.below(out.faces.len()) as u32));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::half_edge::classes::classes;
    use dcel_kit::VertexId;
    use dcel_kit::topology::{isomorphic, violations};

    #[test]
    fn starts_obey_the_laws_and_relabelling_changes_names_only() {
        let mut random = Random::new(7, "test");
        let all = odd().into_iter().map(|(_, table)| table).chain([window()]).chain(classes(3..=4, 2));
        for table in all {
            assert!(violations(&table).is_empty(), "{:?}", violations(&table));
            let mut other = relabelled(&table, &mut random);
            // The numbers of a single edge may come out as they were.
            assert!(other != table || table.half_edges.len() == 2);
            other.outer_face = None;
            assert!(isomorphic(&other, &Table { outer_face: None, ..table }).is_ok());
        }
    }

    #[test]
    #[allow(clippy::float_cmp)] // exact equality is meant
    fn the_usual_ways_to_write_a_midpoint_agree_where_bits_matter_and_careless_ones_do_not() {
        for start in rounding() {
            let numbers: Vec<f64> = start.text().split(' ').skip(1).map(|word| word.parse().unwrap()).collect();
            let corners: Vec<[f64; 2]> = numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
            let axis = |k: usize| (0..2).map(move |axis| [k, axis]);
            let mut careless = [true; 2];
            for [k, axis] in (0..corners.len()).flat_map(axis) {
                let [p, q] = [corners[k][axis], corners[(k + 1) % corners.len()][axis]];
                let middle = (p + q) / 2.0;
                assert_eq!([p / 2.0 + q / 2.0, (p + q) * 0.5, f64::midpoint(p, q)], [middle; 3]);
                assert_eq!([p + (q - p) / 2.0, q + (p - q) / 2.0, 0.5 * p + 0.5 * q], [middle; 3], "{p} {q}");
                careless[0] &= f64::from(middle as f32) == middle;
                careless[1] &= (middle * 65536.0).round() / 65536.0 == middle;
            }
            assert_eq!(careless, [false; 2]);
        }
    }

    #[test]
    fn a_face_passes_a_vertex_twice() {
        for table in [antenna(), bow_tie(), hanging_triangle()] {
            let at_v0 = |h: &HalfEdgeId| table.origin(*h) == Some(VertexId::new(0));
            let corners = |f| {
                let all = (0..table.half_edges.len() as u32).map(HalfEdgeId::new).filter(at_v0);
                all.filter(|&h| table.face(h) == Some(FaceId::new(f))).count()
            };
            assert!([corners(0), corners(1)].contains(&2));
        }
    }
}
