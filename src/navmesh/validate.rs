//! What is wrong with faces that should be a navmesh: every fault by name, not only the first.
//!
//! ```text
//!     winding            overlap          T-junction        not convex         double corner (a warning)
//!   ●──<──●           ●─────●           ●─────●─────●      ●───────●           ┌───●▨▨▨┐
//!   │  ▲  │           │   ●─┼───●       │     │     │      │   ●   │           │   │▨▨▨│
//!   ●──>──●           ●───┼─●   │       ●─────┴──●──●      │  ╱ ╲  │           ├───●───┤  two holes touch in ●:
//!   all faces must        ●─────●         ● lies on a      ●─●   ●─●           │▨▨▨│   │  nobody squeezes
//!   run the same way                      side, no end                         └▨▨▨┴───┘  through
//! ```
//!
//! The faces come as a file has them, before a subdivision is made of them: what is wrong here keeps one from being
//! made, or makes searches give wrong answers in silence. Faces and vertices are numbered from 0 in the order of the
//! input. Every decision is exact.

use super::fault::MeshFault;
use super::mesh::is_floor;
use super::weld::near_misses;
use crate::geometry::grouping::sorted;
use crate::ids::VertexId;
use crate::plane::predicates::{left_to_right, orientation};
use crate::plane::{ArrangeOptions, ConvertError, Point, SegmentFault, SegmentsError, Subdivision};
use crate::topology::PolygonList;
use std::cmp::Ordering;

/// Every fault of faces that should be a navmesh, warnings last. `blocked` are the faces that are no part of the
/// domain, in increasing order: they need not be convex, and count as holes. Nothing in the list but warnings means
/// that the faces are a navmesh.
///
/// Faults of a face by itself come first, in the order of the faces; such a face is left out of what follows. Then
/// comes what does not fit along edges; if all fits there, vertices in wrong places and sides that meet, from left to
/// right. What nearly meets (closer than 3 · 10⁻⁴ of the extent of the map, and than a hundredth of each border side
/// there), and double corners, are only looked for if nothing else is wrong.
///
/// Cost: O(n log n) for n corners.
///
/// ```
/// use dcel_kit::navmesh::{MeshFault, mesh_faults};
/// use dcel_kit::{plane::Point, topology::PolygonList};
/// // The upper face runs past the corner (1, 1) of the lower ones.
/// let points = [(0., 0.), (1., 0.), (2., 0.), (2., 1.), (1., 1.), (0., 1.), (2., 2.), (0., 2.)].map(Point::from);
/// let mut faces = PolygonList::new();
/// [[0, 1, 4, 5], [1, 2, 3, 4], [5, 3, 6, 7]].iter().for_each(|face| faces.push_face(face));
/// let faults = mesh_faults(&points, &faces, &[]);
/// assert_eq!(faults, [MeshFault::TJunction { vertex: 4, face: 2, side: [5, 3] }]);
/// ```
#[must_use]
pub fn mesh_faults(points: &[Point], faces: &PolygonList, blocked: &[u32]) -> Vec<MeshFault> {
    let mut faults = Vec::new();
    for (vertex, point) in points.iter().enumerate() {
        if let Err(error) = point.check() {
            faults.push(MeshFault::Coordinate { vertex: vertex as u32, error });
        }
    }
    if !faults.is_empty() {
        return faults;
    }
    let is_open = |face: u32| blocked.binary_search(&face).is_err();
    let mut sides = Vec::new();
    for face in 0..faces.face_count() as u32 {
        let Some(corners) = faces.cycles(face as usize).next() else { continue };
        let rings = faces.cycles(face as usize).count() - 1;
        if rings > 0 && is_open(face) {
            faults.push(MeshFault::Rings { face, rings });
        }
        if let Err(fault) = shape(points, face, corners, is_open(face)) {
            faults.push(fault);
            continue;
        }
        for cycle in faces.cycles(face as usize) {
            let ends = cycle.iter().zip(cycle.iter().cycle().skip(1));
            sides.extend(ends.map(|(&from, &to)| Side { from, to, face }));
        }
    }
    sides.sort_unstable();
    let shared_sides = faults.len();
    for pair in sides.windows(2).filter(|pair| (pair[0].from, pair[0].to) == (pair[1].from, pair[1].to)) {
        let [Side { from, to, face: first }, Side { face: second, .. }] = [pair[0], pair[1]];
        faults.push(MeshFault::SameSide { first, second, from, to });
    }
    if faults.len() == shared_sides {
        meetings(points, &sides, &mut faults);
    }
    if faults.is_empty() {
        faults.extend(leftover(points, faces));
    }
    if faults.is_empty() {
        faults = near_misses(points, faces);
        double_corners(&sides, is_open, &mut faults);
    }
    faults
}

