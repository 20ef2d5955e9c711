//! What it costs an algorithm that somebody might look at it: nothing, where nobody does.
//!
//! Each algorithm runs without an observer, with one that only counts its events, and with one that keeps them all. An
//! observer that counts must at least do what one that does nothing could do at the worst, so that its surplus is a bound
//! for the price of the hooks.
//!
//! `cargo bench --bench observers`

use dcel_kit::plane::{EarEvent, FlipEvent, HullEvent, MonotoneEvent, Point, Subdivision, convex_hull_observed};
use dcel_kit::solid::{self, HullFaces, Polyhedron};
use dcel_kit::topology::{NoObserver, Observer};
use dcel_kit_benches::{Program, Random, Run, compare, print};

const POINTS: usize = 200_000;
const CORNERS: usize = 20_000;
const ROUNDS: usize = 9;

/// Counts.
#[derive(Default)]
struct Count(u64);

impl<E> Observer<E> for Count {
    fn observe(&mut self, _: impl FnOnce() -> E) {
        self.0 += 1;
    }
}

/// A program that works on a copy of its input, which is not measured.
fn on_copy<'a, S: Clone + 'static>(name: &'a str, input: &'a S, work: fn(&mut S) -> u64) -> Program<'a> {
    let prepare = move || -> Run<'a> {
        let mut copy = input.clone();
        Box::new(move || {
            let events = work(&mut copy);
            Box::new((copy, events))
        })
    };
    (name, Box::new(prepare))
}

fn measure<S: Clone + 'static>(title: &str, input: &S, elements: usize, works: [fn(&mut S) -> u64; 3]) {
    let names = ["nobody looks", "one who counts", "one who keeps all"];
    let mut programs: Vec<Program<'_>> =
        names.into_iter().zip(works).map(|(name, work)| on_copy(name, input, work)).collect();
    let ns = compare(&mut programs, ROUNDS, elements);
    print(title, &programs, &ns);
}

fn main() {
    let mut random = Random::new(1);
    let points: Vec<Point> = (0..POINTS).map(|_| Point::new(random.unit(), random.unit())).collect();
    measure(
        "convex hull in the plane, a point",
        &points,
        POINTS,
        [
            |points| convex_hull_observed(points, &mut NoObserver).expect("points").len() as u64,
            |points| {
                let mut count = Count::default();
                convex_hull_observed(points, &mut count).expect("points");
                count.0
            },
            |points| {
                let mut events: Vec<HullEvent> = Vec::new();
                convex_hull_observed(points, &mut events).expect("points");
                events.len() as u64
            },
        ],
    );

    // A grid has every other diagonal turned, so that there is something to flip.
    let side = ((POINTS as f64).sqrt()) as u32;
    let grid: Vec<Point> = (0..side * side)
        .map(|i| Point::new(f64::from(i % side) + 0.3 * random.unit(), f64::from(i / side) + 0.3 * random.unit()))
        .collect();
    let triangles: Vec<[u32; 3]> = (0..side - 1)
        .flat_map(|y| (0..side - 1).map(move |x| y * side + x))
        .flat_map(|a| [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]])
        .collect();
    let mesh = Subdivision::from_triangles(grid, &triangles).expect("a grid");
    measure(
        "Lawson's flips, a point",
        &mesh,
        POINTS,
        [
            |mesh| mesh.make_delaunay_observed(|_| false, &mut NoObserver) as u64,
            |mesh| {
                let mut count = Count::default();
                mesh.make_delaunay_observed(|_| false, &mut count);
                count.0
            },
            |mesh| {
                let mut events: Vec<FlipEvent> = Vec::new();
                mesh.make_delaunay_observed(|_| false, &mut events);
                events.len() as u64
            },
        ],
    );

    let star: Vec<Point> = (0..CORNERS)
        .map(|i| {
            let turn = i as f64 / CORNERS as f64 * std::f64::consts::TAU;
            let far = 0.5 + 0.5 * random.unit();
            Point::new(far * turn.cos(), far * turn.sin())
        })
        .collect();
    let star = Subdivision::polygon(&star).expect("a star");
    measure(
        "ear clipping, a corner",
        &star,
        CORNERS,
        [
            |star| star.triangulate_ears_observed(&mut NoObserver).map_or(0, |_| 1),
            |star| {
                let mut count = Count::default();
                star.triangulate_ears_observed(&mut count).expect("a star");
                count.0
            },
            |star| {
                let mut events: Vec<EarEvent> = Vec::new();
                star.triangulate_ears_observed(&mut events).expect("a star");
                events.len() as u64
            },
        ],
    );
    measure(
        "monotone triangulation, a corner",
        &star,
        CORNERS,
        [
            |star| star.triangulate_monotone_observed(&mut NoObserver).map_or(0, |_| 1),
            |star| {
                let mut count = Count::default();
                star.triangulate_monotone_observed(&mut count).expect("a star");
                count.0
            },
            |star| {
                let mut events: Vec<MonotoneEvent> = Vec::new();
                star.triangulate_monotone_observed(&mut events).expect("a star");
                events.len() as u64
            },
        ],
    );

    let cloud: Vec<[f64; 3]> = (0..CORNERS)
        .map(|_| {
            let p = [(); 3].map(|()| random.unit() - 0.5);
            let size = p.iter().map(|x| x * x).sum::<f64>().sqrt().max(0.01);
            p.map(|x| x / size)
        })
        .collect();
    measure(
        "convex hull in space, a point",
        &cloud,
        CORNERS,
        [
            |cloud| hull(cloud, &mut NoObserver),
            |cloud| {
                let mut count = Count::default();
                hull(cloud, &mut count);
                count.0
            },
            |cloud| {
                let mut events: Vec<solid::HullEvent> = Vec::new();
                hull(cloud, &mut events);
                events.len() as u64
            },
        ],
    );
}

fn hull(cloud: &[[f64; 3]], observer: &mut impl Observer<solid::HullEvent>) -> u64 {
    let hull = Polyhedron::convex_hull_observed(cloud, HullFaces::Triangles, observer).expect("a sphere");
    hull.solid.vertex_count() as u64
}
