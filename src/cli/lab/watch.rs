//! `dcel lab watch`: check, again whenever the file is saved.
//!
//! ```text
//!   saved ──┐                          h  the next hint       l  the tests again
//!           ├──▶ what to do next ──▶   r  begin again (asks)  q  end
//!   key  ───┘
//! ```
//!
//! On a terminal the screen is cleared before each check and verdicts are coloured, unless NO_COLOR is set. Anywhere
//! else it writes one check below the other and listens to no keys.

use super::super::saved::{QUIET, is_one_of, watcher};
use super::super::{Answer, Failure, Output, failure};
use super::check::{self, Bench};
use super::{hint, reset};
use console::{Key, Term};
use notify::{RecursiveMode, Watcher};
use std::io::Write;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};

/// What stands below a check.
const KEYS: &str = "h hint   l list of tests   r reset   q quit";

/// Check now, and again whenever you save your file
#[derive(clap::Args, Debug)]
#[command(after_help = "\
On a terminal these keys work: h the next hint, l the list of tests, r begin again (asks first), q quit. Elsewhere \
end it with Ctrl-C.

Examples:
  dcel lab watch
  dcel lab watch my-lab")]
pub(crate) struct Args {
    #[command(flatten)]
    check: check::What,
}

/// Something to do.
enum Event {
    /// A file below the folder was changed.
    Changed(PathBuf),
    /// A key was pressed.
    Pressed(char),
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let mut bench = Bench::new(&args.check)?.kept();
    let cannot = |error: notify::Error| {
        Failure::input(format!("the folder cannot be watched: {error}"), "use `dcel lab check` after each change")
    };
    let (send, events) = channel();
    let changes = send.clone();
    let mut watcher = watcher(move |path| changes.send(Event::Changed(path)).is_ok()).map_err(cannot)?;
    // The folder and not the file: editors replace files.
    watcher.watch(&bench.dir.join("src"), RecursiveMode::Recursive).map_err(cannot)?;
    let screen = Screen::new(send);
    check(&mut bench, &screen, out)?;
    loop {
        match wait(&events, &bench.watched()) {
            Some(Event::Changed(_)) => check(&mut bench, &screen, out)?,
            Some(Event::Pressed('h')) => {
                screen.clear();
                shown(hint::next(&bench.dir, bench.named.as_deref(), out));
                screen.foot(out)?;
            }
            Some(Event::Pressed('l')) => {
                screen.clear();
                bench.list(out)?;
                screen.foot(out)?;
            }
            Some(Event::Pressed('r')) => {
                let files: Vec<String> = bench.watched().iter().map(|path| path.display().to_string()).collect();
                writeln!(out, "\nPut back {} as it was given? Yours is kept beside it. [y/N]", files.join(", "))?;
                out.flush()?;
                match next_key(&events) {
                    Some('y' | 'Y') => {
                        shown(reset::run(&reset::Args::of(&bench.dir), out));
                        screen.foot(out)?;
                    }
                    Some('q') | None => return Ok(Answer::Yes),
                    Some(_) => {
                        writeln!(out, "Nothing was changed.")?;
                        screen.foot(out)?;
                    }
                }
            }
            Some(Event::Pressed('q')) | None => return Ok(Answer::Yes),
            Some(Event::Pressed(_)) => {}
        }
    }
}

fn check(bench: &mut Bench, screen: &Screen, out: &mut Output) -> Result<(), Failure> {
    screen.clear();
    shown(bench.check(out));
    screen.foot(out)?;
    if !screen.is_there() {
        failure::say("watching", format_args!("{}; Ctrl-C ends it", bench.dir.join("src").display()));
    }
    Ok(())
}

/// Tells a failure and goes on: the next save may mend it.
fn shown(done: Result<Answer, Failure>) {
    if let Err(failed) = done {
        failed.report();
    }
}

/// The terminal, if there is one.
struct Screen(Option<Term>);

impl Screen {
    /// Begins to listen to keys if both ends are a terminal.
    fn new(send: Sender<Event>) -> Self {
        let term = Term::stdout();
        let keys = Term::stdout();
        if !(term.is_term() && std::io::IsTerminal::is_terminal(&std::io::stdin())) {
            return Self(None);
        }
        std::thread::spawn(move || {
            loop {
                let key = match keys.read_key() {
                    Ok(Key::Char(key)) => key,
                    Ok(Key::CtrlC) | Err(_) => 'q',
                    Ok(_) => continue,
                };
                // Whoever waits for a key holds the terminal: after the last one it must be free again.
                if send.send(Event::Pressed(key)).is_err() || key == 'q' {
                    return;
                }
            }
        });
        Self(Some(term))
    }

    fn is_there(&self) -> bool {
        self.0.is_some()
    }

    fn clear(&self) {
        if let Some(term) = &self.0 {
            // A terminal that cannot be cleared shows one check below the other.
            let _ = term.clear_screen();
        }
    }

    fn foot(&self, out: &mut Output) -> Result<(), Failure> {
        if self.is_there() {
            writeln!(out, "\n{}", console::style(KEYS).dim())?;
        }
        out.flush()?;
        Ok(())
    }
}

/// The next key, whatever is saved in the meantime.
fn next_key(events: &Receiver<Event>) -> Option<char> {
    loop {
        match events.recv().ok()? {
            Event::Pressed(key) => return Some(key),
            Event::Changed(_) => {}
        }
    }
}

/// Waits for a key, or until one of the files has been saved; `None` when there is nothing more to wait for.
fn wait(events: &Receiver<Event>, files: &[PathBuf]) -> Option<Event> {
    let saved = loop {
        match events.recv().ok()? {
            Event::Changed(path) if is_one_of(&path, files) => break Event::Changed(path),
            Event::Changed(_) => {}
            key @ Event::Pressed(_) => return Some(key),
        }
    };
    loop {
        match events.recv_timeout(QUIET) {
            Ok(Event::Pressed('q')) => return Some(Event::Pressed('q')),
            Ok(_) => {}
            Err(RecvTimeoutError::Timeout) => return Some(saved),
            Err(RecvTimeoutError::Disconnected) => return None,
        }
    }
}
