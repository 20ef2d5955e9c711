//! Style rules and which elements they fit.
//!
//! ```text
//!   #x .a.b > text{fill:red}      fits  <svg id="x"> <g class="a b"> <text>
//!    └ steps, outermost first
//! ```
//!
//! Understood are selectors of names, `*`, ids, classes, attributes (`[class~=x]`), `:root` and `:not(...)` of these,
//! with descendants and children (`>`), and what nobody does who only looks (`:hover`). Rules with anything else have no
//! say; `blocks.rs` tells which of them may change what is seen. For a comparison, rules inside `@media screen` count as
//! if they stood outside. Rules win by
//! specificity, then by order.

use super::blocks::{Block, blocks, enclosed, parts};
use std::rc::Rc;

/// `#x .a.b > text` as its steps, outermost first.
pub(crate) struct Rule<'a> {
    steps: Vec<Step<'a>>,
    /// Shared by the selectors of one rule.
    pub(crate) properties: Rc<[(&'a str, &'a str)]>,
}

/// What one step of a selector asks for.
#[derive(Default)]
pub(super) struct Step<'a> {
    name: Option<&'a str>,
    id: Option<&'a str>,
    classes: Vec<&'a str>,
    attributes: Vec<Attribute<'a>>,
    not: Vec<Step<'a>>,
    is_root: bool,
    /// Whether it asks for something that only a reader does, such as to point at it.
    never: bool,
    /// Whether it stands directly within the step before.
    is_child: bool,
}

/// `[name=value]`: how the value is compared, if it is.
struct Attribute<'a> {
    name: &'a str,
    wanted: Option<(u8, &'a str)>,
}

/// What an element offers.
#[derive(Default)]
pub(crate) struct Tag {
    pub(crate) name: String,
    pub(crate) id: Option<String>,
    pub(crate) classes: Vec<String>,
    /// Its attributes, if rules may ask for them.
    pub(crate) attributes: Vec<(String, String)>,
}

impl Rule<'_> {
    /// Ids, classes, names.
    fn specificity(&self) -> (usize, usize, usize) {
        self.steps.iter().map(Step::specificity).fold((0, 0, 0), |a, b| (a.0 + b.0, a.1 + b.1, a.2 + b.2))
    }

    /// How much more than names, ids and classes there is to look at, for each tag.
    #[cfg(feature = "compare")]
    pub(crate) fn weight(&self) -> usize {
        1 + self.steps.iter().map(Step::weight).sum::<usize>()
    }

    /// Whether the last step fits the last tag, and the others fit tags around it in their order.
    pub(crate) fn fits(&self, path: &[Tag]) -> bool {
        let mut steps = &self.steps[..];
        let mut room = path.len();
        while !steps.is_empty() {
            // Steps that stand directly within each other, with the one around them.
            let start = steps.iter().rposition(|step| !step.is_child).unwrap_or(0);
            let (outer, chain) = steps.split_at(start);
            // The innermost place that fits leaves most room for the others.
            let is_last = steps.len() == self.steps.len();
            let lowest = if is_last { room } else { chain.len() };
            let fits = |end: &usize| chain_fits(chain, path, *end);
            let Some(end) = (lowest.max(chain.len())..=room).rev().find(fits) else { return false };
            (steps, room) = (outer, end - chain.len());
        }
        !self.steps.is_empty()
    }
}

