//! The converter: triangles and polygons into a subdivision of the plane.
//!
//! ```text
//!   points, faces ──> check the points ──> which way does each face run ──> glue edges (topology/build)
//!                                                                                │
//!   subdivision <── full check, if asked <── faces of the border (nest.rs) <── links at touching
//!                   or Euler's relation                                        corners (fans.rs)
//!                   fails
//! ```
//!
//! The outside of the faces given becomes faces, too: what is unbounded is `f0`, every bounded gap is a *hole
//! face*. Together they cover the plane, so that no walk meets a border without a face.
//!
//! ```text
//!   error.rs   Why a list of faces is no subdivision of the plane
//!   simple.rs  Whether a closed polygon is simple, and which way it runs
//! ```

mod error;
mod fans;
mod nest;
mod simple;

pub use error::ConvertError;

use super::segments::insert_touching;
use super::{InsertedCorner, Point, Subdivision};
use crate::ids::{HalfEdgeId, VertexId};
use crate::topology::{BuildError, Dcel, Faces, NoRecorder, PolygonList, match_faces};

/// What to do with input that is not quite right.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ConvertOptions {
    /// Turn round the faces that run clockwise, by their exact signed area, instead of refusing them.
    pub orient: bool,
    /// Also look for overlaps that no shared edge or vertex betrays: all edges against each other, O(n log n);
    /// where nearly all faces are convex, O(n).
    pub full_check: bool,
    /// Insert corners where vertices lie exactly inside sides, if polygons do not fit together without them and do with
    /// them: a hole that touches its outer cycle, a tip on the side of a neighbour, sides of different length along a
    /// common border. Implies the full check.
    pub insert_touching: bool,
}

/// A subdivision made by the converter, and what was done to the input.
#[derive(Clone, PartialEq, Debug)]
pub struct Converted {
    /// The subdivision. Vertex i of the input is v(i), face i is f(i + 1); hole faces follow.
    pub subdivision: Subdivision,
    /// The faces that were turned round, by input number.
    pub turned: Vec<u32>,
    /// The vertices that no face uses. Their ids are left free.
    pub unused_vertices: Vec<VertexId>,
    /// The corners that were inserted into sides, polygon by polygon.
    pub inserted: Vec<InsertedCorner>,
}

/// Lists of faces that can be turned round.
pub(super) trait Turn: Faces + ToOwned {
    /// Turns round the cycle with this number.
    fn turn(owned: &mut Self::Owned, cycle: usize);
    /// The list as polygons, if any of them has holes.
    fn with_holes(&self) -> Option<&PolygonList>;
}

impl Turn for [[u32; 3]] {
    fn turn(owned: &mut Vec<[u32; 3]>, cycle: usize) {
        owned[cycle].swap(1, 2);
    }

    fn with_holes(&self) -> Option<&PolygonList> {
        None
    }
}

impl Turn for PolygonList {
    fn turn(owned: &mut Self, cycle: usize) {
        owned.cycle_mut(cycle)[1..].reverse();
    }

    fn with_holes(&self) -> Option<&PolygonList> {
        (!self.has_no_holes()).then_some(self)
    }
}

impl Subdivision {
    /// A subdivision with one bounded face, the simple polygon with these corners in counter-clockwise order:
    /// v0, v1, ... Its inside is `f1`, walked by h0, h2, ...; the twins h1, h3, ... bound `f0`. The half-edge
    /// `outgoing` of each vertex is the one inside.
    ///
    /// Cost: O(corners) for a convex polygon, else O(corners log corners).
    ///
    /// # Errors
    /// [`ConvertError`]: fewer than three corners, bad coordinates, clockwise, sides that meet, no area.
    ///
    /// ```
    /// use dcel_kit::plane::Subdivision;
    /// let triangle = Subdivision::polygon(&[[0.0, 0.0].into(), [4.0, 0.0].into(), [0.0, 3.0].into()])?;
    /// assert_eq!((triangle.vertex_count(), triangle.edge_count(), triangle.face_count()), (3, 3, 2));
    /// # Ok::<(), dcel_kit::plane::ConvertError>(())
    /// ```
    pub fn polygon(corners: &[Point]) -> Result<Self, ConvertError> {
        let mut list = PolygonList::new();
        list.push_face(&(0..corners.len() as u32).collect::<Vec<_>>());
        let mut polygon = Self::from_polygons(corners.to_vec(), &list)?;
        for v in 0..corners.len() as u32 {
            polygon.dcel.set_outgoing(VertexId::new(v), Some(HalfEdgeId::new(2 * v)), &mut NoRecorder);
        }
        Ok(polygon)
    }

