//! From polygons in space to a surface.
//!
//! ```text
//!    v4 ───────── v3         A side of one polygon that is the same edge the other way round of another one joins the
//!    │    ╲        │         two. Polygons of more than three corners are cut into triangles as they look from the
//!    │       ╲     │         side they are seen best from.
//!    v1 ───────── v2
//!
//!      ╲ f1 ╱                Where two fans of triangles touch in a vertex and in no edge (a double corner), the vertex
//!    ────● v ────            becomes a node for each: nobody can pass from one to the other there.
//!      ╱ f2 ╲
//! ```

use super::super::fault::MeshFault;
use super::super::weld::{BorderSide, near_misses_along};
use super::boxes::Boxes;
use super::layers::plan;
use super::place::LEVEL;
use super::{NONE, NavSurface, SideRecord, Space, cross, dot, minus, next, norm, prev};
use crate::geometry::space::{check_place, normal};
use crate::ids::FaceId;
use crate::plane::predicates::orientation;
use crate::plane::{CoordinateError, Point, Subdivision, TriangulationMethod};
use crate::topology::PolygonList;
use std::cmp::Ordering;

/// What is no surface to walk on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// There is no face, or all of them were left out.
    #[error("there is no face to walk on")]
    NoFaces,
    /// A coordinate is no number, or too large to compute with.
    #[error("vertex {vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// What is wrong.
        error: CoordinateError,
    },
    /// A corner is no point.
    #[error("face {face} has the corner {vertex}, and there are {count} points")]
    NoSuchVertex {
        /// The polygon, from 0.
        face: u32,
        /// The corner.
        vertex: u32,
        /// How many points there are.
        count: usize,
    },
    /// A polygon has no area, or crosses itself, or has a ring inside.
    #[error("face {face} cannot be cut into triangles: {why}")]
    Shape {
        /// The polygon, from 0.
        face: u32,
        /// What is wrong.
        why: String,
    },
    /// Seen from above a polygon runs clockwise: it is the underside of something.
    #[error("face {face} faces down: seen from above its corners run clockwise")]
    FacesDown {
        /// The polygon, from 0.
        face: u32,
    },
    /// More than two polygons have an edge.
    #[error("faces {}, {} and {} all have the edge {} - {}: a surface has two sides at an edge", faces[0], faces[1], faces[2], edge[0], edge[1])]
    ThreeAtEdge {
        /// Three of the polygons, from 0.
        faces: [u32; 3],
        /// The ends of the edge.
        edge: [u32; 2],
    },
    /// Two polygons run an edge the same way: they lie on the same side of it.
    #[error("faces {} and {} run the edge {} -> {} the same way: they overlap there, or one of them is turned over", faces[0], faces[1], edge[0], edge[1])]
    SamePath {
        /// The polygons, from 0.
        faces: [u32; 2],
        /// From where to where.
        edge: [u32; 2],
    },
    /// Marks are part of the numbers.
    #[error("the surface is too large: it may have {} triangles", u32::MAX / 8)]
    TooMany,
}

impl SurfaceError {
    /// The polygons it speaks of, from 0.
    #[must_use]
    pub fn faces(&self) -> Vec<u32> {
        match self {
            Self::NoSuchVertex { face, .. } | Self::Shape { face, .. } | Self::FacesDown { face } => vec![*face],
            Self::ThreeAtEdge { faces, .. } => faces.to_vec(),
            Self::SamePath { faces, .. } => faces.to_vec(),
            Self::NoFaces | Self::Coordinate { .. } | Self::TooMany => Vec::new(),
        }
    }

    /// The points it speaks of, from 0.
    #[must_use]
    pub fn vertices(&self) -> Vec<u32> {
        match self {
            Self::Coordinate { vertex, .. } => vec![*vertex],
            Self::ThreeAtEdge { edge, .. } | Self::SamePath { edge, .. } => edge.to_vec(),
            _ => Vec::new(),
        }
    }
}

