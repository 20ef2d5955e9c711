//! From a journal to the tables of the frames.
//!
//! ```text
//!   before            step 1        step 2          ...    after
//!   table ──changes──> table ──changes──> table            the structure itself
//!                      written: h6.next  gone h8, new h13
//! ```
//!
//! The areas of faces cannot be walked in a half-linked structure. A frame shows the areas of the structure
//! before the edit until the moment that gives the last half-edge its face (or, if none does, its next); from
//! then on those after the edit.

use super::moments::{moments, turning};
use super::slip::Slip;
use crate::figure::flatten::{Names, Placed, Spread, set_positions};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::PlanarView;
#[cfg(feature = "solid")]
use crate::solid::Polyhedron;
use crate::topology::{Change, Dcel, Journal, Slot, Table, View, has};
use std::collections::BTreeMap;

/// Edits to be shown frame by frame.
///
/// A structure without coordinates is laid out: what lies on a sphere within a circle, each vertex in the middle of its
/// neighbours; a closed surface with handles as a polygon whose sides are glued in pairs, both of a pair with one letter.
/// From state to state as little moves as possible. If the whole has no room for arrows, the part where the edits are has:
/// elsewhere edges are short and plain, up to 1000 of them. A surface in space is seen from one place, a frame an edit.
///
/// ```
/// use dcel_kit::figure::{Film, FigureOptions};
/// use dcel_kit::{HalfEdgeId, plane::Subdivision, topology::Journal};
/// let mut lab = Subdivision::lab_rectangle();
/// let mut film = Film::new(&lab);
/// let mut journal = Journal::new();
/// lab.split_face_with(HalfEdgeId::new(2), HalfEdgeId::new(8), &mut journal)?;
/// film.edit("split_face h2 h8", "", &[], &journal, &lab);
/// assert_eq!(film.frames().len(), 7);
/// assert!(film.strip(&FigureOptions::new("Split"))?.to_svg().contains("id=\"split-3-h12-next\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Film {
    /// The structure before the first edit, and after each.
    pub(super) states: Vec<Table>,
    /// How the states lie on paper, if they have no coordinates.
    pub(super) spreads: Vec<Spread>,
    /// The states themselves, if they have no coordinates.
    pub(super) kernels: Vec<Dcel>,
    /// The states in space.
    #[cfg(feature = "solid")]
    pub(super) solids: Vec<Polyhedron>,
    shots: Vec<Shot>,
    closing: String,
    /// What is marked in the last frame.
    closing_marked: Vec<Element>,
}

#[derive(Clone, Debug)]
struct Shot {
    title: String,
    caption: String,
    marked: Vec<Element>,
    journal: Journal,
}

/// What became of a pointer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fate {
    /// It was there before the step, and is not any more.
    Gone,
    /// The step has set it.
    New,
}

/// A pointer that a step has changed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Written {
    /// Which pointer.
    pub slot: Slot,
    /// Where it leads, or led.
    pub target: Element,
    /// Whether it is new or gone.
    pub fate: Fate,
}

/// One picture of a film.
#[derive(Clone, Debug, Default)]
pub struct Frame {
    /// The call, the step with its number, or `after`.
    pub heading: String,
    /// What to look at: the caption, or what the step has written.
    pub text: String,
    /// The structure at the end of the step, with positions.
    pub table: Table,
    /// The changes of the step, in order; none before and after.
    pub changes: Vec<Change>,
    /// The pointers that differ from the frame before.
    pub written: Vec<Written>,
    /// Vertices, edges and faces that have come.
    pub added: Vec<Element>,
    /// Vertices, edges and faces that have gone; they are drawn a last time.
    pub removed: Vec<Element>,
    /// What the film's maker wants to be seen.
    pub marked: Vec<Element>,
    /// The number of the state whose areas are shown.
    pub(super) areas: usize,
    /// The numbers of the states before and after the edit.
    pub(super) states: [usize; 2],
    /// The structure at the beginning of the step.
    pub(super) before: Table,
    /// The edges and vertices that the edit has made so far.
    pub(super) made: Vec<Element>,
}

impl Film {
    /// A film that begins with this structure.
    pub fn new(start: &dyn PlanarView) -> Self {
        let mut film = Self::empty();
        film.states.push(Table::from_planar_view(start));
        film
    }

