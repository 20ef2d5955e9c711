//! From the student's canvas to the coordinates of the reference: a scale and a shift, never a turn.
//!
//! ```text
//!   same canvas      the reference's own map, if both drew to the same frame
//!   box to box       the corners of what is drawn
//!   pair to pair     two points far apart onto every pair of the reference; bears missing and moved corners
//! ```
//!
//! The map that brings most points to their places wins. Only if none of them brings enough, mirrored and turned
//! ones are tried: not to forgive them, but to say so.

use super::pairing::Places;
use crate::plane::Point;

/// Pairs are tried against every pair of at most this many points.
const PAIRS: usize = 150;
/// Maps of a kind that are tried in full.
const TRIALS: usize = 400;
/// A turned drawing must fit as well as this to be called one.
const CLEAR: f64 = 0.8;

/// How a drawing lies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Turn {
    Upright,
    LeftRight,
    UpsideDown,
    Half,
    Left,
    Right,
    Diagonal,
    Antidiagonal,
}

impl Turn {
    const OTHERS: [Self; 7] =
        [Self::LeftRight, Self::UpsideDown, Self::Half, Self::Left, Self::Right, Self::Diagonal, Self::Antidiagonal];

    fn apply(self, p: Point) -> Point {
        let (x, y) = match self {
            Self::Upright => (p.x, p.y),
            Self::LeftRight => (-p.x, p.y),
            Self::UpsideDown => (p.x, -p.y),
            Self::Half => (-p.x, -p.y),
            Self::Left => (p.y, -p.x),
            Self::Right => (-p.y, p.x),
            Self::Diagonal => (p.y, p.x),
            Self::Antidiagonal => (-p.y, -p.x),
        };
        Point::new(x, y)
    }

    /// What is wrong with a drawing that has to be turned like this.
    pub(super) const fn sentence(self) -> &'static str {
        match self {
            Self::Upright => "the drawing is upright",
            Self::LeftRight => "the drawing is mirrored left-right",
            Self::UpsideDown => "y points down: the drawing is upside down (draw y as height - y)",
            Self::Half => "the drawing is turned by half a turn",
            Self::Left => "the drawing is turned by a quarter to the left",
            Self::Right => "the drawing is turned by a quarter to the right",
            Self::Diagonal | Self::Antidiagonal => "x and y have changed places: the drawing is mirrored",
        }
    }
}

/// A map: turn, then scale, then shift.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Frame {
    pub(super) turn: Turn,
    scale: f64,
    shift: [f64; 2],
}

impl Frame {
    pub(super) const IDENTITY: Self = Self { turn: Turn::Upright, scale: 1.0, shift: [0.0; 2] };

    pub(super) fn apply(&self, p: Point) -> Point {
        let p = self.turn.apply(p);
        Point::new(p.x * self.scale + self.shift[0], p.y * self.scale + self.shift[1])
    }

    /// The map of this turn that takes p to u and q to v, if there is one: the scale is that of the longer side.
    fn onto(turn: Turn, [p, q]: [Point; 2], [u, v]: [Point; 2], slack: f64) -> Option<Self> {
        let (p, q) = (turn.apply(p), turn.apply(q));
        let (from, to) = ([q.x - p.x, q.y - p.y], [v.x - u.x, v.y - u.y]);
        let longer = usize::from(from[1].abs() > from[0].abs());
        let point = from.iter().chain(&to).all(|side| *side == 0.0);
        let scale = if point { 1.0 } else { to[longer] / from[longer] };
        let fits = scale.is_finite() && scale > 0.0 && (from[1 - longer] * scale - to[1 - longer]).abs() <= slack;
        // Half of what does not fit goes to each end.
        let shift = [0.5 * (u.x + v.x - (p.x + q.x) * scale), 0.5 * (u.y + v.y - (p.y + q.y) * scale)];
        fits.then_some(Self { turn, scale, shift })
    }
}

/// The best map found, and how many of the expected points it brings something to.
pub(super) struct Best {
    pub(super) frame: Frame,
    pub(super) matched: usize,
}

/// The search for the map that fits.
pub(super) struct Search<'a> {
    expected: &'a [Point],
    places: Places,
    tolerance: f64,
}

impl<'a> Search<'a> {
    pub(super) fn new(expected: &'a [Point], tolerance: f64) -> Self {
        Self { expected, places: Places::of(expected, 4.0 * tolerance), tolerance }
    }

    /// The map for drawn points. `hints` are maps to be tried first; `core` are the points that stand for the
    /// whole, the dots if there are any.
    pub(super) fn best(&self, drawn: &[Point], core: &[Point], hints: &[Frame]) -> Best {
        let mut best = Best { frame: Frame::IDENTITY, matched: 0 };
        for &hint in hints {
            self.offer(hint, drawn, &mut best);
        }
        self.turned(Turn::Upright, drawn, core, &mut best);
        // So few points fit any map.
        let few = self.expected.len() < 3;
        if few || 2 * best.matched >= self.expected.len() {
            return best;
        }
        let mut other = Best { frame: Frame::IDENTITY, matched: 0 };
        for turn in Turn::OTHERS {
            self.turned(turn, drawn, core, &mut other);
        }
        let is_clear = other.matched as f64 >= CLEAR * self.expected.len() as f64;
        if is_clear { other } else { best }
    }

