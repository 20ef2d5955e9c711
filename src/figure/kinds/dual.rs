//! The dual graph over its subdivision: a point in each face, and a line across each edge.
//!
//! ```text
//!   ┌─────────┬─────────┐      The point of a face is where its label would be, if that is inside, by exact signs;
//!   │   ■─ ─ ─┼─ ─ ─■   │      otherwise the middle of a triangle of it. A line runs from the point of one face to
//!   │   ╎     │     ╎   │      the middle of the edge and on to the point of the other. Where the straight way
//!   └───╎─────┴─────╎───┘      leaves the face, it runs through the triangles between the two.
//!       ╎           ╎
//! ```

use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::layout::options::FigureOptions;
use crate::figure::layout::pole::pole;
use crate::figure::sketch::{Backdrop, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureError};
use crate::geometry::point::corners;
use crate::ids::{EdgeMap, FaceId, FaceMap, HalfEdgeId};
use crate::plane::predicates::orientation;
use crate::plane::{Point, Subdivision, TriangulateError, TriangulationMethod};
use std::collections::VecDeque;

/// Why the dual graph cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DualFigureError {
    /// The faces have no inside to put a point into.
    #[error(transparent)]
    Triangulate(#[from] TriangulateError),
    /// The lines would have to bend too often.
    #[error("the lines of the dual graph bend more than {MOST_BENDS} times in winding faces: triangulate these first")]
    TooWinding,
    /// The structure, or the sketch over it, cannot be drawn.
    #[error(transparent)]
    Sketch(#[from] SketchError),
}

impl From<FigureError> for DualFigureError {
    fn from(error: FigureError) -> Self {
        Self::Sketch(error.into())
    }
}

/// Size of the picture in which places are looked for, in px.
const SIZE: f64 = 1000.0;

/// A drawing with more bends would take hundreds of megabytes.
const MOST_BENDS: usize = 1 << 23;

/// The dual graph of a subdivision drawn over it. Edges to the outer face end in the open, dashed.
///
/// Every point lies strictly inside its face. Cost: O(n log n) for the triangles of all faces, a search for the place of
/// each point, and for each edge the triangles between it and the place of its face: n² in all for a face whose n edges
/// lie far from there, as in a spiral, a star or a comb. So large is the drawing, too, where lines have to bend: more than
/// 2^23 bends are refused.
///
/// # Errors
/// [`DualFigureError`].
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::Subdivision;
///
/// let svg = figure::dual(&Subdivision::lab_rectangle(), &FigureOptions::new("A dual"))?.to_svg();
/// assert!(svg.contains("e0: f0, f1"));
/// # Ok::<(), figure::DualFigureError>(())
/// ```
pub fn dual(s: &Subdivision, options: &FigureOptions) -> Result<Figure, DualFigureError> {
    let rooms = Rooms::new(s)?;
    let mut sketch = Sketch::new();
    let mut bends = 0;
    for e in s.edges() {
        let [h, t] = e.half_edges();
        let (mut way, other) = (rooms.way(h), rooms.way(t));
        way.push(rooms.middle(h));
        way.extend(other.into_iter().rev());
        bends += way.len().saturating_sub(3);
        if bends > MOST_BENDS {
            return Err(DualFigureError::TooWinding);
        }
        let [f, g] = [h, t].map(|h| s.face(h));
        let outside = f == s.outer_face() || g == s.outer_face();
        let item = sketch.path(Role::Secondary, way);
        item.title(format!("{e}: {}, {}", f.min(g), f.max(g)));
        if outside {
            item.key("across an edge of the outer face");
        } else {
            item.solid().key("across an edge: from face to face");
        }
    }
    for f in s.faces().filter(|&f| f != s.outer_face()) {
        if let Some(room) = rooms.rooms[f] {
            sketch.point(Role::Secondary, room.at).title(f.to_string()).key("a face as a vertex");
        }
    }
    let mut figure = sketch.over(s, Backdrop::Dimmed, options)?;
    let without = s.faces().filter(|&f| f != s.outer_face() && rooms.rooms[f].is_none());
    let without: Vec<String> = without.map(|f| f.to_string()).collect();
    if !without.is_empty() {
        figure.notes.push(format!("no double lies strictly inside of {}", without.join(", ")));
    }
    Ok(figure)
}

/// The place of a face.
#[derive(Clone, Copy)]
struct Room {
    at: Point,
    /// The triangle it lies in.
    triangle: FaceId,
}

/// Places in all faces, and the triangles between them and the edges.
struct Rooms<'a> {
    s: &'a Subdivision,
    triangles: Subdivision,
    is_diagonal: EdgeMap<bool>,
    rooms: FaceMap<Option<Room>>,
    /// For each triangle the diagonal towards the room of its face.
    home: FaceMap<Option<HalfEdgeId>>,
    reach: f64,
}

