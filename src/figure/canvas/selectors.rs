//! Style rules and which elements they fit.
//!
//! ```text
//!   #x .a.b text{fill:red}        fits  <svg id="x"> <g class="a b"> ... <text>
//!    └ steps, outermost first
//! ```
//!
//! Understood are selectors of ids, classes and element names with descendants; rules with anything else
//! (`:hover`) and rules inside `@media` have no say. Rules win by specificity, then by order.

use std::rc::Rc;

/// `#x .a.b text` as its steps, outermost first.
pub(crate) struct Rule<'a> {
    steps: Vec<Step<'a>>,
    /// Shared by the selectors of one rule.
    pub(crate) properties: Rc<[(&'a str, &'a str)]>,
}

/// What one step of a selector asks for.
#[derive(Default)]
struct Step<'a> {
    name: Option<&'a str>,
    id: Option<&'a str>,
    classes: Vec<&'a str>,
}

/// What an element offers.
pub(crate) struct Tag {
    pub(crate) name: String,
    pub(crate) id: Option<String>,
    pub(crate) classes: Vec<String>,
}

impl Rule<'_> {
    /// Ids, classes, names.
    fn specificity(&self) -> (usize, usize, usize) {
        self.steps.iter().fold((0, 0, 0), |(ids, classes, names), step| {
            (
                ids + usize::from(step.id.is_some()),
                classes + step.classes.len(),
                names + usize::from(step.name.is_some()),
            )
        })
    }

    /// Whether the last step fits the last tag, and the others fit tags around it in their order.
    pub(crate) fn fits(&self, path: &[Tag]) -> bool {
        let (Some((last, steps)), Some((tag, around))) = (self.steps.split_last(), path.split_last()) else {
            return false;
        };
        let mut around = around.iter().rev();
        last.fits(tag) && steps.iter().rev().all(|step| around.any(|tag| step.fits(tag)))
    }
}

impl<'a> Step<'a> {
    /// `None` for what is not understood.
    fn read(text: &'a str) -> Option<Self> {
        let mut out = Self::default();
        let starts = text.match_indices(['#', '.']).map(|(i, _)| i);
        let cuts: Vec<usize> = std::iter::once(0).chain(starts.filter(|&i| i > 0)).chain([text.len()]).collect();
        for part in cuts.windows(2).map(|w| &text[w[0]..w[1]]) {
            let word = part.trim_start_matches(['#', '.']);
            if word.is_empty() || !word.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-' || b == b'_') {
                return None;
            }
            match part.as_bytes()[0] {
                b'#' => out.id = Some(word),
                b'.' => out.classes.push(word),
                _ => out.name = Some(word),
            }
        }
        Some(out)
    }

    fn fits(&self, tag: &Tag) -> bool {
        self.name.is_none_or(|name| name == tag.name)
            && self.id.is_none_or(|id| tag.id.as_deref() == Some(id))
            && self.classes.iter().all(|class| tag.classes.iter().any(|c| c == class))
    }
}

/// The rules outside of `@media`, the weakest first.
pub(crate) fn rules(css: &str) -> Vec<Rule<'_>> {
    let mut out = Vec::new();
    let mut rest = css;
    while let Some(open) = rest.find('{') {
        let (selectors, body) = (rest[..open].trim(), &rest[open + 1..]);
        if selectors.starts_with('@') {
            rest = after_block(body);
            continue;
        }
        let close = body.find('}').unwrap_or(body.len());
        let properties = body[..close].split(';').filter_map(|p| p.split_once(':'));
        let properties: Rc<[_]> = properties.map(|(key, value)| (key.trim(), value.trim())).collect();
        for selector in selectors.split(',') {
            let steps: Option<Vec<Step<'_>>> = selector.split_whitespace().map(Step::read).collect();
            out.extend(steps.map(|steps| Rule { steps, properties: Rc::clone(&properties) }));
        }
        rest = body.get(close + 1..).unwrap_or("");
    }
    out.sort_by_key(Rule::specificity);
    out
}

/// Pseudo-classes that say what a reader does: a drawing that lies there unread does not have them.
#[cfg(feature = "compare")]
const OF_READERS: [&str; 6] = ["hover", "focus", "active", "visited", "target", "checked"];

/// The first selector that is not understood, of a rule that hides lines: nobody can tell then what it hides.
#[cfg(feature = "compare")]
pub(crate) fn hides_unseen(css: &str) -> Option<&str> {
    let mut rest = css;
    while let Some(open) = rest.find('{') {
        let (selectors, body) = (rest[..open].trim(), &rest[open + 1..]);
        if let Some(condition) = selectors.strip_prefix("@media") {
            let is_met = condition.split([' ', ',']).all(|word| ["", "all", "screen"].contains(&word));
            let after = after_block(body);
            if is_met && body[..body.len() - after.len()].split(['{', '}', ';']).any(hides) {
                return Some(selectors);
            }
            rest = after;
            continue;
        }
        if selectors.starts_with('@') {
            rest = after_block(body);
            continue;
        }
        let close = body.find('}').unwrap_or(body.len());
        if body[..close].split(';').any(hides) {
            let is_unknown = |selector: &&str| {
                let is_of_readers = OF_READERS.iter().any(|word| selector.contains(word));
                !is_of_readers && selector.split_whitespace().any(|step| Step::read(step).is_none())
            };
            if let Some(selector) = selectors.split(',').find(is_unknown) {
                return Some(selector.trim());
            }
        }
        rest = body.get(close + 1..).unwrap_or("");
    }
    None
}

/// Whether a declaration makes lines invisible, whatever they are.
#[cfg(feature = "compare")]
fn hides(declaration: &str) -> bool {
    let Some((key, value)) = declaration.split_once(':') else { return false };
    let value = value.split('!').next().unwrap_or("").trim();
    let number = || value.trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '%').trim().parse::<f64>();
    match key.trim() {
        "display" | "stroke" => ["none", "transparent"].contains(&value),
        "visibility" => ["hidden", "collapse"].contains(&value),
        "opacity" | "stroke-opacity" | "stroke-width" => number().is_ok_and(|number| number < 0.1),
        "clip-path" | "mask" | "filter" => value != "none",
        _ => false,
    }
}

/// What follows the brace that closes a block.
fn after_block(body: &str) -> &str {
    let mut depth = 1;
    for (i, c) in body.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => continue,
        }
        if depth == 0 {
            return &body[i + 1..];
        }
    }
    ""
}
