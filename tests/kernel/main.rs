//! The structure without coordinates: a file for each promise.
#![allow(clippy::unwrap_used)] // a test may panic

mod builder;
#[path = "../common/mod.rs"]
mod common;
mod edits;
mod examples;
mod flips;
mod house;
mod inverses;
mod isomorphism;
mod kernel_script;
mod missing_ids;
mod notebook;
mod oracles;
mod own;
mod pages;
mod refusals;
mod script;
mod table_of_edits;
mod tables;
mod validator;
mod walks;
