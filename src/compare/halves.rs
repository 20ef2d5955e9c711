//! Half-edges that a figure of the kit declares and draws beside its edges: what is declared has to be seen, and where it
//! is declared.
//!
//! ```text
//!   v0 ●───────────────● v1        its line on the left of its edge, between its two vertices;
//!         ──────────▸              its barb at the end to which it runs, pointing there: the tip at the end of its
//!                                  own line, the barb behind it, on both sides or on the outer one (arrows.rs)
//! ```
//!
//! No head points back. No line is much further from its edge than those of the others, unless its barb is as large, and
//! none is much shorter than the same half-edge in the reference, if that draws it: three quarters of that are enough, and
//! so is to end as near to the vertices, measured by how far lines lie from their edges.
//!
//! What the reference's own drawing does not show nobody has to show: the same half-edge, by its place, whatever its
//! number.

use super::along::Along;
use super::arrows::{Arrow, Head};
use super::beside::Beside;
use super::drawing::{Drawing, Half};
use super::eye::Eye;
use super::links::Links;
use super::pairing::span;
use super::placed::Placed;
use super::report::{Difference, Kind, Layer, counted, listed};
use super::spots::{self, Spots};
use crate::figure::structure::skeleton::destination;
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{Table, View};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// A line is too far from its edge if that is further than this many times the size of its barb, and than this many
/// times the usual distance in the drawing.
const FAR: [f64; 2] = [1.6, 1.5];
/// A line is too short if it covers less than this part of what the reference's covers of its edge, and leaves out more
/// than this many times as much at its ends.
const SHORT: f64 = 0.75;
const LEFT_OUT: f64 = 1.5;
/// Edges of fewer distances of their lines than this are short: there lines may end anywhere.
const LONG: f64 = 8.0;
/// What is wrong with a half-edge as it is drawn.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Wrong {
    Hidden,
    Missing,
    Elsewhere,
    Bent,
    Short,
    NoBarb,
    Backwards,
    Inside,
}

impl Wrong {
    /// What is said of one half-edge, and of several.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::Hidden => ["half-edge is declared and cannot be seen", "half-edges are declared and cannot be seen"],
            Self::Missing => ["half-edge is declared and not drawn", "half-edges are declared and not drawn"],
            Self::Elsewhere => [
                "half-edge is not drawn on the left of its edge, from vertex to vertex",
                "half-edges are not drawn on the left of their edges, from vertex to vertex",
            ],
            Self::Bent => [
                "half-edge is drawn as a curve, which is not read: draw a straight line",
                "half-edges are drawn as curves, which are not read: draw straight lines",
            ],
            Self::Short => [
                "half-edge is drawn much too short: it runs from vertex to vertex",
                "half-edges are drawn much too short: they run from vertex to vertex",
            ],
            Self::Inside => [
                "half-edge has its barb on the side of its edge, not on that of its face",
                "half-edges have their barbs on the sides of their edges, not on those of their faces",
            ],
            Self::NoBarb => ["half-edge has no barb that can be seen", "half-edges have no barbs that can be seen"],
            Self::Backwards => [
                "half-edge has a barb that does not point to the end of it",
                "half-edges have barbs that do not point to the ends of them",
            ],
        }
    }
}

/// How far the line of a half-edge lies from its edge.
struct Gap {
    half_edge: HalfEdgeId,
    distance: f64,
    /// The size of its barb.
    barb: f64,
}

/// Half-edges whose lines lie far from their edges, where those of others do not.
fn strayed(mut gaps: Vec<Gap>) -> impl Iterator<Item = HalfEdgeId> {
    gaps.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let usual = gaps.get(gaps.len().saturating_sub(1) / 2).map_or(0.0, |gap| gap.distance);
    let is_far = move |gap: &Gap| gap.distance > FAR[0] * gap.barb && gap.distance > FAR[1] * usual;
    gaps.into_iter().filter(is_far).map(|gap| gap.half_edge)
}

