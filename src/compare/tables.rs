//! Layer 2: two declared structures, pointer by pointer.
//!
//! ```text
//!   vertices   by place                                 v3 of one file is v7 of the other
//!   half-edges by (origin, destination)                 parallel ones by what their neighbours are
//!   pointers   through that map                         h17.next = h16, expected h0
//! ```
//!
//! Where an edge is missing or too much, the half-edges round it are linked otherwise of necessity. So `next` is
//! compared as if such edges had been taken out on both sides, and faces as if they had been joined there: each
//! mistake gives its own sentence and no others.

use super::frame::Search;
use super::graph::Telling;
use super::links::{Links, Reduced};
use super::placed::Placed;
use super::report::{Difference, Kind, Layer, Slot, Spot, Writing, counted};
use super::spots::Spots;
use super::{Options, faces, shape};
use crate::figure::structure::skeleton::{half_edges, mutual_twin, vertices};
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::topology::{Table, View, violations};

/// So many broken invariants are told beside differences.
const INVARIANTS: usize = 3;

/// What came of it.
pub(super) struct Found {
    pub(super) differences: Vec<Difference>,
    pub(super) notes: Vec<String>,
    /// How many half-edges of the reference have a partner with the same pointers, of how many.
    pub(super) agreed: (usize, usize),
}

/// Compares two tables. O(n log n).
pub(super) fn compare(expected: &Placed<'_>, found: &Placed<'_>, options: &Options) -> Found {
    let tolerance = expected.tolerance();
    let writing = Writing::new(tolerance, false);
    let matched = expected.matched(found);
    let (at_place, all) =
        (matched.to_found.iter().flatten().count() - matched.moved.len(), expected.graph.points.len());
    if all > 2 && 2 * at_place < all {
        let differences = vec![misplaced(expected, found, tolerance)];
        let agreed = (0, half_edges(expected.table).count());
        return Found { differences, notes: Vec::new(), agreed };
    }
    let extra_point = |m: u32, at: &str| {
        Some(format!("vertex {} of yours at {at} is not in the reference", found.graph.names[m as usize]))
    };
    let telling = Telling {
        layer: Layer::Declared,
        writing,
        tolerance,
        extra_point: &extra_point,
        is_told: &|_| true,
        hidden: &|_| None,
    };
    let mut differences = matched.differences(&expected.graph, &found.graph, &telling);
    differences.extend(unplaced(found.table));

    let links = Links::new(expected, found, &matched);
    let mut judge = Judge { expected, found, links: &links, writing, differences, wrong: 0 };
    judge.lone_halves();
    judge.pointers();
    faces::compare(expected, found, &links, &mut judge.differences);
    if options.names {
        judge.names();
    }
    let (mut differences, wrong) = (judge.differences, judge.wrong);
    let broken = violations(found.table);
    let mut notes = Vec::new();
    if differences.is_empty() {
        let mut spots = Spots::new(found);
        differences.extend(broken.iter().map(|violation| {
            let kind = violation.elements.first().map_or(Kind::Drawing, |&element| kind(element));
            let text = format!("your structure breaks an invariant: {violation}");
            let first = violation.elements.first();
            let spot = first.map_or(Spot::Nowhere, |&element| spots.of(element));
            Difference::new(kind, Layer::Declared, text, spot)
        }));
    } else {
        notes.extend(
            broken.iter().take(INVARIANTS).map(|violation| format!("your structure breaks an invariant: {violation}")),
        );
        if broken.len() > INVARIANTS {
            let more = counted(broken.len() - INVARIANTS, "more broken invariant", "more broken invariants");
            notes.push(format!("{more}: dcel validate lists them"));
        }
    }
    differences.sort_by_key(|difference| difference.kind);
    let all = half_edges(expected.table).count();
    let agreed = (links.count().saturating_sub(wrong), all);
    Found { differences, notes, agreed }
}

