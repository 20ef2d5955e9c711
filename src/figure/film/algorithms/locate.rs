//! A walk to a point: which faces it crosses, and over which half-edge it leaves each of them.

use super::{numbered, opened};
use crate::figure::SketchFilm;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::ids::{FaceId, VertexId};
use crate::plane::{Location, Point, Subdivision, WalkEvent};
use crate::topology::IdError;

/// The film of [`locate_from`](Subdivision::locate_from): a frame for each face that the way crosses, and for each edge
/// along which it leads, at most `most` of them.
///
/// # Errors
/// If `start` does not exist.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::{VertexId, plane::{Point, Subdivision}};
/// let film = algorithms::location_walk(&Subdivision::lab_rectangle(), VertexId::new(0), Point::new(5.0, 5.0), 40)?;
/// assert_eq!(film.captions().last().unwrap().0, "The point lies in f1");
/// # Ok::<(), dcel_kit::topology::IdError>(())
/// ```
pub fn location_walk(s: &Subdivision, start: VertexId, p: Point, most: usize) -> Result<SketchFilm, IdError> {
    let mut events = Vec::new();
    let location = s.walk_from_observed(start, p, &mut events)?;
    let base = |about: &[VertexId]| {
        let mut sketch = Sketch::new();
        sketch.path(Role::Secondary, [s.point(start), p]).arrow().key("the straight way");
        sketch.point(Role::Start, s.point(start)).key("where the walk starts");
        sketch.point(Role::Goal, p).key("the point");
        for &v in about {
            sketch.text(Role::Plain, s.point(v), v.to_string());
        }
        sketch
    };
    let text = format!("a walk from {start}, face by face, towards the point");
    let mut film = opened("Where does the point lie?", &text, s, Backdrop::Dimmed, base(&[start]));
    for (i, number) in numbered(events.len(), most) {
        let faces = |event: &WalkEvent| if let WalkEvent::Face { face, .. } = event { Some(*face) } else { None };
        let about = match events[i] {
            WalkEvent::Along(h) | WalkEvent::Face { over: Some(h), .. } => vec![s.origin(h), s.destination(h)],
            WalkEvent::Face { over: None, .. } => Vec::new(),
        };
        let mut sketch = base(&about);
        for f in events[..i].iter().filter_map(faces).filter(|f| Some(*f) != faces(&events[i])) {
            paint(&mut sketch, s, f, Role::Dimmed, "face that was crossed");
        }
        let (heading, text) = match events[i] {
            WalkEvent::Along(h) => {
                let ends = [s.origin(h), s.destination(h)].map(|v| s.point(v));
                sketch.path(Role::Event, ends).key("edge on the way");
                (h.to_string(), format!("{h} lies on the way: on to {}", s.destination(h)))
            }
            WalkEvent::Face { face, half_edges, over } => {
                paint(&mut sketch, s, face, Role::Main, "face that is looked at");
                let looked = match half_edges {
                    1 => "one half-edge looked at".to_owned(),
                    count => format!("{count} half-edges looked at"),
                };
                let text = match over {
                    Some(h) => {
                        let ends = [s.origin(h), s.destination(h)].map(|v| s.point(v));
                        sketch.path(Role::Event, ends).key("edge over which the way leaves it");
                        format!("{looked}; the way leaves {face} over {h} for {}", s.face(h.twin()))
                    }
                    None => format!("{looked}; no edge lies between: it ends here"),
                };
                (face.to_string(), text)
            }
        };
        film.over(&format!("Step {number}: {heading}"), &text, s, Backdrop::Dimmed, sketch);
    }
    let mut end = base(&[]);
    let heading = match location {
        Location::Face(f) => {
            paint(&mut end, s, f, Role::Right, "the face of the point");
            format!("The point lies in {f}")
        }
        Location::Edge(h) => {
            end.path(Role::Right, [s.origin(h), s.destination(h)].map(|v| s.point(v))).key("the edge of the point");
            format!("The point lies on {}", h.edge())
        }
        Location::Vertex(v) => {
            end.point(Role::Right, s.point(v)).key("the vertex of the point");
            format!("The point is {v}")
        }
    };
    let looked: usize =
        events.iter().map(|e| if let WalkEvent::Face { half_edges, .. } = e { *half_edges } else { 0 }).sum();
    let text = format!("{looked} of {} half-edges were looked at", s.half_edge_count());
    film.over(&heading, &text, s, Backdrop::Dimmed, end);
    Ok(film)
}

/// A bounded face; the outer one has no area to be painted.
fn paint(sketch: &mut Sketch, s: &Subdivision, f: FaceId, role: Role, key: &str) {
    if f != s.outer_face() {
        let rings: Vec<Vec<Point>> = s.cycles(f).map(|h| s.cycle(h).map(|h| s.point(s.origin(h))).collect()).collect();
        sketch.region(role, rings).key(key).label(f.to_string());
    }
}
