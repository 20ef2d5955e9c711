//! Point location: 10^6 random points in the Delaunay triangulation of random points, 10^6 triangles.
//!
//! `cargo bench --bench locate` measures the index, the batch, and crate `spade` with its hierarchy of triangulations,
//! all with typed answers (vertex, edge or face), and the making of each; `-- linear` the growth from 10^4 to 10^6
//! triangles; `-- batches` batches of 10^3 to 10^6 points in one triangulation, beside the same one by one; `-- crowds` the index where edges crowd, and `from_segments` of the same segments.

use dcel_kit::plane::{Point, PointIndex, Subdivision};
use dcel_kit_benches::{Random, compare, delaunay, print, program};
use spade::{DelaunayTriangulation, HierarchyHintGenerator, Point2, Triangulation as _};

type Spade = DelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;

/// The points of `delaunay`.
fn sites(count: usize) -> Vec<Point> {
    let mut random = Random::new(2);
    (0..count).map(|_| Point::new(random.unit(), random.unit())).collect()
}

fn ours(triangles: usize) -> Subdivision {
    let input = delaunay(triangles);
    // delaunator counts y downwards.
    let turned: Vec<[u32; 3]> = input.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    Subdivision::from_triangles(sites(input.vertices), &turned).expect("a triangulation")
}

fn spade(vertices: usize) -> Spade {
    let points = sites(vertices).into_iter().map(|p| Point2::new(p.x, p.y)).collect();
    Spade::bulk_load(points).expect("finite points")
}

fn asked(count: usize) -> Vec<Point> {
    let mut random = Random::new(7);
    (0..count).map(|_| Point::new(random.unit(), random.unit())).collect()
}

fn main() {
    match std::env::args().find(|arg| ["linear", "batches", "crowds"].contains(&arg.as_str())).as_deref() {
        Some("linear") => [10_000, 100_000, 1_000_000].into_iter().for_each(against_spade),
        Some("batches") => batches(),
        Some(_) => crowds(),
        None => against_spade(1_000_000),
    }
}

fn against_spade(triangles: usize) {
    let s = ours(triangles);
    let (index, dense) = (PointIndex::new(&s), PointIndex::with_density(&s, 4.0));
    let peer = spade(triangles / 2);
    let points = asked(1_000_000);
    let walks = &points[..1000];
    let mut programs = [
        program("index, one by one", || points.iter().map(|&p| index.locate(p)).collect::<Vec<_>>()),
        program("index, 4 cells an edge", || points.iter().map(|&p| dense.locate(p)).collect::<Vec<_>>()),
        program("index, all at once", || index.locate_all(&points)),
        program("spade, hierarchy", || {
            points
                .iter()
                .map(|p| peer.locate(Point2::new(p.x, p.y)))
                .filter(|at| matches!(at, spade::PositionInTriangulation::OnFace(_)))
                .count()
        }),
    ];
    let ns = compare(&mut programs, 5, points.len());
    print(&format!("{} points in {triangles} triangles, ns per point", points.len()), &programs, &ns);
    for (name, index) in [("1 cell", &index), ("4 cells", &dense)] {
        let bytes = index.memory_bytes() as f64;
        println!(
            "  {name} an edge: {:.1} bytes an edge, {:.1} a triangle; at most {} edges a query",
            bytes / s.edge_count() as f64,
            bytes / triangles as f64,
            index.worst_case()
        );
    }
    let mut programs = [program("jump and walk", || walks.iter().map(|&p| s.locate(p)).collect::<Vec<_>>())];
    let ns = compare(&mut programs, 3, walks.len());
    print("the same without an index, ns per point", &programs, &ns);
    let mut programs = [
        program("making the index", || PointIndex::new(&s).cell_count()),
        program("spade, triangulation and hierarchy", || spade(triangles / 2)),
    ];
    let ns = compare(&mut programs, 3, triangles);
    print("making, ns per triangle", &programs, &ns);
}

fn batches() {
    for triangles in [10_000, 1_000_000] {
        let s = ours(triangles);
        let index = PointIndex::new(&s);
        for count in [1_000, 10_000, 100_000, 1_000_000] {
            let points = asked(count);
            let mut programs = [
                program("one by one", || points.iter().map(|&p| index.locate(p)).collect::<Vec<_>>()),
                program("all at once", || index.locate_all(&points)),
            ];
            let ns = compare(&mut programs, 9, points.len());
            print(&format!("{count} points in {triangles} triangles, ns per point"), &programs, &ns);
        }
    }
}

fn crowds() {
    let n = 1_000_000;
    let mut random = Random::new(8);
    let star: Vec<[Point; 2]> = (0..n)
        .map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / f64::from(n)).sin_cos();
            [Point::default(), Point::new(cos, sin)]
        })
        .collect();
    let bundle: Vec<[Point; 2]> = (0..n)
        .map(|i| {
            let y = f64::from(i) / f64::from(n);
            [Point::new(-random.unit(), y), Point::new(random.unit(), y)]
        })
        .collect();
    let points: Vec<Point> = asked(100_000).iter().map(|p| Point::new(2.0 * p.x - 1.0, 2.0 * p.y - 1.0)).collect();
    for (name, segments) in [("star", star), ("bundle", bundle)] {
        let s = Subdivision::from_segments(&segments).expect("the segments meet at ends only");
        let index = PointIndex::new(&s);
        let mut making = [
            program("from_segments", || Subdivision::from_segments(&segments).expect("as before")),
            program("index", || PointIndex::new(&s).cell_count()),
        ];
        let ns = compare(&mut making, 1, segments.len());
        print(&format!("{name} of {n} segments, ns per segment"), &making, &ns);
        let mut asking = [program("index", || points.iter().map(|&p| index.locate(p)).collect::<Vec<_>>())];
        let ns = compare(&mut asking, 3, points.len());
        print(&format!("{name}, ns per point"), &asking, &ns);
        println!(
            "  {} bytes an edge; at most {} edges a query\n",
            index.memory_bytes() / s.edge_count(),
            index.worst_case()
        );
    }
}
