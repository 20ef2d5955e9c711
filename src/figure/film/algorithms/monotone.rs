//! Triangulation by monotone pieces: the sweep over the corners, then the pieces.

use super::{all_triangles, faces_given, named, numbered};
use crate::figure::SketchFilm;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::ids::VertexId;
use crate::plane::{Corner, MonotoneEvent, Point, Subdivision, TriangulateError};

/// The film of the triangulation by monotone pieces: a frame for each corner that the sweep meets, with the diagonals from
/// there, and one for each triangle that is cut off; at most `most` events are shown.
///
/// # Errors
/// [`TriangulateError`].
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::plane::Subdivision;
/// let dart = [(0., 0.), (4., -3.), (2., 0.), (4., 3.)].map(Into::into);
/// let film = algorithms::monotone(&Subdivision::polygon(&dart)?, 40)?;
/// assert!(film.captions().any(|(heading, _)| heading.contains("v2 is a split corner")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn monotone(given: &Subdivision, most: usize) -> Result<SketchFilm, TriangulateError> {
    let mut events = Vec::new();
    let mut done = given.clone();
    let added = done.triangulate_monotone_observed(&mut events)?;
    let text = "a sweep from left to right cuts them into pieces without split and merge corners";
    let mut film = faces_given(text, given);

    let point = |v: VertexId| given.point(v);
    let (mut diagonals, mut cut): (Vec<[VertexId; 2]>, Vec<[VertexId; 3]>) = (Vec::new(), Vec::new());
    let mut merges: Vec<VertexId> = Vec::new();
    let mut next = 0;
    for (i, number) in numbered(events.len(), most) {
        for event in &events[next..i] {
            remember(event, &mut diagonals, &mut cut, &mut merges);
        }
        next = i;
        let mut sketch = Sketch::new();
        for corners in &cut {
            sketch.region(Role::Dimmed, [corners.map(point)]).hatched().key("cut off");
        }
        for ends in &diagonals {
            sketch.path(Role::Main, ends.map(point)).key("diagonal");
        }
        let (heading, text, about) = match events[i] {
            MonotoneEvent::Corner { at, corner } => {
                let p = point(at);
                sketch.line(Role::Event, p, Point::new(p.x, p.y + 1.0)).key("the sweep line");
                let (name, text, role) = words(corner);
                sketch.point(role, p).key("the corner");
                (format!("{at} is {name} corner"), text.to_owned(), vec![at])
            }
            MonotoneEvent::Diagonal { from, to } => {
                let p = point(from);
                sketch.line(Role::Event, p, Point::new(p.x, p.y + 1.0)).key("the sweep line");
                sketch.path(Role::Secondary, [from, to].map(point)).key("new diagonal");
                let why = if merges.contains(&to) {
                    format!("{to} is a merge corner, and {from} the next one that touches its gap")
                } else {
                    format!("{to} is the helper: the corner that touched the gap of {from} last")
                };
                (format!("diagonal {from} {to}"), why, vec![from, to])
            }
            MonotoneEvent::Cut(corners @ [a, b, c]) => {
                sketch.region(Role::Right, [corners.map(point)]).key("triangle");
                sketch.path(Role::Secondary, [a, c].map(point)).key("new diagonal");
                let text = format!("{b} turns left in what is left of its monotone piece: cut off by {a} {c}");
                (format!("triangle {a} {b} {c}"), text, corners.to_vec())
            }
        };
        named(&mut sketch, given, &about);
        film.over(&format!("Event {number}: {heading}"), &text, given, Backdrop::Dimmed, sketch);
    }
    let pieces = events.iter().filter(|event| matches!(event, MonotoneEvent::Diagonal { .. })).count();
    let text = format!("{} diagonals, {pieces} of them between monotone pieces", added.diagonals.len());
    all_triangles(&mut film, &text, &done, &added.diagonals);
    Ok(film)
}

fn remember(
    event: &MonotoneEvent,
    diagonals: &mut Vec<[VertexId; 2]>,
    cut: &mut Vec<[VertexId; 3]>,
    merges: &mut Vec<VertexId>,
) {
    match *event {
        MonotoneEvent::Corner { at, corner: Corner::Merge | Corner::Isolated } => merges.push(at),
        MonotoneEvent::Corner { .. } => {}
        MonotoneEvent::Diagonal { from, to } => diagonals.push([from, to]),
        MonotoneEvent::Cut(corners) => {
            cut.push(corners);
            diagonals.push([corners[0], corners[2]]);
        }
    }
}

/// The name of a kind of corner, what becomes of it, and how it is drawn.
fn words(corner: Corner) -> (&'static str, &'static str, Role) {
    match corner {
        Corner::Start => ("a start", "both sides run to the right: a gap opens", Role::Start),
        Corner::End => ("an end", "both sides come from the left: a gap closes", Role::Goal),
        Corner::Split => ("a split", "the face lies round it on the left: it is joined to the helper", Role::Wrong),
        Corner::Merge => ("a merge", "two gaps become one: the next corner of it is joined here", Role::Wrong),
        Corner::Lower => ("a lower", "the face lies above: the lower side goes on", Role::Main),
        Corner::Upper => ("an upper", "the face lies below: the upper side goes on", Role::Main),
        Corner::Isolated => ("an isolated", "it is joined to the left, and later to the right", Role::Wrong),
    }
}
