//! The drawing of a chart.
//!
//! ```text
//!   title of y                            ┐
//!   ┌──────────────────────┐ name         │ height
//!   │                      │ name         │
//!   └──────────────────────┘              ┘
//!     ticks   title of x     margin for the names that end at the right side
//! ```

use crate::figure::canvas::scene::{Group, Node, Scene, Step};
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::canvas::{number, text};
use crate::figure::kinds::chart::axis::{Scale, Tick};
use crate::figure::kinds::chart::series::{Reference, Sample, Series};
use crate::figure::kinds::chart::{Chart, ChartError};
use crate::figure::layout::crowd::{Crowd, INK, Shape};
use crate::figure::sketch::places::{self, Anchor};
use crate::figure::sketch::{Role, clip, css};
use crate::figure::structure::notes::Notes;
use crate::figure::{Detail, Figure, FigureOptions};

/// Sizes of the numbers, and of titles and names.
const SMALL: f64 = 11.0;
const LARGE: f64 = 12.0;
/// Distance of two names.
const LINE: f64 = 16.0;
/// Above and below the plot.
const HEAD: f64 = 34.0;
const FOOT: f64 = 48.0;
/// Length of ticks.
const TICK: f64 = 5.0;
/// Half the width of the cap of an error bar.
const CAP: f64 = 4.0;
/// A series with more points than this has marks on some of them only.
const MARKS: usize = 40;

pub(super) fn draw(chart: &Chart, options: &FigureOptions) -> Result<Figure, ChartError> {
    let mut notes = Notes::default();
    let series: Vec<(&Series, Vec<Sample>)> =
        chart.series.iter().map(|series| (series, placed(chart, series, &mut notes))).collect();
    let samples = || series.iter().flat_map(|(_, samples)| samples.iter());
    let heights = samples().flat_map(|s| [s.y].into_iter().chain(s.range.into_iter().flatten()));
    let points = chart.series.iter().map(|series| series.samples.len()).sum();
    let scales = chart.x.scale(samples().map(|s| s.x)).zip(chart.y.scale(heights));
    let (x, y) = scales.ok_or(ChartError::NoPoint { points })?;
    let (xs, ys) = (x.ticks(), y.ticks());

    let width = options.width.unwrap_or(options.usual_width);
    let height = (0.62 * width).min(options.height.unwrap_or(f64::INFINITY)).max(HEAD + FOOT + 60.0);
    let widest = |words: &mut dyn Iterator<Item = &str>, size: f64| {
        words.map(|words| text::width(words, size, false)).fold(0.0, f64::max)
    };
    let left = 14.0 + TICK + widest(&mut ys.iter().filter_map(|tick| tick.label.as_deref()), SMALL);
    let right = 24.0 + widest(&mut series.iter().map(|(series, _)| series.name.as_str()), LARGE).min(0.4 * width);
    let plot = Bounds { min: xy(left, HEAD), max: xy((width - right).max(left + 60.0), height - FOOT) };
    let frame = Frame { x, y, plot, size: xy(width, height) };

    let mut nodes = frame.axes(chart, &xs, &ys);
    let mut crowd = Crowd::new(frame.size);
    let mut ends: Vec<End<'_>> = Vec::new();
    for (i, reference) in chart.references.iter().enumerate() {
        let runs = frame.reference(reference);
        if runs.is_empty() {
            notes.0.push(format!("outside the picture, not drawn: the line {}", reference.growth.name()));
        }
        let lines = runs.iter().filter_map(|run| curve("ln dashed", run));
        nodes.push(group(format!("reference-{}", i + 1), Role::Plain, reference.growth.name(), lines.collect()));
        add_ink(&mut crowd, &runs);
        let run: Vec<Xy> = runs.into_iter().flatten().collect();
        ends.push(End {
            id: format!("reference-{}-label", i + 1),
            role: Role::Plain,
            words: reference.growth.name(),
            run,
        });
    }
    for (i, (series, samples)) in series.iter().enumerate() {
        let run: Vec<Xy> = samples.iter().filter_map(|s| frame.at(s.x, s.y)).collect();
        let parts = clip::polyline(&run, &plot.grown(0.5));
        let lines =
            if series.joined { parts.iter().filter_map(|part| curve("ln", part)).collect() } else { Vec::new() };
        add_ink(&mut crowd, &parts);
        run.iter().for_each(|&p| crowd.add(Shape::Disc(p, series.role.glyph().radius() + 1.0), INK));
        let mut all = lines;
        all.extend(frame.marks(series, samples));
        nodes.push(group(format!("series-{}", i + 1), series.role, &series.name, all));
        ends.push(End { id: format!("series-{}-label", i + 1), role: series.role, words: &series.name, run });
    }
    nodes.extend(frame.names(ends, &mut crowd));

    let roles: Vec<Role> = Role::ALL.into_iter().filter(|&role| uses(chart, role)).collect();
    let words: Vec<&str> = chart.series.iter().map(|series| series.name.as_str()).collect();
    let about = format!("{} over {}: {}.", chart.y.words(), chart.x.words(), words.join("; "));
    let scene = Scene {
        size: frame.size,
        unit: options.unit,
        plain: options.plain,
        prefix: options.prefix(),
        title: options.title.clone(),
        description: options.description.clone().unwrap_or(about),
        attributes: vec![("data-figure", "chart".to_owned())],
        css: css(options, &roles),
        hatches: Vec::new(),
        nodes,
    };
    Ok(Figure { scene, detail: Detail::Full, notes: notes.0 })
}