    /// A film that begins with this structure without coordinates. Its edits go to [`kernel_edit`](Self::kernel_edit).
    ///
    /// ```
    /// use dcel_kit::figure::{Film, FigureOptions};
    /// use dcel_kit::topology::{Dcel, Journal};
    /// let mut triangle = Dcel::from_triangles(3, &[[0, 1, 2]])?.dcel;
    /// let mut film = Film::of_kernel(&triangle);
    /// let mut journal = Journal::new();
    /// let h = triangle.half_edges().next().expect("a triangle has half-edges");
    /// triangle.split_edge_with(h, &mut journal)?;
    /// film.kernel_edit("split_edge h0", "", &[], &journal, &triangle);
    /// assert!(film.strip(&FigureOptions::new("Split"))?.to_svg().contains("id=\"split-0-v0\""));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn of_kernel(start: &Dcel) -> Self {
        let mut film = Self::empty();
        film.add_kernel(start);
        film
    }

    /// A film that begins with this surface in space. Its edits go to [`solid_edit`](Self::solid_edit).
    #[cfg(feature = "solid")]
    #[must_use]
    pub fn of_solid(start: &Polyhedron) -> Self {
        let mut film = Self::empty();
        film.add_solid(start);
        film
    }

    /// A film without any state.
    pub(super) fn empty() -> Self {
        Self {
            states: Vec::new(),
            spreads: Vec::new(),
            kernels: Vec::new(),
            #[cfg(feature = "solid")]
            solids: Vec::new(),
            shots: Vec::new(),
            closing: String::new(),
            closing_marked: Vec::new(),
        }
    }

    /// Appends a state with positions.
    pub(super) fn add_planar(&mut self, state: &dyn PlanarView) {
        self.states.push(Table::from_planar_view(state));
    }

    /// Appends a state without coordinates, laid out like the one before as far as it can be.
    pub(super) fn add_kernel(&mut self, state: &Dcel) {
        let spread = Spread::new(state, self.spreads.last());
        self.add_spread(state, spread);
    }

    /// Appends a state without coordinates that is laid out.
    pub(super) fn add_spread(&mut self, state: &Dcel, spread: Spread) {
        let mut table = Table::from_view(state);
        set_positions(&mut table, &spread);
        self.states.push(table);
        self.spreads.push(spread);
        self.kernels.push(state.clone());
    }

    /// Appends a state in space.
    #[cfg(feature = "solid")]
    pub(super) fn add_solid(&mut self, state: &Polyhedron) {
        self.states.push(Table::from_view(state));
        self.solids.push(state.clone());
    }

    /// The states as they are drawn, and the names of what only the drawing has.
    pub(super) fn placed(&self) -> (Vec<Placed>, Names) {
        let mut names = Names::beyond(&self.states);
        let placed = self.states.iter().enumerate().map(|(i, state)| match self.spreads.get(i) {
            Some(spread) => Placed::new(state, spread, &mut names),
            None => Placed::plain(state.clone()),
        });
        (placed.collect(), names)
    }

    /// Appends an edit: the call, a sentence for the frame before it (may be empty), elements to be marked, what
    /// was recorded, and the structure it led to.
    pub fn edit(&mut self, title: &str, caption: &str, marked: &[Element], journal: &Journal, after: &dyn PlanarView) {
        self.add_shot(title, caption, marked, journal);
        self.add_planar(after);
    }

    /// Appends an edit of a structure without coordinates, as [`edit`](Self::edit) does.
    pub fn kernel_edit(&mut self, title: &str, caption: &str, marked: &[Element], journal: &Journal, after: &Dcel) {
        self.add_shot(title, caption, marked, journal);
        self.add_kernel(after);
    }

    /// Appends an edit of a surface in space, as [`edit`](Self::edit) does.
    #[cfg(feature = "solid")]
    pub fn solid_edit(
        &mut self,
        title: &str,
        caption: &str,
        marked: &[Element],
        journal: &Journal,
        after: &Polyhedron,
    ) {
        self.add_shot(title, caption, marked, journal);
        self.add_solid(after);
    }

    /// Appends an edit; its state is to follow.
    pub(super) fn add_shot(&mut self, title: &str, caption: &str, marked: &[Element], journal: &Journal) {
        self.shots.push(Shot {
            title: title.to_owned(),
            caption: caption.to_owned(),
            marked: marked.to_vec(),
            journal: journal.clone(),
        });
    }

    /// Sets the sentence of the last frame, and what is marked in it.
    pub fn close(&mut self, caption: &str, marked: &[Element]) {
        caption.clone_into(&mut self.closing);
        marked.clone_into(&mut self.closing_marked);
    }

    /// How many edits there are.
    #[must_use]
    pub fn edit_count(&self) -> usize {
        self.shots.len()
    }

    /// All frames: before each edit, after each of its steps, and at the end.
    ///
    /// Cost: O(frames x size of the structure).
    #[must_use]
    pub fn frames(&self) -> Vec<Frame> {
        #[cfg(feature = "solid")]
        if !self.solids.is_empty() {
            return self.views();
        }
        self.frames_with(&[])
    }

    /// The frames if the edits are made with these slips. Each edit but the last begins with what it should begin with.
    pub(super) fn frames_with(&self, slips: &[Slip]) -> Vec<Frame> {
        let mut out: Vec<Frame> = Vec::new();
        for (i, shot) in self.shots.iter().enumerate() {
            let states = [i, i + 1];
            out.push(still(&shot.title, &shot.caption, &self.states[i], i, states, shot.marked.clone()));
            self.steps(shot, states, slips, &mut out);
        }
        let last = self.states.len() - 1;
        let heading = if self.shots.is_empty() { "" } else { "after" };
        let states = [last.saturating_sub(1), last];
        let slipped = out.last().filter(|_| !slips.is_empty()).map(|frame| frame.table.clone());
        let table = slipped.as_ref().unwrap_or(&self.states[last]);
        out.push(still(heading, &self.closing, table, last, states, self.closing_marked.clone()));
        out
    }

    /// Only the beginning and the end of the film: two panels, before and after. What is new is marked in the second one.
    ///
    /// ```
    /// use dcel_kit::figure::Film;
    /// use dcel_kit::script::Script;
    /// let script = Script::parse("rectangle\nlet a = split_face h2 h8\nsplit_in_half a\n", "example")?;
    /// let frames = Film::of_script(&script).ends().frames();
    /// let headings: Vec<&str> = frames.iter().map(|frame| frame.heading.as_str()).collect();
    /// assert_eq!(headings, ["before", "after"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn ends(&self) -> Self {
        let mut film = self.clone();
        let ends = [0, self.states.len() - 1];
        film.states = ends.map(|i| self.states[i].clone()).to_vec();
        film.spreads = ends.iter().filter_map(|&i| self.spreads.get(i).cloned()).collect();
        film.kernels = ends.iter().filter_map(|&i| self.kernels.get(i).cloned()).collect();
        let marked = self.shots.first().map(|shot| shot.marked.clone()).unwrap_or_default();
        film.shots.clear();
        film.closing_marked = new_in(&film.states[1], &film.states[0]);
        #[cfg(feature = "solid")]
        if !self.solids.is_empty() {
            film.solids = ends.map(|i| self.solids[i].clone()).to_vec();
            if film.closing_marked.is_empty() {
                film.add_shot("after", "", &[], &Journal::new());
            }
            return film;
        }
        film.add_shot("before", "", &marked, &Journal::new());
        film
    }

    /// One edit of the film by itself.
    pub(super) fn only(&self, shot: usize) -> Self {
        let mut film = Self::empty();
        film.states = self.states[shot..=shot + 1].to_vec();
        film.spreads = self.spreads.get(shot..=shot + 1).map(<[Spread]>::to_vec).unwrap_or_default();
        film.kernels = self.kernels.get(shot..=shot + 1).map(<[Dcel]>::to_vec).unwrap_or_default();
        film.shots = vec![self.shots[shot].clone()];
        film
    }

    /// The film without its states, which are to follow.
    pub(super) fn without_states(&self) -> Self {
        Self { states: Vec::new(), spreads: Vec::new(), kernels: Vec::new(), ..self.clone() }
    }

    /// What an edit marks.
    pub(super) fn marked(&self, shot: usize) -> &[Element] {
        &self.shots[shot].marked
    }

    /// What an edit changes.
    pub(super) fn journal(&self, shot: usize) -> &Journal {
        &self.shots[shot].journal
    }

    /// A frame for the start and one for what each edit led to; a last one if something is said about it.
    #[cfg(feature = "solid")]
    fn views(&self) -> Vec<Frame> {
        let mut out = vec![still("start", "", &self.states[0], 0, [0, 0], Vec::new())];
        for (i, shot) in self.shots.iter().enumerate() {
            let state = i + 1;
            let mut frame =
                still(&shot.title, &shot.caption, &self.states[state], state, [i, state], shot.marked.clone());
            frame.changes = shot.journal.changes().to_vec();
            frame.added = elements(shot.journal.changes(), true);
            frame.added.retain(|&element| has(&self.states[state], element));
            frame.removed = elements(shot.journal.changes(), false);
            frame.made.clone_from(&frame.added);
            out.push(frame);
        }
        let last = self.states.len() - 1;
        if !(self.closing.is_empty() && self.closing_marked.is_empty()) {
            let states = [last, last];
            out.push(still("after", &self.closing, &self.states[last], last, states, self.closing_marked.clone()));
        }
        out
    }

    fn steps(&self, shot: &Shot, states: [usize; 2], slips: &[Slip], out: &mut Vec<Frame>) {
        let after = &self.states[states[1]];
        let mut table = self.states[states[0]].clone();
        let moments = moments(&shot.journal);
        let turning = turning(&moments);
        let mut made = Vec::new();
        for (i, moment) in moments.into_iter().enumerate() {
            let changes: Vec<Change> = moment.changes.iter().filter_map(|change| Slip::of(slips, change)).collect();
            let changes = changes.as_slice();
            let before = table.clone();
            for change in changes {
                table.apply(change);
                if let Change::Added { element: Element::Vertex(v), .. } = *change {
                    place(&mut table, v, after);
                }
            }
            let turned = i >= turning;
            if turned {
                copy_regions(&mut table, after);
            }
            let added = elements(changes, true);
            made.extend(added.iter().copied());
            out.push(Frame {
                heading: moment.heading,
                text: idle(&moment.idle) + &summary(changes),
                changes: changes.to_vec(),
                written: written(changes, &before),
                added,
                removed: elements(changes, false),
                marked: shot.marked.clone(),
                areas: states[usize::from(turned)],
                states,
                table: table.clone(),
                before,
                made: made.clone(),
            });
        }
    }
}

