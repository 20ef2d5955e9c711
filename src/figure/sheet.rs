//! The style sheet of one drawing: the rules that something in it wears, and no others.
//!
//! ```text
//!   .edge{...}          worn      kept
//!   .hot .sh,.dim .sh   no .hot   .dim .sh
//!   @media print{ .nav{...} }     gone with the last rule inside
//! ```
//!
//! The rules of the kit hold every class of every figure, and are most of a small file. A line holds one rule, or
//! opens or closes a block.

use std::collections::BTreeSet;
use svg::node::Node;
use svg::node::element::Element;

/// What the elements of a drawing refer to.
#[derive(Default)]
pub(super) struct Worn {
    classes: BTreeSet<String>,
    /// `url(#id)`, by the id.
    references: BTreeSet<String>,
}

impl Worn {
    pub(super) fn by(elements: &[Element]) -> Self {
        let mut out = Self::default();
        for element in elements {
            out.collect(element);
        }
        out
    }

    fn collect(&mut self, node: &dyn Node) {
        for (name, value) in node.get_attributes().into_iter().flatten() {
            if name == "class" {
                self.add(value);
            } else if let Some(id) = value.strip_prefix("url(#").and_then(|rest| rest.strip_suffix(')')) {
                self.references.insert(id.to_owned());
            }
        }
        for child in node.get_children().into_iter().flatten() {
            self.collect(&**child);
        }
    }

    /// Adds classes, separated by blanks.
    pub(super) fn add(&mut self, classes: &str) {
        for class in classes.split_whitespace().filter(|class| !self.classes.contains(*class)).collect::<Vec<_>>() {
            self.classes.insert(class.to_owned());
        }
    }

    pub(super) fn refers_to(&self, id: &str) -> bool {
        self.references.contains(id)
    }

    /// The style sheet without rules that nothing wears.
    pub(super) fn sheet(&self, css: &str) -> String {
        let mut out: Vec<String> = Vec::new();
        for line in css.lines() {
            let opens = line.starts_with('@') && line.ends_with('{');
            match line.split_once('{') {
                Some((selectors, rest)) if !opens && !line.starts_with('@') => {
                    let kept: Vec<&str> = selectors.split(',').filter(|selector| self.fits(selector)).collect();
                    if !kept.is_empty() {
                        out.push(format!("{}{{{rest}", kept.join(",")));
                    }
                }
                None if line.starts_with('}') && out.last().is_some_and(|last| last.starts_with('@')) => {
                    out.pop();
                }
                _ => out.push(line.to_owned()),
            }
        }
        out.join("\n")
    }

    /// Whether every class of a selector is worn by something.
    fn fits(&self, selector: &str) -> bool {
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        let classes = selector.split('.').skip(1).map(|rest| rest.split(|c| !is_name(c)).next().unwrap_or(""));
        classes.into_iter().all(|class| self.classes.contains(class))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use svg::node::element::{Group, Line, Path};

    #[test]
    fn rules_stay_if_their_classes_are_worn() {
        let inside = Line::new().set("class", "sh thin").set("stroke", "url(#x-hatch)");
        let drawing: [Element; 2] =
            [Group::new().set("class", "he dim").add(inside).into(), Path::new().set("class", "nav").into()];
        let css = "#x text{a:b}\n#x .sh{a:b}\n#x .hot .sh,#x .dim .sh,#x .he:hover .sh{a:b}\n#x .t0{a:b}\n\
                   @media (prefers-color-scheme:dark){\n#x .t0{a:b}\n}\n@media screen{\n#x .dim .sh{c:d}\n#x .t1{c:d}\n}\n\
                   @media print{#x .nav{display:none}}\n#x:not(:has(.fr:target)) .nav{a:b}\n";
        let worn = Worn::by(&drawing);
        assert_eq!(
            worn.sheet(css),
            "#x text{a:b}\n#x .sh{a:b}\n#x .dim .sh,#x .he:hover .sh{a:b}\n@media screen{\n#x .dim .sh{c:d}\n}\n\
             @media print{#x .nav{display:none}}"
        );
        assert!(worn.refers_to("x-hatch") && !worn.refers_to("x-hole-hatch"));
    }
}
