//! Ctrl-C and the like: what is half written goes before the program does.

use dcel_kit::files::abandon_all;
use std::io;

/// From now on, a signal that ends the program first removes its temporaries. A file that grows beyond the limit of the
/// shell (`ulimit -f`) is an error as a full disk is, and no signal.
///
/// # Errors
/// What the machine says.
#[cfg(unix)]
pub(crate) fn clean_up() -> io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;
    use signal_hook::{flag, low_level};
    use std::sync::atomic::AtomicBool;
    use std::sync::{Arc, Barrier};

    flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)))?;
    let ending = [SIGINT, SIGTERM, SIGHUP, SIGQUIT].into_iter().filter(|&signal| !is_ignored(signal));
    let mut signals = Signals::new(ending)?;
    // Where there is no memory for a thread, that is an error and no panic. The thread has what it needs to begin before
    // the command takes memory: without it, the C library would end the program.
    let begun = Arc::new(Barrier::new(2));
    let here = Arc::clone(&begun);
    std::thread::Builder::new().spawn(move || {
        here.wait();
        if let Some(signal) = signals.forever().next() {
            abandon_all();
            // Ends the program as the signal would have done by itself, so that the shell is told the same.
            let _ = low_level::emulate_default_handler(signal);
        }
    })?;
    begun.wait();
    Ok(())
}

#[cfg(not(unix))]
pub(crate) fn clean_up() -> io::Result<()> {
    Ok(())
}

/// Whether a signal was switched off by whoever started the program, as `nohup` does.
#[cfg(unix)]
pub(crate) fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    ignored >> (signal - 1) & 1 != 0
}
