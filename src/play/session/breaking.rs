//! Pointers that are led elsewhere by hand.

use super::{ALL, Broken, Outcome, Scene, Session, Tone, said};

impl Session {
    pub(super) fn lead(&mut self, id: &str, pointer: &str, to: &str) -> Outcome {
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
}
