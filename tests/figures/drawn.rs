//! Reading a figure back: from the SVG text alone, with own eyes.

use super::cases::P;
use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// A text on the canvas.
#[derive(Clone, Debug)]
pub(crate) struct Word {
    pub(crate) class: String,
    pub(crate) owner: String,
    pub(crate) text: String,
    pub(crate) at: P,
    pub(crate) size: f64,
}

impl Word {
    /// Half width and half height, with the advance widths of DejaVu Sans (half-edges) or its bold face.
    pub(crate) fn half(&self) -> P {
        let regular = |c: char| if c == 'h' { 0.634 } else { 0.636 };
        let bold = |c: char| match c {
            'i' | 'j' | 'l' | ' ' | '\'' => 0.35,
            'f' | 'r' | 't' => 0.48,
            'c' | 's' | 'z' => 0.6,
            'm' | 'M' => 1.04,
            'w' => 0.924,
            'W' => 1.1,
            'A'..='Z' => 0.77,
            _ => 0.7,
        };
        let em: f64 = self.text.chars().map(|c| if self.class == "hl" { regular(c) } else { bold(c) }).sum();
        [0.5 * em * self.size, 0.36 * self.size]
    }

    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        let (a, b) = (self.half(), other.half());
        (0..2).all(|i| (self.at[i] - other.at[i]).abs() < a[i] + b[i])
    }

    /// Distance from the box to a point; 0 inside.
    pub(crate) fn distance(&self, p: P) -> f64 {
        let half = self.half();
        let d = [0, 1].map(|i| ((p[i] - self.at[i]).abs() - half[i]).max(0.0));
        (d[0] * d[0] + d[1] * d[1]).sqrt()
    }
}

/// A drawn half-edge.
#[derive(Clone, Debug)]
pub(crate) struct Arrow {
    pub(crate) tail: P,
    /// End of the line.
    pub(crate) head: P,
    /// Tip, outer corner, notch.
    pub(crate) barb: [P; 3],
}

/// The class of a filled path and its outlines.
pub(crate) type Area = (String, Vec<Vec<P>>);

/// What the file shows.
pub(crate) struct Drawn {
    pub(crate) size: P,
    /// Attributes of every element group by its id without the prefix.
    pub(crate) data: BTreeMap<String, BTreeMap<String, String>>,
    pub(crate) titles: BTreeMap<String, String>,
    pub(crate) discs: BTreeMap<String, (P, f64)>,
    pub(crate) arrows: BTreeMap<String, Arrow>,
    pub(crate) words: Vec<Word>,
    /// The outlines of tinted, hole and outer areas, with the class, by face.
    pub(crate) areas: BTreeMap<String, Vec<Area>>,
    /// The lines of the edges, in px.
    pub(crate) edges: Vec<(P, P)>,
}

fn number(node: Node<'_, '_>, name: &str) -> f64 {
    let text = node.attribute(name).unwrap_or_else(|| panic!("{name} is missing"));
    text.parse().unwrap_or_else(|_| panic!("{name}={text:?}"))
}

