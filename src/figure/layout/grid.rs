//! Panels of one size in rows and columns, each below its caption.
//!
//! ```text
//!   half-edge.next          half-edge.twin
//!   follow next and …       the same edge …
//!   ┌──────────────┐  gap   ┌──────────────┐
//!   │              │        │              │
//!   └──────────────┘        └──────────────┘
//! ```

use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::text::wrap;
use crate::figure::canvas::vector::{Xy, xy};

/// Width of a sheet of panels: that of a page, on which the smallest letters keep their size.
pub(crate) const SHEET: f64 = 830.0;
/// Space between panels.
pub(crate) const GAP: f64 = 14.0;
/// Width of a panel unless the caller asks for more: two of them fill a sheet.
pub(crate) const PANEL: f64 = 0.5 * (SHEET - GAP);
/// Size of a heading and how far its lines are apart; at most so many.
const HEADING: (f64, f64, usize) = (14.0, 17.0, 2);
/// The same for the sentence below it.
const TEXT: (f64, f64, usize) = (11.0, 14.0, 3);
/// Space between a caption and what it is about.
pub(crate) const BELOW: f64 = 8.0;

/// A panel: its caption and what is drawn.
pub(crate) struct Panel {
    pub(crate) heading: String,
    pub(crate) text: String,
    /// Without the prefix of the scene; none: the panel has no id.
    pub(crate) id: Option<String>,
    pub(crate) nodes: Vec<Node>,
}

/// As many columns of this width as a sheet holds, then as few as the rows need.
pub(crate) fn columns(panels: usize, width: f64) -> usize {
    let fit = (((SHEET + GAP) / (width + GAP)) as usize).clamp(1, panels.max(1));
    panels.div_ceil(panels.div_ceil(fit).max(1)).max(1)
}

/// The panels as groups, and the size of it all. `size` is that of each drawing.
pub(crate) fn arrange(panels: Vec<Panel>, size: Xy, columns: usize) -> (Vec<Node>, Xy) {
    let count = panels.len();
    let columns = columns.clamp(1, count.max(1));
    let head = panels.iter().map(|panel| caption(panel, size.x).1).fold(0.0, f64::max);
    let whole = xy(size.x, size.y + head);
    let group = |(i, panel): (usize, Panel)| {
        let (column, row) = ((i % columns) as f64, (i / columns) as f64);
        let mut nodes = caption(&panel, size.x).0;
        nodes.push(Node::Group(Group { shift: Some(xy(0.0, head)), nodes: panel.nodes, ..Group::default() }));
        Node::Group(Group {
            class: "panel",
            id: panel.id,
            shift: Some(xy(column * (whole.x + GAP), row * (whole.y + GAP))),
            nodes,
            ..Group::default()
        })
    };
    let nodes = panels.into_iter().enumerate().map(group).collect();
    let length = |count: usize, one: f64| count as f64 * (one + GAP) - GAP;
    (nodes, xy(length(columns, whole.x), length(count.div_ceil(columns).max(1), whole.y)))
}

/// The lines of a caption and their height, with the space below them.
fn caption(panel: &Panel, width: f64) -> (Vec<Node>, f64) {
    let (nodes, height) = heading(&panel.heading, &panel.text, width);
    (nodes, if height > 0.0 { height + BELOW } else { 0.0 })
}

/// The lines of a heading and of the sentence below it, and their height.
pub(crate) fn heading(heading: &str, text: &str, width: f64) -> (Vec<Node>, f64) {
    let mut y = 0.0;
    let mut out = Vec::new();
    for (words, (size, step, most), class) in [(heading, HEADING, "ct"), (text, TEXT, "cs")] {
        for line in wrap(words, size, class == "ct", width - 16.0, most) {
            y += step;
            out.push(Node::Text { class, at: xy(8.0, y - 0.3 * size), size, text: line });
        }
    }
    (out, y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_holds_what_a_page_holds() {
        assert_eq!([0, 1, 2, 3, 4, 5, 9].map(|panels| columns(panels, PANEL)), [1, 1, 2, 2, 2, 2, 2]);
        assert_eq!([1, 3, 4, 7].map(|panels| columns(panels, 266.0)), [1, 3, 2, 3]);
        assert_eq!(columns(3, 5000.0), 1);
    }
}
