//! Reading a drawing back from its SVG text, with the moves of the groups applied.

use roxmltree::{Document, Node};
use std::collections::BTreeMap;
use svg::node::element::path::{Command, Data, Position};

pub(crate) type P = [f64; 2];

/// A text on the canvas.
#[derive(Clone, Debug)]
pub(crate) struct Word {
    pub(crate) class: String,
    pub(crate) text: String,
    pub(crate) at: P,
    pub(crate) size: f64,
}

impl Word {
    /// Left, top, right and bottom, by widths that are a little less than those of any usual font.
    pub(crate) fn bounds(&self) -> [f64; 4] {
        let em = |c: char| match c {
            'i' | 'j' | 'l' | ' ' | '\'' | '.' | ',' | 'I' => 0.25,
            'f' | 'r' | 't' | '-' => 0.33,
            'm' | 'w' | 'M' | 'W' => 0.8,
            _ => 0.53,
        };
        let width: f64 = self.text.chars().map(em).sum::<f64>() * self.size;
        let starts = ["cs", "ct", "start"].iter().any(|class| self.class.split(' ').any(|c| c == *class));
        let left = if starts { self.at[0] } else { self.at[0] - 0.5 * width };
        [left, self.at[1] - 0.36 * self.size, left + width, self.at[1] + 0.36 * self.size]
    }
}

pub(crate) fn overlap(a: [f64; 4], b: [f64; 4]) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// What a group with an id holds.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    pub(crate) class: String,
    pub(crate) title: Option<String>,
    pub(crate) data: BTreeMap<String, String>,
    /// Centre, radius.
    pub(crate) discs: Vec<(P, f64)>,
    /// Class, ends.
    pub(crate) lines: Vec<(String, P, P)>,
    /// Class, path data.
    pub(crate) paths: Vec<(String, String)>,
    /// By how much its parts are moved.
    pub(crate) shift: P,
    pub(crate) words: Vec<Word>,
}

impl Group {
    /// The points of all paths of straight steps with a class.
    pub(crate) fn rings(&self, class: &str) -> Vec<Vec<P>> {
        let chosen = self.paths.iter().filter(|(c, _)| c.split(' ').any(|c| c == class));
        chosen
            .flat_map(|(_, data)| straight(data))
            .map(|ring| ring.into_iter().map(|p| add(p, self.shift)).collect())
            .collect()
    }

    /// All points of lines, discs and paths of straight steps.
    pub(crate) fn corners(&self) -> Vec<P> {
        let lines = self.lines.iter().flat_map(|line| [line.1, line.2]);
        let discs = self.discs.iter().map(|disc| disc.0);
        let paths = self.paths.iter().filter(|(_, data)| !data.contains(['A', 'Q', 'C', 'a', 'q', 'c']));
        let paths = paths.flat_map(|(_, data)| straight(data)).flatten().map(|p| add(p, self.shift));
        lines.chain(discs).chain(paths).collect()
    }
}

/// What the file shows, by the ids of the groups without the prefix.
pub(crate) struct Drawing {
    pub(crate) size: P,
    pub(crate) groups: BTreeMap<String, Group>,
    /// All texts.
    pub(crate) words: Vec<Word>,
}

pub(crate) fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("{text:?} is not a number"))
}

fn attribute(node: Node<'_, '_>, name: &str) -> f64 {
    number(node.attribute(name).unwrap_or_else(|| panic!("{name} is missing")))
}

fn add(a: P, b: P) -> P {
    [a[0] + b[0], a[1] + b[1]]
}

fn shift(node: Node<'_, '_>) -> P {
    node.ancestors().filter_map(|a| a.attribute("transform")).filter(|t| t.starts_with("translate")).fold(
        [0.0; 2],
        |sum, t| {
            let (x, y) = t.trim_start_matches("translate(").trim_end_matches(')').split_once(',').unwrap();
            add(sum, [number(x), number(y)])
        },
    )
}

