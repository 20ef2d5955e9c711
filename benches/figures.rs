//! Structure figures of many edges, against writing the same bytes raw.
//!
//! `cargo bench --bench figures` draws grids of 10^5 and 10^6 edges, to memory and to a file; `-- linear` shows how drawing
//! the Voronoi cells of random points grows.

use dcel_kit::figure::{self, FigureOptions};
use dcel_kit::plane::{Point, Subdivision, Window};
use dcel_kit_benches::{DOUBLED, Random, compare, growth, ordered, print, program};
use std::hint::black_box;
use std::path::Path;

/// A square grid of triangles with about `edges` edges.
fn grid(edges: usize) -> Subdivision {
    let input = ordered(edges * 2 / 3);
    let across = (input.vertices as f64).sqrt().round() as usize;
    let points = (0..input.vertices).map(|k| Point::new((k % across) as f64, (k / across) as f64)).collect();
    Subdivision::from_triangles(points, &input.triangles).expect("a grid is a subdivision")
}

fn draw(view: &Subdivision, options: &FigureOptions) -> String {
    figure::structure(view, options).expect("all points are finite").to_svg()
}

fn write(path: &Path, bytes: &[u8]) {
    std::fs::write(path, bytes).expect("the folder of the system for such files can be written to");
}

fn linear() {
    growth("figure of Voronoi cells", &DOUBLED, |count| {
        let mut random = Random::new(4);
        let points: Vec<Point> = (0..count).map(|_| Point::new(random.unit(), random.unit())).collect();
        let delaunay = Subdivision::delaunay(&points).expect("good points").subdivision;
        let cells = delaunay.voronoi().expect("Delaunay").cells(Window::around(&points)).expect("sites apart");
        move || {
            let voronoi = delaunay.voronoi().expect("Delaunay");
            let options = FigureOptions::new("Cells");
            figure::voronoi_cells(&voronoi, &cells, false, &options).expect("all points are finite").to_svg()
        }
    });
}

fn main() {
    if std::env::args().any(|arg| arg == "linear") {
        return linear();
    }
    let path = std::env::temp_dir().join(format!("dcel-kit-bench-{}.svg", std::process::id()));
    for (edges, rounds, goal) in [(100_000, 7, "under 2 MB and 0.3 s"), (1_000_000, 3, "under 25 MB and 3 s")] {
        let view = grid(edges);
        let options = FigureOptions::new("Grid");
        let svg = draw(&view, &options);
        let mut programs = [
            program("figure, to memory", || draw(&view, &options)),
            program("figure, to a file", || write(&path, draw(&view, &options).as_bytes())),
            program("the same bytes, to memory", || black_box(&svg).clone()),
            program("the same bytes, to a file", || write(&path, black_box(&svg).as_bytes())),
        ];
        let milliseconds: Vec<f64> = compare(&mut programs, rounds, 1).into_iter().map(|ns| ns / 1e6).collect();
        let (count, megabytes) = (view.edge_count(), svg.len() as f64 / 1e6);
        print(&format!("{count} edges, {megabytes:.2} MB, ms (goal {goal})"), &programs, &milliseconds);
        println!("to a file: {:.0} times as long as the bytes alone\n", milliseconds[1] / milliseconds[3]);
    }
    // Nothing to be done if the file has gone already.
    let _ = std::fs::remove_file(path);
}
