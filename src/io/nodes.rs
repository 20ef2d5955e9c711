//! Objects of the two JSON formats, the place of an element in them, and what can be wrong there.

use super::left_out::LeftOut;
use super::problem::ReadProblem;
use serde::de::{Deserialize, Deserializer, Error as _, IgnoredAny, MapAccess, Visitor};
use serde_json::value::RawValue;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

/// Any object of the two formats with the members the kit uses.
#[derive(serde::Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Node<'a> {
    #[serde(borrow, rename = "type")]
    kind: Option<&'a RawValue>,
    #[serde(borrow)]
    pub(super) features: Option<Vec<Node<'a>>>,
    #[serde(borrow)]
    pub(super) geometry: Option<Box<Node<'a>>>,
    #[serde(borrow)]
    pub(super) geometries: Option<Vec<Node<'a>>>,
    #[serde(borrow)]
    pub(super) objects: Option<BTreeMap<String, Node<'a>>>,
    #[serde(borrow)]
    pub(super) transform: Option<Box<Transform<'a>>>,
    #[serde(borrow)]
    pub(super) coordinates: Option<&'a RawValue>,
    #[serde(borrow)]
    pub(super) arcs: Option<&'a RawValue>,
    #[serde(borrow)]
    properties: Option<Properties<'a>>,
    #[serde(borrow)]
    id: Option<&'a RawValue>,
}

/// The transform of a quantised topology.
#[derive(serde::Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Transform<'a> {
    #[serde(borrow)]
    pub(super) scale: Option<&'a RawValue>,
    #[serde(borrow)]
    pub(super) translate: Option<&'a RawValue>,
}

#[derive(Default)]
struct Properties<'a> {
    name: Option<&'a RawValue>,
    upper_name: Option<&'a RawValue>,
    /// Whether there are others.
    others: bool,
}

#[derive(serde::Deserialize)]
#[serde(field_identifier)]
enum Property {
    #[serde(rename = "name")]
    Name,
    #[serde(rename = "NAME")]
    UpperName,
    #[serde(other)]
    Other,
}

impl<'de: 'a, 'a> Deserialize<'de> for Properties<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Members<'a>(PhantomData<&'a ()>);

        impl<'de: 'a, 'a> Visitor<'de> for Members<'a> {
            type Value = Properties<'a>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<M: MapAccess<'de>>(self, mut members: M) -> Result<Self::Value, M::Error> {
                let mut all = Properties::default();
                while let Some(key) = members.next_key()? {
                    let (name, value) = match key {
                        Property::Name => ("name", &mut all.name),
                        Property::UpperName => ("NAME", &mut all.upper_name),
                        Property::Other => {
                            members.next_value::<IgnoredAny>()?;
                            all.others = true;
                            continue;
                        }
                    };
                    if value.replace(members.next_value()?).is_some() {
                        return Err(M::Error::duplicate_field(name));
                    }
                }
                Ok(all)
            }
        }

        deserializer.deserialize_map(Members(PhantomData))
    }
}

/// A problem with what to try, and where in the file it is.
pub(super) struct Fault {
    pub(super) what: ReadProblem,
    pub(super) help: Cow<'static, str>,
    pub(super) at: Option<usize>,
}

impl Fault {
    /// A problem at a byte of the file.
    pub(super) fn at(at: usize, what: ReadProblem) -> Self {
        Self { at: Some(at), ..Self::from(what) }
    }
}

impl From<ReadProblem> for Fault {
    fn from(what: ReadProblem) -> Self {
        let help = match &what {
            ReadProblem::UnclosedRing { .. } => {
                "repeat the first point of the ring at its end, or close such rings with --mend"
            }
            ReadProblem::DegenerateRing { .. } => {
                "correct the data, or drop such rings with --drop-degenerate-rings or --mend"
            }
            _ => "",
        };
        Self { what, help: help.into(), at: None }
    }
}

/// The problem that an element has the wrong shape.
pub(super) fn shape(place: &str, wanted: impl Into<Cow<'static, str>>) -> ReadProblem {
    ReadProblem::Shape { place: place.to_owned(), wanted: wanted.into() }
}

/// The problem that an element lacks a member.
pub(super) fn lacks(place: &str, member: &str) -> ReadProblem {
    shape(place, format!("an array \"{member}\""))
}

impl<'a> Node<'a> {
    /// The `type`; none if there is none.
    pub(super) fn kind(&self) -> Option<Cow<'a, str>> {
        self.kind.and_then(string)
    }

    /// The `type`, which must be there.
    pub(super) fn need_kind(&self, place: &str) -> Result<Cow<'a, str>, ReadProblem> {
        self.kind().ok_or_else(|| shape(place, "a \"type\""))
    }

    /// The name of a feature: `properties.name`, `properties.NAME`, or its `id`.
    pub(super) fn name(&self) -> Option<Cow<'a, str>> {
        let properties = self.properties.as_ref();
        let names = [properties.and_then(|p| p.name), properties.and_then(|p| p.upper_name), self.id];
        names.into_iter().flatten().find_map(word)
    }

    /// Counts what the name of a feature leaves out.
    pub(super) fn count_left_out(&self, counts: &mut LeftOut) {
        let properties = self.properties.as_ref();
        let names = properties.map_or([None, None], |p| [p.name, p.upper_name].map(|name| name.and_then(word)));
        let is_named = names.iter().any(Option::is_some);
        counts.ids += usize::from(is_named && self.id.is_some_and(|id| id.get() != "null"));
        let both = names.iter().all(Option::is_some) && names[0] != names[1];
        counts.properties += usize::from(both || properties.is_some_and(|p| p.others));
    }
}

/// A value as a name: strings and numbers are.
fn word(value: &RawValue) -> Option<Cow<'_, str>> {
    match value.get().as_bytes() {
        [b'\"', ..] => string(value),
        [b'-' | b'0'..=b'9', ..] => Some(value.get().into()),
        _ => None,
    }
}

/// The text of a JSON string.
fn string(value: &RawValue) -> Option<Cow<'_, str>> {
    let inside = value.get().strip_prefix('"')?.strip_suffix('"')?;
    if inside.contains('\\') { serde_json::from_str(value.get()).ok().map(Cow::Owned) } else { Some(inside.into()) }
}

/// The path of an element with its name: `features[3] "Ohio"`.
pub(super) fn named(path: &str, name: Option<&str>) -> String {
    name.map_or_else(|| path.to_owned(), |name| format!("{path} {name:?}"))
}

/// A name as it stands in a message, which is one line.
pub(super) fn one_line(name: &str) -> String {
    let shown = |c: char| if c.is_control() { c.escape_debug().to_string() } else { c.to_string() };
    name.chars().map(shown).collect()
}

/// The place of a ring in a geometry.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) path: &'a str,
    pub(super) polygon: usize,
    pub(super) ring: usize,
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, polygon, ring } = self;
        write!(f, "{path} polygon {polygon} ring {ring}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_with_line_ends_is_one_line_of_a_message() {
        assert_eq!(one_line("a\nb\u{7}"), "a\\nb\\u{7}");
        assert_eq!(one_line("Ålesund \"x\"'s"), "Ålesund \"x\"'s");
    }
}
