//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::dcel::Mesh;
use crate::harness::{Call, Lab, Start, Take, Value};
use crate::svg::Svg;
use crate::{lab, start};

/// Lab 11.
pub struct SupportLab;

fn refusal(why: &str) -> Value {
    Value::Refusal(why.to_owned())
}

impl Lab for SupportLab {
    type Structure = Mesh;

    const STARTS: &'static [Start<Mesh>] = &[
        Start { word: "empty", usage: "write `empty`", make: start::empty },
        Start { word: "gem", usage: "write `gem`", make: start::gem },
        Start { word: "cube", usage: "write `cube 3`", make: start::cube },
        Start { word: "soup", usage: "write `soup 0 0 0 1 0 0 0 1 0 / 0 1 2`", make: start::soup },
    ];

    const CALLS: &'static [Call<Mesh>] = &[
        Call {
            word: "add_vertex",
            takes: &[Take::Place],
            usage: "write `add_vertex 0 0 1`",
            run: |mesh, of, _| Value::Id(mesh.add_vertex(of[0].place())),
        },
        Call {
            word: "add_face",
            takes: &[Take::Whole, Take::Whole, Take::Whole],
            usage: "write `add_face 0 1 2`, with the numbers of vertices",
            run: |mesh, of, _| {
                let face = mesh.add_face(of[0].whole(), of[1].whole(), of[2].whole());
                face.map_or_else(|| refusal("no face"), Value::Id)
            },
        },
        Call {
            word: "remove_face",
            takes: &[Take::Whole, Take::Whole],
            usage: "write `remove_face 0 1`: the face on the left of the half-edge from v0 to v1",
            run: |mesh, of, _| {
                let side = mesh.half_edge_between(of[0].whole(), of[1].whole());
                let Some(f) = side.and_then(|side| mesh.face(side)) else {
                    return refusal("the edge map knows no face there");
                };
                mesh.remove_face(f);
                Value::Nothing
            },
        },
        Call {
            word: "remove_vertex",
            takes: &[Take::Whole],
            usage: "write `remove_vertex 3`",
            run: |mesh, of, _| {
                mesh.remove_vertex(of[0].whole());
                Value::Nothing
            },
        },
        Call {
            word: "support_by_scan",
            takes: &[Take::Place],
            usage: "write `support_by_scan 0 0 1`",
            run: |mesh, of, _| mesh.support_by_scan(of[0].place()).map_or_else(|| refusal("no vertex"), Value::Id),
        },
        Call {
            word: "climb",
            takes: &[Take::Id('v'), Take::Place],
            usage: "write `climb v0 0 0 1`",
            run: |mesh, of, _| Value::ids(mesh.climb(of[0].id(), of[1].place())),
        },
        Call {
            word: "support",
            takes: &[Take::Id('v'), Take::Place],
            usage: "write `support v0 0 0 1`",
            run: |mesh, of, _| Value::Id(mesh.support(of[0].id(), of[1].place())),
        },
    ];

    const PICTURE: Option<fn(&Mesh) -> String> = Some(|mesh| {
        let mut svg = Svg::default();
        lab::picture(mesh, start::FROM, start::DIRECTION, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("climb", "gem\n")];
}
