//! Building a tree: cargo, offline, in a target directory of its own, in the sandbox.
//!
//! The compiler reads what the student wrote, so it is a program that the student runs: it has a deadline, a memory
//! limit, and sees its tools and the tree. Nothing that is compiled is run while compiling: there is no build script
//! and no procedural macro.
//!
//! ```text
//!   scan ──▶ build in the sandbox ──▶ what did the compiler read? ──▶ program, or the compiler's words
//!                                       anything outside: refused       only if it came to say what it read
//! ```

use super::reads::{Reads, is_own};
use super::toolchain::Toolchain;
use super::tree::{Tree, own_only};
use crate::task::{Runner, Task, View};
use crate::{End, Limits, Verdict};
use serde::Deserialize;
use std::fs;
use std::path::{Path, PathBuf};

/// So much of what the compiler says is passed on.
const MOST_WORDS: usize = 4000;

/// What came of a build.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Built {
    /// The program.
    Program(PathBuf),
    /// Why there is none.
    Not {
        /// Does not compile, timed out while compiling, reads what is not its own, or a fault of the grader.
        verdict: Verdict,
        /// In words; the compiler's first error.
        message: String,
    },
}

/// Builds a tree in a sandbox.
pub(crate) fn build(tree: &Tree, toolchain: &Toolchain, limits: Limits, runner: &dyn Runner) -> Built {
    if let Some(settings) = settings_above(&tree.folder()).filter(|_| !runner.obeys_settings()) {
        return fault(format!("{} would change how submissions are built; move it away", settings.display()));
    }
    // In a room that stays there may be the account of an earlier build.
    Reads::forget(&tree.target());
    let ran = runner.run(&task(tree, toolchain, limits), "");
    let messages: Vec<Message> =
        String::from_utf8_lossy(&ran.stdout).lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    let complaints = String::from_utf8_lossy(&ran.stderr).into_owned();
    let reads = Reads::of_build(&tree.target());
    let own = |file: &str| is_own(file, &tree.folder(), &toolchain.library);
    if let Some(what) = reads.as_ref().and_then(|reads| reads.outside(&tree.folder(), &toolchain.library)) {
        return refused(&what);
    }
    match ran.end {
        End::Exited(0) if reads.is_none() => fault("the compiler did not say which files it read".to_owned()),
        End::Exited(0) => take_program(tree, &messages),
        End::Exited(_) => match error_of(&messages) {
            Some(error) if error.spans.is_empty() => {
                let words = error.rendered.as_deref().unwrap_or(&error.message);
                fault(format!("the compiler cannot do its work on this machine: {}", cut(words)))
            }
            Some(error) if reads.is_none() => not(unread(tree, error)),
            Some(error) if !error.names().all(own) => refused("something that is not in its folder"),
            Some(error) => not(told(tree, error)),
            None if reads.is_some() && complaints.contains("could not compile") => not(cut(&complaints)),
            None => fault(format!("the build failed without an error in the code: {}", cut(&complaints))),
        },
        End::TimedOut => Built::Not {
            verdict: Verdict::TimedOut,
            message: format!(
                "the compiler did not finish within {} s: look for a type, a constant or a macro that never ends",
                limits.seconds
            ),
        },
        End::OutOfMemory => not(format!(
            "the compiler needed more than {} MB: look for a type, a constant or a macro that never ends",
            limits.memory_mb
        )),
        End::OutputLimit => not("the compiler had more to complain of than anybody can read".to_owned()),
        End::NotStarted(why) => fault(why),
        end => not(format!("the compiler itself ended by {end:?}: {}", cut(&complaints))),
    }
}

fn task(tree: &Tree, toolchain: &Toolchain, limits: Limits) -> Task {
    let text = |path: &Path| path.to_string_lossy().into_owned();
    let words = ["build", "--frozen", "--offline", "--quiet", "--message-format=json", "--color=never"];
    let env = [
        ("PATH", toolchain.path.clone()),
        ("CARGO_HOME", text(&tree.home())),
        ("CARGO_TARGET_DIR", text(&tree.target())),
        // Settings of a student's own machine could keep what is made on the way apart.
        ("CARGO_BUILD_BUILD_DIR", text(&tree.target())),
        ("CARGO_BUILD_JOBS", "1".to_owned()),
        ("HOME", text(&tree.home())),
        ("TMPDIR", text(&tree.tmp())),
        ("RUSTC", text(&toolchain.rustc)),
        // The manifest says so too; neither can be undone by an attribute.
        ("RUSTFLAGS", "-F unsafe_code".to_owned()),
    ];
    let mut env: Vec<(String, String)> = env.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    if cfg!(windows) {
        // Without these no program starts there; elsewhere the environment is empty but for the above.
        let needed = ["SystemRoot", "TEMP", "TMP", "ProgramFiles", "ProgramFiles(x86)", "ProgramData"];
        env.extend(needed.iter().filter_map(|name| Some(((*name).to_owned(), std::env::var(name).ok()?))));
    }
    Task {
        program: toolchain.cargo.clone(),
        args: words.map(str::to_owned).into(),
        env,
        folder: tree.folder(),
        view: View {
            run: toolchain.parts.iter().cloned().chain([tree.folder()]).collect(),
            write: vec![tree.target(), tree.tmp(), tree.home()],
            tools: true,
        },
        limits,
    }
}

