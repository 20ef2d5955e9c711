//! A session: the scene, what is selected, what is broken, which quiz is on; every action gives back what has changed.
//!
//! ```text
//!   mod.rs         what is asked for            telling.rs     what of it is shown
//!   scenes.rs      what is played with          picking.rs     what is selected
//!   editing.rs     edits, undo, redo            moving.rs      vertices that are dragged
//!   breaking.rs    pointers led elsewhere       practising.rs  rounds of questions
//!   files.rs       what can be taken along
//! ```

mod breaking;
mod editing;
mod files;
mod moving;
mod picking;
mod practising;
mod scenes;
mod telling;

use crate::edits::Row;
use crate::ids::Element;
use crate::plane::Point;
use crate::play::broken::Broken;
use crate::play::canvas::{Canvas, Over};
use crate::play::quizzes::{Round, read_code};
use crate::play::reply::{Action, File, Message, Question, Reply, Tone, named};
use crate::play::scene::Scene;
use crate::play::{link, points, tables};

/// A longer link than this is not made.
const LONGEST_LINK: usize = 300_000;
/// What readers of the screen hear first of the picture.
const TITLE: &str = "Playground";

/// A session of the playground.
#[derive(Clone, Debug)]
pub struct Session {
    scene: Scene,
    pub(super) canvas: Canvas,
    chosen: Vec<Element>,
    /// Where a face was clicked.
    at: Option<Point>,
    waiting: Option<&'static Row>,
    /// What the last refusal named, until something else is done.
    refused: Vec<Element>,
    pub(super) broken: Option<Broken>,
    quiz: Option<Quiz>,
}

/// A round, and the scene before it.
#[derive(Clone, Debug)]
struct Quiz {
    round: Round,
    before: Box<Scene>,
}

/// What of a session is to be told.
#[derive(Clone, Copy, Debug, Default)]
struct Changed {
    /// The room for the picture alone: everything else that is shown stays.
    room: bool,
    structure: bool,
    selection: bool,
}

const NOTHING: Changed = Changed { room: false, structure: false, selection: false };
const ROOM: Changed = Changed { room: true, ..NOTHING };
const ALL: Changed = Changed { room: false, structure: true, selection: true };
const SELECTION: Changed = Changed { selection: true, ..NOTHING };

type Outcome = Result<(Changed, Reply), String>;

impl Default for Session {
    fn default() -> Self {
        Self::new()
    }
}

impl Session {
    /// A session with the lab's rectangle.
    #[must_use]
    pub fn new() -> Self {
        Self {
            scene: Scene::rectangle(),
            canvas: Canvas::default(),
            chosen: Vec::new(),
            at: None,
            waiting: None,
            refused: Vec::new(),
            broken: None,
            quiz: None,
        }
    }

    /// Does what is asked for. What cannot be done is a sentence in the reply, and nothing has changed.
    pub fn act(&mut self, action: &Action) -> Reply {
        let outcome = self.try_act(action);
        self.told(outcome)
    }

    /// Opens a file of any format.
    pub fn open(&mut self, name: &str, bytes: &[u8]) -> Reply {
        let outcome = Scene::file(name, bytes).map(|(scene, notes)| self.begin(scene, &notes));
        self.told(outcome)
    }

    /// The scene in the link's text form, checked by the random tests: see [`Action::Link`].
    #[must_use]
    pub fn link(&self) -> String {
        let broken = self.broken.as_ref().map_or_else(Vec::new, Broken::kept);
        link::write(&format!("{}\u{1e}{}", self.scene_kept(), broken.join("\n")))
    }

    /// All invariants that do not hold, those of the plane among them; empty except where a pointer was led elsewhere.
    #[must_use]
    pub fn violations(&self) -> Vec<String> {
        if let Some(broken) = &self.broken {
            return broken.faults().into_iter().map(|fault| fault.text).collect();
        }
        let table = self.scene.table();
        let mut all: Vec<String> = crate::topology::violations(&table).iter().map(ToString::to_string).collect();
        if let Some(s) = self.scene.subdivision() {
            all.extend(s.geometry_violations().iter().map(ToString::to_string));
        }
        all
    }

    /// The scene that a link keeps: never the one of a quiz.
    fn scene_kept(&self) -> String {
        self.quiz.as_ref().map_or(&self.scene, |quiz| &*quiz.before).kept()
    }

    fn told(&mut self, outcome: Outcome) -> Reply {
        match outcome {
            Ok((changed, mut reply)) => {
                if !changed.room {
                    self.refused.clear();
                }
                self.fill(changed, &mut reply);
                reply
            }
            Err(reason) => self.refusal(&reason),
        }
    }

