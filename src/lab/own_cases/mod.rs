//! Students' own tests: cases with the answers that they expect, and how many known mistakes these catch.
//!
//! ```text
//!   case the outer face                  a case, as the handout types one, with a line `expect` below a call
//!   rectangle
//!   walk_face f0
//!   expect cycle h1 h11 h9 h7 h5 h3     the answer, from any of them on; `expect set` in any order
//! ```
//!
//! A case that the solution does not answer as it expects is wrong, and does not count. The others run against every
//! known mistake: one is caught if some case is not answered as expected. Which mistakes these are is never told, and
//! the student's own code has no part in it.
//!
//! ```text
//!   cases.rs   the file, what a program is asked, what its answers say
//! ```

mod cases;

pub use cases::{OwnCaseError, OwnCases};

use crate::lanes::in_lanes;
use crate::verify::compile;
use crate::{Driver, Lab, OwnTests};
use std::io;
use std::path::Path;

/// The file of a student that holds them.
pub const OWN_CASES: &str = "tests/own.txt";

/// The solution and the known mistakes of a lab, as programs.
#[derive(Debug)]
pub struct KnownMistakes {
    solution: Driver,
    mistakes: Vec<Driver>,
}

/// Builds a program of the lab with this text in the place of the student's file.
///
/// # Errors
/// If there is no compiler, or it rejects the text.
pub fn built(lab: &Lab, text: &str, room: &Path) -> io::Result<Driver> {
    let program = room.join(format!("program{}", std::env::consts::EXE_SUFFIX));
    compile(lab, &room.join("tree"), &program, text, false)?.map_err(io::Error::other)?;
    Ok(Driver::new(program, lab.manifest.limits))
}

impl KnownMistakes {
    /// Builds all of them in `room`, a folder that stays as long as this. `lab` is one with its solution, read from its
    /// folder.
    ///
    /// # Errors
    /// If there is no solution, a known mistake does not fit it, or something does not build.
    pub fn build(lab: &Lab, room: &Path) -> io::Result<Self> {
        let solution = lab.files.get("solution/lab.rs");
        let solution = solution.ok_or_else(|| io::Error::other(format!("{}: the solution is not here", lab.name)))?;
        let mut texts = vec![solution.to_owned()];
        for bug in &lab.bugs {
            texts.push(bug.apply(solution).map_err(io::Error::other)?);
        }
        let lanes = std::thread::available_parallelism().map_or(1, usize::from);
        let made = in_lanes(lanes, texts.len(), |lane, i| {
            let program = room.join(format!("known-{i}{}", std::env::consts::EXE_SUFFIX));
            let compiled = compile(lab, &room.join(format!("tree-{lane}")), &program, &texts[i], false);
            let made = compiled.and_then(|compiled| compiled.map_err(io::Error::other));
            (made.map(|()| Driver::new(program, lab.manifest.limits)), true)
        });
        let mut drivers = made.into_iter().flatten().collect::<io::Result<Vec<_>>>()?.into_iter();
        let solution = drivers.next().ok_or_else(|| io::Error::other("nothing was built"))?;
        Ok(Self { solution, mistakes: drivers.collect() })
    }

    /// What a student's file of own cases catches; `None` for who handed in none.
    #[must_use]
    pub fn caught_by_text(&self, text: Option<&str>) -> OwnTests {
        match text.map(|text| OwnCases::parse(text, OWN_CASES)) {
            Some(Ok(cases)) => self.caught_by(&cases),
            Some(Err(error)) => {
                OwnTests { known: self.mistakes.len(), problems: vec![error.to_string()], ..OwnTests::default() }
            }
            None => OwnTests { known: self.mistakes.len(), ..OwnTests::default() },
        }
    }

    /// What a student's cases catch. The same cases give the same answer.
    ///
    /// Cost: one run of each known mistake.
    #[must_use]
    pub fn caught_by(&self, cases: &OwnCases) -> OwnTests {
        let mut problems = Vec::new();
        let mut right = Vec::new();
        for (case, failed) in cases.names().into_iter().zip(cases.run(&self.solution)) {
            right.push(failed.is_none());
            problems.extend(failed.map(|why| format!("{case} does not count, the solution fails it: {why}")));
        }
        let cases = cases.only(&right);
        let is_caught = |mistake: &&Driver| cases.run(*mistake).iter().any(Option::is_some);
        let caught = if cases.is_empty() { 0 } else { self.mistakes.iter().filter(is_caught).count() };
        let known = self.mistakes.len();
        OwnTests { cases: right.iter().filter(|right| **right).count(), caught, known, problems, ..OwnTests::default() }
    }
}
