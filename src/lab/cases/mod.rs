//! What judges make cases of: small structures by their faces, polygons by their corners, large
//! ones that need not be printed, the same ones
//! with other numbers, numbers from a seed, what the handouts draw.

pub mod corners;
pub mod cycles;
pub mod handouts;
pub mod large;
pub mod numbers;
pub mod random;
pub mod starts;
