//! What of a session is shown: the picture, the tables, counts and invariants, what is selected.

use super::{Changed, LONGEST_LINK, Over, Session, TITLE, tables};
use crate::edits::rows;
use crate::ids::Element;
use crate::io::counted;
use crate::play::reply::{Message, Reply, Selected, Status, Tone};
use crate::play::scene::{Scene, draw_kernel};
use crate::topology::{Table, has, measure};
use std::collections::BTreeSet;

impl Session {
    /// The pointers that are shown: of the scene, or as they were led, or of the question.
    pub(super) fn table(&self) -> Table {
        if let Some(broken) = &self.broken {
            return broken.table.clone();
        }
        let asked = self.quiz.as_ref().and_then(|quiz| quiz.round.table());
        asked.cloned().unwrap_or_else(|| self.scene.table())
    }

    pub(super) fn fill(&mut self, changed: Changed, reply: &mut Reply) {
        if changed.room {
            let table = self.table();
            self.draw(&table, reply);
            reply.over = self.drawn_over(&table);
        }
        if changed.structure {
            let table = self.table();
            self.draw(&table, reply);
            self.tell(&table, reply);
        }
        if changed.selection || changed.structure {
            self.select(reply);
        }
    }

    pub(super) fn draw(&mut self, table: &Table, reply: &mut Reply) {
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
    pub(super) fn tell(&self, table: &Table, reply: &mut Reply) {
        let counts = measure(table);
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
        let counts = [(v, "vertex", "vertices"), (e, "edge", "edges"), (f, "face", "faces")];
        let counts = counts.map(|(count, one, many)| counted(count, one, many)).join(", ");
        reply.status = Some(Status { counts, euler, violations, scene, history, over });
        let lines = match &self.scene {
            Scene::Plane { work, .. } => work.lines(),
            Scene::Kernel(work) => work.lines(),
            Scene::Points(_) => Vec::new(),
        };
        reply.script = Some(lines.into_iter().map(|line| [line.text, line.note]).collect());
        let link = self.link();
        reply.link = Some(if link.len() > LONGEST_LINK { String::new() } else { link });
        if let Some(quiz) = &self.quiz {
            reply.quiz = Some(quiz.round.question());
        }
    }

    pub(super) fn select(&self, reply: &mut Reply) {
        let table = self.table();
        let mut selected = match self.chosen.last() {
            Some(&last) if has(&table, last) => tables::describe(&table, last),
            _ => Selected::default(),
        };
        selected.ids = self.chosen.iter().map(ToString::to_string).collect();
        selected.waiting = self.waiting.map_or_else(String::new, |row| row.word.to_owned());
        if self.broken.is_none() && self.quiz.as_ref().is_none_or(|quiz| quiz.round.table().is_none()) {
            selected.edits = self.offers();
        }
        if self.quiz.as_ref().is_some_and(|quiz| !quiz.round.shows_tables()) {
            selected.pointers.clear();
        }
        reply.selected = Some(selected);
        reply.over = self.drawn_over(&table).or(reply.over.take());
    }

    /// What lies over the picture: lines of points, and marks where single half-edges are not drawn.
    fn drawn_over(&self, table: &Table) -> Option<String> {
        let points = if let Scene::Points(points) = &self.scene { Some(points.over(&self.canvas)) } else { None };
        if self.canvas.shows_half_edges() || matches!(self.scene, Scene::Kernel(_)) {
            return points;
        }
        let refused = if points.is_none() { self.marked("mark bad", &self.refused, table) } else { String::new() };
        Some(points.unwrap_or_default() + &self.marked("mark", &self.chosen, table) + &refused)
    }

    /// Elements marked over the picture.
    pub(super) fn marked(&self, class: &str, elements: &[Element], table: &Table) -> String {
        let mut over = Over::default();
        elements.iter().for_each(|&element| over.mark(class, &self.canvas, table, element));
        over.0
    }

    /// The edits that can be tried with what is selected.
    pub(super) fn offers(&self) -> Vec<[String; 3]> {
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
}
