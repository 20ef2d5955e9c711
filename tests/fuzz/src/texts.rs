//! Scripts, figure styles, drawings that are compared.

use crate::{Ends, Outcome, assert_place, halves};
use dcel_kit::compare::{CompareError, Options, Side};
use dcel_kit::edits::{Call, Editable};
use dcel_kit::figure::{FigureOptions, Overrides, Style, Unit};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::script::{Edit, Ground, KernelEdit, KernelStart, Run, Script, ScriptError, of_edits, of_kernel_edits};
use dcel_kit::solid::Polyhedron;
use dcel_kit::topology::{Dcel, violations};

/// Longer scripts say nothing that shorter ones do not.
const LONGEST: usize = 4096;
/// So many statements are carried out.
const STATEMENTS: usize = 120;

/// A script of the plane, of the kernel or in space, as its first word says; and each of its lines as a call.
pub(crate) fn script(data: &[u8]) -> Outcome {
    let Ok(text) = std::str::from_utf8(&data[..data.len().min(LONGEST)]) else { return Outcome(0) };
    for line in text.lines().take(STATEMENTS) {
        call::<Subdivision>(line);
        call::<Dcel>(line);
        call::<Polyhedron>(line);
    }
    if text.lines().count() > STATEMENTS {
        return Outcome(1);
    }
    match Ground::of(text) {
        Ground::Plane => match Script::<Subdivision>::parse(text, "file") {
            Ok(script) => of_plane(text, &script),
            Err(error) => refusal(text, &error),
        },
        Ground::Kernel => match Script::parse_kernel(text, "file") {
            Ok(script) => of_kernel(text, &script),
            Err(error) => refusal(text, &error),
        },
        _ => match Script::parse_solid(text, "file") {
            Ok(script) => {
                let run = script.run();
                assert_eq!(violations(&run.end), []);
                told(&run)
            }
            Err(error) => refusal(text, &error),
        },
    }
}

/// A call is read as it is written.
fn call<S: Editable>(line: &str) {
    if let Ok(call) = line.parse::<Call<S>>() {
        let written = call.to_string();
        let again = written.parse::<Call<S>>().unwrap_or_else(|error| panic!("{written}: {error}"));
        assert_eq!(again.to_string(), written);
    }
}

fn refusal(text: &str, error: &ScriptError) -> Outcome {
    let message = error.to_string();
    assert!(!error.what.to_string().is_empty(), "an error without words: {message}");
    assert_place(text.as_bytes(), Ends::Lf, error.line.into(), Some(error.column.into()), &message);
    Outcome::of(&message)
}

/// What the statements said.
fn told<S: Editable>(run: &Run<S>) -> Outcome {
    let said = |step: &dcel_kit::script::Step<Call<S>>| {
        let text = step.outcome.to_string();
        assert!(!text.is_empty(), "a statement that says nothing");
        Outcome::of(if step.outcome.is_refused() { &text } else { text.split(' ').next().unwrap_or_default() })
    };
    // Statements count one by one, not in their order.
    run.steps.iter().map(said).fold(Outcome(7), |all, one| Outcome(all.0.wrapping_add(one.0)))
}

fn of_plane(text: &str, script: &Script<Subdivision>) -> Outcome {
    let run = script.run();
    assert_eq!(violations(&run.end), []);
    assert_eq!(run.end.geometry_violations(), []);
    // What was done, written down, can be done again.
    let edits: Vec<Edit> = run.edits();
    let corners = polygon(text).filter(|corners| Subdivision::polygon(corners).as_ref() == Ok(script.start()));
    if let Some(corners) = corners {
        let replay = of_edits(&corners, &edits);
        let again = Script::<Subdivision>::parse(&replay, "replay").unwrap_or_else(|error| panic!("{error}\n{replay}"));
        assert!(again.run().end == run.end, "the replay ends elsewhere:\n{replay}");
    }
    told(&run)
}

/// The corners of a start `polygon x y x y ...`.
fn polygon(text: &str) -> Option<Vec<Point>> {
    let start =
        text.lines().map(|line| line.split('#').next().unwrap_or_default().trim()).find(|line| !line.is_empty());
    let words = start?.strip_prefix("polygon ")?.split_whitespace();
    let numbers: Vec<f64> = words.map(|word| word.parse().ok()).collect::<Option<_>>()?;
    Some(numbers.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect())
}

fn of_kernel(text: &str, script: &Script<Dcel>) -> Outcome {
    let run = script.run();
    assert_eq!(violations(&run.end), []);
    let edits: Vec<KernelEdit> = run.edits();
    let start = text.lines().map(str::trim).find(|line| !line.is_empty() && !line.starts_with('#'));
    let starts = [KernelStart::Torus, KernelStart::Ring(2), KernelStart::Ring(3), KernelStart::Ring(5)];
    if let Some(start) = starts.into_iter().find(|known| start == Some(known.to_string().as_str())) {
        let replay = of_kernel_edits(&start, &edits);
        let again = Script::parse_kernel(&replay, "replay").unwrap_or_else(|error| panic!("{error}\n{replay}"));
        assert!(again.run().end == run.end, "the replay ends elsewhere:\n{replay}");
    }
    told(&run)
}

