//! Inserting a segment through everything: it walks from face to face and splits what it crosses.
//!
//! ```text
//!        │       │                 │       │
//!   p    │   f   │    q       p ●──●───────●──● q      ends become vertices, on an edge or in a face;
//!        │       │                 │       │           vertices on the way are passed through, edges
//!        ├───────┤        ==>      ├───────┤           on the way are followed
//!        │       │                 │       │
//! ```

use super::insert_edge::InsertEdgeError;
use super::insert_vertex::InsertVertexError;
use super::spot::Towards;
use super::{Obstacle, SplitEdgeError};
use crate::geometry::predicates::left_to_right;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::meet::Crossed;
use crate::plane::{CoordinateError, Location, PlaneRecorder, Point, Subdivision};
use crate::topology::NoRecorder;
use std::cmp::Ordering;

/// Why a segment cannot be inserted.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InsertSegmentError {
    /// An end is no place for a vertex.
    #[error("an end of the segment: {0}")]
    Coordinate(#[from] CoordinateError),
    /// Both ends are the same point.
    #[error("the segment has no length: both its ends are {at}")]
    ZeroLength {
        /// The point.
        at: Point,
    },
    /// An end cannot become a vertex.
    #[error("an end of the segment: {0}")]
    End(#[from] InsertVertexError),
    /// An edge that is crossed cannot be split there.
    #[error("{half_edge} is crossed at about {at}, but cannot be split there: {error}")]
    Split {
        /// The half-edge.
        half_edge: HalfEdgeId,
        /// The crossing, rounded to doubles.
        at: Point,
        /// Why not.
        error: SplitEdgeError,
    },
    /// A piece of the segment cannot be inserted.
    #[error(transparent)]
    Piece(#[from] InsertEdgeError),
    /// Rounded crossings led to more and more pieces.
    #[error(
        "the segment falls into more than {pieces} pieces by rounding: what it crosses is finer than doubles can represent"
    )]
    Unsettled {
        /// How many pieces were tried.
        pieces: usize,
    },
}

/// A segment that was inserted.
#[derive(Debug, Clone, PartialEq)]
pub struct InsertedSegment {
    /// The half-edges along it, from its first end to its second. Those that were there before are among them.
    pub half_edges: Vec<HalfEdgeId>,
    /// The vertices made where it crosses edges, from the first end on.
    pub crossings: Vec<VertexId>,
    /// The crossings that could not be kept in place, each with the distance it moved.
    pub moved: Vec<(VertexId, f64)>,
}

/// What is met first on the way.
enum Met {
    Vertex(VertexId),
    Edge(HalfEdgeId, Crossed),
}

impl Subdivision {
    /// Inserts the segment from `p` to `q`, whatever lies between.
    ///
    /// The ends become vertices where none are: in a face, or on an edge, which they split. Edges across the segment
    /// are split at the crossing; vertices on it are passed through, edges along it are followed. Faces are split, and
    /// components joined, as by [`insert_edge`](Self::insert_edge).
    ///
    /// What is crossed, and in which order, is decided exactly. A crossing becomes a vertex at the nearest doubles, so
    /// that both the edge and the segment may bend by as little there; if the bend ran over anything, the call is
    /// refused.
    ///
    /// Cost: that of [`locate`](Self::locate) for each end, and O(size of the faces on the way).
    ///
    /// # Errors
    /// See [`InsertSegmentError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let mut s = Subdivision::lab_rectangle();
    /// let cut = s.insert_segment(Point::new(-300.0, 0.0), Point::new(300.0, 0.0))?;
    /// assert_eq!((cut.half_edges.len(), cut.crossings.len()), (3, 2));
    /// assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (10, 11, 3));
    /// # Ok::<(), dcel_kit::plane::InsertSegmentError>(())
    /// ```
    pub fn insert_segment(&mut self, p: Point, q: Point) -> Result<InsertedSegment, InsertSegmentError> {
        self.insert_segment_with(p, q, &mut NoRecorder)
    }

