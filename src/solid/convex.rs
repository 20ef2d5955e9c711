//! Whether a surface bounds a convex solid. Exact.
//!
//! ```text
//!        c ●──────● b               d is not above a, b, c: the edge is convex or flat
//!           ╲  f   ╲                (with f the left face, d a corner of the right face g)
//!            ╲    h ^
//!             ●─────● a             One piece, closed, no handles, convex faces, no reflex edge:
//!               g                   then the solid is convex.
//!           d ●
//! ```
//!
//! Why the local test is enough: the normals of a surface without reflex edges never turn back, so they cover the
//! sphere evenly, and without handles once.
//!
//! Faces that are flat only up to rounding count as bent: then every corner of the one face and every corner of the
//! other must fit, so that the test speaks for the exact hull of the corners, whichever way such a face is creased.
//! Of each face the highest corner beside the edge is enough, see `wings.rs`.

use super::Polyhedron;
use super::flat::{FaceFault, Shadow};
use super::measure::PartCounts;
use super::predicates::{are_collinear, orient3d};
use super::vector::Vector;
use super::wings::{Wings, other_corners};
use crate::ids::{EdgeId, Element, FaceId, FaceMap, HalfEdgeId, VertexId};
use crate::plane::predicates::orientation;
use std::cmp::Ordering;

/// Why a surface does not bound a convex solid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotConvex {
    /// There is no face.
    #[error("there is no face: a solid needs at least four")]
    Empty,
    /// The surface has a border.
    #[error("the surface has a border at {boundary_face}: fill it with faces first")]
    Open {
        /// A boundary face.
        boundary_face: FaceId,
    },
    /// The surface has several pieces, or isolated vertices.
    #[error("{vertex} and {other} belong to different pieces: take one piece, or the convex hull of all")]
    Pieces {
        /// A vertex.
        vertex: VertexId,
        /// A vertex of another piece.
        other: VertexId,
    },
    /// The surface has handles.
    #[error("the surface has handles ({handles}): a convex solid has none")]
    Handles {
        /// How many.
        handles: i64,
    },
    /// A face without area.
    #[error("the corners of {face} lie on one line: join the face to its neighbour")]
    NoArea {
        /// The face.
        face: FaceId,
    },
    /// A face that is not convex.
    #[error(
        "{face} has a reflex corner at {vertex}, the origin of {half_edge}: split the face there (dcel solid split), or take the convex hull of all vertices (dcel solid make hull)"
    )]
    ReflexCorner {
        /// The face.
        face: FaceId,
        /// The corner.
        vertex: VertexId,
        /// The half-edge of the face that starts there.
        half_edge: HalfEdgeId,
    },
    /// The solid is bent inwards along an edge, or folded back.
    #[error("the solid is reflex at {edge} from {from} to {to}, between {} and {}: take the convex hull of its vertices, or move one of them", faces[0], faces[1])]
    ReflexEdge {
        /// The edge.
        edge: EdgeId,
        /// Where its even half starts.
        from: VertexId,
        /// Where its even half ends.
        to: VertexId,
        /// The faces of its two halves.
        faces: [FaceId; 2],
    },
}

impl NotConvex {
    /// The elements that it is about.
    #[must_use]
    pub fn elements(&self) -> Vec<Element> {
        match *self {
            Self::Empty | Self::Handles { .. } => Vec::new(),
            Self::Open { boundary_face } => vec![boundary_face.into()],
            Self::Pieces { vertex, other } => vec![vertex.into(), other.into()],
            Self::NoArea { face } => vec![face.into()],
            Self::ReflexCorner { face, vertex, .. } => vec![face.into(), vertex.into()],
            Self::ReflexEdge { edge, faces: [f, g], .. } => vec![f.into(), g.into(), edge.into()],
        }
    }
}

/// A surface that is known to bound a convex solid; it cannot be edited while this exists.
#[derive(Clone, Debug)]
pub struct Convex<'a> {
    pub(super) solid: &'a Polyhedron,
    /// The faces that are not exactly flat.
    pub(super) bent: FaceMap<bool>,
    pub(super) first: VertexId,
}

impl Convex<'_> {
    /// The surface.
    #[must_use]
    pub fn solid(&self) -> &Polyhedron {
        self.solid
    }
}

