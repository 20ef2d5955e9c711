//! Why a file is no structure, and where in the file the elements stand that do not fit.

use super::misfit::Told;
use super::problem::ReadError;
use super::soup::Places;
use crate::plane::{ConvertError, MarkHolesError, SegmentsError, TableError};
use crate::solid::SolidError;
use std::fmt;

/// Why a file is no structure.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// It cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// Its polygons are no subdivision of the plane.
    #[error("{at}: {what}{at:#}")]
    Plane {
        /// Where.
        at: Box<Whereabouts>,
        /// Why not.
        error: ConvertError,
        /// The same in the words and coordinates of the file.
        what: String,
    },
    /// Its polygons are no surface.
    #[error("{at}: {error}{at:#}")]
    Surface {
        /// Where.
        at: Box<Whereabouts>,
        /// Why not.
        error: SolidError,
    },
    /// Its segments meet elsewhere than at common ends.
    #[error("{at}: {error}{at:#}")]
    Segments {
        /// Where the first of them are.
        at: Box<Whereabouts>,
        /// Which ones, and how.
        error: SegmentsError,
    },
    /// Its hole points do not lie in bounded faces.
    #[error("{place}: {error}")]
    Holes {
        /// Where the point stands.
        place: String,
        /// Which one, and why not.
        error: MarkHolesError,
    },
    /// Its table is no subdivision of the plane.
    #[error("{source_name}: {error}")]
    Table {
        /// The file.
        source_name: String,
        /// Why not.
        error: TableError,
    },
}

/// Where the elements of an error stand in a file. Prints as the place of the first one, and with `{:#}` as the
/// places of the others in brackets.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Whereabouts {
    /// The place of the first face the error speaks of, or of its first vertex, or the file.
    pub first: String,
    /// The other elements, `face 5` or `vertex 7`, with their places: `line 19`, `states[3] "Ohio" polygon 0`,
    /// or the whole if that is in another file.
    pub others: Vec<(String, String)>,
}

impl Whereabouts {
    pub(super) fn new(places: &Places, faces: &[u32], vertices: &[u32]) -> Self {
        let faces = faces.iter().map(|&f| (format!("face {f}"), places.face(f as usize)));
        let known = if places.vertex_lines.is_empty() { &[] } else { vertices };
        let vertices = known.iter().map(|&v| (format!("vertex {v}"), places.vertex(v as usize)));
        Self::of(&places.source, faces.chain(vertices))
    }

    /// The places of the rings a misfit speaks of, and of the faces and vertices if it speaks of them by number.
    pub(super) fn of_misfit(told: &Told<'_>, error: &ConvertError, rings: &[[u32; 2]]) -> Self {
        if rings.is_empty() || told.places.face_path(0).is_none() {
            if let ConvertError::InsideFace { .. } = error {
                // The corner is told by its place.
                let faces: Vec<u32> = rings.iter().map(|ring| ring[0]).collect();
                return Self::new(told.places, &faces, &[]);
            }
            let mut faces = error.faces();
            faces.extend(rings.iter().map(|ring| ring[0]).filter(|_| error.faces().is_empty()));
            faces.dedup();
            return Self::new(told.places, &faces, &error.vertices());
        }
        let mut rings = rings.to_vec();
        rings.dedup();
        let all = rings.iter().map(|&ring| (told.name(ring), told.places.ring_place(told.number(ring))));
        Self::of(&told.places.source, all)
    }

    /// The places of elements of the file `source`.
    pub(super) fn of(source: &str, mut all: impl Iterator<Item = (String, String)>) -> Self {
        let first = all.next().map_or_else(|| source.to_owned(), |(_, place)| place);
        let others = all.map(|(element, place)| {
            let rest = place.strip_prefix(source).and_then(|rest| rest.strip_prefix(':'));
            let short = rest.map(|rest| rest.strip_prefix(' ').map_or_else(|| format!("line {rest}"), str::to_owned));
            (element, short.unwrap_or(place))
        });
        Self { first, others: others.collect() }
    }
}

impl fmt::Display for Whereabouts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !f.alternate() {
            return f.write_str(&self.first);
        }
        for (i, (element, place)) in self.others.iter().enumerate() {
            write!(f, "{}{element}: {place}", if i == 0 { " (" } else { ", " })?;
        }
        if self.others.is_empty() { Ok(()) } else { f.write_str(")") }
    }
}

impl LoadError {
    /// Where the elements stand that the error speaks of; nothing if the file could not even be read.
    #[must_use]
    pub fn whereabouts(&self) -> Option<&Whereabouts> {
        match self {
            Self::Plane { at, .. } | Self::Surface { at, .. } | Self::Segments { at, .. } => Some(at),
            Self::Read(_) | Self::Table { .. } | Self::Holes { .. } => None,
        }
    }

    /// What is wrong, without the place.
    #[must_use]
    pub fn what(&self) -> String {
        match self {
            Self::Read(error) => error.what.to_string(),
            Self::Plane { what, .. } => what.clone(),
            Self::Surface { error, .. } => error.to_string(),
            Self::Segments { error, .. } => error.to_string(),
            Self::Holes { error, .. } => error.to_string(),
            Self::Table { error, .. } => error.to_string(),
        }
    }
}
