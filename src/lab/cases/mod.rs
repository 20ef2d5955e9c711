//! Which cases are asked: small structures of every kind, and random sequences with a seed.

pub mod classes;
