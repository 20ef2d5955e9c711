//! Delaunay triangulations of points, into half-edge structures.
//!
//! `cargo bench --bench delaunay` measures 10^4, 10^5 and 10^6 points, random, on a grid and in clusters, beside
//! spade's bulk load (exact, into its own half-edge structure) and delaunator (a list of triangles, by doubles).
//! `-- parts` adds what else can be done with a million random points: delaunator and our converter and flips, a
//! check of all edges, the Voronoi diagram and its cells; `-- linear` the growth of constrained triangulations where all
//! edges meet in one vertex, of Voronoi diagrams of points on a circle and of points that crowd, and of two ways to cut a
//! floor with square pillars in rows into Delaunay triangles: monotone pieces and flips, with the number of flips, and
//! constrained Delaunay at once.

use dcel_kit::plane::{Point, Subdivision, TriangulationMethod, Window};
use dcel_kit_benches::{DOUBLED, Random, compare, growth, print, program};
use spade::Triangulation as _;

fn points(kind: &str, count: usize) -> Vec<Point> {
    let mut random = Random::new(5);
    let side = (count as f64).sqrt() as usize;
    let centres: Vec<[f64; 2]> = (0..30).map(|_| [random.unit(), random.unit()]).collect();
    (0..count)
        .map(|i| match kind {
            "grid" => Point::new((i % side) as f64, (i / side) as f64),
            "clusters" => {
                let [x, y] = centres[random.below(centres.len())];
                let (radius, angle) = (1e-3 * random.unit() * random.unit(), 6.28 * random.unit());
                Point::new(x + radius * angle.cos(), y + radius * angle.sin())
            }
            _ => Point::new(random.unit(), random.unit()),
        })
        .collect()
}

fn triangles_of(points: &[Point]) -> Vec<[u32; 3]> {
    let points: Vec<_> = points.iter().map(|p| delaunator::Point { x: p.x, y: p.y }).collect();
    let corners = delaunator::triangulate(&points).triangles;
    corners.chunks_exact(3).map(|t| [t[0] as u32, t[2] as u32, t[1] as u32]).collect()
}

fn main() {
    match std::env::args().find(|arg| ["parts", "linear"].contains(&arg.as_str())).as_deref() {
        Some("parts") => parts(),
        Some(_) => linear(),
        None => peers(),
    }
}

/// Points on a circle.
fn circle(count: usize) -> Vec<Point> {
    let angle = |i: usize| i as f64 / count as f64 * std::f64::consts::TAU;
    (0..count).map(|i| Point::new(1e6 * angle(i).cos(), 1e6 * angle(i).sin())).collect()
}

fn linear() {
    growth("constrained Delaunay, spokes of one hub", &DOUBLED, |count| {
        let spokes: Vec<[Point; 2]> = circle(count).into_iter().map(|p| [Point::default(), p]).collect();
        let s = Subdivision::from_segments(&spokes).expect("they meet in the hub only");
        move || s.constrained_delaunay().expect("not too many").subdivision.edge_count()
    });
    growth("constrained Delaunay, long walls side by side: n² log n", &[1000, 2000, 4000], |count| {
        let s = Subdivision::from_segments(&walls(count)).expect("walls stand apart");
        move || s.constrained_delaunay().expect("not too many").subdivision.edge_count()
    });
    for (name, points) in [("on a circle", circle as fn(usize) -> Vec<Point>), ("that crowd", crowded)] {
        growth(&format!("Voronoi cells, points {name}"), &DOUBLED, |count| {
            let points = points(count);
            move || {
                let delaunay = Subdivision::delaunay(&points).expect("good points").subdivision;
                let voronoi = delaunay.voronoi().expect("Delaunay");
                voronoi.cells(Window::around(&points)).expect("no two sites too close").subdivision.edge_count()
            }
        });
    }
    growth("floor with pillars in rows: monotone pieces, then flips", &DOUBLED, |count| {
        let floor = floor(count);
        let flips = flipped(&floor).1;
        println!("  {flips} flips for {} vertices", floor.vertex_count());
        move || flipped(&floor).1
    });
    growth("floor with pillars in rows: constrained Delaunay", &DOUBLED, |count| {
        let floor = floor(count);
        move || {
            let mut copy = floor.clone();
            copy.triangulate(TriangulationMethod::Delaunay).expect("a floor");
            copy.face_count()
        }
    });
}