    /// The triangulation-to-DCEL converter: counter-clockwise triangles over the given points.
    ///
    /// Vertex i is v(i), triangle i is f(i + 1), `f0` is the outer face. Gaps inside become faces flagged as
    /// holes; islands in them, and several components, are inner components; a border that touches itself at a vertex is
    /// sorted out by angles. Points that no triangle uses get no vertex.
    ///
    /// Cost: O(n), and O(b log b) for b border edges if there is more than one border cycle. Overlaps are found
    /// where faces share an edge or a touching vertex, and where Euler's relation fails (then O(n log n)); for all
    /// others ask for the full check with [`convert_triangles`](Self::convert_triangles).
    ///
    /// # Errors
    /// [`ConvertError`] names the faces and vertices that do not fit.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let points = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(Point::from).to_vec();
    /// let square = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!((square.edge_count(), square.face_count()), (5, 3));
    /// let neighbours: Vec<_> = square.adjacent_faces(dcel_kit::FaceId::new(1)).collect();
    /// assert_eq!(neighbours, [0, 0, 2].map(dcel_kit::FaceId::new));
    /// # Ok::<(), dcel_kit::plane::ConvertError>(())
    /// ```
    pub fn from_triangles(points: Vec<Point>, triangles: &[[u32; 3]]) -> Result<Self, ConvertError> {
        Ok(Self::convert_triangles(points, triangles, &ConvertOptions::default())?.subdivision)
    }

    /// [`from_triangles`](Self::from_triangles) for simple polygons, which may have holes. The outer cycle of a
    /// face runs counter-clockwise; its inner cycles may run either way.
    ///
    /// Cost: as for triangles, and O(k log k) for each cycle of k corners that is not convex.
    ///
    /// # Errors
    /// [`ConvertError`] names the faces and vertices that do not fit.
    pub fn from_polygons(points: Vec<Point>, polygons: &PolygonList) -> Result<Self, ConvertError> {
        Ok(Self::convert_polygons(points, polygons, &ConvertOptions::default())?.subdivision)
    }

    /// [`from_triangles`](Self::from_triangles) with options and a report.
    ///
    /// # Errors
    /// [`ConvertError`] names the faces and vertices that do not fit.
    pub fn convert_triangles(
        mut points: Vec<Point>,
        triangles: &[[u32; 3]],
        options: &ConvertOptions,
    ) -> Result<Converted, ConvertError> {
        convert(&mut points, triangles, options)
    }

    /// [`from_polygons`](Self::from_polygons) with options and a report.
    ///
    /// # Errors
    /// [`ConvertError`] names the faces and vertices that do not fit.
    pub fn convert_polygons(
        mut points: Vec<Point>,
        polygons: &PolygonList,
        options: &ConvertOptions,
    ) -> Result<Converted, ConvertError> {
        Self::convert_list(&mut points, polygons, options)
    }

    /// [`convert_triangles`](Self::convert_triangles) or [`convert_polygons`](Self::convert_polygons), whichever fits, that
    /// takes the points only if all is well.
    #[cfg(feature = "io")]
    pub(crate) fn convert_taking(
        points: &mut Vec<Point>,
        faces: &PolygonList,
        options: &ConvertOptions,
    ) -> Result<Converted, ConvertError> {
        match faces.as_triangles() {
            Some(triangles) if !options.insert_touching => convert(points, triangles, options),
            _ => Self::convert_list(points, faces, options),
        }
    }

    fn convert_list(
        points: &mut Vec<Point>,
        polygons: &PolygonList,
        options: &ConvertOptions,
    ) -> Result<Converted, ConvertError> {
        if !options.insert_touching {
            return convert(points, polygons, options);
        }
        let options = ConvertOptions { full_check: true, insert_touching: false, ..*options };
        convert(points, polygons, &options).or_else(|error| {
            // Other errors no corner would help.
            let between_rings = matches!(
                error,
                ConvertError::Geometry(_)
                    | ConvertError::OverlapAtVertex { .. }
                    | ConvertError::HoleOutside { .. }
                    | ConvertError::InPieces { .. }
                    | ConvertError::InsideFace { .. }
            );
            let Some((whole, inserted)) = between_rings.then(|| insert_touching(points, polygons)).flatten() else {
                return Err(error);
            };
            Ok(Converted { inserted, ..convert(points, &whole, &options)? })
        })
    }
}

