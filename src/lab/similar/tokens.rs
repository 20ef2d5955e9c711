//! The tokens of a file as numbers: what a change of names, comments or layout does not touch.
//!
//! ```text
//!   let mut h = self.next(he1); // onward        let mut own = self . next ( own ) ;
//! ```
//!
//! A name that stands alone is one's own, whatever it is: a variable or a function. What follows a dot or `::` is a
//! field or function of somebody else, unless the file declares a function of that name that is not given. Types are
//! told by their first letter: those that are given and the usual ones of Rust stay.

use crate::cache::hash_of;
use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::str::FromStr;

const KEYWORDS: &[&str] = &[
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false", "fn",
    "for", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self", "Self",
    "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where", "while",
];

/// Types and variants that everybody uses.
const USUAL: &[&str] = &["Vec", "Option", "Some", "None", "Result", "Ok", "Err", "String", "Box", "HashMap", "HashSet"];

/// A token, as far as it is told from others.
enum Token {
    /// `called` is a name after a dot or `::`, or before `!`; `declared` is one after `fn`.
    Name {
        text: String,
        called: bool,
        declared: bool,
    },
    Mark(char),
    Literal,
}

/// The names of functions and types that a text declares or uses; none if it is no Rust.
pub(super) fn names(text: &str) -> Vec<String> {
    let name = |token| match token {
        Token::Name { text, declared, .. } if declared || is_type(&text) => Some(text),
        _ => None,
    };
    flat(text).unwrap_or_default().into_iter().filter_map(name).collect()
}

fn is_type(name: &str) -> bool {
    name.starts_with(char::is_uppercase)
}

/// The tokens of a text; `None` if it is no Rust. `given` are names that are not the author's own.
pub(super) fn tokens(text: &str, given: &BTreeSet<String>) -> Option<Vec<u64>> {
    let tokens = flat(text)?;
    let own: BTreeSet<&str> = tokens
        .iter()
        .filter_map(|token| match token {
            Token::Name { text, declared: true, .. } if !given.contains(text) => Some(text.as_str()),
            _ => None,
        })
        .collect();
    let stays = |name: &str, called: bool, declared: bool| {
        KEYWORDS.contains(&name)
            || (called && !own.contains(name))
            || (declared && given.contains(name))
            || (is_type(name) && (given.contains(name) || USUAL.contains(&name)))
    };
    let told = |token: &Token| match token {
        Token::Name { text, called, declared } if stays(text, *called, *declared) => hash_of(&("name", text)),
        Token::Name { .. } => hash_of(&"own name"),
        Token::Mark(mark) => hash_of(mark),
        Token::Literal => hash_of(&"literal"),
    };
    Some(tokens.iter().map(told).collect())
}

/// The tokens in a row, brackets as marks, without documentation. However deep they are nested, no stack is used.
fn flat(text: &str) -> Option<Vec<Token>> {
    let mut out = Vec::new();
    let mut open = vec![(TokenStream::from_str(text).ok()?.into_iter().peekable(), None)];
    while let Some((tokens, closing)) = open.last_mut() {
        let Some(token) = tokens.next() else {
            out.extend(closing.map(Token::Mark));
            open.pop();
            continue;
        };
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                let inner = matches!(tokens.peek(), Some(TokenTree::Punct(mark)) if mark.as_char() == '!');
                if inner {
                    tokens.next();
                }
                // Comments for documentation come as attributes.
                match tokens.peek() {
                    Some(TokenTree::Group(group)) if is_doc(&group.stream()) => drop(tokens.next()),
                    _ => out.push(Token::Mark('#')),
                }
            }
            TokenTree::Group(group) => {
                let (first, last) = match group.delimiter() {
                    Delimiter::Parenthesis => (Some('('), Some(')')),
                    Delimiter::Brace => (Some('{'), Some('}')),
                    Delimiter::Bracket => (Some('['), Some(']')),
                    Delimiter::None => (None, None),
                };
                out.extend(first.map(Token::Mark));
                open.push((group.stream().into_iter().peekable(), last));
            }
            TokenTree::Ident(name) => {
                let before: Vec<&Token> = out.iter().rev().take(2).collect();
                let of_another = match before[..] {
                    // Not the end of a range.
                    [Token::Mark('.'), Token::Mark('.')] => false,
                    [Token::Mark('.'), ..] | [Token::Mark(':'), Token::Mark(':')] => true,
                    _ => false,
                };
                let is_macro = matches!(
                    tokens.peek(),
                    Some(TokenTree::Punct(mark)) if mark.as_char() == '!' && mark.spacing() == Spacing::Alone
                );
                let declared = matches!(before.first(), Some(Token::Name { text, .. }) if text == "fn");
                out.push(Token::Name { text: name.to_string(), called: of_another || is_macro, declared });
            }
            TokenTree::Punct(mark) => out.push(Token::Mark(mark.as_char())),
            TokenTree::Literal(_) => out.push(Token::Literal),
        }
    }
    Some(out)
}

fn is_doc(attribute: &TokenStream) -> bool {
    matches!(attribute.clone().into_iter().next(), Some(TokenTree::Ident(name)) if name == "doc")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_names_change_no_token_and_operators_do() {
        let of = |text: &str| tokens(text, &BTreeSet::new()).unwrap();
        let plain = of("fn more(a: i32) -> i32 { a + 1 }");
        for same in [
            "/// One more.\nfn more(a: i32) -> i32 { a + 1 }",
            "//! Numbers.\nfn more(a: i32) -> i32 { a + 1 }",
            "fn more(a: i32) -> i32 { /* no less */ a + 1 } // and no more",
            "fn next(from: i32) -> i32 {\n    from + 2\n}",
        ] {
            assert_eq!(of(same), plain, "{same}");
        }
        for other in
            ["fn more(a: i32) -> i32 { a - 1 }", "fn more(a: i32) -> i32 { -a + 1 }", "#[inline]\nfn more() {}"]
        {
            assert_ne!(of(other), plain, "{other}");
        }
        assert_eq!(
            of("#[inline]\nfn more() {}"),
            of("#![inline]\nfn less() {}"),
            "an attribute is one, wherever it stands"
        );
    }
}
