//! `dcel play`: the playground, a page in the browser, with a file inside.
//!
//! The page is made by `figures/playground/builder`, never by hand; the library carries it, as all that lies in `figures/`.

use super::save::{Files, put};
use super::{Answer, Failure, InputOptions, Output};
use dcel_kit::io::{Format, read_whole, source_name, write};
use dcel_kit::play::{Session, Tone, page_with};
use dcel_kit::sources::PLAYGROUND;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Play with a structure in the browser: draw, break, replay, practise
///
/// Writes one page that holds the whole kit: no server, no network.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
The page opens in the browser of this machine, if it has a display. A file of any format becomes the scene that the page \
begins with: a structure, points, or a script.

Examples:
  dcel play --no-open
  dcel play square.obj -o square.html --no-open
  dcel play split-face.dcels -o split.html --no-open")]
pub(crate) struct Args {
    /// The file to begin with, or - for standard input; without it the lab's rectangle
    file: Option<PathBuf>,
    /// The page to write [default: the name of the file with .html, or playground.html]
    #[arg(short, long, value_name = "OUT.html")]
    output: Option<PathBuf>,
    /// Split polygons and segments where they cross, touch or overlap, and begin with what comes of it
    #[arg(long, requires = "file")]
    mend: bool,
    /// Write the page and open nothing
    #[arg(long)]
    no_open: bool,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let usual = || match &args.file {
        Some(file) if file.as_os_str() != "-" => Path::new(file.file_name().unwrap_or_default()).with_extension("html"),
        _ => PathBuf::from("playground.html"),
    };
    let target = args.output.clone().unwrap_or_else(usual);
    Files::reading(args.file.iter()).writes("-o", Some(&target)).check()?;
    let page = match &args.file {
        None => PLAYGROUND.to_owned(),
        Some(file) if args.mend => with(&format!("{}.dcel", title(file)), &mended(file)?)?,
        Some(file) => {
            let bytes = read_whole(file)?;
            with(&name_of(file), &bytes).map_err(|failure| better_told(file, &bytes, failure))?
        }
    };
    put(&target, page)?;
    if target.as_os_str() == "-" {
        return Ok(Answer::Yes);
    }
    let place = std::fs::canonicalize(&target).unwrap_or_else(|_| target.clone());
    if !args.no_open && has_display() && open(&place) {
        writeln!(out, "{}: opened in the browser", target.display())?;
    } else {
        writeln!(out, "{}: open it in a browser", target.display())?;
    }
    Ok(Answer::Yes)
}

/// What the page calls a file.
fn name_of(file: &Path) -> String {
    let source = source_name(file);
    let name = if source == "<stdin>" { "standard input".to_owned() } else { source };
    Path::new(&name).file_name().map_or_else(|| name.clone(), |name| name.to_string_lossy().into_owned())
}

fn title(file: &Path) -> String {
    let name = name_of(file);
    Path::new(&name).file_stem().map_or_else(|| name.clone(), |stem| stem.to_string_lossy().into_owned())
}

/// The structure that a file becomes when its polygons or segments are split where they meet, as dcel text.
fn mended(file: &Path) -> Result<Vec<u8>, Failure> {
    let subject = InputOptions::mending().open(file)?;
    let mut text = Vec::new();
    write(&mut text, &subject.model(), Format::Dcel).map_err(|error| Failure::of_writing(file, error))?;
    Ok(text)
}

/// What is said of a refusal that has no help of its own.
const SIZES: &str = "the playground shows structures that a hand can edit; dcel info and dcel figure take all others";
/// What helps where polygons, rings or segments do not fit.
const MEND: &str = "correct the data, or give --mend: what crosses is split, what has no area is left out";

/// The refusal of a file that no command reads as it is, as those commands tell it: with the options that help here.
fn better_told(file: &Path, bytes: &[u8], refusal: Failure) -> Failure {
    let format = Format::from_path(file).filter(|format| format.can_read()).or_else(|| Format::from_content(bytes));
    if format.is_none() || file.as_os_str() == "-" {
        return refusal;
    }
    match InputOptions::default().open_as(file, false) {
        Err(failure) if failure.help().contains("--mend") => failure.helped_by(MEND),
        Err(failure) => failure,
        Ok(_) => refusal,
    }
}

/// The page with a file, which it can open.
fn with(name: &str, bytes: &[u8]) -> Result<String, Failure> {
    let reply = Session::new().open(name, bytes);
    if let Some(message) = reply.message.filter(|message| message.tone == Tone::Refused) {
        let (what, help) = message.text.split_once("; ").unwrap_or((&message.text, SIZES));
        return Err(Failure::input(what, help));
    }
    page_with(PLAYGROUND, name, bytes).ok_or_else(|| Failure::kit("the page has no room for a file"))
}

/// Whether there is a screen for a browser.
fn has_display() -> bool {
    cfg!(any(windows, target_os = "macos"))
        || ["DISPLAY", "WAYLAND_DISPLAY"]
            .iter()
            .any(|name| std::env::var_os(name).is_some_and(|value| !value.is_empty()))
}

/// Asks the machine to open a page; whether it could be asked.
fn open(page: &Path) -> bool {
    let program = if cfg!(windows) {
        "explorer"
    } else if cfg!(target_os = "macos") {
        "open"
    } else {
        "xdg-open"
    };
    let mut command = Command::new(program);
    command.arg(page).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}
