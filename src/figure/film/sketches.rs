//! Films of what is not an edit: a sketch for each moment, over the structure of that moment.
//!
//! ```text
//!   heading                 heading                 heading
//!   what happens            what happens            what happens
//!   ┌──────────────┐        ┌──────────────┐        ┌──────────────┐
//!   │ structure    │        │ structure    │        │ structure    │   one scale, one frame
//!   │   + sketch   │        │   + sketch   │        │   + sketch   │
//!   └──────────────┘        └──────────────┘        └──────────────┘
//!   ━━ legend                   what the marks mean: of a strip once, else a legend in each frame
//! ```

use super::reel::Reel;
use super::sheet::Caption;
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::vector::xy;
use crate::figure::layout::grid::PANEL;
use crate::figure::sketch::{self, Backdrop, Drawn, Multiples, Sketch, SketchError};
use crate::figure::structure::skeleton::half_edges;
use crate::figure::{FaceLabels, Figure, FigureOptions};
use crate::plane::PlanarView;
use crate::topology::Table;

/// Space round the legend of a frame.
const AIR: f64 = 8.0;

/// A film of sketches.
///
/// ```
/// use dcel_kit::figure::sketch::{Role, Sketch};
/// use dcel_kit::figure::{FigureOptions, SketchFilm};
/// let mut film = SketchFilm::new();
/// for x in [1.0, 2.0, 3.0] {
///     let mut sketch = Sketch::new();
///     sketch.line(Role::Main, [x, 0.0], [x, 1.0]).key("sweep line");
///     sketch.path(Role::Plain, [[0.0, 0.0], [4.0, 1.0]]);
///     film.frame(&format!("x = {x}"), "the sweep line moves on", sketch);
/// }
/// let svg = film.strip(&FigureOptions::new("Sweep"))?.to_svg();
/// assert!(svg.contains("id=\"sweep-step-2\""));
/// # Ok::<(), dcel_kit::figure::sketch::SketchError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct SketchFilm {
    frames: Vec<SketchFrame>,
    is_quiet: bool,
}

#[derive(Clone, Debug)]
struct SketchFrame {
    caption: Caption,
    /// The structure, and whether it is dimmed.
    under: Option<(Table, Backdrop)>,
    sketch: Sketch,
}

impl SketchFilm {
    /// No frames yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Keeps the structures of all frames in the background: their faces in one grey and without names, so that the sketch
    /// is seen.
    pub fn quiet(&mut self) -> &mut Self {
        self.is_quiet = true;
        self
    }

    /// How many frames there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    /// Whether there is no frame yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// The headings and texts of the frames.
    pub fn captions(&self) -> impl Iterator<Item = (&str, &str)> {
        self.frames.iter().map(|frame| (frame.caption.0.as_str(), frame.caption.1.as_str()))
    }

    /// Adds a frame with a sketch.
    pub fn frame(&mut self, heading: &str, text: &str, sketch: Sketch) -> &mut Self {
        let caption = (heading.to_owned(), text.to_owned());
        self.frames.push(SketchFrame { caption, under: None, sketch });
        self
    }

    /// Adds a frame with a sketch over a structure as it is now.
    pub fn over(
        &mut self,
        heading: &str,
        text: &str,
        view: &dyn PlanarView,
        backdrop: Backdrop,
        sketch: Sketch,
    ) -> &mut Self {
        let caption = (heading.to_owned(), text.to_owned());
        self.frames.push(SketchFrame { caption, under: Some((Table::from_planar_view(view), backdrop)), sketch });
        self
    }

