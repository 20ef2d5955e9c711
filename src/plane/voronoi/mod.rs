//! Voronoi diagrams: the dual of a Delaunay triangulation.
//!
//! ```text
//!          ·  p                    The edge p-q of the triangulation becomes the edge between the centres of the
//!        ╱   ╲     q               circles of its two triangles: on it, p and q are equally near. With f0 on one
//!       ╱  ●──┼──·                 side it runs on for ever. Triangles on one circle have one centre together, a
//!      · ──┼──  ╱                  vertex of degree greater than 3: that is decided exactly, only the place of
//!          ●   ╱                   the centre is rounded.
//!
//!      mod.rs    corners and edges          window.rs  what of an edge lies in a window
//!      cells.rs  the cells in a window      known.rs   the same, put together from the diagram
//! ```
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., chapter 7 and section 9.2.

mod cells;
mod known;
mod window;

pub use cells::VoronoiCells;
pub use window::Window;

use super::{CoordinateError, Point, SMALLEST, SegmentsError, Subdivision};
use crate::geometry::predicates::{in_circle, orientation, twice_area};
use crate::ids::{EdgeId, EdgeMap, FaceId, FaceMap, HalfEdgeId, VertexId};
use std::cmp::Ordering;

/// Why there is no Voronoi diagram.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VoronoiError {
    /// The subdivision has no vertex.
    #[error("there is no site: a diagram needs at least one vertex")]
    NoSite,
    /// A bounded face that is no triangle.
    #[error("{face} is no triangle: take the diagram of a Delaunay triangulation, as Subdivision::delaunay makes it")]
    NotTriangle {
        /// The face.
        face: FaceId,
    },
    /// The bounded faces do not fill the convex hull of all vertices.
    #[error("the outline turns inwards at {vertex}, or is not the only one: triangulate the whole convex hull")]
    NotConvex {
        /// A vertex at which something of the hull is missing.
        vertex: VertexId,
    },
    /// An edge is not locally Delaunay.
    #[error("{edge} is not locally Delaunay: flip it, or all such edges with make_delaunay")]
    NotDelaunay {
        /// The first such edge.
        edge: EdgeId,
    },
    /// A bound of the window cannot be used.
    #[error("the window: {0}")]
    Coordinate(CoordinateError),
    /// The window has no inside.
    #[error("the window from {low} to {high} has no inside: its lower left corner comes first")]
    EmptyWindow {
        /// Its lower left corner.
        low: Point,
        /// Its upper right corner.
        high: Point,
    },
    /// A site lies on the border of the window or outside of it.
    #[error("{site} at {point} does not lie inside the window: make it larger")]
    SiteOutside {
        /// The first such site.
        site: VertexId,
        /// Where it is.
        point: Point,
    },
    /// Rounded corners put a site out of its cell, or two into one.
    #[error(
        "{site} and {other} are so close that doubles cannot hold an edge between them: move the sites near 0 and scale them up"
    )]
    TooClose {
        /// A site.
        site: VertexId,
        /// The site whose cell it falls into, or touches; itself, if that is none.
        other: VertexId,
    },
    /// The edges could not be settled.
    #[error(transparent)]
    Segments(#[from] SegmentsError),
}

/// An edge of a Voronoi diagram: the points to which two sites are equally near, and no other is nearer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VoronoiEdge {
    /// The edge of the triangulation between the two sites.
    pub dual: EdgeId,
    /// The site on the left, then the one on the right.
    pub sites: [VertexId; 2],
    /// The corners from which it comes and to which it runs, by number; none: it comes from infinity, or runs there.
    pub ends: [Option<u32>; 2],
}

/// The Voronoi diagram of the vertices of a Delaunay triangulation, not cut to any window.
#[derive(Clone, PartialEq, Debug)]
pub struct Voronoi<'a> {
    delaunay: &'a Subdivision,
    corners: Vec<Point>,
    corner_of: FaceMap<Option<u32>>,
    edges: Vec<VoronoiEdge>,
}

