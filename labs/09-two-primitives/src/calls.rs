//! What a case of this lab can say: a line for each function of yours.

use crate::dcel::Dcel;
use crate::harness::{Call, Lab, Meter, Start, Take, Value};
use crate::lab;
use crate::svg::Svg;

/// Lab 09.
pub struct PrimitivesLab;

/// A shape may have so many half-edges at most: more are a slip of the keyboard.
const MOST: usize = 4_000_000;

impl Lab for PrimitivesLab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[];

    const CALLS: &'static [Call<Dcel>] = &[
        Call {
            word: "ring",
            takes: &[Take::Whole],
            usage: "write `ring 5`",
            run: |dcel, of, meter| grow(dcel, meter, of[0].whole(), || lab::ring(of[0].whole())),
        },
        Call {
            word: "torus_seed",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, meter| grow(dcel, meter, 4, lab::torus_seed),
        },
        Call {
            word: "split_vertex",
            takes: &[Take::Id('h'), Take::Id('h')],
            usage: "write `split_vertex h0 h3`",
            run: |dcel, of, _| made(dcel.split_vertex(of[0].id(), of[1].id())),
        },
        Call {
            word: "split_face",
            takes: &[Take::Id('h'), Take::Id('h')],
            usage: "write `split_face h0 h4`",
            run: |dcel, of, _| made(dcel.split_face(of[0].id(), of[1].id())),
        },
        Call {
            word: "spur",
            takes: &[Take::Id('h')],
            usage: "write `spur h0`",
            run: |dcel, of, _| Value::Id(dcel.spur(of[0].id())),
        },
        Call {
            word: "cut_corner",
            takes: &[Take::Id('h')],
            usage: "write `cut_corner h0`",
            run: |dcel, of, _| made(dcel.cut_corner(of[0].id())),
        },
        Call {
            word: "euler",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, _| Value::Number(dcel.euler() as f64),
        },
        Call {
            word: "genus",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, _| Value::Number(dcel.genus() as f64),
        },
        Call {
            word: "pole",
            takes: &[Take::Id('h')],
            usage: "write `pole h0`",
            run: |dcel, of, _| Value::Id(dcel.pole(of[0].id())),
        },
        Call {
            word: "divide",
            takes: &[Take::Id('h'), Take::Whole],
            usage: "write `divide h0 3`",
            run: |dcel, of, meter| {
                meter.next_move(dcel.half_edges.len() + of[1].whole().min(MOST));
                Value::Id(dcel.divide(of[0].id(), of[1].whole().min(MOST)))
            },
        },
        Call {
            word: "fill",
            takes: &[Take::Id('h'), Take::Whole, Take::Whole],
            usage: "write `fill h0 3 2`",
            run: |dcel, of, meter| {
                let cells = of[1].whole().saturating_mul(of[2].whole()).min(MOST);
                meter.next_move(dcel.half_edges.len() + RECORDS_OF_A_QUAD * cells);
                dcel.fill(of[0].id(), of[1].whole(), of[2].whole());
                Value::Nothing
            },
        },
        Call {
            word: "extrude",
            takes: &[Take::Id('h')],
            usage: "write `extrude h0`",
            run: |dcel, of, _| Value::Id(dcel.extrude(of[0].id())),
        },
        Call {
            word: "grid",
            takes: &[Take::Whole, Take::Whole],
            usage: "write `grid 3 2`",
            run: |dcel, of, meter| two(dcel, meter, [of[0].whole(), of[1].whole()], lab::grid),
        },
        Call {
            word: "torus",
            takes: &[Take::Whole, Take::Whole],
            usage: "write `torus 5 4`",
            run: |dcel, of, meter| two(dcel, meter, [of[0].whole(), of[1].whole()], lab::torus),
        },
        Call {
            word: "cylinder",
            takes: &[Take::Whole, Take::Whole],
            usage: "write `cylinder 6 2`: sides, layers",
            run: |dcel, of, meter| two(dcel, meter, [of[0].whole(), of[1].whole()], lab::cylinder),
        },
        Call {
            word: "cube",
            takes: &[Take::Whole],
            usage: "write `cube 3`",
            run: |dcel, of, meter| two(dcel, meter, [of[0].whole(), 6 * of[0].whole()], |steps, _| lab::cube(steps)),
        },
        Call {
            word: "cone",
            takes: &[Take::Whole, Take::Whole],
            usage: "write `cone 6 2`: sides, layers",
            run: |dcel, of, meter| two(dcel, meter, [of[0].whole(), of[1].whole()], lab::cone),
        },
        Call {
            word: "sphere",
            takes: &[Take::Whole, Take::Whole],
            usage: "write `sphere 6 4`: sides, bands",
            run: |dcel, of, meter| two(dcel, meter, [of[0].whole(), of[1].whole()], lab::sphere),
        },
        Call {
            word: "revolve",
            takes: &[Take::Id('h'), Take::Points],
            usage: "write `revolve h0 1 0 1 2`: a half-edge, then radius and height of each row",
            run: |dcel, of, _| {
                let places = dcel.revolve(of[0].id(), of[1].points());
                Value::List(places.into_iter().map(Value::Place).collect())
            },
        },
    ];

    // It makes its surfaces itself.
    const PICTURE: Option<fn(&Dcel) -> String> = Some(|_| {
        let mut svg = Svg::default();
        lab::picture(&mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("growth", "case growth\n")];
}

/// How many records a quad has: its four half-edges, its part of the vertices and faces.
const RECORDS_OF_A_QUAD: usize = 8;

fn made(half_edge: Option<usize>) -> Value {
    half_edge.map_or_else(|| Value::Refusal("None".to_owned()), Value::Id)
}

/// What a function makes takes the place of the structure.
fn grow(dcel: &mut Dcel, meter: Meter, quads: usize, make: impl FnOnce() -> Dcel) -> Value {
    if quads > MOST {
        return Value::Refusal("it would be too large".to_owned());
    }
    meter.next_move(RECORDS_OF_A_QUAD * (quads + 8));
    *dcel = make();
    Value::Truth(true)
}

fn two(dcel: &mut Dcel, meter: Meter, [n, m]: [usize; 2], make: fn(usize, usize) -> Dcel) -> Value {
    grow(dcel, meter, n.saturating_mul(m.saturating_add(2)), || make(n, m))
}
