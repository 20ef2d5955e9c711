//! What is drawn, one thing each: circles, lines, outlines, half-edges, texts.

use crate::compare::ink::Hidden;
use crate::plane::Point;
use std::ops::Range;

/// A circle.
#[derive(Clone, PartialEq, Debug)]
pub(in crate::compare) struct Dot {
    pub(in crate::compare) at: Point,
    pub(in crate::compare) radius: f64,
    pub(in crate::compare) hidden: Option<Hidden>,
    /// The vertex that the group round the circle declares: its name and its place in the model.
    pub(in crate::compare) vertex: Option<(String, Point)>,
    /// Whether it stands in a legend or on an axis, by its name.
    pub(in crate::compare) aside: bool,
    /// The number of the legend in which it stands; 0 if in none.
    pub(in crate::compare) legend: u32,
}

/// A straight line.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(in crate::compare) struct Line {
    pub(in crate::compare) ends: [Point; 2],
    /// Half its width.
    pub(in crate::compare) half: f64,
    pub(in crate::compare) hidden: Option<Hidden>,
    pub(in crate::compare) aside: bool,
    pub(in crate::compare) legend: u32,
    /// The number of the element that draws it.
    pub(in crate::compare) shape: u32,
    /// Whether that element has curves, too.
    pub(in crate::compare) curved: bool,
    /// The coats of its dashes, from the first to before the last, if they leave it out in part, or nearly whole.
    pub(in crate::compare) dashes: [u32; 2],
}

impl Line {
    /// One that can be seen and has nothing else about it.
    pub(in crate::compare) fn plain(ends: [Point; 2], half: f64, shape: u32) -> Self {
        Self { ends, half, hidden: None, aside: false, legend: 0, shape, curved: false, dashes: [0; 2] }
    }
}

/// A filled outline.
#[derive(Clone, PartialEq, Debug)]
pub(in crate::compare) struct Outline {
    pub(in crate::compare) points: Vec<Point>,
    /// The face that the group round it declares, or nothing.
    pub(in crate::compare) name: String,
    /// Whether that is a hole.
    pub(in crate::compare) hole: bool,
    /// Whether its own element leaves it empty, by the fill rule: a hole in a face.
    pub(in crate::compare) empty: bool,
    /// What it paints.
    pub(in crate::compare) coat: u32,
    /// Whether some of its sides are curves.
    pub(in crate::compare) curved: bool,
    pub(in crate::compare) hidden: Option<Hidden>,
    pub(in crate::compare) aside: bool,
    pub(in crate::compare) legend: u32,
    pub(in crate::compare) shape: u32,
}

/// A half-edge with its drawing.
#[derive(Clone, PartialEq, Debug)]
pub(in crate::compare) struct Half {
    pub(in crate::compare) name: String,
    /// What it paints.
    pub(in crate::compare) coats: Range<u32>,
    /// Whether a part of it paints nothing at all. If no line of it does, it is not seen.
    pub(in crate::compare) lacks: bool,
}

/// A text that may be a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(in crate::compare) struct Name {
    /// The vertex, half-edge or face that the group round it declares, or nothing.
    pub(in crate::compare) element: String,
    pub(in crate::compare) text: String,
    /// What it paints, if anything.
    pub(in crate::compare) coats: Range<u32>,
    /// Whether it stands in a table, a legend, a note or the like.
    pub(in crate::compare) noted: bool,
}
