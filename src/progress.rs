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
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A watch over work, to be shared by threads.
#[derive(Clone, Debug, Default)]
pub struct Progress(Arc<Shared>);

#[derive(Debug, Default)]
struct Shared {
    stages: Mutex<Stages>,
    /// The steps that are done of the last stage; set back while the stages are locked.
    done: AtomicU64,
}

/// The stages so far.
#[derive(Clone, Copy, Debug, Default)]
struct Stages {
    /// How many were begun, and how many of them have not ended.
    begun: usize,
    open: usize,
    /// What the last one does, and its steps.
    what: &'static str,
    total: u64,
}

impl Shared {
    fn stages(&self) -> MutexGuard<'_, Stages> {
        self.stages.lock().unwrap_or_else(PoisonError::into_inner)
    }
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
    /// How many there are.
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
        self.standing(|stages| stages.open > 0)
    }

    /// The stage that was begun last, under way or not.
    #[must_use]
    pub fn last(&self) -> Option<Standing> {
        self.standing(|stages| stages.begun > 0)
    }

    fn standing(&self, is_wanted: impl Fn(&Stages) -> bool) -> Option<Standing> {
        let stages = self.0.stages();
        let Stages { begun: stage, what, total, .. } = *stages;
        is_wanted(&stages).then(|| Standing {
            stage,
            what,
            done: self.0.done.load(Ordering::Relaxed).min(total),
            total,
        })
    }
}

/// A stage of work while it lasts. Without anybody who watches it does nothing.
#[derive(Debug, Default)]
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
            let mut stages = shared.stages();
            let Stages { begun, open, .. } = *stages;
            *stages = Stages { begun: begun + 1, open: open + 1, what, total: total as u64 };
            shared.done.store(0, Ordering::Relaxed);
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
        if done.is_multiple_of(4096) {
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
            shared.stages().open -= 1;
        }
    }
}
