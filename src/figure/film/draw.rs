//! The picture of a frame.
//!
//! ```text
//!   areas        of the state before or after the edit        labels by the fuller of the two
//!   half-edges   of the frame: new ones blue, gone ones red and dashed, the rest grey
//!   next         grey where it stays; every pointer of the step: new blue, gone red and dashed
//! ```
//!
//! The states before and after an edit are placed each, on one canvas. A frame is drawn on the fuller one, unless
//! a half-edge of the frame runs elsewhere there (the one that is being split, before it is): then on the other. As
//! long as all of the fuller state is there, it stays: an edge that is led past a vertex grows when the vertex goes.

use super::frames::{Fate, Film, Frame, Written};
use crate::figure::canvas::scene::Node;
use crate::figure::layout::crowd::Shape;
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::picture::Picture;
use crate::figure::structure::plate::Plate;
use crate::figure::structure::pointer::Pointer;
use crate::figure::structure::skeleton::{destination, half_edges, vertices};
use crate::figure::{Detail, FigureError, FigureOptions};
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::plane::PlanarView;
use crate::topology::{Slot, Table, View};

/// All states of a film, placed on one canvas.
pub(super) struct Stage<'a> {
    pub(super) plates: Vec<Plate<'a, Table>>,
    states: &'a [Table],
}

/// The fullest state, and all vertices that are nowhere in it: what the canvas must hold.
pub(super) fn union(film: &Film) -> Table {
    let fullest = film.states.iter().max_by_key(|state| half_edges(*state).count());
    let mut union = fullest.cloned().unwrap_or_default();
    for state in &film.states {
        for v in vertices(state) {
            let known = |row: &Option<crate::topology::VertexRow>| {
                row.as_ref()
                    .is_some_and(|row| row.position == state.vertices[v.index()].as_ref().and_then(|r| r.position))
            };
            if !union.vertices.iter().any(known) {
                union.vertices.push(state.vertices[v.index()]);
            }
        }
    }
    union
}

impl<'a> Stage<'a> {
    /// Places all states. `union` sets the scale.
    pub(super) fn new(film: &'a Film, union: &'a Table, options: &'a FigureOptions) -> Result<Self, FigureError> {
        let (whole, _) = Picture::new(union, options)?;
        if whole.detail < Detail::Arrows {
            return Err(FigureError::NoRoom { detail: whole.detail });
        }
        let mut plates = Vec::with_capacity(film.states.len());
        for state in &film.states {
            let (mut picture, _) = Picture::new(state, options)?;
            (picture.fit, picture.detail) = (whole.fit, whole.detail);
            for v in vertices(state) {
                let at = state.position(v).map(|p| whole.fit.place(p));
                picture.skeleton.at.set(v, at, None);
            }
            let first = Plate::place(picture, Notes::default(), &[]);
            let mut ink = first.local_ink();
            ink.extend(film.states.iter().flat_map(|other| foreign_discs(other, state, &whole)));
            plates.push(Plate::place(first.picture, Notes::default(), &ink));
        }
        let mut stage = Self { plates, states: &film.states };
        stage.share_vertices();
        Ok(stage)
    }

    /// Gives each plate the places of the vertices that only its neighbour in time has.
    fn share_vertices(&mut self) {
        for i in 1..self.plates.len() {
            for (from, to) in [(i - 1, i), (i, i - 1)] {
                for v in vertices(&self.states[from]) {
                    if self.states[to].has_vertex(v) {
                        continue;
                    }
                    let place = self.plates[from].skeleton().place(v);
                    let radius = self.plates[from].radii[v];
                    let label = self.plates[from].labels.vertices[v].clone();
                    let plate = &mut self.plates[to];
                    plate.picture.skeleton.at.set(v, place, None);
                    plate.radii.set(v, radius, radius);
                    plate.labels.vertices.set(v, label, None);
                }
            }
        }
    }

    /// The fuller of the two states of a frame, then the other one.
    fn order(&self, frame: &Frame) -> [usize; 2] {
        let [before, after] = frame.states;
        let count = |state: usize| half_edges(&self.states[state]).count();
        if count(after) >= count(before) { [after, before] } else { [before, after] }
    }

    /// How many half-edges of the table run elsewhere on the plate, or have no place there.
    fn misplaced(&self, plate: usize, table: &Table) -> Vec<HalfEdgeId> {
        let place = |h: HalfEdgeId| self.plates[plate].skeleton().ends(h);
        let moved = |h: &HalfEdgeId| {
            let ends = table.origin(*h).zip(destination(table, *h));
            ends.is_none_or(|(a, b)| place(*h) != Some([a, b]))
        };
        half_edges(table).filter(moved).collect()
    }

