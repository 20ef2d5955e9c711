//! Layer 3: what is drawn, compared with what the reference draws or declares.
//!
//! ```text
//!   frame.rs    where the drawing lies          sketch.rs  points, edges, outlines
//!   graph.rs    vertices and edges              here       dots, what cannot be seen, faces
//! ```

use super::Options;
use super::drawing::Drawing;
use super::error::{Fault, Problem};
use super::frame::{Best, Frame, Search, Turn};
use super::graph::{Graph, Matched, Telling};
use super::pairing::{Places, span};
use super::report::{Difference, Kind, Layer, Spot, Writing, counted};
use super::rings;
use super::shape;
use super::sketch::{Outline, Sketch};
use crate::plane::Point;
use std::collections::BTreeMap;

/// The drawing on which the tolerance is stated, in px.
const CANVAS: f64 = 600.0;
/// With more differing edges than this, no edge excuses a face.
const EXCUSES: usize = 100;

/// What came of it.
pub(super) struct Seen {
    pub(super) differences: Vec<Difference>,
    pub(super) notes: Vec<String>,
    /// Edges of the reference that are there, and all.
    pub(super) agreed: (usize, usize),
}

/// What is expected to be drawn.
pub(super) struct Target {
    pub(super) sketch: Sketch,
    tolerance: f64,
    writing: Writing,
    /// Maps from a canvas to these coordinates that are worth a try.
    hints: Vec<Frame>,
}

impl Target {
    /// A sketch in its own coordinates. `down`: it comes from a file, so y is to be written as there.
    ///
    /// # Errors
    /// [`Problem::Nothing`] and [`Problem::TooClose`].
    pub(super) fn new(sketch: Sketch, options: &Options, down: bool) -> Result<Self, Fault> {
        let points = &sketch.graph.points;
        if points.is_empty() {
            return Err(Problem::Nothing.into());
        }
        let tolerance = tolerance(points, options);
        let writing = Writing::new(tolerance, down);
        let mut places = Places::new(4.0 * tolerance);
        for &p in points {
            if let Some(near) = places.near(p, 4.0 * tolerance) {
                let [first, second] = [places.points()[near as usize], p].map(|p| writing.point(p));
                return Err(Problem::TooClose { first, second }.into());
            }
            places.add(p);
        }
        Ok(Self { tolerance, writing, hints: vec![Frame::IDENTITY], sketch })
    }

    /// The map from the canvas of the reference's own drawing is likely to be the student's, too.
    pub(super) fn hint(&mut self, drawing: &Drawing) {
        self.hints.push(self.locate(drawing).frame);
    }

    fn locate(&self, drawing: &Drawing) -> Best {
        let dots: Vec<Point> = drawing.dots.iter().map(|dot| dot.at).collect();
        let mut all: Vec<Point> = drawing.lines.iter().flat_map(|line| line.ends).chain(dots.iter().copied()).collect();
        all.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        all.dedup();
        let core = if dots.len() > 1 { &dots } else { &all };
        Search::new(&self.sketch.graph.points, self.tolerance).best(&all, core, &self.hints)
    }

    /// Compares a drawing with this. O(n log n) in all but hostile cases, which are refused.
    pub(super) fn compare(&self, drawing: &Drawing, options: &Options) -> Result<Seen, Fault> {
        let best = self.locate(drawing);
        let expected = &self.sketch;
        let found = Sketch::read(drawing, &best.frame, &expected.graph.points, self.tolerance)?;
        let all = expected.graph.edges.len();
        if found.graph.points.is_empty() {
            return Err(Problem::Nothing.into());
        }
        if expected.graph.points.len() > 2 && 2 * best.matched < expected.graph.points.len() {
            let difference = shape::compare(&expected.graph, &own(drawing, options)?.graph);
            return Ok(Seen { differences: vec![difference], notes: Vec::new(), agreed: (0, all) });
        }
        let matched = Matched::new(&expected.graph, &found.graph, self.tolerance);
        let mut critic =
            Critic { target: self, found: &found, matched: &matched, differences: Vec::new(), notes: Vec::new() };
        if best.frame.turn != Turn::Upright {
            critic.say(Kind::Drawing, best.frame.turn.sentence().to_owned(), Spot::Nowhere);
        }
        critic.graph();
        critic.dots();
        if options.faces {
            critic.faces();
        }
        critic.side_notes();
        let Critic { mut differences, notes, .. } = critic;
        differences.sort_by_key(|difference| difference.kind);
        Ok(Seen { differences, notes, agreed: (matched.agreeing_edges(&expected.graph), all) })
    }
}

fn tolerance(points: &[Point], options: &Options) -> f64 {
    let span = span(points);
    options.tolerance / CANVAS * if span > 0.0 { span } else { 1.0 }
}