/// Cargo obeys settings in every folder above a package; there must be none above a room.
fn settings_above(folder: &Path) -> Option<PathBuf> {
    let names = [".cargo/config.toml", ".cargo/config"];
    folder.ancestors().flat_map(|above| names.map(|name| above.join(name))).find(|path| path.exists())
}

/// Takes the program out of the target directory, if this very build made it from this very package.
fn take_program(tree: &Tree, messages: &[Message]) -> Built {
    let made = messages.iter().find_map(|message| match message {
        Message::Made { target, fresh: false, executable: Some(path) }
            if target.name == tree.package && path.starts_with(tree.target()) =>
        {
            Some(path)
        }
        _ => None,
    });
    let finished = messages.iter().any(|message| matches!(message, Message::Finished { success: true }));
    let Some(made) = made.filter(|_| finished) else {
        return fault("the build succeeded but did not compile the lab".to_owned());
    };
    let program = tree.program();
    // A copy: the compiler's user owns the original, and could change it while it is judged.
    match fs::copy(made, &program).and_then(|_| own_only(&program, 0o755)) {
        Ok(()) => {
            if !tree.stays {
                let _ = fs::remove_dir_all(tree.target());
            }
            Built::Program(program)
        }
        Err(error) => fault(format!("{}: {error}", program.display())),
    }
}

/// The first error in the code; without any, the first one at all: no linker, no standard library.
fn error_of(messages: &[Message]) -> Option<&Diagnostic> {
    let mut errors = messages.iter().filter_map(|message| match message {
        Message::Said { message } if message.level.starts_with("error") => Some(message),
        _ => None,
    });
    errors.clone().find(|error| !error.spans.is_empty()).or_else(|| errors.next())
}

/// Where an error is, as a student reads it.
fn place_of(tree: &Tree, error: &Diagnostic) -> String {
    let span = error.spans.iter().find(|span| span.is_primary).or(error.spans.first());
    let place = span.map(|span| {
        let given = if tree.graded.contains(&span.file_name) { "" } else { " (a given file, which calls yours)" };
        format!("{}:{}:{}{given}: ", span.file_name, span.line_start, span.column_start)
    });
    place.unwrap_or_default()
}

/// An error: where, what, and the compiler's own picture of it.
fn told(tree: &Tree, error: &Diagnostic) -> String {
    let rendered = error.rendered.as_deref().unwrap_or_default();
    cut(&format!("{}{}\n\n{rendered}", place_of(tree, error), error.message))
}

/// What is said where the compiler stopped before it told what it had read: none of its own words but these.
fn unread(tree: &Tree, error: &Diagnostic) -> String {
    let known = ["recursion limit reached while expanding", "this file contains an unclosed delimiter"];
    let what = known.into_iter().find(|words| error.message.starts_with(words));
    let place = if error.spans.iter().all(|span| tree.graded.contains(&span.file_name)) {
        place_of(tree, error)
    } else {
        String::new()
    };
    let what = what.unwrap_or("the compiler stopped in the middle of a macro");
    format!("{place}{what}; `cargo build` shows the compiler's own words")
}

fn cut(text: &str) -> String {
    let text = text.trim_end();
    match text.char_indices().nth(MOST_WORDS) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

fn not(message: String) -> Built {
    Built::Not { verdict: Verdict::DoesNotCompile, message }
}

fn refused(what: &str) -> Built {
    let message =
        format!("when it is compiled it reads {what}: a lab's file reads nothing but the lab; take out what reads it");
    Built::Not { verdict: Verdict::Refused, message }
}

fn fault(message: String) -> Built {
    Built::Not { verdict: Verdict::GraderFault, message }
}

/// What cargo says, as far as it matters here.
#[derive(Deserialize)]
#[serde(tag = "reason")]
enum Message {
    #[serde(rename = "compiler-message")]
    Said { message: Diagnostic },
    #[serde(rename = "compiler-artifact")]
    Made { target: Target, fresh: bool, executable: Option<PathBuf> },
    #[serde(rename = "build-finished")]
    Finished { success: bool },
    #[serde(other)]
    Other,
}

#[derive(Deserialize)]
struct Target {
    name: String,
}

#[derive(Deserialize)]
struct Diagnostic {
    level: String,
    message: String,
    rendered: Option<String>,
    #[serde(default)]
    spans: Vec<Span>,
    #[serde(default)]
    children: Vec<Diagnostic>,
}

impl Diagnostic {
    /// The files that it names, in notes and macros as well.
    fn names(&self) -> Box<dyn Iterator<Item = &str> + '_> {
        let own = self.spans.iter().flat_map(Span::names);
        Box::new(own.chain(self.children.iter().flat_map(Self::names)))
    }
}

#[derive(Deserialize)]
struct Span {
    file_name: String,
    line_start: u32,
    column_start: u32,
    is_primary: bool,
    expansion: Option<Box<Expansion>>,
}

impl Span {
    fn names(&self) -> Vec<&str> {
        let mut names = vec![self.file_name.as_str()];
        if let Some(expansion) = &self.expansion {
            names.extend(expansion.span.names());
            names.extend(expansion.def_site_span.iter().flat_map(Self::names));
        }
        names
    }
}

/// The macro that a span comes from: where it was called, and where it is defined.
#[derive(Deserialize)]
struct Expansion {
    span: Span,
    def_site_span: Option<Span>,
}
