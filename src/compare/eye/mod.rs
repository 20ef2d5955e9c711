//! What can be seen of what is painted: colours at points, with and without some of the coats.
//!
//! ```text
//!   an edge is seen      if its lines have another colour than the paper and than both sides, nearly all along it
//!   a vertex is seen     if its circle changes the colour at some of the points round it, and not to that of the paper
//!   a face is seen       if it has another colour than the paper
//! ```
//!
//! So nothing has to be known about the ways in which a line can be hidden: by an area, a white line or a circle
//! above it, by its own colour, by a clip path, or by lying beyond the canvas. Colours are mixed as browsers mix
//! them; pixels are not drawn.
//!
//! ```text
//!   blocks.rs  Plain areas that lie over an edge
//!   gaps.rs    Stretches of an edge that something covers
//! ```

mod blocks;
mod gaps;

use super::beside::Beside;
use super::cells::{cell, column, entries, level, pieces};
use super::ink::Hidden;
use super::painting::{Clip, Coat, Disc, Mark, Painting, Part, Shape};
use super::pairing::distance;
use crate::geometry::point::corners;
use crate::plane::Point;
use gaps::Gap;
pub(super) use gaps::Way;

/// Less contrast than this, in steps of 255, cannot be seen of lines and circles.
pub(super) const FAINT: f64 = 8.0;
/// Lines that cover less of what lies below them are called transparent.
const PALEST: f64 = 0.2;
/// Work of one comparison: coats and sides looked at.
const WORK: usize = 120_000_000;
/// Points along an edge, of drawings with few and with many edges.
const PROBES: [(usize, usize); 3] = [(2_000, 24), (10_000, 9), (usize::MAX, 3)];
/// So much of an edge between its circles has to be seen, and so much of it as itself.
const SEEN: f64 = 0.9;
const ALONE: f64 = 0.2;
/// The rim of a line shows beside a narrower one above if it is as wide as this part of the half line; so many are looked at.
const RIM: f64 = 0.1;
const RIMS: usize = 4;
/// Gaps that labels may make: at most so much of an edge, and by boxes of so large a part of the drawing.
const GAP: f64 = 0.45;
const LABEL: f64 = 0.2;
/// Letters along an edge are a label if they are no higher than this part of the drawing.
const LETTERS: f64 = 0.08;
/// A disc of a larger diameter than this part of the drawing, corner to corner of its box, is no background of a label.
const DISC: f64 = 0.12;
/// A text is the name in a disc if it is no longer than so many of its radii.
const NAME: f64 = 6.0;
/// So much of a circle has to be seen.
const DOT: f64 = 0.2;
/// So much contrast a circle needs that lies within a line.
const CLEAR: f64 = 64.0;

/// The eye on one painting.
pub(super) struct Eye<'a> {
    pub(super) painting: &'a Painting,
    /// Coats in the cells of grids of ever larger cells, sorted.
    cells: Vec<(u64, u32)>,
    levels: Vec<i32>,
    /// The point from which cells are counted.
    corner: Point,
    /// Areas that are drawn in place of lines.
    bars: Vec<u32>,
    /// Areas that are paper.
    paper: Vec<u32>,
    probes: usize,
    /// How large the drawing is.
    pub(super) span: f64,
    work: usize,
    /// What may be letters, by the middles of the boxes round it, from left to right; once it is asked for.
    inside: Option<Vec<(Point, u32)>>,
    /// Plain areas over lines, once they are asked for.
    blocks: Option<Vec<u32>>,
    /// What covers the point that was looked at, the lowest first: all but letters of ordinary size, and these.
    pub(super) stack: Vec<u32>,
    pub(super) letters: Vec<u32>,
}