/// One sentence where hardly any vertex has the coordinates it should have.
fn misplaced(expected: &Placed<'_>, found: &Placed<'_>, tolerance: f64) -> Difference {
    let (mine, theirs) = (&expected.graph.points, &found.graph.points);
    let search = Search::new(mine, tolerance);
    let best = search.best(theirs, theirs, &[]);
    let text = match search.others(theirs, theirs, &best).first() {
        _ if 2 * best.matched >= mine.len() => {
            "the declared coordinates (data-x, data-y) are scaled or shifted: write those of the model".to_owned()
        }
        Some(frame) => frame.turn.sentence(),
        None => return shape::compare(&expected.graph, &found.graph),
    };
    Difference::new(Kind::Drawing, Layer::Declared, text, Spot::Nowhere)
}

fn kind(element: Element) -> Kind {
    match element {
        Element::Vertex(_) => Kind::Vertex,
        Element::Edge(_) => Kind::Edge,
        Element::HalfEdge(_) => Kind::HalfEdge,
        Element::Face(_) => Kind::Face,
    }
}

/// Vertices of the student without a position.
fn unplaced(table: &Table) -> impl Iterator<Item = Difference> + '_ {
    let without = |v: &VertexId| table.vertices[v.index()].is_none_or(|row| row.position.is_none());
    vertices(table).filter(without).map(|v| {
        let text = format!("vertex {v} of yours has no data-x and data-y");
        Difference::new(Kind::Vertex, Layer::Declared, text, Spot::Nowhere)
    })
}

struct Judge<'a> {
    expected: &'a Placed<'a>,
    found: &'a Placed<'a>,
    links: &'a Links,
    writing: Writing,
    differences: Vec<Difference>,
    /// Half-edges with a wrong pointer.
    wrong: usize,
}

