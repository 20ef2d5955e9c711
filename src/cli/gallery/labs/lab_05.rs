//! The figures of lab 05: the reference, and how the list becomes a structure.

use super::Made;
use dcel_kit::figure::sketch::{Multiples, Role, Sketch};
use dcel_kit::figure::{self, Detail, FigureOptions, SketchFilm};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use dcel_lab::cases::handouts::{LIST_FACES as FACES, LIST_POINTS as POINTS};

fn handout() -> Made<Subdivision> {
    let points = POINTS.map(|[x, y]| Point { x, y }).to_vec();
    let mut list = PolygonList::new();
    FACES.into_iter().for_each(|face| list.push_face(face));
    Ok(Subdivision::from_polygons(points, &list)?)
}

/// The list of the handout as a structure.
pub(in crate::gallery) fn structure(options: &FigureOptions) -> Made<String> {
    let options = options.clone().detail(Detail::Edges);
    Ok(figure::structure(&handout()?, &options)?.to_svg())
}

/// How much of its size a face keeps, so that it lies apart from the others; and how far out its numbers stand.
const APART: f64 = 0.84;
const WITHIN: f64 = 0.62;

/// The faces as the list has them, each alone; the cycles of the faces; twins and the border.
pub(in crate::gallery) fn matching(options: &FigureOptions) -> Made<String> {
    let mut list = Sketch::new();
    for (f, face) in FACES.iter().enumerate() {
        let corners: Vec<[f64; 2]> = face.iter().map(|&v| POINTS[v as usize]).collect();
        let middle = [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / corners.len() as f64);
        let towards = |corner: &[f64; 2], by: f64| [0, 1].map(|axis| middle[axis] + by * (corner[axis] - middle[axis]));
        list.region(Role::Plain, [corners.iter().map(|corner| towards(corner, APART)).collect::<Vec<_>>()]).plain();
        for (i, corner) in corners.iter().enumerate() {
            let next = &corners[(i + 1) % corners.len()];
            list.path(Role::Main, [towards(corner, APART), towards(next, APART)]).arrow().solid();
            list.text(Role::Plain, towards(corner, WITHIN), face[i].to_string());
        }
        list.text(Role::Main, middle, format!("face {f}"));
    }
    let structure = handout()?;
    let mut panels = Multiples::new();
    panels.sketch("The list", "each face alone: corner 6 is in all four", list);
    panels.structure("The structure", "twins are matched, and the outer face has the border", &structure);
    Ok(panels.figure(options)?.to_svg())
}

/// Face by face: what waits for its twin, what has found it; in the end, the border.
pub(in crate::gallery) fn film(options: &FigureOptions) -> Made<String> {
    let mut film = SketchFilm::new();
    // The half-edges without a twin so far, by the ends of each.
    let mut waiting: Vec<[u32; 2]> = Vec::new();
    let mut matched: Vec<[u32; 2]> = Vec::new();
    for (f, face) in FACES.iter().enumerate() {
        let mut found: Vec<[u32; 2]> = Vec::new();
        for (i, &from) in face.iter().enumerate() {
            let to = face[(i + 1) % face.len()];
            match waiting.iter().position(|&other| other == [to, from]) {
                Some(at) => {
                    waiting.remove(at);
                    found.push([from, to]);
                }
                None => waiting.push([from, to]),
            }
        }
        let mut sketch = ground(&FACES[..=f]);
        arrows(&mut sketch, &waiting, Role::Secondary, "waits for its twin");
        arrows(&mut sketch, &matched, Role::Dimmed, "");
        arrows(&mut sketch, &found, Role::Right, "finds its twin");
        corners(&mut sketch);
        let corners: Vec<String> = face.iter().map(ToString::to_string).collect();
        let words = match found.len() {
            0 => "nobody waits for its half-edges".to_owned(),
            _ => found.iter().map(|[a, b]| format!("v{a} to v{b} finds v{b} to v{a}")).collect::<Vec<_>>().join(", "),
        };
        film.frame(&format!("Face {f}: {}", corners.join(" ")), &words, sketch);
        matched.extend(found);
    }
    let mut sketch = ground(FACES.as_slice());
    let border: Vec<[u32; 2]> = waiting.iter().map(|&[a, b]| [b, a]).collect();
    arrows(&mut sketch, &matched, Role::Dimmed, "");
    arrows(&mut sketch, &border, Role::Main, "half-edge of the outer face");
    corners(&mut sketch);
    film.frame("The border", "what still waits gets a twin in the outer face", sketch);
    Ok(film.strip(options)?.to_svg())
}

fn corners(sketch: &mut Sketch) {
    for (v, place) in POINTS.into_iter().enumerate() {
        sketch.point(Role::Plain, place).label(format!("v{v}"));
    }
}

/// The faces so far.
fn ground(faces: &[&[u32]]) -> Sketch {
    let mut sketch = Sketch::new();
    for face in faces {
        sketch.region(Role::Dimmed, [face.iter().map(|&v| POINTS[v as usize]).collect::<Vec<_>>()]).plain();
    }
    sketch
}

/// Half-edges, each on its left side of the edge.
fn arrows(sketch: &mut Sketch, halves: &[[u32; 2]], role: Role, key: &str) {
    const ASIDE: f64 = 9.0;
    const SHORT: f64 = 26.0;
    for &[from, to] in halves {
        let (a, b) = (POINTS[from as usize], POINTS[to as usize]);
        let way = [b[0] - a[0], b[1] - a[1]];
        let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
        let along = way.map(|x| x / length);
        let left = [-along[1] * ASIDE, along[0] * ASIDE];
        let end = |p: [f64; 2], by: f64| [0, 1].map(|i| p[i] + left[i] + by * along[i]);
        let item = sketch.path(role, [end(a, SHORT), end(b, -SHORT)]).arrow();
        if !key.is_empty() {
            item.key(key);
        }
    }
}
