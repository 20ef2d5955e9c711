//! A wish to come to an end soon, said once and heard everywhere.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Says to a grading run that it is to end: what runs is ended, what is done stays. All clones are one.
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Nobody wishes an end yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Wishes an end.
    pub fn stop(&self) {
        self.0.store(true, Ordering::SeqCst);
    }

    /// Whether an end is wished.
    #[must_use]
    pub fn is_wished(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }

    /// The same as a flag, for those who set one: the handler of a signal.
    #[must_use]
    pub fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.0)
    }
}

/// Equal if they are one.
impl PartialEq for Stop {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}
