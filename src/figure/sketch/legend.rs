//! The legend: what badges and samples mean.
//!
//! ```text
//!   (1)  the path touches this corner
//!   ━━▸  the shortest path
//! ```

use super::item::{Heads, Item, Kind};
use super::places::badge_at;
use super::{Glyph, Role, Sketch};
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::text;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use std::collections::BTreeSet;

/// Size of the words and distance of their lines.
const TEXT: (f64, f64) = (12.0, 16.0);
/// Space between two entries.
const AIR: f64 = 6.0;
/// Width of the samples with the space beside them.
const SAMPLE: f64 = 42.0;
/// The narrowest column.
const COLUMN: f64 = 250.0;
/// The most lines of an entry.
const LINES: usize = 6;

/// A line of the legend.
pub(in crate::figure) struct Entry {
    role: Role,
    words: String,
    sample: Sample,
}

enum Sample {
    Badge(usize),
    Item(Box<Item>),
}

impl Sketch {
    /// The number of badges.
    pub(in crate::figure) fn badges(&self) -> usize {
        self.items.iter().filter(|item| matches!(item.kind, Kind::Badge(_))).count()
    }

    /// The badges with their numbers from `first` on, then the samples, each once.
    pub(in crate::figure) fn legend(&self, first: usize) -> Vec<Entry> {
        let mut out: Vec<Entry> = Vec::new();
        let mut known: BTreeSet<(Role, &str)> = BTreeSet::new();
        let keyed = || self.items.iter().filter_map(|item| Some((item, item.key.as_deref()?)));
        let badges = keyed().filter(|(item, _)| matches!(item.kind, Kind::Badge(_)));
        for (i, (item, words)) in badges.enumerate() {
            out.push(Entry { role: item.role, words: words.to_owned(), sample: Sample::Badge(first + i) });
        }
        for (item, words) in keyed().filter(|(item, _)| !matches!(item.kind, Kind::Badge(_))) {
            if known.insert((item.role, words)) {
                let sample = if self.is_bulk(item) { item.in_bulk() } else { item.clone() };
                out.push(Entry { role: item.role, words: words.to_owned(), sample: Sample::Item(Box::new(sample)) });
            }
        }
        out
    }
}

/// Takes the entries of several sketches together: samples once, badges all.
pub(in crate::figure) fn merged(legends: impl IntoIterator<Item = Vec<Entry>>) -> Vec<Entry> {
    let mut known: BTreeSet<(Role, String)> = BTreeSet::new();
    let is_new =
        |entry: &Entry| matches!(entry.sample, Sample::Badge(_)) || known.insert((entry.role, entry.words.clone()));
    legends.into_iter().flatten().filter(is_new).collect()
}

/// The legend in columns within a width, and its height. Ids begin with `instance`.
pub(in crate::figure) fn nodes(entries: &[Entry], corner: Xy, width: f64, instance: &str) -> (Vec<Node>, f64) {
    let columns = ((width / COLUMN) as usize).clamp(1, entries.len().max(1));
    let rows = entries.len().div_ceil(columns);
    let column_width = width / columns as f64;
    let (mut out, mut height) = (Vec::new(), 0.0f64);
    for (column, part) in entries.chunks(rows.max(1)).enumerate() {
        let mut at = corner + xy(column as f64 * column_width, 0.0);
        for (i, entry) in part.iter().enumerate() {
            let lines = text::wrap(&entry.words, TEXT.0, false, column_width - SAMPLE - 8.0, LINES);
            let mut group = Group {
                class: "sk",
                mark: entry.role.class(),
                id: Some(format!("{instance}s-key-{}", column * rows + i + 1)),
                nodes: entry.sample(at + xy(0.0, 0.5 * TEXT.1)),
                ..Group::default()
            };
            if let Sample::Badge(number) = entry.sample {
                group.attributes.push(("data-badge", number.to_string()));
            }
            for (row, line) in lines.iter().enumerate() {
                let at = at + xy(SAMPLE, (row as f64 + 0.5) * TEXT.1);
                group.nodes.push(Node::Text { class: "cs", at, size: TEXT.0, text: line.clone() });
            }
            out.push(Node::Group(group));
            at.y += TEXT.1 * lines.len().max(1) as f64 + AIR;
        }
        height = height.max(at.y - corner.y - AIR);
    }
    (out, height)
}

impl Entry {
    pub(in crate::figure) fn words(&self) -> &str {
        &self.words
    }

    /// A small picture, centred on a height.
    fn sample(&self, left: Xy) -> Vec<Node> {
        let (from, to) = (left, left + xy(30.0, 0.0));
        let middle = (from + to) * 0.5;
        let item = match &self.sample {
            Sample::Badge(number) => return badge_at(*number, middle).to_vec(),
            Sample::Item(item) => item,
        };
        let outline = Bounds::around(middle, 15.0, 6.0).corners();
        match &item.kind {
            Kind::Region(_) | Kind::Cone { .. } => {
                let (class, hatch) = if item.hatched { ("hatched", Some("hole-hatch")) } else { ("fi", None) };
                let mut nodes = vec![Node::Area { class, hatch, outlines: vec![outline.to_vec()] }];
                if item.outlined {
                    let lines = (0..4).map(|i| (outline[i], outline[(i + 1) % 4]));
                    nodes.extend(lines.map(|(from, to)| Node::Line { class: "ol", from, to }));
                }
                nodes
            }
            Kind::Point(_, glyph) => glyph.nodes(middle),
            Kind::Portal(_) => {
                let mut nodes = vec![Node::Line { class: "po", from, to }];
                nodes.extend(Glyph::Square.nodes(from));
                nodes.extend(Glyph::Ring.nodes(to));
                nodes
            }
            Kind::Text(_) | Kind::Badge(_) => Vec::new(),
            _ => {
                let end = if item.heads == Heads::None { to } else { to - xy(6.0, 0.0) };
                let mut nodes = vec![Node::Line { class: item.line_class(), from, to: end }];
                if item.heads != Heads::None {
                    let head = crate::figure::structure::arrows::head(to, xy(1.0, 0.0), 9.0);
                    nodes.push(Node::Area { class: "gl", hatch: None, outlines: vec![head.to_vec()] });
                }
                nodes
            }
        }
    }
}
