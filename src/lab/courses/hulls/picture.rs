//! The picture of the handout: the hull of all points but the last, the tangents from the last.

use super::hull::hull;
use super::polygons::Corner;
use super::starts::handout;
use super::tangents::from_point;
use crate::pictures::Plain;
use dcel_kit::plane::Point;

/// The picture as the student's program should draw it, with the coordinates that it writes: y points down in a file.
pub(super) fn plain() -> String {
    let all = handout();
    let mut out = Plain::new("-270 -170 540 340");
    let Some((&eye, points)) = all.split_last() else { return out.svg() };
    let corners: Vec<Corner> = (0..).zip(hull(points)).map(|(number, place)| Corner { number, place }).collect();
    out.face(corners.iter().map(|c| c.place));
    let mut line = |p: Point, q: Point| out.edge(p, q);
    (0..corners.len()).for_each(|i| line(corners[i].place, corners[(i + 1) % corners.len()].place));
    from_point(&corners, eye).into_iter().flatten().for_each(|c| line(eye, corners[c as usize].place));
    all.into_iter().for_each(|p| out.vertex(p));
    out.svg()
}
