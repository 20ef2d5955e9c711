//! `dcel lab reset`: the files to fill in as they were, with the old ones kept beside them.

use super::super::{Answer, Failure, Output, save};
use super::{bundled, folder};
use dcel_lab::{Kit, student_files};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Begin again: put back the files to fill in, and keep yours beside them
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Your file stays as `lab.rs.1.bak`, the next one as `lab.rs.2.bak`, and so on.

Examples:
  dcel lab reset
  dcel lab reset my-lab --given")]
pub(crate) struct Args {
    /// The lab's folder; without it, the one you are in
    #[arg(value_name = "DIR")]
    dir: Option<PathBuf>,
    /// Put back the given files, too (the driver, the tests, the handout), but not Cargo.toml
    #[arg(long)]
    given: bool,
}

impl Args {
    /// The files to fill in of this folder.
    pub(super) fn of(dir: &Path) -> Self {
        Self { dir: Some(dir.to_owned()), given: false }
    }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let dir = folder::find(args.dir.as_deref())?;
    let manifest = folder::manifest(&dir)?;
    let files = student_files(&bundled(&manifest.name)?, &Kit::default());
    let mut changed = 0;
    for (path, text) in &files {
        let graded = manifest.graded.contains(path);
        let own = manifest.optional.contains(path) || path.starts_with("Cargo.") || path == "tests/own.rs";
        let elsewhere = path.starts_with("kit/") && !dir.join("kit/Cargo.toml").is_file();
        if own || elsewhere || !(graded || args.given) {
            continue;
        }
        let target = dir.join(path);
        let old = fs::read_to_string(&target).ok();
        if old.as_deref() == Some(text) {
            continue;
        }
        changed += 1;
        if old.is_some() {
            let kept = backup(&target)?;
            writeln!(out, "{}: put back; yours is {}", target.display(), kept.display())?;
        } else {
            writeln!(out, "{}: put back", target.display())?;
        }
        save::put(&target, text)?;
    }
    if changed == 0 {
        writeln!(out, "Nothing to put back: the files are as they were given.")?;
    }
    Ok(Answer::Yes)
}

/// Moves a file to the first free name of the kind `lab.rs.1.bak`.
fn backup(path: &Path) -> Result<PathBuf, Failure> {
    let name = |i: u32| {
        let mut name = path.as_os_str().to_owned();
        name.push(format!(".{i}.bak"));
        PathBuf::from(name)
    };
    let free = (1..).map(name).find(|kept| !kept.exists()).unwrap_or_else(|| name(0));
    fs::rename(path, &free).map_err(|error| Failure::writing(free.display(), &error))?;
    Ok(free)
}
