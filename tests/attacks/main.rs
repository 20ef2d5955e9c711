//! Attacks on the grader: each ends with the right verdict, wins nothing, and leaves nothing running.
//!
//! ```text
//!   walls       a program that does its worst, behind each wall alone
//!   scan        the same in a student's file: refused at its line
//!   behind      the same with the scan switched off: the walls hold by themselves
//!   handed in   folders and files that are not what they should be
//! ```
//!
//! All of it is harmless where a wall is down: what is started ends by itself after a few seconds.
#![cfg(target_os = "linux")]

mod behind;
mod class;
mod handed_in;
mod walls;
