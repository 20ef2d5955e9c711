//! Words for the values of an option, each with a line of help.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A word of the command line, what it says in the help, and what it stands for.
pub(crate) type Choice<T> = (&'static str, &'static str, T);

/// Reads one of these words as what it stands for.
pub(crate) fn one_of<T>(choices: &'static [Choice<T>]) -> impl TypedValueParser<Value = T>
where
    T: Clone + Send + Sync + 'static,
{
    let words = choices.iter().map(|&(word, help, _)| PossibleValue::new(word).help(help));
    PossibleValuesParser::new(words).try_map(|given| {
        let found = choices.iter().find(|(word, ..)| *word == given);
        found.map(|(.., value)| value.clone()).ok_or("no such word")
    })
}
