//! The language of edits: every statement does what it says, every wrong word is named with its place.

use dcel_kit::plane::{PlaneJournal, Point, Subdivision};
use dcel_kit::script::{Edit, Outcome, Refusal, Script, of_edits};
use dcel_kit::topology::violations;
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use proptest::prelude::*;

fn h(number: u32) -> HalfEdgeId {
    HalfEdgeId::new(number)
}

fn play(text: &str) -> Vec<Outcome> {
    let script = Script::parse(text, "test").unwrap_or_else(|error| panic!("{error}"));
    script.run().steps.into_iter().map(|step| step.outcome).collect()
}

fn end(text: &str) -> Subdivision {
    Script::parse(text, "test").unwrap_or_else(|error| panic!("{error}")).run().end
}

/// The place is that of the wrong word, in characters; the message says what is wrong and what to try.
#[test]
fn every_wrong_word_is_named_with_its_place() {
    let cases = [
        ("", "1:1: the script is empty; a script starts with `rectangle`"),
        ("# nothing\r\n\r\n", "1:1: the script is empty"),
        ("split_face h0 h3", "1:1: `split_face` is no start; a script starts with"),
        ("rectangle 3", "1:11: `3` is one word too many for rectangle"),
        ("polygon 0 0 1 0 1", "1:18: polygon needs y"),
        ("polygon 0 0 1 0", "1:16: polygon needs x"),
        ("polygon 0 0 4 0 x 3", "1:17: `x` is not a number; write a number such as 1.5 or -250"),
        ("polygon 0 0 4 0 inf 3", "1:17: x is inf"),
        ("polygon 0 0 4 0 1 1e99", "1:19: y = 1e99 is outside the exact range"),
        ("polygon 0 0 0 3 4 0", "1:1: face 0 runs clockwise"),
        ("  polygon 0 0 4 4 4 0 0 4", "1:3: face 0 crosses itself"),
        ("triangles 0 0 4 0 4 3", "1:22: triangles needs x"),
        ("triangles 0 0 4 0 4 3 /", "1:24: triangles needs three points for each triangle"),
        (
            "triangles 0 0 4 0 4 3 / 0 1 3",
            "1:29: `3` is not the number of a point; the points are numbered from 0 to 2",
        ),
        ("rectangle\n\n  splitface h0 h3", "3:3: unknown statement `splitface`; known: split_face split_in_half"),
        ("rectangle\nrectangle", "2:1: `rectangle` cannot start the script again"),
        ("rectangle\nsplit_face h0", "2:14: split_face needs a half-edge"),
        ("rectangle\nsplit_face h0 h3 h4", "2:18: `h4` is one word too many for split_face"),
        ("rectangle\nsplit_face h0 h12", "2:15: `h12` is not given: the start has h0 .. h11; name what an edit makes"),
        ("rectangle\nsplit_face h0 wall", "2:15: `wall` is not known; given are h0 .. h11"),
        ("rectangle # é\n# é\né", "3:1: unknown statement `é`"),
        ("rectangle\njoin_faces h0.nxt", "2:15: `nxt` is not a link of a half-edge; known: next prev twin origin"),
        ("rectangle\njoin_faces h0.twin.origin.next", "2:27: `next` is not a link of a vertex; known: outgoing"),
        ("rectangle\nhighlight h0.edge.next", "2:19: `next` is not a link of an edge; an edge has no links"),
        ("rectangle\nsplit_in_half f1", "2:15: `f1` is a face, but split_in_half needs a half-edge; try f1.half_edge"),
        ("rectangle\nwalk_face v1", "2:11: `v1` is a vertex, but walk_face needs a half-edge or a face"),
        ("rectangle\nwalk_vertex f1", "2:13: `f1` is a face, but walk_vertex needs a half-edge or a vertex"),
        ("rectangle\nsplit_edge h0 1", "2:16: split_edge needs y"),
        ("rectangle\nhighlight", "2:10: highlight needs an element"),
        ("rectangle\ncaption", "2:8: caption needs a sentence"),
        ("rectangle\nlet", "2:4: let needs a name"),
        ("rectangle\nlet h12 = split_face h0 h4", "2:5: `h12` cannot be a name; a name begins with a letter"),
        ("rectangle\nlet dump = split_face h0 h4", "2:5: `dump` cannot be a name"),
        ("rectangle\nlet a split_face h0 h4", "2:7: `split_face` is one word too many for the name after let"),
        ("rectangle\nlet a =", "2:8: let needs an edit or a half-edge after `=`"),
        ("rectangle\nlet a = h0\nlet a = h1", "3:5: `a` is taken: line 2 has named it; choose another name"),
        ("rectangle\nlet a = join_faces h0", "2:9: join_faces makes nothing new that could be named"),
        ("rectangle\nlet a = dump", "2:9: dump makes nothing new that could be named"),
        ("rectangle\nlet a = split_face h0 a", "2:23: `a` is not known"),
    ];
    for (text, expected) in cases {
        let error = Script::parse(text, "lesson").map(|_| ()).expect_err(text).to_string();
        let expected = format!("lesson:{expected}");
        assert!(error.starts_with(&expected), "{text:?}\n  found    {error}\n  expected {expected}");
    }
}

