//! The film of a script: captions and marks go to the edit after them.

use dcel_kit::figure::Film;
use dcel_kit::ids::Element;
use dcel_kit::plane::Subdivision;
use dcel_kit::script::{Outcome, Script, Step};

/// Watches a script being carried out.
pub(crate) struct Camera {
    film: Film,
    caption: String,
    marked: Vec<Element>,
}

impl Camera {
    pub(crate) fn new(script: &Script) -> Self {
        Self { film: Film::new(script.start()), caption: String::new(), marked: Vec::new() }
    }

    /// Takes up a step; `after` is the structure after it.
    pub(crate) fn watch(&mut self, step: &Step, after: &Subdivision) {
        match &step.outcome {
            Outcome::Caption(text) => self.caption.clone_from(text),
            Outcome::Highlighted(elements) => self.marked.clone_from(elements),
            Outcome::Edited { edit, journal, .. } => {
                let caption = std::mem::take(&mut self.caption);
                let mut marked = std::mem::take(&mut self.marked);
                if marked.is_empty() {
                    marked = edit.elements();
                }
                self.film.edit(&edit.to_string(), &caption, &marked, journal, after);
            }
            _ => {}
        }
    }

    /// The film. A caption and marks without an edit after them belong to the last frame.
    pub(crate) fn finish(mut self) -> Film {
        self.film.close(&self.caption, &self.marked);
        self.film
    }
}

/// The film of a whole script; refused statements are not in it.
pub(crate) fn film(script: &Script) -> Film {
    let mut camera = Camera::new(script);
    script.play(|step, after| {
        camera.watch(&step, after);
        std::ops::ControlFlow::Continue(())
    });
    camera.finish()
}