/// A half-edge on the canvas: where its edge lies, and what is drawn of it.
struct Traced<'a> {
    half: &'a Half,
    id: HalfEdgeId,
    along: Option<Along>,
    arrow: Arrow,
}

impl Traced<'_> {
    /// Whether none of its lines lies where it should.
    fn is_stray(&self) -> bool {
        self.along.is_some() && self.arrow.is_drawn && self.arrow.shafts.is_empty()
    }

    /// How much of the edge its line runs along.
    fn reach(&self) -> Option<Reach> {
        let along = self.along.as_ref()?;
        let part = |ends: [Point; 2]| {
            let [a, b] = ends.map(|p| along.place(p)[0]);
            (a - b).abs()
        };
        let lines = self.arrow.shafts.iter().map(|shaft| shaft.line.ends);
        let ends = lines.max_by(|a, b| part(*a).total_cmp(&part(*b)))?;
        let (part, edge) = (part(ends), along.length / along.distance(ends));
        Some(Reach { part, left_out: (1.0 - part) * edge, is_long: edge >= LONG })
    }
}

/// The half-edges of a drawing.
fn traced<'a>(drawing: &'a Drawing, table: &Table) -> Vec<Traced<'a>> {
    let places: BTreeMap<&str, Point> =
        drawing.dots.iter().filter_map(|dot| Some((dot.vertex.as_ref()?.0.as_str(), dot.at))).collect();
    let trace = |half: &'a Half| {
        let id = half.name.parse::<HalfEdgeId>().ok()?;
        let place = |v: Option<VertexId>| places.get(v?.to_string().as_str()).copied();
        let along = place(table.origin(id)).zip(place(destination(table, id))).and_then(|(p, q)| Along::new(p, q));
        let arrow = Arrow::read(drawing, half, along.as_ref());
        Some(Traced { half, id, along, arrow })
    };
    drawing.halves.iter().filter_map(trace).collect()
}

/// The half-edges of a drawing that are not seen as they are declared.
fn wrong(drawing: &Drawing, table: &Table) -> Vec<(HalfEdgeId, Wrong)> {
    if drawing.halves.is_empty() {
        return Vec::new();
    }
    let span = span(&drawing.points().collect::<Vec<Point>>());
    let mut eye = Eye::new(&drawing.painting, &Beside::default(), drawing.lines.len(), span);
    let traced = traced(drawing, table);
    let mut strays: Vec<Range<u32>> =
        traced.iter().filter(|traced| traced.is_stray()).map(|traced| traced.half.coats.clone()).collect();
    strays.sort_unstable_by_key(|range| range.start);
    let mut out = Vec::new();
    let mut gaps = Vec::new();
    for traced in &traced {
        let Traced { half, id, along, arrow } = traced;
        // What lies on the line of another half-edge cannot be told from it: where it lies is what is wrong.
        let is_seen = traced.is_stray()
            || if arrow.shafts.is_empty() {
                eye.any_line(half.coats.clone(), !half.lacks, &strays)
            } else {
                arrow.is_seen(&mut eye, &strays)
            };
        if !is_seen {
            out.push((*id, Wrong::Hidden));
            continue;
        }
        // Where its ends are not drawn, or at one place, nothing says where it should be.
        let Some(along) = along else { continue };
        let heads: Vec<&Head> = arrow.heads.iter().filter(|head| arrow.has_seen(head, &mut eye)).collect();
        let (right, others): (Vec<&Head>, Vec<&Head>) = heads.iter().partition(|head| arrow.points_ahead(head, along));
        if arrow.shafts.is_empty() && arrow.bends {
            out.push((*id, Wrong::Bent));
        } else if !arrow.is_drawn {
            out.push((*id, Wrong::Missing));
        } else if arrow.shafts.is_empty() {
            out.push((*id, Wrong::Elsewhere));
        } else if heads.is_empty() {
            out.push((*id, Wrong::NoBarb));
        } else if let Some(head) = right.first().filter(|_| !others.iter().any(|head| arrow.points_back(head, along))) {
            let distances = arrow.shafts.iter().map(|shaft| along.distance(shaft.line.ends));
            let distance = distances.fold(f64::INFINITY, f64::min);
            gaps.push(Gap { half_edge: *id, distance, barb: along.size(&head.corners) });
        } else if right.is_empty() && others.iter().any(|head| arrow.is_turned(head, along)) {
            out.push((*id, Wrong::Inside));
        } else {
            out.push((*id, Wrong::Backwards));
        }
    }
    out.extend(strayed(gaps).map(|h| (h, Wrong::Elsewhere)));
    out
}

