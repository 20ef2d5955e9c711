//! What judges make cases of: small structures by their faces, large ones that need not be printed, numbers from a seed.

pub mod cycles;
pub mod large;
pub mod random;
pub mod starts;
