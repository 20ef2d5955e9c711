//! Layer 3: what is drawn, compared with what the reference draws or declares.
//!
//! ```text
//!   frame.rs    where the drawing lies          sketch.rs  points, edges, outlines      eye.rs  what can be seen
//!   graph.rs    vertices and edges              areas.rs   faces                        here    dots, notes
//! ```

use super::Options;
use super::beside::{Trim, thin};
use super::drawing::Drawing;
use super::error::{Fault, Problem};
use super::eye::Eye;
use super::filling::Filling;
use super::frame::{Best, Frame, Search, Turn};
use super::graph::{Graph, Matched, Telling};
use super::ink::Hidden;
use super::pairing::{Places, edge_by, span};
use super::placed::Placed;
use super::report::{Difference, GROUP, Kind, Layer, Spot, Writing, counted, listed};
use super::rings;
use super::shape;
use super::sketch::{Outline, Sketch, specks};
use super::sparse::Sparse;
use super::strangers::strangers;
use super::windows::{self, Window, windows};
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};

/// The drawing on which the tolerance is stated, in px.
pub(super) const CANVAS: f64 = 600.0;
/// If one edge of so many is hidden in the reference, its lines are too wide to be told apart.
const MERGED: usize = 4;
/// Drawings of more points are not tried mirrored and turned.
const TURNED: usize = 20_000;
/// What came of it.
pub(super) struct Seen {
    pub(super) differences: Vec<Difference>,
    pub(super) notes: Vec<String>,
    /// Edges of the reference that are there, and all.
    pub(super) agreed: (usize, usize),
    /// What the drawing shows, in the coordinates of the reference, or in its own where it does not fit.
    pub(super) sketch: Sketch,
    pub(super) fits: bool,
}

/// What cannot be seen of a drawing, by its own numbers.
#[derive(Default)]
struct Unseen {
    edges: Vec<([u32; 2], Hidden)>,
    dots: Vec<(u32, Hidden)>,
    /// Outlines, by their numbers, that have the colour of the paper or are cut off, and those in which their own path
    /// fills nothing.
    pale: BTreeMap<usize, Hidden>,
    hollow: BTreeSet<usize>,
    /// Holes of the reference, by their numbers, that are filled.
    filled: BTreeSet<usize>,
    /// Holes where the reference fills a face.
    windows: Vec<Window>,
}

/// What cannot be seen of the reference's own drawing: nobody else has to show it.
#[derive(Default)]
struct Excused {
    edges: BTreeSet<[u32; 2]>,
    /// Whether its lines run into each other.
    merges: bool,
    dots: BTreeSet<u32>,
    faces: BTreeSet<Vec<u32>>,
    /// Holes that something else fills.
    filled: BTreeSet<usize>,
}

/// What is expected to be drawn.
pub(super) struct Target<'a> {
    pub(super) sketch: Sketch,
    tolerance: f64,
    writing: Writing,
    /// Maps from a canvas to these coordinates that are worth a try.
    hints: Vec<Frame>,
    /// The reference's own drawing.
    own: Option<&'a Drawing>,
}

/// A drawing that has been placed.
struct Placing {
    best: Best,
    found: Sketch,
    matched: Matched,
}

impl<'a> Target<'a> {
    /// What a declared structure must look like.
    ///
    /// # Errors
    /// [`Problem::Nothing`] and [`Problem::TooClose`].
    pub(super) fn of_table(placed: &Placed<'_>, options: &Options) -> Result<Self, Fault> {
        Self::new(Sketch::of_table(placed), options, false)
    }

    /// What another drawing must look like: in the coordinates of the model if its vertices have them.
    ///
    /// # Errors
    /// Those of [`of_table`](Self::of_table).
    pub(super) fn of_drawing(drawing: &'a Drawing, options: &Options) -> Result<Self, Fault> {
        let mut sketch = own(drawing, options)?;
        let frame = sketch.place_in_model(drawing, tolerance(&sketch.graph.points, options));
        let mut out = Self::new(sketch, options, frame.is_none())?;
        out.hints.extend(frame);
        out.own = Some(drawing);
        Ok(out)
    }

    /// The reference draws itself like this.
    pub(super) fn draws(&mut self, drawing: &'a Drawing) {
        self.own = Some(drawing);
    }

