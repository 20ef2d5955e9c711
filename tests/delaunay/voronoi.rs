//! Voronoi diagrams: what is nearest, in cells that are a subdivision whatever rounding does.

use crate::common::{Random, f, v};
use crate::families::{FAMILIES, circle, points, unit};
use dcel_kit::plane::{CoordinateError, Point, Subdivision, VoronoiCells, VoronoiError, Window};
use dcel_kit::topology::InnerComponent;
use dcel_kit::{FaceId, VertexId};

fn delaunay(points: &[Point]) -> Subdivision {
    Subdivision::delaunay(points).unwrap().subdivision
}

/// Whether the point lies inside the face, by the even-odd rule over all its cycles.
fn holds(s: &Subdivision, face: FaceId, p: Point) -> bool {
    let ends = s.cycles(face).flat_map(|h| s.cycle(h)).map(|h| (s.point(s.origin(h)), s.point(s.destination(h))));
    let crosses = |&(a, b): &(Point, Point)| {
        (a.y > p.y) != (b.y > p.y) && {
            let turn = dcel_kit::plane::predicates::orientation(a, b, p);
            if b.y > a.y { turn.is_gt() } else { turn.is_lt() }
        }
    };
    ends.filter(crosses).count() % 2 == 1
}

/// The invariants of the structure, and one cell for each site, which holds it and no other.
#[track_caller]
fn check_cells(sites: &Subdivision, cells: &VoronoiCells, context: &str) {
    let s = &cells.subdivision;
    assert_eq!(dcel_kit::topology::violations(s), [], "{context}");
    assert_eq!(s.geometry_violations(), [], "{context}");
    assert_eq!(s.face_count(), sites.vertex_count() + 1, "{context}");
    let parts = |e: &dcel_kit::EdgeId| {
        let [h, twin] = e.half_edges();
        s.face(h) != s.face(twin)
    };
    assert_eq!(s.edges().find(|e| !parts(e)), None, "{context}: it parts nothing");
    assert_eq!(s.vertices().find(|&v| s.outgoing_half_edges(v).count() < 2), None, "{context}: it bounds nothing");
    for site in sites.vertices() {
        let cell = cells.cells[site].unwrap_or_else(|| panic!("{context}: {site} has no cell"));
        assert_eq!(cells.sites[cell], Some(site), "{context}");
        for other in sites.vertices() {
            assert_eq!(holds(s, cell, sites.point(other)), other == site, "{context}: {other} in the cell of {site}");
        }
    }
}

fn distance(p: Point, q: Point) -> f64 {
    (p.x - q.x).hypot(p.y - q.y)
}

#[test]
fn the_cell_around_a_point_is_that_of_the_nearest_site() {
    for family in ["random", "grid", "line", "circle", "slanted line"] {
        for seed in 0..8 {
            let mut random = Random(seed);
            let n = 1 + random.below(30);
            let sites = delaunay(&points(family, n, &mut random));
            let context = format!("{family}, seed {seed}, {n} points");
            let places: Vec<Point> = sites.vertices().map(|v| sites.point(v)).collect();
            let window = Window::around(&places);
            let cells = sites.voronoi().unwrap().cells(window).unwrap();
            check_cells(&sites, &cells, &context);
            assert_eq!(cells.slivers, 0, "{context}");
            let (width, height) = (window.high.x - window.low.x, window.high.y - window.low.y);
            for _ in 0..60 {
                let p = Point::new(
                    window.low.x + (0.001 + 0.998 * unit(&mut random)) * width,
                    window.low.y + (0.001 + 0.998 * unit(&mut random)) * height,
                );
                let mut near: Vec<(f64, VertexId)> =
                    sites.vertices().map(|v| (distance(sites.point(v), p), v)).collect();
                near.sort_by(|a, b| a.0.total_cmp(&b.0));
                // Too near to an edge to tell by doubles.
                if near.len() > 1 && near[1].0 - near[0].0 < 1e-9 * (width + height) {
                    continue;
                }
                assert!(holds(&cells.subdivision, cells.cells[near[0].1].unwrap(), p), "{context}: {p}");
            }
        }
    }
}

