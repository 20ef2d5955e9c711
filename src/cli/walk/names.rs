//! Ids, names and positions as answers have them: each may be missing in a broken table.

use super::Subject;
use crate::output::point;
use dcel_kit::FaceId;
use serde::Serialize;
use std::fmt;

/// An id or nothing.
pub(super) fn name<T: ToString>(id: Option<T>) -> Option<String> {
    id.map(|id| id.to_string())
}

pub(super) fn or_none(name: &Option<String>) -> &str {
    name.as_deref().unwrap_or("none")
}

pub(super) fn at(position: &Option<Vec<f64>>) -> String {
    position.as_deref().map_or_else(String::new, point)
}

/// A face as seen from somewhere else.
#[derive(Serialize)]
pub(super) struct FaceName {
    pub(super) face: String,
    pub(super) name: Option<String>,
}

impl FaceName {
    pub(super) fn of(subject: &Subject, f: FaceId) -> Self {
        Self { face: f.to_string(), name: subject.name(f).map(str::to_owned) }
    }

    /// `f3 "Ohio"`.
    pub(super) fn called(face: &str, name: &Option<String>) -> String {
        match name {
            Some(name) => format!("{face} {name:?}"),
            None => face.to_owned(),
        }
    }

    /// The same of a face that may be missing.
    pub(super) fn or_none(face: &Option<String>, name: &Option<String>) -> String {
        face.as_ref().map_or_else(|| "none".to_owned(), |face| Self::called(face, name))
    }
}

impl fmt::Display for FaceName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Self::called(&self.face, &self.name))
    }
}
