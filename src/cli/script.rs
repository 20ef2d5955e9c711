//! `dcel script`: edits from a text, carried out one by one.
//!
//! ```text
//!   2: let a = split_face h2 h8          the line as written
//!      split_face h2 h8                  the call with its ids, if the line says it in other words
//!      returned h12, f2                  what it gave back
//! ```

use super::film::put_frames;
use super::picture::{Target, title};
use super::save::{Files, put};
use super::{Answer, Crop, Failure, Output, Page, failure};
use dcel_kit::edits::{self, Call, Editable};
use dcel_kit::figure::{FigureOptions, Film, Filmed, ScriptFilm, Slip, SlipError};
use dcel_kit::io::{Format, Model, read_whole, source_name, write};
use dcel_kit::plane::Subdivision;
use dcel_kit::script::{Ground, Outcome, Script, ScriptError, Step};
use dcel_kit::solid::Polyhedron;
use dcel_kit::topology::{Dcel, Table};
use serde_json::{Value, json};
use std::io::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Carry out a script of edits, step by step
///
/// Every call is printed with what it returned, every walk with what it met. A refused edit changes
/// nothing, is printed with its reason, and ends the script.
#[derive(clap::Args, Debug)]
#[command(after_help = help(), group = clap::ArgGroup::new("drawn").multiple(true))]
pub(crate) struct Args {
    /// The script, or - for standard input
    file: PathBuf,
    /// Write the structure at the end, as a `dump` in the last line would: as .dcel, in space as .obj
    #[arg(long)]
    dump: bool,
    /// Draw the edits frame by frame: a strip (.svg, .png), or a page that shows one frame at a time (.html)
    ///
    /// A structure without coordinates is laid out: within a circle, or, if it is a surface with handles, as
    /// a polygon whose sides are glued in pairs with one letter; of a large one the part where the edits are has
    /// room for arrows. A surface in space is seen from one place.
    #[arg(long, value_name = "OUT", group = "drawn")]
    film: Option<PathBuf>,
    /// A new folder with each frame of the film as a file
    #[arg(long, value_name = "DIR", group = "drawn")]
    frames: Option<PathBuf>,
    /// Show an edit beside the same edit with a slip: an assignment that is forgotten (h6.next), or that writes
    /// something else ("h6.next = h3"). May be given several times
    ///
    /// The film ends after that edit, with the invariants that do not hold any more.
    #[arg(long, value_name = "POINTER", requires = "drawn")]
    slip: Vec<Slip>,
    /// Only two panels of the film: before the first edit and after the last one
    #[arg(long, requires = "drawn", conflicts_with = "slip")]
    ends: bool,
    #[command(flatten)]
    page: Page,
    /// One frame at a time in the .svg too, with links and without a script
    #[arg(long, requires = "film")]
    stepper: bool,
    /// Go on after a refused edit (the exit code stays 1)
    #[arg(long)]
    keep_going: bool,
    /// Answer in JSON, with every pointer that was written
    #[arg(long)]
    json: bool,
}

