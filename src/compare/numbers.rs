//! Lists of numbers in attributes: `points`, path data, `transform`, `viewBox`.
//!
//! ```text
//!   12.5,-3e2 .5.5-1      five numbers: commas and blanks may be left out where a new number is plain to see
//! ```

/// Reads through the text of an attribute.
pub(super) struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Skips blanks, and commas between numbers.
    pub(super) fn skip_separators(&mut self) {
        while self.peek().is_some_and(|b| b.is_ascii_whitespace() || b == b',') {
            self.at += 1;
        }
    }

    pub(super) fn at_end(&mut self) -> bool {
        self.skip_separators();
        self.at >= self.text.len()
    }

    /// What is still to be read.
    pub(super) fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    /// The next letter, if a letter is next.
    pub(super) fn letter(&mut self) -> Option<u8> {
        self.skip_separators();
        let letter = self.peek().filter(u8::is_ascii_alphabetic)?;
        self.at += 1;
        Some(letter)
    }

    /// The next letters, digits and hyphens.
    pub(super) fn word(&mut self) -> &'a str {
        self.skip_separators();
        let rest = self.rest();
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    /// The sign, if it is next.
    pub(super) fn sign(&mut self, sign: u8) -> Option<()> {
        self.skip_separators();
        (self.peek() == Some(sign)).then(|| self.at += 1)
    }

    /// A percent sign right behind a number.
    pub(super) fn percent(&mut self) -> bool {
        let is_percent = self.peek() == Some(b'%');
        self.at += usize::from(is_percent);
        is_percent
    }

    /// Whether this text is next, without blanks before it.
    pub(super) fn is_next(&self, text: &str) -> bool {
        self.rest().starts_with(text)
    }

    /// A flag of an arc: one digit, after which nothing need follow.
    pub(super) fn flag(&mut self) -> Option<bool> {
        self.skip_separators();
        let digit = self.peek().filter(|b| matches!(b, b'0' | b'1'))?;
        self.at += 1;
        Some(digit == b'1')
    }

    /// The next number.
    pub(super) fn number(&mut self) -> Option<f64> {
        self.skip_separators();
        let bytes = self.text.as_bytes();
        let digits = |i: usize| i + bytes[i..].iter().take_while(|b| b.is_ascii_digit()).count();
        let start = self.at + usize::from(matches!(self.peek(), Some(b'+' | b'-')));
        let mut end = digits(start);
        let mut count = end - start;
        if bytes.get(end) == Some(&b'.') {
            let fraction = digits(end + 1);
            count += fraction - end - 1;
            end = fraction;
        }
        if count == 0 {
            return None;
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let power = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            if digits(power) > power {
                end = digits(power);
            }
        }
        let value = self.text[self.at..end].parse().ok()?;
        self.at = end;
        Some(value)
    }

    /// Two numbers.
    pub(super) fn pair(&mut self) -> Option<[f64; 2]> {
        Some([self.number()?, self.number()?])
    }
}

/// All numbers of a list; `None` if there is anything else in it.
pub(super) fn list(text: &str) -> Option<Vec<f64>> {
    let mut reader = Reader::new(text);
    let mut out = Vec::new();
    while !reader.at_end() {
        out.push(reader.number()?);
    }
    Some(out)
}

/// A length in px from any of the units that have a fixed size: 96 px are an inch.
pub(super) fn measure(text: &str) -> Option<f64> {
    let mut reader = Reader::new(text.trim());
    let value = reader.number()?;
    let unit = match reader.rest() {
        "" | "px" => 1.0,
        "pt" => 96.0 / 72.0,
        "pc" => 16.0,
        "in" => 96.0,
        "cm" => 96.0 / 2.54,
        "mm" => 96.0 / 25.4,
        "Q" | "q" => 96.0 / 101.6,
        _ => return None,
    };
    Some(value * unit)
}

/// A length in px: a number, with or without the unit.
pub(super) fn length(text: &str) -> Option<f64> {
    let text = text.trim();
    let mut reader = Reader::new(text.strip_suffix("px").unwrap_or(text));
    let value = reader.number()?;
    reader.at_end().then_some(value)
}

/// A number or a percentage between 0 and 1.
pub(super) fn fraction(text: &str) -> Option<f64> {
    let mut reader = Reader::new(text);
    let value = reader.number()?;
    let value = if reader.percent() { value / 100.0 } else { value };
    reader.at_end().then_some(value.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_may_stand_without_separators() {
        assert_eq!(list("12.5,-3e2 .5.5-1"), Some(vec![12.5, -300.0, 0.5, 0.5, -1.0]));
        assert_eq!(list("1 2e 3"), None, "an exponent without digits");
        assert_eq!(list(". 1"), None);
        assert_eq!(length(" 12px "), Some(12.0));
        assert_eq!(length("12em"), None);
        assert_eq!(length("12mm"), None);
    }

    #[test]
    fn lengths_have_units() {
        let px = |text| measure(text).map(|px| (1000.0 * px).round() as i32);
        for (text, is) in [("25.4mm", 96), ("2.54cm", 96), ("1in", 96), ("72pt", 96), ("6pc", 96), (" 3 ", 3)] {
            assert_eq!(px(text), Some(1000 * is), "{text}");
        }
        for other in ["1em", "50%", "mm", "1 2", ""] {
            assert_eq!(measure(other), None, "{other}");
        }
    }
}
