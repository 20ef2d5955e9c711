//! The reference figure of the two primitives: vertex split and face split, before and after.

use super::Made;
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Backdrop, Multiples, Role, Sketch};
use dcel_kit::ids::{FaceId, HalfEdgeId, VertexId};
use dcel_kit::plane::{PlanarView, Point, Subdivision};
use dcel_kit::topology::{Dcel, PolygonList, Table};

type At = [f64; 2];

const HUB: At = [0.0, 0.0];

/// The corner of the rim at `i` sixths of a turn.
fn rim(i: u32) -> At {
    let (sin, cos) = (f64::from(i) * std::f64::consts::FRAC_PI_3).sin_cos();
    [4.0 * cos, 4.0 * sin]
}

/// A hub joined to a rim of six: `v0` in the middle, `v1` to the right, the others counter-clockwise.
fn wheel() -> Made<Subdivision> {
    let mut points = vec![Point::from((HUB[0], HUB[1]))];
    points.extend((0..6).map(rim).map(|[x, y]| Point::from((x, y))));
    let mut faces = PolygonList::new();
    (0..6).for_each(|i| faces.push_face(&[0, i + 1, (i + 1) % 6 + 1]));
    Ok(Subdivision::from_polygons(points, &faces)?)
}

/// The structure after an edit of the kernel, with places for some vertices.
fn drawn(before: &Subdivision, after: &Dcel, places: &[(VertexId, At)]) -> Table {
    let mut all = Table { outer_face: Some(FaceId::new(0)), ..Table::from_view(after) };
    for (v, row) in (0..).map(VertexId::new).zip(&mut all.vertices) {
        let place = places.iter().find(|(of, _)| *of == v).map(|&(_, place)| place);
        let position = place.or_else(|| before.position(v).map(|p| [p.x, p.y]));
        row.iter_mut().for_each(|row| row.position = position);
    }
    all
}

/// The new edge, and the edges that moved. All lines end beside the discs of their vertices.
fn marked(new: [At; 2], moved: &[[At; 2]]) -> Sketch {
    const DISC: f64 = 0.36;
    let inside = |[a, b]: [At; 2]| {
        let share = DISC / (b[0] - a[0]).hypot(b[1] - a[1]);
        let towards = |a: At, b: At| [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
        [towards(a, b), towards(b, a)]
    };
    let mut sketch = Sketch::new();
    for &ends in moved {
        sketch.path(Role::Secondary, inside(ends)).key("moves to the new vertex");
    }
    sketch.path(Role::Main, inside(new)).key("new");
    sketch
}

/// Six panels: a wheel and what vertex splits make of it, a face and its split.
pub(super) fn figure(options: &FigureOptions) -> Made<String> {
    let wheel = wheel()?;
    let spoke = |i: u32| -> HalfEdgeId {
        let end = VertexId::new(i % 6 + 1);
        wheel.outgoing_half_edges(VertexId::new(0)).find(|&h| wheel.destination(h) == end).unwrap_or(HalfEdgeId::new(0))
    };
    let split = |first: u32, last: u32, hub: At, new: At| -> Made<Table> {
        let mut after = wheel.topology().clone();
        let (_, m) = after.split_vertex(spoke(first), spoke(last))?;
        Ok(drawn(&wheel, &after, &[(VertexId::new(0), hub), (m, new)]))
    };
    let (left, right, middle, tip) = ([-0.9, 0.0], [0.9, 0.0], [2.0, 0.0], [1.75, 1.0]);
    let three = split(5, 2, left, right)?;
    let one = split(0, 1, HUB, middle)?;
    let none = split(1, 1, HUB, tip)?;

    let mut corners = PolygonList::new();
    corners.push_face(&[0, 1, 2, 3, 4, 5]);
    let rim_points = (0..6).map(rim).map(|[x, y]| Point::from((x, y))).collect();
    let face = Subdivision::from_polygons(rim_points, &corners)?;
    let from = |i: u32| {
        let mut round = face.half_edges().filter(|&h| face.face(h) != FaceId::new(0));
        round.find(|&h| face.origin(h) == VertexId::new(i)).unwrap_or(HalfEdgeId::new(0))
    };
    let mut two_faces = face.clone();
    two_faces.split_face(from(4), from(0))?;

    let mut sheet = Multiples::new();
    sheet.structure("A vertex", "six edges round it", &wheel);
    let moved = [5, 0, 1].map(|i| [right, rim(i)]);
    sheet.over(
        "Vertex split",
        "three edges move to the new vertex",
        &three,
        Backdrop::Plain,
        marked([left, right], &moved),
    );
    let moved = [[middle, rim(0)]];
    sheet.over("One edge moves", "a vertex is put on an edge", &one, Backdrop::Plain, marked([HUB, middle], &moved));
    sheet.over("None moves", "a spur in one corner", &none, Backdrop::Plain, marked([HUB, tip], &[]));
    sheet.structure("A face", "six corners", &face);
    let cut = [rim(4), rim(0)];
    sheet.over("Face split", "two corners are joined", &two_faces, Backdrop::Plain, marked(cut, &[]));
    Ok(sheet.figure(options)?.to_svg())
}
