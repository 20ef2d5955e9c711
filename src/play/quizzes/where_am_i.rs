//! Where am I? A half-edge and some links: which half-edge do they lead to?

use super::structures::random;
use super::{Dice, Verdict};
use crate::ids::Element;
use crate::play::walk::walk;
use crate::topology::{Table, View};

/// A path in a structure.
#[derive(Clone, Debug)]
pub(super) struct WhereAmI {
    pub(super) table: Table,
    path: String,
    walked: Vec<Element>,
}

impl WhereAmI {
    pub(super) fn new(dice: &mut Dice, level: u32) -> Self {
        let (splits, links) = match level {
            1 => (2, 2 + dice.below(2)),
            2 => (4, 4 + dice.below(2)),
            _ => (6, 6 + dice.below(3)),
        };
        let s = random(dice, splits);
        let table = Table::from_planar_view(&s);
        let starts: Vec<_> = s.half_edges().collect();
        let mut path = dice.pick(&starts).map_or_else(|| "h0".to_owned(), ToString::to_string);
        let mut last = "";
        let words = if level == 1 { &["next", "twin"][..] } else { &["next", "twin", "prev"][..] };
        for _ in 0..links {
            // Nobody walks back at once.
            let undoes = |word: &str| matches!((last, word), ("twin", "twin") | ("next", "prev") | ("prev", "next"));
            let words: Vec<&str> = words.iter().copied().filter(|word| !undoes(word)).collect();
            let word = dice.pick(&words).copied().unwrap_or("next");
            path.push('.');
            path.push_str(word);
            last = word;
        }
        let walked = walk(&table, &path).unwrap_or_default();
        Self { table, path, walked }
    }

    pub(super) fn text(&self) -> String {
        let start = self.walked.first().map_or_else(String::new, ToString::to_string);
        let links: Vec<&str> = self.path.split('.').skip(1).collect();
        format!("You stand on {start}. Follow {}. Where are you now? Click the half-edge.", links.join(", then "))
    }

    /// What the path begins with.
    pub(super) fn start(&self) -> Option<Element> {
        self.walked.first().copied()
    }

    pub(super) fn answer(&self, answer: &str) -> Result<Verdict, String> {
        let given: crate::ids::HalfEdgeId =
            answer.parse().map_err(|_| "click a half-edge, or write its name".to_owned())?;
        if !self.table.has_half_edge(given) {
            return Err(format!("there is no {given}"));
        }
        let end = self.walked.last().copied();
        let right = end == Some(given.into());
        let way: Vec<String> = self.walked.iter().map(ToString::to_string).collect();
        let told = way.join(" → ");
        let text = if right { format!("right: {told}") } else { format!("not {given}; the way is {told}") };
        Ok(Verdict { right, over: true, text, trail: self.walked.clone() })
    }
}
