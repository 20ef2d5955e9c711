//! The tessellated cube: up, then back, then to the right.
//!
//! ```text
//!      z              ●───●              ●───●───●             ●───●───●
//!      │  y          ╱   ╱│             ╱   ╱   ╱│            ╱   ╱   ╱│
//!      │╱            ●───● ●            ●───●   ╱ ●  ...      ●───●───● ●
//!      ┼── x   ●───● │   │╱│    ==>     │   │  ...     ==>    │   │   │╱│
//!     ╱   ring╱   ╱  ●───● ●            ●───●                 ●───●───● ●
//!             ●───●  │   │╱             │   │                 │   │   │╱
//!                    ●───●              ●───●                 ●───●───●
//! ```
//!
//! Each extrusion moves the selected side by one step; a new wall continues the side below it.

use super::extrude::extrude_faces;
use super::placed::{Placed, part, stride};
use super::{GrowError, Primitives};
use crate::ids::FaceId;
use std::collections::BTreeMap;

/// The walls round the first layer, in the order of the ring's half-edges.
const ROUND: [u8; 4] = [part::FRONT, part::RIGHT, part::BACK, part::LEFT];

/// Grows a box of `steps` cubes from a ring of four; its corners are at -1 and 1.
///
/// Cost: O(x y z) for x, y and z steps: each step walks round the faces of one side, and moves it.
pub(super) fn cuboid(on: &mut impl Primitives, steps: [usize; 3]) -> Result<Placed, GrowError> {
    let mut placed = Placed::default();
    placed.parts.add(FaceId::new(0), part::BOTTOM);
    placed.parts.add(FaceId::new(1), part::TOP);
    let mut sides =
        Sides::from([(part::TOP, vec![FaceId::new(1)]), (part::BACK, Vec::new()), (part::RIGHT, Vec::new())]);
    placed.points = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].into();
    for (side, axis, first) in [(part::TOP, 2, 0), (part::BACK, 1, 1), (part::RIGHT, 0, 1)] {
        for _ in first..steps[axis] {
            push(on, &mut placed, &mut sides, side, axis)?;
        }
    }
    let scaled = |p: [f64; 3]| std::array::from_fn(|axis| stride(p[axis] as usize, steps[axis]));
    placed.points = placed.points.as_slice().iter().map(|&p| scaled(p)).collect::<Vec<_>>().into();
    Ok(placed)
}

/// The faces of the sides that are pushed, in the order of their numbers.
type Sides = BTreeMap<u8, Vec<FaceId>>;

/// Extrudes one side of the box by one step along an axis.
fn push(
    on: &mut impl Primitives,
    placed: &mut Placed,
    sides: &mut Sides,
    side: u8,
    axis: usize,
) -> Result<(), GrowError> {
    let faces = sides.get(&side).cloned().unwrap_or_default();
    let made = extrude_faces(on, faces, |f| placed.parts.has(f, side))?;
    for (foot, above) in made.lifted {
        let mut point = placed.points[foot];
        point[axis] += 1.0;
        placed.points.set(above, point, [0.0; 3]);
    }
    for v in made.inner {
        placed.points[v][axis] += 1.0;
    }
    for (i, wall) in made.walls.iter().enumerate() {
        let below = placed.parts.mask(wall.below);
        let first_layer = side == part::TOP && below == part::BOTTOM;
        let part = if first_layer { ROUND[i % 4] } else { below };
        placed.parts.add(wall.face, part);
        if let Some(list) = sides.get_mut(&part) {
            list.push(wall.face);
        }
    }
    Ok(())
}
