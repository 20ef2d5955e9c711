//! Edits back to text: what a failing test prints, and anybody can run again.
//!
//! ```text
//!   split_face h2 h8       let a1 = split_face h2 h8
//!   split_in_half h12      let a2 = split_in_half a1
//!   join_edges h13         join_edges a2.twin.next
//! ```

use super::kernel::KernelStart;
use super::syntax::{Link, follow};
use super::{Edit, KernelEdit};
use crate::edits::{Call, Editable, Kind};
use crate::ids::Element;
use crate::plane::{Point, Subdivision};
use crate::topology::Change;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// The script that starts with the polygon of these corners and makes these calls, refused ones too.
///
/// Half-edges that edits make are written by names (`a1` for what the first edit made, `a1.twin`). A call of a
/// half-edge that does not exist at its turn cannot be said in words; it becomes a comment.
///
/// Cost: that of the edits.
#[must_use]
pub fn of_edits(corners: &[Point], edits: &[Edit]) -> String {
    let start: Vec<String> = corners.iter().map(|p| format!(" {} {}", p.x, p.y)).collect();
    let start = format!("polygon{}", start.concat());
    Writer::write(start, Subdivision::polygon(corners).ok(), edits)
}

/// The script without coordinates that makes these calls; otherwise as [`of_edits`].
///
/// ```
/// use dcel_kit::script::{KernelEdit, KernelStart, of_kernel_edits};
/// let edits: Vec<KernelEdit> = vec!["split_vertex h0 h0".parse()?, "join_vertices h4".parse()?];
/// assert_eq!(of_kernel_edits(&KernelStart::Torus, &edits), "torus\nlet a1 = split_vertex h0 h0\njoin_vertices a1\n");
/// # Ok::<(), dcel_kit::edits::CallError>(())
/// ```
#[must_use]
pub fn of_kernel_edits(start: &KernelStart, edits: &[KernelEdit]) -> String {
    Writer::write(start.to_string(), start.build().ok(), edits)
}

/// The script in space that makes these calls; otherwise as [`of_edits`].
#[cfg(feature = "solid")]
#[must_use]
pub fn of_solid_edits(start: &super::SolidStart, edits: &[super::SolidEdit]) -> String {
    Writer::write(start.to_string(), start.build().ok(), edits)
}

/// How far from the named element another one may be that the same edit has made.
const FAR: usize = 10_000;

/// A script while it is being written.
#[derive(Clone, Debug)]
pub(crate) struct Writer<S> {
    structure: S,
    /// The start, then one text for each edit: its line, and those that name what it has made beside.
    lines: Vec<String>,
    /// Where each live edge, vertex and face comes from.
    sources: BTreeMap<Element, Source>,
    /// The names given so far, besides those of the edits.
    names: BTreeSet<String>,
}

/// Where an element comes from.
#[derive(Clone, Debug)]
enum Source {
    Start,
    /// The word for it, and for an edge which half the word means.
    Named(String, Element),
    /// Links from the name of the edit with this number lead there; its line is `line`.
    Made {
        number: usize,
        name: String,
        line: usize,
        links: Vec<Link>,
        to: Element,
    },
}

impl<S: Editable> Writer<S> {
    fn write(start: String, structure: Option<S>, edits: &[Call<S>]) -> String {
        let Some(structure) = structure else { return start + "\n" };
        let mut writer = Self::new(start, structure);
        for edit in edits {
            writer.edit(edit, None);
        }
        writer.lines.join("\n") + "\n"
    }

    /// A script that starts with this line, which makes this structure.
    pub(crate) fn new(start: String, structure: S) -> Self {
        let on = structure.topology();
        let edges = on.edges().map(Element::from);
        let all = edges.chain(on.vertices().map(Element::from)).chain(on.faces().map(Element::from));
        let sources = all.map(|element| (element, Source::Start)).collect();
        Self { structure, lines: vec![start], sources, names: BTreeSet::new() }
    }

    /// The start, then a text for each edit and each statement.
    #[cfg(feature = "play")]
    pub(crate) fn lines(&self) -> &[String] {
        &self.lines
    }

    /// Appends a statement that is no edit, as it is written, with the name that it gives.
    #[cfg(feature = "play")]
    pub(crate) fn say(&mut self, line: &str, name: Option<&str>) {
        self.lines.push(line.to_owned());
        self.names.extend(name.map(str::to_owned));
    }

