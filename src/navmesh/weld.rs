//! Hand-made floors: what nearly meets, found and joined.
//!
//! ```text
//!   ●──────●●──────●        ●───────●──────●      Two vertices closer than the distance become one. A vertex on a side
//!   │      ││      │        │       │      │      of another face (a T-junction), or closer to it than that, becomes a
//!   │      │●──────●  ──>   │       ●──────●      corner of that face. Points never move: a vertex is replaced by one
//!   │      │ ●─────●        │       │      │      that was there, a side is bent to one that was there, by no more
//!   ●──────●─┴─────●        ●───────●──────●      than the distance.
//! ```
//!
//! Only *border sides* matter: those that no other face has in the other direction. Vertices are looked up in a grid of
//! equal cells, one for each. Floors in space are looked up by their plan and measured in space, so that storeys over each
//! other never meet.

use super::fault::MeshFault;
use super::surface::Space;
use crate::geometry::grouping::{grouped, sorted};
use crate::geometry::space::{are_collinear, between, check_place, dot, lerp, minus};
use crate::plane::Point;
use crate::topology::PolygonList;

/// What nearly meets is told for distances up to this part of the extent of the map ...
const SUSPICIOUS: f64 = 3e-4;
/// ... and of the border sides that are there: a dense curve is no row of gaps, and the end of a thin wall is no gap.
const OF_SIDES: f64 = 1e-2;

/// Faces after welding.
#[derive(Clone, PartialEq, Debug)]
pub struct Welded {
    /// The faces; their corners are numbers of the same points.
    pub faces: PolygonList,
    /// For each face which one it was.
    pub origins: Vec<u32>,
    /// How many vertices were replaced by others.
    pub joined: usize,
    /// How many corners were put into sides.
    pub inserted: usize,
    /// How many faces are gone, since fewer than three corners were left of them.
    pub collapsed: usize,
    /// The greatest distance between a vertex and the one in its place, or between a side and a corner put into it.
    pub farthest: f64,
}

/// A vertex that is to become a corner inside a side.
struct Beside {
    v: u32,
    /// How far it is from the side.
    apart: f64,
    /// The side of the cycle, by number, and where on it, from 0 to 1.
    side: usize,
    along: f64,
}

/// A side that no other face has in the other direction.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct BorderSide {
    pub(super) ends: [u32; 2],
    pub(super) face: u32,
}

/// Joins what is no further apart than `distance`: vertices first, each with the nearest of those before it that stay;
/// then sides with the vertices on or beside them. With distance 0 that is what lies at the same place, and
/// T-junctions.
///
/// A side may be bent, so a face may lose its convexity by the distance at most. Corners that are no point are left
/// alone.
///
/// Cost: O(n log n) for n corners if the distance is less than most sides; else more, as every pair within it counts.
///
/// ```
/// use dcel_kit::{navmesh::weld, plane::Point, topology::PolygonList};
/// // Two squares beside each other, as good as: and the upper one spans both.
/// let points = [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (1.0001, 0.), (2., 0.), (2., 1.), (1., 0.9999), (2., 2.), (0., 2.)];
/// let points = points.map(Point::from);
/// let mut faces = PolygonList::new();
/// [[0, 1, 2, 3], [4, 5, 6, 7], [3, 6, 8, 9]].iter().for_each(|face| faces.push_face(face));
/// let welded = weld(&points, &faces, 0.001);
/// assert_eq!((welded.joined, welded.inserted), (2, 1));
/// assert_eq!(welded.faces.cycle(1), [1, 5, 6, 2]);
/// assert_eq!(welded.faces.cycle(2), [3, 2, 6, 8, 9]);
/// ```
#[must_use]
pub fn weld(points: &[Point], faces: &PolygonList, distance: f64) -> Welded {
    weld_in_space(&flat(points), faces, distance)
}

