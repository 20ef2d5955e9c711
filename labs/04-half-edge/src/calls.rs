//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::dcel::Dcel;
use crate::harness::{Argument, Call, Lab, Start, Take, Value};
use crate::svg::Svg;
use crate::{lab, pen, start};

/// Lab 04.
pub struct HalfEdgeLab;

const HALF_EDGE: Take = Take::Id('h');
/// A face, or a half-edge of it.
const FACE: Take = Take::IdOr('f', "face");

impl Lab for HalfEdgeLab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[
        Start { word: "rectangle", usage: "write `rectangle`", make: start::rectangle },
        Start { word: "polygon", usage: "write `polygon 0 0 4 0 3 3`", make: start::polygon },
        Start { word: "triangles", usage: "write `triangles 0 0 1 0 1 1 / 0 1 2`", make: start::triangles },
        Start { word: "convex", usage: "write `convex 300`", make: start::convex },
        Start { word: "wheel", usage: "write `wheel 40`", make: start::wheel },
        Start { word: "grid", usage: "write `grid 20 15`", make: start::grid },
    ];

    const CALLS: &'static [Call<Dcel>] = &[
        Call {
            word: "walk_face",
            takes: &[FACE],
            usage: "it takes one face, such as f1, or a half-edge of it",
            run: |dcel, of, _| Value::ids(dcel.incident_half_edges(of[0].id())),
        },
        Call {
            word: "walk_vertices",
            takes: &[FACE],
            usage: "it takes one face, such as f1, or a half-edge of it",
            run: |dcel, of, _| Value::ids(dcel.incident_vertices(of[0].id())),
        },
        Call {
            word: "walk_vertex",
            takes: &[Take::Id('v')],
            usage: "it takes one vertex, such as v0 or h0.origin",
            run: |dcel, of, _| Value::ids(dcel.outgoing_half_edges(of[0].id())),
        },
        Call {
            word: "destination",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| Value::Id(dcel.destination(of[0].id())),
        },
        Call {
            word: "destination_by_next",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| Value::Id(dcel.destination_by_next(of[0].id())),
        },
        Call {
            word: "split_face",
            takes: &[HALF_EDGE, HALF_EDGE],
            usage: "write `split_face h2 h8`",
            run: |dcel, of, _| Value::Truth(dcel.split_face(of[0].id(), of[1].id())),
        },
        Call {
            word: "split_in_half",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| {
                dcel.split_in_half(of[0].id());
                Value::Nothing
            },
        },
        Call {
            word: "drawing",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _: &[Argument], meter| {
                pen::draw(dcel, meter, lab::drawing);
                Value::Nothing
            },
        },
    ];

    const PICTURE: Option<fn(&Dcel) -> String> = Some(|dcel| {
        let mut svg = Svg::default();
        lab::picture(dcel, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("drawing", "rectangle\ndrawing\n")];
}