    /// Appends an edit. What it makes gets the name, or one of its own.
    pub(crate) fn edit(&mut self, edit: &Call<S>, name: Option<&str>) {
        let number = self.lines.len();
        let call = match edit.write_with(|element| self.word(element)) {
            Ok(call) => call,
            Err(missing) => {
                self.lines.push(format!("# {edit}: no such {}", Kind::of(missing).name()));
                return;
            }
        };
        let mut log = S::Log::default();
        let Ok(returned) = edit.apply(&mut self.structure, &mut log) else {
            self.lines.push(format!("{call}   # refused"));
            return;
        };
        let mut made = Vec::new();
        for change in S::pointers(log).changes() {
            match *change {
                Change::Removed { element } => {
                    self.sources.remove(&element);
                    made.retain(|&gone| gone != element);
                }
                Change::Added { element, .. } => made.push(element),
                Change::Write { .. } => {}
            }
        }
        let line = self.lines.len();
        let Some(named) = returned.named() else {
            self.lines.push(call);
            return;
        };
        let Some(name) = name.map_or_else(|| self.free_name('a', number), |name| Some(name.to_owned())) else { return };
        self.names.insert(name.clone());
        self.lines.push(format!("let {name} = {call}"));
        self.sources.insert(whole(named), Source::Named(name.clone(), named));
        made.retain(|&element| element != whole(named));
        for (links, to) in self.ways_from(named, made) {
            self.sources.insert(whole(to), Source::Made { number, name: name.clone(), line, links, to });
        }
    }

    /// A name that is not taken, which is taken now: `a3`, else `a3_2` and so on.
    fn free_name(&mut self, letter: char, number: usize) -> Option<String> {
        let first = std::iter::once(format!("{letter}{number}"));
        first.chain((2..).map(|i| format!("{letter}{number}_{i}"))).find(|word| self.names.insert(word.clone()))
    }

    /// The shortest links from an element to each of the others.
    fn ways_from(&self, start: Element, mut wanted: Vec<Element>) -> Vec<(Vec<Link>, Element)> {
        let mut found = Vec::new();
        let mut seen: BTreeMap<Element, Option<(Element, Link)>> = BTreeMap::from([(start, None)]);
        let mut queue = VecDeque::from([start]);
        while let Some(at) = queue.pop_front().filter(|_| !wanted.is_empty() && seen.len() < FAR) {
            if let Some(i) = wanted.iter().position(|&element| element == whole(at)) {
                wanted.swap_remove(i);
                let back = std::iter::successors(seen[&at], |(before, _)| seen[before]);
                let mut links: Vec<Link> = back.map(|(_, link)| link).collect();
                links.reverse();
                found.push((links, at));
            }
            for link in Link::ALL {
                if let Some(to) = follow(self.structure.topology(), at, link)
                    && !seen.contains_key(&to)
                {
                    seen.insert(to, Some((at, link)));
                    queue.push_back(to);
                }
            }
        }
        found
    }

    /// How the script can name an element; `None` if it does not exist, or nothing leads there.
    fn word(&mut self, element: Element) -> Option<String> {
        let source = self.sources.get(&whole(element))?.clone();
        let (word, names) = match source {
            Source::Start => return Some(element.to_string()),
            Source::Named(word, names) => (word, names),
            Source::Made { number, name, line, links, to } => {
                // By now the links may lead elsewhere: it is named where it was made.
                let letter = match to {
                    Element::Vertex(_) => 'p',
                    Element::Face(_) => 'q',
                    Element::HalfEdge(_) | Element::Edge(_) => 'b',
                };
                let word = self.free_name(letter, number)?;
                let links: Vec<&str> = links.iter().map(|link| link.word()).collect();
                self.lines[line].push_str(&format!("\nlet {word} = {name}.{}", links.join(".")));
                self.sources.insert(whole(to), Source::Named(word.clone(), to));
                (word, to)
            }
        };
        Some(match (element, names) {
            (Element::HalfEdge(h), Element::HalfEdge(named)) if h == named.twin() => format!("{word}.twin"),
            (Element::Edge(_), Element::HalfEdge(_)) => format!("{word}.edge"),
            _ => word,
        })
    }
}

/// The edge of a half-edge; other elements are themselves.
fn whole(element: Element) -> Element {
    match element {
        Element::HalfEdge(h) => h.edge().into(),
        other => other,
    }
}
