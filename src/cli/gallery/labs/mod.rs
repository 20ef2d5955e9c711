//! The reference figures of the labs: their handouts show them, and pictures of students are compared with them.
//!
//! ```text
//!   lab_01  lab_02  lab_03  lab_04  lab_05  lab_06  lab_07  lab_08  lab_09  lab_10  lab_11     a file a lab
//! ```

pub(super) mod lab_01;
pub(super) mod lab_02;
pub(super) mod lab_03;
pub(super) mod lab_04;
pub(super) mod lab_05;
pub(super) mod lab_06;
pub(super) mod lab_07;
pub(super) mod lab_08;
pub(super) mod lab_09;
pub(super) mod lab_10;
pub(super) mod lab_11;

use super::lesson::triangles;
use super::{Made, lesson};
use dcel_kit::figure::sketch::{Role, Sketch};
use dcel_kit::plane::{Point, Subdivision};

/// A dot at each of these places.
fn dots(sketch: &mut Sketch, role: Role, places: impl IntoIterator<Item: Into<Point>>) {
    for place in places {
        sketch.point(role, place);
    }
}

/// Euler's formula, with the numbers of a structure.
fn euler(structure: &Subdivision) -> String {
    let [v, e, f] = [structure.vertex_count(), structure.edge_count(), structure.face_count()];
    format!("V - E + F = {v} - {e} + {f} = {}", v as i64 - e as i64 + f as i64)
}

/// A polygon, its inside in one role and its sides in the other.
fn outline(sketch: &mut Sketch, [inside, sides]: [Role; 2], corners: &[[f64; 2]]) {
    sketch.region(inside, [corners.to_vec()]).plain();
    for (i, p) in corners.iter().enumerate() {
        sketch.path(sides, [*p, corners[(i + 1) % corners.len()]]).solid();
    }
}
