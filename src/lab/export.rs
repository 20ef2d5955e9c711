//! Archives to hand out: a student's folder, and autograders for Gradescope and Classroom 50.
//!
//! ```text
//!   gradescope.zip
//!     setup.sh         once, with the network: a Rust toolchain, then the kit
//!     run_autograder   for each submission: dcel grade … --report gradescope=…
//!     kit/             the sources of the kit, if it comes from a checkout
//!     course.toml secret.toml labs/    of a course: its terms, the hidden cases, the known mistakes for own tests
//!
//!   classroom50.zip    for CLASSROOM/autograders/ASSIGNMENT/ in the course's own repository
//!     autograder.py    for each submission: builds the kit, dcel grade … --report classroom50=…
//!     kit/             as above
//!     course.toml      of a course: what everybody may know of it
//! ```
//!
//! The bytes of an archive depend on its files alone: entries by name, all with one fixed date.

use super::course::SECRET_BESIDE;
use super::kit::Sources;
use super::student::Kit;
use super::typed;
use std::collections::BTreeMap;
use std::io::{self, Cursor, Write};
use std::path::Path;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Folders and files of a checkout that its programs are not made from.
const LEFT_OUT: [&str; 4] = ["target", "benches", "solution", "bugs"];

/// What the autograder runs first, with the network.
const SETUP: &str = "\
#!/usr/bin/env bash
# Runs once, when the autograder is built: a Rust toolchain, then the kit.
set -euo pipefail
apt-get update
apt-get install -y --no-install-recommends build-essential ca-certificates curl git util-linux
export RUSTUP_HOME=/opt/rustup CARGO_HOME=/opt/cargo
curl --proto '=https' --tlsv1.2 -sSf https://sh.rustup.rs | sh -s -- -y --profile minimal --no-modify-path
export PATH=/opt/cargo/bin:$PATH
cargo install --locked --root /opt/dcel INSTALL
chmod -R a+rX /opt/rustup /opt/cargo /opt/dcel
# A submission is built without the network: see now that this works.
dcel() { /opt/dcel/bin/dcel \"$@\"; }
dcel lab list LAB
";

/// What it runs for each submission.
const RUN: &str = "\
#!/usr/bin/env bash
# Grades /autograder/submission. Whatever happens, there is a results.json afterwards.
export RUSTUP_HOME=/opt/rustup CARGO_HOME=/opt/cargo PATH=/opt/dcel/bin:/opt/cargo/bin:$PATH
results=/autograder/results/results.json
mkdir -p /autograder/results
rm -f \"$results\"
dcel grade LAB /autograder/submission FLAGS--report gradescope=\"$results\" || true
if [ ! -s \"$results\" ]; then
    printf '{\"score\": 0, \"output\": \"The grader failed; this is not your fault. Tell your instructor.\"}\\n' > \"$results\"
fi
";

/// What Classroom 50 runs for each submission, in the student's repository.
const AUTOGRADER: &str = "\
\"\"\"Grades the repository it is started in: the autograder of LAB for Classroom 50.

Put this folder into CLASSROOM/autograders/ASSIGNMENT/. Machines that run it need Rust, as ubuntu-latest has it; the
kit is built first, which takes one or two minutes. Set DCEL to an installed `dcel` to use that one. What lies beside
this file can be read by everybody: it holds no solution, and a file with hidden cases does not belong here.
\"\"\"

import datetime
import json
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILT = HERE / \"built\"
RESULT = Path(\"result.json\")


def program():
    \"\"\"The grader: an installed one, or the kit.\"\"\"
    if os.environ.get(\"DCEL\"):
        return os.environ[\"DCEL\"]
    subprocess.run([\"cargo\", \"install\", \"--locked\", \"--debug\", \"--root\", BUILT, INSTALL], cwd=HERE, check=True)
    return BUILT / \"bin\" / \"dcel\"


def main():
    for old in (RESULT, Path(\"release-body.md\")):
        old.unlink(missing_ok=True)
    graded = HERE / \"graded.json\"
    graded.unlink(missing_ok=True)
    reports = [f\"classroom50={graded}\", \"markdown=release-body.md\"]
    flags = [word for report in reports for word in (\"--report\", report)]
    if (HERE / \"course.toml\").is_file():
        flags += [\"--course\", HERE / \"course.toml\"]
    done = subprocess.run([program(), \"grade\", \"LAB\", \".\", *flags], check=False)
    if done.returncode > 1 or not graded.is_file():
        sys.exit(\"::error::The grader failed; this is not the student's fault.\")
    result = json.loads(graded.read_text(encoding=\"utf-8\"))
    result.update({
        \"classroom\": os.environ[\"CLASSROOM\"],
        \"assignment\": os.environ[\"ASSIGNMENT\"],
        \"usernames\": [os.environ[\"USERNAME\"]],
        \"submission\": os.environ[\"SUBMISSION_TAG\"],
        \"commit\": os.environ[\"COMMIT_URL\"],
        \"release\": os.environ[\"RELEASE_URL\"],
        \"review\": os.environ.get(\"REVIEW_URL\") or os.environ[\"COMMIT_URL\"],
        \"datetime\": datetime.datetime.now(datetime.timezone.utc).strftime(\"%Y-%m-%dT%H:%M:%SZ\"),
    })
    RESULT.write_text(json.dumps(result, indent=2), encoding=\"utf-8\")


main()
";

/// A file of an archive.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Packed {
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Whether it is a program.
    pub executable: bool,
}

impl From<String> for Packed {
    fn from(text: String) -> Self {
        Self { bytes: text.into_bytes(), executable: false }
    }
}

/// What a course adds to an autograder.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct CourseFiles {
    /// The course with this lab alone: `course.toml`.
    pub course: String,
    /// The hidden cases: `secret.toml`.
    pub secret: Option<String>,
    /// The lab's folder with its known mistakes, by path from `labs/` on, if own tests give points.
    pub lab: BTreeMap<String, String>,
    /// Whether the time of submission matters.
    pub is_due: bool,
}

impl CourseFiles {
    /// The files beside the programs.
    fn files(&self) -> BTreeMap<String, Packed> {
        let mut files: BTreeMap<_, _> = [("course.toml".to_owned(), Packed::from(self.course.clone()))].into();
        files.extend(self.secret.clone().map(|secret| (SECRET_BESIDE.to_owned(), secret.into())));
        files.extend(self.lab.iter().map(|(path, text)| (format!("labs/{path}"), Packed::from(text.clone()))));
        files
    }

    /// What the grader is called with, each word followed by a space.
    fn flags(&self) -> String {
        let metadata = if self.is_due { "--metadata /autograder/submission_metadata.json " } else { "" };
        let own = if self.lab.is_empty() { "" } else { "--own /autograder/source/labs " };
        format!("--course /autograder/source/course.toml {metadata}{own}")
    }
}

/// The files of an autograder for Gradescope.
///
/// `sources` are the files of the program, for a kit that is inside; `course` is what a course adds.
///
/// # Errors
/// A checkout of the kit that cannot be read.
pub fn gradescope_files(
    lab: &str,
    kit: &Kit,
    sources: Sources,
    course: Option<&CourseFiles>,
) -> io::Result<BTreeMap<String, Packed>> {
    let mut files = kit_files(kit, sources)?;
    files.extend(course.map(CourseFiles::files).unwrap_or_default());
    let flags = course.map(CourseFiles::flags).unwrap_or_default();
    let source = match kit {
        Kit::Inside | Kit::Path(_) => "--path /autograder/source/kit/src/cli".to_owned(),
        Kit::Git(url) => format!("--git {} dcel", typed::word(url)),
        Kit::Version(version) => format!("--version {} dcel", typed::word(version)),
    };
    let program = |text: &str| Packed {
        bytes: text.replace("INSTALL", &source).replace("FLAGS", &flags).replace("LAB", lab).into_bytes(),
        executable: true,
    };
    files.insert("setup.sh".to_owned(), program(SETUP));
    files.insert("run_autograder".to_owned(), program(RUN));
    Ok(files)
}

/// The files of an autograder for Classroom 50.
///
/// `sources` are the files of the program, for a kit that is inside; `course` is the file of the course as
/// everybody may read it.
///
/// # Errors
/// A checkout of the kit that cannot be read.
pub fn classroom50_files(
    lab: &str,
    kit: &Kit,
    sources: Sources,
    course: Option<String>,
) -> io::Result<BTreeMap<String, Packed>> {
    let mut files = kit_files(kit, sources)?;
    files.extend(course.map(|course| ("course.toml".to_owned(), Packed::from(course))));
    // A string of JSON is one of Python, too.
    let quoted = |text: &str| serde_json::Value::from(text).to_string();
    let source = match kit {
        Kit::Inside | Kit::Path(_) => "\"--path\", \"kit/src/cli\"".to_owned(),
        Kit::Git(url) => format!("\"--git\", {}, \"dcel\"", quoted(url)),
        Kit::Version(version) => format!("\"--version\", {}, \"dcel\"", quoted(version)),
    };
    let text = AUTOGRADER.replace("INSTALL", &source).replace("LAB", lab);
    files.insert("autograder.py".to_owned(), text.into());
    Ok(files)
}

/// The sources of the kit, in a folder `kit`; none if it comes from elsewhere.
fn kit_files(kit: &Kit, sources: Sources) -> io::Result<BTreeMap<String, Packed>> {
    let mut files = BTreeMap::new();
    match kit {
        Kit::Inside => {
            let packed = |(path, text): (String, &str)| (format!("kit/{path}"), Packed::from(text.to_owned()));
            files.extend(sources.into_iter().map(packed));
        }
        Kit::Path(checkout) => packed_tree(checkout, "kit", &is_source, &mut files)?,
        Kit::Git(_) | Kit::Version(_) => {}
    }
    Ok(files)
}

/// One zip archive of the files.
///
/// # Errors
/// More than a zip archive can hold.
pub fn zipped(files: &BTreeMap<String, Packed>) -> io::Result<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, file) in files {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(zip::DateTime::default())
            .unix_permissions(if file.executable { 0o755 } else { 0o644 });
        archive.start_file(path, options)?;
        archive.write_all(&file.bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

/// Whether something of this name in a checkout may be what its programs are built from.
fn is_source(name: &str) -> bool {
    !name.starts_with('.') && !LEFT_OUT.contains(&name)
}

/// The files of a folder and of those in it, as far as they are taken.
pub(super) fn packed_tree(
    dir: &Path,
    prefix: &str,
    takes: &dyn Fn(&str) -> bool,
    files: &mut BTreeMap<String, Packed>,
) -> io::Result<()> {
    for entry in std::fs::read_dir(dir)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if !takes(&name) {
            continue;
        }
        let path = format!("{prefix}/{name}");
        if entry.file_type()?.is_dir() {
            packed_tree(&entry.path(), &path, takes, files)?;
        } else {
            files.insert(path, Packed { bytes: std::fs::read(entry.path())?, executable: false });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    #[test]
    fn an_archive_holds_its_files_and_always_has_the_same_bytes() {
        let files = gradescope_files("04-half-edge", &Kit::Version("0'1".to_owned()), BTreeMap::new(), None).unwrap();
        let bytes = zipped(&files).unwrap();
        assert_eq!(bytes, zipped(&files).unwrap());
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        let names: Vec<_> = archive.file_names().map(|name| name.unwrap().into_owned()).collect();
        assert_eq!(names, ["run_autograder", "setup.sh"]);
        let mut setup = archive.by_name("setup.sh").unwrap();
        assert_eq!(setup.unix_mode().map(|mode| mode & 0o777), Some(0o755));
        let mut text = String::new();
        setup.read_to_string(&mut text).unwrap();
        assert!(text.contains("--root /opt/dcel --version '0'\\''1' dcel\n"), "{text}");
    }

    #[test]
    fn an_autograder_in_python_quotes_where_the_kit_comes_from() {
        let of = |kit: &Kit| {
            let files =
                classroom50_files("04-half-edge", kit, [("Cargo.toml".to_owned(), "[package]")].into(), None).unwrap();
            (
                files.keys().cloned().collect::<Vec<_>>(),
                String::from_utf8(files["autograder.py"].bytes.clone()).unwrap(),
            )
        };
        let (names, text) = of(&Kit::Git("a \"b\"\\".to_owned()));
        assert_eq!(names, ["autograder.py"]);
        assert!(text.contains(r#""--git", "a \"b\"\\", "dcel"], cwd=HERE"#), "{text}");
        assert!(text.contains("\"grade\", \"04-half-edge\"") && !text.contains("LAB") && !text.contains("INSTALL"));
        let (names, text) = of(&Kit::Inside);
        assert_eq!(names, ["autograder.py", "kit/Cargo.toml"]);
        assert!(text.contains("\"--path\", \"kit/src/cli\"], cwd=HERE"));
    }

    #[test]
    fn the_sources_of_the_kit_are_those_it_is_built_from() {
        let checkout = env!("CARGO_MANIFEST_DIR").strip_suffix("src/lab").unwrap();
        let files = gradescope_files("04-half-edge", &Kit::Path(checkout.into()), BTreeMap::new(), None).unwrap();
        for needed in ["Cargo.toml", "Cargo.lock", "src/lib.rs", "src/cli/Cargo.toml", "figures/data/rooms.map"] {
            assert!(files.contains_key(&format!("kit/{needed}")), "{needed}");
        }
        assert!(files.keys().all(|path| !path.contains("/target/") && !path.contains("/.git")));
    }
}