impl NavSurface {
    /// The surface of polygons in space. The third coordinate of the points is the height; seen from above the polygons
    /// run counter-clockwise. They may be upright (a riser of a stair). One that is not flat is cut into triangles, and
    /// lengths are along these.
    ///
    /// With `max_slope`, in degrees, whatever is steeper is left out, and so is what faces down: of the model of a whole
    /// house that leaves its floors.
    ///
    /// Cost: O(n log n); with storeys, and what lies over each other.
    ///
    /// # Errors
    /// [`SurfaceError`] names the polygons and points.
    ///
    /// ```
    /// use dcel_kit::navmesh::NavSurface;
    /// use dcel_kit::topology::PolygonList;
    /// // A ramp that rises by 3 over 4, and a platform at its end.
    /// let points = [[0., 0., 0.], [4., 0., 3.], [4., 2., 3.], [0., 2., 0.], [6., 0., 3.], [6., 2., 3.]];
    /// let mut faces = PolygonList::new();
    /// faces.push_face(&[0, 1, 2, 3]);
    /// faces.push_face(&[1, 4, 5, 2]);
    /// let ramp = NavSurface::new(&points, &faces, None)?;
    /// assert_eq!((ramp.layer_count(), ramp.heights(), ramp.area()), (1, [0.0, 3.0], 14.0));
    /// let flat = NavSurface::new(&points, &faces, Some(30.0))?;
    /// assert_eq!(flat.faces().count(), 1, "the ramp is too steep");
    /// # Ok::<(), dcel_kit::navmesh::SurfaceError>(())
    /// ```
    pub fn new(points: &[[f64; 3]], faces: &PolygonList, max_slope: Option<f64>) -> Result<Self, SurfaceError> {
        for (vertex, point) in (0..).zip(points) {
            check_place(*point).map_err(|error| SurfaceError::Coordinate { vertex, error })?;
        }
        let (mut corners, mut polygon, mut starts) = (Vec::new(), Vec::new(), vec![0]);
        for face in 0..faces.face_count() as u32 {
            let first = corners.len();
            cut(points, faces, face, &mut corners)?;
            let triangles = || corners[first..].iter().map(|t: &[u32; 3]| t.map(|v| points[v as usize]));
            let faces_down = triangles().any(|t| orientation(plan(t[0]), plan(t[1]), plan(t[2])).is_lt());
            let is_out = match max_slope {
                Some(most) => faces_down || triangles().any(|t| slope(t) > most * (1.0 + 1e-12)),
                None if faces_down => return Err(SurfaceError::FacesDown { face }),
                None => false,
            };
            if is_out {
                corners.truncate(first);
            }
            polygon.resize(corners.len(), face);
            starts.push(corners.len() as u32);
        }
        if corners.is_empty() {
            return Err(SurfaceError::NoFaces);
        }
        if corners.len() >= u32::MAX as usize / 8 {
            return Err(SurfaceError::TooMany);
        }
        let left_out = |p: usize| starts[p] == starts[p + 1];
        let layer: Vec<u32> = (0..faces.face_count()).map(|p| if left_out(p) { NONE } else { 0 }).collect();
        let mut surface = Self {
            points: Vec::new(),
            vertices: Vec::new(),
            first: Vec::new(),
            around: Vec::new(),
            border: Vec::new(),
            sides: Vec::new(),
            component: vec![NONE; layer.len()],
            layer,
            polygon,
            starts,
            layer_count: 0,
            component_count: 0,
            slack: 0.0,
            boxes: Boxes::default(),
        };
        surface.join(&corners)?;
        surface.make_nodes(points, &corners);
        surface.slack = LEVEL * surface.points.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        surface.measure();
        surface.find_components();
        surface.index();
        surface.find_layers();
        Ok(surface)
    }

    /// What nearly meets, and so is not joined: vertices at one place or close to it, and vertices on a side of another
    /// face (T-junctions) or close to it, closer than 3 · 10⁻⁴ of the extent and than a hundredth of each border
    /// side there. Nobody can pass there. All are warnings: parts that touch may be meant to be parts.
    /// [`weld_in_space`](crate::navmesh::weld_in_space) joins them. O(n log n).
    #[must_use]
    pub fn near_misses(&self) -> Vec<MeshFault> {
        let bound = self.vertices.iter().map(|&v| v as usize + 1).max().unwrap_or(0);
        let mut points = vec![[0.0; 3]; bound];
        self.vertices.iter().zip(&self.points).for_each(|(&v, &p)| points[v as usize] = p);
        let corner = |s: usize| self.vertices[self.sides[s].origin as usize];
        let mut border: Vec<BorderSide> = (0..self.sides.len())
            .filter(|&s| self.sides[s].twin == NONE)
            .map(|s| BorderSide { ends: [corner(s), corner(next(s))], face: self.polygon[s / 3] })
            .collect();
        border.sort_unstable();
        near_misses_along(&points, &border, |face, v| {
            self.vertices(FaceId::new(face + 1)).any(|(w, _)| w.number() == v)
        })
    }