/// Whether steps fit the tags of a path that end here, one by one.
fn chain_fits(chain: &[Step<'_>], path: &[Tag], end: usize) -> bool {
    let start = end - chain.len();
    chain.iter().zip(start..end).rev().all(|(step, depth)| step.fits(&path[depth], depth == 0))
}

impl<'a> Step<'a> {
    fn specificity(&self) -> (usize, usize, usize) {
        let own = (
            usize::from(self.id.is_some()),
            self.classes.len() + self.attributes.len() + usize::from(self.is_root),
            usize::from(self.name.is_some()),
        );
        self.not.iter().map(Self::specificity).fold(own, |a, b| (a.0 + b.0, a.1 + b.1, a.2 + b.2))
    }

    #[cfg(feature = "compare")]
    fn weight(&self) -> usize {
        let not = self.not.iter().map(|step| 1 + step.weight() + step.classes.len()).sum::<usize>();
        usize::from(self.is_child) + self.attributes.len() + not
    }

    /// `None` for what is not understood.
    fn read(text: &'a str) -> Option<Self> {
        let mut out = Self::default();
        let mut rest = text;
        if let Some(after) = rest.strip_prefix('*') {
            rest = after;
        } else if rest.starts_with(is_of_word) {
            (out.name, rest) = word(rest).map(|(name, rest)| (Some(name), rest))?;
        }
        while let Some(first) = rest.chars().next() {
            let body = &rest[first.len_utf8()..];
            rest = match first {
                '#' => {
                    let (id, rest) = word(body)?;
                    out.id = Some(id);
                    rest
                }
                '.' => {
                    let (class, rest) = word(body)?;
                    out.classes.push(class);
                    rest
                }
                '[' => {
                    let (inside, rest) = body.split_once(']')?;
                    out.attributes.push(Attribute::read(inside)?);
                    rest
                }
                ':' => out.pseudo(body)?,
                _ => return None,
            };
        }
        (!text.is_empty()).then_some(out)
    }

    /// `:root`, `:not(...)`, and what nobody does who only looks; what follows.
    fn pseudo(&mut self, text: &'a str) -> Option<&'a str> {
        let (name, rest) = word(text)?;
        if OF_READERS.contains(&name) {
            self.never = true;
            return Some(rest);
        }
        if name == "root" {
            self.is_root = true;
            return Some(rest);
        }
        let (inside, rest) = bracket(rest)?;
        match name {
            "not" => {
                for one in parts(inside, ',') {
                    self.not.push(Step::read(one.trim())?);
                }
            }
            // Something within at which somebody points: nobody does.
            "has" => self.never = Step::read(inside.trim())?.never.then_some(true)?,
            _ => return None,
        }
        Some(rest)
    }

    fn fits(&self, tag: &Tag, is_root: bool) -> bool {
        self.name.is_none_or(|name| name == tag.name)
            && self.id.is_none_or(|id| tag.id.as_deref() == Some(id))
            && self.classes.iter().all(|class| tag.classes.iter().any(|c| c == class))
            && self.attributes.iter().all(|attribute| attribute.fits(tag))
            && (is_root || !self.is_root)
            && !self.never
            && !self.not.iter().any(|step| step.fits(tag, is_root))
    }
}

impl<'a> Attribute<'a> {
    fn read(text: &'a str) -> Option<Self> {
        let Some((name, value)) = text.split_once('=') else {
            let (name, rest) = word(text.trim())?;
            return rest.is_empty().then_some(Self { name, wanted: None });
        };
        let how = name.trim_end().bytes().last().filter(|b| b"~|^$*".contains(b));
        let name = name.trim().trim_end_matches(['~', '|', '^', '$', '*']).trim_end();
        let value = value.trim();
        let quoted = ['"', '\''].iter().find_map(|quote| value.strip_prefix(*quote)?.strip_suffix(*quote));
        let value = quoted.or_else(|| word(value).filter(|(_, rest)| rest.is_empty()).map(|(value, _)| value))?;
        let (name, rest) = word(name)?;
        rest.is_empty().then_some(Self { name, wanted: Some((how.unwrap_or(b'='), value)) })
    }

    fn fits(&self, tag: &Tag) -> bool {
        let Some((_, is)) = tag.attributes.iter().find(|(name, _)| name == self.name) else { return false };
        let Some((how, wanted)) = self.wanted else { return true };
        match how {
            b'~' => is.split_whitespace().any(|word| word == wanted),
            b'|' => is == wanted || is.strip_prefix(wanted).is_some_and(|rest| rest.starts_with('-')),
            b'^' => !wanted.is_empty() && is.starts_with(wanted),
            b'$' => !wanted.is_empty() && is.ends_with(wanted),
            b'*' => !wanted.is_empty() && is.contains(wanted),
            _ => is == wanted,
        }
    }
}

/// Pseudo-classes that say what a reader does: a drawing that lies there unread does not have them.
pub(super) const OF_READERS: [&str; 8] =
    ["hover", "focus", "focus-visible", "focus-within", "active", "visited", "target", "checked"];

/// What stands within round brackets at the start, and what follows.
fn bracket(text: &str) -> Option<(&str, &str)> {
    enclosed(text.strip_prefix('(')?, ['(', ')'])
}

fn is_of_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '-' || c == '_'
}

/// A word at the start, and what follows.
fn word(text: &str) -> Option<(&str, &str)> {
    let end = text.find(|c: char| !is_of_word(c)).unwrap_or(text.len());
    (end > 0).then(|| text.split_at(end))
}

/// The steps of one selector; `None` if it is not understood.
pub(super) fn steps(selector: &str) -> Option<Vec<Step<'_>>> {
    let mut out = Vec::new();
    let mut is_child = false;
    // Blanks within brackets part nothing.
    for part in parts(selector, ' ').flat_map(with_child_marks) {
        if part == ">" {
            if is_child || out.is_empty() {
                return None;
            }
            is_child = true;
        } else if !part.is_empty() {
            out.push(Step { is_child, ..Step::read(part)? });
            is_child = false;
        }
    }
    (!is_child && !out.is_empty()).then_some(out)
}