/// What a script may say; the edits are those of the table.
fn help() -> String {
    format!(
        "\
A script is one statement a line: a start, then edits, walks, marks. `#` starts a comment.
  walk_face A        walk_vertex A       highlight A ...      caption TEXT     dump
  let NAME = ...     names what an edit makes, or any element
  A, B               h0, h1, ... of the start, a NAME, or links from one: h0.next.twin, a.face
  V, E, F            vertices, edges and faces in the same way: v0, a.origin, h2.edge, f1

In the plane: rectangle | polygon X Y X Y ... | triangles X Y ... / I J K ...
{}
Without coordinates, whatever is combinatorially legal: torus | ring N | surface N / I J K ... / ...
{}
In space: solid cube (or another of Plato's five) | mesh X Y Z ... / I J K ... / ...
{}
An edit of the plane checks the faces that it touches, corner by corner: many edits of \
one large face take the square of their number.

Examples:
  dcel script lab.dcels
  dcel script lab.dcels --json
  dcel script split-face.dcels --film split.svg
  dcel script split-face.dcels --film split.html
  dcel script split-face.dcels --film split.png
  dcel script split-face.dcels --film slip.svg --slip h12.next
  dcel script lab.dcels --film two.svg --ends
  dcel script lab.dcels --frames lab-frames
  echo 'rectangle
  split_face h2 h8
  dump' | dcel script -
  echo 'torus
  let a = split_vertex h0 h1
  join_vertices a' | dcel script -
  echo 'solid cube
  bevel_vertex v0 0.25
  dump' | dcel script -",
        edits::help::<Subdivision>(),
        edits::help::<Dcel>(),
        edits::help::<Polyhedron>()
    )
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    args.page.files(Files::reading([&args.file]).writes("--film", args.film.as_deref())).check()?;
    let target = film_target(args)?;
    let target = target.as_ref();
    let (text, source) = read(&args.file)?;
    match Ground::of(&text) {
        Ground::Space => shoot(args, target, &Script::parse_solid(&text, &source)?, &source, out),
        Ground::Kernel => shoot(args, target, &Script::parse_kernel(&text, &source)?, &source, out),
        _ => shoot(args, target, &Script::parse(&text, &source)?, &source, out),
    }
}

/// Plays a script, and films it if that is asked for.
fn shoot<G: Dump + Filmed>(
    args: &Args,
    target: Option<&Target>,
    script: &Script<G>,
    source: &str,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let Some(target) = target else { return play(args, script, source, |_, _| (), out)?.put(out) };
    let mut film = ScriptFilm::new(script);
    // Told when the film is written: a command that fails says nothing else.
    let mut told = Vec::new();
    let played = play(args, script, source, |step, structure| film.watch(step, structure), &mut told)?;
    let film = film.finish();
    let film = if args.ends { film.ends() } else { film };
    write_film(target, &film, &title(&args.file, "script"), args, out)?;
    out.write_all(&told)?;
    played.put(out)
}

/// What is left to be said when a script has been played.
struct Played {
    answer: Answer,
    json: Option<Value>,
    dump: Option<String>,
}

impl Played {
    fn put(self, out: &mut Output) -> Result<Answer, Failure> {
        match (self.json, self.dump) {
            (Some(mut answer), dump) => {
                if let Some(dump) = dump {
                    answer["dump"] = dump.into();
                }
                out.json(&answer)?;
            }
            (None, Some(dump)) => out.write_all(dump.as_bytes())?,
            (None, None) => {}
        }
        Ok(self.answer)
    }
}

/// Plays a script and tells it; `watch` sees each step and the structure after it.
fn play<G: Dump>(
    args: &Args,
    script: &Script<G>,
    source: &str,
    mut watch: impl FnMut(&Step<Call<G>>, &G),
    out: &mut impl Write,
) -> Result<Played, Failure> {
    script.old_words().iter().for_each(|word| failure::say("note", word));
    let mut teller = Teller { args, script, source, answer: Answer::Yes, told: Vec::new() };
    let mut result = Ok(());
    let end = script.play(|step, structure| {
        result = teller.tell(&step, structure, out);
        watch(&step, structure);
        if result.is_err() || (step.outcome.is_refused() && !args.keep_going) {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    });
    result?;
    let json = args.json.then(|| json!({ "source": source, "steps": teller.told }));
    let dump = args.dump.then(|| end.dump()).transpose()?;
    Ok(Played { answer: teller.answer, json, dump })
}

/// Where the film goes, if there is one; before the script is played.
fn film_target(args: &Args) -> Result<Option<Target>, Failure> {
    match &args.film {
        Some(path) if path.extension().is_none() => {
            let what = format!("{}: a film is a drawing or a page", path.display());
            Err(Failure::input(what, "end the name with .svg, .png or .html"))
        }
        Some(path) => Target::of_film(path, &args.page).map(Some),
        None if args.frames.is_some() => Target::new(None, &args.page).map(Some),
        None => Target::optional(None, &args.page, Crop::default(), "--film"),
    }
}

fn write_film(target: &Target, film: &Film, title: &str, args: &Args, out: &mut Output) -> Result<(), Failure> {
    let refused = |error| Failure::input(error, "leave out --film and --frames");
    let options = target.options(FigureOptions::new(title));
    let no_slip = |error: SlipError| Failure::input(error, "`dcel script --json` lists what each edit writes");
    let beside = if args.slip.is_empty() { None } else { Some(film.beside(&args.slip).map_err(no_slip)?) };
    if let Some(dir) = &args.frames {
        let singles = beside.as_ref().map_or_else(|| film.singles(&options), |film| film.singles(&options));
        put_frames(&singles.map_err(refused)?, dir)?;
    }
    if args.film.is_none() {
        return Ok(());
    }
    if let (true, Some(path)) = (target.is_page(), target.path()) {
        let page = beside.as_ref().map_or_else(|| film.page(&options), |film| film.page(&options));
        return put(path, page.map_err(refused)?);
    }
    let figure = match beside {
        Some(film) if args.stepper => film.stepper(&options),
        Some(film) => film.strip(&options),
        None if args.stepper => film.stepper(&options),
        None => film.strip(&options),
    };
    target.write(&figure.map_err(refused)?, out)
}

/// The text, and what messages call it.
fn read(file: &Path) -> Result<(String, String), Failure> {
    let (source, bytes) = (source_name(file), read_whole(file)?);
    let text = String::from_utf8(bytes)
        .map_err(|_| Failure::input(format!("{source}: this is not text in UTF-8"), "save it as plain text"))?;
    Ok((text, source))
}

impl From<ScriptError> for Failure {
    fn from(error: ScriptError) -> Self {
        let help = error.help.clone();
        Self::input(ScriptError { help: String::new(), ..error }, help)
    }
}

/// A structure that can be written out.
trait Dump: Editable {
    /// It as a .dcel file; in space, which that format does not know, as an .obj file.
    fn dump(&self) -> Result<String, Failure>;
}

impl Dump for Subdivision {
    fn dump(&self) -> Result<String, Failure> {
        dump(&Model::planar(self), Format::Dcel)
    }
}

impl Dump for Dcel {
    fn dump(&self) -> Result<String, Failure> {
        dump(&Model::table(&Table::from_view(self)), Format::Dcel)
    }
}

impl Dump for Polyhedron {
    fn dump(&self) -> Result<String, Failure> {
        let position = |v| self.has_vertex(v).then(|| self.point(v));
        dump(&Model::surface(self, position, |f| self.is_boundary_face(f)), Format::Obj)
    }
}

fn dump(model: &Model<'_>, format: Format) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    let cannot = |error| Failure::input(error, "leave out the dump");
    write(&mut bytes, model, format).map_err(cannot)?;
    String::from_utf8(bytes).map_err(Failure::kit)
}

struct Teller<'a, G> {
    args: &'a Args,
    script: &'a Script<G>,
    source: &'a str,
    answer: Answer,
    /// The steps for the answer in JSON.
    told: Vec<Value>,
}

impl<G: Dump> Teller<'_, G> {
    fn tell(&mut self, step: &Step<Call<G>>, structure: &G, out: &mut impl Write) -> Result<(), Failure> {
        let said = &self.script.statements()[step.statement];
        if let Outcome::Refused { reason, .. } = &step.outcome {
            self.answer = Answer::No;
            failure::say("refused", format_args!("{}:{}: {reason}", self.source, said.line()));
        }
        if self.args.json {
            let mut value = to_json(&step.outcome, structure)?;
            value["line"] = said.line().into();
            value["text"] = said.text().into();
            self.told.push(value);
            return Ok(());
        }
        writeln!(out, "{}: {}", said.line(), said.text())?;
        match &step.outcome {
            Outcome::Edited { edit, returned, .. } => {
                let call = edit.to_string();
                if !said.text().ends_with(&call) {
                    writeln!(out, "   {call}")?;
                }
                writeln!(out, "   returned {returned}")?;
            }
            Outcome::Refused { .. } => writeln!(out, "   refused")?,
            Outcome::Dump => out.write_all(structure.dump()?.as_bytes())?,
            Outcome::Caption(_) => {}
            other => writeln!(out, "   {other}")?,
        }
        Ok(())
    }
}

