//! Ctrl-C and the like, as a wish to stop.

use dcel_lab::Stop;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The signals that are waited for.
#[derive(Debug)]
pub(super) struct Signals(Arc<AtomicUsize>);

impl Signals {
    /// From now on Ctrl-C, SIGTERM and, where it is not ignored, a closed terminal wish the end; a second one ends
    /// the program at once.
    pub(super) fn wish(stop: &Stop) -> io::Result<Self> {
        let came = Arc::new(AtomicUsize::new(0));
        for signal in [SIGINT, SIGTERM].into_iter().chain(hang_up()) {
            flag::register_conditional_shutdown(signal, 128 + signal, stop.flag())?;
            flag::register_usize(signal, Arc::clone(&came), signal.unsigned_abs() as usize)?;
            flag::register(signal, stop.flag())?;
        }
        Ok(Self(came))
    }

    /// The one that came last, if any: its number.
    pub(super) fn came(&self) -> Option<u8> {
        u8::try_from(self.0.load(Ordering::SeqCst)).ok().filter(|&signal| signal > 0)
    }
}

/// The end of the terminal, unless it is ignored, as `nohup` has it.
#[cfg(unix)]
fn hang_up() -> Option<i32> {
    use signal_hook::consts::SIGHUP;
    (!super::super::signals::is_ignored(SIGHUP)).then_some(SIGHUP)
}

#[cfg(not(unix))]
fn hang_up() -> Option<i32> {
    None
}
