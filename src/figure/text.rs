//! How much room a text takes, without a font.
//!
//! ```text
//!   ├── 2 · half_width ──┤
//!   ┌────────────────────┐ ┬
//!   │       Nevada       │ 2 · half_height      the box is centred where the text is placed
//!   └────────────────────┘ ┴
//! ```
//!
//! The widths are those of DejaVu Sans, the widest of the families a figure asks for, so that a label
//! that fits here fits with the narrower ones, too.

/// Advance widths of the printable ASCII characters in hundredths of the font size.
const ADVANCE: [u8; 95] = [
    32, 40, 46, 84, 64, 95, 78, 28, 39, 39, 50, 84, 32, 36, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 34, 34, 84,
    84, 84, 53, 100, 68, 69, 70, 77, 63, 58, 78, 75, 30, 30, 66, 56, 86, 75, 79, 60, 79, 70, 64, 61, 73, 68, 99, 69,
    61, 69, 39, 34, 39, 84, 50, 50, 61, 64, 55, 64, 62, 35, 64, 63, 28, 28, 58, 28, 97, 63, 61, 64, 64, 41, 52, 39, 63,
    59, 82, 59, 59, 53, 64, 34, 64, 84,
];
/// How much wider the bold faces are, the overhang of the oblique ones included.
const BOLD: f64 = 1.14;
/// Half of the height of capitals and digits (0.73 of the size), and a little air.
const HALF_HEIGHT: f64 = 0.44;

/// The width of `text` in px at `size` px.
pub(super) fn width(text: &str, size: f64, bold: bool) -> f64 {
    let hundredths: u32 = text.chars().map(advance).sum();
    f64::from(hundredths) / 100.0 * size * if bold { BOLD } else { 1.0 }
}

/// Half the height of a line of text at `size` px.
pub(super) fn half_height(size: f64) -> f64 {
    HALF_HEIGHT * size
}

fn advance(c: char) -> u32 {
    match c {
        ' '..='~' => u32::from(ADVANCE[c as usize - 32]),
        // From Hangul Jamo on, scripts whose signs fill a square.
        '\u{1100}'.. => 100,
        _ => 70,
    }
}

/// The first characters of a text, `longest` in all with the ellipsis that says that some are missing; the
/// text itself if it is not longer.
pub(super) fn shortened(text: &str, longest: usize) -> String {
    if text.chars().count() <= longest {
        return text.to_owned();
    }
    let kept: String = text.chars().take(longest - 1).collect();
    format!("{}…", kept.trim_end())
}

/// The words in lines of at most `width` px; what does not fit into the last line is cut, with dots.
pub(super) fn wrap(words: &str, size: f64, bold: bool, width: f64, most: usize) -> Vec<String> {
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
pub(super) fn clean(text: &str) -> String {
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
