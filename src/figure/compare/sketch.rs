//! A drawing as points, edges and outlines: what layer 3 compares.
//!
//! ```text
//!   lines and dots ──snap──> points ──cut──> edges            outlines ──snap, cut──> cyclic sequences of points
//! ```
//!
//! The reference is cut at its own points; the student's drawing, once it is in the coordinates of the reference, at
//! the points of the reference. So a further dot on an edge is one fault, and not three.

use super::drawing::{Drawing, Line};
use super::error::{Fault, Problem};
use super::frame::Frame;
use super::graph::Graph;
use super::ink::Hidden;
use super::pairing::Places;
use super::segments::Grid;
use super::tables::Placed;
use super::{rings, shape};
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
    /// Lines that nobody sees where nothing else is drawn.
    pub(super) unseen: usize,
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

    /// What a reference without declared structure draws, cut at its own points. y is up.
    pub(super) fn of_drawing(drawing: &Drawing, tolerance: f64) -> Result<Self, Fault> {
        let seen = |hidden: Option<Hidden>| hidden.is_none();
        let lines = drawing.lines.iter().filter(|line| seen(line.hidden)).copied().collect();
        let dots = drawing.dots.iter().filter(|dot| seen(dot.hidden)).cloned().collect();
        let visible = Drawing { lines, dots, outlines: drawing.outlines.clone(), notes: Vec::new() };
        let mut out = Self::read(&visible, &Frame::IDENTITY, &[], tolerance)?;
        out.welcome = shape::outside(&out.graph).iter().map(|ring| rings::canonical(&rings::tidy(ring))).collect();
        Ok(out)
    }

    /// Writes the places of the model, and the names of vertices, if the dots of a drawing declare them all alike.
    /// Returns the map that brings the drawing there.
    pub(super) fn place_in_model(&mut self, drawing: &Drawing, tolerance: f64) -> Option<Frame> {
        let known: Vec<(Point, &String, Point)> =
            drawing.dots.iter().filter_map(|dot| dot.vertex.as_ref().map(|(name, p)| (dot.at, name, *p))).collect();
        let models: Vec<Point> = known.iter().map(|k| k.2).collect();
        let canvas: Vec<Point> = known.iter().map(|k| k.0).collect();
        let frame = Frame::between(&canvas, &models, tolerance)?;
        let places = Places::of(&self.graph.points, tolerance);
        let numbers: Vec<Option<u32>> = canvas.iter().map(|&p| places.near(p, tolerance)).collect();
        self.graph.points.iter_mut().for_each(|p| *p = frame.apply(*p));
        for ((_, name, model), number) in known.into_iter().zip(numbers) {
            let Some(i) = number else { continue };
            self.graph.points[i as usize] = model;
            name.clone_into(&mut self.graph.names[i as usize]);
        }
        Some(frame)
    }

    /// What a drawing shows in the coordinates of `expected`; without those, in its own.
    pub(super) fn read(drawing: &Drawing, frame: &Frame, expected: &[Point], tolerance: f64) -> Result<Self, Fault> {
        let mut snap = Snap::new(expected, tolerance);
        let mut dots: BTreeMap<u32, Result<(), Option<Hidden>>> = BTreeMap::new();
        for dot in &drawing.dots {
            let seen = dot.hidden.map_or(Ok(()), |why| Err(Some(why)));
            let known = dots.entry(snap.number(frame.apply(dot.at))).or_insert(seen);
            *known = known.or(seen);
        }
        // All ends first: a line is cut only where something ends or stands.
        let lines: Vec<[Point; 2]> = drawing.lines.iter().map(|line| line.ends.map(|p| frame.apply(p))).collect();
        let seen = |(line, ends): (&Line, &[Point; 2])| line.hidden.is_none().then(|| ends.map(|p| snap.number(p)));
        let ends: Vec<Option<[u32; 2]>> = drawing.lines.iter().zip(&lines).map(seen).collect();
        let corners = |outline: &super::drawing::Outline| outline.points.iter().map(|&p| frame.apply(p)).collect();
        let corners: Vec<Vec<Point>> = drawing.outlines.iter().map(corners).collect();
        for &p in corners.iter().flatten() {
            snap.number(p);
        }
        let mut cutter = Cutter::new(&snap, expected, tolerance);
        let mut hidden: BTreeMap<[u32; 2], Hidden> = BTreeMap::new();
        let mut edges = Vec::with_capacity(drawing.lines.len());
        let mut unseen = 0;
        for ((line, &places), numbers) in drawing.lines.iter().zip(&lines).zip(ends) {
            let Some(numbers) = numbers.or_else(|| snap.known(places)) else {
                unseen += 1;
                continue;
            };
            for pair in cutter.chain(numbers, places)?.windows(2) {
                let edge = [pair[0].min(pair[1]), pair[0].max(pair[1])];
                match line.hidden {
                    None => edges.push(edge),
                    Some(why) => drop(hidden.insert(edge, why)),
                }
            }
        }
        let mut outlines = Vec::new();
        for (outline, corners) in drawing.outlines.iter().zip(&corners) {
            let mut ring = Vec::new();
            for (i, &p) in corners.iter().enumerate() {
                let side = [p, corners[(i + 1) % corners.len()]];
                if let Some(numbers) = snap.known(side) {
                    ring.extend(cutter.chain(numbers, side)?);
                }
            }
            let ring = rings::tidy(&ring);
            if ring.len() > 2 {
                outlines.push(Outline { ring, name: outline.name.clone() });
            }
        }
        let names = vec![String::new(); snap.points.len()];
        let mut graph = Graph { points: snap.points, names, edges };
        let doubled = graph.tidy();
        hidden.retain(|edge, _| edge[0] != edge[1] && graph.edges.binary_search(edge).is_err());
        let dots = (0..graph.points.len() as u32).map(|v| dots.get(&v).copied().unwrap_or(Err(None))).collect();
        Ok(Self { graph, dots, outlines, welcome: Vec::new(), hidden, unseen, doubled })
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

    /// The number of what is at a place, a new one if need be.
    fn number(&mut self, p: Point) -> u32 {
        let next = self.points.len() as u32;
        let number = match self.expected.near(p, self.tolerance) {
            Some(v) => *self.numbers[v as usize].get_or_insert(next),
            None => {
                let i = self.others.near_or_add(p, self.tolerance) as usize;
                if i == self.other_numbers.len() {
                    self.other_numbers.push(next);
                }
                self.other_numbers[i]
            }
        };
        if number == next {
            self.points.push(p);
        }
        number
    }

    /// The numbers of both ends, if something is drawn at both.
    fn known(&self, ends: [Point; 2]) -> Option<[u32; 2]> {
        let known = |p: Point| match self.expected.near(p, self.tolerance) {
            Some(v) => self.numbers[v as usize],
            None => self.others.near(p, self.tolerance).map(|i| self.other_numbers[i as usize]),
        };
        let [a, b] = ends.map(known);
        a.zip(b).map(|(a, b)| [a, b])
    }
}

