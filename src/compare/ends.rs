//! Where lines end: at the rim of a circle, and in the middle of a straight edge.
//!
//! ```text
//!   (●)────────(●)     a line that ends within or at the rim of a circle and points to its middle ends at that vertex
//!    ●────┼─────●      two lines in one direction that meet where no circle is are one line
//! ```

use super::drawing::Line;
use super::pairing::{Places, distance, lies_on};
use super::snap::Snap;
use crate::plane::Point;
use std::collections::BTreeMap;

/// Circles looked at for all ends; what takes more stays as it is.
const WORK: usize = 20_000_000;
/// How far beside the middle of its circle a line may point, in tolerances.
const ASIDE: f64 = 4.0;
/// So many parts an edge may have.
const PARTS: usize = 64;

/// A line and its ends in the coordinates of the reference.
pub(super) type Placed = (Line, [Point; 2]);

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
    /// so. Ends at known points stay.
    pub(super) fn reach(&mut self, ends: [Point; 2], reach: f64, snap: &Snap, tolerance: f64) -> [Point; 2] {
        [0, 1].map(|i| {
            let (end, other) = (ends[i], ends[1 - i]);
            let vertex = if snap.is_known(end) { None } else { self.aimed(end, other, reach, tolerance) };
            vertex.unwrap_or(end)
        })
    }

    /// The middle of the one circle at which a line from `other` ends.
    fn aimed(&mut self, end: Point, other: Point, reach: f64, tolerance: f64) -> Option<Point> {
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

/// Joins lines that are parts of one straight edge from circle to circle: those that meet where nothing else ends, is
/// drawn or expected. `snap` knows the points of the reference and the circles. O(n log n).
pub(super) fn join(lines: &mut Vec<Placed>, snap: &Snap, tolerance: f64) {
    let mut places = Places::new(4.0 * tolerance);
    let mut meeting: Vec<Vec<(usize, usize)>> = Vec::new();
    let mut number = vec![[None; 2]; lines.len()];
    for (i, (_, ends)) in lines.iter().enumerate().filter(|(_, (line, _))| line.hidden.is_none()) {
        for (side, &end) in ends.iter().enumerate().filter(|(_, end)| !snap.is_known(**end)) {
            let place = places.near_or_add(end, tolerance) as usize;
            meeting.resize(meeting.len().max(place + 1), Vec::new());
            meeting[place].push((i, side));
            number[i][side] = Some(place);
        }
    }
    let mut gone = vec![false; lines.len()];
    for start in 0..lines.len() {
        // From a circle on, over all places where just two lines meet.
        let Some(side) = (0..2).find(|&side| number[start][side].is_none() && number[start][1 - side].is_some()) else {
            continue;
        };
        if gone[start] || lines[start].0.hidden.is_some() {
            continue;
        }
        let (mut parts, mut middles) = (vec![start], Vec::new());
        let (mut line, mut far) = (start, 1 - side);
        let last = loop {
            let Some(place) = number[line][far] else { break Some(lines[line].1[far]) };
            let &[one, two] = &meeting[place][..] else { break None };
            let (next, near) = if one == (line, far) { two } else { one };
            if parts.contains(&next) || parts.len() > PARTS {
                break None;
            }
            middles.push(lines[line].1[far]);
            parts.push(next);
            (line, far) = (next, 1 - near);
        };
        let Some(last) = last else { continue };
        let ends = [lines[start].1[side], last];
        if ends.iter().any(|&p| snap.drawn(p).is_none()) {
            continue;
        }
        let is_straight = |w: &[Point]| distance(ends[0], w[0]) < distance(ends[0], w[1]);
        let alike =
            |i: &usize| (lines[*i].0.aside, lines[*i].0.legend) == (lines[start].0.aside, lines[start].0.legend);
        if middles.iter().all(|&p| lies_on(p, ends, tolerance))
            && middles.windows(2).all(is_straight)
            && parts.iter().all(alike)
        {
            parts[1..].iter().for_each(|&i| gone[i] = true);
            number[start] = [None; 2];
            lines[start].1 = ends;
        }
    }
    let mut gone = gone.into_iter();
    lines.retain(|_| !gone.next().unwrap_or(false));
}
