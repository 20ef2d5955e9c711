//! Walks along the half-edges: round a face along next, round a vertex along prev and twin.

use super::{named, numbered, opened};
use crate::figure::SketchFilm;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::geometry::point::corners;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};
use crate::topology::{IdError, InnerComponent};

/// The film of a walk round a face: a frame for each of its half-edges, numbered as they come, at most `most` of them. Inner
/// components come after the outer boundary.
///
/// # Errors
/// If `f` does not exist.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::{FaceId, plane::Subdivision};
/// let film = algorithms::face_walk(&Subdivision::lab_rectangle(), FaceId::new(1), 40)?;
/// assert!(film.captions().any(|(_, text)| text.starts_with("h2 = h0.next")));
/// # Ok::<(), dcel_kit::topology::IdError>(())
/// ```
pub fn face_walk(s: &Subdivision, f: FaceId, most: usize) -> Result<SketchFilm, IdError> {
    s.check(f)?;
    let mut steps: Vec<(HalfEdgeId, String)> = Vec::new();
    for start in s.cycles(f) {
        let about = if steps.is_empty() {
            format!("{start} is the half-edge of {f}")
        } else {
            format!("{start} is the first half-edge of an inner component of {f}")
        };
        steps.push((start, about));
        let round: Vec<HalfEdgeId> = s.cycle(start).collect();
        steps.extend(round.windows(2).map(|pair| (pair[1], format!("{} = {}.next", pair[1], pair[0]))));
    }
    let isolated = s.inner_components(f).iter().filter(|inner| matches!(inner, InnerComponent::Isolated(_))).count();
    let mut start = Sketch::new();
    paint(&mut start, s, f);
    named(&mut start, s, &[]);
    let text = "it lies on the left of each of its half-edges";
    let mut film = opened(&format!("The face {f}"), text, s, Backdrop::Dimmed, start);
    walk(&mut film, s, &steps, most, |h| format!("from {} to {}", s.origin(h), s.destination(h)));
    let mut end = Sketch::new();
    paint(&mut end, s, f);
    let all: Vec<HalfEdgeId> = steps.iter().map(|&(h, _)| h).collect();
    arrows(&mut end, s, &all);
    named(&mut end, s, &[]);
    let back = match (all.first(), all.last()) {
        (Some(first), Some(last)) if s.next(*last) == *first => format!("{last}.next is {first} again: "),
        _ => String::new(),
    };
    let more = match isolated {
        0 => String::new(),
        1 => ", and one isolated vertex".to_owned(),
        count => format!(", and {count} isolated vertices"),
    };
    let heading = format!("{f} has {} half-edges", all.len());
    film.over(&heading, &format!("{back}{} in all{more}", all.len()), s, Backdrop::Dimmed, end);
    Ok(film)
}

/// The film of a walk round a vertex: a frame for each half-edge that starts there, counter-clockwise, at most `most` of
/// them.
///
/// # Errors
/// If `v` does not exist.
pub fn vertex_walk(s: &Subdivision, v: VertexId, most: usize) -> Result<SketchFilm, IdError> {
    s.check(v)?;
    let round: Vec<HalfEdgeId> = s.outgoing_half_edges(v).collect();
    let about = |(i, &h): (usize, &HalfEdgeId)| match i.checked_sub(1) {
        None => (h, format!("{h} is the outgoing half-edge of {v}")),
        Some(before) => (h, format!("{h} = {}.prev.twin", round[before])),
    };
    let steps: Vec<(HalfEdgeId, String)> = round.iter().enumerate().map(about).collect();
    let mut start = Sketch::new();
    start.point(Role::Main, s.point(v)).key("the vertex");
    named(&mut start, s, &[v]);
    let text = "the half-edges that start there, counter-clockwise";
    let mut film = opened(&format!("The vertex {v}"), text, s, Backdrop::Dimmed, start);
    walk(&mut film, s, &steps, most, |h| format!("to {}, with {} on its left", s.destination(h), s.face(h)));
    let mut end = Sketch::new();
    end.point(Role::Main, s.point(v)).key("the vertex");
    arrows(&mut end, s, &round);
    named(&mut end, s, &[v]);
    let text = match (round.first(), round.last()) {
        (Some(first), Some(last)) => format!("{last}.prev.twin is {first} again"),
        _ => "it is isolated".to_owned(),
    };
    film.over(&format!("{v} has degree {}", round.len()), &text, s, Backdrop::Dimmed, end);
    Ok(film)
}

/// A frame for each step: the half-edges so far, the last of them told apart.
fn walk(
    film: &mut SketchFilm,
    s: &Subdivision,
    steps: &[(HalfEdgeId, String)],
    most: usize,
    about: impl Fn(HalfEdgeId) -> String,
) {
    for (i, number) in numbered(steps.len(), most) {
        let (h, how) = &steps[i];
        let so_far: Vec<HalfEdgeId> = steps[..=i].iter().map(|&(h, _)| h).collect();
        let mut sketch = Sketch::new();
        arrows(&mut sketch, s, &so_far);
        named(&mut sketch, s, &[s.origin(*h), s.destination(*h)]);
        film.over(&format!("Half-edge {number}: {h}"), &format!("{how}, {}", about(*h)), s, Backdrop::Dimmed, sketch);
    }
}

/// Half-edges with their numbers, each on the left of its edge; the last one is where the walk is.
fn arrows(sketch: &mut Sketch, s: &Subdivision, walked: &[HalfEdgeId]) {
    let far = distance_beside(s);
    let numbered = walked.len() <= 60;
    for (i, &h) in walked.iter().enumerate() {
        let ends = [h, h.twin()].map(|h| s.point(s.origin(h)));
        let (role, key) = if i + 1 == walked.len() {
            (Role::Main, "where the walk is")
        } else {
            (Role::Secondary, "half-edge that was met before")
        };
        let arrow = sketch.path(role, beside(ends, far)).arrow().solid().title(h.to_string()).key(key);
        if numbered {
            arrow.label((i + 1).to_string());
        }
    }
}

fn paint(sketch: &mut Sketch, s: &Subdivision, f: FaceId) {
    if f != s.outer_face() {
        let rings = s.cycles(f).map(|h| s.cycle(h).map(|h| s.point(s.origin(h))).collect::<Vec<Point>>());
        sketch.region(Role::Main, rings.collect::<Vec<_>>()).key("the face");
    }
}

/// How far beside their edges half-edges are drawn: a small part of the picture.
fn distance_beside(s: &Subdivision) -> f64 {
    let [low, high] = corners(s.vertices().map(|v| s.point(v)));
    0.018 * (high.x - low.x).max(high.y - low.y)
}

/// The half-edge on the left of its edge, a little shorter than that.
fn beside([a, b]: [Point; 2], far: f64) -> [Point; 2] {
    let (x, y) = (b.x - a.x, b.y - a.y);
    let length = (x * x + y * y).sqrt();
    if length == 0.0 {
        return [a, b];
    }
    let aside = far.min(0.12 * length) / length;
    let short = (1.6 * far).min(0.2 * length) / length;
    [(a, short), (b, -short)].map(|(p, along)| Point::new(p.x - aside * y + along * x, p.y + aside * x + along * y))
}
