//! What the race's rows of navmeshes need, and nothing else, so that it is built quickly: maps, and random numbers for
//! them. The other benches use both.

pub mod maps;
mod random;

pub use random::Random;