#[test]
fn corners_are_as_far_from_their_sites_and_no_site_is_nearer() {
    let sites = delaunay(&points("random", 60, &mut Random(5)));
    let voronoi = sites.voronoi().unwrap();
    assert_eq!(voronoi.corners().len(), sites.face_count() - 1);
    for edge in voronoi.edges() {
        let [p, q] = edge.sites.map(|v| sites.point(v));
        let [middle, along] = voronoi.line(edge);
        let turned =
            dcel_kit::plane::predicates::orientation(middle, Point::new(middle.x + along.x, middle.y + along.y), p);
        assert!(turned.is_gt(), "the first site lies on the left of {edge:?}");
        for corner in edge.ends.into_iter().flatten().map(|corner| voronoi.corners()[corner as usize]) {
            let radius = distance(corner, p);
            assert!((distance(corner, q) - radius).abs() <= 1e-9 * radius, "{edge:?}");
            let nearer = sites.vertices().filter(|&v| distance(sites.point(v), corner) < radius * (1.0 - 1e-9));
            assert_eq!(nearer.count(), 0, "{edge:?}");
        }
        if let [Some(from), Some(to)] = edge.ends.map(|end| end.map(|corner| voronoi.corners()[corner as usize])) {
            let forward = (to.x - from.x) * along.x + (to.y - from.y) * along.y;
            assert!(forward > 0.0, "{edge:?} runs backwards");
        }
    }
    let infinite = voronoi.edges().iter().filter(|edge| edge.ends.contains(&None)).count();
    assert_eq!(infinite, sites.incident_half_edges(sites.outer_face()).count());
    for face in sites.faces().skip(1) {
        assert!(voronoi.corner_of(face).is_some());
    }
    assert_eq!(voronoi.corner_of(f(0)), None);
}

#[test]
fn corners_of_one_circle_are_one_vertex() {
    let grid: Vec<Point> = (0..36).map(|i| Point::new((i % 6) as f64, (i / 6) as f64)).collect();
    let sites = delaunay(&grid);
    let voronoi = sites.voronoi().unwrap();
    assert_eq!((voronoi.corners().len(), voronoi.edges().len()), (25, 60));
    let cells = voronoi.cells(Window::around(&grid)).unwrap();
    check_cells(&sites, &cells, "grid");
    let s = &cells.subdivision;
    assert_eq!(s.vertices().filter(|&v| s.degree(v) == 4).count(), 25);

    let wheel = delaunay(&circle());
    let voronoi = wheel.voronoi().unwrap();
    assert_eq!((voronoi.corners(), voronoi.edges().len()), (&[Point::new(0.0, 0.0)][..], 36));
    let window = Window { low: Point::new(-80.0, -80.0), high: Point::new(80.0, 80.0) };
    let cells = voronoi.cells(window).unwrap();
    check_cells(&wheel, &cells, "circle");
    assert_eq!(cells.subdivision.vertices().map(|v| cells.subdivision.degree(v)).max(), Some(36));

    // On a line: parallel edges that come from infinity and run there.
    let row = delaunay(&[1, 4, 2].map(|x| Point::new(f64::from(x), 7.0)));
    let voronoi = row.voronoi().unwrap();
    assert!(voronoi.corners().is_empty() && voronoi.edges().iter().all(|edge| edge.ends == [None, None]));
    check_cells(&row, &voronoi.cells(Window::around(&[Point::new(0.0, 6.0), Point::new(5.0, 8.0)])).unwrap(), "row");
}

