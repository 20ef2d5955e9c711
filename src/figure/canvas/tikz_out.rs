//! From a scene to TikZ, the pictures of TeX.
//!
//! ```text
//!   Scene + style sheet ──> every shape with its own colours, widths and dashes ──> \draw, \fill, \node
//! ```
//!
//! The picture has the size of the SVG: a px is 0.75 bp, and y points down as there. What has an id in the SVG has its
//! bounding box as a TikZ node of the same name without the prefix, so that an arrow of one's own can point to `(v3)`.
//! Letters are those of the document.
//!
//! Source: Tantau et al., *The TikZ and PGF packages*, manual for 3.1.10: sections 14 and 15 (paths), 63 (`patterns.meta`).

use super::arc::arc;
use super::number::drawn;
use super::scene::{Group, Hatch, Node, Polylines, Scene, Step};
use super::scripts::tex_of;
use super::selectors::{Rule, Tag, rules};
use super::vector::{Xy, xy};
use crate::figure::Figure;
use std::collections::BTreeMap;
use std::fmt::{Display, Write};

/// bp for each px.
const BP: f64 = 0.75;
/// With more groups than this, their bounding boxes get no names: TeX would take long.
const MOST_NAMES: usize = 2000;

impl Figure {
    /// The figure as a `tikzpicture`, to be read by `\input` in a document with
    /// `\usepackage{tikz}\usetikzlibrary{patterns.meta}`. Colours are those for light pages, unless the style has none but
    /// dark ones; what has an id is a TikZ node of that name without the prefix.
    ///
    /// ```
    /// use dcel_kit::{figure, plane::Subdivision};
    /// let picture = figure::structure(&Subdivision::lab_rectangle(), &Default::default())?.to_tikz();
    /// assert!(picture.contains("\\begin{tikzpicture}") && picture.contains("local bounding box=h0"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn to_tikz(&self) -> String {
        Writer::picture(&self.scene)
    }

    /// The same as a document of its own: one page of the size of the figure.
    #[must_use]
    pub fn to_tex(&self) -> String {
        let [width, height] = [self.scene.size.x, self.scene.size.y].map(|side| drawn(side * BP));
        format!(
            "\\RequirePackage{{fix-cm}}\n\\documentclass{{article}}\n\\usepackage{{tikz}}\n\
             \\usetikzlibrary{{patterns.meta}}\n\\renewcommand{{\\familydefault}}{{\\sfdefault}}\n\
             \\usepackage[paperwidth={width}bp,paperheight={height}bp,margin=0bp,noheadfoot,nomarginpar]{{geometry}}\n\
             \\pagestyle{{empty}}\\setlength{{\\parindent}}{{0pt}}\\setlength{{\\topskip}}{{0pt}}\n\\begin{{document}}%\n\
             {}\\end{{document}}\n",
            self.to_tikz()
        )
    }
}

/// What a shape looks like, from the rules and from what is around it.
#[derive(Clone, Default)]
struct Looks<'a>(BTreeMap<&'a str, &'a str>);

/// Properties that what is inside a group does not take over.
const OWN: [&str; 2] = ["display", "opacity"];

impl<'a> Looks<'a> {
    fn get(&self, key: &str) -> Option<&'a str> {
        self.0.get(key).copied().filter(|value| !value.is_empty())
    }

    fn number(&self, key: &str) -> Option<f64> {
        let text = self.get(key)?;
        text.strip_suffix("px").unwrap_or(text).parse().ok()
    }

    /// A colour, unless there is none.
    fn colour(&self, key: &str) -> Option<&'a str> {
        self.get(key).filter(|value| value.starts_with('#'))
    }
}

struct Writer<'a> {
    out: String,
    rules: Vec<Rule<'a>>,
    path: Vec<Tag>,
    prefix: &'a str,
    hatches: &'a [Hatch],
    colours: BTreeMap<String, String>,
    names: bool,
}

