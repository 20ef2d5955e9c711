//! Elements as rules of a style sheet see them, and how much work they are.

use crate::figure::canvas::selectors::Tag;
use roxmltree::Node;
use std::collections::BTreeMap;

/// The work of an element: itself, and sixteenths of its attributes.
pub(super) fn size(node: Node<'_, '_>) -> usize {
    1 + node.attributes().map(|a| a.value().len()).sum::<usize>() / 16
}

/// What rules of a style sheet look at.
pub(super) fn tag(node: Node<'_, '_>) -> Tag {
    Tag {
        name: node.tag_name().name().to_owned(),
        id: node.attribute("id").map(str::to_owned),
        classes: node.attribute("class").unwrap_or("").split_whitespace().map(str::to_owned).collect(),
        attributes: node.attributes().map(|a| (a.name().to_owned(), a.value().to_owned())).collect(),
    }
}

/// The first of some elements with each id.
pub(super) fn by_id<'a, 'i>(nodes: impl Iterator<Item = Node<'a, 'i>>) -> BTreeMap<&'a str, Node<'a, 'i>> {
    let mut out = BTreeMap::new();
    for (id, node) in nodes.filter_map(|n| Some((n.attribute("id")?, n))) {
        out.entry(id).or_insert(node);
    }
    out
}
