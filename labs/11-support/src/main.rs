//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                                  reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt                   the same from a file
//!   cargo run -- svg my-case.txt my-case.svg   your picture of the mesh that the case ends with
//!   cargo run -- climb my-climb.svg            your picture of the climb over the gem
//! ```
//!
//! The language of the cases is explained in the handout, README.md.

mod calls;
mod dcel;
mod edge_map;
#[path = "../../harness/mod.rs"]
mod harness;
mod height;
mod records;
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::SupportLab>()
}
