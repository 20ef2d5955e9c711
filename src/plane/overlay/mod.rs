//! Two subdivisions laid over each other.
//!
//! ```text
//!      a            b            overlay: every face knows the face of a and the face of b that it is part of
//!   ┌─────┐                       ┌─────┐
//!   │ f1  │      ┌─────┐          │ 1,0 │               outside   0,0
//!   │     │  +   │ f1  │    =     │  ┌──┼──┐            union     1,0  1,1  0,1
//!   └─────┘      │     │          └──┼──┘  │            common    1,1
//!                └─────┘             │ 0,1 │            a - b     1,0
//!                                    └─────┘            either    1,0  0,1
//! ```
//!
//! The edges of both are arranged by the splitter of [`arrange_graph`](Subdivision::arrange_graph), with its precision:
//! what meets is decided exactly, the vertices of both stay where they are, crossings become vertices at the nearest
//! doubles. Labels are then carried from face to face: see `labels.rs`. Where that does not settle, or where rounding
//! turned a part over so that labels contradict each other, points are rounded to a grid, which turns nothing over.
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 2.3.
//!
//! ```text
//!   area.rs    The area of a region before rounding
//!   labels.rs  Which faces of a and b a face is part of
//!   region.rs  Regions of an overlay
//! ```

mod area;
mod labels;
mod region;

pub use region::{Operation, ParseOperationError, Parts};

use super::meet::Grid;
use super::{ArrangeOptions, Arranged, Point, SegmentsError, Subdivision};
use crate::geometry::both::of_both;
use crate::ids::{EdgeId, FaceId, FaceMap, HalfEdgeId, VertexId, VertexMap};
use labels::Sources;

/// What two subdivisions, a and b, cut the plane into together.
#[derive(Clone, PartialEq, Debug)]
pub struct Overlay {
    /// The subdivision with the edges of both. It has no hole faces.
    pub subdivision: Subdivision,
    /// The face of a that each face is part of.
    pub face_of_a: FaceMap<FaceId>,
    /// The face of b that each face is part of.
    pub face_of_b: FaceMap<FaceId>,
    /// Where each vertex of a is; a vertex that does not exist is nowhere.
    pub vertices_of_a: VertexMap<Option<VertexId>>,
    /// Where each vertex of b is.
    pub vertices_of_b: VertexMap<Option<VertexId>>,
    /// The vertices made where edges of a and b cross, in increasing order.
    pub crossings: Vec<VertexId>,
    /// The crossings that could not be kept in place, each with the distance it moved.
    pub moved: Vec<(VertexId, f64)>,
    /// How often everything was split; more than 1 if rounded crossings made edges meet anew.
    pub rounds: u32,
    /// The vertices of a and b that a grid moved, each with the greatest distance of those that it stands for.
    pub displaced: Vec<(VertexId, f64)>,
    /// How many vertices of a and b a grid moved. Those at the same place count once; those that fell together on the grid
    /// do not.
    pub displaced_points: usize,
    /// The distance of neighbours of the grid, if points were rounded to one: a power of two.
    pub grid: Option<f64>,
    /// No point of an edge of a or b is further from what it has become.
    pub farthest: f64,
    /// Faces for which different paths lead to different labels, in increasing order: none, since then a grid is used.
    pub unsettled: Vec<FaceId>,
    edges_of_a: Sources,
    edges_of_b: Sources,
    /// The hole faces of a and of b.
    holes: [Vec<FaceId>; 2],
}

impl Overlay {
    /// The half-edges of a along the even half of an edge: none, one, or several that rounding has joined.
    ///
    /// # Panics
    /// If there is no such edge: `there is no e99: there are 12 edges`.
    #[must_use]
    pub fn edges_of_a(&self, e: EdgeId) -> &[HalfEdgeId] {
        self.edges_of_a.along(e)
    }

    /// The half-edges of b along the even half of an edge.
    #[must_use]
    pub fn edges_of_b(&self, e: EdgeId) -> &[HalfEdgeId] {
        self.edges_of_b.along(e)
    }
}