impl<'a> Rooms<'a> {
    fn new(s: &'a Subdivision) -> Result<Self, TriangulateError> {
        let mut triangles = s.clone();
        let added = triangles.triangulate_all(TriangulationMethod::Monotone)?;
        let mut is_diagonal = EdgeMap::filled(triangles.edge_bound(), false);
        added.diagonals.iter().for_each(|&diagonal| is_diagonal[diagonal] = true);
        let mut parts: Vec<(FaceId, FaceId)> = added.new_faces.iter().map(|&(new, old)| (old, new)).collect();
        parts.extend(s.faces().filter(|&f| f != s.outer_face()).map(|f| (f, f)));
        parts.sort_unstable();
        let [low, high] = corners(s.vertices().map(|v| s.point(v)));
        let reach = (high.x - low.x).max(high.y - low.y).max(0.0);
        let rooms = FaceMap::filled(s.face_bound(), None);
        let home = FaceMap::filled(triangles.face_bound(), None);
        let mut found = Self { s, triangles, is_diagonal, rooms, home, reach };
        for of_face in parts.chunk_by(|a, b| a.0 == b.0) {
            let own: Vec<FaceId> = of_face.iter().map(|&(_, triangle)| triangle).collect();
            let room = found.room(of_face[0].0, &own);
            found.rooms[of_face[0].0] = room;
            if let Some(room) = room {
                found.spread(room.triangle);
            }
        }
        Ok(found)
    }

    fn corners(&self, triangle: FaceId) -> [Point; 3] {
        let mut corners = [Point::default(); 3];
        let walk = self.triangles.incident_vertices(triangle);
        corners.iter_mut().zip(walk).for_each(|(corner, v)| *corner = self.triangles.point(v));
        corners
    }

