//! The student's folder on disk.

use super::super::Failure;
use super::super::input::text_of;
use super::super::save::put_folder;
use dcel_kit::files::write_whole;
use dcel_lab::{Kit, LabFiles, Manifest, Packed, student_files, vendored};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Makes a folder with these files, and the folders that lead there. One that exists must be empty: nothing is ever written
/// over. The folder is there when it is complete, and not before.
pub(super) fn make(dir: &Path, files: &BTreeMap<String, Packed>) -> Result<(), Failure> {
    let whole = std::path::absolute(dir).map_err(|error| Failure::writing(dir.display(), &error))?;
    let on_the_way: Vec<&Path> = whole.ancestors().skip(1).take_while(|folder| !folder.exists()).collect();
    let way = on_the_way.first().map_or(Ok(()), |parent| {
        fs::create_dir_all(parent).map_err(|error| Failure::writing(parent.display(), &error))
    });
    let made =
        way.and_then(|()| put_folder(dir, files.iter().map(|(path, file)| (path.as_str(), file.bytes.as_slice()))));
    if made.is_err() {
        // Those that are not empty stay, and so do those above them.
        on_the_way.into_iter().take_while(|folder| fs::remove_dir(folder).is_ok()).for_each(drop);
    }
    made
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

/// Reads the manifest of the lab in a folder.
pub(super) fn manifest(dir: &Path) -> Result<Manifest, Failure> {
    let toml = dir.join("lab.toml");
    Manifest::parse(&read(&toml)?, &toml.display().to_string())
        .map_err(|error| Failure::input(error, "put back the lab.toml that the lab came with"))
}

/// The text of a file in it.
pub(super) fn read(path: &Path) -> Result<String, Failure> {
    text_of(path, "is the folder complete?")
}

/// What checks leave in the folder of a lab.
pub(super) fn checked(dir: &Path) -> PathBuf {
    dir.join("target").join("check")
}

/// What was remembered under this name in the folder of a lab, if it is there and can be read.
pub(super) fn remembered<T: DeserializeOwned>(dir: &Path, name: &str) -> Option<T> {
    serde_json::from_str(&fs::read_to_string(checked(dir).join(name)).ok()?).ok()
}

/// Remembers something. If it cannot be written, it is forgotten.
pub(super) fn remember(dir: &Path, name: &str, what: &impl Serialize) {
    let _ = fs::create_dir_all(checked(dir));
    let _ = write_whole(&checked(dir).join(name), serde_json::to_string(what).unwrap_or_default());
}