/// Corners closer than doubles can tell: a valid subdivision with a cell for every site, or a refusal by name.
#[test]
fn rounding_never_makes_an_invalid_subdivision() {
    for seed in 0..6 {
        let mut random = Random(seed);
        let places: Vec<Point> = (0..64)
            .map(|i| {
                let mut jitter = |x: usize| (1 + x) as f64 * (1.0 + random.below(5) as f64 * f64::EPSILON);
                Point::new(jitter(i % 8), jitter(i / 8))
            })
            .collect();
        let sites = delaunay(&places);
        let cells = sites.voronoi().unwrap().cells(Window::around(&places)).unwrap();
        check_cells(&sites, &cells, &format!("jitter, seed {seed}"));
    }
    // Many corners about one place, where doubles are coarse.
    for seed in 0..8 {
        let mut random = Random(seed);
        let places: Vec<Point> = circle()
            .into_iter()
            .map(|p| {
                let mut jitter =
                    |x: f64| (1000.0 + x) * (1.0 + random.below(3 + 20 * (seed as usize % 2)) as f64 * f64::EPSILON);
                Point::new(jitter(p.x), jitter(p.y))
            })
            .collect();
        let sites = delaunay(&places);
        let cells = sites.voronoi().unwrap().cells(Window::around(&places)).unwrap();
        check_cells(&sites, &cells, &format!("circle, seed {seed}"));
    }
    let (mut made, mut refused) = (0, 0);
    for family in FAMILIES {
        for seed in 50..70 {
            let given = points(family, 25, &mut Random(seed));
            let sites = delaunay(&given);
            let context = format!("{family}, seed {seed}");
            match sites.voronoi().unwrap().cells(Window::around(&given)) {
                Ok(cells) => check_cells(&sites, &cells, &context),
                Err(VoronoiError::TooClose { site, other }) => {
                    assert!(sites.has_vertex(site) && sites.has_vertex(other), "{context}");
                    assert!(["1-ulp", "far outlier", "long and thin", "clusters"].contains(&family), "{context}");
                    refused += 1;
                }
                Err(error) => panic!("{context}: {error}"),
            }
            made += 1;
        }
    }
    assert!(made > 170 && refused > 0, "{made}, {refused} refused");
}

