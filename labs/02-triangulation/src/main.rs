//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                                  reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt                   the same from a file
//!   cargo run -- svg my-case.txt my-case.svg   draws the polygons that the case ends with
//!   cargo run -- triangulation my.svg          draws what your `triangulate` makes of the polygon of the handout
//! ```
//!
//! The language of the cases is explained in the handout, README.md.

mod calls;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../../01-predicates/src/point.rs"]
mod point;
mod polygon;
mod predicates;
mod records;
mod start;
mod svg;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::TriangulationLab>()
}
