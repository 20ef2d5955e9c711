//! Polygons that overlap, touch, cross each other or themselves, made into a subdivision.
//!
//! ```text
//!        ┌──┐                 ┌──┐            Every side is split where it meets another one. Each face knows the
//!        │B │                 │B │            polygons that cover it:
//!     ┌──┼──┼──┐           ┌──┼──┼──┐
//!     │A │  │  │    ==>    │A │AB│A │           A, B            one of them
//!     └──┼──┼──┘           └──┼──┼──┘           A and B         both
//!        │  │                 │B │              nothing         f0, or a hole face if it is bounded
//!        └──┘                 └──┘
//! ```
//!
//! A ring covers what it goes round an odd number of times (even-odd). A polygon covers what its outer ring covers and
//! none of its inner rings does: an inner ring that sticks out cuts off what lies inside and adds nothing. Where the outer
//! ring goes round nothing at all, there is nothing to cut off from: the inner rings cover what they go round, even-odd.
//!
//! Rounding cannot make the labels contradict each other: every ring stays closed, and whether it goes round a face an
//! odd number of times changes over each of its edges, whatever way one takes.

mod cover;

pub use cover::Cover;

use super::segments::sides_of;
use super::{ArrangeOptions, Arranged, Point, SegmentsError, Subdivision};
use crate::ids::{EdgeId, VertexId, must_be_below};
use crate::topology::PolygonList;
use cover::{Lists, changes_over_edges, hollow};

/// A subdivision made of polygons that do not fit together, and what was done to them.
#[derive(Clone, PartialEq, Debug)]
pub struct Mended {
    /// The subdivision. Bounded faces that no polygon covers are hole faces.
    pub subdivision: Subdivision,
    /// Which polygons cover each face.
    pub cover: Cover,
    /// The vertices made where sides cross and no corner was, in increasing order.
    pub crossings: Vec<VertexId>,
    /// The vertices that could not be kept in place, corners and crossings, each with the distance it moved.
    pub moved: Vec<(VertexId, f64)>,
    /// No point of a side is further from where it is now. 0 if nothing moved.
    pub farthest: f64,
    /// The distance of neighbours of the grid, if points had to be rounded to one; see [`Arranged::grid`].
    pub grid: Option<f64>,
    /// The corners of the input that lay inside a side of a polygon, which was split there, in increasing order.
    pub touching: Vec<VertexId>,
    /// How many pieces of sides were left out because the same polygons, or none, lie on both sides of them: spikes,
    /// rings without area, parts of inner rings outside of the outer one.
    pub left_out: usize,
    /// The polygons whose outer ring goes round nothing, so that their inner rings were taken as outlines.
    pub hollow: Vec<u32>,
    outlines: Lists,
}

impl Mended {
    /// The polygons whose outline runs along an edge, so that they cover just one side of it, in increasing order.
    ///
    /// # Panics
    /// If there is no such edge: `there is no e99: there are 12 edges`.
    #[must_use]
    #[track_caller]
    pub fn outlines(&self, e: EdgeId) -> &[u32] {
        must_be_below(e, e.index(), self.outlines.len());
        self.outlines.of(e.index())
    }
}

