//! A driver in memory: it answers cases as the real one does, right by itself, and can be made wrong in any way.

use dcel_kit::plane::PlanarView;
use dcel_kit::script::Script;
use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{Element, FaceId, HalfEdgeId, Id, VertexId};
use dcel_lab::cases::starts;
use dcel_lab::checks::walks::{cycle, star};
use dcel_lab::courses::half_edge::spec::{self, TwinSide};
use dcel_lab::{End, Program, Ran};
use std::fmt::Write;
use std::sync::OnceLock;

/// What a call did.
pub(crate) struct Done {
    pub before: Table,
    pub after: Table,
    pub answer: Answer,
}

/// How a call ended.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Answer {
    Returned(String),
    Panicked(&'static str),
    /// Stopped by the count of its reads.
    Stopped(&'static str),
    /// The process ends here.
    Died(End),
}

/// Changes what a call did. Gets the function and its arguments.
pub(crate) type Twist = Box<dyn Fn(&str, &[u32], &mut Done) + Sync>;

/// The program.
pub(crate) struct Fake {
    /// Which half of the twin's side is new.
    pub side: TwinSide,
    pub twist: Twist,
    /// What happens to the whole output in the end.
    pub printed: Box<dyn Fn(String) -> String + Sync>,
}

impl Fake {
    pub(crate) fn right() -> Self {
        Self::twisted(|_, _, _| {})
    }

    pub(crate) fn twisted(twist: impl Fn(&str, &[u32], &mut Done) + Sync + 'static) -> Self {
        Self { side: TwinSide::Moved, twist: Box::new(twist), printed: Box::new(|out| out) }
    }
}

impl Program for Fake {
    fn run(&self, input: &str) -> Ran {
        let mut out = String::new();
        let end = Talk {
            fake: self,
            out: &mut out,
            table: Table::default(),
            saved: None,
            last: None,
            shown: Table::default(),
        }
        .all(input);
        let stdout = (self.printed)(out).into_bytes();
        Ran { stdout, stderr: Vec::new(), end, millis: 1 }
    }
}

struct Talk<'a> {
    fake: &'a Fake,
    out: &'a mut String,
    table: Table,
    saved: Option<Table>,
    last: Option<String>,
    shown: Table,
}

