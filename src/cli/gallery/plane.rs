//! The reference figures of what is done with subdivisions.

use super::Made;
use super::lesson;
use dcel_kit::FaceId;
use dcel_kit::figure::sketch::{Backdrop, Multiples};
use dcel_kit::figure::{self, Detail, FigureOptions};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};

const OUTLINE: [[f64; 2]; 10] = [
    [0.0, 0.0],
    [5.0, 1.2],
    [10.0, 0.0],
    [9.0, 4.0],
    [12.0, 7.0],
    [7.0, 6.2],
    [5.5, 9.0],
    [4.0, 6.5],
    [0.0, 8.0],
    [1.5, 4.0],
];
const HOLE: [[f64; 2]; 4] = [[4.0, 3.0], [6.0, 2.4], [6.6, 4.4], [4.8, 4.8]];
const ALONE: [f64; 2] = [8.2, 5.2];

/// A face with a hole and an isolated vertex.
fn island() -> Made<Subdivision> {
    let points: Vec<Point> = OUTLINE.iter().chain(&HOLE).chain([&ALONE]).map(|&p| p.into()).collect();
    let closed = |first: u32, n: u32| (0..n).map(move |i| [first + i, first + (i + 1) % n]);
    let (outline, hole) = (OUTLINE.len() as u32, HOLE.len() as u32);
    let edges: Vec<[u32; 2]> = closed(0, outline).chain(closed(outline, hole)).collect();
    let mut island = Subdivision::from_graph(&points, &edges)?;
    island.mark_holes(&[Point::new(5.4, 3.6)])?;
    Ok(island)
}

/// Pieces, their triangles, and ears, side by side.
pub(super) fn triangulation(options: &FigureOptions) -> Made<String> {
    let island = island()?;
    let mut sheet = Multiples::new();
    let mut pieces = island.clone();
    let added = pieces.split_into_monotone(FaceId::new(1))?;
    let text = "every vertical line meets a monotone piece in one segment";
    sheet.over("Monotone pieces", text, &island, Backdrop::Plain, figure::diagonals_of(&pieces, &added.diagonals));
    for (method, heading, text) in [
        (TriangulationMethod::Monotone, "Their triangles", "14 half-edges, 2 rings: 14 + 2 · 2 - 2 = 16"),
        (TriangulationMethod::Ears, "Ears", "rings are joined by bridges, then corners are cut off"),
    ] {
        let mut triangles = island.clone();
        let added = triangles.triangulate(method)?;
        sheet.over(heading, text, &island, Backdrop::Plain, figure::diagonals_of(&triangles, &added.diagonals));
    }
    let options = options.clone().detail(Detail::Edges);
    Ok(sheet.figure(&options)?.to_svg())
}

/// A small square far from the middle of a large rectangle, and its surroundings.
pub(super) fn inset(options: &FigureOptions) -> Made<String> {
    let points =
        [(0., 0.), (1000., 0.), (1000., 500.), (0., 500.), (700., 300.), (704., 300.), (704., 303.), (700., 303.)];
    let plane = lesson::quads(points)?;
    Ok(figure::inset(&plane, None, options)?.to_svg())
}
