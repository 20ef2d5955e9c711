//! Lays two maps over each other, and measures what is covered by both.
//!
//! Run it: `cargo run --example overlay`
//!
//! It prints:
//!
//! ```text
//! 10 vertices, 2 of them crossings
//! f0: in f0 of the field, in f0 of the flood
//! f1: in f1 of the field, in f0 of the flood
//! f2: in f1 of the field, in f1 of the flood
//! f3: in f0 of the field, in f1 of the flood
//! union: 8 vertices, area 48
//! intersection: 4 vertices, area 6
//! difference: 6 vertices, area 18
//! xor: 10 vertices, area 42
//! ```

use dcel_kit::plane::{Operation, Parts, Point, Subdivision};

/// A rectangle given by two opposite corners.
fn rectangle([x0, y0, x1, y1]: [f64; 4]) -> Result<Subdivision, dcel_kit::plane::ConvertError> {
    Subdivision::polygon(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(Point::from))
}

/// A field and a flood.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (field, flood) = (rectangle([0., 0., 6., 4.])?, rectangle([4., 1., 9., 7.])?);
    let both = field.overlay(&flood)?;
    println!("{} vertices, {} of them crossings", both.subdivision.vertex_count(), both.crossings.len());

    // Every face knows which face of the first map and which of the second it is part of.
    for f in both.subdivision.faces() {
        println!("{f}: in {} of the field, in {} of the flood", both.face_of_a[f], both.face_of_b[f]);
    }
    for operation in [Operation::Union, Operation::Intersection, Operation::Difference, Operation::SymmetricDifference]
    {
        let region = both.region(operation, Parts::Joined)?;
        println!("{operation}: {} vertices, area {}", region.vertex_count(), region.domain_area());
    }
    Ok(())
}
