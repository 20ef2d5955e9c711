//! What the compiler read, by its own account: the files `*.d` that it writes beside what it makes.
//!
//! ```text
//!   target/debug/deps/lab-1f2e.d: src/main.rs src/lab.rs /opt/other/lab.rs      files, blanks as `\ `
//!   src/main.rs:                                                                 the same once more
//!   # env-dep:HOME=/root                                                         variables
//! ```
//!
//! The compiler writes it as soon as all macros are expanded, so a build that fails later has one as well: whatever a
//! file does to read another one, by a module, a macro, or a macro that makes these, is told here. It cannot be
//! forged: nothing that is compiled is run while compiling (no build script, no procedural macro), names are written
//! with blanks and line ends escaped, and until now no program of the student has run that could change it.
//!
//! There is none if the compiler stopped while it was expanding macros. Then nothing it says can be passed on, since
//! some of it may have been read elsewhere.

use std::fs;
use std::path::{Component, Path, PathBuf};

/// More is no account of a lab's files.
const LARGEST: u64 = 1 << 20;
/// Variables that cargo sets from the manifest, which is the lab's.
const OF_THE_MANIFEST: &str = "CARGO_PKG_";

/// What was read.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Reads {
    files: Vec<String>,
    variables: Vec<String>,
}

impl Reads {
    /// What a build in this target directory read; nothing if the compiler did not come to say it.
    pub(super) fn of_build(target: &Path) -> Option<Self> {
        let mut all: Option<Self> = None;
        for path in accounts(target) {
            // What cannot be read as it should be is as good as not there.
            let fits = fs::symlink_metadata(&path).is_ok_and(|data| data.is_file() && data.len() <= LARGEST);
            let text = fs::read_to_string(&path).ok().filter(|_| fits)?;
            let one = Self::parse(&text);
            let all = all.get_or_insert_with(Self::default);
            all.files.extend(one.files);
            all.variables.extend(one.variables);
        }
        all.filter(|all| !all.files.is_empty())
    }

    /// Takes away what earlier builds in this target directory said.
    pub(super) fn forget(target: &Path) {
        for path in accounts(target) {
            let _ = fs::remove_file(path);
        }
    }

    fn parse(text: &str) -> Self {
        let mut reads = Self::default();
        for line in text.lines() {
            if let Some(variable) = line.strip_prefix("# env-dep:") {
                reads.variables.push(variable.split('=').next().unwrap_or_default().to_owned());
            } else if let Some((_, files)) = line.split_once(": ") {
                reads.files.extend(split(files));
            }
        }
        reads
    }

    /// The first thing that is neither the tree's nor the standard library's, as a student reads it.
    pub(super) fn outside(&self, tree: &Path, library: &Path) -> Option<String> {
        if let Some(file) = self.files.iter().find(|file| !is_own(file, tree, library)) {
            return Some(format!("the file `{file}`"));
        }
        let variable = self.variables.iter().find(|name| !name.starts_with(OF_THE_MANIFEST))?;
        Some(format!("the environment variable `{variable}`"))
    }
}

/// The files of a target directory in which the compiler says what it read.
fn accounts(target: &Path) -> Vec<PathBuf> {
    let entries = |folder: &Path| {
        let entries: Vec<_> = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).collect();
        entries.into_iter().map(|entry| entry.path())
    };
    // One folder deeper where settings name the system that is built for.
    let profiles: Vec<_> = entries(target).collect();
    let deeper: Vec<_> = profiles.iter().flat_map(|folder| entries(folder)).collect();
    let parts = profiles.iter().chain(&deeper).flat_map(|profile| entries(&profile.join("deps")));
    parts.filter(|path| path.extension().is_some_and(|ending| ending == "d")).collect()
}

/// Splits at blanks that have no backslash before them.
fn split(files: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut name = String::new();
    let mut chars = files.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '\\' if chars.peek() == Some(&' ') => name.extend(chars.next()),
            ' ' => names.push(std::mem::take(&mut name)),
            c => name.push(c),
        }
    }
    names.push(name);
    names.retain(|name| !name.is_empty());
    names
}

/// Whether a file that the compiler names is one of the tree, or a part of the standard library.
pub(super) fn is_own(file: &str, tree: &Path, library: &Path) -> bool {
    let mut real = PathBuf::new();
    for part in tree.join(file).components() {
        match part {
            Component::ParentDir => drop(real.pop()),
            Component::CurDir => {}
            part => real.push(part),
        }
    }
    // The standard library's own sources are called so where they are not installed.
    real.starts_with("/rustc") || real.starts_with(library) || (real.starts_with(tree) && real.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_account_is_read() {
        let text = "/t/lab-1.d: src/main.rs src/a\\ b.rs /etc/passwd\n\n/t/lab-1: src/main.rs\n\nsrc/main.rs:\n/etc/passwd:\n\n\
                    # env-dep:CARGO_PKG_NAME=lab\n# env-dep:HOME=/a\\nb\n# env-dep:NONE\n";
        let reads = Reads::parse(text);
        assert_eq!(reads.files, ["src/main.rs", "src/a b.rs", "/etc/passwd", "src/main.rs"]);
        assert_eq!(reads.variables, ["CARGO_PKG_NAME", "HOME", "NONE"]);
    }

    #[test]
    fn what_lies_outside_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let tree = dir.path().join("tree");
        fs::create_dir_all(tree.join("src")).unwrap();
        fs::write(tree.join("src/lab.rs"), "").unwrap();
        fs::write(dir.path().join("secret"), "").unwrap();
        let toolchain = Path::new("/opt/rust");
        let outside = |files: &[&str], variables: &[&str]| {
            let own = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
            Reads { files: own(files), variables: own(variables) }.outside(&tree, toolchain)
        };
        assert_eq!(
            outside(&["src/lab.rs", "src/../src/./lab.rs", "/opt/rust/lib/x.rs", "/rustc/1/core/x.rs"], &[]),
            None
        );
        assert_eq!(outside(&[], &["CARGO_PKG_NAME"]), None);
        for file in ["../secret", "src/../../secret", "/etc/passwd", "/opt/rust/../secret", "/opt/rusty", "src/none.rs"]
        {
            assert_eq!(outside(&["src/lab.rs", file], &[]), Some(format!("the file `{file}`")));
        }
        assert_eq!(outside(&[], &["HOME"]), Some("the environment variable `HOME`".to_owned()));
    }

    #[test]
    fn an_account_that_is_not_there_or_a_link_is_none() {
        let dir = tempfile::tempdir().unwrap();
        assert_eq!(Reads::of_build(dir.path()), None);
        let deps = dir.path().join("debug/deps");
        fs::create_dir_all(&deps).unwrap();
        assert_eq!(Reads::of_build(dir.path()), None);
        fs::write(deps.join("lab-1.d"), "x: src/lab.rs\n").unwrap();
        fs::write(deps.join("lab-1.o"), "x: /etc/passwd\n").unwrap();
        assert_eq!(Reads::of_build(dir.path()).unwrap().files, ["src/lab.rs"]);
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("lab-1.d", deps.join("lab-2.d")).unwrap();
            assert_eq!(Reads::of_build(dir.path()), None);
        }
    }
}