impl<'a> Writer<'a> {
    fn picture(scene: &'a Scene) -> String {
        let mut this = Self {
            out: String::new(),
            rules: rules(&scene.css),
            path: vec![Tag { name: "svg".to_owned(), id: Some(scene.prefix.clone()), ..Tag::default() }],
            prefix: &scene.prefix,
            hatches: &scene.hatches,
            colours: BTreeMap::new(),
            names: groups(&scene.nodes) <= MOST_NAMES,
        };
        let looks = this.looks("svg", "", None, &Looks::default());
        this.looks_of("rect", "bg", &looks, |this, looks| {
            let paint = this.paint(looks, None, true);
            let _ = writeln!(this.out, "\\path[use as bounding box{paint}] (0,0) rectangle {};", point(scene.size));
        });
        scene.nodes.iter().for_each(|node| this.node(node, &looks));
        let title = escaped(&scene.title);
        let colours: String =
            this.colours.iter().map(|(hex, name)| format!("\\definecolor{{{name}}}{{HTML}}{{{hex}}}\n")).collect();
        format!(
            "% {title}\n% needs: \\usepackage{{tikz}} \\usetikzlibrary{{patterns.meta}}\n{colours}\
             \\begin{{tikzpicture}}[x={BP}bp,y=-{BP}bp,every node/.style={{inner sep=0pt,outer sep=0pt}}]\n{}\
             \\end{{tikzpicture}}\n",
            this.out
        )
    }

    /// What the rules say of a tag on the path, over what is inherited.
    fn looks(&mut self, name: &str, class: &str, id: Option<&str>, inherited: &Looks<'a>) -> Looks<'a> {
        let classes = class.split_whitespace().map(str::to_owned).collect();
        let id = id.map(|id| format!("{}-{id}", self.prefix));
        let is_root = name == "svg" && self.path.len() == 1 && class.is_empty();
        if !is_root {
            self.path.push(Tag { name: name.to_owned(), id, classes, ..Tag::default() });
        }
        let mut looks = inherited.clone();
        looks.0.retain(|key, _| !OWN.contains(key));
        for rule in self.rules.iter().filter(|rule| rule.fits(&self.path)) {
            looks.0.extend(rule.properties.iter().copied());
        }
        looks
    }

    /// Writes a shape with its looks; shapes that are not shown are left out.
    fn looks_of(&mut self, name: &str, class: &str, inherited: &Looks<'a>, write: impl FnOnce(&mut Self, &Looks<'a>)) {
        let looks = self.looks(name, class, None, inherited);
        if looks.get("display") != Some("none") {
            write(self, &looks);
        }
        self.path.pop();
    }

    fn node(&mut self, node: &Node, around: &Looks<'a>) {
        match node {
            Node::Group(inner) => self.group(inner, around),
            Node::Line { class, from, to } => self.looks_of("line", class, around, |this, looks| {
                let paint = this.paint(looks, None, false);
                let _ = writeln!(this.out, "\\path[{}] {}--{};", tidy(&paint), point(*from), point(*to));
            }),
            Node::Curve { class, start, steps } => self.looks_of("path", class, around, |this, looks| {
                let paint = this.paint(looks, None, true);
                let _ = writeln!(this.out, "\\path[{}] {};", tidy(&paint), curve(*start, steps));
            }),
            Node::Area { class, hatch, outlines } => {
                let path: Vec<String> = outlines.iter().map(|outline| closed(outline.iter().copied())).collect();
                self.area(class, *hatch, &path.join(" "), around);
            }
            Node::Fine { class, hatch, lines } if lines.closed => {
                let path: Vec<String> = lines.iter().map(|line| closed(line.iter().map(of_tenths))).collect();
                self.area(class, *hatch, &path.join(" "), around);
            }
            Node::Fine { class, lines, .. } => self.looks_of("path", class, around, |this, looks| {
                let paint = this.paint(looks, None, false);
                let _ = writeln!(this.out, "\\path[{}] {};", tidy(&paint), open(lines));
            }),
            Node::Disc { class, centre, radius } => self.looks_of("circle", class, around, |this, looks| {
                let paint = this.paint(looks, None, true);
                let radius = drawn(radius * BP);
                let _ = writeln!(this.out, "\\path[{}] {} circle[radius={radius}bp];", tidy(&paint), point(*centre));
            }),
            Node::Text { class, at, size, text } => {
                self.looks_of("text", class, around, |this, looks| this.text(looks, *at, *size, text));
            }
        }
    }

    fn area(&mut self, class: &str, hatch: Option<&str>, path: &str, around: &Looks<'a>) {
        self.looks_of("path", class, around, |this, looks| {
            let paint = this.paint(looks, hatch, true);
            let _ = writeln!(this.out, "\\path[even odd rule{paint}] {path};");
        });
    }

