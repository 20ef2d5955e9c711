//! Attacks on the grader: each ends with the right verdict, wins nothing, and leaves nothing running.
//!
//! ```text
//!   sandbox     a program that does its worst, behind each barrier alone
//!   scan        the same in a student's file: refused at its line
//!   behind      the same with the scan switched off: the barriers hold by themselves
//!   compile     reading what others handed in while the compiler runs, under /opt, under /home, in a temporary folder
//!   ordinary    the same as a user who is not root, with and without namespaces; the instructor's secret
//!   handed in   folders and files that are not what they should be
//! ```
//!
//! A test of a barrier that this machine cannot have is ignored, with the reason; `.ci/run` fails if root on Linux ignores
//! one.
//!
//! All of it is harmless where a barrier is down: what is started ends by itself after a few seconds.

#[cfg(target_os = "linux")]
mod behind;
#[cfg(target_os = "linux")]
mod class;
#[cfg(target_os = "linux")]
mod compile;
#[cfg(target_os = "linux")]
mod handed_in;
#[cfg(target_os = "linux")]
mod ordinary;
#[cfg(target_os = "linux")]
mod sandbox;
#[path = "../support/trials.rs"]
mod trials;

#[cfg(target_os = "linux")]
fn main() {
    trials::run(
        [
            behind::trials(),
            compile::trials(),
            compile::behind_each(),
            handed_in::trials(),
            ordinary::trials(),
            sandbox::trials(),
            sandbox::behind_each(),
        ]
        .into_iter()
        .flatten()
        .collect(),
    )
}

#[cfg(not(target_os = "linux"))]
fn main() {
    trials::run(Vec::new())
}
