//! What a drawing paints, in the order in which it does.
//!
//! ```text
//!   coats    1 area ─ 2 area ─ 3 line ─ 4 line ─ 5 disc        a later one lies over an earlier one
//!   clips    canvas ─ clip path ─ clip path                    a coat is shown inside all clips of its chain only
//! ```

use super::along::Stroke;
use super::colour::Paint;
use super::pairing::ring_sides;
use super::rings::beside_sides;
use crate::geometry::point::corners;
use crate::plane::Point;
use std::collections::BTreeMap;

/// What a coat is for a comparison.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Part {
    /// A line that can be an edge, or one side of an outline.
    Line,
    /// A vertex.
    Dot,
    Area,
    /// Decoration: it can only hide.
    Other,
    /// A marker or a text: it can only hide, and only if it is large.
    Mark(Mark),
}

/// What stands on a line or beside it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Mark {
    Marker,
    Letters,
}

/// The place that a coat covers.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Shape {
    /// A line of this half width.
    Stroke([Point; 2], f64),
    Disc(Disc),
    Area(Area),
}

/// A circle under a transform: the points that `inverse` takes to a distance from the origin between these.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Disc {
    pub(super) centre: Point,
    pub(super) inverse: [f64; 4],
    pub(super) from: f64,
    pub(super) to: f64,
    /// How far it reaches from its centre.
    pub(super) reach: f64,
}

impl Disc {
    fn covers(&self, p: Point) -> bool {
        let (x, y) = (p.x - self.centre.x, p.y - self.centre.y);
        let [a, b, c, d] = self.inverse;
        let far = (a * x + b * y).hypot(c * x + d * y);
        (self.from..=self.to).contains(&far)
    }

    /// What its map takes to the axes of the circle of radius `to`, if it is no circle itself.
    pub(super) fn axes(&self) -> Option<[Point; 2]> {
        let [a, b, c, d] = self.inverse;
        let is_circle =
            (a * a + c * c - b * b - d * d).hypot(2.0 * (a * b + c * d)) <= 1e-6 * (a * a + b * b + c * c + d * d);
        let part = self.to / (a * d - b * c);
        (!is_circle && part.is_finite()).then(|| [Point::new(part * d, -part * c), Point::new(-part * b, part * a)])
    }
}

/// Rings with a fill rule, indexed by height.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Area {
    even_odd: bool,
    low: Point,
    high: Point,
    sides: Vec<[Point; 2]>,
    /// Sides by the bands of height that they meet; empty for few sides.
    bands: Vec<Vec<u32>>,
}

/// Areas with fewer sides have no bands.
const FEW: usize = 24;

impl Area {
    pub(super) fn new(rings: &[Vec<Point>], even_odd: bool) -> Self {
        Self::of_sides(rings.iter().flat_map(|ring| ring_sides(ring)).collect(), even_odd)
    }

    fn of_sides(sides: Vec<[Point; 2]>, even_odd: bool) -> Self {
        let [low, high] = corners(sides.iter().flatten().copied());
        let mut out = Self { even_odd, low, high, sides, bands: Vec::new() };
        if out.sides.len() >= FEW {
            // As many entries as a few times the sides, however long these are.
            let count = (out.sides.len() / 4).min(4096);
            let mut bands = vec![Vec::new(); count];
            let mut entries = 0;
            for (i, [a, b]) in out.sides.iter().enumerate() {
                let range = out.band(count, a.y.min(b.y))..=out.band(count, a.y.max(b.y));
                entries += range.clone().count();
                range.for_each(|band| bands[band].push(i as u32));
            }
            if entries <= 64 * out.sides.len() {
                out.bands = bands;
            }
        }
        out
    }

    fn band(&self, count: usize, y: f64) -> usize {
        let height = self.high.y - self.low.y;
        let part = if height > 0.0 { (y - self.low.y) / height } else { 0.0 };
        ((part * count as f64).max(0.0) as usize).min(count - 1)
    }

