//! What every judge of half-edge structures needs: pure functions on structures and on what calls returned.
//!
//! ```text
//!   before ──the call as it should be──▶ expected ┐   by the judge of the lab
//!      │                                          ├─▶ the pointers that differ   align.rs
//!      └──the student's program──▶ after ─────────┘   each said in words, with the laws it breaks   steps.rs
//!                         returned 4 2 0 ─▶ compared with the walk, up to where it starts   cyclic.rs
//! ```
//!
//! `faults.rs` collects what is wrong with a call, `duals.rs` knows what a dual is. The structure before a call is the student's own, so old elements
//! keep their numbers and only the new ones may be numbered at will. `after` may be broken in every way: nothing here
//! panics or walks without a bound (`walks.rs`).

pub mod align;
pub mod cyclic;
pub mod duals;
pub mod faults;
pub mod steps;
pub mod walks;