    /// Finds the other side of every side. O(n log n).
    fn join(&mut self, corners: &[[u32; 3]]) -> Result<(), SurfaceError> {
        let ends =
            |s: u32| [corners[s as usize / 3][s as usize % 3], corners[next(s as usize) / 3][next(s as usize) % 3]];
        let edge = |s: u32| {
            let [a, b] = ends(s);
            [a.min(b), a.max(b)]
        };
        let count = 3 * corners.len() as u32;
        let record = |s: u32| SideRecord { origin: ends(s)[0], twin: NONE, length: 0.0, angle: 0.0, apex: [0.0; 2] };
        self.sides = (0..count).map(record).collect();
        let mut order: Vec<u32> = (0..count).collect();
        order.sort_unstable_by_key(|&s| (edge(s), s));
        for same in order.chunk_by(|&s, &t| edge(s) == edge(t)) {
            let face = |s: u32| self.polygon[s as usize / 3];
            match *same {
                [_] => {}
                [s, t] if ends(s) == ends(t) => {
                    return Err(SurfaceError::SamePath { faces: [face(s), face(t)], edge: ends(s) });
                }
                [s, t] => {
                    self.sides[s as usize].twin = t;
                    self.sides[t as usize].twin = s;
                }
                [s, t, u, ..] => {
                    return Err(SurfaceError::ThreeAtEdge { faces: [face(s), face(t), face(u)], edge: edge(s) });
                }
                [] => {}
            }
        }
        Ok(())
    }

    /// Makes a node of each fan of each vertex. O(n).
    fn make_nodes(&mut self, points: &[Space], corners: &[[u32; 3]]) {
        let mut done = vec![false; self.sides.len()];
        for s in 0..self.sides.len() {
            if done[s] {
                continue;
            }
            // Clockwise to the border, or once round.
            let mut first = s;
            while let Some(before) = self.turn_right(first).filter(|&before| before != s) {
                first = before;
            }
            let is_border = self.turn_right(first).is_none();
            let node = self.points.len() as u32;
            let vertex = corners[s / 3][s % 3];
            self.points.push(points[vertex as usize]);
            self.vertices.push(vertex);
            self.first.push(first as u32);
            self.border.push(is_border);
            let mut at = Some(first);
            while let Some(s) = at {
                done[s] = true;
                self.sides[s].origin = node;
                at = self.turn_left(s).filter(|&after| after != first);
            }
        }
    }

    /// Finds lengths and angles. O(n).
    fn measure(&mut self) {
        for s in 0..self.sides.len() {
            let [a, b] = self.ends(s);
            let c = self.points[self.sides[prev(s)].origin as usize];
            let (along, up) = (minus(b, a), minus(c, a));
            let length = norm(along);
            let height = norm(cross(along, up)) / length;
            let x = dot(along, up) / length;
            let side = &mut self.sides[s];
            (side.length, side.apex, side.angle) = (length, [x, height], height.atan2(x));
        }
        self.around = vec![0.0; self.points.len()];
        for side in &self.sides {
            self.around[side.origin as usize] += side.angle;
        }
    }

    fn find_components(&mut self) {
        for start in 0..self.layer.len() {
            if self.layer[start] == NONE || self.component[start] != NONE {
                continue;
            }
            let number = self.component_count as u32;
            self.component_count += 1;
            let mut stack = vec![start];
            while let Some(p) = stack.pop() {
                if std::mem::replace(&mut self.component[p], number) == number {
                    continue;
                }
                let sides = 3 * self.starts[p] as usize..3 * self.starts[p + 1] as usize;
                let beyond = sides.map(|s| self.sides[s].twin).filter(|&twin| twin != NONE);
                let beyond = beyond.map(|twin| self.polygon[twin as usize / 3] as usize);
                stack.extend(beyond.filter(|&p| self.component[p] == NONE));
            }
        }
    }
}

/// How steep a triangle is, in degrees: 0 is flat, 90 upright; more if it faces down.
pub(super) fn slope(t: [Space; 3]) -> f64 {
    let n = normal(t);
    n[0].hypot(n[1]).atan2(n[2]).to_degrees()
}

