//! Edits of what is selected; undo and redo.

use super::{ALL, Changed, Message, Outcome, Reply, SELECTION, Scene, Session, Tone, points, said};
use crate::edits::{Argument, Call, Kind, Row, Takes, find};
use crate::ids::Element;
use crate::plane::Subdivision;
use crate::play::edits::Done;
use crate::topology::{Dcel, has};

impl Session {
    pub(super) fn may_edit(&self) -> Result<(), String> {
        if self.broken.is_some() {
            return Err("pointers were led elsewhere by hand: mend them before the next edit".to_owned());
        }
        if self.quiz.as_ref().is_some_and(|quiz| quiz.round.table().is_some()) {
            return Err("this is a question: nothing can be edited in it".to_owned());
        }
        Ok(())
    }

    pub(super) fn edit_selected(&mut self, word: &str) -> Outcome {
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
    pub(super) fn complete(&mut self, row: &'static Row, second: Element) -> Outcome {
        let &first = self.chosen.first().ok_or("select an element first")?;
        let arguments = self.arguments(row, &[first, second])?;
        let outcome = self.call(row, arguments);
        if outcome.is_ok() {
            self.waiting = None;
        }
        outcome
    }

    /// The arguments of a row from the elements that are selected.
    pub(super) fn arguments(&self, row: &Row, elements: &[Element]) -> Result<Vec<Argument>, String> {
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

    pub(super) fn call(&mut self, row: &'static Row, arguments: Vec<Argument>) -> Outcome {
        match &mut self.scene {
            Scene::Kernel(work) => {
                let call = Call::<Dcel>::new(row, arguments).map_err(|error| error.to_string())?;
                let done = work.edit(call, None).map_err(|error| error.to_string())?;
                Ok(self.edited(done, 1))
            }
            _ => self.plane_edit(Call::new(row, arguments).map_err(|error| error.to_string())?),
        }
    }

    pub(super) fn plane_edit(&mut self, call: Call<Subdivision>) -> Outcome {
        self.may_edit()?;
        let Scene::Plane { work, .. } = &mut self.scene else { return Err("this scene has no places".to_owned()) };
        let done = work.edit(call, None).map_err(|error| error.to_string())?;
        Ok(self.edited(done, 1))
    }

    /// After an edit: what it made is selected.
    pub(super) fn edited(&mut self, done: Done, count: usize) -> (Changed, Reply) {
        self.waiting = None;
        let table = self.scene.table();
        let first = done.elements.iter().copied().find(|&element| has(&table, element));
        let is_new = |element: &Element| matches!(element, Element::HalfEdge(_));
        let half_edge = done.elements.iter().copied().find(|e| is_new(e) && has(&table, *e));
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

    pub(super) fn change_points(
        &mut self,
        change: impl FnOnce(&mut points::Points) -> Result<(), String>,
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

    pub(super) fn undo(&mut self) -> Outcome {
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

    pub(super) fn redo(&mut self) -> Outcome {
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
}
