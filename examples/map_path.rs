//! Reads a map, finds the shortest path round its walls, and draws it.
//!
//! Run it: `cargo run --example map_path`
//!
//! It prints:
//!
//! ```text
//! 31 convex faces to walk on
//! breadth: 23.346 long, 4 turns, through 5 faces
//! midpoint: 23.346 long, 4 turns, through 5 faces
//! exact: 23.237 long, 7 turns, through 8 faces
//! ```

use dcel_kit::figure::{FigureOptions, navmesh::Floor};
use dcel_kit::io::{LoadOptions, Structure, load};
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::Point;
use std::path::Path;

/// Across the map, by three ways of searching.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let loaded = load(Path::new("figures/data/rooms.map"), &LoadOptions::default())?;
    let Structure::Plane(map) = loaded.structure else { return Err("this is no map of the plane".into()) };
    let mesh = NavMesh::new(&map)?;
    println!("{} convex faces to walk on", mesh.faces().filter(|&f| mesh.is_walkable(f)).count());

    // In the file y points down, here it points up.
    let [start, goal] = [Point::new(21.5, -5.5), Point::new(0.5, -4.5)];
    let mut planner = Planner::new();
    // From the fewest faces to the shortest path of all.
    for algorithm in [PathAlgorithm::Breadth, PathAlgorithm::Midpoint, PathAlgorithm::Exact] {
        let path = planner.route_between(&mesh, algorithm, start, goal)?;
        println!(
            "{algorithm}: {:.3} long, {} turns, through {} faces",
            path.length,
            path.corners.len(),
            path.faces.len()
        );
    }

    let path = planner.route_between(&mesh, PathAlgorithm::Exact, start, goal)?;
    let picture = Floor::new(&map, &mesh).route(&path, &FigureOptions::new("The shortest path"))?;
    let file = std::env::temp_dir().join("dcel-path.svg");
    std::fs::write(&file, picture.to_svg())?;
    eprintln!("look at {}", file.display());
    Ok(())
}
