//! A map without its margin: where the middle of an agent may be that is no point.
//!
//! ```text
//!   ┌──────────────────┐      Along every closed side the strip of the radius goes, and round every corner that
//!   │▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒│      stands out a piece of a disc. What is left is a map like any other: a point finds its
//!   │▒              ╱▒▒│      way through it just where the agent finds its way through the first one, by whatever
//!   │▒    ┌────────●   │      path algorithm.
//!   └─────┘ ▒▒▒▒▒▒▒▒▒▒▒
//! ```
//!
//! ```text
//!        f2 ●──────────────      An arc is drawn from outside, by tangents: as few as keep the tolerance. The first and the
//!          ╱      strip          last of them are the lines of the two strips themselves, so a corner that stands out is
//!      f1 ●  ·  r ┌────────      one vertex for each tangent between them, and one more.
//!         │     · │
//!         │ strip │  hole
//! ```
//!
//! So no way comes nearer than the radius, and nothing is lost that an agent of (1 + tolerance) times the radius could do.
//!
//! Source: Lozano-Pérez and Wesley, *An algorithm for planning collision-free paths among polyhedral obstacles*, 1979.

use super::{NavMesh, NavMeshError};
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::plane::predicates::{left_to_right, orientation};
use crate::plane::{ArrangeOptions, Point, SegmentsError, Subdivision, TriangulateError, TriangulationMethod};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

/// Why there is no map for an agent of a radius.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InsetError {
    /// The radius is no length.
    #[error("a radius of {radius}: give a positive number")]
    Radius {
        /// The radius.
        radius: f64,
    },
    /// The tolerance is no part of the radius.
    #[error("a tolerance of {tolerance}: give a part of the radius, from {} to 1", Inset::LEAST_TOLERANCE)]
    Tolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// The agent fits nowhere.
    #[error("an agent of radius {radius} fits nowhere on the map: try a smaller one")]
    NoRoom {
        /// The radius.
        radius: f64,
    },
    /// The strips cannot be cut out.
    #[error("the margin of {radius} cannot be cut off: {error}")]
    Cut {
        /// The radius.
        radius: f64,
        /// Why not.
        error: SegmentsError,
    },
    /// What is left cannot be cut into triangles.
    #[error("what the margin of {radius} leaves cannot be cut up: {error}")]
    Triangles {
        /// The radius.
        radius: f64,
        /// Why not.
        error: TriangulateError,
    },
    /// What is left is no navmesh.
    #[error(transparent)]
    Mesh(#[from] NavMeshError),
}

/// A map without the margin that an agent of a radius cannot use, cut into triangles. Its ids are its own.
#[derive(Clone, Debug)]
pub struct Inset {
    map: Subdivision,
    mesh: NavMesh,
    radius: f64,
    tolerance: f64,
}

impl Inset {
    /// By which part of the radius a path may be kept further off than the radius, if nothing else is said: the finest
    /// with which large maps grow to no more than three times their triangles.
    pub const TOLERANCE: f64 = 0.02;
    /// The least that can be asked for: a right angle then takes 556 tangents.
    pub const LEAST_TOLERANCE: f64 = 1e-6;

    /// The map that is left; what the margin cuts off or encloses is hole faces.
    #[must_use]
    pub fn map(&self) -> &Subdivision {
        &self.map
    }

    /// Its navmesh: for location, reach, and routes by any algorithm.
    #[must_use]
    pub fn mesh(&self) -> &NavMesh {
        &self.mesh
    }

    /// The radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// By which part of the radius a path may be kept further off than that, round corners.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The map and its navmesh, to be kept apart.
    #[must_use]
    pub fn into_parts(self) -> (Subdivision, NavMesh) {
        (self.map, self.mesh)
    }
}