impl<'a> Eye<'a> {
    /// `beside` tells which areas stand for lines and which are paper; `span` is the size of the drawing. O(n log n).
    pub(super) fn new(painting: &'a Painting, beside: &Beside, edges: usize, span: f64) -> Self {
        let mut cells = Vec::with_capacity(2 * painting.coats.len());
        let finest = span / 2048.0;
        let slack = span * 2e-4;
        let [corner, _] = corners(painting.coats.iter().map(|coat| coat.corners()[0]));
        let corner = Point::new(corner.x - slack, corner.y - slack);
        for (i, coat) in painting.coats.iter().enumerate() {
            let [low, high] = coat.corners();
            let (low, high) = (Point::new(low.x - slack, low.y - slack), Point::new(high.x + slack, high.y + slack));
            if !(low.x <= high.x && low.y <= high.y) || coat.alpha <= 0.0 || coat.is_small_marker(span) {
                continue;
            }
            let side = (high.x - low.x).max(high.y - low.y);
            // A long line lies in the cells that it passes, and not in all of its box.
            let pieces = match &coat.shape {
                Shape::Stroke(ends, half) => {
                    pieces(*ends, half + slack, (span / (edges as f64).sqrt().clamp(8.0, 512.0)).max(2.0 * half))
                }
                _ => vec![[low, high]],
            };
            let side = if pieces.len() > 1 { side / pieces.len() as f64 } else { side };
            let level = level(side.max(finest));
            for [low, high] in pieces {
                for x in column(low.x - corner.x, level)..=column(high.x - corner.x, level) {
                    for y in column(low.y - corner.y, level)..=column(high.y - corner.y, level) {
                        cells.push((cell(level, x, y), i as u32));
                    }
                }
            }
        }
        cells.sort_unstable();
        cells.dedup();
        let mut levels: Vec<i32> = cells.iter().map(|cell| (cell.0 >> 56) as i32 - 64).collect();
        levels.dedup();
        let probes = PROBES.iter().find(|(most, _)| edges <= *most).map_or(3, |(_, probes)| *probes);
        let (bars, paper) = (beside.bars.clone(), beside.paper.clone());
        Self {
            painting,
            cells,
            levels,
            corner,
            bars,
            paper,
            probes,
            span,
            work: 0,
            inside: None,
            blocks: None,
            stack: Vec::new(),
            letters: Vec::new(),
        }
    }

    /// Whether too much lay over each other to look at it all: then all that was not looked at counted as seen.
    pub(super) fn is_tired(&self) -> bool {
        self.work > WORK
    }

    /// Finds the coats that cover a point, the lowest first.
    pub(super) fn look(&mut self, p: Point) {
        self.stack.clear();
        self.letters.clear();
        for &level in &self.levels {
            for &(_, i) in entries(&self.cells, self.corner, level, p) {
                let coat = &self.painting.coats[i as usize];
                let (covers, work) = coat.covers(p);
                self.work += work;
                if covers && self.painting.cut_off(coat, p).is_none() {
                    let list = if coat.is_small_text(self.span) { &mut self.letters } else { &mut self.stack };
                    list.push(i);
                }
            }
        }
        if self.stack.len() > 1 {
            self.stack.sort_unstable();
            self.stack.dedup();
        }
    }

    /// The same, with some letters of ordinary size, sorted.
    fn look_below(&mut self, letters: &[u32], p: Point) {
        self.look(p);
        if !letters.is_empty() {
            self.stack.extend(self.letters.iter().filter(|i| letters.binary_search(i).is_ok()));
            self.stack.sort_unstable();
            self.stack.dedup();
        }
    }

    /// The letters at these points that nobody can read: they have the colour of the paper or of what lies below them.
    fn faded(&mut self, points: [Point; 2]) -> Vec<u32> {
        let mut out = Vec::new();
        for p in points {
            self.look(p);
            self.work += self.letters.len() * self.stack.len();
            if self.is_tired() {
                break;
            }
            out.extend(self.letters.iter().copied().filter(|&i| self.fades(i)));
        }
        out.sort_unstable();
        out.dedup();
        out.retain(|&i| !self.is_name(i));
        out
    }

    /// Whether a coat has the colour of the paper or of what lies below it at the last point looked at, lines left out.
    fn fades(&self, i: u32) -> bool {
        let colour = self.painting.coats[i as usize].colour;
        let below = self.colour(|j, _| j < i && !self.is_line(j));
        contrast(colour, below) < FAINT || contrast(colour, self.blank()) < FAINT
    }

    /// Whether a text is the name of a vertex: it is short, and its middle lies in a disc. Looks elsewhere.
    fn is_name(&mut self, i: u32) -> bool {
        let painting = self.painting;
        let text = &painting.coats[i as usize];
        self.look(text.middle());
        let mut discs = self.stack.iter().map(|&j| &painting.coats[j as usize]).filter(|coat| coat.part == Part::Dot);
        discs.any(|coat| coat.disc().is_some_and(|disc| text.diameter() <= NAME * disc.reach))
    }

