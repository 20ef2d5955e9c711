//! A [`Table`] in columns: as it is read from a large file.
//!
//! ```text
//!   h0 origin v0 twin h1 next h2 prev h4 face f1        origin  0 1 1 ...    one word a pointer, 16 bytes a half-edge
//!   h1 origin v1 twin h0 next h5 prev h3 face f0        next    2 5 4 ...    in place of 44; a column of twins only if
//!   h2 origin v1 twin h3 next h4 prev h0 face f1        ...                  one of them is not h ^ 1
//! ```

use super::links::Columns;
use super::table::{FaceRow, HalfEdgeRow, Table, VertexRow};
use super::view::{InnerComponent, View, Words};
use crate::ids::{FaceId, FaceMap, HalfEdgeId, VertexId};
use std::collections::BTreeMap;
#[cfg(feature = "io")]
use std::collections::TryReserveError;

/// The word of a missing pointer.
const NONE: u32 = Columns::NONE;
/// The word of the first column where there is no row. Ids are smaller.
const NO_ROW: u32 = NONE - 1;
/// The coordinates of a vertex without a position: no coordinate is infinite.
#[cfg(feature = "io")]
const NOWHERE: [f64; 2] = [f64::INFINITY; 2];

/// The same as a [`Table`], in less than half of its memory. It holds anything, right or wrong.
///
/// Files are read into it, see `io::ReadOptions::columns`; [`into_table`](Self::into_table) makes rows of it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct TableColumns {
    pub(crate) columns: Columns,
    /// Empty if the twin of every half-edge h that has a row is h ^ 1.
    twin: Vec<u32>,
    pub(crate) positions: Vec<[f64; 2]>,
    pub(crate) details: BTreeMap<u32, FaceDetails>,
    pub(crate) outer_face: Option<FaceId>,
}

/// What few faces have.
#[derive(Clone, PartialEq, Debug, Default)]
pub(crate) struct FaceDetails {
    pub(crate) inner_components: Vec<InnerComponent>,
    pub(crate) hole: bool,
    pub(crate) name: Option<String>,
}

/// The target of a pointer.
fn target(words: &[u32], index: usize) -> Option<u32> {
    words.get(index).copied().filter(|&word| word < NO_ROW)
}

fn has_row(words: &[u32], index: usize) -> bool {
    words.get(index).is_some_and(|&word| word != NO_ROW)
}

impl TableColumns {
    /// Whether every number up to the greatest has a row, and twins are h ^ 1.
    pub(crate) fn has_no_gaps(&self) -> bool {
        let Columns { origin, outgoing, boundary, .. } = &self.columns;
        let is_full = |column: &Vec<u32>| !column.contains(&NO_ROW);
        self.twin.is_empty() && origin.len().is_multiple_of(2) && [origin, outgoing, boundary].into_iter().all(is_full)
    }

    /// x and y of a vertex; `None` if it does not exist or has no position.
    #[must_use]
    pub fn position(&self, v: VertexId) -> Option<[f64; 2]> {
        self.positions.get(v.index()).copied().filter(|[x, _]| x.is_finite())
    }

    /// The names by the numbers that the faces have in a subdivision: there the outer face is `f0`, and the face of that
    /// name has its number.
    #[must_use]
    pub fn names_in_plane(&self) -> FaceMap<Option<String>> {
        let (first, mut names) = (FaceId::new(0), FaceMap::default());
        for (&f, details) in self.details.iter().filter(|(_, details)| details.name.is_some()) {
            let new = match (self.outer_face, FaceId::new(f)) {
                (Some(outer), f) if f == outer => first,
                (Some(outer), f) if f == first => outer,
                (_, f) => f,
            };
            names.set(new, details.name.clone(), None);
        }
        names
    }

