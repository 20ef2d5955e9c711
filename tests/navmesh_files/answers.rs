//! Maps, queries and lengths stated by others: what comes out of the readers is what they were meant to hold.

use crate::{data, plane};
use dcel_kit::io::{Format, Grid, Optimum, Scenario};
use dcel_kit::navmesh::{Inset, NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};

/// The lengths that the kit finds, none where it finds no way, and how many agree with the file.
fn lengths(map: &Subdivision, scenario: &Scenario, y_down: bool, tolerance: f64) -> (Vec<Option<f64>>, usize) {
    let mesh = NavMesh::new(map).expect("convex faces");
    let mut planner = Planner::new();
    let place = |p: Point| Point::new(p.x, if y_down { 0.0 - p.y } else { p.y });
    // At a double corner the files say that there is no clear place to start or end.
    let route = |q: &dcel_kit::io::Query| {
        let [start, goal] = [q.start, q.goal].map(|p| mesh.place(place(p)).ok());
        planner.route(&mesh, PathAlgorithm::Exact, &start?, &goal?).ok().map(|route| route.length)
    };
    let found: Vec<Option<f64>> = scenario.queries.iter().map(route).collect();
    let optimum = scenario.optimum();
    let agree = scenario.queries.iter().zip(&found).filter(|(q, found)| q.agrees(**found, optimum, tolerance)).count();
    (found, agree)
}

fn triangulated(mut map: Subdivision) -> Subdivision {
    map.triangulate(TriangulationMethod::default()).expect("a sound map");
    map
}

fn check_grid(map: &[u8], scenario: &[u8], count: usize) {
    let scenario = Scenario::parse(scenario, "queries").expect("a scenario");
    assert_eq!((scenario.queries.len(), scenario.optimum()), (count, Optimum::Euclidean));
    let (found, agree) = lengths(&plane(map, Format::Map), &scenario, true, 1e-9);
    assert_eq!(agree, count, "rectangles");
    let regions = Grid::parse(map, "map").expect("a map").regions().expect("regions");
    let (by_triangles, agree) = lengths(&triangulated(regions), &scenario, true, 1e-9);
    assert_eq!(agree, count, "triangles");
    for (a, b) in found.iter().zip(&by_triangles) {
        assert_eq!(a.is_some(), b.is_some());
    }
}

