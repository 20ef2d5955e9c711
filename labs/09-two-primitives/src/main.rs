//! The program of the lab. Nothing here is for you to change: your part is `lab.rs`.
//!
//! ```text
//!   cargo run                        reads cases from standard input, prints what your code made of them
//!   cargo run -- my-case.txt         the same from a file
//!   cargo run -- growth growth.svg   draws the picture of your last task
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
mod svg;
mod walks;

// The last one: what it declares for itself, macros say, is not seen by the modules above.
mod lab;

fn main() -> std::process::ExitCode {
    harness::main::<calls::PrimitivesLab>()
}
