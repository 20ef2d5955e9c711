//! Lines on surfaces that are straight in the plan: what they meet, and where they run.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use crate::surface::{far, lifted, list, off_triangle, spiral};
use dcel_kit::navmesh::{Floor, NavSurface};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;
use dcel_kit::{FaceId, VertexId};

type Space = [f64; 3];

/// Straight in the plan, a line on a hilly floor meets what it meets in the plane, at the height of the surface there.
#[test]
fn a_line_on_a_surface_meets_what_it_meets_in_the_plan() {
    let (mut hits, mut clear, mut passed) = (0, 0, 0);
    for seed in 0..60 {
        // Also where all lies on common lines: through vertices and along edges.
        let on_grid = seed % 3 == 0;
        let map = Map::random(seed + 900, 7, 0.85, if on_grid { 0.0 } else { 0.5 });
        let mesh = map.mesh();
        let mut heights = Random::new(seed);
        let surface = lifted(&map, |p| [p.x, p.y, 2.0 * heights.unit()]);
        assert_eq!(surface.layer_count(), 1);
        let mut random = Random::new(seed + 77);
        for _ in 0..40 {
            let mut at = || {
                let [x, y] = [(); 2].map(|()| 7.0 * random.unit());
                if on_grid { Point::new((2.0 * x).round() / 2.0, (2.0 * y).round() / 2.0) } else { Point::new(x, y) }
            };
            let [from, to] = [at(), at()];
            let (Ok(start), Ok(place)) = (surface.place([from.x, from.y], Floor::Any), mesh.place(from)) else {
                continue;
            };
            let context = format!("seed {seed}: {from} -> {to}");
            let flat = mesh.raycast_from(&place, to).expect("it begins on the mesh");
            let cast = surface.raycast(&start, [to.x, to.y]).expect("finite");
            assert_eq!(cast.hit.is_some(), flat.hit.is_some(), "{context}");
            let end = cast.points[cast.points.len() - 1];
            let expected = flat.hit.map_or(to, |hit| hit.point);
            assert!((end[0] - expected.x).hypot(end[1] - expected.y) < 1e-9, "{context}: {end:?}, and {expected}");
            if let (Some(hit), Some(in_plan)) = (cast.hit, flat.hit) {
                assert_eq!((hit.point, hit.vertex), (end, in_plan.vertex), "{context}");
                // It would go on to the right of a side of its last face; at a vertex of the face it came through, if that
                // has one there.
                let is_in_the_way = |[a, b]: [VertexId; 2]| orientation(mesh.point(a), mesh.point(b), to).is_lt();
                let closed = |f: FaceId| mesh.sides(f).filter(|side| !side.open).map(|side| [side.from, side.to]);
                assert!(is_in_the_way(hit.side) && cast.faces.last() == Some(&hit.face), "{context}: {hit:?}");
                assert!(closed(hit.face).any(|side| side == hit.side), "{context}: {hit:?}");
                if let (Some(v), &[.., before, _]) = (hit.vertex, &*cast.faces) {
                    assert!(hit.side.contains(&v), "{context}: {hit:?}");
                    let own = closed(before).find(|&side| side.contains(&v) && is_in_the_way(side));
                    assert_eq!(own, None, "{context}: {hit:?} after {before}");
                    passed += 1;
                }
                hits += 1;
            } else {
                clear += 1;
            }
            // It lies on the surface all along, and its length is the sum of its pieces.
            let sum: f64 = cast.points.windows(2).map(|pair| far(pair[0], pair[1])).sum();
            assert!(is_close(sum, cast.length) && cast.layers.len() + 1 == cast.points.len(), "{context}: {cast:?}");
            for pair in cast.points.windows(2) {
                let middle: Space = std::array::from_fn(|i| (pair[0][i] + pair[1][i]) / 2.0);
                let off = cast.faces.iter().flat_map(|&f| surface.triangles(f)).map(|t| off_triangle(middle, t));
                assert!(off.fold(f64::INFINITY, f64::min) < 1e-9, "{context}: {middle:?} is off the surface");
            }
        }
    }
    assert!(hits > 300 && clear > 100, "{hits} hits, {clear} clear");
    assert!(passed > 5, "{passed} hits at vertices of other faces than the line came through");
}

#[test]
fn a_line_stays_on_its_storey_and_climbs_ramps() {
    let (points, faces) = spiral(3, 16, 2.0);
    let surface = NavSurface::new(&points, &list(&faces), None).expect("a ramp");
    assert!(surface.layer_count() > 1);
    for place in surface.random_places(5).take(200) {
        let cast = surface.raycast(&place, [0.0, 0.0]).expect("finite");
        // The way to the axis is barred by the inner border of the very turn it starts from.
        let hit = cast.hit.unwrap_or_else(|| panic!("{place:?} sees the axis"));
        assert!((hit.point[2] - place.point[2]).abs() < 2.0 / 3.0, "{place:?} leaps to {hit:?}");
        assert_eq!(cast.faces[0], place.face);
    }
}