    /// What the reference's own drawing hides. Windows that it has, too, are taken out.
    fn excused(&self, windows: &mut Vec<Window>) -> Result<Excused, Fault> {
        let mut out = Excused::default();
        let Some(drawing) = self.own else { return Ok(out) };
        let Placing { best, found, matched } = self.place(drawing)?;
        let unseen = self.look(drawing, &best.frame, &found, &matched)?;
        if !windows.is_empty() {
            windows::excuse(windows, drawing, &found.beside, &best.frame);
        }
        let partner = |m: u32| matched.to_expected[m as usize];
        let edges = unseen.edges.into_iter().filter(|(edge, _)| !found.sparse.contains_key(edge));
        out.edges.extend(edges.filter_map(|(edge, _)| edge_by(edge, &matched.to_expected)));
        // Lines so wide that they run into each other hide more or less, as they are ordered.
        out.merges = MERGED * out.edges.len() > self.sketch.graph.edges.len();
        out.dots.extend(unseen.dots.iter().filter_map(|&(m, _)| partner(m)));
        let ring = |i: usize| {
            let ring: Option<Vec<u32>> = found.outlines[i].ring.iter().map(|&m| partner(m)).collect();
            Some(rings::canonical(&ring?))
        };
        out.filled = unseen.filled;
        let is_unseen = |i: &usize| unseen.pale.contains_key(i) || unseen.hollow.contains(i);
        out.faces.extend((0..found.outlines.len()).filter(is_unseen).filter_map(ring));
        // A face may be the hole of another one, and be filled itself.
        if !out.faces.is_empty() {
            let seen = (0..found.outlines.len()).filter(|i| !is_unseen(i)).filter_map(ring);
            for ring in seen {
                out.faces.remove(&ring);
            }
        }
        Ok(out)
    }

    /// A sketch in its own coordinates. `down`: it comes from a file, so y is to be written as there.
    ///
    /// # Errors
    /// [`Problem::Nothing`] and [`Problem::TooClose`].
    fn new(sketch: Sketch, options: &Options, down: bool) -> Result<Self, Fault> {
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
        Ok(Self { tolerance, writing, hints: vec![Frame::IDENTITY], sketch, own: None })
    }

    /// The map from the canvas of the reference's own drawing is likely to be the student's, too.
    pub(super) fn hint(&mut self, drawing: &Drawing) {
        let (search, all, core) = self.search(drawing);
        let frame = search.best(&all, &core, &[]).frame;
        self.sketch.specks = specks(drawing, &frame);
        self.hints.push(frame);
    }

    /// The search, and the points to search with: all, and the core.
    fn search(&self, drawing: &Drawing) -> (Search<'_>, Vec<Point>, Vec<Point>) {
        let dots: Vec<Point> = drawing.dots.iter().filter(|dot| !dot.aside).map(|dot| dot.at).collect();
        let mut all: Vec<Point> = drawing.points().collect();
        if drawing.lines.is_empty() {
            // Lines may be drawn as thin rectangles.
            let size =
                span(&drawing.outlines.iter().flat_map(|outline| outline.points.iter().copied()).collect::<Vec<_>>());
            let bars = drawing.outlines.iter().filter_map(|outline| thin(&outline.points, size));
            all.extend(bars.flat_map(|(ends, _)| ends));
        }
        all.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        all.dedup();
        let core = if dots.len() > 1 { dots } else { all.clone() };
        (Search::new(&self.sketch.graph.points, self.tolerance), all, core)
    }