pub(crate) fn read(svg: &str) -> Drawn {
    let document = Document::parse(svg).unwrap_or_else(|error| panic!("{error}"));
    let root = document.root_element();
    let prefix = root.attribute("id").unwrap().to_owned();
    // The size of a class of texts that has one.
    let css = root.descendants().find(|n| n.tag_name().name() == "style").and_then(|n| n.text()).unwrap_or_default();
    let shared = |class: &str| {
        let rule = format!("#{prefix} .{class}{{font-size:");
        let at = css.find(&rule).unwrap_or_else(|| panic!("no size of {class}")) + rule.len();
        css[at..].split("px").next().unwrap().parse::<f64>().unwrap()
    };
    let mut out = Drawn {
        size: [number(root, "width"), number(root, "height")],
        data: BTreeMap::new(),
        titles: BTreeMap::new(),
        discs: BTreeMap::new(),
        arrows: BTreeMap::new(),
        words: Vec::new(),
        areas: BTreeMap::new(),
        edges: Vec::new(),
    };
    for node in root.descendants().filter(Node::is_element) {
        let class = node.attribute("class").unwrap_or_default();
        let owner = node.ancestors().find_map(|a| a.attribute("id")?.strip_prefix(&format!("{prefix}-")));
        let owner = owner.unwrap_or_default().to_owned();
        match (node.tag_name().name(), class) {
            ("g", _) if node.has_attribute("id") => {
                let data = node.attributes().map(|a| (a.name().to_owned(), a.value().to_owned()));
                out.data.insert(owner.clone(), data.collect());
                let title = node.children().find(|c| c.has_tag_name(("http://www.w3.org/2000/svg", "title")));
                out.titles.insert(owner, title.and_then(|t| t.text()).unwrap_or_default().trim().to_owned());
            }
            ("circle", "root") => {}
            ("circle", _) => {
                out.discs.insert(owner, ([number(node, "cx"), number(node, "cy")], number(node, "r")));
            }
            ("text", _) => out.words.push(Word {
                class: class.to_owned(),
                owner: owner.trim_end_matches("-label").to_owned(),
                text: node.text().unwrap_or_default().trim().to_owned(),
                at: [number(node, "x"), number(node, "y")],
                size: if node.has_attribute("font-size") { number(node, "font-size") } else { shared(class) },
            }),
            ("line", "sh" | "sh thin") => {
                let barb = node.next_sibling_element().unwrap();
                assert_eq!(barb.attribute("class"), Some("barb"));
                let corners = path(barb.attribute("d").unwrap());
                out.arrows.insert(
                    owner,
                    Arrow {
                        tail: [number(node, "x1"), number(node, "y1")],
                        head: [number(node, "x2"), number(node, "y2")],
                        barb: corners[0].clone().try_into().unwrap(),
                    },
                );
            }
            ("line", "edge") => {
                out.edges.push(([number(node, "x1"), number(node, "y1")], [number(node, "x2"), number(node, "y2")]));
            }
            ("path", "mesh" | "edge") => {
                for line in path(node.attribute("d").unwrap()) {
                    out.edges.extend(line.windows(2).map(|w| (w[0], w[1])));
                }
            }
            ("path", _) if node.attribute("fill-rule").is_some() && class != "barb" => {
                out.areas.entry(owner).or_default().push((class.to_owned(), path(node.attribute("d").unwrap())));
            }
            _ => {}
        }
    }
    out
}

/// Reads the path commands M L Z m h z, with implicit line-tos, by the grammar of SVG.
pub(crate) fn path(data: &str) -> Vec<Vec<P>> {
    let bytes = data.as_bytes();
    let mut out: Vec<Vec<P>> = Vec::new();
    let (mut i, mut at, mut command) = (0, [0.0, 0.0], b' ');
    while i < bytes.len() {
        match bytes[i] {
            b' ' | b',' | b'\n' => {
                i += 1;
                continue;
            }
            c if c.is_ascii_alphabetic() => {
                command = c;
                i += 1;
                if c == b'z' || c == b'Z' {
                    at = out.last().unwrap()[0];
                }
                continue;
            }
            _ => {}
        }
        let x = scan(bytes, &mut i);
        if command == b'h' {
            at = [at[0] + x, at[1]];
            out.last_mut().unwrap().push(at);
            continue;
        }
        while matches!(bytes[i], b' ' | b',') {
            i += 1;
        }
        let y = scan(bytes, &mut i);
        at = if command.is_ascii_lowercase() { [at[0] + x, at[1] + y] } else { [x, y] };
        match command {
            b'M' | b'm' => {
                out.push(vec![at]);
                command = if command == b'M' { b'L' } else { b'l' };
            }
            b'L' | b'l' => out.last_mut().unwrap().push(at),
            other => panic!("unexpected command {:?} in a path", other as char),
        }
    }
    out
}

pub(crate) fn scan(bytes: &[u8], i: &mut usize) -> f64 {
    let start = *i;
    if bytes[*i] == b'-' {
        *i += 1;
    }
    let mut point = false;
    while *i < bytes.len() && (bytes[*i].is_ascii_digit() || (bytes[*i] == b'.' && !point)) {
        point |= bytes[*i] == b'.';
        *i += 1;
    }
    let text = std::str::from_utf8(&bytes[start..*i]).unwrap();
    text.parse().unwrap_or_else(|_| panic!("{text:?} is not a number"))
}

/// Even-odd.
pub(crate) fn inside(outlines: &[Vec<P>], p: P) -> bool {
    let mut odd = false;
    for ring in outlines {
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            if (a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0] {
                odd = !odd;
            }
        }
    }
    odd
}

pub(crate) fn minus(a: P, b: P) -> P {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn length(a: P) -> f64 {
    (a[0] * a[0] + a[1] * a[1]).sqrt()
}

/// How far `p` lies to the left of the line from `a` to `b`, as one sees it on a canvas whose y points down.
pub(crate) fn left_of(a: P, b: P, p: P) -> f64 {
    let (d, e) = (minus(b, a), minus(p, a));
    (d[1] * e[0] - d[0] * e[1]) / length(d)
}
