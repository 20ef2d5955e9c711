//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::harness::{Argument, Call, Lab, Start, Take, Value};
use crate::polygon::Polygons;
use crate::svg::Svg;
use crate::{lab, start};

/// Lab 02.
pub struct TriangulationLab;

const CORNER: Take = Take::Id('c');
/// So many reads a triangulation may make, for each pair of corners.
const READS: u64 = 300;

impl Lab for TriangulationLab {
    type Structure = Polygons;

    const STARTS: &'static [Start<Polygons>] = &[
        Start { word: "polygon", usage: "write `polygon 0 0 4 0 3 3`", make: start::polygon },
        Start { word: "convex", usage: "write `convex 300`", make: start::convex },
    ];

    const CALLS: &'static [Call<Polygons>] = &[
        Call {
            word: "corners_of",
            takes: &[CORNER],
            usage: "it takes one corner, such as c0",
            run: |polygons, of, _| Value::ids(polygons.corners_of(of[0].id())),
        },
        Call {
            word: "split",
            takes: &[CORNER, CORNER],
            usage: "write `split c0 c2`",
            run: |polygons, of, _| match polygons.split(of[0].id(), of[1].id()) {
                Some(corner) => Value::Id(corner),
                None => Value::Refusal("there is nothing to split".to_owned()),
            },
        },
        Call {
            word: "is_diagonal",
            takes: &[CORNER, CORNER],
            usage: "write `is_diagonal c0 c2`",
            run: |polygons, of, _| Value::Truth(polygons.is_diagonal(of[0].id(), of[1].id())),
        },
        Call {
            word: "is_ear",
            takes: &[CORNER],
            usage: "it takes one corner, such as c0",
            run: |polygons, of, _| Value::Truth(polygons.is_ear(of[0].id())),
        },
        Call {
            word: "triangulate",
            takes: &[CORNER],
            usage: "it takes one corner, such as c0",
            run: |polygons, of: &[Argument], meter| {
                let corners = polygons.corners.len() as u64;
                meter.allow(READS * corners * corners);
                Value::ids(polygons.triangulate(of[0].id()))
            },
        },
    ];

    const PICTURE: Option<fn(&Polygons) -> String> = Some(|polygons| {
        let mut svg = Svg::default();
        lab::picture(polygons, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[(
        "triangulation",
        "polygon 0 0 -40 110 -90 -80 120 0 180 -100 90 -140 160 -210 150 -170 250 -30 220 -80 300 -20 190 10 200 -40 60 100 110 110 190 90 30 180\ntriangulate c0\n",
    )];
}
