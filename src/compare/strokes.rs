//! Whether lines that are no edges are seen, and small areas: those of half-edges.
//!
//! ```text
//!    ──┃──▸     a thin line of decoration over an arrow, as leaders are, hides nothing of it if it is seen itself
//!    ══════▸    one that runs along it, in another colour, hides what it covers: rims of the arrow have to show beside it
//! ```

use super::along::Stroke;
use super::eye::{Eye, FAINT, contrast};
use super::painting::{Coat, Part, Shape};
use super::pairing::distance;
use crate::plane::Point;
use std::ops::Range;

/// Points along a line that are looked at.
const POINTS: usize = 8;
/// A line of decoration is thin if it is no wider than this part of the drawing, and is seen as a line of its own if it has so
/// much contrast.
const THIN: f64 = 0.006;
const CLEAR: f64 = 48.0;
/// A line runs along another one if it turns by less than this, as a part of its length. The rim of that one shows beside
/// it if it does so far from the middle, as a part of half the width.
const TURN: f64 = 0.1;
const RIM: f64 = 0.8;
/// What is drawn twice lies at the same place up to this part of its size.
const NEAR: f64 = 0.02;

impl Eye<'_> {
    /// Whether something is seen of the lines among these coats; `without` is the answer if there are none. `strays` are
    /// the coats of what lies in a wrong place, sorted: a line below one of these, of its colour, is seen with it.
    pub(super) fn any_line(&mut self, coats: Range<u32>, without: bool, strays: &[Range<u32>]) -> bool {
        let painting = self.painting;
        let mut lines = coats.filter_map(|i| Some((i, painting.coats[i as usize].stroke()?))).peekable();
        let is_any = lines.peek().is_some();
        if is_any { lines.any(|(i, line)| self.shows_along(&[i], &[], line, strays)) } else { without }
    }

    /// Whether one of some coats is seen at half of the points along a line, in its middle or at its rims, with those of its
    /// heads, sorted, which may lie over it.
    pub(super) fn shows_along(
        &mut self,
        coats: &[u32],
        heads: &[u32],
        Stroke { ends: [a, b], half }: Stroke,
        strays: &[Range<u32>],
    ) -> bool {
        let painting = self.painting;
        let way = Point::new(b.x - a.x, b.y - a.y);
        let aside = RIM * half / way.x.hypot(way.y).max(f64::MIN_POSITIVE);
        let is_stray = |j: u32| {
            let next = strays.partition_point(|range| range.start <= j);
            next > 0 && strays[next - 1].contains(&j)
        };
        let is_head = |j: u32| heads.binary_search(&j).is_ok();
        let shows_at = |eye: &mut Self, t: f64, off: f64| {
            eye.look(Point::new(a.x + t * way.x - off * way.y, a.y + t * way.y + off * way.x));
            coats.iter().any(|&i| {
                let own = &painting.coats[i as usize];
                let goes_with = |j: u32, coat: &Coat| is_stray(j) && contrast(coat.colour, own.colour) < FAINT;
                let crosses = |coat: &Coat| !runs_along(coat, way) || contrast(coat.colour, own.colour) < FAINT;
                eye.differs(i, crosses, |j, coat| goes_with(j, coat) || is_head(j) || is_again(own, coat))
            })
        };
        let Some(&lowest) = coats.iter().min() else { return false };
        let mut seen = 0;
        for k in 0..POINTS {
            if self.is_tired() {
                return true;
            }
            let t = (k as f64 + 0.5) / POINTS as f64;
            if shows_at(self, t, 0.0) {
                seen += 1;
                continue;
            }
            // Beside a line along it a rim shows on both sides, or on one if that line is seen itself.
            let is_over = |j: &u32| *j > lowest && runs_along(&painting.coats[*j as usize], way) && !coats.contains(j);
            let over: Vec<u32> = self.stack.iter().copied().filter(is_over).collect();
            if over.is_empty() {
                continue;
            }
            let ground = self.ground(lowest);
            let is_clear = over.iter().all(|&j| self.is_thin(&painting.coats[j as usize], ground));
            let rims = [aside, -aside].into_iter().filter(|&off| shows_at(self, t, off)).count();
            seen += usize::from(rims == 2 || is_clear && rims == 1);
        }
        2 * seen >= POINTS
    }

    /// Whether a coat changes the colour at one of these points, some other coats left out. Decoration of its colour goes
    /// with it: where heads lie over each other's lines, their ink is there.
    pub(super) fn shows(&mut self, i: u32, points: &[Point], others: &[u32]) -> bool {
        let own = &self.painting.coats[i as usize];
        points.iter().any(|&p| {
            if self.is_tired() {
                return true;
            }
            self.look(p);
            self.stack.retain(|j| *j == i || !others.contains(j));
            if own.is_small_marker(self.span) {
                return self.marks(i, p);
            }
            let is_alike = |coat: &Coat| coat.part == Part::Other && contrast(own.colour, coat.colour) < FAINT;
            self.differs(i, |_| true, |_, coat| is_alike(coat) || is_again(own, coat))
        })
    }

    /// Whether the colour of the last point looked at would be another one without a coat and those that go with it, below
    /// what thin lines that cross it leave open: with what thin patterns paint there, and with what they leave open.
    fn differs(&self, i: u32, crosses: impl Fn(&Coat) -> bool, goes_with: impl Fn(u32, &Coat) -> bool) -> bool {
        let painting = self.painting;
        let ground = self.ground(i);
        let may_pass = |coat: &Coat| self.is_thin(coat, ground) && crosses(coat);
        let is_passed = |j: u32| j > i && may_pass(&painting.coats[j as usize]);
        let is_kept = |j: u32, coat: &Coat| j != i && !goes_with(j, coat);
        let is_open = |j: u32| painting.sparse.binary_search(&j).is_ok() || is_passed(j);
        let differ = |counts: &dyn Fn(u32) -> bool| {
            let all = self.colour(|j, _| counts(j));
            contrast(all, self.colour(|j, coat| counts(j) && is_kept(j, coat))) >= FAINT
        };
        differ(&|j| !is_passed(j)) && (painting.sparse.is_empty() || differ(&|j| j == i || !is_open(j)))
    }

    /// What areas paint at the last point looked at, below a coat.
    fn ground(&self, i: u32) -> [f64; 3] {
        self.colour(|j, coat| j < i && coat.part != Part::Other && !matches!(coat.shape, Shape::Stroke(..)))
    }

    /// Whether a coat is a thin line of decoration that is seen on this ground.
    fn is_thin(&self, coat: &Coat, ground: [f64; 3]) -> bool {
        let is_line = matches!(coat.shape, Shape::Stroke(_, half) if 2.0 * half <= THIN * self.span);
        is_line && coat.part == Part::Other && contrast(coat.colour, ground) >= CLEAR
    }

    /// Whether a small marker, which hides nothing itself, is seen at the last point looked at, or what is drawn over it.
    fn marks(&self, i: u32, p: Point) -> bool {
        let coat = &self.painting.coats[i as usize];
        if !coat.covers(p).0 || self.painting.cut_off(coat, p).is_some() {
            return false;
        }
        let below = self.colour(|j, _| j < i);
        let above = self.stack.iter().filter(|&&j| j > i).map(|&j| 1.0 - self.painting.coats[j as usize].alpha);
        above.product::<f64>() * coat.alpha * contrast(coat.colour, below) >= FAINT
    }
}

/// Whether a coat is a line of decoration that runs this way or back.
fn runs_along(coat: &Coat, way: Point) -> bool {
    let Shape::Stroke([c, d], _) = coat.shape else { return false };
    let (x, y) = (d.x - c.x, d.y - c.y);
    coat.part == Part::Other && (x * way.y - y * way.x).abs() <= TURN * x.hypot(y) * way.x.hypot(way.y)
}

/// Whether a coat paints the same place as another one, in the same colour.
fn is_again(own: &Coat, other: &Coat) -> bool {
    let is_near = |a: Point, b: Point| distance(a, b) <= NEAR * own.diameter();
    let is_there = match (&own.shape, &other.shape) {
        (Shape::Stroke([a, b], _), Shape::Stroke([c, d], _)) => {
            is_near(*a, *c) && is_near(*b, *d) || is_near(*a, *d) && is_near(*b, *c)
        }
        (Shape::Area(_), Shape::Area(_)) => own.corners().into_iter().zip(other.corners()).all(|(a, b)| is_near(a, b)),
        _ => false,
    };
    is_there && contrast(own.colour, other.colour) < FAINT
}
