//! Counts, areas and volume of a surface. Angles and curvatures are in `angles.rs`.
//!
//! These are doubles, good for looking at; decisions are in `flat.rs` and `convex.rs`, and exact.

use super::Polyhedron;
use super::vector::{Sum, Vector, dot, length, mean, minus, times, unit};
use crate::ids::{EdgeId, FaceId, VertexId};
use crate::plane::Expansion;
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
            let start = self.topology().half_edge(f).map(|h| self.topology().origin(h));
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
    /// Good to 1e-12 of its length, also for slivers: what rounding could spoil is summed up exactly.
    ///
    /// Source: M. E. Newell's sum over the edges.
    #[must_use]
    pub fn area_vector(&self, f: FaceId) -> [f64; 3] {
        let Some(first) = self.corners(f).next() else { return [0.0; 3] };
        let ahead = self.corners(f).skip(1).map(|p| minus(p, first));
        let (mut sums, mut size) = ([Sum::default(); 3], 0.0_f64);
        for (a, b) in ahead.clone().zip(ahead.skip(1)) {
            let mut turn = [0.0; 3];
            for [k, i, j] in TURNS {
                let (one, other) = (a[i] * b[j], a[j] * b[i]);
                turn[k] = one - other;
                size += one.abs() + other.abs();
            }
            (0..3).for_each(|k| sums[k].add(turn[k]));
        }
        let twice = sums.map(Sum::value);
        if is_good(length(twice), size) { times(twice, 0.5) } else { self.exact_area_vector(f) }
    }

    /// The same, each coordinate rounded once.
    fn exact_area_vector(&self, f: FaceId) -> [f64; 3] {
        TURNS.map(|[_, i, j]| {
            let mut twice = Expansion::default();
            for (p, q) in self.corners(f).zip(self.corners(f).cycle().skip(1)) {
                twice.add_product(p[i], q[j]);
                twice.add_product(-p[j], q[i]);
            }
            0.5 * twice.rounded()
        })
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

    /// The area of all polygons together. Good to 1e-12 of it.
    #[must_use]
    pub fn area(&self) -> f64 {
        Sum::of(self.polygon_faces().map(|f| length(self.area_vector(f))))
    }

    /// The volume inside, for a closed surface: positive if the faces run counter-clockwise as seen from outside,
    /// negative if they are inside out. Meaningless for a surface with borders. Pieces are added up; faces that are not
    /// flat count as triangles from their first corner. O(corners).
    ///
    /// Good to 1e-12 of it, wherever the surface lies and however thin it is: what rounding could spoil is summed up
    /// exactly.
    #[must_use]
    pub fn signed_volume(&self) -> f64 {
        let Some(base) = self.vertices().next().map(|v| self.point(v)) else { return 0.0 };
        let (mut sum, mut size) = (Sum::default(), 0.0_f64);
        for [a, b, c] in self.fans() {
            let [a, b, c] = [a, b, c].map(|p| minus(p, base));
            let mut six = 0.0;
            for [k, i, j] in TURNS {
                let (one, other) = (a[k] * b[i] * c[j], a[k] * b[j] * c[i]);
                six += one - other;
                size += one.abs() + other.abs();
            }
            sum.add(six);
        }
        let closed = self.boundary_faces().next().is_none();
        if is_good(sum.value(), size) || !closed { sum.value() / 6.0 } else { self.exact_volume() }
    }

    /// The same, rounded once.
    fn exact_volume(&self) -> f64 {
        let mut six = Expansion::default();
        for [a, b, c] in self.fans() {
            for [k, i, j] in TURNS {
                six.add_product_of_three(a[k], b[i], c[j]);
                six.add_product_of_three(-a[k], b[j], c[i]);
            }
        }
        six.rounded() / 6.0
    }

    /// All polygons in triangles from their first corners.
    fn fans(&self) -> impl Iterator<Item = [Vector; 3]> + '_ {
        self.polygon_faces().flat_map(|f| {
            let ahead = self.corners(f).skip(1);
            let first = self.corners(f).next().unwrap_or_default();
            ahead.clone().zip(ahead.skip(1)).map(move |(b, c)| [first, b, c])
        })
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

/// Each axis with the two that follow it.
const TURNS: [[usize; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

/// Whether a sum is good to 5e-13, if its terms have the sum of sizes `size`: differences of coordinates, products of
/// three of them and their sum cost eight roundings at most.
fn is_good(sum: f64, size: f64) -> bool {
    8.0 * f64::EPSILON * size <= 5e-13 * sum.abs()
}
