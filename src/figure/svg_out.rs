//! From a scene to SVG text, by the element tree of crate `svg`.
//!
//! Things that crate leaves to us: numbers come as ready strings (its own would print `-0` and seventeen
//! digits), path data is built by hand (its builder keeps f32), control characters are taken out before, and
//! no style rule holds a `>`, which would be escaped.

use super::number::{drawn, push, push_tenths};
use super::scene::{Group, Hatch, Node, Polylines, Scene, Step};
use super::vector::Xy;
use svg::node::Text as Characters;
use svg::node::element::{
    Anchor, Definitions, Description, Element, Line, Path, Pattern, Rectangle, Style, Text, Title,
};

/// The whole document, with a line break at its end.
pub(super) fn document(scene: &Scene) -> String {
    let (width, height) = (drawn(scene.size.x), drawn(scene.size.y));
    let prefix = &scene.prefix;
    let mut root = svg::Document::new()
        .set("id", prefix.as_str())
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("width", scene.unit.state(scene.size.x))
        .set("height", scene.unit.state(scene.size.y))
        .set("role", "img")
        .set("aria-labelledby", format!("{prefix}-title {prefix}-desc"));
    for (name, value) in &scene.attributes {
        root = root.set(*name, value.as_str());
    }
    root = root
        .add(Title::new(scene.title.as_str()).set("id", format!("{prefix}-title")))
        .add(Description::new().set("id", format!("{prefix}-desc")).add(Characters::new(scene.description.as_str())))
        .add(Style::new(scene.css.trim_end()));
    if !scene.hatches.is_empty() {
        let patterns = scene.hatches.iter().map(|hatch| pattern(hatch, prefix));
        root = root.add(patterns.fold(Definitions::new(), Definitions::add));
    }
    root = root.add(Rectangle::new().set("class", "bg").set("width", width).set("height", height));
    for node in &scene.nodes {
        root = root.add(element(node, prefix));
    }
    if scene.plain {
        super::plain::inline(&mut root, &scene.css);
    }
    let mut text = root.to_string();
    text.push('\n');
    text
}

fn pattern(hatch: &Hatch, prefix: &str) -> Pattern {
    let step = drawn(hatch.step);
    let line = Line::new().set("class", "hatch").set("x1", "0").set("y1", "0").set("x2", "0").set("y2", step.as_str());
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
    let mut out = svg::node::element::Group::new();
    match (group.class, group.mark) {
        ("", "") => {}
        (class, "") | ("", class) => out = out.set("class", class),
        (class, mark) => out = out.set("class", format!("{class} {mark}")),
    }
    if let Some(by) = group.shift {
        out = out.set("transform", format!("translate({},{})", drawn(by.x), drawn(by.y)));
    }
    if let Some(id) = &group.id {
        out = out.set("id", format!("{prefix}-{id}"));
    }
    for (name, value) in &group.attributes {
        out = out.set(*name, value.as_str());
    }
    if let Some(title) = &group.title {
        out = out.add(Title::new(title.as_str()));
    }
    for node in &group.nodes {
        out = out.add(element(node, prefix));
    }
    match &group.link {
        Some(id) => Anchor::new().set("href", format!("#{prefix}-{id}")).add(out).into(),
        None => out.into(),
    }
}

fn area(class: &str, hatch: Option<&str>, prefix: &str, data: String) -> Element {
    let mut out = Path::new().set("class", class).set("d", data).set("fill-rule", "evenodd");
    if let Some(name) = hatch {
        out = out.set("fill", format!("url(#{prefix}-{name})"));
    }
    out.into()
}

/// `M x,y`, then `L`, `Q`, `C` and `A` with their points, two decimals.
fn curve_data(start: Xy, steps: &[Step]) -> String {
    let mut out = String::new();
    let mut points = |command: &str, points: &[Xy]| {
        out.push_str(command);
        for (i, p) in points.iter().enumerate() {
            if i > 0 {
                out.push(' ');
            }
            push(&mut out, p.x);
            out.push(',');
            push(&mut out, p.y);
        }
    };
    points("M", &[start]);
    for step in steps {
        match *step {
            Step::Line(to) => points("L", &[to]),
            Step::Quad(control, to) => points("Q", &[control, to]),
            Step::Cubic(first, second, to) => points("C", &[first, second, to]),
            Step::Round { radius, large, to } => {
                let r = drawn(radius);
                points(&format!("A{r},{r} 0 {} 1 ", u8::from(large)), &[to]);
            }
        }
    }
    out
}

/// `M x,y L x,y ... Z` for each outline, two decimals.
fn outline_data(outlines: &[Vec<Xy>]) -> String {
    let mut out = String::new();
    for outline in outlines {
        for (i, p) in outline.iter().enumerate() {
            out.push(if i == 0 { 'M' } else { 'L' });
            push(&mut out, p.x);
            out.push(',');
            push(&mut out, p.y);
        }
        out.push('Z');
    }
    out
}

/// `m dx dy dx dy ...`: relative steps, the first of all from the origin; a lone point is drawn as a dot.
fn fine_data(lines: &Polylines) -> String {
    let mut out = String::with_capacity(lines.point_count() * 7);
    let mut at = [0, 0];
    for line in lines.iter() {
        out.push('m');
        let mut separate = false;
        for &p in line {
            push_step(&mut out, p[0] - at[0], separate);
            push_step(&mut out, p[1] - at[1], true);
            separate = true;
            at = p;
        }
        if line.len() == 1 && !lines.closed {
            out.push_str("h0");
        }
        if lines.closed {
            out.push('z');
            at = line[0];
        }
    }
    out
}

/// A number of a path, after a space where the one before would run into it.
fn push_step(out: &mut String, tenths: i32, separate: bool) {
    let last = out.len();
    push_tenths(out, tenths);
    let joins = out.as_bytes()[last] == b'-' || (out.as_bytes()[last] == b'.' && fraction_before(&out[..last]));
    if separate && !joins {
        out.insert(last, ' ');
    }
}

/// Whether the number at the end of `text` has a point already, so that a second point begins a new number.
fn fraction_before(text: &str) -> bool {
    text.bytes().rev().take_while(|b| b.is_ascii_digit() || *b == b'.').any(|b| b == b'.')
}

#[cfg(test)]
mod tests {
    use super::*;

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
