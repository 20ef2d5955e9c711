//! A lab with everything that grading needs of it.

use super::bug::Bug;
use super::files::{LabFiles, LabFilesError};
use super::manifest::Manifest;
use super::signatures::Signatures;
use super::toml_file::ManifestError;
use std::path::Path;

/// A lab: its manifest and its zoo.
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
    /// The lab in these files.
    ///
    /// # Errors
    /// [`LabError`] if the manifest or a bug cannot be read. A zoo without signatures names nothing, and is no error.
    pub fn new(files: LabFiles) -> Result<Self, LabError> {
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
        Ok(Self { name, manifest, bugs, signatures, files })
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

/// Where the signatures of the zoo are.
const SIGNATURES: &str = "bugs/signatures.toml";
