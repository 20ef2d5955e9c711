//! `dcel lab watch`: check, again whenever the file is saved.

use super::super::{Answer, Failure, Output, failure};
use super::check::{self, Bench};
use notify::{RecursiveMode, Watcher};
use std::io::Write;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// Editors write a file in several steps; this long after the last of them it is complete.
const QUIET: Duration = Duration::from_millis(60);

/// Check now, and again whenever you save your file
#[derive(clap::Args, Debug)]
#[command(after_help = "\
End it with Ctrl-C.

Examples:
  dcel lab watch
  dcel lab watch my-lab")]
pub(crate) struct Args {
    #[command(flatten)]
    check: check::Args,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let bench = Bench::new(&args.check)?;
    let cannot = |error: notify::Error| {
        Failure::input(format!("the folder cannot be watched: {error}"), "use `dcel lab check` after each change")
    };
    let (send, events) = channel();
    let mut watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
        // The compiler opens the file, too: only changes count, or each check would start the next one.
        if let Some(event) = event.ok().filter(|event| !event.kind.is_access()) {
            // Nobody listens any more only when the program ends.
            let _ = event.paths.into_iter().try_for_each(|path| send.send(path));
        }
    })
    .map_err(cannot)?;
    // The folder and not the file: editors replace files.
    watcher.watch(&bench.dir.join("src"), RecursiveMode::Recursive).map_err(cannot)?;
    loop {
        if let Err(failed) = bench.check(out) {
            failed.report();
        }
        out.flush()?;
        failure::say("watching", format_args!("{}; Ctrl-C ends it", bench.dir.join("src").display()));
        if !saved(&events, &bench.watched()) {
            return Ok(Answer::Yes);
        }
        writeln!(out, "\n{}", "-".repeat(40))?;
    }
}

/// Waits until one of the files has been saved; false when there is nothing more to wait for.
fn saved(events: &Receiver<PathBuf>, files: &[PathBuf]) -> bool {
    let names: Vec<_> = files.iter().filter_map(|file| file.file_name()).collect();
    loop {
        match events.recv() {
            Ok(path) if path.file_name().is_some_and(|name| names.contains(&name)) => break,
            Ok(_) => {}
            Err(_) => return false,
        }
    }
    loop {
        match events.recv_timeout(QUIET) {
            Ok(_) => {}
            Err(RecvTimeoutError::Timeout) => return true,
            Err(RecvTimeoutError::Disconnected) => return false,
        }
    }
}
