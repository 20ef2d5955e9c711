//! Solids on paper, a state a frame, all seen from one place.

use super::refusal::HEADING;
use crate::figure::SketchFilm;
use crate::figure::kinds::solid::{Camera, HiddenLines, Shown, UP};
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::figure::structure::part::Part;
use crate::ids::{Element, VertexId};
use crate::plane::{PlanarView, Point};
use crate::solid::Polyhedron;
use crate::topology::has;

/// Of so many vertices at most all names are drawn.
const MOST_NAMES: usize = 24;

/// What one frame adds to a solid.
pub(super) struct Moment {
    /// The heading and the text.
    pub(super) caption: (String, String),
    /// Which of the solids is seen.
    pub(super) solid: usize,
    /// Faces told apart: role, corners in space, what the legend says.
    pub(super) faces: Vec<(Role, Vec<[f64; 3]>, &'static str)>,
    /// Lines from point to point.
    pub(super) lines: Vec<(Role, Vec<[f64; 3]>, &'static str)>,
    /// Points, with the names that are always drawn.
    pub(super) points: Vec<(Role, [f64; 3], &'static str, Option<String>)>,
    /// A direction, drawn as an arrow from the middle of the paper up.
    pub(super) level: Option<[f64; 3]>,
}

impl Moment {
    pub(super) fn new(heading: String, text: String, solid: usize) -> Self {
        let (faces, lines, points) = (Vec::new(), Vec::new(), Vec::new());
        Self { caption: (heading, text), solid, faces, lines, points, level: None }
    }
}

/// A film of moments; the direction `up` points up on the paper.
pub(super) fn film(solids: &[Polyhedron], moments: &[Moment], up: [f64; 3], names: bool) -> SketchFilm {
    let shown = Camera::default().film(solids, HiddenLines::Dashed, up);
    let mut film = SketchFilm::new();
    film.quiet();
    for moment in moments {
        let state = &shown[moment.solid];
        let (heading, text) = &moment.caption;
        let mut drawn = sketch(state, moment);
        // Faces that are seen whole are drawn as such; without any, the edges alone.
        let Ok(part) = Part::new(&state.projected, &state.faces) else { continue };
        if names && solids[moment.solid].vertex_count() <= MOST_NAMES {
            name(&mut drawn, moment, state, &part);
        }
        film.over(heading, text, &part, Backdrop::Dimmed, drawn);
    }
    film
}

/// The film of an algorithm that refuses a solid: one frame, `why` as its text, and marks on the elements that the refusal
/// is about. Elements that are not there have no mark.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::solid::{Platonic, Polyhedron};
/// use dcel_kit::{FaceId, ids::Element};
/// let cube = Polyhedron::platonic(Platonic::Cube);
/// let film = algorithms::refusal_in_space(&cube, "f2 is refused", &[Element::from(FaceId::new(2))]);
/// assert_eq!(film.len(), 1);
/// ```
#[must_use]
pub fn refusal_in_space(solid: &Polyhedron, why: &str, elements: &[Element]) -> SketchFilm {
    const KEY: &str = "what is refused";
    let mut moment = Moment::new(HEADING.to_owned(), why.to_owned(), 0);
    for &element in elements.iter().filter(|&&element| has(solid.topology(), element)) {
        let point = |h| solid.point(solid.topology().origin(h));
        match element {
            Element::Vertex(v) => moment.points.push((Role::Wrong, solid.point(v), KEY, Some(v.to_string()))),
            Element::HalfEdge(h) => moment.lines.push((Role::Wrong, h.edge().half_edges().map(point).to_vec(), KEY)),
            Element::Edge(e) => moment.lines.push((Role::Wrong, e.half_edges().map(point).to_vec(), KEY)),
            Element::Face(f) => {
                let corners = solid.incident_vertices(f).map(|v| solid.point(v)).collect();
                moment.faces.push((Role::Wrong, corners, KEY));
            }
        }
    }
    film(std::slice::from_ref(solid), &[moment], UP, true)
}

fn sketch(state: &Shown<'_>, moment: &Moment) -> Sketch {
    let mut sketch = state.sketch.clone();
    let place = |p: &[f64; 3]| state.place(*p);
    for (role, corners, key) in &moment.faces {
        let ring: Vec<Point> = corners.iter().map(place).collect();
        if is_front(&ring) {
            sketch.region(*role, [ring]).key(key);
        } else {
            // Seen from behind: its sides alone.
            let first = ring.first().copied();
            sketch.path(*role, ring.into_iter().chain(first)).dashed().key(key);
        }
    }
    for (role, points, key) in &moment.lines {
        sketch.path(*role, points.iter().map(place)).key(key);
    }
    if let Some(p) = &moment.level {
        let p = place(p);
        sketch.line(Role::Event, p, Point::new(p.x + 1.0, p.y)).key("what is higher lies above this line");
    }
    for (role, p, key, name) in &moment.points {
        let at = place(p);
        let mark = sketch.point(*role, at).key(key);
        if let Some(name) = name {
            mark.label(name);
        }
    }
    sketch
}

/// The names of the vertices that are seen, but for those that have one already.
fn name(sketch: &mut Sketch, moment: &Moment, state: &Shown<'_>, seen: &dyn PlanarView) {
    let named: Vec<Point> =
        moment.points.iter().filter(|(.., name)| name.is_some()).map(|(_, p, ..)| state.place(*p)).collect();
    for v in (0..seen.vertex_bound() as u32).map(VertexId::new).filter(|&v| seen.has_vertex(v)) {
        if let Some(p) = seen.position(v).filter(|p| !named.contains(p)) {
            sketch.text(Role::Plain, p, v.to_string());
        }
    }
}

/// Whether a face looks at the eye: it runs counter-clockwise on the paper.
fn is_front(ring: &[Point]) -> bool {
    let double: f64 =
        (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()])).map(|(p, q)| p.x * q.y - p.y * q.x).sum();
    double > 0.0
}
