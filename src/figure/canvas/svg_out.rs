//! From a scene to SVG text, by the element tree of crate `svg`.
//!
//! Things that crate leaves to us: numbers come as ready strings (its own would print `-0` and seventeen
//! digits), path data is built by hand (its builder keeps f32), control characters are taken out before, and
//! no style rule holds a `>`, which would be escaped.

use crate::figure::canvas::number::{drawn, push_short};
use crate::figure::canvas::scene::{Group, Hatch, Node, Polylines, Scene, Step};
use crate::figure::canvas::sheet::{Worn, share_sizes};
use crate::figure::canvas::vector::Xy;
use svg::Node as _;
use svg::node::Text as Characters;
use svg::node::element::{
    Anchor, Definitions, Description, Element, Line, Path, Pattern, Rectangle, Style, Text, Title,
};

/// The class of the lines of a hatch.
const HATCH: &str = "hatch";

/// Areas that look the same by every rule of filling.
const CONVEX: [&str; 2] = ["barb", "ph"];

/// The whole document, with a line break at its end.
pub(crate) fn document(scene: &Scene) -> String {
    let (width, height) = (drawn(scene.size.x), drawn(scene.size.y));
    let prefix = &scene.prefix;
    let mut root = svg::Document::new()
        .set("id", prefix.as_str())
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("width", scene.unit.state(scene.size.x))
        .set("height", scene.unit.state(scene.size.y))
        .set("role", "img")
        .set("aria-labelledby", format!("{prefix}-title"))
        .set("aria-describedby", format!("{prefix}-desc"));
    for (name, value) in &scene.attributes {
        root = root.set(*name, value.as_str());
    }
    let paper: Element = Rectangle::new().set("class", "bg").set("width", width).set("height", height).into();
    let mut drawing: Vec<Element> =
        std::iter::once(paper).chain(scene.nodes.iter().map(|node| element(node, prefix))).collect();
    let sizes = if scene.plain { String::new() } else { share_sizes(&mut drawing, prefix) };
    let mut worn = Worn::by(&drawing);
    let hatches: Vec<&Hatch> =
        scene.hatches.iter().filter(|h| worn.refers_to(&format!("{prefix}-{}", h.name))).collect();
    if !hatches.is_empty() {
        worn.add(HATCH);
    }
    // Inkscape knows no @supports, and then none of the rules of that style sheet: those that ask stand in their own.
    let (common, asking) = scene.css.split_at(scene.css.find("@supports").unwrap_or(scene.css.len()));
    root = root
        .add(Title::new(scene.title.as_str()).set("id", format!("{prefix}-title")))
        .add(Description::new().set("id", format!("{prefix}-desc")).add(Characters::new(scene.description.as_str())))
        .add(Style::new(worn.sheet(common) + &sizes));
    if !asking.is_empty() {
        root = root.add(Style::new(worn.sheet(asking)));
    }
    if !hatches.is_empty() {
        let patterns = hatches.into_iter().map(|hatch| pattern(hatch, prefix));
        root = root.add(patterns.fold(Definitions::new(), Definitions::add));
    }
    root = drawing.into_iter().fold(root, svg::Document::add);
    if scene.plain {
        crate::figure::canvas::plain::inline(&mut root, &scene.css);
    }
    let mut text = root.to_string();
    text.push('\n');
    text
}

fn pattern(hatch: &Hatch, prefix: &str) -> Pattern {
    let step = drawn(hatch.step);
    let line = Line::new().set("class", HATCH).set("x1", "0").set("y1", "0").set("x2", "0").set("y2", step.as_str());
    Pattern::new()
        .set("id", format!("{prefix}-{}", hatch.name))
        .set("width", step.as_str())
        .set("height", step)
        .set("patternUnits", "userSpaceOnUse")
        .set("patternTransform", format!("rotate({})", hatch.degrees))
        .add(line)
}

