//! Questions to practise with. A seed makes them the same for everybody; their answers come from the library.
//!
//! ```text
//!   where_am_i.rs    follow links in your head, click where you are
//!   make_drawing.rs  make a drawing with the two splits (drawings/: what is to be made, as polygons)
//!   find_fault.rs    which pointer is wrong?
//!   predict.rs       which of these calls is refused, and why?
//!   structures.rs    what is asked about          code.rs  the result as a word to hand in
//!   tests.rs         the answers against the library
//! ```

mod code;
mod find_fault;
mod make_drawing;
mod predict;
mod structures;
mod where_am_i;

pub(super) use code::read as read_code;

use super::dice::Dice;
use super::reply::{Message, Question};
use crate::ids::Element;
use crate::plane::Subdivision;
use crate::topology::Table;
use find_fault::FindFault;
use make_drawing::MakeDrawing;
use predict::Predict;
use where_am_i::WhereAmI;

/// How many questions a round has, except of drawings.
const QUESTIONS: usize = 5;

/// What came of an answer.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Verdict {
    pub(super) right: bool,
    /// Whether the question is answered for good.
    pub(super) over: bool,
    pub(super) text: String,
    pub(super) trail: Vec<Element>,
}

/// The kinds of questions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    WhereAmI,
    MakeDrawing,
    FindFault,
    Predict,
}

impl Kind {
    const ALL: [(&'static str, &'static str, Self); 4] = [
        ("where_am_i", "Where am I?", Self::WhereAmI),
        ("make_drawing", "Make this drawing", Self::MakeDrawing),
        ("find_fault", "Find the fault", Self::FindFault),
        ("predict", "Predict the verdict", Self::Predict),
    ];

    fn names(self) -> (&'static str, &'static str) {
        Self::ALL.iter().find(|(.., kind)| *kind == self).map_or(("", ""), |&(word, title, _)| (word, title))
    }
}

#[derive(Clone, Debug)]
enum Task {
    WhereAmI(WhereAmI),
    MakeDrawing(MakeDrawing),
    FindFault(FindFault),
    Predict(Predict),
}

/// A round of questions.
#[derive(Clone, Debug)]
pub(super) struct Round {
    kind: Kind,
    level: u32,
    seed: u64,
    number: usize,
    right: usize,
    answered: bool,
    task: Task,
}

impl Round {
    pub(super) fn new(what: &str, level: u32, seed: u64) -> Result<Self, String> {
        let known = Kind::ALL.iter().find(|(word, ..)| *word == what);
        let &(.., kind) = known.ok_or_else(|| format!("there is no quiz `{what}`"))?;
        let level = level.clamp(1, 3);
        // Seeds are written and compared by people: small ones.
        let seed = seed % 1_000_000;
        Ok(Self { kind, level, seed, number: 0, right: 0, answered: false, task: task(kind, level, seed, 0) })
    }

    fn count(&self) -> usize {
        if self.kind == Kind::MakeDrawing { make_drawing::count(self.level) } else { QUESTIONS }
    }

    /// What is shown, if it is not to be edited.
    pub(super) fn table(&self) -> Option<&Table> {
        match &self.task {
            Task::WhereAmI(task) => Some(&task.table),
            Task::FindFault(task) => Some(&task.table),
            Task::Predict(task) => Some(&task.table),
            Task::MakeDrawing(_) => None,
        }
    }

    /// Whether the tables may be seen: they would answer some questions.
    pub(super) fn shows_tables(&self) -> bool {
        self.answered || matches!(self.task, Task::FindFault(_) | Task::MakeDrawing(_))
    }

    /// Broken invariants that may be seen.
    pub(super) fn faults(&self) -> Vec<Message> {
        match &self.task {
            Task::FindFault(task) => task.faults(self.answered),
            _ => Vec::new(),
        }
    }

