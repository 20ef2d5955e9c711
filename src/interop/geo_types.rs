//! Polygons and lines of `geo-types` into a subdivision, and faces and edges out of it.
//!
//! ```text
//!   MultiPolygon ──equal corners become one vertex──> Subdivision ──> Polygon of a face, MultiPolygon of all
//!   lines        ──equal ends become one vertex─────>             ──> MultiLineString: a line an edge
//! ```
//!
//! Going in, a ring may run either way, and its closing point is left out. Going out, a ring is closed, the exterior one
//! runs counter-clockwise, the interior ones clockwise. Names and hole faces are not geometry and stay behind; so do
//! isolated vertices.

use crate::geometry::places::first_at_each_place;
use crate::ids::{FaceId, HalfEdgeId};
use crate::plane::{ConvertError, ConvertOptions, Point, SegmentsError, Subdivision, is_counter_clockwise};
use crate::topology::PolygonList;
use ::geo_types::{Coord, LineString, MultiLineString, MultiPolygon, Point as GeoPoint, Polygon};

as_xy!(Coord<f64>);

impl From<GeoPoint<f64>> for Point {
    fn from(p: GeoPoint<f64>) -> Self {
        p.0.into()
    }
}

impl From<Point> for GeoPoint<f64> {
    fn from(p: Point) -> Self {
        Self(p.into())
    }
}

/// Why polygons or lines of `geo-types` are no subdivision.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeoError {
    /// The polygons do not fit together. Polygon i is face i of the message.
    #[error("{error}{}", places(vertices))]
    Polygons {
        /// What is wrong, with vertices numbered in the order in which their coordinates first come.
        error: ConvertError,
        /// The vertices that it speaks of, and where they are.
        vertices: Vec<(u32, Point)>,
    },
    /// A polygon whose exterior ring has no corners.
    #[error("polygon {polygon} has no exterior ring; leave it out")]
    Empty {
        /// Its number, from 0.
        polygon: usize,
    },
    /// The lines do not fit together. Their parts are numbered from 0, line after line.
    #[error(transparent)]
    Lines(#[from] SegmentsError),
}

fn places(vertices: &[(u32, Point)]) -> String {
    vertices.iter().map(|(vertex, point)| format!("; vertex {vertex} is at {point}")).collect()
}

/// Corners of all rings, equal ones joined.
struct Joined {
    points: Vec<Point>,
    /// The number of the point of each corner.
    numbers: Vec<u32>,
}

impl Joined {
    /// Numbers points in the order in which they first come. O(n log n).
    fn new(corners: impl Iterator<Item = Coord<f64>>) -> Self {
        // -0 + 0 = 0: the two zeros are one coordinate.
        let corners: Vec<Point> = corners.map(|c| Point::new(c.x + 0.0, c.y + 0.0)).collect();
        let (first, _) = first_at_each_place(&corners);
        let (mut points, mut numbers) = (Vec::new(), vec![0; corners.len()]);
        for (i, &corner) in corners.iter().enumerate() {
            numbers[i] = if first[i] as usize == i {
                points.push(corner);
                points.len() as u32 - 1
            } else {
                numbers[first[i] as usize]
            };
        }
        Self { points, numbers }
    }
}

/// The corners of a ring without the one that closes it.
fn open(ring: &LineString<f64>) -> &[Coord<f64>] {
    match ring.0.split_last() {
        Some((last, rest)) if rest.first() == Some(last) => rest,
        _ => &ring.0,
    }
}

/// Polygon i becomes `f(i + 1)`. Rings may run either way; equal coordinates become one vertex; where corners lie inside
/// sides of others they are inserted. Nothing may cross or overlap: all of it is checked.
///
/// ```
/// use dcel_kit::{FaceId, Subdivision};
/// use geo_types::{MultiPolygon, Polygon, polygon};
/// let left = polygon![(x: 0., y: 0.), (x: 2., y: 0.), (x: 2., y: 2.), (x: 0., y: 2.)];
/// let right = polygon![(x: 2., y: 0.), (x: 4., y: 0.), (x: 4., y: 2.), (x: 2., y: 2.)];
/// let map = Subdivision::try_from(&MultiPolygon(vec![left.clone(), right]))?;
/// assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (6, 7, 3));
/// assert_eq!(map.polygon_of(FaceId::new(1)), Some(left));
/// # Ok::<(), dcel_kit::interop::GeoError>(())
/// ```
impl TryFrom<&MultiPolygon<f64>> for Subdivision {
    type Error = GeoError;

