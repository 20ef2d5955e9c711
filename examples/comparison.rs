//! Compares what two drawings mean, and two structures up to the numbers of their elements.
//!
//! Run it: `cargo run --example comparison`
//!
//! It prints:
//!
//! ```text
//! equal (same bytes)
//! differs in its declared structure: 2 differences
//!   edge v0-v2 between (0, 0) and (7, 6) is missing
//!   edge between (9, 0) and (0, 6) is not in the reference
//! without places: v0 is v3, v1 is v0, v2 is v1, v3 is v2
//! with places: h0.next = h2, which corresponds to h2 (expected h8)
//! ```

use dcel_kit::compare::{Options, compare};
use dcel_kit::figure::{self, FigureOptions};
use dcel_kit::plane::{Point, SegmentsError, Subdivision};
use dcel_kit::topology::{IsomorphismOptions, isomorphic, isomorphic_with, position_key};

/// Four walls with one diagonal or the other.
fn room(diagonal: [u32; 2]) -> Result<Subdivision, SegmentsError> {
    let corners = [(0., 0.), (9., 0.), (7., 6.), (0., 6.)].map(Point::from);
    Subdivision::from_graph(&corners, &[[0, 1], [1, 2], [2, 3], [3, 0], diagonal])
}

/// The same room or another: as drawings, and as structures.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (rising, falling) = (room([0, 2])?, room([1, 3])?);

    // Drawings are compared by the edges, vertices and faces that they show, never by pixels.
    let options = FigureOptions::new("A room");
    let expected = figure::structure(&rising, &options)?.to_svg();
    let mine = figure::structure(&falling, &options)?.to_svg();
    println!("{}", compare(&expected, &expected, &Options::new())?.verdict());
    let answer = compare(&expected, &mine, &Options::new())?;
    println!("{}", answer.verdict());
    for difference in answer.differences() {
        println!("  {}", difference.text);
    }

    // Without positions the two are the same structure: one is the other, turned by a quarter.
    let matching = isomorphic(&rising, &falling)?;
    let turned: Vec<String> = matching.vertices.iter().filter_map(|(v, w)| Some(format!("{v} is {}", (*w)?))).collect();
    println!("without places: {}", turned.join(", "));

    // With positions they are not.
    let [first, second] = [&rising, &falling].map(|s| move |v| position_key([s.point(v).x, s.point(v).y]));
    if let Err(difference) = isomorphic_with(&rising, &falling, &IsomorphismOptions::new().keys(&first, &second)) {
        println!("with places: {difference}");
    }
    Ok(())
}