/// A side of a face, which lies on its left.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    from: u32,
    to: u32,
    face: u32,
}

/// The sides from one vertex to another; the list is sorted.
fn sides_between(sides: &[Side], from: u32, to: u32) -> impl Iterator<Item = &Side> {
    let first = sides.partition_point(|side| (side.from, side.to) < (from, to));
    sides[first..].iter().take_while(move |side| (side.from, side.to) == (from, to))
}

/// What is wrong with a face by itself.
fn shape(points: &[Point], face: u32, corners: &[u32], open: bool) -> Result<(), MeshFault> {
    if let Some(&corner) = corners.iter().find(|&&c| c as usize >= points.len()) {
        return Err(MeshFault::NoSuchVertex { face, corner, vertices: points.len() });
    }
    let n = corners.len();
    let distinct = sorted(corners.to_vec()).len();
    if distinct < 3 || distinct < n {
        return Err(MeshFault::FewCorners { face, corners: n, distinct });
    }
    let place = |k: usize| points[corners[k % n] as usize];
    let turn = |k: usize| orientation(place(k + n - 1), place(k), place(k + 1));
    let turns: Vec<Ordering> = (0..n).map(turn).collect();
    if turns.iter().all(|turn| turn.is_eq()) {
        return Err(MeshFault::Flat { face });
    }
    // At the leftmost corner, the lowest of them, a simple face turns the way it runs.
    let leftmost = (0..n).min_by(|&a, &b| left_to_right(place(a), place(b))).unwrap_or(0);
    let runs = (0..n).map(|k| turns[(leftmost + k) % n]).find(|turn| turn.is_ne());
    if runs == Some(Ordering::Less) {
        return Err(MeshFault::Clockwise { face });
    }
    if !open {
        return Ok(());
    }
    let goes_back = |k: usize| {
        turns[k].is_eq() && left_to_right(place(k + n - 1), place(k)) != left_to_right(place(k), place(k + 1))
    };
    if let Some(k) = (0..n).find(|&k| turns[k].is_lt() || goes_back(k)) {
        return Err(MeshFault::NotConvex { face, vertex: corners[k] });
    }
    // A convex face goes once to the right and once back to the left.
    let ways = (0..n).map(|k| left_to_right(place(k), place(k + 1)));
    let changes = ways.clone().zip(ways.cycle().skip(1)).filter(|(a, b)| a != b).count();
    if changes > 2 { Err(MeshFault::Winds { face }) } else { Ok(()) }
}

