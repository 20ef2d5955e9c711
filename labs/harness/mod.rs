//! The program of every lab: it reads cases, calls your functions, prints what they gave back and what they made of
//! the structure. Nothing here is for you to change.
//!
//! ```text
//!   a case, as text ──▶ words.rs    names, links: h0.next.twin        value.rs      what goes in and out of a call
//!                       run.rs      starts, calls, dumps              structure.rs  the records that a lab declares
//!                       output.rs   what is printed, and every call   reads.rs      how many records a call looks at
//!                                   of yours, behind a guard          records.rs    the lists that count
//! ```
//!
//! A lab says what it has in a [`Lab`]: its records, its starts, its calls. All of this depends on the standard
//! library only.

// A lab uses the parts that it needs.
#![allow(dead_code, unused_imports)]

mod output;
mod reads;
mod records;
mod run;
mod structure;
mod value;
mod words;

pub use reads::Meter;
pub use records::{Record, Records};
pub use run::{answers, main};
pub use structure::{Cell, Column, Link, Shortcut, Structure, Table, dump};
pub use value::{Argument, Take, Value, coordinate, places, points, whole};

/// What a lab brings along.
pub trait Lab: 'static {
    /// What the calls work on. A lab whose functions need no structure takes `()`.
    type Structure: Structure;
    /// The lines that a case can begin with.
    const STARTS: &'static [Start<Self::Structure>];
    /// The functions that a case can call.
    const CALLS: &'static [Call<Self::Structure>];
    /// Draws a structure as SVG, if the lab has that.
    const PICTURE: Option<fn(&Self::Structure) -> String>;
    /// Cases that have a name: `cargo run -- NAME out.svg` draws what such a case ends with.
    const NAMED: &'static [(&'static str, &'static str)];
}

/// A line that makes a structure.
pub struct Start<S> {
    /// Its first word.
    pub word: &'static str,
    /// How it is written, for messages: "write `grid 3 2`".
    pub usage: &'static str,
    /// Makes it of the other words of the line.
    pub make: fn(&[&str]) -> Result<S, String>,
}

/// A line that calls one of your functions.
pub struct Call<S> {
    /// Its first word.
    pub word: &'static str,
    /// What the function takes.
    pub takes: &'static [Take],
    /// How the line is written, for messages.
    pub usage: &'static str,
    /// Makes the call.
    pub run: fn(&mut S, &[Argument], Meter) -> Value,
}
