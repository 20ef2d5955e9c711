//! The focus figure: one half-edge, its five pointers named, its row of the table beside it.
//!
//! ```text
//!   ┌───────────────────────┐       h = h14
//!   │  (v7)◂── h.prev ──    │   ─▸  h.origin    v7
//!   │ h.twin ↕ h   ┄▸ f5    │   ◂▸  h.twin      h15
//!   │  (v4)─── h.next ─▸    │   ─▸  h.next      h8   ...
//!   └───────────────────────┘
//! ```
//!
//! Only the five half-edges and arrows that belong to `h` have colours; the rest is grey.

use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::canvas::{crop, text};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::structure::arrows::Arrow;
use crate::figure::structure::captions::Label;
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::part::Part;
use crate::figure::structure::plate::{DynPlate, Plate};
use crate::figure::structure::pointer::Pointer;
use crate::figure::structure::pointer_style;
use crate::figure::structure::skeleton::destination;
use crate::figure::{Detail, Figure, FigureError, FigureOptions};
use crate::ids::HalfEdgeId;
use crate::plane::PlanarView;

/// Where the twin arrow stands, so that the face arrow has the middle.
pub(crate) const TWIN_AT: f64 = 0.36;
/// Size of the names of the pointers, and of the rows beside the picture.
const NAME: f64 = 12.0;
const ROW: f64 = 13.0;
/// Free space round a name.
const AIR: f64 = 1.5;
/// Distance of rows.
const LINE: f64 = 24.0;
/// Width of the samples of arrows, of the first column, and of all beside the picture.
const SAMPLE: f64 = 38.0;
const FIRST: f64 = 96.0;
const ASIDE: f64 = 324.0;

/// Draws one half-edge `h` with all it knows: `origin`, `twin`, `next`, `prev`, `face`; beside it what they are.
///
/// `prev` has no arrow of its own: the next arrow that arrives at `h` is read backwards. Shafts stand further
/// from their edges than in other figures (13 px unless the style says otherwise). A pointer that is missing is
/// `none` in the table.
///
/// # Errors
/// Those of [`pointers`](crate::figure::pointers), [`FigureError::NoHalfEdge`], and [`FigureError::NotDrawn`] if the face of
/// `h` is not among those to be drawn.
pub fn focus(view: &dyn PlanarView, h: HalfEdgeId, options: &FigureOptions) -> Result<Figure, FigureError> {
    if !view.has_half_edge(h) {
        let bound = view.half_edge_bound();
        let count = (0..bound as u32).filter(|&h| view.has_half_edge(HalfEdgeId(h))).count();
        return Err(FigureError::NoHalfEdge { half_edge: h, count, bound });
    }
    let view: &dyn PlanarView = &Part::of(view, options)?;
    if !view.has_half_edge(h) {
        return Err(FigureError::NotDrawn { element: h.into() });
    }
    let mut options = options.checked().half_edge_labels(false);
    options.usual_width = 620.0;
    let usual = crate::figure::Style::default();
    for (size, was, larger) in [
        (&mut options.style.offset, usual.offset, 13.0),
        (&mut options.style.padding, usual.padding, 80.0),
        (&mut options.style.vertex_radius, usual.vertex_radius, 12.0),
        (&mut options.style.vertex_text, usual.vertex_text, 11.0),
    ] {
        if *size <= was {
            *size = larger;
        }
    }
    let options = &options;
    let plate = Plate::new(view, options, false)?;
    if plate.picture.detail < Detail::Arrows {
        return Err(FigureError::NoRoom { detail: plate.picture.detail });
    }
    let mut notes = Notes(plate.notes.0.clone());
    let mut look = Look::default().rest(Mark::Dim);
    for part in [view.prev(h), view.twin(h), view.next(h)].into_iter().flatten() {
        look.mark_half_edge(part, Mark::Plain);
    }
    look.mark_half_edge(h, Mark::Hot);
    if let Some(v) = view.origin(h) {
        look.mark_vertex(v, Mark::Hot);
    }
    if let Some(f) = view.face(h) {
        look.mark_face(f, Mark::Hot);
    }
    let prev = view.prev(h).filter(|&p| view.next(p) == Some(h));
    let mut shown: Vec<Pointer> = prev.map(Pointer::Next).into_iter().collect();
    shown.extend([Pointer::Next(h), Pointer::Twin(h), Pointer::Origin(h), Pointer::Face(h)]);
    let mut arrows = plate.pointers(view, &shown, &look, TWIN_AT, &mut notes);
    arrows.extend(names(&plate, view, h));

    let mut scene = plate.picture.scene(Vec::new());
    scene.nodes = crop::framed(plate.nodes(view, &look, arrows), scene.size, options);
    let height = 2.0 * 40.0 + 8.0 * LINE;
    // Beside the picture, or below it if the caller has asked for so narrow a figure.
    let is_beside = options.width.is_none_or(|width| scene.size.x + ASIDE <= width);
    let corner = if is_beside { xy(scene.size.x, 0.0) } else { xy(0.0, scene.size.y) };
    scene.nodes.push(rows(view, h, corner));
    scene.size = if is_beside {
        xy(scene.size.x + ASIDE, scene.size.y.max(height))
    } else {
        xy(scene.size.x.max(ASIDE), scene.size.y + height - 40.0)
    };
    scene.css.push_str(&pointer_style::css(&options.style, &scene.prefix));
    if options.description.is_none() {
        let words: Vec<String> = fields(view, h).into_iter().map(|(field, value)| format!("{field} {value}")).collect();
        scene.description = format!("The half-edge {h} and what it knows: {}.", words.join(", "));
    }
    Ok(Figure { scene, detail: plate.picture.detail, notes: notes.0 })
}

