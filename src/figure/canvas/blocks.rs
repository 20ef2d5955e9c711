//! Style sheets as blocks: rules, media, anything else.
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
