//! Ear clipping: which corners are no ears, and why; what is left after each cut.

use super::{all_triangles, faces_given, named, numbered};
use crate::figure::SketchFilm;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::geometry::predicates::orientation;
use crate::ids::VertexId;
use crate::plane::{EarEvent, Subdivision, TriangulateError};

/// The film of ear clipping: a frame for each corner that is asked, at most `most` of them.
///
/// # Errors
/// [`TriangulateError`].
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::plane::Subdivision;
/// let dart = [(0., 0.), (4., -3.), (2., 0.), (4., 3.)].map(Into::into);
/// let film = algorithms::ear_clipping(&Subdivision::polygon(&dart)?, 20)?;
/// assert!(film.captions().any(|(_, text)| text.contains("v2 lies in the triangle")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ear_clipping(given: &Subdivision, most: usize) -> Result<SketchFilm, TriangulateError> {
    let mut events = Vec::new();
    let mut done = given.clone();
    let added = done.triangulate_ears_observed(&mut events)?;
    let mut film = faces_given("an ear turns left, and no vertex lies in its triangle", given);
    let mut cut: Vec<[VertexId; 3]> = Vec::new();
    let mut next = 0;
    for (i, number) in numbered(events.len(), most) {
        for event in &events[next..i] {
            cut.extend(is_cut(event));
        }
        next = i + 1;
        let mut sketch = Sketch::new();
        for corners in &cut {
            let [a, b, c] = corners.map(|v| given.point(v));
            sketch.region(Role::Dimmed, [[a, b, c]]).hatched().key("cut off");
        }
        let corners @ [a, b, c] = match events[i] {
            EarEvent::Refused { corners, .. } | EarEvent::Cut(corners) => corners,
        };
        let at @ [p, q, r] = corners.map(|v| given.point(v));
        let text = match events[i] {
            EarEvent::Cut(_) => {
                sketch.region(Role::Right, [at]).key("ear");
                sketch.path(Role::Main, [p, r]).key("diagonal");
                format!("{b} turns left and no vertex lies in {a} {b} {c}: an ear, cut off by the diagonal {a} {c}")
            }
            EarEvent::Refused { is_convex: false, .. } => {
                sketch.path(Role::Wrong, [p, q, r]).key("corner that is no ear");
                format!("{b} turns right, or goes straight on: no ear")
            }
            EarEvent::Refused { .. } => {
                sketch.region(Role::Wrong, [at]).key("corner that is no ear");
                let inside = given.vertices().filter(|v| !corners.contains(v)).find(|&v| {
                    let v = given.point(v);
                    let sides = [[p, q], [q, r], [r, p]];
                    !at.contains(&v) && sides.iter().all(|&[from, to]| orientation(from, to, v).is_ge())
                });
                if let Some(v) = inside {
                    sketch.point(Role::Event, given.point(v)).key("vertex in its triangle");
                }
                let who = inside.map_or_else(|| "a vertex".to_owned(), |v| v.to_string());
                format!("{who} lies in the triangle {a} {b} {c}: no ear")
            }
        };
        named(&mut sketch, given, &corners);
        film.over(&format!("Corner {number}: {b}"), &text, given, Backdrop::Dimmed, sketch);
        cut.extend(is_cut(&events[i]));
    }
    let text = format!("{} diagonals", added.diagonals.len());
    all_triangles(&mut film, &text, &done, &added.diagonals);
    Ok(film)
}

fn is_cut(event: &EarEvent) -> Option<[VertexId; 3]> {
    match event {
        EarEvent::Cut(corners) => Some(*corners),
        EarEvent::Refused { .. } => None,
    }
}
