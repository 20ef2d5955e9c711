//! Subdivisions to start from.

use super::{Point, Subdivision};
use crate::ids::{FaceId, VertexMap};
use crate::topology::Dcel;

/// The corners of the rectangle that the half-edge lab starts from, with a vertex in the middle of its long
/// sides.
pub const LAB_RECTANGLE: [Point; 6] = [
    Point::new(-250.0, -150.0),
    Point::new(0.0, -150.0),
    Point::new(250.0, -150.0),
    Point::new(250.0, 150.0),
    Point::new(0.0, 150.0),
    Point::new(-250.0, 150.0),
];

impl Subdivision {
    /// The whole plane: `f0` and nothing else.
    #[must_use]
    pub fn new() -> Self {
        let mut dcel = Dcel::new();
        dcel.add_face_record(&mut crate::topology::NoRecorder);
        Self::from_parts(dcel, VertexMap::default())
    }

    /// The six-vertex rectangle of the half-edge lab: 500 wide, 300 high, `f1` inside, `f0` outside.
    ///
    #[doc = include_str!("../../figures/rectangle.svg")]
    ///
    /// h0, h2, ... h10 run round the inside from v0, their twins h1, h3, ... h11 round the outside.
    ///
    /// Source: the CS 480 half-edge lab. (Its own start leaves `outerFace` without a half-edge by a typing
    /// error, and the vertices without outgoing half-edges; here both are set.)
    #[must_use]
    pub fn lab_rectangle() -> Self {
        let dcel = Dcel::polygon(LAB_RECTANGLE.len()).unwrap_or_default();
        Self::from_parts(dcel, LAB_RECTANGLE.to_vec().into())
    }

    pub(super) fn from_parts(dcel: Dcel, points: VertexMap<Point>) -> Self {
        Self { dcel, points, inner_components: Default::default(), holes: Default::default() }
    }

    /// Drops the dead records and renumbers the rest along a walk, see [`Dcel::compact`]. Inner components and holes
    /// follow; `f0` stays `f0`.
    #[must_use = "every id held outside must be translated by the renumbering"]
    pub fn compact(&mut self) -> crate::topology::Renumbering {
        use crate::topology::InnerComponent;
        let rings_of_f0: Vec<_> = self.cycles(self.outer_face()).skip(1).collect();
        let old_points = std::mem::take(&mut self.points);
        let map = self.dcel.compact_from(&rings_of_f0);
        let mut points = vec![Point::default(); self.dcel.vertex_bound()];
        for (v, new) in map.vertices.iter() {
            if let Some(new) = new {
                points[new.index()] = old_points[v];
            }
        }
        self.points = points.into();
        let ring = |ring: InnerComponent| match ring {
            InnerComponent::Cycle(h) => map.half_edge(h).map(InnerComponent::Cycle),
            InnerComponent::Isolated(v) => map.vertices[v].map(InnerComponent::Isolated),
        };
        let face = |f: FaceId| map.faces[f];
        self.inner_components = std::mem::take(&mut self.inner_components)
            .into_iter()
            .filter_map(|(f, rings)| Some((face(f)?, rings.into_iter().filter_map(ring).collect())))
            .collect();
        self.holes = std::mem::take(&mut self.holes).into_iter().filter_map(face).collect();
        map
    }
}

impl Default for Subdivision {
    fn default() -> Self {
        Self::new()
    }
}
