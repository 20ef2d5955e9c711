//! The picture of the handout: the hull of all points but the last, the tangents from the last.

use super::hull::hull;
use super::polygons::Corner;
use super::starts::handout;
use super::tangents::from_point;
use dcel_kit::plane::Point;
use std::fmt::Write;

/// The picture as the student's program should draw it, with the coordinates that it writes: y points down in a file.
pub(super) fn plain() -> String {
    let all = handout();
    let mut out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-270 -170 540 340\">\n".to_owned();
    let Some((&eye, points)) = all.split_last() else { return out + "</svg>\n" };
    let corners: Vec<Corner> = (0..).zip(hull(points)).map(|(number, place)| Corner { number, place }).collect();
    let at = |p: Point| format!("{},{}", p.x, 0.0 - p.y);
    let outline: Vec<String> = corners.iter().map(|c| at(c.place)).collect();
    let _ = writeln!(out, "<polygon points=\"{}\" fill=\"#dddddd\"/>", outline.join(" "));
    let mut line = |p: Point, q: Point| {
        let (y1, y2) = (0.0 - p.y, 0.0 - q.y);
        let _ = writeln!(out, "<line x1=\"{}\" y1=\"{y1}\" x2=\"{}\" y2=\"{y2}\" stroke=\"#000000\"/>", p.x, q.x);
    };
    (0..corners.len()).for_each(|i| line(corners[i].place, corners[(i + 1) % corners.len()].place));
    from_point(&corners, eye).into_iter().flatten().for_each(|c| line(eye, corners[c as usize].place));
    for p in all {
        let _ = writeln!(out, "<circle cx=\"{}\" cy=\"{}\" r=\"4\"/>", p.x, 0.0 - p.y);
    }
    out + "</svg>\n"
}
