//! A lab with everything that grading needs of it.

use super::bug::Bug;
use super::courses;
use super::files::{LabFiles, LabFilesError};
use super::judge::Judge;
use super::manifest::Manifest;
use super::signatures::Signatures;
use super::toml_file::ManifestError;
use std::fmt;
use std::path::Path;

/// A lab: its manifest and its known mistakes.
#[derive(Clone, PartialEq, Debug)]
pub struct Lab {
    /// As its folder is called.
    pub name: String,
    /// What there is to do and what it is worth.
    pub manifest: Manifest,
    /// The wrong solutions that have names, by their numbers.
    pub bugs: Vec<Bug>,
    /// How they fail.
    pub signatures: Signatures,
    /// All of its files.
    pub files: LabFiles,
    judge: Bound,
}

/// Who judges a lab. Labs are compared by their files.
#[derive(Clone, Copy)]
struct Bound(Option<&'static dyn Judge>);

impl fmt::Debug for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "a judge" } else { "no judge" })
    }
}

impl PartialEq for Bound {
    fn eq(&self, other: &Self) -> bool {
        self.0.is_some() == other.0.is_some()
    }
}

/// Why a lab cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LabError {
    /// Its files cannot be had.
    #[error(transparent)]
    Files(#[from] LabFilesError),
    /// A file of it is wrong.
    #[error(transparent)]
    Manifest(#[from] ManifestError),
    /// A file that it needs is not there.
    #[error("{lab} has no {path}")]
    Missing {
        /// The lab.
        lab: String,
        /// The file.
        path: String,
    },
}

impl Lab {
    /// The lab in these files, with the judge of the kit's lab of that name, if there is one.
    ///
    /// # Errors
    /// [`LabError`] if the manifest or a bug cannot be read. Known mistakes without signatures names nothing, and is no error.
    pub fn new(files: LabFiles) -> Result<Self, LabError> {
        let lab = Self::judged_by(files, None)?;
        // The folder of an own lab may be called anything.
        let judge = courses::judge_of(&lab.manifest.name).or_else(|| courses::judge_of(&lab.name));
        Ok(Self { judge: Bound(judge), ..lab })
    }

    /// The lab in these files, with a judge of its own.
    ///
    /// # Errors
    /// As for [`Lab::new`].
    pub fn with_judge(files: LabFiles, judge: &'static dyn Judge) -> Result<Self, LabError> {
        Self::judged_by(files, Some(judge))
    }

    /// What knows the cases of this lab and judges the answers; `None` if this version of the kit has no such lab.
    #[must_use]
    pub fn judge(&self) -> Option<&'static dyn Judge> {
        self.judge.0
    }

    fn judged_by(files: LabFiles, judge: Option<&'static dyn Judge>) -> Result<Self, LabError> {
        let name = files.name().to_owned();
        let missing = |path: &str| LabError::Missing { lab: name.clone(), path: path.to_owned() };
        let manifest = files.get("lab.toml").ok_or_else(|| missing("lab.toml"))?;
        let manifest = Manifest::parse(manifest, "lab.toml")?;
        let signatures = match files.get(SIGNATURES) {
            Some(text) => Signatures::parse(text, SIGNATURES)?,
            None => Signatures::default(),
        };
        let is_bug = |path: &str| path.starts_with("bugs/") && path.ends_with(".toml") && path != SIGNATURES;
        let mut bugs = files
            .iter()
            .filter(|(path, _)| is_bug(path))
            .map(|(path, text)| Bug::parse(text, path))
            .collect::<Result<Vec<_>, _>>()?;
        bugs.sort_by_key(|bug| bug.number);
        Ok(Self { name, manifest, bugs, signatures, files, judge: Bound(judge) })
    }

    /// A lab that is compiled into the kit, see [`LabFiles::bundled`].
    ///
    /// # Errors
    /// [`LabError`].
    pub fn bundled(name: &str) -> Result<Self, LabError> {
        Self::new(LabFiles::bundled(name)?)
    }

    /// The lab in a folder of the repository.
    ///
    /// # Errors
    /// [`LabError`].
    pub fn read(folder: &Path) -> Result<Self, LabError> {
        Self::new(LabFiles::read(folder)?)
    }
}

/// Where the signatures of the known mistakes are.
const SIGNATURES: &str = "bugs/signatures.toml";