    /// The drawing of a frame. Ids begin with `name`.
    pub(super) fn draw(&self, frame: &Frame, name: &str) -> Vec<Node> {
        let shown = with_removed(frame);
        let [rich, other] = self.order(frame);
        let known = |h: &HalfEdgeId| shown.origin(*h).is_some() && destination(&shown, *h).is_some();
        let wrong = |plate: usize| self.misplaced(plate, &shown).into_iter().filter(known).count();
        let is_whole = half_edges(&self.states[rich]).all(|h| shown.has_half_edge(h) && known(&h));
        let chosen = if is_whole || wrong(rich) == 0 || wrong(rich) < wrong(other) { rich } else { other };
        let plate = &self.plates[chosen];

        let mut look = Look::instance(name);
        let is_quiet = frame.written.is_empty() && frame.marked.is_empty();
        if !is_quiet {
            look = look.rest(Mark::Dim);
        }
        let halves = half_edges(plate.picture.view).filter(|&h| !shown.has_half_edge(h));
        halves.for_each(|h| look.mark_half_edge(h, Mark::Hidden));
        for (elements, mark) in [(&frame.marked, Mark::Hot), (&frame.made, Mark::New), (&frame.removed, Mark::Gone)] {
            elements.iter().for_each(|&element| set(&mut look, element, mark));
        }
        let hidden = if is_whole { Vec::new() } else { self.misplaced(chosen, &shown) };
        hidden.iter().for_each(|&h| look.mark_half_edge(h, Mark::Hidden));

        let mut nodes = self.plates[rich].areas(&self.states[frame.areas], &look);
        let arrows = arrows(plate, frame, &look);
        nodes.extend(plate.lines(&shown, &look, arrows));
        // The frame has a title of its own; one for each line of each frame would be half of the file.
        for node in &mut nodes {
            if let Node::Group(group) = node {
                group.title = None;
            }
        }
        nodes
    }
}

/// The discs of vertices that another state has and this one has not: labels keep clear of them, too.
fn foreign_discs(other: &Table, state: &Table, whole: &Picture<'_, Table>) -> Vec<Shape> {
    let foreign = vertices(other).filter(|&v| !state.has_vertex(v));
    let places = foreign.filter_map(|v| other.position(v)).map(|p| whole.fit.place(p));
    places.map(|at| Shape::Disc(at, whole.options.style.vertex_radius + 1.5)).collect()
}

fn set(look: &mut Look, element: Element, mark: Mark) {
    match element {
        Element::Vertex(v) => look.mark_vertex(v, mark),
        Element::HalfEdge(h) => look.mark_half_edge(h, mark),
        Element::Edge(e) => e.half_edges().into_iter().for_each(|h| look.mark_half_edge(h, mark)),
        Element::Face(f) => look.mark_face(f, mark),
    }
}

/// The table of a frame with the rows that have gone in its step.
fn with_removed(frame: &Frame) -> Table {
    let mut shown = frame.table.clone();
    for &element in &frame.removed {
        match element {
            Element::Vertex(VertexId(i)) => shown.vertices[i as usize] = frame.before.vertices[i as usize],
            Element::Edge(e) => {
                for h in e.half_edges() {
                    shown.half_edges[h.index()] = frame.before.half_edges[h.index()];
                }
            }
            Element::Face(_) | Element::HalfEdge(_) => {}
        }
    }
    shown
}

/// The next pointers that stay, then those that have gone, then the new ones.
fn arrows(plate: &Plate<'_, Table>, frame: &Frame, look: &Look) -> Vec<Node> {
    let is_new = |slot: Slot| frame.written.iter().any(|w| w.fate == Fate::New && w.slot == slot);
    let visible = |h: HalfEdgeId| look.half_edge(h) != Mark::Hidden;
    let stays = |h: &HalfEdgeId| {
        let next = frame.table.next(*h);
        visible(*h) && next.is_some_and(visible) && !is_new(Slot::Next(*h))
    };
    let stay: Vec<Pointer> = half_edges(&frame.table).filter(stays).map(Pointer::Next).collect();
    let of = |fate: Fate| -> Vec<Pointer> {
        let shown = |w: &&Written| match (fate, w.slot) {
            (Fate::Gone, Slot::Face(_)) => false,
            // Of a face that goes there is no name from which its arrow could begin.
            (Fate::Gone, Slot::Boundary(f)) => !frame.removed.contains(&Element::Face(f)),
            _ => true,
        } && w.fate == fate;
        frame.written.iter().filter(shown).filter_map(|w| pointer(w.slot)).collect()
    };
    let mut notes = Notes::default();
    let mut nodes = Vec::new();
    for (view, pointers, mark, suffix) in [
        (&frame.table, stay, "dim", ""),
        (&frame.before, of(Fate::Gone), "gone", "-gone"),
        (&frame.table, of(Fate::New), "made", ""),
    ] {
        for mut node in plate.pointers(view, &pointers, look, 0.5, &mut notes) {
            if let Node::Group(group) = &mut node {
                group.mark = mark;
                if let Some(id) = &mut group.id {
                    id.push_str(suffix);
                }
            }
            nodes.push(node);
        }
    }
    nodes
}

/// The arrow of a slot. `prev` is `next` backwards, and `origin` is where the half-edge starts.
fn pointer(slot: Slot) -> Option<Pointer> {
    match slot {
        Slot::Next(h) => Some(Pointer::Next(h)),
        Slot::Face(h) => Some(Pointer::Face(h)),
        Slot::Outgoing(v) => Some(Pointer::Outgoing(v)),
        Slot::Boundary(f) => Some(Pointer::Boundary(f)),
        Slot::Prev(_) | Slot::Origin(_) => None,
    }
}