/// What a reference looks like that asks for something.
const REFERENCE: &str = include_str!("../corpus/compare/reference.svg");

/// Two drawings, the reference first; a drawing alone is compared with one of the kit's own, and with itself.
pub(crate) fn compare(data: &[u8]) -> Outcome {
    let (first, second) = halves(&data[..data.len().min(1 << 15)]);
    let (reference, student) = if second.is_empty() { (REFERENCE.as_bytes(), first) } else { (first, second) };
    let texts = [(reference, Side::Reference), (student, Side::Student)]
        .map(|(bytes, side)| dcel_kit::compare::text(bytes, side));
    let (reference, student) = match texts {
        [Ok(reference), Ok(student)] => (reference, student),
        [Err(error), _] | [_, Err(error)] => return Outcome::of(&error.to_string()),
    };
    let options = [Options::new(), Options::new().names(true).faces(false).tolerance(2.0)];
    let mut outcome = Outcome(0);
    for options in options {
        outcome = outcome.and(compared(reference, student, &options));
    }
    // A drawing is equal to itself, or no reference.
    match dcel_kit::compare::compare(student, student, &Options::new()) {
        Ok(same) => assert!(same.is_equal(), "it differs from itself: {}", same.text()),
        Err(error) => outcome = outcome.and(misread(student, student, &error)),
    }
    outcome
}

fn compared(reference: &str, student: &str, options: &Options) -> Outcome {
    let answer = match dcel_kit::compare::compare(reference, student, options) {
        Ok(answer) => answer,
        Err(error) => return misread(reference, student, &error),
    };
    let text = answer.text();
    assert_eq!(answer.is_equal(), answer.differences().is_empty());
    assert!(text.starts_with(if answer.is_equal() { "equal" } else { "differs" }), "{text}");
    assert!(answer.differences().iter().all(|difference| !difference.text.is_empty()), "{text}");
    if let Ok(figure) = answer.figure(&FigureOptions::new("Differences")) {
        let drawn = figure.to_svg();
        assert!(drawn.contains("<svg") && !drawn.contains("NaN") && !drawn.contains("inf,"), "{drawn}");
    }
    Outcome::of(&answer.verdict())
        .and(answer.differences().first().map_or(Outcome(0), |difference| Outcome::of(&difference.text)))
        .and(answer.notes().first().map_or(Outcome(0), |note| Outcome::of(note)))
}

fn misread(reference: &str, student: &str, error: &CompareError) -> Outcome {
    let message = error.to_string();
    let text = if error.side == Side::Reference { reference } else { student };
    if let Some((line, column)) = error.place {
        assert!(line > 0 && column > 0, "{message}");
        // Here only LF ends a line.
        let found = text.split('\n').nth(line as usize - 1);
        let width = found.map(|line| line.chars().count() + 2);
        assert!(width.is_some_and(|width| column as usize <= width), "no such place: {message}");
    }
    assert!(!error.problem.to_string().is_empty());
    Outcome::of(&message)
}

/// A style, colours and labels of elements, a length.
pub(crate) fn figure_files(data: &[u8]) -> Outcome {
    let Ok(text) = std::str::from_utf8(&data[..data.len().min(LONGEST)]) else { return Outcome(0) };
    let style = match Style::from_json(text) {
        Ok(style) => drawn(FigureOptions::new("Styled").style(style), text),
        Err(error) => Outcome::of(&error.to_string()),
    };
    let overrides = match Overrides::parse(text) {
        Ok(overrides) => drawn(FigureOptions::new("Coloured").overrides(overrides), text),
        Err(error) => {
            assert!(!error.what.is_empty() && error.line > 0 && error.column > 0, "{error}");
            let line = text.lines().nth(error.line - 1).unwrap_or_else(|| panic!("no such line: {error}"));
            assert!(error.column <= line.chars().count() + 1, "no such column: {error}");
            Outcome::of(&error.to_string())
        }
    };
    let length = match Unit::parse_length(text.trim()) {
        Ok((length, _)) => {
            assert!(length.is_finite(), "{length}");
            Outcome(1)
        }
        Err(error) => Outcome::of(&error.to_string()),
    };
    style.and(overrides).and(length)
}

/// What can be drawn is drawn with numbers. A label may say anything.
fn drawn(options: FigureOptions, text: &str) -> Outcome {
    match dcel_kit::figure::structure(&Subdivision::lab_rectangle(), &options) {
        Ok(figure) => {
            let svg = figure.to_svg();
            for word in ["NaN", "=\"inf", "=\"-inf"] {
                assert!(!svg.contains(word) || text.contains(word), "{svg}");
            }
            Outcome(2)
        }
        Err(error) => Outcome::of(&error.to_string()),
    }
}
