//! Labels of faces: what is written, in one line or two, how large and where.
//!
//! ```text
//!   ┌──────────────┐      Every size is tried from the largest that the room promises down to the smallest;
//!   │    South     │      a box that covers something makes the search look elsewhere. A name with a space
//!   │   Carolina   │      is also tried in two lines, and the larger result wins.
//!   └──────────────┘
//! ```

use crate::figure::FigureOptions;
use crate::figure::canvas::scene::Node;
use crate::figure::canvas::text;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::{FATTEST, Shape};
use crate::figure::layout::options::FaceLabels;
use crate::figure::layout::pole::{area, pole};
use crate::figure::structure::faces::Region;
use std::borrow::Cow;

/// Distance of two lines of text, in sizes.
const LINE: f64 = 1.12;

/// How many characters of a long name are tried, the most first.
const CUTS: [usize; 2] = [28, 16];

/// A text that looks for a place.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Caption {
    /// One line or two.
    lines: Vec<String>,
    /// Width at size 1. All ids of a figure claim the width of the widest, so that equal faces get labels of
    /// equal size.
    width: f64,
    /// What is written if there is no room for all.
    least: Option<String>,
}

/// The sizes a label may have.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Sizes {
    pub(crate) largest: f64,
    /// Labels smaller than this are left out.
    pub(crate) smallest: f64,
}

/// A placed label.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Label {
    /// The middle of the text.
    pub(crate) at: Xy,
    pub(crate) size: f64,
    pub(crate) lines: Vec<String>,
}

impl Label {
    pub(crate) fn bounds(&self) -> Bounds {
        bounds(self.at, self.size, width(&self.lines), self.lines.len())
    }

    /// One text for each line.
    pub(crate) fn nodes(&self, class: &'static str) -> impl Iterator<Item = Node> {
        let first = -0.5 * LINE * self.size * (self.lines.len() as f64 - 1.0);
        self.lines.iter().enumerate().map(move |(i, line)| Node::Text {
            class,
            at: self.at + xy(0.0, first + LINE * self.size * i as f64),
            size: self.size,
            text: line.clone(),
        })
    }
}

/// The width at size 1.
fn width(lines: &[String]) -> f64 {
    lines.iter().map(|line| text::width(line, 1.0, true)).fold(0.0, f64::max)
}

fn bounds(at: Xy, size: f64, width: f64, lines: usize) -> Bounds {
    let height = text::half_height(size) + 0.5 * LINE * size * (lines as f64 - 1.0);
    Bounds::around(at, 0.5 * width * size, height)
}

/// What stands in the way of a text.
type Blocker<'a> = &'a dyn Fn(&Bounds) -> Option<Shape>;

impl Caption {
    fn new(lines: Vec<String>) -> Self {
        Self { width: width(&lines), lines, least: None }
    }

    /// The first line, cut to `longest` characters with an ellipsis at the end.
    pub(crate) fn shortened(&self, longest: usize) -> Self {
        let text = self.lines.first().map_or("", String::as_str);
        let short = text::shortened(text, longest);
        if short == text { self.clone() } else { Self::new(vec![short]) }
    }

    /// Half the width and half the height at a size.
    pub(crate) fn half(&self, size: f64) -> Xy {
        bounds(Xy::default(), size, width(&self.lines), self.lines.len()).max
    }

    /// Width and height at size 1.
    fn shape(&self) -> Xy {
        bounds(Xy::default(), 1.0, self.width, self.lines.len()).size()
    }

    /// By how much x is squeezed in the search for a place. A box as wide as 2.4 times its height fits a circle well
    /// enough; a wider one needs a flat room.
    fn squeeze(&self) -> f64 {
        (self.shape().x / self.shape().y / 2.4).max(1.0)
    }

    /// Whether there could be room for any text at all: a look at the region alone, which does not depend on what else
    /// is drawn. It errs on the side of yes. O(sides of the region).
    pub(crate) fn may_have_room(region: &Region, sizes: Sizes) -> bool {
        // Half of what `place` asks for: its search gives some clearance away to be nearer to the middle.
        let least = 0.375 * sizes.smallest * 2.0 * text::half_height(1.0);
        area(&region.rings) >= std::f64::consts::PI * least * least
            && pole(&region.rings, &[], 1.0, 2.0 * least).is_some_and(|pole| pole.clearance >= least)
    }

    /// What is further away from a region than this does not matter to a place in it: with x squeezed, a line
    /// outside can reach into the region by half its width times that much, a side of the region by nothing.
    pub(crate) fn reach(&self) -> f64 {
        FATTEST * self.squeeze()
    }

