//! Where the orientation test of plain doubles fails: a map of a tiny neighbourhood of a line.
//!
//! ```text
//!              q, r far away on the same line
//!    ▒▒▒▒▓▓░░      Every cell is one double: p + (i, j) · step, for 256 × 256 cells. Its hue is what the
//!    ▒▒▓▓░░▓▓      formula  (q - p) × (r - p)  says when it is computed in doubles: left of q r, on the
//!    ▓▓░░▓▓▒▒      line, or right of it. Strong cells are wrong; the line bounds the true answer.
//! ```
//!
//! Source: Kettner, Mehlhorn, Pion, Schirra and Yap, *Classroom examples of robustness problems in geometric
//! computations*, 2008.

use crate::figure::canvas::scene::{Node, Polylines, Scene};
use crate::figure::canvas::style::rule;
use crate::figure::canvas::vector::xy;
use crate::figure::canvas::{number, scripts, text};
use crate::figure::layout::options::FigureOptions;
use crate::figure::{Detail, Figure};
use crate::plane::predicates::orientation;
use crate::plane::{CoordinateError, Point};
use std::cmp::Ordering;

/// Cells along a side.
const SIDE: usize = 256;
/// Size of a cell in tenths of a px.
const CELL: i32 = 20;
/// Left and top edge of the map in px.
const MARGIN: f64 = 24.0;
/// Distance of two lines of the legend.
const LINE: f64 = 19.0;

/// Three almost collinear points: `p` with a grid of neighbours, and the line through `q` and `r`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NearlyCollinear {
    p: [f64; 2],
    q: [f64; 2],
    r: [f64; 2],
    step: f64,
}

impl Default for NearlyCollinear {
    /// The example of the source: p = (0.5, 0.5), q = (12, 12), r = (24, 24), step 2^-53.
    fn default() -> Self {
        Self { p: [0.5; 2], q: [12.0; 2], r: [24.0; 2], step: 0.5 * f64::EPSILON }
    }
}

impl NearlyCollinear {
    /// The neighbourhood `p + (i, j) · step` for i, j from 0 to 255 and the line from `q` to `r`. The step should
    /// be the distance of neighbouring doubles at `p`.
    ///
    /// # Errors
    /// [`CoordinateError`] for numbers that exact predicates cannot compute with.
    pub fn new(p: [f64; 2], q: [f64; 2], r: [f64; 2], step: f64) -> Result<Self, CoordinateError> {
        let last = (SIDE - 1) as f64 * step;
        for [x, y] in [p, [p[0] + last, p[1] + last], q, r, [step, step]] {
            Point::new(x, y).check()?;
        }
        Ok(Self { p, q, r, step })
    }

    /// How many of the first `side` × `side` points, those with i and j below `side`, doubles put on the wrong side. At
    /// most 256 × 256 are looked at. Cost: an exact test for each.
    ///
    /// ```
    /// # use dcel_kit::figure::NearlyCollinear;
    /// let points = NearlyCollinear::default();
    /// assert!(points.wrong_within(16) < points.wrong_within(256));
    /// ```
    #[must_use]
    pub fn wrong_within(&self, side: usize) -> usize {
        let side = side.min(SIDE);
        let points = (0..side * side).map(|k| self.point(k % side, k / side));
        points.filter(|&p| self.naive(p) != self.exact(p)).count()
    }

    fn point(&self, i: usize, j: usize) -> [f64; 2] {
        [self.p[0] + i as f64 * self.step, self.p[1] + j as f64 * self.step]
    }

    /// On which side of q r the point lies as doubles see it: `Greater` is left.
    fn naive(&self, p: [f64; 2]) -> Ordering {
        let cross = (self.q[0] - p[0]) * (self.r[1] - p[1]) - (self.q[1] - p[1]) * (self.r[0] - p[0]);
        cross.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }

    /// The same, exactly.
    fn exact(&self, p: [f64; 2]) -> Ordering {
        let [p, q, r] = [p, self.q, self.r].map(|[x, y]| Point::new(x, y));
        orientation(p, q, r)
    }
}

