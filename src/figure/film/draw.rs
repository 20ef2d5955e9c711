//! The picture of a frame.
//!
//! ```text
//!   areas        of the state before or after the edit        labels by the fuller of the two
//!   half-edges   of the frame: new ones blue, gone ones red and dashed, the rest grey
//!   chips        records that have no place yet, by name, in the lower left corner
//!   next         grey where it stays; every pointer of the step: new blue, gone red and dashed
//! ```
//!
//! The states before and after an edit are placed each, on one canvas. A frame is drawn on the fuller one, unless
//! a half-edge of the frame runs elsewhere there (the one that is being split, before it is): then on the other. As
//! long as all of the fuller state is there, it stays: an edge that is led past a vertex grows when the vertex goes.

use super::frames::{Fate, Frame, Written};
use super::sides;
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::text;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::flatten::Placed;
use crate::figure::layout::crowd::Shape;
use crate::figure::structure::arrows::Arrow;
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::picture::Picture;
use crate::figure::structure::plate::{DynPlate, Plate};
use crate::figure::structure::pointer::Pointer;
use crate::figure::structure::skeleton::{destination, faces, half_edges, vertices};
use crate::figure::{Detail, FigureError, FigureOptions};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::PlanarView;
use crate::topology::{Slot, Table, View};

/// How far inside of a corner a next pointer passes that follows the bends of its edge.
const CORNER: f64 = 13.0;
/// Where the chips begin: so far from the left and from the bottom.
const CHIP: Xy = xy(12.0, 12.0);
const CHIP_HEIGHT: f64 = 19.0;
const CHIP_TEXT: f64 = 11.0;
/// So many are shown.
const CHIPS: usize = 6;
/// So many half-edges may lie between two that are to follow each other.
const MOST: usize = 12;

/// All states of a film, placed on one canvas.
pub(super) struct Stage<'a> {
    pub(super) plates: Vec<DynPlate<'a>>,
    states: &'a [Table],
    /// The states as they are drawn.
    placed: &'a [Placed],
}

