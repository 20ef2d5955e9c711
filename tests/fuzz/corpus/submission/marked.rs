//! A lab.
use std::fmt;
impl Dcel {
    fn next(&self, h: usize) -> usize {
        // BEGIN SOLUTION
        // STARTER: todo!("next")
        self.half_edges[h].next
        // END SOLUTION
    }
}
