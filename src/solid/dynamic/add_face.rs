//! Adding a face between vertices that are there.
//!
//! ```text
//!        in ╲   ╱ out         at each corner the two edges of the face are there already or new:
//!            v v
//!             ●               both there, out next of in     the gap closes
//!         gap                 both there, fans between       they move into another gap
//!                             one there                      the gap becomes narrower
//!                             both new                       a new fan opens in a gap
//! ```
//!
//! Inverse: [`remove_face`](Polyhedron::remove_face).

use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::topology::{IdError, NoRecorder, TooMany};

/// Why a face cannot be added.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AddFaceError {
    /// One of the corners does not exist.
    #[error(transparent)]
    Id(#[from] IdError),
    /// Fewer than three corners.
    #[error("a face with {corners} corner{}: three are needed; list its vertices counter-clockwise", if *.corners == 1 { "" } else { "s" })]
    TooFewCorners {
        /// How many were given.
        corners: usize,
    },
    /// A vertex was given twice.
    #[error("the face passes {vertex} twice: split it there into two faces")]
    RepeatedVertex {
        /// The vertex.
        vertex: VertexId,
    },
    /// A face runs along an edge in the same direction already; the other side of the edge is free.
    #[error(
        "{half_edge} from {from} to {to} bounds {face} already: list the corners the other way round, or turn {face}"
    )]
    AgainstWinding {
        /// The half-edge that is taken.
        half_edge: HalfEdgeId,
        /// Its origin.
        from: VertexId,
        /// Its destination.
        to: VertexId,
        /// Its face.
        face: FaceId,
    },
    /// Both sides of an edge have faces already.
    #[error("{edge} between {from} and {to} has two faces already, {} and {}: an edge has two sides; remove one face first", faces[0], faces[1])]
    EdgeFull {
        /// The edge.
        edge: EdgeId,
        /// One end.
        from: VertexId,
        /// The other end.
        to: VertexId,
        /// Its two faces.
        faces: [FaceId; 2],
    },
    /// Faces go all the way round a vertex, so that no gap is left for another fan.
    #[error("faces go all the way round {vertex}: no gap is left for one more; give the face a vertex of its own")]
    ClosedVertex {
        /// The vertex.
        vertex: VertexId,
    },
    /// The face would close one fan at a vertex while other faces touch the same vertex.
    #[error(
        "the face would close the faces round {vertex} from {in_half_edge} to {out_half_edge}, but other faces touch {vertex}, too: remove those, or give them a vertex of their own"
    )]
    ClosesFan {
        /// The vertex.
        vertex: VertexId,
        /// The border half-edge at which the fan starts.
        in_half_edge: HalfEdgeId,
        /// The border half-edge at which it ends.
        out_half_edge: HalfEdgeId,
    },
    /// The structure is full.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// What happens at one corner, between the half-edge `into` it and the one `out` of it.
#[derive(Clone, Copy)]
enum Corner {
    /// Both are there and follow each other.
    Closes,
    /// Both are there, and what stands between moves into the gap of this border half-edge.
    Joins(HalfEdgeId),
    /// Only the half-edge into the corner is there.
    After,
    /// Only the half-edge out of the corner is there.
    Before,
    /// Both are new; the gap of this border half-edge takes them.
    Opens(HalfEdgeId),
    /// Both are new, and the vertex has no edge.
    Alone,
}

/// A face that passed the checks: for each corner its vertex, the half-edge from there if it is there, and what
/// happens.
struct Plan {
    sides: Vec<Option<HalfEdgeId>>,
    corners: Vec<Corner>,
}

