//! A text in blocks of whole lines, so that it need not stand in memory as a whole.
//!
//! ```text
//!   v 0 0 0↵v 1 0 0↵v 0 1↵f 1 2        the bytes as they come
//!   └──── block ───┘└─ kept ─┘         a block ends behind a line end; the rest stands at the front of the next one
//! ```
//!
//! A reader that keeps nothing of one line when it comes to the next reads block by block what it would read at once. It is
//! the same line if CR and LF are in different pieces, and where `\` joins lines no block ends between them. A line that
//! is longer than a block makes the block longer. A text that is in memory is one block.

use super::block::Block;
use super::problem::{ReadError, ReadProblem};
use super::room::{reserved, too_little};
use super::text::{LARGEST_FILE, check_start, check_text, note_of_the_last_line};
use crate::progress::Stage;
use std::io::{self, Read, Seek, SeekFrom};
use std::sync::Arc;

/// How many bytes are asked for at a time.
const PIECE: usize = 1 << 18;
/// How much a reader may need for each byte of a block, beside lists that are as long as the text.
const BYTES_PER_BYTE: usize = 8;

/// Something that can be read from the start again.
pub(super) trait Rereadable: Read + Seek {}

impl<T: Read + Seek> Rereadable for T {}

/// Where the bytes come from.
pub(super) enum Origin<'a> {
    /// All of them are there.
    Whole(&'a [u8]),
    /// They come once.
    Once(Box<dyn Read + 'a>),
    /// They can be had again.
    Again(Box<dyn Rereadable + 'a>),
}

/// A text that is read block by block.
pub(super) struct Blocks<'a> {
    origin: Origin<'a>,
    source: &'a str,
    /// How many bytes are asked for at a time.
    piece: usize,
    /// Whether `\` before a line end joins lines.
    joins: bool,
    /// Whether commas and semicolons are blanks.
    separators: bool,
    /// Bytes that came. The block stands at the front.
    buffer: Vec<u8>,
    /// The length of the block.
    given: usize,
    /// Whether no more bytes come.
    has_ended: bool,
    /// Whether the last block was given.
    is_done: bool,
    /// Of the bytes before the block: how many, and the number of the line they end in.
    base: usize,
    line: u32,
    /// Line ends up to the end of the block, CR LF counted as two.
    line_ends: usize,
    /// Of all bytes, if it is known. The number is not relied on.
    length: Option<usize>,
    has_zero: bool,
    note: Option<String>,
    stage: Arc<Stage>,
}

impl<'a> Blocks<'a> {
    /// A text that is in memory, as one block.
    ///
    /// # Errors
    /// What no reader can take: see [`check_text`].
    pub(super) fn whole(bytes: &'a [u8], source: &'a str) -> Result<Self, ReadError> {
        check_text(bytes, source)?;
        Ok(Self::new(Origin::Whole(bytes), source, Some(bytes.len()), PIECE))
    }

    /// Bytes that come in pieces; nothing is read yet. `length` is how many will come, if that is known.
    pub(super) fn pieces(origin: Origin<'a>, source: &'a str, length: Option<usize>) -> Self {
        Self::new(origin, source, length, PIECE)
    }

    fn new(origin: Origin<'a>, source: &'a str, length: Option<usize>, piece: usize) -> Self {
        Self {
            origin,
            source,
            piece,
            joins: false,
            separators: false,
            buffer: Vec::new(),
            given: 0,
            has_ended: false,
            is_done: false,
            base: 0,
            line: 1,
            line_ends: 0,
            length,
            has_zero: false,
            note: None,
            stage: Arc::new(Stage::default()),
        }
    }

    /// The same, where `\` before a line end joins lines.
    pub(super) fn joining(&mut self) -> &mut Self {
        self.joins = true;
        self
    }

    /// The same, where commas and semicolons are blanks.
    pub(super) fn with_separators(&mut self) -> &mut Self {
        self.separators = true;
        self
    }

    /// What errors call the text.
    pub(super) fn source(&self) -> &'a str {
        self.source
    }

    /// That the last line has no end, when all blocks were given; see [`note_of_the_last_line`].
    pub(super) fn note(&mut self) -> Option<String> {
        self.note.take()
    }

    /// The first piece, before any block is asked for.
    ///
    /// # Errors
    /// What the machine says; too little memory.
    pub(super) fn peek(&mut self) -> Result<&[u8], ReadError> {
        if let Origin::Whole(bytes) = self.origin {
            return Ok(bytes);
        }
        if self.buffer.is_empty() {
            self.fill()?;
        }
        Ok(&self.buffer)
    }

    /// How many bytes there are in all, if it is known after [`peek`](Self::peek).
    pub(super) fn known_length(&self) -> Option<usize> {
        if self.has_ended { Some(self.buffer.len()) } else { self.length }
    }

    /// All bytes, if no block was asked for.
    ///
    /// # Errors
    /// What the machine says; too little memory.
    pub(super) fn into_whole(mut self) -> Result<Vec<u8>, ReadError> {
        if let Some(length) = self.length.filter(|&length| !self.has_ended && (length as u64) < LARGEST_FILE) {
            let more = length.saturating_sub(self.buffer.len());
            // One more byte, so that the end is found without asking for room again.
            self.buffer.try_reserve_exact(more + 32).map_err(|_| too_little(length, self.source))?;
        }
        self.rest()?;
        Ok(self.buffer)
    }

    /// Whether [`restart`](Self::restart) is possible.
    pub(super) fn can_restart(&self) -> bool {
        !matches!(self.origin, Origin::Once(_))
    }

    /// Reads all that is left behind the bytes that came.
    pub(super) fn rest(&mut self) -> Result<(), ReadError> {
        while !self.has_ended {
            self.fill()?;
        }
        Ok(())
    }

    /// Reads one piece more, or as much again as there is.
    fn fill(&mut self) -> Result<(), ReadError> {
        let so_far = self.base + self.buffer.len();
        let wanted = self.piece.max(self.buffer.len()).min(LARGEST_FILE as usize - so_far.min(LARGEST_FILE as usize));
        let too_little = |buffer: &Vec<u8>| too_little(buffer.len() + wanted, self.source);
        self.buffer.try_reserve(wanted + 32).map_err(|_| too_little(&self.buffer))?;
        let read = match &mut self.origin {
            Origin::Whole(_) => Ok(0),
            Origin::Once(from) => from.take(wanted as u64).read_to_end(&mut self.buffer),
            Origin::Again(from) => from.take(wanted as u64).read_to_end(&mut self.buffer),
        };
        match read {
            Ok(read) => self.has_ended = read < wanted || wanted == 0,
            Err(error) if error.kind() == io::ErrorKind::OutOfMemory => return Err(too_little(&self.buffer)),
            Err(error) => return Err(failed(self.source)(error)),
        }
        Ok(())
    }

    /// The next block; after the last one, nothing. The last one may be empty.
    ///
    /// # Errors
    /// An empty text, one of 4 GiB or more, one in UTF-16; what the machine says; too little memory.
    pub(super) fn next(&mut self) -> Result<Option<Block<'_>>, ReadError> {
        if self.is_done {
            return Ok(None);
        }
        let is_first = self.base == 0 && self.given == 0;
        let is_whole = matches!(self.origin, Origin::Whole(_));
        if is_whole {
            self.is_done = true;
        } else {
            self.step()?;
        }
        let bytes = match self.origin {
            Origin::Whole(bytes) => bytes,
            _ => &self.buffer[..self.given],
        };
        if is_first {
            check_start(bytes, self.length.filter(|_| !self.is_done).unwrap_or(bytes.len()), self.source)?;
            self.stage = Arc::new(Stage::new("reading", self.length.unwrap_or(0)));
        }
        if !is_whole {
            // For names and the like; lists ask for themselves.
            reserved::<u8>(bytes.len().saturating_mul(BYTES_PER_BYTE), self.source)?;
        }
        self.line_ends += count(bytes, b'\n') + count(bytes, b'\r');
        self.has_zero |= bytes.contains(&0);
        if self.is_done {
            self.note = if self.has_zero { None } else { note_of_the_last_line(bytes, self.line, self.separators) };
        }
        let left = self.length.map_or(bytes.len(), |length| length.saturating_sub(self.base).max(bytes.len()));
        Ok(Some(Block { left, ..self.same() }))
    }

    /// Leaves the block and moves to the next.
    fn step(&mut self) -> Result<(), ReadError> {
        self.line += lines_in(&self.buffer[..self.given]);
        self.base += self.given;
        self.buffer.copy_within(self.given.., 0);
        self.buffer.truncate(self.buffer.len() - self.given);
        self.given = 0;
        if self.buffer.is_empty() && !self.has_ended {
            self.fill()?;
        }
        loop {
            if self.has_ended {
                if (self.base + self.buffer.len()) as u64 >= LARGEST_FILE {
                    let problem = ReadProblem::TooLarge { what: "bytes", limit: LARGEST_FILE };
                    return Err(ReadError::whole(self.source, problem, ""));
                }
                (self.given, self.is_done) = (self.buffer.len(), true);
                return Ok(());
            }
            self.given = self.end_of_lines();
            if self.given > 0 {
                return Ok(());
            }
            self.fill()?;
        }
    }

    /// Where the last line ends that is sure to end in the bytes that came; 0 if none does.
    fn end_of_lines(&self) -> usize {
        let mut end = self.buffer.len();
        // Behind a CR an LF may be still to come.
        if self.buffer.ends_with(b"\r") {
            end -= 1;
        }
        loop {
            let Some(at) = self.buffer[..end].iter().rposition(|b| matches!(b, b'\n' | b'\r')) else { return 0 };
            let line = &self.buffer[..at];
            let line = if self.buffer[at] == b'\n' { line.strip_suffix(b"\r").unwrap_or(line) } else { line };
            if !(self.joins && line.ends_with(b"\\")) {
                return at + 1;
            }
            end = line.len();
        }
    }

    /// How many line ends the whole text has, CR LF counted as two. What is still to come is read for it, and read again if
    /// it can be had again, kept if it cannot. The block stays.
    ///
    /// # Errors
    /// What the machine says; too little memory.
    pub(super) fn line_ends(&mut self) -> Result<usize, ReadError> {
        let in_memory = |blocks: &Self| {
            let kept = blocks.buffer.get(blocks.given..).unwrap_or_default();
            blocks.line_ends + count(kept, b'\n') + count(kept, b'\r')
        };
        let Origin::Again(from) = &mut self.origin else {
            self.rest()?;
            return Ok(in_memory(self));
        };
        let mut piece = reserved(PIECE, self.source)?;
        let (mut found, mut length) = (0, 0);
        loop {
            piece.clear();
            let read = from.take(PIECE as u64).read_to_end(&mut piece).map_err(failed(self.source))?;
            found += count(&piece, b'\n') + count(&piece, b'\r');
            length += read as i64;
            if read < PIECE {
                break;
            }
        }
        from.seek(SeekFrom::Current(-length)).map_err(failed(self.source))?;
        Ok(found + in_memory(self))
    }

    /// Begins again with the first block. Returns whether that is possible.
    ///
    /// # Errors
    /// What the machine says.
    pub(super) fn restart(&mut self) -> Result<bool, ReadError> {
        match &mut self.origin {
            Origin::Once(_) => return Ok(false),
            Origin::Whole(_) => {}
            Origin::Again(from) => from.rewind().map_err(failed(self.source))?,
        }
        let origin = std::mem::replace(&mut self.origin, Origin::Whole(&[]));
        let (joins, separators) = (self.joins, self.separators);
        *self = Self { joins, separators, ..Self::new(origin, self.source, self.length, self.piece) };
        Ok(true)
    }

    /// The block that was given last, once more.
    pub(super) fn same(&self) -> Block<'_> {
        let bytes = match self.origin {
            Origin::Whole(bytes) => bytes,
            _ => &self.buffer[..self.given],
        };
        Block {
            bytes,
            base: self.base,
            line: self.line,
            is_last: self.is_done,
            left: bytes.len(),
            is_part: !matches!(self.origin, Origin::Whole(_)),
            source: self.source,
            stage: Arc::clone(&self.stage),
        }
    }

    /// How many line ends there are up to the end of the block, CR LF counted as two.
    pub(super) fn line_ends_so_far(&self) -> usize {
        self.line_ends
    }
}

