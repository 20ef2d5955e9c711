//! Points at random, every part of the mesh as often as its area says.
//!
//! ```text
//!   areas    │ f1      │ f2 │ f3           │    a number below the whole area falls into one triangle of a face;
//!            0 ────────────── · ───────────>    two more say where in it
//! ```
//!
//! Source: Osada, Funkhouser, Chazelle and Dobkin, *Shape distributions*, 2002, section 3.1, for the point in a triangle;
//! Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, 2014, for the numbers.

use super::{NavMesh, QueryPoint};
use crate::geometry::random;
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;
use crate::plane::predicates::twice_area;

/// Random places of a mesh: an iterator without an end. The same seed gives the same places.
#[derive(Clone, Debug)]
pub struct RandomPoints<'a> {
    mesh: &'a NavMesh,
    /// For each triangle its face, its corners, and the area up to and with it.
    triangles: Vec<(FaceId, [VertexId; 3], f64)>,
    numbers: Numbers,
}

impl NavMesh {
    /// Places spread evenly over the area of all faces where one may stand.
    ///
    /// Cost: O(n) to begin, O(log n) for each place.
    ///
    /// ```
    /// use dcel_kit::navmesh::NavMesh;
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let mesh = NavMesh::new(&Subdivision::polygon(&hall)?)?;
    /// let left = mesh.random_places(7).take(1000).filter(|place| place.point.x < 2.0).count();
    /// assert!((200..300).contains(&left), "a quarter of the hall, and {left} of 1000 places");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn random_places(&self, seed: u64) -> RandomPoints<'_> {
        self.random_places_in(self.faces(), seed)
    }

    /// [`random_places`](Self::random_places) in some faces only, for example in those of
    /// [`component_faces`](Self::component_faces). Faces where nobody may stand are left out.
    #[must_use]
    pub fn random_places_in(&self, faces: impl IntoIterator<Item = FaceId>, seed: u64) -> RandomPoints<'_> {
        let (mut triangles, mut area) = (Vec::new(), 0.0);
        for f in faces.into_iter().filter(|&f| self.is_walkable(f)) {
            let mut corners = self.corners(f);
            let (Some(first), Some(mut last)) = (corners.next(), corners.next()) else { continue };
            for corner in corners {
                let [a, b, c] = [first, last, corner].map(|v| self.point(v));
                area += twice_area(a, b, c).max(0.0);
                triangles.push((f, [first, last, corner], area));
                last = corner;
            }
        }
        RandomPoints { mesh: self, triangles, numbers: Numbers::new(seed) }
    }
}

/// Random numbers.
#[derive(Clone, Debug)]
pub(super) struct Numbers(u64);

impl Numbers {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A number from 0 up to, but without, 1.
    pub(super) fn unit(&mut self) -> f64 {
        (random::next(&mut self.0) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A point in a triangle, or by rounding a hair beside it.
    pub(super) fn in_triangle(&mut self, [a, b, c]: [Point; 3]) -> Point {
        let (s, t) = (self.unit().sqrt(), self.unit());
        let mix = |a: f64, b: f64, c: f64| (1.0 - s) * a + s * ((1.0 - t) * b + t * c);
        Point::new(mix(a.x, b.x, c.x), mix(a.y, b.y, c.y))
    }
}

impl Iterator for RandomPoints<'_> {
    type Item = QueryPoint;

    /// `None` only if there is no face to stand in.
    fn next(&mut self) -> Option<QueryPoint> {
        let &(.., whole) = self.triangles.last()?;
        let chosen = self.numbers.unit() * whole;
        let i = self.triangles.partition_point(|&(.., area)| area <= chosen).min(self.triangles.len() - 1);
        let (face, corners, _) = self.triangles[i];
        let at = self.numbers.in_triangle(corners.map(|v| self.mesh.point(v)));
        // Rounding may have moved it over a side: then it goes back by as little as it takes.
        Some(self.mesh.nearest_in(face, at, at).place)
    }
}
