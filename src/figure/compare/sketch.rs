//! A drawing as points, edges and outlines: what layer 3 compares.
//!
//! ```text
//!   lines and dots ──snap──> points ──cut──> edges            outlines ──snap, cut──> cyclic sequences of points
//! ```
//!
//! The reference is cut at its own points; the student's drawing, once it is in the coordinates of the reference, at
//! the points of the reference.

use super::drawing::{Drawing, Line};
use super::error::{Fault, Problem};
use super::frame::Frame;
use super::graph::Graph;
use super::ink::Hidden;
use super::pairing::Places;
use super::rings;
use super::segments::Grid;
use super::tables::Placed;
use crate::figure::skeleton::faces;
use crate::plane::Point;
use crate::topology::{Ring, View, bounded_cycle};
use std::collections::BTreeMap;

/// A face's outline.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// Points in order, tidied; at least three.
    pub(super) ring: Vec<u32>,
    /// The name of the face, or nothing.
    pub(super) name: String,
}

/// Points, edges, outlines.
#[derive(Clone, Debug, Default)]
pub(super) struct Sketch {
    pub(super) graph: Graph,
    /// Which points have a dot, and why not if one is drawn that cannot be seen.
    pub(super) dots: Vec<Result<(), Option<Hidden>>>,
    pub(super) outlines: Vec<Outline>,
    /// Outlines that may be filled, and need not be: of the outer face and of holes.
    pub(super) welcome: Vec<Vec<u32>>,
    /// Edges that are drawn, but only so that nobody sees them.
    pub(super) hidden: BTreeMap<[u32; 2], Hidden>,
    /// How many edges are drawn more than once.
    pub(super) doubled: usize,
}

impl Sketch {
    pub(super) fn has_dots(&self) -> bool {
        self.dots.iter().any(Result::is_ok)
    }

    /// What a declared structure looks like when it is drawn.
    pub(super) fn of_table(placed: &Placed<'_>) -> Self {
        let table = placed.table;
        let mut out =
            Self { graph: placed.graph.clone(), dots: vec![Ok(()); placed.graph.points.len()], ..Self::default() };
        let corners = |h| -> Vec<u32> {
            rings::tidy(&bounded_cycle(table, h).filter_map(|h| Some(placed.ends(h)?[0])).collect::<Vec<_>>())
        };
        for f in faces(table) {
            let further = table.rings(f).iter().filter_map(|ring| match ring {
                Ring::Cycle(h) => Some(*h),
                Ring::Isolated(_) => None,
            });
            let is_outer = table.outer_face == Some(f);
            for (i, ring) in table.boundary(f).into_iter().chain(further).map(corners).enumerate() {
                if i == 0 && !is_outer && ring.len() > 2 {
                    out.outlines.push(Outline { ring, name: f.to_string() });
                } else {
                    out.welcome.push(rings::canonical(&ring));
                }
            }
        }
        out
    }

    /// What a reference without declared structure draws. y is up.
    pub(super) fn of_drawing(drawing: &Drawing, tolerance: f64) -> Result<Self, Fault> {
        let mut snap = Snap::new(&[], tolerance);
        let seen: Vec<Line> = drawing.lines.iter().filter(|line| line.hidden.is_none()).copied().collect();
        let dots = drawing.dots.iter().filter(|dot| dot.hidden.is_none()).map(|dot| dot.at);
        let corners = drawing.outlines.iter().flat_map(|outline| outline.points.iter().copied());
        for p in dots.chain(seen.iter().flat_map(|line| line.ends)).chain(corners) {
            snap.number(p);
        }
        let points = snap.points.clone();
        let visible = Drawing { lines: seen, ..drawing.clone() };
        Self::read(&visible, &Frame::IDENTITY, &points, tolerance)
    }