/// `a>b` as `a`, `>`, `b`.
fn with_child_marks(part: &str) -> impl Iterator<Item = &str> {
    parts(part, '>').flat_map(|piece| [">", piece.trim()]).skip(1)
}

/// The rules outside of `@media`, the weakest first.
pub(crate) fn rules(css: &str) -> Vec<Rule<'_>> {
    sorted(css, false)
}

/// The rules outside of `@media`, and inside those for screens; the weakest first.
#[cfg(feature = "compare")]
pub(crate) fn rules_on_screen(css: &str) -> Vec<Rule<'_>> {
    sorted(css, true)
}

fn sorted(css: &str, on_screen: bool) -> Vec<Rule<'_>> {
    let mut out = Vec::new();
    add(css, on_screen, &mut out, 0);
    out.sort_by_key(Rule::specificity);
    out
}

/// Blocks within blocks are read so deep.
const DEPTH: usize = 8;

fn add<'a>(css: &'a str, on_screen: bool, out: &mut Vec<Rule<'a>>, depth: usize) {
    for block in blocks(css) {
        match block {
            Block::Media { rules, is_met: Some(true), .. } if on_screen && depth < DEPTH => {
                add(rules, on_screen, out, depth + 1);
            }
            Block::Rule { selectors, body } => {
                let properties = parts(body, ';').filter_map(|p| p.split_once(':'));
                let properties: Rc<[_]> = properties.map(|(key, value)| (key.trim(), value.trim())).collect();
                for selector in parts(selectors, ',') {
                    out.extend(steps(selector).map(|steps| Rule { steps, properties: Rc::clone(&properties) }));
                }
            }
            Block::Media { .. } | Block::Other { .. } => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a selector fits the last of these tags, each a name with classes: `svg g.a line`.
    fn fits(selector: &str, path: &str) -> bool {
        let tag = |word: &str| {
            let mut parts = word.split('.').map(str::to_owned);
            Tag { name: parts.next().unwrap(), classes: parts.collect(), ..Tag::default() }
        };
        let path: Vec<Tag> = path.split(' ').map(tag).collect();
        rules(&format!("{selector}{{a:b}}")).iter().any(|rule| rule.fits(&path))
    }

    #[test]
    fn children_and_descendants_are_found_wherever_they_stand() {
        for (selector, path) in [
            ("svg line", "svg g g line"),
            ("svg > g > line", "svg g line"),
            ("g > g.a line", "svg g g.a g g line"),
            (".a > .b .c > .d", "svg.a g.b g.c g.b g.c line.d"),
            ("svg>*>.a", "svg g line.a"),
            (":root > g", "svg g"),
            ("g:not(.a,.b) line", "svg g.a g.c line"),
        ] {
            assert!(fits(selector, path), "{selector} fits {path}");
        }
        for (selector, path) in [
            ("svg > line", "svg g line"),
            ("g > g.a line", "svg g.a g line"),
            (".a > .b .c > .d", "svg.a g.b g.c g.b line.d"),
            ("svg line", "line"),
            ("g:not(.a,.b) line", "svg.a g.a g.b line"),
            ("line + line", "svg line"),
        ] {
            assert!(!fits(selector, path), "{selector} does not fit {path}");
        }
    }
}
