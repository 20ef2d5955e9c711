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

use std::collections::{BTreeMap, BTreeSet};
use svg::node::Node;
use svg::node::element::Element;

/// What the elements of a drawing refer to.
#[derive(Default)]
pub(crate) struct Worn {
    classes: BTreeSet<String>,
    /// `url(#id)`, by the id.
    references: BTreeSet<String>,
}

impl Worn {
    pub(crate) fn by(elements: &[Element]) -> Self {
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
    pub(crate) fn add(&mut self, classes: &str) {
        for class in classes.split_whitespace() {
            if !self.classes.contains(class) {
                self.classes.insert(class.to_owned());
            }
        }
    }

    pub(crate) fn refers_to(&self, id: &str) -> bool {
        self.references.contains(id)
    }

    /// The style sheet without rules that nothing wears.
    pub(crate) fn sheet(&self, css: &str) -> String {
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
        let mut classes = selector.split('.').skip(1).map(|rest| rest.split(|c| !is_name(c)).next().unwrap_or(""));
        classes.all(|class| self.classes.contains(class))
    }
}

/// Takes the size off texts whose whole class has one size, and gives the class a rule that says it.
pub(crate) fn share_sizes(elements: &mut [Element], prefix: &str) -> String {
    let mut sizes: BTreeMap<String, Option<String>> = BTreeMap::new();
    for element in elements.iter() {
        note_size(element, &mut sizes);
    }
    // A rule of one class would reach texts that wear it beside others.
    let single = |class: &str| {
        let wears = |other: &str| other != class && other.split(' ').any(|one| one == class);
        !class.contains(' ') && !sizes.keys().any(|other| wears(other))
    };
    let shared: BTreeMap<&str, &str> = sizes
        .iter()
        .filter(|(class, _)| single(class))
        .filter_map(|(class, size)| Some((class.as_str(), size.as_deref()?)))
        .collect();
    elements.iter_mut().for_each(|element| take_size(element, &shared));
    shared.iter().map(|(class, size)| format!("\n#{prefix} .{class}{{font-size:{size}px}}")).collect()
}

/// The class of a text and its size.
fn text_size(node: &dyn Node) -> Option<(String, String)> {
    let attributes = node.get_attributes().filter(|_| node.get_name() == "text")?;
    Some((attributes.get("class")?.to_string(), attributes.get("font-size")?.to_string()))
}

fn note_size(node: &dyn Node, sizes: &mut BTreeMap<String, Option<String>>) {
    if let Some((class, size)) = text_size(node) {
        let known = sizes.entry(class).or_insert_with(|| Some(size.clone()));
        if known.as_ref() != Some(&size) {
            *known = None;
        }
    }
    node.get_children().into_iter().flatten().for_each(|child| note_size(&**child, sizes));
}

fn take_size(node: &mut dyn Node, shared: &BTreeMap<&str, &str>) {
    if text_size(node).is_some_and(|(class, _)| shared.contains_key(class.as_str()))
        && let Some(attributes) = node.get_attributes_mut()
    {
        attributes.remove("font-size");
    }
    node.get_children_mut().into_iter().flatten().for_each(|child| take_size(&mut **child, shared));
}

#[cfg(test)]
mod tests {
    use super::*;
    use svg::node::element::{Group, Line, Path, Text};

    #[test]
    fn sizes_are_shared_where_the_class_has_one() {
        let text = |class: &str, size: &str| Text::new("x").set("class", class).set("font-size", size);
        let inside = Group::new().add(text("hl", "9.5")).add(text("vl", "9.5")).add(text("vl", "8"));
        let mut drawing: [Element; 3] = [inside.into(), text("hl", "9.5").into(), text("cs nav", "12").into()];
        assert_eq!(share_sizes(&mut drawing, "x"), "\n#x .hl{font-size:9.5px}");
        let sizes: Vec<bool> = drawing.iter().map(|e| e.to_string().contains("class=\"hl\" font-size")).collect();
        assert_eq!(sizes, [false; 3]);
        assert_eq!(drawing[0].to_string().matches("font-size").count(), 2, "two sizes stay with their texts");
        assert!(drawing[2].to_string().contains("font-size=\"12\""), "two classes");
    }

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
