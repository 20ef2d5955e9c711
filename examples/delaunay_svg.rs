//! Draws the Delaunay triangulation of random points, and the Voronoi cells of the same points.
//!
//! Run it: `cargo run --example delaunay_svg`
//!
//! It prints:
//!
//! ```text
//! 40 points, 106 edges, 67 triangles
//! edges that are not Delaunay: 0
//! 67 corners and 106 edges of Voronoi cells
//! ```

use dcel_kit::figure::{self, FigureOptions};
use dcel_kit::plane::{Point, Subdivision};
use std::fs;

/// Points that are the same on every run.
fn random_points(n: usize) -> Vec<Point> {
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / 16_384.0
    };
    (0..n).map(|_| Point::new(next(), next())).collect()
}

/// Two pictures of the same points.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points = random_points(40);
    let triangulation = Subdivision::delaunay(&points)?.subdivision;
    let triangles = triangulation.face_count() - 1; // f0 is the outer face
    println!("{} points, {} edges, {triangles} triangles", points.len(), triangulation.edge_count());

    // No point lies inside the circle round a triangle.
    println!("edges that are not Delaunay: {}", triangulation.non_delaunay_edges(|_| false).count());
    // Each triangle is a corner of the dual, each edge between two of them an edge of it.
    let voronoi = triangulation.voronoi()?;
    println!("{} corners and {} edges of Voronoi cells", voronoi.corners().len(), voronoi.edges().len());

    let picture = figure::structure(&triangulation, &FigureOptions::new("Delaunay triangulation"))?;
    let path = std::env::temp_dir().join("dcel-delaunay.svg");
    fs::write(&path, picture.to_svg())?;
    eprintln!("look at {}", path.display());
    Ok(())
}