    /// The same with one ring more, which lies elsewhere.
    pub(super) fn with(&self, ring: &[Point]) -> Self {
        Self::of_sides(self.sides().chain(ring_sides(ring)).collect(), self.even_odd)
    }

    /// Whether a point lies inside by the fill rule, and how many sides were looked at.
    pub(super) fn covers(&self, p: Point) -> (bool, usize) {
        if p.x < self.low.x || p.y < self.low.y || p.x > self.high.x || p.y > self.high.y {
            return (false, 1);
        }
        let mut winding = 0i32;
        let mut crossings = 0u32;
        let mut cross = |&[a, b]: &[Point; 2]| {
            if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
                winding += if b.y > a.y { 1 } else { -1 };
                crossings += 1;
            }
        };
        let looked = if self.bands.is_empty() {
            self.sides.iter().for_each(&mut cross);
            self.sides.len()
        } else {
            let band = &self.bands[self.band(self.bands.len(), p.y)];
            band.iter().for_each(|&i| cross(&self.sides[i as usize]));
            band.len() + 1
        };
        (if self.even_odd { crossings % 2 == 1 } else { winding != 0 }, looked)
    }

    /// The middles of the widest stretches at some heights that lie within a ring and are covered: points well inside
    /// of both. None if nothing within the ring is covered. O(sides of the ring and of the bands at these heights).
    pub(super) fn inner_points(&self, ring: &Self) -> Vec<Point> {
        let height = ring.high.y - ring.low.y;
        let heights = [0.5, 0.31, 0.69, 0.15, 0.85, 0.06, 0.94].map(|t| ring.low.y + t * height);
        let widest = |y: f64| {
            let mut meetings: Vec<f64> = ring.meetings(y).collect();
            let [low, high] = [ring.low.x, ring.high.x];
            meetings.extend(self.meetings(y).filter(|x| (low..=high).contains(x)));
            meetings.sort_by(f64::total_cmp);
            let stretches = meetings.windows(2).map(|w| (w[1] - w[0], Point::new(0.5 * (w[0] + w[1]), y)));
            let inside = stretches.filter(|(width, p)| *width > 0.0 && ring.covers(*p).0 && self.covers(*p).0);
            inside.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, p)| p)
        };
        heights.into_iter().filter_map(widest).collect()
    }

    /// Whether a ring that is a part of it is a hole: what is painted lies just outside of one of its first sides, and
    /// nothing just inside. O(corners of the ring, and sides of some bands).
    pub(super) fn leaves_empty(&self, ring: &[Point]) -> bool {
        let mut pairs = beside_sides(ring, -1e-3).zip(beside_sides(ring, 1e-3)).take(SIDES);
        pairs.any(|(outside, inside)| self.covers(outside).0 && !self.covers(inside).0)
    }

    /// Where the sides meet a height.
    fn meetings(&self, y: f64) -> impl Iterator<Item = f64> + '_ {
        let band = match self.bands.len() {
            _ if y < self.low.y || y > self.high.y => Some(&[][..]),
            0 => None,
            count => Some(&self.bands[self.band(count, y)][..]),
        };
        let all = self.sides.iter().filter(move |_| band.is_none());
        let near = band.into_iter().flatten().map(|&i| &self.sides[i as usize]);
        let meets = move |&&[a, b]: &&[Point; 2]| (a.y > y) != (b.y > y);
        all.chain(near).filter(meets).map(move |&[a, b]| a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x))
    }

    pub(super) fn corners(&self) -> [Point; 2] {
        [self.low, self.high]
    }

    /// The sides of all rings.
    pub(super) fn sides(&self) -> impl Iterator<Item = [Point; 2]> + '_ {
        self.sides.iter().copied()
    }

    /// The corners of all rings.
    pub(super) fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.sides.iter().map(|side| side[0])
    }

    /// The shorter of the first two sides: the height of a box of letters.
    fn thickness(&self) -> f64 {
        let sides = self.sides.iter().take(2).map(|[a, b]| super::pairing::distance(*a, *b));
        sides.fold(f64::INFINITY, f64::min)
    }
}

