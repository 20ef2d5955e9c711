//! A row of the table with its arguments: one call of an edit.

use super::arguments::{Argument, Arguments};
use super::kind::{Kind, Takes};
use super::returned::{EditError, Returned};
use super::row::Row;
use super::structure::Editable;
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use std::fmt;
use std::marker::PhantomData;
use std::str::FromStr;

/// A call of an edit on a structure `S`, with its arguments resolved to ids.
#[derive(Clone, PartialEq)]
pub struct Call<S> {
    row: &'static Row,
    arguments: Vec<Argument>,
    on: PhantomData<fn(&mut S)>,
}

/// Why there is no such call.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CallError {
    /// The structure has no edit with this word.
    #[error("{structure} has no edit `{word}`; known: {known}")]
    Unknown {
        /// The word.
        word: String,
        /// The structure.
        structure: &'static str,
        /// The words it has.
        known: String,
    },
    /// Too few arguments, too many, or of the wrong kind.
    #[error("`{call}` does not fit; write {usage}")]
    Misfit {
        /// The call.
        call: String,
        /// How it is written.
        usage: String,
    },
}

impl<S: Editable> Call<S> {
    /// The call of a row with these arguments.
    ///
    /// # Errors
    /// [`CallError`] if the structure does not have the edit, or the arguments are not those that it takes.
    pub fn new(row: &'static Row, arguments: impl IntoIterator<Item = Argument>) -> Result<Self, CallError> {
        let call = Self::unchecked(row, arguments.into_iter().collect());
        if S::column(row).is_none() {
            return Err(unknown::<S>(row.word));
        }
        if call.fits() {
            return Ok(call);
        }
        Err(CallError::Misfit { call: call.to_string(), usage: row.usage::<S>() })
    }

    pub(crate) fn unchecked(row: &'static Row, arguments: Vec<Argument>) -> Self {
        Self { row, arguments, on: PhantomData }
    }

    fn fits(&self) -> bool {
        let mut rest = self.arguments.iter().peekable();
        let is_vertex = |argument: &&Argument| matches!(argument, Argument::Element(Element::Vertex(_)));
        let all = self.row.takes_on::<S>().all(|takes| match takes {
            Takes::Element(kind) => {
                rest.next_if(|a| matches!(a, Argument::Element(e) if Kind::of(*e) == kind)).is_some()
            }
            Takes::Place => rest.next_if(|a| matches!(a, Argument::Place(_))).is_some(),
            Takes::Number | Takes::Map => rest.next_if(|a| matches!(a, Argument::Number(_))).is_some(),
            Takes::Switch => rest.next_if(|a| matches!(a, Argument::Switch(_))).is_some(),
            Takes::Vertices => {
                let some = rest.next_if(is_vertex).is_some();
                while rest.next_if(is_vertex).is_some() {}
                some
            }
        });
        all && rest.next().is_none()
    }

    /// The row of the table.
    #[must_use]
    pub fn row(&self) -> &'static Row {
        self.row
    }

    /// The arguments, in order.
    #[must_use]
    pub fn arguments(&self) -> &[Argument] {
        &self.arguments
    }

    /// The elements among its arguments, in order.
    #[must_use]
    pub fn elements(&self) -> Vec<Element> {
        let element = |argument: &Argument| if let Argument::Element(x) = *argument { Some(x) } else { None };
        self.arguments.iter().filter_map(element).collect()
    }

    /// Makes the call; `log` gets every change. Cost: that of the edit.
    ///
    /// # Errors
    /// Those of the edit; a refused call leaves everything bit for bit as it was.
    pub fn apply(&self, structure: &mut S, log: &mut S::Log) -> Result<Returned, EditError> {
        let column = S::column(self.row).ok_or_else(|| EditError::new(unknown::<S>(self.row.word)))?;
        let mut arguments = Arguments::new(&self.arguments, S::DIMENSION);
        Ok(column(structure, &mut arguments, log)?.named_by(self.row.names()))
    }

    /// Writes an argument as a script says it; elements by `name`.
    pub(crate) fn write_with(&self, mut name: impl FnMut(Element) -> Option<String>) -> Result<String, Element> {
        let mut out = self.row.word.to_owned();
        for argument in &self.arguments {
            match *argument {
                Argument::Element(element) => {
                    out.push(' ');
                    out.push_str(&name(element).ok_or(element)?);
                }
                Argument::Place(place) => place[..S::DIMENSION].iter().for_each(|x| out.push_str(&format!(" {x}"))),
                Argument::Number(number) => out.push_str(&format!(" {number}")),
                Argument::Switch(yes) => out.push_str(if yes { " yes" } else { " no" }),
            }
        }
        Ok(out)
    }
}

impl<S: Editable> fmt::Display for Call<S> {
    /// `split_face h2 h8`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.write_with(|element| Some(element.to_string()));
        f.write_str(&text.unwrap_or_default())
    }
}

impl<S: Editable> fmt::Debug for Call<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<S: Editable> FromStr for Call<S> {
    type Err = CallError;

    /// Reads what [`Display`](fmt::Display) writes.
    fn from_str(text: &str) -> Result<Self, CallError> {
        let mut words = text.split_whitespace();
        let word = words.next().unwrap_or("");
        let row = super::find::<S>(word).ok_or_else(|| unknown::<S>(word))?;
        let misfit = || CallError::Misfit { call: text.to_owned(), usage: row.usage::<S>() };
        let mut arguments = Vec::new();
        for takes in row.takes_on::<S>() {
            let mut number = || words.next().and_then(|word| word.parse::<f64>().ok()).ok_or_else(misfit);
            arguments.push(match takes {
                Takes::Place => {
                    let mut place = [0.0; 3];
                    for x in &mut place[..S::DIMENSION] {
                        *x = number()?;
                    }
                    Argument::Place(place)
                }
                Takes::Number | Takes::Map => Argument::Number(number()?),
                Takes::Switch => Argument::Switch(words.next().and_then(switch).ok_or_else(misfit)?),
                Takes::Element(kind) => element_of(kind, words.next().unwrap_or("")).ok_or_else(misfit)?,
                Takes::Vertices => {
                    for word in words.by_ref() {
                        arguments.push(element_of(Kind::Vertex, word).ok_or_else(misfit)?);
                    }
                    continue;
                }
            });
        }
        if words.next().is_some() {
            return Err(misfit());
        }
        Self::new(row, arguments)
    }
}

/// The words of a switch.
pub(crate) fn switch(word: &str) -> Option<bool> {
    match word {
        "yes" => Some(true),
        "no" => Some(false),
        _ => None,
    }
}

fn element_of(kind: Kind, word: &str) -> Option<Argument> {
    element(word).filter(|&element| Kind::of(element) == kind).map(Argument::from)
}

/// `h3`, `v0`, `e1` or `f2`.
pub(crate) fn element(word: &str) -> Option<Element> {
    let half_edge = || word.parse::<HalfEdgeId>().map(Element::from);
    let vertex = || word.parse::<VertexId>().map(Element::from);
    let edge = || word.parse::<EdgeId>().map(Element::from);
    let face = || word.parse::<FaceId>().map(Element::from);
    half_edge().or_else(|_| vertex()).or_else(|_| edge()).or_else(|_| face()).ok()
}

fn unknown<S: Editable>(word: &str) -> CallError {
    let known: Vec<&str> = super::rows_of::<S>().map(|row| row.word).collect();
    CallError::Unknown { word: word.to_owned(), structure: S::NAME, known: known.join(" ") }
}
