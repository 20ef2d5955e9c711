//! The student's folder on disk.

use super::super::Failure;
use dcel_kit::lab::{Kit, LabFiles, Packed, student_files, vendored};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Makes a folder with these files. One that exists must be empty: nothing is ever written over. The folder is there
/// when it is complete, and not before.
pub(super) fn make(dir: &Path, files: &BTreeMap<String, Packed>) -> Result<(), Failure> {
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
    let written = |error: io::Error| Failure::writing(dir.display(), &error);
    let dir = std::path::absolute(dir).map_err(written)?;
    let beside = beside(&dir);
    let made = lay(&beside, files).and_then(|()| {
        // An empty folder of that name gives way; one that is no longer empty stays.
        match fs::remove_dir(&dir) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => fs::rename(&beside, &dir),
        }
    });
    made.map_err(|error| {
        let _ = fs::remove_dir_all(&beside);
        written(error)
    })
}

fn lay(folder: &Path, files: &BTreeMap<String, Packed>) -> io::Result<()> {
    for (path, file) in files {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap_or(folder))?;
        fs::write(&path, &file.bytes)?;
    }
    Ok(())
}

/// Writes a file: beside its place first, then moved there, so that one that was there stays as it was if this fails.
pub(super) fn put(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let beside = beside(path);
    fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path)).map_err(|error| {
        let _ = fs::remove_file(&beside);
        Failure::writing(path.display(), &error)
    })
}

/// A hidden name in the same folder.
fn beside(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}.part", std::process::id()))
}

/// The files of a student's folder; with `vendor` all crates that it needs, too.
pub(super) fn files(lab: &LabFiles, kit: &Kit, vendor: bool) -> Result<BTreeMap<String, Packed>, Failure> {
    let files = student_files(lab, kit);
    if !vendor {
        return Ok(files.into_iter().map(|(path, text)| (path, Packed::from(text))).collect());
    }
    vendored(files).map_err(|error| {
        Failure::machine(format!("the crates cannot be had: {error}"), "this needs cargo, and the network once")
    })
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
