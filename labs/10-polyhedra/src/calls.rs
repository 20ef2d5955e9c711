//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::harness::{Call, Lab, Start, Structure, Take, Value, dump};
use crate::polyhedron::{Polyhedron, WingedEdge};
use crate::svg::Svg;
use crate::{lab, start};

/// Lab 10.
pub struct PolyhedraLab;

const VERTEX: Take = Take::Id('v');
const HALF_EDGE: Take = Take::Id('h');
const ALONE: &str = "it stands alone in its line";

impl Lab for PolyhedraLab {
    type Structure = Polyhedron;

    const STARTS: &'static [Start<Polyhedron>] = &[
        Start { word: "platonic", usage: "write `platonic cube`", make: start::platonic },
        Start { word: "frame", usage: "write `frame`", make: start::frame },
        Start {
            word: "solid",
            usage: "write `solid 0 0 0 1 0 0 0 1 0 0 0 1 / 0 2 1 / 0 1 3 / 1 2 3 / 2 0 3`, with a blank on both sides of `/`",
            make: start::solid,
        },
        Start {
            word: "faces",
            usage: "write `faces 0 2 1 / 0 1 3 / 1 2 3 / 2 0 3`, with a blank on both sides of `/`",
            make: start::faces,
        },
        Start { word: "torus", usage: "write `torus 3 4`", make: start::torus },
    ];

    const CALLS: &'static [Call<Polyhedron>] = &[
        Call { word: "euler", takes: &[], usage: ALONE, run: |solid, _, _| Value::Number(solid.euler() as f64) },
        Call {
            word: "missing_edges",
            takes: &[],
            usage: ALONE,
            run: |solid, _, _| Value::Number(solid.missing_edges() as f64),
        },
        Call {
            word: "vertices_around",
            takes: &[VERTEX],
            usage: "it takes one vertex, such as v0 or h0.origin",
            run: |solid, of, _| Value::ids(solid.vertices_around(of[0].id())),
        },
        Call {
            word: "regular",
            takes: &[],
            usage: ALONE,
            run: |solid, _, _| match solid.regular() {
                Some((p, q)) => Value::ids(vec![p, q]),
                None => Value::Refusal("not regular".to_owned()),
            },
        },
        Call {
            word: "winged_edges",
            takes: &[],
            usage: ALONE,
            run: |solid, _, _| Value::List(solid.winged_edges().into_iter().map(row).collect()),
        },
        Call { word: "dual", takes: &[], usage: ALONE, run: |solid, _, _| Value::Structure(dump(&solid.dual())) },
        Call {
            word: "deficit_angle",
            takes: &[VERTEX],
            usage: "it takes one vertex, such as v0 or h0.origin",
            run: |solid, of, _| Value::Number(solid.deficit_angle(of[0].id())),
        },
        Call {
            word: "dihedral_angle",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |solid, of, _| Value::Number(solid.dihedral_angle(of[0].id())),
        },
        Call {
            word: "genus",
            takes: &[],
            usage: ALONE,
            run: |solid, _, _| match solid.genus() {
                Ok(genus) => Value::Id(genus),
                Err(v) => Value::Refusal(format!("v{v}")),
            },
        },
        Call {
            word: "merge_faces",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |solid, of, _| match solid.merge_faces(of[0].id()) {
                Ok(()) => Value::Nothing,
                Err(f) => Value::Refusal(format!("f{f}")),
            },
        },
        Call {
            word: "is_genus_0",
            takes: &[],
            usage: ALONE,
            run: |solid, _, meter| {
                // Each merge may go round a whole face.
                let records = (0..3).map(|table| Structure::len(solid, table) as u64).sum::<u64>();
                meter.allow(10_000 + records * records);
                Value::Truth(solid.is_genus_0())
            },
        },
    ];

    const PICTURE: Option<fn(&Polyhedron) -> String> = Some(|solid| {
        let mut svg = Svg::default();
        lab::picture(solid, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[
        ("tetrahedron", "platonic tetrahedron\n"),
        ("cube", "platonic cube\n"),
        ("octahedron", "platonic octahedron\n"),
        ("dodecahedron", "platonic dodecahedron\n"),
        ("icosahedron", "platonic icosahedron\n"),
    ];
}

/// The numbers of a row, in the order of its fields.
fn row(edge: WingedEdge) -> Value {
    let WingedEdge { edge, start, end, left, right, left_before, left_after, right_before, right_after } = edge;
    Value::ids(vec![edge, start, end, left, right, left_before, left_after, right_before, right_after])
}