    fn offer(&self, frame: Frame, drawn: &[Point], best: &mut Best) {
        if best.matched == self.expected.len() {
            return;
        }
        let mut hit = vec![false; self.expected.len()];
        for &p in drawn {
            if let Some(v) = self.places.near(frame.apply(p), self.tolerance) {
                hit[v as usize] = true;
            }
        }
        let matched = hit.iter().filter(|&&hit| hit).count();
        if matched > best.matched {
            *best = Best { frame, matched };
        }
    }

    fn turned(&self, turn: Turn, drawn: &[Point], core: &[Point], best: &mut Best) {
        for points in [core, drawn] {
            let boxed: Vec<Point> = points.iter().map(|&p| turn.apply(p)).collect();
            if let (Some(from), Some(to)) = (corners(&boxed), corners(self.expected)) {
                // The box is turned already.
                let map = Frame::onto(Turn::Upright, from, to, 4.0 * self.tolerance);
                map.into_iter().for_each(|map| self.offer(Frame { turn, ..map }, drawn, best));
            }
        }
        if best.matched < self.expected.len() && self.expected.len().max(core.len()) <= PAIRS {
            self.pairs(turn, drawn, core, best);
        }
    }

    /// Pairs of points far apart, onto all pairs.
    fn pairs(&self, turn: Turn, drawn: &[Point], core: &[Point], best: &mut Best) {
        let mut trials = 0;
        for pair in far_pairs(core) {
            for &u in self.expected {
                for &v in self.expected {
                    let Some(map) = Frame::onto(turn, pair, [u, v], 2.0 * self.tolerance) else { continue };
                    trials += 1;
                    if trials > TRIALS {
                        return;
                    }
                    // Nine of ten wrong maps fail at once.
                    let fits = |p: &&Point| self.places.near(map.apply(**p), self.tolerance).is_some();
                    if core.iter().take(12).filter(fits).count() > core.len().min(12) / 4 {
                        self.offer(map, drawn, best);
                    }
                }
            }
            if 10 * best.matched >= 9 * self.expected.len() {
                return;
            }
        }
    }
}

/// The corners of the box round all points.
fn corners(points: &[Point]) -> Option<[Point; 2]> {
    points.iter().fold(None, |corners: Option<[Point; 2]>, &p| {
        let [low, high] = corners.unwrap_or([p; 2]);
        Some([Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y))])
    })
}

/// Pairs of extreme points in different directions.
fn far_pairs(points: &[Point]) -> Vec<[Point; 2]> {
    let directions = [(1.0, 0.31), (-0.27, 1.0), (1.0, 1.13), (1.0, -0.87), (0.4, 1.0), (1.0, -0.2)];
    let extreme = |(x, y): (f64, f64)| {
        let along = |p: &Point| p.x * x + p.y * y;
        points.iter().copied().max_by(|a, b| along(a).total_cmp(&along(b)))
    };
    let pair = |(x, y)| Some([extreme((x, y))?, extreme((-x, -y))?]);
    directions.into_iter().filter_map(pair).filter(|[p, q]| p != q).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure() -> Vec<Point> {
        let flat = [(0.0, 0.0), (9.0, 0.0), (9.0, 4.0), (0.0, 6.0), (2.0, 1.0), (5.0, 3.0), (7.0, 1.5)];
        flat.map(|(x, y)| Point::new(x, y)).to_vec()
    }

    fn placed(map: impl Fn(Point) -> (f64, f64)) -> Vec<Point> {
        let moved = |p| {
            let (x, y) = map(p);
            Point::new(x, y)
        };
        figure().into_iter().map(moved).collect()
    }

    #[test]
    fn a_scaled_and_shifted_drawing_fits_even_without_its_corners() {
        let expected = figure();
        let search = Search::new(&expected, 1e-3);
        let mut drawn = placed(|p| (62.0 + 50.0 * p.x, 50.0 * p.y - 400.0));
        assert_eq!(search.best(&drawn, &drawn, &[]).matched, 7);
        drawn.remove(1);
        drawn[2].y += 40.0;
        let best = search.best(&drawn, &drawn, &[]);
        assert_eq!((best.matched, best.frame.turn), (5, Turn::Upright));
    }

    #[test]
    fn turned_drawings_are_named() {
        let expected = figure();
        let search = Search::new(&expected, 1e-3);
        for (turn, drawn) in [
            (Turn::LeftRight, placed(|p| (-3.0 * p.x, 3.0 * p.y))),
            (Turn::UpsideDown, placed(|p| (p.x, 5.0 - p.y))),
            (Turn::Half, placed(|p| (-p.x, -p.y))),
            (Turn::Left, placed(|p| (-p.y, p.x))),
            (Turn::Right, placed(|p| (p.y, -p.x))),
            (Turn::Diagonal, placed(|p| (p.y, p.x))),
        ] {
            let best = search.best(&drawn, &drawn, &[]);
            assert_eq!((best.matched, best.frame.turn), (7, turn));
        }
        let stretched = placed(|p| (2.0 * p.x, 3.0 * p.y));
        assert!(search.best(&stretched, &stretched, &[]).matched < 4, "scales must be equal");
    }
}
