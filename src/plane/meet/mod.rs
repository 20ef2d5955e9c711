//! All intersections of straight edges, found by one sweep with exact decisions.
//!
//! ```text
//!          ╲   ╱            Event points are the vertices and all crossings.       Below it the edges are kept
//!     ──────╲─╱──── e3      from bottom to top; at an event point those through it turn round. Only neighbours can
//!            ●              cross next, and a crossing that is known waits in a heap, in its exact place: it is
//!           ╱ ╲             never rounded on the way.
//!        e1╱   ╲e2
//! ```
//!
//! Cost: O((n + k) log n) for n edges and k event points, plus telling what the edges through each of them are. Exact
//! arithmetic is used only where intervals cannot tell.
//!
//! Source: Bentley and Ottmann, *Algorithms for reporting and counting geometric intersections*, 1979; the handling
//! of many edges through one point as in de Berg et al., *Computational Geometry*, 3rd ed., section 2.1.
//!
//! ```text
//!   cells.rs   All pairs of edges that meet, found in the cells of a grid
//!   gap.rs     A distance beside which rounding is small
//!   grid.rs    A square grid whose points, and whose lines between pixels, are doubles
//!   raster.rs  The cells of a grid, and which of them an edge passes
//! ```

mod cells;
mod crossing;
mod gap;
mod grid;
mod raster;

use super::Point;
use super::status::Status;
use super::sweep::rightwards;
use crate::geometry::both::of_both;
pub(crate) use crate::geometry::expansion::{Expansion, cross};
use crate::geometry::grouping::grouped;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::progress::Stage;
use crate::topology::{NoObserver, Observer};
pub(super) use cells::{Meetings, NoMeetings, meetings};
use crossing::Crossing;
pub(super) use crossing::{crossing_from, foot_from, is_moved, placed};
pub(super) use gap::Gap;
pub(super) use grid::Grid;
pub(super) use raster::{Cells, Frame, MARGIN};
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;
use std::ops::ControlFlow;

/// Where an event point lies.
#[derive(Clone, Copy)]
pub(super) enum EventPlace<'a> {
    /// At a point of the input.
    Vertex(u32),
    /// Where edges cross and no point is.
    Crossing(&'a Crossed),
}

/// Where two segments cross, without rounding.
pub(crate) struct Crossed(Crossing);

impl Crossed {
    /// The crossing of two segments, which must cross in a point interior to both.
    pub(crate) fn new(one: [Point; 2], other: [Point; 2]) -> Self {
        Self(Crossing::new([0, 1], [one, other]))
    }

    /// The nearest point with doubles as coordinates, and how far it is from the crossing.
    pub(crate) fn rounded(&self) -> (Point, f64) {
        self.0.rounded()
    }

    /// The point of the grid in whose pixel it lies, and how far off that is at most; see [`Grid`].
    pub(super) fn on_grid(&self, grid: Grid) -> (Point, f64) {
        self.0.on_grid(grid)
    }

    /// Where it lies from a point in the order from left to right. Exact.
    pub(super) fn order_to_point(&self, p: Point) -> Ordering {
        self.0.order_to_point(p)
    }

    /// Where it lies from another crossing in the order from left to right. Exact.
    pub(super) fn order_to(&self, other: &Self) -> Ordering {
        self.0.order_to(&other.0)
    }
}

/// An event point at which edges meet that should not: edges pass through, or start in the same direction.
pub(super) struct EventPoint<'a> {
    pub(super) place: EventPlace<'a>,
    /// The edges with this point in their interior.
    pub(super) through: &'a [u32],
    /// The edges that end here, as the sweep goes.
    pub(super) ending: &'a [u32],
    /// The edges that start here, in the order of their directions from bottom to top.
    pub(super) starting: &'a [u32],
}

/// What the sweep over segments does at an event point. Segments are told by their numbers; the lists run from bottom to
/// top.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepEvent {
    /// The event point, of a crossing the nearest doubles.
    pub at: Point,
    /// Whether it is a crossing at which no segment ends.
    pub is_crossing: bool,
    /// The segments that end here.
    pub ending: Vec<u32>,
    /// Those that pass through and turn round, as they were before.
    pub through: Vec<u32>,
    /// Those that start here.
    pub starting: Vec<u32>,
    /// The segments that the sweep line cuts just after the event point.
    pub status: Vec<u32>,
    /// The crossings that are known and wait, in no order.
    pub expected: Vec<Point>,
}