/// The same on a floor in space, whose third coordinate is the height: what lies over each other stays apart. With
/// distance 0 a T-junction is a vertex exactly on a side, which slopes rarely have: what was computed lies beside it by its
/// rounding.
///
/// Cost: as [`weld`]; storeys over each other share the cells of the plan.
///
/// ```
/// use dcel_kit::{navmesh::weld_in_space, topology::PolygonList};
/// // A ramp, and a platform at its upper end whose corner lies in the middle of the ramp's side.
/// let points = [[0., 0., 0.], [4., 0., 1.], [4., 4., 1.], [0., 4., 0.], [4., 2., 1.], [8., 2., 1.], [8., 4., 1.]];
/// let mut faces = PolygonList::new();
/// [[0, 1, 2, 3], [4, 5, 6, 2]].iter().for_each(|face| faces.push_face(face));
/// let welded = weld_in_space(&points, &faces, 0.0);
/// assert_eq!(welded.faces.cycle(0), [0, 1, 4, 2, 3]);
/// ```
#[must_use]
pub fn weld_in_space(points: &[[f64; 3]], faces: &PolygonList, distance: f64) -> Welded {
    let is_sound = |&v: &u32| points.get(v as usize).is_some_and(|&p| check_place(p).is_ok());
    let used = sorted(faces.corners().iter().copied().filter(is_sound).collect());
    let grid = PointGrid::new(points, used);
    let mut result =
        Welded { faces: PolygonList::new(), origins: Vec::new(), joined: 0, inserted: 0, collapsed: 0, farthest: 0.0 };
    let mut stands_for: Vec<u32> = (0..points.len() as u32).collect();
    for &v in &grid.vertices {
        let mut best: Option<(f64, u32)> = None;
        grid.near(points, [points[v as usize]; 2], distance, |u| {
            let apart = between(points[v as usize], points[u as usize]);
            if u < v && stands_for[u as usize] == u && apart <= distance && best.is_none_or(|best| (apart, u) < best) {
                best = Some((apart, u));
            }
        });
        if let Some((apart, u)) = best {
            stands_for[v as usize] = u;
            result.joined += 1;
            result.farthest = result.farthest.max(apart);
        }
    }
    let mut cycles: Vec<(u32, bool, Vec<u32>)> = Vec::new();
    for face in 0..faces.face_count() {
        for (i, cycle) in faces.cycles(face).enumerate() {
            let mut corners: Vec<u32> =
                cycle.iter().map(|&v| stands_for.get(v as usize).copied().unwrap_or(v)).collect();
            // What was there twice before is not our business.
            let was_sound = cycle.windows(2).all(|pair| pair[0] != pair[1]) && cycle.len() >= 3;
            if was_sound {
                corners.dedup();
                while corners.len() > 1 && corners.first() == corners.last() {
                    corners.pop();
                }
                if corners.len() < 3 {
                    result.collapsed += usize::from(i == 0);
                    if i == 0 {
                        break;
                    }
                    continue;
                }
            }
            cycles.push((face as u32, i == 0, corners));
        }
    }
    let ends = |cycle: &[u32]| -> Vec<[u32; 2]> {
        cycle.iter().zip(cycle.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect()
    };
    let sides = cycles.iter().zip(0..).flat_map(|((.., cycle), i)| ends(cycle).into_iter().map(move |ends| (ends, i)));
    let border = border_of(sides.map(|(ends, face)| BorderSide { ends, face }).collect());
    let on_border = sorted(border.iter().flat_map(|side| side.ends).filter(is_sound).collect());
    let grid = PointGrid::new(points, on_border);
    let mut found: Vec<Beside> = Vec::new();
    for (i, (face, is_outer, cycle)) in cycles.iter().enumerate() {
        found.clear();
        for (side, [a, b]) in ends(cycle).into_iter().enumerate() {
            let border_side = BorderSide { ends: [a, b], face: i as u32 };
            if ![a, b].iter().all(is_sound) || border.binary_search(&border_side).is_err() {
                continue;
            }
            let [p, q] = [a, b].map(|v| points[v as usize]);
            grid.near(points, [p, q], distance, |v| {
                let at = points[v as usize];
                let (along, apart) = along_and_apart([p, q], at);
                let exact = are_collinear(p, q, at);
                let inside = along > 0.0 && along < 1.0 && ![p, q].contains(&at);
                if inside && (apart <= distance || exact) && !cycle.contains(&v) {
                    found.push(Beside { v, apart: if exact { 0.0 } else { apart }, side, along });
                }
            });
        }
        // Near a corner a vertex may be beside two sides of one face: it goes into the nearer one.
        found.sort_unstable_by(|a, b| a.v.cmp(&b.v).then(a.apart.total_cmp(&b.apart)).then(a.side.cmp(&b.side)));
        found.dedup_by_key(|beside| beside.v);
        found.sort_unstable_by(|a, b| a.side.cmp(&b.side).then(a.along.total_cmp(&b.along)).then(a.v.cmp(&b.v)));
        result.inserted += found.len();
        result.farthest = found.iter().fold(result.farthest, |farthest, beside| farthest.max(beside.apart));
        let mut corners = Vec::with_capacity(cycle.len() + found.len());
        let mut inserted = found.iter().peekable();
        for (side, &corner) in cycle.iter().enumerate() {
            corners.push(corner);
            corners
                .extend(std::iter::from_fn(|| inserted.next_if(|beside| beside.side == side)).map(|beside| beside.v));
        }
        if *is_outer {
            result.faces.push_face(&corners);
            result.origins.push(*face);
        } else {
            result.faces.push_hole(&corners);
        }
    }
    result
}

/// Pairs of vertices, and vertices and sides, that are so close to each other that they were probably meant to meet; not
/// those that do. Each vertex is told once, with the nearest.
pub(super) fn near_misses(points: &[Point], faces: &PolygonList) -> Vec<MeshFault> {
    let mut sides = Vec::with_capacity(faces.corner_count());
    for face in 0..faces.face_count() {
        for cycle in faces.cycles(face) {
            let next = cycle.iter().cycle().skip(1);
            sides.extend(cycle.iter().zip(next).map(|(&a, &b)| BorderSide { ends: [a, b], face: face as u32 }));
        }
    }
    let has = |face: u32, v: u32| faces.cycles(face as usize).any(|cycle| cycle.contains(&v));
    near_misses_along(&flat(points), &border_of(sides), has)
}

/// The same of the sides of a border, in space. `has` tells whether a vertex is a corner of a face.
pub(super) fn near_misses_along(
    points: &[Space],
    border: &[BorderSide],
    has: impl Fn(u32, u32) -> bool,
) -> Vec<MeshFault> {
    let on_border = sorted(border.iter().flat_map(|side| side.ends).collect());
    let grid = PointGrid::new(points, on_border);
    let most = SUSPICIOUS * grid.extent();
    // How far away something may be of a side, and of a vertex: of the shortest side there.
    let reach = |side: &BorderSide| {
        let [a, b] = side.ends.map(|v| points[v as usize]);
        most.min(OF_SIDES * between(a, b))
    };
    let mut reach_of = vec![most; points.len()];
    for side in border {
        side.ends.iter().for_each(|&v| reach_of[v as usize] = reach_of[v as usize].min(reach(side)));
    }
    let joined = sorted(border.iter().flat_map(|side| [side.ends, [side.ends[1], side.ends[0]]]).collect());
    let mut nearest: Vec<Option<(f64, u32)>> = vec![None; points.len()];
    for &v in &grid.vertices {
        grid.near(points, [points[v as usize]; 2], reach_of[v as usize], |u| {
            let apart = between(points[v as usize], points[u as usize]);
            let reach = reach_of[v as usize].min(reach_of[u as usize]);
            let is_near = u < v && apart <= reach && joined.binary_search(&[u, v]).is_err();
            if is_near && nearest[v as usize].is_none_or(|best| (apart, u) < best) {
                nearest[v as usize] = Some((apart, u));
            }
        });
    }
    let pair = |(v, near): (u32, &Option<(f64, u32)>)| {
        near.map(|(distance, first)| MeshFault::NearVertices { first, second: v, distance })
    };
    let mut faults: Vec<MeshFault> = (0..).zip(&nearest).filter_map(pair).collect();
    // Those that are the first of a pair are told with it.
    let told: Vec<u32> = faults.iter().flat_map(MeshFault::vertices).collect();
    told.into_iter().for_each(|v| nearest[v as usize] = Some((0.0, v)));
    for side in border {
        let ends = side.ends.map(|v| points[v as usize]);
        let reach = reach(side);
        grid.near(points, ends, reach, |v| {
            let (along, apart) = along_and_apart(ends, points[v as usize]);
            let is_near = along > 0.0 && along < 1.0 && apart <= reach.min(reach_of[v as usize]);
            if is_near && nearest[v as usize].is_none() && !has(side.face, v) {
                nearest[v as usize] = Some((apart, v));
                faults.push(MeshFault::NearSide { vertex: v, face: side.face, side: side.ends, distance: apart });
            }
        });
    }
    faults
}

/// Those sides that no face has in the other direction, sorted.
fn border_of(mut sides: Vec<BorderSide>) -> Vec<BorderSide> {
    sides.sort_unstable();
    let has = |ends: [u32; 2]| {
        let first = sides.partition_point(|side| side.ends < ends);
        sides.get(first).is_some_and(|side| side.ends == ends)
    };
    sides.iter().copied().filter(|side| !has([side.ends[1], side.ends[0]])).collect()
}

/// Points of the plane, at height 0.
fn flat(points: &[Point]) -> Vec<Space> {
    points.iter().map(|p| [p.x, p.y, 0.0]).collect()
}

/// Where on the segment the nearest point to `p` is, from 0 to 1, and how far away.
fn along_and_apart([a, b]: [Space; 2], p: Space) -> (f64, f64) {
    let along = minus(b, a);
    let t = dot(minus(p, a), along) / dot(along, along);
    (t, between(lerp(a, b, t.clamp(0.0, 1.0)), p))
}

/// Vertices in cells of equal size.
struct PointGrid {
    vertices: Vec<u32>,
    min: Space,
    max: Space,
    scale: f64,
    size: [usize; 2],
    /// Where the vertices of each cell begin in `items`, row by row; and at last where they end.
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl PointGrid {
    /// `vertices` are sorted. O(n).
    fn new(points: &[Space], vertices: Vec<u32>) -> Self {
        let first = vertices.first().map_or(Space::default(), |&v| points[v as usize]);
        let (min, max) = vertices.iter().map(|&v| points[v as usize]).fold((first, first), |(min, max), p| {
            ([0, 1, 2].map(|i| min[i].min(p[i])), [0, 1, 2].map(|i| max[i].max(p[i])))
        });
        let [width, height, _] = [0, 1, 2].map(|i| max[i] - min[i]);
        let count = vertices.len().max(1) as f64;
        // Square cells, one for each vertex; of a row of vertices no more than that many, either.
        let cell = (width * height / count).sqrt().max(width.max(height) / count);
        let scale = if cell > 0.0 { 1.0 / cell } else { 0.0 };
        let size = [width, height].map(|length| (length * scale) as usize + 1);
        let grid = Self { vertices, min, max, scale, size, starts: Vec::new(), items: Vec::new() };
        let vertex = |i: usize| grid.vertices[i];
        let cell = |i: usize| grid.cell(points[vertex(i) as usize]);
        let (starts, order) = grouped(size[0] * size[1], grid.vertices.len(), cell);
        let items = order.into_iter().map(|i| vertex(i as usize)).collect();
        Self { starts, items, ..grid }
    }

    /// The length of the diagonal of the box round all.
    fn extent(&self) -> f64 {
        between(self.min, self.max)
    }

    fn place(&self, which: usize, x: f64) -> usize {
        // A cast of a negative number gives 0.
        (((x - self.min[which]) * self.scale) as usize).min(self.size[which] - 1)
    }

    fn cell(&self, p: Space) -> usize {
        self.place(1, p[1]) * self.size[0] + self.place(0, p[0])
    }

    /// Calls `visit` with every vertex that is no further from the segment than the distance, and with some that are.
    fn near(&self, points: &[Space], [a, b]: [Space; 2], distance: f64, mut visit: impl FnMut(u32)) {
        // More than the rounding of what follows.
        let largest = [self.min, self.max].iter().flatten().copied().map(f64::abs).fold(0.0, f64::max);
        let reach = distance + largest * 2f64.powi(-48);
        let (low, high) = if a[1] <= b[1] { (a, b) } else { (b, a) };
        for row in self.place(1, low[1] - reach)..=self.place(1, high[1] + reach) {
            // The part of the segment that may be near a vertex of this row.
            let end = |y: f64, end: Space| {
                let t = if high[1] > low[1] { ((y - low[1]) / (high[1] - low[1])).clamp(0.0, 1.0) } else { 0.5 };
                if high[1] > low[1] { low[0] + (high[0] - low[0]) * t } else { end[0] }
            };
            let line = |row: usize| if self.scale > 0.0 { self.min[1] + row as f64 / self.scale } else { self.min[1] };
            let below = if row == 0 { f64::NEG_INFINITY } else { line(row) - reach };
            let above = if row + 1 == self.size[1] { f64::INFINITY } else { line(row + 1) + reach };
            let xs = [end(below.max(low[1]), low), end(above.min(high[1]), high)];
            let [from, to] = [xs[0].min(xs[1]) - reach, xs[0].max(xs[1]) + reach];
            let first = row * self.size[0];
            let cells = first + self.place(0, from)..first + self.place(0, to) + 1;
            let items = self.starts[cells.start] as usize..self.starts[cells.end] as usize;
            for &v in &self.items[items] {
                let p = points[v as usize];
                let out = p[0] < a[0].min(b[0]) - reach
                    || p[0] > a[0].max(b[0]) + reach
                    || p[1] < low[1] - reach
                    || p[1] > high[1] + reach;
                if !out {
                    visit(v);
                }
            }
        }
    }
}
