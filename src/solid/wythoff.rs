//! Solids from solids, by points in flags: faces are moved apart, edges widened, faces twisted.
//!
//! ```text
//!          v                a flag is a corner v, the middle m of an edge there, and the mean c of a face there:
//!          ●───             the two flags of a half-edge h are A at its origin and B at its destination.
//!          │A ╲╲
//!          │  ╱c●           cantellated    a vertex for each corner of a face    faces, edges, vertices -> faces
//!        m ●─────           omnitruncated  a vertex for each flag                the same, with twice the corners
//!          │  ╲c●           snub           a vertex for every second flag        faces and vertices -> faces,
//!          │B ╱╱                                                                 edges -> two triangles
//!          ●───
//! ```
//!
//! Source: W. A. Wythoff, *A relation between the polytopes of the C600-family*, 1918; H. S. M. Coxeter, *Uniform
//! polyhedra*, 1954.

use super::Polyhedron;
use super::derived::TruncateError;
use super::vector::{Vector, plus, times};
use crate::ids::{EdgeId, HalfEdgeId, HalfEdgeMap};

/// The way a snub solid is twisted, seen from outside.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Hand {
    /// Its faces stand counter-clockwise of those it was made from.
    Left,
    /// Clockwise.
    Right,
}

/// The place of a point in a flag: how much of the corner, of the middle of the edge, and of the mean of the face.
/// Only the ratio counts.
pub type FlagWeights = [f64; 3];

impl Polyhedron {
    /// The surface with its faces shrunk towards their means, each corner to `ratio` of its distance; edges become
    /// quads, and vertices become faces, too. Faces come first, in their old order, then those of vertices, then
    /// those of edges. Cost: linear.
    ///
    /// # Errors
    /// [`TruncateError`]; the ratio must lie between 0 and 1.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let wide = Polyhedron::platonic(Platonic::Cube).cantellated(0.5)?;
    /// assert_eq!((wide.vertex_count(), wide.edge_count(), wide.face_count()), (24, 48, 26));
    /// # Ok::<(), dcel_kit::solid::TruncateError>(())
    /// ```
    pub fn cantellated(&self, ratio: f64) -> Result<Self, TruncateError> {
        check_weights([ratio, 0.0, 1.0 - ratio])?;
        self.check_corners()?;
        let (points, number) = self.points_in_flags(|h| self.in_flag(h, h, [ratio, 0.0, 1.0 - ratio]));
        let mut faces =
            self.faces_and_stars(|h, corners| corners.push(number[h]), |h, corners| corners.push(number[h]));
        for e in self.edges() {
            faces.push_face(&self.quad(e).map(|h| number[h]));
        }
        Ok(Self::from_polygons(points, &faces)?)
    }

    /// The surface with a vertex in each flag: faces keep their place with twice the corners, edges become quads,
    /// and a vertex with n edges becomes a face with 2n corners. Order as in [`cantellated`](Self::cantellated).
    /// Cost: linear.
    ///
    /// # Errors
    /// [`TruncateError`]; weights must be positive.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let all = Polyhedron::platonic(Platonic::Cube).omnitruncated([1.0, 1.0, 1.0])?;
    /// assert_eq!((all.vertex_count(), all.edge_count(), all.face_count()), (48, 72, 26));
    /// # Ok::<(), dcel_kit::solid::TruncateError>(())
    /// ```
    pub fn omnitruncated(&self, weights: FlagWeights) -> Result<Self, TruncateError> {
        check_weights(weights)?;
        self.check_corners()?;
        let (mut points, number) = self.points_in_flags(|h| self.in_flag(h, h, weights));
        let count = points.len() as u32;
        points.extend(self.half_edges().map(|h| self.in_flag(self.topology().next(h), h, weights)));
        let (first, second) = (|h: HalfEdgeId| number[h], |h: HalfEdgeId| count + number[h]);
        let mut faces = self.faces_and_stars(
            |h, corners| corners.extend([first(h), second(h)]),
            |h, corners| corners.extend([second(h.twin()), first(h)]),
        );
        for [h, twin] in self.edges().map(EdgeId::half_edges) {
            faces.push_face(&[second(h), first(h), second(twin), first(twin)]);
        }
        Ok(Self::from_polygons(points, &faces)?)
    }

