//! A case: a start, then calls, as text for a driver.

use crate::cases::large;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::fmt::{Display, Write};
use std::sync::Arc;

/// What a case begins with.
#[derive(Clone, PartialEq, Debug)]
pub enum Start {
    /// The six-vertex rectangle of the lab.
    Rectangle,
    /// A polygon by its corners, counter-clockwise.
    Polygon(Vec<[f64; 2]>),
    /// Triangles: points, then corners by number.
    Triangles(Vec<[f64; 2]>, Vec<[u32; 3]>),
    /// A convex polygon with so many corners.
    Convex(usize),
    /// So many triangles round one vertex.
    Wheel(usize),
    /// So many columns and rows of square cells.
    Grid(usize, usize),
    /// Any structure, as the lines of a dump.
    Table(Arc<Table>),
}

impl Start {
    /// The structure, if it need not be printed to be known: that of a number of corners, spokes or cells, and a table.
    ///
    /// Cost: linear, once for each size of a grid.
    #[must_use]
    pub fn table(&self) -> Option<Arc<Table>> {
        match self {
            Self::Convex(corners) => Some(Arc::new(large::convex(*corners))),
            Self::Wheel(spokes) => Some(Arc::new(large::wheel(*spokes))),
            Self::Grid(columns, rows) => Some(large::grid(*columns, *rows)),
            Self::Table(table) => Some(Arc::clone(table)),
            Self::Rectangle | Self::Polygon(_) | Self::Triangles(..) => None,
        }
    }

    /// How to show the structure after it: of a large one only what has changed.
    #[must_use]
    pub fn dump(&self) -> Step {
        match self {
            Self::Grid(columns, rows) if columns * rows > LARGE => Step::Changes,
            _ => Step::Dump,
        }
    }
}

/// Grids with more cells are never printed whole.
const LARGE: usize = 2000;

/// A line after the start.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Step {
    /// A call of one of the student's functions; the arguments are words such as `h0.next`.
    Call {
        /// The function.
        function: String,
        /// Its arguments.
        arguments: Vec<String>,
    },
    /// The structure is to be printed.
    Dump,
    /// What has changed since it was printed last, or since the start, is to be printed.
    Changes,
    /// The number of records that the last call looked at is to be printed.
    Reads,
    /// A function of one element is to be called for many elements, evenly spread over all.
    Many {
        /// The function.
        function: String,
        /// For how many.
        count: usize,
        /// How many records they may look at together; then no more are asked.
        budget: u64,
    },
    /// The student's program is to draw the structure.
    Svg,
    /// The structure is to be remembered.
    Save,
    /// The remembered structure is to come back.
    Restore,
}

impl Step {
    /// A call with the words of its arguments.
    pub fn call<W: Display>(function: &str, arguments: impl IntoIterator<Item = W>) -> Self {
        let arguments = arguments.into_iter().map(|word| word.to_string()).collect();
        Self::Call { function: function.to_owned(), arguments }
    }

    /// Whether the structure is shown.
    #[must_use]
    pub fn shows(&self) -> bool {
        matches!(self, Self::Dump | Self::Changes)
    }

    /// Whether it is answered.
    #[must_use]
    pub fn is_answered(&self) -> bool {
        !matches!(self, Self::Save | Self::Restore)
    }
}

/// A start and what to do with it.
#[derive(Clone, PartialEq, Debug)]
pub struct Case {
    /// Its name: letters, digits, `_`, `.` and `-`.
    pub name: String,
    /// What it begins with.
    pub start: Start,
    /// The lines after that.
    pub steps: Vec<Step>,
}

impl Case {
    /// A case without any step yet.
    pub fn new(name: impl Into<String>, start: Start) -> Self {
        Self { name: name.into(), start, steps: Vec::new() }
    }

    /// Adds a step.
    #[must_use]
    pub fn step(mut self, step: Step) -> Self {
        self.steps.push(step);
        self
    }

    /// The shortest case with the same structure before step `at` and the same step `at`, and the number of the
    /// step in it: what was done and undone by `save` and `restore` is left out, and so are calls that only read
    /// (no dump follows them), and other dumps than the one just before. If a call changes the structure, a `dump`
    /// should follow: `with_dump`.
    #[must_use]
    pub fn reduced_to(&self, at: usize, with_dump: bool) -> (Self, usize) {
        let mut steps: Vec<Step> = Vec::new();
        let mut saved = 0;
        for (i, step) in self.steps.iter().enumerate().take(at) {
            match step {
                Step::Save => saved = steps.len(),
                Step::Restore => steps.truncate(saved),
                Step::Call { .. } if self.steps.get(i + 1).is_some_and(Step::shows) => steps.push(step.clone()),
                _ => {}
            }
        }
        steps.push(self.start.dump());
        let place = steps.len();
        steps.extend(self.steps.get(at).filter(|step| step.is_answered()).cloned());
        if with_dump {
            steps.push(self.start.dump());
        }
        (Self { name: self.name.clone(), start: self.start.clone(), steps }, place)
    }

