//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                                  reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt                   the same from a file
//!   cargo run -- svg my-case.txt my-case.svg   draws the Voronoi diagram of the structure that the case ends with
//!   cargo run -- voronoi my-voronoi.svg        draws that of the sites of the handout
//! ```
//!
//! The language of the cases is explained in the handout, README.md.

mod calls;
#[path = "../../04-half-edge/src/dcel.rs"]
mod dcel;
mod frame;
#[path = "../../harness/mod.rs"]
mod harness;
mod lattice;
#[path = "../../predicates/mod.rs"]
mod predicates;
#[path = "../../04-half-edge/src/records.rs"]
mod records;
#[path = "../../04-half-edge/src/start.rs"]
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;
mod walks;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::VoronoiLab>()
}
