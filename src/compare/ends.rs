//! Where lines end: at the middle of a circle, or at its rim.
//!
//! ```text
//!   (●)────────(●)     a line that ends within or at the rim of a circle and points to its middle ends at that vertex
//! ```
//!
//! Where another line begins at the same point, as at the corners of a polygon, none ends.

use super::pairing::{distance, key};
use super::snap::Snap;
use crate::plane::Point;
use std::collections::BTreeMap;

/// Circles looked at for all ends; what takes more stays as it is.
const WORK: usize = 20_000_000;
/// How far beside the middle of its circle a line may point, in tolerances.
const ASIDE: f64 = 4.0;

/// The middles of circles, and how far they reach.
pub(super) struct Circles {
    all: Vec<(Point, f64)>,
    /// The largest reach, which is the size of a cell.
    size: f64,
    cells: BTreeMap<(i64, i64), Vec<u32>>,
    looked: usize,
}

impl Circles {
    /// Circles by their middles and how far they reach; `tolerance` is a length that is not 0.
    pub(super) fn new(all: Vec<(Point, f64)>, tolerance: f64) -> Self {
        let size = all.iter().map(|circle| circle.1).fold(tolerance, f64::max);
        let mut out = Self { all, size, cells: BTreeMap::new(), looked: 0 };
        for (i, (at, _)) in (0..).zip(&out.all) {
            out.cells.entry(out.cell(*at)).or_default().push(i);
        }
        out
    }

    fn cell(&self, p: Point) -> (i64, i64) {
        ((p.x / self.size).floor() as i64, (p.y / self.size).floor() as i64)
    }

    /// Brings the ends of a line to the vertices at whose circles it ends: it lies within a circle, or no more than
    /// `reach` beyond its rim, short of the middle to which the line points; and within no other circle of which that is
    /// so. Ends at known points stay, and those that are not loose.
    pub(super) fn reach(
        &mut self,
        ends: [Point; 2],
        reach: f64,
        snap: &Snap,
        loose: &Loose,
        tolerance: f64,
    ) -> [Point; 2] {
        [0, 1].map(|i| {
            let (end, other) = (ends[i], ends[1 - i]);
            let stays = snap.is_known(end) || !loose.is(end);
            let vertex = if stays { None } else { self.aimed(end, other, reach, tolerance) };
            vertex.unwrap_or(end)
        })
    }

    /// The middle of the one circle at which a line from `other` ends.
    pub(super) fn aimed(&mut self, end: Point, other: Point, reach: f64, tolerance: f64) -> Option<Point> {
        if self.all.is_empty() {
            return None;
        }
        let length = distance(end, other);
        let way = Point::new((end.x - other.x) / length, (end.y - other.y) / length);
        let (x, y) = self.cell(end);
        let mut found = None;
        for cell in (x - 2..=x + 2).flat_map(|x| (y - 2..=y + 2).map(move |y| (x, y))) {
            let near = self.cells.get(&cell).map_or(&[][..], Vec::as_slice);
            self.looked += 1 + near.len();
            if self.looked > WORK {
                return None;
            }
            for &i in near {
                let (at, radius) = self.all[i as usize];
                let to = Point::new(at.x - end.x, at.y - end.y);
                let (ahead, aside) = (to.x * way.x + to.y * way.y, (to.x * way.y - to.y * way.x).abs());
                let is_within = distance(at, end) <= radius + reach && distance(at, other) > radius + reach;
                if !is_within || ahead <= 0.0 || aside > ASIDE * tolerance {
                    continue;
                }
                if found.is_some_and(|known| distance(known, at) > tolerance) {
                    return None;
                }
                found = Some(at);
            }
        }
        found
    }
}

/// The ends of lines, and whether all lines that end there run to one point: a line may be drawn twice.
#[derive(Default)]
pub(super) struct Loose(BTreeMap<[u64; 2], Option<[u64; 2]>>);

impl Loose {
    /// Takes in a line.
    pub(super) fn add(&mut self, ends: [Point; 2]) {
        let [a, b] = ends.map(key);
        for (end, other) in [(a, b), (b, a)] {
            let known = self.0.entry(end).or_insert(Some(other));
            if *known != Some(other) {
                *known = None;
            }
        }
    }

    /// Whether all lines that end at a point run to one other point.
    pub(super) fn is(&self, end: Point) -> bool {
        self.0.get(&key(end)).is_none_or(Option::is_some)
    }
}
