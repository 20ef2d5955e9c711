//! Shapes that several tests use, from coordinates alone.

#![allow(unreachable_pub)] // a module of a test

use super::common::Random;
use dcel_kit::solid::{HullFaces, Polyhedron};
use dcel_kit::topology::PolygonList;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

pub fn polygons(faces: &[&[u32]]) -> PolygonList {
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    list
}

/// A prism over a polygon in the plane, given counter-clockwise, from z = 0 to `height`. Vertices below come first.
pub fn prism(base: &[[f64; 2]], height: f64) -> Polyhedron {
    let n = base.len() as u32;
    let at = |z: f64| base.iter().map(move |&[x, y]| [x, y, z]);
    let mut faces = PolygonList::new();
    faces.push_face(&(0..n).rev().collect::<Vec<_>>());
    faces.push_face(&(n..2 * n).collect::<Vec<_>>());
    for i in 0..n {
        let j = (i + 1) % n;
        faces.push_face(&[i, j, n + j, n + i]);
    }
    Polyhedron::from_polygons(at(0.0).chain(at(height)).collect(), &faces).unwrap()
}

/// An L: six corners, area 3.
pub const L: [[f64; 2]; 6] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];

/// A torus of n x m quads.
pub fn torus(n: u32, m: u32) -> Polyhedron {
    let mut points = Vec::new();
    let mut faces = PolygonList::new();
    for i in 0..n {
        for j in 0..m {
            let (a, b) = (TAU * f64::from(i) / f64::from(n), TAU * f64::from(j) / f64::from(m));
            let r = 3.0 + b.cos();
            points.push([r * a.cos(), r * a.sin(), b.sin()]);
            let at = |i: u32, j: u32| i % n * m + j % m;
            faces.push_face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    Polyhedron::from_polygons(points, &faces).unwrap()
}

/// The cube from 0 to `n` in all directions, each side cut into n x n squares.
pub fn cut_cube(n: u32) -> Polyhedron {
    let mut numbers = BTreeMap::new();
    let mut points = Vec::new();
    let mut faces = PolygonList::new();
    for (axis, side, u, v) in (0..3).flat_map(|axis| [0, 1].map(|side| (axis, side, axis + 1, axis + 2))) {
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let mut corners: Vec<u32> = [[0, 0], [1, 0], [1, 1], [0, 1]]
                .into_iter()
                .map(|[a, b]| {
                    let mut cell = [0; 3];
                    (cell[axis], cell[u % 3], cell[v % 3]) = (side * n, i + a, j + b);
                    *numbers.entry(cell).or_insert_with(|| {
                        points.push(cell.map(f64::from));
                        points.len() as u32 - 1
                    })
                })
                .collect();
            if side == 0 {
                corners.reverse();
            }
            faces.push_face(&corners);
        }
    }
    Polyhedron::from_polygons(points, &faces).unwrap()
}

/// Random points of a grid from -size to size.
pub fn grid_points(random: &mut Random, count: usize, size: usize) -> Vec<[f64; 3]> {
    let mut one = || random.below(2 * size + 1) as f64 - size as f64;
    (0..count).map(|_| [one(), one(), one()]).collect()
}

/// The hull of random points near the unit sphere, in triangles.
pub fn round_solid(random: &mut Random, count: usize) -> Polyhedron {
    let mut one = || random.below(2001) as f64 / 1000.0 - 1.0;
    let points = (0..count).map(|_| {
        let p = [one(), one(), one()];
        let size = p.iter().map(|x| x * x).sum::<f64>().sqrt().max(0.1);
        p.map(|x| x / size)
    });
    Polyhedron::convex_hull(&points.collect::<Vec<_>>(), HullFaces::Triangles).unwrap().solid
}