    fn group(&mut self, group: &Group, around: &Looks<'a>) {
        let class = format!("{} {}", group.class, group.mark);
        let looks = self.looks(if group.window.is_some() { "svg" } else { "g" }, &class, group.id.as_deref(), around);
        if looks.get("display") == Some("none") {
            self.path.pop();
            return;
        }
        let mut options = String::new();
        option(&mut options, "shift", group.shift.map(|by| format!("{{{}}}", point(by))));
        option(&mut options, "opacity", looks.number("opacity").map(drawn));
        option(&mut options, "local bounding box", group.id.as_ref().filter(|_| self.names));
        let is_scope = !options.is_empty() || group.window.is_some();
        if is_scope {
            let _ = writeln!(self.out, "\\begin{{scope}}[{}]", tidy(&options));
        }
        if let Some(size) = group.window {
            let _ = writeln!(self.out, "\\clip (0,0) rectangle {};", point(size));
        }
        group.nodes.iter().for_each(|node| self.node(node, &looks));
        if is_scope {
            self.out.push_str("\\end{scope}\n");
        }
        self.path.pop();
    }

    /// The options for the paint of a shape, each after a comma.
    fn paint(&mut self, looks: &Looks<'a>, hatch: Option<&str>, fills: bool) -> String {
        let mut out = String::new();
        if let Some(hatch) = hatch.and_then(|name| self.hatches.iter().find(|hatch| hatch.name == name)) {
            let lines = self.hatch_lines();
            let colour = lines.colour("stroke").map_or_else(|| "black".to_owned(), |hex| self.colour(hex));
            let (step, width) = (drawn(hatch.step * BP), drawn(lines.number("stroke-width").unwrap_or(1.0) * BP));
            // The lines of the SVG are upright before they are turned.
            let angle = 90 - hatch.degrees;
            let _ = write!(
                out,
                ",pattern={{Lines[angle={angle},distance={step}bp,line width={width}bp]}},pattern color={colour}"
            );
        } else if fills && looks.get("fill") != Some("none") {
            // Without a rule, the inside is black.
            let colour = looks.colour("fill").map_or_else(|| "black".to_owned(), |hex| self.colour(hex));
            let _ = write!(out, ",fill={colour}");
            option(&mut out, "fill opacity", looks.number("fill-opacity").map(drawn));
        }
        if let Some(hex) = looks.colour("stroke") {
            let colour = self.colour(hex);
            let _ =
                write!(out, ",draw={colour},line width={}bp", drawn(looks.number("stroke-width").unwrap_or(1.0) * BP));
            let [cap, join] = ["stroke-linecap", "stroke-linejoin"].map(|key| looks.get(key));
            option(&mut out, "draw opacity", looks.number("stroke-opacity").map(drawn));
            option(&mut out, "dash pattern", looks.get("stroke-dasharray").and_then(dashes));
            option(&mut out, "line cap", cap.filter(|cap| ["round", "butt"].contains(cap)));
            option(&mut out, "line join", join.filter(|join| ["round", "bevel", "miter"].contains(join)));
        }
        option(&mut out, "opacity", looks.number("opacity").map(drawn));
        out
    }

    /// What the rules say of the lines of a hatch.
    fn hatch_lines(&mut self) -> Looks<'a> {
        let path = self.path.drain(1..).collect::<Vec<_>>();
        let looks = self.looks("line", "hatch", None, &Looks::default());
        self.path.truncate(1);
        self.path.extend(path);
        looks
    }

    fn text(&mut self, looks: &Looks<'a>, at: Xy, size: f64, text: &str) {
        let anchor = match looks.get("text-anchor") {
            Some("start") => "base west",
            Some("end") => "base east",
            _ => "base",
        };
        let colour = looks.colour("fill").map_or_else(|| "black".to_owned(), |hex| self.colour(hex));
        let mut options = format!("anchor={anchor},text={colour}");
        // The line round the letters becomes a plate behind them.
        if let Some(hex) = looks.colour("stroke").filter(|_| looks.get("paint-order").is_some()) {
            let paper = self.colour(hex);
            let _ = write!(options, ",fill={paper},fill opacity=0.8,text opacity=1");
        }
        let opacity = looks.number("opacity").or_else(|| looks.number("fill-opacity"));
        option(&mut options, "text opacity", opacity.map(drawn));
        let (letters, line) = (drawn(size * BP), drawn(size * BP * 1.2));
        let bold = if looks.get("font-weight").is_some_and(|w| w == "bold" || w >= "600") { "\\bfseries" } else { "" };
        let italic = if looks.get("font-style") == Some("italic") { "\\itshape" } else { "" };
        let baseline = point(xy(at.x, at.y + 0.36 * size));
        let text = escaped(text);
        let _ = writeln!(
            self.out,
            "\\node[{options}] at {baseline} {{\\fontsize{{{letters}bp}}{{{line}bp}}\\selectfont{bold}{italic} {text}}};"
        );
    }

    /// The name of a colour of the style: `#b5420a` or `#fff`.
    fn colour(&mut self, hex: &str) -> String {
        let digits = hex.trim_start_matches('#');
        let long: String =
            if digits.len() == 3 { digits.chars().flat_map(|c| [c, c]).collect() } else { digits.to_owned() };
        let long = long.to_ascii_uppercase();
        let name = format!("dcel{long}");
        self.colours.insert(long, name.clone());
        name
    }
}

