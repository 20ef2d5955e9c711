//! The answer on standard output.

use super::waiting::aside;
use super::{Answer, Failure};
use dcel_kit::io::{Number, counted};
use serde::Serialize;
use std::io::{self, BufWriter, StdoutLock, Write};

/// Standard output, buffered. Errors come back as they happen, a closed pipe among them.
pub(crate) struct Output(BufWriter<StdoutLock<'static>>);

impl Output {
    pub(crate) fn new() -> Self {
        Self(BufWriter::with_capacity(1 << 16, io::stdout().lock()))
    }

    /// Writes a value as JSON with indentation: most often all that a command answers.
    pub(crate) fn json(&mut self, value: &impl Serialize) -> Result<Answer, Failure> {
        serde_json::to_writer_pretty(&mut *self, value)?;
        self.write_all(b"\n")?;
        Ok(Answer::Yes)
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Only what does not fit goes out.
        let fits = self.0.buffer().len() + bytes.len() < self.0.capacity();
        if fits { self.0.write(bytes) } else { aside(|| self.0.write(bytes)) }
    }

    fn flush(&mut self) -> io::Result<()> {
        aside(|| self.0.flush())
    }
}

/// `(1, 2)`, with as many digits as bring back the same numbers.
pub(crate) fn point(coordinates: &[f64]) -> String {
    let numbers: Vec<String> = coordinates.iter().map(|&x| Number(x).to_string()).collect();
    format!("({})", numbers.join(", "))
}

/// `8 vertices, 12 edges, 6 faces`.
pub(crate) fn counts([vertices, edges, faces]: [usize; 3]) -> String {
    let (vertices, edges) = (counted(vertices, "vertex", "vertices"), counted(edges, "edge", "edges"));
    format!("{vertices}, {edges}, {}", counted(faces, "face", "faces"))
}

/// Elements, each as it is written.
pub(crate) fn names<T: ToString>(elements: impl IntoIterator<Item = T>) -> Vec<String> {
    elements.into_iter().map(|element| element.to_string()).collect()
}

/// The words of a text in lines of at most `width` characters, longer words alone.
pub(crate) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Rows in aligned columns, indented by two.
pub(crate) fn table<const N: usize>(out: &mut impl Write, rows: &[[String; N]]) -> io::Result<()> {
    let width = |i: usize| rows.iter().map(|row| row[i].chars().count()).max().unwrap_or(0);
    let widths: [usize; N] = std::array::from_fn(width);
    for row in rows {
        // By hand: a width in a format string ends at 65,535.
        let blanks = |cell: &str, width: usize| " ".repeat(width.saturating_sub(cell.chars().count()));
        let line: Vec<String> =
            row.iter().zip(widths).map(|(cell, width)| format!("{cell}{}", blanks(cell, width))).collect();
        writeln!(out, "  {}", line.join("  ").trim_end())?;
    }
    Ok(())
}