fn element(node: &Node, prefix: &str) -> Element {
    match node {
        Node::Group(inner) => group(inner, prefix),
        Node::Line { class, from, to } => Line::new()
            .set("class", *class)
            .set("x1", drawn(from.x))
            .set("y1", drawn(from.y))
            .set("x2", drawn(to.x))
            .set("y2", drawn(to.y))
            .into(),
        Node::Curve { class, start, steps } => {
            Path::new().set("class", *class).set("d", curve_data(*start, steps)).into()
        }
        Node::Area { class, hatch, outlines } => area(class, *hatch, prefix, outline_data(outlines)),
        Node::Fine { class, hatch, lines } if lines.closed => area(class, *hatch, prefix, fine_data(lines)),
        Node::Fine { class, lines, .. } => Path::new().set("class", *class).set("d", fine_data(lines)).into(),
        Node::Disc { class, centre, radius } => svg::node::element::Circle::new()
            .set("class", *class)
            .set("cx", drawn(centre.x))
            .set("cy", drawn(centre.y))
            .set("r", drawn(*radius))
            .into(),
        Node::Text { class, at, size, text } => {
            let line = Text::new(text.as_str())
                .set("class", *class)
                .set("x", drawn(at.x))
                .set("y", drawn(at.y))
                .set("dy", ".36em")
                .set("font-size", drawn(*size));
            line.into()
        }
    }
}

fn group(group: &Group, prefix: &str) -> Element {
    // An svg inside an svg ends at its border.
    let mut out = Element::new(if group.window.is_some() { "svg" } else { "g" });
    if let Some(size) = group.window {
        out.assign("width", drawn(size.x));
        out.assign("height", drawn(size.y));
    }
    match (group.class, group.mark) {
        ("", "") => {}
        (class, "") | ("", class) => out.assign("class", class),
        (class, mark) => out.assign("class", format!("{class} {mark}")),
    }
    if let Some(by) = group.shift {
        out.assign("transform", format!("translate({},{})", drawn(by.x), drawn(by.y)));
    }
    if let Some(id) = &group.id {
        out.assign("id", format!("{prefix}-{id}"));
    }
    for (name, value) in &group.attributes {
        out.assign(*name, value.as_str());
    }
    if let Some(title) = &group.title {
        out.append(Title::new(title.as_str()));
    }
    for node in &group.nodes {
        out.append(element(node, prefix));
    }
    match &group.link {
        Some(id) => Anchor::new().set("href", format!("#{prefix}-{id}")).add(out).into(),
        None => out,
    }
}

fn area(class: &str, hatch: Option<&str>, prefix: &str, data: String) -> Element {
    let mut out = Path::new().set("class", class).set("d", data);
    if !CONVEX.contains(&class) {
        out = out.set("fill-rule", "evenodd");
    }
    if let Some(name) = hatch {
        out = out.set("fill", format!("url(#{prefix}-{name})"));
    }
    out.into()
}

/// A start, then lines, quadratics, cubics and arcs, two decimals.
fn curve_data(start: Xy, steps: &[Step]) -> String {
    let mut pen = Pen::new(100, 1 + 3 * steps.len());
    pen.command("m", &[start]);
    for step in steps {
        match *step {
            Step::Line(to) => pen.command("l", &[to]),
            Step::Quad(control, to) => pen.command("q", &[control, to]),
            Step::Cubic(first, second, to) => pen.command("c", &[first, second, to]),
            Step::Round { radius, large, to } => {
                let r = drawn(radius);
                pen.command(&format!("a{r} {r} 0 {} 1 ", u8::from(large)), &[to]);
            }
        }
    }
    pen.out
}

fn hundredths(p: Xy) -> [i64; 2] {
    [p.x, p.y].map(|x| (x * 100.0).round() as i64)
}

/// Closed outlines, two decimals.
fn outline_data(outlines: &[Vec<Xy>]) -> String {
    let mut pen = Pen::new(100, outlines.iter().map(Vec::len).sum());
    for outline in outlines {
        pen.draw(outline.iter().copied().map(hundredths), true);
    }
    pen.out
}

/// Lines or outlines, one decimal; a lone point is drawn as a dot.
fn fine_data(lines: &Polylines) -> String {
    let mut pen = Pen::new(10, lines.point_count());
    for line in lines.iter() {
        pen.draw(line.iter().map(|p| p.map(i64::from)), lines.closed);
    }
    pen.out
}

