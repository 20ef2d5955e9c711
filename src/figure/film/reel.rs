//! Frames that are drawn, each with its caption: on one sheet, one at a time, as a page, or each alone.

use super::player;
use super::sheet::{Caption, arranged, below, frame_size, head_height};
use super::style;
use crate::figure::canvas::scene::{Node, Scene};
use crate::figure::structure::pointer_style;
use crate::figure::{Detail, Figure, FigureOptions};

/// The frames of a film, drawn.
pub(super) struct Reel {
    /// Of the size of one frame without its caption; nothing is on it.
    pub(super) scene: Scene,
    pub(super) captions: Vec<Caption>,
    pub(super) drawings: Vec<Vec<Node>>,
    pub(super) detail: Detail,
    pub(super) notes: Vec<String>,
}

impl Reel {
    /// All frames in rows; with links it shows one at a time where style rules are known.
    pub(super) fn sheet(self, options: &FigureOptions, links: bool) -> Figure {
        let scene = arranged(self.scene, &self.captions, self.drawings, options, links);
        Figure { scene, detail: self.detail, notes: self.notes }
    }

    /// A page that plays the frames.
    pub(super) fn page(self, options: &FigureOptions) -> String {
        let frame = frame_size(&self.captions, self.scene.size, true);
        let headings: Vec<String> = self.captions.iter().map(|(heading, _)| heading.clone()).collect();
        player::page(&self.sheet(options, true), &headings, frame)
    }

    /// Each frame alone, all of one size.
    pub(super) fn singles(self, options: &FigureOptions) -> Vec<Figure> {
        let Self { mut scene, captions, drawings, detail, notes } = self;
        let (width, head) = (scene.size.x, head_height(&captions, scene.size.x));
        scene.size.y += head;
        scene.css.push_str(&pointer_style::css(&options.style, &scene.prefix));
        scene.css.push_str(&style::marks(&options.style, &scene.prefix));
        let alone = |(caption, drawing): (&Caption, Vec<Node>)| {
            let mut scene = scene.clone();
            scene.nodes = below(caption, head, width, drawing);
            scene.description.clone_from(&caption.0);
            Figure { scene, detail, notes: notes.clone() }
        };
        captions.iter().zip(drawings).map(alone).collect()
    }
}