    /// The drawing where it fits best, and how well: upright, unless it is clearly turned, and without frames and
    /// legends if it fits better so.
    fn place(&self, drawing: &Drawing) -> Result<Placing, Fault> {
        let (search, all, core) = self.search(drawing);
        let expected = &self.sketch.graph;
        let edges: Vec<[Point; 2]> = expected.edges.iter().map(|&edge| expected.ends(edge)).collect();
        let mut ways = vec![(Trim::nothing(drawing), all, core)];
        // Axes may be part of what the reference draws, where legends are not.
        for trim in [Trim::legends(drawing, edges.clone()), Trim::all(drawing, edges)] {
            if !trim.is_any(drawing) {
                continue;
            }
            let frames = trim.border.iter().zip(&trim.tight).map(|(border, tight)| *border || *tight);
            let lines = drawing.lines.iter().zip(frames);
            let lines = lines.filter(|(line, frame)| !frame && !trim.may_leave_out(line.aside, line.legend));
            let dots = drawing.dots.iter().filter(|dot| !trim.may_leave_out(dot.aside, dot.legend));
            let mut inner: Vec<Point> = dots.map(|dot| dot.at).collect();
            let few: Vec<Point> = lines.flat_map(|(line, _)| line.ends).chain(inner.iter().copied()).collect();
            if inner.len() < 2 {
                inner.clone_from(&few);
            }
            ways.push((trim, few, inner));
        }
        let mut best: Option<(Placing, &Trim)> = None;
        for (trim, all, core) in &ways {
            let fitting = search.best(all, core, &self.hints);
            let (found, matched) = self.read(drawing, &fitting.frame, trim)?;
            if best.as_ref().is_none_or(|(other, _)| matched.faults() < other.matched.faults()) {
                best = Some((Placing { best: fitting, found, matched }, trim));
            }
        }
        let Some((mut out, trim)) = best else { return Err(Problem::Nothing.into()) };
        if out.matched.faults() > 1 && expected.points.len() <= TURNED {
            let (_, all, core) = &ways[ways.len() - 1];
            let upright = self.faults(&out);
            let mut fewest = upright;
            for frame in search.others(all, core, &out.best) {
                let (found, matched) = self.read(drawing, &frame, trim)?;
                let turned = Placing { best: Best { frame, matched: expected.points.len() }, found, matched };
                // The turn is a fault itself, and has to explain more than half of the others.
                let faults = 1 + self.faults(&turned);
                if faults < fewest && 2 * faults < upright {
                    (out, fewest) = (turned, faults);
                }
            }
        }
        Ok(out)
    }

    /// How many points, edges and faces of a drawing differ where it is placed.
    fn faults(&self, placing: &Placing) -> usize {
        let (expected, found) = (&self.sketch, &placing.found);
        placing.matched.faults() + strangers(expected, found, &placing.matched)
    }

    fn read(&self, drawing: &Drawing, frame: &Frame, trim: &Trim) -> Result<(Sketch, Matched), Fault> {
        let expected = &self.sketch.graph;
        let found = Sketch::read(drawing, frame, expected, self.tolerance, trim)?;
        let matched = Matched::new(expected, &found.graph, self.tolerance);
        Ok((found, matched))
    }

    /// Looks at everything that was found. Where too much lies over each other, and all else agrees, that is refused.
    fn look(&self, drawing: &Drawing, frame: &Frame, found: &Sketch, matched: &Matched) -> Result<Unseen, Fault> {
        let graph = &found.graph;
        let canvas: Vec<Point> = graph.points.iter().map(|&p| frame.back(p)).collect();
        let tolerance = self.tolerance / frame.scale();
        let mut eye = Eye::new(&drawing.painting, &found.beside, graph.edges.len(), span(&canvas));
        let mut out = Unseen::default();
        let specks = Sparse::new(&self.sketch.specks, 4.0 * self.tolerance);
        // The end of a line that does not reach its vertex, or goes beyond it, below the circle there.
        let is_stub = |edge: [u32; 2]| {
            let [p, q] = edge.map(|m| canvas[m as usize]);
            let ends_in = |m: u32, other: u32| {
                let is_end = matched.to_expected[m as usize].is_none() && found.dots[m as usize].is_err();
                is_end && super::pairing::distance(p, q) < found.radii[other as usize]
            };
            ends_in(edge[0], edge[1]) || ends_in(edge[1], edge[0])
        };
        for &edge in graph.edges.iter().filter(|&&edge| !is_stub(edge)) {
            let ends = edge.map(|m| canvas[m as usize]);
            // A circle stands for its vertex, not for more than half of an edge.
            let half = 0.5 * super::pairing::distance(ends[0], ends[1]);
            let radii = edge.map(|m| found.radii[m as usize].min(half));
            if let Some(lines) = found.sparse.get(&edge) {
                let mut is_seen = || lines.iter().any(|&dashes| eye.any_dash(ends, radii, dashes));
                if specks.has(graph.ends(edge)) || !is_seen() {
                    out.edges.push((edge, Hidden::Dashes));
                }
                continue;
            }
            let is_stranger = matched.extra.binary_search(&edge).is_ok();
            if let Err(why) = eye.edge(ends, radii, tolerance, is_stranger) {
                out.edges.push((edge, why));
            }
        }
        let mut nearest = vec![f64::INFINITY; graph.points.len()];
        for &edge in graph.edges.iter().filter(|&&edge| !is_stub(edge)) {
            let [p, q] = edge.map(|m| canvas[m as usize]);
            let length = super::pairing::distance(p, q);
            edge.iter().for_each(|&m| nearest[m as usize] = nearest[m as usize].min(length));
        }
        for (m, &at) in canvas.iter().enumerate().filter(|&(m, _)| found.dots[m].is_ok()) {
            let radius = found.radii[m];
            let far = matched.to_expected[m].is_some() && radius > nearest[m];
            if far || eye.disc_over(at, 4.0 * tolerance).is_some() {
                out.dots.push((m as u32, Hidden::Dot));
            } else if let Err(why) = eye.vertex(at, radius, 2.0 * tolerance) {
                out.dots.push((m as u32, why));
            }
        }
        for (i, outline) in found.outlines.iter().enumerate() {
            let ring = outline.ring.iter().map(|&m| canvas[m as usize]).collect();
            match eye.face(outline.coat, ring) {
                Filling::Seen => {}
                Filling::Pale => drop(out.pale.insert(i, Hidden::Paper)),
                Filling::Cut(why) => drop(out.pale.insert(i, why)),
                Filling::Hollow => drop(out.hollow.insert(i)),
            }
        }
        for (i, hole) in self.sketch.holes.iter().enumerate() {
            let ring = hole.iter().map(|&v| frame.back(self.sketch.graph.point(v))).collect();
            if eye.is_filled(ring) {
                out.filled.insert(i);
            }
        }
        out.windows = windows(&mut eye, &self.sketch, found, frame);
        let agrees = matched.faults() == 0 && out.edges.is_empty() && out.dots.is_empty();
        if eye.is_tired() && agrees {
            let (what, limit) = ("shapes over each other", drawing.painting.coats.len());
            return Err(Problem::TooLarge { what, limit }.into());
        }
        Ok(out)
    }

