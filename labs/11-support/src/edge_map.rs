//! The edge map: the number of a half-edge by its two ends. Who goes through all of it is counted.
//!
//! ```text
//!   edges.get(&(a, b))      one look, O(log n)          for (&(a, b), &h) in &edges     a read for each entry
//! ```

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::{HalfEdgeId, VertexId};
use crate::harness::{Record, Records};
use std::collections::BTreeMap;

/// The two ends of a half-edge: its origin, its destination.
pub type Ends = (VertexId, VertexId);

/// Half-edges by their two ends, ordered by the first end. It is used like a `BTreeMap`.
#[derive(Clone, Default)]
pub struct EdgeMap {
    map: BTreeMap<Ends, HalfEdgeId>,
    /// One for each entry of the map: they are there to be counted.
    entries: Records<Entry>,
}

#[derive(Clone)]
struct Entry;

impl Record for Entry {
    const KIND: &'static str = "entry of the edge map";
    const LETTER: char = 'e';
}

impl EdgeMap {
    /// The half-edge with these ends.
    pub fn get(&self, ends: &Ends) -> Option<&HalfEdgeId> {
        self.map.get(ends)
    }

    /// Whether there is a half-edge with these ends.
    pub fn contains_key(&self, ends: &Ends) -> bool {
        self.map.contains_key(ends)
    }

    /// Makes `h` the half-edge with these ends; returns the one that was there before.
    pub fn insert(&mut self, ends: Ends, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let before = self.map.insert(ends, h);
        if before.is_none() {
            self.entries.push(Entry);
        }
        before
    }

    /// Forgets the half-edge with these ends; returns it.
    pub fn remove(&mut self, ends: &Ends) -> Option<HalfEdgeId> {
        let before = self.map.remove(ends);
        if before.is_some() {
            self.entries.pop();
        }
        before
    }

    /// How many half-edges there are.
    pub fn len(&self) -> usize {
        self.map.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.map.is_empty()
    }

    /// The half-edges that start at `v`, with the vertices where they end, in the order of these.
    pub fn from(&self, v: VertexId) -> impl Iterator<Item = (VertexId, HalfEdgeId)> {
        self.map.range((v, 0)..=(v, usize::MAX)).map(|(&(_, to), &h)| (to, h))
    }

    /// All entries, in the order of the ends.
    #[track_caller]
    pub fn iter(&self) -> impl Iterator<Item = (&Ends, &HalfEdgeId)> {
        self.entries.iter().zip(&self.map).map(|(_, entry)| entry)
    }

    /// The ends of all half-edges.
    #[track_caller]
    pub fn keys(&self) -> impl Iterator<Item = &Ends> {
        self.iter().map(|(ends, _)| ends)
    }

    /// All half-edges.
    #[track_caller]
    pub fn values(&self) -> impl Iterator<Item = &HalfEdgeId> {
        self.iter().map(|(_, h)| h)
    }
}

impl<'a> IntoIterator for &'a EdgeMap {
    type Item = (&'a Ends, &'a HalfEdgeId);
    type IntoIter = Box<dyn Iterator<Item = (&'a Ends, &'a HalfEdgeId)> + 'a>;

    #[track_caller]
    fn into_iter(self) -> Self::IntoIter {
        Box::new(self.iter())
    }
}
