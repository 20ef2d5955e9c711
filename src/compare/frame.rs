//! From the student's canvas to the coordinates of the reference: a scale and a shift, never a turn or a stretch.
//!
//! ```text
//!   same canvas      the reference's own map, if both drew to the same frame
//!   box to box       the corners of what is drawn
//!   pair to pair     two points far apart onto every pair of the reference; bears missing and moved corners
//! ```
//!
//! The map that brings most points to their places wins. Only if none of them brings enough, mirrored, turned and
//! stretched ones are tried: not to forgive them, but to say so. Those of the smallest angle come first.

use super::pairing::{Places, distance};
use crate::figure::canvas::number::model;
use crate::geometry::point;
use crate::plane::{Point, convex_hull};

/// Pairs are tried against every pair of at most this many points; at any angle, of the corners round more.
const PAIRS: usize = 150;
/// Maps of a kind that are tried in full.
const TRIALS: usize = 400;
/// A turned drawing must fit as well as this to be called one.
const CLEAR: f64 = 0.8;
/// So many maps at any angle are offered; those of nearly the same angle are one, in degrees.
const ANGLES: usize = 8;
const NEARLY: f64 = 0.5;

/// How a drawing lies.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Turn {
    Upright,
    LeftRight,
    UpsideDown,
    Half,
    Left,
    Right,
    Diagonal,
    Antidiagonal,
    /// To the left by this many degrees; to the right if they are negative.
    Angle(f64),
    /// Mirrored, and turned by an angle as well.
    MirrorAngle,
    /// Stretched by these factors in x and y.
    Stretch([f64; 2]),
}

impl Turn {
    const OTHERS: [Self; 7] =
        [Self::LeftRight, Self::UpsideDown, Self::Half, Self::Left, Self::Right, Self::Diagonal, Self::Antidiagonal];

    /// What undoes the turn, by rows.
    fn matrix(self) -> [f64; 4] {
        match self {
            Self::Upright | Self::Angle(_) | Self::MirrorAngle | Self::Stretch(_) => [1.0, 0.0, 0.0, 1.0],
            Self::LeftRight => [-1.0, 0.0, 0.0, 1.0],
            Self::UpsideDown => [1.0, 0.0, 0.0, -1.0],
            Self::Half => [-1.0, 0.0, 0.0, -1.0],
            Self::Left => [0.0, 1.0, -1.0, 0.0],
            Self::Right => [0.0, -1.0, 1.0, 0.0],
            Self::Diagonal => [0.0, 1.0, 1.0, 0.0],
            Self::Antidiagonal => [0.0, -1.0, -1.0, 0.0],
        }
    }

    fn apply(self, p: Point) -> Point {
        let [a, b, c, d] = self.matrix();
        Point::new(a * p.x + b * p.y, c * p.x + d * p.y)
    }

    /// How far it is turned, in degrees; more than any angle if it is mirrored as well.
    fn angle(self) -> f64 {
        match self {
            Self::Angle(degrees) => degrees.abs(),
            _ => 360.0,
        }
    }

    /// What is wrong with a drawing that has to be turned like this.
    pub(super) fn sentence(self) -> String {
        let rounded = |x: f64, by: f64| model((x * by).round() / by);
        match self {
            Self::Upright => "the drawing is upright".to_owned(),
            Self::LeftRight => "the drawing is mirrored left-right".to_owned(),
            Self::UpsideDown => "y points down: the drawing is upside down (draw y as height - y)".to_owned(),
            Self::Half => "the drawing is turned by half a turn".to_owned(),
            Self::Left => "the drawing is turned by a quarter to the left".to_owned(),
            Self::Right => "the drawing is turned by a quarter to the right".to_owned(),
            Self::Diagonal | Self::Antidiagonal => "x and y have changed places: the drawing is mirrored".to_owned(),
            Self::Angle(degrees) => {
                let side = if degrees > 0.0 { "left" } else { "right" };
                format!("the drawing is turned by {}° to the {side}", rounded(degrees.abs(), 100.0))
            }
            Self::MirrorAngle => "the drawing is mirrored and turned".to_owned(),
            Self::Stretch([x, y]) => {
                let times = rounded(x / y, 1e4);
                format!("the drawing is stretched: x is drawn {times} times as large as y (use one scale for both)")
            }
        }
    }
}

/// A map from the canvas to the coordinates of the reference.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Frame {
    pub(super) turn: Turn,
    /// By rows.
    matrix: [f64; 4],
    shift: [f64; 2],
}

impl Frame {
    pub(super) const IDENTITY: Self = Self { turn: Turn::Upright, matrix: [1.0, 0.0, 0.0, 1.0], shift: [0.0; 2] };

    pub(super) fn apply(&self, p: Point) -> Point {
        let [a, b, c, d] = self.matrix;
        Point::new(a * p.x + b * p.y + self.shift[0], c * p.x + d * p.y + self.shift[1])
    }

