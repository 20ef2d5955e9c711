//! The words in which a judge says what holds of a call, as bits of a set.

use super::judge::Feature;

/// Declares the features of a lab: an enum of their names and the vocabulary, in the order in which a reader would
/// rather hear them. There may be 128.
///
/// ```
/// dcel_lab::features! {
///     Outer "outer" "the face is the outer one",
///     Many "many" "the face has more than 8 half-edges",
/// }
/// let mut set = dcel_lab::FeatureSet::default();
/// set.add(Word::Many, true);
/// assert_eq!((set.bits(), VOCABULARY[1].id), (0b10, "many"));
/// ```
#[macro_export]
macro_rules! features {
    ($($name:ident $id:literal $clause:literal,)*) => {
        /// A feature, by its bit.
        #[derive(Clone, Copy)]
        #[repr(u32)]
        enum Word { $($name,)* }

        impl From<Word> for u32 {
            fn from(word: Word) -> Self {
                word as Self
            }
        }

        /// All features, those that a reader would rather hear first.
        pub(crate) static VOCABULARY: &[$crate::judge::Feature] = &[$($crate::judge::Feature { id: $id, clause: $clause },)*];

        const _: () = assert!(VOCABULARY.len() <= 128, "a set has 128 bits");
    };
}

/// The parts of a [`Judge`](crate::judge::Judge) that say what holds of calls, by the module that declares the
/// [`features!`](crate::features) of the lab: its `of` says which of them hold of a call, and of the calls before it.
#[macro_export]
macro_rules! features_of {
    ($module:ident) => {
        fn vocabulary(&self) -> &'static [$crate::judge::Feature] {
            $module::VOCABULARY
        }

        fn features(&self, earlier: &[&$crate::fault::Exchange], exchange: &$crate::fault::Exchange) -> Option<u128> {
            $module::of(earlier, exchange)
        }
    };
}

/// A set of features.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FeatureSet(u128);

impl FeatureSet {
    /// Adds a feature if it holds.
    pub fn add(&mut self, bit: impl Into<u32>, holds: bool) {
        self.0 |= u128::from(holds) << bit.into();
    }

    /// Adds one feature or the other.
    pub fn either(&mut self, yes: impl Into<u32>, no: impl Into<u32>, holds: bool) {
        self.add(yes, holds);
        self.add(no, !holds);
    }

    /// Adds each feature of the vocabulary whose number is passed: `face_8_more` of the ids `face_N_more` if there are
    /// more than 8. A value of the enumeration that nothing else names begins with `_`.
    pub fn more(&mut self, vocabulary: &[Feature], ids: &str, count: usize) {
        let (before, after) = ids.split_once('N').unwrap_or((ids, ""));
        let mut known = 0;
        for (bit, feature) in (0_u32..).zip(vocabulary) {
            let than = feature.id.strip_prefix(before).and_then(|rest| rest.strip_suffix(after)?.parse::<usize>().ok());
            known += usize::from(than.is_some());
            self.add(bit, than.is_some_and(|than| count > than));
        }
        debug_assert!(known > 0, "no feature has an id such as {ids}");
    }

    /// The set, bit i for feature i of the vocabulary.
    #[must_use]
    pub fn bits(self) -> u128 {
        self.0
    }

    /// Whether a feature of the vocabulary is in it, by its id.
    #[must_use]
    pub fn has(self, vocabulary: &[Feature], id: &str) -> bool {
        vocabulary.iter().position(|feature| feature.id == id).is_some_and(|bit| self.0 >> bit & 1 == 1)
    }
}
