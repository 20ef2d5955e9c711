//! A session: the scene, what is selected, what is broken, which quiz is on; every action gives back what has changed.

use super::broken::Broken;
use super::canvas::{Canvas, Over};
use super::edits::{Done, LineError};
use super::quizzes::{Round, Verdict, read_code};
use super::reply::{Action, File, Message, Question, Reply, Selected, Status, Tone, element, named};
use super::scene::{Scene, dcel_text, draw_kernel};
use super::{film, link, tables, walk};
use crate::edits::{Argument, Call, Kind, Row, Takes, find, rows};
use crate::ids::{Element, VertexId};
use crate::io::Model;
use crate::plane::{Point, Subdivision};
use crate::topology::{Dcel, Table, measure};
use std::collections::BTreeSet;

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
    structure: bool,
    selection: bool,
}

const NOTHING: Changed = Changed { structure: false, selection: false };
const ALL: Changed = Changed { structure: true, selection: true };
const SELECTION: Changed = Changed { structure: false, selection: true };

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
                self.fill(changed, &mut reply);
                reply
            }
            Err(reason) => {
                let mut reply = Reply { message: Some(Message::new(Tone::Refused, reason)), ..Reply::default() };
                self.mark_refused(&mut reply);
                reply
            }
        }
    }

    /// Marks what a refusal names, where single half-edges are not drawn.
    fn mark_refused(&self, reply: &mut Reply) {
        if self.canvas.shows_half_edges() || !matches!(self.scene, Scene::Plane { .. }) {
            return;
        }
        let Some(message) = &reply.message else { return };
        let table = self.table();
        let mut over = Over::default();
        for name in named(&message.text) {
            over.mark("mark bad", &self.canvas, &table, name);
        }
        reply.over = Some(over.0);
    }

    fn try_act(&mut self, action: &Action) -> Outcome {
        let quiet = |changed| Ok((changed, Reply::default()));
        match action {
            Action::Show => quiet(ALL),
            Action::Resize { width, height } => {
                self.canvas.resize(*width, *height);
                quiet(ALL)
            }
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
                let layer = super::points::Layer::of(what).ok_or_else(|| format!("nothing is called `{what}`"))?;
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

    // What is shown.

    /// The pointers that are shown: of the scene, or as they were led, or of the question.
    fn table(&self) -> Table {
        if let Some(broken) = &self.broken {
            return broken.table.clone();
        }
        let asked = self.quiz.as_ref().and_then(|quiz| quiz.round.table());
        asked.cloned().unwrap_or_else(|| self.scene.table())
    }

    fn fill(&mut self, changed: Changed, reply: &mut Reply) {
        if changed.structure {
            let table = self.table();
            self.draw(&table, reply);
            self.tell(&table, reply);
        }
        if changed.selection || changed.structure {
            self.select(reply);
        }
    }

    fn draw(&mut self, table: &Table, reply: &mut Reply) {
        let options = self.canvas.options(TITLE);
        let drawn = match &self.scene {
            _ if self.quiz.as_ref().is_some_and(|quiz| quiz.round.table().is_some()) => {
                self.canvas.draw(table, options, true)
            }
            Scene::Kernel(work) => draw_kernel(work.now(), &options),
            Scene::Points(_) => self.canvas.draw(table, options, false),
            Scene::Plane { .. } => {
                let names = table
                    .faces
                    .iter()
                    .enumerate()
                    .filter_map(|(f, row)| Some((crate::ids::FaceId::new(f as u32), row.as_ref()?.name.clone()?)));
                let options = options.face_names(names);
                self.canvas.draw(table, options, true)
            }
        };
        match drawn {
            Ok(figure) => {
                reply.svg = Some(figure.to_svg());
                if let Some(note) = figure.notes().first()
                    && reply.message.is_none()
                {
                    reply.message = Some(Message::new(Tone::Note, note.clone()));
                }
            }
            Err(error) => reply.message = Some(Message::new(Tone::Refused, error.to_string())),
        }
    }

    /// Tables, counts, invariants, script and link.
    fn tell(&self, table: &Table, reply: &mut Reply) {
        let counts = measure(table);
        let counted = |n: usize, one: &str, many: &str| format!("{n} {}", if n == 1 { one } else { many });
        let violations = match (&self.quiz, &self.broken) {
            (Some(quiz), _) => quiz.round.faults(),
            (None, Some(broken)) => broken.faults(),
            (None, None) => Vec::new(),
        };
        let sound = violations.is_empty() && self.broken.is_none();
        let [v, e, f] = [counts.vertices, counts.edges, counts.face_records];
        let sum = v as i64 - e as i64 + f as i64;
        let euler = match &self.scene {
            _ if !sound => String::new(),
            Scene::Kernel(_) => format!("V - E + F = {v} - {e} + {f} = {sum}: genus {}", counts.genus()),
            _ => {
                let parts = counts.components.len();
                let right = if parts == 1 { String::new() } else { format!(" = 1 + {parts} components") };
                format!("V - E + F = {v} - {e} + {f} = {sum}{right}")
            }
        };
        let shown = self.quiz.as_ref().is_none_or(|quiz| quiz.round.shows_tables());
        let bad: BTreeSet<String> = violations.iter().flat_map(|fault| fault.elements.iter().cloned()).collect();
        reply.tables = Some(if shown { tables::html(table, &bad) } else { String::new() });
        let (scene, over) = match &self.scene {
            _ if self.broken.is_some() => ("broken", ""),
            _ if self.quiz.as_ref().is_some_and(|quiz| quiz.round.table().is_some()) => ("quiz", ""),
            Scene::Plane { .. } => ("plane", ""),
            Scene::Kernel(_) => ("kernel", ""),
            Scene::Points(points) => ("points", points.layer.word()),
        };
        let history = match &self.scene {
            _ if self.broken.is_some() => [true, false],
            Scene::Plane { work, .. } => [work.can_undo(), work.can_redo()],
            Scene::Kernel(work) => [work.can_undo(), work.can_redo()],
            Scene::Points(points) => points.history(),
        };
        reply.status = Some(Status {
            counts: format!(
                "{}, {}, {}",
                counted(v, "vertex", "vertices"),
                counted(e, "edge", "edges"),
                counted(f, "face", "faces")
            ),
            euler,
            violations,
            scene,
            history,
            over,
        });
        let lines = match &self.scene {
            Scene::Plane { work, .. } => work.lines(),
            Scene::Kernel(work) => work.lines(),
            Scene::Points(_) => Vec::new(),
        };
        reply.script = Some(lines.into_iter().map(|line| [line.text, line.note]).collect());
        let link = self.link();
        reply.link = Some(if link.len() > LONGEST_LINK { String::new() } else { link });
        if let Scene::Points(points) = &self.scene {
            reply.over = Some(points.over(&self.canvas));
        }
        if let Some(quiz) = &self.quiz {
            reply.quiz = Some(quiz.round.question());
        }
    }

    fn select(&self, reply: &mut Reply) {
        let table = self.table();
        let mut selected = match self.chosen.last() {
            Some(&last) if tables::exists(&table, last) => tables::describe(&table, last),
            _ => Selected::default(),
        };
        selected.ids = self.chosen.iter().map(ToString::to_string).collect();
        selected.waiting = self.waiting.map_or_else(String::new, |row| row.word.to_owned());
        if self.broken.is_none() && self.quiz.as_ref().is_none_or(|quiz| quiz.round.table().is_none()) {
            selected.edits = self.offers();
        }
        let hidden = self.quiz.as_ref().is_some_and(|quiz| !quiz.round.shows_tables());
        if hidden {
            selected.pointers.clear();
        }
        reply.selected = Some(selected);
        if !self.canvas.shows_half_edges() && !matches!(self.scene, Scene::Kernel(_)) {
            let mut over = Over(reply.over.take().unwrap_or_default());
            if let Scene::Points(points) = &self.scene
                && over.0.is_empty()
            {
                over.0 = points.over(&self.canvas);
            }
            for &element in &self.chosen {
                over.mark("mark", &self.canvas, &table, element);
            }
            reply.over = Some(over.0);
        }
    }

    /// The edits that can be tried with what is selected.
    fn offers(&self) -> Vec<[String; 3]> {
        let Some(&last) = self.chosen.last() else { return Vec::new() };
        let words: &[(&str, &str)] = match (&self.scene, last) {
            (Scene::Points(_), Element::Vertex(_)) => &[("remove_vertex", "Remove")],
            (Scene::Points(_), _) => &[],
            (Scene::Plane { .. }, Element::HalfEdge(_) | Element::Edge(_)) => &[
                ("split_in_half", "Split in half"),
                ("split_face", "Split face to …"),
                ("flip_edge", "Flip"),
                ("remove_edge", "Remove"),
                ("join_faces", "Join faces"),
                ("join_edges", "Join with next"),
            ],
            (Scene::Plane { .. }, Element::Vertex(_)) => &[("insert_edge", "Edge to …"), ("remove_vertex", "Remove")],
            (Scene::Plane { .. }, Element::Face(_)) => &[("insert_vertex", "Vertex here"), ("set_hole", "Hole")],
            (Scene::Kernel(_), Element::HalfEdge(_) | Element::Edge(_)) => &[
                ("split_edge", "Split edge"),
                ("split_face", "Split face to …"),
                ("split_vertex", "Split vertex to …"),
                ("flip_edge", "Flip"),
                ("join_faces", "Join faces"),
                ("join_edges", "Join with next"),
                ("join_vertices", "Join ends"),
                ("collapse_edge", "Collapse"),
            ],
            (Scene::Kernel(_), _) => &[],
        };
        let allowed = |word: &str| self.quiz.as_ref().is_none_or(|quiz| quiz.round.allows(word));
        let help = |word: &str| rows::TABLE.iter().find(|row| row.word == word).map_or("", |row| row.help);
        let offer = |&(word, text): &(&str, &str)| [word.to_owned(), text.to_owned(), help(word).to_owned()];
        words.iter().filter(|(word, _)| allowed(word)).map(offer).collect()
    }

    // Scenes.

    fn begin(&mut self, scene: Scene, notes: &[String]) -> (Changed, Reply) {
        let left = self.quiz.take().is_some();
        self.scene = scene;
        self.broken = None;
        self.canvas.forget();
        self.leave();
        let mut reply = Reply::default();
        if !notes.is_empty() {
            reply.message = Some(Message::new(Tone::Note, notes.join("; ")));
        }
        if left {
            reply.quiz = Some(Question::default());
        }
        (ALL, reply)
    }

    fn leave(&mut self) {
        self.chosen.clear();
        self.waiting = None;
        self.at = None;
    }

    fn polygon(&mut self, places: &[[f64; 2]]) -> Outcome {
        let points: Option<Vec<Point>> = places.iter().map(|&[x, y]| self.canvas.point(x, y)).collect();
        let points = points.ok_or("there is no picture to click in: start with another scene first")?;
        if points.len() < 3 {
            return Err("a polygon has at least three corners: click more places".to_owned());
        }
        let scene = Scene::polygon(&points)?;
        Ok(self.begin(scene, &[]))
    }

    fn follow_link(&mut self, text: &str) -> Outcome {
        let text = link::read(text)?;
        let (scene, broken) = text.rsplit_once('\u{1e}').ok_or("the link holds no scene; copy it again")?;
        let scene = Scene::remade(scene)?;
        let mut session = Self { canvas: self.canvas.clone(), ..Self::new() };
        let begun = session.begin(scene, &[]);
        for line in broken.lines().filter(|line| !line.is_empty()) {
            let words: Vec<&str> = line.split(' ').collect();
            let [id, pointer, to] = words[..] else { return Err("the link holds no scene; copy it again".to_owned()) };
            session.lead(id, pointer, to)?;
        }
        let mut begun = begun;
        if self.quiz.is_some() {
            begun.1.quiz = Some(Question::default());
        }
        *self = session;
        Ok(begun)
    }

    fn keep(&mut self) -> Outcome {
        let Scene::Points(points) = &self.scene else { return Err("this scene is a structure already".to_owned()) };
        let scene = Scene::of_plane(points.delaunay().clone(), "the Delaunay triangulation of points");
        let mut begun = self.begin(scene, &[]);
        begun.1.message = Some(Message::new(Tone::Done, "the triangulation is a structure to edit now"));
        Ok(begun)
    }

    /// A script with a start replaces the scene; lines without one are carried out on it, all or none.
    fn script(&mut self, text: &str) -> Outcome {
        if super::scene::starts_as_script(text) {
            let (scene, notes) = Scene::script(text, "script")?;
            return Ok(self.begin(scene, &notes));
        }
        self.may_edit()?;
        let lines: Vec<(usize, &str)> = (1..)
            .zip(text.lines())
            .filter(|(_, line)| !line.split('#').next().unwrap_or("").trim().is_empty())
            .collect();
        if let Some(quiz) = &self.quiz {
            let word = |line: &str| {
                let rest = line.split_once('=').map_or(line, |(_, rest)| rest);
                rest.split_whitespace().next().unwrap_or("").to_owned()
            };
            if let Some((_, line)) = lines.iter().find(|(_, line)| !quiz.round.allows(&word(line))) {
                return Err(format!("`{}`: only split_face and split_in_half draw this", word(line)));
            }
        }
        let many = lines.len() > 1;
        let mut scene = self.scene.clone();
        let mut done = Vec::new();
        for (number, line) in lines {
            let one = match &mut scene {
                Scene::Plane { work, .. } => work.line(line),
                Scene::Kernel(work) => work.line(line),
                Scene::Points(_) => {
                    Err(LineError::Refused("points have no script: keep the triangulation first".to_owned()))
                }
            };
            match one {
                Ok(one) => done.push(one),
                Err(error) if many => {
                    return Err(format!("line {number} of what was given: {error}; nothing was done"));
                }
                Err(error) => return Err(error.to_string()),
            }
        }
        self.scene = scene;
        let Some(last) = done.pop() else { return Ok((NOTHING, Reply::default())) };
        let count = done.len() + 1;
        let text = if many { format!("{count} lines done; the last: {}", last.text) } else { last.text.clone() };
        Ok(self.edited(Done { text, ..last }, count))
    }

    // Picking.

    fn under(&self, x: f64, y: f64, reach: f64) -> Option<Element> {
        if let Some(table) = self.quiz.as_ref().and_then(|quiz| quiz.round.table()) {
            return self.canvas.pick_in_table(table, x, y, reach);
        }
        self.canvas.pick(self.scene.subdivision()?, x, y, reach)
    }

    fn pick(&mut self, found: Element, at: Option<[f64; 2]>) -> Outcome {
        if self.quiz.as_ref().is_some_and(|quiz| quiz.round.wants(false)) {
            return match found {
                Element::HalfEdge(h) => self.answer(&h.to_string()),
                _ => said(NOTHING, Tone::Note, format!("this is {found}: click a half-edge, on its side of the edge")),
            };
        }
        let place = at.and_then(|[x, y]| self.canvas.point(x, y));
        if let Some(row) = self.waiting {
            return self.complete(row, found);
        }
        let before = self.chosen.last().copied();
        if let (Scene::Points(_), Element::Face(_) | Element::HalfEdge(_), Some(p)) = (&self.scene, found, place)
            && self.quiz.is_none()
        {
            return self.change_points(|points| points.add(p), format!("a point at ({}, {})", p.x, p.y));
        }
        if let (Scene::Plane { .. }, Some(Element::Vertex(u)), Element::Vertex(v)) = (&self.scene, before, found)
            && u != v
            && self.broken.is_none()
            && self.may_edit().is_ok()
        {
            return self.join_corners(u, v);
        }
        if before == Some(found) && matches!(found, Element::Vertex(_)) {
            self.leave();
            return Ok((SELECTION, Reply::default()));
        }
        self.chosen = vec![found];
        self.at = place;
        Ok((SELECTION, Reply::default()))
    }

    /// `split_face` between two corners: of the half-edges that start there, those in whose corners the segment begins and
    /// ends; along an edge, those that have one face, a bounded one if there is one.
    fn join_corners(&mut self, u: VertexId, v: VertexId) -> Outcome {
        let Some(s) = self.scene.subdivision() else { return Err("this scene has no places".to_owned()) };
        let (from, to) = (s.corners_towards(u, s.point(v)), s.corners_towards(v, s.point(u)));
        let pairs = from.iter().flat_map(|&a| to.iter().map(move |&b| (a, b)));
        let best = pairs.min_by_key(|&(a, b)| (s.face(a) != s.face(b), s.face(a) == s.outer_face()));
        let call = match best {
            Some((a, b)) => Call::new(&rows::split_face, [Argument::from(a), Argument::from(b)]),
            // A vertex without edges has no corner: the plane's own word for joining two vertices.
            None => Call::new(&rows::insert_edge, [Argument::from(u), Argument::from(v)]),
        };
        let refused = self.plane_edit(call.map_err(|error| error.to_string())?);
        if refused.is_err() {
            self.chosen = vec![v.into()];
            let message = refused.as_ref().err().map(|reason| Message::new(Tone::Refused, reason.clone()));
            let mut reply = Reply { message, ..Reply::default() };
            self.mark_refused(&mut reply);
            return Ok((SELECTION, reply));
        }
        refused
    }

    fn follow(&mut self, link: &str) -> Outcome {
        let Some(&from) = self.chosen.last() else { return Err("select a half-edge first".to_owned()) };
        if self.quiz.as_ref().is_some_and(|quiz| !quiz.round.shows_tables()) {
            return Err("follow the links in your head: that is the question".to_owned());
        }
        let known = walk::link(link).ok_or_else(|| format!("`{link}` is no link"))?;
        let table = self.table();
        let to = walk::step(&table, from, known);
        let Some(to) = to.filter(|&to| tables::exists(&table, to)) else {
            return Err(format!("{from}.{link} leads nowhere"));
        };
        // While an edit waits for a second element, the first one stays.
        if self.waiting.is_some() && self.chosen.len() == 1 {
            self.chosen.push(to);
        } else {
            self.chosen.pop();
            self.chosen.push(to);
        }
        let text = format!("{from}.{link} = {to}");
        Ok((SELECTION, Reply { message: Some(Message::new(Tone::Done, text)), ..Reply::default() }))
    }

    fn walk(&mut self, path: &str) -> Outcome {
        if self.quiz.as_ref().is_some_and(|quiz| !quiz.round.shows_tables()) {
            return Err("follow the links in your head: that is the question".to_owned());
        }
        let walked = walk::walk(&self.table(), path)?;
        let Some(&last) = walked.last() else { return Err("write a path such as h2.next.twin".to_owned()) };
        self.chosen = vec![last];
        let trail: Vec<String> = walked.iter().map(ToString::to_string).collect();
        let text = format!("{} = {last}", path.trim());
        let message = Some(Message { tone: Tone::Done, text, elements: vec![last.to_string()] });
        Ok((SELECTION, Reply { message, trail: Some(trail), ..Reply::default() }))
    }

    // Edits.

    fn may_edit(&self) -> Result<(), String> {
        if self.broken.is_some() {
            return Err("pointers were led elsewhere by hand: mend them before the next edit".to_owned());
        }
        if self.quiz.as_ref().is_some_and(|quiz| quiz.round.table().is_some()) {
            return Err("this is a question: nothing can be edited in it".to_owned());
        }
        Ok(())
    }

    fn edit_selected(&mut self, word: &str) -> Outcome {
        self.may_edit()?;
        let &chosen = self.chosen.first().ok_or("select an element first")?;
        if let Scene::Points(_) = self.scene {
            let Element::Vertex(v) = chosen else { return Err("select a point first".to_owned()) };
            if word != "remove_vertex" {
                return Err(format!("points have no `{word}`: keep the triangulation first"));
            }
            return self.change_points(|points| points.remove(v.index()), format!("{v} removed"));
        }
        if let Some(quiz) = &self.quiz
            && !quiz.round.allows(word)
        {
            return Err(format!("`{word}`: only split_face and split_in_half draw this"));
        }
        let row = match self.scene {
            Scene::Kernel(_) => find::<Dcel>(word),
            _ => find::<Subdivision>(word),
        };
        let row = row.ok_or_else(|| format!("there is no edit `{word}` here"))?;
        let needs = row.takes.iter().filter(|parameter| matches!(parameter.takes, Takes::Element(_))).count();
        if needs > 1 {
            if let &[_, second] = &self.chosen[..] {
                return self.complete(row, second);
            }
            self.waiting = Some(row);
            return said(SELECTION, Tone::Note, format!("{word} {chosen} …: choose the second element"));
        }
        let arguments = self.arguments(row, &[chosen])?;
        self.call(row, arguments)
    }

    /// The waiting edit with its second element.
    fn complete(&mut self, row: &'static Row, second: Element) -> Outcome {
        let &first = self.chosen.first().ok_or("select an element first")?;
        let arguments = self.arguments(row, &[first, second])?;
        let outcome = self.call(row, arguments);
        if outcome.is_ok() {
            self.waiting = None;
        }
        outcome
    }

    /// The arguments of a row from the elements that are selected.
    fn arguments(&self, row: &Row, elements: &[Element]) -> Result<Vec<Argument>, String> {
        let mut elements = elements.iter();
        let mut out = Vec::new();
        for parameter in row.takes {
            out.push(match parameter.takes {
                Takes::Element(kind) => {
                    let &given = elements.next().ok_or("select an element first")?;
                    let fits = match (kind, given) {
                        (Kind::Edge, Element::HalfEdge(h)) => Some(h.edge().into()),
                        (Kind::HalfEdge, Element::Edge(e)) => Some(e.half_edges()[0].into()),
                        (kind, given) => (Kind::of(given) == kind).then_some(given),
                    };
                    Argument::Element(fits.ok_or_else(|| {
                        format!("`{given}` is {}, but {} needs {}", Kind::of(given).a(), row.word, kind.a())
                    })?)
                }
                Takes::Place if matches!(self.scene, Scene::Kernel(_)) => continue,
                Takes::Place => self.at.ok_or("click a place in a face first")?.into(),
                Takes::Switch => {
                    let holes = self.scene.subdivision();
                    let face = self.chosen.first().copied();
                    let is_hole = |f| holes.is_some_and(|s| s.is_hole(f));
                    Argument::Switch(!matches!(face, Some(Element::Face(f)) if is_hole(f)))
                }
                _ => return Err(format!("type {} as a line of the script", row.word)),
            });
        }
        Ok(out)
    }

    fn call(&mut self, row: &'static Row, arguments: Vec<Argument>) -> Outcome {
        match &mut self.scene {
            Scene::Kernel(work) => {
                let call = Call::<Dcel>::new(row, arguments).map_err(|error| error.to_string())?;
                let done = work.edit(call, None).map_err(|error| error.to_string())?;
                Ok(self.edited(done, 1))
            }
            _ => self.plane_edit(Call::new(row, arguments).map_err(|error| error.to_string())?),
        }
    }

    fn plane_edit(&mut self, call: Call<Subdivision>) -> Outcome {
        self.may_edit()?;
        let Scene::Plane { work, .. } = &mut self.scene else { return Err("this scene has no places".to_owned()) };
        let done = work.edit(call, None).map_err(|error| error.to_string())?;
        Ok(self.edited(done, 1))
    }

    /// After an edit: what it made is selected.
    fn edited(&mut self, done: Done, count: usize) -> (Changed, Reply) {
        self.waiting = None;
        let table = self.scene.table();
        let first = done.elements.iter().copied().find(|&element| tables::exists(&table, element));
        let is_new = |element: &Element| matches!(element, Element::HalfEdge(_));
        let half_edge = done.elements.iter().copied().find(|e| is_new(e) && tables::exists(&table, *e));
        self.chosen = half_edge.or(first).into_iter().collect();
        let message = Some(Message::new(Tone::Done, done.text));
        let mut reply = Reply { message, ..Reply::default() };
        if let (Some(quiz), Some(s)) = (&mut self.quiz, self.scene.subdivision()) {
            let verdict = (0..count).fold(None, |last, _| quiz.round.moved(s).or(last));
            if let Some(verdict) = verdict {
                reply.message = Some(Message::new(Tone::Right, verdict.text));
            }
        }
        (ALL, reply)
    }

    fn change_points(
        &mut self,
        change: impl FnOnce(&mut super::points::Points) -> Result<(), String>,
        text: String,
    ) -> Outcome {
        self.may_edit()?;
        let Scene::Points(points) = &mut self.scene else {
            return Err("this scene has no points of its own".to_owned());
        };
        change(points)?;
        self.leave();
        said(ALL, Tone::Done, text)
    }

    fn undo(&mut self) -> Outcome {
        if let Some(broken) = &mut self.broken {
            let what = broken.undo();
            if broken.kept().is_empty() {
                self.broken = None;
            }
            return said(ALL, Tone::Done, what.map_or_else(String::new, |what| format!("taken back: {what}")));
        }
        self.may_edit()?;
        let undone = match &mut self.scene {
            Scene::Plane { work, .. } => work.undo(),
            Scene::Kernel(work) => work.undo(),
            Scene::Points(points) => points.undo().then(|| "the last change".to_owned()),
        };
        let what = undone.ok_or("there is nothing to undo")?;
        self.leave();
        said(ALL, Tone::Done, format!("taken back: {what}"))
    }

    fn redo(&mut self) -> Outcome {
        self.may_edit()?;
        let done = match &mut self.scene {
            Scene::Plane { work, .. } => work.redo(),
            Scene::Kernel(work) => work.redo(),
            Scene::Points(points) => points.redo().then(|| "the next change".to_owned()),
        };
        let what = done.ok_or("there is nothing to do again")?;
        self.leave();
        said(ALL, Tone::Done, format!("done again: {what}"))
    }

    // Moving.

    fn vertex(&self, id: &str) -> Result<VertexId, String> {
        match tables::find(&self.scene.table(), id)? {
            Element::Vertex(v) => Ok(v),
            other => Err(format!("{other} cannot be dragged: only vertices can")),
        }
    }

    fn drag(&mut self, id: &str, x: f64, y: f64) -> Outcome {
        self.may_edit()?;
        let Some(Element::Vertex(v)) = element(id) else {
            return Err(format!("{id} cannot be dragged: only vertices can"));
        };
        let p = self.canvas.point(x, y).ok_or("there is no picture to drag in")?;
        if let Scene::Points(points) = &self.scene {
            let held = points.held(v.index(), p)?;
            let mut reply = Reply::default();
            let table = super::scene::planar_table(held.delaunay());
            let options = self.canvas.options(TITLE);
            let figure = self.canvas.draw(&table, options, false).map_err(|error| error.to_string())?;
            reply.svg = Some(figure.to_svg());
            reply.over = Some(held.over(&self.canvas));
            return Ok((NOTHING, reply));
        }
        let Scene::Plane { work, .. } = &self.scene else {
            return Err("without coordinates nothing can be dragged".to_owned());
        };
        let s = work.now();
        s.topology().check(v).map_err(|error| error.to_string())?;
        let verdict = s.can_set_point(v, p);
        let mut over = Over::default();
        let class = if verdict.is_ok() { "drag" } else { "drag bad" };
        let table = self.table();
        if let Err(error) = &verdict {
            for crossed in named(&error.to_string()).into_iter().filter(|&element| element != v.into()) {
                over.mark("mark bad", &self.canvas, &table, crossed);
            }
        }
        if let Some(at) = self.canvas.place(p) {
            for h in s.outgoing_half_edges(v) {
                if let Some(end) = self.canvas.place(s.point(s.destination(h))) {
                    over.line(class, at, end);
                }
            }
            over.circle(class, at, 8.0);
        }
        let message = match verdict {
            Ok(()) => Message::new(Tone::Note, format!("{v} at ({}, {})", p.x, p.y)),
            Err(error) => Message::new(Tone::Refused, error.to_string()),
        };
        Ok((NOTHING, Reply { over: Some(over.0), message: Some(message), ..Reply::default() }))
    }

    fn drop_at(&mut self, id: &str, x: f64, y: f64) -> Outcome {
        let v = self.vertex(id)?;
        let p = self.canvas.point(x, y).ok_or("there is no picture to drag in")?;
        self.put(v, p)
    }

    fn nudge(&mut self, id: &str, x: f64, y: f64) -> Outcome {
        let v = self.vertex(id)?;
        let step = self.canvas.step();
        let at = self.scene.subdivision().ok_or("without coordinates nothing can be moved")?.point(v);
        let moved = self.put(v, Point::new(at.x + step * x, at.y + step * y))?;
        self.chosen = vec![v.into()];
        Ok(moved)
    }

    fn put(&mut self, v: VertexId, p: Point) -> Outcome {
        self.may_edit()?;
        if let Some(quiz) = &self.quiz
            && !quiz.round.allows("set_point")
        {
            return Err("only split_face and split_in_half draw this: corners stay where they are".to_owned());
        }
        if let Scene::Points(_) = self.scene {
            return self.change_points(|points| points.place(v.index(), p), format!("{v} at ({}, {})", p.x, p.y));
        }
        let call = Call::new(&rows::set_point, [Argument::from(v), Argument::from(p)]);
        let moved = self.plane_edit(call.map_err(|error| error.to_string())?)?;
        self.chosen = vec![v.into()];
        Ok(moved)
    }

    // Breaking.

    fn lead(&mut self, id: &str, pointer: &str, to: &str) -> Outcome {
        if self.quiz.as_ref().is_some_and(|quiz| quiz.round.wants(true)) {
            return self.answer(&format!("{id}.{pointer}"));
        }
        if self.quiz.is_some() {
            return Err("this is a question: no pointer can be led elsewhere in it".to_owned());
        }
        if !matches!(self.scene, Scene::Plane { .. }) {
            return Err("pointers can be led elsewhere in structures of the plane: begin with the rectangle".to_owned());
        }
        let mut broken = self.broken.clone().unwrap_or_else(|| Broken::new(self.scene.table()));
        let text = broken.lead(id, pointer, to)?;
        let faults = broken.faults();
        self.broken = Some(broken);
        self.leave();
        let text = match faults.len() {
            0 => format!("{text}: every invariant holds"),
            1 => format!("{text}: 1 invariant is broken"),
            n => format!("{text}: {n} invariants are broken"),
        };
        said(ALL, Tone::Note, text)
    }

    // Files.

    fn export(&mut self, what: &str) -> Outcome {
        let text = match what {
            "svg" => {
                let mut reply = Reply::default();
                let table = self.table();
                self.draw(&table, &mut reply);
                let svg = reply.svg.ok_or("there is no picture")?;
                file("drawing.svg", "image/svg+xml", svg)
            }
            "dcel" => {
                let table = self.table();
                file("drawing.dcel", "text/plain", dcel_text(&Model::table(&table)))
            }
            "script" => {
                let script = match &self.scene {
                    Scene::Plane { work, .. } => work.script(),
                    Scene::Kernel(work) => work.script(),
                    Scene::Points(_) => return Err("points have no script: keep the triangulation first".to_owned()),
                };
                file("drawing.dcels", "text/plain", script)
            }
            "film" | "play" => {
                let last = if what == "play" { 1 } else { usize::MAX };
                let (page, note) = match &self.scene {
                    Scene::Plane { work, .. } => film::page(work, last, "Edits, step by step")?,
                    Scene::Kernel(work) => film::page(work, last, "Edits, step by step")?,
                    Scene::Points(_) => {
                        return Err("points have no edits to play: keep the triangulation first".to_owned());
                    }
                };
                let mut reply = file("film.html", "text/html", page);
                if !note.is_empty() {
                    reply.message = Some(Message::new(Tone::Note, note));
                }
                reply
            }
            _ => return Err(format!("there is no file `{what}`")),
        };
        Ok((NOTHING, text))
    }

    // Quizzes.

    fn begin_quiz(&mut self, what: &str, level: u32, seed: u64) -> Outcome {
        let round = Round::new(what, level, seed)?;
        let before = match self.quiz.take() {
            Some(quiz) => quiz.before,
            None => Box::new(std::mem::replace(&mut self.scene, Scene::rectangle())),
        };
        self.broken = None;
        self.quiz = Some(Quiz { round, before });
        self.show_question();
        Ok((ALL, Reply::default()))
    }

    fn show_question(&mut self) {
        self.canvas.forget();
        self.leave();
        self.scene = Scene::rectangle();
        let start = self.quiz.as_ref().and_then(|quiz| quiz.round.start());
        self.chosen = start.into_iter().collect();
    }

    fn answer(&mut self, answer: &str) -> Outcome {
        let drawn = self.scene.subdivision().cloned();
        let quiz = self.quiz.as_mut().ok_or("no quiz is on")?;
        let Verdict { right, over, text, trail } = quiz.round.answer(answer, drawn.as_ref())?;
        let tone = if right { Tone::Right } else { Tone::Refused };
        let trail: Vec<String> = trail.iter().map(ToString::to_string).collect();
        let mut reply = Reply { message: Some(Message::new(tone, text)), ..Reply::default() };
        if over && !trail.is_empty() {
            reply.trail = Some(trail);
        }
        Ok((ALL, reply))
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
