//! Answers are read strictly: whatever is missing, doubled, forged or too much breaks its case, and no other.

use dcel_lab::cases::starts;
use dcel_lab::protocol::{
    Answers, Broken, CallEnd, Case, Cell, ColumnSchema, Pattern, RecordSchema, Reply, Schema, Start, Step, TableSchema,
    Value, read_answers,
};

const DUMP: &str = "dump\nouter 0\nvertex 0 0 -1.5 0\nhalf_edge 0 0 - 0 0 1\nface 0 -\nface 1 0\nend_dump\n";

fn case(name: &str) -> Case {
    let call = Step::call("split_face", ["h0", "h4"]);
    Case { steps: vec![Step::Dump, call, Step::Dump], ..Case::new(name, Start::line("rectangle")) }
}

fn good(name: &str) -> String {
    format!("case {name}\n{DUMP}call split_face 0 4\nreturned true\ndump same\nend_case {name}\n")
}

/// Reads an answer to the cases `a` and `b`; every line gets the token.
fn read(text: &str) -> Answers {
    let said: String = text.lines().map(|line| format!("\n@T {line}\n")).collect();
    read_answers(said.as_bytes(), "T", &[&case("a"), &case("b")], Schema::HalfEdges)
}

fn broken(first: &str) -> Broken {
    let answers = read(&format!("{first}{}done\n", good("b")));
    assert!(!answers.cases[0].complete, "{first}");
    assert!(answers.cases[1].complete, "the next case is lost: {answers:?}");
    answers.cases[0].broken.clone().expect("nothing is said of it")
}

#[test]
fn a_whole_answer_is_read() {
    let answers = read(&format!("{}{}done\n", good("a"), good("b")));
    assert!(answers.done && answers.cases.iter().all(|case| case.complete && case.broken.is_none()), "{answers:?}");
    let replies = &answers.cases[0].replies;
    let (Reply::Dump(first), Reply::Called(called), Reply::Dump(last)) = (&replies[0], &replies[1], &replies[2]) else {
        panic!("{replies:?}")
    };
    assert_eq!((first, &called.arguments[..]), (last, &[0, 4][..]));
    assert_eq!(called.end, CallEnd::Returned(vec![Value::Truth(true)]));
    let first = first.half_edges().unwrap();
    assert_eq!(first.vertices[0].unwrap().position, Some([0.0, -1.5]));
    assert_eq!((first.half_edges[0].unwrap().twin, first.faces.len()), (None, 2));
}

#[test]
fn lines_that_are_not_due_break_their_case_only() {
    let text = good("a");
    for (from, to) in [
        // Missing, doubled, strange, out of order.
        ("call split_face 0 4\n", ""),
        ("returned true\n", ""),
        ("returned true\n", "returned true\nreturned true\n"),
        ("returned true\n", "returned maybe\n"),
        ("returned true\n", "returned -1\n"),
        ("call split_face 0 4\n", "call split_face 0\n"),
        ("call split_face 0 4\n", "call split_in_half 0\n"),
        ("dump same\n", ""),
        ("vertex 0 0 -1.5 0\n", "vertex 1 0 -1.5 0\n"),
        ("vertex 0 0 -1.5 0\n", "vertex 0 0 -1.5 0\nvertex 0 0 -1.5 0\n"),
        ("vertex 0 0 -1.5 0\n", "vertex 0 0 zero 0\n"),
        ("vertex 0 0 -1.5 0\n", "vertex 0 0 -1.5 0 0\n"),
        ("half_edge 0 0 - 0 0 1\n", "half_edge 0 0 - 0 1\n"),
        ("half_edge 0 0 - 0 0 1\n", "half_edge 0 0 - 0x0 0 1\n"),
        ("outer 0\n", ""),
        ("outer 0\n", "outer 0\nouter 0\n"),
        ("face 1 0\n", "faces 1 0\n"),
        ("end_dump\n", ""),
        ("end_case a\n", "end_case b\n"),
        ("case a\n", "case a\ncase a\n"),
    ] {
        let forged = text.replacen(from, to, 1);
        assert_ne!(forged, text, "{from}");
        let said = broken(&forged).to_string();
        assert!(said.starts_with("line "), "{said}");
    }
    let first = text.replacen(DUMP, "dump same\n", 1);
    assert!(matches!(broken(&first), Broken::NothingBefore { line: 2 }));
    // A line between two cases is nobody's.
    let answers = read(&format!("{}hello\n{}done\n", good("a"), good("b")));
    assert!(answers.cases[0].complete && !answers.cases[1].complete);
}

#[test]
fn an_answer_that_stops_is_not_complete() {
    let whole = format!("{}{}done\n", good("a"), good("b"));
    let lines: Vec<&str> = whole.lines().collect();
    for stop in 0..lines.len() {
        let answers = read(&lines[..stop].join("\n"));
        assert!(!answers.done, "after {stop} lines");
        let complete = answers.cases.iter().filter(|case| case.complete).count();
        let expected = [good("a"), whole.clone()]
            .iter()
            .filter(|part| part.lines().count() <= stop + usize::from(part.contains("done")))
            .count();
        assert_eq!(complete, expected, "after {stop} lines");
        assert!(answers.cases.iter().all(|case| case.broken.is_none()), "after {stop} lines");
    }
}

