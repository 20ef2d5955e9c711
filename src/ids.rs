//! Names of the elements: `v3`, `h7`, `e3`, `f0`.
//!
//! ```text
//!            h7 = 2·3 + 1
//!        <────────────────
//!   v1 ●───────── e3 ───────● v2        e3 is the pair (h6, h7):
//!        ────────────────>              twin(h) = h ^ 1, edge(h) = h >> 1
//!            h6 = 2·3
//! ```
//!
//! An id is a plain number with a type. It stays valid until its element is removed, so per-element
//! data lives in dense arrays beside the structure: [`VertexMap`], [`HalfEdgeMap`], [`EdgeMap`], [`FaceMap`].

use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};
use std::str::FromStr;

/// Ids are smaller than this: the records keep one bit and two marks for themselves.
pub const MAX_IDS: usize = 0x7fff_fffe;

/// What every id type can do; the key type of an [`IdMap`].
pub trait Id: Copy + Eq + Ord + fmt::Debug + fmt::Display {
    /// The letter in front of the number.
    const LETTER: char;
    /// The id with number `index`.
    ///
    /// # Panics
    /// If `index` is not below [`MAX_IDS`].
    fn from_index(index: usize) -> Self;
    /// The number as an index of an array.
    fn index(self) -> usize;
}

/// The text is not the name of such an element.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not the name of a {kind}: write {letter} and a number, for example {letter}3")]
pub struct ParseIdError {
    text: String,
    kind: &'static str,
    letter: char,
}

macro_rules! id {
    ($(#[$doc:meta])* $name:ident, $variant:ident, $letter:literal, $kind:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub(crate) u32);

        impl $name {
            /// The element with number `number`, whether or not it exists anywhere.
            #[must_use]
            pub const fn new(number: u32) -> Self {
                Self(number)
            }

            /// The number behind the letter.
            #[must_use]
            pub const fn number(self) -> u32 {
                self.0
            }

            /// The number as an index of an array.
            #[must_use]
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// The id, if the element is of its kind.
            pub(crate) fn from_element(element: Element) -> Option<Self> {
                if let Element::$variant(id) = element { Some(id) } else { None }
            }
        }

        impl Id for $name {
            const LETTER: char = $letter;

            fn from_index(index: usize) -> Self {
                assert!(index < MAX_IDS, "more than {MAX_IDS} elements of one kind");
                Self(index as u32)
            }

            fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }

        impl FromStr for $name {
            type Err = ParseIdError;

            fn from_str(text: &str) -> Result<Self, ParseIdError> {
                text.strip_prefix($letter)
                    .filter(|digits| digits.bytes().all(|b| b.is_ascii_digit()))
                    .and_then(|digits| digits.parse::<u32>().ok())
                    .filter(|&number| (number as usize) < MAX_IDS)
                    .map(Self)
                    .ok_or_else(|| ParseIdError { text: text.to_owned(), kind: $kind, letter: $letter })
            }
        }

        impl From<$name> for Element {
            fn from(id: $name) -> Self {
                Self::$variant(id)
            }
        }
    };
}

id!(
    /// A vertex: `v3`.
    VertexId, Vertex, 'v', "vertex"
);
id!(
    /// A half-edge: `h7`. Its face lies on its left.
    HalfEdgeId, HalfEdge, 'h', "half-edge"
);
id!(
    /// An edge, that is a pair of twin half-edges: `e3` = (`h6`, `h7`).
    EdgeId, Edge, 'e', "edge"
);
id!(
    /// A face: `f0`. In a planar subdivision `f0` is the outer face.
    FaceId, Face, 'f', "face"
);

impl HalfEdgeId {
    /// The other half of the same edge.
    #[must_use]
    pub const fn twin(self) -> Self {
        Self(self.0 ^ 1)
    }

    /// The edge this is one half of.
    #[must_use]
    pub const fn edge(self) -> EdgeId {
        EdgeId(self.0 >> 1)
    }
}

impl EdgeId {
    /// The two halves of the edge, the even one first.
    #[must_use]
    pub const fn half_edges(self) -> [HalfEdgeId; 2] {
        [HalfEdgeId(self.0 << 1), HalfEdgeId(self.0 << 1 | 1)]
    }
}

/// An element of any kind, for messages that may speak of each.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Element {
    /// A vertex.
    Vertex(VertexId),
    /// A half-edge.
    HalfEdge(HalfEdgeId),
    /// An edge.
    Edge(EdgeId),
    /// A face.
    Face(FaceId),
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(v) => v.fmt(f),
            Self::HalfEdge(h) => h.fmt(f),
            Self::Edge(e) => e.fmt(f),
            Self::Face(x) => x.fmt(f),
        }
    }
}

impl Element {
    /// That there is no such element, and what there is: `there is no v99: there are 5 vertices`. Where ids were
    /// removed, the highest one is told, too; `bound` is one more than that.
    #[must_use]
    pub fn missing(self, count: usize, bound: usize) -> String {
        let (letter, one, many) = match self {
            Self::Vertex(_) => ('v', "vertex", "vertices"),
            Self::HalfEdge(_) => ('h', "half-edge", "half-edges"),
            Self::Edge(_) => ('e', "edge", "edges"),
            Self::Face(_) => ('f', "face", "faces"),
        };
        let there = match count {
            0 => format!("there are no {many}"),
            1 => format!("there is 1 {one}, {letter}{}", bound.saturating_sub(1)),
            _ if count == bound => format!("there are {count} {many}"),
            _ => format!("there are {count} {many}, up to {letter}{}", bound.saturating_sub(1)),
        };
        format!("there is no {self}: {there}")
    }
}