    /// Compares a drawing with this. O(n log n) in all but hostile cases, which are refused.
    pub(super) fn compare(&self, drawing: &Drawing, options: &Options) -> Result<Seen, Fault> {
        let expected = &self.sketch;
        let Placing { best, mut found, mut matched } = self.place(drawing)?;
        let all = expected.graph.edges.len();
        if found.graph.points.is_empty() {
            return Err(Problem::Nothing.into());
        }
        if expected.graph.points.len() > 2 && 2 * best.matched < expected.graph.points.len() {
            let sketch = own(drawing, options)?;
            let differences = vec![shape::compare(&expected.graph, &sketch.graph)];
            return Ok(Seen { differences, notes: Vec::new(), agreed: (0, all), sketch, fits: false });
        }
        let mut unseen = self.look(drawing, &best.frame, &found, &matched)?;
        self.excuse(&mut unseen, &found, &matched)?;
        let strange = unseen.dots.iter().filter(|(m, _)| matched.to_expected[*m as usize].is_none()).count();
        if !unseen.edges.is_empty() || !unseen.dots.is_empty() {
            let keeps: Vec<bool> = matched.to_expected.iter().map(Option::is_some).collect();
            found.take_out(&unseen.edges, &unseen.dots, |m| keeps[m as usize]);
            matched = Matched::new(&expected.graph, &found.graph, self.tolerance);
        }
        self.refuse_veils(&found, &matched)?;
        let mut critic = Critic {
            target: self,
            found: &found,
            matched: &matched,
            pale: &unseen.pale,
            hollow: &unseen.hollow,
            fills_hole: !unseen.filled.is_empty(),
            windows: &unseen.windows,
            differences: Vec::new(),
            notes: Vec::new(),
        };
        if best.frame.turn != Turn::Upright {
            critic.say(Kind::Drawing, best.frame.turn.sentence(), Spot::Nowhere);
        }
        critic.legends();
        critic.graph();
        critic.dots();
        if options.faces {
            critic.faces();
        }
        critic.side_notes();
        if strange > 0 {
            let circles = counted(strange, "circle that is no vertex", "circles that are no vertices");
            critic.notes.push(format!("not read: {circles}"));
        }
        let Critic { mut differences, notes, .. } = critic;
        differences.sort_by_key(|difference| difference.kind);
        let agreed = (matched.agreeing_edges(&expected.graph), all);
        Ok(Seen { differences, notes, agreed, sketch: found, fits: true })
    }