    /// Whether a disc too large for the background of a label, which is not seen itself, covers the last point looked at.
    fn is_blotted(&self, own: &Own) -> bool {
        let Some(&top) = own.coats.last() else { return false };
        let is_large_disc = |&&i: &&u32| {
            let coat = &self.painting.coats[i as usize];
            matches!(coat.shape, Shape::Disc(_)) && coat.alpha > 0.5 && coat.diameter() > DISC * self.span
        };
        let mut above = self.stack.iter().rev().take_while(|&&i| i > top);
        above.find(is_large_disc).is_some_and(|&i| self.fades(i))
    }

    fn is_line(&self, i: u32) -> bool {
        self.painting.coats[i as usize].part == Part::Line || self.bars.binary_search(&i).is_ok()
    }

    /// The colour of the last point looked at, on white paper, of those coats.
    pub(super) fn colour(&self, keeps: impl Fn(u32, &Coat) -> bool) -> [f64; 3] {
        let mut out = [255.0; 3];
        for &i in &self.stack {
            let coat = &self.painting.coats[i as usize];
            if keeps(i, coat) {
                let mix = |below: f64, above: f64| below + coat.alpha * (above - below);
                out = [0, 1, 2].map(|c| mix(out[c], coat.colour[c]));
            }
        }
        out
    }

    /// The colour of the paper at the last point looked at.
    pub(super) fn blank(&self) -> [f64; 3] {
        self.colour(|i, _| self.paper.binary_search(&i).is_ok())
    }

    /// Why an edge is not seen, if that is so: nearly all of one that is expected has to be, and hardly anything of a
    /// stranger may be. `ends` are on the canvas; `discs` are the radii of the circles there.
    pub(super) fn edge(
        &mut self,
        ends: [Point; 2],
        discs: [f64; 2],
        tolerance: f64,
        is_stranger: bool,
    ) -> Result<(), Hidden> {
        let way = Way::new(ends, discs, tolerance);
        let mut marks = Vec::with_capacity(self.probes);
        let mut reasons = Vec::new();
        let (mut gap_is_small, mut blotted, mut crossed) = (true, false, 0);
        let mut last: Option<Gap> = None;
        for i in 0..self.probes {
            if self.is_tired() {
                return Ok(());
            }
            let far = way.length * (i as f64 + 0.5) / self.probes as f64;
            if !way.is_open(far) {
                continue;
            }
            let p = way.at(far);
            let Glance { seen, alone, own } = self.glance(&way, far);
            blotted |= !seen && self.is_blotted(&own);
            let mut is_open = seen;
            if !(seen && alone) {
                let why = self.reason(&own, p);
                reasons.push(why);
                if !seen && self.is_short_gap(&way, far, why, &mut last) {
                    (crossed, is_open) = (crossed + 1, true);
                } else {
                    gap_is_small &= seen || self.is_small(&own, p);
                }
            }
            marks.push((seen, alone, is_open));
        }
        let part = |count: usize| count as f64 / marks.len().max(1) as f64;
        let seen = part(marks.iter().filter(|mark| mark.0).count());
        let alone = part(marks.iter().filter(|mark| mark.1).count());
        if marks.is_empty() {
            return Err(Hidden::Ends);
        }
        let open = [marks.first(), marks.last()].iter().flatten().all(|mark| mark.2);
        let labelled = gap_is_small && open;
        let enough = seen >= SEEN || seen >= 1.0 - GAP && (labelled || seen + part(crossed) >= SEEN);
        let shows = is_stranger && part(marks.iter().filter(|mark| mark.0 && mark.1).count()) > 1.0 - SEEN;
        if shows || enough && alone >= ALONE && !blotted {
            return if !is_stranger && self.is_blocked(&way) { Err(Hidden::Area) } else { Ok(()) };
        }
        reasons.sort_unstable();
        let count = |why: &Hidden| reasons.iter().filter(|other| *other == why).count();
        Err(reasons.iter().copied().max_by_key(|why| (count(why), std::cmp::Reverse(*why))).unwrap_or(Hidden::Ground))
    }

