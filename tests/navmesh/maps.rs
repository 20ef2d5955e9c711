//! Maps from seeds: cells of a grid, some left out, their corners moved a little, each cut in two.

use dcel_kit::navmesh::NavMesh;
use dcel_kit::plane::{Point, Subdivision};

/// Xorshift.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        (self.bits() >> 11) as usize % bound
    }

    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Points and counter-clockwise triangles.
#[derive(Clone)]
pub(crate) struct Map {
    pub(crate) points: Vec<Point>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Map {
    /// A map of `size` x `size` cells. With `jitter` 0 many things lie on common lines.
    pub(crate) fn random(seed: u64, size: usize, free: f64, jitter: f64) -> Self {
        let mut random = Random::new(seed);
        let mut points = Vec::new();
        for y in 0..=size {
            for x in 0..=size {
                let [dx, dy] = [(); 2].map(|()| (random.unit() - 0.5) * jitter);
                points.push(Point::new(x as f64 + dx, y as f64 + dy));
            }
        }
        let mut triangles = Vec::new();
        for y in 0..size {
            for x in 0..size {
                let corner = |dx: usize, dy: usize| ((y + dy) * (size + 1) + x + dx) as u32;
                let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                let (is_free, slash) = (random.unit() < free, random.unit() < 0.5);
                if is_free {
                    triangles.extend(if slash { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
                }
            }
        }
        if triangles.is_empty() {
            triangles.push([0, 1, size as u32 + 1]);
        }
        Self { points, triangles }
    }

    pub(crate) fn subdivision(&self) -> Subdivision {
        Subdivision::from_triangles(self.points.clone(), &self.triangles).expect("cells that do not overlap")
    }

    pub(crate) fn mesh(&self) -> NavMesh {
        NavMesh::new(&self.subdivision()).expect("triangles are convex")
    }

    /// The same map with every point moved.
    pub(crate) fn moved(&self, by: impl Fn(Point) -> Point) -> Self {
        Self { points: self.points.iter().map(|&p| by(p)).collect(), triangles: self.triangles.clone() }
    }

    pub(crate) fn corners(&self, triangle: usize) -> [Point; 3] {
        self.triangles[triangle].map(|v| self.points[v as usize])
    }

    /// A point inside the triangle.
    pub(crate) fn inside(&self, triangle: usize, random: &mut Random) -> Point {
        let [a, b, c] = self.corners(triangle);
        let [u, v] = [0.1 + 0.4 * random.unit(), 0.1 + 0.4 * random.unit()];
        Point::new(a.x + (b.x - a.x) * u + (c.x - a.x) * v, a.y + (b.y - a.y) * u + (c.y - a.y) * v)
    }
}
