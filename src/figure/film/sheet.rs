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

use super::style;
use crate::figure::FigureOptions;
use crate::figure::canvas::scene::{Group, Node, Scene};
use crate::figure::canvas::text::clean;
use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::layout::grid::{self, BELOW, GAP, columns};
use crate::figure::structure::pointer_style;

/// What stands above a frame: its heading, and the text below it.
pub(super) type Caption = (String, String);
/// Height of the links between frames.
const LINKS: f64 = 20.0;

/// The frames in rows, each below its heading. `scene` has the size of one. They are linked if that is asked for.
pub(super) fn arranged(
    mut scene: Scene,
    frames: &[Caption],
    drawings: Vec<Vec<Node>>,
    options: &FigureOptions,
    links: bool,
) -> Scene {
    let frame_size = frame_size(frames, scene.size, links);
    let head = frame_size.y - scene.size.y;
    let columns = options.columns.unwrap_or_else(|| columns(frames.len(), frame_size.x)).min(frames.len().max(1));
    for (i, (frame, drawing)) in frames.iter().zip(drawings).enumerate() {
        let (column, row) = ((i % columns) as f64, (i / columns) as f64);
        let mut nodes = below(frame, head, scene.size.x, drawing);
        if links {
            nodes.splice(nodes.len() - 1..nodes.len() - 1, nav(i, frames.len(), head - 6.0));
        }
        scene.nodes.push(Node::Group(Group {
            class: "fr",
            mark: if i == 0 { "first" } else { "" },
            id: Some(format!("step-{i}")),
            title: Some(format!("{} of {}: {}", i + 1, frames.len(), frame.0)),
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
        let headings: Vec<&str> = frames.iter().map(|frame| frame.0.as_str()).collect();
        scene.description = clean(&format!("Frames: {}", headings.join("; ")));
    }
    scene
}

/// The size of a frame with its caption, and links if there are any; `drawing` is the size of what is drawn.
pub(super) fn frame_size(frames: &[Caption], drawing: Xy, links: bool) -> Xy {
    xy(drawing.x, drawing.y + head_height(frames, drawing.x) + if links { LINKS } else { 0.0 })
}

/// A drawing below its caption, which has the height `head`.
pub(super) fn below(caption: &Caption, head: f64, width: f64, drawing: Vec<Node>) -> Vec<Node> {
    let mut nodes = heading(caption, width);
    nodes.push(Node::Group(Group { shift: Some(xy(0.0, head)), nodes: drawing, ..Group::default() }));
    nodes
}

/// Room for the tallest heading.
pub(super) fn head_height(frames: &[Caption], width: f64) -> f64 {
    frames.iter().map(|(heading, text)| grid::heading(heading, text, width).1).fold(0.0, f64::max) + BELOW
}

/// The lines above a drawing.
pub(super) fn heading((heading, text): &Caption, width: f64) -> Vec<Node> {
    grid::heading(&clean(heading), &clean(text), width).0
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