/// The vertices, edges and faces of a table that another one has not.
fn new_in(table: &Table, before: &Table) -> Vec<Element> {
    let vertices = (0..table.vertices.len() as u32).map(|i| Element::from(VertexId::new(i)));
    let edges = (0..table.half_edges.len() as u32).step_by(2).map(|i| HalfEdgeId::new(i).edge().into());
    let faces = (0..table.faces.len() as u32).map(|i| Element::from(FaceId::new(i)));
    vertices.chain(edges).chain(faces).filter(|&element| has(table, element) && !has(before, element)).collect()
}

fn still(heading: &str, text: &str, table: &Table, areas: usize, states: [usize; 2], marked: Vec<Element>) -> Frame {
    Frame {
        heading: heading.to_owned(),
        text: text.to_owned(),
        table: table.clone(),
        marked,
        areas,
        states,
        before: table.clone(),
        ..Frame::default()
    }
}

fn place(table: &mut Table, v: VertexId, from: &Table) {
    let position = from.position(v).map(|p| [p.x, p.y]);
    if let Some(Some(row)) = table.vertices.get_mut(v.index()) {
        row.position = position;
    }
}

/// Rings and holes are not in the journal: they change when the areas do.
fn copy_regions(table: &mut Table, after: &Table) {
    for (i, row) in table.faces.iter_mut().enumerate() {
        let face = FaceId::new(i as u32);
        if let Some(row) = row {
            row.inner_components = after.inner_components(face).to_vec();
            row.hole = after.is_hole(face);
        }
    }
}