/// An edge in the heap's order: the leftmost crossing first.
struct Waiting(Crossed);

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.order_to(&other.0)
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

/// Calls `visit` for every event point at which edges meet that should not, from left to right, until it breaks off.
///
/// `by_place` holds all points from left to right; they are distinct. Edges have two different ends, no two the same
/// ones.
pub(super) fn visit_intersections(
    points: &[Point],
    edges: &[[u32; 2]],
    by_place: &[u32],
    visit: impl FnMut(&EventPoint<'_>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    sweep_observed(points, edges, by_place, visit, &mut NoObserver)
}

/// The same, watched.
pub(super) fn sweep_observed(
    points: &[Point],
    edges: &[[u32; 2]],
    by_place: &[u32],
    mut visit: impl FnMut(&EventPoint<'_>) -> ControlFlow<()>,
    observer: &mut impl Observer<SweepEvent>,
) -> ControlFlow<()> {
    let edges = rightwards(points, edges);
    let (firsts, starts) = grouped(points.len(), edges.len(), |e| edges[e][0] as usize);
    let status = Status::default();
    let mut sweep = Sweep { points, edges: &edges, status, heap: BinaryHeap::new(), lists: Lists::default(), observer };
    let mut vertices = by_place.iter().copied().enumerate().peekable();
    let stage = Stage::new("looking for crossings", by_place.len());
    loop {
        let vertex = vertices.peek().map(|&(number, v)| {
            stage.at(number);
            v
        });
        // A crossing at a vertex is part of the event point at the vertex.
        let first = match (vertex, sweep.heap.peek()) {
            (None, None) => return ControlFlow::Continue(()),
            (None, Some(_)) => Ordering::Less,
            (Some(_), None) => Ordering::Greater,
            (Some(v), Some(Reverse(waiting))) => waiting.0.order_to_point(points[v as usize]),
        };
        let crossing = if first.is_gt() { None } else { sweep.pop_crossing() };
        match (crossing, vertex) {
            (Some(crossing), _) if first.is_lt() => sweep.event(&EventPlace::Crossing(&crossing), &[], &mut visit)?,
            (_, Some(v)) => {
                vertices.next();
                let starting = firsts[v as usize] as usize..firsts[v as usize + 1] as usize;
                sweep.event(&EventPlace::Vertex(v), &starts[starting], &mut visit)?;
            }
            (_, None) => {}
        }
    }
}

struct Sweep<'a, O> {
    points: &'a [Point],
    edges: &'a [[u32; 2]],
    observer: &'a mut O,
    status: Status,
    heap: BinaryHeap<Reverse<Waiting>>,
    lists: Lists,
}

/// The edges at an event point, kept between events so that none of them has to make lists.
#[derive(Default)]
struct Lists {
    through: Vec<u32>,
    ending: Vec<u32>,
    leaving: Vec<u32>,
    starting: Vec<u32>,
}

impl Lists {
    fn clear(&mut self) {
        [&mut self.through, &mut self.ending, &mut self.leaving, &mut self.starting].into_iter().for_each(Vec::clear);
    }
}

impl<O: Observer<SweepEvent>> Sweep<'_, O> {
    /// Takes the first crossing out of the heap, with all others at the same place.
    fn pop_crossing(&mut self) -> Option<Crossed> {
        let Reverse(Waiting(first)) = self.heap.pop()?;
        while let Some(Reverse(next)) = self.heap.peek() {
            if first.order_to(&next.0).is_lt() {
                break;
            }
            self.heap.pop();
        }
        Some(first)
    }

    fn ends(&self, edge: u32) -> [Point; 2] {
        of_both(self.edges[edge as usize], |p| self.points[p as usize])
    }

    /// Where the event point lies from the edge: `Greater` = above.
    fn side(&self, edge: u32, place: &EventPlace<'_>) -> Ordering {
        let [a, b] = self.ends(edge);
        match *place {
            EventPlace::Vertex(v) => orientation(a, b, self.points[v as usize]),
            EventPlace::Crossing(Crossed(crossing)) if crossing.edges.contains(&edge) => Ordering::Equal,
            EventPlace::Crossing(Crossed(crossing)) => crossing.side(a, b),
        }
    }

    fn event(
        &mut self,
        place: &EventPlace<'_>,
        starting: &[u32],
        visit: &mut impl FnMut(&EventPoint<'_>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut lists = std::mem::take(&mut self.lists);
        lists.clear();
        let flow = self.event_with(&mut lists, place, starting, visit);
        self.lists = lists;
        flow
    }

    fn event_with(
        &mut self,
        Lists { through, ending, leaving, starting }: &mut Lists,
        place: &EventPlace<'_>,
        starts: &[u32],
        visit: &mut impl FnMut(&EventPoint<'_>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut at = self.status.partition(|edge| self.side(edge, place).is_gt());
        let below = self.status.before(at);
        while let Some(edge) = self.status.get(at).filter(|&edge| self.side(edge, place).is_eq()) {
            let ends_here = matches!(place, EventPlace::Vertex(v) if self.edges[edge as usize][1] == *v);
            if ends_here {
                ending.push(edge);
            } else {
                through.push(edge);
            }
            self.status.remove(&mut at);
        }
        match *place {
            EventPlace::Crossing(_) => leaving.extend(through.iter().rev()),
            EventPlace::Vertex(v) => {
                leaving.extend(starts.iter().chain(&*through));
                self.by_direction(v, leaving);
                starting.extend(leaving.iter().filter(|&&edge| self.edges[edge as usize][0] == v));
            }
        }
        let above = self.status.get(at);
        self.status.insert(at, leaving);
        match (leaving.first(), leaving.last()) {
            (Some(&lowest), Some(&highest)) => {
                self.expect(below, Some(lowest));
                self.expect(Some(highest), above);
            }
            _ => self.expect(below, above),
        }
        self.observer.observe(|| SweepEvent {
            at: match *place {
                EventPlace::Vertex(v) => self.points[v as usize],
                EventPlace::Crossing(crossing) => crossing.rounded().0,
            },
            is_crossing: matches!(place, EventPlace::Crossing(_)),
            ending: ending.clone(),
            through: through.clone(),
            starting: starting.clone(),
            status: self.status.all().collect(),
            expected: self.heap.iter().map(|Reverse(Waiting(crossing))| crossing.rounded().0).collect(),
        });
        if through.is_empty() && !self.overlap(place, starting) {
            return ControlFlow::Continue(());
        }
        visit(&EventPoint { place: *place, through, ending, starting })
    }

    /// Edges through or from a vertex, from bottom to top just after it.
    fn by_direction(&self, v: u32, edges: &mut [u32]) {
        let here = self.points[v as usize];
        let far = |edge: u32| self.ends(edge)[1];
        edges.sort_unstable_by(|&e, &g| orientation(here, far(g), far(e)).then(e.cmp(&g)));
    }

    /// Whether two of the edges that start at the event point run in the same direction.
    fn overlap(&self, place: &EventPlace<'_>, starting: &[u32]) -> bool {
        let EventPlace::Vertex(v) = *place else { return false };
        starting.windows(2).any(|pair| same_direction(self.points, self.edges, v, pair[0], pair[1]))
    }

    /// Puts the crossing of two new neighbours into the heap, if they have one to the right of the sweep line.
    fn expect(&mut self, lower: Option<u32>, upper: Option<u32>) {
        let (Some(e), Some(g)) = (lower, upper) else { return };
        let ([a, b], [c, d]) = (self.ends(e), self.ends(g));
        let crosses = match left_to_right(b, d) {
            Ordering::Less => orientation(c, d, b).is_gt(),
            Ordering::Greater => orientation(a, b, d).is_lt(),
            Ordering::Equal => false,
        };
        if crosses {
            let (edges, ends) = if e < g { ([e, g], [[a, b], [c, d]]) } else { ([g, e], [[c, d], [a, b]]) };
            self.heap.push(Reverse(Waiting(Crossed(Crossing::new(edges, ends)))));
        }
    }
}

/// Whether two edges, both through or from the vertex `v`, leave it in the same direction; both run to the right.
pub(super) fn same_direction(points: &[Point], edges: &[[u32; 2]], v: u32, e: u32, g: u32) -> bool {
    let far = |edge: u32| points[edges[edge as usize][1] as usize];
    orientation(points[v as usize], far(e), far(g)).is_eq()
}
