//! Builds the subdivision that line segments cut the plane into, and asks where points lie.
//!
//! Run it: `cargo run --example segments_and_locate`
//!
//! It prints:
//!
//! ```text
//! refused: segments 2 and 3 cross at (0, 1) (the first of 2 faults)
//! segment 3 is 3 edges now, and 2 crossings are vertices
//! (1, 3) lies in f2, whose area is 16.666666666666668
//! (1, 0.5) lies in f1, whose area is 7.333333333333334
//! (4, 3) lies in f2, whose area is 16.666666666666668
//! (8, 0) is the vertex v1
//! (20, 20) lies outside, in f0
//! ```

use dcel_kit::plane::{ArrangeOptions, Location, Point, PointIndex, Subdivision};

/// A triangle, and a line that cuts through it.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let segment = |x0, y0, x1, y1| [Point::new(x0, y0), Point::new(x1, y1)];
    let segments =
        [segment(0., 0., 8., 0.), segment(8., 0., 0., 6.), segment(0., 6., 0., 0.), segment(-1., 1., 9., 1.)];

    // Segments may meet at common ends only, unless they are to be split.
    if let Err(error) = Subdivision::from_segments(&segments) {
        println!("refused: {error}");
    }
    let split = ArrangeOptions { split: true, ..ArrangeOptions::default() };
    let arranged = Subdivision::arrange_segments(&segments, &split)?;
    println!(
        "segment 3 is {} edges now, and {} crossings are vertices",
        arranged.chain(3).len(),
        arranged.crossings.len()
    );

    // The index answers in constant time on the average; `Subdivision::locate` needs no preparation.
    let index = PointIndex::new(arranged.subdivision);
    for p in [(1., 3.), (1., 0.5), (4., 3.), (8., 0.), (20., 20.)].map(Point::from) {
        let place = match index.locate(p) {
            Location::Vertex(v) => format!("is the vertex {v}"),
            Location::Edge(h) => format!("lies on the edge {}", h.edge()),
            Location::Face(f) if f == index.subdivision().outer_face() => format!("lies outside, in {f}"),
            Location::Face(f) => format!("lies in {f}, whose area is {}", index.subdivision().area(f)),
        };
        println!("{p} {place}");
    }
    Ok(())
}