/// The fullest state, and all vertices that are nowhere in it: what the canvas must hold.
pub(super) fn union(states: &[Placed]) -> Table {
    let fullest = states.iter().max_by_key(|state| half_edges(&state.table).count());
    let mut union = fullest.map(|state| state.table.clone()).unwrap_or_default();
    for state in states.iter().map(|state| &state.table) {
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
    pub(super) fn new(
        states: &'a [Table],
        placed: &'a [Placed],
        union: &'a dyn PlanarView,
        options: &'a FigureOptions,
    ) -> Result<Self, FigureError> {
        let (whole, _) = Picture::new(union, options)?;
        if whole.detail < Detail::Arrows {
            return Err(FigureError::NoRoom { detail: whole.detail });
        }
        let mut plates = Vec::with_capacity(placed.len());
        for Placed { table: state, .. } in placed {
            let (mut picture, _) = Picture::<dyn PlanarView>::new(state, options)?;
            (picture.fit, picture.detail) = (whole.fit, whole.detail);
            for v in vertices(state) {
                let at = state.position(v).map(|p| whole.fit.place(p));
                picture.skeleton.at.set(v, at, None);
            }
            let first = Plate::place(picture, Notes::default(), &[]);
            let mut ink = first.local_ink();
            ink.extend(placed.iter().flat_map(|other| foreign_discs(&other.table, state, &whole)));
            plates.push(Plate::place(first.picture, Notes::default(), &ink));
        }
        let mut stage = Self { plates, states, placed };
        stage.share_vertices();
        Ok(stage)
    }

    /// Gives each plate the places of the vertices that only its neighbour in time has.
    fn share_vertices(&mut self) {
        for i in 1..self.plates.len() {
            for (from, to) in [(i - 1, i), (i, i - 1)] {
                for v in vertices(&self.placed[from].table) {
                    if self.placed[to].table.has_vertex(v) {
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
        let is_laid_out = self.placed[plate].is_laid_out;
        let place = |h: HalfEdgeId| match self.plates[plate].skeleton().ends(h) {
            // On a copy or a bend it stands for the vertices that it runs between.
            Some(_) if is_laid_out => {
                self.states[plate].origin(h).zip(destination(&self.states[plate], h)).map(<[_; 2]>::from)
            }
            ends => ends,
        };
        let moved = |h: &HalfEdgeId| {
            let ends = table.origin(*h).zip(destination(table, *h));
            ends.is_none_or(|(a, b)| place(*h) != Some([a, b]))
        };
        half_edges(table).filter(moved).collect()
    }

    /// The drawing of a frame. Ids begin with `name`.
    pub(super) fn draw(&self, frame: &Frame, name: &str) -> Vec<Node> {
        let mut shown = with_removed(frame);
        let [rich, other] = self.order(frame);
        let known = |h: &HalfEdgeId| shown.origin(*h).is_some() && destination(&shown, *h).is_some();
        let wrong = |plate: usize| self.misplaced(plate, &shown).into_iter().filter(known).count();
        // A layout has room for an edge at both of its places: one that turns is drawn where it is.
        let turns = self.placed[rich].is_laid_out
            && half_edges(&self.states[other]).all(|h| self.states[rich].has_half_edge(h))
            && half_edges(&self.states[rich]).all(|h| self.states[other].has_half_edge(h));
        let is_whole = !turns && half_edges(&self.states[rich]).all(|h| shown.has_half_edge(h) && known(&h));
        let chosen = if is_whole || wrong(rich) == 0 || wrong(rich) < wrong(other) { rich } else { other };
        let plate = &self.plates[chosen];

        let mut look = Look::instance(name);
        let is_quiet = frame.written.is_empty() && frame.marked.is_empty();
        if !is_quiet {
            look = look.rest(Mark::Dim);
        }
        let halves = half_edges(plate.picture.view).filter(|&h| !shown.has_half_edge(h));
        halves.for_each(|h| look.mark_half_edge(h, Mark::Hidden));
        let copies = &self.placed[chosen].copies;
        // No arrow shows an origin: what begins elsewhere from now on is bold.
        for written in frame.written.iter().filter(|written| written.fate == Fate::New) {
            if let Slot::Origin(h) = written.slot {
                look.mark_half_edge(h, Mark::Hot);
            }
        }
        for (elements, mark) in [(&frame.marked, Mark::Hot), (&frame.made, Mark::New), (&frame.removed, Mark::Gone)] {
            elements.iter().for_each(|&element| look.mark(element, mark));
        }
        let hidden = if is_whole { Vec::new() } else { self.misplaced(chosen, &shown) };
        hidden.iter().for_each(|&h| look.mark_half_edge(h, Mark::Hidden));
        for &(piece, h) in &self.placed[chosen].pieces {
            if shown.has_half_edge(h) && look.half_edge(h) != Mark::Hidden {
                look.mark_half_edge(piece, Mark::Plain);
            }
        }
        for &(copy, _, v) in copies {
            if !shown.has_vertex(v) {
                continue;
            }
            look.mark_vertex(copy, look.vertex(v));
            shown.vertices.resize(shown.vertices.len().max(copy.index() + 1), None);
            shown.vertices[copy.index()] = self.placed[chosen].table.vertices[copy.index()];
        }

        let mut nodes = self.areas(frame, [chosen, rich], &look);
        // Below the discs of the vertices.
        let mut between = sides::nodes(plate, &self.placed[chosen], &look);
        between.extend(arrows(plate, frame, &look, &self.placed[chosen]));
        nodes.extend(plate.lines(&shown, &look, between));
        nodes.extend(self.chips(frame, &look, plate.picture.fit.size));
        // The frame has a title of its own; one for each line of each frame would be half of the file.
        for node in &mut nodes {
            if let Node::Group(group) = node {
                group.title = None;
                let copy = copies.iter().find(|(copy, ..)| group.id.as_deref() == Some(&look.id(*copy)));
                if let Some((_, number, v)) = copy {
                    group.id = Some(look.name(&format!("{v}-{number}")));
                }
            }
        }
        nodes
    }

    /// Records without a place in the picture: faces that no half-edge bounds yet, half-edges without both of their ends.
    fn chips(&self, frame: &Frame, look: &Look, size: Xy) -> Option<Node> {
        let has_ends = |h: &HalfEdgeId| frame.table.origin(*h).is_some() && destination(&frame.table, *h).is_some();
        let faces = faces(&frame.table).filter(|&f| !self.states[frame.areas].has_face(f)).map(|f| f.to_string());
        let halves = half_edges(&frame.table).filter(|h| !has_ends(h)).map(|h| h.to_string());
        let names: Vec<String> = faces.chain(halves).collect();
        let mut left = CHIP.x;
        let mut nodes = Vec::new();
        for name in names.iter().take(CHIPS) {
            let width = text::width(name, CHIP_TEXT, true) + 14.0;
            let corner = xy(left, size.y - CHIP.y - CHIP_HEIGHT);
            let outline = Bounds { min: corner, max: corner + xy(width, CHIP_HEIGHT) }.corners();
            let outlines = vec![outline.to_vec()];
            nodes.push(Node::Area { class: "cb", hatch: None, outlines });
            let at = corner + xy(0.5 * width, 0.5 * CHIP_HEIGHT);
            nodes.push(Node::Text { class: "cl", at, size: CHIP_TEXT, text: name.clone() });
            left += width + 6.0;
        }
        if names.len() > CHIPS {
            let at = xy(left + 10.0, size.y - CHIP.y - 0.5 * CHIP_HEIGHT);
            nodes.push(Node::Text { class: "cl", at, size: CHIP_TEXT, text: "…".to_owned() });
        }
        (!nodes.is_empty())
            .then(|| Node::Group(Group { class: "chips", id: Some(look.name("new")), nodes, ..Group::default() }))
    }

    /// The faces. On a layout they are those of the plate that is drawn: where a face is not there yet, or no more, its
    /// place belongs to the face that it comes from, or went into.
    fn areas(&self, frame: &Frame, [chosen, rich]: [usize; 2], look: &Look) -> Vec<Node> {
        if !self.placed[chosen].is_laid_out {
            return self.plates[rich].areas(&self.states[frame.areas], look);
        }
        let table = &self.placed[chosen].table;
        if chosen == frame.areas {
            return self.plates[chosen].areas(table, look);
        }
        let mut merged = table.clone();
        let state = &self.states[frame.areas];
        for face in faces(table).filter(|&f| !state.has_face(f)) {
            let sides = half_edges(table).filter(|&h| merged.face(h) == Some(face));
            let beside = |h: HalfEdgeId| Some((h, table.twin(h)?, merged.face(table.twin(h)?)?));
            let across = sides.filter_map(beside).filter(|&(_, _, f)| state.has_face(f));
            if let Some((h, twin, other)) = across.min_by_key(|&(h, ..)| (state.has_half_edge(h), h)) {
                merge(&mut merged, [h, twin], [face, other]);
            }
        }
        let mut nodes = self.plates[chosen].areas(&merged, look);
        if let Some(outer) = merged.outer_face.filter(|_| merged.outer_face != table.outer_face) {
            rename_outer(&mut nodes, &outer.to_string());
        }
        nodes
    }
}

/// Another face is the outer one than in the plate that is drawn.
fn rename_outer(nodes: &mut [Node], name: &str) {
    for node in nodes {
        let Node::Group(group) = node else { continue };
        for node in group.nodes.iter_mut().filter(|_| group.class == "f outer") {
            if let Node::Text { text, .. } = node {
                name.clone_into(text);
            }
        }
    }
}

/// Takes an edge out of a table, so that the face on its first side becomes part of the one on its second side.
fn merge(table: &mut Table, [h, twin]: [HalfEdgeId; 2], [gone, kept]: [FaceId; 2]) {
    let [links, others] = [h, twin].map(|h| table.prev(h).zip(table.next(h)));
    let (Some((before, after)), Some((twin_before, twin_after))) = (links, others) else { return };
    for (from, to) in [(before, twin_after), (twin_before, after)] {
        if let Some(Some(first)) = table.half_edges.get_mut(from.index()) {
            first.next = Some(to);
        }
        if let Some(Some(second)) = table.half_edges.get_mut(to.index()) {
            second.prev = Some(from);
        }
    }
    (table.half_edges[h.index()], table.half_edges[twin.index()]) = (None, None);
    for row in table.half_edges.iter_mut().flatten().filter(|row| row.face == Some(gone)) {
        row.face = Some(kept);
    }
    if let Some(Some(row)) = table.faces.get_mut(kept.index()) {
        row.half_edge = Some([before, twin_before, after].into_iter().find(|&g| g != h && g != twin).unwrap_or(after));
    }
    table.faces[gone.index()] = None;
    if table.outer_face == Some(gone) {
        table.outer_face = Some(kept);
    }
}

/// The discs of vertices that another state has and this one has not: labels keep clear of them, too.
fn foreign_discs(other: &Table, state: &Table, whole: &Picture<'_, dyn PlanarView + '_>) -> Vec<Shape> {
    let foreign = vertices(other).filter(|&v| !state.has_vertex(v));
    let places = foreign.filter_map(|v| other.position(v)).map(|p| whole.fit.place(p));
    places.map(|at| Shape::Disc(at, whole.options.style.vertex_radius + 1.5)).collect()
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
fn arrows(plate: &DynPlate<'_>, frame: &Frame, look: &Look, placed: &Placed) -> Vec<Node> {
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
            (Fate::Gone, Slot::HalfEdge(f)) => !frame.removed.contains(&Element::Face(f)),
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
        let bent = |pointer: &Pointer| bent_next(plate, view, *pointer, placed, look);
        let (straight, round): (Vec<_>, Vec<_>) = pointers.iter().partition(|pointer| bent(pointer).is_none());
        let drawn = plate.pointers(view, &straight, look, 0.5, &mut notes);
        for mut node in drawn.into_iter().chain(round.iter().filter_map(bent)) {
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

/// The next pointer of a bent half-edge, or to one: beside the pieces between the two.
fn bent_next(plate: &DynPlate<'_>, view: &Table, pointer: Pointer, placed: &Placed, look: &Look) -> Option<Node> {
    let Pointer::Next(h) = pointer else { return None };
    if placed.pieces.is_empty() {
        return None;
    }
    let next = view.next(h)?;
    let mut chain = vec![h];
    let mut at = h;
    for _ in 0..MOST {
        at = placed.table.next(at)?;
        // What is not there yet, or no more, is passed by.
        if at == next || placed.pieces.iter().any(|(piece, _)| *piece == at) {
            chain.push(at);
        } else if view.has_half_edge(at) {
            return None;
        }
        if at == next {
            break;
        }
    }
    let ends = |h: HalfEdgeId| plate.skeleton().ends(h);
    let joined = chain.windows(2).all(|pair| ends(pair[0]).map(|ends| ends[1]) == ends(pair[1]).map(|ends| ends[0]));
    let is_there = chain.len() > 2 && chain.last() == Some(&next) && joined;
    let [from, to] = [h, next].map(|h| plate.shafts.get(h).and_then(Option::as_ref));
    let (from, to) = from.zip(to).filter(|_| is_there)?;
    let way = |h: HalfEdgeId| plate.skeleton().segment(h);
    let mut points = vec![from.tip];
    for pair in chain.windows(2) {
        let ((a, b), (_, c)) = (way(pair[0])?, way(pair[1])?);
        let (inward, outward) = ((b - a).unit()?, (c - b).unit()?);
        let aside = (inward.left() + outward.left()).unit().unwrap_or(inward);
        points.push(b + aside * CORNER);
    }
    points.push(to.tail);
    let nodes = Arrow::through(&points)?.nodes("pl", "ph").to_vec();
    let id = Some(format!("{}-next", look.name(&h.to_string())));
    Some(Node::Group(Group { class: "ptr next", id, nodes, ..Group::default() }))
}

/// The arrow of a slot. `prev` is `next` backwards, and `origin` is where the half-edge starts.
fn pointer(slot: Slot) -> Option<Pointer> {
    match slot {
        Slot::Next(h) => Some(Pointer::Next(h)),
        Slot::Face(h) => Some(Pointer::Face(h)),
        Slot::Outgoing(v) => Some(Pointer::Outgoing(v)),
        Slot::HalfEdge(f) => Some(Pointer::Boundary(f)),
        Slot::Prev(_) | Slot::Origin(_) => None,
    }
}