impl Subdivision {
    /// Makes a subdivision of polygons whatever they do: overlap, touch inside a side, cross each other or themselves.
    /// Polygon i of the list is called i by [`Mended::cover`].
    ///
    /// All sides are split where they meet, as by [`arrange_graph`](Self::arrange_graph), and numbered as there; sides
    /// that bound nothing are left out. Rings may run either way; corners that repeat the one before are ignored.
    ///
    /// Cost: O((n + k) log n) for n sides with k intersections. Where many sides run along each other, k counts each of them
    /// on each edge.
    ///
    /// # Errors
    /// [`SegmentsError`] if a coordinate cannot be used or there are more elements than ids.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// use dcel_kit::topology::PolygonList;
    /// let points = [(0., 2.), (6., 2.), (6., 4.), (0., 4.), (2., 0.), (4., 0.), (4., 6.), (2., 6.)].map(Point::from);
    /// let mut bars = PolygonList::default();
    /// bars.push_face(&[0, 1, 2, 3]);
    /// bars.push_face(&[4, 5, 6, 7]);
    /// let mended = Subdivision::mend_polygons(&points, &bars)?;
    /// let both: Vec<_> = mended.subdivision.faces().filter(|&f| mended.cover.polygons(f) == [0, 1]).collect();
    /// assert_eq!((mended.crossings.len(), mended.subdivision.face_count(), both.len()), (4, 6, 1));
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    pub fn mend_polygons(points: &[Point], polygons: &PolygonList) -> Result<Mended, SegmentsError> {
        let sides = || (0..polygons.cycle_count()).flat_map(|cycle| sides_of(polygons.cycle(cycle)));
        let segments: Vec<[u32; 2]> = sides().collect();
        let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
        let arranged = Self::arrange_graph(points, &segments, &options)?;
        let s = &arranged.subdivision;
        let rings = rings_along(&arranged, polygons);
        let hollow = hollow(polygons, &rings);
        let changes = changes_over_edges(s, polygons, &rings, &hollow);
        let hollow = (0..polygons.face_count() as u32).filter(|&p| hollow[p as usize]).collect();
        let kept: Vec<EdgeId> = s.dcel.edges().filter(|e| !changes.of(e.index()).is_empty()).collect();
        let mut used = vec![false; s.dcel.vertex_bound()];
        kept.iter().flat_map(|&e| s.edge_ends(e)).for_each(|v| used[v.index()] = true);

        let touching = touching(&arranged, &segments);
        let Arranged { subdivision, crossings, mut moved, displaced, farthest, grid, .. } = arranged;
        moved.extend(displaced);
        let left_out = subdivision.dcel.edge_count() - kept.len();
        let cover = Cover::default();
        let outlines = changes;
        let mut mended =
            Mended { subdivision, cover, crossings, moved, farthest, grid, touching, left_out, hollow, outlines };
        if left_out > 0 || used.contains(&false) {
            let numbers = mended.keep(&kept, &used)?;
            mended.renumber(&numbers);
            mended.outlines = mended.outlines.chosen(kept.iter().map(|e| e.index()));
        }
        mended.cover = Cover::new(&mended.subdivision, &mended.outlines);
        let uncovered: Vec<_> = mended.cover.uncovered().filter(|&f| f != mended.subdivision.outer_face()).collect();
        mended.subdivision.holes.extend(uncovered);
        Ok(mended)
    }
}

impl Mended {
    /// Leaves only these edges and vertices; returns the new number of each vertex.
    fn keep(&mut self, kept: &[EdgeId], used: &[bool]) -> Result<Vec<Option<VertexId>>, SegmentsError> {
        let s = &self.subdivision;
        let (mut numbers, mut points) = (vec![None; used.len()], Vec::new());
        for v in s.dcel.vertices().filter(|v| used[v.index()]) {
            numbers[v.index()] = Some(VertexId::new(points.len() as u32));
            points.push(s.points[v]);
        }
        let number = |v: VertexId| numbers[v.index()].map_or(0, VertexId::number);
        let ends: Vec<[u32; 2]> = kept.iter().map(|&e| s.edge_ends(e).map(number)).collect();
        self.subdivision = Subdivision::from_graph(&points, &ends)?;
        Ok(numbers)
    }

    fn renumber(&mut self, numbers: &[Option<VertexId>]) {
        let new = |v: &VertexId| numbers[v.index()];
        self.crossings = self.crossings.iter().filter_map(new).collect();
        self.touching = self.touching.iter().filter_map(new).collect();
        self.moved = self.moved.iter().filter_map(|(v, by)| Some((new(v)?, *by))).collect();
    }
}

/// The rings along each edge, those that run along it an even number of times left out: in increasing order.
fn rings_along(arranged: &Arranged, polygons: &PolygonList) -> Lists {
    let mut ring_of = Vec::with_capacity(polygons.corner_count());
    for ring in 0..polygons.cycle_count() {
        ring_of.extend(polygons.cycle(ring).iter().map(|_| ring as u32));
    }
    let along = arranged.segments_along();
    let mut lists = Lists::default();
    for e in arranged.subdivision.dcel.edges() {
        let ring = |side: &u32| ring_of[*side as usize];
        for same in along.of(e).chunk_by(|a, b| ring(a) == ring(b)) {
            if same.len() % 2 == 1 {
                lists.push(ring(&same[0]));
            }
        }
        lists.end();
    }
    lists
}

/// The given points that lie inside a side.
fn touching(arranged: &Arranged, segments: &[[u32; 2]]) -> Vec<VertexId> {
    let mut given = vec![false; arranged.subdivision.dcel.vertex_bound()];
    segments.as_flattened().iter().for_each(|&p| given[arranged.vertices[p as usize].index()] = true);
    let inner = (0..segments.len()).flat_map(|i| arranged.chain(i).iter().skip(1));
    let mut touching: Vec<VertexId> =
        inner.map(|&h| arranged.subdivision.dcel.origin(h)).filter(|v| given[v.index()]).collect();
    touching.sort_unstable();
    touching.dedup();
    touching
}
