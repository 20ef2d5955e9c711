//! The student's folder on disk.

use super::super::Failure;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Makes a folder with these files. One that exists must be empty: nothing is ever written over.
pub(super) fn make(dir: &Path, files: &BTreeMap<String, String>) -> Result<(), Failure> {
    match fs::read_dir(dir) {
        Ok(mut entries) => {
            if entries.next().is_some() {
                let what = format!("{}: is not empty", dir.display());
                return Err(Failure::input(what, "name a folder that does not exist yet"));
            }
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) => {
            return Err(Failure::input(format!("{}: {error}", dir.display()), "name a folder that does not exist yet"));
        }
    }
    for (path, text) in files {
        let path = dir.join(path);
        let parent = path.parent().unwrap_or(dir);
        fs::create_dir_all(parent).map_err(|error| Failure::writing(parent.display(), &error))?;
        fs::write(&path, text).map_err(|error| Failure::writing(path.display(), &error))?;
    }
    Ok(())
}

/// The folder of a lab: the one named, or the nearest one upwards from here that holds a `lab.toml`.
pub(super) fn find(named: Option<&Path>) -> Result<PathBuf, Failure> {
    const HELP: &str = "go into the folder that `dcel lab start` made, or name it";
    if let Some(dir) = named {
        return if dir.join("lab.toml").is_file() {
            // Commands are run inside it: a way from here would lead elsewhere there.
            std::path::absolute(dir).map_err(|error| Failure::input(error, HELP))
        } else {
            Err(Failure::input(format!("{}: no lab is there: it has no lab.toml", dir.display()), HELP))
        };
    }
    let here = std::env::current_dir().map_err(|error| Failure::input(error, HELP))?;
    here.ancestors()
        .find(|dir| dir.join("lab.toml").is_file())
        .map(Path::to_owned)
        .ok_or_else(|| Failure::input("no lab is here: no folder from here upwards has a lab.toml", HELP))
}

/// The text of a file in it.
pub(super) fn read(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path)
        .map_err(|error| Failure::input(format!("{}: {error}", path.display()), "is the folder complete?"))
}
