//! What a text says that stands at an element.
//!
//! ```text
//!   v0  v_0  v₀  $v_0$        the name of v0
//!   f1  Garden  f1 Garden     the names of a face f1 that is called Garden, and of one that is called f1 Garden
//!   v3                        at v0: the name of something else of the same kind
//! ```

use crate::ids::FaceId;

/// What a text says at an element.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Spelling {
    /// Its own name.
    Own,
    /// The name of something else of the same kind.
    Other,
    /// No name of that kind.
    Nothing,
}

impl Spelling {
    /// `name` is what a face is called, `is_face` tells whether some face is called so.
    pub(super) fn of(element: &str, name: Option<&str>, text: &str, is_face: impl Fn(&str) -> bool) -> Self {
        let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        let bare = bare(text);
        let is_called = |name: &str| {
            let [name, text] = [name, text].map(|text| unnumbered(element, text));
            let is_start = |start: &str| !start.is_empty() && name.starts_with(start.trim_end());
            name == text || text.strip_suffix('…').is_some_and(is_start)
        };
        if bare == element || name.is_some_and(is_called) {
            return Self::Own;
        }
        let is_other = if element.parse::<FaceId>().is_ok() {
            is_face(text) || bare.parse::<FaceId>().is_ok()
        } else {
            bare.get(..1) == element.get(..1) && bare.get(1..).is_some_and(is_number)
        };
        if is_other { Self::Other } else { Self::Nothing }
    }
}

/// A text without the marks of formulas, with its indices as digits.
fn bare(text: &str) -> String {
    let digit = |c: char| match c {
        '₀'..='₉' => char::from_digit(c as u32 - '₀' as u32, 10).unwrap_or(c),
        _ => c,
    };
    text.chars().filter(|c| !c.is_whitespace() && !"_{}$".contains(*c)).map(digit).collect()
}

/// What a face is called, without its number before or behind that.
pub(super) fn unnumbered<'t>(element: &str, text: &'t str) -> &'t str {
    let is_mark = |c: char| !c.is_alphanumeric() && c != '…';
    let before = text.strip_prefix(element).filter(|rest| rest.starts_with(is_mark));
    let behind = text.trim_end_matches(')').strip_suffix(element).filter(|rest| rest.ends_with(is_mark));
    let rest = before.or(behind).map(|rest| rest.trim_matches(is_mark)).filter(|rest| !rest.is_empty());
    rest.unwrap_or(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_spelt_as_programs_and_people_write_them() {
        let of =
            |element: &str, name: Option<&str>, text: &str| Spelling::of(element, name, text, |name| name == "Shed");
        for text in ["v0", "v_0", "v₀", "$v_{0}$", "v 0"] {
            assert_eq!(of("v0", None, text), Spelling::Own, "{text}");
        }
        for text in ["f1", "Garden", "f1 Garden", "f1: Garden", "Garden (f1)", "Gar…"] {
            assert_eq!(of("f1", Some("Garden"), text), Spelling::Own, "{text}");
            assert_eq!(of("f1", Some("f1 Garden"), text), Spelling::Own, "{text}");
        }
        for (element, text) in [("v0", "v3"), ("v0", "v₃"), ("h3", "h31"), ("f1", "f2"), ("f1", "Shed")] {
            assert_eq!(of(element, Some("Garden").filter(|_| element == "f1"), text), Spelling::Other, "{text}");
        }
        for (element, text) in
            [("v0", "xyz"), ("v0", ""), ("h3", "v9"), ("f1", "f1 Shed"), ("f1", "Gardens"), ("f1", "…")]
        {
            assert_eq!(of(element, Some("Garden").filter(|_| element == "f1"), text), Spelling::Nothing, "{text}");
        }
    }
}