/// How far the line of a half-edge reaches: the part of the edge along which it runs, and what it leaves out at both
/// ends, in distances of the line from the edge.
#[derive(Clone, Copy)]
struct Reach {
    part: f64,
    left_out: f64,
    /// Whether the edge is long enough to judge by that.
    is_long: bool,
}

impl Reach {
    /// Whether it is clearly shorter than another one, which may be drawn in another size.
    fn is_short_of(self, other: Self) -> bool {
        self.is_long && self.part < SHORT * other.part && self.left_out > LEFT_OUT * other.left_out
    }
}

/// How far the half-edges of a drawing reach.
fn reaches(drawing: &Drawing, table: Option<&Table>) -> BTreeMap<HalfEdgeId, Reach> {
    let traced = table.map_or_else(Vec::new, |table| traced(drawing, table));
    traced.iter().filter_map(|traced| Some((traced.id, traced.reach()?))).collect()
}

/// What a file declares and does not show so, unless the reference shows it no better. `tables` are the declared
/// structures of both, `placed` the same where both have one.
pub(super) fn compare(
    [reference, student]: [&Drawing; 2],
    tables: [Option<&Table>; 2],
    placed: Option<[&Placed<'_>; 2]>,
) -> Vec<Difference> {
    let faults = |drawing, table: Option<&Table>| table.map_or_else(Vec::new, |table| wrong(drawing, table));
    let mut found = faults(student, tables[1]);
    let [usual, reached] =
        [(reference, tables[0]), (student, tables[1])].map(|(drawing, table)| reaches(drawing, table));
    if found.is_empty() && (usual.is_empty() || reached.is_empty()) {
        return Vec::new();
    }
    if let Some([expected, theirs]) = placed {
        let links = Links::new(expected, theirs, &expected.matched(theirs));
        let told: BTreeSet<HalfEdgeId> = found.iter().map(|(g, _)| *g).collect();
        if !told.is_empty() {
            let excused: BTreeSet<(HalfEdgeId, Wrong)> = faults(reference, tables[0]).into_iter().collect();
            found.retain(|&(g, wrong)| links.expected(g).is_none_or(|h| !excused.contains(&(h, wrong))));
        }
        let is_short = |g: HalfEdgeId, reach: Reach| {
            let usual = links.expected(g).and_then(|h| usual.get(&h));
            usual.is_some_and(|usual| reach.is_short_of(*usual)) && !told.contains(&g)
        };
        found.extend(reached.iter().filter(|(g, reach)| is_short(**g, **reach)).map(|(g, _)| (*g, Wrong::Short)));
    }
    let mut groups: BTreeMap<Wrong, Vec<HalfEdgeId>> = BTreeMap::new();
    found.iter().for_each(|&(h, wrong)| groups.entry(wrong).or_default().push(h));
    let told = |(wrong, half_edges): (Wrong, Vec<HalfEdgeId>)| {
        let names: Vec<String> = half_edges.iter().map(ToString::to_string).collect();
        let [one, many] = wrong.words();
        let text = format!("{}: {}", counted(names.len(), one, many), listed(&names));
        let mut places = placed.map(|[_, theirs]| Spots::new(theirs));
        let spots = half_edges.into_iter().filter_map(|g| Some(places.as_mut()?.of(Element::HalfEdge(g))));
        Difference::new(Kind::HalfEdge, Layer::Drawn, text, spots::all(spots))
    };
    groups.into_iter().map(told).collect()
}
