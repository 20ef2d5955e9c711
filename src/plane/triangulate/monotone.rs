//! Monotone pieces: a sweep from left to right that joins every corner at which a gap opens or closes.
//!
//! ```text
//!      start        end         split        merge         upper        lower      In each picture the face is
//!        ╱           ╲            ╲ : : :   : : : ╱       : : : :      ──v──       where the dots are.
//!       v : :     : : v        : : v             v : :    ──v──        : : : :
//!        ╲           ╱            ╱ : : :   : : : ╲
//! ```
//!
//! The sweep line meets a face in *gaps*, each with an edge below and an edge above. Every gap remembers its
//! *helper*, the corner at which it was last touched: the line from there to anything the sweep meets next in the
//! gap is free. A split corner is joined to the helper of the gap it lies in; a merge corner, once it is the helper,
//! to whatever touches the gap next. Then no corner opens to one side only, and the pieces are monotone.
//!
//! A corner is what is looked at, not a vertex: a vertex that a face passes several times has several corners, each of
//! a kind of its own, in gaps of their own. Likewise the free end of a dangling edge is a split or a merge corner, and an
//! isolated vertex is both at once.
//!
//! Each gap is found by its edges (`gap_of`), the sweep line is searched only where gaps open and close.
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 3.2; there for simple polygons.

use super::TriangulateError;
use super::patch::{Patch, PatchComponent};
use super::{Corner, MonotoneEvent};
use crate::geometry::both::of_both;
use crate::geometry::predicates::orientation;
use crate::plane::Point;
use crate::plane::status::{Place, Status};
use crate::progress::Stage;
use crate::topology::Observer;

const NONE: u32 = u32::MAX;

/// A stretch of the sweep line inside a face.
struct Gap {
    /// The ends of the edge below it.
    floor: [Point; 2],
    /// The half-edge below it, from left to right; `NONE` once the gap is closed.
    below: u32,
    /// The half-edge above it, from right to left.
    above: u32,
    /// The corner at which it was last touched.
    helper: u32,
    /// Whether that was a merge corner, or an isolated vertex.
    merge: bool,
}

struct Sweep<'a, O> {
    patch: &'a mut Patch,
    observer: &'a mut O,
    gaps: Vec<Gap>,
    /// The gap of each half-edge given that the sweep line cuts.
    gap_of: Vec<u32>,
    status: Status,
    /// Where the present vertex is on the sweep line, once that was looked for: what opens and closes there does not
    /// change it before all is settled.
    found: Option<Place>,
    /// The gaps that open at the present vertex, and how many close there.
    opened: Vec<u32>,
    closed: usize,
}

/// Cuts all faces of the patch into monotone pieces. Inner components are joined on the way. O(n log n).
///
/// # Errors
/// [`TriangulateError::NotPlanar`] where edges do not come in the order they should.
pub(super) fn split(patch: &mut Patch, observer: &mut impl Observer<MonotoneEvent>) -> Result<(), TriangulateError> {
    let events = std::mem::take(&mut patch.events);
    if patch.is_monotone && is_one_piece(patch, &events, observer) {
        return Ok(());
    }
    let given = patch.given();
    let gap_of = vec![NONE; given as usize];
    let (gaps, opened) = (Vec::new(), Vec::new());
    let mut sweep = Sweep { patch, observer, gaps, gap_of, status: Status::default(), found: None, opened, closed: 0 };
    let (mut here, mut last) = (0, 0);
    let stage = Stage::new("triangulating", events.len());
    for (number, &event) in events.iter().enumerate() {
        stage.at(number);
        let ring = event.checked_sub(given);
        let place = ring.map_or_else(|| sweep.patch.origin(event), |ring| sweep.patch.place_of(ring));
        if place != here {
            sweep.settle(last)?;
            here = place;
        }
        match ring {
            None => {
                sweep.corner(event)?;
                last = event;
            }
            Some(ring) => sweep.isolated(ring)?,
        }
    }
    sweep.settle(last)
}

/// Whether a face that runs to the right and back just once has its inside between both rows; then no gap opens or
/// closes but at the ends, and nothing is left to be joined. Tells the corners.
fn is_one_piece(patch: &Patch, events: &[u32], observer: &mut impl Observer<MonotoneEvent>) -> bool {
    let [start, between @ .., end] = events else { return false };
    if !patch.turn(*start).is_gt() || !patch.turn(*end).is_gt() {
        return false;
    }
    let at = |h: u32| patch.vertex(patch.origin(h));
    observer.observe(|| MonotoneEvent::Corner { at: at(*start), corner: Corner::Start });
    for &h in between {
        observer.observe(|| {
            let is_lower = patch.origin(patch.prev(h)) < patch.origin(h);
            MonotoneEvent::Corner { at: at(h), corner: if is_lower { Corner::Lower } else { Corner::Upper } }
        });
    }
    observer.observe(|| MonotoneEvent::Corner { at: at(*end), corner: Corner::End });
    true
}

