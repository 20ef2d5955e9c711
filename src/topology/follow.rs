//! Data of users that follow a structure while it is edited and renumbered.
//!
//! ```text
//!   an edit:    new f7 ──> colours[f7] = the first value         removed f3 ──> colours[f3] = the first value
//!   compact():  f7 is f3 now ──> colours.renumbered(&map)
//! ```

use super::pool::Renumbering;
use super::record::{Change, Recorder};
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, Id, IdMap, VertexId};
use std::ops::{Index, IndexMut};

/// Ids that a [`Renumbering`] knows, and that come and go with elements.
pub trait Follows: Id {
    /// The new id; `None` if the element was removed.
    fn renumbered(self, map: &Renumbering) -> Option<Self>;

    /// The ids of this kind that come and go with an element: an edge brings two half-edges.
    fn of(element: Element) -> impl Iterator<Item = Self>;
}

macro_rules! follows {
    ($id:ty, $column:ident) => {
        impl Follows for $id {
            fn renumbered(self, map: &Renumbering) -> Option<Self> {
                map.$column.get(self).copied().flatten()
            }

            fn of(element: Element) -> impl Iterator<Item = Self> {
                Self::from_element(element).into_iter()
            }
        }
    };
}

follows!(VertexId, vertices);
follows!(EdgeId, edges);
follows!(FaceId, faces);

impl Follows for HalfEdgeId {
    fn renumbered(self, map: &Renumbering) -> Option<Self> {
        (self.edge().index() < map.edges.len()).then(|| map.half_edge(self)).flatten()
    }

    fn of(element: Element) -> impl Iterator<Item = Self> {
        EdgeId::from_element(element).into_iter().flat_map(EdgeId::half_edges)
    }
}

impl<I: Follows, T: Default> IdMap<I, T> {
    /// The values under the new ids, after `compact()`. Values of removed elements are dropped; elements that had none
    /// get the default one. O(values).
    ///
    /// ```
    /// use dcel_kit::{FaceId, FaceMap, HalfEdgeId, plane::Subdivision};
    /// let mut lab = Subdivision::lab_rectangle();
    /// let (a, cut_off) = lab.split_face(HalfEdgeId::new(2), HalfEdgeId::new(8))?;
    /// let mut names = FaceMap::filled(lab.face_bound(), "");
    /// names[cut_off] = "kitchen";
    /// lab.join_faces(a.twin())?; // f1 goes
    /// let map = lab.compact();
    /// assert_eq!(names.renumbered(&map)[FaceId::new(1)], "kitchen");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn renumbered(self, map: &Renumbering) -> Self {
        moved(self, map, T::default)
    }
}

fn moved<I: Follows, T>(values: IdMap<I, T>, map: &Renumbering, filler: impl Fn() -> T) -> IdMap<I, T> {
    let mut new: Vec<T> = Vec::with_capacity(values.len());
    for (i, value) in values.into_vec().into_iter().enumerate() {
        if let Some(id) = I::from_index(i).renumbered(map) {
            if id.index() >= new.len() {
                new.resize_with(id.index() + 1, &filler);
            }
            new[id.index()] = value;
        }
    }
    new.into()
}

/// A value for each element of a kind that follows the edits of a structure: hand it to an edit as its recorder. A new
/// element gets the first value; a removed one loses its own. Taking edits back is not told to it: keep a copy for that.
///
/// ```
/// use dcel_kit::{FaceId, HalfEdgeId, plane::{PlaneJournal, Subdivision}, topology::Followed};
/// let mut lab = Subdivision::lab_rectangle();
/// let mut colours: Followed<FaceId, &str> = Followed::new("white");
/// colours[FaceId::new(1)] = "red";
/// let mut journal = PlaneJournal::new();
/// let [h2, h8] = [2, 8].map(HalfEdgeId::new);
/// let (_, new) = lab.split_face_with(h2, h8, &mut (&mut colours, &mut journal))?; // two recorders at once
/// colours[new] = "blue";
/// lab.join_faces_with(lab.half_edge(new).unwrap().twin(), &mut colours)?;
/// assert_eq!((colours[FaceId::new(1)], colours[new]), ("white", "blue"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Followed<I, T> {
    values: IdMap<I, T>,
    first: T,
}

impl<I: Follows, T: Clone> Followed<I, T> {
    /// The same value for all elements.
    #[must_use]
    pub fn new(first: T) -> Self {
        Self { values: IdMap::default(), first }
    }

    /// Follows a structure that was compacted. O(values).
    pub fn renumber(&mut self, map: &Renumbering) {
        let values = std::mem::take(&mut self.values);
        self.values = moved(values, map, || self.first.clone());
    }
}

impl<I: Follows, T> Index<I> for Followed<I, T> {
    type Output = T;

    fn index(&self, id: I) -> &T {
        self.values.get(id).unwrap_or(&self.first)
    }
}

impl<I: Follows, T: Clone> IndexMut<I> for Followed<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        if id.index() >= self.values.len() {
            self.values.set(id, self.first.clone(), self.first.clone());
        }
        &mut self.values[id]
    }
}

impl<I: Follows, T: Clone> Recorder for Followed<I, T> {
    fn record(&mut self, change: Change) {
        if let Change::Added { element, .. } | Change::Removed { element } = change {
            for id in I::of(element) {
                if id.index() < self.values.len() {
                    self.values[id] = self.first.clone();
                }
            }
        }
    }
}

/// Two recorders at once.
impl<A: Recorder, B: Recorder> Recorder for (A, B) {
    fn step(&mut self, number: u32, what: &'static str) {
        self.0.step(number, what);
        self.1.step(number, what);
    }

    fn record(&mut self, change: Change) {
        self.0.record(change);
        self.1.record(change);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::Dcel;

    #[test]
    fn both_half_edges_of_a_removed_edge_lose_their_values() {
        let side = HalfEdgeId(0);
        let mut square = Dcel::polygon(4).unwrap();
        let (diagonal, _) = square.split_face(side, HalfEdgeId(4)).unwrap();
        let halves = [diagonal, diagonal.twin(), side];
        let mut marks = Followed::new(0);
        halves.iter().for_each(|&h| marks[h] = 1);
        square.join_faces_with(diagonal, &mut marks).unwrap();
        assert_eq!(halves.map(|h| marks[h]), [0, 0, 1]);
    }
}