fn uses(chart: &Chart, role: Role) -> bool {
    let plain = role == Role::Plain && !chart.references.is_empty();
    plain || chart.series.iter().any(|series| series.role == role)
}

/// The points of a series that have places; the others are noted.
fn placed(chart: &Chart, series: &Series, notes: &mut Notes) -> Vec<Sample> {
    let (x, y) = (&chart.x, &chart.y);
    let fits =
        |s: &&Sample| x.takes(s.x) && y.takes(s.y) && s.range.is_none_or(|range| range.iter().all(|&v| y.takes(v)));
    let kept: Vec<Sample> = series.samples.iter().filter(fits).copied().collect();
    let lost = series.samples.len() - kept.len();
    if lost > 0 {
        notes.0.push(format!("without a place on the axes, not drawn: {lost} points of {}", series.name));
    }
    kept
}

fn group(id: String, role: Role, title: &str, nodes: Vec<Node>) -> Node {
    let title = Some(title.to_owned());
    Node::Group(Group { class: "sk", mark: role.class(), id: Some(id), title, nodes, ..Group::default() })
}

fn curve(class: &'static str, run: &[Xy]) -> Option<Node> {
    let (&start, rest) = run.split_first()?;
    Some(Node::Curve { class, start, steps: rest.iter().map(|&p| Step::Line(p)).collect() })
}

fn add_ink(crowd: &mut Crowd, runs: &[Vec<Xy>]) {
    for w in runs.iter().flat_map(|run| run.windows(2)) {
        crowd.add(Shape::Segment(w[0], w[1], 1.0), INK);
    }
}

/// A line that wants its name at its end.
struct End<'a> {
    id: String,
    role: Role,
    words: &'a str,
    run: Vec<Xy>,
}

/// The plot on its canvas.
struct Frame {
    x: Scale,
    y: Scale,
    plot: Bounds,
    size: Xy,
}

impl Frame {
    fn at(&self, x: f64, y: f64) -> Option<Xy> {
        Some(xy(self.across(x)?, self.up(y)?))
    }

    fn across(&self, x: f64) -> Option<f64> {
        Some(self.plot.min.x + self.x.place(x)? * self.plot.size().x)
    }

    fn up(&self, y: f64) -> Option<f64> {
        Some(self.plot.max.y - self.y.place(y)? * self.plot.size().y)
    }

