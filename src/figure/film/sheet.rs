//! All frames on one sheet, each with its heading.
//!
//! ```text
//!   split_face h2 h8     1 Create a new face …    2 Create two new …
//!   what to look at      new f2                   new e6 = (h12, h13), …
//!   ┌──────────┐         ┌──────────┐             ┌──────────┐
//!   │          │         │          │             │    │     │
//!   └──────────┘         └──────────┘             └──────────┘
//!   3 Insert the new …   4 …                      5 …
//! ```

use super::draw::{Stage, union};
use super::frames::{Film, Frame};
use super::{sides, style};
use crate::figure::canvas::scene::{Group, Node, Scene};
use crate::figure::canvas::text;
use crate::figure::canvas::vector::xy;
use crate::figure::structure::pointer_style;
use crate::figure::{Figure, FigureError, FigureOptions};

/// Width of a frame unless the caller or the structure asks for more.
const WIDTH: f64 = 380.0;
/// No row is wider than this, unless a frame alone is.
const SHEET: f64 = 1680.0;
/// Space between frames.
const GAP: f64 = 14.0;
/// Size of a heading and how far its lines are apart; at most two.
const HEADING: (f64, f64, usize) = (14.0, 17.0, 2);
/// The same for the text below it.
const TEXT: (f64, f64, usize) = (11.0, 14.0, 3);
/// Height of the links between frames.
const LINKS: f64 = 20.0;

impl Film {
    /// A strip: all frames side by side, in rows. The width of the options is that of one frame (default 380,
    /// more until the median edge has 110 px). Ids read `FIG-3-h5` for `h5` in the fourth frame (the first is
    /// 0), `FIG-3-h5-next` for its pointer, `FIG-3-h5-next-gone` for the one that the step has replaced.
    ///
    /// Cost: O(frames x n log n) for n half-edges.
    ///
    /// # Errors
    /// Those of [`structure`](crate::figure::structure()), and [`FigureError::NoRoom`] if half-edges would be too
    /// short to draw.
    pub fn strip(&self, options: &FigureOptions) -> Result<Figure, FigureError> {
        self.sheet(options, false)
    }

    /// A stepper: one frame at a time, with links to the one before and the one after; no script. The fragment
    /// `#FIG-step-3` opens the fourth frame. Where style rules are not known, and in print, it is the strip.
    ///
    /// # Errors
    /// Those of [`strip`](Self::strip).
    pub fn stepper(&self, options: &FigureOptions) -> Result<Figure, FigureError> {
        self.sheet(options, true)
    }

    fn sheet(&self, options: &FigureOptions, links: bool) -> Result<Figure, FigureError> {
        let mut options = options.checked();
        options.usual_width = WIDTH;
        options.crop = None;
        let options = &options;
        let frames = self.frames();
        #[cfg(feature = "solid")]
        if !self.solids.is_empty() {
            let (scene, drawings, detail) = super::space::draw(&self.solids, &frames, options)?;
            return Ok(Figure { scene: arranged(scene, &frames, drawings, options, links), detail, notes: Vec::new() });
        }
        let (placed, names) = self.placed();
        let options = &sides::labelled(options, &names);
        let union = union(&placed);
        let stage = Stage::new(&self.states, &placed, &union, options)?;
        let Some(first) = stage.plates.first() else { return crate::figure::structure(&union, options) };
        let mut scene = first.picture.scene(Vec::new());
        scene.css.push_str(&sides::css(&options.style, &scene.prefix, &placed));
        let drawings = frames.iter().enumerate().map(|(i, frame)| stage.draw(frame, &i.to_string())).collect();
        let detail = first.picture.detail;
        Ok(Figure { scene: arranged(scene, &frames, drawings, options, links), detail, notes: Vec::new() })
    }
}

