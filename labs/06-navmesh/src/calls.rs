//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::dcel::{Dcel, Point};
use crate::harness::{Call, Lab, Start, Take, Value};
use crate::svg::Svg;
use crate::{lab, map, start};

/// Lab 06.
pub struct NavMeshLab;

const FACE: Take = Take::Id('f');

fn point([x, y]: [f64; 2]) -> Point {
    Point { x, y }
}

fn points(path: Vec<Point>) -> Value {
    Value::List(path.into_iter().map(|p| Value::Point([p.x, p.y])).collect())
}

fn refusal(why: &str) -> Value {
    Value::Refusal(why.to_owned())
}

impl Lab for NavMeshLab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[
        Start { word: "map", usage: "write `map`", make: map::map },
        Start { word: "cells", usage: "write `cells 3 2`", make: map::cells },
        Start { word: "mesh", usage: "write `mesh 0 0 1 0 1 1 / 0 1 2`", make: map::mesh },
        Start { word: "wheel", usage: "write `wheel 40`", make: start::wheel },
    ];

    const CALLS: &'static [Call<Dcel>] = &[
        Call {
            word: "neighbours",
            takes: &[FACE],
            usage: "it takes one triangle, such as f1",
            run: |mesh, of, _| Value::ids(mesh.neighbours(of[0].id())),
        },
        Call {
            word: "locate_by_scan",
            takes: &[Take::Point],
            usage: "write `locate_by_scan 0.5 2`",
            run: |mesh, of, _| {
                mesh.locate_by_scan(point(of[0].point())).map_or_else(|| refusal("in no triangle"), Value::Id)
            },
        },
        Call {
            word: "locate",
            takes: &[FACE, Take::Point],
            usage: "write `locate f1 0.5 2`",
            run: |mesh, of, _| {
                let found = mesh.locate(of[0].id(), point(of[1].point()));
                found.map_or_else(|| refusal("in no triangle"), Value::Id)
            },
        },
        Call {
            word: "corridor",
            takes: &[FACE, FACE],
            usage: "write `corridor f1 f5`",
            run: |mesh, of, _| mesh.corridor(of[0].id(), of[1].id()).map_or_else(|| refusal("no corridor"), Value::ids),
        },
        Call {
            word: "portals",
            takes: &[Take::Wholes],
            usage: "write `portals 1 2 5`, with the numbers of triangles",
            run: |mesh, of, _| {
                let portals = mesh.portals(of[0].wholes());
                Value::List(portals.into_iter().map(|portal| Value::ids(vec![portal.left, portal.right])).collect())
            },
        },
        Call {
            word: "funnel",
            takes: &[Take::Point, Take::Point, Take::Points],
            usage: "write `funnel 0 0 5 0 2 1 2 -1`: start, goal, then left and right of each portal",
            run: |_, of, _| {
                let ends = of[2].points();
                let portals: Vec<(Point, Point)> =
                    ends.chunks_exact(2).map(|pair| (point(pair[0]), point(pair[1]))).collect();
                points(lab::funnel(point(of[0].point()), point(of[1].point()), &portals))
            },
        },
        Call {
            word: "path",
            takes: &[Take::Point, Take::Point],
            usage: "write `path 0 0 5 0`: start, then goal",
            run: |mesh, of, _| {
                let path = mesh.path(point(of[0].point()), point(of[1].point()));
                path.map_or_else(|| refusal("no path"), points)
            },
        },
    ];

    const PICTURE: Option<fn(&Dcel) -> String> = Some(|mesh| {
        let mut svg = Svg::default();
        lab::picture(mesh, map::START, map::GOAL, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("corridor", "map\n")];
}