/// What a cell shows: the side that doubles say, and whether they are wrong; and the class of such cells.
const ANSWERS: [(Ordering, bool, &str, &str); 6] = [
    (Ordering::Greater, false, "face t0", "left of the line"),
    (Ordering::Equal, false, "face t1", "on the line"),
    (Ordering::Less, false, "face t3", "right of the line"),
    (Ordering::Greater, true, "strong t0", "left of the line, wrongly"),
    (Ordering::Equal, true, "strong t1", "on the line, wrongly"),
    (Ordering::Less, true, "strong t3", "right of the line, wrongly"),
];

/// The answers of all cells, row by row from below.
struct Map {
    naive: Vec<Ordering>,
    exact: Vec<Ordering>,
}

impl Map {
    fn new(points: &NearlyCollinear) -> Self {
        let cells = || (0..SIDE * SIDE).map(|k| points.point(k % SIDE, k / SIDE));
        let naive = cells().map(|p| points.naive(p)).collect();
        Self { naive, exact: cells().map(|p| points.exact(p)).collect() }
    }

    fn is(&self, i: usize, j: usize, side: Ordering, wrong: bool) -> bool {
        let k = j * SIDE + i;
        self.naive[k] == side && (self.naive[k] != self.exact[k]) == wrong
    }

    fn count(&self, side: Ordering, wrong: bool) -> usize {
        (0..SIDE * SIDE).filter(|k| self.is(k % SIDE, k / SIDE, side, wrong)).count()
    }

    /// The cells with an answer as rectangles: runs of a row, joined with the equal run of the row below.
    fn area(&self, side: Ordering, wrong: bool) -> Polylines {
        let mut out = Polylines::new(true);
        // Runs that may still grow upwards: first cell, end, lowest row.
        let mut open: Vec<(usize, usize, usize)> = Vec::new();
        for j in 0..=SIDE {
            let runs = if j < SIDE { self.runs(j, side, wrong) } else { Vec::new() };
            for &(from, to, bottom) in open.iter().filter(|o| !runs.contains(&(o.0, o.1))) {
                let [a, b] = [corner(from, bottom), corner(to, j)];
                out.start(a);
                [[b[0], a[1]], b, [a[0], b[1]]].into_iter().for_each(|p| out.line_to(p));
            }
            let bottom = |run: &(usize, usize)| open.iter().find(|o| (o.0, o.1) == *run).map_or(j, |o| o.2);
            open = runs.iter().map(|run| (run.0, run.1, bottom(run))).collect();
        }
        out
    }

    /// The runs of equal cells in a row: first cell and end.
    fn runs(&self, j: usize, side: Ordering, wrong: bool) -> Vec<(usize, usize)> {
        let mut out: Vec<(usize, usize)> = Vec::new();
        for i in (0..SIDE).filter(|&i| self.is(i, j, side, wrong)) {
            match out.last_mut() {
                Some(run) if run.1 == i => run.1 = i + 1,
                _ => out.push((i, i + 1)),
            }
        }
        out
    }

    /// The borders between cells whose true answers differ.
    fn border(&self) -> Polylines {
        let mut out = Polylines::new(false);
        let exact = |i: usize, j: usize| self.exact[j * SIDE + i];
        for j in 0..SIDE {
            for i in 0..SIDE {
                if i > 0 && exact(i, j) != exact(i - 1, j) {
                    out.start(corner(i, j));
                    out.line_to(corner(i, j + 1));
                }
                if j > 0 && exact(i, j) != exact(i, j - 1) {
                    out.start(corner(i, j));
                    out.line_to(corner(i + 1, j));
                }
            }
        }
        out
    }
}

/// The corner of the map at the lower left of cell (i, j), in tenths of a px.
fn corner(i: usize, j: usize) -> [i32; 2] {
    let margin = (10.0 * MARGIN) as i32;
    [margin + CELL * i as i32, margin + CELL * (SIDE as i32 - j as i32)]
}