impl Talk<'_> {
    fn all(mut self, input: &str) -> End {
        let mut token = String::new();
        let mut case = None;
        let mut lines = input.lines();
        while let Some(line) = lines.next() {
            if let Some(name) = line.strip_prefix("token ") {
                token = format!("@{name} ");
                continue;
            }
            let mut said = String::new();
            let mut end = None;
            if let Some(name) = line.strip_prefix("case ") {
                if let Some(before) = case.replace(name) {
                    let _ = writeln!(said, "end_case {before}");
                }
                let _ = writeln!(said, "case {name}");
                self.last = None;
            } else if line == "table" {
                let records: Vec<&str> = lines.by_ref().take_while(|line| *line != "end_table").collect();
                self.table = table(&records);
            } else {
                end = self.line(line, &mut said);
            }
            for line in said.lines() {
                for words in ["\n", &token, line, "\n"] {
                    self.out.push_str(words);
                }
            }
            if let Some(end) = end {
                return end;
            }
        }
        if let Some(name) = case {
            let _ = writeln!(self.out, "{token}end_case {name}");
        }
        let _ = writeln!(self.out, "{token}done");
        End::Exited(0)
    }

    fn line(&mut self, line: &str, said: &mut String) -> Option<End> {
        let words: Vec<&str> = line.split(' ').collect();
        match words[0] {
            "rectangle" | "polygon" | "triangles" => self.table = start(line),
            "convex" | "wheel" | "grid" => {
                let number = |i: usize| words[i].parse().unwrap();
                let start = match words[0] {
                    "convex" => starts::convex(number(1)),
                    "wheel" => starts::wheel(number(1)),
                    _ => starts::grid(number(1), number(2)),
                };
                self.table = start.half_edges().unwrap().as_ref().clone();
                self.shown = self.table.clone();
            }
            "reads" => said.push_str("reads 9\n"),
            "many" => self.many(&words[1..], said),
            "dump" if words.len() == 2 => {
                let _ = write!(said, "dump changes\n{}end_dump\n", changes(&self.table, &self.shown));
                self.shown = self.table.clone();
                self.last = None;
            }
            "save" => self.saved = Some(self.table.clone()),
            "restore" => self.table = self.saved.clone().unwrap(),
            "dump" => {
                let dump = dump(&self.table);
                if self.last.as_ref() == Some(&dump) {
                    said.push_str("dump same\n");
                } else {
                    let _ = write!(said, "dump\n{dump}end_dump\n");
                    self.last = Some(dump);
                    self.shown = self.table.clone();
                }
            }
            "svg" => {
                let _ = write!(said, "call svg\nsvg\n{}end_svg\n", include_str!("../../figures/lab-04-drawing.svg"));
            }
            function => return self.call(function, &words[1..], said),
        }
        None
    }

    fn call(&mut self, function: &str, words: &[&str], said: &mut String) -> Option<End> {
        let mut arguments = Vec::new();
        for word in words {
            let Some(number) = resolve(&self.table, word) else {
                let _ = writeln!(said, "unresolved {word}");
                return None;
            };
            arguments.push(number);
        }
        let numbers: String = arguments.iter().map(|n| format!(" {n}")).collect();
        let _ = writeln!(said, "call {function}{numbers}");
        let before = self.table.clone();
        let (after, answer) = self.right(function, &arguments);
        let mut done = Done { before, after, answer: Answer::Returned(answer) };
        (self.fake.twist)(function, &arguments, &mut done);
        self.table = done.after;
        match done.answer {
            Answer::Returned(values) => {
                let _ = writeln!(said, "{}", format!("returned {values}").trim_end());
            }
            Answer::Panicked(message) => {
                let _ = writeln!(said, "panicked {message:?} src/lab.rs:7:9");
            }
            Answer::Stopped(reads) => {
                let _ = writeln!(said, "stopped {reads}");
            }
            Answer::Died(end) => return Some(end),
        }
        None
    }

    /// All answers are right, each for a read a value.
    fn many(&mut self, words: &[&str], said: &mut String) {
        let (count, function) = (words[0].parse::<usize>().unwrap(), words[1]);
        let table = std::mem::take(&mut self.table);
        let length = match function {
            "walk_vertex" => table.vertices.len(),
            "walk_face" | "walk_vertices" => table.faces.len(),
            _ => table.half_edges.len(),
        };
        let count = count.min(length);
        let answers: usize = (0..count)
            .map(|i| i * length / count)
            .map(|n| match function {
                "walk_vertex" => star(&table, table.outgoing(VertexId::new(n as u32)).unwrap()).len(),
                "walk_face" | "walk_vertices" => cycle(&table, table.half_edge(FaceId::new(n as u32)).unwrap()).len(),
                _ => 1,
            })
            .sum();
        self.table = table;
        let _ = writeln!(said, "call many {count} {function}");
        let _ = writeln!(said, "asked {count} answers {answers} reads {answers} most 9 h0 -");
    }

    fn right(&self, function: &str, arguments: &[u32]) -> (Table, String) {
        let table = self.table.clone();
        let h = |i: usize| HalfEdgeId::new(arguments[i]);
        let list = |walk: Vec<HalfEdgeId>| walk.iter().map(|h| h.number().to_string()).collect::<Vec<_>>().join(" ");
        match function {
            "split_face" => match spec::split_face(&table, h(0), h(1)) {
                Some((after, _)) => (after, "true".to_owned()),
                None => (table, "false".to_owned()),
            },
            "split_in_half" => {
                // Nothing can be told of a structure that a call before it has broken.
                let split = spec::split_in_half(&table, h(0), self.fake.side);
                (split.map_or(table, |(after, _)| after), String::new())
            }
            "walk_face" => {
                let walk = cycle(&table, table.half_edge(FaceId::new(arguments[0])).unwrap());
                (table, list(walk))
            }
            "walk_vertices" => {
                let walk = cycle(&table, table.half_edge(FaceId::new(arguments[0])).unwrap());
                let origins: Vec<String> =
                    walk.iter().map(|&h| table.origin(h).unwrap().number().to_string()).collect();
                (table, origins.join(" "))
            }
            "walk_vertex" => {
                let walk = star(&table, table.outgoing(VertexId::new(arguments[0])).unwrap());
                (table, list(walk))
            }
            "destination" => {
                let end = table.origin(table.twin(h(0)).unwrap()).unwrap().number().to_string();
                (table, end)
            }
            "destination_by_next" => {
                let end = table.origin(table.next(h(0)).unwrap()).unwrap().number().to_string();
                (table, end)
            }
            "drawing" => (start(include_str!("../../figures/scripts/lab-04-drawing.dcels")), String::new()),
            other => panic!("{other}"),
        }
    }
}

