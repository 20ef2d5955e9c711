//! Whole structures from lists of faces.
//!
//! ```text
//!   input, in order                       output
//!     face 0 = (0, 1, 2)                    v0 v1 v2 v3     as numbered in the input
//!     face 1 = (2, 1, 3)                    f0 f1           as numbered in the input
//!
//!       2 ●──────● 3                        e0 = 0 -> 1, e1 = 1 -> 2, e2 = 2 -> 0,  met in face 0
//!         │\  f1 │                          e3 = 1 -> 3, e4 = 3 -> 2                met in face 1
//!         │  \   │                          The even half of an edge is the one met first: h2 runs
//!         │ f0 \ │                          1 -> 2 in f0, its twin h3 runs 2 -> 1 in f1.
//!       0 ●──────● 1                        h1, h5, h7, h9: the outside, one more face (f2).
//! ```
//!
//! Each corner of a face becomes a half-edge. Whether its twin has been there before is found without hashing,
//! in one go if the numbers are local (`streamed.rs`), else after bringing twins together (`bucketed.rs`); both give
//! the same structure. That the faces round each vertex form one fan is checked by walking round the vertices
//! (`fans.rs`). If anything is wrong, a second, slower look finds out what (`diagnose.rs`).
//!
//! ```text
//!   error.rs  Why a list of faces is not a surface
//! ```

mod bucketed;
mod diagnose;
mod error;
mod faces;
mod fans;
mod streamed;

use super::links::Columns;
use super::{Dcel, PolygonList, TooMany};
use crate::ids::{FaceId, VertexId};
use bucketed::bucketed;
pub use error::BuildError;
pub(crate) use faces::Faces;
use streamed::streamed;

/// A structure made from a list of faces.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Built {
    /// The structure. No half-edge lacks a face.
    pub dcel: Dcel,
    /// The faces that were added to fill the border of the surface, one for each border cycle. They are
    /// numbered after the faces of the input, in the order of the smallest half-edge of each cycle.
    pub boundary_faces: Vec<FaceId>,
}

impl Dcel {
    /// The structure of a list of triangles over the vertices `0 .. vertices`.
    ///
    /// Vertices and faces keep their numbers. Edges are numbered as the triangles in order first meet them
    /// (`0 -> 1`, `1 -> 2`, `2 -> 0` of each), and the even half of an edge is the one met first. `half_edge(f)`
    /// is the half-edge from the first to the second corner. Where the surface ends, each border cycle gets
    /// a face of its own, and `outgoing(v)` of a vertex there is its half-edge on that border; elsewhere it is the
    /// one in the first face that uses `v`. A vertex that no face uses stays, isolated.
    ///
    /// Faces may form any oriented surface: closed or with borders, of any genus, in any number of pieces.
    ///
    /// Cost: O(vertices + faces) time and memory, whatever the order and the degrees, up to a logarithm for
    /// numberings made to hurt. `benches/README.md` has measurements.
    ///
    /// Source: that the corners of a triangle list stand for its half-edges is from Campagna, Kobbelt and Seidel,
    /// *Directed Edges*, 1998.
    ///
    /// # Errors
    /// [`BuildError`] names the faces and vertices that do not fit.
    ///
    /// ```
    /// use dcel_kit::topology::{BuildError, Dcel};
    /// let built = Dcel::from_triangles(4, &[[0, 1, 2], [2, 1, 3]])?;
    /// assert_eq!((built.dcel.edge_count(), built.dcel.face_count()), (5, 3));
    /// assert_eq!(built.boundary_faces, [dcel_kit::FaceId::new(2)]);
    ///
    /// let turned = Dcel::from_triangles(4, &[[0, 1, 2], [1, 2, 3]]).unwrap_err();
    /// assert_eq!(turned, BuildError::MixedWinding { u: 1, v: 2, first: 0, second: 1 });
    /// # Ok::<(), BuildError>(())
    /// ```
    pub fn from_triangles(vertices: usize, triangles: &[[u32; 3]]) -> Result<Built, BuildError> {
        build_kernel(vertices, triangles)
    }