    /// How much lengths grow.
    pub(super) fn scale(&self) -> f64 {
        let [a, b, c, d] = self.matrix;
        (a * d - b * c).abs().sqrt()
    }

    /// The point of the canvas that is brought here.
    pub(super) fn back(&self, p: Point) -> Point {
        let [a, b, c, d] = self.matrix;
        let (x, y) = (p.x - self.shift[0], p.y - self.shift[1]);
        let determinant = a * d - b * c;
        Point::new((d * x - b * y) / determinant, (a * y - c * x) / determinant)
    }

    /// Whether two maps turn and scale nearly alike.
    fn is_nearly(&self, other: &Self) -> bool {
        let near = 1e-2 * self.scale();
        self.matrix.iter().zip(other.matrix).all(|(a, b)| (a - b).abs() <= near)
    }

    /// Turn, then scale, then shift.
    fn of(turn: Turn, scale: f64, shift: [f64; 2]) -> Self {
        Self { turn, matrix: turn.matrix().map(|x| x * scale), shift }
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
        fits.then_some(Self::of(turn, scale, shift))
    }

    /// The turned map that takes p to u and q to v: any angle, mirrored or not.
    fn similar([p, q]: [Point; 2], [u, v]: [Point; 2], mirrored: bool) -> Option<Self> {
        let side = if mirrored { -1.0 } else { 1.0 };
        let (from, to) = ([q.x - p.x, side * (q.y - p.y)], [v.x - u.x, v.y - u.y]);
        let squared = from[0] * from[0] + from[1] * from[1];
        let (c, s) = ((from[0] * to[0] + from[1] * to[1]) / squared, (from[0] * to[1] - from[1] * to[0]) / squared);
        let matrix = [c, -s * side, s, c * side];
        let turn = if mirrored { Turn::MirrorAngle } else { Turn::Angle(-s.atan2(c).to_degrees()) };
        let shift = [u.x - matrix[0] * p.x - matrix[1] * p.y, u.y - matrix[2] * p.x - matrix[3] * p.y];
        (c.hypot(s) > 0.0 && c.is_finite() && s.is_finite()).then_some(Self { turn, matrix, shift })
    }

    /// The map that takes one box to another, with a scale for each side.
    fn stretched([p, q]: [Point; 2], [u, v]: [Point; 2]) -> Option<Self> {
        let scales = [(v.x - u.x) / (q.x - p.x), (v.y - u.y) / (q.y - p.y)];
        let fits = scales.iter().all(|scale| scale.is_finite() && *scale > 0.0);
        let shift = [u.x - scales[0] * p.x, u.y - scales[1] * p.y];
        let turn = Turn::Stretch(scales.map(|scale| 1.0 / scale));
        fits.then_some(Self { turn, matrix: [scales[0], 0.0, 0.0, scales[1]], shift })
    }

    /// The upright map that takes every point to its partner within the tolerance, stated for the points.
    pub(super) fn between(from: &[Point], to: &[Point], tolerance: f64) -> Option<Self> {
        let along = |i: usize| from[i].x + 0.7 * from[i].y;
        let by_place = |a: &usize, b: &usize| along(*a).total_cmp(&along(*b));
        let (i, j) = ((0..from.len()).min_by(by_place)?, (0..from.len()).max_by(by_place)?);
        let map = Self::onto(Turn::Upright, [from[i], from[j]], [to[i], to[j]], f64::INFINITY)?;
        let fits = |(&p, &q): (&Point, &Point)| distance(map.apply(p), q) <= 4.0 * tolerance * map.scale();
        (i != j && from.iter().zip(to).all(fits)).then_some(map)
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
        best
    }

    /// The mirrored and turned maps that fit clearly, and at least as well as `best`.
    pub(super) fn others(&self, drawn: &[Point], core: &[Point], best: &Best) -> Vec<Frame> {
        // So few points fit any map.
        if self.expected.len() < 3 {
            return Vec::new();
        }
        let enough = best.matched.max((CLEAR * self.expected.len() as f64) as usize);
        let found = Turn::OTHERS.into_iter().filter_map(|turn| {
            let mut other = Best { frame: Frame::IDENTITY, matched: 0 };
            self.turned(turn, drawn, core, &mut other);
            (other.matched >= enough).then_some(other.frame)
        });
        let mut found: Vec<Frame> = found.collect();
        if found.is_empty() {
            let stretched = self.stretched(drawn, core);
            found.extend((stretched.matched >= enough).then_some(stretched.frame));
            found.extend(self.angled(drawn, core, enough));
        }
        found
    }

    fn stretched(&self, drawn: &[Point], core: &[Point]) -> Best {
        let mut best = Best { frame: Frame::IDENTITY, matched: 0 };
        for points in [core, drawn] {
            let map = corners(points).zip(corners(self.expected)).and_then(|(from, to)| Frame::stretched(from, to));
            map.into_iter().for_each(|map| self.offer(map, drawn, &mut best));
        }
        best
    }