    /// The surface with a vertex in every second flag: faces and vertices keep their corners and are twisted, and
    /// between them each edge becomes two triangles. Order as in [`cantellated`](Self::cantellated). Cost: linear.
    ///
    /// # Errors
    /// [`TruncateError`]; weights must be positive.
    ///
    /// ```
    /// use dcel_kit::solid::{Hand, Platonic, Polyhedron};
    /// let snub = Polyhedron::platonic(Platonic::Cube).snub([1.0, 1.0, 1.0], Hand::Left)?;
    /// assert_eq!((snub.vertex_count(), snub.edge_count(), snub.face_count()), (24, 60, 38));
    /// # Ok::<(), dcel_kit::solid::TruncateError>(())
    /// ```
    pub fn snub(&self, weights: FlagWeights, hand: Hand) -> Result<Self, TruncateError> {
        check_weights(weights)?;
        self.check_corners()?;
        let dcel = self.topology();
        let (points, number) = self.points_in_flags(|h| match hand {
            Hand::Left => self.in_flag(h, h, weights),
            Hand::Right => self.in_flag(h, dcel.prev(h), weights),
        });
        let mut faces =
            self.faces_and_stars(|h, corners| corners.push(number[h]), |h, corners| corners.push(number[h]));
        for e in self.edges() {
            // The two corners that were moved towards the edge are joined.
            let [a, b, c, d] = self.quad(e).map(|h| number[h]);
            let triangles = match hand {
                Hand::Left => [[a, b, d], [b, c, d]],
                Hand::Right => [[a, b, c], [a, c, d]],
            };
            triangles.iter().for_each(|triangle| faces.push_face(triangle));
        }
        Ok(Self::from_polygons(points, &faces)?)
    }

    /// The corners of the quad across an edge from `a` to `b`, counter-clockwise: the left face at `b` and `a`, the
    /// right face at `a` and `b`, each by its half-edge that starts there.
    fn quad(&self, e: EdgeId) -> [HalfEdgeId; 4] {
        let [h, twin] = e.half_edges();
        [self.topology().next(h), h, self.topology().next(twin), twin]
    }

    /// A point for each half-edge, and their numbers.
    pub(super) fn points_in_flags(&self, point: impl Fn(HalfEdgeId) -> Vector) -> (Vec<Vector>, HalfEdgeMap<u32>) {
        let mut number = HalfEdgeMap::filled(self.half_edge_bound(), 0);
        self.half_edges().zip(0..).for_each(|(h, i)| number[h] = i);
        (self.half_edges().map(point).collect(), number)
    }

    /// The point in the flag of the origin of `corner`, the edge of `side`, and the face of both.
    pub(super) fn in_flag(&self, corner: HalfEdgeId, side: HalfEdgeId, [v, m, c]: FlagWeights) -> Vector {
        let [at, middle, mean] = self.flag(corner, side);
        times(plus(plus(times(at, v), times(middle, m)), times(mean, c)), 1.0 / (v + m + c))
    }

    /// The corner, the middle of the edge and the mean of the face.
    pub(super) fn flag(&self, corner: HalfEdgeId, side: HalfEdgeId) -> [Vector; 3] {
        let dcel = self.topology();
        let at = |h: HalfEdgeId| self.point(dcel.origin(h));
        [at(corner), times(plus(at(side), at(side.twin())), 0.5), self.face_mean(dcel.face(side))]
    }
}

fn check_weights(weights: FlagWeights) -> Result<(), TruncateError> {
    let fits = weights.iter().all(|x| (0.0..1e100).contains(x)) && weights[0] > 0.0 && weights[2] > 0.0;
    if fits { Ok(()) } else { Err(TruncateError::Weights { weights }) }
}