    /// Grid, ticks, numbers and titles.
    fn axes(&self, chart: &Chart, xs: &[Tick], ys: &[Tick]) -> Vec<Node> {
        let Bounds { min, max } = self.plot;
        let (mut grid, mut axes, mut words) = (Vec::new(), Vec::new(), Vec::new());
        let line = |class: &'static str, from: Xy, to: Xy| Node::Line { class, from, to };
        // Numbers that would touch the one before are left out.
        let mut free = f64::NEG_INFINITY;
        for tick in xs {
            let Some(x) = self.across(tick.value) else { continue };
            let length = if tick.label.is_some() { TICK } else { 0.6 * TICK };
            axes.push(line("axis", xy(x, max.y), xy(x, max.y + length)));
            let Some(label) = &tick.label else { continue };
            grid.push(line("grid", xy(x, min.y), xy(x, max.y)));
            let half = 0.5 * text::width(label, SMALL, false);
            if x - half >= free {
                let at = xy(x, max.y + TICK + 9.0);
                words.push(Node::Text { class: "cm", at, size: SMALL, text: label.clone() });
                free = x + half + 6.0;
            }
        }
        for tick in ys {
            let Some(y) = self.up(tick.value) else { continue };
            let length = if tick.label.is_some() { TICK } else { 0.6 * TICK };
            axes.push(line("axis", xy(min.x - length, y), xy(min.x, y)));
            let Some(label) = &tick.label else { continue };
            grid.push(line("grid", xy(min.x, y), xy(max.x, y)));
            let at = xy(min.x - TICK - 4.0, y);
            words.push(Node::Text { class: "ce", at, size: SMALL, text: label.clone() });
        }
        axes.push(line("axis", xy(min.x, max.y), max));
        axes.push(line("axis", xy(min.x, max.y), min));
        let fitting = |words: &str| LARGE.min(LARGE * (self.size.x - 16.0) / text::width(words, LARGE, true));
        let (across, up) = (chart.x.words(), chart.y.words());
        let size = fitting(&up);
        words.push(Node::Text { class: "ct", at: xy(8.0, 0.45 * HEAD), size, text: up });
        let size = fitting(&across);
        let half = 0.5 * text::width(&across, size, true);
        let x = (0.5 * (min.x + max.x)).min(self.size.x - half - 8.0).max(half + 8.0);
        words.push(Node::Text { class: "cm bold", at: xy(x, max.y + 36.0), size, text: across });
        [grid, axes, words].map(|nodes| Node::Group(Group { nodes, ..Group::default() })).to_vec()
    }

    /// The parts of a reference inside the plot, without points on straight stretches.
    fn reference(&self, reference: &Reference) -> Vec<Vec<Xy>> {
        let place = |x: f64| self.at(x, reference.at(x)?).filter(|p| p.y.abs() < 1e9);
        let mut run: Vec<Xy> = Vec::new();
        for p in self.x.values().into_iter().filter_map(place) {
            if let [.., a, b] = run[..]
                && (b - a).unit().zip((p - b).unit()).is_some_and(|(u, v)| u.turn(v).abs() < 1e-4)
            {
                run.pop();
            }
            run.push(p);
        }
        clip::polyline(&run, &self.plot)
    }

    /// Error bars and marks.
    fn marks(&self, series: &Series, samples: &[Sample]) -> Vec<Node> {
        let every = samples.len().div_ceil(MARKS).max(1);
        let seen = self.plot.grown(0.5);
        let mut out = Vec::new();
        for (i, sample) in samples.iter().enumerate() {
            let Some(p) = self.at(sample.x, sample.y) else { continue };
            let mut nodes = Vec::new();
            if let Some([low, high]) = sample.range.map(|range| range.map(|v| self.up(v).unwrap_or(p.y)))
                && let Some((a, b)) = clip::segment(xy(p.x, low), xy(p.x, high), &seen)
            {
                nodes.push(Node::Line { class: "ol", from: a, to: b });
                nodes.extend([a, b].map(|end| Node::Line {
                    class: "ol",
                    from: end - xy(CAP, 0.0),
                    to: end + xy(CAP, 0.0),
                }));
            }
            let is_marked = i % every == 0 || i + 1 == samples.len();
            if is_marked && seen.contains(&Bounds { min: p, max: p }) {
                nodes.extend(series.role.glyph().nodes(p));
            }
            if !nodes.is_empty() {
                let (x, y) = (number::model(sample.x), number::model(sample.y));
                let title = format!("{}: {x}, {y}", series.name);
                let attributes = vec![("data-x", x), ("data-y", y)];
                out.push(Node::Group(Group { title: Some(title), attributes, nodes, ..Group::default() }));
            }
        }
        out
    }