/// Writes `m dx dy dx dy ...`: relative steps, the first of all from the origin, as short as the grammar allows.
struct Pen {
    out: String,
    at: [i64; 2],
    /// How many units of the numbers given make a px: 10 or 100.
    unit: u64,
}

impl Pen {
    fn new(unit: u64, points: usize) -> Self {
        Self { out: String::with_capacity(points * 8), at: [0, 0], unit }
    }

    fn draw(&mut self, points: impl ExactSizeIterator<Item = [i64; 2]>, closed: bool) {
        let (count, mut start) = (points.len(), None);
        for p in points {
            if start.is_none() {
                self.out.push('m');
            }
            self.step(p[0] - self.at[0], start.is_some());
            self.step(p[1] - self.at[1], true);
            self.at = p;
            start = start.or(Some(p));
        }
        if count == 1 && !closed {
            self.out.push_str("h0");
        }
        if let (true, Some(start)) = (closed, start) {
            self.out.push('z');
            self.at = start;
        }
    }

    /// A command to the last of some points, by the others; units are hundredths.
    fn command(&mut self, letter: &str, points: &[Xy]) {
        self.out.push_str(letter);
        let start = self.at;
        for (i, p) in points.iter().copied().map(hundredths).enumerate() {
            self.step(p[0] - start[0], i > 0);
            self.step(p[1] - start[1], true);
            self.at = p;
        }
    }

    /// A number, after a space where the one before would run into it.
    fn step(&mut self, value: i64, separate: bool) {
        let last = self.out.len();
        push_short(&mut self.out, value, self.unit);
        let first = self.out.as_bytes()[last];
        let joins = first == b'-' || (first == b'.' && fraction_before(&self.out[..last]));
        if separate && !joins {
            self.out.insert(last, ' ');
        }
    }
}

/// Whether the number at the end of `text` has a point already, so that a second point begins a new number.
fn fraction_before(text: &str) -> bool {
    text.bytes().rev().take_while(|b| b.is_ascii_digit() || *b == b'.').any(|b| b == b'.')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::canvas::vector::xy;

    #[test]
    fn fine_paths_are_relative_and_as_short_as_the_grammar_allows() {
        let mut lines = Polylines::new(false);
        lines.start([100, 205]);
        lines.line_to([106, 211]);
        lines.line_to([106, 211]);
        lines.line_to([96, 211]);
        lines.start([90, 211]);
        assert_eq!(fine_data(&lines), "m10 20.5.6.6-1 0m-.6 0h0");
    }

    #[test]
    fn outlines_are_relative_and_do_not_drift() {
        let third = 1.0 / 3.0;
        let outline = vec![xy(third, 0.0), xy(2.0 * third, -0.004), xy(1.0, 1.05), xy(0.333, 10.0)];
        assert_eq!(
            outline_data(&[outline, vec![xy(1.0, 1.0), xy(2.0, 1.0)]]),
            "m.33 0 .34 0 .33 1.05-.67 8.95zm.67 1 1 0z"
        );
    }

    #[test]
    fn curves_are_relative_to_the_start_of_each_step() {
        let steps = [
            Step::Quad(xy(12.0, 10.0), xy(12.0, 8.5)),
            Step::Round { radius: 14.0, large: true, to: xy(11.75, 8.0) },
            Step::Line(xy(11.0, 8.0)),
        ];
        assert_eq!(curve_data(xy(10.0, 10.0), &steps), "m10 10q2 0 2-1.5a14 14 0 1 1 -.25-.5l-.75 0");
    }

    #[test]
    fn after_a_closed_outline_the_pen_is_back_at_its_start() {
        let mut lines = Polylines::new(true);
        lines.start([10, 10]);
        lines.line_to([20, 10]);
        lines.line_to([10, 20]);
        lines.start([30, 10]);
        lines.line_to([40, 10]);
        lines.line_to([30, 20]);
        assert_eq!(fine_data(&lines), "m1 1 1 0-1 1zm2 0 1 0-1 1z");
    }
}
