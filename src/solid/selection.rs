//! Marks on elements: eight masks each, by id.
//!
//! ```text
//!   id      f0        f1        f2        f3
//!   mask    00000001  00000010  01000000  00000000      one byte an element, in a plain array beside
//!           bottom    top       side      nothing       the structure; bit 0 of an edge may mean "crease"
//! ```
//!
//! Source: the selection masks and crease flags of the GenMesh article.

use crate::ids::{Id, IdMap};

/// Eight masks for each element of one kind. Elements that were never marked have none set.
///
/// ```
/// use dcel_kit::{FaceId, solid::Selection};
/// let mut selection = Selection::new();
/// selection.add(FaceId::new(4), 0b101);
/// selection.remove(FaceId::new(4), 0b001);
/// assert_eq!((selection.mask(FaceId::new(4)), selection.mask(FaceId::new(99))), (0b100, 0));
/// assert_eq!(selection.ids(0b111).collect::<Vec<_>>(), [FaceId::new(4)]);
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Selection<I> {
    masks: IdMap<I, u8>,
}

impl<I> Default for Selection<I> {
    fn default() -> Self {
        Self { masks: IdMap::default() }
    }
}

impl<I: Id> Selection<I> {
    /// Nothing is marked.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the bits of `mask` for `id`. O(1), but for the growing of the array.
    pub fn add(&mut self, id: I, mask: u8) {
        let all = self.mask(id) | mask;
        self.masks.set(id, all, 0);
    }

    /// Clears the bits of `mask` for `id`. O(1).
    pub fn remove(&mut self, id: I, mask: u8) {
        if id.index() < self.masks.len() {
            self.masks[id] &= !mask;
        }
    }

    /// All bits of `id`. O(1).
    #[must_use]
    #[inline]
    pub fn mask(&self, id: I) -> u8 {
        self.masks.get(id).copied().unwrap_or(0)
    }

    /// Whether any bit of `mask` is set for `id`. O(1).
    #[must_use]
    #[inline]
    pub fn has(&self, id: I, mask: u8) -> bool {
        self.mask(id) & mask != 0
    }

    /// The elements with any bit of `mask`, in the order of their numbers. O(length of the array).
    pub fn ids(&self, mask: u8) -> impl Iterator<Item = I> + '_ {
        self.masks.iter().filter(move |(_, bits)| **bits & mask != 0).map(|(id, _)| id)
    }
}
