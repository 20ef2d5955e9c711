//! The sides of a surface that was cut open: two sides that are one edge have one colour, one letter and one direction.
//!
//! ```text
//!        a ▸                the arrow head points along the half-edge with the even number
//!    ●────────●
//!  b │        │ b
//!  ▾ │        │ ▾
//!    ●────────●
//!        a ▸
//! ```

use crate::figure::FigureOptions;
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::style::{Palette, Style};
use crate::figure::canvas::vector::xy;
use crate::figure::flatten::{Names, Placed};
use crate::figure::structure::arrows::head;
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::plate::DynPlate;
use std::fmt::Write;

/// The classes of the colours, one after the other.
const CLASSES: [&str; 6] = ["glued g0", "glued g1", "glued g2", "glued g3", "glued g4", "glued g5"];
/// How far beside a side its letter stands.
const BESIDE: f64 = 15.0;
/// The size of a letter.
const LETTER: f64 = 15.0;

/// a, b, … z, a1, b1, …
fn letter(number: usize) -> String {
    let letter = char::from(b'a' + (number % 26) as u8);
    if number < 26 { letter.to_string() } else { format!("{letter}{}", number / 26) }
}

/// The sides that are shown.
pub(super) fn nodes(plate: &DynPlate<'_>, placed: &Placed, look: &Look) -> Vec<Node> {
    let shown = placed.sides.iter().filter(|(h, _)| look.half_edge(*h) != Mark::Hidden);
    let side = |&(h, number): &(_, usize)| {
        let (from, to) = plate.skeleton().segment(h)?;
        let along = (to - from).unit()?;
        let middle = (from + to) * 0.5;
        let forward = along * if h.number() % 2 == 0 { 1.0 } else { -1.0 };
        let text = letter(number);
        let at = middle - along.left() * BESIDE;
        let nodes = vec![
            Node::Line { class: "gl", from, to },
            Node::Area {
                class: "gh",
                hatch: None,
                outlines: vec![head(middle + forward * 6.0, forward, 12.0).to_vec()],
            },
            Node::Text { class: "gt", at: xy(at.x, at.y), size: LETTER, text },
        ];
        Some(Node::Group(Group { class: CLASSES[number % CLASSES.len()], nodes, ..Group::default() }))
    };
    shown.filter_map(side).collect()
}

/// The options with the names of copies; bends get none.
pub(super) fn labelled(options: &FigureOptions, names: &Names) -> FigureOptions {
    let mut overrides = options.overrides.clone();
    for (id, vertex) in names.shown() {
        let name = vertex.map_or_else(String::new, |v| options.caption(v));
        overrides = overrides.label(id, name);
    }
    options.clone().overrides(overrides)
}

/// The style rules, if there are sides.
pub(super) fn css(style: &Style, scope: &str, placed: &[Placed]) -> String {
    let mut out = String::new();
    if placed.iter().all(|placed| placed.sides.is_empty()) {
        return out;
    }
    let _ = writeln!(out, "#{scope} .glued .gl{{fill:none;stroke-width:3;stroke-linecap:round}}");
    let _ = writeln!(out, "#{scope} .glued .gt{{font-weight:700;font-style:italic}}");
    style.in_both(&mut out, |out, palette| colours(out, scope, palette));
    out
}

fn colours(out: &mut String, scope: &str, palette: &Palette) {
    let colours = [palette.twin, palette.origin, palette.half_edge, palette.face, palette.next, palette.ink];
    for (i, colour) in colours.into_iter().enumerate() {
        let _ = writeln!(out, "#{scope} .g{i} .gl{{stroke:{colour}}}");
        let _ = writeln!(out, "#{scope} .g{i} .gh,#{scope} .g{i} .gt{{fill:{colour}}}");
    }
}
