//! The starts of cases: as lines, as models, as records.
//!
//! The k-th edge that the triangles state has the half-edges h(2k), on the side that states it first, and h(2k+1).

use super::model::{Model, Place};
use crate::cases::cycles::sides_of;
use crate::cases::handouts::GEM;
use crate::cases::random::Random;
use crate::cases::starts::words;
use crate::protocol::{Cell, ColumnSchema, RecordSchema, Records, Start, Structure, TableSchema};
use std::collections::BTreeMap;
use std::sync::Arc;

use ColumnSchema::{Link, Number};

/// The records of the lab.
pub(super) static SCHEMA: RecordSchema = RecordSchema {
    singles: &[],
    tables: &[
        TableSchema {
            word: "vertex",
            letter: 'v',
            columns: &[Number("x"), Number("y"), Number("z"), Link("outgoing", 'h'), Number("live")],
        },
        TableSchema {
            word: "half_edge",
            letter: 'h',
            columns: &[
                Link("origin", 'v'),
                Link("twin", 'h'),
                Link("next", 'h'),
                Link("prev", 'h'),
                Link("face", 'f'),
                Number("live"),
            ],
        },
        TableSchema { word: "face", letter: 'f', columns: &[Link("half_edge", 'h'), Number("live")] },
    ],
};

/// A mesh that cases start from.
#[derive(Clone)]
pub(super) struct Solid {
    pub(super) name: &'static str,
    line: String,
    points: Vec<Place>,
    triangles: Vec<[usize; 3]>,
    /// The vertices that are free, in the order in which they became so.
    free: Vec<usize>,
}

impl Solid {
    /// What it should be.
    pub(super) fn model(&self) -> Model {
        Model::new(&self.points, &self.triangles).with_free(&self.free)
    }

    /// The start of a case.
    pub(super) fn start(&self) -> Start {
        Start::known(self.line.clone(), Structure::Records(Arc::new(self.records())))
    }

    /// With these vertices free. None of them has a triangle.
    pub(super) fn with_free(mut self, free: &[usize]) -> Self {
        self.line += &format!(" /{}", words(free));
        self.free = free.to_vec();
        self
    }

    fn records(&self) -> Records {
        records(&self.points, &self.triangles, &self.free)
    }
}

/// No vertex yet.
pub(super) fn empty() -> Solid {
    Solid { name: "empty", line: "empty".to_owned(), points: Vec::new(), triangles: Vec::new(), free: Vec::new() }
}

/// The gem of the handout: a pyramid with six sides above and below.
pub(super) fn gem() -> Solid {
    let triangles = (1..=6).flat_map(|k| [[k, k % 6 + 1, 7], [k % 6 + 1, k, 0]]).collect();
    Solid { name: "gem", line: "gem".to_owned(), points: GEM.to_vec(), triangles, free: Vec::new() }
}

/// A cube whose sides are cut into n times n squares, each of two triangles.
pub(super) fn cube(name: &'static str, n: usize) -> Solid {
    let mut points: Vec<Place> = Vec::new();
    let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
    let mut triangles = Vec::new();
    for side in 0..6 {
        let (axis, end) = (side / 2, side % 2 * n);
        for square in 0..n * n {
            let (i, j) = (square / n, square % n);
            let [a, b, c, d] = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(di, dj)| {
                let mut at = [end; 3];
                (at[(axis + 1) % 3], at[(axis + 2) % 3]) = (i + di, j + dj);
                *numbers.entry(at).or_insert_with(|| {
                    points.push(at.map(|x| x as f64));
                    points.len() - 1
                })
            });
            triangles.extend(if end == 0 { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] });
        }
    }
    Solid { name, line: format!("cube {n}"), points, triangles, free: Vec::new() }
}