#[test]
fn what_has_no_token_was_printed_by_the_student() {
    let said: String = format!("{}{}done\n", good("a"), good("b")).lines().map(|line| format!("@T {line}\n")).collect();
    let noisy = format!("case a\n{DUMP}@X done\n{said}bye");
    let answers = read_answers(noisy.as_bytes(), "T", &[&case("a"), &case("b")], Schema::HalfEdges);
    assert!(answers.done && answers.cases.iter().all(|case| case.complete), "{answers:?}");
    assert!(answers.printed.starts_with("case a\ndump\n") && answers.printed.ends_with("@X done\nbye\n"));
    // It is kept up to a few kilobytes, and need not be text.
    let flood: Vec<u8> = (0..1_000_000).map(|i| if i % 80 == 0 { b'\n' } else { 0xff }).collect();
    let answers = read_answers(&flood, "T", &[&case("a")], Schema::HalfEdges);
    assert!(answers.printed.len() < 16 * 1024 && answers.cases.is_empty() && !answers.done);
}

#[test]
fn sizes_are_capped_and_great_numbers_name_nothing() {
    let vertices: String = (0..60_000).map(|i| format!("vertex {i} 0 0 -\n")).collect();
    let huge = good("a").replacen("vertex 0 0 -1.5 0\n", &vertices, 1);
    assert!(matches!(broken(&huge), Broken::TooMuch { what: "records", .. }));
    let long = good("a").replacen("returned true", &format!("returned {}", "1 ".repeat(30_000).trim_end()), 1);
    assert!(matches!(broken(&long), Broken::TooMuch { what: "values", .. }));
    let line = good("a").replacen("dump\n", &format!("{}\n", "x".repeat(100_000)), 1);
    assert!(matches!(broken(&line), Broken::TooMuch { what: "bytes in a line", .. }));
    let answers = read(&good("a").replacen("half_edge 0 0 - 0 0 1", "half_edge 0 18446744073709551615 - 0 0 1", 1));
    let Reply::Dump(structure) = &answers.cases[0].replies[0] else { panic!("{answers:?}") };
    let table = structure.half_edges().unwrap();
    assert_eq!(table.half_edges[0].unwrap().origin.unwrap().number(), u32::MAX - 1);
    // Not even the validator minds.
    assert!(!dcel_kit::topology::violations(table.as_ref()).is_empty());
}