    fn try_from(polygons: &MultiPolygon<f64>) -> Result<Self, GeoError> {
        let rings = |polygon: &'_ Polygon<f64>| {
            let inner = polygon.interiors().iter().filter(|ring| !ring.0.is_empty()).cloned();
            std::iter::once(polygon.exterior().clone()).chain(inner).collect::<Vec<_>>()
        };
        if let Some(polygon) = polygons.0.iter().position(|polygon| polygon.exterior().0.is_empty()) {
            return Err(GeoError::Empty { polygon });
        }
        let all: Vec<Vec<LineString<f64>>> = polygons.0.iter().map(rings).collect();
        let Joined { points, numbers } = Joined::new(all.iter().flatten().flat_map(open).copied());
        let (mut list, mut at) = (PolygonList::new(), 0);
        for polygon in &all {
            for (i, ring) in polygon.iter().enumerate() {
                let corners = &numbers[at..at + open(ring).len()];
                at += corners.len();
                if i == 0 {
                    list.push_face(corners);
                } else {
                    list.push_hole(corners);
                }
            }
        }
        let options = ConvertOptions { orient: true, full_check: true, insert_touching: true };
        match Self::convert_polygons(points.clone(), &list, &options) {
            Ok(converted) => Ok(converted.subdivision),
            Err(error) => {
                let named = error.vertices().into_iter();
                let vertices = named.filter_map(|v| Some((v, *points.get(v as usize)?))).collect();
                Err(GeoError::Polygons { error, vertices })
            }
        }
    }
}

/// The same for one polygon.
impl TryFrom<&Polygon<f64>> for Subdivision {
    type Error = GeoError;

    fn try_from(polygon: &Polygon<f64>) -> Result<Self, GeoError> {
        Self::try_from(&MultiPolygon(vec![polygon.clone()]))
    }
}

/// What the lines cut the plane into, see [`Subdivision::from_segments`]: they may meet at common ends only.
impl TryFrom<&MultiLineString<f64>> for Subdivision {
    type Error = GeoError;

    fn try_from(lines: &MultiLineString<f64>) -> Result<Self, GeoError> {
        let parts = lines.0.iter().flat_map(LineString::lines);
        let segments: Vec<[Point; 2]> = parts.map(|part| [part.start.into(), part.end.into()]).collect();
        Ok(Self::from_segments(&segments)?)
    }
}

impl Subdivision {
    /// A bounded face as a polygon: what it covers, so without dangling edges and isolated vertices. The exterior ring
    /// runs counter-clockwise, the interior ones clockwise; all are simple and closed. `None` for `f0` and for faces that
    /// do not exist.
    ///
    /// Cost: O(n log n) for n half-edges of the face.
    #[must_use]
    pub fn polygon_of(&self, f: FaceId) -> Option<Polygon<f64>> {
        if f == self.outer_face() || !self.topology().has_face(f) {
            return None;
        }
        let (mut exterior, mut interiors) = (LineString(Vec::new()), Vec::new());
        for ring in self.simple_rings(f) {
            let is_exterior = is_counter_clockwise(&ring);
            let mut line: Vec<Coord<f64>> = ring.into_iter().map(Into::into).collect();
            line.extend(line.first().copied());
            if is_exterior {
                exterior = LineString(line);
            } else {
                interiors.push(LineString(line));
            }
        }
        Some(Polygon::new(exterior, interiors))
    }

    /// The border of what a face covers, as rings that pass each of their points once.
    fn simple_rings(&self, f: FaceId) -> Vec<Vec<Point>> {
        let dcel = self.topology();
        let is_border = |h: HalfEdgeId| dcel.face(h.twin()) != f;
        // The border half-edge after h: past the edges that have the face on both sides.
        let after = |h: HalfEdgeId| {
            let mut next = dcel.next(h);
            while !is_border(next) {
                next = dcel.next(next.twin());
            }
            next
        };
        let mut border: Vec<HalfEdgeId> =
            self.cycles(f).flat_map(|h| dcel.cycle(h)).filter(|&h| is_border(h)).collect();
        border.sort_unstable();
        let mut done = vec![false; border.len()];
        let mut rings = Vec::new();
        for i in 0..border.len() {
            let mut open: Vec<HalfEdgeId> = Vec::new();
            // Where on the open path each of its vertices is.
            let mut on_path = std::collections::BTreeMap::new();
            let mut h = border[i];
            while let Ok(at) = border.binary_search(&h) {
                let v = dcel.origin(h);
                if let Some(&from) = on_path.get(&v) {
                    let ring: Vec<HalfEdgeId> = open.drain(from..).collect();
                    for &h in &ring {
                        on_path.remove(&dcel.origin(h));
                    }
                    rings.push(ring.iter().map(|&h| self.point(dcel.origin(h))).collect());
                }
                if std::mem::replace(&mut done[at], true) {
                    break;
                }
                on_path.insert(v, open.len());
                open.push(h);
                h = after(h);
            }
        }
        rings
    }
}

/// All faces of the domain, in the order of their numbers: not `f0`, and no hole faces. Neighbours share sides.
impl From<&Subdivision> for MultiPolygon<f64> {
    fn from(s: &Subdivision) -> Self {
        let faces = s.topology().faces().filter(|&f| !s.is_hole(f));
        Self(faces.filter_map(|f| s.polygon_of(f)).collect())
    }
}

/// A line of two points for each edge, in the order of the edges.
impl From<&Subdivision> for MultiLineString<f64> {
    fn from(s: &Subdivision) -> Self {
        let dcel = s.topology();
        let line =
            |h: HalfEdgeId| LineString(vec![s.point(dcel.origin(h)).into(), s.point(dcel.destination(h)).into()]);
        Self(dcel.edges().map(|e| line(e.half_edges()[0])).collect())
    }
}
