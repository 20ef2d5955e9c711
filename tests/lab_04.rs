//! Lab 04 as it stands in `labs/`: its program, its drawing, and the parts of the engine that are tried on its files.
//!
//! The solution is a module of this test, so that nothing has to be built apart; the graded tests themselves, with
//! every bug, are the matter of another file.

use dcel_kit::compare::{Options, compare};
use dcel_kit::script::{Outcome, Script};
use dcel_kit::topology::{FaceRow, HalfEdgeRow, IsomorphismOptions, Table, VertexRow, isomorphic_with, position_key};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use dcel_lab::cases::starts::{convex, grid, wheel};
use dcel_lab::protocol::{CallEnd, Case, Reply, Schema, Start, Step, Value, read_answers};
use dcel_lab::{Bug, BugError, Manifest, MarkError, starter};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

#[path = "../labs/04-half-edge/src/calls.rs"]
#[allow(dead_code, unreachable_pub)]
mod calls;
#[path = "../labs/04-half-edge/src/dcel.rs"]
#[allow(unreachable_pub)]
mod dcel;
#[path = "../labs/harness/mod.rs"]
#[allow(unreachable_pub)]
mod harness;
#[path = "../labs/04-half-edge/solution/lab.rs"]
#[allow(unreachable_pub)]
mod lab;
#[path = "../labs/04-half-edge/src/pen.rs"]
#[allow(unreachable_pub)]
mod pen;
#[path = "../labs/04-half-edge/src/records.rs"]
mod records;
#[path = "../labs/04-half-edge/src/start.rs"]
#[allow(unreachable_pub)]
mod start;
#[path = "../labs/04-half-edge/src/svg.rs"]
#[allow(unreachable_pub)]
mod svg;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../labs/04-half-edge")
}