    /// Refuses what would be missing because of a mask or a filter: it may be seen.
    fn refuse_veils(&self, found: &Sketch, matched: &Matched) -> Result<(), Fault> {
        let expected = &self.sketch;
        let edges = matched.missing.iter().filter(|&&edge| found.hidden_as(edge, matched) == Some(Hidden::Veil));
        let edges = edges.map(|&edge| format!("the edge between {}", self.writing.between(expected.graph.ends(edge))));
        let dot = |v: usize| matched.to_found[v].map(|m| found.dots[m as usize]).filter(|_| expected.dots[v].is_ok());
        let points = expected.graph.points.iter().enumerate();
        let points = points.filter(|&(v, _)| dot(v) == Some(Err(Some(Hidden::Veil))));
        let points = points.map(|(_, &at)| format!("the vertex at {}", self.writing.point(at)));
        edges.chain(points).next().map_or(Ok(()), |what| Err(Problem::Veil { what }.into()))
    }

    /// Takes out what the reference's own drawing hides, too.
    fn excuse(&self, unseen: &mut Unseen, found: &Sketch, matched: &Matched) -> Result<(), Fault> {
        let all_seen = unseen.edges.is_empty() && unseen.dots.is_empty() && unseen.pale.is_empty();
        if all_seen && unseen.hollow.is_empty() && unseen.filled.is_empty() && unseen.windows.is_empty() {
            return Ok(());
        }
        let excused = self.excused(&mut unseen.windows)?;
        let partner = |m: u32| matched.to_expected[m as usize];
        unseen.edges.retain(|&(edge, why)| {
            let is_sparse = found.sparse.contains_key(&edge);
            let [Some(a), Some(b)] = edge.map(partner).map(|v| v.filter(|_| !is_sparse)) else { return true };
            let merged = excused.merges && matches!(why, Hidden::Line | Hidden::Paper | Hidden::Ends);
            !merged && !excused.edges.contains(&[a.min(b), a.max(b)])
        });
        unseen.dots.retain(|&(m, _)| partner(m).is_none_or(|v| !excused.dots.contains(&v)));
        let is_excused = |outline: &Outline| {
            let ring: Option<Vec<u32>> = outline.ring.iter().map(|&m| partner(m)).collect();
            ring.is_some_and(|ring| excused.faces.contains(&rings::canonical(&ring)))
        };
        unseen.pale.retain(|&i, _| !is_excused(&found.outlines[i]));
        unseen.hollow.retain(|&i| !is_excused(&found.outlines[i]));
        unseen.filled.retain(|hole| !excused.filled.contains(hole));
        Ok(())
    }

    pub(super) fn writing(&self) -> Writing {
        self.writing
    }
}

fn tolerance(points: &[Point], options: &Options) -> f64 {
    let span = span(points);
    options.part() * if span > 0.0 { span } else { 1.0 }
}

/// A drawing in its own coordinates.
fn own(drawing: &Drawing, options: &Options) -> Result<Sketch, Fault> {
    Sketch::of_drawing(drawing, tolerance(&drawing.points().collect::<Vec<_>>(), options))
}

pub(super) struct Critic<'a> {
    pub(super) target: &'a Target<'a>,
    pub(super) found: &'a Sketch,
    pub(super) matched: &'a Matched,
    /// Outlines that cannot be seen: they have the colour of the paper, or are cut off.
    pub(super) pale: &'a BTreeMap<usize, Hidden>,
    /// Outlines in which their own path fills nothing: they fill no face.
    pub(super) hollow: &'a BTreeSet<usize>,
    /// Whether a hole of the reference is filled.
    pub(super) fills_hole: bool,
    /// Holes where the reference fills a face.
    pub(super) windows: &'a [Window],
    differences: Vec<Difference>,
    pub(super) notes: Vec<String>,
}

