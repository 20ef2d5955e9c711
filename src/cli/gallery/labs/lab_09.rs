//! The figures of lab 09.

use super::{Made, dots, euler};
use dcel_kit::figure::sketch::{Backdrop, Role, Sketch};
use dcel_kit::figure::{FigureOptions, SketchFilm};
use dcel_kit::ids::{HalfEdgeId, VertexId};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::solid::Polyhedron;
use dcel_kit::solid::grow::Shape;

/// The six surfaces, and the radius and height of each row of their vertices, from below.
const STAGES: [(Shape, &[[f64; 2]]); 6] = [
    (Shape::Ring { sides: 6 }, &[[1.0, 0.0]]),
    (Shape::Cylinder { sides: 6, layers: 1 }, &[[1.0, 0.0], [1.0, 0.7]]),
    (Shape::Cylinder { sides: 6, layers: 2 }, &[[1.0, 0.0], [1.0, 0.7], [1.0, 1.4]]),
    (Shape::Cone { sides: 6, layers: 3 }, &[[1.0, 0.0], [0.7, 0.5], [0.4, 1.0], [0.0, 1.6]]),
    (Shape::Sphere { sides: 6, bands: 4 }, &[[0.0, -1.0], [0.7, -0.7], [1.0, 0.0], [0.7, 0.7], [0.0, 1.0]]),
    (Shape::Torus { n: 8, m: 4 }, &[[1.4, 0.0], [1.0, 0.4], [0.6, 0.0], [1.0, -0.4]]),
];

/// Where a vertex that the kit has placed belongs: the row is known by the kit's height and radius, the direction from
/// the axis stays.
fn placed(solid: &Polyhedron, rows: &[[f64; 2]], v: VertexId) -> [f64; 3] {
    let [x, y, z] = solid.point(v);
    let is_torus = rows.len() == 4 && rows[0][0] > 1.0;
    let row = if is_torus {
        // Once round the tube, whose middle is at a distance of 1 from the axis.
        let turn = z.atan2(x.hypot(y) - 1.0) / std::f64::consts::FRAC_PI_2;
        turn.round().rem_euclid(4.0) as usize
    } else {
        let below = |other: VertexId| solid.point(other)[2] < z - 1e-9;
        let mut heights: Vec<f64> = solid.vertices().filter(|&other| below(other)).map(|v| solid.point(v)[2]).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        heights.len()
    };
    let [radius, height] = rows[row];
    let reach = x.hypot(y);
    if radius == 0.0 { [0.0, 0.0, height] } else { [radius * x / reach, radius * y / reach, height] }
}

/// Where a point of space is drawn in a panel: seen from the front, from above and a little from the right. y points up.
fn seen(panel: usize, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let [right, down] = [panel % 3, panel / 3].map(|place| 400.0 * place as f64);
    [right + 100.0 * x + 45.0 * y, 100.0 * z + 60.0 * y - 10.0 * x - down]
}

/// The picture that lab 09 asks for: a ring, two cylinders, a cone, a sphere, a torus.
pub(in crate::gallery) fn growth(options: &FigureOptions) -> Made<String> {
    let mut sketch = Sketch::new();
    for (panel, (shape, rows)) in STAGES.into_iter().enumerate() {
        let solid = shape.build()?.polyhedron;
        let at = |v: VertexId| seen(panel, placed(&solid, rows, v));
        let dcel = solid.topology();
        for h in solid.half_edges().filter(|&h| h < h.twin()) {
            sketch.path(Role::Main, [at(dcel.origin(h)), at(dcel.destination(h))]).solid();
        }
        dots(&mut sketch, Role::Main, solid.vertices().map(at));
    }
    Ok(sketch.figure(options)?.to_svg())
}

/// A pole over a square, seen from above: a spur, then face splits.
pub(in crate::gallery) fn film(options: &FigureOptions) -> Made<String> {
    let mut square =
        Subdivision::polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(|[x, y]| Point { x, y }))?;
    let mut film = SketchFilm::new();
    let mut shoot = |heading: &str, square: &Subdivision, new: Option<HalfEdgeId>| {
        let mut sketch = Sketch::new();
        if let Some(h) = new {
            let ends = [square.origin(h), square.destination(h)].map(|v| square.point(v));
            sketch.path(Role::Main, ends).key("the new edge");
        }
        film.over(heading, &euler(square), square, Backdrop::Plain, sketch);
    };
    shoot("A ring of four sides", &square, None);
    let first = square.half_edges().find(|&h| square.face(h) != square.outer_face()).ok_or("a square has an inside")?;
    let (_, spur) = square.insert_dangling_edge(square.origin(first), Point { x: 1.7, y: 2.3 })?;
    shoot("The vertex split makes a spur", &square, Some(spur));
    // From the tip of the spur to the corners that follow, one after the other.
    let mut corner = square.next(first);
    let mut tip = spur.twin();
    for word in ["first", "second", "third"] {
        let (new, _) = square.split_face(corner, tip)?;
        shoot(&format!("The {word} face split"), &square, Some(new));
        tip = new.twin();
        corner = square.next(corner);
    }
    Ok(film.strip(options)?.to_svg())
}
