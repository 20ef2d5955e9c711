//! A list of records that counts how often it is looked at.
//!
//! ```text
//!   self.half_edges[h].next          one read             self.half_edges.len()        none
//!   self.half_edges[h].face = f      one read             self.half_edges.push(…)      one read
//!   for record in &self.half_edges   one for each record
//! ```
//!
//! It is used like a `Vec`. The counting ends a walk that never comes back, and says in which circle it ran.

use super::reads::{self, Origin};
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};
use std::panic::Location;

/// A kind of record.
pub trait Record {
    /// What it is called in messages: `half-edge`.
    const KIND: &'static str;
    /// What its numbers begin with in a case: `h` for h0, h1, …
    const LETTER: char;
}

/// A list of records. The record with the number 3 is `list[3]`.
pub struct Records<T> {
    items: Vec<T>,
    /// One thread only: the count belongs to the thread that makes the call.
    _one_thread: PhantomData<std::cell::Cell<()>>,
}

impl<T: Record> Records<T> {
    /// An empty list.
    pub fn new() -> Self {
        Self { items: Vec::new(), _one_thread: PhantomData }
    }

    /// How many records there are.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Adds a record. Its number is the length of the list before.
    #[track_caller]
    pub fn push(&mut self, record: T) {
        reads::one(T::LETTER, self.items.len(), Origin::Number, Location::caller());
        self.items.push(record);
    }

    /// Takes the last record away.
    pub fn pop(&mut self) -> Option<T> {
        self.items.pop()
    }

    /// Keeps the first `len` records only.
    pub fn truncate(&mut self, len: usize) {
        self.items.truncate(len);
    }

    /// The record of this number, or `None` if there is none.
    #[track_caller]
    pub fn get(&self, number: usize) -> Option<&T> {
        reads::one(T::LETTER, number, Origin::Number, Location::caller());
        self.items.get(number)
    }

    /// The record of this number, to be changed, or `None` if there is none.
    #[track_caller]
    pub fn get_mut(&mut self, number: usize) -> Option<&mut T> {
        reads::one(T::LETTER, number, Origin::Number, Location::caller());
        self.items.get_mut(number)
    }

    /// The first record.
    #[track_caller]
    pub fn first(&self) -> Option<&T> {
        self.get(0)
    }

    /// The last record.
    #[track_caller]
    pub fn last(&self) -> Option<&T> {
        self.get(self.items.len().wrapping_sub(1))
    }

    /// The last record, to be changed.
    #[track_caller]
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.get_mut(self.items.len().wrapping_sub(1))
    }

    /// All records, in the order of their numbers.
    #[track_caller]
    pub fn iter(&self) -> Iter<'_, T> {
        Iter { items: self.items.iter().enumerate(), place: Location::caller() }
    }

    /// All records, to be changed.
    #[track_caller]
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = &mut T> + DoubleEndedIterator {
        let place = Location::caller();
        self.items.iter_mut().enumerate().map(move |(number, record)| {
            reads::one(T::LETTER, number, Origin::Iterator, place);
            record
        })
    }

    /// There is no such record.
    #[track_caller]
    #[cold]
    fn missing(&self, number: usize) -> ! {
        panic!("there is no {} {number}: there are {}", T::KIND, self.items.len())
    }
}

impl<T: Record> Index<usize> for Records<T> {
    type Output = T;

    #[track_caller]
    fn index(&self, number: usize) -> &T {
        reads::one(T::LETTER, number, Origin::Number, Location::caller());
        match self.items.get(number) {
            Some(record) => record,
            None => self.missing(number),
        }
    }
}

impl<T: Record> IndexMut<usize> for Records<T> {
    #[track_caller]
    fn index_mut(&mut self, number: usize) -> &mut T {
        reads::one(T::LETTER, number, Origin::Number, Location::caller());
        if number >= self.items.len() {
            self.missing(number);
        }
        &mut self.items[number]
    }
}

/// The records of a list, one after the other.
pub struct Iter<'a, T> {
    items: std::iter::Enumerate<std::slice::Iter<'a, T>>,
    place: &'static Location<'static>,
}

impl<'a, T: Record> Iterator for Iter<'a, T> {
    type Item = &'a T;

    fn next(&mut self) -> Option<&'a T> {
        let (number, record) = self.items.next()?;
        reads::one(T::LETTER, number, Origin::Iterator, self.place);
        Some(record)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.items.size_hint()
    }
}

impl<T: Record> DoubleEndedIterator for Iter<'_, T> {
    fn next_back(&mut self) -> Option<Self::Item> {
        let (number, record) = self.items.next_back()?;
        reads::one(T::LETTER, number, Origin::Iterator, self.place);
        Some(record)
    }
}

impl<T: Record> ExactSizeIterator for Iter<'_, T> {}

impl<T> Clone for Iter<'_, T> {
    fn clone(&self) -> Self {
        Self { items: self.items.clone(), place: self.place }
    }
}

impl<'a, T: Record> IntoIterator for &'a Records<T> {
    type Item = &'a T;
    type IntoIter = Iter<'a, T>;

    #[track_caller]
    fn into_iter(self) -> Iter<'a, T> {
        self.iter()
    }
}

impl<T: Record> FromIterator<T> for Records<T> {
    fn from_iter<I: IntoIterator<Item = T>>(records: I) -> Self {
        Self { items: records.into_iter().collect(), _one_thread: PhantomData }
    }
}

impl<T: Record> Extend<T> for Records<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, records: I) {
        records.into_iter().for_each(|record| self.push(record));
    }
}

impl<T: Record> Default for Records<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Record + Clone> Clone for Records<T> {
    #[track_caller]
    fn clone(&self) -> Self {
        reads::many(T::LETTER, self.items.len(), Location::caller());
        Self { items: self.items.clone(), _one_thread: PhantomData }
    }
}

impl<T: Record + PartialEq> PartialEq for Records<T> {
    #[track_caller]
    fn eq(&self, other: &Self) -> bool {
        reads::many(T::LETTER, self.items.len(), Location::caller());
        self.items == other.items
    }
}

impl<T: Record + std::fmt::Debug> std::fmt::Debug for Records<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        reads::many(T::LETTER, self.items.len(), Location::caller());
        f.debug_list().entries(&self.items).finish()
    }
}
