//! A small readable language for edits: one statement a line, typed by a student, printed by a failing test.
//!
//! ```text
//!   rectangle                        # the start: the half-edge lab's six-vertex rectangle, h0 .. h11
//!   let a = split_face h2 h8         # a: the new half-edge, from the origin of h2 to the origin of h8
//!   let c = split_in_half a          # c: the half-edge that now follows a; c.origin: the new vertex
//!   walk_face a.twin                 # along next until it closes
//!   highlight a c c.origin
//!   caption The wall between the rooms has a door
//!   join_edges a
//!   dump
//! ```
//!
//! **Starts**: `rectangle`, `polygon x y x y …` (counter-clockwise corners), `triangles x y x y … / i j k …`
//! (points, then corners by number from 0).
//!
//! **Half-edges are words.** `h0`, `h1`, … are the given ones, in the order in which the start states its edges:
//! the k-th stated edge is `h(2k)` on the side that states it (inside), and `h(2k+1)` on its other side (outside).
//! In this kit that number is the id, so a given word is what the figures show. What an edit makes has no number
//! in a script, because whoever allocates it chooses the number: it is named by `let`, or by links from a known
//! half-edge, as in `h0.next.twin`. `v0`, `f1`, `e2` of the start are given in the same way.
//!
//! **Without coordinates.** A script that starts with `torus`, `ring N` (a double-sided disc) or
//! `surface N / i j k ... / ...` (N vertices and their faces) is played on the kernel, where whatever is
//! combinatorially legal may be done. [`Script::parse_kernel`] reads it.
//!
//! **In space.** A script that starts with `solid cube` (or another of Plato's solids) or
//! `mesh x y z ... / i j k ... / ...` (points, then the corners of each face) is played on a surface with positions.
//! `Script::parse_solid` reads it.
//!
//! **Edits.** All edits are words; which of them a structure has, and what they take, is said by the
//! [table of edits](crate::edits::rows). A place is `X Y` in the plane and `X Y Z` in space.
//!
//! | link | from | to |
//! |---|---|---|
//! | `next prev twin` | half-edge | half-edge |
//! | `origin destination` | half-edge | vertex |
//! | `face`, `edge` | half-edge | face, edge |
//! | `outgoing` | vertex | half-edge |
//! | `half_edge` | face | half-edge |
//!
//! A word stays with its element: if that is removed, the word is refused from then on, even if the number has
//! been given out again.
//!
//! ```text
//!   syntax.rs  what a script says                  words.rs, cursor.rs, starts.rs, parse.rs  from text
//!   kernel.rs  starts without coordinates          play.rs    step by step      error.rs  file:line:column
//!   replay.rs  edits back to text                  the edits themselves: the table in edits/
//! ```
//!
//! ```
//! use dcel_kit::script::Script;
//! let script = Script::parse("rectangle\nlet a = split_face h2 h8\nsplit_in_half a\n", "example")?;
//! let run = script.run();
//! assert_eq!(run.end.vertex_count(), 7);
//! assert_eq!(run.steps[1].outcome.to_string(), "split_in_half h12 returned v6, h14");
//! # Ok::<(), dcel_kit::script::ScriptError>(())
//! ```

mod cursor;
mod error;
mod kernel;
mod parse;
mod play;
mod replay;
#[cfg(feature = "solid")]
mod solid;
mod starts;
mod syntax;
mod words;

#[cfg(feature = "play")]
pub(crate) use replay::Writer;
#[cfg(feature = "play")]
pub(crate) use syntax::follow;
#[cfg(feature = "play")]
pub(crate) use {crate::edits::element, parse::parse_on};

pub use error::{Problem, ScriptError};
pub use kernel::{KernelStart, KernelStartError};
pub use play::{Outcome, Refusal, Run, Step};
pub use replay::{of_edits, of_kernel_edits};
pub use starts::{Ground, is_kernel_script};
pub use syntax::{Link, Script, Statement};
#[cfg(feature = "solid")]
pub use {replay::of_solid_edits, solid::SolidStart};

/// A call of an edit of the plane.
pub type Edit = crate::edits::Call<crate::plane::Subdivision>;
/// A call of an edit of the kernel.
pub type KernelEdit = crate::edits::Call<crate::topology::Dcel>;

/// A call of an edit of a surface in space.
#[cfg(feature = "solid")]
pub type SolidEdit = crate::edits::Call<crate::solid::Polyhedron>;