impl Subdivision {
    /// The Voronoi diagram whose sites are the vertices of this Delaunay triangulation.
    ///
    /// Which corners and edges there are is exact: triangles whose corners lie on one circle share one corner of the
    /// diagram. The places of the corners are rounded.
    ///
    /// Cost: O(n).
    ///
    /// # Errors
    /// [`VoronoiError`]: this is no Delaunay triangulation of its convex hull, or has no vertex. A path of points on
    /// one line is one.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision, Window};
    /// let square = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(Point::from);
    /// let delaunay = Subdivision::delaunay(&square)?.subdivision;
    /// let voronoi = delaunay.voronoi()?;
    /// assert_eq!(voronoi.corners(), [Point::new(1., 1.)]); // of degree 4
    /// assert_eq!(voronoi.edges().len(), 4);
    /// let cells = voronoi.cells(Window::around(&square))?;
    /// assert_eq!(cells.subdivision.face_count(), 5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn voronoi(&self) -> Result<Voronoi<'_>, VoronoiError> {
        let on_circle = self.check_delaunay()?;
        let (corner_of, corners) = self.centres(&on_circle);
        let mut edges = Vec::with_capacity(self.dcel.edge_count());
        for dual in self.dcel.edges() {
            let [h, t] = dual.half_edges();
            let ends = [corner_of[self.dcel.face(t)], corner_of[self.dcel.face(h)]];
            if ends[0] != ends[1] || ends[0].is_none() {
                edges.push(VoronoiEdge { dual, sites: [self.dcel.origin(h), self.dcel.origin(t)], ends });
            }
        }
        Ok(Voronoi { delaunay: self, corners, corner_of, edges })
    }

    /// Whether this is a Delaunay triangulation of the convex hull of its vertices; then, whether the triangles at each
    /// edge have one circle. O(n).
    fn check_delaunay(&self) -> Result<EdgeMap<bool>, VoronoiError> {
        let first = self.dcel.vertices().next().ok_or(VoronoiError::NoSite)?;
        let single = self.dcel.vertex_count() == 1;
        if let Some(face) = self.dcel.faces().skip(1).find(|&f| {
            let around = |h: HalfEdgeId| self.dcel.next(self.dcel.next(self.dcel.next(h)));
            self.dcel.half_edge(f).is_none_or(|h| around(h) != h || self.dcel.next(h) == h)
                || !self.inner_components(f).is_empty()
        }) {
            return Err(VoronoiError::NotTriangle { face });
        }
        if let Some(&ring) = self.inner_components(self.outer_face()).first().filter(|_| !single) {
            return Err(VoronoiError::NotConvex { vertex: self.inner_component_vertex(ring) });
        }
        let inwards = |&h: &HalfEdgeId| {
            let [u, v, w] = [self.dcel.prev(h), h, self.dcel.next(h)].map(|h| self.points[self.dcel.origin(h)]);
            orientation(u, v, w).is_gt()
        };
        if let Some(h) = self.dcel.incident_half_edges(self.outer_face()).find(inwards) {
            return Err(VoronoiError::NotConvex { vertex: self.dcel.origin(h) });
        }
        if !single && self.dcel.half_edge(self.outer_face()).is_none() {
            return Err(VoronoiError::NotConvex { vertex: first });
        }
        // A hole beside the domain hides nothing here.
        let mut on_circle = EdgeMap::filled(self.dcel.edge_bound(), false);
        for edge in self.dcel.edges() {
            match self.quadrilateral(edge).map(|[a, b, c, d]| in_circle(a, b, c, d)) {
                Some(Ordering::Greater) => return Err(VoronoiError::NotDelaunay { edge }),
                side => on_circle[edge] = side == Some(Ordering::Equal),
            }
        }
        Ok(on_circle)
    }

    /// The corners a, b, c, d of the triangles at an edge a-b, with c on its left; none on the outline.
    fn quadrilateral(&self, e: EdgeId) -> Option<[Point; 4]> {
        let [h, t] = e.half_edges();
        let is_inside = |h: HalfEdgeId| self.dcel.face(h) != self.outer_face();
        let from = |h: HalfEdgeId| self.points[self.dcel.origin(h)];
        (is_inside(h) && is_inside(t)).then(|| [from(h), from(t), from(self.dcel.prev(h)), from(self.dcel.prev(t))])
    }

    /// The corner of each triangle, and the places of the corners: one for all triangles on the same circle. O(n).
    fn centres(&self, on_circle: &EdgeMap<bool>) -> (FaceMap<Option<u32>>, Vec<Point>) {
        let mut corner_of: FaceMap<Option<u32>> = FaceMap::filled(self.dcel.face_bound(), None);
        let mut corners = Vec::with_capacity(self.dcel.face_count());
        let mut waiting = Vec::new();
        for first in self.dcel.faces().skip(1) {
            if corner_of[first].is_some() {
                continue;
            }
            let mine = Some(corners.len() as u32);
            corner_of[first] = mine;
            corners.push(self.circle_centre(first));
            waiting.push(first);
            while let Some(f) = waiting.pop() {
                for h in self.dcel.incident_half_edges(f) {
                    if !on_circle[h.edge()] {
                        continue;
                    }
                    // No edge of the outline is marked.
                    let beside = self.dcel.face(h.twin());
                    if corner_of[beside].is_none() {
                        corner_of[beside] = mine;
                        waiting.push(beside);
                    }
                }
            }
        }
        (corner_of, corners)
    }

    /// The centre of the circle round a triangle, rounded: relative to one corner, so that it does not suffer from
    /// being far from 0; of a needle it may lie beyond all numbers.
    fn circle_centre(&self, f: FaceId) -> Point {
        let mut corners = self.dcel.incident_vertices(f).map(|v| self.points[v]);
        let (Some(a), Some(b), Some(c)) = (corners.next(), corners.next(), corners.next()) else {
            return Point::default();
        };
        let (p, q) = (Point::new(b.x - a.x, b.y - a.y), Point::new(c.x - a.x, c.y - a.y));
        let (pp, qq) = (p.x * p.x + p.y * p.y, q.x * q.x + q.y * q.y);
        let area = 2.0 * twice_area(a, b, c);
        let place = |from: f64, by: f64| {
            let x = from + by / area;
            if x.abs() < SMALLEST { 0.0 } else { x }
        };
        Point::new(place(a.x, q.y * pp - p.y * qq), place(a.y, p.x * qq - q.x * pp))
    }
}