/// The panic of a list that reaches from 0 to below `bound`, for an id that it has not: one that names both.
#[inline]
#[track_caller]
pub(crate) fn must_be_below(element: impl Into<Element>, index: usize, bound: usize) {
    #[cold]
    #[inline(never)]
    #[track_caller]
    fn refuse(element: Element, bound: usize) -> ! {
        panic!("{}", element.missing(bound, bound))
    }
    if index >= bound {
        refuse(element.into(), bound);
    }
}

impl fmt::Debug for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// One value per id in a plain array: `map[id]`, O(1), no hashing. An id beyond its end is a panic that names it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct IdMap<I, T> {
    values: Vec<T>,
    key: PhantomData<fn(I) -> I>,
}

/// One value per vertex.
pub type VertexMap<T> = IdMap<VertexId, T>;
/// One value per half-edge.
pub type HalfEdgeMap<T> = IdMap<HalfEdgeId, T>;
/// One value per edge.
pub type EdgeMap<T> = IdMap<EdgeId, T>;
/// One value per face.
pub type FaceMap<T> = IdMap<FaceId, T>;

impl<I, T> Default for IdMap<I, T> {
    fn default() -> Self {
        Self { values: Vec::new(), key: PhantomData }
    }
}

impl<I: Id, T> IdMap<I, T> {
    /// A map with `bound` values, for the ids `0 .. bound`.
    #[must_use]
    pub fn filled(bound: usize, value: T) -> Self
    where
        T: Clone,
    {
        vec![value; bound].into()
    }

    /// The number of ids the map has values for.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether the map has no value at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The value of `id`, if the map reaches that far.
    #[must_use]
    pub fn get(&self, id: I) -> Option<&T> {
        self.values.get(id.index())
    }

    /// Sets the value of `id`, first filling the ids before it with `filler`.
    pub fn set(&mut self, id: I, value: T, filler: T)
    where
        T: Clone,
    {
        if id.index() >= self.values.len() {
            self.values.resize(id.index() + 1, filler);
        }
        self.values[id.index()] = value;
    }

    /// Appends the value of the next id and returns that id.
    pub fn push(&mut self, value: T) -> I {
        let id = I::from_index(self.values.len());
        self.values.push(value);
        id
    }

    /// Forgets the values of the ids from `bound` on.
    pub fn truncate(&mut self, bound: usize) {
        self.values.truncate(bound);
    }

    /// Ids with their values, in the order of the ids.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (I, &T)> + DoubleEndedIterator {
        self.values.iter().enumerate().map(|(i, value)| (I::from_index(i), value))
    }

    /// The values in the order of the ids.
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }

    /// The values in the order of the ids.
    #[must_use]
    pub fn into_vec(self) -> Vec<T> {
        self.values
    }
}

impl<I, T> From<Vec<T>> for IdMap<I, T> {
    fn from(values: Vec<T>) -> Self {
        Self { values, key: PhantomData }
    }
}

impl<I: Id, T> Index<I> for IdMap<I, T> {
    type Output = T;

    #[inline]
    #[track_caller]
    fn index(&self, id: I) -> &T {
        match self.values.get(id.index()) {
            Some(value) => value,
            None => beyond(id, self.values.len()),
        }
    }
}

impl<I: Id, T> IndexMut<I> for IdMap<I, T> {
    #[inline]
    #[track_caller]
    fn index_mut(&mut self, id: I) -> &mut T {
        let len = self.values.len();
        match self.values.get_mut(id.index()) {
            Some(value) => value,
            None => beyond(id, len),
        }
    }
}

/// Ends with the message that a map does not reach as far as an id: `there is no v99: the map holds 5 values, v0 to v4`.
#[cold]
#[inline(never)]
#[track_caller]
fn beyond<I: Id>(id: I, len: usize) -> ! {
    match len.checked_sub(1) {
        None => panic!("there is no {id}: the map is empty"),
        Some(last) => panic!("there is no {id}: the map holds {len} values, {0}0 to {0}{last}", I::LETTER),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip_and_bad_names_are_refused() {
        assert_eq!("h7".parse(), Ok(HalfEdgeId(7)));
        assert_eq!(VertexId(3).to_string(), "v3");
        for text in ["", "h", "7", "v7", "h-1", "h+1", "h 1", "h4294967295", "h2147483646"] {
            assert!(text.parse::<HalfEdgeId>().is_err(), "{text:?} was accepted");
        }
    }

    #[test]
    fn halves_of_an_edge_are_twins() {
        let [a, b] = EdgeId(3).half_edges();
        assert_eq!((a, b), (HalfEdgeId(6), HalfEdgeId(7)));
        assert_eq!((a.twin(), b.twin()), (b, a));
        assert_eq!((a.edge(), b.edge()), (EdgeId(3), EdgeId(3)));
    }
}
