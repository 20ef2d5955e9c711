//! A drawing as points, edges and outlines: what layer 3 compares.
//!
//! ```text
//!   lines and dots ──snap──> points ──cut──> edges            outlines ──snap, cut──> cyclic sequences of points
//! ```
//!
//! What stands beside the structure, such as paper, axes and letters, is left out by `beside.rs`.
//!
//! The reference is cut at its own points; the student's drawing, once it is in the coordinates of the reference, at
//! the points of the reference. So a further dot on an edge is one fault, and not three.

use super::beside::{self, Area, Beside, Called, Extent, Trim, kind};
use super::drawing::{Drawing, Line};
use super::ends::{Circles, Loose};
use super::error::{Fault, Problem};
use super::frame::Frame;
use super::graph::{Graph, Matched};
use super::ink::Hidden;
use super::pairing::{Places, edge_by, lies_on};
use super::placed::Placed;
use super::segments::Grid;
use super::snap::Snap;
use super::{drawing, labels, legends, rings, shape};
use crate::figure::structure::skeleton::faces;
use crate::plane::Point;
use crate::topology::{View, bounded_cycle};
use std::collections::{BTreeMap, BTreeSet};

/// A face's outline.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// Points in order, tidied; at least three.
    pub(super) ring: Vec<u32>,
    /// The name of the face, or nothing.
    pub(super) name: String,
    /// Whether the face is a hole.
    hole: bool,
    /// What paints it.
    pub(super) coat: u32,
}

/// Points, edges, outlines.
#[derive(Clone, Debug, Default)]
pub(super) struct Sketch {
    pub(super) graph: Graph,
    /// Which points have a dot, and why not if one is drawn that cannot be seen.
    pub(super) dots: Vec<Result<(), Option<Hidden>>>,
    /// How far the dots reach, in px of the canvas; 0 without one.
    pub(super) radii: Vec<f64>,
    /// At which points lines end that can be seen.
    ends: Vec<bool>,
    pub(super) outlines: Vec<Outline>,
    /// Outlines that may be filled, and need not be: of the outer face and of holes.
    pub(super) welcome: Vec<Vec<u32>>,
    /// Outlines that their own element leaves empty.
    pub(super) holes: Vec<Vec<u32>>,
    /// Outlines of declared hole faces.
    pub(super) open: Vec<Vec<u32>>,
    /// Edges that are drawn, but only so that nobody sees them.
    pub(super) hidden: BTreeMap<[u32; 2], Hidden>,
    /// How many edges are drawn more than once.
    pub(super) doubled: usize,
    /// Lines that nobody sees where nothing else is drawn.
    pub(super) unseen: usize,
    /// Edges that dashes leave out in part, or nearly whole, with the coats of the dashes of each line.
    pub(super) sparse: BTreeMap<[u32; 2], Vec<[u32; 2]>>,
    /// Such lines of a reference.
    pub(super) specks: Vec<[Point; 2]>,
    pub(super) beside: Beside,
}

impl Sketch {
    /// Why nobody sees an edge of the reference that is drawn.
    pub(super) fn hidden_as(&self, edge: [u32; 2], matched: &Matched) -> Option<Hidden> {
        self.hidden.get(&edge_by(edge, &matched.to_found)?).copied()
    }

    /// Whether a line ends at a point.
    pub(super) fn is_end(&self, m: u32) -> bool {
        self.ends.get(m as usize).copied().unwrap_or(false)
    }

    /// Whether a point that the reference does not have is a fault of its own: it has a line or a dot.
    pub(super) fn is_told(&self, m: u32) -> bool {
        self.is_end(m) || self.dots[m as usize].is_ok()
    }

    pub(super) fn has_dots(&self) -> bool {
        self.dots.iter().any(Result::is_ok)
    }