/// So many sides of a ring are asked whether it is a hole.
const SIDES: usize = 16;
/// Less contrast than this, in steps of 255, cannot be seen of areas.
pub(super) const PALE: f64 = 4.0;
/// Markers and letters are of ordinary size up to these parts of the drawing.
const MARKER: f64 = 0.15;
const LETTERS: f64 = 0.2;

/// One thing that is painted.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Coat {
    pub(super) shape: Shape,
    pub(super) colour: [f64; 3],
    pub(super) alpha: f64,
    /// How much of a px a line is wide, if it is narrower.
    pub(super) cover: f64,
    /// The innermost clip.
    pub(super) clip: Option<u32>,
    pub(super) part: Part,
}

impl Coat {
    /// The line that it is, if it is one.
    pub(super) fn stroke(&self) -> Option<Stroke> {
        if let Shape::Stroke(ends, half) = self.shape { Some(Stroke { ends, half }) } else { None }
    }

    /// The disc that it is, if it is one.
    pub(super) fn disc(&self) -> Option<&Disc> {
        if let Shape::Disc(disc) = &self.shape { Some(disc) } else { None }
    }

    /// Whether a point is covered, clips left out, and the work that it took.
    pub(super) fn covers(&self, p: Point) -> (bool, usize) {
        match &self.shape {
            Shape::Stroke(ends, half) => (super::pairing::lies_on(p, *ends, *half), 1),
            Shape::Disc(disc) => (disc.covers(p), 1),
            Shape::Area(area) => area.covers(p),
        }
    }

    /// Whether it is a marker of ordinary size in a drawing of this size: then it hides nothing.
    pub(super) fn is_small_marker(&self, span: f64) -> bool {
        self.part == Part::Mark(Mark::Marker) && self.diameter() <= MARKER * span
    }

    /// Whether it is a text of ordinary size in a drawing of this size: then it hides nothing if it can be read.
    pub(super) fn is_small_text(&self, span: f64) -> bool {
        self.part == Part::Mark(Mark::Letters) && self.thickness() <= LETTERS * span
    }

    /// The middle of the box round it.
    pub(super) fn middle(&self) -> Point {
        super::pairing::middle(self.corners())
    }

    /// The height of letters; of anything else its diameter.
    pub(super) fn thickness(&self) -> f64 {
        match (self.part, &self.shape) {
            (Part::Mark(Mark::Letters), Shape::Area(area)) => area.thickness(),
            _ => self.diameter(),
        }
    }

    /// The diameter of the box round it.
    pub(super) fn diameter(&self) -> f64 {
        let [low, high] = self.corners();
        (high.x - low.x).hypot(high.y - low.y)
    }

    /// The corners of the box round it.
    pub(super) fn corners(&self) -> [Point; 2] {
        let around = |p: Point, by: f64| [Point::new(p.x - by, p.y - by), Point::new(p.x + by, p.y + by)];
        match &self.shape {
            Shape::Stroke([a, b], half) => [
                Point::new(a.x.min(b.x) - half, a.y.min(b.y) - half),
                Point::new(a.x.max(b.x) + half, a.y.max(b.y) + half),
            ],
            Shape::Disc(disc) => around(disc.centre, disc.reach),
            Shape::Area(area) => area.corners(),
        }
    }
}

/// How letters are painted.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Lettering {
    /// Their size in px, as the drawing is shown.
    pub(super) size: f64,
    /// The colour of the letters themselves, and how much it covers.
    pub(super) fill: Shade,
    pub(super) rim: Option<Rim>,
}

/// A colour, and how much it covers.
pub(super) type Shade = ([f64; 3], f64);

