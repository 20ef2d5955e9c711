//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                     reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt      the same from a file
//!   cargo run -- map my-map.svg   draws your map of wrong signs
//! ```
//!
//! The language of the cases is explained in the handout, README.md.

mod calls;
mod exact;
#[path = "../../harness/mod.rs"]
mod harness;
mod map;
mod point;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::PredicatesLab>()
}
