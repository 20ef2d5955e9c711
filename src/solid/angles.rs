//! Angles and curvatures of a surface.
//!
//! ```text
//!   face on the left of h          dihedral angle of an edge: inside, between its two faces. Less than pi at a
//!       ╲  θ  ╱  face of twin      convex edge, pi in a flat place, more at a reflex edge.
//!        ╲   ╱
//!         ╲ ╱                      deficit angle of a vertex: 2 pi - the angles of its faces there; each gap of
//!      ●───h───>●                  the border takes another pi. Their sum is 2 pi (V - E + F): Gauss and Bonnet.
//! ```
//!
//! All of them are read off the area vectors of the faces. Asked one by one, each makes the vectors of the faces that
//! it touches; [`Polyhedron::measures`] makes them once for all.
//!
//! These are doubles, good for looking at; decisions are in `flat.rs` and `convex.rs`, and exact.

use super::Polyhedron;
use super::vector::{Vector, cross, dot, length, minus, unit};
use crate::ids::{EdgeId, FaceId, FaceMap, HalfEdgeId, VertexId};
use std::f64::consts::{PI, TAU};

impl Polyhedron {
    /// The angle of the face of `h` at the origin of `h`, inside the face: between 0 and 2 pi. O(corners of the face);
    /// for many angles see [`measures`](Self::measures), here and for what follows.
    #[must_use]
    pub fn corner_angle(&self, h: HalfEdgeId) -> f64 {
        self.unseen().corner_angle(h)
    }

    /// The angle inside the solid between the two faces of `e`: between 0 and 2 pi, less than pi if the edge is
    /// convex. None if the edge lies on the border, or if one of the faces has no area. O(sizes of the two faces).
    #[must_use]
    pub fn dihedral_angle(&self, e: EdgeId) -> Option<f64> {
        self.unseen().dihedral_angle(e)
    }

    /// From the origin of `h` to its destination.
    pub(super) fn edge_vector(&self, h: HalfEdgeId) -> Vector {
        minus(self.point(self.topology().destination(h)), self.point(self.topology().origin(h)))
    }

    /// 2 pi minus the angles of the faces at `v`, and minus pi for each gap of the border at `v`. It is the
    /// curvature of Gauss that the vertex holds; over a whole surface with flat faces it adds up to
    /// 2 pi (V - E + F). O(sizes of the faces at `v`).
    #[must_use]
    pub fn deficit_angle(&self, v: VertexId) -> f64 {
        self.unseen().deficit_angle(v)
    }

    /// The sum of all deficit angles. O(V + E + F).
    #[must_use]
    pub fn total_deficit(&self) -> f64 {
        self.measures().total_deficit()
    }

    /// The area that belongs to `v`: an equal part of each face at `v`. O(sizes of the faces at `v`).
    #[must_use]
    pub fn vertex_area(&self, v: VertexId) -> f64 {
        self.unseen().vertex_area(v)
    }

    /// The curvature of Gauss at `v`: its deficit angle for each unit of area. 1 / r² on a fine mesh of a sphere.
    /// None if the faces at `v` have no area. O(sizes of the faces at `v`).
    #[must_use]
    pub fn gauss_curvature(&self, v: VertexId) -> Option<f64> {
        self.unseen().gauss_curvature(v)
    }

    /// The mean curvature at `v`: half of what its edges bend, each by (pi - dihedral angle) times half of its
    /// length, for each unit of area. 1 / r on a fine mesh of a sphere, positive where the solid is convex. None
    /// if the faces at `v` have no area. Edges of the border do not count. O(sizes of the faces at `v`, times two).
    ///
    /// Source: J. Steiner's formula for polyhedra, 1840.
    #[must_use]
    pub fn mean_curvature(&self, v: VertexId) -> Option<f64> {
        self.unseen().mean_curvature(v)
    }

    /// Looks at every face once, so that each angle and curvature costs what it touches at its own edge or vertex,
    /// however many corners the faces there have. O(V + E + F); 28 bytes a face.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let cube = Polyhedron::platonic(Platonic::Cube);
    /// let measures = cube.measures();
    /// assert!(cube.vertices().all(|v| measures.deficit_angle(v) == cube.deficit_angle(v)));
    /// ```
    #[must_use]
    pub fn measures(&self) -> Measures<'_> {
        let mut vectors = FaceMap::filled(self.face_bound(), [0.0; 3]);
        let mut sizes = FaceMap::filled(self.face_bound(), 0);
        for f in self.polygon_faces() {
            vectors[f] = self.area_vector(f);
            sizes[f] = self.corners(f).count() as u32;
        }
        Measures { surface: self, seen: Some((vectors, sizes)) }
    }

    /// The formulas, of faces that are looked at only when they are asked for.
    fn unseen(&self) -> Measures<'_> {
        Measures { surface: self, seen: None }
    }
}

