//! `dcel lab check --own`: the student's own cases against their code, and against the known mistakes.

use super::super::input::text_of;
use super::super::{Answer, Failure, Output};
use super::{folder, verify};
use dcel_kit::files::ScratchFolder;
use dcel_lab::{KnownMistakes, Lab, OWN_CASES, OwnCases, built};
use std::io::Write;
use std::path::Path;

/// Runs the cases of the folder `dir`. With the folder of the labs, which has the solutions, it says what they catch.
pub(super) fn check(lab: &Lab, dir: &Path, labs: Option<&Path>, out: &mut Output) -> Result<Answer, Failure> {
    let file = dir.join(OWN_CASES);
    let help =
        "write it: a line `case NAME`, a start, a call, and below it `expect ANSWER`; README.md of labs/ tells more";
    let text = text_of(&file, help)?;
    let cases = OwnCases::parse(&text, &file.display().to_string()).map_err(|error| Failure::input(error, ""))?;
    if cases.is_empty() {
        let help = "write a line `case NAME`, a start, a call, and below it `expect ANSWER`";
        return Err(Failure::input(format!("{}: nothing is expected there", file.display()), help));
    }
    let room = ScratchFolder::new("dcel-own").map_err(|error| Failure::writing("a temporary folder", &error))?;
    let mine = lab.manifest.graded.first().map_or_else(|| dir.join("src/lab.rs"), |path| dir.join(path));
    let program = built(lab, &folder::read(&mine)?, room.path()).map_err(|error| {
        Failure::input(format!("{}: {error}", mine.display()), "run `dcel lab check` and mend the first error")
    })?;
    let said = cases.run(&program);
    for (name, why) in cases.names().iter().zip(&said) {
        match why {
            None => writeln!(out, "  + {name}")?,
            Some(why) => writeln!(out, "  - {name}: {why}")?,
        }
    }
    let right = said.iter().filter(|why| why.is_none()).count();
    writeln!(out, "{right} of {} cases are answered as you expect", said.len())?;
    if let Some(labs) = labs {
        let known = known_mistakes(lab, labs, room.path())?.caught_by(&cases);
        for problem in &known.problems {
            writeln!(out, "  ! {problem}")?;
        }
        writeln!(out, "Your cases catch {} of {} known mistakes", known.caught, known.known)?;
    }
    Ok(if right == said.len() { Answer::Yes } else { Answer::No })
}

/// The known mistakes of a lab, built from its folder among these.
pub(crate) fn known_mistakes(lab: &Lab, labs: &Path, room: &Path) -> Result<KnownMistakes, Failure> {
    let whole = verify::read(&labs.join(&lab.name))?;
    KnownMistakes::build(&whole, room).map_err(|error| {
        let what = format!("the known mistakes of {} cannot be built: {error}", lab.name);
        Failure::input(what, "name the folder `labs` of a checkout: it has the solutions")
    })
}
