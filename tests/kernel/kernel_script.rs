//! Scripts without coordinates: every word of the kernel, what is wrong with a line, and edits back to text.

use crate::common::{Random, h, v};
use dcel_kit::edits::{Argument, Row, rows};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::script::{Edit, KernelEdit, KernelStart, Outcome, Script, is_kernel_script, of_edits, of_kernel_edits};
use dcel_kit::topology::{Dcel, Journal, PolygonList, isomorphic};

fn call<const N: usize>(row: &'static Row, arguments: [Argument; N]) -> KernelEdit {
    KernelEdit::new(row, arguments).unwrap()
}

fn play(text: &str) -> (Vec<String>, Dcel) {
    let run = Script::parse_kernel(text, "test").unwrap_or_else(|error| panic!("{error}\n{text}")).run();
    (run.steps.iter().map(|step| step.outcome.to_string()).collect(), run.end)
}

#[test]
fn every_word_of_the_kernel_makes_its_edit() {
    let text = "surface 5 / 0 1 2 / 0 2 3\nlet a = split_vertex h0 h5\nsplit_edge h2\nlet c = split_face h2 h2.next.next\n\
                join_faces c\njoin_edges h2\njoin_vertices a\nflip_edge h4\nflip_edge h4\nlet p = split_isolated_vertex v4\n\
                join_vertices p\ncollapse_edge h0";
    let (told, end) = play(text);
    let mut by_hand = Dcel::from_triangles(5, &[[0, 1, 2], [0, 2, 3]]).unwrap().dcel;
    let d = &mut by_hand;
    let (a, _) = d.split_vertex(h(0), h(5)).unwrap();
    d.split_edge(h(2)).unwrap();
    let (c, _) = d.split_face(h(2), d.next(d.next(h(2)))).unwrap();
    d.join_faces(c).unwrap();
    d.join_edges(h(2)).unwrap();
    d.join_vertices(a).unwrap();
    d.flip_edge(h(4)).unwrap();
    d.flip_edge(h(4)).unwrap();
    let (p, _) = d.split_isolated_vertex(v(4)).unwrap();
    d.join_vertices(p).unwrap();
    let collapsed = d.collapse_edge(h(0)).map(|gone| format!("collapse_edge h0 returned {gone}"));
    assert_eq!(told.last(), Some(&collapsed.unwrap_or_else(|e| format!("collapse_edge h0 refused: {e}"))), "{told:#?}");
    assert_eq!(end, by_hand, "{told:#?}");
    assert_eq!(told[0], "split_vertex h0 h5 returned h10, v5");
    assert_eq!(told.iter().filter(|line| line.contains("refused")).count(), 0, "{told:#?}");
}

