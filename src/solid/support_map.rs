//! Support points without a long climb: the vertices in a good order, and a start near every direction.
//!
//! ```text
//!    +z side of a cube of directions          vertices in the order of a curve that fills space
//!    ┌──┬──┬──┬──┐                            │ v7 │ v3 │ v9 │ ...        positions
//!    │  │ d│  │  │ m cells along a side       │ 0  │ 5  │ 11 │ ...        where the neighbours begin
//!    ├──┼──┼──┼──┤                            └───>│v3 v9 v4 v8 v1│ ...   neighbours of v7, by place
//!    │  │  │  │  │ each knows the answer for
//!    └──┴──┴──┴──┘ its middle: start there    one row of numbers, one of positions near by
//! ```
//!
//! Climbing from a fixed vertex takes about as many steps as the solid has vertices along a meridian, the square root
//! of V; and when the vertices stand in memory in the order in which they came, each step waits for memory several
//! times as soon as the solid outgrows the cache. Here a direction finds its cell by one division, and the answer for
//! the middle of the cell is a few steps away. Answers are those of [`Convex::support`], ties included.
//!
//! Memory: 36 bytes for each vertex, 8 for each edge, half a byte for each vertex for the cells; 8 more for each corner
//! of a face that is not exactly flat, and then 4 for each vertex.

use super::hull::places;
use super::predicates::further;
use super::support::Direction;
use super::{Convex, Polyhedron};
use crate::ids::{FaceId, VertexId, VertexMap};
use std::cmp::Ordering;

/// The vertices of a convex solid, prepared for many questions which of them lies furthest in a direction.
///
/// It holds copies, so that the solid may change or go meanwhile.
///
/// ```
/// use dcel_kit::solid::{Direction, Platonic, Polyhedron};
/// let solid = Polyhedron::platonic(Platonic::Icosahedron);
/// let map = solid.check_convex()?.support_map();
/// let up = Direction::try_from([0.1, 0.2, 3.0])?;
/// assert_eq!(map.support(up), solid.check_convex()?.support(up));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct SupportMap {
    /// By place.
    points: Vec<[f64; 3]>,
    /// By place.
    vertices: Vec<VertexId>,
    /// The place of each vertex; `NONE` for ids without a vertex.
    place: VertexMap<u32>,
    neighbours: Lists,
    /// For each place the bent faces there, each as a list of `corners`; empty if all faces are flat.
    bent_faces: Lists,
    corners: Lists,
    /// Cells along a side of the cube of directions.
    side: u32,
    /// The place of the answer for the middle of each cell.
    starts: Vec<u32>,
}

const NONE: u32 = u32::MAX;

/// Lists of numbers, one after the other: list i is `items[first[i]..first[i + 1]]`.
#[derive(Clone, PartialEq, Debug)]
struct Lists {
    first: Vec<u32>,
    items: Vec<u32>,
}

impl Lists {
    fn new() -> Self {
        Self { first: vec![0], items: Vec::new() }
    }

    /// Ends the list that is being filled.
    fn close(&mut self) {
        self.first.push(self.items.len() as u32);
    }

    #[inline]
    fn get(&self, i: u32) -> &[u32] {
        match self.first.get(i as usize..i as usize + 2) {
            Some(&[start, end]) => &self.items[start as usize..end as usize],
            _ => &[],
        }
    }
}

impl Convex<'_> {
    /// Prepares the solid for many questions. Cost: O(V log V + E).
    #[must_use]
    pub fn support_map(&self) -> SupportMap {
        let solid = self.solid();
        let curve = places(solid.points.as_slice());
        let mut order: Vec<(u32, VertexId)> = solid.vertices().map(|v| (curve(solid.point(v)), v)).collect();
        order.sort_unstable();
        let mut place = VertexMap::filled(solid.vertex_bound(), NONE);
        order.iter().zip(0..).for_each(|(&(_, v), i)| place[v] = i);
        let vertices: Vec<VertexId> = order.iter().map(|&(_, v)| v).collect();
        let mut neighbours = Lists::new();
        for &v in &vertices {
            neighbours.items.extend(solid.adjacent_vertices(v).map(|w| place[w]));
            neighbours.close();
        }
        let (bent_faces, corners) = self.bent_lists(&vertices, &place);
        let points = vertices.iter().map(|&v| solid.point(v)).collect();
        let start = place[self.first];
        let mut map =
            SupportMap { points, vertices, place, neighbours, bent_faces, corners, side: 1, starts: vec![start; 6] };
        map.fill_cells(start);
        map
    }

    /// The bent faces at each vertex, and the corners of each.
    fn bent_lists(&self, vertices: &[VertexId], place: &VertexMap<u32>) -> (Lists, Lists) {
        let (solid, dcel): (&Polyhedron, _) = (self.solid(), self.solid().topology());
        let (mut at, mut corners) = (Lists::new(), Lists::new());
        let bent: Vec<FaceId> = solid.faces().filter(|&f| self.bent[f]).collect();
        if bent.is_empty() {
            return (at, corners);
        }
        for &f in &bent {
            corners.items.extend(solid.incident_vertices(f).map(|v| place[v]));
            corners.close();
        }
        for &v in vertices {
            let faces = dcel.incident_faces(v).filter_map(|f| bent.binary_search(&f).ok());
            at.items.extend(faces.map(|i| i as u32));
            at.close();
        }
        (at, corners)
    }
}