/// A power of two as it is written in books, any other number as it is.
fn power(step: f64) -> String {
    let exponent = ((step.to_bits() >> 52) & 0x7ff) as i64 - 1023;
    let is_power = step.is_normal() && step > 0.0 && step.to_bits() << 12 == 0;
    if is_power { scripts::typeset(&format!("2^{{{exponent}}}")) } else { format!("{step:e}") }
}

/// Draws where doubles answer wrongly whether a point lies left of a line, on it or right of it. The root carries
/// the number of cells and of wrong ones as `data-cells` and `data-wrong`. Of the options only the title, the
/// description, the prefix, the style, the unit and `plain` count. Cost: 65,536 exact tests.
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions, NearlyCollinear};
/// let map = figure::robustness(&NearlyCollinear::default(), &FigureOptions::new("Robustness"));
/// assert!(map.to_svg().contains("data-wrong="));
/// ```
#[must_use]
pub fn robustness(points: &NearlyCollinear, options: &FigureOptions) -> Figure {
    let options = &options.checked();
    let map = Map::new(points);
    let mut nodes: Vec<Node> = Vec::new();
    for (side, wrong, class, _) in ANSWERS {
        let lines = map.area(side, wrong);
        if !lines.is_empty() {
            nodes.push(Node::Fine { class, hatch: None, lines });
        }
    }
    nodes.push(Node::Fine { class: "truth", hatch: None, lines: map.border() });
    let side = 0.1 * f64::from(CELL) * SIDE as f64;
    let mut y = MARGIN + side + LINE;
    let wrong: usize = ANSWERS.iter().filter(|answer| answer.1).map(|answer| map.count(answer.0, true)).sum();
    let model = number::model;
    let point = |p: [f64; 2]| format!("({}, {})", model(p[0]), model(p[1]));
    let NearlyCollinear { p, q, r, step } = *points;
    let mut line = |x: f64, class: &'static str, words: String| {
        let size = 12f64.min(12.0 * (side - x + MARGIN) / text::width(&words, 12.0, class == "ct"));
        nodes.push(Node::Text { class, at: xy(x, y), size, text: words });
        y += LINE;
        y - LINE
    };
    let cells = SIDE * SIDE;
    line(MARGIN, "ct", format!("(q - p) × (r - p) in doubles: {wrong} of {cells} answers are wrong"));
    line(MARGIN, "cs", format!("p = {} + (i, j) · {}, i to the right, j up, 0 to {}", point(p), power(step), SIDE - 1));
    line(MARGIN, "cs", format!("q = {}, r = {}; the line bounds the true answers", point(q), point(r)));
    let mut swatches = Vec::new();
    for (answer, wrong, class, words) in ANSWERS {
        let y = line(MARGIN + 26.0, "cs", format!("{words}: {} cells", map.count(answer, wrong)));
        let [x, half] = [MARGIN, 6.5];
        let outline = vec![xy(x, y - half), xy(x + 18.0, y - half), xy(x + 18.0, y + half), xy(x, y + half)];
        swatches.push(Node::Area { class, hatch: None, outlines: vec![outline] });
    }
    nodes.extend(swatches);
    let size = xy(side + 2.0 * MARGIN, y + 4.0);
    let prefix = options.prefix();
    let mut css = options.css();
    for (class, properties) in [
        (".strong", "fill-opacity:.9"),
        (".ct", "font-weight:700;text-anchor:start"),
        (".cs", "text-anchor:start"),
        (".truth", "fill:none;stroke-width:1;stroke-linecap:square"),
    ] {
        rule(&mut css, &prefix, class, properties);
    }
    options.style.in_both(&mut css, |css, palette| {
        for (class, key) in [(".ct", "fill"), (".cs", "fill"), (".truth", "stroke")] {
            rule(css, &prefix, class, &format!("{key}:{}", palette.ink));
        }
    });
    let about = format!(
        "A map of {cells} points next to a line. Strong cells show where the orientation test in doubles is wrong: \
         {wrong} times."
    );
    let mut scene = Scene { css, nodes, ..options.scene("robustness", size, about) };
    scene.attributes.extend([("data-cells", cells.to_string()), ("data-wrong", wrong.to_string())]);
    Figure { scene, detail: Detail::Full, notes: Vec::new() }
}