/// The rim of letters.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Rim {
    pub(super) shade: Shade,
    /// Its width as a part of the size of the letters.
    pub(super) width: f64,
    /// Whether it lies below them: a halo.
    pub(super) is_below: bool,
}

/// A region outside of which nothing is shown: all of these shapes together, within another one.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Clip {
    pub(super) areas: Vec<Area>,
    pub(super) around: Option<u32>,
    /// Whether it is the canvas of the file.
    pub(super) canvas: bool,
}

/// All coats, the lowest first, and all clips.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Painting {
    pub(super) coats: Vec<Coat>,
    pub(super) clips: Vec<Clip>,
    /// How letters are painted, by their coats.
    pub(super) lettering: BTreeMap<u32, Lettering>,
    /// Coats that leave most of their area open: hatches. Sorted.
    pub(super) sparse: Vec<u32>,
}

impl Painting {
    /// Adds a coat and returns its number.
    pub(super) fn add(&mut self, shape: Shape, paint: (Paint, f64), clip: Option<u32>, part: Part) -> u32 {
        let (colour, alpha) = shade(paint);
        self.coats.push(Coat { shape, colour, alpha, cover: 1.0, clip, part });
        self.coats.len() as u32 - 1
    }

    /// Whether a coat is white or paints nothing: clear of everything else, it cannot be told from white paper.
    pub(super) fn is_blank(&self, coat: u32) -> bool {
        let coat = &self.coats[coat as usize];
        coat.colour.iter().all(|part| coat.alpha * (255.0 - part) < PALE)
    }

    /// The innermost clip that cuts off a point.
    pub(super) fn cut_off(&self, coat: &Coat, p: Point) -> Option<&Clip> {
        let mut at = coat.clip;
        while let Some(clip) = at.map(|i| &self.clips[i as usize]) {
            if !clip.areas.iter().any(|area| area.covers(p).0) {
                return Some(clip);
            }
            at = clip.around;
        }
        None
    }
}

/// The colour of a paint, and how much it covers. A paint that is not known is one that differs from all others.
pub(super) fn shade((paint, opacity): (Paint, f64)) -> Shade {
    let (colour, alpha) = match paint {
        Paint::Colour(rgb, alpha) => (rgb.map(f64::from), alpha),
        Paint::None => ([0.0; 3], 0.0),
        Paint::Pattern | Paint::Current | Paint::Some => ([203.0, 3.0, 151.0], 1.0),
    };
    (colour, alpha * opacity)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point {
        Point::new(x, y)
    }

    #[test]
    fn areas_with_bands_cover_what_areas_without_cover() {
        let star: Vec<Point> = (0..97)
            .map(|i| {
                let (s, c) = (f64::from(i) * 38.0 * std::f64::consts::TAU / 97.0).sin_cos();
                p(10.0 * c, 10.0 * s)
            })
            .collect();
        for even_odd in [false, true] {
            let quick = Area::new(std::slice::from_ref(&star), even_odd);
            let slow = Area { bands: Vec::new(), ..quick.clone() };
            assert!(!quick.bands.is_empty());
            let mut inside = 0;
            for i in 0..60 {
                for j in 0..60 {
                    let at = p(f64::from(i) * 0.37 - 11.0, f64::from(j) * 0.37 - 11.0);
                    assert_eq!(quick.covers(at).0, slow.covers(at).0);
                    inside += usize::from(quick.covers(at).0);
                }
            }
            assert!(inside > 500);
            assert!(quick.inner_points(&quick).iter().all(|&at| slow.covers(at).0));
            assert_eq!(quick.inner_points(&slow), slow.inner_points(&slow));
        }
    }

    #[test]
    fn discs_under_transforms_are_ellipses() {
        let disc = Disc { centre: p(5.0, 0.0), inverse: [0.5, 0.0, 0.0, 1.0], from: 0.0, to: 1.0, reach: 2.0 };
        assert!(disc.covers(p(6.9, 0.0)) && !disc.covers(p(5.0, 1.1)));
    }
}
