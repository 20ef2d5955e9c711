//! What can be taken along: drawings, structures, scripts, films.

use super::{Message, NOTHING, Outcome, Reply, Session, Tone, file};
use crate::io::Model;
use crate::play::film;
use crate::play::scene::{Scene, dcel_text};

impl Session {
    pub(super) fn export(&mut self, what: &str) -> Outcome {
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
                let message = note.map(|note| Message::new(Tone::Note, note));
                Reply { message, ..file("film.html", "text/html", page) }
            }
            _ => return Err(format!("there is no file `{what}`")),
        };
        Ok((NOTHING, text))
    }
}