/// The structure that a script makes.
fn start(script: &str) -> Table {
    let end = Script::parse(script, "start").unwrap().run().end;
    let mut table = Table::from_view(&end);
    for (v, row) in table.vertices.iter_mut().enumerate() {
        let p = end.position(VertexId::new(v as u32)).unwrap();
        row.as_mut().unwrap().position = Some([p.x, p.y]);
    }
    table
}

fn resolve(table: &Table, word: &str) -> Option<u32> {
    let mut links = word.split('.');
    let base = links.next()?;
    let number = base[1..].parse().ok()?;
    let mut at = match &base[..1] {
        "h" => Element::HalfEdge(HalfEdgeId::new(number)),
        "v" => Element::Vertex(VertexId::new(number)),
        _ => Element::Face(FaceId::new(number)),
    };
    for link in links {
        at = match (at, link) {
            (Element::HalfEdge(h), "next") => table.next(h)?.into(),
            (Element::HalfEdge(h), "prev") => table.prev(h)?.into(),
            (Element::HalfEdge(h), "twin") => table.twin(h)?.into(),
            (Element::HalfEdge(h), "origin") => table.origin(h)?.into(),
            (Element::HalfEdge(h), "face") => table.face(h)?.into(),
            (Element::Vertex(v), "outgoing") => table.outgoing(v)?.into(),
            (Element::Face(f), "half_edge") => table.half_edge(f)?.into(),
            _ => panic!("{word}"),
        };
    }
    Some(match at {
        Element::HalfEdge(h) => h.number(),
        Element::Vertex(v) => v.number(),
        Element::Face(f) => f.number(),
        Element::Edge(e) => e.number(),
    })
}

/// Adds a reference, or `-`, and a blank before it. Most of what a program prints are references.
fn reference<T: Id>(out: &mut String, to: Option<T>) {
    const SMALL: usize = 100;
    static WORDS: OnceLock<Vec<String>> = OnceLock::new();
    let words = WORDS.get_or_init(|| (0..SMALL).map(|number| format!(" {number}")).collect());
    match to.map(T::index) {
        None => out.push_str(" -"),
        Some(number) if number < SMALL => out.push_str(&words[number]),
        Some(number) => out.push_str(&format!(" {number}")),
    }
}

fn dump(table: &Table) -> String {
    changes(table, &Table::default())
}

/// The records that are not as they were.
fn changes(table: &Table, before: &Table) -> String {
    let mut out = String::from("outer");
    reference(&mut out, table.outer_face);
    out.push('\n');
    for (i, row) in table.vertices.iter().enumerate().filter(|(i, row)| before.vertices.get(*i) != Some(row)) {
        let row = row.unwrap();
        let [x, y] = row.position.unwrap();
        let _ = write!(out, "vertex {i} {x} {y}");
        reference(&mut out, row.outgoing);
        out.push('\n');
    }
    for (i, row) in table.half_edges.iter().enumerate().filter(|(i, row)| before.half_edges.get(*i) != Some(row)) {
        let row = row.unwrap();
        out.push_str("half_edge");
        reference(&mut out, Some(HalfEdgeId::new(i as u32)));
        reference(&mut out, row.origin);
        [row.twin, row.next, row.prev].into_iter().for_each(|to| reference(&mut out, to));
        reference(&mut out, row.face);
        out.push('\n');
    }
    for (i, row) in table.faces.iter().enumerate().filter(|(i, row)| before.faces.get(*i) != Some(row)) {
        out.push_str("face");
        reference(&mut out, Some(FaceId::new(i as u32)));
        reference(&mut out, row.as_ref().unwrap().half_edge);
        out.push('\n');
    }
    out
}

fn table(records: &[&str]) -> Table {
    let mut table = Table::default();
    for record in records {
        let words: Vec<&str> = record.split(' ').collect();
        let number = |i: usize| words[i].parse::<u32>().ok();
        let half_edge = |i| number(i).map(HalfEdgeId::new);
        match words[0] {
            "outer" => table.outer_face = number(1).map(FaceId::new),
            "vertex" => table.vertices.push(Some(VertexRow {
                position: Some([words[2].parse().unwrap(), words[3].parse().unwrap()]),
                outgoing: half_edge(4),
            })),
            "half_edge" => table.half_edges.push(Some(HalfEdgeRow {
                origin: number(2).map(VertexId::new),
                twin: half_edge(3),
                next: half_edge(4),
                prev: half_edge(5),
                face: number(6).map(FaceId::new),
            })),
            _ => table.faces.push(Some(FaceRow { half_edge: half_edge(2), ..FaceRow::default() })),
        }
    }
    table
}