#[test]
fn every_refusal_has_its_name() {
    let places = [(0., 0.), (4., 0.), (4., 3.), (0., 3.), (2., 1.)].map(Point::from);
    let good = delaunay(&places);
    let window = Window::around(&places);
    let voronoi = good.voronoi().unwrap();
    assert_eq!(delaunay(&[]).voronoi(), Err(VoronoiError::NoSite));

    let square = Subdivision::polygon(&places[..4]).unwrap();
    assert_eq!(square.voronoi(), Err(VoronoiError::NotTriangle { face: f(1) }));
    let mut kite = Subdivision::from_triangles(
        [(0., 0.), (3., -1.), (6., 0.), (3., 1.)].map(Point::from).to_vec(),
        &[[0, 1, 2], [0, 2, 3]],
    )
    .unwrap();
    let edge = kite.find_half_edge(v(0), v(2)).unwrap().edge();
    assert_eq!(kite.voronoi(), Err(VoronoiError::NotDelaunay { edge }));
    kite.make_delaunay(|_| false);
    assert_eq!(kite.voronoi().unwrap().edges().len(), 5);
    let arrow = [(0., 0.), (4., 0.), (1., 1.), (0., 4.)].map(Point::from).to_vec();
    let arrow = Subdivision::from_triangles(arrow, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    assert_eq!(arrow.voronoi(), Err(VoronoiError::NotConvex { vertex: v(2) }));
    let mut lonely = good.clone();
    let added = lonely.insert_vertex(Point::new(9.0, 9.0)).unwrap();
    assert_eq!(lonely.voronoi(), Err(VoronoiError::NotConvex { vertex: v(5) }), "{added:?}");
    assert!(matches!(lonely.inner_components(f(0))[0], InnerComponent::Isolated(_)));

    let outside = Window { low: Point::new(-1.0, -1.0), high: Point::new(4.0, 5.0) };
    assert_eq!(voronoi.cells(outside), Err(VoronoiError::SiteOutside { site: v(1), point: places[1] }));
    let empty = Window { low: window.high, high: window.low };
    assert!(matches!(voronoi.cells(empty), Err(VoronoiError::EmptyWindow { .. })));
    let endless = Window { low: Point::new(f64::NEG_INFINITY, 0.0), ..window };
    let error = VoronoiError::Coordinate(CoordinateError::NotFinite { axis: 'x', value: f64::NEG_INFINITY });
    assert_eq!(voronoi.cells(endless), Err(error));
    // Neighbouring doubles: no number lies between them.
    let close = delaunay(&[Point::new(1.0, 0.0), Point::new(1.0 + f64::EPSILON, 0.0)]);
    let found = close.voronoi().unwrap().cells(Window::around(&[Point::new(0.0, 0.0), Point::new(2.0, 1.0)]));
    assert_eq!(found, Err(VoronoiError::TooClose { site: v(0), other: v(1) }));
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_cells_of_a_map_program() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/O04-turf/turf-voronoi/test");
    let json = |name: &str| -> serde_json::Value {
        serde_json::from_str(&std::fs::read_to_string(folder.join(name)).unwrap()).unwrap()
    };
    let point = |xy: &serde_json::Value| Point::new(xy[0].as_f64().unwrap(), xy[1].as_f64().unwrap());
    for name in ["simple", "ninepoints", "with-properties", "world"] {
        let (given, stated) = (json(&format!("in/{name}.json")), json(&format!("out/{name}.json")));
        let places: Vec<Point> =
            given["features"].as_array().unwrap().iter().map(|site| point(&site["geometry"]["coordinates"])).collect();
        let polygons = stated["features"].as_array().unwrap();
        let rings = polygons.iter().map(|cell| cell["geometry"]["coordinates"][0].as_array().unwrap());
        let rings: Vec<Vec<Point>> = rings.map(|ring| ring.iter().map(point).collect()).collect();
        let corners = rings.concat();
        let fold = |f: fn(f64, f64) -> f64, of: fn(&Point) -> f64| corners.iter().map(of).reduce(f).unwrap();
        let window = Window {
            low: Point::new(fold(f64::min, |p| p.x), fold(f64::min, |p| p.y)),
            high: Point::new(fold(f64::max, |p| p.x), fold(f64::max, |p| p.y)),
        };
        let built = Subdivision::delaunay(&places).unwrap();
        let cells = built.subdivision.voronoi().unwrap().cells(window).unwrap();
        check_cells(&built.subdivision, &cells, name);
        assert_eq!(rings.len(), places.len(), "{name}");
        let area = |ring: &[Point]| ring.windows(2).map(|w| w[0].x * w[1].y - w[0].y * w[1].x).sum::<f64>().abs();
        for (i, ring) in rings.iter().enumerate() {
            let s = &cells.subdivision;
            let cell = cells.cells[built.vertices[i]].unwrap();
            let mut own: Vec<Point> = s.incident_vertices(cell).map(|v| s.point(v)).collect();
            own.push(own[0]);
            assert!((area(&own) - area(ring)).abs() <= 1e-6 * area(ring), "{name}: cell {i}");
        }
    }
}

/// Sites on a circle, each moved by a few last places: their edges meet within last places of the centre, in disorder.
#[test]
fn faces_that_rounding_made_go_to_their_neighbours() {
    let mut slivers = 0;
    for seed in 0..150 {
        let mut random = Random(seed);
        let n = 5 + random.below(12);
        let last_places = |random: &mut Random| (random.below(9) as f64 - 4.0) * f64::EPSILON;
        let site = |i: usize| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
            Point::new(1000.0 * cos + last_places(&mut random), 1000.0 * sin + last_places(&mut random))
        };
        let places: Vec<Point> = (0..n).map(site).collect();
        let sites = delaunay(&places);
        let cells = sites.voronoi().unwrap().cells(Window::around(&places)).unwrap();
        check_cells(&sites, &cells, &format!("seed {seed}, {n} points"));
        slivers += cells.slivers;
    }
    assert!(slivers > 100, "only {slivers} faces without a site: this test does not look at what it is for");
}
