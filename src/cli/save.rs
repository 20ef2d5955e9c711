//! A structure as a file.

use super::{Failure, Output};
use dcel_kit::io::{Format, Model, write, write_path};
use std::path::{Path, PathBuf};

/// Refuses to write over the input.
pub(crate) fn not_the_input<'a>(input: &Path, targets: impl IntoIterator<Item = &'a PathBuf>) -> Result<(), Failure> {
    match targets.into_iter().find(|target| super::output::is_same_file(input, target)) {
        Some(target) => {
            let what = format!("{}: this is the input itself", target.display());
            Err(Failure::input(what, "choose another name"))
        }
        None => Ok(()),
    }
}

/// Writes a structure; the end of the name tells the format. `-` is dcel text on standard output.
pub(crate) fn save(path: &Path, model: &Model<'_>, out: &mut Output) -> Result<(), Failure> {
    let written = match Format::from_path(path) {
        _ if path.as_os_str() == "-" => write(out, model, Format::Dcel),
        Some(format) => write_path(path, model, format),
        None => {
            let what = format!("{}: the name does not tell the format to write", path.display());
            return Err(Failure::input(what, "end it in .dcel"));
        }
    };
    written.map_err(|error| Failure::of_writing(path, error))
}
