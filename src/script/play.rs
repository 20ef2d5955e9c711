//! Carrying out a script, step by step.
//!
//! ```text
//!   3: let a = split_face h2 h0.next.next.twin.prev.twin     words
//!      split_face h2 h8                                       ids, as they are at this moment
//!      returned h12, f2                                       a = h12
//! ```

use super::Edit;
use super::syntax::{Action, Base, Link, Path, Script, Statement, Value, follow};
use crate::edits::{Argument, Call, EditError, Editable, Returned};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::Subdivision;
use crate::topology::{Change, Journal};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::ControlFlow;

/// A statement that has been carried out, or refused.
#[derive(Clone, PartialEq, Debug)]
pub struct Step<E = Edit> {
    /// Its number among the statements of the script, from 0.
    pub statement: usize,
    /// What came of it.
    pub outcome: Outcome<E>,
}

/// What came of a statement.
#[derive(Clone, PartialEq, Debug)]
pub enum Outcome<E = Edit> {
    /// An edit was made.
    Edited {
        /// The call with its ids.
        edit: E,
        /// What it gave back.
        returned: Returned,
        /// Every change it made, by the steps of the operation.
        journal: Journal,
    },
    /// Nothing was done.
    Refused {
        /// The call with its ids, if the words could be resolved.
        edit: Option<E>,
        /// Why not.
        reason: Refusal,
    },
    /// A walk along `next` until it closed.
    WalkedFace {
        /// The face on the left.
        face: FaceId,
        /// The half-edges with their origins.
        cycle: Vec<(HalfEdgeId, VertexId)>,
    },
    /// A walk round a vertex, counter-clockwise.
    WalkedVertex {
        /// The vertex.
        vertex: VertexId,
        /// The half-edges that start there, with their destinations.
        star: Vec<(HalfEdgeId, VertexId)>,
    },
    /// An element got a name.
    Named(Element),
    /// Elements to be marked in the frames of the next edit.
    Highlighted(Vec<Element>),
    /// A sentence for the frames of the next edit.
    Caption(String),
    /// The structure is to be written out.
    Dump,
}

impl<E> Outcome<E> {
    /// Whether the statement was refused.
    #[must_use]
    pub fn is_refused(&self) -> bool {
        matches!(self, Self::Refused { .. })
    }
}

impl<E: fmt::Display> fmt::Display for Outcome<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pairs = |f: &mut fmt::Formatter<'_>, pairs: &[(HalfEdgeId, VertexId)]| {
            pairs.iter().try_for_each(|(h, v)| write!(f, " {h} ({v})"))
        };
        match self {
            Self::Edited { edit, returned, .. } => write!(f, "{edit} returned {returned}"),
            Self::Refused { edit: Some(edit), reason } => write!(f, "{edit} refused: {reason}"),
            Self::Refused { edit: None, reason } => write!(f, "refused: {reason}"),
            Self::WalkedFace { face, cycle } => {
                write!(f, "along {face}:")?;
                pairs(f, cycle)
            }
            Self::WalkedVertex { vertex, star } if star.is_empty() => write!(f, "round {vertex}: no half-edge"),
            Self::WalkedVertex { vertex, star } => {
                write!(f, "round {vertex}:")?;
                pairs(f, star)
            }
            Self::Named(element) => write!(f, "is {element}"),
            Self::Highlighted(elements) => {
                let names: Vec<String> = elements.iter().map(ToString::to_string).collect();
                write!(f, "highlighted {}", names.join(", "))
            }
            Self::Caption(text) => f.write_str(text),
            Self::Dump => f.write_str("dump"),
        }
    }
}

/// Why a statement was not carried out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The edit refused.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// The element of a word has been removed.
    #[error("`{word}` was {element}, which line {line} has removed; name another element")]
    Gone {
        /// The word.
        word: String,
        /// What it named.
        element: Element,
        /// The line of the edit that removed it.
        line: u32,
    },
    /// The edit that was to give the name was refused.
    #[error("`{word}` names nothing, because line {line} was refused")]
    Unnamed {
        /// The word.
        word: String,
        /// The line of the refused edit.
        line: u32,
    },
    /// A pointer that is not set: the `outgoing` of a vertex without edges, the `half_edge` of an empty plane.
    #[error("{element}.{} is not set, so `{word}` leads nowhere", link.word())]
    NoTarget {
        /// The word.
        word: String,
        /// Where the path ends.
        element: Element,
        /// The link that leads nowhere.
        link: Link,
    },
}

/// A script that has been carried out.
#[derive(Clone, PartialEq, Debug)]
pub struct Run<G: Editable = Subdivision> {
    /// One for each statement.
    pub steps: Vec<Step<Call<G>>>,
    /// The structure at the end.
    pub end: G,
}

impl<G: Editable> Run<G> {
    /// The edits that were made, in order: [`of_edits`](super::of_edits) prints them.
    #[must_use]
    pub fn edits(&self) -> Vec<Call<G>> {
        let made = self.steps.iter().filter_map(|step| match &step.outcome {
            Outcome::Edited { edit, .. } => Some(edit.clone()),
            _ => None,
        });
        made.collect()
    }
}

impl<G: Editable> Script<G> {
    /// Carries out all statements. Refused ones change nothing, and the script goes on.
    #[must_use]
    pub fn run(&self) -> Run<G> {
        let mut steps = Vec::with_capacity(self.statements.len());
        let end = self.play(|step, _| {
            steps.push(step);
            ControlFlow::Continue(())
        });
        Run { steps, end }
    }

