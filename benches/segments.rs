//! Segments to subdivisions.
//!
//! `cargo bench --bench segments` measures 10^6 segments that meet at common ends only, in three orders, and their
//! parts; `-- linear` the growth from 10^4 to 10^6, and that of segments on one line which all overlap; `-- split` random
//! segments that cross, beside the sweep of crate geo, which tells the crossings and builds nothing.
//!
//! No crate builds a half-edge structure from segments, so the peers are lower bounds: the sort of all ends that
//! finds equal points, and the copy of the result. GEOS and CGAL were measured beside it;
//! the figures are in README.md.

use dcel_kit::plane::{ArrangeOptions, Point, Subdivision};
use dcel_kit_benches::{DOUBLED, Random, compare, delaunay, growth, ordered, print, program, shuffled};

/// The edges of a triangulation as segments, each once, in the order of the triangles; about `count` of them.
fn edges(count: usize, order: &str) -> Vec<[Point; 2]> {
    let input = match order {
        "Delaunay" => delaunay(count * 2 / 3),
        "shuffled" => shuffled(count * 2 / 3),
        _ => ordered(count * 2 / 3),
    };
    let side = (input.vertices as f64).sqrt().round() as usize;
    let mut random = Random::new(2);
    let random: Vec<Point> = (0..input.vertices).map(|_| Point::new(random.unit(), random.unit())).collect();
    let dcel = dcel_kit::topology::Dcel::from_triangles(input.vertices, &input.triangles).expect("a surface").dcel;
    // The vertices of the shuffled grid have to be found again: by their place in the ordered one.
    let grid: Vec<Point> = (0..input.vertices).map(|v| Point::new((v % side) as f64, (v / side) as f64)).collect();
    let mut segments: Vec<[Point; 2]> = match order {
        "shuffled" => edges(count, "ordered"),
        "Delaunay" => dcel.edges().map(|e| e.half_edges().map(|h| random[dcel.origin(h).index()])).collect(),
        _ => dcel.edges().map(|e| e.half_edges().map(|h| grid[dcel.origin(h).index()])).collect(),
    };
    if order == "shuffled" {
        Random::new(3).shuffle(&mut segments);
    }
    segments
}

/// The sort that finds equal ends.
fn sorted_ends(segments: &[[Point; 2]]) -> Vec<(u64, u64, u32)> {
    let mut ends: Vec<(u64, u64, u32)> =
        segments.as_flattened().iter().enumerate().map(|(i, p)| (p.x.to_bits(), p.y.to_bits(), i as u32)).collect();
    ends.sort_unstable();
    ends
}

fn main() {
    match std::env::args().find(|arg| ["linear", "split"].contains(&arg.as_str())).as_deref() {
        Some("linear") => linear(),
        Some(_) => split(),
        None => parts(),
    }
}

fn parts() {
    for order in ["ordered", "shuffled", "Delaunay"] {
        let segments = edges(1_000_000, order);
        let s = Subdivision::from_segments(&segments).expect("the segments meet at ends only");
        let mut programs = [
            program("from_segments", || Subdivision::from_segments(&segments).expect("as before")),
            program("sort of the ends alone", || sorted_ends(&segments)),
            program("full check of the result", || s.geometry_violations()),
            program("copy of the result", || s.clone()),
        ];
        let ns = compare(&mut programs, 5, segments.len());
        print(&format!("{} segments, {order}, ns per segment", segments.len()), &programs, &ns);
    }
}

fn linear() {
    for count in [10_000, 100_000, 1_000_000] {
        let segments = edges(count, "Delaunay");
        let mut programs = [program("from_segments", || Subdivision::from_segments(&segments).expect("as before"))];
        let ns = compare(&mut programs, 5, segments.len());
        print(&format!("{} segments, Delaunay, ns per segment", segments.len()), &programs, &ns);
    }
    growth("segments from (0, 0) to (i, 0), split", &DOUBLED, |count| {
        let segments: Vec<[Point; 2]> = (1..=count).map(|i| [Point::default(), Point::new(i as f64, 0.0)]).collect();
        let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
        move || Subdivision::arrange_segments(&segments, &options).expect("all can be split").subdivision.edge_count()
    });
}

/// Short random segments, with about as many crossings as segments.
fn split() {
    for count in [1_000, 10_000, 100_000] {
        let mut random = Random::new(4);
        let length = 2.0 / (count as f64).sqrt();
        let segments: Vec<[Point; 2]> = (0..count)
            .map(|_| {
                let p = Point::new(random.unit(), random.unit());
                [p, Point::new(p.x + (random.unit() - 0.5) * 2.0 * length, p.y + (random.unit() - 0.5) * 2.0 * length)]
            })
            .collect();
        let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
        let made = Subdivision::arrange_segments(&segments, &options).expect("all can be split");
        let events = segments.len() + made.crossings.len();
        let run = || Subdivision::arrange_segments(&segments, &options).expect("as before");
        // The peer tells the crossings only, as it finds them, by doubles; what it gives is counted.
        let line =
            |&[p, q]: &[Point; 2]| geo::Line::new(geo::coord! { x: p.x, y: p.y }, geo::coord! { x: q.x, y: q.y });
        let lines: Vec<geo::Line> = segments.iter().map(line).collect();
        let found = || lines.iter().copied().collect::<geo::sweep::Intersections<_>>().count();
        let mut programs = [program("arrange_segments, split", run), program("geo, crossings only", found)];
        let ns = compare(&mut programs, 7, events);
        let title = format!(
            "{count} segments, {} crossings, {} rounds, ns per segment and crossing",
            made.crossings.len(),
            made.rounds
        );
        print(&title, &programs, &ns);
    }
}
