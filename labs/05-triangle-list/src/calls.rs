//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::dcel::{Dcel, HalfEdge, Point};
use crate::harness::{Call, Lab, Meter, Start, Take, Value};
use crate::lab;
use crate::refusal::Refusal;
use crate::start::{self, cut_cells, faces};
use crate::svg::Svg;

/// Lab 05.
pub struct TriangleListLab;

/// How many records a structure has for each corner of the list: the half-edge, its twin, a part of a face.
const RECORDS_OF_A_CORNER: usize = 3;

/// Up to so many corners, a call may search all half-edges for each of them: what that costs is asked of the large list.
const FEW_CORNERS: usize = 2_000;

/// Lets a call look at each half-edge again for each corner, if they are few.
fn allow_searches(corners: usize, records: usize, meter: Meter) {
    if corners <= FEW_CORNERS {
        let (corners, records) = (corners as u64, records as u64);
        meter.allow(1_000 + 20 * records + 8 * corners * corners);
    }
}

impl Lab for TriangleListLab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[
        Start { word: "vertices", usage: "write `vertices 4`", make: start::vertices },
        Start { word: "points", usage: "write `points 0 0 4 0 3 3`", make: start::at_points },
    ];

    const CALLS: &'static [Call<Dcel>] = &[
        Call {
            word: "check_faces",
            takes: &[Take::Wholes],
            usage: "write faces, each after its number of corners: `check_faces 3 0 1 2 3 0 2 3`",
            run: |dcel, of, _| outcome(lab::check_faces(dcel.vertices.len(), &faces(of[0].wholes()))),
        },
        Call {
            word: "add_face",
            takes: &[Take::Wholes],
            usage: "write the corners of one face: `add_face 0 1 2`",
            run: |dcel, of, _| Value::Id(dcel.add_face(of[0].wholes())),
        },
        Call {
            word: "match_twins",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, meter| {
                let corners = dcel.half_edges.len();
                allow_searches(corners, corners, meter);
                outcome(dcel.match_twins())
            },
        },
        Call {
            word: "close_border",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, meter| {
                let corners = dcel.half_edges.len();
                allow_searches(corners, corners, meter);
                outcome(dcel.close_border())
            },
        },
        Call {
            word: "from_faces",
            takes: &[Take::Wholes],
            usage: "write faces, each after its number of corners: `from_faces 3 0 1 2 3 0 2 3`",
            run: |dcel, of, meter| build(dcel, &faces(of[0].wholes()), meter),
        },
        Call {
            word: "from_cells",
            takes: &[Take::Whole],
            usage: "write `from_cells 2`, after `vertices 9`",
            run: |dcel, of, meter| {
                let n = of[0].whole();
                let there = n.checked_add(1).and_then(|n| n.checked_mul(n));
                if there != Some(dcel.vertices.len()) {
                    return Value::Refusal(format!(
                        "{n} times {n} cells have other than {} corners",
                        dcel.vertices.len()
                    ));
                }
                build(dcel, &cut_cells(n), meter)
            },
        },
        Call {
            word: "summary",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, _| Value::ids(summary(dcel)),
        },
    ];

    const PICTURE: Option<fn(&Dcel) -> String> = Some(|dcel| {
        let mut svg = Svg::default();
        lab::picture(dcel, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("structure", STRUCTURE)];
}

/// The list of the handout.
const STRUCTURE: &str = "points -250 -150 0 -150 250 -150 250 150 0 150 -250 150 0 0
from_faces 3 0 1 6 4 1 2 3 6 3 3 4 6 4 6 4 5 0
";

fn outcome(result: Result<(), Refusal>) -> Value {
    match result {
        Ok(()) => Value::Truth(true),
        Err(refusal) => Value::Refusal(refusal.to_string()),
    }
}

/// Calls `from_faces` with the vertices that are there; what it makes takes their place.
fn build(dcel: &mut Dcel, faces: &[Vec<usize>], meter: Meter) -> Value {
    let points: Vec<Point> = dcel.vertices.iter().map(|vertex| vertex.pos).collect();
    let corners: usize = faces.iter().map(Vec::len).sum();
    let records = points.len() + RECORDS_OF_A_CORNER * corners;
    meter.next_move(records);
    allow_searches(corners, records, meter);
    match lab::from_faces(&points, faces) {
        Ok(made) => {
            *dcel = made;
            Value::Truth(true)
        }
        Err(refusal) => Value::Refusal(refusal.to_string()),
    }
}

/// Of a structure too large to be read: the number of vertices, half-edges, faces, half-edges of the outer face, and
/// of half-edges that break a rule: `h.twin.twin` is h, `h.next.prev` is h, `h.next` starts where `h.twin` starts and
/// has the face of h.
fn summary(dcel: &Dcel) -> Vec<usize> {
    let all: Vec<HalfEdge> = dcel.half_edges.iter().copied().collect();
    let at = |h: Option<usize>| h.and_then(|h| all.get(h));
    let right = |h: usize, row: &HalfEdge| {
        let (Some(twin), Some(next)) = (at(row.twin), at(row.next)) else { return false };
        let linked = twin.twin == Some(h) && next.prev == Some(h);
        linked && next.origin == twin.origin && next.face == row.face && row.face.is_some() && row.origin != twin.origin
    };
    let outer = all.iter().filter(|row| row.face == Some(dcel.outer_face)).count();
    let broken = all.iter().enumerate().filter(|(h, row)| !right(*h, row)).count();
    vec![dcel.vertices.len(), all.len(), dcel.faces.len(), outer, broken]
}