/// Sides that meet elsewhere than at common ends, and vertices at the same place.
fn meetings(points: &[Point], sides: &[Side], faults: &mut Vec<MeshFault>) {
    // Each edge once, by its lesser end; the face is one of those beside it.
    let mut edges: Vec<Side> =
        sides.iter().map(|s| if s.from <= s.to { *s } else { Side { from: s.to, to: s.from, ..*s } }).collect();
    edges.sort_unstable();
    edges.dedup_by_key(|edge| (edge.from, edge.to));
    // Only points that are used, so that the others are not in anybody's way.
    let used = sorted(edges.iter().flat_map(|edge| [edge.from, edge.to]).collect());
    let number = |v: u32| used.partition_point(|&u| u < v) as u32;
    let places: Vec<Point> = used.iter().map(|&v| points[v as usize]).collect();
    let segments: Vec<[u32; 2]> = edges.iter().map(|edge| [number(edge.from), number(edge.to)]).collect();
    let Err(SegmentsError::Faults { faults: found, more }) =
        Subdivision::arrange_graph(&places, &segments, &ArrangeOptions::default())
    else {
        return;
    };
    let named = found.len();
    let before = faults.len();
    // Sides of one line with a face on one side each, and not the same: neighbours that lack a corner, which is told
    // as a T-junction.
    let is_beside = |a: Side, b: Side| {
        let ways = |edge: Side| {
            let [p, q] = [edge.from, edge.to].map(|v| points[v as usize]);
            let has = |from, to| sides_between(sides, from, to).next().is_some();
            let (there, back) = (has(edge.from, edge.to), has(edge.to, edge.from));
            if left_to_right(p, q).is_lt() { (there, back) } else { (back, there) }
        };
        let ((a_there, a_back), (b_there, b_back)) = (ways(a), ways(b));
        !(a_there && b_there || a_back && b_back)
    };
    for fault in found {
        let edge = |i: u32| edges[i as usize];
        let ends = |i: u32| [edge(i).from, edge(i).to];
        let fault = match fault {
            SegmentFault::SamePlace { first, second, at } => {
                MeshFault::SamePlace { first: used[first as usize], second: used[second as usize], at }
            }
            SegmentFault::Touching { segment, at, on } => {
                let [from, to] = ends(segment);
                let vertex = if points[from as usize] == at { from } else { to };
                t_junction(sides, edge(on), vertex)
            }
            SegmentFault::PointOnSegment { point, on, .. } => t_junction(sides, edge(on), used[point as usize]),
            SegmentFault::Overlapping { first, second, .. } if is_beside(edge(first), edge(second)) => continue,
            SegmentFault::Crossing { first, second, at }
            | SegmentFault::Overlapping { first, second, from: at, .. } => MeshFault::Overlap {
                first: edge(first).face,
                second: edge(second).face,
                sides: [ends(first), ends(second)],
                at,
            },
            // Edges have two different ends, and each is there once.
            SegmentFault::ZeroLength { .. } | SegmentFault::Repeated { .. } => continue,
        };
        if !faults[before..].contains(&fault) {
            faults.push(fault);
        }
    }
    if more {
        faults.push(MeshFault::More { named });
    }
}

/// The side as its face has it.
fn t_junction(sides: &[Side], edge: Side, vertex: u32) -> MeshFault {
    let forward = Side { face: edge.face, ..edge };
    let is_forward = sides.binary_search(&forward).is_ok();
    let side = if is_forward { [edge.from, edge.to] } else { [edge.to, edge.from] };
    MeshFault::TJunction { vertex, face: edge.face, side }
}

/// What only the converter sees: faces inside others.
fn leftover(points: &[Point], faces: &PolygonList) -> Option<MeshFault> {
    match Subdivision::from_polygons(points.to_vec(), faces).err()? {
        ConvertError::InsideFace { face, vertex } => Some(MeshFault::Covers { face, vertex }),
        other => Some(MeshFault::Convert(other)),
    }
}

/// Vertices from which more than one side starts that has no open face behind it.
fn double_corners(sides: &[Side], is_open: impl Fn(u32) -> bool, faults: &mut Vec<MeshFault>) {
    let has_open = |from, to| sides_between(sides, from, to).any(|side| is_open(side.face));
    for same in sides.chunk_by(|a, b| a.from == b.from) {
        let holes = same.iter().filter(|side| is_open(side.face) && !has_open(side.to, side.from)).count();
        if holes > 1 {
            faults.push(MeshFault::DoubleCorner { vertex: same[0].from, holes });
        }
    }
}

/// The double corners of a subdivision: vertices round which several holes lie, each between faces of the domain.
///
/// Cost: O(half-edges).
#[must_use]
pub fn double_corners_of(map: &Subdivision) -> Vec<VertexId> {
    let is_open = |f| is_floor(map, f);
    let holes = |v: &VertexId| {
        map.outgoing_half_edges(*v).filter(|&h| is_open(map.face(h)) && !is_open(map.face(h.twin()))).count()
    };
    map.vertices().filter(|v| holes(v) > 1).collect()
}
