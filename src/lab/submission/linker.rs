//! The linker that the compiler calls: where it is, and where its parts are.
//!
//! ```text
//!   PATH ──▶ cc ──-print-search-dirs──▶ its own programs and libraries, wherever they are installed
//! ```

use std::path::{Path, PathBuf};
use std::process::Command;

/// A C compiler, as which the linker is called.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Linker {
    /// The folder in which it is found by its name.
    pub(super) folder: PathBuf,
    /// What it needs to see: itself, and the folders it looks into.
    pub(super) parts: Vec<PathBuf>,
}

impl Linker {
    /// The first `cc` on the path, as the compiler finds it.
    pub(super) fn find() -> Result<Self, String> {
        let path = std::env::var_os("PATH").unwrap_or_default();
        let mut folders = std::env::split_paths(&path).filter(|folder| folder.is_absolute());
        let folder = folders.find(|folder| folder.join("cc").is_file());
        let folder = folder.ok_or("there is no `cc` on the path: install a C compiler, which links programs")?;
        let program = folder.join("cc");
        // Nothing of the environment, which could add folders.
        let asked = Command::new(&program).arg("-print-search-dirs").env_clear().env("PATH", &path).output();
        let said = asked.map_err(|error| format!("{}: {error}", program.display()))?;
        let mut parts = search_folders(&String::from_utf8_lossy(&said.stdout));
        parts.extend(program.canonicalize());
        parts.push(program);
        parts.sort();
        parts.dedup();
        Ok(Self { folder, parts })
    }
}

/// The folders of lines such as `libraries: =/usr/lib/gcc/…:/lib/`. Those that are not there are left out, and those
/// that are too near the root to hold nothing else.
fn search_folders(said: &str) -> Vec<PathBuf> {
    let lists = said.lines().filter_map(|line| line.split_once(": ").map(|(_, list)| list.trim_start_matches('=')));
    let real = |folder: &str| Path::new(folder).canonicalize().ok();
    let folders = lists.flat_map(|list| list.split(':')).filter(|folder| folder.starts_with('/')).filter_map(real);
    folders.filter(|folder| folder.is_dir() && folder.components().count() > 2).collect()
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_real_and_not_too_wide() {
        let dir = tempfile::tempdir().unwrap();
        let inner = dir.path().canonicalize().unwrap().join("lib/gcc");
        std::fs::create_dir_all(&inner).unwrap();
        let said = format!(
            "install: {0}/\nprograms: ={0}/../gcc/:/:/home:relative\nlibraries: ={0}/none:{0}/..\n",
            inner.display()
        );
        let mut found = search_folders(&said);
        found.dedup();
        assert_eq!(found, [inner.clone(), inner.parent().unwrap().to_path_buf()]);
    }
}
