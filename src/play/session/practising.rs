//! Rounds of questions.

use super::{ALL, Message, Outcome, Quiz, Reply, Scene, Session, Tone};
use crate::play::quizzes::{Round, Verdict};

impl Session {
    pub(super) fn begin_quiz(&mut self, what: &str, level: u32, seed: u64) -> Outcome {
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

    pub(super) fn show_question(&mut self) {
        self.canvas.forget();
        self.leave();
        self.scene = Scene::rectangle();
        let start = self.quiz.as_ref().and_then(|quiz| quiz.round.start());
        self.chosen = start.into_iter().collect();
    }

    pub(super) fn answer(&mut self, answer: &str) -> Outcome {
        let drawn = self.scene.subdivision().cloned();
        let quiz = self.quiz.as_mut().ok_or("no quiz is on")?;
        let Verdict { right, over, text, trail } = quiz.round.answer(answer, drawn.as_ref())?;
        let tone = if right { Tone::Right } else { Tone::Refused };
        let trail: Vec<String> = trail.iter().map(ToString::to_string).collect();
        let (message, trail) = (Some(Message::new(tone, text)), Some(trail).filter(|trail| over && !trail.is_empty()));
        Ok((ALL, Reply { message, trail, ..Reply::default() }))
    }
}