/// A drawing in its own coordinates.
pub(super) fn own(drawing: &Drawing, options: &Options) -> Result<Sketch, Fault> {
    let all = drawing.dots.iter().map(|dot| dot.at).chain(drawing.lines.iter().flat_map(|line| line.ends));
    Sketch::of_drawing(drawing, tolerance(&all.collect::<Vec<_>>(), options))
}

struct Critic<'a> {
    target: &'a Target,
    found: &'a Sketch,
    matched: &'a Matched,
    differences: Vec<Difference>,
    notes: Vec<String>,
}

impl Critic<'_> {
    fn say(&mut self, kind: Kind, text: String, spot: Spot) {
        self.differences.push(Difference::new(kind, Layer::Drawn, text, spot));
    }

    fn expected(&self) -> &Graph {
        &self.target.sketch.graph
    }

    fn graph(&mut self) {
        let found = self.found;
        let extra_point = |m: u32, at: &str| match found.dots[m as usize] {
            Ok(()) => format!("vertex at {at} is not in the reference"),
            Err(_) => format!("a line ends at {at}, where there is no vertex"),
        };
        let hidden = |edge: [u32; 2]| {
            let [a, b] = edge.map(|v| self.matched.to_found[v as usize]);
            let (a, b) = a.zip(b)?;
            found.hidden.get(&[a.min(b), a.max(b)]).map(|why| why.reason())
        };
        let telling = Telling {
            layer: Layer::Drawn,
            writing: self.target.writing,
            tolerance: self.target.tolerance,
            extra_point: &extra_point,
            hidden: &hidden,
        };
        let told = self.matched.differences(self.expected(), &found.graph, &telling);
        self.differences.extend(told);
    }

    /// Points without a dot.
    fn dots(&mut self) {
        if !self.target.sketch.has_dots() {
            return;
        }
        if !self.found.has_dots() {
            let text = "no vertex is drawn: draw a circle at each vertex".to_owned();
            return self.say(Kind::Vertex, text, Spot::Nowhere);
        }
        for v in 0..self.expected().points.len() {
            let Some(m) = self.matched.to_found[v].filter(|_| self.target.sketch.dots[v].is_ok()) else { continue };
            let Err(why) = self.found.dots[m as usize] else { continue };
            let at = self.expected().points[v];
            let name = &self.expected().names[v];
            let space = if name.is_empty() { "" } else { " " };
            let place = self.target.writing.point(at);
            let text = match why {
                Some(why) => format!("vertex {name}{space}at {place} cannot be seen: {}", why.reason()),
                None => format!("vertex {name}{space}at {place} is missing: no circle is drawn there"),
            };
            self.say(Kind::Vertex, text, Spot::MissingVertex(at));
        }
    }

    fn faces(&mut self) {
        let target = self.target;
        let expected = &target.sketch.outlines;
        if expected.is_empty() {
            if !self.found.outlines.is_empty() {
                let count = counted(self.found.outlines.len(), "filled polygon", "filled polygons");
                self.notes.push(format!("{count} not compared: the reference fills no faces"));
            }
            return;
        }
        if self.found.outlines.is_empty() {
            let text = "no face is filled: draw each bounded face as a filled polygon, counter-clockwise".to_owned();
            return self.say(Kind::Face, text, Spot::Nowhere);
        }
        let mut faces: BTreeMap<Vec<u32>, (usize, usize)> = BTreeMap::new();
        for (i, outline) in expected.iter().enumerate() {
            faces.entry(rings::canonical(&outline.ring)).or_insert((i, 0));
        }
        let excuses = Excuses::new(self);
        let mut reversed = Vec::new();
        let mut strange = Vec::new();
        for outline in &self.found.outlines {
            let ring = rings::canonical(&self.translated(outline));
            if let Some((_, count)) = faces.get_mut(&ring) {
                *count += 1;
            } else {
                reversed.push((rings::reversed(&ring), ring, outline));
            }
        }
        for (ring, own, outline) in reversed {
            // The outer face and holes run the other way round, and may be drawn, too.
            let is_welcome = target.sketch.welcome.contains(&own) || target.sketch.welcome.contains(&ring);
            match faces.get_mut(&ring) {
                Some((i, count)) if *count == 0 => {
                    *count += 1;
                    strange.push((true, &expected[*i]));
                }
                _ if is_welcome => {}
                Some(_) => {}
                None if excuses.found(outline) => {}
                None => strange.push((false, outline)),
            }
        }
        let missing = faces.values().filter(|(_, count)| *count == 0).map(|(i, _)| &expected[*i]);
        let missing: Vec<&Outline> = missing.collect();
        let excused = missing.iter().filter(|outline| excuses.expected(outline)).count();
        if excused > 0 {
            let count =
                counted(excused, "face lies beside what differs and is", "faces lie beside what differs and are");
            self.notes.push(format!("{count} not compared"));
        }
        for outline in missing.into_iter().filter(|outline| !excuses.expected(outline)) {
            self.face(outline, |what, along| format!("{what} along {along} is not filled"));
        }
        for (is_reversed, outline) in strange {
            if is_reversed {
                let points = self.points(&outline.ring, self.expected());
                let [is, wanted] = match rings::area(points.iter().copied()) > 0.0 {
                    true => ["clockwise", "counter-clockwise"],
                    false => ["counter-clockwise", "clockwise"],
                };
                self.face(outline, |what, along| format!("{what} along {along} runs {is}: list its corners {wanted}"));
            } else {
                let points = self.points(&outline.ring, &self.found.graph);
                let text =
                    format!("filled polygon along {} is no face of the reference", target.writing.along(&points));
                self.say(Kind::Face, text, Spot::Nowhere);
            }
        }
    }

    fn face(&mut self, outline: &Outline, text: impl Fn(String, String) -> String) {
        let points = self.points(&outline.ring, self.expected());
        let what = if outline.name.is_empty() { "face".to_owned() } else { format!("face {}", outline.name) };
        let text = text(what, self.target.writing.along(&points));
        self.say(Kind::Face, text, Spot::Face(points));
    }

    fn points(&self, ring: &[u32], graph: &Graph) -> Vec<Point> {
        ring.iter().map(|&v| graph.point(v)).collect()
    }

    /// An outline by the points of the reference; further ones have greater numbers.
    fn translated(&self, outline: &Outline) -> Vec<u32> {
        let bound = self.expected().points.len() as u32;
        outline.ring.iter().map(|&m| self.matched.to_expected[m as usize].unwrap_or(bound + m)).collect()
    }

    fn side_notes(&mut self) {
        if self.found.doubled > 0 {
            let count = counted(self.found.doubled, "edge is drawn", "edges are drawn");
            self.notes.push(format!("{count} more than once"));
        }
        let known = |edge: &[u32; 2]| {
            let [a, b] = edge.map(|m| self.matched.to_expected[m as usize]);
            let ends = a.zip(b).map(|(a, b)| [a.min(b), a.max(b)]);
            ends.is_some_and(|ends| self.expected().edges.binary_search(&ends).is_ok())
        };
        let count = self.found.hidden.keys().filter(|edge| !known(edge)).count();
        if count > 0 {
            let count = counted(count, "line that nobody can see is", "lines that nobody can see are");
            self.notes.push(format!("{count} not read"));
        }
    }
}

