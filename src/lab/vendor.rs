//! The crates that a student's folder needs, laid into it: for a classroom without the network.
//!
//! ```text
//!   my-lab/
//!     vendor/NAME/…           as `cargo vendor` writes them
//!     .cargo/config.toml      says to take them from there, and from nowhere else
//! ```

use super::export::{Packed, packed_tree};
use dcel_kit::files::ScratchFolder;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;
use std::process::Command;

/// What makes cargo look in the folder; the path is seen from the folder itself, wherever that stands.
const SETTINGS: &str = "\
# All crates lie in vendor/: nothing is downloaded.
[source.crates-io]
replace-with = \"vendor\"

[source.vendor]
directory = \"vendor\"
";

/// The files of a student's folder together with all crates that it needs. The crates are downloaded now, unless cargo
/// has them already.
///
/// # Errors
/// If cargo cannot be started, or cannot have the crates: with what it said.
pub fn vendored(files: BTreeMap<String, String>) -> io::Result<BTreeMap<String, Packed>> {
    let mut packed = laid(ScratchFolder::new("dcel-vendor")?.path(), &files)?;
    packed.insert(".cargo/config.toml".to_owned(), Packed::from(SETTINGS.to_owned()));
    packed.extend(files.into_iter().map(|(path, text)| (path, Packed::from(text))));
    Ok(packed)
}

/// Lets cargo lay the crates into a folder with these files; gives the crates.
fn laid(folder: &Path, files: &BTreeMap<String, String>) -> io::Result<BTreeMap<String, Packed>> {
    for (path, text) in files {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap_or(folder))?;
        fs::write(path, text)?;
    }
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let ran = Command::new(cargo).args(["vendor", "--locked", "--quiet", "vendor"]).current_dir(folder).output()?;
    if !ran.status.success() {
        return Err(io::Error::other(String::from_utf8_lossy(&ran.stderr).trim().to_owned()));
    }
    let mut crates = BTreeMap::new();
    packed_tree(&folder.join("vendor"), "vendor", &|_| true, &mut crates)?;
    Ok(crates)
}