impl<O: Observer<MonotoneEvent>> Sweep<'_, O> {
    /// Takes the sweep line over the corner of `h`.
    fn corner(&mut self, h: u32) -> Result<(), TriangulateError> {
        let (before, here, after) = (self.patch.prev(h), self.patch.origin(h), self.patch.next(h));
        let corner = match (self.patch.origin(before) < here, self.patch.origin(after) < here) {
            (true, false) => Corner::Lower,
            (false, true) => Corner::Upper,
            (true, true) if self.patch.turn(h).is_gt() => Corner::End,
            (true, true) => Corner::Merge,
            (false, false) if self.patch.turn(h).is_gt() => Corner::Start,
            (false, false) => Corner::Split,
        };
        self.observer.observe(|| MonotoneEvent::Corner { at: self.patch.vertex(here), corner });
        match corner {
            Corner::Lower => self.on_floor(before, h),
            Corner::Upper => self.on_ceiling(before, h),
            Corner::End => self.end(before, h),
            Corner::Merge => self.merge(before, h),
            Corner::Split => self.split(before, h),
            Corner::Start | Corner::Isolated => {
                self.open(h, before, h);
                Ok(())
            }
        }
    }

    /// Joins the corner of `h` to the helper, and tells of it; returns the half-edge that leaves the corner of `h`.
    fn join(&mut self, h: u32, helper: u32) -> u32 {
        self.observer.observe(|| {
            let [from, to] = of_both([h, helper], |h| self.patch.vertex(self.patch.origin(h)));
            MonotoneEvent::Diagonal { from, to }
        });
        self.patch.join(h, helper)
    }

    /// The gap with the half-edge `g` below it.
    fn gap_above(&self, g: u32) -> Result<usize, TriangulateError> {
        let gap = self.gap_of.get(g as usize).copied().unwrap_or(NONE) as usize;
        let fits = self.gaps.get(gap).is_some_and(|gap| gap.below == g);
        if fits { Ok(gap) } else { Err(self.patch.fault(g)) }
    }

    /// The gap with the half-edge `g` above it.
    fn gap_below(&self, g: u32) -> Result<usize, TriangulateError> {
        let gap = self.gap_of.get(g as usize).copied().unwrap_or(NONE) as usize;
        let fits = self.gaps.get(gap).is_some_and(|gap| gap.above == g && gap.below != NONE);
        if fits { Ok(gap) } else { Err(self.patch.fault(g)) }
    }

    /// The edge below a gap goes on in `h`.
    fn on_floor(&mut self, before: u32, h: u32) -> Result<(), TriangulateError> {
        let gap = self.gap_above(before)?;
        self.join_merge(gap, h);
        let floor = [self.patch.point(h), self.patch.point(self.patch.next(h))];
        self.gaps[gap] = Gap { floor, below: h, helper: h, merge: false, ..self.gaps[gap] };
        self.gap_of[h as usize] = gap as u32;
        Ok(())
    }

    /// The edge above a gap, `h`, goes on in `before`.
    fn on_ceiling(&mut self, before: u32, h: u32) -> Result<(), TriangulateError> {
        let gap = self.gap_below(h)?;
        let helper = self.join_merge(gap, h).unwrap_or(h);
        self.gaps[gap] = Gap { above: before, helper, merge: false, ..self.gaps[gap] };
        self.gap_of[before as usize] = gap as u32;
        Ok(())
    }

    fn end(&mut self, before: u32, h: u32) -> Result<(), TriangulateError> {
        let gap = self.gap_above(before)?;
        if self.gaps[gap].above != h {
            return Err(self.patch.fault(h));
        }
        self.join_merge(gap, h);
        self.close(gap);
        Ok(())
    }

    /// The gap above the corner and the one below it become one.
    fn merge(&mut self, before: u32, h: u32) -> Result<(), TriangulateError> {
        let (upper, lower) = (self.gap_above(before)?, self.gap_below(h)?);
        if upper == lower {
            return Err(self.patch.fault(h));
        }
        self.join_merge(upper, h);
        let helper = self.join_merge(lower, h).unwrap_or(h);
        let above = self.gaps[upper].above;
        self.gaps[lower] = Gap { above, helper, merge: true, ..self.gaps[lower] };
        self.gap_of[above as usize] = lower as u32;
        self.close(upper);
        Ok(())
    }

    /// The gap around the corner falls into two.
    fn split(&mut self, before: u32, h: u32) -> Result<(), TriangulateError> {
        let gap = self.gap_around(self.patch.point(h)).ok_or_else(|| self.patch.fault(h))?;
        let Gap { helper, above, .. } = self.gaps[gap];
        if self.patch.face(helper) != self.patch.face(h) {
            return Err(self.patch.fault(h));
        }
        let helper = self.join(h, helper);
        self.gaps[gap] = Gap { above: before, helper, merge: false, ..self.gaps[gap] };
        self.gap_of[before as usize] = gap as u32;
        self.open(h, above, h);
        Ok(())
    }

    /// An isolated vertex: joined to the left now, and to the right as if it were a merge corner.
    fn isolated(&mut self, ring: u32) -> Result<(), TriangulateError> {
        let PatchComponent::Isolated(place, face) = self.patch.rings[ring as usize] else { return Ok(()) };
        let gap = self.gap_around(self.patch.points[place as usize]);
        let gap = gap.filter(|&gap| self.patch.face(self.gaps[gap].helper) == face);
        let gap = gap.ok_or_else(|| self.patch.fault_at(place, face))?;
        let helper = self.gaps[gap].helper;
        let at = self.patch.vertex(place);
        self.observer.observe(|| MonotoneEvent::Corner { at, corner: Corner::Isolated });
        let to = self.patch.vertex(self.patch.origin(helper));
        self.observer.observe(|| MonotoneEvent::Diagonal { from: at, to });
        let helper = self.patch.join_isolated(place, helper);
        self.gaps[gap] = Gap { helper, merge: true, ..self.gaps[gap] };
        Ok(())
    }

    /// If the helper of the gap is a merge corner, joins the corner of `h` to it; returns the half-edge that leaves
    /// the corner of `h`.
    fn join_merge(&mut self, gap: usize, h: u32) -> Option<u32> {
        let Gap { helper, merge, .. } = self.gaps[gap];
        merge.then(|| self.join(h, helper))
    }

    /// Opens a gap between two edges.
    fn open(&mut self, below: u32, above: u32, helper: u32) {
        let gap = self.gaps.len() as u32;
        let floor = [self.patch.point(below), self.patch.point(self.patch.next(below))];
        self.gaps.push(Gap { floor, below, above, helper, merge: false });
        self.gap_of[below as usize] = gap;
        self.gap_of[above as usize] = gap;
        self.opened.push(gap);
    }

    fn close(&mut self, gap: usize) {
        self.gaps[gap].below = NONE;
        self.closed += 1;
    }

    /// Where on the sweep line the gaps begin whose floor is not below the present vertex, which is at `p`.
    fn search(&mut self, p: Point) -> Place {
        let (status, gaps) = (&self.status, &self.gaps);
        *self.found.get_or_insert_with(|| {
            status.partition(|gap| {
                let [a, b] = gaps[gap as usize].floor;
                orientation(a, b, p).is_gt()
            })
        })
    }

    /// The gap with the present vertex in it, which is at `p`.
    fn gap_around(&mut self, p: Point) -> Option<usize> {
        let place = self.search(p);
        self.status.before(place).map(|gap| gap as usize)
    }

    /// Brings the sweep line up to date when all corners of a vertex are done; `h` leaves it.
    fn settle(&mut self, h: u32) -> Result<(), TriangulateError> {
        if self.closed == 0 && self.opened.is_empty() {
            self.found = None;
            return Ok(());
        }
        let here = self.patch.point(h);
        let mut at = self.search(here);
        self.found = None;
        while self.closed > 0 {
            // All gaps that close here follow each other.
            let closes = |&gap: &u32| self.gaps[gap as usize].below == NONE;
            if self.status.get(at).filter(closes).is_none() {
                return Err(self.patch.fault(h));
            }
            self.status.remove(&mut at);
            self.closed -= 1;
        }
        if self.opened.len() > 1 {
            let far = |gap: u32| self.gaps[gap as usize].floor[1];
            self.opened.sort_unstable_by(|&e, &g| orientation(here, far(g), far(e)).then(e.cmp(&g)));
        }
        self.status.insert(at, &self.opened);
        self.opened.clear();
        Ok(())
    }
}
