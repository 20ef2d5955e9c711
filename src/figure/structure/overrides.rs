//! Colours and labels of single elements, from code or from a file of lines.
//!
//! ```text
//!   # the rooms
//!   f1 #e69f00 "kitchen"
//!   f2 "hall"
//!   h7 #0067a5
//!   v0 #b5420a "A"
//! ```
//!
//! A face has exactly the colour given, not a tint of it; a half-edge has it on shaft, barb and label, a vertex
//! on circle and name. The colours are the same on light and on dark pages.

use crate::figure::canvas::scripts::typeset;
use crate::figure::canvas::style::Colour;
use crate::figure::canvas::text;
use crate::figure::structure::skeleton::ids;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::topology::View;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Why a text holds no colours and labels, or not for this structure.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{line}:{column}: {what}")]
pub struct OverridesError {
    /// Line of the text, from 1.
    pub line: usize,
    /// Column of the text in characters, from 1.
    pub column: usize,
    /// What is wrong there, and what to write instead.
    pub what: String,
}

/// What is said about one element.
#[derive(Clone, PartialEq, Debug, Default)]
struct Entry {
    colour: Option<Colour>,
    label: Option<String>,
    /// Line and column in the file.
    place: (usize, usize),
}

/// Colours and labels of single elements.
///
/// ```
/// # use dcel_kit::figure::{FigureOptions, Overrides};
/// let overrides = Overrides::parse("f1 #e69f00 \"kitchen\"\nh7 #0067a5\n")?;
/// let options = FigureOptions::new("Rooms").overrides(overrides);
/// let error = Overrides::parse("f1 blue").unwrap_err();
/// assert_eq!(error.to_string(), "1:4: `blue` is neither a colour such as #0067a5 nor a label in double quotes");
/// # Ok::<(), dcel_kit::figure::OverridesError>(())
/// ```
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Overrides {
    entries: BTreeMap<Element, Entry>,
}

impl Overrides {
    /// Reads lines: an element (`v3`, `h7` or `f2`), then a colour (`#rrggbb` or `#rgb`), or a label in double
    /// quotes (`\"` and `\\` stand for `"` and `\`; `e_1`, `x_{12}` and `r^2` are set as [`label`](Self::label) says), or both. Empty lines are skipped, and so is a line
    /// that begins with `#`, and the rest of a line from `# ` on. A later line about an element adds to an earlier one.
    ///
    /// # Errors
    /// [`OverridesError`] with line and column.
    pub fn parse(text: &str) -> Result<Self, OverridesError> {
        let mut out = Self::default();
        for (number, line) in text.lines().enumerate() {
            out.read_line(line).map_err(|(column, what)| OverridesError { line: number + 1, column, what })?;
            out.entries.values_mut().filter(|e| e.place.0 == 0).for_each(|e| e.place.0 = number + 1);
        }
        Ok(out)
    }

    fn read_line(&mut self, line: &str) -> Result<(), (usize, String)> {
        let column = |rest: &str| line[..line.len() - rest.len()].chars().count() + 1;
        let start = line.trim_start();
        if start.is_empty() || start.starts_with('#') {
            return Ok(());
        }
        let end = start.find(char::is_whitespace).unwrap_or(start.len());
        let (name, mut rest) = start.split_at(end);
        let element = element(name).map_err(|what| (column(start), what))?;
        let mut new = Entry { place: (0, column(start)), ..Entry::default() };
        loop {
            rest = rest.trim_start();
            if rest.is_empty() || rest == "#" || rest.starts_with("# ") {
                break;
            }
            if rest.starts_with('"') && new.label.is_none() {
                let (label, after) = quoted(rest).map_err(|what| (column(rest), what))?;
                (new.label, rest) = (Some(label), after);
                continue;
            }
            let end = rest.find(char::is_whitespace).unwrap_or(rest.len());
            let colour = rest[..end].parse().ok().filter(|_| new.colour.is_none());
            new.colour = Some(colour.ok_or_else(|| (column(rest), unknown(&rest[..end])))?);
            rest = &rest[end..];
        }
        if new.colour.is_none() && new.label.is_none() {
            return Err((column(rest), format!("{element} gets nothing: write a colour, a label, or both")));
        }
        let entry = self.entries.entry(element).or_default();
        *entry =
            Entry { colour: new.colour.or(entry.colour), label: new.label.or(entry.label.take()), place: new.place };
        Ok(())
    }

    /// Gives an element a colour. Edges have none of their own: they are grey lines between their halves.
    #[must_use]
    pub fn colour(mut self, element: impl Into<Element>, colour: Colour) -> Self {
        self.entries.entry(element.into()).or_default().colour = Some(colour);
        self
    }

    /// Gives a vertex, a half-edge or a face a label instead of its id. `e_1` is set as e₁, `x_{12}` as x₁₂, `r^2` as r²: one
    /// letter with numbers or letters below or above it.
    #[must_use]
    pub fn label(mut self, element: impl Into<Element>, label: impl AsRef<str>) -> Self {
        self.entries.entry(element.into()).or_default().label = Some(text::clean(&typeset(label.as_ref())));
        self
    }

