//! The reference figures of Delaunay triangulations and Voronoi diagrams.

use super::Made;
use super::lesson::triangles;
use dcel_kit::EdgeId;
use dcel_kit::figure::sketch::{Backdrop, Multiples, Role, Sketch};
use dcel_kit::figure::{self, Detail, FigureOptions};
use dcel_kit::plane::{Point, Subdivision, Window};

const SITES: [[f64; 2]; 14] = [
    [1.0, 1.2],
    [4.2, 0.6],
    [7.5, 1.6],
    [11.0, 0.8],
    [0.6, 4.4],
    [3.4, 3.6],
    [6.2, 4.8],
    [9.2, 3.8],
    [12.2, 4.6],
    [2.2, 7.4],
    [5.0, 7.8],
    [8.0, 7.0],
    [10.6, 7.6],
    [5.6, 2.4],
];

/// The diagram and its dual over each other.
pub(super) fn voronoi(options: &FigureOptions) -> Made<String> {
    let sites = SITES.map(Point::from);
    let delaunay = Subdivision::delaunay(&sites)?.subdivision;
    let voronoi = delaunay.voronoi()?;
    let cells = voronoi.cells(Window { low: Point::new(-1.0, -1.0), high: Point::new(14.0, 9.5) })?;
    Ok(figure::voronoi_cells(&voronoi, &cells, true, options)?.to_svg())
}

/// The circle round the triangle on the left of an edge, and the corner on the other side.
fn look(s: &Subdivision, edge: EdgeId, role: Role, words: &str) -> Sketch {
    let mut sketch = Sketch::new();
    let [h, t] = edge.half_edges();
    let [a, b, c, d] = [h, t, s.prev(h), s.prev(t)].map(|h| s.point(s.origin(h)));
    sketch.circumcircle(role, [a, b, c]).key(words);
    sketch.path(role, [a, b]).key("the edge in question");
    sketch.point(role, d);
    sketch
}

/// From a bad triangulation to the best, flip by flip.
pub(super) fn lawson(options: &FigureOptions) -> Made<String> {
    let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.5], [9.0, 4.0], [5.0, 6.0], [1.0, 4.5]].map(Point::from).to_vec();
    let before = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])?;
    let bad = before.non_delaunay_edges(|_| false).next();
    let (mut flipped, mut done) = (before.clone(), before.clone());
    done.make_delaunay(|_| false);
    let mut sheet = Multiples::new();
    if let Some(edge) = bad {
        flipped.flip_edge(edge.half_edges()[0])?;
        let wrong = look(&before, edge, Role::Wrong, "circle that holds a corner");
        sheet.over(
            "Not locally Delaunay",
            "the circle holds the corner beyond: flip",
            &before,
            Backdrop::Dimmed,
            wrong,
        );
        let right = look(&flipped, edge, Role::Right, "empty circle");
        sheet.over("After the flip", "the corner beyond lies outside of it", &flipped, Backdrop::Dimmed, right);
    }
    let mut circles = Sketch::new();
    for corners in triangles(&done) {
        circles.circumcircle(Role::Right, corners).key("empty circle");
    }
    sheet.over("Delaunay", "no edge is left to flip: every circle is empty", &done, Backdrop::Dimmed, circles);
    let options = options.clone().detail(Detail::Edges);
    Ok(sheet.figure(&options)?.to_svg())
}
