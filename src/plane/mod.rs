//! Half-edge structures in the plane: positions, exact decisions, faces that cover the whole plane.
//!
//! | task | types |
//! |---|---|
//! | a subdivision, to walk and to ask | [`Subdivision`], [`Point`], [`Location`]; any structure with positions is a [`PlanarView`] |
//! | make one of polygons or triangles | [`Subdivision::from_polygons`], [`Subdivision::from_triangles`], [`ConvertOptions`]; of polygons that overlap [`Mended`] |
//! | make one of segments | [`Subdivision::from_segments`], [`ArrangeOptions`], [`Arranged`] |
//! | edit it, watch the edit, take it back | [`Subdivision::split_face`] and its like in [`edit`]; [`PlaneRecorder`], [`PlaneJournal`] |
//! | move it | [`Subdivision::set_point`], [`Affine`] |
//! | find where points lie | [`Subdivision::locate`], [`PointIndex`], [`Walk`] |
//! | triangulate | [`Subdivision::delaunay`], [`ConstrainedDelaunay`], [`TriangulationMethod`] |
//! | Voronoi diagrams, hulls | [`Voronoi`], [`VoronoiCells`], [`Window`], [`convex_hull`] |
//! | lay two on each other | [`Subdivision::overlay`], [`Overlay`], [`Operation`] |
//! | check the laws of the plane | [`GeometryViolation`] |
//! | decide exactly | [`predicates`] |
//!
//! With the feature `parallel`, threads share the parts of a [Delaunay triangulation](Subdivision::delaunay) of more than
//! 32,768 points, blocks of points to [locate](PointIndex::locate_all), the making of the [index](PointIndex::new), and the
//! segments that a [grid](ArrangeOptions::grid) rounds.
//! Answers and numbers are the same with any number of threads; `RAYON_NUM_THREADS=1` asks for one.

// The files of this folder:
//
//   subdivision.rs              a Dcel with positions: f0 is the outer face, faces may have rings
//   convert/                    polygons and triangles -> subdivision       table.rs   tables -> subdivision
//   segments/                   any straight-line graph -> subdivision         meet/      all crossings, exactly
//   delaunay/                   of points, by flips, with fixed edges
//   voronoi/                    cells of nearest sites: the dual of Delaunay
//   overlay/                    two subdivisions on each other, and their regions
//   mend/                       polygons that overlap or cross -> subdivision
//   affine.rs                   maps that keep straight lines straight
//   check.rs proof.rs           the laws of the plane; that they hold, with less work        measure.rs areas, exactly
//   edit/                       split_face, join_faces, split_edge, join_edges; insert and remove vertices, edges, segments
//   plane_journal.rs            watching the edits, undo
//   locate/                     where a point lies: scan, walk, index
//   triangulate/                faces into triangles: ears, monotone pieces              hull/      points -> convex hull
//   sweep.rs status.rs          what lies below; the edges under the sweep line, in order     below.rs the same for some points
//   cycle.rs rings.rs           which way round, which inner cycle in which face              seed.rs    to start from
//   marks.rs                    boxes in a coarse grid: what may meet them

mod affine;
mod below;
mod check;
mod convert;
pub(crate) mod cycle;
mod delaunay;
pub mod edit;
mod hull;
mod locate;
mod marks;
mod measure;
mod meet;
mod mend;
mod overlay;
mod plane_journal;
mod proof;
mod rings;
mod seed;
mod segments;
mod status;
mod subdivision;
mod sweep;
mod table;
mod triangulate;
mod voronoi;

pub use crate::geometry::point::{CoordinateError, LARGEST, Point, SMALLEST, check_coordinate};
pub use crate::geometry::predicates;
pub use affine::Affine;
pub use check::{GEOMETRY_RULES, GeometryViolation};
pub use convert::{ConvertError, ConvertOptions, Converted};
pub use cycle::is_counter_clockwise;
pub use delaunay::{ConstrainedDelaunay, DelaunayBuilt, DelaunayError, FlipEvent};
#[cfg(feature = "navmesh")]
pub(crate) use edit::most_looked_at;
pub use edit::{
    FlipEdgeError, InsertDanglingEdgeError, InsertEdgeError, InsertSegmentError, InsertVertexError, InsertedEdge,
    InsertedSegment, JoinEdgesError, JoinFacesError, RemoveEdgeError, RemoveVertexError, SetPointError, SplitEdgeError,
    SplitFaceError, TransformError, rounding_room,
};
pub use hull::{HullError, HullEvent, convex_hull, convex_hull_observed};
#[cfg(feature = "navmesh")]
pub(crate) use locate::{Cells, Lines};
pub use locate::{Location, PointIndex, Walk, WalkEvent};
#[cfg(feature = "navmesh")]
pub(crate) use meet::Crossed;
pub(crate) use meet::Expansion;
pub use meet::SweepEvent;
pub use mend::{Cover, Mended};
pub use overlay::{Operation, Overlay, ParseOperationError, Parts};
pub use plane_journal::{PlaneChange, PlaneJournal, PlaneRecorder};
pub use seed::LAB_RECTANGLE;
pub use segments::{
    ArrangeOptions, Arranged, DanglesAndCutEdges, InsertedCorner, MarkHolesError, SegmentFault, SegmentsAlong,
    SegmentsError, sweep_segments_observed,
};
pub use subdivision::{PlanarView, Subdivision};
pub use table::TableError;
#[cfg(feature = "serde")]
pub(crate) use table::dcel_of_table;
pub use triangulate::{Corner, EarEvent, MonotoneEvent, TriangulateError, Triangulated, TriangulationMethod};
pub use voronoi::{Voronoi, VoronoiCells, VoronoiEdge, VoronoiError, Window};