    /// The names: in the margin, in the order of the ends, for lines that reach the right side; near their ends for
    /// the others, if there is room.
    fn names(&self, ends: Vec<End<'_>>, crowd: &mut Crowd) -> Vec<Node> {
        let mut out = Vec::new();
        let reaches = |end: &End<'_>| end.run.last().is_some_and(|p| p.x > self.plot.max.x - 30.0);
        let (mut margin, elsewhere): (Vec<_>, Vec<_>) = ends.into_iter().partition(reaches);
        for end in elsewhere.into_iter().filter(|end| !end.run.is_empty()) {
            let ways = [xy(1.0, 0.0), xy(0.8, -0.6), xy(0.8, 0.6), xy(-0.8, -0.6), xy(-0.8, 0.6)].to_vec();
            let anchor = |&at: &Xy| Anchor { at, clear: 6.0, ways: ways.clone(), is_point: true };
            let anchors: Vec<Anchor> = end.run.iter().rev().take(8).map(anchor).collect();
            match places::label(end.words, LARGE, &anchors, &self.plot.grown(2.0), crowd) {
                Some(nodes) => out.push(group(end.id, end.role, end.words, nodes)),
                None => margin.push(end),
            }
        }
        let height = |end: &End<'_>| end.run.last().map_or(0.0, |p| p.y);
        margin.sort_by(|a, b| height(a).total_cmp(&height(b)));
        let heights = apart(&margin.iter().map(height).collect::<Vec<_>>(), self.plot.min.y, self.plot.max.y);
        let x = self.plot.max.x + 16.0;
        for (end, y) in margin.into_iter().zip(heights) {
            let Some(&p) = end.run.last() else { continue };
            let tie = Node::Line { class: "tie", from: p + xy(8.0, 0.0), to: xy(x - 2.0, y) };
            let (size, text) = fitting(end.words, self.size.x - x - 4.0);
            let name = Node::Text { class: "tx start", at: xy(x, y), size, text };
            out.push(group(end.id, end.role, end.words, vec![tie, name]));
        }
        out
    }
}

/// A name as large as fits, cut short if it were too small to be read.
fn fitting(words: &str, room: f64) -> (f64, String) {
    let fits = |text: &str| text::width(text, 0.75 * LARGE, false) <= room;
    let cuts = (1..words.chars().count()).rev().map(|longest| text::shortened(words, longest));
    let text = std::iter::once(words.to_owned()).chain(cuts).find(|text| fits(text)).unwrap_or_default();
    (LARGE.min(LARGE * room / text::width(&text, LARGE, false)), text)
}

/// The same heights, moved apart to at least a line, as little as need be, within the plot as long as there is room.
fn apart(wanted: &[f64], top: f64, bottom: f64) -> Vec<f64> {
    let mut out: Vec<f64> = Vec::with_capacity(wanted.len());
    for &y in wanted {
        let least = out.last().map_or(top, |last| last + LINE);
        out.push(y.max(least));
    }
    let mut limit = bottom;
    for y in out.iter_mut().rev() {
        *y = y.min(limit);
        limit = *y - LINE;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_move_apart_and_stay_in_order() {
        let heights = apart(&[50.0, 52.0, 53.0, 190.0, 199.0], 30.0, 200.0);
        assert!(heights.windows(2).all(|w| w[1] - w[0] >= LINE - 1e-9), "{heights:?}");
        assert!(heights.iter().all(|y| (30.0..=200.0).contains(y)), "{heights:?}");
        let as_wanted = [40.0, 90.0, 150.0];
        let kept = apart(&as_wanted, 30.0, 200.0);
        assert_eq!(kept.iter().map(|y| y.to_bits()).collect::<Vec<_>>(), as_wanted.map(f64::to_bits));
    }
}
