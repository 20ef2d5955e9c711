//! Counts, areas and volume of a surface. Angles and curvatures are in `angles.rs`.
//!
//! These are doubles, good for looking at; decisions are in `flat.rs` and `convex.rs`, and exact.

use super::Polyhedron;
use super::vector::{Vector, cross, dot, length, mean, minus, plus, times, unit};
use crate::ids::{EdgeId, FaceId, VertexId};
use crate::topology::components;

/// The counts of one connected piece of a surface.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct PartCounts {
    /// The vertex of the piece with the lowest number.
    pub first_vertex: VertexId,
    /// V
    pub vertices: usize,
    /// E
    pub edges: usize,
    /// F, boundary faces not counted.
    pub faces: usize,
    /// Border cycles, each of which has a boundary face.
    pub borders: usize,
}

impl PartCounts {
    /// V - E + F.
    #[must_use]
    pub const fn euler(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.faces as i64
    }

    /// The number of handles: V - E + F = 2 - 2 genus - borders. An isolated vertex has none.
    #[must_use]
    pub const fn genus(&self) -> i64 {
        if self.edges == 0 { 0 } else { (2 - self.euler() - self.borders as i64) / 2 }
    }

    /// Whether the piece has no handles, by counting: of a closed piece that says that each closed curve of edges
    /// cuts it in two, which is the slides' definition, by the classification of surfaces. A curve that does not is
    /// found by [`Polyhedron::curve_without_sides`].
    ///
    /// The slides let curves from border to border count as closed, too; then a piece with two borders or more fails
    /// the definition even without handles. Borders are counted apart here: see [`borders`](Self::borders).
    #[must_use]
    pub const fn is_genus_zero(&self) -> bool {
        self.genus() == 0
    }

    /// Whether E <= 3V - 6, which holds for pieces without handles from three vertices on, if no two edges join
    /// the same vertices.
    ///
    /// Source: Kazhdan's slides on 3D convex hulls after O'Rourke, *Computational Geometry in C*, chapter 4.
    #[must_use]
    pub const fn is_within_edge_bound(&self) -> bool {
        self.vertices < 3 || self.edges <= 3 * self.vertices - 6
    }
}

impl Polyhedron {
    /// The counts of each connected piece, in the order of their first vertices. An isolated vertex is a piece.
    /// Linear, but for the inverse Ackermann function.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let [cube] = Polyhedron::platonic(Platonic::Cube).parts()[..] else { unreachable!() };
    /// assert_eq!((cube.vertices, cube.edges, cube.faces, cube.euler(), cube.genus()), (8, 12, 6, 2, 0));
    /// ```
    #[must_use]
    pub fn parts(&self) -> Vec<PartCounts> {
        let of = components(self);
        let empty = PartCounts { first_vertex: VertexId::new(0), vertices: 0, edges: 0, faces: 0, borders: 0 };
        let mut parts = vec![empty; of.count()];
        let index = |v: VertexId| of.of(v).map(|part| part as usize);
        for v in self.vertices().rev() {
            if let Some(i) = index(v) {
                parts[i].vertices += 1;
                parts[i].first_vertex = v;
            }
        }
        for e in self.edges() {
            if let Some(i) = index(self.topology().origin(e.half_edges()[0])) {
                parts[i].edges += 1;
            }
        }
        for f in self.faces() {
            let start = self.topology().boundary(f).map(|h| self.topology().origin(h));
            if let Some(i) = start.and_then(index) {
                if self.is_boundary_face(f) {
                    parts[i].borders += 1;
                } else {
                    parts[i].faces += 1;
                }
            }
        }
        parts
    }

    /// The faces that are polygons of the surface, boundary faces left out, in the order of their numbers.
    pub fn polygon_faces(&self) -> impl DoubleEndedIterator<Item = FaceId> + Clone + '_ {
        self.faces().filter(|&f| !self.is_boundary_face(f))
    }

    /// The dual graph: for each edge between two polygons the edge and the two faces, that of its even half first.
    pub fn dual_graph(&self) -> impl Iterator<Item = (EdgeId, [FaceId; 2])> + '_ {
        let sides = |e: EdgeId| (e, e.half_edges().map(|h| self.topology().face(h)));
        self.edges().map(sides).filter(|(_, faces)| faces.iter().all(|&f| !self.is_boundary_face(f)))
    }

    /// Where the vertices of a face are, in order.
    pub(super) fn corners(&self, f: FaceId) -> impl DoubleEndedIterator<Item = Vector> + Clone + '_ {
        self.incident_vertices(f).map(|v| self.point(v))
    }

    /// The vector at right angles to `f` whose length is the area of `f`, outwards. Of a face that is not flat it
    /// is that of the projection with the largest area. O(corners).
    ///
    /// Source: M. E. Newell's sum over the edges.
    #[must_use]
    pub fn area_vector(&self, f: FaceId) -> [f64; 3] {
        let Some(first) = self.corners(f).next() else { return [0.0; 3] };
        let ahead = self.corners(f).skip(1).map(|p| minus(p, first));
        let pairs = ahead.clone().zip(ahead.skip(1));
        times(pairs.fold([0.0; 3], |sum, (a, b)| plus(sum, cross(a, b))), 0.5)
    }

    /// The unit vector at right angles to `f`, outwards; none if `f` has no area.
    #[must_use]
    pub fn normal(&self, f: FaceId) -> Option<[f64; 3]> {
        unit(self.area_vector(f))
    }

    /// The mean of the corners of `f`.
    #[must_use]
    pub fn face_mean(&self, f: FaceId) -> [f64; 3] {
        mean(self.corners(f))
    }

    /// The area of all polygons together.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.polygon_faces().map(|f| length(self.area_vector(f))).sum()
    }

    /// The volume inside, for a closed surface: positive if the faces run counter-clockwise as seen from outside,
    /// negative if they are inside out. Meaningless for a surface with borders. Pieces are added up.
    #[must_use]
    pub fn signed_volume(&self) -> f64 {
        let Some(base) = self.vertices().next().map(|v| self.point(v)) else { return 0.0 };
        let cone = |f: FaceId| {
            let Some(first) = self.corners(f).next() else { return 0.0 };
            dot(self.area_vector(f), minus(first, base)) / 3.0
        };
        self.polygon_faces().map(cone).sum()
    }

    /// The mean of the vertices.
    #[must_use]
    pub fn mean_point(&self) -> [f64; 3] {
        mean(self.vertices().map(|v| self.point(v)))
    }

    /// The greatest distance of a corner of `f` from the plane at right angles to the normal of `f` through the
    /// mean of its corners. 0 or rounding if the face is flat; see [`is_flat`](Self::is_flat) for the decision.
    #[must_use]
    pub fn bend_of_face(&self, f: FaceId) -> f64 {
        let Some(normal) = self.normal(f) else { return 0.0 };
        let middle = self.face_mean(f);
        self.corners(f).map(|p| dot(normal, minus(p, middle)).abs()).fold(0.0, f64::max)
    }
}
