//! Names that faces of a file have in common: groups, objects and materials.
//!
//! ```text
//!   g floor          faces 0 and 1: floor, stone          a name holds until the next one of its kind, so a run of
//!   usemtl stone     face 2: floor, mud                   faces is stored by its first face
//!   f 1 2 3
//!   f 1 3 4
//!   usemtl mud
//!   f 4 5 6
//! ```

use super::problem::ReadError;
use super::room::too_little;
use std::collections::BTreeSet;

/// Which names each face has, besides a name of its own.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Labels {
    /// From this face on, these names; in the order of the faces.
    runs: Vec<(u32, Vec<String>)>,
}

impl Labels {
    /// Makes room for so many runs more.
    ///
    /// # Errors
    /// If there is not so much memory.
    pub(super) fn make_room(&mut self, runs: usize, source: &str) -> Result<(), ReadError> {
        let bytes = (self.runs.len() + runs).saturating_mul(size_of::<(u32, Vec<String>)>());
        self.runs.try_reserve(runs).map_err(|_| too_little(bytes, source))
    }

    /// From face `first` on the names are these. Faces must come in order.
    pub(super) fn begin(&mut self, first: u32, names: Vec<String>) {
        while self.runs.last().is_some_and(|&(start, _)| start >= first) {
            self.runs.pop();
        }
        if self.runs.last().map_or(&[][..], |(_, last)| last) != names {
            self.runs.push((first, names));
        }
    }

    /// The names of a face. O(log n).
    #[must_use]
    pub fn of(&self, face: usize) -> &[String] {
        let after = self.runs.partition_point(|&(first, _)| first as usize <= face);
        after.checked_sub(1).map_or(&[], |run| &self.runs[run].1)
    }

    /// All names, each once, in the order of the alphabet.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        let all: BTreeSet<&str> = self.runs.iter().flat_map(|(_, names)| names).map(String::as_str).collect();
        all.into_iter().collect()
    }

    /// The labels of other faces, each of which was one of these before.
    pub(super) fn with_origins(&self, origins: &[u32]) -> Self {
        let mut labels = Self::default();
        if !self.runs.is_empty() {
            for (face, &origin) in (0..).zip(origins) {
                labels.begin(face, self.of(origin as usize).to_vec());
            }
        }
        labels
    }
}