/// Angles and curvatures of a surface whose faces have been looked at; see [`Polyhedron::measures`].
///
/// The values are those of the methods of [`Polyhedron`] with the same names, to the last bit.
#[derive(Clone, Debug)]
pub struct Measures<'a> {
    surface: &'a Polyhedron,
    /// The area vector of each face and the number of its corners.
    seen: Option<(FaceMap<Vector>, FaceMap<u32>)>,
}

impl Measures<'_> {
    /// See [`Polyhedron::corner_angle`]. O(1).
    #[must_use]
    pub fn corner_angle(&self, h: HalfEdgeId) -> f64 {
        let surface = self.surface;
        let dcel = surface.topology();
        let [at, to, from] = [h, h.twin(), dcel.prev(h)].map(|h| surface.point(dcel.origin(h)));
        let (a, b) = (minus(to, at), minus(from, at));
        let turn = cross(a, b);
        let angle = length(turn).atan2(dot(a, b));
        if dot(turn, self.vector_of(dcel.face(h))) < 0.0 { TAU - angle } else { angle }
    }

    /// See [`Polyhedron::dihedral_angle`]. O(1).
    #[must_use]
    pub fn dihedral_angle(&self, e: EdgeId) -> Option<f64> {
        let surface = self.surface;
        if e.index() >= surface.topology().edge_bound() {
            surface.topology().no_such(e);
        }
        let [h, twin] = e.half_edges();
        let faces = [h, twin].map(|h| surface.topology().face(h));
        if faces.iter().any(|&f| surface.is_boundary_face(f)) {
            return None;
        }
        let (left, right) = (unit(self.vector_of(faces[0]))?, unit(self.vector_of(faces[1]))?);
        let along = surface.edge_vector(h);
        let size = length(along);
        let bend = if size > 0.0 { dot(cross(left, right), along) / size } else { 0.0 };
        Some(PI - bend.atan2(dot(left, right)))
    }

    /// See [`Polyhedron::deficit_angle`]. O(degree of `v`), and so the following.
    #[must_use]
    pub fn deficit_angle(&self, v: VertexId) -> f64 {
        let surface = self.surface;
        let used = |h: HalfEdgeId| {
            if surface.is_boundary_face(surface.topology().face(h)) { PI } else { self.corner_angle(h) }
        };
        TAU - surface.outgoing_half_edges(v).map(used).sum::<f64>()
    }

    /// See [`Polyhedron::total_deficit`]. O(V + E).
    #[must_use]
    pub fn total_deficit(&self) -> f64 {
        self.surface.vertices().map(|v| self.deficit_angle(v)).sum()
    }

    /// See [`Polyhedron::vertex_area`].
    #[must_use]
    pub fn vertex_area(&self, v: VertexId) -> f64 {
        let surface = self.surface;
        let share = |f: FaceId| length(self.vector_of(f)) / self.size_of(f) as f64;
        surface.incident_faces(v).filter(|&f| !surface.is_boundary_face(f)).map(share).sum()
    }

    /// See [`Polyhedron::gauss_curvature`].
    #[must_use]
    pub fn gauss_curvature(&self, v: VertexId) -> Option<f64> {
        let area = self.vertex_area(v);
        (area > 0.0).then(|| self.deficit_angle(v) / area)
    }

    /// See [`Polyhedron::mean_curvature`].
    #[must_use]
    pub fn mean_curvature(&self, v: VertexId) -> Option<f64> {
        let surface = self.surface;
        let area = self.vertex_area(v);
        let bend = |h: HalfEdgeId| Some((PI - self.dihedral_angle(h.edge())?) * length(surface.edge_vector(h)) / 4.0);
        (area > 0.0).then(|| surface.outgoing_half_edges(v).filter_map(bend).sum::<f64>() / area)
    }

    /// Of a face: as it was seen, or as it is looked at now.
    fn vector_of(&self, f: FaceId) -> Vector {
        self.seen.as_ref().map_or_else(|| self.surface.area_vector(f), |(vectors, _)| vectors[f])
    }

    fn size_of(&self, f: FaceId) -> usize {
        self.seen.as_ref().map_or_else(|| self.surface.incident_half_edges(f).count(), |(_, sizes)| sizes[f] as usize)
    }
}
