//! Leader lines: a face that is too small for its label has it outside, at the end of a thin line.
//!
//! ```text
//!   ┌──┬────┐
//!   │  │  ∘─┼──── f7        From a dot inside the face along one of 36 directions, as short as possible. The
//!   │  └────┤               line crosses no label, no disc and no other leader line, and as few edges and
//!   └───────┘               shafts as it can; the label stands outside of all bounded faces.
//! ```
//!
//! If there is no such place, or if so many faces lack room that the lines would be a thicket, the label is left
//! out and the tooltip remains.

use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::vector::{Bounds, Xy, doubled_area, xy};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::layout::pole::pole;
use crate::figure::structure::captions::{Caption, Label};
use crate::figure::structure::faces::Region;

/// More labels than this are not led out: the lines would hide the figure.
pub(crate) const MOST: usize = 24;
/// The longest line, and the longest of a label that finds no place that near.
const REACHES: [f64; 2] = [170.0, 300.0];
/// So many of the nearest leaders are asked to make way for one without a place.
const NEAREST: usize = 6;
/// So many labels without a place are given a second look: each costs some ten thousand candidates.
const TRIED: usize = 4;
/// So many of them are moved at once.
const MOVED: usize = 3;
/// The lengths tried are multiples of this.
const STEP: f64 = 8.0;
/// A line that crosses an edge or a shaft counts as this much longer.
const CROSSING: f64 = 12.0;
/// The labels are placed one after the other, and then again, now that each knows the others.
const ROUNDS: usize = 3;
/// Distance between a label and its line.
const BESIDE: f64 = 3.0;
/// Free space round a label that stands alone.
const AIR: f64 = 3.0;
/// A name longer than this is shortened at the end of a leader line.
const LONGEST: usize = 28;
/// A face smaller than this, in square px, is no place a line could begin.
const SMALLEST: f64 = 0.5;

/// The directions in the lower half of a quadrant, as whole sides of a triangle and its long side.
const SLOPES: [(f64, f64, f64); 5] =
    [(1.0, 0.0, 1.0), (24.0, 7.0, 25.0), (12.0, 5.0, 13.0), (15.0, 8.0, 17.0), (4.0, 3.0, 5.0)];

/// Further ones, for labels that find no place otherwise.
const FINER: [(f64, f64, f64); 6] = [
    (60.0, 11.0, 61.0),
    (40.0, 9.0, 41.0),
    (63.0, 16.0, 65.0),
    (35.0, 12.0, 37.0),
    (45.0, 28.0, 53.0),
    (21.0, 20.0, 29.0),
];

/// Where a label is looked for.
#[derive(Clone, Copy)]
struct Ways<'a> {
    slopes: &'a [&'a [(f64, f64, f64)]],
    /// The longest line.
    reach: f64,
}

/// A label at the end of a line.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Leader {
    /// In the face.
    root: Xy,
    /// Beside the label.
    end: Xy,
    pub(crate) label: Label,
}

impl Leader {
    /// The line, the dot in the face and the text; to be drawn above everything else.
    pub(crate) fn group(&self, id: String) -> Node {
        let line = Node::Line { class: "leader", from: self.root, to: self.end };
        let dot = Node::Disc { class: "root", centre: self.root, radius: 1.6 };
        let nodes = [line, dot].into_iter().chain(self.label.nodes("ll")).collect();
        Node::Group(Group { class: "lead", id: Some(id), nodes, ..Group::default() })
    }

    /// Whether the two cannot be drawn both.
    fn meets(&self, leader: &Self) -> bool {
        let (own, bounds) = (self.label.bounds().grown(AIR), leader.label.bounds());
        own.overlaps(&bounds)
            || own.meets_segment(leader.root, leader.end)
            || Shape::Segment(self.root, self.end, 0.5).meets(&bounds.grown(AIR))
            || cross((leader.root, leader.end), (self.root, self.end))
    }
}

/// Where labels of faces that have none yet may stand.
pub(crate) struct Search<'a> {
    /// All regions of the figure.
    pub(crate) regions: &'a [Region],
    /// Whether a region is part of the drawing, so that labels of others do not stand in it.
    pub(crate) is_taken: &'a dyn Fn(&Region) -> bool,
    pub(crate) size: f64,
    pub(crate) canvas: Bounds,
}

