//! The sweep that finds where segments cross, for who watches it.

use super::graph::{Distinct, Graph};
use super::{SegmentsError, check_points};
use crate::plane::Point;
use crate::plane::meet::{SweepEvent, sweep_observed};
use crate::topology::Observer;
use std::ops::ControlFlow;

/// The sweep that finds where segments cross, watched: its event points from left to right. Segments are numbered as they
/// are given; those without length are event points only, of equal ones the first takes part.
///
/// This is the sweep with which [`arrange_segments`](crate::plane::Subdivision::arrange_segments) splits segments where cells
/// of a grid do not do.
///
/// Cost: O((n + k) log n) besides what the observer does.
///
/// Source: Bentley and Ottmann, *Algorithms for reporting and counting geometric intersections*, 1979.
///
/// # Errors
/// [`SegmentsError`]: what is no number, or out of range, or too much.
///
/// ```
/// use dcel_kit::plane::{Point, sweep_segments_observed};
/// let segment = |x0, y0, x1, y1| [Point::new(x0, y0), Point::new(x1, y1)];
/// let mut events = Vec::new();
/// sweep_segments_observed(&[segment(0., 0., 4., 2.), segment(0., 2., 4., 0.)], &mut events)?;
/// assert_eq!(events.len(), 5);
/// assert!(events[2].is_crossing && events[2].at == Point::new(2., 1.));
/// # Ok::<(), dcel_kit::plane::SegmentsError>(())
/// ```
pub fn sweep_segments_observed(
    segments: &[[Point; 2]],
    observer: &mut impl Observer<SweepEvent>,
) -> Result<(), SegmentsError> {
    check_points(segments.as_flattened())?;
    let Distinct { points, number, order } = Distinct::new(segments.as_flattened());
    // A segment that is given twice, or has no length, is left out; the others keep their numbers by this list.
    let mut ends: Vec<([u32; 2], u32)> = Vec::with_capacity(segments.len());
    for (segment, pair) in (0..).zip(number.chunks_exact(2)) {
        if pair[0] != pair[1] {
            ends.push(([pair[0].min(pair[1]), pair[0].max(pair[1])], segment));
        }
    }
    ends.sort_unstable();
    ends.dedup_by_key(|(ends, _)| *ends);
    ends.sort_unstable_by_key(|&(_, segment)| segment);
    let (edges, names): (Vec<[u32; 2]>, Vec<u32>) = ends.into_iter().unzip();
    let graph = Graph { points, edges, order };
    let mut named = Named { names, observer };
    let _ = sweep_observed(&graph.points, &graph.edges, graph.by_place(), |_| ControlFlow::Continue(()), &mut named);
    Ok(())
}

/// Tells of the segments by the numbers that they were given.
struct Named<'a, O> {
    names: Vec<u32>,
    observer: &'a mut O,
}

impl<O: Observer<SweepEvent>> Observer<SweepEvent> for Named<'_, O> {
    fn observe(&mut self, event: impl FnOnce() -> SweepEvent) {
        let names = &self.names;
        self.observer.observe(|| {
            let mut event = event();
            let lists = [&mut event.ending, &mut event.through, &mut event.starting, &mut event.status];
            lists.into_iter().flatten().for_each(|segment| *segment = names[*segment as usize]);
            event
        });
    }
}
