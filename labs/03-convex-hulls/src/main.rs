//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                                  reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt                   the same from a file
//!   cargo run -- svg my-case.txt my-case.svg   draws what the case ends with
//!   cargo run -- hull my-hull.svg              draws the points of the handout, their hull and two tangents
//! ```
//!
//! The language of the cases is explained in the handout, README.md.

mod calls;
mod halves;
#[path = "../../harness/mod.rs"]
mod harness;
mod polygons;
#[path = "../../predicates/mod.rs"]
mod predicates;
mod records;
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;

// `svg.rs` is the writer of lab 04, where points stand in a file of this name.
use polygons as dcel;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::HullLab>()
}
