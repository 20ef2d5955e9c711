//! The five regular solids, by their corners: the faces are found by looking for planes with all corners on one side.

use super::angles::{Vector, cross, dot, minus};
use super::surface::Surface;
use std::f64::consts::TAU;

/// Their names, as a case has them.
pub(super) const NAMES: [&str; 5] = ["tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"];

/// A regular solid by its name; the cube if there is none of that name.
pub(super) fn solid(name: &str) -> Surface {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let points = match name {
        "tetrahedron" => vec![[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]],
        "octahedron" => turned([0., 0., 1.]),
        "icosahedron" => turned([0., 1., golden]),
        "dodecahedron" => [signs([1.; 3]), turned([0., golden, 1.0 / golden])].concat(),
        _ => signs([1.; 3]),
    };
    let faces = faces(&points);
    Surface::of_faces(points, &faces)
}

/// The point with all signs of its coordinates, those of zeros left alone.
fn signs(p: Vector) -> Vec<Vector> {
    let sign = |bits: usize, axis: usize| if bits >> axis & 1 == 1 { -1.0 } else { 1.0 };
    let all = (0..8).filter(|bits| (0..3).all(|axis| p[axis] > 0.0 || bits >> axis & 1 == 0));
    all.map(|bits| [0, 1, 2].map(|axis| sign(bits, axis) * p[axis])).collect()
}

/// The same with the coordinates moved on in turn.
fn turned(p: Vector) -> Vec<Vector> {
    let [x, y, z] = p;
    [[x, y, z], [z, x, y], [y, z, x]].into_iter().flat_map(signs).collect()
}

/// The faces of the hull of a few points round the origin: those in a plane that has no point beyond it.
fn faces(points: &[Vector]) -> Vec<Vec<u32>> {
    const NEAR: f64 = 1e-9;
    let n = points.len();
    let mut found: Vec<Vec<u32>> = Vec::new();
    for (i, j, k) in (0..n * n * n).map(|number| (number / n / n, number / n % n, number % n)) {
        let normal = cross(minus(points[j], points[i]), minus(points[k], points[i]));
        let height = |p: &Vector| dot(normal, minus(*p, points[i]));
        if dot(normal, normal) < NEAR || points.iter().any(|p| height(p) > NEAR) {
            continue;
        }
        // Round the middle, counter-clockwise seen along the normal from outside.
        let (along, across) = (minus(points[j], points[i]), cross(normal, minus(points[j], points[i])));
        let share = (dot(along, along) / dot(across, across)).sqrt();
        let mut corners: Vec<u32> = (0..n as u32).filter(|&v| height(&points[v as usize]) >= -NEAR).collect();
        let middle = super::dual::mean(corners.iter().map(|&v| points[v as usize]));
        let turn = |v: &u32| {
            let arm = minus(points[*v as usize], middle);
            (share * dot(across, arm)).atan2(dot(along, arm)).rem_euclid(TAU)
        };
        corners.sort_by(|v, w| turn(v).total_cmp(&turn(w)));
        let first = corners.iter().enumerate().min_by_key(|(_, v)| **v).map_or(0, |(at, _)| at);
        corners.rotate_left(first);
        if !found.contains(&corners) {
            found.push(corners);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::counts::{common, counts, sizes};

    #[test]
    fn the_five_solids_have_the_numbers_of_the_books() {
        let numbers = NAMES.map(|name| {
            let solid = solid(name);
            let [faces, vertices] = sizes(&solid);
            (counts(&solid), common(&faces).unwrap(), common(&vertices).unwrap())
        });
        let expected =
            [([4, 6, 4], 3, 3), ([8, 12, 6], 4, 3), ([6, 12, 8], 3, 4), ([20, 30, 12], 5, 3), ([12, 30, 20], 3, 5)];
        assert_eq!(numbers, expected);
    }
}