    /// Whether all elements exist in a structure. Others are ignored by figures.
    ///
    /// # Errors
    /// [`OverridesError`] for the first line about an element that does not exist.
    pub fn check<V: View + ?Sized>(&self, view: &V) -> Result<(), OverridesError> {
        let is_there = |element: Element| match element {
            Element::Vertex(v) => view.has_vertex(v),
            Element::HalfEdge(h) => view.has_half_edge(h),
            Element::Face(f) => view.has_face(f),
            Element::Edge(_) => true,
        };
        let wrong = self.entries.iter().filter(|&(&element, _)| !is_there(element));
        let Some(((line, column), element)) = wrong.map(|(&element, entry)| (entry.place, element)).min() else {
            return Ok(());
        };
        let [vertices, half_edges, faces] = [view.vertex_bound(), view.half_edge_bound(), view.face_bound()];
        let (count, bound) = match element {
            Element::Vertex(_) => (ids(vertices, |v| view.has_vertex(v)).count(), vertices),
            Element::HalfEdge(_) | Element::Edge(_) => (ids(half_edges, |h| view.has_half_edge(h)).count(), half_edges),
            Element::Face(_) => (ids(faces, |f| view.has_face(f)).count(), faces),
        };
        Err(OverridesError { line, column, what: element.missing(count, bound) })
    }

    /// The label of an element.
    pub(crate) fn label_of(&self, element: impl Into<Element>) -> Option<&str> {
        self.entries.get(&element.into())?.label.as_deref()
    }

    /// The labels of faces.
    pub(crate) fn face_labels(&self) -> impl Iterator<Item = (FaceId, &str)> {
        self.entries.iter().filter_map(|(element, entry)| match element {
            Element::Face(f) => Some((*f, entry.label.as_deref()?)),
            _ => None,
        })
    }

    /// The style rules of the colours, for a figure with this prefix.
    pub(crate) fn css(&self, prefix: &str) -> String {
        let mut out = String::new();
        for (element, entry) in &self.entries {
            let Some(colour) = entry.colour else { continue };
            let parts: &[(&str, &str, &str)] = match element {
                Element::Vertex(_) => &[("vd", "stroke", ""), ("vl", "fill", ""), ("dot", "fill", "")],
                Element::HalfEdge(_) => &[("sh", "stroke", ""), ("barb", "fill", ""), ("hl", "fill", "")],
                Element::Face(_) => &[("face", "fill", ";fill-opacity:1")],
                Element::Edge(_) => &[],
            };
            for (class, property, more) in parts {
                let _ = writeln!(out, "#{prefix} #{prefix}-{element} .{class}{{{property}:{colour}{more}}}");
            }
        }
        out
    }
}

/// The element with this name.
fn element(name: &str) -> Result<Element, String> {
    let parsed = match name.as_bytes().first() {
        Some(b'v') => name.parse::<VertexId>().map(Element::from),
        Some(b'h') => name.parse::<HalfEdgeId>().map(Element::from),
        Some(b'f') => name.parse::<FaceId>().map(Element::from),
        _ => return Err(format!("`{name}` is not the name of an element: write v3, h7 or f2, for example")),
    };
    parsed.map_err(|error| error.to_string())
}

fn unknown(word: &str) -> String {
    format!("`{word}` is neither a colour such as #0067a5 nor a label in double quotes")
}

/// The text in double quotes at the start of `text`, and what follows it.
fn quoted(text: &str) -> Result<(String, &str), String> {
    let mut out = String::new();
    let mut escaped = false;
    for (i, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => {
                out.push(c);
                escaped = false;
            }
            '\\' => escaped = true,
            '"' => return Ok((text::clean(&typeset(&out)), &text[i + 1..])),
            _ => out.push(c),
        }
    }
    Err("this label has no closing double quote".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_and_add_up() {
        let text = "# rooms\n\n f1 #e69f00 \"a \\\"b\\\" \\\\ c\" # seen\nf1 #123\nh7 #0067a5\r\nv0 \"A\"\n";
        let read = Overrides::parse(text).unwrap();
        let written = Overrides::default()
            .colour(FaceId::new(1), Colour(0x0011_2233))
            .label(FaceId::new(1), "a \"b\" \\ c")
            .colour(HalfEdgeId::new(7), Colour(0x0000_67a5))
            .label(VertexId::new(0), "A");
        let plain = |o: &Overrides| o.entries.iter().map(|(k, e)| (*k, e.colour, e.label.clone())).collect::<Vec<_>>();
        assert_eq!(plain(&read), plain(&written));
    }

    #[test]
    fn errors_name_line_and_column() {
        for (text, place, part) in [
            ("f2 \"a\" # b\nx3 #fff", (2, 1), "`x3` is not the name of an element"),
            ("  fx #fff", (1, 3), "`fx` is not the name of a face"),
            ("f1 red", (1, 4), "`red` is neither"),
            ("f1 #12345", (1, 4), "`#12345` is neither"),
            ("f1 \"é\" red", (1, 8), "`red` is neither"),
            ("h2 \"open", (1, 4), "no closing"),
            ("h2", (1, 3), "h2 gets nothing"),
            ("f1 \"a\" \"b\"", (1, 8), "neither"),
        ] {
            let error = Overrides::parse(text).unwrap_err();
            assert_eq!((error.line, error.column), place, "{text}: {error}");
            assert!(error.what.contains(part), "{text}: {error}");
        }
    }

    #[test]
    fn an_element_that_does_not_exist_is_named_with_its_line() {
        let dcel = crate::topology::Dcel::polygon(3).unwrap();
        let check = |text: &str| Overrides::parse(text).unwrap().check(&dcel);
        assert_eq!(check("f1 #fff\nh5 #fff\nv2 #fff"), Ok(()));
        let error = check("v2 #fff\n  h6 #fff\nf9 #fff").unwrap_err();
        assert_eq!(error.to_string(), "2:3: there is no h6: there are 6 half-edges");
    }
}