#[test]
fn starts_give_their_half_edges_in_stated_order_inside_then_outside() {
    assert_eq!(Script::parse("rectangle", "test").unwrap().start(), &Subdivision::lab_rectangle());
    for text in ["polygon 0 0 4 0 4 3", "triangles 0 0 4 0 4 3 / 0 1 2"] {
        let structure = end(text);
        for k in 0..3 {
            let (inside, outside) = (h(2 * k), h(2 * k + 1));
            assert_eq!(structure.origin(inside), VertexId::new(k), "{text}");
            assert_eq!((structure.face(inside), structure.face(outside)), (FaceId::new(1), FaceId::new(0)), "{text}");
        }
    }
    let two = end("triangles 0 0 4 0 4 3 0 3 / 0 1 2 0 2 3");
    assert_eq!((two.edge_count(), two.face_count()), (5, 3));
    assert_eq!(two.face(h(5)), FaceId::new(2), "the third stated edge is 2 -> 0; its other side is in f2");
}

#[test]
fn names_and_links_lead_to_the_elements_they_say() {
    let text = "\u{feff}rectangle\r\nlet a = split_face h2 h0.prev.prev # v1 to v4\r\nlet c = split_in_half a.twin\r\n\
                let f = a.face\r\nlet other = c.twin.next\r\nhighlight f other c.origin a.destination h0.edge f.half_edge v0 f0.half_edge v1.outgoing\r\n";
    let outcomes = play(text);
    assert_eq!(outcomes[0].to_string(), "split_face h2 h8 returned h12, f2");
    assert_eq!(outcomes[1].to_string(), "split_in_half h13 returned v6, h14");
    assert_eq!(outcomes[2].to_string(), "is f2");
    assert_eq!(outcomes[3].to_string(), "is h12");
    assert_eq!(outcomes[4].to_string(), "highlighted f2, h12, v6, v4, e0, h12, v0, h1, h2");
}

#[test]
fn every_statement_does_what_it_says() {
    let mut by_hand = Subdivision::lab_rectangle();
    by_hand.split_face(h(2), h(8)).unwrap();
    by_hand.split_edge(h(12), Point::new(0.0, 50.0)).unwrap();
    let both = "rectangle\nlet a = split_face h2 h8\nlet c = split_edge a 0 50\n";
    assert_eq!(end(both), by_hand);
    by_hand.join_edges(h(12)).unwrap();
    by_hand.join_faces(h(12)).unwrap();
    assert_eq!(end(&format!("{both}join_edges a\njoin_faces a\n")), by_hand);

    let walks = play(
        "rectangle\nsplit_face h2 h8\nwalk_face h2\nwalk_face f1\nwalk_vertex h2\nwalk_vertex v1\ncaption  one two # three\ndump",
    );
    let texts: Vec<String> = walks[1..].iter().map(ToString::to_string).collect();
    assert_eq!(
        texts,
        [
            "along f1: h2 (v1) h4 (v2) h6 (v3) h13 (v4)",
            "along f1: h13 (v4) h2 (v1) h4 (v2) h6 (v3)",
            "round v1: h2 (v2) h12 (v4) h1 (v0)",
            "round v1: h2 (v2) h12 (v4) h1 (v0)",
            "one two",
            "dump",
        ]
    );
}

/// A name follows its element to the grave, and does not come back with a reused number.
#[test]
fn refusals_tell_the_reason_and_change_nothing() {
    let text = "rectangle\nlet a = split_face h2 h4\nlet b = split_face h2 h8\njoin_faces a\njoin_faces b\n\
                let c = split_face h0 h6\njoin_faces b\nhighlight b.next\njoin_edges h0\njoin_faces h0\nwalk_face h1";
    let outcomes = play(text);
    let refused: Vec<bool> = outcomes.iter().map(Outcome::is_refused).collect();
    assert_eq!(refused, [true, false, true, false, false, true, true, false, false, true], "{outcomes:#?}");
    let reason = |i: usize| outcomes[i].to_string();
    assert_eq!(
        reason(0),
        "split_face h2 h4 refused: h4 is next of h2: their origins are the two ends of h2; choose corners further apart"
    );
    assert_eq!(reason(2), "refused: `a` names nothing, because line 2 was refused");
    assert!(
        matches!(&outcomes[4], Outcome::Edited { returned, .. } if returned.half_edge() == Some(h(12))),
        "h12 is reused"
    );
    assert_eq!(reason(5), "refused: `b` was h12, which line 5 has removed; name another element");
    assert!(matches!(&outcomes[6], Outcome::Refused { reason: Refusal::Gone { line: 5, .. }, .. }));
}

#[test]
fn all_names_of_an_element_go_with_it() {
    let outcomes = play(
        "rectangle\nlet a = split_face h2 h8\nlet b = h2.prev\nlet e = a.edge\njoin_faces b\nhighlight a\nhighlight b\nhighlight e",
    );
    assert_eq!(outcomes[1].to_string(), "is h13", "{outcomes:#?}");
    for (outcome, (name, element)) in outcomes[4..].iter().zip([("a", "h12"), ("b", "h13"), ("e", "e6")]) {
        let gone = format!("refused: `{name}` was {element}, which line 5 has removed; name another element");
        assert_eq!(outcome.to_string(), gone);
    }
}

