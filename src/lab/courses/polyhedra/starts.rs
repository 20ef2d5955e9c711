//! The surfaces that cases begin with: stated by a line that a student can type, or as a table.

use super::merging::merged;
use super::regular;
use super::shapes::{Faces, bipyramid, blind};
use super::surface::Surface;
use crate::cases::random::Random;
use crate::cases::starts::words;
use crate::protocol::{Start, Structure};
use dcel_kit::HalfEdgeId;
use std::sync::Arc;

/// A surface, how a case states it, and its name.
#[derive(Clone)]
pub(super) struct Given {
    pub(super) name: String,
    pub(super) start: Start,
    pub(super) surface: Surface,
}

/// `0 1 2 / 0 3 1 / …`
fn listed(faces: &[Vec<u32>]) -> String {
    let face = |corners: &Vec<u32>| corners.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
    faces.iter().map(face).collect::<Vec<_>>().join(" / ")
}

/// All vertices at one place, by the corners of the faces.
pub(super) fn of_faces(name: &str, faces: &Faces) -> Given {
    let start = Start::line(format!("faces {}", listed(faces)));
    Given { name: name.to_owned(), start, surface: blind(faces) }
}

/// With points in space.
pub(super) fn of_solid(name: &str, surface: &Surface) -> Given {
    let line = format!("solid{} / {}", words(surface.points.iter().flatten()), listed(&surface.corners()));
    Given { name: name.to_owned(), start: Start::line(line), surface: surface.clone() }
}

/// Every record written out.
pub(super) fn of_table(name: &str, surface: &Surface) -> Given {
    let start = Start::structure_of(Structure::Records(Arc::new(surface.records())));
    Given { name: name.to_owned(), start, surface: surface.clone() }
}

/// The same with other representatives, each any one that may be stored.
pub(super) fn with_others(surface: &Surface, random: &mut Random) -> Surface {
    let mut other = surface.clone();
    for v in 0..surface.points.len() as u32 {
        let stored = random.pick(&surface.spokes(v)).copied();
        if let Some(row) = &mut other.table.vertices[v as usize] {
            row.outgoing = stored;
        }
    }
    for f in surface.faces() {
        let stored = random.pick(&surface.of_face(f)).copied();
        if let Some(row) = &mut other.table.faces[f.index()] {
            row.half_edge = stored;
        }
    }
    other
}

/// Some edges removed, and their faces merged; other representatives.
pub(super) fn with_removed(surface: &Surface, merges: usize, random: &mut Random) -> Surface {
    let mut left = surface.clone();
    for _ in 0..merges {
        let there: Vec<HalfEdgeId> = left.half_edges().collect();
        let h = random.pick(&there).copied();
        if let Some(after) = h.and_then(|h| merged(&left, h)) {
            left = after;
        }
    }
    with_others(&left, random)
}

/// A regular solid by its word.
pub(super) fn platonic(name: &str) -> Given {
    Given { name: name.to_owned(), start: Start::line(format!("platonic {name}")), surface: regular::solid(name) }
}

/// Solids in space with flat convex faces; the regular ones first.
pub(super) fn solids() -> Vec<(String, Surface)> {
    let mut all: Vec<(String, Surface)> = regular::NAMES.map(|name| (name.to_owned(), regular::solid(name))).into();
    let mut add = |name: &str, points: &[[f64; 3]], faces: &[&[u32]]| {
        let faces: Vec<Vec<u32>> = faces.iter().map(|face| face.to_vec()).collect();
        all.push((name.to_owned(), Surface::of_faces(points.to_vec(), &faces)));
    };
    let cube = [
        [0., 0., 0.],
        [2., 0., 0.],
        [2., 2., 0.],
        [0., 2., 0.],
        [0., 0., 2.],
        [2., 0., 2.],
        [2., 2., 2.],
        [0., 2., 2.],
        [1., 1., 1.],
    ];
    let sides: [&[u32]; 5] = [&[0, 3, 2, 1], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
    let dent: [&[u32]; 4] = [&[4, 5, 8], &[5, 6, 8], &[6, 7, 8], &[7, 4, 8]];
    add("dented_cube", &cube, &[&sides[..], &dent].concat());
    let all_sides = [&sides[..], &[&[4, 5, 6, 7]]].concat();
    let halves: Vec<[u32; 3]> = all_sides.iter().flat_map(|s| [[s[0], s[1], s[2]], [s[0], s[2], s[3]]]).collect();
    let cut: Vec<&[u32]> = halves.iter().map(|half| &half[..]).collect();
    add("cut_cube", &cube[..8], &cut);
    // A linear map keeps faces flat, up to rounding.
    let leaning: Vec<[f64; 3]> =
        cube[..8].iter().map(|[x, y, z]| [0.7 * x + 0.1 * y, 0.9 * y + 0.3 * z, 1.1 * z + 0.2 * x]).collect();
    add("leaning_cut_cube", &leaning, &cut);
    let lower: [&[u32]; 5] = [&[3, 2, 1, 0], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
    let pyramid = |apex: [f64; 3]| [[0., 0., 0.], [4., 0., 0.], [4., 3., 0.], [0., 3., 0.], apex];
    add("pyramid", &pyramid([1., 1., 3.]), &lower);
    let four: [&[u32]; 4] = [&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]];
    add("corner", &[[0., 0., 0.], [3., 0., 0.], [0., 2., 0.], [0., 0., 1.]], &four);
    add("tenths", &[[0.1, 0.2, 0.3], [1.1, 0.7, 0.3], [0.3, 1.3, 0.7], [0.6, 0.9, 1.7]], &four);
    add("tiny", &[[0., 0., 0.], [3e-30, 0., 1e-30], [0., 2e-30, 0.], [0., 0., 1e-30]], &four);
    add("huge", &[[1e15, 2e15, 0.], [3e15, 2e15, 0.1], [1e15, 5e15, 0.], [1e15, 3e15, 7e15]], &four);
    all.push(("frame".to_owned(), frame()));
    all
}

/// Solids with an edge or an apex so sharp that angles are close to 0.
pub(super) fn sharp() -> Vec<(String, Surface)> {
    let four = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(Vec::from);
    let needle = |length: f64| {
        let points = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0.25, 0.25, length]];
        Surface::of_faces(points, &four)
    };
    vec![("needle".to_owned(), needle(1e8)), ("longer_needle".to_owned(), needle(2e8))]
}

