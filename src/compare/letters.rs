//! How large letters are.
//!
//! ```text
//!   font-size: 12px    150%    2em    bold 9pt/1.2 serif
//!   --small: 9px       font-size: var(--small, 12px)        names are looked up where the letters stand
//! ```
//!
//! Sizes that browsers work out, as `calc(...)`, are kept as they are written: they matter only where letters stand.

use super::numbers;
use super::values::is_unread;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The size of an element whose style says nothing, and of the root.
const SIZE: f64 = 16.0;
/// Names are looked up so many times for one value.
const LOOKS: usize = 8;

/// The size of letters, and the names by which sizes may be called.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Letters {
    pub(super) size: f64,
    /// The declaration of a size that is not worked out.
    pub(super) unread: Option<Rc<(&'static str, String)>>,
    names: Rc<BTreeMap<String, String>>,
}

impl Default for Letters {
    fn default() -> Self {
        Self { size: SIZE, unread: None, names: Rc::default() }
    }
}

impl Letters {
    /// Keeps a value by its name, `--small`.
    pub(super) fn name(&mut self, name: &str, value: &str) {
        Rc::make_mut(&mut self.names).insert(name.to_owned(), value.to_owned());
    }

    /// Sets the size by `font-size` or `font` within letters of another size. A size below 0 is none, and passed over.
    pub(super) fn set(&mut self, key: &'static str, value: &str, around: &Self) {
        let inherited = (around.size, around.unread.clone());
        let Some(said) = self.looked_up(value) else {
            (self.size, self.unread) = inherited;
            return;
        };
        if is_unread(key, &said) {
            self.unread = Some(Rc::new((key, said)));
            return;
        }
        let is_size = |word: &&str| word.ends_with(|c: char| c.is_ascii_alphabetic() || c == '%');
        let words = said.split([' ', '/']).filter(|word| key == "font-size" || is_size(word));
        let found = words.filter_map(|word| Some((size(word, around.size)?, is_part(word)))).next();
        match found {
            Some((size, _)) if size < 0.0 => {}
            Some((size, is_part)) => {
                (self.size, self.unread) = (size, around.unread.clone().filter(|_| is_part));
            }
            None => (self.size, self.unread) = inherited,
        }
    }

    /// A value with what stands for its names; `None` if one stands for nothing. What is still named after so many
    /// looks stays.
    fn looked_up(&self, value: &str) -> Option<String> {
        let mut out = value.to_owned();
        for _ in 0..LOOKS {
            let Some(start) = out.find("var(") else { break };
            let mut depth = 0i32;
            let end = out[start..].find(|c: char| {
                depth += i32::from(c == '(') - i32::from(c == ')');
                depth == 0 && c == ')'
            });
            let end = start + end?;
            let inside = &out[start + 4..end];
            let (name, otherwise) = inside.split_once(',').map_or((inside, None), |(name, rest)| (name, Some(rest)));
            let known = self.names.get(&name.trim().to_ascii_lowercase());
            let value = known.map(String::as_str).or(otherwise)?.trim().to_owned();
            out.replace_range(start..=end, &value);
        }
        Some(out)
    }
}

/// A size from a length, or from a part of the size around or of that of the root.
fn size(text: &str, around: f64) -> Option<f64> {
    let part = |unit: &str, whole: f64| Some(whole * numbers::length(text.strip_suffix(unit)?)?);
    let part = part("%", around / 100.0).or_else(|| part("rem", SIZE)).or_else(|| part("em", around));
    part.or_else(|| numbers::measure(text))
}

/// Whether a size is a part of the size around.
fn is_part(text: &str) -> bool {
    text.ends_with('%') || text.ends_with("em") && !text.ends_with("rem")
}
