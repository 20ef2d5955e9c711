//! The line of each of many things, in little room: what stands in one line after the other is told by its first line.
//!
//! ```text
//!   thing   0  1  2  3 │ 4  5  6        runs of equal steps, each by its first thing, the line of that, and the step
//!   line    5  6  7  8 │ 20 22 24       (0, 5, 1)  (4, 20, 2)
//! ```

/// The line of each of some things in the order of the file. Appending is O(1), asking O(log r) for r runs.
///
/// Takes 12 bytes for each run of equal steps, 6 bytes a thing at worst.
///
/// ```
/// use dcel_kit::io::LineNumbers;
/// let lines: LineNumbers = [5, 6, 7, 8, 20, 22, 24].into_iter().collect();
/// assert_eq!((lines.len(), lines.get(3), lines.get(5), lines.get(7)), (7, Some(8), Some(22), None));
/// ```
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct LineNumbers {
    runs: Vec<Run>,
    count: u32,
}

/// Things whose lines differ by the same step, from each to the next one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Run {
    first: u32,
    line: u32,
    /// Modulo 2³²: any two lines have one.
    step: u32,
}

impl Run {
    fn line_of(self, thing: u32) -> u32 {
        self.line.wrapping_add(self.step.wrapping_mul(thing - self.first))
    }
}

impl LineNumbers {
    /// How many things there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count as usize
    }

    /// Whether there is none, as of formats that have no lines.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The line of a thing, from 1. O(log r).
    #[must_use]
    pub fn get(&self, thing: usize) -> Option<u32> {
        let thing = u32::try_from(thing).ok().filter(|&thing| thing < self.count)?;
        let after = self.runs.partition_point(|run| run.first <= thing);
        Some(self.runs[after - 1].line_of(thing))
    }

    /// All lines in their order. O(number of things).
    pub fn iter(&self) -> impl Iterator<Item = u32> + '_ {
        let ends = self.runs.iter().skip(1).map(|run| run.first).chain([self.count]);
        self.runs.iter().zip(ends).flat_map(|(run, end)| (run.first..end).map(|thing| run.line_of(thing)))
    }

    /// Appends the line of the next thing. O(1) on average.
    #[inline]
    pub fn push(&mut self, line: u32) {
        let thing = self.count;
        self.count += 1;
        match self.runs.last_mut() {
            Some(run) if run.line_of(thing) == line => {}
            // One thing has no step yet.
            Some(run) if thing - run.first == 1 => run.step = line.wrapping_sub(run.line),
            _ => self.runs.push(Run { first: thing, line, step: 1 }),
        }
    }

    /// Room for so many things more, whatever their lines.
    ///
    /// # Errors
    /// If there is not so much memory.
    pub(super) fn try_reserve(&mut self, things: usize) -> Result<(), std::collections::TryReserveError> {
        self.runs.try_reserve(things / 2 + 1)
    }
}

impl Extend<u32> for LineNumbers {
    fn extend<I: IntoIterator<Item = u32>>(&mut self, lines: I) {
        lines.into_iter().for_each(|line| self.push(line));
    }
}

impl FromIterator<u32> for LineNumbers {
    fn from_iter<I: IntoIterator<Item = u32>>(lines: I) -> Self {
        let mut all = Self::default();
        all.extend(lines);
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::next;

    #[test]
    fn every_thing_has_the_line_that_was_told() {
        let mut state = 11;
        let mut below = |bound: u64| (next(&mut state) % bound) as u32;
        for round in 0..500 {
            let steps = 1 + round % 4;
            let mut line = 1;
            let one = |_| {
                line += below(steps);
                if below(30) == 0 { u32::MAX } else { line }
            };
            let count = 60 - round as u32 % 60;
            let told: Vec<u32> = (0..count).map(one).collect();
            let lines: LineNumbers = told.iter().copied().collect();
            assert_eq!(lines.iter().collect::<Vec<_>>(), told, "round {round}");
            let asked: Vec<Option<u32>> = (0..=told.len()).map(|thing| lines.get(thing)).collect();
            let all: Vec<Option<u32>> = told.iter().copied().map(Some).chain([None]).collect();
            assert_eq!(asked, all, "round {round}");
            assert!(lines.runs.len() <= told.len() / 2 + 1, "{told:?}: {:?}", lines.runs);
        }
    }

    #[test]
    fn lines_at_equal_steps_take_one_run() {
        let [each, every_seventh]: [LineNumbers; 2] = [(3..1000).collect(), (4..9000).step_by(7).collect()];
        assert_eq!((each.runs.len(), every_seventh.runs.len()), (1, 1));
        assert_eq!((each.len(), each.get(996), each.get(997)), (997, Some(999), None));
        assert_eq!(every_seventh.get(100), Some(704));
    }
}
