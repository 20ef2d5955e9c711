//! Two drawings.

use super::Args;
use crate::{Answer, Failure, Output, Target, fields, say};
use dcel_kit::compare::{self, CompareError, Comparison, Options, Side};
use dcel_kit::figure::FigureOptions;
use dcel_kit::io::source_name;
use std::io::Write;
use std::path::Path;

/// Longest file that is read at all; what is compared is far smaller.
const LONGEST: u64 = 64 << 20;
/// How far a point may be from its place, in px, if nothing is said.
const TOLERANCE: f64 = 0.05;

pub(super) fn run(args: &Args, target: Option<&Target>, out: &mut Output) -> Result<Answer, Failure> {
    let files = [(Side::Reference, &args.reference), (Side::Student, &args.student)];
    let refused = |error: &CompareError| {
        let (_, file) = files[usize::from(error.side == Side::Student)];
        Failure::input(error.named(&source_name(file)), "dcel compare --help says what is read")
    };
    let [reference, student] = files.map(|(_, file)| read(file));
    let (reference, student) = (reference?, student?);
    // With its byte order mark: files of other bytes are not told to have the same.
    let whole = |bytes, text| std::str::from_utf8(bytes).unwrap_or(text);
    let text = |bytes, side| compare::text(bytes, side).map(|text| whole(bytes, text)).map_err(|error| refused(&error));
    let options = Options::new()
        .names(args.names)
        .faces(!args.drawn.no_faces)
        .tolerance(args.drawn.tolerance.unwrap_or(TOLERANCE));
    let (reference, student) = (text(&reference, Side::Reference)?, text(&student, Side::Student)?);
    let answer = compare::compare(reference, student, &options).map_err(|error| refused(&error))?;
    if let Some(target) = target {
        draw(target, &answer, out)?;
    }
    if args.json {
        let line =
            |d: &compare::Difference| fields! { kind: d.kind.word(), layer: d.layer.word(), text: d.text.clone() };
        out.json(&fields! {
            reference: source_name(&args.reference),
            student: source_name(&args.student),
            equal: answer.is_equal(),
            // What decided: bytes, declared, drawn or shape.
            layer: answer.layer().word(),
            agreed: answer.agreed(),
            differences: answer.differences().iter().map(line).collect::<Vec<_>>(),
            notes: answer.notes(),
        })?;
    } else {
        write!(out, "{}", answer.text())?;
    }
    Ok(if answer.is_equal() { Answer::Yes } else { Answer::No })
}

/// The bytes of a file.
fn read(file: &Path) -> Result<Vec<u8>, Failure> {
    use std::io::Read;
    let unreadable = |error: std::io::Error| {
        Failure::input(format!("{}: cannot be read: {error}", source_name(file)), "check the name of the file")
    };
    if file.is_dir() {
        return Err(Failure::input(format!("{}: it is a directory", source_name(file)), "give a file in it"));
    }
    let mut bytes = Vec::new();
    let length = if file.as_os_str() == "-" {
        std::io::stdin().lock().take(LONGEST).read_to_end(&mut bytes)
    } else {
        std::fs::File::open(file).and_then(|file| file.take(LONGEST).read_to_end(&mut bytes))
    };
    length.map_err(unreadable)?;
    Ok(bytes)
}

fn draw(target: &Target, answer: &Comparison, out: &mut Output) -> Result<(), Failure> {
    let options = target.options(FigureOptions::new("What differs").id_prefix("diff"));
    let figure = answer.figure(&options).map_err(|error| Failure::input(error, ""))?;
    figure.notes().iter().for_each(|note| say("note", note));
    target.write(&figure, out)
}
