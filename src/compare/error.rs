//! Why a file cannot be compared, and where.
//!
//! ```text
//!   student:12:5: `abc` is not a number: write cx as a number such as 12.5
//!   └ file ┘ └ line:column, both from 1, the column in characters
//! ```

use std::fmt;

/// One of the two drawings.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Side {
    /// What is expected.
    Reference,
    /// What was handed in.
    Student,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Reference { "reference" } else { "student" })
    }
}

/// A file that cannot be compared. Prints as `student:line:column: problem`.
#[derive(Debug, Clone, PartialEq)]
pub struct CompareError {
    /// Which of the two files.
    pub side: Side,
    /// Line and column, from 1, where there is a place.
    pub place: Option<(u32, u32)>,
    /// What is wrong.
    pub problem: Problem,
}

impl CompareError {
    /// The same with the name of the file: `map.svg:12:5: problem`.
    #[must_use]
    pub fn named(&self, file: &str) -> String {
        match self.place {
            Some((line, column)) => format!("{file}:{line}:{column}: {}", self.problem),
            None => format!("{file}: {}", self.problem),
        }
    }
}

impl fmt::Display for CompareError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.named(&self.side.to_string()))
    }
}

impl std::error::Error for CompareError {}

/// What can be wrong with a file that is to be compared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// No text at all.
    #[error("the file is empty")]
    Empty,
    /// A compressed file.
    #[error("this is a compressed file (gzip, .svgz): unpack it first")]
    Compressed,
    /// Text in another encoding.
    #[error("this is {encoding}: save the file as UTF-8")]
    Encoding {
        /// What it seems to be.
        encoding: &'static str,
    },
    /// More bytes, elements or lines than are read.
    #[error("too large: more than {limit} {what}")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How much is read.
        limit: usize,
    },
    /// Elements inside elements, or `use` of `use`, without end.
    #[error("nested too deeply: more than {limit} levels of elements and `use`")]
    TooDeep {
        /// How deep is read.
        limit: usize,
    },
    /// Not well-formed XML.
    #[error("not well-formed XML: {message}")]
    Xml {
        /// The parser's words.
        message: String,
    },
    /// A document type that declares something, such as entities.
    #[error("a DOCTYPE with declarations ([ ... ]) is not read: delete that line")]
    DocumentType,
    /// Code inside the drawing.
    #[error("{what} is not read: a drawing for comparison holds no scripts")]
    Script {
        /// The element or attribute.
        what: String,
    },
    /// A rule of a style sheet that hides, and of which it cannot be said what.
    #[error("the style rule `{selector}` hides something, and {}", untold(selector))]
    StyleRule {
        /// Its selector, shortened.
        selector: String,
    },
    /// A rule of a style sheet that changes how something looks, and of which it cannot be said what.
    #[error("the style rule `{selector}` changes what is seen, and {}", untold(selector))]
    StyleChange {
        /// Its selector, shortened.
        selector: String,
    },
    /// A value of a property that browsers work out and a comparison does not.
    #[error(
        "`{declaration}` is not worked out here, and it may change what is seen: write a plain value, such as {such}"
    )]
    StyleValue {
        /// The property and its value, shortened.
        declaration: String,
        /// What could stand there.
        such: &'static str,
    },
    /// A style sheet that is no part of the file.
    #[error(
        "{what} brings in a style sheet from outside of the drawing, which is not read: write its rules in a <style>"
    )]
    StyleSheet {
        /// The element or instruction.
        what: &'static str,
    },
    /// An animation of something that is compared.
    #[error(
        "<{element}> changes {what} after a moment, and a comparison looks at one moment only: take it out, or compare \
         the picture without motion"
    )]
    Animation {
        /// The element that animates.
        element: String,
        /// The attribute that it changes, and of which element.
        what: String,
    },
    /// A box of another language than SVG that may cover what lies round it.
    #[error(
        "<foreignObject> holds {what}, which may cover lines, and overflow: visible lets it reach beyond its box: take \
         that out, or write the label as <text>"
    )]
    Foreign {
        /// What may cover.
        what: String,
    },
    /// The root is no `svg` element.
    #[error("the first element is <{name}>, not <svg>: this is no SVG drawing")]
    NotSvg {
        /// Its name.
        name: String,
    },
    /// A root without width or height.
    #[error("width, height or viewBox of <svg> has a side of 0: nothing of the drawing is shown")]
    NotShown,
    /// An attribute that cannot be understood.
    #[error("`{word}` is no {wanted}")]
    Word {
        /// The word, shortened.
        word: String,
        /// What should stand there.
        wanted: &'static str,
    },
    /// A number that no drawing needs.
    #[error("a coordinate of this {what} is not finite or beyond a thousand million px")]
    Coordinate {
        /// The element.
        what: &'static str,
    },
    /// Two elements with one name.
    #[error("{element} is declared twice, first in line {first}: give each element an id of its own")]
    DeclaredTwice {
        /// The element.
        element: String,
        /// The line of the first.
        first: u32,
    },
    /// An id that would need an enormous table.
    #[error("the number of {element} is too large: number the elements from 0")]
    Number {
        /// The element.
        element: String,
    },
    /// The reference itself breaks an invariant or draws something else than it declares.
    #[error("the reference cannot be used: {reason}")]
    Reference {
        /// Why.
        reason: String,
    },
    /// Names were to be compared, and a file declares none.
    #[error(
        "names cannot be compared: this drawing declares none in data-* attributes (draw it with dcel figure, or leave \
         --names out)"
    )]
    NoNames,
    /// A line or a circle of the drawing behind a mask or a filter.
    #[error("{what} has a mask, a filter or a blend mode, and what that hides is not worked out here: leave it out")]
    Veil {
        /// The edge or vertex, with its place.
        what: String,
    },
    /// The reference has nothing to compare with.
    #[error("nothing is drawn here: no line, circle or filled polygon was found")]
    Nothing,
    /// Points so close together that the tolerance cannot tell them apart.
    #[error(
        "two points of the reference, at {first} and {second}, are closer than four times the tolerance: draw it \
         larger, or give a smaller tolerance"
    )]
    TooClose {
        /// One point.
        first: String,
        /// The other.
        second: String,
    },
}

