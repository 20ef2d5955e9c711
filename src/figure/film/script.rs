//! The film of a script: captions and marks go to the edit after them.

use super::frames::Film;
use crate::edits::{Call, Editable};
use crate::ids::Element;
use crate::plane::Subdivision;
use crate::script::{Outcome, Script, Step};
#[cfg(feature = "solid")]
use crate::solid::Polyhedron;
use crate::topology::Dcel;
#[cfg(feature = "play")]
use crate::topology::Journal;
use std::ops::ControlFlow;

/// A structure whose edits can be filmed.
pub trait Filmed: Editable {
    /// Appends the structure to the states of a film.
    fn add_to(&self, film: &mut Film);
}

impl Filmed for Subdivision {
    fn add_to(&self, film: &mut Film) {
        film.add_planar(self);
    }
}

impl Filmed for Dcel {
    fn add_to(&self, film: &mut Film) {
        film.add_kernel(self);
    }
}

#[cfg(feature = "solid")]
impl Filmed for Polyhedron {
    fn add_to(&self, film: &mut Film) {
        film.add_solid(self);
    }
}

impl Film {
    /// The film of a whole script, of the plane, of the kernel or in space; refused statements are not in it.
    ///
    /// ```
    /// use dcel_kit::figure::{Film, FigureOptions};
    /// use dcel_kit::script::Script;
    /// let torus = Script::parse_kernel("torus\nlet a = split_vertex h0 h1\n", "example")?;
    /// let film = Film::of_script(&torus);
    /// let svg = film.strip(&FigureOptions::new("Torus"))?.to_svg();
    /// assert!(svg.contains("id=\"torus-0-v0-4\""), "the square has four corners, all of them v0");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn of_script<G: Filmed>(script: &Script<G>) -> Self {
        let mut film = ScriptFilm::new(script);
        script.play(|step, after| {
            film.watch(&step, after);
            ControlFlow::Continue(())
        });
        film.finish()
    }
}

#[cfg(feature = "play")]
impl Film {
    /// A film that begins with this structure, of any kind.
    pub(crate) fn starting<G: Filmed>(start: &G) -> Self {
        let mut film = Self::empty();
        start.add_to(&mut film);
        film
    }

    /// Appends an edit to it.
    pub(crate) fn filmed<G: Filmed>(&mut self, title: &str, marked: &[Element], journal: &Journal, after: &G) {
        self.add_shot(title, "", marked, journal);
        after.add_to(self);
    }
}

/// Films a script while it is being carried out; see [`Script::play`].
#[derive(Clone, Debug)]
pub struct ScriptFilm {
    film: Film,
    caption: String,
    marked: Vec<Element>,
}

impl ScriptFilm {
    /// A film that begins with the start of the script.
    #[must_use]
    pub fn new<G: Filmed>(script: &Script<G>) -> Self {
        let mut film = Film::empty();
        script.start().add_to(&mut film);
        Self { film, caption: String::new(), marked: Vec::new() }
    }

    /// Takes up a step; `after` is the structure after it.
    pub fn watch<G: Filmed>(&mut self, step: &Step<Call<G>>, after: &G) {
        match &step.outcome {
            Outcome::Caption(text) => self.caption.clone_from(text),
            Outcome::Highlighted(elements) => self.marked.clone_from(elements),
            Outcome::Edited { edit, journal, .. } => {
                let caption = std::mem::take(&mut self.caption);
                let mut marked = std::mem::take(&mut self.marked);
                if marked.is_empty() {
                    marked = edit.elements();
                }
                self.film.add_shot(&edit.to_string(), &caption, &marked, journal);
                after.add_to(&mut self.film);
            }
            _ => {}
        }
    }

    /// The film. A caption and marks without an edit after them belong to the last frame.
    #[must_use]
    pub fn finish(mut self) -> Film {
        self.film.close(&self.caption, &self.marked);
        self.film
    }
}