/// Faces that differ because an edge or a vertex beside them does, which is told already.
struct Excuses {
    missing: Vec<[u32; 2]>,
    extra: Vec<[u32; 2]>,
    /// Extra edges by points of the reference.
    chords: Vec<[u32; 2]>,
    lost: Vec<bool>,
    strange: Vec<bool>,
    back: Vec<Option<u32>>,
}

impl Excuses {
    fn new(critic: &Critic<'_>) -> Self {
        let matched = critic.matched;
        let translated = |edge: &[u32; 2]| {
            let [a, b] = edge.map(|m| matched.to_expected[m as usize]);
            a.zip(b).map(|(a, b)| [a, b])
        };
        let mut out = Self {
            missing: matched.missing.clone(),
            extra: matched.extra.clone(),
            chords: matched.extra.iter().filter_map(translated).collect(),
            lost: matched.to_found.iter().map(Option::is_none).collect(),
            strange: matched.to_expected.iter().map(Option::is_none).collect(),
            back: matched.to_expected.clone(),
        };
        out.extra.sort_unstable();
        if out.missing.len().max(out.extra.len()) > EXCUSES {
            out.chords.clear();
        }
        out
    }

    fn expected(&self, outline: &Outline) -> bool {
        let ring = &outline.ring;
        let has_both = |[a, b]: &[u32; 2]| ring.contains(a) && ring.contains(b);
        ring.iter().any(|&v| self.lost[v as usize])
            || sides(ring).any(|side| self.missing.binary_search(&side).is_ok())
            || self.chords.iter().any(has_both)
    }

    fn found(&self, outline: &Outline) -> bool {
        let ring = &outline.ring;
        if ring.iter().any(|&m| self.strange[m as usize])
            || sides(ring).any(|side| self.extra.binary_search(&side).is_ok())
        {
            return true;
        }
        let corners: Vec<Option<u32>> = ring.iter().map(|&m| self.back[m as usize]).collect();
        let has_both = |[a, b]: &[u32; 2]| corners.contains(&Some(*a)) && corners.contains(&Some(*b));
        self.missing.len() <= EXCUSES && self.missing.iter().any(has_both)
    }
}

/// The sides of an outline, the smaller number first.
fn sides(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    let ahead = ring.iter().skip(1).chain(ring.first());
    ring.iter().zip(ahead).map(|(&a, &b)| [a.min(b), a.max(b)])
}
