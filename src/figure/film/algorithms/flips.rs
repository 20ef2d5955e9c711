//! Lawson's flips: why an edge has to go, and what takes its place.

use super::{named, numbered, opened};
use crate::figure::SketchFilm;
use crate::figure::canvas::text::counted;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::ids::{EdgeId, VertexId};
use crate::plane::{FlipEvent, Point, Subdivision};

/// Circles are drawn round so many triangles at most.
const MOST_CIRCLES: usize = 60;

/// The film of [`make_delaunay`](Subdivision::make_delaunay): two frames for each flip, one with the circle that forces it,
/// one with the new edge. At most `most` flips are shown.
///
/// ```
/// use dcel_kit::figure::{FigureOptions, algorithms};
/// use dcel_kit::plane::{Point, Subdivision};
/// let points = [(0., 0.), (3., -1.), (6., 0.), (3., 1.)].map(Point::from).to_vec();
/// let kite = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?;
/// let film = algorithms::lawson_flips(&kite, |_| false, 20);
/// assert_eq!(film.len(), 4);
/// assert!(film.strip(&FigureOptions::new("Kite"))?.to_svg().contains("edge to be flipped"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn lawson_flips(given: &Subdivision, is_fixed: impl Fn(EdgeId) -> bool, most: usize) -> SketchFilm {
    let mut events = Vec::new();
    given.clone().make_delaunay_observed(&is_fixed, &mut events);
    let flipped = |event: &FlipEvent| match *event {
        FlipEvent::Flipped(e) => Some(e),
        FlipEvent::Kept(_) => None,
    };
    let flips: Vec<EdgeId> = events.iter().filter_map(flipped).collect();
    let mut now = given.clone();
    let mut start = Sketch::new();
    let wrong: Vec<EdgeId> = now.non_delaunay_edges(&is_fixed).collect();
    for &e in &wrong {
        start.path(Role::Wrong, ends(&now, e)).title(format!("{e} is not locally Delaunay")).key(NOT_DELAUNAY);
    }
    named(&mut start, &now, &[]);
    let text = match wrong.len() {
        0 => "every edge is locally Delaunay".to_owned(),
        1 => "one edge is not locally Delaunay".to_owned(),
        count => format!("{count} edges are not locally Delaunay"),
    };
    let mut film = opened("The triangulation that is given", &text, &now, Backdrop::Dimmed, start);

    let mut next = 0;
    for (i, number) in numbered(flips.len(), most) {
        while next < i {
            flip(&mut now, flips[next]);
            next += 1;
        }
        let e = flips[i];
        let about = corners(&now, e);
        let [a, b, c, d] = about.map(|v| now.point(v));
        let mut sketch = Sketch::new();
        sketch.circumcircle(Role::Secondary, [a, b, c]).key("circle round one of its triangles");
        sketch.path(Role::Wrong, [a, b]).title(format!("{e}, which has to go")).key("edge to be flipped");
        sketch.point(Role::Event, d).key("corner inside of the circle");
        named(&mut sketch, &now, &about);
        let text = format!("{} lies inside of the circle, so {e} is flipped", about[3]);
        film.over(&format!("Flip {number}: {e}"), &text, &now, Backdrop::Dimmed, sketch);

        flip(&mut now, e);
        next = i + 1;
        let mut sketch = Sketch::new();
        sketch.circumcircle(Role::Right, [c, d, a]).key("circle with the other corner outside");
        sketch.circumcircle(Role::Right, [d, c, b]).key("circle with the other corner outside");
        sketch.path(Role::Main, [c, d]).title(format!("{e}, where it is now")).key("edge where it is now");
        named(&mut sketch, &now, &about);
        let text = "its four neighbours are looked at again";
        film.over(&format!("{e} joins {} and {}", about[2], about[3]), text, &now, Backdrop::Dimmed, sketch);
    }

    let mut end = Sketch::new();
    let triangles = now.faces().filter(|&f| f != now.outer_face() && now.incident_half_edges(f).count() == 3);
    let triangles: Vec<_> = triangles.collect();
    if triangles.len() <= MOST_CIRCLES {
        for f in triangles {
            let at: Vec<Point> = now.incident_vertices(f).map(|v| now.point(v)).collect();
            end.circumcircle(Role::Right, [at[0], at[1], at[2]]).title(format!("circle of {f}")).key("empty circle");
        }
    }
    named(&mut end, &now, &[]);
    let flips = counted(flips.len(), "flip", "flips");
    let text =
        format!("{flips}; each edge that may be flipped is locally Delaunay, so no vertex lies inside of a circle");
    film.over("The Delaunay triangulation", &text, &now, Backdrop::Dimmed, end);
    film
}

const NOT_DELAUNAY: &str = "edge that is not locally Delaunay";

fn ends(s: &Subdivision, e: EdgeId) -> [Point; 2] {
    e.half_edges().map(|h| s.point(s.origin(h)))
}

/// The ends of an edge and the third corners of its two triangles, the left one first.
fn corners(s: &Subdivision, e: EdgeId) -> [VertexId; 4] {
    let [h, t] = e.half_edges();
    [h, t, s.prev(h), s.prev(t)].map(|h| s.origin(h))
}

fn flip(s: &mut Subdivision, e: EdgeId) {
    let [h, _] = e.half_edges();
    let flipped = s.flip_edge(h);
    debug_assert!(flipped.is_ok(), "the algorithm flips {e} here");
}