fn read(path: &str) -> String {
    fs::read_to_string(folder().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

// ---- the starter ----------------------------------------------------------------------------------------

#[test]
fn a_block_becomes_its_starter_text_at_its_own_depth() {
    let source = "fn f() {\n    // BEGIN SOLUTION\n    // STARTER: let _ = 1;\n    // STARTER:\n    //STARTER:   deep\n    \
                  secret();\n    // END SOLUTION\n}\n";
    assert_eq!(starter(source).unwrap(), "fn f() {\n    let _ = 1;\n\n      deep\n}\n");
    assert_eq!(starter("  // BEGIN SOLUTION\n  secret\n  // END SOLUTION").unwrap(), "  todo!()\n");
    assert_eq!(starter("a\r\n//BEGIN SOLUTION\r\nb\r\n//END SOLUTION\r\n").unwrap(), "a\ntodo!()\n");
}

#[test]
fn markers_that_do_not_pair_up_are_named_by_their_lines() {
    for (source, error) in [
        ("x\n// BEGIN SOLUTION\n", MarkError::NotEnded { line: 2 }),
        ("// BEGIN SOLUTION\n\n// BEGIN SOLUTION\n", MarkError::Nested { line: 3, first_line: 1 }),
        ("// END SOLUTION\n", MarkError::NotBegun { line: 1 }),
        ("\n// STARTER: todo!()\n", MarkError::StrayStarter { line: 2 }),
        ("let answer = 42; // BEGIN SOLUTION\n", MarkError::NothingMarked),
    ] {
        assert_eq!(starter(source), Err(error), "{source:?}");
    }
}

// ---- the manifest ---------------------------------------------------------------------------------------

#[test]
fn a_manifest_that_cannot_be_used_is_refused_with_the_place() {
    let good = read("lab.toml");
    assert!(Manifest::parse(&good, "lab.toml").is_ok());
    let second = |word: &str| good.match_indices(word).nth(1).unwrap().0;
    let test = |name: &str| good[..good.find(&format!("name = \"{name}\"")).unwrap()].rfind("[[test]]").unwrap();
    let at = |word: &str| good.find(word).unwrap();
    for (find, replace, place, message) in [
        ("version = ", "vresion = ", at("version"), "unknown field `vresion`"),
        ("version = \"1.0.0\"\n", "", 0, "missing field `version`"),
        (
            "\"src/lab.rs\"",
            "\"../lab.rs\"",
            at("\"src/lab.rs\""),
            "\"../lab.rs\" is not a file inside the lab's folder",
        ),
        ("\"src/lab.rs\"", "\"/src/lab.rs\"", at("\"src/lab.rs\""), "\"/src/lab.rs\" is not a file inside"),
        ("\"src/lab.rs\"", "'src\\lab.rs'", at("\"src/lab.rs\""), "\"src\\\\lab.rs\" is not a file inside"),
        ("[\"src/lab.rs\"]", "[]", at("[\"src/lab.rs"), "no file is graded"),
        ("seconds = 5.0", "seconds = 0.0", at("[limits]"), "a limit is not above 0"),
        ("memory_mb = 1024", "memory_mb = \"much\"", at("1024"), "invalid type"),
        ("number = 2", "number = 1", second("[[task]]"), "task 1 was given before"),
        ("name = \"face_walk\"", "name = \"face walk\"", test("face_walk"), "\"face walk\" cannot be a test"),
        ("points = 3\n", "points = 0\n", test("destination_by_twin"), "the test destination_by_twin is worth nothing"),
        (
            "name = \"face_vertices\"",
            "name = \"face_walk\"",
            test("face_vertices"),
            "the test face_walk was given before",
        ),
        ("task = 2", "task = 20", at("task = 2") + 7, "there is no task 20"),
        (
            "[\"split_face_0_legal\"]",
            "[\"drawing\"]",
            at("\"split_face_0_legal\"]"),
            "split_face_1_new_face needs drawing",
        ),
    ] {
        assert_eq!(good.matches(find).count(), 1, "{find:?} stands once in the manifest");
        let error = Manifest::parse(&good.replace(find, replace), "lab.toml").unwrap_err();
        let line_start = good[..place].rfind('\n').map_or(0, |end| end + 1);
        let wanted = (good[..place].matches('\n').count() + 1, good[line_start..place].chars().count() + 1);
        assert_eq!((error.line, error.column), wanted, "{error}");
        assert!(error.what.starts_with(message) && !error.what.contains('\n'), "{error}");
    }
    let unclosed = Manifest::parse("name = \"x\"\n[drawing\n", "lab.toml").unwrap_err();
    assert_eq!((unclosed.line, unclosed.source.as_str()), (2, "lab.toml"));
}

// ---- the bugs -------------------------------------------------------------------------------------------

#[test]
fn a_bug_that_does_not_fit_says_why() {
    let bug = |edits: &str| Bug::parse(&format!("number = 7\ntitle = 't'\ntask = 1\nsection = 's'\n{edits}"), "b.toml");
    let edit = |find: &str, replace: &str| format!("[[edit]]\nfind = '{find}'\nreplace = '{replace}'\n");
    assert_eq!(bug(&edit("b", "c")).unwrap().apply("a b").unwrap(), "a c");
    assert_eq!(bug(&(edit("b", "c") + &edit("a c", "d"))).unwrap().apply("a b").unwrap(), "d", "one after the other");
    let (place, find) = ("b.toml:6:8".to_owned(), "b".to_owned());
    let not_once = |times| Err(BugError::NotOnce { place: place.clone(), find: find.clone(), times });
    assert_eq!(bug(&edit("b", "c")).unwrap().apply("a"), not_once(0));
    assert_eq!(bug(&edit("b", "c")).unwrap().apply("b b"), not_once(2));
    let no_change = Err(BugError::NoChange { place: place.clone(), find: find.clone() });
    assert_eq!(bug(&edit("b", "b")).unwrap().apply("b"), no_change);
    for (edits, message) in [
        ("same_as = [7]\n[[edit]]\nfind = 'b'\nreplace = 'c'\n", "b.toml:5:11: a bug is the same as itself"),
        ("edit = []\n", "b.toml:5:8: a bug without an edit"),
        ("[[edit]]\nfind = 'b'\n", "b.toml:5:1: missing field `replace`"),
    ] {
        let error = bug(edits).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error:?}, not {message:?}");
    }
}

// ---- the drawing ----------------------------------------------------------------------------------------

fn table_of(dcel: &dcel::Dcel) -> Table {
    let (vertex, half_edge) = (|v| VertexId::new(v as u32), |h| HalfEdgeId::new(h as u32));
    let face = |f: usize| FaceId::new(f as u32);
    let mut table = Table { outer_face: Some(face(dcel.outer_face)), ..Table::default() };
    table.vertices = dcel
        .vertices
        .iter()
        .map(|v| Some(VertexRow { position: Some([v.pos.x, v.pos.y]), outgoing: v.outgoing_half_edge.map(half_edge) }))
        .collect();
    table.half_edges = dcel
        .half_edges
        .iter()
        .map(|h| {
            Some(HalfEdgeRow {
                origin: h.origin.map(vertex),
                twin: h.twin.map(half_edge),
                next: h.next.map(half_edge),
                prev: h.prev.map(half_edge),
                face: h.face.map(face),
            })
        })
        .collect();
    table.faces = dcel
        .faces
        .iter()
        .map(|f| Some(FaceRow { half_edge: f.incident_half_edge.map(half_edge), ..FaceRow::default() }))
        .collect();
    table
}

fn script(text: &str) -> dcel_kit::plane::Subdivision {
    let run = Script::parse(text, "script").unwrap().run();
    assert!(run.steps.iter().all(|step| !matches!(step.outcome, Outcome::Refused { .. })), "a call was refused");
    run.end
}

#[test]
fn the_starts_of_the_program_have_the_numbers_of_the_kit() {
    for text in ["rectangle", "polygon 0 0 4 0 3 3", "triangles 0 0 1 0 1 1 0 1 2 2 / 0 1 2 0 2 3 3 2 4"] {
        let words: Vec<&str> = text.split(' ').skip(1).collect();
        let mine = match text.split(' ').next().unwrap() {
            "rectangle" => start::rectangle(&[]).unwrap(),
            "polygon" => start::polygon(&words).unwrap(),
            _ => start::triangles(&words).unwrap(),
        };
        let (mine, kit) = (table_of(&mine), Table::from_view(&script(text)));
        for (h, (mine, kit)) in mine.half_edges.iter().zip(&kit.half_edges).enumerate() {
            assert_eq!(mine, kit, "h{h} of {text}");
        }
        isomorphic_with(&mine, &kit, &IsomorphismOptions::new())
            .unwrap_or_else(|difference| panic!("{text}: {difference}"));
        assert_eq!(dcel_kit::topology::violations(&mine), []);
    }
    for text in ["0 0 1 0 1 1 / 0 2 1", "0 0 1 0 1 1 / 0 1 3", "0 0 1 0 1 1 / 0 1 2 0 1 2", "0 0 1 0 1 1 / 0 1"] {
        let words: Vec<&str> = text.split(' ').collect();
        assert!(start::triangles(&words).is_err(), "{text}");
    }
}

#[test]
fn the_plane_accepts_the_drawing_and_the_solution_draws_the_same() {
    let text = include_str!("../figures/scripts/lab-04-drawing.dcels");
    for call in ["split_face ", "split_in_half "] {
        assert!(text.matches(call).count() >= 8, "{call}is called too seldom");
    }
    let reference = script(text);
    assert_eq!((reference.vertex_count(), reference.edge_count(), reference.face_count()), (22, 33, 13));

    let case = Case::new("drawing", Start::line("rectangle"));
    let mut case = case.step(Step::call::<&str>("drawing", [])).step(Step::Dump).step(Step::Svg);
    case.steps
        .extend((0..66).flat_map(|h| ["destination_by_next", "destination"].map(|f| Step::call(f, [format!("h{h}")]))));
    case.steps.extend((0..22).map(|v| Step::call("walk_vertex", [format!("v{v}")])));
    let replies = answers_to(&case);
    let Reply::Dump(mine) = &replies[1] else { panic!("{:?}", replies[1]) };
    let mine = mine.half_edges().unwrap();
    assert_eq!(dcel_kit::topology::violations(mine.as_ref()), []);
    let of_mine = |v: VertexId| position_key(mine.vertices[v.index()].unwrap().position.unwrap());
    let of_reference = |v: VertexId| position_key([reference.point(v).x, reference.point(v).y]);
    let options = IsomorphismOptions::new().keys(&of_mine, &of_reference);
    isomorphic_with(mine.as_ref(), &reference, &options).unwrap_or_else(|difference| panic!("{difference}"));

    let returned = |reply: &Reply| match reply {
        Reply::Called(called) => called.end.clone(),
        other => panic!("{other:?}"),
    };
    for (h, pair) in replies[3..135].chunks(2).enumerate() {
        assert_eq!(returned(&pair[0]), returned(&pair[1]), "h{h}");
    }
    for (v, reply) in replies[135..].iter().enumerate() {
        let star = reference_star(mine, v).into_iter().map(|h| Value::Id(h as u32)).collect();
        assert_eq!(returned(reply), CallEnd::Returned(star), "v{v}");
    }

    let Reply::Svg(picture) = &replies[2] else { panic!("{:?}", replies[2]) };
    let figure = include_str!("../figures/lab-04-drawing.svg");
    let comparison = compare(figure, picture, &Options::new()).unwrap();
    let differences: Vec<&str> = comparison.differences().iter().map(|d| d.text.as_str()).collect();
    assert!(comparison.is_equal(), "{differences:?}");
}

/// What the solution answers to a case.
fn answers_to(case: &Case) -> Vec<Reply> {
    let text = answers(&Case::input("T", [case]));
    let mut answers = read_answers(text.as_bytes(), "T", &[case], Schema::HalfEdges);
    assert!(answers.done && answers.cases[0].complete, "{text}");
    answers.cases.remove(0).replies
}

/// What the program of the lab prints, with the solution in it.
fn answers(text: &str) -> String {
    harness::answers::<calls::HalfEdgeLab>(text)
}

/// The half-edges that start at a vertex, counter-clockwise from the stored one, by the kit's own walk.
fn reference_star(table: &Table, v: usize) -> Vec<usize> {
    let kit = dcel_kit::plane::Subdivision::from_table(table).unwrap();
    kit.outgoing_half_edges(VertexId::new(v as u32)).map(HalfEdgeId::index).collect()
}

#[test]
fn no_reflection_or_turn_maps_the_drawing_to_itself() {
    let drawing = script(include_str!("../figures/scripts/lab-04-drawing.dcels"));
    let points: BTreeSet<[i64; 2]> =
        drawing.vertices().map(|v| drawing.point(v)).map(|p| [p.x, p.y].map(|x| (x * 4.0) as i64)).collect();
    for map in [|[x, y]: [i64; 2]| [-x, y], |[x, y]: [i64; 2]| [x, -y], |[x, y]: [i64; 2]| [-x, -y]] {
        let image: BTreeSet<[i64; 2]> = points.iter().map(|&p| map(p)).collect();
        assert_ne!(points, image);
    }
}

#[test]
fn a_dump_is_read_back_as_it_was() {
    let dump = |text: &str| {
        let text = answers(text);
        let (_, rest) = text.split_once("\ndump\n").unwrap_or_else(|| panic!("{text}"));
        rest.split_once("end_dump").unwrap().0.to_owned()
    };
    let text = dump("rectangle\nsplit_face h2 h8\ndump\n");
    let odd = text.replacen("half_edge 3 2 2 ", "half_edge 3 2 - ", 1).replacen("vertex 1 0 ", "vertex 1 0.1 ", 1);
    assert_ne!(odd, text);
    assert_eq!(dump(&format!("table\n{odd}end_table\ndump\n")), odd);
    for bad in ["vertex 9 0 0 -", "vertex 7 0 0 -", "vertex 6 0 inf -", "half_edge 14 - - - -", "edge 0", "face 3 x"] {
        let said = answers(&format!("table\n{odd}{bad}\nend_table\n"));
        assert!(said.contains(&format!("\nerror line {}: ", odd.lines().count() + 2)), "{bad}: {said}");
    }
}

// ---- the program of the lab -----------------------------------------------------------------------------

#[test]
fn large_starts_have_the_numbers_that_the_grader_expects() {
    for start in [convex(3), convex(300), wheel(3), wheel(40), grid(1, 1), grid(20, 15), grid(1, 30)] {
        let replies = answers_to(&Case::new("x", start.clone()).step(Step::Dump));
        let Reply::Dump(mine) = &replies[0] else { panic!("{replies:?}") };
        assert_eq!(Some(mine), start.structure(), "{start:?}");
        let kit = dcel_kit::plane::Subdivision::from_table(mine.half_edges().unwrap());
        assert!(kit.is_ok(), "{start:?}: {:?}", kit.err());
    }
    for bad in ["convex 2", "wheel x", "grid 3", "grid 0 4", "grid 100000 100000", "rectangle 1", "polygon 0 0 1"] {
        let said = answers(&format!("{bad}\n"));
        assert!(said.contains("error line 1: ") && said.contains("write `"), "{bad}: {said}");
    }
}

#[test]
fn changes_are_those_since_the_last_dump() {
    let case = Case::new("x", grid(4, 3)).step(Step::Changes).step(Step::call("split_face", ["h0", "h0.next.next"]));
    let case = case.step(Step::Changes).step(Step::call("split_in_half", ["h5"])).step(Step::Changes).step(Step::Dump);
    let replies = answers_to(&case);
    let tables: Vec<_> = replies
        .iter()
        .filter_map(|reply| match reply {
            Reply::Dump(structure) => structure.half_edges(),
            _ => None,
        })
        .collect();
    assert_eq!(Some(tables[0]), case.start.half_edges());
    assert_eq!(tables[1].faces.len(), tables[0].faces.len() + 1);
    assert_eq!(tables[2], tables[3], "what has changed, put over what was there, is what is there");
    let said = answers("dump changes\nrectangle\ndump changes\ndump changes\n");
    assert!(said.contains("error line 1: nothing was dumped yet"), "{said}");
    assert_eq!(said.matches("dump changes\nouter 0\nend_dump\n").count(), 2, "{said}");
}

#[test]
fn reads_are_counted_and_a_call_that_reads_too_much_is_ended_where_it_reads() {
    use harness::{Argument, Call, Lab, Meter, Start, Take, Value};
    struct Runaway;
    /// Follows next until it meets a half-edge that is not there; through a closure, or by an iterator.
    fn walk(dcel: &mut dcel::Dcel, of: &[Argument], _: Meter) -> Value {
        let mut h = of[0].id();
        loop {
            h = dcel.next(h);
            if h == usize::MAX {
                return Value::Nothing;
            }
        }
    }
    fn look(dcel: &mut dcel::Dcel, of: &[Argument], _: Meter) -> Value {
        let mut found = 0;
        for _ in 0..of[0].id() {
            found += dcel.half_edges.iter().filter(|record| record.next.is_none()).count();
        }
        Value::Id(found)
    }
    impl Lab for Runaway {
        type Structure = dcel::Dcel;
        const STARTS: &'static [Start<dcel::Dcel>] = calls::HalfEdgeLab::STARTS;
        const CALLS: &'static [Call<dcel::Dcel>] = &[
            Call { word: "walk", takes: &[Take::Id('h')], usage: "", run: walk },
            Call { word: "look", takes: &[Take::Id('h')], usage: "", run: look },
        ];
        const PICTURE: Option<fn(&dcel::Dcel) -> String> = None;
        const NAMED: &'static [(&'static str, &'static str)] = &[];
    }
    let said = harness::answers::<Runaway>("polygon 0 0 4 0 3 3\nwalk h2\nreads\nlook h2\nreads\n");
    // 3 vertices, 6 half-edges, 2 faces: 20 x 11 + 1,000 reads, and the one that was too much.
    assert!(said.contains("stopped 1221 circle ") && said.contains("lab_04.rs:"), "{said}");
    assert!(said.contains(" h0 h2 h4\nreads 1221\n"), "the circle that it ran in: {said}");
    assert!(said.contains("returned 0\nreads 12\n"), "twice through six half-edges: {said}");
    let said = harness::answers::<Runaway>("convex 300\nlook h599\nmany 600 look 5000\n");
    assert!(said.contains("stopped 19041 scan "), "{said}");
    let many = said.lines().find(|line| line.starts_with("asked ")).unwrap();
    // 0 + 600 + 1,200 + 1,800 reads, then 2,400: more than 5,000.
    assert!(many.starts_with("asked 5 answers 5 reads 6000 most 2400 h4 ") && many.contains("lab_04.rs:"), "{many}");
}

