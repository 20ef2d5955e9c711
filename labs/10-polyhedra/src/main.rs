//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                                  reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt                   the same from a file
//!   cargo run -- svg my-case.txt my-case.svg   draws the polyhedron that the case ends with, and its dual
//!   cargo run -- cube my-cube.svg              draws the cube and its dual; so with the other four regular solids
//! ```
//!
//! The language of the cases is explained in the handout, README.md.

mod calls;
#[path = "../../harness/mod.rs"]
mod harness;
mod polyhedron;
mod records;
mod start;
mod svg;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::PolyhedraLab>()
}
