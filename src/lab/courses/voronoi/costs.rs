//! A large triangulation: is the cell right where numbers are large, and does it cost what it should?
//!
//! ```text
//!   lattice 150 150                203,402 records; numbers of half-edges up to 135,599; six triangles round most sites
//!   many 10000 cell 3000000        answers 59207 reads 695346          who looks at everything has used the reads up
//! ```

use crate::cases::large;
use crate::many::{self, Large};
use crate::protocol::{Case, Start, Structure};
use std::sync::{Arc, LazyLock};

/// The cells in a row, and the rows.
const SIDE: usize = 150;
/// How many reads the many questions have together. The solution needs 695,346.
const BUDGET: u64 = 3_000_000;

/// What the questions should give: six corners, on the border fewer.
pub(super) const LARGE: Large = Large {
    records: 203_402,
    answers: 59_207,
    one: "round which there are 6 triangles",
    elements: "sites",
    letter: 'v',
};

static LATTICE: LazyLock<Start> = LazyLock::new(|| {
    Start::known(format!("lattice {SIDE} {SIDE}"), Structure::HalfEdges(Arc::new(large::lattice(SIDE, SIDE))))
});

/// Questions about single sites, inside, on the border and at corners, then about many.
pub(super) fn questions() -> Case {
    many::questions(
        "cell_large.lattice",
        LATTICE.clone(),
        "cell",
        ["v22800", "v22725", "v16400", "v300", "v150", "v0"],
        BUDGET,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::walks::star;
    use crate::many::QUESTIONS;
    use dcel_kit::VertexId;

    #[test]
    fn the_large_triangulation_has_as_many_records_and_triangles_as_it_says() {
        let start = &LATTICE;
        let table = start.half_edges().unwrap();
        assert_eq!(start.structure().map(Structure::len), Some(LARGE.records as usize));
        let asked = (0..QUESTIONS).map(|i| VertexId::new((i * table.vertices.len() / QUESTIONS) as u32));
        let inside = |v: VertexId| {
            let spokes = star(table, table.vertices[v.index()].unwrap().outgoing.unwrap());
            spokes.iter().filter(|h| table.half_edges[h.index()].unwrap().face != table.outer_face).count()
        };
        assert_eq!(asked.map(inside).sum::<usize>() as u64, LARGE.answers);
    }
}