/// The stated lengths are those of a visibility graph, made in another language with exact fractions.
#[test]
fn the_rooms_have_the_lengths_of_a_visibility_graph() {
    check_grid(include_bytes!("../../figures/data/rooms.map"), include_bytes!("../../figures/data/rooms.scen"), 24);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn all_201_published_lengths_of_the_cape_are_met() {
    let read = |name: &str| std::fs::read(data("O15-gppc-acrossthecape").join(name)).expect("the file");
    check_grid(&read("AcrosstheCape.map"), &read("AcrosstheCape.map.scen"), 201);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_degenerate_meshes_have_their_stated_lengths_and_refusals() {
    // What the page of the data states; the columns of the files are not these numbers.
    let cases: [(&str, &[Option<f64>], f64); 6] = [
        ("bad-ambig", &[Some(3.98010), None, None, None], 1e-5),
        ("bad-collinear", &[Some(7.41221)], 1e-5),
        ("bad-collinear2-rot0", &[Some(6.0)], 1e-12),
        ("bad-collinear2-rot45", &[Some(6.0)], 1e-12),
        ("bad-collinear2-rot90", &[Some(6.0)], 1e-12),
        ("square", &[Some(std::f64::consts::FRAC_1_SQRT_2)], 1e-12),
    ];
    for (name, stated, tolerance) in cases {
        let read =
            |ending: &str| std::fs::read(data("O16-navmesh-tests").join(format!("{name}.{ending}"))).expect("the file");
        let scenario = Scenario::parse(&read("scen"), name).expect("a scenario");
        let (found, _) = lengths(&triangulated(plane(&read("mesh"), Format::Mesh)), &scenario, false, 1e-9);
        assert_eq!(found.len(), stated.len(), "{name}");
        for (found, stated) in found.iter().zip(stated) {
            match (found, stated) {
                (Some(found), Some(stated)) => assert!((found - stated).abs() <= tolerance, "{name}: {found}"),
                (found, stated) => assert_eq!(found, stated, "{name}"),
            }
        }
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_octile_costs_of_the_arena_bound_the_exact_lengths() {
    let read = |name: &str| std::fs::read(data("O09-polyanya-arena").join(name)).expect("the file");
    let scenario = Scenario::parse(&read("arena.scen"), "arena").expect("a scenario");
    let mut all = Vec::new();
    for mesh in ["arena.mesh", "arena-merged.mesh"] {
        let (found, agree) = lengths(&plane(&read(mesh), Format::Mesh), &scenario, false, 1e-9);
        assert_eq!(agree, 160, "{mesh}");
        all.push(found);
    }
    // Triangles and merged faces are the same floor.
    for (a, b) in all[0].iter().zip(&all[1]) {
        let (a, b) = (a.expect("a way"), b.expect("a way"));
        assert!((a - b).abs() <= 1e-12 * a.max(1.0), "{a} {b}");
    }
}

#[test]
fn agreement_means_what_it_says() {
    let parse = |line: &str| Scenario::parse(line.as_bytes(), "queries").expect("a scenario").queries.remove(0);
    let (ten, none) = (parse("0 a 9 9 0 0 6 8 10"), parse("0 a 9 9 0 0 6 8 -1"));
    // Six digits are printed, and no zeros at the end: 10 may have been anything from 9.99995 to 10.00005.
    for (found, right) in
        [(Some(10.0), true), (Some(10.00004), true), (Some(10.00006), false), (Some(9.99994), false), (None, false)]
    {
        assert_eq!(ten.agrees(found, Optimum::Euclidean, 1e-9), right, "{found:?}");
    }
    assert!(none.agrees(None, Optimum::Euclidean, 1e-9) && !none.agrees(Some(1.0), Optimum::Euclidean, 1e-9));
    let octile = parse("0 a 9 9 0 0 6 8 10.48528");
    for (found, right) in [(Some(10.0), true), (Some(10.485284), true), (Some(10.485286), false), (Some(9.9), false)] {
        assert_eq!(octile.agrees(found, Optimum::Octile, 1e-9), right, "{found:?}");
    }
}

#[test]
fn a_floor_in_space_is_laid_flat_as_it_is_seen_from_above() {
    use dcel_kit::io::Axis;
    // A floor of two triangles; (x, y) on it, and where each axis convention puts that.
    let flat = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
    let put = |[x, y]: [f64; 2], up| match up {
        Axis::Z => [x, y, 7.0],
        Axis::Y => [x, 7.0, 0.0 - y],
        Axis::X => [7.0, x, y],
    };
    for up in [Axis::X, Axis::Y, Axis::Z] {
        let mut text = String::new();
        for p in flat {
            let [x, y, z] = put(p, up);
            text += &format!("v {x} {y} {z}\n");
        }
        text += "f 1 2 3\nf 1 3 4\n";
        let mut soup = crate::soup(text.as_bytes(), Format::Obj);
        soup.lay_flat(up);
        let points: Vec<[u64; 2]> = soup.points.iter().map(|p| [p[0].to_bits(), p[1].to_bits()]).collect();
        assert_eq!(points, flat.map(|p| p.map(f64::to_bits)), "{up:?}");
        assert!(!soup.has_z);
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn radii_with_the_usual_tolerance_leave_no_more_than_three_times_the_faces() {
    let bytes = std::fs::read(data("O09-polyanya-arena").join("arena.mesh")).expect("the file");
    let mesh = NavMesh::new(&plane(&bytes, Format::Mesh)).expect("convex faces");
    for radius in [0.25, 0.5, 1.0, 2.0] {
        let faces = |tolerance: f64| mesh.inset_within(radius, tolerance).expect("room").mesh().face_count();
        let usual = faces(Inset::TOLERANCE);
        assert!(usual <= 3 * mesh.face_count(), "radius {radius}: {usual} of {}", mesh.face_count());
        // Half of it is too fine: the usual one is about the finest that keeps the promise.
        if radius < 2.0 {
            assert!(faces(Inset::TOLERANCE / 2.0) > 3 * mesh.face_count(), "radius {radius}");
        }
    }
}
