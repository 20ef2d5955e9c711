//! Where the vertices of a surface of revolution are.
//!
//! ```text
//!   row 2   ●────●────●     a vertex has a row, and a number of steps from the half-edge that the call names; both
//!   row 1   ●────●────●     are found by a search from quad to quad, in whatever order it finds them
//!   row 0   ●─h─▶●────●
//! ```

use super::reference::{self, round};
use crate::answers::Wrong;
use crate::cases::numbers;
use crate::cases::random::Random;
use crate::checks::walks::half_edges;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// How far a coordinate may be from the right one, as a share of the radius of its row.
const TOLERANCE: f64 = 1e-9;

/// The row of each vertex, and its steps along the row; and how many steps a row has.
fn lattice(table: &Table, h: HalfEdgeId, rows: &[[f64; 2]]) -> Option<(Vec<Option<[usize; 2]>>, usize)> {
    let last = rows.len().checked_sub(1)?;
    let lowest = usize::from(rows[0][0] == 0.0);
    let highest = last.checked_sub(usize::from(rows[last][0] == 0.0))?;
    let (pole_above, is_torus) = (highest < last, super::growth::genus(table) == 1);
    let mut at = vec![None; table.vertices.len()];
    let mut found: BTreeMap<HalfEdgeId, [usize; 2]> = BTreeMap::new();
    let mut to_visit = vec![(h, [lowest, 0])];
    while let Some((east, [row, steps])) = to_visit.pop() {
        if found.contains_key(&east) {
            continue;
        }
        found.insert(east, [row, steps]);
        *at.get_mut(table.origin(east)?.index())? = Some([row, steps]);
        let cell = round(table, east)?;
        if last == 0 {
            to_visit.push((cell[1], [row, steps + 1]));
            continue;
        }
        if row < highest {
            to_visit.push((table.twin(*cell.get(2)?)?, [row + 1, steps]));
        }
        // Above the highest row there may be no wall, but a face.
        if row < highest || pole_above || is_torus {
            to_visit.push((table.next(table.twin(*cell.get(1)?)?)?, [row, steps + 1]));
        }
    }
    let around = found.values().filter(|[row, _]| *row == lowest).count();
    if lowest == 1 {
        at[table.origin(table.prev(table.twin(h)?)?)?.index()] = Some([0, 0]);
    }
    if pole_above {
        let (&top, _) = found.iter().find(|(_, [row, _])| *row == highest)?;
        at[table.origin(table.prev(top)?)?.index()] = Some([last, 0]);
    }
    Some((at, around))
}

/// The place of each vertex; where `turn` is -1, as it would be clockwise.
fn places(table: &Table, h: HalfEdgeId, rows: &[[f64; 2]], turn: f64) -> Option<Vec<[f64; 3]>> {
    let (at, around) = lattice(table, h, rows)?;
    let place = |at: Option<[usize; 2]>| {
        let [row, steps] = at?;
        let [radius, height] = *rows.get(row)?;
        let (sin, cos) = (turn * TAU * (steps % around.max(1)) as f64 / around as f64).sin_cos();
        Some([radius * cos, radius * sin, height])
    };
    at.into_iter().map(place).collect()
}

/// Whether a place is near enough: the height is that of the row, and x and y are off by little.
fn is_near(found: [f64; 3], expected: [f64; 3]) -> bool {
    let radius = expected[0].hypot(expected[1]);
    let near = |axis: usize| (found[axis] - expected[axis]).abs() <= TOLERANCE * radius;
    near(0) && near(1) && found[2].to_bits() == (expected[2] + 0.0).to_bits()
        || near(0) && near(1) && found[2] == 0.0 && expected[2] == 0.0
}

/// What is wrong with the places that a call has returned.
pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = super::growth::closed(exchange.before()?);
    let h = HalfEdgeId::new(exchange.words.first()?.strip_prefix('h')?.parse().ok()?);
    let numbers: Vec<f64> = exchange.words.iter().filter_map(|word| word.parse().ok()).collect();
    let rows: Vec<[f64; 2]> = numbers.chunks_exact(2).map(|row| [row[0], row[1]]).collect();
    let expected = places(&table, h, &rows, 1.0)?;
    let found: Option<Vec<[f64; 3]>> = values.iter().map(Value::place).collect();
    let Some(found) = found else { return Some(Wrong::kind("a list of places")) };
    if found.len() != expected.len() {
        let because = format!("there are {} vertices, and {} places", expected.len(), found.len());
        return Some(Wrong::because("count", because));
    }
    let v = (0..found.len()).find(|&v| !is_near(found[v], expected[v]))?;
    let (at, _) = lattice(&table, h, &rows)?;
    let [row, steps] = at[v]?;
    let ([x, y, z], [fx, fy, fz]) = (expected[v], found[v]);
    let steps = if steps == 1 { "1 step".to_owned() } else { format!("{steps} steps") };
    let because = format!(
        "v{v} is at ({fx}, {fy}, {fz}); it is in row {row}, {steps} from the origin of {h}, and belongs at \
         ({x}, {y}, {z})"
    );
    let clockwise = places(&table, h, &rows, -1.0)?;
    let all = |other: &[[f64; 3]]| found.iter().zip(other).all(|(&found, &other)| is_near(found, other));
    Some(Wrong::because("place", because).is([(all(&clockwise), "the surface as it is in a mirror")]))
}