    /// Gives back the room that is not used.
    pub(crate) fn shrink_to_fit(&mut self) {
        let Columns { origin, next, prev, face, outgoing, boundary } = &mut self.columns;
        [origin, next, prev, face, outgoing, boundary].into_iter().for_each(Vec::shrink_to_fit);
        self.positions.shrink_to_fit();
    }

    /// The name of a face; `None` if it does not exist or has no name.
    #[must_use]
    pub fn name(&self, f: FaceId) -> Option<&str> {
        self.details.get(&f.number())?.name.as_deref()
    }

    /// The same in rows. O(size).
    #[must_use]
    pub fn into_table(mut self) -> Table {
        let mut table = Table::default();
        self.move_to(&mut table);
        table
    }

    /// Moves the rows; the list of half-edges, the longest, may have its room already.
    fn move_to(&mut self, table: &mut Table) {
        let half_edges = (0..self.half_edge_bound() as u32).map(HalfEdgeId::new);
        table.half_edges.extend(half_edges.map(|h| HalfEdgeRow::of(self, h)));
        let Columns { origin, next, prev, face, .. } = &mut self.columns;
        [origin, next, prev, face, &mut self.twin].into_iter().for_each(|column| *column = Vec::new());
        let vertex =
            |v| self.has_vertex(v).then(|| VertexRow { position: self.position(v), outgoing: self.outgoing(v) });
        table.vertices.extend((0..self.vertex_bound() as u32).map(VertexId::new).map(vertex));
        for f in (0..self.face_bound() as u32).map(FaceId::new) {
            let details = self.details.remove(&f.number()).unwrap_or_default();
            let FaceDetails { inner_components, hole, name } = details;
            let row = FaceRow { half_edge: self.half_edge(f), inner_components, hole, name };
            table.faces.push(self.has_face(f).then_some(row));
        }
        table.outer_face = self.outer_face;
    }
}

/// For the readers.
#[cfg(feature = "io")]
impl TableColumns {
    /// Sets the row of a vertex.
    ///
    /// # Errors
    /// If there is too little memory.
    #[inline]
    pub(crate) fn set_vertex(&mut self, v: VertexId, row: VertexRow) -> Result<(), TryReserveError> {
        put(&mut self.positions, v.index(), row.position.unwrap_or(NOWHERE), NOWHERE)?;
        put(&mut self.columns.outgoing, v.index(), word(row.outgoing.map(HalfEdgeId::number)), NO_ROW)
    }

    /// Sets the row of a half-edge. Each has one.
    ///
    /// # Errors
    /// If there is too little memory.
    #[inline]
    pub(crate) fn set_half_edge(&mut self, h: HalfEdgeId, row: HalfEdgeRow) -> Result<(), TryReserveError> {
        let i = h.index();
        let half_edge = |h: Option<HalfEdgeId>| word(h.map(HalfEdgeId::number));
        if row.twin != Some(h.twin()) || !self.twin.is_empty() {
            self.set_twin(i, half_edge(row.twin))?;
        }
        let Columns { origin, next, prev, face, .. } = &mut self.columns;
        put(origin, i, word(row.origin.map(VertexId::number)), NO_ROW)?;
        put(next, i, half_edge(row.next), NONE)?;
        put(prev, i, half_edge(row.prev), NONE)?;
        put(face, i, word(row.face.map(FaceId::number)), NONE)
    }

    fn set_twin(&mut self, i: usize, twin: u32) -> Result<(), TryReserveError> {
        if self.twin.is_empty() {
            let origin = &self.columns.origin;
            self.twin.try_reserve(origin.len())?;
            self.twin.extend((0..).zip(origin).map(|(h, &word)| if word == NO_ROW { NONE } else { h ^ 1 }));
        }
        put(&mut self.twin, i, twin, NONE)
    }