impl<'a> Voronoi<'a> {
    /// The triangulation.
    #[must_use]
    pub fn delaunay(&self) -> &'a Subdivision {
        self.delaunay
    }

    /// The corners: centres of empty circles through three sites or more. Rounded; those of needles may lie very
    /// far out, and not even be finite.
    #[must_use]
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// The corner that stands for a triangle; none for `f0`.
    #[must_use]
    pub fn corner_of(&self, f: FaceId) -> Option<u32> {
        *self.corner_of.get(f)?
    }

    /// The edges, in the order of their duals. Edges of the triangulation inside one circle have none.
    #[must_use]
    pub fn edges(&self) -> &[VoronoiEdge] {
        &self.edges
    }

    /// A point of an edge and its direction: the middle of its two sites, and the difference of the sites turned by a
    /// right angle. Every point of the edge is the middle plus a multiple of the direction.
    #[must_use]
    pub fn line(&self, edge: &VoronoiEdge) -> [Point; 2] {
        let [p, q] = edge.sites.map(|v| self.delaunay.point(v));
        // Halves first, so that nothing overflows and equal coordinates stay as they are.
        let middle = Point::new(0.5 * p.x + 0.5 * q.x, 0.5 * p.y + 0.5 * q.y);
        [middle, Point::new(p.y - q.y, q.x - p.x)]
    }
}
