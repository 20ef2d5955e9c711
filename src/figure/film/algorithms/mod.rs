//! Films of algorithms: each is run once, watched, and its events are drawn.
//!
//! ```text
//!   algorithm ──events──▶ which of them are shown ──▶ a sketch for each ──▶ SketchFilm
//! ```
//!
//! Every film takes the greatest number of events that it shows. If there are more, some are left out evenly, never the
//! last; what is left out is said in the text of the next frame.
//!
//! ```text
//!   walks.rs     round a face, round a vertex            hull.rs           a convex hull, point by point
//!   locate.rs    a walk to a point, face by face         sweep.rs          where segments cross
//!   ears.rs      ear clipping, corner by corner          monotone.rs       triangulation by monotone pieces
//!   flips.rs     Lawson's flips                          voronoi.rs        the dual of a triangulation, cell by cell
//!   funnel.rs    paths: the funnel, the cones            climb.rs          hill climbing over a solid
//!   space_hull.rs  a convex hull in space                catmull_clark.rs  subdivision
//!   space.rs     solids on paper, a state a frame        refusal.rs        what an algorithm refuses
//! ```

#[cfg(feature = "solid")]
mod catmull_clark;
#[cfg(feature = "solid")]
mod climb;
mod ears;
mod flips;
#[cfg(feature = "navmesh")]
mod funnel;
mod hull;
mod locate;
mod monotone;
mod refusal;
#[cfg(feature = "solid")]
mod space;
#[cfg(feature = "solid")]
mod space_hull;
mod sweep;
mod voronoi;
mod walks;

#[cfg(feature = "solid")]
pub use catmull_clark::catmull_clark;
#[cfg(feature = "solid")]
pub use climb::hill_climbing;
pub use ears::ear_clipping;
pub use flips::lawson_flips;
#[cfg(feature = "navmesh")]
pub use funnel::{cones, funnel};
pub use hull::convex_hull;
pub use locate::location_walk;
pub use monotone::monotone;
pub use refusal::refusal;
#[cfg(feature = "solid")]
pub use space::refusal_in_space;
#[cfg(feature = "solid")]
pub use space_hull::convex_hull_in_space;
pub use sweep::segment_sweep;
pub use voronoi::voronoi;
pub use walks::{face_walk, vertex_walk};

use crate::figure::SketchFilm;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::ids::{EdgeId, VertexId};
use crate::plane::{PlanarView, Subdivision};

/// The names of vertices, of all if there are few, else of those that the frame is about.
fn named(sketch: &mut Sketch, s: &Subdivision, about: &[VertexId]) {
    let all = s.vertex_count() <= 40;
    for v in s.vertices().filter(|v| all || about.contains(v)) {
        sketch.text(Role::Plain, s.point(v), v.to_string());
    }
}

/// Which of `count` events are shown if at most `most` can be: evenly spread, the last one always.
fn shown(count: usize, most: usize) -> Vec<usize> {
    let most = most.max(1);
    if count <= most {
        return (0..count).collect();
    }
    (1..=most).map(|i| i * count / most - 1).collect()
}

/// "3 of 17" and what was left out before.
fn number(i: usize, before: Option<usize>, count: usize) -> String {
    let left_out = i - before.map_or(0, |before| before + 1);
    match left_out {
        0 => format!("{} of {count}", i + 1),
        _ => format!("{} of {count}, {left_out} not shown", i + 1),
    }
}

/// The events that are shown, each with its number.
fn numbered(count: usize, most: usize) -> impl Iterator<Item = (usize, String)> {
    let mut before = None;
    shown(count, most).into_iter().map(move |i| (i, number(i, before.replace(i), count)))
}

/// A film over quiet structures, with its first frame.
fn opened(heading: &str, text: &str, view: &dyn PlanarView, backdrop: Backdrop, sketch: Sketch) -> SketchFilm {
    let mut film = SketchFilm::new();
    film.quiet().over(heading, text, view, backdrop, sketch);
    film
}

/// The film of a triangulation, with its first frame.
fn faces_given(text: &str, given: &Subdivision) -> SketchFilm {
    let mut sketch = Sketch::new();
    named(&mut sketch, given, &[]);
    opened("The faces that are given", text, given, Backdrop::Plain, sketch)
}

/// The last frame of a triangulation.
fn all_triangles(film: &mut SketchFilm, text: &str, done: &Subdivision, diagonals: &[EdgeId]) {
    let mut sketch = Sketch::new();
    for e in diagonals {
        sketch.path(Role::Main, e.half_edges().map(|h| done.point(done.origin(h)))).key("diagonal");
    }
    named(&mut sketch, done, &[]);
    film.over("All triangles", text, done, Backdrop::Plain, sketch);
}

#[cfg(test)]
mod tests {
    use super::{number, shown};

    #[test]
    fn events_are_left_out_evenly_and_the_last_one_never() {
        assert_eq!(shown(4, 9), [0, 1, 2, 3]);
        assert_eq!(shown(10, 5), [1, 3, 5, 7, 9]);
        assert_eq!(shown(7, 3), [1, 3, 6]);
        assert_eq!(shown(3, 0), [2]);
        assert!(shown(0, 5).is_empty());
        assert_eq!([number(0, None, 7), number(3, Some(1), 7)], ["1 of 7", "4 of 7, 1 not shown"]);
    }
}
