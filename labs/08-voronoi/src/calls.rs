//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::dcel::{Dcel, Point};
use crate::harness::{Argument, Call, Lab, Start, Take, Value, dump};
use crate::svg::Svg;
use crate::{lab, lattice, start};

/// Lab 08.
pub struct VoronoiLab;

/// The sites of the handout and their Delaunay triangulation.
const SITES: &str = "-180 -110 -40 -150 120 -120 210 -20 150 110 10 150 -150 120 -230 10 -60 -20 60 40 -50 70 80 -60 / \
                     0 1 8 0 8 7 1 2 11 1 11 8 2 3 11 3 4 9 3 9 11 4 5 9 5 6 10 5 10 9 6 7 8 6 8 10 8 9 10 8 11 9";

impl Lab for VoronoiLab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[
        Start { word: "sites", usage: "write `sites`", make: sites },
        Start { word: "polygon", usage: "write `polygon 0 0 4 0 3 3`", make: start::polygon },
        Start { word: "triangles", usage: "write `triangles 0 0 1 0 1 1 / 0 1 2`", make: start::triangles },
        Start { word: "convex", usage: "write `convex 300`", make: start::convex },
        Start { word: "wheel", usage: "write `wheel 40`", make: start::wheel },
        Start { word: "grid", usage: "write `grid 20 15`", make: start::grid },
        Start { word: "lattice", usage: "write `lattice 150 150`", make: lattice::lattice },
    ];

    const CALLS: &'static [Call<Dcel>] = &[
        Call {
            word: "circle_centre",
            takes: &[Take::Point, Take::Point, Take::Point],
            usage: "write `circle_centre 0 0 4 0 0 3`",
            run: |_, of, _| {
                let [a, b, c] = [0, 1, 2].map(|i| point(&of[i]));
                match lab::circle_centre(a, b, c) {
                    Some(centre) => Value::Point([centre.x, centre.y]),
                    None => Value::Refusal("the points are on one line".to_owned()),
                }
            },
        },
        Call {
            word: "dual",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, _| Value::Structure(dump(&dcel.dual())),
        },
        Call {
            word: "voronoi",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _, _| Value::Structure(dump(&dcel.voronoi())),
        },
        Call {
            word: "ray",
            takes: &[Take::Id('h')],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| match dcel.ray(of[0].id()) {
                Some((start, direction)) => {
                    Value::List(vec![Value::Point([start.x, start.y]), Value::Point([direction.x, direction.y])])
                }
                None => Value::Refusal("the half-edge is not on the outer face".to_owned()),
            },
        },
        Call {
            word: "cell",
            takes: &[Take::Id('v')],
            usage: "it takes one vertex, such as v0",
            run: |dcel, of, _| {
                Value::List(dcel.cell(of[0].id()).into_iter().map(|p| Value::Point([p.x, p.y])).collect())
            },
        },
    ];

    const PICTURE: Option<fn(&Dcel) -> String> = Some(|dcel| {
        let mut svg = Svg::default();
        lab::picture(dcel, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("voronoi", "sites\n")];
}

fn point(argument: &Argument) -> Point {
    let [x, y] = argument.point();
    Point { x, y }
}

fn sites(words: &[&str]) -> Result<Dcel, String> {
    if !words.is_empty() {
        return Err("the sites of the handout are always the same".to_owned());
    }
    start::triangles(&SITES.split_whitespace().collect::<Vec<_>>())
}
