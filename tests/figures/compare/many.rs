//! Drawings of 40,000 boxes, heads, dashes, areas or holes end quickly.

use cpu_time::ThreadTime;
use dcel_kit::compare::{Options, compare};
use std::time::Duration;

const COUNT: usize = 40_000;

/// A page with so many of something, each by its number and its place.
fn page(one: impl Fn(usize, f64, f64) -> String) -> String {
    let all: String = (0..COUNT).map(|i| one(i, (i % 200) as f64 * 3.0, (i / 200) as f64 * 2.0)).collect();
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">{all}</svg>")
}

#[test]
fn many_of_a_kind_end_quickly() {
    let line = |x: f64, y: f64, a: f64, b: f64| format!("<path stroke=\"red\" d=\"M{x} {y}L{a} {b}\"/>");
    let square = |x: f64, y: f64, side: f64| format!("<rect x=\"{x}\" y=\"{y}\" width=\"{side}\" height=\"{side}\"/>");
    let head = |x: f64, y: f64| {
        let strokes = format!("M{} {}L{} {y}L{} {}", x + 1.5, y - 0.2, x + 2.0, x + 1.5, y + 0.2);
        format!("<path fill=\"none\" stroke=\"red\" d=\"{strokes}\"/>")
    };
    let halo = |x: f64, y: f64| {
        let ring = format!("d=\"M{x} {y}h1v1z\"");
        format!("<path {ring}/><path fill=\"none\" stroke=\"white\" {ring}/>")
    };
    let circle = |x: f64, y: f64| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\".4\"/>");
    let holes: String = (0..COUNT).map(|i| format!("L{i} 9L{i} 20L{i}.5 20L{i}.5 9L{i} 9")).collect();
    let kinds = [
        ("boxes", page(|_, x, y| square(x, y, 1.0) + &line(x + 1.0, y + 0.5, x + 2.0, y + 0.5))),
        ("boxes in one place", page(|_, x, y| square(300.0, 200.0, 1.0) + &line(x, y, 300.0, 200.0))),
        ("a large box", page(|i, x, y| square(x, y, if i == 0 { 40.0 } else { 0.1 }) + &line(x, y, y, x))),
        ("heads", page(|_, x, y| line(x, y, x + 2.0, y) + &head(x, y))),
        (
            "dashes",
            page(|i, x, y| {
                let [a, b] = [7 * i % 600, 3 * i % 400].map(|part| part as f64);
                line(x, y, a, b).replace("/>", " stroke-dasharray=\"3 1000\"/>")
            }),
        ),
        ("squares over lines", page(|_, x, y| line(x, y, x + 300.0, y) + &square(x, y, 30.0))),
        (
            "holes",
            page(|i, _, _| if i == 0 { format!("<path fill=\"red\" d=\"M0 0{holes}z\"/>") } else { String::new() }),
        ),
        ("halos", page(|_, x, y| halo(x, y))),
        (
            "arrows",
            page(|_, x, y| {
                let ends = circle(x, y + 1.0) + &circle(x + 3.0, y + 1.0);
                ends + &format!("<path d=\"M{x} {}L{} {}L{x} {}z\"/>", y + 0.6, x + 3.0, y + 1.0, y + 1.4)
            }),
        ),
    ];
    for (name, svg) in kinds {
        let started = ThreadTime::now();
        let answer = compare(&super::shown::with(""), &svg, &Options::new());
        let time = started.elapsed();
        println!("{name}: {time:?}");
        assert!(answer.map_or(true, |answer| !answer.is_equal()), "{name}");
        assert!(time < Duration::from_secs(10), "{name}: {time:?}");
    }
}