fn groups(nodes: &[Node]) -> usize {
    let inside = |node: &Node| if let Node::Group(group) = node { 1 + groups(&group.nodes) } else { 0 };
    nodes.iter().map(inside).sum()
}

/// Options without the comma before the first.
fn tidy(options: &str) -> &str {
    options.strip_prefix(',').unwrap_or(options)
}

fn point(p: Xy) -> String {
    format!("({},{})", drawn(p.x), drawn(p.y))
}

fn of_tenths(&[x, y]: &[i32; 2]) -> Xy {
    xy(f64::from(x) * 0.1, f64::from(y) * 0.1)
}

fn closed(points: impl Iterator<Item = Xy>) -> String {
    let mut out: Vec<String> = points.map(point).collect();
    out.push("cycle".to_owned());
    out.join("--")
}

fn open(lines: &Polylines) -> String {
    let line = |points: &[[i32; 2]]| {
        let points: Vec<String> = points.iter().map(of_tenths).map(point).collect();
        // A lone point is a dot.
        if let [only] = &points[..] { format!("{only}--{only}") } else { points.join("--") }
    };
    lines.iter().map(line).collect::<Vec<_>>().join(" ")
}

fn curve(start: Xy, steps: &[Step]) -> String {
    let mut out = point(start);
    let mut at = start;
    let cubic = |out: &mut String, a: Xy, b: Xy, to: Xy| {
        let _ = write!(out, "..controls {} and {}..{}", point(a), point(b), point(to));
    };
    for step in steps {
        match *step {
            Step::Line(to) => out.extend(["--", &point(to)]),
            Step::Quad(control, to) => {
                let towards = |p: Xy| p + (control - p) * (2.0 / 3.0);
                cubic(&mut out, towards(at), towards(to), to);
            }
            Step::Cubic(a, b, to) => cubic(&mut out, a, b, to),
            Step::Round { radius, large, to } => {
                arc(at, to, radius, large, &mut |a, b, to| cubic(&mut out, a, b, to));
            }
        }
        at = step.end();
    }
    out
}

/// Adds `,name=value` where there is a value.
fn option(out: &mut String, name: &str, value: Option<impl Display>) {
    if let Some(value) = value {
        let _ = write!(out, ",{name}={value}");
    }
}

/// `on 3bp off 2bp` of `4 2.67`.
fn dashes(text: &str) -> Option<String> {
    let lengths: Option<Vec<f64>> =
        text.split([' ', ',']).filter(|word| !word.is_empty()).map(|word| word.parse().ok()).collect();
    let mut lengths = lengths.filter(|lengths| !lengths.is_empty())?;
    if lengths.len() % 2 == 1 {
        lengths.extend_from_within(..);
    }
    let words = ["on", "off"].into_iter().cycle().zip(lengths);
    Some(words.map(|(word, length)| format!("{word} {}bp", drawn(length * BP))).collect::<Vec<_>>().join(" "))
}

/// Text that TeX sets as it stands.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => out.extend(['\\', c]),
            '^' => out.push_str("\\textasciicircum{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '<' => out.push_str("\\textless{}"),
            '>' => out.push_str("\\textgreater{}"),
            '|' => out.push_str("\\textbar{}"),
            '"' => out.push_str("{''}"),
            '\n' | '\r' => out.push(' '),
            _ => match tex_of(c) {
                Some((small, is_above)) => {
                    let place = if is_above { "super" } else { "sub" };
                    let _ = write!(out, "\\text{place}script{{{small}}}");
                }
                None => out.push(c),
            },
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_set_as_it_stands_and_dashes_come_in_pairs() {
        assert_eq!(escaped("f_1 & 50% {x}"), "f\\_1 \\& 50\\% \\{x\\}");
        assert_eq!(escaped("a\\b^c"), "a\\textbackslash{}b\\textasciicircum{}c");
        assert_eq!(dashes("4 2").unwrap(), "on 3bp off 1.5bp");
        assert_eq!(dashes("4").unwrap(), "on 3bp off 3bp");
        assert_eq!(dashes("none"), None);
        assert_eq!(escaped("e₁ r²"), "e\\textsubscript{1} r\\textsuperscript{2}");
    }
}