/// What cannot be told of a style rule or of a block of them, and what to write in its place.
fn untold(selector: &str) -> &'static str {
    if selector.starts_with('@') {
        "whether it applies is not worked out here: write its rules outside of it"
    } else {
        "what it fits cannot be told: use ids, classes and names of elements, or attributes"
    }
}

/// A problem at a byte of the text.
#[derive(Debug)]
pub(super) struct Fault {
    pub(super) at: Option<usize>,
    pub(super) problem: Problem,
}

impl Fault {
    pub(super) fn at(offset: usize, problem: Problem) -> Self {
        Self { at: Some(offset), problem }
    }

    /// Refuses more of something than may be there.
    pub(super) fn if_more(count: usize, limit: usize, what: &'static str, offset: usize) -> Result<(), Self> {
        if count > limit { Err(Self::at(offset, Problem::TooLarge { what, limit })) } else { Ok(()) }
    }

    /// Refuses elements that lie within too many others.
    pub(super) fn if_deeper(depth: usize, limit: usize, offset: usize) -> Result<(), Self> {
        if depth > limit { Err(Self::at(offset, Problem::TooDeep { limit })) } else { Ok(()) }
    }

    /// The error, with the place counted in the text.
    pub(super) fn located(self, side: Side, text: &str) -> CompareError {
        CompareError { side, place: self.at.map(|offset| place(text, offset)), problem: self.problem }
    }
}

impl From<Problem> for Fault {
    fn from(problem: Problem) -> Self {
        Self { at: None, problem }
    }
}

/// Line and column of a byte. O(offset).
pub(super) fn place(text: &str, offset: usize) -> (u32, u32) {
    let before = text.get(..offset).unwrap_or(text);
    let start = before.rfind('\n').map_or(0, |i| i + 1);
    let line = before.bytes().filter(|&b| b == b'\n').count() as u32 + 1;
    (line, before[start..].chars().count() as u32 + 1)
}

/// A word for a message, short.
pub(super) fn quoted(word: &str) -> String {
    crate::figure::canvas::text::shortened(&crate::figure::canvas::text::clean(word.trim()), 40)
}