impl NavMesh {
    /// The map without its margin: all points that are at least `radius` away from every closed side, be it a hole, a
    /// wall or a blocked face that lies behind.
    ///
    /// Every route through the inset keeps that distance (but for rounding), whatever the algorithm; the exact one is the
    /// shortest of those that keep off the tangents. It is no shorter than the shortest path at distance `radius`, and no
    /// longer than the shortest at distance 1 + [`TOLERANCE`](Inset::TOLERANCE) times that; if the latter exists, so
    /// does a route. For closer arcs see [`inset_within`](Self::inset_within).
    ///
    /// One inset serves any number of queries with that radius.
    ///
    /// Cost: O((n + k) log n) for n closed sides whose strips meet k times.
    ///
    /// # Errors
    /// [`InsetError`].
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner, PathAlgorithm};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let inset = NavMesh::new(&Subdivision::polygon(&hall)?)?.inset(1.0)?;
    /// assert!(inset.mesh().place(Point::new(0.5, 2.0)).is_err());
    /// let [a, b] = [Point::new(1.0, 1.0), Point::new(7.0, 3.0)];
    /// let route = Planner::new().route_between(inset.mesh(), PathAlgorithm::Exact, a, b)?;
    /// assert_eq!(route.length, 40f64.sqrt());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn inset(&self, radius: f64) -> Result<Inset, InsetError> {
        self.inset_within(radius, Inset::TOLERANCE)
    }

    /// [`inset`](Self::inset) with arcs that are at most `tolerance` times the radius too far out. A right angle takes
    /// two tangents at 0.1, three at 0.05, six at 0.01: as many vertices.
    ///
    /// # Errors
    /// [`InsetError`].
    pub fn inset_within(&self, radius: f64, tolerance: f64) -> Result<Inset, InsetError> {
        if !radius.is_finite() || radius <= 0.0 {
            return Err(InsetError::Radius { radius });
        }
        if !(Inset::LEAST_TOLERANCE..=1.0).contains(&tolerance) {
            return Err(InsetError::Tolerance { tolerance });
        }
        let mut outlines = Outlines { segments: Vec::new(), sides: 0 };
        let sides: Vec<[VertexId; 2]> = self.closed_sides().collect();
        for &[a, b] in &sides {
            outlines.add(&[self.point(a), self.point(b)]);
        }
        outlines.sides = outlines.segments.len();
        // The ends of each strip: moved out to where the first tangent beside it begins.
        let mut ends: BTreeMap<[VertexId; 2], [Point; 2]> =
            sides.iter().map(|&side| (side, beside(side.map(|v| self.point(v)), radius))).collect();
        // The angle between two tangents: 1 / cos(step / 2) = 1 + tolerance.
        let step = 2.0 * (1.0 / (1.0 + tolerance)).acos();
        let on_border: BTreeSet<VertexId> = sides.iter().flatten().copied().collect();
        for v in on_border {
            for [before, at, next] in self.closed_corners(v) {
                let arc = outlines.corner([before, at, next].map(|v| self.point(v)), radius, step);
                if let (Some(first), Some(last)) = (arc.first(), arc.last()) {
                    ends.entry([before, at]).and_modify(|ends| ends[1] = *last);
                    ends.entry([at, next]).and_modify(|ends| ends[0] = *first);
                }
            }
        }
        for ([a, b], [c, d]) in ends {
            let [a, b] = [a, b].map(|v| self.point(v));
            outlines.add(&[a, b, d, c, a]);
        }
        let free = outlines.free_part().map_err(|error| InsetError::Cut { radius, error })?;
        let mut map = free.ok_or(InsetError::NoRoom { radius })?;
        map.triangulate(TriangulationMethod::default()).map_err(|error| InsetError::Triangles { radius, error })?;
        let mesh = NavMesh::new(&map)?;
        Ok(Inset { map, mesh, radius, tolerance })
    }

    /// The closed sides of all faces one may stand in, each with that face on its left.
    fn closed_sides(&self) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        let free = self.faces().filter(|&f| self.is_walkable(f));
        free.flat_map(|f| self.sides(f)).filter(|side| !side.open).map(|side| [side.from, side.to])
    }

    /// For each wedge at `v` that ends at closed sides: the vertex before `v` along the border, `v`, the vertex after.
    ///
    /// Cost: that of [`wedges`](Self::wedges).
    fn closed_corners(&self, v: VertexId) -> Vec<[VertexId; 3]> {
        let corner = |wedge: Vec<FaceId>| {
            let [&first, &last] = [wedge.first()?, wedge.last()?];
            let next = self.side(first, self.side_from(first, v.number())?);
            let before = self.side(last, self.side_to(last, v.number())?);
            (!next.open && !before.open).then_some([before.from, v, next.to])
        };
        self.wedges(v).into_iter().filter_map(corner).collect()
    }
}

/// Closed outlines as segments, each with its inside on the left: first the border, then the strips.
struct Outlines {
    segments: Vec<[Point; 2]>,
    /// How many of them are sides of the border.
    sides: usize,
}