    /// [`insert_segment`](Self::insert_segment), watched by a recorder.
    pub fn insert_segment_with(
        &mut self,
        p: Point,
        q: Point,
        rec: &mut impl PlaneRecorder,
    ) -> Result<InsertedSegment, InsertSegmentError> {
        p.check()?;
        q.check()?;
        if p == q {
            return Err(InsertSegmentError::ZeroLength { at: p });
        }
        self.all_or_nothing(rec, |s, rec| {
            let [from, to] = [s.vertex_at(p, rec)?, s.vertex_at(q, rec)?];
            s.insert_way(from, to, 0.0, rec)
        })
    }

    /// [`insert_segment`](Self::insert_segment) for a segment that may bend a little to keep clear of what is close: it is
    /// led through vertices that are not farther off than `near`, and an end is put on the nearest vertex or edge that is
    /// as near. So no crossing comes to lie beside a vertex, where there may be no room for it. The distance that does for
    /// segments that touch and cross is [`rounding_room`](super::rounding_room).
    ///
    /// Cost: as there.
    ///
    /// # Errors
    /// See [`InsertSegmentError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision, rounding_room};
    /// let square = [(0., 0.), (20., 0.), (20., 20.), (0., 20.)].map(Point::from);
    /// let mut s = Subdivision::polygon(&square)?;
    /// let near = rounding_room(square);
    /// // The last one touches the first, which has been bent a little where the second crosses it.
    /// for [p, q] in [[(5., 1.), (7., 9.)], [(4., 0.), (6., 3.)], [(6., 3.), (6., 5.)]] {
    ///     s.insert_segment_within(p.into(), q.into(), near)?;
    /// }
    /// assert_eq!(s.geometry_violations(), []);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn insert_segment_within(
        &mut self,
        p: Point,
        q: Point,
        near: f64,
    ) -> Result<InsertedSegment, InsertSegmentError> {
        p.check()?;
        q.check()?;
        if p == q {
            return Err(InsertSegmentError::ZeroLength { at: p });
        }
        self.all_or_nothing(&mut NoRecorder, |s, rec| {
            let [from, to] = [s.vertex_near(p, near, rec)?, s.vertex_near(q, near, rec)?];
            s.insert_way(from, to, near, rec)
        })
    }

    /// The vertex for an end: the nearest one that is near enough, else on an edge that is near enough, else at `p`.
    fn vertex_near(
        &mut self,
        p: Point,
        near: f64,
        rec: &mut impl PlaneRecorder,
    ) -> Result<VertexId, InsertVertexError> {
        let face = match self.locate(p) {
            Location::Vertex(v) => return Ok(v),
            Location::Edge(h) => self.dcel.face(h),
            Location::Face(f) => f,
        };
        if let Some(v) = self.nearest_vertex(face, p, near) {
            return Ok(v);
        }
        let beside = self.nearest_half_edge(face, p, near, |_| true);
        match beside.map(|h| self.split_edge_with(h, p, rec)) {
            Some(Ok((v, _))) => Ok(v),
            _ => self.vertex_at(p, rec),
        }
    }

    fn vertex_at(&mut self, p: Point, rec: &mut impl PlaneRecorder) -> Result<VertexId, InsertVertexError> {
        match self.insert_vertex_with(p, rec) {
            Err(InsertVertexError::Occupied { vertex, .. }) => Ok(vertex),
            other => other,
        }
    }

    /// Joins two vertices by a straight way through everything between them. It is led through vertices beside it that are
    /// not farther off than `near`. A caller that is refused goes back itself.
    pub(crate) fn insert_way(
        &mut self,
        from: VertexId,
        to: VertexId,
        near: f64,
        rec: &mut impl PlaneRecorder,
    ) -> Result<InsertedSegment, InsertSegmentError> {
        let mut done = InsertedSegment { half_edges: Vec::new(), crossings: Vec::new(), moved: Vec::new() };
        let most = 64 + 8 * self.dcel.edge_count();
        // The places still to be reached, the last one first: a rounded crossing comes before what lies behind it.
        let (mut at, mut goals) = (from, vec![to]);
        let mut way = vec![from];
        let line = [from, to].map(|v| self.points[v]);
        for _ in 0..most {
            let Some(&goal) = goals.last() else {
                // A later piece may have split an earlier one.
                let piece = |pair: &[VertexId]| self.dcel.find_half_edge(pair[0], pair[1]);
                let half_edges: Option<Vec<_>> = way.windows(2).map(piece).collect();
                done.half_edges = half_edges.ok_or(InsertSegmentError::Unsettled { pieces: way.len() })?;
                return Ok(done);
            };
            if at == goal {
                goals.pop();
                continue;
            }
            let face = match self.towards(at, self.points[goal]) {
                Towards::Along(h) => {
                    at = self.dcel.destination(h);
                    way.push(at);
                    continue;
                }
                Towards::Corner(h) => self.dcel.face(h),
                Towards::Open(f) => f,
            };
            if near > 0.0
                && let Some(v) = self.first_beside(face, [at, goal], line, near).filter(|v| !way.contains(v))
            {
                goals.push(v);
                continue;
            }
            let next = match self.first_met(face, at, goal) {
                None => goal,
                Some(Met::Vertex(v)) => v,
                Some(Met::Edge(h, crossed)) => {
                    goals.push(self.split_crossed(h, &crossed, near, &mut done, rec)?);
                    continue;
                }
            };
            self.insert_edge_with(at, next, rec)?;
            way.push(next);
            at = next;
        }
        Err(InsertSegmentError::Unsettled { pieces: most })
    }

    /// The nearest vertex or edge of the face on the way from one vertex to another.
    fn first_met(&self, f: FaceId, from: VertexId, to: VertexId) -> Option<Met> {
        let [a, b] = [from, to].map(|v| self.points[v]);
        let forward = left_to_right(a, b);
        let mut first: Option<Met> = None;
        let _ = self.find_on_way(f, [a, b], |obstacle| {
            let met = match obstacle {
                Obstacle::Vertex(v) => Met::Vertex(v),
                Obstacle::Edge(h) => {
                    let ends = [self.dcel.origin(h), self.dcel.destination(h)].map(|v| self.points[v]);
                    Met::Edge(h, Crossed::new([a, b], ends))
                }
            };
            let nearer = first.as_ref().is_none_or(|first| self.order_of(&met, first) == forward);
            if nearer {
                first = Some(met);
            }
            None::<()>
        });
        first
    }

    /// The first vertex of the face beside a way from one vertex to another that is part of a line, and not farther off the
    /// line than `near`.
    fn first_beside(&self, f: FaceId, [from, to]: [VertexId; 2], [p, q]: [Point; 2], near: f64) -> Option<VertexId> {
        let [x, y] = [q.x - p.x, q.y - p.y];
        let length = x.hypot(y);
        let along = |v: VertexId| ((self.points[v].x - p.x) * x + (self.points[v].y - p.y) * y) / length;
        let off = |v: VertexId| ((self.points[v].x - p.x) * y - (self.points[v].y - p.y) * x) / length;
        let [begin, end] = [from, to].map(along);
        let beside = self
            .vertices_of_face(f)
            .filter(|&v| off(v).abs() <= near && v != from && v != to && begin < along(v) && along(v) < end);
        beside.min_by(|&v, &w| along(v).total_cmp(&along(w)))
    }

    fn order_of(&self, one: &Met, other: &Met) -> Ordering {
        match (one, other) {
            (Met::Vertex(v), Met::Vertex(w)) => left_to_right(self.points[*v], self.points[*w]),
            (Met::Vertex(v), Met::Edge(_, crossed)) => crossed.order_to_point(self.points[*v]).reverse(),
            (Met::Edge(_, crossed), Met::Vertex(v)) => crossed.order_to_point(self.points[*v]),
            (Met::Edge(_, one), Met::Edge(_, other)) => one.order_to(other),
        }
    }

    /// Splits the half-edge where the way crosses it. Returns the vertex there: a new one, or an end of the edge.
    fn split_crossed(
        &mut self,
        h: HalfEdgeId,
        crossed: &Crossed,
        near: f64,
        done: &mut InsertedSegment,
        rec: &mut impl PlaneRecorder,
    ) -> Result<VertexId, InsertSegmentError> {
        let (place, off) = crossed.rounded();
        let ends = [self.dcel.origin(h), self.dcel.destination(h)];
        let v = if let Some(&end) = ends.iter().find(|&&v| self.points[v] == place) {
            end
        } else {
            let split = self.split_beside(h, place, near, rec);
            let v = split.map_err(|error| InsertSegmentError::Split { half_edge: h, at: place, error })?;
            done.crossings.push(v);
            v
        };
        if off > 0.0 {
            done.moved.push((v, off));
        }
        Ok(v)
    }

    /// Splits the half-edge at a place, or if it would be bent over something, at the first place round it, not farther off
    /// than `near`, where it would not.
    fn split_beside(
        &mut self,
        h: HalfEdgeId,
        place: Point,
        near: f64,
        rec: &mut impl PlaneRecorder,
    ) -> Result<VertexId, SplitEdgeError> {
        const RINGS: i32 = 8;
        let refused = match self.split_edge_with(h, place, rec) {
            Ok((v, _)) => return Ok(v),
            Err(error) => error,
        };
        let step = place.x.abs().max(place.y.abs()) * f64::EPSILON;
        for ring in (1..=RINGS).take_while(|&ring| 2.0 * f64::from(ring) * step <= near) {
            let around = (-ring..=ring).flat_map(|i| (-ring..=ring).map(move |j| [i, j]));
            for [i, j] in around.filter(|[i, j]| i.abs().max(j.abs()) == ring) {
                let beside = Point::new(place.x + f64::from(i) * step, place.y + f64::from(j) * step);
                if let Ok((v, _)) = self.split_edge_with(h, beside, rec) {
                    return Ok(v);
                }
            }
        }
        Err(refused)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::PlaneJournal;

    fn at(x: f64, y: f64) -> Point {
        Point::new(x, y)
    }

    #[test]
    fn the_first_vertex_beside_a_way_is_found_between_its_ends() {
        // A way from v0 to v1 along a slope of 3 to 4; v2 to v6 lie 5, 10, 5, 0 and 0 beside it, 50, 25, 75, -25 and
        // 125 along; v7 and v8 beside its ends.
        let beside = |along: f64, off: f64| at(7.0 + 4.0 * along - 3.0 * off, 3.0 * along + 4.0 * off - 2.0);
        let points = [
            beside(0., 0.),
            beside(20., 0.),
            beside(10., 1.),
            beside(5., -2.),
            beside(15., -1.),
            beside(-5., 0.),
            beside(25., 0.),
            beside(0., 1.),
            beside(20., 1.),
        ];
        let s = Subdivision::from_graph(&points, &[]).expect("loose points");
        let first = |ends: [u32; 2], near: f64| {
            let line = [points[0], points[1]];
            s.first_beside(s.outer_face(), ends.map(VertexId::new), line, near).map(VertexId::number)
        };
        assert_eq!(first([0, 1], 4.9), None);
        assert_eq!((first([0, 1], 5.0), first([0, 1], 9.9), first([0, 1], 10.0)), (Some(2), Some(2), Some(3)));
        assert_eq!((first([2, 1], 10.0), first([2, 4], 10.0), first([3, 1], 5.0)), (Some(4), None, Some(2)));
    }

    /// A point a hair above the edge: bent upwards behind it, the edge would run over it.
    #[test]
    fn an_edge_is_split_beside_a_place_at_which_it_would_be_bent_over_something() {
        let points = [at(0., 0.), at(4., 0.), at(1., 2f64.powi(-60))];
        let s = Subdivision::from_graph(&points, &[[0, 1]]).expect("an edge and a point");
        let h = HalfEdgeId::new(0);
        let (place, step) = (at(2., 2f64.powi(-52)), 2.0 * f64::EPSILON);
        assert!(s.clone().split_edge(h, place).is_err());
        let split = |near: f64| {
            let (mut one, mut journal) = (s.clone(), PlaneJournal::new());
            let v = one.split_beside(h, place, near, &mut journal).ok()?;
            assert_eq!(one.geometry_violations(), []);
            Some(one.point(v))
        };
        assert_eq!(split(1.9 * step), None);
        // The first of the eight places round it at which the edge stays below the point.
        let expected = at(place.x - step, place.y - step);
        assert_eq!((split(2.0 * step), split(1.0)), (Some(expected), Some(expected)));
        // Where all of them are above the point it takes a wider ring.
        let higher = |rings: f64| {
            let mut one = s.clone();
            let place = at(2., (rings + 0.5) * step);
            one.split_beside(h, place, 1.0, &mut PlaneJournal::new()).ok().map(|v| one.point(v))
        };
        assert_eq!(higher(2.0), Some(at(2. - 3.0 * step, -0.5 * step)));
        assert_eq!((higher(7.0).is_some(), higher(8.0)), (true, None));
    }
}
