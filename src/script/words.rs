//! The words of a line, each with its column.
//!
//! ```text
//!   let a = split_face h0.next h8   # comment         `#` ends the line, LF and CR LF end it, too
//!   1   5 7 9          20      28
//! ```

/// A word of a line.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    /// The column of its first character, from 1.
    pub(super) column: u32,
}

/// A line that says something.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Line<'a> {
    /// From 1.
    pub(super) number: u32,
    /// Without the comment and the blanks at both ends.
    pub(super) text: &'a str,
    /// At least one.
    pub(super) words: Vec<Word<'a>>,
    /// The column after the last word.
    pub(super) end: u32,
}

/// The lines with at least one word.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    text.lines().enumerate().filter_map(|(i, line)| {
        let said = line.split('#').next().unwrap_or("");
        let words = words(said);
        let last = words.last()?;
        let end = last.column + last.text.chars().count() as u32;
        Some(Line { number: i as u32 + 1, text: said.trim(), words, end })
    })
}

fn words(line: &str) -> Vec<Word<'_>> {
    let mut out = Vec::new();
    let (mut start, mut column, mut begun) = (0, 0, 0);
    for (i, (at, c)) in line.char_indices().chain([(line.len(), ' ')]).enumerate() {
        if !c.is_whitespace() {
            if begun == 0 {
                (start, column, begun) = (at, i as u32 + 1, 1);
            }
        } else if begun == 1 {
            out.push(Word { text: &line[start..at], column });
            begun = 0;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_have_columns_in_characters_and_comments_are_gone() {
        let text = "\u{feff}# title\r\n  é split_face\th0 # h1\r\n\r\nx";
        let found: Vec<_> = lines(text)
            .map(|l| (l.number, l.words.iter().map(|w| (w.text, w.column)).collect::<Vec<_>>(), l.end))
            .collect();
        assert_eq!(found, [(2, vec![("é", 3), ("split_face", 5), ("h0", 16)], 18), (4, vec![("x", 1)], 2)]);
    }
}