    /// What is seen of an edge so far from its start.
    fn glance(&mut self, way: &Way, far: f64) -> Glance {
        let (p, along) = (way.at(far), way.along);
        let mut own = self.own(p, along, way.tolerance);
        let (mut seen, mut alone) = (false, false);
        // Of lines over each other, each that shows is looked at: a cased line, or the two rims of a double one.
        for off in own.offsets() {
            // On both sides of the middle, where an area may begin: the colours with and without lines.
            let points = [off, -off].map(|off| Point::new(p.x - off * along.y, p.y + off * along.x));
            let mut sides = points.map(|p| self.side(&own, p));
            if sides.iter().any(|side| side.has_letters) {
                own.letters = self.faded(points);
                sides = points.map(|p| self.side(&own, p));
            }
            // A line has another colour than what lies on either side of it, and than the paper.
            let blank = self.blank();
            let differs = |all: [f64; 3]| {
                let on_both = sides.iter().all(|side| own.cover * contrast(all, side.ground) >= FAINT);
                on_both && own.cover * contrast(all, blank) >= FAINT
            };
            let both = (sides.iter().any(|side| differs(side.all)), sides.iter().any(|side| side.alone));
            if both.0 >= seen {
                (seen, alone) = both;
            }
            if seen && alone {
                break;
            }
        }
        Glance { seen, alone, own }
    }

    /// What is seen at a point on one side of the middle of an edge.
    fn side(&mut self, own: &Own, p: Point) -> Side {
        self.look_below(&own.letters, p);
        let all = self.colour(|_, _| true);
        let without = self.colour(|i, _| own.coats.binary_search(&i).is_err());
        Side {
            all,
            ground: self.colour(|i, _| !self.is_line(i)),
            alone: contrast(all, without) >= FAINT,
            has_letters: !self.letters.is_empty(),
        }
    }

    /// The lines along this edge at a point.
    fn own(&mut self, p: Point, along: Point, tolerance: f64) -> Own {
        let mut out = Own { coats: Vec::new(), letters: Vec::new(), halves: Vec::new(), cover: 0.0 };
        for &level in &self.levels {
            for &(_, i) in entries(&self.cells, self.corner, level, p) {
                self.work += 1;
                let coat = &self.painting.coats[i as usize];
                match &coat.shape {
                    Shape::Stroke([c, d], half) if coat.part == Part::Line => {
                        let (x, y) = (d.x - c.x, d.y - c.y);
                        let skew = (x * along.y - y * along.x).abs() / x.hypot(y);
                        if skew <= 0.05 && super::pairing::lies_on(p, [*c, *d], 2.0 * tolerance) {
                            out.coats.push(i);
                            out.halves.push(*half);
                            out.cover = out.cover.max(coat.cover);
                        }
                    }
                    _ if self.bars.binary_search(&i).is_ok() && coat.covers(p).0 => {
                        out.coats.push(i);
                        out.cover = 1.0;
                    }
                    _ => {}
                }
            }
        }
        out.coats.sort_unstable();
        out.coats.dedup();
        out.halves.sort_unstable_by(f64::total_cmp);
        out
    }

    /// Why the lines of an edge are not seen at a point.
    fn reason(&mut self, own: &Own, p: Point) -> Hidden {
        let Some(&top) = own.coats.last() else { return Hidden::Dashes };
        let cut = own.coats.iter().map(|&i| self.painting.cut_off(&self.painting.coats[i as usize], p));
        if let Some(why) = cut.collect::<Option<Vec<&Clip>>>().and_then(cut_by) {
            return why;
        }
        self.look_below(&own.letters, p);
        let above = self.stack.iter().rev().take_while(|&&i| i > top);
        let covering = above.copied().find(|&i| self.painting.coats[i as usize].alpha > 0.5);
        let is_small_text = |i: u32| self.painting.coats[i as usize].is_small_text(self.span);
        match covering.map(|i| (self.is_line(i), self.painting.coats[i as usize].part)) {
            Some((true, _)) => Hidden::Line,
            Some(_) if covering.is_some_and(is_small_text) => Hidden::Faded,
            Some((_, part)) => hiding(part),
            None if own.coats.iter().all(|&i| self.painting.coats[i as usize].alpha < PALEST) => Hidden::Faint,
            None if contrast(self.colour(|_, _| true), self.blank()) < FAINT => Hidden::Paper,
            None => Hidden::Ground,
        }
    }

