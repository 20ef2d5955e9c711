//! What is said of an element: by its attributes, by the rules that fit it, and by its style; a later word wins.
//!
//! ```text
//!   stroke="red"      line{stroke:none}      style="STROKE: None ! important; /* thin */ stroke-width:1px"
//! ```
//!
//! As attributes, names are as they are written; in rules and styles, small and capital letters are the same. A value that
//! browsers drop is as if it were not written.

use super::geometry::is_geometry;
use super::valid::{Written, is_valid};
use crate::figure::canvas::blocks::{is_line_end, opened, parts};
use crate::figure::canvas::selectors::{Rule, Tag};
use roxmltree::Node;
use std::borrow::Cow;

/// A property and its value.
pub(super) type Declaration<'n> = (Cow<'n, str>, Cow<'n, str>);

/// Properties that have another meaning or none as attributes.
const BY_STYLE: [&str; 8] = ["all", "background", "background-color", "offset", "rotate", "scale", "translate", "zoom"];

/// The properties of an element. `path` is what the rules look at: the tags from the root to the node.
pub(super) fn declarations<'n>(node: Node<'n, '_>, rules: &[Rule<'n>], path: &[Tag]) -> Vec<Declaration<'n>> {
    let mut out = Vec::new();
    for attribute in node.attributes().filter(|a| a.namespace().is_none()) {
        let name = attribute.name();
        // As attributes, these are read with their place.
        if name != "transform" && !is_geometry(name) && !BY_STYLE.contains(&name) {
            let value = plain(attribute.value());
            if is_valid(name, &value, Written::Attribute) {
                out.push((Cow::Borrowed(name), value));
            }
        }
    }
    let sheet = rules.iter().filter(|rule| rule.fits(path)).flat_map(|rule| rule.properties.iter().copied());
    let mut all: Vec<Declaration<'n>> = sheet.map(|(key, value)| (lower(key), Cow::Borrowed(value))).collect();
    let style = node.attribute("style").unwrap_or("");
    if style.contains("/*") || style.contains('\\') {
        let bare = bare(style);
        let parts = parts(&bare, ';').filter_map(|part| part.split_once(':'));
        all.extend(parts.map(|(key, value)| (key.trim().to_ascii_lowercase().into(), value.to_owned().into())));
    } else {
        let parts = parts(style, ';').filter_map(|part| part.split_once(':'));
        all.extend(parts.map(|(key, value)| (lower(key.trim()), Cow::Borrowed(value))));
    }
    for important in [false, true] {
        for (key, value) in &all {
            let bare = unmarked(value);
            if bare.is_some() == important {
                let value = match value {
                    Cow::Borrowed(value) => plain(unmarked(value).unwrap_or(value)),
                    Cow::Owned(value) => plain(unmarked(value).unwrap_or(value)).into_owned().into(),
                };
                if is_valid(key, &value, Written::Style) {
                    out.push((key.clone(), value));
                }
            }
        }
    }
    out
}

/// A value that is marked as important, without the mark.
fn unmarked(value: &str) -> Option<&str> {
    let (value, mark) = value.rsplit_once('!')?;
    mark.trim().eq_ignore_ascii_case("important").then_some(value.trim_end())
}

fn lower(text: &str) -> Cow<'_, str> {
    let is_small = !text.bytes().any(|b| b.is_ascii_uppercase());
    if is_small { Cow::Borrowed(text) } else { text.to_ascii_lowercase().into() }
}

/// A value in small letters, but for what stands within brackets, such as the names of elements.
fn plain(value: &str) -> Cow<'_, str> {
    let value = value.trim();
    let end = value.find('(').unwrap_or(value.len());
    match lower(&value[..end]) {
        Cow::Borrowed(_) => Cow::Borrowed(value),
        Cow::Owned(start) => (start + &value[end..]).into(),
    }
}

/// A style sheet without comments, and with escaped letters as themselves: `str\6f ke` is `stroke`. Of escaped marks, such
/// as `\:` in the name of a class, the backslash stays, so that they part nothing and are no name. What looks like a comment
/// in quotes or in `url(...)` is none. O(length).
pub(super) fn bare(css: &str) -> String {
    let mut out = String::with_capacity(css.len());
    let (mut rest, mut end) = (css, None);
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        match (end, c) {
            (_, '\\') => {
                let (letter, length) = unescaped(rest);
                out.push(letter.filter(|&c| c.is_alphanumeric() || c == '-' || c == '_').unwrap_or('\\'));
                rest = &rest[length..];
                continue;
            }
            (None, '/') if rest.starts_with('*') => {
                out.push(' ');
                rest = rest[1..].split_once("*/").map_or("", |(_, rest)| rest);
                continue;
            }
            (Some(quote), c) => end = end.filter(|_| c != quote && (quote == ')' || !is_line_end(c))),
            (None, c) => end = opened(&out, c, rest),
        }
        out.push(c);
    }
    out
}

/// The character that stands behind a backslash, and how many bytes it takes: up to six hexadecimal digits and a blank, or
/// itself.
fn unescaped(text: &str) -> (Option<char>, usize) {
    let digits = text.bytes().take(6).take_while(u8::is_ascii_hexdigit).count();
    if digits == 0 {
        let c = text.chars().next();
        return (c, c.map_or(0, char::len_utf8));
    }
    let code = u32::from_str_radix(&text[..digits], 16).unwrap_or(0);
    let blank = usize::from(text[digits..].starts_with(|c: char| c.is_ascii_whitespace()));
    (char::from_u32(code), digits + blank)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_comments_and_marks_are_read_as_browsers_do() {
        let said = |element: &str| {
            let text = format!("<g {element}/>");
            let document = roxmltree::Document::parse(&text).unwrap();
            let all = declarations(document.root_element(), &[], &[]);
            all.into_iter().map(|(key, value)| format!("{key}:{value}")).collect::<Vec<_>>().join(";")
        };
        assert_eq!(said("STROKE='RED' fill='NONE'"), "STROKE:red;fill:none");
        for (style, properties) in [
            ("STROKE:None;fill:URL(#Ab)", "stroke:none;fill:url(#Ab)"),
            ("/* a;b:c */stroke:red;/**/", "stroke:red"),
            ("a:b ! Important;a:c", "a:c;a:b"),
            (r"str\6f ke:n\00006Fne;o\pacity:0", "stroke:none;opacity:0"),
            (r"font-family:\;stroke\3a none;b:a/b", r"font-family:\stroke\none;b:a/b"),
        ] {
            let all = said(&format!("style='{style}'"));
            assert!(all.ends_with(&format!(";{properties}")), "{style}: {all}");
        }
    }
}