    /// A place strictly inside the face, which consists of these triangles.
    fn room(&self, f: FaceId, triangles: &[FaceId]) -> Option<Room> {
        // It may lie on one diagonal, too, but not on two: there is a vertex.
        let holds = |triangle: FaceId, p: Point| {
            let mut diagonals = 0;
            let inside = self.triangles.incident_half_edges(triangle).all(|h| {
                let [a, b] = [h, h.twin()].map(|h| self.triangles.point(self.triangles.origin(h)));
                let side = orientation(a, b, p);
                diagonals += u32::from(side.is_eq());
                side.is_gt() || (side.is_eq() && self.is_diagonal[h.edge()])
            });
            inside && diagonals <= 1
        };
        let label = self.label_place(f);
        if let Some(at) = label
            && let Some(&triangle) = triangles.iter().find(|&&triangle| holds(triangle, at))
        {
            return Some(Room { at, triangle });
        }
        let area = |&triangle: &FaceId| {
            let [a, b, c] = self.corners(triangle);
            (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
        };
        let mut by_size = triangles.to_vec();
        by_size.sort_by(|t, u| area(u).total_cmp(&area(t)));
        let mut middles = by_size.into_iter().map(|triangle| {
            let [a, b, c] = self.corners(triangle);
            Room { at: Point::new((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0), triangle }
        });
        middles.find(|room| holds(room.triangle, room.at))
    }

    /// Where a label of the face would stand, by rounded numbers.
    fn label_place(&self, f: FaceId) -> Option<Point> {
        let base = self.s.cycles(f).next().map(|h| self.s.point(self.s.origin(h)))?;
        let scale = SIZE / self.reach;
        let px = |p: Point| -> Xy { xy((p.x - base.x) * scale, (p.y - base.y) * scale) };
        let ring = |h: HalfEdgeId| self.s.cycle(h).map(|h| px(self.s.point(self.s.origin(h)))).collect();
        let rings: Vec<Vec<Xy>> = self.s.cycles(f).map(ring).collect();
        let at = pole(&rings, &[], 1.0, SIZE)?.at;
        Some(Point::new(base.x + at.x / scale, base.y + at.y / scale))
    }

    /// Finds the way home from all triangles of the face of this one. Breadth first.
    fn spread(&mut self, start: FaceId) {
        let mut queue = VecDeque::from([start]);
        while let Some(triangle) = queue.pop_front() {
            let sides: Vec<HalfEdgeId> = self.triangles.incident_half_edges(triangle).collect();
            for h in sides.into_iter().filter(|h| self.is_diagonal[h.edge()]) {
                let next = self.triangles.face(h.twin());
                if next != start && self.home[next].is_none() {
                    self.home[next] = Some(h.twin());
                    queue.push_back(next);
                }
            }
        }
    }

    fn middle(&self, h: HalfEdgeId) -> Point {
        let [a, b] = [h, h.twin()].map(|h| self.triangles.point(self.triangles.origin(h)));
        Point::new(0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y)
    }

    /// The way from the place of the face of `h` to the middle of `h`, without that.
    fn way(&self, h: HalfEdgeId) -> Vec<Point> {
        let f = self.s.face(h);
        let target = self.middle(h);
        if f == self.s.outer_face() {
            let [a, b] = [h, h.twin()].map(|h| self.s.point(self.s.origin(h)));
            let (x, y) = (b.x - a.x, b.y - a.y);
            let length = (x * x + y * y).sqrt();
            let by = (0.3 * length).min(0.05 * self.reach) / length;
            return vec![Point::new(target.x - y * by, target.y + x * by)];
        }
        let Some(room) = self.rooms[f] else { return Vec::new() };
        let mut gates = Vec::new();
        let mut triangle = self.triangles.face(h);
        while let Some(gate) = self.home[triangle] {
            gates.push(gate);
            triangle = self.triangles.face(gate.twin());
        }
        let is_free = gates.iter().all(|&gate| {
            let ends = [gate, gate.twin()].map(|h| self.triangles.point(self.triangles.origin(h)));
            let [left, right] = ends.map(|end| orientation(room.at, target, end));
            left == right.reverse() && left.is_ne()
        });
        let bends = if is_free { Vec::new() } else { gates };
        std::iter::once(room.at).chain(bends.into_iter().rev().map(|gate| self.middle(gate))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::InnerComponent;

    fn closed(rings: &[&[(i32, i32)]], antennas: &[[(i32, i32); 2]]) -> Subdivision {
        let at = |&(x, y): &(i32, i32)| Point::new(f64::from(x), f64::from(y));
        let sides = |ring: &&[(i32, i32)]| -> Vec<[Point; 2]> {
            (0..ring.len()).map(|i| [at(&ring[i]), at(&ring[(i + 1) % ring.len()])]).collect()
        };
        let mut segments: Vec<[Point; 2]> = rings.iter().flat_map(sides).collect();
        segments.extend(antennas.iter().map(|ends| ends.map(|p| at(&p))));
        Subdivision::from_segments(&segments).expect("segments that meet at their ends only")
    }

    fn examples() -> Vec<Subdivision> {
        let u = [(0, 0), (12, 0), (12, 9), (9, 9), (9, 3), (3, 3), (3, 9), (0, 9)];
        let comb: Vec<(i32, i32)> =
            (0..20).rev().flat_map(|i| [(4 * i + 3, 90), (4 * i + 2, 1)]).chain([(0, 90), (0, 0), (80, 0)]).collect();
        let square = [(0, 0), (90, 0), (90, 90), (0, 90)];
        vec![
            closed(&[&u, &[(5, 1), (7, 1), (6, 2)]], &[[(9, 3), (6, 7)], [(0, 0), (1, 1)]]),
            closed(&[&comb], &[]),
            closed(&[&square, &[(10, 10), (80, 10), (80, 80), (10, 80)], &[(44, 44), (46, 44), (45, 46)]], &[]),
            // The label of the square would stand on its isolated vertex.
            Subdivision::from_graph(
                &[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0], [4.0, 4.0]].map(Point::from),
                &[[0, 1], [1, 2], [2, 3], [3, 0]],
            )
            .expect("a square"),
            Subdivision::polygon(&[[0.0, 0.0], [1e9, 1e-9], [2e9, 1.0]].map(Point::from)).expect("a sliver"),
        ]
    }

    #[test]
    fn every_place_lies_strictly_inside_its_face() {
        for (i, s) in examples().iter().enumerate() {
            let rooms = Rooms::new(s).expect("sound");
            for f in s.faces().skip(1) {
                let room = rooms.rooms[f].unwrap_or_else(|| panic!("example {i}: {f} has no place"));
                let mut with = s.clone();
                let v = with.insert_vertex(room.at).unwrap_or_else(|error| panic!("example {i}: {error}"));
                assert_eq!(with.outgoing(v), None, "example {i}: {f} has its place on an edge");
                assert!(
                    with.inner_components(f).contains(&InnerComponent::Isolated(v)),
                    "example {i}: {f} has its place elsewhere"
                );
            }
        }
    }

    #[test]
    fn ways_cross_no_edge_before_their_own() {
        let opposed = |a, b, p, q| {
            let [one, other] = [p, q].map(|end| orientation(a, b, end));
            one.is_ne() && one == other.reverse()
        };
        for (i, s) in examples().iter().enumerate() {
            let rooms = Rooms::new(s).expect("sound");
            for h in s.half_edges().filter(|&h| s.face(h) != s.outer_face()) {
                let mut way = rooms.way(h);
                way.push(rooms.middle(h));
                for pair in way.windows(2) {
                    for e in s.edges().filter(|&e| e != h.edge()) {
                        let [p, q] = e.half_edges().map(|h| s.point(s.origin(h)));
                        let crosses = opposed(pair[0], pair[1], p, q) && opposed(p, q, pair[0], pair[1]);
                        assert!(!crosses, "example {i}: the way to {h} crosses {e}");
                    }
                }
            }
        }
    }
}
