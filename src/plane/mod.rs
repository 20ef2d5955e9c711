//! Half-edge structures in the plane: positions, exact decisions, faces that cover the whole plane.

mod point;
pub mod predicates;
mod subdivision;

pub use point::{CoordinateError, LARGEST, Point, SMALLEST, check_coordinate};
pub use subdivision::{PlanarView, Subdivision};