impl Subdivision {
    /// Lays `other` over this subdivision: a is `self`, b is `other`.
    ///
    /// Vertices of a come first, in their order, then those of b that are new, then the crossings; faces are numbered
    /// as in [`from_graph`](Self::from_graph). Both must be planes, as all are that the kit makes
    /// ([`geometry_violations`](Self::geometry_violations) names none): edges of one of them are not compared with each other.
    ///
    /// Cost: O((n + k) log n) for n edges of both with k crossings, a few times over if crossings have to be rounded. Where most
    /// edges of one are far from those of the other, nearly all of the time goes into writing.
    ///
    /// # Errors
    /// [`SegmentsError::TooMany`] if there are more elements than ids; nothing is refused for being close.
    ///
    /// ```
    /// use dcel_kit::plane::{Operation, Parts, Point, Subdivision};
    /// let square = |x, y| {
    ///     let c = [(x, y), (x + 4., y), (x + 4., y + 4.), (x, y + 4.)].map(Point::from);
    ///     Subdivision::from_graph(&c, &[[0, 1], [1, 2], [2, 3], [3, 0]])
    /// };
    /// let both = square(0., 0.)?.overlay(&square(2., 2.)?)?;
    /// assert_eq!((both.crossings.len(), both.subdivision.face_count()), (2, 4));
    /// let common = both.region(Operation::Intersection, Parts::Joined)?;
    /// assert_eq!((common.vertex_count(), common.face_count()), (4, 2));
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    pub fn overlay(&self, other: &Self) -> Result<Overlay, SegmentsError> {
        let both = self.overlay_on_grid(other, None)?;
        if both.unsettled.is_empty() {
            return Ok(both);
        }
        let points = [self, other].into_iter().flat_map(|s| s.dcel.vertices().map(|v| s.points[v]));
        let reach = points.map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
        self.overlay_on_grid(other, Some(Grid::finest(reach).size()))
    }

    /// The same with all points on a grid, the multiples of the largest power of two not above `grid`; see
    /// [`ArrangeOptions::grid`]. `None`: in place where that settles, even if labels then contradict each other
    /// ([`unsettled`](Overlay::unsettled)).
    ///
    /// # Errors
    /// [`SegmentsError::Grid`] if doubles do not reach so far, else as [`overlay`](Self::overlay).
    pub fn overlay_on_grid(&self, other: &Self, grid: Option<f64>) -> Result<Overlay, SegmentsError> {
        let mut graph = Graph::default();
        let [places_of_a, places_of_b] = [graph.add(self), graph.add(other)];
        let options = ArrangeOptions { merge: true, split: true, grid, ..ArrangeOptions::default() };
        let arranged = Self::arrange_two(graph.points, graph.segments, self.dcel.edge_count(), &options)?;
        let (of_a, of_b) = graph.halves.split_at(self.dcel.edge_count());
        let edges = arranged.subdivision.dcel.edge_bound();
        let edges_of_a = Sources::new(edges, of_a, |i| arranged.chain(i));
        let edges_of_b = Sources::new(edges, of_b, |i| arranged.chain(of_a.len() + i));
        let place = |point: Option<u32>| point.map(|i| arranged.vertices[i as usize]);
        let [vertices_of_a, vertices_of_b] =
            [places_of_a, places_of_b].map(|list| list.into_iter().map(place).collect::<Vec<_>>().into());
        let Arranged { subdivision, crossings, moved, rounds, displaced, displaced_points, grid, farthest, .. } =
            arranged;
        let ([face_of_a, face_of_b], unsettled) = subdivision.carry_labels([self, other], [&edges_of_a, &edges_of_b]);
        Ok(Overlay {
            subdivision,
            face_of_a,
            face_of_b,
            vertices_of_a,
            vertices_of_b,
            crossings,
            moved,
            rounds,
            displaced,
            displaced_points,
            grid,
            farthest,
            unsettled,
            edges_of_a,
            edges_of_b,
            holes: [self, other].map(|s| s.hole_faces().collect()),
        })
    }
}

/// The points and edges of both.
#[derive(Default)]
struct Graph {
    points: Vec<Point>,
    segments: Vec<[u32; 2]>,
    /// The even half of each edge, where it comes from.
    halves: Vec<HalfEdgeId>,
}

impl Graph {
    /// Adds a subdivision; returns the number of the point of each vertex.
    fn add(&mut self, s: &Subdivision) -> Vec<Option<u32>> {
        let mut places = vec![None; s.dcel.vertex_bound()];
        for v in s.dcel.vertices() {
            places[v.index()] = Some(self.points.len() as u32);
            self.points.push(s.points[v]);
        }
        for e in s.dcel.edges() {
            if let [Some(from), Some(to)] = of_both(s.edge_ends(e), |v| places[v.index()]) {
                self.segments.push([from, to]);
                self.halves.push(e.half_edges()[0]);
            }
        }
        places
    }
}
