//! How far long work has come: told by the work itself, asked by whoever waits for it.
//!
//! ```text
//!   the thread that works                          another thread
//!   progress.watch(|| Subdivision::delaunay(..))   progress.now()  ──>  triangulating, 1,310,720 of 2,000,000
//! ```
//!
//! Work is told stage by stage: the last stage that was begun counts. Readers, sweeps, triangulations, location, writers tell
//! what they do of inputs that take long; nobody who does not ask pays for it.
//!
//! ```
//! use dcel_kit::{Point, Subdivision, progress::Progress};
//! let points: Vec<Point> = (0..50_000).map(|i| Point::new(f64::from(i % 317), f64::from(i / 317))).collect();
//! let progress = Progress::new();
//! let built = progress.watch(|| Subdivision::delaunay(&points))?;
//! let last = progress.last().expect("a stage");
//! assert_eq!((last.what, last.done, last.total), ("triangulating", 50_000, 50_000));
//! assert!(progress.now().is_none() && built.subdivision.vertex_count() == 50_000);
//! # Ok::<(), dcel_kit::plane::DelaunayError>(())
//! ```

use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// A watch over work, to be shared by threads.
#[derive(Clone, Debug, Default)]
pub struct Progress(Arc<Shared>);

#[derive(Debug, Default)]
struct Shared {
    /// What is being done; what was done last stays.
    what: Mutex<&'static str>,
    /// How many stages were begun, and how many of them have not ended.
    begun: AtomicUsize,
    open: AtomicUsize,
    done: AtomicU64,
    total: AtomicU64,
}

/// How far a stage has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Standing {
    /// Which stage this is, counted from 1.
    pub stage: usize,
    /// What is being done: `reading`.
    pub what: &'static str,
    /// How many steps are done. A step may be anything; not more than `total`.
    pub done: u64,
    /// How many there are; 0 if nobody knows.
    pub total: u64,
}

thread_local! {
    static WATCHED: RefCell<Option<Progress>> = const { RefCell::new(None) };
}

impl Progress {
    /// A watch over nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Does the work, and lets it tell how far it has come. A watch inside another one takes its place as long as it lasts.
    pub fn watch<R>(&self, work: impl FnOnce() -> R) -> R {
        /// Puts back what was there, on a panic, too.
        struct Before(Option<Progress>);
        impl Drop for Before {
            fn drop(&mut self) {
                WATCHED.set(self.0.take());
            }
        }
        let _before = Before(WATCHED.replace(Some(self.clone())));
        work()
    }

    /// The stage that is under way, if any.
    #[must_use]
    pub fn now(&self) -> Option<Standing> {
        self.last().filter(|_| self.0.open.load(Ordering::Acquire) > 0)
    }

    /// The stage that was begun last, under way or not.
    #[must_use]
    pub fn last(&self) -> Option<Standing> {
        let what = *self.0.what.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let stage = self.0.begun.load(Ordering::Acquire);
        let total = self.0.total.load(Ordering::Relaxed);
        let done = self.0.done.load(Ordering::Relaxed);
        (stage > 0).then_some(Standing { stage, what, done: if total > 0 { done.min(total) } else { done }, total })
    }
}

/// A stage of work while it lasts. Without anybody who watches it does nothing.
#[derive(Debug)]
pub(crate) struct Stage(Option<Progress>);

/// Work with fewer steps than this is no stage: it is over before anybody asks.
const SHORT: usize = 1 << 14;

impl Stage {
    /// Begins a stage of so many steps.
    pub(crate) fn new(what: &'static str, total: usize) -> Self {
        if total < SHORT {
            return Self(None);
        }
        let watched = WATCHED.with_borrow(Clone::clone);
        if let Some(Progress(shared)) = &watched {
            *shared.what.lock().unwrap_or_else(std::sync::PoisonError::into_inner) = what;
            shared.total.store(total as u64, Ordering::Relaxed);
            shared.done.store(0, Ordering::Relaxed);
            shared.begun.fetch_add(1, Ordering::Release);
            shared.open.fetch_add(1, Ordering::Release);
        }
        Self(watched)
    }

    /// So many steps more are done. To be called for some thousands at a time.
    pub(crate) fn add(&self, steps: usize) {
        if let Some(Progress(shared)) = &self.0 {
            shared.done.fetch_add(steps as u64, Ordering::Relaxed);
        }
    }

    /// So many steps are done in all. Cheap enough to be called for every one.
    #[inline]
    pub(crate) fn at(&self, done: usize) {
        if done % 4096 == 0 {
            self.set(done);
        }
    }

    /// So many steps are done in all.
    pub(crate) fn set(&self, done: usize) {
        if let Some(Progress(shared)) = &self.0 {
            shared.done.store(done as u64, Ordering::Relaxed);
        }
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        if let Some(Progress(shared)) = &self.0 {
            shared.open.fetch_sub(1, Ordering::Release);
        }
    }
}
