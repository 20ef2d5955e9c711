//! Your part of the lab. The task is in the handout, README.md; the functions that help are in `dcel.rs`.

use crate::dcel::Dcel;

impl Dcel {
    /// Task 1. How many edges have the outer face on exactly one side.
    pub fn border_edges(&self) -> usize {
        // BEGIN SOLUTION
        // STARTER: todo!("border_edges")
        let is_outer = |h: usize| self.face(h) == self.outer_face;
        let on_border = (0..self.half_edges.len()).filter(|&h| is_outer(h) && !is_outer(self.twin(h)));
        on_border.count()
        // END SOLUTION
    }
}
