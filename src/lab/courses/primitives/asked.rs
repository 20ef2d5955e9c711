//! A function asked of a surface, which is stated as a table.

use super::growth::closed;
use crate::protocol::{Case, Start, Step};
use dcel_kit::FaceId;
use dcel_kit::topology::Table;

/// A surface with all vertices at one place. A table has an outer face, so the first one is said to be it.
pub(super) fn start(table: &Table) -> Start {
    let mut table = Table { outer_face: Some(FaceId::new(0)), ..closed(table) };
    table.vertices.iter_mut().flatten().for_each(|row| row.position = Some([0.0; 2]));
    Start::table(table)
}

/// A call, with the surface before and after it.
pub(super) fn call(name: String, table: &Table, function: &str, words: &[String]) -> Case {
    Case::new(name, start(table)).step(Step::Dump).step(Step::call(function, words)).step(Step::Dump)
}
