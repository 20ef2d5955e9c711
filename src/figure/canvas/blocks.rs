//! Style sheets as blocks: rules, media, anything else. Marks in strings and in `url(...)` part nothing.
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
        let open = outside(rest).find(|(_, c)| *c == '{')?.0;
        let mut head = rest[..open].trim();
        let text = &rest[open + 1..];
        let (body, after) = enclosed(text, ['{', '}']).unwrap_or((text, ""));
        rest = after;
        while let Some((end, _)) = outside(head).find(|(_, c)| *c == ';').filter(|_| head.starts_with('@')) {
            head = head[end + 1..].trim();
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

/// The characters of a text, with their places, that stand in no quotes and in no `url(...)` without quotes. A string ends
/// with its line at the latest.
pub(crate) fn outside(text: &str) -> impl Iterator<Item = (usize, char)> + '_ {
    let mut end = None;
    text.char_indices().filter(move |&(i, c)| match end {
        Some(quote) => {
            let is_end = c == quote || quote != ')' && is_line_end(c);
            end = end.filter(|_| !is_end);
            is_end && c == ')'
        }
        None => {
            end = opened(&text[..i], c, &text[i + c.len_utf8()..]);
            end.is_none_or(|end| end == ')')
        }
    })
}

/// The end of the string or of the `url(...)` without quotes that begins with a character, if one does.
pub(crate) fn opened(before: &str, c: char, after: &str) -> Option<char> {
    let is_url = || {
        let at = before.len().checked_sub(3).filter(|&at| before.is_char_boundary(at))?;
        let (start, name) = before.split_at(at);
        let is_word = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
        let is_url = name.eq_ignore_ascii_case("url") && !start.ends_with(is_word);
        (is_url && !after.trim_start().starts_with(['"', '\''])).then_some(')')
    };
    match c {
        '"' | '\'' => Some(c),
        '(' => is_url(),
        _ => None,
    }
}

/// Whether a string without its second quote ends here.
pub(crate) fn is_line_end(c: char) -> bool {
    matches!(c, '\n' | '\r' | '\x0c')
}

/// What stands before the bracket that closes what was opened, and behind it; `None` if it stays open. Brackets in
/// strings count for nothing.
pub(super) fn enclosed(text: &str, [open, close]: [char; 2]) -> Option<(&str, &str)> {
    let mut depth = 1;
    let end = outside(text).find_map(|(i, c)| {
        depth += i32::from(c == open) - i32::from(c == close);
        (depth == 0).then_some(i)
    })?;
    Some((&text[..end], &text[end + close.len_utf8()..]))
}

/// The parts of a text between these marks, but not within brackets or quotes.
pub(crate) fn parts(text: &str, mark: char) -> impl Iterator<Item = &str> {
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        let mut depth = 0usize;
        for (i, c) in outside(text) {
            match c {
                '(' | '[' => depth += 1,
                ')' | ']' => depth = depth.saturating_sub(1),
                c if depth == 0 && (c == mark || mark == ' ' && c.is_ascii_whitespace()) => {
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

/// Whether somebody at a screen who asked for nothing meets one of the conditions of a list of media; `None` if that
/// cannot be told. A medium that is no screen is never met, be it a known one or not.
pub(crate) fn is_met(list: &str) -> Option<bool> {
    let list = list.to_ascii_lowercase();
    let each: Vec<Option<bool>> = list.split(',').map(str::trim).map(is_one_met).collect();
    if each.contains(&Some(true)) {
        return Some(true);
    }
    (!each.contains(&None)).then_some(false)
}

/// Words of a condition that are the names of no medium.
const WORDS: [&str; 7] = ["not", "only", "and", "or", "layer", "screen", "all"];

fn is_one_met(condition: &str) -> Option<bool> {
    if ["", "all", "screen", "only screen", "only all"].contains(&condition) {
        return Some(true);
    }
    let named = condition.strip_prefix("only ").unwrap_or(condition).trim_start();
    let end = named.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(named.len());
    let (medium, further) = named.split_at(end);
    let ends = further.is_empty() || further.trim_start() != further && further.trim_start().starts_with("and");
    if !medium.is_empty() && !WORDS.contains(&medium) && ends {
        return Some(false);
    }
    let is_open = ["not", "light", "or", "no-preference"]
        .iter()
        .any(|word| condition.split(|c: char| !c.is_ascii_alphabetic() && c != '-').any(|other| other == *word));
    (condition.contains("(prefers-") && !is_open).then_some(false)
}