    /// The structure of a list of polygons over the vertices `0 .. vertices`; otherwise as
    /// [`from_triangles`](Self::from_triangles). Polygons with holes are refused.
    ///
    /// # Errors
    /// [`BuildError`] names the faces and vertices that do not fit.
    pub fn from_polygons(vertices: usize, polygons: &PolygonList) -> Result<Built, BuildError> {
        let extra = (0..polygons.face_count()).find(|&face| polygons.cycle_range(face).len() > 1);
        match extra {
            Some(face) => Err(BuildError::HoleInFace { face: face as u32 }),
            None => build_kernel(vertices, polygons),
        }
    }
}

fn build_kernel<F: Faces + ?Sized>(vertices: usize, faces: &F) -> Result<Built, BuildError> {
    let mut matched = match_faces(vertices, faces, 0)?;
    if let Some(&v) = matched.pinched.first() {
        return Err(matched.fans_at(v));
    }
    let cycles = matched.border_cycles();
    let boundary_faces = cycles.iter().map(|&h| matched.add_border_face(h)).collect::<Result<_, _>>()?;
    Ok(Built { dcel: Dcel::from_columns(matched.columns), boundary_faces })
}

/// The faces of a list, glued along their common edges; the outside of the border has no face yet.
///
/// Both halves of every edge are there. Half-edges of input faces are complete. A border half-edge has an
/// origin and no face; its `next` and `prev` are set except at [`pinched`](Self::pinched) vertices.
pub(crate) struct Matched {
    pub(crate) columns: Columns,
    /// The half-edges without a face, in increasing order.
    pub(crate) border: Vec<u32>,
    /// The vertices whose faces are not one fan, in increasing order: several border gaps, several closed
    /// fans, or both kinds. There the links between border half-edges are missing.
    pub(crate) pinched: Vec<VertexId>,
    /// How many vertices no face uses.
    pub(crate) isolated: usize,
    /// The number of the first input face.
    first_face: u32,
}

/// Glues `faces` together. Input face i becomes f(i + `first_face`); the face records before are left empty.
///
/// Everything is checked but what happens at the vertices: see [`Matched::pinched`]. O(vertices + corners).
pub(crate) fn match_faces<F: Faces + ?Sized>(
    vertices: usize,
    faces: &F,
    first_face: u32,
) -> Result<Matched, BuildError> {
    TooMany::check(vertices, faces.corners().len(), faces.face_count() + first_face as usize)?;
    // What ends show, matching meets: it reads all of them anyway.
    if !F::SHOWN_BY_ENDS {
        faces.check_each(vertices)?;
    }
    let columns = match is_local(faces.corners()).then(|| streamed(faces, vertices, first_face)) {
        None | Some(Err(Stop::LongList)) => bucketed(faces, vertices, first_face),
        Some(done) => done,
    };
    match columns {
        Ok(columns) => Ok(Matched::new(columns, first_face)),
        Err(_) => {
            faces.check_each(vertices)?;
            Err(diagnose::clash(faces))
        }
    }
}

/// Room for so many faces beyond borders is made with the others.
const BORDERS: usize = 16;

/// Why matching stopped.
enum Stop {
    /// An end of a half-edge is no vertex, or both are the same.
    Ends,
    /// Two half-edges run in the same direction between the same vertices, or three share an edge.
    Clash,
    /// A list is too long to be searched.
    LongList,
}

/// Whether corners that follow each other in the input have near numbers, so that the lists in use are in the
/// cache: judged by a thousand places. O(1).
fn is_local(corners: &[u32]) -> bool {
    const SMALL: usize = 1 << 16;
    const SAMPLES: usize = 1024;
    const NEAR: u32 = 1 << 13;
    let jumps = || corners.windows(2).step_by(corners.len() / SAMPLES + 1).map(|pair| pair[0].abs_diff(pair[1]));
    corners.len() <= SMALL || 4 * jumps().filter(|&jump| jump < NEAR).count() >= 3 * jumps().count()
}
