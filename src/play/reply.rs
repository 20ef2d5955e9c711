//! What the page says to a session, and what it hears: JSON on both sides.

use crate::ids::Element;
pub(super) use crate::script::element;
use serde::{Deserialize, Serialize};

/// What the page asks for.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Action {
    /// Everything anew: after the page was loaded.
    Show,
    /// The room for the picture in px.
    Resize {
        /// Its width.
        width: f64,
        /// Its height.
        height: f64,
    },
    /// A scene to begin with: `rectangle`, `torus`, `points`, or a solid such as `cube` in its Schlegel diagram.
    Start {
        /// Which.
        what: String,
    },
    /// A polygon by the places that were clicked.
    Polygon {
        /// The places in the picture.
        places: Vec<[f64; 2]>,
    },
    /// The corners of a polygon that is being clicked.
    Outline {
        /// The places in the picture.
        places: Vec<[f64; 2]>,
    },
    /// A whole script, or one line of it.
    Script {
        /// Its text.
        text: String,
    },
    /// The scene of a link, without its `#`.
    Link {
        /// The text behind the `#`.
        text: String,
    },
    /// A click at a place of the picture.
    Click {
        /// To the right, in px of the picture.
        x: f64,
        /// Down.
        y: f64,
        /// How far a vertex or an edge may be.
        reach: f64,
    },
    /// What lies at a place: for the mouse that moves.
    Hover {
        /// To the right.
        x: f64,
        /// Down.
        y: f64,
        /// How far a vertex or an edge may be.
        reach: f64,
    },
    /// A click on an element: of a table, or by the keyboard.
    Pick {
        /// Its id.
        id: String,
    },
    /// Nothing is selected any more.
    Leave,
    /// From the selected element along a link: `next`, `twin` …
    Follow {
        /// The link.
        link: String,
    },
    /// A path such as `h2.next.twin`.
    Walk {
        /// The path.
        path: String,
    },
    /// An edit of what is selected, by its word.
    Edit {
        /// The word.
        word: String,
    },
    /// A vertex is held over a place.
    Drag {
        /// The vertex.
        id: String,
        /// To the right.
        x: f64,
        /// Down.
        y: f64,
    },
    /// A vertex is let go at a place.
    Drop {
        /// The vertex.
        id: String,
        /// To the right.
        x: f64,
        /// Down.
        y: f64,
    },
    /// A vertex is moved by steps of the keyboard.
    Nudge {
        /// The vertex.
        id: String,
        /// Steps to the right.
        x: f64,
        /// Steps up.
        y: f64,
    },
    /// Takes the last edit back.
    Undo,
    /// Makes it again.
    Redo,
    /// A pointer is to lead elsewhere, whatever the invariants say.
    Break {
        /// The element whose pointer it is.
        id: String,
        /// Which pointer.
        pointer: String,
        /// Where it is to lead; `none` for nowhere.
        to: String,
    },
    /// All pointers lead again where they should.
    Mend,
    /// What is drawn over points: `delaunay`, `circles` or `voronoi`.
    Over {
        /// Which.
        what: String,
    },
    /// The triangulation of the points becomes a structure to edit.
    Keep,
    /// A file of the scene: `svg`, `dcel`, `script`, `film`, or `play`, the film of the last edit.
    Export {
        /// Which.
        what: String,
    },
    /// A quiz begins.
    Quiz {
        /// `where_am_i`, `make_drawing`, `find_fault` or `predict`.
        what: String,
        /// From 1 to 3.
        level: u32,
        /// The same seed, the same questions.
        seed: u64,
    },
    /// An answer: an element, a pointer (`h3.next`), or the number of a choice.
    Answer {
        /// The answer.
        answer: String,
    },
    /// The next question.
    Next,
    /// The quiz ends, and the scene before it is back.
    Quit,
    /// What a result code says.
    Code {
        /// The code.
        code: String,
    },
}

/// What has changed. What is not there has not.
#[derive(Clone, PartialEq, Debug, Default, Serialize)]
pub struct Reply {
    /// The picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub svg: Option<String>,
    /// What is drawn over the picture, in its coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over: Option<String>,
    /// The tables, as HTML.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tables: Option<String>,
    /// Counts and invariants.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub status: Option<Status>,
    /// The lines of the script, each with what it returned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub script: Option<Vec<[String; 2]>>,
    /// The scene as a link, without `#`; empty if it is too long for one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
    /// What is selected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub selected: Option<Selected>,
    /// What lies under the mouse: an id, or nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hover: Option<String>,
    /// A sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<Message>,
    /// Elements along a walk, in order.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trail: Option<Vec<String>>,
    /// A file to be kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<File>,
    /// The quiz.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quiz: Option<Question>,
}

/// What kind of sentence it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Tone {
    /// Something was done.
    Done,
    /// Something was refused.
    Refused,
    /// Something to know.
    Note,
    /// The answer was right.
    Right,
}

/// A sentence with the elements that it names.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Message {
    /// What kind of sentence.
    pub tone: Tone,
    /// The sentence.
    pub text: String,
    /// The elements that it names.
    pub elements: Vec<String>,
}

impl Message {
    /// A sentence; the elements are those that it names.
    pub(super) fn new(tone: Tone, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { tone, elements: named(&text).iter().map(ToString::to_string).collect(), text }
    }
}

/// The elements that a sentence names.
pub(super) fn named(text: &str) -> Vec<Element> {
    let mut out: Vec<Element> = Vec::new();
    for word in text.split(|c: char| !c.is_alphanumeric() && c != '_') {
        if let Some(element) = element(word)
            && !out.contains(&element)
        {
            out.push(element);
        }
    }
    out
}

/// Counts and invariants of a scene.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Status {
    /// `6 vertices, 6 edges, 2 faces`.
    pub counts: String,
    /// Euler's relation with its numbers.
    pub euler: String,
    /// Each broken invariant; empty if all hold.
    pub violations: Vec<Message>,
    /// What kind of scene: `plane`, `kernel`, `points` or `broken`.
    pub scene: &'static str,
    /// Whether there is something to undo, and to redo.
    pub history: [bool; 2],
    /// What is drawn over points.
    pub over: &'static str,
}

/// What is selected, and what can be done with it.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Selected {
    /// The ids.
    pub ids: Vec<String>,
    /// The element in words: `half-edge h3`.
    pub title: String,
    /// Its pointers, each with what it leads to.
    pub pointers: Vec<[String; 2]>,
    /// The edits that can be tried: word, text of the button, what it does.
    pub edits: Vec<[String; 3]>,
    /// The edit that waits for a second element, if one does.
    pub waiting: String,
}

/// A file to be kept.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct File {
    /// Its name.
    pub name: String,
    /// Its kind, as browsers call it.
    pub mime: &'static str,
    /// What it holds.
    pub text: String,
}

/// Where a quiz stands.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Question {
    /// Which quiz; empty when none is on.
    pub what: String,
    /// Its name.
    pub title: String,
    /// What to do.
    pub text: String,
    /// Answers to choose from, if it is a choice.
    pub choices: Vec<String>,
    /// A picture of what is to be made.
    pub target: String,
    /// `question 2 of 5, 1 right`
    pub score: String,
    /// Whether this question is answered.
    pub answered: bool,
    /// The code of the result once the round is over.
    pub code: String,
}
