//! Half-edges that a figure of the kit declares and draws beside its edges: what is declared has to be seen, and where it
//! is declared.
//!
//! ```text
//!   v0 ●───────────────● v1        its line on the left of its edge, between its two vertices;
//!         ──────────▸              its barb at the end to which it runs, pointing there: the tip at the end of its
//!                                  own line, the barb behind it, on both sides or on the outer one
//! ```
//!
//! No line is much further from its edge than those of the others, unless its barb is as large, and none is much shorter
//! than the same half-edge in the reference, if that draws it: three quarters of that are enough, and so is to end as near
//! to the vertices, measured by how far lines lie from their edges.
//!
//! What the reference's own drawing does not show nobody has to show: the same half-edge, by its place, whatever its
//! number.

use super::beside::Beside;
use super::drawing::{Drawing, Half};
use super::eye::Eye;
use super::links::Links;
use super::painting::{Area, Part, Shape};
use super::pairing::{distance, sides, span};
use super::placed::Placed;
use super::report::{Difference, Kind, Layer, Spot, counted, listed};
use crate::figure::structure::skeleton::destination;
use crate::ids::{HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{Table, View};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// How far a line may lie from its edge, and its ends from each other across the edge, as parts of the edge.
const ASIDE: f64 = 0.25;
const SLANT: f64 = 0.05;
/// How far it may reach beyond the edge, as a part of it.
const BEYOND: f64 = 0.02;
/// A barb begins beyond this part of its edge.
const HEAD: f64 = 0.45;
/// How far the tip of a barb may lie from the end of its line: behind it, before it, and across, as parts of its size.
const TIP: [f64; 3] = [0.25, 1.0, 0.5];
/// The outer corner of a barb lies at least so far behind the tip, as a part of what lies across, the line's own width
/// left out.
const SLIM: f64 = 0.35;
/// A line is too far from its edge if that is further than this many times the size of its barb, and than this many
/// times the usual distance in the drawing.
const FAR: [f64; 2] = [1.6, 1.5];
/// A line is too short if it covers less than this part of what the reference's covers of its edge, and leaves out more
/// than this many times as much at its ends.
const SHORT: f64 = 0.75;
const LEFT_OUT: f64 = 1.5;
/// Edges of fewer distances of their lines than this are short: there lines may end anywhere.
const LONG: f64 = 8.0;
/// A barb lies on the side of its edge if it reaches so many times as far to that side of its line as to the other.
const INSIDE: f64 = 1.5;

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
    const ALL: [Self; 8] = [
        Self::Hidden,
        Self::Missing,
        Self::Elsewhere,
        Self::Bent,
        Self::Short,
        Self::NoBarb,
        Self::Backwards,
        Self::Inside,
    ];

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

/// An edge on the canvas, along one of its half-edges.
struct Along {
    from: Point,
    direction: [f64; 2],
    length: f64,
}

impl Along {
    fn new(from: Point, to: Point) -> Option<Self> {
        let length = distance(from, to);
        let direction = [(to.x - from.x) / length, (to.y - from.y) / length];
        (length > 0.0).then_some(Self { from, direction, length })
    }

    /// Where a point lies along the edge and to the left of it, as parts of the edge.
    fn place(&self, p: Point) -> [f64; 2] {
        let (x, y, [u, v]) = (p.x - self.from.x, p.y - self.from.y, self.direction);
        [(x * u + y * v) / self.length, (y * u - x * v) / self.length]
    }

    /// Whether a line runs beside the middle of the edge, on the left, and no further than its ends.
    fn has_beside(&self, ends: [Point; 2]) -> bool {
        let [[t, a], [s, b]] = ends.map(|p| self.place(p));
        let (first, last) = (t.min(s), t.max(s));
        let lies_along = (-BEYOND..0.5).contains(&first) && (0.5..=1.0 + BEYOND).contains(&last);
        lies_along && a.min(b) > 0.0 && a.max(b) <= ASIDE && (a - b).abs() <= SLANT
    }

    /// How far a line lies from the edge, on the canvas.
    fn distance(&self, ends: [Point; 2]) -> f64 {
        let [[_, a], [_, b]] = ends.map(|p| self.place(p));
        0.5 * (a + b) * self.length
    }

    /// Where the end of a line lies.
    fn front(&self, line: Stroke) -> [f64; 2] {
        let [start, end] = line.ends.map(|p| self.place(p));
        if end[0] > start[0] { end } else { start }
    }

    /// Whether a barb belongs to a line, and does not lie on its right.
    fn has_barb(&self, line: Stroke, corners: &[Point]) -> bool {
        let places: Vec<[f64; 2]> = corners.iter().map(|&p| self.place(p)).collect();
        let across = self.front(line)[1];
        let far = |sign: f64| places.iter().map(|p| sign * (p[1] - across)).fold(f64::NEG_INFINITY, f64::max);
        far(-1.0) <= INSIDE * far(1.0) && self.has_barb_at(line, &places)
    }

    /// Whether a barb would belong to a line if it lay on the other side of it: it reaches no farther aside than back,
    /// and its outer corner is the hindmost one.
    fn has_turned_barb(&self, line: Stroke, corners: &[Point]) -> bool {
        let across = self.front(line)[1];
        let places: Vec<[f64; 2]> =
            corners.iter().map(|&p| self.place(p)).map(|[t, a]| [t, 2.0 * across - a]).collect();
        let [long, wide] = sides(&places);
        let hindmost = places.iter().min_by(|p, q| p[0].total_cmp(&q[0]));
        let is_outer = hindmost.is_some_and(|hindmost| places.iter().all(|place| place[1] <= hindmost[1]));
        is_outer && wide <= long && self.has_barb_at(line, &places)
    }

    /// Whether a barb belongs to a line: its foremost corner is its tip and lies at the end of the line, and the corner
    /// farthest to the left lies behind that and beyond the line.
    fn has_barb_at(&self, line: Stroke, places: &[[f64; 2]]) -> bool {
        let front = self.front(line);
        let most = |i: usize| places.iter().max_by(|p, q| p[i].total_cmp(&q[i]));
        let (Some(tip), Some(outer)) = (most(0), most(1)) else { return false };
        let [long, wide] = sides(places);
        let size = long.max(wide);
        let [ahead, across] = [0, 1].map(|i| tip[i] - front[i]);
        let is_at_end = ahead >= -TIP[0] * size && ahead <= TIP[1] * size && across.abs() <= TIP[2] * size;
        let is_ahead = places.iter().all(|place| place[0] >= HEAD) && tip[0] <= 1.0 + BEYOND;
        let is_behind = outer[0] < tip[0] && tip[0] - outer[0] >= SLIM * (wide - 4.0 * line.half / self.length);
        let is_aside = outer[1] > front[1] && outer[1] <= 2.0 * ASIDE + 2.0 / self.length;
        is_at_end && is_ahead && is_behind && is_aside
    }

    /// The size of a barb on the canvas, along the edge or across it.
    fn size(&self, corners: &[Point]) -> f64 {
        let [long, wide] = sides(&corners.iter().map(|&p| self.place(p)).collect::<Vec<_>>());
        long.max(wide) * self.length
    }
}

/// A line on the canvas, with half its width.
#[derive(Clone, Copy)]
struct Stroke {
    ends: [Point; 2],
    half: f64,
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

/// A half-edge on the canvas: where its edge lies, and its lines.
struct Traced<'a> {
    half: &'a Half,
    id: HalfEdgeId,
    along: Option<Along>,
    lines: Vec<Stroke>,
    /// Those of its lines that run beside its edge.
    beside: Vec<Stroke>,
    /// Whether it has curves.
    bends: bool,
}

impl Traced<'_> {
    /// Whether none of its lines lies where it should.
    fn is_stray(&self) -> bool {
        self.along.is_some() && !self.lines.is_empty() && self.beside.is_empty()
    }

    /// How much of the edge its line runs along.
    fn reach(&self) -> Option<Reach> {
        let along = self.along.as_ref()?;
        let part = |line: &Stroke| {
            let [a, b] = line.ends.map(|p| along.place(p)[0]);
            (a - b).abs()
        };
        let line = self.beside.iter().max_by(|a, b| part(a).total_cmp(&part(b)))?;
        let (part, edge) = (part(line), along.length / along.distance(line.ends));
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
        let is_bent = |i: u32| drawing.bends.binary_search(&i).is_ok();
        let stroke = |i: u32| match drawing.painting.coats[i as usize].shape {
            Shape::Stroke(ends, half) => Some(Stroke { ends, half }),
            _ => None,
        };
        let lines: Vec<Stroke> = half.coats.clone().filter(|&i| !is_bent(i)).filter_map(stroke).collect();
        let is_beside = |line: &Stroke| along.as_ref().is_some_and(|along| along.has_beside(line.ends));
        let beside = lines.iter().copied().filter(is_beside).collect();
        Some(Traced { half, id, along, lines, beside, bends: half.coats.clone().any(is_bent) })
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
        let (h, half) = (traced.id, traced.half);
        // What lies on the line of another half-edge cannot be told from it: where it lies is what is wrong.
        if !(traced.is_stray() || eye.any_line(half.coats.clone(), !half.lacks, &strays)) {
            out.push((h, Wrong::Hidden));
            continue;
        }
        // Where its ends are not drawn, or at one place, nothing says where it should be.
        let Some(along) = &traced.along else { continue };
        let barbs: Vec<(u32, &Area)> = half
            .coats
            .clone()
            .map(|i| (i, &drawing.painting.coats[i as usize]))
            .filter(|(_, coat)| !matches!(coat.part, Part::Mark(_)))
            .filter_map(|(i, coat)| if let Shape::Area(area) = &coat.shape { Some((i, area)) } else { None })
            .collect();
        let beside = &traced.beside;
        let corners_of = |area: &Area| area.points().collect::<Vec<Point>>();
        let fits = |area: &Area| beside.iter().any(|&line| along.has_barb(line, &corners_of(area)));
        let is_turned = |area: &Area| beside.iter().any(|&line| along.has_turned_barb(line, &corners_of(area)));
        if beside.is_empty() && traced.bends {
            out.push((h, Wrong::Bent));
        } else if traced.lines.is_empty() {
            out.push((h, Wrong::Missing));
        } else if beside.is_empty() {
            out.push((h, Wrong::Elsewhere));
        } else if !barbs.iter().any(|&(i, area)| eye.shows(i, &corners(area))) {
            out.push((h, Wrong::NoBarb));
        } else if let Some((_, area)) = barbs.iter().find(|(_, area)| fits(area)) {
            let distance = beside.iter().map(|line| along.distance(line.ends)).fold(f64::INFINITY, f64::min);
            gaps.push(Gap { half_edge: h, distance, barb: along.size(&corners_of(area)) });
        } else if barbs.iter().any(|(_, area)| is_turned(area)) {
            out.push((h, Wrong::Inside));
        } else {
            out.push((h, Wrong::Backwards));
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

/// Points near the corners of an area, inside of it.
fn corners(area: &Area) -> Vec<Point> {
    let count = area.points().count() as f64;
    let (x, y) = area.points().fold((0.0, 0.0), |(x, y), p| (x + p.x / count, y + p.y / count));
    area.points().map(|p| Point::new(0.7 * p.x + 0.3 * x, 0.7 * p.y + 0.3 * y)).collect()
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
    let told = |wrong: Wrong| {
        let names: Vec<String> =
            found.iter().filter(|(_, other)| *other == wrong).map(|(h, _)| h.to_string()).collect();
        let [one, many] = wrong.words();
        let text = format!("{}: {}", counted(names.len(), one, many), listed(&names));
        (!names.is_empty()).then(|| Difference::new(Kind::HalfEdge, Layer::Drawn, text, Spot::Nowhere))
    };
    Wrong::ALL.into_iter().filter_map(told).collect()
}
