//! Words that have been replaced. The old ones are still read, with a note, until version 1.0.

use std::fmt;

/// Where a word is written.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum Language {
    /// In scripts of edits.
    Script,
    /// In `.dcel` files.
    DcelFile,
    /// On the command line: a flag, or a flag and its value.
    CommandLine,
}

/// A word that has been replaced by another.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct OldWord {
    /// Where it is written.
    pub language: Language,
    /// The old word.
    pub old: &'static str,
    /// The word to write instead.
    pub new: &'static str,
}

const fn row(language: Language, old: &'static str, new: &'static str) -> OldWord {
    OldWord { language, old, new }
}

/// All of them.
pub const OLD_WORDS: &[OldWord] = &[
    row(Language::Script, "boundary", "half_edge"),
    row(Language::Script, "insert_antenna", "insert_dangling_edge"),
    row(Language::DcelFile, "boundary", "half_edge"),
    row(Language::DcelFile, "rings", "inner"),
    row(Language::CommandLine, "--pointers boundary", "--pointers half-edge"),
    row(Language::CommandLine, "--rung", "--algorithm"),
];

impl OldWord {
    /// The row of an old word; `None` for all other words.
    ///
    /// ```
    /// use dcel_kit::old_words::{Language, OldWord};
    /// assert_eq!(OldWord::find(Language::Script, "boundary").unwrap().new, "half_edge");
    /// assert_eq!(OldWord::find(Language::Script, "half_edge"), None);
    /// ```
    #[must_use]
    pub fn find(language: Language, word: &str) -> Option<&'static Self> {
        OLD_WORDS.iter().find(|row| row.language == language && row.old == word)
    }

    /// The word to write today for this word, which may be an old one.
    #[must_use]
    pub fn current(language: Language, word: &str) -> &str {
        Self::find(language, word).map_or(word, |row| row.new)
    }
}

impl fmt::Display for OldWord {
    /// The note for people.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is now called `{}`; the old word is read until version 1.0", self.old, self.new)
    }
}
