//! What can be said of a test, and what to do next.

use serde::{Deserialize, Serialize};

dcel_kit::named! {
    /// What came of a graded test, or of a whole submission. The order is from best to worst news for its author.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Verdict {
        /// Every case was answered completely and rightly.
        Passed = "passed",
        /// The student's code says `todo!()` there.
        Unattempted = "unattempted",
        /// A test that this one builds on did not pass.
        Skipped = "skipped",
        /// The program ran and a promise was broken.
        Wrong = "wrong",
        /// The answers are right, but the code looks at everything where a few records would do.
        TooSlow = "too slow: looks at everything",
        /// A panic in the student's code, a stack overflow, an abort.
        Crashed = "crashed",
        /// A call read far more records than there are: a walk that never comes back to where it began.
        DoesNotComeBack = "walk does not come back",
        /// The deadline passed before the answer was complete.
        TimedOut = "timed out",
        /// The memory limit was reached.
        OutOfMemory = "out of memory",
        /// The file holds a construct that the lab forbids.
        Refused = "refused",
        /// The compiler rejects the file.
        DoesNotCompile = "does not compile",
        /// The grader or the machine failed; never the student's loss.
        #[default]
        GraderFault = "grader fault",
    }

    /// The verdict in words, as reports print it.
    fn word as Display;
    /// All verdicts, in their order.
    const ALL;
}

impl Verdict {
    /// What the student should do next, as a sentence.
    #[must_use]
    pub fn next_action(self) -> &'static str {
        match self {
            Self::Passed => "Nothing is left to do here.",
            Self::Unattempted => "Replace the todo!() by your code.",
            Self::Skipped => "Make the test that it builds on pass first.",
            Self::Wrong => "Read the first finding, look at the picture if there is one, then replay the case.",
            Self::Crashed => "Go to the line of the panic; replay the script to get there.",
            Self::TooSlow => {
                "Reach what you need from the element that you are given, by its references; where a loop has to look at \
                 everything, see that it ends."
            }
            Self::DoesNotComeBack => {
                "Go to the loop at that line: ask what ends it, and whether the references that it follows lead there."
            }
            Self::TimedOut => "Look for a loop that never ends, or for one that searches a whole list each time round.",
            Self::OutOfMemory => "Look for a list that grows in a loop which never ends.",
            Self::Refused => {
                "Take out what is named, or hand in what is missing; the lab needs nothing beyond ordinary code."
            }
            Self::DoesNotCompile => "Run `cargo build` and mend the first error.",
            Self::GraderFault => "This is not your fault: tell your instructor, with this report.",
        }
    }

    /// Whether the code was run and something is wrong with it, so that there are findings to show.
    #[must_use]
    pub fn is_failure(self) -> bool {
        use Verdict::{Crashed, DoesNotComeBack, OutOfMemory, TimedOut, TooSlow, Wrong};
        matches!(self, Wrong | TooSlow | Crashed | DoesNotComeBack | TimedOut | OutOfMemory)
    }

    /// Whether the points are earned.
    #[must_use]
    pub fn is_passed(self) -> bool {
        self == Self::Passed
    }
}

#[cfg(test)]
mod tests {
    use super::Verdict;

    #[test]
    fn verdicts_are_told_apart_by_word_and_by_what_to_do() {
        for (i, a) in Verdict::ALL.iter().enumerate() {
            for b in &Verdict::ALL[..i] {
                assert!(b < a, "{b} comes before {a}");
                assert_ne!(a.word(), b.word());
                assert_ne!(a.next_action(), b.next_action());
            }
        }
    }
}