/// A pyramid whose base is cut into many triangles, of which most do not touch the border of the base. A path on
/// the base from neighbour to neighbour, none of them twice, often comes to a vertex from where it cannot go on.
pub(super) fn nested(name: &'static str, seed: u64) -> Solid {
    const VERTICES: usize = 30;
    let mut random = Random::new(seed, "nested");
    // Three times the mean of three corners is whole; so deep that it stays whole.
    let side = 3.0_f64.powi(9);
    let mut points = vec![[0.0, 0.0, 0.0], [side, 0.0, 0.0], [0.0, side, 0.0], [side / 3.0, side / 3.0, side]];
    let mut base = vec![([0, 2, 1], 0)];
    while points.len() < VERTICES {
        let chosen = random.below(base.len());
        let ([a, b, c], depth) = base[chosen];
        if depth == 9 {
            continue;
        }
        let v = points.len();
        points.push([0, 1, 2].map(|i| (points[a][i] + points[b][i] + points[c][i]) / 3.0));
        base.swap_remove(chosen);
        base.extend([([a, b, v], depth + 1), ([b, c, v], depth + 1), ([c, a, v], depth + 1)]);
    }
    let sides = [[0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let order = random.order(VERTICES);
    let mut mixed = points.clone();
    order.iter().zip(&points).for_each(|(&v, &place)| mixed[v] = place);
    let triangles: Vec<[usize; 3]> =
        base.into_iter().map(|(corners, _)| corners).chain(sides).map(|corners| corners.map(|v| order[v])).collect();
    soup(name, &mixed, &triangles)
}

/// Triangles as a student would type them.
pub(super) fn soup(name: &'static str, points: &[Place], triangles: &[[usize; 3]]) -> Solid {
    let line = format!("soup{} /{}", words(points.iter().flatten()), words(triangles.iter().flatten()));
    Solid { name, line, points: points.to_vec(), triangles: triangles.to_vec(), free: Vec::new() }
}

/// The records that the student's program begins with.
fn records(points: &[Place], triangles: &[[usize; 3]], free: &[usize]) -> Records {
    let (ends, sides) = sides_of(triangles);
    let mut outgoing = vec![None; points.len()];
    for &h in sides.iter().flatten() {
        outgoing[ends[h][0]].get_or_insert(h as u32);
    }
    let mut links = vec![[None; 3]; ends.len()];
    for (f, three) in sides.iter().enumerate() {
        for i in 0..3 {
            links[three[i]] = [three[(i + 1) % 3], three[(i + 2) % 3], f].map(|to| Some(to as u32));
        }
    }
    let mut records = Records::new(&SCHEMA);
    for (v, (place, outgoing)) in points.iter().zip(outgoing).enumerate() {
        let [x, y, z] = place.map(Cell::Number);
        let live = if free.contains(&v) { 0.0 } else { 1.0 };
        records.push(0, &[x, y, z, Cell::Link(outgoing), Cell::Number(live)]);
    }
    for (h, [next, prev, face]) in links.into_iter().enumerate() {
        let [origin, twin] = [ends[h][0], h ^ 1].map(|to| Cell::Link(Some(to as u32)));
        records.push(1, &[origin, twin, Cell::Link(next), Cell::Link(prev), Cell::Link(face), Cell::Number(1.0)]);
    }
    for three in sides {
        records.push(2, &[Cell::Link(Some(three[0] as u32)), Cell::Number(1.0)]);
    }
    records
}

#[cfg(test)]
mod tests {
    use super::super::laws::broken;
    use super::*;

    #[test]
    fn the_starts_obey_the_laws_and_are_closed() {
        for (solid, [v, e, f]) in [(empty(), [0, 0, 0]), (gem(), [8, 18, 12]), (cube("cube", 3), [56, 162, 108])] {
            let model = solid.model();
            assert_eq!([model.live().count(), model.edges(), model.across.len() / 3], [v, e, f]);
            assert!(model.across.keys().all(|&(a, b)| model.across.contains_key(&(b, a))));
            assert_eq!(broken(&solid.records(), &model), None);
        }
    }

    #[test]
    fn the_gem_and_the_cubes_are_convex() {
        for solid in [gem(), cube("cube", 2), nested("nested", 1), nested("nested", 2)] {
            for corners in &solid.triangles {
                let [a, b, c] = corners.map(|v| solid.points[v]);
                let minus = |p: Place, q: Place| [0, 1, 2].map(|i| p[i] - q[i]);
                let (u, w) = (minus(b, a), minus(c, a));
                let normal = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
                let above = |p: &Place| (0..3).map(|i| normal[i] * (p[i] - a[i])).sum::<f64>();
                assert!(solid.points.iter().all(|p| above(p) <= 0.0), "{}: {corners:?}", solid.name);
            }
        }
    }
}
