//! Work that goes on in several threads at the same time.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// What `work` makes of the numbers below `count`, one after the other, in so many lanes at most. It gets the number of
/// its lane, too, and says whether what has not begun is still wanted; what never begins is `None`.
pub(super) fn in_lanes<T: Send>(
    lanes: usize,
    count: usize,
    work: impl Fn(usize, usize) -> (T, bool) + Sync,
) -> Vec<Option<T>> {
    let (next, ended) = (AtomicUsize::new(0), AtomicBool::new(false));
    let made: Vec<Mutex<Option<T>>> = (0..count).map(|_| Mutex::new(None)).collect();
    let run = |lane: usize| {
        while !ended.load(Ordering::Relaxed) {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some(place) = made.get(number) else { break };
            let (one, goes_on) = work(lane, number);
            ended.fetch_or(!goes_on, Ordering::Relaxed);
            *place.lock().unwrap_or_else(PoisonError::into_inner) = Some(one);
        }
    };
    let run = &run;
    std::thread::scope(|scope| (0..lanes.min(count)).for_each(|lane| drop(scope.spawn(move || run(lane)))));
    made.into_iter().map(|one| one.into_inner().unwrap_or_else(PoisonError::into_inner)).collect()
}
