//! `dcel lab bundle`: the archives of the labs that are compiled into the kit, written anew.

use super::super::{Answer, Failure, Output};
use dcel_kit::lab::LabFiles;
use std::fs;
use std::io::Write;
use std::path::PathBuf;

/// Write the archives of the labs anew, from their folders in the repository
#[derive(clap::Args, Debug)]
pub(crate) struct Args {
    /// The repository
    #[arg(value_name = "DIR", default_value = ".")]
    dir: PathBuf,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    for name in LabFiles::bundled_names() {
        let lab = LabFiles::read(&args.dir.join("labs").join(&name))
            .map_err(|error| Failure::input(error, "go to the root of the kit's repository"))?;
        let path = args.dir.join("src/lab/bundle").join(format!("{name}.txt"));
        fs::write(&path, lab.to_archive()).map_err(|error| Failure::writing(path.display(), &error))?;
        writeln!(out, "{}: {} files", path.display(), lab.iter().count())?;
    }
    Ok(Answer::Yes)
}
