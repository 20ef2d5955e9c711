//! The Schlegel diagram: a convex solid seen through one of its faces, as a subdivision of the plane.
//!
//! ```text
//!     ●─────────────────●
//!     │ ╲             ╱ │       The eye is just outside of the removed face and sees all others through it: they
//!     │   ●─────────●   │       fill it without gaps or overlaps. The removed face is f0, the outer one.
//!     │   │         │   │
//!     │   ●─────────●   │       The picture is that of a mirror: from inside, faces would run clockwise.
//!     │ ╱             ╲ │
//!     ●─────────────────●
//! ```
//!
//! Source: V. Schlegel, *Theorie der homogen zusammengesetzten Raumgebilde*, 1883.

use super::vector::{Vector, cross, dot, length, minus, times};
use super::{NotConvex, Polyhedron};
use crate::ids::{FaceId, FaceMap, VertexMap};
use crate::plane::{ConvertError, Point, Subdivision};
use crate::topology::{IdError, PolygonList};

/// Why there is no Schlegel diagram.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SchlegelError {
    /// The face does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// The solid is not convex, so that faces would hide each other.
    #[error(transparent)]
    NotConvex(#[from] NotConvex),
    /// Another face lies in the plane of the face, so that no eye is outside of this face alone.
    #[error(
        "{face} and {other} lie in one plane, so that nothing is seen through {face} alone: join the two, or look through a face whose neighbours all bend away"
    )]
    OnePlane {
        /// The face that was to be removed.
        face: FaceId,
        /// The other one.
        other: FaceId,
    },
    /// The solid is so thin that its picture folds when it is rounded.
    #[error("seen through {face}, faces fall together when they are rounded ({error}): try another face")]
    Rounded {
        /// The removed face.
        face: FaceId,
        /// What is wrong with the picture.
        error: ConvertError,
    },
}

/// A solid seen through one of its faces.
#[derive(Clone, PartialEq, Debug)]
pub struct Schlegel {
    /// The picture. Its outer face is the removed face.
    pub diagram: Subdivision,
    /// By vertex of the picture: the vertex of the solid.
    pub vertices: VertexMap<crate::ids::VertexId>,
    /// By face of the picture: the face of the solid.
    pub faces: FaceMap<FaceId>,
}

impl Polyhedron {
    /// The picture of a convex solid through `face`, in the coordinates of that face, its mean at the origin.
    ///
    /// Cost: that of [`check_convex`](Self::check_convex) and of building a subdivision.
    ///
    /// # Errors
    /// [`SchlegelError`]
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let cube = Polyhedron::platonic(Platonic::Cube);
    /// let seen = cube.schlegel(dcel_kit::FaceId::new(3))?;
    /// assert_eq!((seen.diagram.vertex_count(), seen.diagram.face_count()), (8, 6));
    /// assert_eq!(seen.faces[dcel_kit::FaceId::new(0)], dcel_kit::FaceId::new(3));
    /// # Ok::<(), dcel_kit::solid::SchlegelError>(())
    /// ```
    pub fn schlegel(&self, face: FaceId) -> Result<Schlegel, SchlegelError> {
        self.topology().check(face)?;
        self.check_convex()?;
        let eye = Eye::before(self, face).map_err(|other| SchlegelError::OnePlane { face, other })?;
        let mut numbers = VertexMap::filled(self.vertex_bound(), 0);
        self.vertices().zip(0..).for_each(|(v, i)| numbers[v] = i);
        let points = self.vertices().map(|v| eye.sees(self.point(v))).collect();
        let mut faces = FaceMap::default();
        faces.push(face);
        let mut polygons = PolygonList::new();
        for f in self.faces().filter(|&f| f != face) {
            let corners: Vec<u32> = self.incident_vertices(f).map(|v| numbers[v]).collect();
            polygons.push_face(&corners);
            faces.push(f);
        }
        let diagram =
            Subdivision::from_polygons(points, &polygons).map_err(|error| SchlegelError::Rounded { face, error })?;
        Ok(Schlegel { diagram, vertices: self.vertices().collect::<Vec<_>>().into(), faces })
    }
}

/// An eye so close to a face, as a part of its radius, is in its plane up to rounding.
const IN_PLANE: f64 = 1e-12;

/// Where the picture is taken from.
struct Eye {
    middle: Vector,
    outwards: Vector,
    right: Vector,
    up: Vector,
    distance: f64,
}

impl Eye {
    /// So close to the middle of the face that it is outside of this face alone; or the face that leaves no room for it.
    fn before(solid: &Polyhedron, face: FaceId) -> Result<Self, FaceId> {
        let middle = solid.face_mean(face);
        let outwards = solid.normal(face).unwrap_or([0.0, 0.0, 1.0]);
        let radius = solid.corners(face).map(|p| length(minus(p, middle))).fold(0.0, f64::max);
        // How far out the plane of another face is met.
        let met = solid.faces().filter(|&f| f != face).filter_map(|f| {
            let normal = solid.normal(f)?;
            let rise = dot(normal, outwards);
            let gap = dot(normal, minus(solid.face_mean(f), middle));
            (rise > 1e-12).then_some((gap / rise, f))
        });
        let (distance, nearest) =
            met.fold((2.5 * radius, face), |least, (far, f)| if 0.6 * far < least.0 { (0.6 * far, f) } else { least });
        if distance <= IN_PLANE * radius {
            return Err(nearest);
        }
        let first = solid.corners(face).next().map_or([1.0, 0.0, 0.0], |p| minus(p, middle));
        let along = minus(first, times(outwards, dot(first, outwards)));
        let right = times(along, 1.0 / length(along).max(f64::MIN_POSITIVE));
        // In the mirror, up is down.
        Ok(Self { middle, outwards, right, up: cross(right, outwards), distance })
    }

    fn sees(&self, p: Vector) -> Point {
        let p = minus(p, self.middle);
        let scale = self.distance / (self.distance - dot(p, self.outwards));
        Point::new(dot(p, self.right) * scale, dot(p, self.up) * scale)
    }
}