impl Polyhedron {
    /// Adds the face with these corners, counter-clockwise as seen from outside, and the edges that are not there
    /// yet. Returns the face; its `half_edge` runs from the first corner to the second.
    ///
    /// Cost: for each corner O(the smaller degree at its edge), and O(degree) where a gap closes; if border cycles
    /// are cut or joined, the length of the second longest stretch.
    ///
    /// # Errors
    /// [`AddFaceError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{solid::Polyhedron, topology::violations};
    /// let mut surface = Polyhedron::new();
    /// let v: Vec<_> = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]
    ///     .into_iter()
    ///     .map(|point| surface.add_vertex(point))
    ///     .collect::<Result<_, _>>()?;
    /// for [a, b, c] in [[0, 2, 1], [0, 1, 3], [1, 2, 3]] {
    ///     surface.add_face(&[v[a], v[b], v[c]])?;
    /// }
    /// assert_eq!(surface.boundary_faces().len(), 1);
    /// surface.add_face(&[v[2], v[0], v[3]])?;
    /// assert_eq!((surface.boundary_faces().len(), surface.edge_count()), (0, 6));
    /// assert!(violations(&surface).is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_face(&mut self, corners: &[VertexId]) -> Result<FaceId, AddFaceError> {
        self.add_face_with(corners, &mut NoRecorder)
    }

    /// [`add_face`](Self::add_face), watched by a recorder.
    pub fn add_face_with(
        &mut self,
        corners: &[VertexId],
        rec: &mut impl SurfaceRecorder,
    ) -> Result<FaceId, AddFaceError> {
        let plan = self.plan_face(corners)?;
        Ok(self.add_planned_face(corners, &plan, rec))
    }

    /// Whether [`add_face`](Self::add_face) would succeed, and if not, why. Changes nothing.
    pub fn can_add_face(&self, corners: &[VertexId]) -> Result<(), AddFaceError> {
        self.plan_face(corners).map(drop)
    }

    fn plan_face(&self, vertices: &[VertexId]) -> Result<Plan, AddFaceError> {
        let n = vertices.len();
        vertices.iter().try_for_each(|&v| self.dcel.check(v))?;
        if n < 3 {
            return Err(AddFaceError::TooFewCorners { corners: n });
        }
        if let Some(vertex) = repeated(vertices) {
            return Err(AddFaceError::RepeatedVertex { vertex });
        }
        let side = |i: usize| self.free_side(vertices[i], vertices[(i + 1) % n]);
        let sides = (0..n).map(side).collect::<Result<Vec<_>, _>>()?;
        let corner = |i: usize| self.plan_corner(vertices[i], sides[(i + n - 1) % n], sides[i]);
        let corners = (0..n).map(corner).collect::<Result<Vec<_>, _>>()?;
        let edges = sides.iter().filter(|side| side.is_none()).count();
        // Each corner can split off one border cycle at most.
        self.dcel.room_for(0, edges, 1 + n)?;
        Ok(Plan { sides, corners })
    }

    /// The border half-edge from `u` to `v`; none if there is no edge. The half-edges that leave both are walked in step, so that the
    /// smaller one decides what it costs.
    fn free_side(&self, u: VertexId, v: VertexId) -> Result<Option<HalfEdgeId>, AddFaceError> {
        let mut taken = None;
        let (mut from_u, mut from_v) = (self.dcel.outgoing_half_edges(u), self.dcel.outgoing_half_edges(v));
        while let (Some(a), Some(b)) = (from_u.next(), from_v.next()) {
            let forward = Some(a).filter(|&a| self.dcel.destination(a) == v);
            let backward = Some(b.twin()).filter(|&b| self.dcel.origin(b) == u);
            for h in [forward, backward].into_iter().flatten() {
                if self.is_border(h) {
                    return Ok(Some(h));
                }
                taken = Some(h);
            }
        }
        let Some(h) = taken else { return Ok(None) };
        let (face, behind) = (self.dcel.face(h), self.dcel.face(h.twin()));
        Err(if self.is_border(h.twin()) {
            AddFaceError::AgainstWinding { half_edge: h, from: u, to: v, face }
        } else {
            AddFaceError::EdgeFull { edge: h.edge(), from: u, to: v, faces: [face, behind] }
        })
    }

    fn plan_corner(
        &self,
        vertex: VertexId,
        into: Option<HalfEdgeId>,
        out: Option<HalfEdgeId>,
    ) -> Result<Corner, AddFaceError> {
        match (into, out) {
            (Some(into), Some(out)) if self.dcel.next(into) == out => Ok(Corner::Closes),
            (Some(into), Some(out)) => {
                let mut fan = self.dcel.star(into.twin()).take_while(|&h| h != out);
                let gap = fan.find(|&h| self.is_border(h));
                let refused = AddFaceError::ClosesFan { vertex, in_half_edge: into, out_half_edge: out };
                gap.map(Corner::Joins).ok_or(refused)
            }
            (Some(_), None) => Ok(Corner::After),
            (None, Some(_)) => Ok(Corner::Before),
            (None, None) if self.dcel.outgoing(vertex).is_none() => Ok(Corner::Alone),
            (None, None) => self.gap_at(vertex).map(Corner::Opens).ok_or(AddFaceError::ClosedVertex { vertex }),
        }
    }

    fn add_planned_face(&mut self, vertices: &[VertexId], plan: &Plan, rec: &mut impl SurfaceRecorder) -> FaceId {
        let n = vertices.len();
        let face = self.dcel.add_face_record(rec);
        let mut touched = Vec::with_capacity(n);
        let mut sides = Vec::with_capacity(n);
        for (i, &side) in plan.sides.iter().enumerate() {
            sides.push(side.unwrap_or_else(|| {
                let [forward, backward] = self.dcel.add_edge_record(rec).half_edges();
                self.dcel.set_origin(forward, vertices[i], rec);
                self.dcel.set_origin(backward, vertices[(i + 1) % n], rec);
                forward
            }));
            touched.extend(side.map(|h| self.dcel.face(h)));
        }
        let mut starts = Vec::with_capacity(2 * n);
        for (i, &corner) in plan.corners.iter().enumerate() {
            self.link_corner(sides[(i + n - 1) % n], sides[i], corner, &mut starts, rec);
        }
        for &h in &sides {
            self.dcel.set_face(h, face, rec);
        }
        self.dcel.set_half_edge(face, Some(sides[0]), rec);
        self.renew_borders(starts, touched, rec);
        for (i, &v) in vertices.iter().enumerate() {
            self.point_to_gap(v, sides[(i + n - 1) % n], sides[i], plan.corners[i], rec);
        }
        face
    }

    /// Makes `out` follow `into`, and closes the border round them. Only pointers at this vertex are read and
    /// written, so the corners of a face do not disturb each other.
    fn link_corner(
        &mut self,
        into: HalfEdgeId,
        out: HalfEdgeId,
        corner: Corner,
        starts: &mut Vec<HalfEdgeId>,
        rec: &mut impl SurfaceRecorder,
    ) {
        let dcel = &mut self.dcel;
        let mut link = |before: HalfEdgeId, after: HalfEdgeId, rest: &mut crate::topology::Dcel| {
            rest.set_next(before, after, rec);
            starts.push(after);
        };
        match corner {
            Corner::Closes => return,
            Corner::Joins(gap) => {
                let (first, last) = (dcel.next(into), dcel.prev(out));
                link(dcel.prev(gap), first, dcel);
                link(last, gap, dcel);
            }
            Corner::After => link(out.twin(), dcel.next(into), dcel),
            Corner::Before => link(dcel.prev(out), into.twin(), dcel),
            Corner::Opens(gap) => {
                link(dcel.prev(gap), into.twin(), dcel);
                link(out.twin(), gap, dcel);
            }
            Corner::Alone => link(out.twin(), into.twin(), dcel),
        }
        dcel.set_next(into, out, rec);
    }

    /// Lets `outgoing(v)` be a border half-edge if there is one, so that the next face finds a gap at once.
    fn point_to_gap(
        &mut self,
        v: VertexId,
        into: HalfEdgeId,
        out: HalfEdgeId,
        corner: Corner,
        rec: &mut impl SurfaceRecorder,
    ) {
        let gap = match corner {
            Corner::Closes if self.dcel.outgoing(v) == Some(out) => self.gap_at(v).or(Some(out)),
            Corner::Closes => return,
            Corner::Joins(gap) => Some(gap),
            Corner::After => Some(self.dcel.next(out.twin())),
            Corner::Before | Corner::Opens(_) | Corner::Alone => Some(into.twin()),
        };
        self.dcel.set_outgoing(v, gap, rec);
    }
}

/// The first vertex that stands twice in the list.
fn repeated(vertices: &[VertexId]) -> Option<VertexId> {
    const SHORT: usize = 16;
    if vertices.len() <= SHORT {
        return (1..vertices.len()).find(|&i| vertices[..i].contains(&vertices[i])).map(|i| vertices[i]);
    }
    let mut sorted: Vec<(VertexId, usize)> = vertices.iter().copied().zip(0..).collect();
    sorted.sort_unstable();
    let seconds = sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1);
    seconds.min().map(|i| vertices[i])
}
