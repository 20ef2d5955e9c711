//! What is played with: a scene begins, by a word, a drawing, a link or lines of a script.

use super::{ALL, Changed, Message, NOTHING, Outcome, Question, Reply, Session, Tone, link};
use crate::plane::Point;
use crate::play::edits::Done;
use crate::play::scene::Scene;
use crate::script::Ground;

impl Session {
    pub(super) fn begin(&mut self, scene: Scene, notes: &[String]) -> (Changed, Reply) {
        let left = self.quiz.take().is_some();
        self.scene = scene;
        self.broken = None;
        self.canvas.forget();
        self.leave();
        let message = (!notes.is_empty()).then(|| Message::new(Tone::Note, notes.join("; ")));
        (ALL, Reply { message, quiz: left.then(Question::default), ..Reply::default() })
    }

    pub(super) fn leave(&mut self) {
        self.chosen.clear();
        self.waiting = None;
        self.at = None;
    }

    pub(super) fn polygon(&mut self, places: &[[f64; 2]]) -> Outcome {
        let points: Option<Vec<Point>> = places.iter().map(|&[x, y]| self.canvas.point(x, y)).collect();
        let points = points.ok_or("there is no picture to click in: start with another scene first")?;
        if points.len() < 3 {
            return Err("a polygon has at least three corners: click more places".to_owned());
        }
        let scene = Scene::polygon(&points)?;
        Ok(self.begin(scene, &[]))
    }

    pub(super) fn follow_link(&mut self, text: &str) -> Outcome {
        let text = link::read(text)?;
        let (scene, broken) = text.rsplit_once('\u{1e}').ok_or("the link holds no scene; copy it again")?;
        let scene = Scene::remade(scene)?;
        let mut session = Self { canvas: self.canvas.clone(), ..Self::new() };
        let mut begun = session.begin(scene, &[]);
        for line in broken.lines().filter(|line| !line.is_empty()) {
            let words: Vec<&str> = line.split(' ').collect();
            let [id, pointer, to] = words[..] else { return Err("the link holds no scene; copy it again".to_owned()) };
            session.lead(id, pointer, to)?;
        }
        if self.quiz.is_some() {
            begun.1.quiz = Some(Question::default());
        }
        *self = session;
        Ok(begun)
    }

    pub(super) fn keep(&mut self) -> Outcome {
        let Scene::Points(points) = &self.scene else { return Err("this scene is a structure already".to_owned()) };
        let scene = Scene::of_plane(points.delaunay().clone(), "the Delaunay triangulation of points");
        let mut begun = self.begin(scene, &[]);
        begun.1.message = Some(Message::new(Tone::Done, "the triangulation is a structure to edit now"));
        Ok(begun)
    }

    /// A script with a start replaces the scene; lines without one are carried out on it, all or none.
    pub(super) fn script(&mut self, text: &str) -> Outcome {
        if Ground::begun(text).is_some() {
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
                Scene::Points(_) => Err("points have no script: keep the triangulation first".to_owned()),
            };
            match one {
                Ok(one) => done.push(one),
                Err(error) if many => {
                    return Err(format!("line {number} of what was given: {error}; nothing was done"));
                }
                Err(error) => return Err(error),
            }
        }
        self.scene = scene;
        let Some(last) = done.pop() else { return Ok((NOTHING, Reply::default())) };
        let count = done.len() + 1;
        let text = if many { format!("{count} lines done; the last: {}", last.text) } else { last.text.clone() };
        Ok(self.edited(Done { text, ..last }, count))
    }
}