/// The frames in rows, each below its heading. `scene` has the size of one.
fn arranged(
    mut scene: Scene,
    frames: &[Frame],
    drawings: Vec<Vec<Node>>,
    options: &FigureOptions,
    links: bool,
) -> Scene {
    let head = head_height(frames, scene.size.x) + if links { LINKS } else { 0.0 };
    let frame_size = xy(scene.size.x, scene.size.y + head);
    let columns = columns(frames.len(), frame_size.x);
    for (i, (frame, drawing)) in frames.iter().zip(drawings).enumerate() {
        let (column, row) = ((i % columns) as f64, (i / columns) as f64);
        let mut nodes = heading(frame, scene.size.x);
        if links {
            nodes.extend(nav(i, frames.len(), head - 6.0));
        }
        nodes.push(Node::Group(Group { shift: Some(xy(0.0, head)), nodes: drawing, ..Group::default() }));
        scene.nodes.push(Node::Group(Group {
            class: "fr",
            mark: if i == 0 { "first" } else { "" },
            id: Some(format!("step-{i}")),
            title: Some(format!("{} of {}: {}", i + 1, frames.len(), frame.heading)),
            shift: Some(xy(column * (frame_size.x + GAP), row * (frame_size.y + GAP))),
            nodes,
            ..Group::default()
        }));
    }
    let size = |count: usize, one: f64| count as f64 * (one + GAP) - GAP;
    scene.size = xy(size(columns, frame_size.x), size(frames.len().div_ceil(columns), frame_size.y));
    scene.css.push_str(&pointer_style::css(&options.style, &scene.prefix));
    scene.css.push_str(&style::marks(&options.style, &scene.prefix));
    scene.attributes[0].1 = if links { "dcel-stepper" } else { "dcel-strip" }.to_owned();
    if links {
        scene.css.push_str(&style::stepper(&scene.prefix, scene.size, frame_size));
        scene.attributes.push(("preserveAspectRatio", "xMinYMin slice".to_owned()));
        scene.attributes.push(("role", "group".to_owned()));
    }
    if options.description.is_none() {
        let headings: Vec<&str> = frames.iter().map(|frame| frame.heading.as_str()).collect();
        scene.description = text::clean(&format!("Frames: {}", headings.join("; ")));
    }
    scene
}

/// As many columns as fit, then as few as the rows need.
fn columns(frames: usize, width: f64) -> usize {
    let fit = (((SHEET + GAP) / (width + GAP)) as usize).clamp(1, frames.max(1));
    frames.div_ceil(frames.div_ceil(fit).max(1)).max(1)
}

/// Room for the tallest heading.
fn head_height(frames: &[Frame], width: f64) -> f64 {
    let height = |frame: &Frame| {
        let lines = |words: &str, (size, step, most): (f64, f64, usize), bold: bool| {
            text::wrap(words, size, bold, width - 16.0, most).len() as f64 * step
        };
        lines(&frame.heading, HEADING, true) + lines(&frame.text, TEXT, false)
    };
    frames.iter().map(height).fold(0.0, f64::max) + 8.0
}

fn heading(frame: &Frame, width: f64) -> Vec<Node> {
    let mut y = 0.0;
    let mut out = Vec::new();
    for (words, (size, step, most), class) in [(&frame.heading, HEADING, "ct"), (&frame.text, TEXT, "cs")] {
        for line in text::wrap(&text::clean(words), size, class == "ct", width - 16.0, most) {
            y += step;
            out.push(Node::Text { class, at: xy(8.0, y - 0.3 * size), size, text: line });
        }
    }
    out
}

/// The links to the frames before and after, and the number of this one.
fn nav(i: usize, frames: usize, y: f64) -> Vec<Node> {
    let text = |x: f64, class: &'static str, text: String| Node::Text { class, at: xy(x, y), size: 12.0, text };
    let link = |to: Option<usize>, x: f64, words: &str| {
        let to = to.filter(|&to| to < frames)?;
        let nodes = vec![text(x, "cs nav", words.to_owned())];
        Some(Node::Group(Group { link: Some(format!("step-{to}")), nodes, ..Group::default() }))
    };
    let mut out: Vec<Node> = link(i.checked_sub(1), 8.0, "‹ back").into_iter().collect();
    out.push(text(66.0, "cs", format!("{} of {frames}", i + 1)));
    out.extend(link(Some(i + 1), 124.0, "next ›"));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_as_equal_as_can_be() {
        assert_eq!([1, 4, 5, 7, 9].map(|frames| columns(frames, 400.0)), [1, 4, 3, 4, 3]);
        assert_eq!(columns(3, 5000.0), 1);
    }
}