    /// Two points far apart onto all pairs, at any angle: the maps that bring most, and at least `enough`, the smallest
    /// angles first, mirrored ones last.
    fn angled(&self, drawn: &[Point], core: &[Point], enough: usize) -> Vec<Frame> {
        let mut found: Vec<Best> = Vec::new();
        // Of many points, those far apart are corners of the convex hull, however it is turned.
        let outer = match self.expected.len().max(core.len()) {
            ..=PAIRS => self.expected.to_vec(),
            _ => convex_hull(self.expected)
                .map(|hull| hull.into_iter().map(|i| self.expected[i as usize]).collect())
                .unwrap_or_default(),
        };
        if outer.len() > PAIRS {
            return Vec::new();
        }
        for pair in far_pairs(core).into_iter().take(2) {
            for (u, v) in outer.iter().flat_map(|&u| outer.iter().map(move |&v| (u, v))) {
                for mirrored in [false, true] {
                    let Some(map) = Frame::similar(pair, [u, v], mirrored) else { continue };
                    if self.is_promising(&map, core) {
                        let matched = self.count(&map, drawn);
                        if matched >= enough && found.iter().all(|other| other.matched <= matched) {
                            found.retain(|other| other.matched == matched);
                            found.push(Best { frame: map, matched });
                        }
                    }
                }
            }
        }
        let mut out: Vec<Frame> = found.into_iter().map(|best| best.frame).collect();
        out.sort_by(|a, b| a.turn.angle().total_cmp(&b.turn.angle()));
        out.dedup_by(|a, b| (a.turn.angle() - b.turn.angle()).abs() < NEARLY && a.is_nearly(b));
        out.truncate(ANGLES);
        out
    }

    /// Nine of ten wrong maps fail at once.
    fn is_promising(&self, map: &Frame, core: &[Point]) -> bool {
        let fits = |p: &&Point| self.places.near(map.apply(**p), self.tolerance).is_some();
        core.iter().take(12).filter(fits).count() > core.len().min(12) / 4
    }

    fn offer(&self, frame: Frame, drawn: &[Point], best: &mut Best) {
        if best.matched == self.expected.len() {
            return;
        }
        let matched = self.count(&frame, drawn);
        if matched > best.matched {
            *best = Best { frame, matched };
        }
    }

    /// How many of the expected points a map brings something to.
    fn count(&self, frame: &Frame, drawn: &[Point]) -> usize {
        let mut hit = vec![false; self.expected.len()];
        for &p in drawn {
            if let Some(v) = self.places.near(frame.apply(p), self.tolerance) {
                hit[v as usize] = true;
            }
        }
        hit.iter().filter(|&&hit| hit).count()
    }

    fn turned(&self, turn: Turn, drawn: &[Point], core: &[Point], best: &mut Best) {
        for points in [core, drawn] {
            let boxed: Vec<Point> = points.iter().map(|&p| turn.apply(p)).collect();
            if let (Some(from), Some(to)) = (corners(&boxed), corners(self.expected)) {
                // The box is turned already.
                let map = Frame::onto(Turn::Upright, from, to, 4.0 * self.tolerance);
                let turned = map.map(|map| Frame::of(turn, map.scale(), map.shift));
                turned.into_iter().for_each(|map| self.offer(map, drawn, best));
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
                    if self.is_promising(&map, core) {
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
    (!points.is_empty()).then(|| point::corners(points.iter().copied()))
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
            let others = search.others(&drawn, &drawn, &best);
            assert_eq!(others.iter().map(|frame| frame.turn).collect::<Vec<_>>(), [turn]);
        }
        let stretched = placed(|p| (2.0 * p.x + 7.0, 3.0 * p.y));
        let best = search.best(&stretched, &stretched, &[]);
        assert!(best.matched < 4, "scales must be equal");
        let other = search.others(&stretched, &stretched, &best);
        assert_eq!(
            other[0].turn.sentence(),
            "the drawing is stretched: x is drawn 0.6667 times as large as y (use one scale for both)"
        );
        let (s, c) = 30f64.to_radians().sin_cos();
        for (side, sentence) in
            [(1.0, "the drawing is turned by 30° to the left"), (-1.0, "the drawing is mirrored and turned")]
        {
            let angled = placed(|p| (2.0 * (side * c * p.x - s * p.y), 2.0 * (side * s * p.x + c * p.y)));
            let best = search.best(&angled, &angled, &[]);
            let other = search.others(&angled, &angled, &best);
            assert_eq!(other[0].turn.sentence(), sentence);
            let (p, q) = (angled[2], other[0].apply(angled[2]));
            assert!(distance(q, expected[2]) < 1e-9 && distance(other[0].back(q), p) < 1e-9);
        }
    }
}
