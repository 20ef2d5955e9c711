//! What a style sheet says and what cannot be told: rules of which it is not understood what they fit, or when.
//!
//! ```text
//!   line:nth-child(2){stroke:none}    hides something, and who knows what      :hover{fill:red}    nobody points
//! ```

use super::blocks::{Block, blocks, parts};
use super::selectors::{OF_READERS, steps};

/// What a style sheet says and what cannot be told: the selector of a rule, or the name of an at-rule.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Untold<'a> {
    /// It hides lines.
    Hides(&'a str),
    /// It changes how something looks, or where it lies.
    Changes(&'a str),
}

/// Properties that change what is seen of a drawing, or where.
#[rustfmt::skip]
const OF_LOOKS: [&str; 30] = [
    "all", "animation", "clip-path", "content-visibility", "cx", "cy", "d", "display", "fill", "fill-opacity", "filter",
    "height", "marker", "marker-end", "marker-mid", "marker-start", "mask", "opacity", "overflow", "r", "rx", "ry",
    "stroke", "stroke-dasharray", "stroke-opacity", "stroke-width", "transform", "visibility", "width", "zoom",
];

/// The first rule that may change what is seen and cannot be told: it is not understood what it fits, or when.
pub(crate) fn untold(css: &str) -> Option<Untold<'_>> {
    blocks(css).find_map(|block| match block {
        Block::Media { is_met: Some(false), .. } => None,
        // Of a list of media, what hides is never taken for granted.
        Block::Media { condition, rules, is_met } if is_met.is_none() || condition.contains(',') => match () {
            () if declares(rules, hides) => Some(Untold::Hides(condition)),
            () if is_met.is_none() && declares(rules, changes) => Some(Untold::Changes(condition)),
            () => untold(rules),
        },
        Block::Media { rules, .. } => untold(rules),
        Block::Other { name, body } => {
            let is_harmless = ["@font-", "@page", "@property", "@counter"].iter().any(|start| name.starts_with(start));
            (!is_harmless && declares(body, changes)).then_some(Untold::Changes(name))
        }
        Block::Rule { selectors, body } if body.contains('{') => {
            declares(body, changes).then_some(Untold::Changes(selectors))
        }
        Block::Rule { selectors, body } => {
            let selector = parts(selectors, ',').find(|selector| is_unknown(selector))?.trim();
            match () {
                () if declares(body, hides) => Some(Untold::Hides(selector)),
                () => declares(body, changes).then_some(Untold::Changes(selector)),
            }
        }
    })
}

fn is_unknown(selector: &str) -> bool {
    let is_of_readers = OF_READERS.iter().any(|word| selector.contains(&format!(":{word}")));
    let is_told = !is_of_readers || selector.contains('(');
    is_told && steps(selector).is_none()
}

/// Whether one of the declarations of a block, or of the blocks in it, is such a one.
fn declares(body: &str, is: fn(&str) -> bool) -> bool {
    body.split(['{', '}', ';']).any(is)
}

/// Whether a declaration changes what is seen, whatever it is said of.
fn changes(declaration: &str) -> bool {
    let key = declaration.split_once(':').map_or("", |(key, _)| key.trim());
    OF_LOOKS.contains(&key) || hides(declaration)
}

/// Whether a declaration makes lines invisible, whatever they are.
fn hides(declaration: &str) -> bool {
    let Some((key, value)) = declaration.split_once(':') else { return false };
    let value = value.split('!').next().unwrap_or("").trim();
    let number = || value.trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '%').trim().parse::<f64>();
    match key.trim() {
        "display" | "stroke" => ["none", "transparent"].contains(&value),
        "visibility" => ["hidden", "collapse"].contains(&value),
        "opacity" | "stroke-opacity" | "stroke-width" => number().is_ok_and(|number| number < 0.1),
        "clip-path" | "mask" | "filter" => value != "none",
        _ => false,
    }
}