impl Judge<'_> {
    fn say(&mut self, text: String, spot: Spot) {
        self.differences.push(Difference::new(Kind::HalfEdge, Layer::Declared, text, spot));
    }

    /// `h17 (0, 0) -> (3, 0)`, by the names of the reference.
    fn half_edge(&self, h: HalfEdgeId) -> String {
        self.with_ends(self.expected, h)
    }

    /// A half-edge of one of the two, with its ends if they are known.
    fn with_ends(&self, placed: &Placed<'_>, h: HalfEdgeId) -> String {
        let ends = placed.ends(h).map(|ends| placed.graph.ends(ends).map(|p| self.writing.point(p)));
        ends.map_or_else(|| h.to_string(), |[a, b]| format!("{h} {a} -> {b}"))
    }

    /// A half-edge of the student in a sentence: by the name of the reference, and the student's if that differs.
    fn theirs(&self, h: HalfEdgeId) -> String {
        match self.links.expected(h) {
            Some(name) if name == h => h.to_string(),
            Some(name) => format!("{name} (your {h})"),
            None => format!("your {}", self.with_ends(self.found, h)),
        }
    }

    /// Half-edges of an edge that is there, one half of which is missing or drawn once more.
    fn lone_halves(&mut self) {
        for h in half_edges(self.expected.table) {
            let twin = mutual_twin(self.expected.table, h);
            if self.links.found(h).is_none() && twin.is_some_and(|t| self.links.found(t).is_some()) {
                let spot = Spot::Pointer { half_edge: h, pointer: Slot::Whole, found: None };
                let text = format!("half-edge {} is missing; its twin is there", self.half_edge(h));
                self.say(text, spot);
            }
        }
        for h in half_edges(self.found.table).filter(|&h| self.links.expected(h).is_none()) {
            let Some(ends) = self.found.ends(h) else {
                self.say(format!("half-edge {h} of yours has no known ends"), Spot::Nowhere);
                continue;
            };
            let edge = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            if !self.links.is_extra_edge(edge) {
                let [a, b] = self.found.graph.ends(ends).map(|p| self.writing.point(p));
                let ends = self.found.graph.ends(ends);
                self.say(format!("half-edge {h} of yours, {a} -> {b}, is one too many there"), Spot::ExtraEdge(ends));
            }
        }
    }

    fn pointers(&mut self) {
        let links = self.links;
        let (mine, theirs) = (Reduced::expected(self.expected.table, links), Reduced::found(self.found.table, links));
        for h in half_edges(self.expected.table) {
            let Some(g) = links.found(h) else { continue };
            let before = self.differences.len();
            self.twin(h, g);
            self.link(h, g, Slot::Next, [mine.next(h), theirs.next(g)], self.found.table.next(g));
            let back = self.found.table.prev(g);
            if back.and_then(|p| self.found.table.next(p)) != Some(g) {
                self.link(h, g, Slot::Prev, [mine.prev(h), theirs.prev(g)], back);
            }
            self.wrong += usize::from(self.differences.len() > before);
        }
    }

    fn twin(&mut self, h: HalfEdgeId, g: HalfEdgeId) {
        let twins = [self.expected.table.twin(h), self.found.table.twin(g)];
        let partner = |t: Option<HalfEdgeId>| t.and_then(|t| self.links.found(t));
        // Of a half-edge whose twin is missing, that is what is told.
        if partner(twins[0]).is_none() && twins[0].is_some() {
            return;
        }
        self.link(h, g, Slot::Twin, twins, twins[1]);
    }

    /// One pointer: where it should lead, where it does once the edges that differ are out, and what is written.
    fn link(
        &mut self,
        h: HalfEdgeId,
        g: HalfEdgeId,
        slot: Slot,
        [to, does]: [Option<HalfEdgeId>; 2],
        raw: Option<HalfEdgeId>,
    ) {
        if to.and_then(|to| self.links.found(to)) == does && (does.is_some() || to.is_none()) {
            return;
        }
        let name = match slot {
            Slot::Twin => "twin",
            Slot::Prev => "prev",
            _ => "next",
        };
        let known = raw.filter(|&x| self.found.table.has_half_edge(x));
        let got = match (raw, known) {
            (None, _) => "is not set".to_owned(),
            (Some(x), None) => format!("is {x}, which does not exist"),
            (Some(x), Some(_)) if x == g => "is the half-edge itself".to_owned(),
            (Some(x), Some(_)) if slot != Slot::Twin && self.found.table.twin(g) == Some(x) => {
                format!("is {}, its own twin", self.theirs(x))
            }
            (Some(x), Some(_)) => format!("is {}", self.theirs(x)),
        };
        let wanted = to.map_or_else(|| "none".to_owned(), |to| self.half_edge(to));
        let whose = if h == g { String::new() } else { format!(" (your {g})") };
        let text = format!("half-edge {}{whose}: {name} {got}; expected {wanted}", self.half_edge(h));
        let found = raw.and_then(|x| self.links.expected(x)).map(Element::HalfEdge);
        self.say(text, Spot::Pointer { half_edge: h, pointer: slot, found });
    }

    /// Names that differ, when they are to be compared.
    fn names(&mut self) {
        for (i, &v) in self.expected.vertices.iter().enumerate() {
            let partner = self.links.vertex(i as u32).map(|m| self.found.vertices[m as usize]);
            if let Some(w) = partner.filter(|&w| w != v) {
                let at = self.expected.graph.points[i];
                let text = format!("vertex {v} at {} is called {w}", self.writing.point(at));
                self.differences.push(Difference::new(Kind::Vertex, Layer::Declared, text, Spot::MissingVertex(at)));
            }
        }
        for h in half_edges(self.expected.table) {
            if let Some(g) = self.links.found(h).filter(|&g| g != h) {
                let spot = Spot::Pointer { half_edge: h, pointer: Slot::Whole, found: None };
                self.say(format!("half-edge {} is called {g}", self.half_edge(h)), spot);
            }
        }
        faces::names(self.expected, self.found, self.links, &mut self.differences);
    }
}