impl Drawing {
    pub(crate) fn read(svg: &str) -> Self {
        let document = Document::parse(svg).unwrap_or_else(|error| panic!("{error}"));
        let root = document.root_element();
        let prefix = format!("{}-", root.attribute("id").unwrap());
        let mut out = Self {
            size: ["width", "height"].map(|name| attribute(root, name)),
            groups: BTreeMap::new(),
            words: Vec::new(),
        };
        for node in root.descendants().filter(Node::is_element) {
            let class = node.attribute("class").unwrap_or_default().to_owned();
            let owner =
                node.ancestors().find(|a| a.has_tag_name(("http://www.w3.org/2000/svg", "g")) && a.has_attribute("id"));
            let moved = shift(node);
            let at = |x: &str, y: &str| add([attribute(node, x), attribute(node, y)], moved);
            let Some(owner) = owner else {
                if node.has_tag_name(("http://www.w3.org/2000/svg", "text")) {
                    out.words.push(word(node, class, at("x", "y")));
                }
                continue;
            };
            let id = owner.attribute("id").unwrap().strip_prefix(&prefix).unwrap().to_owned();
            let group = out.groups.entry(id).or_default();
            group.shift = moved;
            match node.tag_name().name() {
                "g" if node == owner => {
                    group.class = class;
                    let data = node.attributes().filter(|a| a.name().starts_with("data-"));
                    group.data = data.map(|a| (a.name().to_owned(), a.value().to_owned())).collect();
                }
                "title" => group.title = node.text().map(|t| t.trim().to_owned()),
                "circle" => group.discs.push((at("cx", "cy"), attribute(node, "r"))),
                "line" => group.lines.push((class, at("x1", "y1"), at("x2", "y2"))),
                "path" => group.paths.push((class, node.attribute("d").unwrap().to_owned())),
                "text" => {
                    let word = word(node, class, at("x", "y"));
                    group.words.push(word.clone());
                    out.words.push(word);
                }
                _ => {}
            }
        }
        out
    }
}

fn word(node: Node<'_, '_>, class: String, at: P) -> Word {
    let size = node.attribute("font-size").map_or_else(|| size_of_class(node, &class), number);
    Word { class, text: node.text().unwrap_or_default().trim().to_owned(), at, size }
}

/// The size that the style sheet gives to all texts of a class.
fn size_of_class(node: Node<'_, '_>, class: &str) -> f64 {
    let sheets =
        node.document().root().descendants().filter(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "style")));
    let sheet: String = sheets.filter_map(|n| n.text()).collect();
    let rule = format!(" .{class}{{font-size:");
    let at = sheet.find(&rule).unwrap_or_else(|| panic!("a text of class {class:?} has no size"));
    let rest = &sheet[at + rule.len()..];
    number(&rest[..rest.find("px").unwrap()])
}

/// The points of a path of straight steps, whatever form they are written in.
pub(crate) fn straight(data: &str) -> Vec<Vec<P>> {
    let mut out: Vec<Vec<P>> = Vec::new();
    let mut at = [0.0; 2];
    for command in Data::parse(data).unwrap_or_else(|error| panic!("{data}: {error}")).iter() {
        match command {
            Command::Move(position, steps) | Command::Line(position, steps) => {
                for (i, step) in steps.chunks(2).enumerate() {
                    let step = [f64::from(step[0]), f64::from(step[1])];
                    at = if matches!(position, Position::Relative) { add(at, step) } else { step };
                    if matches!(command, Command::Move(..)) && i == 0 {
                        out.push(Vec::new());
                    }
                    out.last_mut().unwrap().push(at);
                }
            }
            Command::Close => at = out.last().unwrap()[0],
            other => panic!("{other:?} in {data}"),
        }
    }
    out
}

/// The value of a property in a rule of the style sheet, the first with that selector.
pub(crate) fn rule<'a>(svg: &'a str, selector: &str, property: &str) -> Option<&'a str> {
    let lines = svg.lines().filter_map(|line| line.strip_prefix(selector)?.strip_prefix('{')?.strip_suffix('}'));
    let mut properties = lines.flat_map(|body| body.split(';'));
    properties.find_map(|p| p.strip_prefix(property)?.strip_prefix(':'))
}

/// Even-odd.
pub(crate) fn inside(rings: &[Vec<P>], p: P) -> bool {
    let mut odd = false;
    for ring in rings {
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            odd ^= (a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0];
        }
    }
    odd
}