/// Cuts lines at points at which something is drawn: the expected ones, or if nothing is expected all.
struct Cutter {
    points: Vec<Point>,
    numbers: Vec<u32>,
    grid: Grid,
    tolerance: f64,
}

impl Cutter {
    fn new(snap: &Snap, expected: &[Point], tolerance: f64) -> Self {
        let (points, numbers): (Vec<Point>, Vec<u32>) = if expected.is_empty() {
            (snap.points.clone(), (0..snap.points.len() as u32).collect())
        } else {
            let drawn = expected.iter().zip(&snap.numbers).filter_map(|(&p, number)| Some((p, (*number)?)));
            drawn.unzip()
        };
        Self { grid: Grid::new(&points), points, numbers, tolerance }
    }

    /// The numbers along a line, its ends among them.
    fn chain(&mut self, [a, b]: [u32; 2], ends: [Point; 2]) -> Result<Vec<u32>, Fault> {
        let too_much = || Fault::from(Problem::TooLarge { what: "points along lines", limit: super::segments::WORK });
        let between = self.grid.along(&self.points, ends, self.tolerance).ok_or_else(too_much)?;
        let mut out = vec![a];
        out.extend(between.into_iter().map(|i| self.numbers[i as usize]));
        out.push(b);
        out.dedup();
        Ok(out)
    }
}