    /// Sets the row of a face.
    ///
    /// # Errors
    /// If there is too little memory.
    #[inline]
    pub(crate) fn set_face(&mut self, f: FaceId, row: FaceRow) -> Result<(), TryReserveError> {
        let FaceRow { half_edge, inner_components, hole, name } = row;
        if hole || name.is_some() || !inner_components.is_empty() {
            self.details.insert(f.number(), FaceDetails { inner_components, hole, name });
        }
        put(&mut self.columns.boundary, f.index(), word(half_edge.map(HalfEdgeId::number)), NO_ROW)
    }

    /// The positions of the vertices that have one, to be changed. They must stay finite.
    pub(crate) fn positions_mut(&mut self) -> impl Iterator<Item = &mut [f64; 2]> {
        self.positions.iter_mut().filter(|[x, _]| x.is_finite())
    }

    /// The same in rows.
    ///
    /// # Errors
    /// If there is too little memory.
    pub(crate) fn try_into_table(mut self) -> Result<Table, TryReserveError> {
        let mut table = Table::default();
        table.half_edges.try_reserve_exact(self.half_edge_bound())?;
        table.vertices.try_reserve_exact(self.vertex_bound())?;
        table.faces.try_reserve_exact(self.face_bound())?;
        self.move_to(&mut table);
        Ok(table)
    }
}

#[cfg(feature = "io")]
fn word(pointer: Option<u32>) -> u32 {
    pointer.unwrap_or(NONE)
}

/// Sets an item of a column, which becomes as long as that.
#[cfg(feature = "io")]
#[inline]
fn put<T: Copy>(column: &mut Vec<T>, index: usize, item: T, empty: T) -> Result<(), TryReserveError> {
    if column.len() <= index {
        column.try_reserve(index + 1 - column.len())?;
        column.resize(index + 1, empty);
    }
    column[index] = item;
    Ok(())
}

impl View for TableColumns {
    fn vertex_bound(&self) -> usize {
        self.columns.outgoing.len()
    }
    fn half_edge_bound(&self) -> usize {
        self.columns.origin.len()
    }
    fn face_bound(&self) -> usize {
        self.columns.boundary.len()
    }
    fn has_vertex(&self, v: VertexId) -> bool {
        has_row(&self.columns.outgoing, v.index())
    }
    fn has_half_edge(&self, h: HalfEdgeId) -> bool {
        has_row(&self.columns.origin, h.index())
    }
    fn has_face(&self, f: FaceId) -> bool {
        has_row(&self.columns.boundary, f.index())
    }
    fn origin(&self, h: HalfEdgeId) -> Option<VertexId> {
        target(&self.columns.origin, h.index()).map(VertexId::new)
    }
    fn twin(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        if self.twin.is_empty() {
            return self.has_half_edge(h).then(|| h.twin());
        }
        target(&self.twin, h.index()).map(HalfEdgeId::new)
    }
    fn next(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        target(&self.columns.next, h.index()).map(HalfEdgeId::new)
    }
    fn prev(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        target(&self.columns.prev, h.index()).map(HalfEdgeId::new)
    }
    fn face(&self, h: HalfEdgeId) -> Option<FaceId> {
        target(&self.columns.face, h.index()).map(FaceId::new)
    }
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        target(&self.columns.outgoing, v.index()).map(HalfEdgeId::new)
    }
    fn half_edge(&self, f: FaceId) -> Option<HalfEdgeId> {
        target(&self.columns.boundary, f.index()).map(HalfEdgeId::new)
    }
    fn inner_components(&self, f: FaceId) -> &[InnerComponent] {
        self.details.get(&f.number()).map_or(&[], |details| &details.inner_components)
    }
    fn outer_face(&self) -> Option<FaceId> {
        self.outer_face
    }
    fn is_hole(&self, f: FaceId) -> bool {
        self.details.get(&f.number()).is_some_and(|details| details.hole)
    }
    fn words(&self) -> Option<Words<'_>> {
        let twins_are_near = self.twin.is_empty() && self.columns.origin.len().is_multiple_of(2);
        twins_are_near.then(|| self.columns.words())
    }
}