/// As the line `frame` has it.
fn frame() -> Surface {
    let profile = [(1., 0.), (3., 0.), (3., 2.), (1., 2.)];
    let turns = [(1., 1.), (-1., 1.), (-1., -1.), (1., -1.)];
    let points = turns.iter().flat_map(|(x, y)| profile.map(|(r, z)| [r * x, r * y, z])).collect();
    let around = super::shapes::torus(4, 4);
    Surface::of_faces(points, &around)
}

/// Two pyramids base to base, the tips above each other, the base uneven: as many random ones as are asked for.
pub(super) fn random_solid(random: &mut Random) -> Surface {
    const DIRECTIONS: [[f64; 2]; 8] =
        [[3., 0.], [2., 2.], [0., 3.], [-2., 2.], [-3., 0.], [-2., -2.], [0., -3.], [2., -2.]];
    let kept: Vec<[f64; 2]> = match random.below(3) {
        0 => vec![DIRECTIONS[0], DIRECTIONS[3], DIRECTIONS[6]],
        1 => vec![DIRECTIONS[0], DIRECTIONS[2], DIRECTIONS[4], DIRECTIONS[6], DIRECTIONS[7]],
        _ => DIRECTIONS.to_vec(),
    };
    let mut number = |least: usize, most: usize| (least + random.below(most - least + 1)) as f64;
    let mut points: Vec<[f64; 3]> = Vec::new();
    for [x, y] in kept {
        let r = number(1, 4);
        points.push([r * x, r * y, number(0, 4) - 2.0]);
    }
    let faces = bipyramid(points.len() as u32);
    points.push([0., 0., number(3, 9)]);
    points.push([0., 0., -number(3, 9)]);
    Surface::of_faces(points, &faces)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::angles::TOLERANCE;
    use dcel_kit::topology::View;

    #[test]
    fn solids_are_turned_outside() {
        for (name, surface) in solids().into_iter().chain(sharp()) {
            let place = |v: &u32| surface.points[*v as usize];
            let volume = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
                a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            };
            let origin = surface.points[0];
            let seen = |v: &u32| [0, 1, 2].map(|i| place(v)[i] - origin[i]);
            let mut sum = 0.0;
            for corners in surface.corners() {
                for i in 2..corners.len() {
                    sum += volume(seen(&corners[0]), seen(&corners[i - 1]), seen(&corners[i]));
                }
            }
            assert!(sum > 0.0, "{name}");
        }
        let mut random = Random::new(3, "solids");
        for i in 0..100 {
            let surface = random_solid(&mut random);
            let sum: f64 =
                (0..surface.points.len() as u32).map(|v| super::super::angles::deficit(&surface, v).unwrap()).sum();
            assert!((sum - 4.0 * std::f64::consts::PI).abs() < TOLERANCE, "{i}");
        }
    }

    #[test]
    fn what_was_removed_leaves_a_surface() {
        let mut random = Random::new(4, "removed");
        for (name, faces) in super::super::shapes::all() {
            let left = with_removed(&blind(&faces), 3, &mut random);
            assert!(left.has_removed(), "{name}");
            assert!(left.half_edges().all(|h| left.table.next(h).and_then(|next| left.table.prev(next)) == Some(h)));
        }
    }
}
