//! The clock of a deadline: it goes slower while the machine has not enough processors for all that wants to run.
//!
//! ```text
//!   2 processors, 2 programs want to run    one second is a second
//!   2 processors, 6 programs want to run    one second is a third of a second
//! ```
//!
//! A program that is right in half a second would be called endless on a machine that is busy with other work. How many
//! programs want to run is what Linux says in `/proc/loadavg`; elsewhere it is the clock on the wall.

use std::time::{Duration, Instant};

/// How often the machine is asked.
const EVERY: Duration = Duration::from_millis(50);
/// The slowest that it goes, so that nobody who starts many programs stays for long.
const SLOWEST: f64 = 0.25;

/// A clock that began when it was made.
pub(crate) struct Clock {
    passed: Duration,
    since: Instant,
    share: f64,
}

impl Clock {
    /// A clock that begins now.
    pub(crate) fn new() -> Self {
        Self { passed: Duration::ZERO, since: Instant::now(), share: share_now() }
    }

    /// What is left of this time; `None` if it has passed.
    pub(crate) fn left_of(&mut self, limit: Duration) -> Option<Duration> {
        let now = Instant::now();
        let ahead = (now - self.since).mul_f64(self.share);
        if now - self.since >= EVERY {
            (self.passed, self.since, self.share) = (self.passed + ahead, now, share_now());
            return limit.checked_sub(self.passed);
        }
        limit.checked_sub(self.passed + ahead)
    }
}

/// The share of a processor that a program can have now.
fn share_now() -> f64 {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let text = if cfg!(target_os = "linux") { std::fs::read_to_string("/proc/loadavg").ok() } else { None };
    text.and_then(|text| share(&text, processors)).unwrap_or(1.0)
}

/// The same by the text of `/proc/loadavg`: `0.52 0.58 0.59 3/602 29034`, where 3 want to run. One of them is who asks.
fn share(text: &str, processors: usize) -> Option<f64> {
    let running: usize = text.split_whitespace().nth(3)?.split('/').next()?.parse().ok()?;
    let others = running.saturating_sub(1).max(1);
    Some((processors as f64 / others as f64).clamp(SLOWEST, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_busy_machine_gives_a_share() {
        let of = |running: usize| share(&format!("0.5 0.5 0.5 {running}/600 29034\n"), 2).unwrap();
        let told: Vec<f64> = [0, 1, 2, 3, 5, 7, 9, 600].iter().map(|&running| of(running)).collect();
        assert_eq!(told, [1.0, 1.0, 1.0, 1.0, 0.5, 1.0 / 3.0, 0.25, 0.25]);
        assert_eq!(share("0.5 0.5", 2), None);
    }

    #[test]
    fn time_passes_by_its_share() {
        let second = Duration::from_secs(1);
        let after = |share, of_the_wall: Duration| {
            let mut clock = Clock { passed: Duration::ZERO, since: Instant::now() - of_the_wall, share };
            clock.left_of(second).map(|left| left.as_secs_f64())
        };
        let whole = after(1.0, second / 2).unwrap();
        assert!((0.4..=0.5).contains(&whole), "{whole}");
        let quarter = after(0.25, second / 2).unwrap();
        assert!((0.8..=0.875).contains(&quarter), "{quarter}");
        assert_eq!((after(1.0, second * 2), after(0.25, second * 5)), (None, None));
        let mut clock = Clock { passed: second, since: Instant::now(), share: 0.25 };
        assert_eq!(clock.left_of(second - EVERY), None, "what has passed stays passed");
    }
}
