//! From x and y to places on the surface.
//!
//! ```text
//!        ·  height 5                 A point of the plan may have several storeys. Which one is meant is said by a
//!   ─────●─────  4.2, layer 1        height, and the highest surface at it or below it is taken; or by a layer.
//!   ─────●─────  0,   layer 0
//! ```

use super::super::nearest::closest_on;
use super::layers::plan;
use super::{NONE, NavSurface, Space, lerp, next};
use crate::ids::FaceId;
use crate::plane::Point;
use crate::plane::predicates::{orientation, twice_area};
use std::cmp::Ordering;

/// Which of several storeys is meant.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Floor {
    /// Whichever is there, if there is one only.
    Any,
    /// The highest that is at this height or below it.
    Height(f64),
    /// That of this layer.
    Layer(usize),
}

/// A place on a surface, from or to which a path may lead.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfacePoint {
    /// Where it is: x and y as they were given, and the height.
    pub point: [f64; 3],
    /// A face that has it.
    pub face: FaceId,
    /// The layer of that face.
    pub layer: usize,
    /// A triangle that has it.
    pub(super) triangle: u32,
    /// On which of the sides of the triangle it lies, a bit for each.
    on: u8,
}

/// Why one cannot stand at a point.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SurfacePointError {
    /// The surface is not there.
    #[error("({}, {}) is not on the surface", at[0], at[1])]
    Off {
        /// The point of the plan.
        at: [f64; 2],
    },
    /// The surface is there, but only above the height.
    #[error("at ({}, {}) nothing is as low as {height}: the lowest is at {}", at[0], at[1], lowest.point[2])]
    NothingBelow {
        /// The point of the plan.
        at: [f64; 2],
        /// The height.
        height: f64,
        /// What comes first above it.
        lowest: SurfacePoint,
    },
    /// The surface is there, but not on the layer.
    #[error("({}, {}) is not on layer {layer}", at[0], at[1])]
    NotOnLayer {
        /// The point of the plan.
        at: [f64; 2],
        /// The layer.
        layer: usize,
        /// Where the surface is.
        others: Vec<SurfacePoint>,
    },
    /// Several storeys are there.
    #[error("at ({}, {}) there are {} storeys: {}", at[0], at[1], places.len(), storeys(places))]
    Ambiguous {
        /// The point of the plan.
        at: [f64; 2],
        /// One place on each, from the lowest on.
        places: Vec<SurfacePoint>,
    },
}

/// `layer 0 at height 0, layer 1 at height 4.2`.
fn storeys(places: &[SurfacePoint]) -> String {
    let words: Vec<String> =
        places.iter().map(|place| format!("layer {} at height {}", place.layer, place.point[2])).collect();
    words.join(", ")
}

/// Heights whose difference is a smaller part of the size of the surface count as one.
pub(super) const LEVEL: f64 = 1e-9;

impl NavSurface {
    /// All places at a point of the plan, from the lowest to the highest. At a vertex where fans touch that nobody passes
    /// between there is one for each; upright faces have none inside.
    ///
    /// Cost: O(log n), and the triangles near the point.
    #[must_use]
    pub fn places(&self, at: [f64; 2]) -> Vec<SurfacePoint> {
        let p = Point::from(at);
        let mut found: Vec<((u8, u32), SurfacePoint)> = Vec::new();
        self.boxes.visit([p.x, p.y, p.x, p.y], |t| {
            found.extend(self.place_in(t, p).map(|place| (self.element(&place), place)));
        });
        found.sort_by(|(a, one), (b, other)| a.cmp(b).then(one.triangle.cmp(&other.triangle)));
        found.dedup_by_key(|(element, _)| *element);
        let mut places: Vec<SurfacePoint> = found.into_iter().map(|(_, place)| place).collect();
        places.sort_by(|a, b| a.point[2].total_cmp(&b.point[2]).then(a.triangle.cmp(&b.triangle)));
        places
    }

    /// The place at a point of the plan. At a vertex where fans touch it is in one of them;
    /// [`places_on`](Self::places_on) gives all.
    ///
    /// # Errors
    /// [`SurfacePointError`] says what is there instead.
    pub fn place(&self, at: [f64; 2], floor: Floor) -> Result<SurfacePoint, SurfacePointError> {
        self.places_on(at, floor).map(|places| places[0])
    }

