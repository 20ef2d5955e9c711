//! The figures of lab 05: the reference, and how the list becomes a structure.

use crate::gallery::Made;
use dcel_kit::figure::sketch::{Multiples, Role, Sketch};
use dcel_kit::figure::{self, Detail, FigureOptions};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;

/// The points of the handout's list.
const POINTS: [[f64; 2]; 7] =
    [[-250.0, -150.0], [0.0, -150.0], [250.0, -150.0], [250.0, 150.0], [0.0, 150.0], [-250.0, 150.0], [0.0, 0.0]];
/// Its faces.
const FACES: [&[u32]; 4] = [&[0, 1, 6], &[1, 2, 3, 6], &[3, 4, 6], &[6, 4, 5, 0]];

fn handout() -> Made<Subdivision> {
    let points = POINTS.map(|[x, y]| Point { x, y }).to_vec();
    let mut list = PolygonList::new();
    FACES.into_iter().for_each(|face| list.push_face(face));
    Ok(Subdivision::from_polygons(points, &list)?)
}

/// The list of the handout as a structure.
pub(in crate::gallery) fn structure() -> Made<String> {
    let options = FigureOptions::new("The structure of lab 05").detail(Detail::Edges).id_prefix("triangle-list");
    Ok(figure::structure(&handout()?, &options)?.to_svg())
}

/// How much of its size a face keeps, so that it lies apart from the others; and how far out its numbers stand.
const APART: f64 = 0.84;
const WITHIN: f64 = 0.62;

/// The faces as the list has them, each alone; the cycles of the faces; twins and the border.
pub(in crate::gallery) fn matching() -> Made<String> {
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
    let options = FigureOptions::new("From a list of faces to half-edges").id_prefix("matching").width(405.0);
    Ok(panels.figure(&options)?.to_svg())
}