impl Search<'_> {
    /// One leader for each wanted caption that finds a place; `wanted` holds indices of regions. The labels join
    /// the crowd.
    /// O(wanted · candidates), some 800 candidates each, and some ten times as many for the few that need a second look.
    pub(crate) fn place(&self, wanted: &[(usize, &Caption)], crowd: &mut Crowd) -> Vec<(usize, Leader)> {
        if wanted.len() > MOST {
            return Vec::new();
        }
        let root =
            |&(i, caption): &(usize, &Caption)| Some((i, self.root(&self.regions[i])?, caption.shortened(LONGEST)));
        let wanted: Vec<(usize, Xy, Caption)> = wanted.iter().filter_map(root).collect();
        let mut out: Vec<Option<Leader>> = vec![None; wanted.len()];
        for _ in 0..ROUNDS {
            for (k, (_, root, caption)) in wanted.iter().enumerate() {
                out[k] = None;
                out[k] = self.best(*root, caption, &out, crowd, Ways { slopes: &[&SLOPES], reach: REACHES[0] });
            }
        }
        let without: Vec<usize> = (0..wanted.len()).filter(|&k| out[k].is_none()).take(TRIED).collect();
        for k in without {
            self.make_way(k, &wanted, &mut out, crowd);
        }
        let placed = wanted.iter().zip(out).filter_map(|(&(i, ..), leader)| Some((i, leader?)));
        let placed: Vec<(usize, Leader)> = placed.collect();
        crowd.add_all(placed.iter().map(|(_, leader)| Shape::Box(leader.label.bounds())), u32::MAX);
        placed
    }

    /// Places a label that has found no place: further away, or where one, two or three of its neighbours stand that have
    /// places elsewhere. Nothing is tried if it had no place even without any of them.
    fn make_way(&self, k: usize, wanted: &[(usize, Xy, Caption)], out: &mut Vec<Option<Leader>>, crowd: &Crowd) {
        let distance = |j: usize| (wanted[j].1 - wanted[k].1).length();
        let mut others: Vec<usize> = (0..wanted.len()).filter(|&j| out[j].is_some()).collect();
        others.sort_by(|&i, &j| distance(i).total_cmp(&distance(j)));
        others.truncate(NEAREST);
        let mut sets: Vec<Vec<usize>> = (0..1_u32 << others.len())
            .map(|set| (0..others.len()).filter(|i| set >> i & 1 == 1).map(|i| others[i]).collect())
            .filter(|set: &Vec<usize>| set.len() <= MOVED)
            .collect();
        sets.sort_by_key(Vec::len);
        for reach in REACHES {
            let ways = Ways { slopes: &[&SLOPES, &FINER], reach };
            let best = |j: usize, out: &[Option<Leader>]| self.best(wanted[j].1, &wanted[j].2, out, crowd, ways);
            let mut alone = out.clone();
            others.iter().for_each(|&j| alone[j] = None);
            if best(k, &alone).is_none() {
                continue;
            }
            for set in &sets {
                let mut moved = out.clone();
                set.iter().for_each(|&j| moved[j] = None);
                // From top to bottom, so that the lines of a column of labels do not cross.
                let mut order: Vec<usize> = set.iter().copied().chain([k]).collect();
                order.sort_by(|&i, &j| wanted[i].1.y.total_cmp(&wanted[j].1.y));
                if order.iter().all(|&j| {
                    moved[j] = best(j, &moved);
                    moved[j].is_some()
                }) {
                    *out = moved;
                    return;
                }
            }
        }
    }

    /// A point well inside a region that can be seen.
    fn root(&self, region: &Region) -> Option<Xy> {
        let area: f64 = region.rings.iter().map(|ring| doubled_area(ring)).sum();
        let at = pole(&region.coarse(0.5).rings, &[], 1.0, 8.0)?.at;
        (0.5 * area.abs() >= SMALLEST && self.canvas.contains(&Bounds { min: at, max: at })).then_some(at)
    }

    /// The cheapest place round `root`.
    fn best(
        &self,
        root: Xy,
        caption: &Caption,
        placed: &[Option<Leader>],
        crowd: &Crowd,
        ways: Ways<'_>,
    ) -> Option<Leader> {
        let mut best: Option<(f64, Leader)> = None;
        for way in ways.slopes.iter().flat_map(|slopes| directions(slopes)) {
            let mut length = 2.0 * STEP;
            while length <= ways.reach {
                if best.as_ref().is_some_and(|(cost, _)| *cost <= length) {
                    break;
                }
                let leader = self.candidate(root, way, length, caption);
                if let Some(cost) = self.cost(&leader, placed, crowd)
                    && best.as_ref().is_none_or(|(least, _)| cost < *least)
                {
                    best = Some((cost, leader));
                }
                length += STEP;
            }
        }
        best.map(|(_, leader)| leader)
    }

    /// The label beside the end of a line of this length, or above or below it if the line is steep.
    fn candidate(&self, root: Xy, way: Xy, length: f64, caption: &Caption) -> Leader {
        let end = root + way * length;
        let size = self.size;
        let half = caption.half(size);
        let aside = if way.x.abs() > 0.5 {
            xy((half.x + BESIDE).copysign(way.x), 0.0)
        } else {
            xy(0.0, (half.y + BESIDE).copysign(way.y))
        };
        Leader { root, end, label: caption.at(end + aside, size) }
    }

    /// Length and crossings; `None` if something is in the way.
    fn cost(&self, leader: &Leader, placed: &[Option<Leader>], crowd: &Crowd) -> Option<f64> {
        let bounds = leader.label.bounds();
        if !self.canvas.contains(&bounds) || crowd.blocker(&bounds.grown(AIR)).is_some() {
            return None;
        }
        let line = Shape::Segment(leader.root, leader.end, 0.5);
        if placed.iter().flatten().any(|other| other.meets(leader)) || line.meets(&bounds) {
            return None;
        }
        let inside = |region: &&Region| (self.is_taken)(region) && region.contains(bounds.centre());
        if self.regions.iter().any(|region| inside(&region)) {
            return None;
        }
        let crossings = crowd.crossings(leader.root, leader.end)?;
        Some((leader.end - leader.root).length() + CROSSING * crossings as f64)
    }
}

/// Whether two segments cross.
fn cross((a, b): (Xy, Xy), (p, q): (Xy, Xy)) -> bool {
    let sides = |a: Xy, b: Xy, p: Xy, q: Xy| (b - a).turn(p - a) * (b - a).turn(q - a) <= 0.0;
    sides(a, b, p, q) && sides(p, q, a, b)
}

/// To the right and left first.
fn directions(slopes: &[(f64, f64, f64)]) -> impl Iterator<Item = Xy> {
    let quadrants = [(1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let upper = slopes.iter().rev().map(|&(x, y, length)| (y, x, length));
    slopes
        .iter()
        .copied()
        .chain(upper)
        .flat_map(move |(x, y, length)| quadrants.map(|(sx, sy)| xy(sx * x / length, sy * y / length)))
}
