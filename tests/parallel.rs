//! The feature `parallel`: one thread and several give the same answers, half-edge by half-edge.

use dcel_kit::plane::{ArrangeOptions, DelaunayBuilt, Point, PointIndex, Subdivision};
use dcel_kit::progress::Progress;
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Platonic, Polyhedron, Selection};
use rayon::ThreadPoolBuilder;
use std::f64::consts::TAU;

#[path = "plane/numbers.rs"]
mod numbers;
use numbers::Numbers;

/// Runs `work` on so many threads.
fn on<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool").install(work)
}

/// More points than the parts that threads share have.
const MANY: usize = 150_000;

fn sets() -> Vec<(&'static str, Vec<Point>)> {
    let mut numbers = Numbers::new(7);
    let mut set = |place: &dyn Fn(&mut Numbers, usize) -> [f64; 2]| -> Vec<Point> {
        (0..MANY).map(|i| place(&mut numbers, i).into()).collect()
    };
    vec![
        ("anywhere", set(&|numbers, _| [numbers.unit(), numbers.unit()])),
        // Nearly half of them are repeated.
        ("lattice", set(&|numbers, _| [numbers.below(330) as f64, numbers.below(330) as f64])),
        ("circle", set(&|_, i| [(TAU * i as f64 / MANY as f64).cos(), (TAU * i as f64 / MANY as f64).sin()])),
        // In a few cells of the grid, and a far point.
        ("crowded", set(&|numbers, i| if i == 9 { [1e6, 1e6] } else { [numbers.unit(), numbers.unit()] })),
        // Many in a few cells, with the smallest keys or with the greatest; the others everywhere.
        (
            "crowded below",
            set(&|numbers, i| [numbers.unit(), numbers.unit()].map(|x| if i % 3 == 0 { 1e-6 * x } else { x })),
        ),
        (
            "crowded above",
            set(&|numbers, i| [numbers.unit(), numbers.unit()].map(|x| if i % 3 == 0 { 1e-6 * x } else { -x })),
        ),
        // Long seams: the upper outline of each half sees far into the other.
        (
            "moon",
            set(&|numbers, _| {
                let (x, y) = (2.0 * numbers.unit() - 1.0, numbers.unit());
                [x, x * x + 1e-3 * y]
            }),
        ),
    ]
}

#[test]
fn a_delaunay_triangulation_does_not_depend_on_the_threads() {
    for (name, points) in sets() {
        let [one, four]: [DelaunayBuilt; 2] =
            [1, 4].map(|threads| on(threads, || Subdivision::delaunay(&points).unwrap()));
        assert!(one == four, "{name}");
        assert_eq!(one.subdivision.non_delaunay_edges(|_| false).count(), 0, "{name}");
    }
}

/// Also one thread makes the parts of a large set by themselves, and the edges that join them in places that these left.
#[test]
fn edges_that_join_parts_have_the_same_numbers() {
    for seed in 0..60 {
        let mut numbers = Numbers::new(seed);
        let mut point = || Point::new(numbers.unit(), numbers.unit() * numbers.unit());
        let points: Vec<Point> = (0..40_000).map(|_| point()).collect();
        let [one, two]: [DelaunayBuilt; 2] =
            [1, 2].map(|threads| on(threads, || Subdivision::delaunay(&points).unwrap()));
        assert!(one == two, "seed {seed}");
    }
}

#[test]
fn points_are_located_in_their_order_by_any_number_of_threads() {
    let points = &sets()[0].1;
    let subdivision = Subdivision::delaunay(&points[..20_000]).unwrap().subdivision;
    let index = PointIndex::new(&subdivision);
    let one_by_one: Vec<_> = points.iter().map(|&p| index.locate(p)).collect();
    for threads in [1, 3] {
        assert!(on(threads, || index.locate_all(points)) == one_by_one, "{threads} threads");
        assert!(on(threads, || index.locate_all(&points[..1])) == one_by_one[..1]);
    }
}

#[test]
fn finer_surfaces_do_not_depend_on_the_threads() {
    let torus = Shape::Torus { n: 160, m: 130 }.build().unwrap().polyhedron;
    let mut creases = Selection::new();
    torus.edges().step_by(7).for_each(|e| creases.add(e, 1));
    let quads = |threads| on(threads, || torus.catmull_clark(&creases).unwrap());
    assert!(quads(1) == quads(3));
    let finer = |surface: &Polyhedron, threads| on(threads, || surface.loop_subdivision(&Selection::new()).unwrap());
    let mut ball = Polyhedron::platonic(Platonic::Icosahedron);
    for _ in 0..6 {
        ball = finer(&ball, 1).polyhedron;
    }
    assert!(ball.vertex_count() > 40_000 && finer(&ball, 1) == finer(&ball, 3));
}

#[test]
fn an_index_does_not_depend_on_the_threads() {
    for (name, points) in sets() {
        let subdivision = Subdivision::delaunay(&points).unwrap().subdivision;
        let made = |threads| on(threads, || format!("{:?}", PointIndex::new(&subdivision)));
        assert!(made(1) == made(3), "{name}");
    }
}

#[test]
fn segments_on_a_grid_do_not_depend_on_the_threads() {
    let mut numbers = Numbers::new(3);
    let segments: Vec<[Point; 2]> = (0..20_000)
        .map(|_| {
            let [x, y] = [numbers.unit(), numbers.unit()];
            [Point::new(x, y), Point::new(x + 0.03 * (numbers.unit() - 0.5), y + 0.03 * (numbers.unit() - 0.5))]
        })
        .collect();
    for grid in [2f64.powi(-8), 2f64.powi(-30)] {
        let options = ArrangeOptions { split: true, grid: Some(grid), ..ArrangeOptions::default() };
        let made = |threads| on(threads, || Subdivision::arrange_segments(&segments, &options).unwrap());
        let one = made(1);
        assert!(one.subdivision.edge_count() > 30_000, "{}", one.subdivision.edge_count());
        assert!(one == made(3), "{grid}");
    }
}

/// The caller is no thread of the pool that does the work.
#[test]
fn who_watches_is_told_what_other_threads_do() {
    let (points, progress) = (&sets()[0].1, Progress::new());
    progress.watch(|| drop(Subdivision::delaunay(points)));
    let last = progress.last().map(|last| (last.what, last.done as usize));
    assert_eq!(last, Some(("triangulating", points.len())));
}
