//! A cube whose corner is cut off, measured, subdivided, and drawn with its hidden lines.
//!
//! Run it: `cargo run --example solid`
//!
//! It prints:
//!
//! ```text
//! cube: V 8, E 12, F 6, V - E + F = 2, volume 8.0000
//! without a corner: V 10, E 15, F 7, V - E + F = 2, volume 7.8333
//! f6 has 3 sides, and the solid is convex: true
//! total deficit: 4.0000 pi
//! its dual: V 7, E 15, F 10, V - E + F = 2, volume 1.4167
//! subdivided: V 32, E 60, F 30, V - E + F = 2, volume 3.6019
//! ```

use dcel_kit::VertexId;
use dcel_kit::figure::{self, Camera, FigureOptions, HiddenLines};
use dcel_kit::solid::{Platonic, Polyhedron, Selection};
use dcel_kit::topology::measure;

/// Counts, volume and curvature of a solid, in a line.
fn tell(name: &str, solid: &Polyhedron) {
    let (v, e, f) = (solid.vertex_count(), solid.edge_count(), solid.face_count());
    let (euler, volume) = (measure(solid).closed_euler(), solid.signed_volume());
    println!("{name}: V {v}, E {e}, F {f}, V - E + F = {euler}, volume {volume:.4}");
}

/// From a cube to a smooth solid.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut solid = Polyhedron::platonic(Platonic::Cube);
    tell("cube", &solid);

    // A triangle in the place of v0, half way along its three edges.
    let (_, triangle) = solid.bevel_vertex(VertexId::new(0), 0.5)?;
    tell("without a corner", &solid);
    println!(
        "{triangle} has {} sides, and the solid is convex: {}",
        solid.incident_edges(triangle).count(),
        solid.check_convex().is_ok()
    );
    // Descartes: the angles that are missing round all vertices add up to 4 pi, whatever the solid.
    println!("total deficit: {:.4} pi", solid.total_deficit() / std::f64::consts::PI);

    tell("its dual", &solid.dual()?.solid);
    tell("subdivided", &solid.catmull_clark(&Selection::default())?.polyhedron);

    let options = FigureOptions::new("A cube without a corner");
    let picture = figure::solid(&solid, &Camera::default(), HiddenLines::Dashed, &options)?;
    let path = std::env::temp_dir().join("dcel-solid.svg");
    std::fs::write(&path, picture.to_svg())?;
    eprintln!("look at {}", path.display());
    Ok(())
}
