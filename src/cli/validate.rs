//! `dcel validate`: which invariants does a structure break?

use super::output::names;
use super::subject::{Kind, Subject};
use super::{Answer, Failure, InputOptions, Output, fields, say, tell};
use dcel_kit::VertexId;
use dcel_kit::io::{LoadError, counted, source_name};
use dcel_kit::plane::{ConvertError, GEOMETRY_RULES, GeometryViolation, Subdivision, TableError};
use dcel_kit::topology::{Mode, Rule, Violation, violations};
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;

/// List the invariants that a structure breaks
///
/// One violation a line, the id of the invariant first. In the plane all edges are checked against each
/// other. Polygons that do not fit together are one violation, G1 to G3 or INPUT, and no structure;
/// corners that lie inside sides of GeoJSON, TopoJSON and WKT are inserted there, with a note.
///
/// Exit code 0: valid; 1: not valid; 2: the file cannot be read.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel validate square.dcel
  dcel validate broken.dcel --json
  dcel validate --rules")]
pub(crate) struct Args {
    /// The file, or - for standard input
    #[arg(required_unless_present = "rules")]
    file: Option<PathBuf>,
    /// Print the invariants and what they mean
    #[arg(long, conflicts_with = "file")]
    rules: bool,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    input: InputOptions,
}

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Report {
    source: String,
    mode: Option<&'static str>,
    valid: bool,
    violations: Vec<Fault>,
    /// Why invariants were not checked.
    unchecked: Vec<String>,
}

#[derive(Default, Serialize)]
struct Fault {
    rule: &'static str,
    text: String,
    elements: Vec<String>,
    chain: Vec<String>,
    found: Option<String>,
    expected: Option<String>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let Some(file) = args.file.as_deref().filter(|_| !args.rules) else {
        print_rules(args.json, out)?;
        return Ok(Answer::Yes);
    };
    if args.input.trust {
        return Err(Failure::input("--trust leaves out the check that validate makes", "leave --trust out"));
    }
    let report = match args.input.try_open(file, true)? {
        Ok(mut subject) => Report::of(&mut subject),
        Err(error) => Report::misfit(source_name(file), &error),
    };
    tell(&report, args.json, out, |out| report.print(out))?;
    Ok(if report.valid { Answer::Yes } else { Answer::No })
}

impl Report {
    /// The report of a subject, which is not to be used afterwards.
    fn of(subject: &mut Subject) -> Self {
        let (source, mode) = (subject.source.clone(), subject.mode());
        let mode_name = subject.mode_name();
        let mut unchecked = Vec::new();
        let broken = violations(subject.view());
        let mut faults: Vec<Fault> = broken.iter().map(Fault::of_law).collect();
        if faults.is_empty() {
            let geometry = geometry(subject, &mut unchecked);
            faults = geometry.iter().map(|violation| Fault::of_geometry(violation, subject)).collect();
        } else if mode == Mode::Plane {
            unchecked.push("the invariants of the plane: first those of the structure must hold".to_owned());
        }
        Self { source, mode: Some(mode_name), valid: faults.is_empty(), violations: faults, unchecked }
    }

    fn misfit(source: String, error: &LoadError) -> Self {
        let text = error.to_string();
        let (rule, text, elements) = match error {
            LoadError::Plane { error: ConvertError::Geometry(violation), .. } => {
                let rule = violation.rule().id;
                (rule, text.replacen(&format!("{rule}: "), "", 1), names(violation.vertices()))
            }
            _ => ("INPUT", text, Vec::new()),
        };
        let fault = Fault { rule, text, elements, ..Fault::default() };
        Self { source, mode: None, valid: false, violations: vec![fault], unchecked: Vec::new() }
    }

    fn print(&self, out: &mut Output) -> io::Result<()> {
        for Fault { rule, text, .. } in &self.violations {
            writeln!(out, "{rule}: {text}")?;
        }
        if self.valid {
            writeln!(out, "{}: valid", self.source)?;
        } else {
            let count = self.violations.len();
            say("note", format!("{}: {}", self.source, counted(count, "violation", "violations")));
        }
        self.unchecked.iter().for_each(|what| say("note", format!("not checked: {what}")));
        Ok(())
    }
}

/// Violations of the invariants of the plane, where there is one.
fn geometry(subject: &mut Subject, unchecked: &mut Vec<String>) -> Vec<GeometryViolation> {
    match &mut subject.kind {
        Kind::Plane(subdivision) => subdivision.geometry_violations(),
        Kind::Surface(_) => Vec::new(),
        Kind::Table(table) => match Subdivision::from_columns(table) {
            Ok(_) => Vec::new(),
            Err(TableError::Geometry { violations }) => violations,
            Err(TableError::NoOuterFace) => {
                unchecked.push("the invariants of the plane: no face is marked `outer`".to_owned());
                Vec::new()
            }
            Err(error) => {
                unchecked.push(format!("the invariants of the plane: {error}"));
                Vec::new()
            }
        },
    }
}

impl Fault {
    fn of_law(violation: &Violation) -> Self {
        Self {
            rule: violation.rule.id,
            text: violation.text().to_owned(),
            elements: names(&violation.elements),
            chain: names(&violation.chain),
            found: violation.found.map(|element| element.to_string()),
            expected: violation.expected.map(|element| element.to_string()),
        }
    }

    fn of_geometry(violation: &GeometryViolation, subject: &Subject) -> Self {
        let vertices = violation.vertices();
        let message = violation.to_string();
        let text = message.split_once(": ").map_or(message.as_str(), |(_, text)| text);
        let mut elements = names(&vertices);
        elements.extend(names(violation.other_elements()));
        Self {
            rule: violation.rule().id,
            text: format!("{text}{}", lines(&vertices, subject)),
            elements,
            ..Self::default()
        }
    }
}

/// ` (v3: line 7, v4: line 9)`, if the vertices have lines.
fn lines(vertices: &[VertexId], subject: &Subject) -> String {
    let Some(places) = &subject.places else { return String::new() };
    let line = |v: &VertexId| Some(format!("{v}: line {}", places.vertex_lines.get(v.index())?));
    let all: Vec<String> = vertices.iter().filter_map(line).collect();
    if all.is_empty() { String::new() } else { format!(" ({})", all.join(", ")) }
}

fn print_rules(json: bool, out: &mut Output) -> Result<(), Failure> {
    let invariants = Rule::all().iter().chain(GEOMETRY_RULES);
    if json {
        let invariant = |&Rule { id, invariant, explanation }: &Rule| fields! { rule: id, invariant, explanation };
        out.json(&invariants.map(invariant).collect::<Vec<_>>())?;
        return Ok(());
    }
    for Rule { id, invariant, explanation } in invariants {
        writeln!(out, "{id}  {invariant}")?;
        for line in super::output::wrapped(explanation, 72) {
            writeln!(out, "      {line}")?;
        }
    }
    Ok(())
}
