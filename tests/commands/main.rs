//! The command line as its users type it, a file for each group of commands.

mod build;
mod compare;
mod degenerate;
mod delaunay;
mod errors;
mod figure_options;
mod files;
mod growth;
mod locate;
mod manners;
mod memory;
mod mend;
mod misfits;
mod navmesh;
mod navmesh_costs;
mod navmesh_flags;
mod numbers;
mod old_words;
mod play;
mod reading;
mod samples;
mod script;
#[path = "../shell/mod.rs"]
mod shell;
mod shells;
mod solid;
mod storeys;
mod targets;
mod triangulate;
mod well_known_text;
