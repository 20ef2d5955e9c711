//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::dcel::{Dcel, HalfEdge, Point};
use crate::harness::{Call, Lab, Meter, Start, Take, Value};
use crate::svg::Svg;
use crate::{lab, mesh, start};

/// Lab 07.
pub struct DelaunayLab;

const HALF_EDGE: Take = Take::Id('h');
const ALONE: &str = "it stands alone in its line";

impl Lab for DelaunayLab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[
        Start { word: "sites", usage: "write `sites`", make: mesh::sites },
        Start { word: "triangles", usage: "write `triangles 0 0 4 0 0 3 / 0 1 2`", make: start::triangles },
        Start { word: "wheel", usage: "write `wheel 40`", make: start::wheel },
        Start { word: "slanted", usage: "write `slanted 4 3`", make: mesh::slanted },
    ];

    const CALLS: &'static [Call<Dcel>] = &[
        Call {
            word: "is_legal",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| Value::Truth(dcel.is_legal(of[0].id())),
        },
        Call {
            word: "can_flip",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| match dcel.can_flip(of[0].id()) {
                Ok(()) => Value::Truth(true),
                Err(refusal) => Value::Refusal(refusal.to_string()),
            },
        },
        Call {
            word: "flip",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| {
                dcel.flip(of[0].id());
                Value::Nothing
            },
        },
        Call {
            word: "delaunify",
            takes: &[],
            usage: ALONE,
            run: |dcel, _, meter| {
                allow_flips(dcel, meter);
                Value::ids(dcel.delaunify())
            },
        },
        Call {
            word: "count_flips",
            takes: &[],
            usage: ALONE,
            run: |dcel, _, meter| {
                allow_flips(dcel, meter);
                Value::Id(dcel.delaunify().len())
            },
        },
        Call { word: "summary", takes: &[], usage: ALONE, run: |dcel, _, _| Value::ids(summary(dcel)) },
        Call {
            word: "smallest_angle",
            takes: &[],
            usage: ALONE,
            run: |dcel, _, _| Value::Number(dcel.smallest_angle()),
        },
    ];

    const PICTURE: Option<fn(&Dcel) -> String> = Some(|dcel| {
        let mut svg = Svg::default();
        lab::picture(dcel, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("circles", "sites\ndelaunify\n")];
}

/// So many reads `delaunify` has for each half-edge; and in a small triangulation so many for each three vertices, so
/// that all edges can be looked at again after each flip.
const OF_A_HALF_EDGE: u64 = 120;
const OF_THREE: u64 = 50;
const SMALL: u64 = 50;

fn allow_flips(dcel: &Dcel, meter: Meter) {
    let n = (dcel.vertices.len() as u64).min(SMALL);
    meter.allow(1_000 + OF_A_HALF_EDGE * dcel.half_edges.len() as u64 + OF_THREE * n * n * n);
}

/// Of a structure too large to be read: the number of faces that are no triangles, the outer one aside; of half-edges
/// that break a rule: `h.twin.twin` is h, `h.next.prev` is h, `h.next` starts where `h.twin` starts and has the face of
/// h; and of half-edges longer than the square root of 2, of which the case has many in the beginning.
fn summary(dcel: &Dcel) -> Vec<usize> {
    let all: Vec<HalfEdge> = dcel.half_edges.iter().copied().collect();
    let places: Vec<Point> = dcel.vertices.iter().map(|vertex| vertex.pos).collect();
    let at = |h: Option<usize>| h.and_then(|h| all.get(h));
    let linked = |h: usize, row: &HalfEdge| {
        let (Some(twin), Some(next)) = (at(row.twin), at(row.next)) else { return false };
        let linked = twin.twin == Some(h) && next.prev == Some(h) && row.face.is_some();
        linked && next.origin == twin.origin && next.face == row.face && row.origin != twin.origin
    };
    let inside = |row: &HalfEdge| row.face != Some(dcel.outer_face);
    let three = |h: usize, row: &HalfEdge| {
        let third = at(row.next).and_then(|next| at(next.next)).and_then(|next| next.next);
        third == Some(h) && row.next != Some(h)
    };
    let place = |row: Option<&HalfEdge>| row.and_then(|row| row.origin).and_then(|v| places.get(v)).copied();
    let is_long = |row: &HalfEdge| {
        let (Some(from), Some(to)) = (place(Some(row)), place(at(row.twin))) else { return true };
        (to.x - from.x).powi(2) + (to.y - from.y).powi(2) > 2.0
    };
    let sides = all.iter().enumerate().filter(|(h, row)| inside(row) && !three(*h, row)).count();
    let broken = all.iter().enumerate().filter(|(h, row)| !linked(*h, row)).count();
    vec![sides, broken, all.iter().filter(|row| is_long(row)).count()]
}
