//! What could not be drawn, in words.

use crate::ids::Id;

/// What was left out, one sentence a kind.
#[derive(Default)]
pub(crate) struct Notes(pub(crate) Vec<String>);

impl Notes {
    pub(crate) fn add<I: Id>(&mut self, what: &str, elements: impl Iterator<Item = I>) {
        self.add_words(what, &mut elements.map(|element| element.to_string()));
    }

    /// At most ten names are written out.
    pub(crate) fn add_words(&mut self, what: &str, words: &mut dyn Iterator<Item = String>) {
        let mut names = Vec::new();
        let mut more = 0;
        for word in words {
            if names.len() < 10 {
                names.push(word);
            } else {
                more += 1;
            }
        }
        if !names.is_empty() {
            let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
            self.0.push(format!("{what}: {}{rest}", names.join(", ")));
        }
    }
}
