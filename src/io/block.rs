//! A piece of a text: whole lines, and where they stand.

use crate::progress::Stage;
use std::sync::Arc;

/// Lines that follow each other.
#[derive(Clone, Debug)]
pub(super) struct Block<'a> {
    /// The bytes.
    pub(super) bytes: &'a [u8],
    /// How many bytes of the text come before.
    pub(super) base: usize,
    /// The number of the first line, from 1.
    pub(super) line: u32,
    /// Whether the text ends here.
    pub(super) is_last: bool,
    /// How many bytes there are from the start of the block to the end of the text, if that is known; else those of the block.
    pub(super) left: usize,
    /// Whether there is more than this block, so that lists must ask for memory while they grow.
    pub(super) is_part: bool,
    /// What errors call the text.
    pub(super) source: &'a str,
    /// How far reading has come.
    pub(super) stage: Arc<Stage>,
}
