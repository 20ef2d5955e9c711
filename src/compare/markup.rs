//! Layer 0: the text is well-formed, small enough, and holds no code.
//!
//! ```text
//!   bytes ── UTF-8? ── caps, counted before anything is built ── XML tree ── <svg>, no script
//! ```
//!
//! The XML reader checks attributes of one element, and namespaces, against each other pair by pair; so both are
//! counted before, and a hostile file ends here in linear time.

use super::error::{Fault, Problem, quoted};
use roxmltree::{Document, Error, Node, ParsingOptions};

/// Size of a file.
const BYTES: usize = 8 << 20;
/// Elements of a file.
const ELEMENTS: usize = 200_000;
/// Attributes of one element.
const ATTRIBUTES: usize = 256;
/// Namespace declarations of a file.
const NAMESPACES: usize = 200;
/// Equals signs anywhere: the XML reader reserves memory for each.
const EQUALS: usize = 2_000_000;
/// Nodes of the tree, the texts between elements included.
const NODES: u32 = 700_000;

const SVG: &str = "http://www.w3.org/2000/svg";

/// The text of a file, without a byte order mark.
pub(super) fn text(bytes: &[u8]) -> Result<&str, Fault> {
    let encoding = match bytes {
        [0x1f, 0x8b, ..] => return Err(Problem::Compressed.into()),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [b'<', 0, ..] | [0, b'<', ..] => "UTF-16 text",
        _ => "not UTF-8 text",
    };
    std::str::from_utf8(bytes).map(without_mark).map_err(|_| Problem::Encoding { encoding }.into())
}

/// The text without a byte order mark.
pub(super) fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// The tree of a text whose root is `svg`.
pub(super) fn parse(text: &str) -> Result<Document<'_>, Fault> {
    if text.len() > BYTES {
        return Err(Problem::TooLarge { what: "bytes", limit: BYTES }.into());
    }
    if text.trim().is_empty() {
        return Err(Problem::Empty.into());
    }
    count(text)?;
    let options = ParsingOptions { allow_dtd: true, nodes_limit: NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| malformed(text, &error))?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let name = quoted(root.tag_name().name());
        return Err(Fault::at(root.range().start, Problem::NotSvg { name }));
    }
    if let Some((node, what)) = document.descendants().find_map(|node| Some((node, code(node)?))) {
        return Err(Fault::at(node.range().start, Problem::Script { what }));
    }
    Ok(document)
}

/// Whether the element is one of SVG. A file without `xmlns` is read as if it had one.
pub(super) fn is_svg(node: Node<'_, '_>) -> bool {
    node.tag_name().namespace().is_none_or(|name| name == SVG)
}

/// The code that an element holds.
fn code(node: Node<'_, '_>) -> Option<String> {
    if !node.is_element() {
        return None;
    }
    if node.tag_name().name().eq_ignore_ascii_case("script") {
        return Some("<script>".to_owned());
    }
    let is_code = |name: &str, value: &str| {
        name.get(..2).is_some_and(|start| start.eq_ignore_ascii_case("on"))
            || value.trim_start().get(..11).is_some_and(|start| start.eq_ignore_ascii_case("javascript:"))
    };
    let attribute = node.attributes().find(|a| is_code(a.name(), a.value()))?;
    Some(format!("the attribute `{}`", quoted(attribute.name())))
}

fn malformed(text: &str, error: &Error) -> Fault {
    let problem = match error {
        Error::NodesLimitReached => Problem::TooLarge { what: "elements", limit: ELEMENTS },
        other => {
            let message = other.to_string();
            // The reader ends its sentences with the place, which stands at the front here.
            let end =
                message.rfind(" at ").filter(|&i| message[i + 4..].bytes().all(|b| b.is_ascii_digit() || b == b':'));
            Problem::Xml { message: message[..end.unwrap_or(message.len())].to_owned() }
        }
    };
    let pos = error.pos();
    let line = text.split_inclusive('\n').take(pos.row.saturating_sub(1) as usize).map(str::len).sum::<usize>();
    let rest = text.get(line..).unwrap_or("");
    let column = rest.char_indices().nth(pos.col.saturating_sub(1) as usize).map_or(rest.len(), |(i, _)| i);
    Fault::at(line + column, problem)
}

/// Counts what the XML reader would build. Leaves everything that is not well-formed to that reader.
fn count(text: &str) -> Result<(), Fault> {
    if text.bytes().filter(|&b| b == b'=').count() > EQUALS {
        return Err(Problem::TooLarge { what: "equals signs", limit: EQUALS }.into());
    }
    let (mut at, mut elements, mut namespaces) = (0, 0, 0);
    while let Some(open) = text[at..].find('<').map(|i| at + i) {
        let rest = &text[open..];
        let skip = |end: &str| rest.find(end).map_or(rest.len(), |i| i + end.len());
        let others = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("</", ">")];
        at = open
            + if let Some((_, end)) = others.iter().find(|(start, _)| rest.starts_with(start)) {
                skip(end)
            } else if rest.starts_with("<!") {
                plain_type(rest).ok_or_else(|| Fault::at(open, Problem::DocumentType))?
            } else {
                elements += 1;
                let (length, attributes) = tag(rest);
                Fault::if_more(attributes, ATTRIBUTES, "attributes of one element", open)?;
                namespaces += rest[..length].matches("xmlns").count();
                length
            };
        Fault::if_more(elements, ELEMENTS, "elements", open)?;
        Fault::if_more(namespaces, NAMESPACES, "namespace declarations", open)?;
    }
    Ok(())
}

/// The bytes outside of quotes, and the quotes that open, with their places.
fn unquoted(text: &str) -> impl Iterator<Item = (usize, u8)> + '_ {
    let mut quote = None;
    text.bytes().enumerate().filter(move |&(_, b)| {
        let is_outside = quote.is_none();
        quote = match quote {
            Some(opened) => Some(opened).filter(|&opened| opened != b),
            None => Some(b).filter(|b| matches!(b, b'"' | b'\'')),
        };
        is_outside
    })
}

/// The length of a document type that declares nothing: it names a type and perhaps where that is described, which is
/// never fetched. `None` if it declares something, or is no document type.
fn plain_type(rest: &str) -> Option<usize> {
    let inside = rest.strip_prefix("<!DOCTYPE")?;
    let (i, end) = unquoted(inside).find(|(_, b)| matches!(b, b'[' | b'<' | b'>'))?;
    (end == b'>').then_some(rest.len() - inside.len() + i + 1)
}

/// The length of a start tag, and the number of its attributes.
fn tag(rest: &str) -> (usize, usize) {
    let mut attributes = 0;
    let end = unquoted(rest).find(|(_, b)| {
        attributes += usize::from(matches!(b, b'"' | b'\''));
        *b == b'>'
    });
    (end.map_or(rest.len(), |(i, _)| i + 1), attributes)
}