/// A surface that is asked for: rows with their poles, or a torus.
pub(super) struct Asked {
    pub(super) table: Table,
    pub(super) h: HalfEdgeId,
    pub(super) rows: Vec<[f64; 2]>,
}

/// A surface of revolution, its elements numbered at random; `h` is any side of its lowest row.
pub(super) fn asked(sides: usize, rings: usize, poles: Option<[bool; 2]>, random: &mut Random) -> Option<Asked> {
    let sizes = [0.1, 1.0 / 3.0, 1.0, 2.5, 1e-30, 1e15];
    let mut radius = || random.pick(&sizes).copied().unwrap_or(1.0);
    let mut rows: Vec<[f64; 2]> = (0..rings).map(|j| [radius(), 0.7 * j as f64 - 1.3]).collect();
    let table = match poles {
        None => reference::torus(sides, rings)?,
        Some([top, bottom]) => {
            if top {
                rows.push([0.0, 7.1]);
            }
            if bottom {
                rows.insert(0, [0.0, -7.1]);
            }
            reference::tube(sides, rings - 1, [top, bottom])?
        }
    };
    // The sides of the seed are h0, h2, and so on; the torus has one of them, cut in pieces.
    let first = if poles.is_some() { 2 * random.below(sides) } else { 0 };
    let (table, order) = renumbered(&table, random);
    Some(Asked { table, h: HalfEdgeId::new(order[first] as u32), rows })
}

/// The same surface with other numbers of all its elements, and other stored half-edges; and the new numbers of
/// the half-edges.
fn renumbered(table: &Table, random: &mut Random) -> (Table, Vec<usize>) {
    let orders = [table.vertices.len(), table.half_edges.len(), table.faces.len()].map(|count| random.order(count));
    let vertex = |v: VertexId| VertexId::new(orders[0][v.index()] as u32);
    let half_edge = |h: HalfEdgeId| HalfEdgeId::new(orders[1][h.index()] as u32);
    let face = |f: FaceId| FaceId::new(orders[2][f.index()] as u32);
    let mut out = numbers::renumbered(table, vertex, half_edge, face);
    // The last one that is seen is stored, whichever that is.
    numbers::store_last(&mut out, half_edges(table).map(half_edge));
    (out, orders.into_iter().nth(1).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::{first_violation, isomorphic};

    fn length(p: [f64; 3], q: [f64; 3]) -> f64 {
        (p[0] - q[0]).hypot(p[1] - q[1]).hypot(p[2] - q[2])
    }

    #[test]
    fn other_numbers_make_the_same_surface() {
        let mut random = Random::new(3, "numbers");
        let table = reference::tube(5, 2, [true, false]).unwrap();
        let (other, _) = renumbered(&table, &mut random);
        assert!(first_violation(&other).is_none());
        assert_ne!(other, table);
        isomorphic(&other, &table).unwrap();
    }

    /// With equal radii and steps of a unit, edges along a row have the side of the polygon as their length, those
    /// between rows one, and no two vertices are at one place.
    #[test]
    fn edges_are_as_long_as_the_sides_of_the_polygon_and_the_steps() {
        let mut random = Random::new(5, "lengths");
        for (sides, rings) in [(3, 2), (4, 4), (7, 3)] {
            let Asked { table, h, .. } = asked(sides, rings, Some([false; 2]), &mut random).unwrap();
            let rows: Vec<[f64; 2]> = (0..rings).map(|j| [1.0, j as f64]).collect();
            let all = places(&table, h, &rows, 1.0).unwrap();
            let side = 2.0 * (TAU / 2.0 / sides as f64).sin();
            let (mut along, mut up) = (0, 0);
            for g in (0..table.half_edges.len() as u32).map(HalfEdgeId::new) {
                let [p, q] = [g, table.twin(g).unwrap()].map(|g| all[table.origin(g).unwrap().index()]);
                if p[2].to_bits() == q[2].to_bits() {
                    assert!((length(p, q) - side).abs() < 1e-12);
                    along += 1;
                } else {
                    assert!((length(p, q) - 1.0).abs() < 1e-12);
                    up += 1;
                }
            }
            assert_eq!([along, up], [2 * sides * rings, 2 * sides * (rings - 1)]);
            let start = all[table.origin(h).unwrap().index()];
            assert!(length(start, [1.0, 0.0, 0.0]) < 1e-12, "h starts at the angle 0");
            let end = all[table.origin(table.twin(h).unwrap()).unwrap().index()];
            assert!(end[1] > 0.0, "h runs counter-clockwise");
        }
    }

    #[test]
    fn every_vertex_has_a_place_and_poles_are_on_the_axis() {
        let mut random = Random::new(6, "poles");
        for poles in [Some([true, false]), Some([true, true]), None, Some([false, false])] {
            for (sides, rings) in [(3, 3), (5, 4)] {
                let Asked { table, h, rows } = asked(sides, rings, poles, &mut random).unwrap();
                let all = places(&table, h, &rows, 1.0).unwrap();
                let expected = poles.map_or(0, |poles| poles.into_iter().filter(|&pole| pole).count());
                let on_axis = all.iter().filter(|place| place[0].hypot(place[1]) == 0.0).count();
                assert_eq!((all.len(), on_axis), (sides * rings + expected, expected));
            }
        }
    }
}