#[test]
fn panics_are_read_with_message_and_place() {
    let with = |line: &str| {
        let answers = read(&good("a").replacen("returned true", line, 1));
        match &answers.cases[0].replies[1] {
            Reply::Called(called) => called.end.clone(),
            other => panic!("{other:?}"),
        }
    };
    let end = with(r#"panicked "it \"was\" a \\ b\nc" src/lab.rs:41:9"#);
    let CallEnd::Panicked { message, place } = &end else { panic!("{end:?}") };
    assert_eq!((message.as_str(), place.as_deref()), ("it \"was\" a \\ b\nc", Some("src/lab.rs:41:9")));
    assert!(!end.is_todo());
    assert!(with(r#"panicked "not yet implemented: split_face""#).is_todo());
    assert!(matches!(broken(&good("a").replacen("returned true", "panicked \"open", 1)), Broken::Expected { .. }));
}

#[test]
fn the_input_is_what_a_student_would_type() {
    let text = Case::input("T", [&case("a")]);
    assert_eq!(text, "token T\ncase a\nrectangle\ndump\nsplit_face h0 h4\ndump\n");
    assert_eq!(case("a").script(), "rectangle\ndump\nsplit_face h0 h4\ndump\n");
    let triangles = starts::triangles(&[[0.0, 0.5], [2.0, 0.0], [1.0, 3.0]], &[[0, 1, 2]]);
    assert_eq!(Case::new("x", triangles).script(), "triangles 0 0.5 2 0 1 3 / 0 1 2\n");
}

#[test]
fn stopped_calls_are_read_with_what_they_did_last() {
    let with = |line: &str| {
        let answers = read(&good("a").replacen("returned true", line, 1));
        match &answers.cases[0].replies[1] {
            Reply::Called(called) => called.end.clone(),
            other => panic!("{other:?}"),
        }
    };
    let CallEnd::Stopped(circle) = with("stopped 1401 circle src/lab.rs:41:9 h3 h7") else { panic!("no stop") };
    assert_eq!((circle.reads, circle.pattern, circle.elements.len()), (1401, Pattern::Circle, 2));
    assert_eq!(circle.place.as_deref(), Some("src/lab.rs:41:9"));
    assert_eq!(circle.words(), "does not come back: after 1,401 reads it goes round and round, h3, h7, h3, h7 …");
    let CallEnd::Stopped(open) = with("stopped 20 open - h1 x<y h99999999999999999999999") else { panic!("no stop") };
    assert_eq!((open.place, open.elements), (None, vec!["h1".to_owned()]));
    for wrong in ["stopped", "stopped x circle - h1", "stopped 1 round - h1", "stopped 1"] {
        assert!(matches!(broken(&good("a").replacen("returned true", wrong, 1)), Broken::Expected { .. }), "{wrong}");
    }
}

/// Nodes of a linked polygon: what a lab without half-edges may have.
static NODES: RecordSchema = RecordSchema {
    singles: &["first"],
    tables: &[TableSchema {
        word: "node",
        letter: 'n',
        columns: &[ColumnSchema::Number("x"), ColumnSchema::Number("y"), ColumnSchema::Link("next", 'n')],
    }],
};

#[test]
fn records_of_other_kinds_are_read_as_strictly() {
    let case = Case { steps: vec![Step::Dump, Step::of_line("ears")], ..Case::new("a", Start::line("nodes 2")) };
    let text = "case a\ndump\nfirst 1\nnode 0 0.5 2 1\nnode 1 0 0 -\nend_dump\ncall ears\nreturned 1 [0 2] #0.5\nend_case a\ndone\n";
    let read = |text: &str| {
        let said: String = text.lines().map(|line| format!("\n@T {line}\n")).collect();
        read_answers(said.as_bytes(), "T", &[&case], Schema::Records(&NODES))
    };
    let answers = read(text);
    assert!(answers.done && answers.cases[0].complete, "{answers:?}");
    let Reply::Dump(structure) = &answers.cases[0].replies[0] else { panic!("{answers:?}") };
    let records = structure.records().unwrap();
    assert_eq!((records.singles[0], records.len(0)), (Some(1), 2));
    assert_eq!(records.row(0, 1).unwrap(), [Cell::Number(0.0), Cell::Number(0.0), Cell::Link(None)]);
    assert_eq!(records.row(0, 2), None);
    let Reply::Called(called) = &answers.cases[0].replies[1] else { panic!("{answers:?}") };
    let values = vec![Value::Id(1), Value::List(vec![Value::Id(0), Value::Id(2)]), Value::Number(0.5)];
    assert_eq!(called.end, CallEnd::Returned(values));
    // What is printed is what a case can begin with.
    let again = Case::new("b", Start::structure_of(structure.clone()));
    assert_eq!(again.script(), "table\nfirst 1\nnode 0 0.5 2 1\nnode 1 0 0 -\nend_table\n");
    for (from, to) in [
        ("first 1\n", ""),
        ("first 1\n", "first 1\nfirst 1\n"),
        ("node 1 0 0 -", "node 1 0 0"),
        ("node 1 0 0 -", "node 1 0 0 - -"),
        ("node 1 0 0 -", "node 2 0 0 -"),
        ("node 1 0 0 -", "nodes 1 0 0 -"),
        ("node 1 0 0 -", "node 1 0 - -"),
        ("returned 1 [0 2] #0.5", "returned 1 [0 2 #0.5"),
        ("returned 1 [0 2] #0.5", "returned1"),
        ("returned 1 [0 2] #0.5", "returned "),
    ] {
        let forged = text.replacen(from, to, 1);
        assert_ne!(forged, text, "{from}");
        assert!(!read(&forged).cases[0].complete, "{forged}");
        assert!(read(&forged).cases[0].broken.is_some(), "{forged}");
    }
}

#[test]
fn a_structure_that_a_call_returns_follows_as_a_dump() {
    let case = Case { steps: vec![Step::of_line("dual 1.5 true")], ..Case::new("a", Start::none()) };
    assert_eq!(case.script(), "dual 1.5 true\n");
    let text = format!("case a\ncall dual 1.5 true\nreturned [structure 3] structure\n{DUMP}{DUMP}end_case a\ndone\n");
    let read = |text: &str| {
        let said: String = text.lines().map(|line| format!("\n@T {line}\n")).collect();
        read_answers(said.as_bytes(), "T", &[&case], Schema::HalfEdges)
    };
    let answers = read(&text);
    let Reply::Called(called) = &answers.cases[0].replies[0] else { panic!("{answers:?}") };
    assert!(answers.cases[0].complete && called.arguments.is_empty(), "{answers:?}");
    let CallEnd::Returned(values) = &called.end else { panic!("{called:?}") };
    let (Value::List(list), Value::Structure(last)) = (&values[0], &values[1]) else { panic!("{values:?}") };
    let Value::Structure(first) = &list[0] else { panic!("{list:?}") };
    assert_eq!((first, first.half_edges().unwrap().faces.len()), (last, 2));
    let one = text.replacen(DUMP, "", 1);
    assert!(!read(&one).cases[0].complete);
}
