//! A film of edits as a strip, a stepper, a page, or single frames.

use super::draw::{Stage, union};
use super::frames::Film;
use super::reel::Reel;
use super::sides;
use crate::figure::{Figure, FigureError, FigureOptions};

impl Film {
    /// A strip: all frames side by side, in rows. The width of the options is that of one frame (default 408,
    /// two on a page of 830 px; more until the median edge has 110 px, and no more than the page). Ids read `FIG-3-h5` for `h5` in the fourth frame (the first is
    /// 0), `FIG-3-h5-next` for its pointer, `FIG-3-h5-next-gone` for the one that the step has replaced.
    ///
    /// Cost: O(frames x n log n) for n half-edges.
    ///
    /// # Errors
    /// Those of [`structure`](crate::figure::structure()), and [`FigureError::NoRoom`] if half-edges would be too
    /// short to draw.
    pub fn strip(&self, options: &FigureOptions) -> Result<Figure, FigureError> {
        Ok(self.reel(options)?.sheet(options, false))
    }

    /// A stepper: one frame at a time, with links to the one before and the one after; no script. The fragment
    /// `#FIG-step-3` opens the fourth frame. Where style rules are not known, and in print, it is the strip.
    ///
    /// # Errors
    /// Those of [`strip`](Self::strip).
    pub fn stepper(&self, options: &FigureOptions) -> Result<Figure, FigureError> {
        Ok(self.reel(options)?.sheet(options, true))
    }

    /// A page that plays the film: buttons, keys, a slider, and an address for each frame. Without a script it is the
    /// [`stepper`](Self::stepper). Nothing comes from outside.
    ///
    /// # Errors
    /// Those of [`strip`](Self::strip).
    pub fn page(&self, options: &FigureOptions) -> Result<String, FigureError> {
        Ok(self.reel(options)?.page(options))
    }

    /// Each frame alone, all of one size.
    ///
    /// # Errors
    /// Those of [`strip`](Self::strip).
    pub fn singles(&self, options: &FigureOptions) -> Result<Vec<Figure>, FigureError> {
        Ok(self.reel(options)?.singles(options))
    }

    /// The frames, drawn.
    fn reel(&self, options: &FigureOptions) -> Result<Reel, FigureError> {
        let mut options = options.of_panels();
        options.crop = None;
        let roomy = self.with_room(&mut options)?;
        let film = roomy.as_ref().unwrap_or(self);
        let options = &options;
        let frames = film.frames();
        let captions = frames.iter().map(|frame| (frame.heading.clone(), frame.text.clone())).collect();
        #[cfg(feature = "solid")]
        if !self.solids.is_empty() {
            let (scene, drawings, detail) = super::space::draw(&self.solids, &frames, options)?;
            return Ok(Reel { scene, captions, drawings, detail, notes: Vec::new() });
        }
        let (placed, names) = film.placed();
        let options = &sides::labelled(options, &names);
        let union = union(&placed);
        let mut stage = Stage::new(&film.states, &placed, &union, options)?;
        if roomy.is_some() {
            stage.leave_out_short();
        }
        let mut scene = stage.plates[0].picture.scene(Vec::new());
        scene.css.push_str(&sides::css(&options.style, &scene.prefix, &placed));
        let drawings = frames.iter().enumerate().map(|(i, frame)| stage.draw(frame, &i.to_string())).collect();
        let detail = stage.plates[0].picture.detail;
        Ok(Reel { scene, captions, drawings, detail, notes: Vec::new() })
    }
}
