//! Geometry that a style says: in SVG 2 these are properties, and a style wins over the attribute of that name.
//!
//! ```text
//!   <circle r="4" style="r:9px"/>                a circle of radius 9
//!   <line x2="9" style="x2:50px"/>               x2 is no property: the line ends at 9
//!   <path d="M0 0h9" style="d:path('M0 0v9')"/>  a line downwards
//! ```

use super::numbers::measure;

/// The properties of geometry.
const NAMES: [&str; 10] = ["cx", "cy", "r", "rx", "ry", "x", "y", "width", "height", "d"];
/// Those of which a value below 0 is none.
const LENGTHS: [&str; 5] = ["r", "rx", "ry", "width", "height"];

/// What the styles of one element say of its geometry, as it is written.
#[derive(Clone, Default, PartialEq, Debug)]
pub(super) struct Geometry(Vec<(&'static str, String)>);

/// Whether a property says where something lies or how large it is.
pub(super) fn is_geometry(key: &str) -> bool {
    NAMES.contains(&key)
}

/// Whether values below 0 of a property are none.
pub(super) fn is_never_negative(key: &str) -> bool {
    LENGTHS.contains(&key)
}

impl Geometry {
    /// Keeps what a style says; a later word wins. Other properties are passed over.
    pub(super) fn set(&mut self, key: &str, value: &str) {
        let Some(name) = NAMES.into_iter().find(|name| *name == key) else { return };
        if LENGTHS.contains(&name) && value.starts_with('-') {
            return;
        }
        self.0.retain(|(other, _)| *other != name);
        self.0.push((name, value.to_owned()));
    }

    /// What the styles say, on whatever element.
    pub(super) fn said(&self, key: &str) -> Option<&str> {
        self.0.iter().find(|(name, _)| *name == key).map(|(_, value)| value.as_str())
    }

    /// A word on place or size that is not what the attributes say, as `width: 9px`.
    pub(super) fn differing<'n>(&self, attribute: impl Fn(&str) -> Option<&'n str>) -> Option<String> {
        let differs = |key: &&str| {
            let Some(said) = self.said(key) else { return false };
            let otherwise = if matches!(*key, "x" | "y") { "0" } else { "100%" };
            let written = attribute(key).unwrap_or(otherwise);
            let is_same = |a: &str, b: &str| a == b || measure(a).is_some_and(|a| Some(a) == measure(b));
            !(is_same(said, written) || said == "auto" && is_same(written, otherwise))
        };
        let key = ["x", "y", "width", "height"].into_iter().find(|key| differs(key))?;
        Some(format!("{key}: {}", self.said(key)?))
    }

    /// What the styles say, if this is a property that browsers read on an element of this name.
    pub(super) fn of(&self, element: &str, key: &str) -> Option<&str> {
        let read: &[&str] = match element {
            "circle" => &["cx", "cy", "r"],
            "ellipse" => &["cx", "cy", "rx", "ry"],
            "rect" => &["x", "y", "width", "height", "rx", "ry"],
            "image" | "foreignObject" => &["x", "y", "width", "height"],
            "use" => &["x", "y"],
            "path" => &["d"],
            _ => &[],
        };
        self.said(key).filter(|_| read.contains(&key))
    }
}

/// The path data in `path("...")`; that of `none` is empty.
pub(super) fn path_data(text: &str) -> Option<&str> {
    if text == "none" {
        return Some("");
    }
    let inside = text.strip_prefix("path(")?.strip_suffix(')')?.trim();
    ['"', '\''].into_iter().find_map(|quote| inside.strip_prefix(quote)?.strip_suffix(quote))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_property_is_read_where_browsers_read_it() {
        let mut styles = Geometry::default();
        for (key, value) in [("r", "4px"), ("r", "9px"), ("r", "-1px"), ("x", "2px"), ("x2", "7px")] {
            styles.set(key, value);
        }
        assert_eq!((styles.of("circle", "r"), styles.of("rect", "x")), (Some("9px"), Some("2px")));
        assert_eq!((styles.of("circle", "x"), styles.of("line", "x2"), styles.said("x2")), (None, None, None));
        assert_eq!(path_data("path( 'M0 0' )"), Some("M0 0"));
        let differing = |x: Option<&'static str>| styles.differing(|key| x.filter(|_| key == "x"));
        assert_eq!((differing(None), differing(Some("2"))), (Some("x: 2px".to_owned()), None));
        assert_eq!((path_data("none"), path_data("ray(9deg)")), (Some(""), None));
    }
}
