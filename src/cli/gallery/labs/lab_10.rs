//! The figures of lab 10.

use super::{Made, dots, euler, lesson};
use dcel_kit::figure::sketch::{Backdrop, Glyph, Multiples, Role, Sketch};
use dcel_kit::figure::{FigureOptions, SketchFilm};
use dcel_kit::ids::FaceId;
use dcel_kit::solid::{Platonic, Polyhedron};

/// Where a point of space is drawn: seen from the front, from above and a little from the right. y points up.
fn seen([x, y, z]: [f64; 3]) -> [f64; 2] {
    [100.0 * x + 40.0 * y, 100.0 * z + 30.0 * y - 15.0 * x]
}

/// A regular solid and its dual, whose vertices are in the middles of its faces, drawn as `glyph`.
fn pair(solid: Platonic, glyph: Glyph) -> Sketch {
    let solid = Polyhedron::platonic(solid);
    let dcel = solid.topology();
    let middle = |f: FaceId| seen(solid.face_mean(f));
    let mut sketch = Sketch::new();
    let edges = || solid.half_edges().filter(|&h| h < h.twin());
    for h in edges() {
        sketch.path(Role::Main, [dcel.origin(h), dcel.destination(h)].map(|v| seen(solid.point(v)))).solid();
    }
    for h in edges() {
        sketch.path(Role::Secondary, [middle(dcel.face(h)), middle(dcel.face(h.twin()))]).solid();
    }
    dots(&mut sketch, Role::Main, solid.vertices().map(|v| seen(solid.point(v))));
    for f in solid.faces() {
        sketch.point(Role::Secondary, middle(f)).glyph(glyph);
    }
    sketch
}

/// The picture that lab 10 asks for. Its dots are round, as those of the students: squares would be four edges each.
pub(in crate::gallery) fn cube(options: &FigureOptions) -> Made<String> {
    Ok(pair(Platonic::Cube, Glyph::Disc).figure(options)?.to_svg())
}

/// Three pairs of duals.
pub(in crate::gallery) fn duals(options: &FigureOptions) -> Made<String> {
    let mut panels = Multiples::new();
    panels.columns(3);
    for (solid, heading, text) in [
        (Platonic::Tetrahedron, "Tetrahedron", "inside it, its dual: a tetrahedron"),
        (Platonic::Cube, "Cube", "inside it, its dual: the octahedron"),
        (Platonic::Dodecahedron, "Dodecahedron", "inside it, its dual: the icosahedron"),
    ] {
        panels.sketch(heading, text, pair(solid, Glyph::Square));
    }
    Ok(panels.figure(options)?.to_svg())
}

/// The cube, spread out in the plane, loses edges until one face is left.
pub(in crate::gallery) fn film(options: &FigureOptions) -> Made<String> {
    let mut cube = lesson::cube()?;
    let mut film = SketchFilm::new();
    loop {
        let goes = cube.half_edges().find(|&h| cube.face(h) != cube.face(h.twin()));
        let mut sketch = Sketch::new();
        let Some(h) = goes else {
            film.over("One face is left: the edges are a tree", &euler(&cube), &cube, Backdrop::Plain, sketch);
            return Ok(film.strip(options)?.to_svg());
        };
        sketch.path(Role::Wrong, [cube.origin(h), cube.destination(h)].map(|v| cube.point(v))).key("goes next");
        let [left, right] = [h, h.twin()].map(|h| cube.face(h));
        film.over(&format!("{left} and {right} become one"), &euler(&cube), &cube, Backdrop::Plain, sketch);
        cube.join_faces(h)?;
    }
}
