//! What a style sheet says and what cannot be told: rules of which it is not understood what they fit, or when.
//!
//! ```text
//!   line:nth-child(2){stroke:none}    hides something, and who knows what      :hover{fill:red}    nobody points
//! ```

use super::blocks::{Block, blocks, outside, parts};
use super::selectors::{OF_READERS, steps};

/// What a style sheet says and what cannot be told: the selector of a rule, or the name of an at-rule.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Untold<'a> {
    /// It hides lines.
    Hides(&'a str),
    /// It changes how something looks, or where it lies.
    Changes(&'a str),
}

impl<'a> Untold<'a> {
    /// The selector, or the name of the at-rule.
    pub(crate) fn selector(&self) -> &'a str {
        match self {
            Self::Hides(selector) | Self::Changes(selector) => selector,
        }
    }
}

/// Properties that change what is seen of a drawing, or where.
#[rustfmt::skip]
const OF_LOOKS: [&str; 41] = [
    "all", "animation", "clip-path", "color", "content-visibility", "cx", "cy", "d", "display", "fill", "fill-opacity",
    "fill-rule", "filter", "height", "marker", "marker-end", "marker-mid", "marker-start", "mask", "offset",
    "offset-path", "opacity", "overflow", "r", "rotate", "rx", "ry", "scale", "stop-color", "stop-opacity", "stroke",
    "stroke-dasharray", "stroke-opacity", "stroke-width", "transform", "translate", "visibility",
    "width", "x", "y", "zoom",
];

/// Whether a property changes what is seen of a drawing, or where.
pub(crate) fn changes_looks(property: &str) -> bool {
    OF_LOOKS.iter().any(|of_looks| of_looks.eq_ignore_ascii_case(property))
}

/// The first rule that may change what is seen and cannot be told: it is not understood what it fits, or when.
pub(crate) fn untold(css: &str) -> Option<Untold<'_>> {
    untold_with(css, &[])
}

/// The same, where these properties change what is seen, too.
pub(crate) fn untold_with<'a>(css: &'a str, further: &[&str]) -> Option<Untold<'a>> {
    let changes = |declaration: &str| {
        changes(declaration) || further.iter().any(|other| other.eq_ignore_ascii_case(key(declaration)))
    };
    blocks(css).find_map(|block| match block {
        Block::Media { is_met: Some(false), .. } => None,
        // Of a list of media, what hides is never taken for granted.
        Block::Media { condition, rules, is_met } if is_met.is_none() || condition.contains(',') => match () {
            () if declares(rules, &hides) => Some(Untold::Hides(condition)),
            () if is_met.is_none() && declares(rules, &changes) => Some(Untold::Changes(condition)),
            () => untold_with(rules, further),
        },
        Block::Media { rules, .. } => untold_with(rules, further),
        Block::Other { name, body } => {
            let is_harmless = ["@font-", "@page", "@property", "@counter"].iter().any(|start| name.starts_with(start));
            (!is_harmless && declares(body, &changes)).then_some(Untold::Changes(name))
        }
        Block::Rule { selectors, body } if outside(body).any(|(_, c)| c == '{') => {
            declares(body, &changes).then_some(Untold::Changes(selectors))
        }
        Block::Rule { selectors, body } => {
            let selector = parts(selectors, ',').find(|selector| is_unknown(selector))?.trim();
            match () {
                () if declares(body, &hides) => Some(Untold::Hides(selector)),
                () => declares(body, &changes).then_some(Untold::Changes(selector)),
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
fn declares(body: &str, is: &dyn Fn(&str) -> bool) -> bool {
    let mut start = 0;
    let mut ends = outside(body).filter(|(_, c)| matches!(c, '{' | '}' | ';')).map(|(i, _)| i);
    ends.any(|end| is(&body[std::mem::replace(&mut start, end + 1)..end])) || is(&body[start..])
}

/// Whether a declaration changes what is seen, whatever it is said of.
fn changes(declaration: &str) -> bool {
    changes_looks(key(declaration)) || hides(declaration)
}

/// The property of a declaration.
fn key(declaration: &str) -> &str {
    declaration.split_once(':').map_or("", |(key, _)| key.trim())
}

/// Whether a declaration makes lines invisible, whatever they are.
fn hides(declaration: &str) -> bool {
    let declaration = declaration.to_ascii_lowercase();
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