    /// Whether all that covers the lines of an edge at a point is small: letters, or the box of a label.
    fn is_small(&mut self, own: &Own, p: Point) -> bool {
        let Some(&top) = own.coats.last() else { return false };
        self.look_below(&own.letters, p);
        let painting = self.painting;
        let above = self.stack.iter().filter(|&&i| i > top && painting.coats[i as usize].alpha > 0.2);
        let above: Vec<u32> = above.copied().collect();
        let mut small = |i: &u32| {
            let coat = &painting.coats[*i as usize];
            let is_small = coat.diameter() <= LABEL * self.span;
            match coat.part {
                Part::Area | Part::Other => is_small && self.holds_letters(*i),
                Part::Mark(Mark::Letters) => is_small || coat.thickness() <= LETTERS * self.span,
                _ => false,
            }
        };
        !above.is_empty() && above.iter().all(&mut small)
    }

    /// Why the circles at a vertex are not seen, if that is so.
    pub(super) fn vertex(&mut self, centre: Point, radius: f64, tolerance: f64) -> Result<(), Hidden> {
        const ROUND: usize = 16;
        let (mut seen, mut looked, mut top, mut below) = (0, 0, None, false);
        // A circle no wider than a line there is seen on it only if it has clearly another colour.
        self.look(centre);
        let mut lines = self.stack.iter().map(|&i| &self.painting.coats[i as usize]);
        let within = lines.any(|coat| coat.part == Part::Line && coat.stroke().is_some_and(|line| line.half >= radius));
        // Where its colour is not that of the paper: points at which lines have it, too, and areas.
        let (mut swallowed, mut grounded, mut blank) = (0, 0, 0);
        let axes = self.axes(centre, radius, tolerance);
        let round = |part: f64, i: usize| {
            let (s, c) = (std::f64::consts::TAU * (i as f64 + 0.3) / ROUND as f64).sin_cos();
            let (s, c) = (part * s, part * c);
            Point::new(centre.x + c * axes[0].x + s * axes[1].x, centre.y + c * axes[0].y + s * axes[1].y)
        };
        // Well inside, and where a rim is: however thin, one of the last two lies on it.
        for part in [0.45, 0.8, 0.93, 0.985] {
            for i in 0..ROUND {
                if self.is_tired() {
                    return Ok(());
                }
                self.look(round(part, i));
                let is_here = |disc: &Disc| distance(disc.centre, centre) <= tolerance;
                let is_own = |coat: &Coat| coat.part == Part::Dot && coat.disc().is_some_and(is_here);
                let owned = self.stack.iter().rev().find(|&&i| is_own(&self.painting.coats[i as usize]));
                looked += usize::from(part < 0.9);
                below |= owned.is_some();
                let all = self.colour(|_, _| true);
                let below = contrast(all, self.colour(|_, coat| !is_own(coat)));
                let differs = below >= if within { CLEAR } else { FAINT };
                if differs && contrast(all, self.blank()) >= FAINT {
                    seen += 1;
                } else if let Some(&own) = owned {
                    let mut above = self.stack.iter().copied().filter(|&i| i > own);
                    let hides = |&i: &u32| !self.is_line(i) && self.painting.coats[i as usize].alpha > 0.5;
                    top = top.or_else(|| above.clone().find(hides).or_else(|| above.next_back()));
                    match self.stack.iter().rev().find(|&&i| !is_own(&self.painting.coats[i as usize])) {
                        _ if contrast(all, self.blank()) < FAINT => blank += 1,
                        Some(&i) if self.is_line(i) => swallowed += 1,
                        _ => grounded += 1,
                    }
                }
            }
        }
        let enough = |all: usize| seen as f64 >= DOT * all as f64;
        if enough(looked) {
            return Ok(());
        }
        // Of a circle that is cut off in part, as at the border of a page, what is left counts, if it is enough.
        let own: Vec<&Coat> = self.circles(centre, tolerance).collect();
        self.work += 2 * ROUND * own.len();
        let shown = |p: Point| own.iter().any(|coat| self.painting.cut_off(coat, p).is_none());
        let left = [0.45, 0.8].iter().map(|&part| (0..ROUND).filter(|&i| shown(round(part, i))).count()).sum::<usize>();
        if left as f64 >= DOT * looked as f64 && enough(left) {
            return Ok(());
        }
        Err(match top.map(|i| (self.is_line(i), self.painting.coats[i as usize].part)) {
            Some((true, _)) => Hidden::Line,
            Some((_, part)) => hiding(part),
            None if !below => self.lost(centre, tolerance),
            None if swallowed > blank.max(grounded) => Hidden::Swallowed,
            None if grounded > blank => Hidden::Ground,
            None => Hidden::Paper,
        })
    }