    /// What a declared structure looks like when it is drawn.
    pub(super) fn of_table(placed: &Placed<'_>) -> Self {
        let table = placed.table;
        let count = placed.graph.points.len();
        let graph = placed.graph.clone();
        let mut out = Self { graph, dots: vec![Ok(()); count], radii: vec![0.0; count], ..Self::default() };
        let corners = |h| -> Vec<u32> {
            rings::tidy(&bounded_cycle(table, h).filter_map(|h| Some(placed.ends(h)?[0])).collect::<Vec<_>>())
        };
        for f in faces(table) {
            let further = table.inner_components(f).iter().filter_map(|ring| ring.cycle());
            // A hole looks like the paper, and so may the outer face.
            let is_free = table.outer_face == Some(f) || table.is_hole(f);
            for (i, ring) in table.half_edge(f).into_iter().chain(further).map(corners).enumerate() {
                let parts = rings::parts(&ring);
                let is_one = parts.len() == 1;
                for part in parts {
                    // Of a face that a bridge leads through, the outline that runs counter-clockwise is its own.
                    let runs_round = || rings::area(part.iter().map(|&v| placed.graph.point(v))) > 0.0;
                    if i == 0 && !is_free && part.len() > 2 && (is_one || runs_round()) {
                        out.outlines.push(Outline { ring: part, name: f.to_string(), hole: false, coat: u32::MAX });
                    } else {
                        out.open.extend((i == 0 && table.is_hole(f) && part.len() > 2).then(|| part.clone()));
                        out.welcome.push(rings::canonical(&part));
                    }
                }
            }
        }
        out
    }

    /// What a reference without declared structure draws, cut at its own points. y is up.
    pub(super) fn of_drawing(drawing: &Drawing, tolerance: f64) -> Result<Self, Fault> {
        let mut visible = drawing.clone();
        visible.lines.retain(|line| line.hidden.is_none());
        visible.dots.retain(|dot| dot.hidden.is_none());
        let frames = beside::frames(&visible);
        let mut stays = frames.iter().map(|is_frame| !is_frame);
        visible.lines.retain(|_| stays.next().unwrap_or(true));
        let read = |drawing: &Drawing| {
            Self::read(drawing, &Frame::IDENTITY, &Graph::default(), tolerance, &Trim::nothing(drawing))
        };
        if drawing.has_legend() {
            let mut rest = visible.clone();
            rest.take_out(|legend| legend > 0);
            let graph = read(&rest)?.graph;
            let edges: Vec<[Point; 2]> = graph.edges.iter().map(|&edge| graph.ends(edge)).collect();
            let legends = legends::legends(drawing, &Frame::IDENTITY, &graph.points, &edges);
            visible.take_out(|legend| legends.get(&legend).is_some_and(|is_clear| *is_clear));
        }
        let mut out = read(&visible)?;
        out.specks = specks(drawing, &Frame::IDENTITY);
        let outside = shape::outside(&out.graph).into_iter().flat_map(|ring| rings::parts(&rings::tidy(&ring)));
        out.welcome = outside.map(|ring| rings::canonical(&ring)).collect();
        // Holes may be left as paper; the face round one has the same outline.
        let holes = out.outlines.iter().filter(|outline| outline.hole).map(|outline| rings::canonical(&outline.ring));
        let holes: BTreeSet<Vec<u32>> = holes.flat_map(|ring| [rings::reversed(&ring), ring]).collect();
        out.outlines.retain(|outline| !holes.contains(&rings::canonical(&outline.ring)));
        out.open.extend(holes.iter().cloned());
        out.welcome.extend(holes);
        let empty = out.holes.iter().flat_map(|ring| [rings::reversed(ring), rings::canonical(ring)]);
        out.welcome.extend(empty.collect::<Vec<_>>());
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
        self.specks.iter_mut().flatten().for_each(|p| *p = frame.apply(*p));
        for ((_, name, model), number) in known.into_iter().zip(numbers) {
            let Some(i) = number else { continue };
            self.graph.points[i as usize] = model;
            name.clone_into(&mut self.graph.names[i as usize]);
        }
        Some(frame)
    }

