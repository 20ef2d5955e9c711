//! What a case of this lab can say: a line for each function of yours.

use crate::harness::{Argument, Call, Lab, Start, Take, Value};
use crate::lab;
use crate::map::Map;
use crate::point::Point;

/// Lab 01.
pub struct PredicatesLab;

const THREE: &[Take] = &[Take::Point, Take::Point, Take::Point];
const FOUR: &[Take] = &[Take::Point, Take::Point, Take::Point, Take::Point];

impl Lab for PredicatesLab {
    /// The functions of this lab work on points alone.
    type Structure = ();

    const STARTS: &'static [Start<()>] = &[];

    const CALLS: &'static [Call<()>] = &[
        Call {
            word: "parallelogram_area",
            takes: THREE,
            usage: "it takes three points, such as 0 0 4 0 3 3",
            run: |(), of, _| Value::Number(lab::parallelogram_area(at(of, 0), at(of, 1), at(of, 2))),
        },
        Call {
            word: "triangle_area",
            takes: THREE,
            usage: "it takes three points, such as 0 0 4 0 3 3",
            run: |(), of, _| Value::Number(lab::triangle_area(at(of, 0), at(of, 1), at(of, 2))),
        },
        Call {
            word: "turn",
            takes: THREE,
            usage: "it takes three points, such as 0 0 4 0 3 3",
            run: |(), of, _| sign(lab::turn(at(of, 0), at(of, 1), at(of, 2))),
        },
        Call {
            word: "in_triangle",
            takes: FOUR,
            usage: "it takes a point and three corners, such as 2 1 0 0 4 0 3 3",
            run: |(), of, _| Value::Truth(lab::in_triangle(at(of, 0), at(of, 1), at(of, 2), at(of, 3))),
        },
        Call {
            word: "in_circle",
            takes: FOUR,
            usage: "it takes four points, such as 0 0 4 0 4 4 1 2",
            run: |(), of, _| sign(lab::in_circle(at(of, 0), at(of, 1), at(of, 2), at(of, 3))),
        },
        Call {
            word: "sign_of_sum",
            takes: &[Take::Numbers],
            usage: "it takes numbers, such as 1e16 1 -1e16",
            run: |(), of, _| sign(lab::sign_of_sum(of[0].numbers())),
        },
        Call {
            word: "orient2d_exact",
            takes: THREE,
            usage: "it takes three points, such as 0 0 4 0 3 3",
            run: |(), of, _| sign(lab::orient2d_exact(at(of, 0), at(of, 1), at(of, 2))),
        },
        Call {
            word: "filter",
            takes: THREE,
            usage: "it takes three points, such as 0 0 4 0 3 3",
            run: |(), of, _| match lab::filter(at(of, 0), at(of, 1), at(of, 2)) {
                Some(certain) => sign(certain),
                None => Value::Refusal("doubles cannot tell".to_owned()),
            },
        },
        Call {
            word: "orient2d",
            takes: THREE,
            usage: "it takes three points, such as 0 0 4 0 3 3",
            run: |(), of, _| sign(lab::orient2d(at(of, 0), at(of, 1), at(of, 2))),
        },
    ];

    const PICTURE: Option<fn(&()) -> String> = Some(|()| {
        let mut map = Map::default();
        lab::wrong_signs(&mut map);
        map.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("map", "case map\n")];
}

fn at(of: &[Argument], place: usize) -> Point {
    let [x, y] = of[place].point();
    Point { x, y }
}

fn sign(sign: i32) -> Value {
    Value::Number(f64::from(sign))
}
