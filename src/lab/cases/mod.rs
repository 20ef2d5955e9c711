//! What judges make cases of: small structures by their faces, large ones that need not be printed, numbers from a
//! seed, what the handouts draw.

pub mod cycles;
pub mod handouts;
pub mod large;
pub mod random;
pub mod starts;