/// Cuts a polygon into triangles.
fn cut(points: &[Space], faces: &PolygonList, face: u32, out: &mut Vec<[u32; 3]>) -> Result<(), SurfaceError> {
    let shape = |why: &str| SurfaceError::Shape { face, why: why.to_owned() };
    let cycles = faces.cycle_range(face as usize);
    if cycles.len() != 1 {
        return Err(shape("it has a ring inside"));
    }
    let ring = faces.cycle(cycles.start);
    if let Some(&vertex) = ring.iter().find(|&&v| v as usize >= points.len()) {
        return Err(SurfaceError::NoSuchVertex { face, vertex, count: points.len() });
    }
    let at = |v: u32| points[v as usize];
    match *ring {
        [a, b, c] => {
            if is_thin([a, b, c].map(at)) {
                return Err(shape("it has no area"));
            }
            out.push([a, b, c]);
            return Ok(());
        }
        [a, b, c, d] => {
            // The cut that leaves the greater least angle, if both triangles face the same way.
            let quality = |t: [u32; 3]| {
                let t = t.map(at);
                let longest = [norm(minus(t[1], t[0])), norm(minus(t[2], t[1])), norm(minus(t[0], t[2]))];
                norm(normal(t)) / longest.into_iter().fold(0.0, f64::max).powi(2)
            };
            let same_way = |s: [u32; 3], t: [u32; 3]| dot(normal(s.map(at)), normal(t.map(at))) > 0.0;
            let cuts = [[[a, b, c], [a, c, d]], [[b, c, d], [b, d, a]]];
            let usable = |[s, t]: &[[u32; 3]; 2]| same_way(*s, *t) && !is_thin(s.map(at)) && !is_thin(t.map(at));
            let least = |[s, t]: &[[u32; 3]; 2]| quality(*s).min(quality(*t));
            let better = |one: &[[u32; 3]; 2], other: &[[u32; 3]; 2]| {
                least(one).partial_cmp(&least(other)).unwrap_or(Ordering::Equal)
            };
            if usable(&cuts[0]) && usable(&cuts[1]) {
                // Of equal cuts the first.
                out.extend(cuts[usize::from(better(&cuts[1], &cuts[0]).is_gt())]);
                return Ok(());
            }
        }
        _ => {}
    }
    // As it is seen from the axis that its normal is closest to.
    let normal = ring.iter().zip(ring.iter().cycle().skip(1)).fold([0.0; 3], |sum, (&a, &b)| {
        let n = cross(minus(at(a), at(ring[0])), minus(at(b), at(ring[0])));
        [0, 1, 2].map(|i| sum[i] + n[i])
    });
    let axis = (0..3).fold(2, |most, i| if normal[i].abs() > normal[most].abs() { i } else { most });
    let seen = |v: &u32| {
        let p = at(*v);
        let [x, y] = match axis {
            0 => [p[1], p[2]],
            1 => [p[2], p[0]],
            _ => [p[0], p[1]],
        };
        if normal[axis] < 0.0 { Point::new(0.0 - x, y) } else { Point::new(x, y) }
    };
    let outline: Vec<Point> = ring.iter().map(seen).collect();
    let mut map = Subdivision::polygon(&outline).map_err(|error| shape(&error.of_one_polygon(|i| ring[i as usize])))?;
    let given = map.edge_bound();
    map.triangulate(TriangulationMethod::default()).map_err(|error| shape(&error.to_string()))?;
    map.make_delaunay(|edge| edge.index() < given);
    for f in map.faces().filter(|&f| f != FaceId::new(0)) {
        let mut corners = map.incident_half_edges(f).map(|h| ring[map.origin(h).index()]);
        if let (Some(a), Some(b), Some(c)) = (corners.next(), corners.next(), corners.next()) {
            if is_thin([a, b, c].map(at)) {
                return Err(shape("corners of it lie on one line"));
            }
            out.push([a, b, c]);
        }
    }
    Ok(())
}

/// Whether a triangle has no area that one can compute with.
fn is_thin(t: [Space; 3]) -> bool {
    let sides = [minus(t[1], t[0]), minus(t[2], t[1]), minus(t[0], t[2])].map(norm);
    let longest = sides.into_iter().fold(0.0, f64::max);
    norm(normal(t)) <= 1e-13 * longest * longest
}