#[test]
fn values_are_written_with_all_that_they_are() {
    use harness::{Call, Lab, Start, Take, Value};
    struct Values;
    impl Lab for Values {
        type Structure = ();
        const STARTS: &'static [Start<()>] = &[];
        const CALLS: &'static [Call<()>] = &[
            Call {
                word: "area",
                takes: &[Take::Points],
                usage: "write points",
                run: |(), of, _| match &of[0] {
                    harness::Argument::Points(points) => {
                        Value::List(vec![Value::Number(0.1), Value::Polygon(points.clone())])
                    }
                    _ => Value::Refusal("no \"points\"".to_owned()),
                },
            },
            Call {
                word: "half",
                takes: &[Take::Number, Take::Truth],
                usage: "write a number and `true`",
                run: |(), of, _| match of {
                    [harness::Argument::Number(x), harness::Argument::Truth(true)] => Value::Point([x / 2.0, 1e-30]),
                    _ => Value::Refusal("it is \"false\"".to_owned()),
                },
            },
        ];
        const PICTURE: Option<fn(&()) -> String> = None;
        const NAMED: &'static [(&'static str, &'static str)] = &[];
    }
    let said = harness::answers::<Values>("area 0 0 4 0.5\nhalf 3 true\nhalf 3 false\nhalf 3\narea 1\n");
    for line in [
        "returned #0.1 <0,0 4,0.5>\n",
        "returned (1.5,0.000000000000000000000000000001)\n",
        "returned refused \"it is \\\"false\\\"\"\n",
        "error line 4: `half 3` is not understood; write a number and `true`\n",
        "error line 5: a point has two coordinates",
    ] {
        assert!(said.contains(line), "{line} in {said}");
    }
}