    /// What a drawing shows in the coordinates of the graph that is expected; without points of that, in its own.
    pub(super) fn read(
        drawing: &Drawing,
        frame: &Frame,
        graph: &Graph,
        tolerance: f64,
        trim: &Trim,
    ) -> Result<Self, Fault> {
        let expected = &graph.points[..];
        let mut snap = Snap::new(expected, tolerance);
        let mut beside = Beside { border: drawing.axes[0], aside: drawing.axes[1], ..Beside::default() };
        let around = Extent::around(if expected.is_empty() { drawing.points().collect() } else { expected.to_vec() });
        let legends = match trim.called {
            Called::Nothing => BTreeMap::new(),
            Called::Legend | Called::Any => legends::legends(drawing, frame, expected, &trim.edges),
        };
        beside.over = legends.iter().filter(|(_, is_clear)| !**is_clear).count();
        let is_beside = |aside: bool, legend: u32, points: &[Point]| {
            trim.may_leave_out(aside, legend) && (legends.contains_key(&legend) || around.is_clear_of(points))
        };
        let mut dots: BTreeMap<u32, (Result<(), Option<Hidden>>, f64)> = BTreeMap::new();
        for dot in &drawing.dots {
            let at = frame.apply(dot.at);
            if is_beside(dot.aside, dot.legend, &[at]) {
                beside.aside += 1;
                continue;
            }
            let seen = dot.hidden.map_or(Ok(()), |why| Err(Some(why)));
            let radius = if seen.is_ok() { dot.radius } else { 0.0 };
            let known = dots.entry(snap.number(at)).or_insert((seen, radius));
            *known = (known.0.or(seen), known.1.max(radius));
        }
        let labels = labels::labels(drawing, frame, &snap, around.size());
        let circles = dots.iter().filter(|(_, (seen, _))| seen.is_ok());
        let circles = circles.map(|(&m, &(_, radius))| (snap.points[m as usize], radius * frame.scale()));
        let mut circles = Circles::new(circles.collect(), tolerance);
        let mut loose = Loose::default();
        let drawn = drawing.lines.iter().filter(|line| line.hidden.is_none());
        drawn.for_each(|line| loose.add(line.ends.map(|p| frame.apply(p))));
        // All ends first: a line is cut only where something ends or stands.
        let mut lines: Vec<(Line, [Point; 2])> = Vec::with_capacity(drawing.lines.len());
        for (i, line) in drawing.lines.iter().enumerate() {
            let ends = line.ends.map(|p| frame.apply(p));
            let is_tight = trim.tight.get(i).copied().unwrap_or(false);
            if trim.border.get(i).copied().unwrap_or(false)
                || is_tight && (around.is_crossed_by(ends) || around.is_clear_of(&ends))
            {
                beside.border += 1;
            } else if is_beside(line.aside, line.legend, &ends)
                || trim.called == Called::Any && line.aside && (around.is_crossed_by(ends) || around.is_left_by(ends))
            {
                beside.aside += 1;
            } else if labels.contains(&line.shape) {
                beside.small += 1;
            } else {
                let reach = line.half * frame.scale() + tolerance;
                lines.push((*line, circles.reach(ends, reach, &snap, &loose, tolerance)));
            }
        }
        let mut numbers: Vec<Option<[u32; 2]>> =
            lines.iter().map(|(line, ends)| line.hidden.is_none().then(|| ends.map(|p| snap.number(p)))).collect();
        let size = around.size();
        let (mut shapes, mut small_holes): (Vec<(&drawing::Outline, Vec<Point>)>, _) = (Vec::new(), Vec::new());
        for outline in drawing.outlines.iter().filter(|outline| !legends.contains_key(&outline.legend)) {
            let corners: Vec<Point> = outline.points.iter().map(|&p| frame.apply(p)).collect();
            let covers = drawing.canvas.is_some_and(|canvas| Extent::around(outline.points.clone()).covers(canvas));
            match kind(outline, &corners, &snap, &around, size) {
                // The whole canvas is paper, even if the structure reaches beyond it.
                Area::Face if covers && !corners.iter().any(|&p| snap.is_known(p)) => beside.paper.push(outline.coat),
                Area::Bar(ends) => {
                    beside.bars.push(outline.coat);
                    lines.push((Line { hidden: outline.hidden, ..Line::plain(ends, 0.0, u32::MAX) }, ends));
                    numbers.push(Some(ends.map(|p| snap.number(p))));
                }
                Area::Paper => beside.paper.push(outline.coat),
                Area::Small if outline.empty => small_holes.push((outline, corners)),
                Area::Small => beside.small += 1,
                Area::Beside if drawing.painting.is_blank(outline.coat) => beside.small += 1,
                Area::Curved => {}
                Area::Face | Area::Beside => shapes.push((outline, corners)),
            }
        }
        // Small holes in letters are a part of these, and in faces they are none.
        let faces: BTreeSet<u32> = shapes.iter().map(|(outline, _)| outline.coat).collect();
        let (in_faces, in_letters): (Vec<_>, Vec<_>) =
            small_holes.into_iter().partition(|(outline, _)| faces.contains(&outline.coat));
        beside.small += in_letters.len();
        shapes.extend(in_faces);
        for (_, corners) in &mut shapes {
            *corners = straightened(corners, &snap, tolerance);
        }
        for &p in shapes.iter().flat_map(|(_, corners)| corners) {
            snap.number(p);
        }
        let mut cutter = Cutter::new(&snap, expected, tolerance);
        let mut hidden: BTreeMap<[u32; 2], Hidden> = BTreeMap::new();
        let mut edges = Vec::with_capacity(lines.len());
        let mut unseen = 0;
        let mut dashed = Vec::new();
        for ((line, places), numbers) in lines.iter().zip(numbers) {
            let has_ink = line.dashes[0] < line.dashes[1] && !expected.is_empty();
            dashed.extend(has_ink.then_some((line.dashes, *places)));
            let Some(numbers) = numbers.or_else(|| snap.known(*places)) else {
                unseen += usize::from(!has_ink);
                continue;
            };
            for pair in cutter.chain(numbers, *places)?.windows(2) {
                let edge = [pair[0].min(pair[1]), pair[0].max(pair[1])];
                match line.hidden {
                    None => edges.push(edge),
                    Some(why) => drop(hidden.insert(edge, why)),
                }
            }
        }
        let mut sparse: BTreeMap<[u32; 2], Vec<[u32; 2]>> = BTreeMap::new();
        if !dashed.is_empty() {
            let number = |edge: &[u32; 2]| edge_by(*edge, &snap.numbers);
            let known: BTreeSet<[u32; 2]> =
                graph.edges.iter().filter_map(number).chain(edges.iter().copied()).collect();
            for (dashes, places) in dashed {
                let chain = cutter.chain(places.map(|p| snap.number(p)), places)?;
                let parts = chain.windows(2).map(|pair| [pair[0].min(pair[1]), pair[0].max(pair[1])]);
                for edge in parts.filter(|edge| !known.contains(edge)) {
                    sparse.entry(edge).or_default().push(dashes);
                    edges.push(edge);
                }
            }
        }
        let (mut outlines, mut holes) = (Vec::new(), Vec::new());
        for (outline, corners) in &shapes {
            let mut ring = Vec::new();
            for (i, &p) in corners.iter().enumerate() {
                let side = [p, corners[(i + 1) % corners.len()]];
                if let Some(numbers) = snap.known(side) {
                    ring.extend(cutter.chain(numbers, side)?);
                }
            }
            let ring = rings::tidy(&ring);
            if ring.len() > 2 && outline.empty {
                holes.push(ring);
            } else if ring.len() > 2 {
                outlines.push(Outline { ring, name: outline.name.clone(), hole: outline.hole, coat: outline.coat });
            }
        }
        let names = vec![String::new(); snap.points.len()];
        let mut graph = Graph { points: snap.points, names, edges };
        let doubled = graph.tidy();
        hidden.retain(|edge, _| edge[0] != edge[1] && graph.edges.binary_search(edge).is_err());
        let dot = |v: u32| dots.get(&v).copied().unwrap_or((Err(None), 0.0));
        let mut ends = vec![false; graph.points.len()];
        graph.edges.iter().flatten().for_each(|&m| ends[m as usize] = true);
        let (dots, radii) = (0..graph.points.len() as u32).map(dot).unzip();
        beside.bars.extend(&drawing.bars);
        beside.bars.sort_unstable();
        beside.paper.extend(&drawing.paper);
        beside.paper.sort_unstable();
        Ok(Self {
            graph,
            dots,
            radii,
            ends,
            outlines,
            holes,
            hidden,
            sparse,
            unseen,
            doubled,
            beside,
            ..Self::default()
        })
    }