impl Polyhedron {
    /// Checks that the surface bounds a convex solid; flat edges, and vertices in flat places, are allowed.
    ///
    /// Cost: O(V + E + F) if the faces are exactly flat. A bent face of n corners costs O(n log n), and O(n) for each
    /// of its edges that goes straight on into the next one up to rounding.
    ///
    /// # Errors
    /// [`NotConvex`] names the first edge, face or corner in the way.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let solid = Polyhedron::platonic(Platonic::Dodecahedron);
    /// let top = solid.check_convex()?.support([0.0, 0.0, 1.0].try_into()?);
    /// assert!(solid.vertices().all(|v| solid.point(v)[2] <= solid.point(top)[2]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check_convex(&self) -> Result<Convex<'_>, NotConvex> {
        if let Some(boundary_face) = self.boundary_faces().next() {
            return Err(NotConvex::Open { boundary_face });
        }
        let first = match self.parts()[..] {
            [PartCounts { edges: 0, .. }] | [] => return Err(NotConvex::Empty),
            [part] if part.genus() > 0 => return Err(NotConvex::Handles { handles: part.genus() }),
            [part] => part.first_vertex,
            [a, b, ..] => return Err(NotConvex::Pieces { vertex: a.first_vertex, other: b.first_vertex }),
        };
        let mut bent = FaceMap::filled(self.face_bound(), false);
        let mut looks = FaceMap::filled(self.face_bound(), None);
        for face in self.faces() {
            self.check_convex_face(face).map_err(|fault| match fault {
                FaceFault::NoArea => NotConvex::NoArea { face },
                FaceFault::Reflex(half_edge) => {
                    NotConvex::ReflexCorner { face, vertex: self.topology().origin(half_edge), half_edge }
                }
            })?;
            let corners = self.spanning_corners(face).ok_or(NotConvex::NoArea { face })?;
            bent[face] = !self.is_in_plane(face, corners);
            looks[face] = Some(Look { shadow: self.shadow(face), corners });
        }
        let wings = Wings::new(self, &bent);
        for edge in self.edges() {
            if !self.is_convex_edge(edge, &bent, &looks, &wings) {
                let [from, to] = edge.half_edges().map(|h| self.topology().origin(h));
                let faces = edge.half_edges().map(|h| self.topology().face(h));
                return Err(NotConvex::ReflexEdge { edge, from, to, faces });
            }
        }
        Ok(Convex { solid: self, bent, first })
    }

    fn is_convex_edge(&self, edge: EdgeId, bent: &FaceMap<bool>, looks: &FaceMap<Option<Look>>, wings: &Wings) -> bool {
        let dcel = self.topology();
        let halves = edge.half_edges();
        let faces = halves.map(|h| dcel.face(h));
        let [Some(left), Some(right)] = faces.map(|f| looks[f]) else { return false };
        let [a, b] = halves.map(|h| self.point(dcel.origin(h)));
        let fits = |c: Vector, d: Vector| match orient3d(a, b, c, d) {
            Ordering::Less => true,
            Ordering::Greater => false,
            // In one plane: the faces must lie on both sides of the edge.
            Ordering::Equal => {
                let [a, b, d] = [a, b, d].map(|p| left.shadow.of(p));
                orientation(a, b, d) != Ordering::Greater
            }
        };
        let [h, twin] = halves;
        if !bent[faces[0]] && !bent[faces[1]] {
            // Any corner of a flat face that is not in line with the edge stands for all.
            let apex = |look: Look| look.corners.into_iter().find(|&p| !are_collinear(a, b, p));
            return matches!((apex(left), apex(right)), (Some(c), Some(d)) if fits(c, d));
        }
        match (wings.highest(self, h, left.shadow), wings.highest(self, twin, right.shadow)) {
            (Some(c), Some(d)) => fits(c, d),
            _ => {
                let corners = |h: HalfEdgeId| other_corners(self, h).filter(|&p| !are_collinear(a, b, p));
                corners(h).all(|c| corners(twin).all(|d| fits(c, d)))
            }
        }
    }
}

/// What is asked of a face at each of its edges.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Look {
    shadow: Shadow,
    /// Three that are not in line.
    corners: [Vector; 3],
}