    /// The circles at a vertex.
    fn circles(&self, centre: Point, tolerance: f64) -> impl Iterator<Item = &'a Coat> + '_ {
        let found = self.levels.iter().flat_map(move |&level| entries(&self.cells, self.corner, level, centre));
        let painting = self.painting;
        let coats = found.map(move |&(_, i)| &painting.coats[i as usize]);
        coats.filter(move |coat| matches!(&coat.shape, Shape::Disc(disc) if distance(disc.centre, centre) <= tolerance))
    }

    /// Two half diameters of the largest circle at a vertex, which may be drawn as an ellipse, to its outer rim.
    fn axes(&self, centre: Point, radius: f64, tolerance: f64) -> [Point; 2] {
        let discs = self.circles(centre, tolerance).filter_map(Coat::disc);
        let largest = discs.max_by(|a, b| a.reach.total_cmp(&b.reach));
        let upright = [Point::new(radius, 0.0), Point::new(0.0, radius)];
        largest.and_then(Disc::axes).unwrap_or(upright)
    }

    /// Why nothing lies where a circle at a vertex should be seen: it is cut off, or only its rim is drawn.
    fn lost(&self, centre: Point, tolerance: f64) -> Hidden {
        let cut = self.circles(centre, tolerance).filter_map(|coat| self.painting.cut_off(coat, centre));
        cut_by(cut).unwrap_or(Hidden::Rim)
    }

    /// The circle of another vertex that covers a point, if there is one.
    pub(super) fn disc_over(&mut self, p: Point, tolerance: f64) -> Option<Point> {
        self.look(p);
        let dots = self.stack.iter().map(|&i| &self.painting.coats[i as usize]).filter(|coat| coat.part == Part::Dot);
        dots.filter_map(Coat::disc).map(|disc| disc.centre).find(|&centre| distance(centre, p) > tolerance)
    }
}

/// What is seen of an edge at a point: whether its lines are, and whether they are seen as themselves.
pub(super) struct Glance {
    pub(super) seen: bool,
    alone: bool,
    own: Own,
}

/// The lines along an edge, sorted, and half their widths, sorted; the letters at a point of it that nobody can read.
struct Own {
    coats: Vec<u32>,
    letters: Vec<u32>,
    halves: Vec<f64>,
    /// How much of a px the widest is wide, if it is narrower.
    cover: f64,
}

impl Own {
    /// How far from the middle each of the lines shows if it lies below all narrower ones: the narrowest near the middle,
    /// each wider one half way out to its own rim, if it is clearly wider.
    fn offsets(&self) -> Vec<f64> {
        let narrowest = self.halves.first().copied().unwrap_or(0.0);
        let mut out = vec![0.3 * narrowest];
        let mut within = narrowest;
        for &half in &self.halves {
            if half - within > RIM * half && out.len() < RIMS {
                out.push(0.5 * (within + half));
                within = half;
            }
        }
        out
    }
}

/// What is seen at a point: the colour, that without lines, and whether it is another one without those of the edge.
#[derive(Clone, Copy)]
struct Side {
    all: [f64; 3],
    ground: [f64; 3],
    alone: bool,
    /// Whether there are letters of ordinary size.
    has_letters: bool,
}

/// The reason for what lies below such a coat, which is no line.
fn hiding(part: Part) -> Hidden {
    match part {
        Part::Dot => Hidden::Dot,
        Part::Mark(Mark::Marker) => Hidden::Marker,
        Part::Mark(Mark::Letters) => Hidden::Letters,
        _ => Hidden::Area,
    }
}

/// Why nobody sees what some clips cut off, if there are any: the canvas counts before the others.
pub(super) fn cut_by<'a>(clips: impl IntoIterator<Item = &'a Clip>) -> Option<Hidden> {
    let clip = clips.into_iter().max_by_key(|clip| clip.canvas)?;
    Some(if clip.canvas { Hidden::Canvas } else { Hidden::Clip })
}

pub(super) fn contrast(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