    /// Takes out what turned out not to be seen: edges, and points that only such edges or circles had. `keeps` says
    /// which points stay in any case.
    pub(super) fn take_out(
        &mut self,
        edges: &[([u32; 2], Hidden)],
        dots: &[(u32, Hidden)],
        keeps: impl Fn(u32) -> bool,
    ) {
        for &(m, why) in dots {
            self.dots[m as usize] = Err(Some(why));
        }
        self.hidden.extend(edges.iter().copied());
        let gone = &self.hidden;
        self.graph.edges.retain(|edge| !gone.contains_key(edge));
        let mut used: Vec<bool> =
            (0..self.graph.points.len()).map(|m| self.dots[m].is_ok() || keeps(m as u32)).collect();
        let rings = self.outlines.iter().flat_map(|outline| &outline.ring);
        self.graph.edges.iter().flatten().chain(rings).for_each(|&m| used[m as usize] = true);
        let mut numbers = vec![u32::MAX; used.len()];
        for (next, (m, _)) in (0..).zip(used.iter().enumerate().filter(|(_, used)| **used)) {
            numbers[m] = next;
        }
        let new = |m: u32| numbers[m as usize];
        self.graph.points = kept(&self.graph.points, &used);
        self.graph.names = kept(&self.graph.names, &used);
        self.radii = kept(&self.radii, &used);
        self.dots = kept(&self.dots, &used);
        self.ends = kept(&self.ends, &used);
        self.graph.edges.iter_mut().flatten().for_each(|m| *m = new(*m));
        self.outlines.iter_mut().flat_map(|outline| &mut outline.ring).for_each(|m| *m = new(*m));
        self.holes.clear();
        let before = self.hidden.len();
        self.hidden = std::mem::take(&mut self.hidden).into_iter().map(|(edge, why)| (edge.map(new), why)).collect();
        self.hidden.retain(|edge, _| edge.iter().all(|m| *m != u32::MAX));
        self.unseen += before - self.hidden.len();
    }
}

/// The lines of a drawing that dashes leave out in part, or nearly whole, where the frame brings them.
pub(super) fn specks(drawing: &Drawing, frame: &Frame) -> Vec<[Point; 2]> {
    let lines = drawing.lines.iter().filter(|line| line.dashes[0] < line.dashes[1]);
    lines.map(|line| line.ends.map(|p| frame.apply(p))).collect()
}

/// The corners of an outline without those on a straight side at which nothing else is drawn or expected.
fn straightened(corners: &[Point], snap: &Snap, tolerance: f64) -> Vec<Point> {
    let count = corners.len();
    let is_corner = |&i: &usize| {
        let sides = [corners[(i + count - 1) % count], corners[(i + 1) % count]];
        snap.is_known(corners[i]) || !lies_on(corners[i], sides, tolerance)
    };
    (0..count).filter(is_corner).map(|i| corners[i]).collect()
}

/// The elements of a list that stay.
fn kept<T: Clone>(list: &[T], used: &[bool]) -> Vec<T> {
    list.iter().zip(used).filter(|(_, used)| **used).map(|(x, _)| x.clone()).collect()
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
