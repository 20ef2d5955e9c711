//! Names too many: texts that are read as the name of something and do not stand there, or stand twice.
//!
//! ```text
//!   <g id="a-f1" ...><text>f1</text><text>f2</text></g>      f2 is drawn at f1, too
//!   <text>h0</text>                                          and h0 is drawn at h0 already
//! ```
//!
//! A text is a name if it is one as a whole: a caption that names a vertex is none. What stands in a table, a legend, a
//! note, or clear of the structure names nothing, and a copy of a name at its own place is a part of it: a halo.

use super::beside::Extent;
use super::drawing::Drawing;
use super::eye::Eye;
use super::legible::is_copy;
use super::standing::{Around, HEIGHTS};
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};

/// What is too much about a name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Surplus {
    /// It is drawn where it belongs, too.
    Twice,
    /// It stands in the group of something else.
    Other,
    /// It stands somewhere else than what it names.
    Loose,
}

impl Surplus {
    pub(super) const ALL: [Self; 3] = [Self::Twice, Self::Other, Self::Loose];

    /// What is said of one name, and of several.
    pub(super) fn words(self) -> [&'static str; 2] {
        match self {
            Self::Twice => ["name is drawn twice", "names are drawn twice"],
            Self::Other => ["name is drawn at something else, too", "names are drawn at something else, too"],
            Self::Loose => {
                ["name stands where nothing of that name is drawn", "names stand where nothing of those names is drawn"]
            }
        }
    }
}

/// The names too many in a drawing. `right` are the letters of the names that stand where they belong. O(n log n).
pub(super) fn surplus(
    drawing: &Drawing,
    around: &Around<'_>,
    eye: &mut Eye<'_>,
    right: &BTreeMap<String, u32>,
) -> BTreeSet<(Surplus, String)> {
    let mut out = BTreeSet::new();
    let extent = Extent::around(drawing.points().collect::<Vec<Point>>());
    let coats = &drawing.painting.coats;
    for name in drawing.names.iter().filter(|name| !name.noted && !name.coats.is_empty()) {
        let (element, coat) = (name.element.as_str(), name.coats.start);
        let named = around.named(&name.text);
        let letters = &coats[coat as usize];
        let rights: Vec<u32> = named.iter().filter_map(|other| right.get(other.as_str()).copied()).collect();
        let is_own = named.iter().any(|other| other == element);
        let is_part = |&&other: &&u32| other == coat || is_copy([letters, &coats[other as usize]]);
        if named.is_empty() || rights.iter().find(is_part).is_some() {
            continue;
        }
        let what = if element.is_empty() {
            let is_at = |other: &String| !right.contains_key(other.as_str()) && around.is_at_place(other, coat);
            if !extent.holds(letters.middle(), -HEIGHTS * letters.thickness()) || named.iter().any(is_at) {
                continue;
            }
            if rights.is_empty() { Surplus::Loose } else { Surplus::Twice }
        } else if is_own {
            Surplus::Twice
        } else {
            Surplus::Other
        };
        // Where the only name is a wrong one, that is told already.
        let is_told = !element.is_empty() && !right.contains_key(element);
        if !is_told && name.coats.clone().all(|coat| eye.is_read(coat)) {
            let text = if what == Surplus::Other { format!("{} at {element}", name.text) } else { name.text.clone() };
            out.insert((what, text));
        }
    }
    out
}
