//! The command line as its users type it, a file for each group of commands.
#![cfg(feature = "cli")]

mod build;
mod compare;
mod delaunay;
mod errors;
mod files;
mod locate;
mod manners;
mod mend;
mod navmesh;
mod reading;
mod samples;
mod script;
mod shared;
#[path = "../shell/mod.rs"]
mod shell;
mod triangulate;
