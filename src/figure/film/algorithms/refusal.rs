//! What an algorithm refuses: the film has one frame, with what the refusal is about.

use super::opened;
use crate::figure::SketchFilm;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::ids::{Element, FaceId, HalfEdgeId};
use crate::plane::{PlanarView, Point};

/// What the legend says of the marks.
const KEY: &str = "what is refused";
/// The heading of the frame.
pub(super) const HEADING: &str = "Refused";

/// The film of an algorithm that refuses what it is given: one frame with the structure, `why` as its text, and marks on the
/// elements and places that the refusal is about. Elements that are not there have no mark.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::plane::{Point, Subdivision};
/// use dcel_kit::{FaceId, ids::Element};
/// let lab = Subdivision::lab_rectangle();
/// let elements = [Element::from(FaceId::new(1))];
/// let film = algorithms::refusal(&lab, "f1 is no triangle", &elements, &[(Point::new(9.0, 9.0), "too far")]);
/// assert_eq!(film.captions().next(), Some(("Refused", "f1 is no triangle")));
/// ```
#[must_use]
pub fn refusal(given: &dyn PlanarView, why: &str, elements: &[Element], places: &[(Point, &str)]) -> SketchFilm {
    let mut sketch = Sketch::new();
    for &element in elements {
        match element {
            Element::Vertex(v) => {
                if let Some(p) = given.position(v) {
                    sketch.point(Role::Wrong, p).label(v.to_string()).key(KEY);
                }
            }
            Element::HalfEdge(h) => side(&mut sketch, given, h, element),
            Element::Edge(e) => side(&mut sketch, given, e.half_edges()[0], element),
            Element::Face(f) => {
                let corners: Vec<Point> = walk(given, f).filter_map(|h| given.position(given.origin(h)?)).collect();
                if corners.len() > 1 {
                    let first = corners[0];
                    sketch.path(Role::Wrong, corners.into_iter().chain([first])).title(f.to_string()).key(KEY);
                }
            }
        }
    }
    for (p, name) in places {
        sketch.point(Role::Wrong, *p).label(*name).key(KEY);
    }
    opened(HEADING, why, given, Backdrop::Dimmed, sketch)
}

fn side(sketch: &mut Sketch, given: &dyn PlanarView, h: HalfEdgeId, element: Element) {
    let end = given.twin(h).and_then(|twin| given.origin(twin));
    let ends = [given.origin(h), end].map(|v| given.position(v?));
    if let [Some(a), Some(b)] = ends {
        sketch.path(Role::Wrong, [a, b]).label(element.to_string()).key(KEY);
    }
}

/// The half-edges of the first border of a face; no more than there are, even where the links are wrong.
fn walk(given: &dyn PlanarView, f: FaceId) -> impl Iterator<Item = HalfEdgeId> {
    let first = given.half_edge(f);
    let step = move |&h: &HalfEdgeId| given.next(h).filter(|&next| Some(next) != first);
    std::iter::successors(first, step).take(given.half_edge_bound())
}