/// `h`, `h.prev`, `h.next`, `h.twin` beside their shafts, each where it covers nothing.
fn names(plate: &DynPlate<'_>, view: &dyn PlanarView, h: HalfEdgeId) -> Vec<Node> {
    let mut crowd = plate.crowd.clone();
    let mut own = vec![Pointer::Next(h), Pointer::Twin(h), Pointer::Origin(h), Pointer::Face(h)];
    own.extend(view.prev(h).map(Pointer::Next));
    plate.block(view, &own, TWIN_AT, &mut crowd);
    let parts = [(Some(h), "h"), (view.prev(h), "h.prev"), (view.next(h), "h.next"), (view.twin(h), "h.twin")];
    let mut named: Vec<(HalfEdgeId, String)> = Vec::new();
    for (part, name) in parts {
        let Some(part) = part else { continue };
        match named.iter_mut().find(|(known, _)| *known == part) {
            // At a dangling end one half-edge is several things.
            Some((_, names)) => *names = format!("{names} = {name}"),
            None => named.push((part, name.to_owned())),
        }
    }
    let mut out = Vec::new();
    for (part, name) in named {
        let Some(label) = name_beside(plate, part, name, &crowd) else { continue };
        crowd.add(Shape::Box(label.bounds().grown(AIR)), u32::MAX);
        out.extend(label.nodes("pn"));
    }
    for (pointer, name, class) in [(Pointer::Face(h), "h.face", "k-face"), (Pointer::Origin(h), "h.origin", "k-origin")]
    {
        let arrow = plate.arrow(view, pointer, TWIN_AT, &mut plate.crowd.clone()).map(|tagged| tagged.arrow);
        let Some(label) = arrow.and_then(|arrow| name_near(plate, arrow.middle(), name, &crowd)) else { continue };
        crowd.add(Shape::Box(label.bounds().grown(AIR)), u32::MAX);
        out.extend(label.nodes(class));
    }
    out
}

