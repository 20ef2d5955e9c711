//! What is shown while one waits: a bar on the terminal, from the third second on.
//!
//! ```text
//!   reading ████████████████████──────────  62 %  4s left      gone as soon as there is something else to say
//! ```
//!
//! Only where stderr is a terminal. Notes and errors take the bar away while they are written.

use dcel_kit::progress::{Progress, Standing};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// So long nothing is shown.
const PATIENCE: Duration = Duration::from_secs(2);
/// How often the bar is drawn anew.
const PACE: Duration = Duration::from_millis(100);

/// The bar that is shown, for those who write beside it.
static BAR: OnceLock<ProgressBar> = OnceLock::new();

/// A look at the work, as long as it lasts.
struct Look {
    end: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

/// Does the work; shows how far it is if it takes long, and if somebody can see it.
pub(crate) fn shown<R>(work: impl FnOnce() -> R) -> R {
    if !std::io::stderr().is_terminal() {
        return work();
    }
    let progress = Progress::new();
    let _look = Look::at(progress.clone());
    progress.watch(work)
}

/// Writes something to the terminal that is not to stand within the bar.
pub(crate) fn aside<R>(write: impl FnOnce() -> R) -> R {
    match BAR.get() {
        Some(bar) => bar.suspend(write),
        None => write(),
    }
}

impl Look {
    fn at(progress: Progress) -> Self {
        let (end, ended) = channel();
        // Without a thread nothing is shown.
        let thread = std::thread::Builder::new().spawn(move || {
            let mut wait = PATIENCE;
            let mut seen = 0;
            while ended.recv_timeout(wait) == Err(RecvTimeoutError::Timeout) {
                wait = PACE;
                let Some(now) = progress.now() else {
                    BAR.get().inspect(|bar| bar.finish_and_clear());
                    continue;
                };
                let bar = BAR.get_or_init(ProgressBar::hidden);
                let is_new = now.stage != seen;
                if is_new {
                    seen = now.stage;
                    // Out of sight until it is complete.
                    bar.finish_and_clear();
                    bar.set_draw_target(ProgressDrawTarget::hidden());
                    bar.reset();
                    bar.set_length(now.total);
                    bar.set_message(now.what);
                }
                bar.set_style(style(now));
                bar.set_position(now.done);
                if is_new {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                }
                bar.tick();
            }
            if let Some(bar) = BAR.get() {
                bar.finish_and_clear();
            }
        });
        Self { end: Some(end), thread: thread.ok() }
    }
}

fn style(now: Standing) -> ProgressStyle {
    // At the beginning nobody knows how fast it goes.
    let left = if now.done > 0 { "  {eta} left" } else { "" };
    let template = format!("{{msg}} {{wide_bar}} {{percent:>3}} %{left}");
    ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

impl Drop for Look {
    fn drop(&mut self) {
        drop(self.end.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