/// Random edits of all kinds from every kind of start: the printed script replays to the same structure, its ids
/// and its journal included, and prints as itself.
#[test]
fn edits_of_the_kernel_print_a_script_that_replays() {
    let tetrahedron = PolygonList::from_triangles(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    let starts = [
        KernelStart::Torus,
        KernelStart::Ring(1),
        KernelStart::Ring(6),
        KernelStart::Surface { vertices: 6, faces: tetrahedron },
        KernelStart::Surface { vertices: 2, faces: PolygonList::new() },
    ];
    let mut made = [0; 9];
    let mut refused = 0;
    for seed in 0..400 {
        let start = &starts[seed as usize % starts.len()];
        let mut random = Random(seed);
        let mut d = start.build().unwrap();
        let mut journal = Journal::new();
        let mut edits = Vec::new();
        for _ in 0..14 {
            let any = |random: &mut Random, d: &Dcel| h(random.below(d.half_edge_bound() + 1) as u32);
            let (a, mut b) = (any(&mut random, &d), any(&mut random, &d));
            let kind = random.below(9);
            if d.has_half_edge(a) && random.below(4) > 0 {
                let steps = random.below(5);
                b = (0..steps).fold(a, |x, _| if kind == 1 { d.ccw(x) } else { d.next(x) });
            }
            let point = d.vertices().find(|&v| d.outgoing(v).is_none());
            let edit = match kind {
                0 => call(&rows::split_face, [a.into(), b.into()]),
                1 => call(&rows::split_vertex, [a.into(), b.into()]),
                2 => call(&rows::split_edge, [a.into()]),
                3 => call(&rows::split_isolated_vertex, [point.unwrap_or(v(random.below(9) as u32)).into()]),
                4 => call(&rows::join_faces, [a.into()]),
                5 => call(&rows::join_edges, [a.into()]),
                6 => call(&rows::join_vertices, [a.into()]),
                7 => call(&rows::collapse_edge, [a.into()]),
                _ => call(&rows::flip_edge, [a.into()]),
            };
            let done = edit.apply(&mut d, &mut journal).is_ok();
            made[kind] += usize::from(done);
            refused += usize::from(!done);
            edits.push(edit);
        }
        let text = of_kernel_edits(start, &edits);
        assert!(is_kernel_script(&text), "{text}");
        let run = Script::parse_kernel(&text, "printed").unwrap_or_else(|e| panic!("{e}\n{text}")).run();
        assert_eq!(run.end, d, "seed {seed}:\n{text}");
        assert!(isomorphic(&run.end, &d).is_ok(), "seed {seed}:\n{text}");
        let mut replayed = Vec::new();
        for step in &run.steps {
            if let Outcome::Edited { journal, .. } = &step.outcome {
                replayed.extend_from_slice(journal.changes());
            }
        }
        assert_eq!(replayed, journal.changes(), "seed {seed}:\n{text}");
        let of_made = of_kernel_edits(start, &run.edits());
        let again = Script::parse_kernel(&of_made, "again").unwrap_or_else(|e| panic!("{e}\n{of_made}"));
        assert_eq!(again.run().edits(), run.edits(), "seed {seed}:\n{of_made}");
        assert_eq!(of_kernel_edits(start, &again.run().edits()), of_made, "seed {seed}");
    }
    assert!(made.iter().all(|&n| n > 30) && refused > 500, "{made:?} made, {refused} refused");
}

/// A vertex that an edit made has no number; it is named while a half-edge leads to it.
#[test]
fn a_vertex_that_lost_its_edges_keeps_its_name() {
    let start = KernelStart::Surface { vertices: 1, faces: PolygonList::new() };
    let edits = [
        "split_isolated_vertex v0",
        "join_vertices h1",
        "split_isolated_vertex v1",
        "split_isolated_vertex v7",
        "join_faces h9",
    ]
    .map(|call| call.parse::<KernelEdit>().unwrap());
    assert_eq!(
        of_kernel_edits(&start, &edits),
        "surface 1\nlet a1 = split_isolated_vertex v0\nlet p1 = a1.destination\njoin_vertices a1.twin\n\
         let a3 = split_isolated_vertex p1\n# split_isolated_vertex v7: no such vertex\n# join_faces h9: no such half-edge\n"
    );
}

#[test]
fn wrong_lines_of_the_kernel_are_named_with_their_place() {
    let cases = [
        ("", "1:1: the script is empty; a script without coordinates starts with `torus`"),
        ("rectangle", "1:1: `rectangle` is no start; a script without coordinates"),
        ("torus 3", "1:7: `3` is one word too many for torus"),
        ("ring", "1:5: ring needs a whole number up to 1000000; `ring` takes the number of its corners"),
        ("ring 2000000000", "1:6: `2000000000` is not a whole number up to 1000000"),
        ("ring 0", "1:1: a polygon needs at least one corner"),
        ("surface 3 / 0 1", "1:1: face 0 has a cycle with 2 corners"),
        ("surface 4 / 0 1 2 / 0 1 x", "1:25: `x` is not a whole number"),
        ("surface 4 / 0 1 2 / 1 2 4", "1:1: face 1: vertex 4 does not exist, there are 4"),
        ("surface 4 /", "1:12: surface needs a whole number"),
        ("torus\nring 3", "2:1: `ring` cannot start the script again"),
        (
            "torus\nsplit_in_half h0",
            "2:1: unknown statement `split_in_half`; known: split_face split_edge split_vertex",
        ),
        ("torus\nsplit_edge h0 1 2", "2:15: `1` is one word too many for split_edge"),
        ("torus\nsplit_vertex h0", "2:16: split_vertex needs a half-edge"),
        (
            "torus\nsplit_isolated_vertex h0",
            "2:23: `h0` is a half-edge, but split_isolated_vertex needs a vertex; try h0.origin",
        ),
        ("torus\nlet a = collapse_edge h0", "2:9: collapse_edge makes nothing new that could be named"),
    ];
    for (text, expected) in cases {
        let error = Script::parse_kernel(text, "k").map(drop).expect_err(text).to_string();
        assert!(error.starts_with(&format!("k:{expected}")), "{text:?}\n  found    {error}\n  expected {expected}");
    }
    let plane = Script::parse("rectangle\nsplit_vertex h0 h1", "k").map(drop).unwrap_err().to_string();
    assert!(plane.starts_with("k:2:1: unknown statement `split_vertex`"), "{plane}");
}

#[test]
fn a_diagonal_of_the_plane_is_flipped_and_printed() {
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.5]].map(Point::from);
    let edits = ["split_face h0 h4", "flip_edge h9"].map(|call| call.parse::<Edit>().unwrap());
    let text = of_edits(&corners, &edits);
    assert!(text.ends_with("let a1 = split_face h0 h4\nflip_edge a1.twin\n"), "{text}");
    let run = Script::parse(&text, "flip").unwrap().run();
    assert_eq!(run.steps[1].outcome.to_string(), "flip_edge h9 returned nothing");
    let mut by_hand = Subdivision::polygon(&corners).unwrap();
    by_hand.split_face(h(0), h(4)).unwrap();
    by_hand.flip_edge(h(9)).unwrap();
    assert_eq!(run.end, by_hand);
    let refused = Script::parse("rectangle\nflip_edge h0", "flip").unwrap().run();
    assert!(refused.steps[0].outcome.to_string().contains("is no triangle"), "{:?}", refused.steps[0]);
}