fn to_json<G: Dump>(outcome: &Outcome<Call<G>>, structure: &G) -> Result<Value, Failure> {
    let strings = |items: &mut dyn Iterator<Item = String>| Value::from_iter(items);
    Ok(match outcome {
        Outcome::Edited { edit, returned, journal } => {
            let steps = journal.steps().iter().enumerate().map(|(i, step)| {
                let writes = strings(&mut journal.changes_of_step(i).iter().map(ToString::to_string));
                json!({ "number": step.number, "what": step.what, "changes": writes })
            });
            let returned = strings(&mut returned.elements().iter().map(ToString::to_string));
            json!({ "call": edit.to_string(), "returned": returned, "steps": Value::from_iter(steps) })
        }
        Outcome::Refused { edit, reason } => {
            json!({ "call": edit.as_ref().map(ToString::to_string), "refused": reason.to_string() })
        }
        Outcome::WalkedFace { face, cycle } => json!({
            "face": face.to_string(),
            "half_edges": strings(&mut cycle.iter().map(|(h, _)| h.to_string())),
            "origins": strings(&mut cycle.iter().map(|(_, v)| v.to_string())),
        }),
        Outcome::WalkedVertex { vertex, star } => json!({
            "vertex": vertex.to_string(),
            "half_edges": strings(&mut star.iter().map(|(h, _)| h.to_string())),
            "destinations": strings(&mut star.iter().map(|(_, v)| v.to_string())),
        }),
        Outcome::Named(element) => json!({ "element": element.to_string() }),
        Outcome::Highlighted(elements) => {
            json!({ "highlighted": strings(&mut elements.iter().map(ToString::to_string)) })
        }
        Outcome::Caption(text) => json!({ "caption": text }),
        Outcome::Dump => json!({ "dump": structure.dump()? }),
    })
}
