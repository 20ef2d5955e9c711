//! Points at random on a surface, every part of it as often as its area says.

use super::super::random::Numbers;
use super::layers::plan;
use super::{NavSurface, SurfacePoint, norm, normal};
use crate::plane::Point;
use crate::plane::predicates::orientation;

/// Random places of a surface: an iterator without an end. The same seed gives the same places.
#[derive(Clone, Debug)]
pub struct RandomSurfacePlaces<'a> {
    surface: &'a NavSurface,
    /// For each triangle that does not stand upright its number, and the area up to and with it.
    triangles: Vec<(u32, f64)>,
    numbers: Numbers,
}

impl NavSurface {
    /// Places spread evenly over the area of the surface, measured along it: a slope has more of them than its plan would
    /// have. Upright faces, on which nobody stands, have none.
    ///
    /// Cost: O(n) to begin, O(log n) for each place.
    ///
    /// ```
    /// use dcel_kit::navmesh::NavSurface;
    /// use dcel_kit::topology::PolygonList;
    /// // A floor of 4 x 4, and a slope of the same plan that rises by 3 over 4: 16 and 20.
    /// let points = [[0., 0., 0.], [4., 0., 0.], [8., 0., 3.], [8., 4., 3.], [4., 4., 0.], [0., 4., 0.]];
    /// let mut faces = PolygonList::new();
    /// [[0, 1, 4, 5], [1, 2, 3, 4]].iter().for_each(|face| faces.push_face(face));
    /// let surface = NavSurface::new(&points, &faces, None)?;
    /// let on_slope = surface.random_places(7).take(1800).filter(|place| place.point[0] > 4.0).count();
    /// assert!((950..1050).contains(&on_slope), "20 parts of 36, and {on_slope} of 1800 places");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn random_places(&self, seed: u64) -> RandomSurfacePlaces<'_> {
        let mut area = 0.0;
        let stands = |&t: &usize| {
            let [a, b, c] = self.corners(t).map(plan);
            orientation(a, b, c).is_gt()
        };
        let triangles = (0..self.triangle_count()).filter(stands).map(|t| {
            area += norm(normal(self.corners(t)));
            (t as u32, area)
        });
        RandomSurfacePlaces { surface: self, triangles: triangles.collect(), numbers: Numbers::new(seed) }
    }
}

impl Iterator for RandomSurfacePlaces<'_> {
    type Item = SurfacePoint;

    /// `None` only if all faces stand upright.
    fn next(&mut self) -> Option<SurfacePoint> {
        let &(_, whole) = self.triangles.last()?;
        let chosen = self.numbers.unit() * whole;
        let i = self.triangles.partition_point(|&(_, area)| area <= chosen).min(self.triangles.len() - 1);
        let t = self.triangles[i].0 as usize;
        let corners = self.surface.corners(t).map(plan);
        let at: Point = self.numbers.in_triangle(corners);
        self.surface.place_near(t, at)
    }
}