/// Long walls side by side, and between them short edges that climb: each wall has very many edges across it.
fn walls(count: usize) -> Vec<[Point; 2]> {
    let steps = (0..count / 2).map(|i| i as f64);
    steps.flat_map(|x| [[(x, 0.0), (x, 1e6)], [(x + 0.3, x), (x + 0.6, x)]]).map(|ends| ends.map(Point::from)).collect()
}

/// Points in squares of sides 1, 1/1000, 10^-6 and 10^-9, all of them at the origin.
fn crowded(count: usize) -> Vec<Point> {
    let mut random = Random::new(6);
    (0..count)
        .map(|i| {
            let scale = 1000_f64.powi(-((10 * i / count) as i32 / 3));
            Point::new(scale * random.unit(), scale * random.unit())
        })
        .collect()
}

/// A square floor with about `count` corners: square pillars in rows and columns.
fn floor(count: usize) -> Subdivision {
    let side = ((count / 4) as f64).sqrt() as usize;
    let wide = side as f64 + 1.0;
    let mut points: Vec<Point> = [(0., 0.), (wide, 0.), (wide, wide), (0., wide)].map(Point::from).to_vec();
    for i in 0..side * side {
        let (x, y) = ((i % side) as f64 + 0.75, (i / side) as f64 + 0.75);
        points.extend([(x, y), (x + 0.5, y), (x + 0.5, y + 0.5), (x, y + 0.5)].map(Point::from));
    }
    let edges: Vec<[u32; 2]> = (0..points.len() as u32).map(|i| [i, if i % 4 == 3 { i - 3 } else { i + 1 }]).collect();
    let mut floor = Subdivision::from_graph(&points, &edges).expect("pillars stand apart");
    floor.mark_nested_holes();
    floor
}

/// The floor in Delaunay triangles, by flips, and how many.
fn flipped(floor: &Subdivision) -> (Subdivision, usize) {
    let mut copy = floor.clone();
    let given = copy.edge_bound();
    copy.triangulate(TriangulationMethod::Monotone).expect("a floor");
    let flips = copy.make_delaunay(|e| e.index() < given);
    (copy, flips)
}

fn peers() {
    for kind in ["random", "grid", "clusters"] {
        for count in [10_000, 100_000, 1_000_000] {
            let points = points(kind, count);
            let ours = Subdivision::delaunay(&points).expect("good points").subdivision;
            assert_eq!(ours.non_delaunay_edges(|_| false).count(), 0);
            let mut programs = [
                program("Subdivision::delaunay", || Subdivision::delaunay(&points).expect("good points")),
                program("spade bulk_load", || {
                    let points = points.iter().map(|p| spade::Point2::new(p.x, p.y)).collect();
                    let made = spade::DelaunayTriangulation::<spade::Point2<f64>>::bulk_load(points);
                    assert_eq!(made.as_ref().expect("good points").num_inner_faces(), ours.face_count() - 1);
                    made
                }),
                program("delaunator", || {
                    let points: Vec<_> = points.iter().map(|p| delaunator::Point { x: p.x, y: p.y }).collect();
                    delaunator::triangulate(&points)
                }),
            ];
            let ns = compare(&mut programs, 5, count);
            print(&format!("{count} points, {kind}, ns per point"), &programs, &ns);
        }
    }
}

fn parts() {
    let points = points("random", 1_000_000);
    let delaunay = Subdivision::delaunay(&points).expect("good points").subdivision;
    let mut programs = [
        program("Subdivision::delaunay", || Subdivision::delaunay(&points).expect("good points")),
        program("delaunator, then ours", || {
            let triangles = triangles_of(&points);
            let mut s = Subdivision::from_triangles(points.clone(), &triangles).expect("a triangulation");
            s.make_delaunay(|_| false);
            s
        }),
        program("check of all edges", || delaunay.non_delaunay_edges(|_| false).count()),
        program("Voronoi diagram", || delaunay.voronoi().expect("Delaunay").edges().len()),
        program("Voronoi cells", || {
            delaunay.voronoi().expect("Delaunay").cells(Window::around(&points)).expect("no two sites too close")
        }),
    ];
    let ns = compare(&mut programs, 3, points.len());
    print("1000000 random points, ns per point", &programs, &ns);
}
