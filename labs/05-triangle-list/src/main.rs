//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                                  reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt                   the same from a file
//!   cargo run -- svg my-case.txt my-case.svg   draws the structure that the case ends with
//!   cargo run -- structure my-structure.svg    draws what your `from_faces` makes of the list of the handout
//! ```
//!
//! The language of the cases is explained in the handout, README.md.

mod calls;
#[path = "../../04-half-edge/src/dcel.rs"]
mod dcel;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../../04-half-edge/src/records.rs"]
mod records;
mod refusal;
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::TriangleListLab>()
}