#[test]
fn a_given_word_stays_with_its_element() {
    let text = "triangles 0 0 4 0 4 3 0 3 / 0 1 2 0 2 3\njoin_faces h4\nlet a = split_face h0 h2.next\nwalk_face h5";
    let outcomes = play(text);
    assert_eq!(outcomes[1].to_string(), "split_face h0 h6 returned h4, f1", "e2 is reused: {outcomes:#?}");
    assert_eq!(outcomes[2].to_string(), "refused: `h5` was h5, which line 2 has removed; name another element");
}

#[test]
fn edits_print_a_script_that_replays() {
    let corners = [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.5]].map(Point::from);
    let edits = [
        "split_face h0 h4",
        "split_in_half h9",
        "split_face h0 h2",
        "split_edge h2 6.5 2.25",
        "join_edges h9",
        "join_faces h99",
        "join_faces h8",
    ]
    .map(|call| call.parse::<Edit>().unwrap());
    let mut by_hand = Subdivision::polygon(&corners).unwrap();
    edits.iter().for_each(|edit| drop(edit.apply(&mut by_hand, &mut PlaneJournal::new())));
    let text = of_edits(&corners, &edits);
    assert!(text.contains("let a1 = split_face h0 h4\nlet a2 = split_in_half a1.twin\n"), "{text}");
    assert!(text.contains("# join_faces h99: no such half-edge"), "{text}");
    assert_eq!(end(&text), by_hand, "{text}");
}

/// A script's words put together at random.
fn soup() -> impl Strategy<Value = String> {
    let words = [
        "rectangle",
        "polygon",
        "triangles",
        "/",
        "0",
        "4",
        "-3",
        "1e400",
        "nan",
        "let",
        "a",
        "b",
        "=",
        "split_face",
        "split_in_half",
        "split_edge",
        "join_faces",
        "join_edges",
        "walk_face",
        "walk_vertex",
        "highlight",
        "caption",
        "dump",
        "h0",
        "h2",
        "h8",
        "h99",
        "v1",
        "f0",
        "e0",
        "h0.next",
        "a.twin",
        "a.face.half_edge",
        "h2.twin.next.origin",
        "f0.half_edge",
        "..",
        "a.",
        ".next",
        "é",
        "#",
        "\n",
        "\r\n",
        "\t",
        "\u{feff}",
    ];
    let word = prop::sample::select(words.to_vec());
    (any::<bool>(), prop::collection::vec((word, prop::sample::select(vec![" ", "\n", " ", ""])), 0..40)).prop_map(
        |(start, words)| {
            let rest: String = words.iter().map(|(word, gap)| format!("{word}{gap}")).collect();
            format!("{}{rest}", if start { "rectangle\n" } else { "" })
        },
    )
}

/// The corners of the lab's rectangle.
const RECTANGLE: &str = "polygon -250 -150 0 -150 250 -150 250 150 0 150 -250 150\n";

/// Lines that have a fair chance.
fn sensible() -> impl Strategy<Value = String> {
    let element = prop::sample::select(vec![
        "h0",
        "h1",
        "h2",
        "h3",
        "h4",
        "h6",
        "h8",
        "h10",
        "h0.next",
        "h2.next.next",
        "h8.prev",
        "h0.next.twin",
        "h10.prev.prev",
    ]);
    let line = (0..5, element.clone(), element).prop_map(|(kind, a, b)| match kind {
        0 | 1 => format!("split_face {a} {b}\n"),
        2 => format!("split_in_half {a}\n"),
        3 => format!("join_faces {a}\n"),
        _ => format!("join_edges {a}\n"),
    });
    prop::collection::vec(line, 0..25).prop_map(|lines| format!("{RECTANGLE}{}", lines.concat()))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_words_never_panic_and_their_errors_have_a_place(text in soup()) {
        match Script::parse(&text, "soup") {
            Ok(script) => prop_assert!(violations(&script.run().end).is_empty()),
            Err(error) => {
                let line = text.lines().nth(error.line as usize - 1).unwrap_or("");
                prop_assert!(error.column as usize <= line.chars().count() + 1, "{error} in {line:?}");
            }
        }
    }

    #[test]
    fn random_scripts_keep_the_laws_and_print_back(text in sensible()) {
        let script = Script::parse(&text, "random").unwrap();
        let run = script.run();
        prop_assert!(violations(&run.end).is_empty(), "{text}");
        let edits: Vec<Edit> = run.steps.iter().filter_map(|step| match &step.outcome {
            Outcome::Edited { edit, .. } => Some(edit.clone()),
            _ => None,
        }).collect();
        let again = of_edits(&dcel_kit::plane::LAB_RECTANGLE, &edits);
        prop_assert_eq!(end(&again), run.end, "{}\nprinted back as\n{}", text, again);
    }
}
