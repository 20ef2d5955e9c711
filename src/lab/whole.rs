//! Files that are there whole or not at all.

use super::walls::unguessable;
use std::fs;
use std::io;
use std::path::Path;

/// Writes a file beside its place and moves it there: nobody ever reads half of it, and a failure leaves what was
/// there. A link is followed; what is no ordinary file, such as a pipe, is written to as it is.
///
/// # Errors
/// If the folder is not there, or cannot be written to.
pub fn write_whole(file: &Path, bytes: &[u8]) -> io::Result<()> {
    if fs::metadata(file).is_ok_and(|data| !data.is_file()) {
        return fs::write(file, bytes);
    }
    let file = file.canonicalize().unwrap_or_else(|_| file.to_path_buf());
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let beside = file.with_file_name(format!(".{name}.{}", &unguessable()[..12]));
    fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, &file)).inspect_err(|_| {
        let _ = fs::remove_file(&beside);
    })
}
