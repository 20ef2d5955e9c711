//! Surfaces of revolution: a ring, extruded layer by layer, with or without poles.
//!
//! ```text
//!       axis
//!        │
//!     ●──┼──●  profile[2]        ring of n ──> extrude the cap f1 ──> extrude again ──> pole in f1, pole in f0
//!    ╱   │   ╲
//!   ●────┼────●  profile[1]      the vertex of column c and layer k: profile[k] turned by c / n of a full turn
//!    ╲   │   ╱
//!     ●──┼──●  profile[0]
//! ```

use super::extrude::extrude_faces;
use super::placed::{Placed, part};
use super::{GrowError, Primitives, pole};
use crate::ids::{FaceId, HalfEdgeId, VertexMap};
use std::f64::consts::TAU;

/// What is spun: (radius, height) of the rings from the bottom up, and the heights of the poles.
pub(super) struct Profile {
    pub(super) rings: Vec<[f64; 2]>,
    pub(super) bottom_pole: Option<f64>,
    pub(super) top_pole: Option<f64>,
}

/// Spins a profile with at least one ring round the z axis, on a ring of `sides`.
pub(super) fn spin(on: &mut impl Primitives, sides: usize, profile: &Profile) -> Result<Placed, GrowError> {
    let mut placed = Placed::default();
    let (bottom, top) = (FaceId::new(0), FaceId::new(1));
    placed.parts.add(bottom, part::BOTTOM);
    placed.parts.add(top, part::TOP);
    let mut column: VertexMap<u32> = (0..sides as u32).collect::<Vec<_>>().into();
    let at = |column: u32, [radius, z]: [f64; 2]| {
        let (sin, cos) = (TAU * f64::from(column) / sides as f64).sin_cos();
        [radius * cos, radius * sin, z]
    };
    for c in 0..sides as u32 {
        placed.points.push(at(c, profile.rings[0]));
    }
    for &ring in &profile.rings[1..] {
        let made = extrude_faces(on, [top], |f| f == top)?;
        for (foot, above) in made.lifted {
            column.set(above, column[foot], 0);
            placed.points.set(above, at(column[foot], ring), [0.0; 3]);
        }
        made.walls.iter().for_each(|wall| placed.parts.add(wall.face, part::SIDE));
    }
    for (cap, bits, height) in [(bottom, part::BOTTOM, profile.bottom_pole), (top, part::TOP, profile.top_pole)] {
        if let (Some(z), Some(h)) = (height, on.dcel().half_edge(cap)) {
            add_pole(on, h, z, bits, &mut placed)?;
        }
    }
    Ok(placed)
}

fn add_pole(on: &mut impl Primitives, h: HalfEdgeId, z: f64, cap: u8, placed: &mut Placed) -> Result<(), GrowError> {
    let fan = pole(on, h)?;
    placed.points.set(fan.middle, [0.0, 0.0, z], [0.0; 3]);
    for face in fan.faces {
        placed.parts.remove(face, cap);
        placed.parts.add(face, part::SIDE);
    }
    Ok(())
}