/// The pointers that differ after the changes from what they were in `before`.
fn written(changes: &[Change], before: &Table) -> Vec<Written> {
    let mut net: Vec<(Slot, Option<Element>, Option<Element>)> = Vec::new();
    let mut index: BTreeMap<String, usize> = BTreeMap::new();
    for change in changes {
        let Change::Write { slot, old, new } = *change else { continue };
        let at = *index.entry(slot.to_string()).or_insert_with(|| {
            net.push((slot, old.filter(|_| has(before, slot.owner())), None));
            net.len() - 1
        });
        net[at].2 = new;
    }
    let changed = net.into_iter().filter(|(_, old, new)| old != new);
    let both = changed.flat_map(|(slot, old, new)| [(slot, old, Fate::Gone), (slot, new, Fate::New)]);
    both.filter_map(|(slot, target, fate)| Some(Written { slot, target: target?, fate })).collect()
}

fn elements(changes: &[Change], come: bool) -> Vec<Element> {
    let pick = |change: &Change| match *change {
        Change::Added { element, .. } if come => Some(element),
        Change::Removed { element } if !come => Some(element),
        _ => None,
    };
    changes.iter().filter_map(pick).collect()
}

/// The steps that had nothing to do, in front of what has been done.
fn idle(steps: &[u32]) -> String {
    let numbers: Vec<String> = steps.iter().map(ToString::to_string).collect();
    match numbers.len() {
        0 => String::new(),
        1 => format!("nothing to do in step {}; ", numbers[0]),
        _ => format!("nothing to do in steps {}; ", numbers.join(", ")),
    }
}

/// What a step has written, in few words. `prev` goes without saying beside `next`, and so does the clearing of
/// what is removed.
fn summary(changes: &[Change]) -> String {
    let words = changes.iter().filter_map(|change| match change {
        Change::Write { slot: Slot::Prev(_), .. } | Change::Write { new: None, .. } => None,
        Change::Write { slot, new: Some(new), .. } => Some(format!("{slot} = {new}")),
        other => Some(other.to_string()),
    });
    let words: Vec<String> = words.collect();
    if words.is_empty() { "nothing to do here".to_owned() } else { words.join(", ") }
}
