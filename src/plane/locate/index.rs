//! An index of a subdivision that does not change, for very many points.
//!
//! ```text
//!   ┌───┬───┬───┬───┐     A grid with about one cell for each edge. A query looks at the few edges of one cell:
//!   │ ╱ │ ──┼─╲ │   │     O(1) where edges are spread like points of a random set, O(log k) in a cell that k edges
//!   ├───┼───┼──╲┼───┤     crowd into (a star, a city on a map of a country). Edges that are long against the cells
//!   │ ──┼───┼──┐│ · │     make the cells larger, so that all lists together stay O(n).
//!   └───┴───┴──┴┴───┘
//! ```

use super::{Cells, Lines, Location};
use crate::geometry::grouping::grouped;
use crate::geometry::threads::pieces;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};
use crate::progress::Stage;
use std::borrow::Borrow;

/// The fewest points of a batch that are put in order together. Measured: a million points in one order take 2.6 times
/// as long as one by one where the subdivision has 10^4 triangles, for points and answers leave the cache; blocks of 10^4
/// points take as long, and where it has 10^6 triangles, 0.7 of it.
const SMALL_BLOCK: usize = 8_192;
/// The most: blocks of 10^5 points take 0.4 of it there, more do not gain.
const LARGE_BLOCK: usize = 131_072;

/// Point location in a subdivision that does not change.
///
/// It holds the subdivision or a reference to it, whichever it is made with: `PointIndex::new(&s)`,
/// `PointIndex::new(s)`, `PointIndex::new(Arc::clone(&s))`.
///
/// ```
/// use dcel_kit::plane::{Location, Point, PointIndex, Subdivision};
/// let s = Subdivision::lab_rectangle();
/// let index = PointIndex::new(&s);
/// let points = [Point::new(10.0, 20.0), Point::new(0.0, -150.0), Point::new(9000.0, 0.0)];
/// let answers: Vec<String> = index.locate_all(&points).iter().map(Location::to_string).collect();
/// assert_eq!(answers, ["f1", "v1", "f0"]);
/// assert_eq!(index.locate(points[0]), s.locate(points[0]));
/// ```
#[derive(Clone, Debug)]
pub struct PointIndex<S = Subdivision> {
    subdivision: S,
    cells: Cells,
}

impl Lines for Subdivision {
    #[inline]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.dcel.origin(h)
    }
    #[inline]
    fn point(&self, v: VertexId) -> Point {
        self.points[v]
    }
    #[inline]
    fn face(&self, h: HalfEdgeId) -> FaceId {
        self.dcel.face(h)
    }
}

impl<S: Borrow<Subdivision>> PointIndex<S> {
    /// The index of a subdivision, with one cell for each edge.
    ///
    /// Cost: O(n) where edges are spread evenly, O(n log^2 n) at worst. About 22 bytes for each edge of a random
    /// triangulation, at worst O(n log n).
    #[must_use]
    pub fn new(subdivision: S) -> Self {
        Self::with_density(subdivision, 1.0)
    }

    /// The index with `density` cells for each edge, between 1/16 and 16: more cells are quicker to ask and take
    /// more memory. With 1/4 it takes half of what it takes with 1, and points of a batch are found nearly as quickly.
    #[must_use]
    pub fn with_density(subdivision: S, density: f64) -> Self {
        let cells = cells(subdivision.borrow(), density);
        Self { subdivision, cells }
    }

    /// The subdivision.
    #[must_use]
    pub fn subdivision(&self) -> &Subdivision {
        self.subdivision.borrow()
    }

    /// Where the point lies: the same answer as [`Subdivision::locate`].
    ///
    /// Cost: exact; expected O(1) for edges spread like a random triangulation, never more than
    /// [`worst_case`](Self::worst_case) edges, which is O(log n).
    #[must_use]
    #[inline]
    pub fn locate(&self, p: Point) -> Location {
        self.cells.locate(self.subdivision.borrow(), p)
    }

    /// Where each of the points lies, in their order. They are asked cell by cell, so that neighbours find the
    /// structure in the cache, in blocks that stay in the cache themselves: faster than one by one in a large
    /// subdivision. With the feature `parallel` threads share the blocks.
    ///
    /// Cost: O(k) for the order of k points, O(k log k) for few of them, and the queries.
    #[must_use]
    pub fn locate_all(&self, points: &[Point]) -> Vec<Location> {
        let mut answers = vec![Location::Face(self.subdivision().outer_face()); points.len()];
        let block = self.cells.count().clamp(SMALL_BLOCK, LARGE_BLOCK);
        let (s, cells) = (self.subdivision(), &self.cells);
        let stage = Stage::new("locating", points.len());
        pieces(&mut answers, block, |first, answers| {
            locate_block(s, cells, &points[first..first + answers.len()], answers);
            stage.add(answers.len());
        });
        answers
    }

    /// The number of cells.
    #[must_use]
    pub fn cell_count(&self) -> usize {
        self.cells.count()
    }

    /// The most edges that any query looks at: those of the fullest cell with a list, or the depth of the deepest
    /// tree of a crowded cell and of its searches.
    #[must_use]
    pub fn worst_case(&self) -> usize {
        self.cells.worst_case()
    }

    /// The bytes of the index, without the subdivision.
    #[must_use]
    pub fn memory_bytes(&self) -> usize {
        self.cells.memory_bytes()
    }
}

/// Asks for the points in the order of their cells.
fn locate_block(s: &Subdivision, cells: &Cells, points: &[Point], answers: &mut [Location]) {
    let cell = |i: usize| cells.cell_of(points[i]);
    let order = if points.len() < cells.count() / 8 {
        let mut few: Vec<u32> = (0..points.len() as u32).collect();
        few.sort_by_cached_key(|&i| cell(i as usize));
        few
    } else {
        grouped(cells.count() + 1, points.len(), cell).1
    };
    for i in order {
        answers[i as usize] = cells.locate(s, points[i as usize]);
    }
}

fn cells(s: &Subdivision, density: f64) -> Cells {
    let edges = s.dcel.edges().map(|e| e.half_edges()[0]);
    let isolated = s.dcel.vertices().filter(|&v| s.dcel.outgoing(v).is_none());
    let density = if density.is_nan() { 1.0 } else { density.clamp(1.0 / 16.0, 16.0) };
    Cells::new(s, edges, isolated, s.outer_face(), density)
}