    /// A refusal. What it names is marked where single half-edges are not drawn.
    fn refusal(&mut self, reason: &str) -> Reply {
        self.refused = named(reason);
        let mut reply = Reply { message: Some(Message::new(Tone::Refused, reason)), ..Reply::default() };
        if !self.canvas.shows_half_edges() && matches!(self.scene, Scene::Plane { .. }) {
            reply.over = Some(self.marked("mark bad", &self.refused, &self.table()));
        }
        reply
    }

    fn try_act(&mut self, action: &Action) -> Outcome {
        let quiet = |changed| Ok((changed, Reply::default()));
        match action {
            Action::Show => quiet(ALL),
            Action::Resize { width, height } => quiet(if self.canvas.resize(*width, *height) { ROOM } else { NOTHING }),
            Action::Start { what } => Scene::start(what).map(|(scene, notes)| self.begin(scene, &notes)),
            Action::Polygon { places } => self.polygon(places),
            Action::Outline { places } => Ok((NOTHING, Reply { over: Some(outline(places)), ..Reply::default() })),
            Action::Script { text } => self.script(text),
            Action::Link { text } => self.follow_link(text),
            Action::Click { x, y, reach } => match self.under(*x, *y, *reach) {
                Some(found) => self.pick(found, Some([*x, *y])),
                None => quiet(NOTHING),
            },
            Action::Hover { x, y, reach } => {
                let found = self.under(*x, *y, *reach).map_or_else(String::new, |found| found.to_string());
                Ok((NOTHING, Reply { hover: Some(found), ..Reply::default() }))
            }
            Action::Pick { id } => {
                let found = tables::find(&self.table(), id)?;
                self.pick(found, None)
            }
            Action::Leave => {
                self.leave();
                quiet(SELECTION)
            }
            Action::Follow { link } => self.follow(link),
            Action::Walk { path } => self.walk(path),
            Action::Edit { word } => self.edit_selected(word),
            Action::Drag { id, x, y } => self.drag(id, *x, *y),
            Action::Drop { id, x, y } => self.drop_at(id, *x, *y),
            Action::Nudge { id, x, y } => self.nudge(id, *x, *y),
            Action::Undo => self.undo(),
            Action::Redo => self.redo(),
            Action::Break { id, pointer, to } => self.lead(id, pointer, to),
            Action::Mend => {
                self.broken.take().ok_or("no pointer was led elsewhere")?;
                self.leave();
                said(ALL, Tone::Done, "all pointers lead again where they should")
            }
            Action::Over { what } => {
                let layer = points::Layer::of(what).ok_or_else(|| format!("nothing is called `{what}`"))?;
                let Scene::Points(points) = &mut self.scene else {
                    return Err("this scene has no points of its own".to_owned());
                };
                points.layer = layer;
                quiet(ALL)
            }
            Action::Keep => self.keep(),
            Action::Export { what } => self.export(what),
            Action::Quiz { what, level, seed } => self.begin_quiz(what, *level, *seed),
            Action::Answer { answer } => self.answer(answer),
            Action::Next => {
                let quiz = self.quiz.as_mut().ok_or("no quiz is on")?;
                quiz.round.next()?;
                self.show_question();
                quiet(ALL)
            }
            Action::Quit => {
                let quiz = self.quiz.take().ok_or("no quiz is on")?;
                self.scene = *quiz.before;
                self.canvas.forget();
                self.leave();
                Ok((ALL, Reply { quiz: Some(Question::default()), ..Reply::default() }))
            }
            Action::Code { code } => said(NOTHING, Tone::Note, read_code(code)?),
        }
    }
}

/// The corners that were clicked so far.
fn outline(places: &[[f64; 2]]) -> String {
    let mut over = Over::default();
    let at = |[x, y]: [f64; 2]| crate::figure::canvas::vector::xy(x, y);
    for pair in places.windows(2) {
        over.line("mark", at(pair[0]), at(pair[1]));
    }
    if let (Some(&first), Some(&last)) = (places.first(), places.last()) {
        over.line("drag", at(last), at(first));
    }
    for &place in places {
        over.circle("mark", at(place), 5.0);
    }
    over.0
}

fn said(changed: Changed, tone: Tone, text: impl Into<String>) -> Outcome {
    Ok((changed, Reply { message: Some(Message::new(tone, text)), ..Reply::default() }))
}

fn file(name: &str, mime: &'static str, text: String) -> Reply {
    Reply { file: Some(File { name: name.to_owned(), mime, text }), ..Reply::default() }
}