    /// The text at a place, whatever is there.
    pub(crate) fn at(&self, at: Xy, size: f64) -> Label {
        Label { at, size, lines: self.lines.clone() }
    }

    /// The same words in two lines, split at the space nearest the middle.
    fn in_two_lines(&self) -> Option<Self> {
        let text = self.lines.first()?;
        let middle = text.len() / 2;
        let at = text.match_indices(' ').map(|(i, _)| i).min_by_key(|&i| i.abs_diff(middle))?;
        Some(Self::new(vec![text[..at].to_owned(), text[at + 1..].to_owned()]))
    }

    /// Places the text in a region, clear of its rings, of the obstacles and of everything that `blocker`
    /// knows; `None` if there is no room. A long name that does not fit is cut short.
    pub(crate) fn place(
        &self,
        region: &Region,
        sizes: Sizes,
        obstacles: &[Shape],
        blocker: Blocker<'_>,
    ) -> Option<Label> {
        let whole = self.place_whole(region, sizes, obstacles, blocker);
        whole.or_else(|| {
            let cuts = CUTS.into_iter().map(|longest| self.shortened(longest)).filter(|short| short != self);
            let least = self.least.iter().map(|text| Self::new(vec![text.clone()]));
            let mut placed = cuts.chain(least).map(|short| short.place_whole(region, sizes, obstacles, blocker));
            placed.find_map(|label| label)
        })
    }

    fn place_whole(&self, region: &Region, sizes: Sizes, obstacles: &[Shape], blocker: Blocker<'_>) -> Option<Label> {
        let one = self.place_lines(region, sizes, obstacles.to_vec(), blocker);
        if one.as_ref().is_some_and(|label| label.size >= sizes.largest) {
            return one;
        }
        let two = self.in_two_lines().and_then(|two| two.place_lines(region, sizes, obstacles.to_vec(), blocker));
        let size = |label: &Option<Label>| label.as_ref().map_or(0.0, |label| label.size);
        if size(&two) > size(&one) { two } else { one }
    }

    fn place_lines(
        &self,
        region: &Region,
        sizes: Sizes,
        mut obstacles: Vec<Shape>,
        blocker: Blocker<'_>,
    ) -> Option<Label> {
        let (shape, squeeze) = (self.shape(), self.squeeze());
        let enough = 1.45 * sizes.largest * shape.y;
        for _ in 0..4 {
            let pole = pole(&region.rings, &obstacles, squeeze, enough)?;
            if pole.clearance < 0.75 * sizes.smallest * shape.y {
                return None;
            }
            let mut size = sizes.largest.min((1.2 * pole.clearance / shape.y).max(sizes.smallest));
            let mut blocked = None;
            while size >= sizes.smallest {
                let bounds = bounds(pole.at, size, self.width, self.lines.len());
                blocked = blocker(&bounds.grown(1.0));
                let clear = region.is_clear(&bounds.grown(1.5)) && !obstacles.iter().any(|shape| shape.meets(&bounds));
                if clear && blocked.is_none() {
                    return Some(Label { at: pole.at, size, lines: self.lines.clone() });
                }
                size = if size > sizes.smallest { (size - 0.5).max(sizes.smallest) } else { 0.0 };
            }
            obstacles.push(blocked?);
        }
        None
    }
}

/// What is written into each region by the options: a name, an id or nothing. Of several regions with the same
/// name the largest has it.
pub(crate) fn captions(regions: &[Region], options: &FigureOptions) -> Vec<Option<Caption>> {
    let mut out: Vec<Option<Caption>> =
        regions.iter().map(|region| Some(Caption::new(vec![region.face.to_string()]))).collect();
    let mut named: Vec<(Cow<'_, str>, f64, usize)> = Vec::new();
    if options.face_labels == FaceLabels::Off {
        out.fill(None);
    } else if options.face_labels == FaceLabels::Names {
        for (i, region) in regions.iter().enumerate() {
            if let Some(name) = options.drawn_name(region.face) {
                named.push((name, area(&region.rings), i));
                out[i] = None;
            }
        }
    }
    let widest = out.iter().flatten().map(|id| id.width).fold(0.0, f64::max);
    out.iter_mut().flatten().for_each(|id| id.width = widest);
    named.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)).then(a.2.cmp(&b.2)));
    named.dedup_by(|a, b| a.0 == b.0);
    for (name, _, i) in named {
        // Of an id with a name the id is more important.
        let id = regions[i].face.to_string();
        let least = name.strip_prefix(&id).is_some_and(|rest| rest.starts_with(' ')).then_some(id);
        out[i] = Some(Caption { least, ..Caption::new(vec![name.into_owned()]) });
    }
    out
}