/// A square with an edge that dangles at v4, whose half-edge 8 is split.
#[test]
fn spur_case_splitting_a_dangling_edge_loses_no_half_edge() {
    let said = answers(
        "table\nouter 0\nvertex 0 0 0 8\nvertex 1 8 0 5\nvertex 2 8 7 6\nvertex 3 0 7 7\nvertex 4 3.5 2.5 9\n\
         half_edge 0 0 7 1 3 0\nhalf_edge 1 3 6 2 0 0\nhalf_edge 2 2 5 3 1 0\nhalf_edge 3 1 4 0 2 0\n\
         half_edge 4 0 3 5 9 1\nhalf_edge 5 1 2 6 4 1\nhalf_edge 6 2 1 7 5 1\nhalf_edge 7 3 0 8 6 1\n\
         half_edge 8 0 9 9 7 1\nhalf_edge 9 4 8 4 8 1\nface 0 0\nface 1 4\nend_table\n\
         split_in_half h8\ndump\nwalk_face f1\nwalk_vertices f1\n",
    );
    assert!(said.contains("call walk_face 1\nreturned 4 5 6 7 8 10 11 9\n"), "{said}");
    assert!(said.contains("call walk_vertices 1\nreturned 0 1 2 3 0 5 4 5\n"), "{said}");
    // Every half-edge is the next of one, and the prev of one.
    for column in [4, 5] {
        let rows = said.lines().filter_map(|line| line.strip_prefix("half_edge "));
        let mut links: Vec<u32> = rows.map(|row| row.split(' ').nth(column - 1).unwrap().parse().unwrap()).collect();
        links.sort_unstable();
        assert_eq!(links, (0..12).collect::<Vec<u32>>(), "{said}");
    }
}
