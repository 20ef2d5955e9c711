//! How much room a text takes.
//!
//! ```text
//!   ├── 2 · half_width ──┤
//!   ┌────────────────────┐ ┬
//!   │       Nevada       │ 2 · half_height      the box is centred where the text is placed
//!   └────────────────────┘ ┴
//! ```
//!
//! The widths are those of DejaVu Sans, which figures name first and which `fonts/` holds: the widest of the families
//! a figure asks for, so that a label that fits here fits with the narrower ones, too.

use crate::figure::canvas::advances::{EM, RUNS};

/// The smallest letters of a label, in px: smaller ones cannot be read on a page. A style with smaller texts keeps these.
pub(crate) const LEGIBLE: f64 = 9.0;
/// How far oblique letters lean out of their widths, left and right together, in parts of the size.
const LEAN: f64 = 0.06;
/// Half of the height of capitals and digits (0.73 of the size), and a little air.
const HALF_HEIGHT: f64 = 0.44;

/// The width of `text` in px at `size` px, in the regular face or in the wider of the two bold ones.
pub(crate) fn width(text: &str, size: f64, bold: bool) -> f64 {
    let units: u32 = text.chars().map(|c| advance(c, bold)).sum();
    (f64::from(units) / f64::from(EM) + if bold { LEAN } else { 0.0 }) * size
}

/// Half the height of a line of text at `size` px.
pub(crate) fn half_height(size: f64) -> f64 {
    HALF_HEIGHT * size
}

/// The widths of a character in the regular and in the bold face, in units of the em; none without a glyph.
fn known(c: char) -> Option<[u16; 2]> {
    let &(first, regular, bold) = RUNS[..RUNS.partition_point(|run| run.0 <= c)].last()?;
    let i = c as usize - first as usize;
    Some([*regular.get(i)?, *bold.get(i)?])
}

/// Whether the bundled fonts can draw a character.
#[cfg(feature = "png")]
pub(crate) fn has_glyph(c: char) -> bool {
    known(c).is_some()
}

fn advance(c: char, bold: bool) -> u32 {
    match known(c) {
        Some(widths) => u32::from(widths[usize::from(bold)]),
        // From Hangul Jamo on, scripts whose signs fill a square.
        None if c >= '\u{1100}' => u32::from(EM),
        None => u32::from(EM) * 7 / 10,
    }
}

/// `1 face`, `2 faces`
pub(crate) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// The first characters of a text, `longest` in all with the ellipsis that says that some are missing; the
/// text itself if it is not longer.
pub(crate) fn shortened(text: &str, longest: usize) -> String {
    if text.chars().count() <= longest {
        return text.to_owned();
    }
    let kept: String = text.chars().take(longest - 1).collect();
    format!("{}…", kept.trim_end())
}

/// The words in lines of at most `width` px; what does not fit into the last line is cut, with dots.
pub(crate) fn wrap(words: &str, size: f64, bold: bool, width: f64, most: usize) -> Vec<String> {
    let fits = |line: &str| self::width(line, size, bold) <= width;
    let mut lines: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        let full = lines.len() == most;
        match lines.last_mut() {
            Some(line) if fits(&format!("{line} {word}")) => {
                line.push(' ');
                line.push_str(word);
            }
            Some(line) if full => {
                // Whole words go; of a single word, letters.
                while !line.is_empty() && !fits(&format!("{line} …")) {
                    let letter = line.char_indices().next_back().map_or(0, |(at, _)| at);
                    line.truncate(line.rfind(' ').unwrap_or(letter));
                }
                line.push_str(" …");
                break;
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The text without characters that XML cannot hold; line breaks become spaces.
pub(crate) fn clean(text: &str) -> String {
    let keep = |c: char| match c {
        '\t' | '\n' | '\r' => ' ',
        c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => '\u{fffd}',
        c => c,
    };
    text.chars().map(keep).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_about_as_wide_as_the_drawing_rules_say() {
        for id in ["h5", "h12", "h123"] {
            let rule = 0.62 * 9.5 * id.len() as f64;
            assert!((width(id, 9.5, false) - rule).abs() < 1.0, "{id}");
        }
        assert!(width("WWW", 10.0, false) > 2.0 * width("iii", 10.0, false));
        assert!(width("f12", 10.0, true) > width("f12", 10.0, false));
    }

    #[test]
    fn characters_have_their_own_widths_and_strange_ones_a_guess() {
        assert_eq!(known('h'), Some([1298, 1458]), "what the font says");
        assert_eq!((known('中'), known('\u{378}'), known('\u{7f}')), (None, None, None));
        assert!((width("中", 10.0, false) - 10.0).abs() < 1e-9);
        assert!((width("Ж", 10.0, false) - 7.0).abs() < 0.01);
        assert!(width("€…é", 10.0, true) > 15.0);
    }

    #[test]
    fn a_shortened_text_says_that_it_is() {
        assert_eq!(shortened("eight ch", 8), "eight ch");
        assert_eq!(shortened("nine char", 8), "nine ch…");
        assert_eq!(shortened("ünïcödé sïgns", 9), "ünïcödé…");
    }

    #[test]
    fn characters_that_xml_cannot_hold_are_replaced() {
        assert_eq!(clean("a\u{0}b\nc"), "a\u{fffd}b c");
    }

    #[test]
    fn text_is_wrapped_and_cut() {
        let lines = wrap("one two three four five", 10.0, false, 60.0, 2);
        assert_eq!(lines, ["one two", "three …"]);
        assert!(wrap("", 10.0, false, 60.0, 2).is_empty());
        assert_eq!(wrap("ümläüte wörd", 10.0, false, 30.0, 1), ["üm …"], "letters, not bytes");
    }
}
