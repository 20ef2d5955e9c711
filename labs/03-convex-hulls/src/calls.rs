//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::harness::{Call, Lab, Start, Take, Value};
use crate::polygons::{CornerId, Point, Polygons};
use crate::svg::Svg;
use crate::{halves, lab, start};

/// Lab 03.
pub struct HullLab;

const CORNER: Take = Take::Id('c');

impl Lab for HullLab {
    type Structure = Polygons;

    const STARTS: &'static [Start<Polygons>] = &[
        Start { word: "points", usage: "write `points 0 0 4 0 3 3`", make: start::points },
        Start {
            word: "polygons",
            usage: "write `polygons 0 0 4 0 3 3 / 6 0 9 1 7 3`, with a blank on both sides of `/`",
            make: start::polygons,
        },
        Start { word: "bowl", usage: "write `bowl 5000`", make: start::bowl },
        Start { word: "handout", usage: "write `handout`", make: start::handout },
    ];

    const CALLS: &'static [Call<Polygons>] = &[
        Call {
            word: "gift_wrapping",
            takes: &[],
            usage: "it stands alone in its line",
            run: |polygons, _, meter| {
                // All points are looked at for each corner.
                let count = polygons.points.len();
                meter.next_move(count * count);
                let first = polygons.gift_wrapping();
                outline(polygons, first)
            },
        },
        Call {
            word: "graham_scan",
            takes: &[],
            usage: "it stands alone in its line",
            run: |polygons, _, meter| {
                // To sort n points takes about n log n looks at two of them.
                meter.next_move(10 * polygons.points.len());
                let first = polygons.graham_scan();
                outline(polygons, first)
            },
        },
        Call {
            word: "tangents",
            takes: &[CORNER, Take::Point],
            usage: "write `tangents c0 9 2`: a corner of the polygon, then the point",
            run: |polygons, of, _| {
                let [x, y] = of[1].point();
                match polygons.tangents(of[0].id(), Point { x, y }) {
                    Some((right, left)) => Value::ids(vec![right, left]),
                    None => Value::Refusal("the point is not outside".to_owned()),
                }
            },
        },
        Call {
            word: "common_tangents",
            takes: &[CORNER, CORNER],
            usage: "write `common_tangents c0 c3`: a corner of each polygon",
            run: |polygons, of, _| {
                let ((a, b), (c, d)) = polygons.common_tangents(of[0].id(), of[1].id());
                Value::List(vec![Value::ids(vec![a, b]), Value::ids(vec![c, d])])
            },
        },
        Call {
            word: "merge",
            takes: &[CORNER, CORNER],
            usage: "write `merge c0 c3`: a corner of each polygon",
            run: |polygons, of, _| Value::Id(polygons.merge(of[0].id(), of[1].id())),
        },
        Call {
            word: "hull_by_halves",
            takes: &[],
            usage: "it stands alone in its line",
            run: |polygons, _, meter| {
                let first = halves::hull(polygons, meter, Polygons::merge);
                outline(polygons, first)
            },
        },
    ];

    const PICTURE: Option<fn(&Polygons) -> String> = Some(|polygons| {
        let mut svg = Svg::default();
        lab::picture(&mut polygons.clone(), &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("hull", "handout\n")];
}

/// The places of the corners of a polygon, by `next`.
fn outline(polygons: &Polygons, first: Option<CornerId>) -> Value {
    let mut places = Vec::new();
    if let Some(first) = first {
        let mut c = first;
        loop {
            let Point { x, y } = polygons.position(c);
            places.push([x, y]);
            c = polygons.next(c);
            if c == first {
                break;
            }
        }
    }
    Value::Polygon(places)
}
