//! Lab 04, the half-edge data structure: what its functions should do, and the cases that ask for it.
//!
//! ```text
//!   suites.rs          the cases, test by test          starts.rs  the structures they begin with
//!   walks.rs           round a face, round a vertex, destination
//!   split_face.rs      in six steps                     split_in_half.rs  in three
//!   sequences.rs       one call after the other         drawing.rs        the drawing of the handout
//!   costs.rs           large structures, and how many records a call looks at
//!   features.rs        what can be said of a call       shorter.rs        shorter cases that may fail alike
//! ```

pub mod classes;
mod costs;
mod drawing;
mod features;
mod readings;
mod sequences;
mod shorter;
pub mod spec;
mod split_face;
mod split_in_half;
mod starts;
mod suites;
mod walk;
mod walks;

pub use suites::HalfEdge;

use crate::checks::align::align;
use crate::fault::Exchange;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Table, View};

/// The structure that a call should have left behind, in the numbers of the student's. A call that reads, and one
/// that is refused, leaves it as it was.
fn expected(exchange: &Exchange) -> Option<Table> {
    let before = exchange.before()?;
    let arguments = exchange.called?.0;
    match (exchange.function, arguments) {
        ("split_face", &[h1, h2]) => {
            let [h1, h2] = [h1, h2].map(HalfEdgeId::new);
            let Some((expected, new)) = spec::split_face(before, h1, h2) else { return Some(before.as_ref().clone()) };
            let yours = exchange.after().filter(|yours| yours.half_edge_bound() == expected.half_edge_bound());
            Some(yours.map_or_else(|| expected.clone(), |yours| align(&expected, &new, yours).expected))
        }
        ("split_in_half", &[he]) => {
            let he = HalfEdgeId::new(he);
            let aligned = exchange.after().and_then(|yours| split_in_half::expected(before, he, yours));
            aligned.map(|aligned| aligned.expected)
        }
        ("drawing", _) => drawing::reference(),
        _ => Some(before.as_ref().clone()),
    }
}