/// Takes the points if all is well, and leaves them where it is not.
fn convert<F: Turn + ?Sized>(
    points: &mut Vec<Point>,
    faces: &F,
    options: &ConvertOptions,
) -> Result<Converted, ConvertError>
where
    F::Owned: std::borrow::Borrow<F>,
{
    for (vertex, point) in points.iter().enumerate() {
        point.check().map_err(|error| ConvertError::Coordinate { vertex: vertex as u32, error })?;
    }
    faces.check_each(points.len())?;
    let found = directions(points, faces)?;
    if found.cycles.is_empty() {
        return finish(points, faces, Vec::new(), options);
    }
    if let (Some(&face), false) = (found.clockwise.first(), options.orient) {
        // Two faces that do not fit together tell more than one that runs the wrong way.
        let all = found.clockwise.len() == faces.face_count();
        return Err(match match_faces(points.len(), faces, 1) {
            Err(error) => error.into(),
            Ok(_) => ConvertError::Clockwise { face, all },
        });
    }
    let mut turned = faces.to_owned();
    found.cycles.iter().for_each(|&cycle| F::turn(&mut turned, cycle));
    finish(points, std::borrow::Borrow::borrow(&turned), found.clockwise, options)
}

/// What runs the wrong way.
struct WrongWay {
    /// Cycles by number: outer ones that run clockwise, inner ones that run counter-clockwise.
    cycles: Vec<usize>,
    /// The faces whose outer cycle is among them.
    clockwise: Vec<u32>,
}

fn directions<F: Faces + ?Sized>(points: &[Point], faces: &F) -> Result<WrongWay, ConvertError> {
    let mut wrong = WrongWay { cycles: Vec::new(), clockwise: Vec::new() };
    let mut number = 0;
    faces.try_for_each_cycle(|face, cycle, corners| {
        let counter_clockwise = simple::direction(points, corners, face)?.is_gt();
        if counter_clockwise != (cycle == 0) {
            wrong.cycles.push(number);
            if cycle == 0 {
                wrong.clockwise.push(face);
            }
        }
        number += 1;
        Ok::<(), ConvertError>(())
    })?;
    Ok(wrong)
}

/// All cycles run the right way.
fn finish<F: Turn + ?Sized>(
    points: &mut Vec<Point>,
    faces: &F,
    turned: Vec<u32>,
    options: &ConvertOptions,
) -> Result<Converted, ConvertError> {
    let matched = match_faces(points.len(), faces, 1).map_err(|error| match error {
        BuildError::MixedWinding { u, v, first, second } => ConvertError::OverlapAtEdge { u, v, first, second },
        other => other.into(),
    })?;
    let mut dcel = Dcel::from_columns(matched.columns);
    let number = |dcel: &Dcel, h: HalfEdgeId| (!dcel.lacks_face(h)).then(|| dcel.face(h).number() - 1);
    let linked = fans::link_by_angle(&mut dcel, points, &matched.pinched, number);
    let mut subdivision = Subdivision::from_parts(dcel, std::mem::take(points).into());
    let nested = linked.and_then(|()| subdivision.nest(&matched.border, faces.with_holes()));
    let settled = match nested {
        Ok(inner_components) => subdivision.settle_in_plane(inner_components, matched.isolated > 0, options.full_check),
        // What lies in what, and what overlaps at a corner, is only known if nothing crosses.
        Err(error) => Err(options.full_check.then(|| subdivision.intersection()).flatten().map_or(error, Into::into)),
    };
    match settled {
        Ok(unused_vertices) => Ok(Converted { subdivision, turned, unused_vertices, inserted: Vec::new() }),
        Err(error) => {
            *points = subdivision.points.into_vec();
            Err(error)
        }
    }
}

impl Subdivision {
    /// Takes out the vertices without edges, if there are some, and returns them; then looks whether everything lies in
    /// the plane.
    fn settle_in_plane(
        &mut self,
        inner_components: usize,
        has_isolated: bool,
        full_check: bool,
    ) -> Result<Vec<VertexId>, ConvertError> {
        let mut unused = Vec::new();
        if has_isolated {
            unused.extend(self.dcel.vertices().filter(|&v| self.dcel.outgoing(v).is_none()));
            for &v in unused.iter().rev() {
                self.dcel.remove_vertex_record(v, &mut NoRecorder);
            }
        }
        let looks = full_check || !fits_the_plane(self, inner_components);
        let violations = if looks { self.geometry_violations() } else { Vec::new() };
        violations.first().map_or(Ok(unused), |&violation| Err(violation.into()))
    }
}

/// Euler's relation V - E + (F - 1) = C, with the inner components for C: without a walk it tells that every component
/// has genus 0 and lies in one face.
///
/// The signed areas of the cycles of a component add up to 0, and those of the boundaries of bounded faces are positive:
/// each component has at least one inner component. So with k components of genera g the left side, which is
/// 2k - 2 sum g - C, reaches C only if C = k and every g = 0. Where nothing crosses and the edges round each vertex lie
/// by their angles, it does: where it fails, the full check finds why.
fn fits_the_plane(s: &Subdivision, inner_components: usize) -> bool {
    s.vertex_count() + (s.face_count() - 1) == s.edge_count() + inner_components
}