impl SupportMap {
    /// How many vertices share a cell of directions, on average.
    const SHARE: usize = 8;
    /// At most so many cells along a side.
    const MOST: u32 = 1 << 10;

    /// The vertex furthest in `direction`; of equally far ones that with the greatest x, then y, then z. Exact.
    ///
    /// Cost: a few steps, if no part of the solid holds far more vertices than its share of directions.
    #[must_use]
    pub fn support(&self, direction: Direction) -> VertexId {
        self.vertices[self.top(direction, self.starts[self.cell(direction)]) as usize]
    }

    /// The same, from the last answer; a hint that is no vertex is not used. Worth it where directions change by less
    /// than a cell from question to question.
    #[must_use]
    pub fn support_from(&self, direction: Direction, hint: VertexId) -> VertexId {
        match self.place.get(hint) {
            None | Some(&NONE) => self.support(direction),
            Some(&at) => self.vertices[self.top(direction, at) as usize],
        }
    }

    /// The vertices met by [`support`](Self::support), the first and the last included.
    #[must_use]
    pub fn climb(&self, direction: Direction) -> Vec<VertexId> {
        let start = self.starts[self.cell(direction)];
        let places =
            std::iter::successors(Some(start), |&at| Some(self.step(direction, at)).filter(|&best| best != at));
        places.map(|at| self.vertices[at as usize]).collect()
    }

    /// The bytes it takes, apart from what the allocator adds.
    #[must_use]
    pub fn memory(&self) -> usize {
        let lists = [&self.neighbours, &self.bent_faces, &self.corners];
        let numbers: usize = lists.iter().map(|lists| lists.first.len() + lists.items.len()).sum();
        24 * self.points.len() + 4 * (self.vertices.len() + self.place.len() + self.starts.len() + numbers)
    }

    /// The place where no neighbour is better.
    #[inline]
    fn top(&self, direction: Direction, start: u32) -> u32 {
        let mut at = start;
        loop {
            let best = self.step(direction, at);
            if best == at {
                return at;
            }
            at = best;
        }
    }

    /// The best of a place and its neighbours. In a face that is not exactly flat all corners are neighbours.
    #[inline]
    fn step(&self, direction: Direction, at: u32) -> u32 {
        let point = |i: u32| self.points[i as usize];
        let better = |best: u32, &i: &u32| {
            if further(direction.vector(), point(i), point(best)) == Ordering::Greater { i } else { best }
        };
        let best = self.neighbours.get(at).iter().fold(at, better);
        self.bent_faces.get(at).iter().fold(best, |best, &face| self.corners.get(face).iter().fold(best, better))
    }

    /// Finds the answer for the middle of each cell, each from the one beside it.
    fn fill_cells(&mut self, start: u32) {
        let cells = (self.points.len() / (6 * Self::SHARE)) as f64;
        self.side = (cells.sqrt() as u32).clamp(1, Self::MOST);
        let mut at = start;
        let mut starts = Vec::with_capacity(6 * (self.side * self.side) as usize);
        for row in 0..6 * self.side {
            let first = starts.len();
            for column in 0..self.side {
                // To and fro, so that neighbours follow each other.
                let column = if row % 2 == 0 { column } else { self.side - 1 - column };
                at = self.top(self.middle(row / self.side, [column, row % self.side]), at);
                starts.push(at);
            }
            if row % 2 == 1 {
                starts[first..].reverse();
            }
        }
        self.starts = starts;
    }

    /// The direction in the middle of a cell of a side of the cube: sides 0 1 2 look to +x +y +z, 3 4 5 to -x -y -z.
    fn middle(&self, face: u32, cell: [u32; 2]) -> Direction {
        let axis = face as usize % 3;
        let [u, v] = cell.map(|i| f64::from(2 * i + 1) / f64::from(self.side) - 1.0);
        let mut direction = [0.0; 3];
        direction[axis] = if face < 3 { 1.0 } else { -1.0 };
        direction[(axis + 1) % 3] = u;
        direction[(axis + 2) % 3] = v;
        Direction::of_checked(direction)
    }

    /// The cell a direction passes through.
    #[inline]
    fn cell(&self, direction: Direction) -> usize {
        let d = direction.vector();
        let far = d.map(f64::abs);
        let axis = if far[0] >= far[1] && far[0] >= far[2] { 0 } else { 1 + usize::from(far[2] > far[1]) };
        if far[axis] == 0.0 {
            return 0;
        }
        let side = f64::from(self.side);
        // From -1 .. 1 to the cells; the right end belongs to the last one.
        let cell = |x: f64| ((x / far[axis] + 1.0) * 0.5 * side).min(side - 1.0) as usize;
        let face = if d[axis] > 0.0 { axis } else { axis + 3 };
        let (u, v) = (cell(d[(axis + 1) % 3]), cell(d[(axis + 2) % 3]));
        (face * self.side as usize + v) * self.side as usize + u
    }
}
