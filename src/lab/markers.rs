//! The starter of a lab, from its solution: there is one source for both.
//!
//! ```text
//!   // BEGIN SOLUTION                     becomes     the text of its STARTER lines,
//!   // STARTER: todo!("degree")                       here: todo!("degree")
//!   let walk = self.around(v);
//!   walk.count()                          A block without STARTER lines becomes todo!().
//!   // END SOLUTION
//! ```
//!
//! A marker stands alone in its line; what replaces a block is indented as its first line. All else is copied.

/// What a starter says where a block says nothing else.
const UNWRITTEN: &str = "todo!()";

/// Why a source is not marked as it should be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MarkError {
    /// A block begins inside a block.
    #[error("line {line}: a block begins inside the one of line {first_line}; end that first")]
    Nested {
        /// The line of the inner marker, from 1.
        line: usize,
        /// The line of the outer marker.
        first_line: usize,
    },
    /// A block ends that has not begun.
    #[error("line {line}: END SOLUTION without BEGIN SOLUTION")]
    NotBegun {
        /// The line of the marker, from 1.
        line: usize,
    },
    /// The text ends inside a block.
    #[error("line {line}: this block never ends; write END SOLUTION after it")]
    NotEnded {
        /// The line where it begins, from 1.
        line: usize,
    },
    /// Starter text outside a block.
    #[error("line {line}: STARTER outside of a block; it belongs after BEGIN SOLUTION")]
    StrayStarter {
        /// The line, from 1.
        line: usize,
    },
    /// Nothing is marked: the starter would be the solution.
    #[error("no block is marked: the starter would show the whole solution")]
    NothingMarked,
}

/// A line of a marked source.
enum Marked<'a> {
    Begin,
    End,
    Starter(&'a str),
    Text,
}

fn read(line: &str) -> Marked<'_> {
    let Some(comment) = line.trim().strip_prefix("//") else { return Marked::Text };
    match comment.trim() {
        "BEGIN SOLUTION" => Marked::Begin,
        "END SOLUTION" => Marked::End,
        comment => comment.strip_prefix("STARTER:").map_or(Marked::Text, |text| {
            // One blank belongs to the marker; the rest is indentation.
            Marked::Starter(text.strip_prefix(' ').unwrap_or(text))
        }),
    }
}

/// The starter that belongs to a marked solution. Cost: linear.
///
/// # Errors
/// [`MarkError`] with the line, if markers do not pair up.
pub fn starter(solution: &str) -> Result<String, MarkError> {
    let mut text = String::with_capacity(solution.len());
    let mut block: Option<Block> = None;
    let mut marked = false;
    for (i, line) in solution.lines().enumerate() {
        let number = i + 1;
        match (read(line), &mut block) {
            (Marked::Begin, Some(open)) => return Err(MarkError::Nested { line: number, first_line: open.line }),
            (Marked::Begin, none) => {
                let indent = &line[..line.len() - line.trim_start().len()];
                *none = Some(Block { line: number, indent, starter: Vec::new() });
                marked = true;
            }
            (Marked::End, Some(open)) => {
                open.write(&mut text);
                block = None;
            }
            (Marked::End, None) => return Err(MarkError::NotBegun { line: number }),
            (Marked::Starter(line), Some(open)) => open.starter.push(line),
            (Marked::Starter(_), None) => return Err(MarkError::StrayStarter { line: number }),
            (Marked::Text, Some(_)) => {}
            (Marked::Text, None) => {
                text.push_str(line);
                text.push('\n');
            }
        }
    }
    match block {
        Some(open) => Err(MarkError::NotEnded { line: open.line }),
        None if !marked => Err(MarkError::NothingMarked),
        None => Ok(text),
    }
}

/// A block that is being read.
struct Block<'a> {
    line: usize,
    indent: &'a str,
    starter: Vec<&'a str>,
}

impl Block<'_> {
    fn write(&self, text: &mut String) {
        let unwritten = [UNWRITTEN];
        for line in if self.starter.is_empty() { &unwritten[..] } else { &self.starter } {
            text.push_str(if line.is_empty() { "" } else { self.indent });
            text.push_str(line);
            text.push('\n');
        }
    }
}