    /// A strip: all frames side by side, two in a row unless the options ask for wider ones. Ids read `FIG-p1-…` in
    /// the first frame.
    ///
    /// Cost: that of a figure for each frame.
    ///
    /// # Errors
    /// [`SketchError`] of the first frame that cannot be drawn.
    pub fn strip(&self, options: &FigureOptions) -> Result<Figure, SketchError> {
        let (reel, legend) = self.reel(options, false)?;
        let mut figure = reel.sheet(options, false);
        let scene = &mut figure.scene;
        let corner = xy(AIR, scene.size.y + AIR);
        let (nodes, height) = sketch::legend_nodes(&legend, corner, scene.size.x - 2.0 * AIR, "");
        if !nodes.is_empty() {
            scene.nodes.push(Node::Group(Group { class: "legend", nodes, ..Group::default() }));
            scene.size.y = corner.y + height + AIR;
        }
        Ok(figure)
    }

    /// A stepper: one frame at a time, with links and without a script; where style rules are not known, and in print,
    /// it is the strip. The fragment `#FIG-step-3` opens the fourth frame.
    ///
    /// # Errors
    /// As [`strip`](Self::strip).
    pub fn stepper(&self, options: &FigureOptions) -> Result<Figure, SketchError> {
        Ok(self.reel(options, true)?.0.sheet(options, true))
    }

    /// A page that plays the film: buttons, keys, a slider, and an address for each frame. Without a script it is the
    /// [`stepper`](Self::stepper). Nothing comes from outside.
    ///
    /// # Errors
    /// As [`strip`](Self::strip).
    pub fn page(&self, options: &FigureOptions) -> Result<String, SketchError> {
        Ok(self.reel(options, true)?.0.page(options))
    }

    /// Each frame alone, all of one size.
    ///
    /// # Errors
    /// As [`strip`](Self::strip).
    pub fn singles(&self, options: &FigureOptions) -> Result<Vec<Figure>, SketchError> {
        Ok(self.reel(options, true)?.0.singles(options))
    }

    /// The frames, drawn, with a legend each if that is asked for; and the legend of all.
    fn reel(&self, options: &FigureOptions, legends: bool) -> Result<(Reel, Vec<sketch::Entry>), SketchError> {
        let mut options = options.of_panels();
        let edges = |frame: &SketchFrame| frame.under.as_ref().map_or(0, |(table, _)| half_edges(table).count() / 2);
        if self.is_quiet {
            options.width.get_or_insert(PANEL);
            options = options.quiet().face_labels(FaceLabels::Off);
        }
        let options = &options.without_half_edges(self.frames.iter().map(edges).max().unwrap_or(0));
        let mut panels = Multiples::new();
        for SketchFrame { under, sketch, .. } in &self.frames {
            match under {
                Some((table, backdrop)) => panels.over("", "", table, *backdrop, sketch.clone()),
                None => panels.sketch("", "", sketch.clone()),
            };
        }
        let Drawn { panels, fit, detail, roles, notes, .. } = panels.drawn(options)?;
        let mut scene = sketch::scene(options, "dcel-film", (fit.size, fit.scale), &roles, Vec::new(), &[]);
        let mut badges = 1;
        let mut entries = Vec::new();
        let drawings = panels.into_iter().zip(&self.frames).map(|(panel, frame)| {
            let legend = frame.sketch.legend(badges);
            badges += frame.sketch.badges();
            let mut nodes = panel.nodes;
            let corner = xy(AIR, fit.size.y + AIR);
            if !legends {
                entries.push(legend);
                return nodes;
            }
            let instance = panel.id.map_or_else(String::new, |id| format!("{id}-"));
            let (legend, height) = sketch::legend_nodes(&legend, corner, fit.size.x - 2.0 * AIR, &instance);
            if !legend.is_empty() {
                nodes.push(Node::Group(Group { class: "legend", nodes: legend, ..Group::default() }));
                scene.size.y = scene.size.y.max(corner.y + height + AIR);
            }
            nodes
        });
        let drawings = drawings.collect();
        let captions = self.frames.iter().map(|frame| frame.caption.clone()).collect();
        Ok((Reel { scene, captions, drawings, detail, notes }, sketch::merged(entries)))
    }
}