impl Outlines {
    /// Adds the segments from point to point.
    fn add(&mut self, points: &[Point]) {
        self.segments.extend(points.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[a, b]| a != b));
    }

    /// What is left between the strips of two sides in a row: a fan below tangents. Returns the corners between them, the
    /// first of which is on the line of the strip after the corner, the last on that of the strip before it; none if
    /// the strips meet.
    fn corner(&mut self, [before, at, next]: [Point; 3], radius: f64, step: f64) -> Vec<Point> {
        let turn = match orientation(before, at, next) {
            // The strips overlap.
            Ordering::Greater => return Vec::new(),
            // Straight on; or the free end of a wall.
            Ordering::Equal if left_to_right(before, at) == left_to_right(at, next) => 0.0,
            Ordering::Equal => PI,
            Ordering::Less => {
                let [d, e] = [[before, at], [at, next]].map(|[p, q]| [q.x - p.x, q.y - p.y]);
                // To the right, as the exact sign says: near 0 and half a turn the rounded one may differ.
                (d[1] * e[0] - d[0] * e[1]).atan2(d[0] * e[0] + d[1] * e[1]).abs()
            }
        };
        let [_, from] = beside([before, at], radius);
        let [to, _] = beside([at, next], radius);
        // A turn that is next to nothing has tangents that are one line: the strips keep their own ends.
        let pieces = if turn < 1e-6 { 0.0 } else { (turn / step).ceil() };
        let step = turn / pieces.max(1.0);
        // Counter-clockwise from the strip after the corner to that before it.
        let first = (to.y - at.y).atan2(to.x - at.x);
        let far = radius / (0.5 * step).cos();
        let corner = |i: u32| {
            let (sin, cos) = (first + (f64::from(i) + 0.5) * step).sin_cos();
            Point::new(at.x + far * cos, at.y + far * sin)
        };
        let arc: Vec<Point> = (0..pieces as u32).map(corner).collect();
        let rim = if arc.is_empty() { vec![to, from] } else { arc.clone() };
        let outline: Vec<Point> = std::iter::once(at).chain(rim).chain([at]).collect();
        self.add(&outline);
        arc
    }

    /// The part of the plane inside the border and in no strip, with everything else as holes; `None` if there is none.
    fn free_part(&self) -> Result<Option<Subdivision>, SegmentsError> {
        let options = ArrangeOptions { split: true, merge: true, ..ArrangeOptions::default() };
        let arranged = Subdivision::arrange_segments(&self.segments, &options)?;
        let map = &arranged.subdivision;
        // What a step from the face of an even half-edge across it changes: of the border, of the strips.
        let mut change = vec![[0i32; 2]; map.edge_bound()];
        for i in 0..self.segments.len() {
            let which = usize::from(i >= self.sides);
            for h in arranged.chain(i) {
                change[h.edge().index()][which] += if is_even(*h) { -1 } else { 1 };
            }
        }
        // How often the border and the strips run round each face.
        let mut rounds = vec![None; map.face_bound()];
        rounds[map.outer_face().index()] = Some([0, 0]);
        let mut stack = vec![map.outer_face()];
        while let Some(f) = stack.pop() {
            let Some([border, strips]) = rounds[f.index()] else { continue };
            for h in map.cycles(f).flat_map(|h| map.cycle(h)) {
                let across = map.face(h.twin());
                if rounds[across.index()].is_none() {
                    let [a, b] = change[h.edge().index()];
                    let way = if is_even(h) { 1 } else { -1 };
                    rounds[across.index()] = Some([border + way * a, strips + way * b]);
                    stack.push(across);
                }
            }
        }
        let is_free = |f: FaceId| matches!(rounds[f.index()], Some([border, 0]) if border > 0);
        let halves = map.edges().flat_map(EdgeId::half_edges);
        let sides = halves.filter(|&h| is_free(map.face(h)) && !is_free(map.face(h.twin())));
        let sides: Vec<[Point; 2]> = sides.map(|h| [map.origin(h), map.destination(h)].map(|v| map.point(v))).collect();
        if sides.is_empty() {
            return Ok(None);
        }
        let mut free = Subdivision::from_segments(&sides)?;
        let inside: BTreeSet<FaceId> = (0..sides.len() as u32).map(|i| free.face(HalfEdgeId::new(2 * i))).collect();
        for f in free.faces().filter(|f| !inside.contains(f)).collect::<Vec<_>>() {
            free.set_hole(f, true);
        }
        Ok(Some(free))
    }
}

fn is_even(h: HalfEdgeId) -> bool {
    h.number().is_multiple_of(2)
}

/// The ends of a side, moved to its left by the radius.
fn beside([a, b]: [Point; 2], radius: f64) -> [Point; 2] {
    let [x, y] = [b.x - a.x, b.y - a.y];
    let scale = radius / x.hypot(y);
    [a, b].map(|p| Point::new(p.x - y * scale, p.y + x * scale))
}
