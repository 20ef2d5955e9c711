//! Delaunay triangulations: no vertex lies inside the circle round a triangle.
//!
//! ```text
//!        c                 The edge a-b is *locally Delaunay* if d does not lie inside the circle through a, b, c.
//!      ╱   ╲               If it does, the other diagonal c-d is the better one: flip. A triangulation in which all
//!    a ───── b             edges are locally Delaunay is a Delaunay triangulation.
//!      ╲   ╱
//!        d                 halves.rs  half-edges in the making     order.rs  near points near each other
//!                          divide.rs  of points alone              lawson.rs  of a triangulation, by flips
//!                          constrained.rs  with edges that have to stay
//! ```
//!
//! Every decision is exact. With four points on a circle there are several Delaunay triangulations. Which one is
//! made of points alone depends on their places, not on their order.
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., chapter 9.

mod constrained;
mod divide;
mod halves;
mod lawson;
mod order;

pub use constrained::ConstrainedDelaunay;
pub use lawson::FlipEvent;

use super::{CoordinateError, Point, Subdivision};
use crate::geometry::threads::{both, pieces};
use crate::ids::{MAX_IDS, VertexId, VertexMap};
use crate::topology::{Columns, Dcel, InnerComponent, TooMany};
use divide::{Divided, divide_and_conquer, stage};
use order::{Ordered, ordered};