    /// What is marked from the beginning.
    pub(super) fn start(&self) -> Option<Element> {
        match &self.task {
            Task::WhereAmI(task) => task.start(),
            _ => None,
        }
    }

    /// Whether an edit may be used.
    pub(super) fn allows(&self, word: &str) -> bool {
        matches!(self.task, Task::MakeDrawing(_)) && MakeDrawing::allows(word)
    }

    /// Whether a click on an element, or on the cell of a pointer, is an answer.
    pub(super) fn wants(&self, cell: bool) -> bool {
        !self.answered
            && match self.task {
                Task::WhereAmI(_) => !cell,
                Task::FindFault(_) => cell,
                _ => false,
            }
    }

    pub(super) fn question(&self) -> Question {
        let (word, title) = self.kind.names();
        let (text, choices, target) = match &self.task {
            Task::WhereAmI(task) => (task.text(), Vec::new(), String::new()),
            Task::MakeDrawing(task) => (task.text(), Vec::new(), task.picture()),
            Task::FindFault(task) => (task.text(), Vec::new(), String::new()),
            Task::Predict(task) => (task.text(), task.choices(), String::new()),
        };
        let count = self.count();
        let over = self.answered && self.number + 1 == count;
        let score = format!(
            "Question {} of {count}, {} right. Level {}, seed {}.",
            self.number + 1,
            self.right,
            self.level,
            self.seed
        );
        let code = if over { code::write(word, self.level, self.seed, self.right, count) } else { String::new() };
        let choices = if self.answered { Vec::new() } else { choices };
        Question {
            what: word.to_owned(),
            title: title.to_owned(),
            text,
            choices,
            target,
            score,
            answered: self.answered,
            code,
        }
    }

    /// An answer. Wrong words are an error, which costs nothing.
    pub(super) fn answer(&mut self, answer: &str, drawn: Option<&Subdivision>) -> Result<Verdict, String> {
        if self.answered {
            return Err("this question is answered: go on to the next one".to_owned());
        }
        let verdict = match &mut self.task {
            Task::WhereAmI(task) => task.answer(answer),
            Task::FindFault(task) => task.answer(answer),
            Task::Predict(task) => task.answer(answer),
            Task::MakeDrawing(task) => task.judge(drawn.ok_or("there is no drawing".to_owned())?),
        }?;
        self.take(&verdict);
        Ok(verdict)
    }

    /// An edit was made; says so if the drawing is made by it.
    pub(super) fn moved(&mut self, drawn: &Subdivision) -> Option<Verdict> {
        let Task::MakeDrawing(task) = &mut self.task else { return None };
        if self.answered {
            return None;
        }
        task.moved();
        let verdict = task.judge(drawn).ok()?;
        self.take(&verdict);
        Some(verdict)
    }

    fn take(&mut self, verdict: &Verdict) {
        if verdict.over {
            self.answered = true;
            self.right += usize::from(verdict.right);
        }
    }

    /// The next question.
    pub(super) fn next(&mut self) -> Result<(), String> {
        if !self.answered {
            return Err("answer this question first".to_owned());
        }
        if self.number + 1 == self.count() {
            return Err("the round is over: begin another one, or hand in the code".to_owned());
        }
        self.number += 1;
        self.answered = false;
        self.task = task(self.kind, self.level, self.seed, self.number);
        Ok(())
    }
}

fn task(kind: Kind, level: u32, seed: u64, number: usize) -> Task {
    let purpose = 1000 * (kind as u64 + 1) + 100 * u64::from(level) + number as u64;
    let dice = &mut Dice::new(seed, purpose);
    match kind {
        Kind::WhereAmI => Task::WhereAmI(WhereAmI::new(dice, level)),
        Kind::MakeDrawing => Task::MakeDrawing(MakeDrawing::new(level, number)),
        Kind::FindFault => Task::FindFault(FindFault::new(dice, level)),
        Kind::Predict => Task::Predict(Predict::new(dice, level)),
    }
}

#[cfg(test)]
mod tests;
