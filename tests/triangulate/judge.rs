//! What must hold of every triangulation, looked at from outside.

use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Point, Subdivision, Triangulated, TriangulationMethod};
use dcel_kit::topology::{InnerComponent, violations};
use dcel_kit::{FaceId, FaceMap, HalfEdgeId};

pub(crate) const METHODS: [TriangulationMethod; 3] =
    [TriangulationMethod::Ears, TriangulationMethod::Monotone, TriangulationMethod::Delaunay];

/// Twice the signed area of a closed walk with whole coordinates, exactly.
fn doubled_area(corners: &[Point]) -> i128 {
    let whole = |x: f64| {
        assert!(x.fract() == 0.0 && x.abs() < 1e15, "{x} is no small whole number");
        x as i128
    };
    let turn = |i: usize| {
        let (p, q) = (corners[i], corners[(i + 1) % corners.len()]);
        whole(p.x) * whole(q.y) - whole(q.x) * whole(p.y)
    };
    (0..corners.len()).map(turn).sum()
}

fn corners(s: &Subdivision, h: HalfEdgeId) -> Vec<Point> {
    s.cycle(h).map(|h| s.point(s.origin(h))).collect()
}

/// Twice the area of a face: rings run the other way round and so count as negative.
fn doubled_area_of_face(s: &Subdivision, f: FaceId) -> i128 {
    s.cycles(f).map(|h| doubled_area(&corners(s, h))).sum()
}

/// The triangles that a face must fall into.
pub(crate) fn triangles_due(s: &Subdivision, f: FaceId) -> usize {
    let cycles: Vec<_> = s.cycles(f).collect();
    let isolated = s.inner_components(f).iter().filter(|ring| matches!(ring, InnerComponent::Isolated(_))).count();
    let half_edges: usize = cycles.iter().map(|&h| s.cycle(h).count()).sum();
    half_edges + 2 * (cycles.len() - 1 + isolated) - 2
}

/// The invariants that hold for any coordinates, for the faces `cut` of `before`.
pub(crate) fn judge(before: &Subdivision, cut: &[FaceId], after: &Subdivision, added: &Triangulated) {
    assert_eq!((violations(after), after.geometry_violations()), (vec![], vec![]));
    let (v, e, f) = (before.vertex_count(), before.edge_count(), before.face_count());
    assert_eq!(after.vertex_count(), v, "no vertex comes or goes");
    assert_eq!((after.edge_count(), after.face_count()), (e + added.diagonals.len(), f + added.new_faces.len()));
    assert!(before.vertices().all(|v| before.point(v) == after.point(v)));
    for h in before.half_edges() {
        assert_eq!(before.origin(h), after.origin(h));
        assert!(cut.contains(&before.face(h)) || before.face(h) == after.face(h), "{h} is not of a face that was cut");
    }
    let mut came_from = FaceMap::filled(after.face_bound(), FaceId::new(0));
    before.faces().for_each(|f| came_from[f] = f);
    assert!(added.new_faces.is_sorted() && added.diagonals.iter().all(|&d| d.index() >= before.edge_bound()));
    added.new_faces.iter().for_each(|&(new, old)| came_from[new] = old);
    let mut triangles = FaceMap::filled(before.face_bound(), 0);
    for f in after.faces() {
        let old = came_from[f];
        assert_eq!(after.is_hole(f), before.is_hole(old), "{f}, a part of {old}");
        if !cut.contains(&old) {
            assert!(f == old && before.inner_components(f) == after.inner_components(f));
            continue;
        }
        triangles[old] += 1;
        assert!(after.inner_components(f).is_empty(), "{f} has rings");
        let triangle = corners(after, after.half_edge(f).unwrap());
        let [a, b, c] = triangle[..] else { panic!("{f} has {} corners", triangle.len()) };
        assert!(orientation(a, b, c).is_gt(), "{f} has no positive area");
    }
    for &f in cut {
        assert_eq!(triangles[f], triangles_due(before, f), "number of triangles of {f}");
        assert_eq!(before.half_edge(f), after.half_edge(f));
    }
    for &diagonal in &added.diagonals {
        let [left, right] = diagonal.half_edges().map(|h| came_from[after.face(h)]);
        assert!(left == right && cut.contains(&left), "{diagonal} lies in {left} and {right}");
    }
}

/// Judges all methods on all faces, with exact areas: coordinates must be whole.
pub(crate) fn judge_whole(before: &Subdivision) {
    let bounded: Vec<FaceId> = before.faces().skip(1).filter(|&f| !before.is_hole(f)).collect();
    for method in METHODS {
        let mut after = before.clone();
        let added = after.triangulate(method).unwrap_or_else(|error| panic!("{method:?}: {error}"));
        judge(before, &bounded, &after, &added);
        if method == TriangulationMethod::Delaunay {
            let slivers = after.non_delaunay_edges(|e| e.index() < before.edge_bound());
            assert_eq!(slivers.collect::<Vec<_>>(), [], "diagonals that are not locally Delaunay");
        }
        let mut areas = FaceMap::filled(before.face_bound(), 0);
        let mut came_from = FaceMap::filled(after.face_bound(), FaceId::new(0));
        added.new_faces.iter().for_each(|&(new, old)| came_from[new] = old);
        bounded.iter().for_each(|&f| came_from[f] = f);
        after.faces().skip(1).filter(|&f| !after.is_hole(f)).for_each(|f| areas[came_from[f]] += area(&after, f));
        for &f in &bounded {
            assert_eq!(areas[f], doubled_area_of_face(before, f), "{method:?}: area of {f}");
        }
    }
}

fn area(s: &Subdivision, f: FaceId) -> i128 {
    let area = doubled_area_of_face(s, f);
    assert!(area > 0);
    area
}

/// The subdivision of a polygon with whole coordinates.
pub(crate) fn polygon(points: &[(i32, i32)]) -> Subdivision {
    rings(&[points])
}

/// The subdivision of several closed lines.
pub(crate) fn rings(lists: &[&[(i32, i32)]]) -> Subdivision {
    let mut points = Vec::new();
    let mut edges = Vec::new();
    for list in lists {
        let first = points.len() as u32;
        let n = list.len() as u32;
        points.extend(list.iter().map(|&(x, y)| Point::new(f64::from(x), f64::from(y))));
        edges.extend((0..n).map(|i| [first + i, first + (i + 1) % n]));
    }
    Subdivision::from_graph(&points, &edges).unwrap_or_else(|error| panic!("{error}"))
}