/// Why points have no Delaunay triangulation.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DelaunayError {
    /// A point whose coordinates cannot be used.
    #[error("point {point}: {error}")]
    Coordinate {
        /// The point, by its number from 0.
        point: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// More edges than ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// A Delaunay triangulation, and what became of each point.
#[derive(Clone, PartialEq, Debug)]
pub struct DelaunayBuilt {
    /// The triangulation. Its bounded faces are triangles that fill the convex hull; without three points off one
    /// line it is a path from one end of the line to the other, a vertex alone, or nothing.
    pub subdivision: Subdivision,
    /// The vertex of each point.
    pub vertices: Vec<VertexId>,
    /// Points at the place of an earlier one, each with that one, by number. They share its vertex.
    pub repeated: Vec<(u32, u32)>,
}

/// So many rows of a column are a piece of work.
const PIECE: usize = 1 << 14;

impl Subdivision {
    /// The Delaunay triangulation of points.
    ///
    /// Point i is v(i) if no point repeats an earlier one; else vertices are numbered in the order in which their
    /// places first come. Near edges and triangles get near numbers. The smallest half-edge at a vertex is its
    /// `outgoing`, the smallest one of a triangle its `half_edge`; triangles are numbered from 1 in their order.
    ///
    /// ```text
    ///   T = 2n - 2 - k triangles and 3n - 3 - k edges for n vertices, k of them on the hull
    /// ```
    ///
    /// Cost: O(n log n), for points spread evenly nearly O(n). All decisions are exact. With the feature `parallel` two
    /// threads and more make the parts of large sets.
    ///
    /// # Errors
    /// [`DelaunayError`] names the first point that cannot be used.
    ///
    /// Source: Guibas and Stolfi, *Primitives for the manipulation of general subdivisions and the computation of
    /// Voronoi diagrams*, 1985.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let points = [(0., 0.), (4., 0.), (4., 3.), (0., 3.), (2., 1.), (4., 0.)].map(Point::from);
    /// let built = Subdivision::delaunay(&points)?;
    /// assert_eq!(built.repeated, [(5, 1)]);
    /// let s = built.subdivision;
    /// assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (5, 8, 5));
    /// assert_eq!(s.non_delaunay_edges(|_| false).count(), 0);
    /// # Ok::<(), dcel_kit::plane::DelaunayError>(())
    /// ```
    pub fn delaunay(points: &[Point]) -> Result<DelaunayBuilt, DelaunayError> {
        if points.len() > MAX_IDS / 6 {
            return Err(TooMany.into());
        }
        for (i, point) in points.iter().enumerate() {
            point.check().map_err(|error| DelaunayError::Coordinate { point: i as u32, error })?;
        }
        let ordered = ordered(points);
        let stage = stage(&ordered);
        let named = || {
            let vertices = numbered(points.len(), &ordered);
            let mut places = vec![Point::default(); ordered.sites.len()];
            for (i, v) in vertices.iter().enumerate().rev() {
                // From the last on, so that the first of equal points stays: it may differ in the sign of a zero.
                places[v.index()] = points[i];
            }
            let names: Vec<u32> = ordered.sites.iter().map(|site| vertices[site.index as usize].number()).collect();
            (vertices, names, places)
        };
        let (divided, (vertices, names, places)) = both(|| divide_and_conquer(&ordered, &stage), named);
        drop(stage);
        let subdivision = assembled(divided, &names, places.into());
        Ok(DelaunayBuilt { subdivision, vertices, repeated: ordered.repeated })
    }
}

/// The vertex of each point: places in the order in which they first come.
fn numbered(count: usize, ordered: &Ordered) -> Vec<VertexId> {
    let mut vertices = Vec::with_capacity(count);
    let (mut repeated, mut next) = (ordered.repeated.iter().peekable(), 0);
    for i in 0..count as u32 {
        match repeated.next_if(|pair| pair.0 == i) {
            Some(&(_, first)) => vertices.push(vertices[first as usize]),
            None => {
                vertices.push(VertexId::new(next));
                next += 1;
            }
        }
    }
    vertices
}

/// The triangulation of ordered points, whose vertices have the given numbers and places; none of fewer than two. Numbers
/// without a point become isolated vertices that no face lists. O(n).
fn assembled(divided: Option<Divided>, names: &[u32], points: VertexMap<Point>) -> Subdivision {
    let vertices = points.len();
    let Some(divided) = divided else {
        let columns = Columns {
            origin: Vec::new(),
            next: Vec::new(),
            prev: Vec::new(),
            face: Vec::new(),
            outgoing: vec![Columns::NONE; vertices],
            boundary: vec![Columns::NONE],
        };
        let mut subdivision = Subdivision::from_parts(Dcel::from_columns(columns), points);
        if let &[v] = names {
            subdivision
                .inner_components
                .insert(subdivision.outer_face(), vec![InnerComponent::Isolated(VertexId::new(v))]);
        }
        return subdivision;
    };
    Subdivision::from_parts(with_faces(divided, names, vertices), points)
}

/// The finished structure: the outline bounds `f0`, every other cycle a triangle. O(n).
fn with_faces(Divided { mut origin, next, prev, outer }: Divided, names: &[u32], vertices: usize) -> Dcel {
    let named = || {
        // Places in the order are near each other; vertices need not be.
        let mut first_at = vec![Columns::NONE; names.len()];
        origin.iter().enumerate().rev().for_each(|(h, &place)| first_at[place as usize] = h as u32);
        let mut outgoing = vec![Columns::NONE; vertices];
        names.iter().zip(first_at).for_each(|(&name, h)| outgoing[name as usize] = h);
        pieces(&mut origin, PIECE, |_, origin| origin.iter_mut().for_each(|v| *v = names[*v as usize]));
        outgoing
    };
    let ((face, boundary), outgoing) = both(|| faces(&next, &prev, outer), named);
    Dcel::from_columns(Columns { origin, next, prev, face, outgoing, boundary })
}

/// The face of each half-edge, and the first half-edge of each face.
fn faces(next: &[u32], prev: &[u32], outer: u32) -> (Vec<u32>, Vec<u32>) {
    let mut outline = vec![outer];
    let mut h = next[outer as usize];
    while h != outer {
        outline.push(h);
        h = next[h as usize];
    }
    outline.sort_unstable();
    let mut face = vec![0; next.len()];
    // One place more than there are faces, see below.
    let mut boundary = vec![0; next.len() / 3 + 2];
    boundary[0] = outline[0];
    let mut count = 1;
    let mut outline = outline.into_iter().peekable();
    for (h, (&second, &third)) in (0..).zip(next.iter().zip(prev)) {
        if outline.next_if_eq(&h).is_some() {
            continue;
        }
        // Without a branch: which corner of its triangle is the first to come cannot be foreseen.
        let first = second.min(third);
        let is_first = h < first;
        let known = face[first.min(h.saturating_sub(1)) as usize];
        boundary[count] = h;
        face[h as usize] = if is_first { count as u32 } else { known };
        count += usize::from(is_first);
    }
    boundary.truncate(count);
    (face, boundary)
}