/// The nearest free place round a point.
fn name_near(plate: &DynPlate<'_>, p: Xy, name: &str, crowd: &Crowd) -> Option<Label> {
    let half = xy(0.5 * text::width(name, NAME, true), text::half_height(NAME));
    let inside = crop::window(plate.picture.fit.size).grown(-4.0);
    let steps = |to: i32, step: f64| (-to..=to).map(move |i| step * f64::from(i));
    let mut places: Vec<Xy> = steps(14, 6.0).flat_map(|x| steps(12, 5.0).map(move |y| p + xy(x, y))).collect();
    places.sort_by(|a, b| (*a - p).length().total_cmp(&(*b - p).length()));
    let place = places.into_iter().find(|&at| crowd.has_room(at, half, &inside, AIR));
    place.map(|at| Label { at, size: NAME, lines: vec![name.to_owned()] })
}

fn name_beside(plate: &DynPlate<'_>, h: HalfEdgeId, name: String, crowd: &Crowd) -> Option<Label> {
    let shaft = plate.shafts.get(h)?.as_ref()?;
    let half = xy(0.5 * text::width(&name, NAME, true), text::half_height(NAME));
    let aside = shaft.along.left();
    let distance = 4.5 + half.x * aside.x.abs() + half.y * aside.y.abs();
    let places = [0.5, 0.3, 0.7, 0.22, 0.78, 0.4, 0.6];
    let inside = crop::window(plate.picture.fit.size).grown(-4.0);
    let mut places = places.into_iter().map(|t| shaft.at(t) + aside * distance);
    let place = places.find(|&at| crowd.has_room(at, half, &inside, 0.0));
    place.map(|at| Label { at, size: NAME, lines: vec![name] })
}

/// The fields and what they are.
fn fields<V: PlanarView + ?Sized>(view: &V, h: HalfEdgeId) -> [(&'static str, String); 6] {
    fn word<I: std::fmt::Display>(id: Option<I>) -> String {
        id.map_or_else(|| "none".to_owned(), |id| id.to_string())
    }
    [
        ("h.origin", word(view.origin(h))),
        ("h.twin", word(view.twin(h))),
        ("h.next", word(view.next(h))),
        ("h.prev", word(view.prev(h))),
        ("h.face", word(view.face(h))),
        ("destination", format!("h.twin.origin = {}", word(destination(view, h)))),
    ]
}

/// The table beside the picture; the names have the colours of their arrows, and a sample of each stands before.
fn rows<V: PlanarView + ?Sized>(view: &V, h: HalfEdgeId, corner: Xy) -> Node {
    let classes = ["k-origin", "k-twin", "k-next", "k-next", "k-face", "cs"];
    // In the order of the fields; `prev` is next backwards.
    let samples = [("origin", ">"), ("twin", "<>"), ("next", ">"), ("next", "<"), ("face-of", ">")];
    let left = corner.x + 16.0 + SAMPLE;
    let row = |i: usize| corner.y + 40.0 + LINE * i as f64;
    let line = |class: &'static str, x: f64, y: f64, text: String| Node::Text { class, at: xy(x, y), size: ROW, text };
    let mut nodes = vec![line("ct", left, row(0), format!("h = {h}"))];
    for (i, (class, heads)) in samples.into_iter().enumerate() {
        let [left, right] = [8.0 - SAMPLE, -10.0].map(|x| xy(left + x, row(i + 1)));
        let (from, to) = if heads == "<" { (right, left) } else { (left, right) };
        let sample = Arrow::straight(from, to, heads == "<>").map(|arrow| arrow.nodes("pl", "ph").to_vec());
        nodes.extend(sample.map(|nodes| Node::Group(Group { class, nodes, ..Group::default() })));
    }
    for (i, ((field, value), class)) in fields(view, h).into_iter().zip(classes).enumerate() {
        nodes.push(line(class, left, row(i + 1), field.to_owned()));
        nodes.push(line("cs", left + FIRST, row(i + 1), value));
    }
    Node::Group(Group { class: "rows", nodes, ..Group::default() })
}