/// The error that the machine cannot read on.
fn failed(source: &str) -> impl Fn(io::Error) -> ReadError + use<'_> {
    |error| ReadError::whole(source, ReadProblem::Io { reason: error.to_string() }, "")
}

fn count(bytes: &[u8], wanted: u8) -> usize {
    // Sums of bytes, which are added many at a time.
    bytes.chunks(255).map(|chunk| usize::from(chunk.iter().map(|&b| u8::from(b == wanted)).sum::<u8>())).sum()
}

/// How many lines end in a block; a CR at its end is a line end of its own.
fn lines_in(bytes: &[u8]) -> u32 {
    let returns = count(bytes, b'\r');
    let pairs = if returns == 0 { 0 } else { bytes.windows(2).filter(|pair| pair == b"\r\n").count() };
    (count(bytes, b'\n') + returns - pairs) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::points::plain;
    use crate::io::read::read_blocks;
    use crate::io::{Format, ReadOptions, points_from_text, read_bytes};
    use std::io::Cursor;

    /// How a text is read: in a format, or as plain points.
    type Way = Option<Format>;

    fn at_once(bytes: &[u8], way: Way) -> String {
        match way {
            Some(format) => format!("{:?}", read_bytes(bytes, format, "file", &ReadOptions::default())),
            None => format!("{:?}", points_from_text(bytes, "file")),
        }
    }

    fn in_pieces(bytes: &[u8], way: Way, piece: usize, again: bool) -> String {
        let origin = if again { Origin::Again(Box::new(Cursor::new(bytes))) } else { Origin::Once(Box::new(bytes)) };
        let length = again.then_some(bytes.len());
        let mut blocks = Blocks::new(origin, "file", length, piece);
        match way {
            Some(format) => format!("{:?}", read_blocks(&mut blocks, format, &ReadOptions::default())),
            None => format!("{:?}", plain(&mut blocks)),
        }
    }

    fn check(bytes: &[u8], way: Way, pieces: impl IntoIterator<Item = usize>) {
        let expected = at_once(bytes, way);
        for piece in pieces {
            for again in [true, false] {
                // A header of OFF that counts wrongly takes a second look.
                if again || way != Some(Format::Off) {
                    let found = in_pieces(bytes, way, piece, again);
                    let text = String::from_utf8_lossy(bytes);
                    assert_eq!(found, expected, "{way:?} in pieces of {piece}, again: {again}: {text:?}");
                }
            }
        }
    }

    const TEXTS: [(Way, &str); 12] = [
        (
            Some(Format::Obj),
            "# ü\nv 0 0 1 # p\nv 1 0 \\\n 2\\\n\nf 1 2 \\\n3\ng a b\\\nusemtl x\nxyz 3\nv 0 1 2\nf -3 -2 -1\nxy\n# \\\nf 1/1 3//2 2/1/1\nf 4 1 2\nv 5 5\n",
        ),
        (Some(Format::Obj), "v 0 0\nf 1 2 7\nv 1 0\nf 9 1 2\nf 1 1 8\nv 2 0\n"),
        (Some(Format::Obj), "blub 1\n\nbla\n"),
        (Some(Format::Off), "# c\nOFF\n# d\n4 2\n\n0 0 0\n1 0 0 7\n1 1 0 # ü\n0 1 0\n3 0 1 2\n3 0 2 3 255 0 0\n"),
        (Some(Format::Off), "OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"),
        (Some(Format::Off), "OFF 3 1\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n"),
        (
            Some(Format::Dcel),
            "# kit\n\ndcel 1\nv0 0 0 out h0\nv2 1e3 0\nh1 twin h0\nh0 origin v0 twin h1 next h0 prev none face f0\nf0 outer inner h1 v2 name \"a # \\\"ü\"\nf1 rings h0 hole\n",
        ),
        (Some(Format::Dcel), "dcel 1\nf0 outer\nv1 0 0\nf1 outer\n"),
        (Some(Format::Dcel), "dcel 1\nv1 0 0\n\nv0 1 1\nv1 1 0\n"),
        (Some(Format::Segments), "2 # two\n0 0 1 1\n\n1 1 2 0\n3 3 # alone\n"),
        (Some(Format::Segments), "5\n0 0 1 1\n"),
        (None, "x,\"y\"\n# ;\n3\n0 0\n4,0;\n;0;3\n"),
    ];

    #[test]
    fn a_text_in_pieces_of_any_length_is_the_same_text() {
        for (way, text) in TEXTS {
            for ends in ["\n", "\r\n", "\r"] {
                let text = text.replace('\n', ends);
                check(text.as_bytes(), way, 1..=64);
                check(format!("\u{feff}{text}").as_bytes(), way, 1..=64);
                // A byte order mark means nothing anywhere else.
                check(text.replacen(ends, &format!("{ends}\u{feff}"), 3).as_bytes(), way, 1..=64);
            }
        }
    }

    #[test]
    fn a_text_that_breaks_off_or_is_broken_is_refused_at_the_same_place() {
        for (way, text) in TEXTS {
            let text = text.replace("\nf", "\r\nf");
            for end in 0..text.len() {
                check(&text.as_bytes()[..end], way, [1, 2, 5, 16, 63]);
                let mut broken = text.clone().into_bytes();
                for byte in [0xff, b'\r', b'\\', b'x', b',', 0] {
                    broken[end] = byte;
                    check(&broken, way, [1, 3, 17]);
                }
            }
        }
    }

    #[test]
    fn a_line_may_be_longer_than_a_piece() {
        let words = "v 0 0 0 ".repeat(40);
        check(words.as_bytes(), Some(Format::Obj), [1, 7, 64]);
        let face = format!("v 0 0\nf{}\nf 2\n", " 1".repeat(300));
        check(face.as_bytes(), Some(Format::Obj), [1, 7, 64]);
        check("# \\\r\n".repeat(50).as_bytes(), Some(Format::Obj), [1, 7, 64]);
        check("0 0 ".repeat(50).as_bytes(), None, [1, 7, 64]);
    }

    #[test]
    fn what_was_seen_in_an_earlier_piece_counts_at_the_end() {
        // That the last line has no end is told of texts, and a byte of zero belongs to none.
        for text in ["# \0\nv 0 0\n# x\nv 1 0", "# 0\nv 0 0\n# x\nv 1 0", "v 0 0\n# x", "v 0 0\n;;"] {
            check(text.as_bytes(), Some(Format::Obj), [1, 5, 64]);
            check(text.replace("v ", "").as_bytes(), None, [1, 5, 64]);
        }
    }

    #[test]
    fn ids_are_compared_with_the_number_of_all_lines() {
        for beyond in [0, 1] {
            for ends in ["\n", "\r\n"] {
                let lines = 6 * ends.len();
                let id = 1_000_000 + lines + beyond;
                let text = format!("dcel 1\nf0\nv{id} 0 0\nh0\nh1\n# end\n").replace('\n', ends);
                let expected = at_once(text.as_bytes(), Some(Format::Dcel));
                assert_eq!(expected.starts_with("Ok"), beyond == 0);
                for (piece, again) in [(1, true), (1, false), (9, true), (9, false), (1000, false)] {
                    let found = in_pieces(text.as_bytes(), Some(Format::Dcel), piece, again);
                    assert!(found == expected, "{id} in pieces of {piece}: {found:.200}");
                }
            }
        }
    }

    #[test]
    fn what_is_not_read_in_blocks_is_there_as_a_whole() {
        let text: Vec<u8> = (0..1000).map(|i| i as u8).collect();
        for (piece, length) in [(1, None), (7, Some(1000)), (64, Some(3)), (4096, Some(5000)), (1000, None)] {
            let mut blocks = Blocks::new(Origin::Once(Box::new(&text[..])), "file", length, piece);
            let start = blocks.peek().unwrap().to_vec();
            assert!(!start.is_empty() && text.starts_with(&start));
            assert!(blocks.into_whole().unwrap() == text);
        }
    }

    #[test]
    fn an_interrupted_source_is_an_error_that_says_why() {
        struct Broken(usize);
        impl Read for Broken {
            fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
                self.0 += 1;
                if self.0 > 3 {
                    return Err(io::Error::other("the line is dead"));
                }
                let text = b"v 0 0\n";
                into[..6].copy_from_slice(text);
                Ok(6)
            }
        }
        let mut blocks = Blocks::pieces(Origin::Once(Box::new(Broken(0))), "file", None);
        let error = read_blocks(&mut blocks, Format::Obj, &ReadOptions::default()).unwrap_err();
        assert_eq!(error.to_string(), "file: cannot be read: the line is dead");
    }
}
