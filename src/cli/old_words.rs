//! Arguments in words that have been replaced: they are taken as the new ones, with a note.

use dcel_kit::old_words::{Language, OLD_WORDS, OldWord};
use std::ffi::OsString;

/// The arguments in the words of today, and the old words among them, each once.
pub(crate) fn current(arguments: impl Iterator<Item = OsString>) -> (Vec<OsString>, Vec<&'static OldWord>) {
    let rows = || OLD_WORDS.iter().filter(|row| row.language == Language::CommandLine);
    let (mut out, mut met) = (Vec::new(), Vec::new());
    let mut note = |row| {
        if !met.contains(&row) {
            met.push(row);
        }
    };
    // The flag before a value.
    let mut flag = String::new();
    let mut plain = false;
    for argument in arguments {
        let Some(text) = argument.to_str().filter(|_| !plain) else {
            out.push(argument);
            continue;
        };
        plain = text == "--";
        let (name, value) = match text.split_once('=') {
            Some((name, value)) if name.starts_with("--") => (name.to_owned(), Some(value.to_owned())),
            _ if text.starts_with("--") => (text.to_owned(), None),
            _ => (std::mem::take(&mut flag), Some(text.to_owned())),
        };
        let new_name = rows().find(|row| row.old == name).map_or(name.clone(), |row| {
            note(row);
            row.new.to_owned()
        });
        // Values are lists with commas.
        let new_value = value.map(|value| {
            let word = |word: &str| {
                let pair = format!("{new_name} {word}");
                let row = rows().find(|row| row.old == pair);
                row.map_or_else(
                    || word.to_owned(),
                    |row| {
                        note(row);
                        row.new.rsplit(' ').next().unwrap_or_default().to_owned()
                    },
                )
            };
            value.split(',').map(word).collect::<Vec<_>>().join(",")
        });
        out.push(match (text.starts_with("--"), new_value) {
            (true, None) => {
                flag.clone_from(&new_name);
                new_name.into()
            }
            (true, Some(value)) => format!("{new_name}={value}").into(),
            (false, value) => value.unwrap_or_default().into(),
        });
    }
    (out, met)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_old_word_is_taken_as_the_new_one_and_noted_once() {
        for row in OLD_WORDS.iter().filter(|row| row.language == Language::CommandLine) {
            let words = |text: &str| text.split(' ').map(OsString::from).collect::<Vec<_>>();
            let (new, met) = current(words(&format!("dcel x {0} {0} y", row.old)).into_iter());
            assert_eq!((new, met), (words(&format!("dcel x {0} {0} y", row.new)), vec![row]));
        }
    }

    #[test]
    fn lists_and_equal_signs_are_read_and_all_else_stays() {
        let call = |text: &str| {
            let (new, met) = current(text.split(' ').map(OsString::from));
            (new.iter().map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" "), met.len())
        };
        assert_eq!(
            call("dcel figure --pointers=next,boundary a"),
            ("dcel figure --pointers=next,half-edge a".into(), 1)
        );
        assert_eq!(
            call("dcel figure --pointers next,boundary a"),
            ("dcel figure --pointers next,half-edge a".into(), 1)
        );
        for same in
            ["dcel figure boundary", "dcel walk --face-name boundary", "dcel x -- --pointers boundary", "dcel -"]
        {
            assert_eq!(call(same), (same.to_owned(), 0));
        }
    }
}
