//! What judges make cases of: large structures that need not be printed, and numbers from a seed.

pub mod large;
pub mod random;
pub mod starts;
