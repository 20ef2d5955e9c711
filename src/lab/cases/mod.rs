//! Which cases are asked: small structures of every kind, large ones, and random sequences with a seed.

pub mod classes;
pub mod large;
pub mod random;
