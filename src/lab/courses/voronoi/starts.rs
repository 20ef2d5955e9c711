//! The triangulations that cases begin with: points, joined by the kit's own Delaunay triangulation.

use crate::cases::handouts::SITES;
use crate::cases::numbers::renumbered;
use crate::cases::random::Random;
use crate::cases::starts::triangles;
use crate::protocol::Start;
use dcel_kit::FaceId;
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::{FaceRow, Table};

/// A triangulation as a case states it, and what it is like.
#[derive(Clone)]
pub(super) struct Given {
    pub(super) name: String,
    pub(super) start: Start,
    pub(super) sites: usize,
    pub(super) half_edges: usize,
}

/// The Delaunay triangulation of some points; nothing if they have none.
pub(super) fn delaunay(points: &[[f64; 2]]) -> Option<Subdivision> {
    let points: Vec<Point> = points.iter().copied().map(Point::from).collect();
    let built = Subdivision::delaunay(&points).ok()?.subdivision;
    (built.faces().count() > 1).then_some(built)
}

/// The Delaunay triangulation of some points, stated as triangles.
pub(super) fn of_points(name: &str, points: &[[f64; 2]]) -> Option<Given> {
    let built = delaunay(points)?;
    let place = |p: Point| [p.x, p.y];
    let places: Vec<[f64; 2]> = built.vertices().map(|v| place(built.point(v))).collect();
    let corners = |f| built.incident_vertices(f).map(dcel_kit::VertexId::number).collect::<Vec<u32>>().try_into().ok();
    let faces: Vec<[u32; 3]> = built.faces().skip(1).map(corners).collect::<Option<_>>()?;
    let half_edges = built.half_edges().count();
    Some(Given { name: name.to_owned(), start: triangles(&places, &faces), sites: places.len(), half_edges })
}

/// The same with another number for the outer face, that of a triangle; every record is written out.
pub(super) fn with_outer_face(name: &str, points: &[[f64; 2]], number: u32) -> Option<Given> {
    let built = delaunay(points)?;
    let table = Table::from_planar_view(&built);
    let outer = table.outer_face?;
    let number = FaceId::new(number);
    let exchanged = |f: FaceId| match f {
        _ if f == outer => number,
        _ if f == number => outer,
        _ => f,
    };
    let mut table = renumbered(&table, |v| v, |h| h, exchanged);
    table.faces.iter_mut().flatten().for_each(|row| *row = FaceRow { half_edge: row.half_edge, ..FaceRow::default() });
    let (sites, half_edges) = (table.vertices.len(), table.half_edges.len());
    Some(Given { name: name.to_owned(), start: Start::table(table), sites, half_edges })
}

/// Points that are always the same, the simplest first.
pub(super) fn fixed() -> Vec<Given> {
    let square = |n: usize| (0..n * n).map(move |k| [(k % n) as f64, (k / n) as f64]).collect::<Vec<_>>();
    let hexagon = vec![[0., 0.], [6., 0.], [3., 5.], [-3., 5.], [-6., 0.], [-3., -5.], [3., -5.]];
    let mut all = vec![
        ("triangle", vec![[0., 0.], [4., 0.], [1., 3.]]),
        ("obtuse", vec![[0., 0.], [10., 0.], [4., 2.]]),
        ("four", vec![[0., 0.], [5., -1.], [6., 4.], [1., 5.]]),
        ("square", square(2)),
        ("inside", vec![[0., 0.], [9., 0.], [3., 8.], [4., 3.]]),
        ("hexagon", hexagon),
        ("grid", square(3)),
        ("larger_grid", square(5)),
        ("handout", SITES.to_vec()),
        ("tenths", vec![[0.1, 0.2], [3.3, 0.7], [2.9, 2.3], [0.3, 3.1], [1.7, 1.3]]),
        ("tiny", vec![[1e-30, 0.], [5e-30, 1e-30], [3e-30, 4e-30], [3e-30, 1.5e-30]]),
    ];
    let far = 1_000_000_000_000.0;
    all.push(("far", vec![[far, far], [far + 5., far - 1.], [far + 6., far + 4.], [far + 1., far + 5.]]));
    all.push(("fan", (0..40).map(|k| [f64::from(k), f64::from(k * k)]).chain([[-300., 800.]]).collect()));
    let mut random = Random::new(8, "large");
    all.push(("large", random.places(160, 10_000)));
    let mut all: Vec<Given> = all.into_iter().filter_map(|(name, points)| of_points(name, &points)).collect();
    all.extend(with_outer_face("outer_last", &[[0., 0.], [9., 0.], [3., 8.], [4., 3.]], 3));
    all.extend(with_outer_face("outer_between", &square(3), 4));
    all
}

/// Points that look random, few of them in a small grid so that some lie on one circle.
pub(super) fn random(random: &mut Random, name: &str, most: usize) -> Option<Given> {
    let count = 4 + random.below(most);
    let size = if random.below(2) == 0 { 7 } else { 1000 };
    let places = random.places(count, size);
    // About every third time the outer face has another number than 0.
    let faces = delaunay(&places)?.faces().count();
    match random.below(3) {
        0 => with_outer_face(name, &places, 1 + random.below(faces - 1) as u32),
        _ => of_points(name, &places),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::plane::predicates::orientation;
    use dcel_kit::topology::violations;

    #[test]
    fn all_points_have_a_triangulation() {
        assert_eq!(fixed().len(), 16);
        let mut from = Random::new(2, "starts");
        for i in 0..50 {
            assert!(random(&mut from, "x", 12).is_some(), "{i}");
        }
    }

    #[test]
    fn the_outer_face_gets_the_number_that_is_asked_for_and_the_laws_hold() {
        let points = [[0., 0.], [9., 0.], [3., 8.], [4., 3.]];
        for number in 0..4 {
            let given = with_outer_face("x", &points, number).unwrap();
            let table = given.start.half_edges().unwrap();
            assert_eq!(violations(table.as_ref()), []);
            assert_eq!(table.outer_face, Some(FaceId::new(number)));
            let triangles: Vec<_> = crate::courses::voronoi::duals::triangles(table).collect();
            assert_eq!(triangles.len(), 3);
            for f in triangles {
                let [a, b, c] = crate::courses::voronoi::duals::corners(table, f).unwrap().map(Point::from);
                assert!(orientation(a, b, c).is_gt(), "{f} turns left, so it is none of the outside");
            }
        }
    }
}
