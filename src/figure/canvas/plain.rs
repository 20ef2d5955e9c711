//! A document without a style sheet: every element carries its colours and fonts itself.
//!
//! ```text
//!   #x .sh{stroke:#b5420a}    <line class="sh"/>    ──>    <line stroke="#b5420a"/>
//! ```
//!
//! The rules of the kit's own style sheets are applied as a browser would (`selectors.rs`). A halo round a text
//! (`paint-order`) becomes a copy of the text underneath, since slide programs do not know that property.

use crate::figure::canvas::number::drawn;
use crate::figure::canvas::selectors::{Rule, Tag, rules};
use svg::node::{Children, Node};

/// The properties that are attributes, too. All others are left out.
const ATTRIBUTES: [&str; 16] = [
    "display",
    "fill",
    "fill-opacity",
    "fill-rule",
    "font-family",
    "font-style",
    "font-weight",
    "opacity",
    "paint-order",
    "stroke",
    "stroke-dasharray",
    "stroke-linecap",
    "stroke-linejoin",
    "stroke-opacity",
    "stroke-width",
    "text-anchor",
];

/// Moves the rules of `css` into the elements; style sheets and classes go. O(elements · rules).
pub(crate) fn inline(root: &mut svg::Document, css: &str) {
    dress(root, &rules(css), &mut Vec::new());
}

fn dress(node: &mut dyn Node, rules: &[Rule<'_>], path: &mut Vec<Tag>) {
    let name = node.get_name().to_owned();
    let Some(attributes) = node.get_attributes_mut() else { return };
    let classes = attributes.remove("class").map(String::from).unwrap_or_default();
    let classes = classes.split_whitespace().map(str::to_owned).collect();
    path.push(Tag { name, id: attributes.get("id").map(ToString::to_string), classes, ..Tag::default() });
    for rule in rules.iter().filter(|rule| rule.fits(path)) {
        for &(key, value) in rule.properties.iter().filter(|(key, _)| ATTRIBUTES.contains(key)) {
            attributes.insert(key.to_owned(), value.into());
        }
    }
    if let Some(children) = node.get_children_mut() {
        let mut dressed: Children = Vec::with_capacity(children.len());
        for mut child in children.drain(..).filter(|child| child.get_name() != "style") {
            dress(&mut *child, rules, path);
            let is_hidden = child.get_attributes().and_then(|a| a.get("display")).is_some_and(|v| *v == "none");
            if !is_hidden {
                dressed.extend(halo(&mut child));
                dressed.push(child);
            }
        }
        *children = dressed;
    }
    path.pop();
}

/// Takes the halo off a text: a copy to be painted before it.
fn halo(text: &mut Box<dyn Node>) -> Option<Box<dyn Node>> {
    if text.get_name() != "text" || text.get_attributes()?.get("paint-order").is_none() {
        return None;
    }
    text.get_attributes_mut()?.remove("paint-order");
    let mut halo = text.clone();
    let attributes = text.get_attributes_mut()?;
    for key in ["stroke", "stroke-width", "stroke-linejoin"] {
        attributes.remove(key);
    }
    let attributes = halo.get_attributes_mut()?;
    let number = |key: &str, unit: &str| attributes.get(key)?.strip_suffix(unit)?.parse::<f64>().ok();
    if let (Some(ems), Some(size)) = (number("stroke-width", "em"), number("font-size", "")) {
        attributes.insert("stroke-width".to_owned(), drawn(ems * size).into());
    }
    let paper = attributes.get("stroke")?.clone();
    attributes.insert("fill".to_owned(), paper);
    attributes.insert("aria-hidden".to_owned(), "true".into());
    attributes.remove("id");
    Some(halo)
}

#[cfg(test)]
mod tests {
    use super::*;
    use svg::node::element::{Group, Line, Text};

    #[test]
    fn rules_apply_by_specificity_then_order_and_media_rules_do_not() {
        let css = "#x #x-h1 .sh{stroke:red}\n#x .dim .sh{stroke:grey;stroke-width:3}\n#x .sh{stroke:brown;cursor:help}\n\
                   @media print{\n#x .sh{stroke:black}\n}\n#x .sh:hover{stroke:blue}\n#y .sh{stroke:pink}";
        let line = |class: &str| Line::new().set("class", class);
        let group = |id: &str, class: &str| Group::new().set("id", id).set("class", class).add(line("sh"));
        let mut root = svg::Document::new().set("id", "x").add(line("sh")).add(line("edge"));
        root = root.add(group("x-h0", "he dim")).add(group("x-h1", "he dim"));
        inline(&mut root, css);
        let lines: Vec<String> =
            root.to_string().lines().filter(|l| l.starts_with("<line")).map(str::to_owned).collect();
        assert_eq!(
            lines,
            [
                "<line stroke=\"brown\"/>",
                "<line/>",
                "<line stroke=\"grey\" stroke-width=\"3\"/>",
                "<line stroke=\"red\" stroke-width=\"3\"/>"
            ]
        );
    }

    #[test]
    fn a_halo_is_a_copy_below_the_text() {
        let css = "#x .hl{fill:brown;stroke:white;paint-order:stroke;stroke-width:.3em}";
        let text = Text::new("h1").set("class", "hl").set("font-size", "10");
        let mut root = svg::Document::new().set("id", "x").add(text);
        inline(&mut root, css);
        let out = root.to_string();
        let halo = out.find("fill=\"white\" font-size=\"10\" stroke=\"white\" stroke-width=\"3\"").unwrap();
        let text = out.find("<text fill=\"brown\" font-size=\"10\">").unwrap();
        assert!(halo < text, "{out}");
    }
}
