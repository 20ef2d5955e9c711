//! Style sheets as blocks, and what in them cannot be told.
//!
//! ```text
//!   @import "x";   a, b{...}   @media screen{ c{...} }   @supports (...){...}
//!                  rule        media                     other
//! ```

/// One block of a style sheet.
pub(super) enum Block<'a> {
    Rule {
        selectors: &'a str,
        body: &'a str,
    },
    /// `@media`; whether a plain reader at a screen meets its condition, if that can be told.
    #[cfg_attr(not(feature = "compare"), allow(dead_code, reason = "only comparisons tell what is not understood"))]
    Media {
        condition: &'a str,
        rules: &'a str,
        is_met: Option<bool>,
    },
    /// Any other at-rule.
    #[cfg_attr(not(feature = "compare"), allow(dead_code, reason = "only comparisons tell what is not understood"))]
    Other {
        name: &'a str,
        body: &'a str,
    },
}

/// The blocks of a style sheet, in order. At-rules without a block are passed over.
pub(super) fn blocks(css: &str) -> impl Iterator<Item = Block<'_>> {
    let mut rest = css;
    std::iter::from_fn(move || {
        let open = rest.find('{')?;
        let mut head = rest[..open].trim();
        let text = &rest[open + 1..];
        let (body, after) = enclosed(text, ['{', '}']).unwrap_or((text, ""));
        rest = after;
        while let Some((_, next)) = head.split_once(';').filter(|_| head.starts_with('@')) {
            head = next.trim();
        }
        Some(match head.strip_prefix("@media") {
            Some(condition) => Block::Media { condition: head, rules: body, is_met: is_met(condition) },
            // Every reader of today knows that, and the kit's own steppers ask for it.
            None if head == "@supports selector(:has(a))" => {
                Block::Media { condition: head, rules: body, is_met: Some(true) }
            }
            None if head.starts_with('@') => Block::Other { name: head, body },
            None => Block::Rule { selectors: head, body },
        })
    })
}

/// What stands before the bracket that closes what was opened, and behind it; `None` if it stays open.
pub(super) fn enclosed(text: &str, [open, close]: [char; 2]) -> Option<(&str, &str)> {
    let mut depth = 1;
    let end = text.char_indices().find_map(|(i, c)| {
        depth += i32::from(c == open) - i32::from(c == close);
        (depth == 0).then_some(i)
    })?;
    Some((&text[..end], &text[end + close.len_utf8()..]))
}

/// The parts of a text between these marks, but not within brackets or quotes.
pub(super) fn parts(text: &str, mark: char) -> impl Iterator<Item = &str> {
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        let (mut depth, mut quote) = (0usize, None);
        for (i, c) in text.char_indices() {
            match (quote, c) {
                (Some(q), c) if q == c => quote = None,
                (Some(_), _) => {}
                (None, '"' | '\'') => quote = Some(c),
                (None, '(' | '[') => depth += 1,
                (None, ')' | ']') => depth = depth.saturating_sub(1),
                (None, c) if depth == 0 && (c == mark || mark == ' ' && c.is_ascii_whitespace()) => {
                    rest = Some(&text[i + c.len_utf8()..]);
                    return Some(&text[..i]);
                }
                _ => {}
            }
        }
        rest = None;
        Some(text)
    })
}

/// Whether somebody at a screen who asked for nothing meets one of the conditions of a list.
fn is_met(list: &str) -> Option<bool> {
    let list = list.to_ascii_lowercase();
    let each: Vec<Option<bool>> = list.split(',').map(str::trim).map(is_one_met).collect();
    if each.contains(&Some(true)) {
        return Some(true);
    }
    (!each.contains(&None)).then_some(false)
}

fn is_one_met(condition: &str) -> Option<bool> {
    if ["", "all", "screen", "only screen", "only all"].contains(&condition) {
        return Some(true);
    }
    let is_open = ["not", "light", "or", "no-preference"]
        .iter()
        .any(|word| condition.split(|c: char| !c.is_ascii_alphabetic() && c != '-').any(|other| other == *word));
    let starts = ["print", "speech", "only print"];
    let is_other = starts.iter().any(|start| condition.starts_with(start)) || condition.contains("(prefers-");
    (is_other && !is_open).then_some(false)
}

/// What a style sheet says and what cannot be told: the selector of a rule, or the name of an at-rule.
#[cfg(feature = "compare")]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Untold<'a> {
    /// It hides lines.
    Hides(&'a str),
    /// It changes how something looks, or where it lies.
    Changes(&'a str),
}

/// Properties that change what is seen of a drawing, or where.
#[cfg(feature = "compare")]
#[rustfmt::skip]
const OF_LOOKS: [&str; 30] = [
    "all", "animation", "clip-path", "content-visibility", "cx", "cy", "d", "display", "fill", "fill-opacity", "filter",
    "height", "marker", "marker-end", "marker-mid", "marker-start", "mask", "opacity", "overflow", "r", "rx", "ry",
    "stroke", "stroke-dasharray", "stroke-opacity", "stroke-width", "transform", "visibility", "width", "zoom",
];

/// The first rule that may change what is seen and cannot be told: it is not understood what it fits, or when.
#[cfg(feature = "compare")]
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

#[cfg(feature = "compare")]
fn is_unknown(selector: &str) -> bool {
    let is_of_readers = super::selectors::OF_READERS.iter().any(|word| selector.contains(&format!(":{word}")));
    let is_told = !is_of_readers || selector.contains('(');
    is_told && super::selectors::steps(selector).is_none()
}

/// Whether one of the declarations of a block, or of the blocks in it, is such a one.
#[cfg(feature = "compare")]
fn declares(body: &str, is: fn(&str) -> bool) -> bool {
    body.split(['{', '}', ';']).any(is)
}

/// Whether a declaration changes what is seen, whatever it is said of.
#[cfg(feature = "compare")]
fn changes(declaration: &str) -> bool {
    let key = declaration.split_once(':').map_or("", |(key, _)| key.trim());
    OF_LOOKS.contains(&key) || hides(declaration)
}

/// Whether a declaration makes lines invisible, whatever they are.
#[cfg(feature = "compare")]
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