    /// Carries out the statements one by one; `watch` gets each with the structure after it, and may end the
    /// play. Returns the structure as it is then.
    ///
    /// Cost: that of the edits and walks.
    pub fn play(&self, mut watch: impl FnMut(Step<Call<G>>, &G) -> ControlFlow<()>) -> G {
        let mut stage = Stage {
            ground: self.start.clone(),
            names: self.names.iter().map(|name| Bound::Refused { line: name.line }).collect(),
            holders: BTreeMap::new(),
            gone: BTreeMap::new(),
        };
        for (statement, said) in self.statements.iter().enumerate() {
            let outcome = stage.act(said).unwrap_or_else(|reason| Outcome::Refused { edit: None, reason });
            if watch(Step { statement, outcome }, &stage.ground).is_break() {
                break;
            }
        }
        stage.ground
    }
}

/// What a name stands for.
#[derive(Clone, Copy)]
enum Bound {
    To(Element),
    Gone { element: Element, line: u32 },
    Refused { line: u32 },
}

struct Stage<G> {
    ground: G,
    names: Vec<Bound>,
    /// The names of each element that has some.
    holders: BTreeMap<Element, Vec<usize>>,
    /// Given elements that were removed, with the line that did it.
    gone: BTreeMap<Element, u32>,
}

impl<G: Editable> Stage<G> {
    fn act(&mut self, said: &Statement) -> Result<Outcome<Call<G>>, Refusal> {
        Ok(match &said.action {
            Action::Edit { row, arguments, name } => {
                let resolved = arguments.iter().map(|value| match value {
                    Value::Element(path) => self.resolve(path).map(Argument::Element),
                    Value::Plain(argument) => Ok(*argument),
                });
                self.edit(Call::unchecked(row, resolved.collect::<Result<_, _>>()?), said.line, *name)
            }
            Action::Name { path, name } => {
                let element = self.resolve(path)?;
                self.bind(*name, element);
                Outcome::Named(element)
            }
            Action::WalkFace(path) => {
                let h = self.half_edge(path)?;
                let cycle = self.ground.topology().cycle(h).map(|h| (h, self.ground.topology().origin(h))).collect();
                Outcome::WalkedFace { face: self.ground.topology().face(h), cycle }
            }
            Action::WalkVertex(path) => {
                let (vertex, start) = match self.resolve(path)? {
                    Element::Vertex(v) => (v, self.ground.topology().outgoing(v)),
                    _ => {
                        let h = self.half_edge(path)?;
                        (self.ground.topology().origin(h), Some(h))
                    }
                };
                let star = start.into_iter().flat_map(|h| self.ground.topology().star(h));
                let star = star.map(|h| (h, self.ground.topology().destination(h))).collect();
                Outcome::WalkedVertex { vertex, star }
            }
            Action::Highlight(paths) => {
                Outcome::Highlighted(paths.iter().map(|path| self.resolve(path)).collect::<Result<_, _>>()?)
            }
            Action::Caption(text) => Outcome::Caption(text.clone()),
            Action::Dump => Outcome::Dump,
        })
    }

    fn edit(&mut self, edit: Call<G>, line: u32, name: Option<usize>) -> Outcome<Call<G>> {
        let mut log = G::Log::default();
        let returned = match edit.apply(&mut self.ground, &mut log) {
            Ok(returned) => returned,
            Err(reason) => return Outcome::Refused { edit: Some(edit), reason: reason.into() },
        };
        let journal = G::pointers(log);
        for change in journal.changes() {
            if let Change::Removed { element } = *change {
                self.remove(element, line);
            }
        }
        if let (Some(name), Some(element)) = (name, returned.named()) {
            self.bind(name, element);
        }
        Outcome::Edited { edit, returned, journal }
    }

    fn bind(&mut self, name: usize, element: Element) {
        self.names[name] = Bound::To(element);
        self.holders.entry(element).or_default().push(name);
    }

    fn remove(&mut self, element: Element, line: u32) {
        let mut all = vec![element];
        if let Element::Edge(e) = element {
            all.extend(e.half_edges().map(Element::from));
        }
        for element in all {
            self.gone.entry(element).or_insert(line);
            for name in self.holders.remove(&element).unwrap_or_default() {
                self.names[name] = Bound::Gone { element, line };
            }
        }
    }

    /// The half-edge of a path; that of a vertex is its `outgoing`, that of a face its `half_edge`.
    fn half_edge(&self, path: &Path) -> Result<HalfEdgeId, Refusal> {
        let element = self.resolve(path)?;
        let (target, link) = match element {
            Element::HalfEdge(h) => (Some(h), Link::Next),
            Element::Vertex(v) => (self.ground.topology().outgoing(v), Link::Outgoing),
            Element::Face(f) => (self.ground.topology().half_edge(f), Link::HalfEdge),
            Element::Edge(e) => (Some(e.half_edges()[0]), Link::Edge),
        };
        target.ok_or_else(|| Refusal::NoTarget { word: path.text.clone(), element, link })
    }

    fn resolve(&self, path: &Path) -> Result<Element, Refusal> {
        let gone = |element, line| Refusal::Gone { word: path.text.clone(), element, line };
        let start = match path.base {
            Base::Given(element) => match self.gone.get(&element) {
                Some(&line) => return Err(gone(element, line)),
                None => element,
            },
            Base::Named(name) => match self.names[name] {
                Bound::To(element) => element,
                Bound::Gone { element, line } => return Err(gone(element, line)),
                Bound::Refused { line } => return Err(Refusal::Unnamed { word: path.text.clone(), line }),
            },
        };
        path.links.iter().try_fold(start, |element, &link| {
            let no_target = || Refusal::NoTarget { word: path.text.clone(), element, link };
            follow(self.ground.topology(), element, link).ok_or_else(no_target)
        })
    }
}