    /// The lines of the case without its name: what a student types.
    #[must_use]
    pub fn script(&self) -> String {
        let mut out = String::new();
        self.write_start(&mut out);
        for step in &self.steps {
            step.write(&mut out);
        }
        out
    }

    /// All cases as one input.
    pub fn input<'a>(token: &str, cases: impl IntoIterator<Item = &'a Self>) -> String {
        let mut out = format!("token {token}\n");
        for case in cases {
            let _ = writeln!(out, "case {}", case.name);
            case.write_start(&mut out);
            case.steps.iter().for_each(|step| step.write(&mut out));
        }
        out
    }

    fn write_start(&self, out: &mut String) {
        let points = |out: &mut String, points: &[[f64; 2]]| {
            for [x, y] in points {
                let _ = write!(out, " {x} {y}");
            }
        };
        match &self.start {
            Start::Rectangle => out.push_str("rectangle"),
            Start::Polygon(corners) => {
                out.push_str("polygon");
                points(out, corners);
            }
            Start::Triangles(places, triangles) => {
                out.push_str("triangles");
                points(out, places);
                out.push_str(" /");
                for [i, j, k] in triangles {
                    let _ = write!(out, " {i} {j} {k}");
                }
            }
            Start::Convex(corners) => {
                let _ = write!(out, "convex {corners}");
            }
            Start::Wheel(spokes) => {
                let _ = write!(out, "wheel {spokes}");
            }
            Start::Grid(columns, rows) => {
                let _ = write!(out, "grid {columns} {rows}");
            }
            Start::Table(table) => {
                out.push_str("table\n");
                write_dump(table, out);
                out.push_str("end_table");
            }
        }
        out.push('\n');
    }
}

impl Step {
    fn write(&self, out: &mut String) {
        match self {
            Self::Call { function, arguments } => {
                out.push_str(function);
                for word in arguments {
                    out.push(' ');
                    out.push_str(word);
                }
            }
            Self::Dump => out.push_str("dump"),
            Self::Changes => out.push_str("dump changes"),
            Self::Reads => out.push_str("reads"),
            Self::Many { function, count, budget } => {
                let _ = write!(out, "many {count} {function} {budget}");
            }
            Self::Svg => out.push_str("svg"),
            Self::Save => out.push_str("save"),
            Self::Restore => out.push_str("restore"),
        }
        out.push('\n');
    }
}

/// The records of a table, one a line, as a driver prints and reads them. Tables with gaps have no such text:
/// the lab's structures never lose an element.
fn write_dump(table: &Table, out: &mut String) {
    let number = |n: Option<u32>| n.map_or_else(|| "-".to_owned(), |n| n.to_string());
    let half_edge = |h: Option<HalfEdgeId>| number(h.map(HalfEdgeId::number));
    let face = |f: Option<FaceId>| number(f.map(FaceId::number));
    let _ = writeln!(out, "outer {}", face(table.outer_face()));
    for (i, row) in table.vertices.iter().flatten().enumerate() {
        let [x, y] = row.position.unwrap_or_default();
        let _ = writeln!(out, "vertex {i} {x} {y} {}", half_edge(row.outgoing));
    }
    for (i, row) in table.half_edges.iter().flatten().enumerate() {
        let [twin, next, prev] = [row.twin, row.next, row.prev].map(half_edge);
        let origin = number(row.origin.map(VertexId::number));
        let _ = writeln!(out, "half_edge {i} {origin} {twin} {next} {prev} {}", face(row.face));
    }
    for (i, row) in table.faces.iter().flatten().enumerate() {
        let _ = writeln!(out, "face {i} {}", half_edge(row.boundary));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn calls(words: &[&str]) -> Vec<Step> {
        let step = |word: &&str| match *word {
            "save" => Step::Save,
            "restore" => Step::Restore,
            "dump" => Step::Dump,
            word => Step::call("split_in_half", [word]),
        };
        words.iter().map(step).collect()
    }

    #[test]
    fn a_case_is_reduced_to_what_leads_to_a_step() {
        let steps =
            calls(&["h0", "dump", "save", "h2", "dump", "restore", "h4", "dump", "restore", "h9", "h6", "dump"]);
        let case = Case { steps, ..Case::new("x", Start::Rectangle) };
        let (reduced, at) = case.reduced_to(10, true);
        assert_eq!(reduced.script(), "rectangle\nsplit_in_half h0\ndump\nsplit_in_half h6\ndump\n");
        assert_eq!(at, 2);
        assert_eq!(case.reduced_to(0, false).0.script(), "rectangle\ndump\nsplit_in_half h0\n");
    }
}
