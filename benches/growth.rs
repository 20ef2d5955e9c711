//! How the time of the kit grows from 10^5 triangles to 10^7, drawn by the kit.
//!
//! `cargo bench --manifest-path benches/Cargo.toml --bench growth -- [FILE.svg]` prints the table, and writes the picture
//! into the file. Processor time; the median of three runs.

#[path = "../src/cli/gallery/chart.rs"]
mod chart;

use chart::Chart;
use dcel_kit::figure::FigureOptions;
use dcel_kit::io::{Document, Format, Model, ReadOptions, read_bytes, write};
use dcel_kit::plane::{Point, PointIndex, Subdivision};
use dcel_kit::topology::Dcel;
use dcel_kit_benches::{Random, Triangles, growth, ordered};

/// Triangles.
const SIZES: [usize; 5] = [100_000, 300_000, 1_000_000, 3_000_000, 10_000_000];

fn main() {
    let rows = [
        ("list of triangles", structure()),
        ("Delaunay", triangulation()),
        ("text", reading()),
        ("location", location()),
    ];
    let Some(file) = std::env::args().skip(1).find(|arg| arg.ends_with(".svg")) else { return };
    // Powers of ten from 1 to 100,000 are what the axes have marks for; names stand to the right of the last points.
    let mut chart = Chart::new(["thousands of triangles", "milliseconds"], [100.0, 1.0], [60_000.0, 100_000.0]);
    for (name, ns) in &rows {
        chart.series(name, SIZES.iter().zip(ns).map(|(&n, ns)| [n as f64 / 1e3, ns / 1e6]));
    }
    chart.growth("n", [100.0, 1.2], [10_000.0, 120.0]);
    let options = FigureOptions::new("Time and size").id_prefix("growth").width(830.0);
    let figure = chart.sketch.figure(&options).expect("a chart is a figure");
    std::fs::write(&file, figure.to_svg()).unwrap_or_else(|error| panic!("{file}: {error}"));
    println!("{file}");
}

fn structure() -> Vec<f64> {
    growth("list of triangles to structure, row by row", &SIZES, |count| {
        let Triangles { vertices, triangles, .. } = ordered(count);
        move || Dcel::from_triangles(vertices, &triangles).expect("a grid")
    })
}

/// Random points of the unit square.
fn points(count: usize) -> Vec<Point> {
    let mut random = Random::new(6);
    (0..count).map(|_| Point::new(random.unit(), random.unit())).collect()
}

/// A triangulation of about so many triangles.
fn delaunay(count: usize) -> Subdivision {
    Subdivision::delaunay(&points(count / 2)).expect("points that can be used").subdivision
}

fn triangulation() -> Vec<f64> {
    growth("Delaunay triangulation of random points, by triangles", &SIZES, |count| {
        let points = points(count / 2);
        move || Subdivision::delaunay(&points).expect("points that can be used").subdivision
    })
}

fn reading() -> Vec<f64> {
    growth("its text (dcel) to structure", &SIZES, |count| {
        let mut text = Vec::new();
        write(&mut text, &Model::planar(&delaunay(count)), Format::Dcel).expect("to memory");
        let columns = ReadOptions { columns: true, ..ReadOptions::default() };
        move || match read_bytes(&text, Format::Dcel, "text", &columns).map(|read| read.document) {
            Ok(Document::Columns(mut table)) => Subdivision::from_columns(&mut table).expect("its own text"),
            other => panic!("{:?}", other.err()),
        }
    })
}

fn location() -> Vec<f64> {
    growth("index, and one random point a triangle located", &SIZES, |count| {
        let (map, asked) = (delaunay(count), points(count));
        move || PointIndex::new(&map).locate_all(&asked)
    })
}
