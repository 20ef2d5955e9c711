//! Words of an answer.

/// Ids beyond are read as this one, which no structure has.
pub(super) const GREATEST: u32 = u32::MAX - 1;

/// The beginning of a text, for messages.
pub(super) fn cut(text: &str) -> String {
    let mut out: String = text.chars().take(80).collect();
    if out.len() < text.len() {
        out.push('…');
    }
    out
}

/// A number of an element; too great ones are those of none.
pub(super) fn id(word: &str) -> Option<u32> {
    let is_number = !word.is_empty() && word.len() <= 20 && word.bytes().all(|b| b.is_ascii_digit());
    is_number.then(|| word.parse::<u128>().map_or(GREATEST, |n| n.min(u128::from(GREATEST)) as u32))
}

/// A text in quotes and what comes after it. `\"`, `\\` and `\n` stand for the characters that would end it.
pub(super) fn quoted(text: &str) -> Option<(String, &str)> {
    let mut message = String::new();
    let mut chars = text.strip_prefix('"')?.chars();
    loop {
        match chars.next()? {
            '"' => return Some((message, chars.as_str())),
            '\\' => match chars.next()? {
                'n' => message.push('\n'),
                't' => message.push('\t'),
                'r' => {}
                other => message.push(other),
            },
            c => message.push(c),
        }
    }
}
