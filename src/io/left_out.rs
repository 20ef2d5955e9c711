//! What a map says of its polygons and a structure does not keep.

use super::words::{counted, note};

/// What was read over, counted. The structure is none the worse for it, but a file that is written from it lacks it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LeftOut {
    /// Features with an id that is not their name.
    pub ids: usize,
    /// Features with properties beside their name.
    pub properties: usize,
    /// Geometries of several polygons, each of which became a face.
    pub groups: usize,
}

impl LeftOut {
    /// What a file lacks that is written from the structure, one sentence for each kind. That polygons belonged together is
    /// told if its format `has_groups`.
    #[must_use]
    pub fn notes(&self, has_groups: bool) -> Vec<String> {
        let mut notes = Vec::new();
        note(&mut notes, self.ids, "id of a feature is lost", "ids of features are lost", ": names are kept");
        if self.properties > 0 {
            let features = counted(self.properties, "feature", "features");
            notes.push(format!("properties of {features} are lost: only names are kept"));
        }
        if has_groups {
            let (one, many) = ("multipolygon was taken apart", "multipolygons were taken apart");
            note(&mut notes, self.groups, one, many, ": each of its polygons is a feature by itself");
        }
        notes
    }
}