impl Critic<'_> {
    pub(super) fn say(&mut self, kind: Kind, text: String, spot: Spot) {
        self.differences.push(Difference::new(kind, Layer::Drawn, text, spot));
    }

    pub(super) fn expected(&self) -> &Graph {
        &self.target.sketch.graph
    }

    /// Legends over the drawing, which are no part of it and may hide something of it.
    fn legends(&mut self) {
        let text = match self.found.beside.over {
            0 => return,
            1 => "the legend lies over the drawing and is not in the reference: move it to where nothing is drawn",
            _ => "legends lie over the drawing and are not in the reference: move them to where nothing is drawn",
        };
        self.say(Kind::Drawing, text.to_owned(), Spot::Nowhere);
    }

    fn graph(&mut self) {
        let found = self.found;
        let extra_point = |m: u32, at: &str| match found.dots[m as usize] {
            Ok(()) => Some(format!("vertex at {at} is not in the reference")),
            Err(_) if found.is_end(m) => Some(format!("a line ends at {at}, where there is no vertex")),
            Err(_) => None,
        };
        let hidden = |edge: [u32; 2]| found.hidden_as(edge, self.matched);
        let telling = Telling {
            layer: Layer::Drawn,
            writing: self.target.writing,
            tolerance: self.target.tolerance,
            extra_point: &extra_point,
            is_told: &|v| self.target.sketch.is_told(v),
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
        if self.found.dots.iter().all(|dot| *dot == Err(None)) {
            let text = "no vertex is drawn: draw a circle at each vertex".to_owned();
            return self.say(Kind::Vertex, text, Spot::Nowhere);
        }
        // Those with the same reason together, in the order of the first.
        let mut groups: Vec<(Option<Hidden>, Vec<u32>)> = Vec::new();
        for v in 0..self.expected().points.len() as u32 {
            let found = self.matched.to_found[v as usize].filter(|_| self.target.sketch.dots[v as usize].is_ok());
            let Some(Err(why)) = found.map(|m| self.found.dots[m as usize]) else { continue };
            match groups.iter_mut().find(|group| group.0 == why) {
                Some(group) => group.1.push(v),
                None => groups.push((why, vec![v])),
            }
        }
        for (why, group) in groups {
            let at_once = if group.len() < GROUP { 1 } else { group.len() };
            group.chunks(at_once).for_each(|group| self.lost_dots(why, group));
        }
    }

    /// One sentence about vertices without a dot that can be seen.
    fn lost_dots(&mut self, why: Option<Hidden>, group: &[u32]) {
        let place = |&v: &u32| {
            let name = &self.expected().names[v as usize];
            let at = self.target.writing.point(self.expected().point(v));
            if name.is_empty() { format!("at {at}") } else { format!("{name} at {at}") }
        };
        let places = listed(&group.iter().map(place).collect::<Vec<_>>());
        let text = match (why, group.len()) {
            (Some(why), 1) => format!("vertex {places} cannot be seen: {}", why.reason(false)),
            (None, 1) => format!("vertex {places} is missing: no circle is drawn there"),
            (Some(Hidden::Paper), n) => format!("{n} vertices have the colour of the paper: {places}"),
            (Some(why), n) => format!("{n} vertices cannot be seen, {}: {places}", why.reason(true)),
            (None, n) => format!("{n} vertices are missing, no circles are drawn there: {places}"),
        };
        let spots = group.iter().map(|&v| Spot::MissingVertex(self.expected().point(v))).collect();
        self.say(Kind::Vertex, text, Spot::all(spots));
    }

    fn side_notes(&mut self) {
        if self.found.doubled > 0 {
            let count = counted(self.found.doubled, "edge is drawn", "edges are drawn");
            self.notes.push(format!("{count} more than once"));
        }
        let beside = &self.found.beside;
        if beside.border > 0 {
            self.notes.push("the frame round the drawing is not compared".to_owned());
        }
        if beside.aside > 0 {
            let what = counted(beside.aside, "line or circle", "lines and circles");
            self.notes.push(format!("not compared: {what} of a legend or an axis"));
        }
        if beside.small > 0 {
            let what = counted(beside.small, "small area that touches", "small areas that touch");
            self.notes.push(format!("not compared: {what} no vertex"));
        }
        let known = |edge: &[u32; 2]| {
            let ends = edge_by(*edge, &self.matched.to_expected);
            ends.is_some_and(|ends| self.expected().edges.binary_search(&ends).is_ok())
        };
        let count = self.found.hidden.keys().filter(|edge| !known(edge)).count() + self.found.unseen;
        if count > 0 {
            let count = counted(count, "line that nobody can see is", "lines that nobody can see are");
            self.notes.push(format!("{count} not read"));
        }
    }
}