    /// What a drawing shows in the coordinates of `expected`.
    pub(super) fn read(drawing: &Drawing, frame: &Frame, expected: &[Point], tolerance: f64) -> Result<Self, Fault> {
        let mut grid = Grid::new(expected);
        let mut snap = Snap::new(expected, tolerance);
        let mut dots: BTreeMap<u32, Result<(), Option<Hidden>>> = BTreeMap::new();
        for dot in &drawing.dots {
            let seen = dot.hidden.map_or(Ok(()), |why| Err(Some(why)));
            let known = dots.entry(snap.number(frame.apply(dot.at))).or_insert(seen);
            *known = known.or(seen);
        }
        let mut hidden: BTreeMap<[u32; 2], Hidden> = BTreeMap::new();
        let mut edges = Vec::with_capacity(drawing.lines.len());
        for line in &drawing.lines {
            let chain = snap.chain(&mut grid, line.ends.map(|p| frame.apply(p)))?;
            for pair in chain.windows(2) {
                let edge = [pair[0].min(pair[1]), pair[0].max(pair[1])];
                match line.hidden {
                    None => edges.push(edge),
                    Some(why) => drop(hidden.insert(edge, why)),
                }
            }
        }
        let mut outlines = Vec::new();
        for outline in &drawing.outlines {
            let mut ring = Vec::new();
            let corners: Vec<Point> = outline.points.iter().map(|&p| frame.apply(p)).collect();
            for (i, &p) in corners.iter().enumerate() {
                ring.extend(snap.chain(&mut grid, [p, corners[(i + 1) % corners.len()]])?);
            }
            let ring = rings::tidy(&ring);
            if ring.len() > 2 {
                outlines.push(Outline { ring, name: String::new() });
            }
        }
        let names = vec![String::new(); snap.points.len()];
        let mut graph = Graph { points: snap.points, names, edges };
        let doubled = graph.tidy();
        hidden.retain(|edge, _| edge[0] != edge[1] && graph.edges.binary_search(edge).is_err());
        let dots = (0..graph.points.len() as u32).map(|v| dots.get(&v).copied().unwrap_or(Err(None))).collect();
        Ok(Self { graph, dots, outlines, welcome: Vec::new(), hidden, doubled })
    }
}

/// Points by place: those near an expected point become one, and so do those near each other.
struct Snap {
    expected: Places,
    /// The number of each expected point, once something is drawn there.
    numbers: Vec<Option<u32>>,
    others: Places,
    other_numbers: Vec<u32>,
    points: Vec<Point>,
    tolerance: f64,
}

impl Snap {
    fn new(expected: &[Point], tolerance: f64) -> Self {
        Self {
            expected: Places::of(expected, 4.0 * tolerance),
            numbers: vec![None; expected.len()],
            others: Places::new(4.0 * tolerance),
            other_numbers: Vec::new(),
            points: Vec::new(),
            tolerance,
        }
    }

    fn number(&mut self, p: Point) -> u32 {
        if let Some(v) = self.expected.near(p, self.tolerance) {
            return self.at_expected(v, p);
        }
        let i = self.others.near_or_add(p, self.tolerance) as usize;
        if i == self.other_numbers.len() {
            self.other_numbers.push(self.points.len() as u32);
            self.points.push(p);
        }
        self.other_numbers[i]
    }

    fn at_expected(&mut self, v: u32, p: Point) -> u32 {
        let next = self.points.len() as u32;
        let number = *self.numbers[v as usize].get_or_insert(next);
        if number == next {
            self.points.push(p);
        }
        number
    }

    /// The points of a line in order: its ends, and the expected points between them.
    fn chain(&mut self, grid: &mut Grid<'_>, ends: [Point; 2]) -> Result<Vec<u32>, Fault> {
        let [a, b] = ends.map(|p| self.number(p));
        let too_much = || Fault::from(Problem::TooLarge { what: "points along lines", limit: super::segments::WORK });
        let between = grid.along(ends, self.tolerance).ok_or_else(too_much)?;
        let mut out = vec![a];
        for v in between {
            let at = self.expected.points()[v as usize];
            out.push(self.at_expected(v, at));
        }
        out.push(b);
        out.dedup();
        Ok(out)
    }
}
