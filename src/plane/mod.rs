//! Half-edge structures in the plane: positions, exact decisions, faces that cover the whole plane.
//!
//! ```text
//!   subdivision.rs              a Dcel with positions: f0 is the outer face, faces may have inner components
//!   convert/                    polygons and triangles -> subdivision       table.rs   tables -> subdivision
//!   segments/                   any straight-line graph -> subdivision         meet/      all crossings, exactly
//!   delaunay/                   of points, by flips, with fixed edges
//!   voronoi/                    cells of nearest sites: the dual of Delaunay
//!   overlay/                    two subdivisions on each other, and their regions
//!   mend/                       polygons that overlap or cross -> subdivision
//!   affine.rs                   maps that keep straight lines straight
//!   check.rs                    the invariants of the plane                                   measure.rs areas, exactly
//!   edit/                       split_face, join_faces, split_edge, join_edges; insert and remove vertices, edges, segments
//!   plane_journal.rs            watching the edits, undo
//!   locate/                     where a point lies: scan, walk, index
//!   triangulate/                faces into triangles: ears, monotone pieces              hull.rs    points -> convex hull
//!   sweep.rs cycle.rs rings.rs  what lies below, which way round, which inner component in which face
//! ```
//!
//! ```text
//!   seed.rs    Subdivisions to start from
//!   status.rs  The edges under the sweep line, in order
//! ```

mod affine;
mod check;
mod convert;
mod cycle;
mod delaunay;
pub mod edit;
mod hull;
mod locate;
mod measure;
mod meet;
mod mend;
mod overlay;
mod plane_journal;
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
pub use delaunay::{ConstrainedDelaunay, DelaunayBuilt, DelaunayError};
pub use edit::{
    FlipEdgeError, InsertDanglingEdgeError, InsertEdgeError, InsertSegmentError, InsertVertexError, InsertedEdge,
    InsertedSegment, JoinEdgesError, JoinFacesError, RemoveEdgeError, RemoveVertexError, SetPointError, SplitEdgeError,
    SplitFaceError, TransformError,
};
pub use hull::{HullError, convex_hull};
#[cfg(feature = "navmesh")]
pub(crate) use locate::{Cells, Lines};
pub use locate::{Location, PointIndex, Walk};
#[cfg(feature = "navmesh")]
pub(crate) use meet::Crossed;
pub(crate) use meet::Expansion;
pub use mend::{Cover, Mended};
pub use overlay::{Operation, Overlay, ParseOperationError, Parts};
pub use plane_journal::{PlaneChange, PlaneJournal, PlaneRecorder};
pub use seed::LAB_RECTANGLE;
pub use segments::{
    ArrangeOptions, Arranged, DanglesAndCutEdges, InsertedCorner, MarkHolesError, SegmentFault, SegmentsAlong,
    SegmentsError,
};
pub use subdivision::{PlanarView, Subdivision};
pub use table::TableError;
pub use triangulate::{TriangulateError, Triangulated, TriangulationMethod};
pub use voronoi::{Voronoi, VoronoiCells, VoronoiEdge, VoronoiError, Window};