    /// The places at a point of one storey: more than one where fans touch in a vertex. At least one.
    ///
    /// # Errors
    /// [`SurfacePointError`] says what is there instead.
    ///
    /// ```
    /// use dcel_kit::navmesh::{Floor, NavSurface, SurfacePointError};
    /// use dcel_kit::topology::PolygonList;
    /// // Two floors over each other.
    /// let [x, y] = [[0., 4., 4., 0.], [0., 0., 4., 4.]];
    /// let points: Vec<_> = (0..8).map(|i| [x[i % 4], y[i % 4], if i < 4 { 0. } else { 3. }]).collect();
    /// let mut faces = PolygonList::new();
    /// faces.push_face(&[0, 1, 2, 3]);
    /// faces.push_face(&[4, 5, 6, 7]);
    /// let house = NavSurface::new(&points, &faces, None)?;
    /// assert_eq!(house.layer_count(), 2);
    /// assert_eq!(house.place([1., 1.], Floor::Height(2.5))?.layer, 0);
    /// assert_eq!(house.place([1., 1.], Floor::Height(3.5))?.point, [1., 1., 3.]);
    /// assert!(matches!(house.place([1., 1.], Floor::Any), Err(SurfacePointError::Ambiguous { .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn places_on(&self, at: [f64; 2], floor: Floor) -> Result<Vec<SurfacePoint>, SurfacePointError> {
        let mut places = self.places(at);
        if places.is_empty() {
            return Err(SurfacePointError::Off { at });
        }
        let slack = self.slack;
        let chosen = match floor {
            Floor::Any => {
                let mut storeys = places.clone();
                storeys.dedup_by(|next, last| next.point[2] - last.point[2] <= slack);
                if storeys.len() > 1 {
                    return Err(SurfacePointError::Ambiguous { at, places: storeys });
                }
                storeys[0].point[2]
            }
            Floor::Height(height) => {
                let below = places.iter().rev().find(|place| place.point[2] <= height + slack);
                below.ok_or(SurfacePointError::NothingBelow { at, height, lowest: places[0] })?.point[2]
            }
            Floor::Layer(layer) => {
                let is_on = |place: &SurfacePoint| {
                    self.triangles_at(place).into_iter().any(|t| self.layer(self.face_of(t)) == Some(layer))
                };
                match places.iter().find(|place| is_on(place)) {
                    Some(place) => place.point[2],
                    None => return Err(SurfacePointError::NotOnLayer { at, layer, others: places }),
                }
            }
        };
        places.retain(|place| (place.point[2] - chosen).abs() <= slack);
        Ok(places)
    }

    /// The nearest place to a point: by the distance in the plan, and of storeys over each other by the height, if one is
    /// given, or of the layer that is asked for. With it the distance in the plan. `None` if a coordinate is not finite
    /// or there is no such layer.
    ///
    /// Cost: O(log n), and the triangles that are about as near; with a layer, those of other layers that are nearer, too.
    #[must_use]
    pub fn nearest(&self, at: [f64; 2], floor: Floor) -> Option<(SurfacePoint, f64)> {
        let p = Point::from(at);
        if let Ok(places) = self.places_on(at, floor) {
            return Some((places[0], 0.0));
        }
        let mut best: Option<([f64; 2], usize, Point)> = None;
        self.boxes.visit_near(at, |t| {
            let corners = self.corners(t);
            let is_asked_for = !matches!(floor, Floor::Layer(layer) if self.layer(self.face_of(t)) != Some(layer));
            if is_asked_for && orientation(plan(corners[0]), plan(corners[1]), plan(corners[2])).is_gt() {
                let inside = self.place_in(t, p).map(|_| p);
                let sides = (0..3).map(|k| closest_on([k, (k + 1) % 3].map(|k| plan(corners[k])), p));
                for q in inside.into_iter().chain(sides) {
                    let off = match floor {
                        Floor::Height(height) => (height_at(corners, q) - height).abs(),
                        _ => 0.0,
                    };
                    let far = [(q.x - p.x).hypot(q.y - p.y), off];
                    if far[0].is_finite() && best.is_none_or(|(least, other, _)| (far, t) < (least, other)) {
                        best = Some((far, t, q));
                    }
                }
            }
            best.map_or(f64::INFINITY, |([least, _], ..)| least)
        });
        let (_, t, q) = best?;
        let place = self.place_near(t, q)?;
        Some((place, (place.point[0] - p.x).hypot(place.point[1] - p.y)))
    }

    /// The place at a point in a triangle from which rounding may have moved the point by a hair; `None` if the triangle
    /// stands upright.
    pub(super) fn place_near(&self, t: usize, q: Point) -> Option<SurfacePoint> {
        let middle = self.corners(t).map(plan).iter().fold([0.0; 2], |sum, p| [sum[0] + p.x / 3.0, sum[1] + p.y / 3.0]);
        let steps = std::iter::once(0.0).chain((0..=60).rev().map(|i| 2f64.powi(-i)));
        steps
            .map(|part| Point::new(q.x + (middle[0] - q.x) * part, q.y + (middle[1] - q.y) * part))
            .find_map(|q| self.place_in(t, q))
    }

    /// The place at a point in a closed triangle, if it has the point. Exact.
    pub(super) fn place_in(&self, t: usize, p: Point) -> Option<SurfacePoint> {
        let corners = self.corners(t);
        let flat = corners.map(plan);
        if orientation(flat[0], flat[1], flat[2]).is_le() {
            return None;
        }
        let mut on = 0;
        for k in 0..3 {
            match orientation(flat[k], flat[(k + 1) % 3], p) {
                Ordering::Less => return None,
                Ordering::Equal => on |= 1 << k,
                Ordering::Greater => {}
            }
        }
        let point = match on {
            0 => [p.x, p.y, height_at(corners, p)],
            1 | 2 | 4 => {
                let k = usize::from(on == 2) + 2 * usize::from(on == 4);
                let [a, b] = [corners[k], corners[(k + 1) % 3]];
                let axis = usize::from((b[1] - a[1]).abs() > (b[0] - a[0]).abs());
                let share = ([p.x, p.y][axis] - a[axis]) / (b[axis] - a[axis]);
                [p.x, p.y, lerp(a, b, share)[2]]
            }
            // On two sides: in the corner between them.
            _ => corners[[3, 6, 5].into_iter().position(|both| both == on).map_or(0, |k| [1, 2, 0][k])],
        };
        let face = self.face_of(t);
        let layer = self.layer(face)?;
        Some(SurfacePoint { point, face, layer, triangle: t as u32, on })
    }

    /// What a place lies on: the same for the same point of a node, of an edge, of a triangle.
    fn element(&self, place: &SurfacePoint) -> (u8, u32) {
        match self.spot(place) {
            Spot::Inside => (0, place.triangle),
            Spot::Side(s) => (1, (s as u32).min(self.sides[s].twin)),
            Spot::Corner(s) => (2, self.sides[s].origin),
        }
    }

    pub(super) fn spot(&self, place: &SurfacePoint) -> Spot {
        let first = 3 * place.triangle as usize;
        match place.on {
            0 => Spot::Inside,
            1 => Spot::Side(first),
            2 => Spot::Side(first + 1),
            4 => Spot::Side(first + 2),
            3 => Spot::Corner(first + 1),
            6 => Spot::Corner(first + 2),
            _ => Spot::Corner(first),
        }
    }

    /// The triangles that have a place, as far as one may pass between them there.
    pub(super) fn triangles_at(&self, place: &SurfacePoint) -> Vec<usize> {
        match self.spot(place) {
            Spot::Inside => vec![place.triangle as usize],
            Spot::Side(s) => {
                let twin = Some(self.sides[s].twin).filter(|&twin| twin != NONE);
                std::iter::once(s / 3).chain(twin.map(|twin| twin as usize / 3)).collect()
            }
            Spot::Corner(s) => {
                let first = self.first[self.sides[s].origin as usize] as usize;
                let fan = std::iter::successors(Some(first), |&s| self.turn_left(s).filter(|&s| s != first));
                fan.map(|s| s / 3).collect()
            }
        }
    }

    /// Whether a place lies on a side, of any of the triangles that have it.
    pub(super) fn is_on_side(&self, place: &SurfacePoint, s: usize) -> bool {
        match self.spot(place) {
            Spot::Inside => false,
            Spot::Side(on) => on == s || self.sides[on].twin as usize == s,
            Spot::Corner(corner) => {
                let node = self.sides[corner].origin;
                self.sides[s].origin == node || self.sides[next(s)].origin == node
            }
        }
    }
}

/// Where in a triangle a place lies: on a side, or in the corner that a side starts from.
pub(super) enum Spot {
    Inside,
    Side(usize),
    Corner(usize),
}

/// The height of a triangle over a point of the plan.
fn height_at(corners: [Space; 3], p: Point) -> f64 {
    let [a, b, c] = corners.map(plan);
    let weights = [twice_area(b, c, p), twice_area(c, a, p), twice_area(a, b, p)];
    let whole: f64 = weights.iter().sum();
    // Differences, so that a flat triangle has its height exactly.
    corners[0][2] + (1..3).map(|i| (corners[i][2] - corners[0][2]) * (weights[i] / whole)).sum::<f64>()
}
