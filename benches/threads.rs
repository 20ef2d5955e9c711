//! What a second thread brings (feature `parallel`): time by the clock, one thread and two in turn, the same answers.
//!
//! `cargo bench --manifest-path benches/Cargo.toml --features parallel --bench threads`

use dcel_kit::plane::{ArrangeOptions, Point, PointIndex, Subdivision};
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Polyhedron, Selection};
use dcel_kit::topology::PolygonList;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::hint::black_box;
use std::time::{Duration, Instant};

const ROUNDS: usize = 7;
const POINTS: usize = 1_000_000;

/// Numbers that look random, from 0 to 1.
fn unit(state: &mut u64) -> f64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}

/// A line of the table.
fn row<T>(name: &str, pools: &[ThreadPool; 2], work: impl Fn() -> T + Sync) {
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        for (pool, times) in pools.iter().zip(&mut times) {
            times.push(pool.install(|| {
                let start = Instant::now();
                black_box(work());
                start.elapsed()
            }));
        }
    }
    let [one, two] = times.map(|times| median(times).as_secs_f64());
    println!("{name:<44} {:>9.1} ms {:>9.1} ms   {:.2} times as fast", 1e3 * one, 1e3 * two, one / two);
}

fn main() {
    let pools = [1, 2].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool"));
    let mut state = 88_172_645_463_325_252;
    let mut points = || -> Vec<Point> { (0..POINTS).map(|_| Point::new(unit(&mut state), unit(&mut state))).collect() };
    let (sites, asked) = (points(), points());
    println!("{:<44} {:>12} {:>12}", "", "one thread", "two");
    row("Delaunay triangulation of 10^6 points", &pools, || Subdivision::delaunay(&sites));
    let map = Subdivision::delaunay(&sites).expect("points that can be used").subdivision;
    row("index of its 2 * 10^6 triangles", &pools, || PointIndex::new(&map));
    let index = PointIndex::new(&map);
    row("10^6 points located together", &pools, || index.locate_all(&asked));
    let segments: Vec<[Point; 2]> = sites
        .chunks_exact(5)
        .map(|p| [p[0], Point::new(p[0].x + 0.008 * (p[1].x - 0.5), p[0].y + 0.008 * (p[1].y - 0.5))])
        .collect();
    let options = ArrangeOptions { split: true, grid: Some(2f64.powi(-30)), ..ArrangeOptions::default() };
    row("200,000 segments, rounded to a grid", &pools, || Subdivision::arrange_segments(&segments, &options));
    let torus = Shape::Torus { n: 500, m: 500 }.build().expect("a torus of this size fits").polyhedron;
    let creases = Selection::new();
    row("Catmull-Clark to 10^6 faces", &pools, || torus.catmull_clark(&creases));
    let triangles = cut(&torus);
    row("Loop to 2 * 10^6 faces", &pools, || triangles.loop_subdivision(&creases));
}

/// The quads of a surface as triangles.
fn cut(solid: &Polyhedron) -> Polyhedron {
    let points = solid.vertices().map(|v| solid.point(v)).collect();
    let mut triangles = PolygonList::new();
    for f in solid.faces() {
        let c: Vec<u32> = solid.incident_vertices(f).map(|v| v.number()).collect();
        [[c[0], c[1], c[2]], [c[0], c[2], c[3]]].iter().for_each(|corners| triangles.push_face(corners));
    }
    Polyhedron::from_polygons(points, &triangles).expect("the faces of a torus fit together")
}
