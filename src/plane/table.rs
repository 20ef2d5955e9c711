//! From tables to a subdivision.
//!
//! ```text
//!   h0 origin v0 twin h1 next h2 ...          h0 -> h0     twin(h) = h ^ 1 already: every id stays
//!
//!   h0 origin v0 twin h3 next h1 ...          h0 -> h0     otherwise edges are numbered in the order of
//!   h1 origin v1 twin h4 next h2 ...          h3 -> h1     their smaller half, which becomes the even one
//!   h3 origin v1 twin h0 ...                  h1 -> h2, h4 -> h3, ...
//!
//!   f7 outer                                  f7 <-> f0    the outer face and f0 change numbers
//! ```

use super::{CoordinateError, GeometryViolation, PlanarView, Point, Subdivision};
use crate::ids::{EdgeId, FaceId, HalfEdgeId, MAX_IDS, VertexId, VertexMap};
use crate::topology::{
    Columns, Dcel, HalfEdgeRow, InnerComponent, NoRecorder, Table, TableColumns, TooMany, View, Violation, violations,
};

/// Why a table is no subdivision of the plane. All ids are those of the table.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// Invariants of the structure are broken.
    #[error("{}{}", violations.first().map_or_else(String::new, ToString::to_string), more(violations.len()))]
    Invariants {
        /// All of them; at least one.
        violations: Vec<Violation>,
    },
    /// No face is the outer one.
    #[error("no face is the outer one; mark the unbounded face")]
    NoOuterFace,
    /// A vertex has no position.
    #[error("{vertex} has no position; a subdivision of the plane needs x and y for every vertex")]
    NoPosition {
        /// The first such vertex.
        vertex: VertexId,
    },
    /// A vertex whose coordinates cannot be used.
    #[error("{vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: VertexId,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// Invariants of the plane are broken.
    #[error("{}{}", violations.first().map_or_else(String::new, ToString::to_string), more(violations.len()))]
    Geometry {
        /// What the full check found; at least one.
        violations: Vec<GeometryViolation>,
    },
    /// More elements than ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

fn more(count: usize) -> String {
    if count > 1 { format!(" (the first of {count} violations)") } else { String::new() }
}

impl Subdivision {
    /// The subdivision that a table describes, fully checked.
    ///
    /// Vertices keep their numbers. Half-edges keep theirs if twins are h ^ 1 throughout; otherwise edges are
    /// numbered without gaps in the order of their smaller half, which becomes the even one. Faces keep theirs,
    /// except that the outer face becomes `f0` and changes numbers with the face of that name. Numbers without
    /// a row stay free, to be given out from the lowest on. Boundaries, inner components and hole faces are taken as they
    /// are; names are left in the table.
    ///
    /// Cost: O(n log n) for the check that nothing crosses.
    ///
    /// # Errors
    /// [`TableError`], with all violations of the first kind that has any: the invariants of the structure, missing or
    /// bad positions, then the invariants of the plane.
    ///
    /// ```
    /// use dcel_kit::{plane::{PlanarView, Subdivision}, topology::Table};
    /// let square = Subdivision::lab_rectangle();
    /// let mut table = Table::from_view(&square);
    /// for v in square.vertices() {
    ///     table.vertices[v.index()].as_mut().unwrap().position = square.position(v).map(|p| [p.x, p.y]);
    /// }
    /// assert_eq!(Subdivision::from_table(&table)?, square);
    /// # Ok::<(), dcel_kit::plane::TableError>(())
    /// ```
    pub fn from_table(table: &Table) -> Result<Self, TableError> {
        let broken = violations(table);
        if !broken.is_empty() {
            return Err(TableError::Invariants { violations: broken });
        }
        check_sizes(table)?;
        let outer = table.outer_face.ok_or(TableError::NoOuterFace)?;
        let points = positions(table)?;
        let numbers = Numbers::new(table, outer);
        let mut subdivision = Self::from_parts(numbers.structure(table), points);
        for (f, row) in table.faces.iter().enumerate() {
            let f = numbers.face(FaceId::new(f as u32));
            let Some(row) = row else { continue };
            if row.hole {
                subdivision.holes.insert(f);
            }
            if !row.inner_components.is_empty() {
                subdivision
                    .inner_components
                    .insert(f, row.inner_components.iter().map(|&ring| numbers.ring(ring)).collect());
            }
        }
        let violations = subdivision.geometry_violations();
        if violations.is_empty() {
            return Ok(subdivision);
        }
        Err(TableError::Geometry { violations: violations.into_iter().map(|v| numbers.named_back(v)).collect() })
    }
}

impl Table {
    /// Copies the pointers and positions of a view of the plane; names are left empty.
    ///
    /// ```
    /// use dcel_kit::{plane::Subdivision, topology::Table};
    /// let square = Subdivision::lab_rectangle();
    /// assert_eq!(Subdivision::from_table(&Table::from_planar_view(&square))?, square);
    /// # Ok::<(), dcel_kit::plane::TableError>(())
    /// ```
    pub fn from_planar_view(view: &dyn PlanarView) -> Self {
        let mut table = Self::from_view(view);
        for (v, row) in (0..).map(VertexId::new).zip(&mut table.vertices) {
            if let Some(row) = row {
                row.position = view.position(v).map(|p| [p.x, p.y]);
            }
        }
        table
    }
}

impl Subdivision {
    /// The same as [`from_table`](Self::from_table) of a table in columns, which is empty afterwards. If its twins are h ^ 1,
    /// its outer face is `f0` and no number is left out, its columns become those of the subdivision, and nothing is copied.
    ///
    /// # Errors
    /// As [`from_table`](Self::from_table); the table is as it was.
    pub fn from_columns(table: &mut TableColumns) -> Result<Self, TableError> {
        if table.outer_face != Some(FaceId::new(0)) || !table.has_no_gaps() {
            let subdivision = Self::from_table(&table.clone().into_table())?;
            *table = TableColumns::default();
            return Ok(subdivision);
        }
        let broken = violations(table);
        if !broken.is_empty() {
            return Err(TableError::Invariants { violations: broken });
        }
        check_sizes(table)?;
        for v in (0..table.vertex_bound() as u32).map(VertexId::new) {
            checked(v, table.position(v))?;
        }
        table.shrink_to_fit();
        let columns = std::mem::take(&mut table.columns);
        let points: Vec<Point> = std::mem::take(&mut table.positions).into_iter().map(Point::from).collect();
        let mut subdivision = Self::from_parts(Dcel::from_columns(columns), points.into());
        for (&f, details) in &table.details {
            if details.hole {
                subdivision.holes.insert(FaceId::new(f));
            }
            if !details.inner_components.is_empty() {
                subdivision.inner_components.insert(FaceId::new(f), details.inner_components.clone());
            }
        }
        let violations = subdivision.geometry_violations();
        if violations.is_empty() {
            *table = TableColumns::default();
            return Ok(subdivision);
        }
        table.positions = subdivision.points.as_slice().iter().map(|p| [p.x, p.y]).collect();
        table.columns = subdivision.dcel.into_columns();
        Err(TableError::Geometry { violations })
    }
}

/// Refuses more elements than there are ids.
fn check_sizes<V: View>(table: &V) -> Result<(), TooMany> {
    let bounds = [table.vertex_bound(), table.half_edge_bound() + 1, table.face_bound()];
    if bounds.iter().any(|&bound| bound > MAX_IDS) { Err(TooMany) } else { Ok(()) }
}

/// The place of a vertex, if it has one that can be used.
fn checked(vertex: VertexId, position: Option<[f64; 2]>) -> Result<Point, TableError> {
    let point = Point::from(position.ok_or(TableError::NoPosition { vertex })?);
    point.check().map_err(|error| TableError::Coordinate { vertex, error })?;
    Ok(point)
}

/// The structure of a table that obeys the laws and whose twins are h ^ 1. All elements keep their numbers.
#[cfg(feature = "serde")]
pub(crate) fn dcel_of_table(table: &Table) -> Dcel {
    Numbers { old: None, new: Vec::new(), outer: FaceId::new(0) }.structure(table)
}

/// Numbers without a row get a place that nobody looks at.
fn positions(table: &Table) -> Result<VertexMap<Point>, TableError> {
    let mut points = VertexMap::filled(table.vertices.len(), Point::default());
    for (v, row) in table.vertices.iter().enumerate() {
        let vertex = VertexId::new(v as u32);
        let Some(row) = row else { continue };
        points[vertex] = checked(vertex, row.position)?;
    }
    Ok(points)
}

/// From the numbers of a table that obeys the invariants to those of the subdivision.
struct Numbers {
    /// For each new half-edge the old one, or `None` for free slots. Without: all stay.
    old: Option<Vec<HalfEdgeId>>,
    /// For each old half-edge the new one; as long as `old` is there.
    new: Vec<HalfEdgeId>,
    outer: FaceId,
}

impl Numbers {
    fn new(table: &Table, outer: FaceId) -> Self {
        let rows = || {
            let live = table.half_edges.iter().enumerate();
            live.filter_map(|(h, row)| Some((HalfEdgeId::new(h as u32), row.as_ref()?.twin?)))
        };
        if rows().all(|(h, twin)| h.twin() == twin) {
            return Self { old: None, new: Vec::new(), outer };
        }
        let mut numbers = Self { old: None, new: vec![HalfEdgeId::new(0); table.half_edges.len()], outer };
        let mut old = Vec::new();
        for (h, twin) in rows().filter(|(h, twin)| h < twin) {
            for g in [h, twin] {
                numbers.new[g.index()] = HalfEdgeId::new(old.len() as u32);
                old.push(g);
            }
        }
        numbers.old = Some(old);
        numbers
    }

    fn half_edge(&self, h: HalfEdgeId) -> HalfEdgeId {
        if self.old.is_some() { self.new[h.index()] } else { h }
    }

    fn old_half_edge(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.old.as_ref().map_or(h, |old| old[h.index()])
    }

    /// The same both ways: `f0` and the outer face change places.
    fn face(&self, f: FaceId) -> FaceId {
        let first = FaceId::new(0);
        if f == self.outer {
            first
        } else if f == first {
            self.outer
        } else {
            f
        }
    }

    fn ring(&self, ring: InnerComponent) -> InnerComponent {
        match ring {
            InnerComponent::Cycle(h) => InnerComponent::Cycle(self.half_edge(h)),
            InnerComponent::Isolated(v) => InnerComponent::Isolated(v),
        }
    }

    /// The columns, with free slots where the table has no row.
    fn structure(&self, table: &Table) -> Dcel {
        let row = |h: u32| -> Option<&HalfEdgeRow> {
            table.half_edges.get(self.old_half_edge(HalfEdgeId::new(h)).index())?.as_ref()
        };
        let half_edges = self.old.as_ref().map_or(table.half_edges.len().next_multiple_of(2), Vec::len) as u32;
        let half_edge = |h: Option<HalfEdgeId>| h.map_or(Columns::NONE, |h| self.half_edge(h).number());
        let column = |pointer: &dyn Fn(&HalfEdgeRow) -> u32| {
            (0..half_edges).map(|h| row(h).map_or(Columns::NONE, pointer)).collect::<Vec<_>>()
        };
        let face_row = |f: u32| table.faces.get(self.face(FaceId::new(f)).index())?.as_ref();
        let vertex_rows = table.vertices.iter().map(Option::as_ref);
        let faces = table.faces.len() as u32;
        let mut dcel = Dcel::from_columns(Columns {
            origin: column(&|row| row.origin.map_or(Columns::NONE, VertexId::number)),
            next: column(&|row| half_edge(row.next)),
            prev: column(&|row| half_edge(row.prev)),
            face: column(&|row| row.face.map_or(Columns::NONE, |f| self.face(f).number())),
            outgoing: vertex_rows.map(|row| half_edge(row.and_then(|row| row.outgoing))).collect(),
            boundary: (0..faces).map(|f| half_edge(face_row(f).and_then(|row| row.half_edge))).collect(),
        });
        // From the last one on, so that the lowest free number is given out first.
        for (v, _) in table.vertices.iter().enumerate().rev().filter(|(_, row)| row.is_none()) {
            dcel.remove_vertex_record(VertexId::new(v as u32), &mut NoRecorder);
        }
        for e in (0..half_edges / 2).rev().filter(|e| row(2 * e).is_none()) {
            dcel.remove_edge_record(EdgeId::new(e), &mut NoRecorder);
        }
        for f in (0..faces).rev().filter(|&f| face_row(f).is_none()) {
            dcel.remove_face_record(FaceId::new(f), &mut NoRecorder);
        }
        dcel
    }

    /// The violation in the numbers of the table.
    fn named_back(&self, violation: GeometryViolation) -> GeometryViolation {
        use GeometryViolation as G;
        match violation {
            G::BoundaryClockwise { face, start } => {
                G::BoundaryClockwise { face: self.face(face), start: self.old_half_edge(start) }
            }
            G::RingCounterClockwise { face, start } => {
                G::RingCounterClockwise { face: self.face(face), start: self.old_half_edge(start) }
            }
            G::RingElsewhere { vertex, listed, face } => {
                G::RingElsewhere { vertex, listed: self.face(listed), face: self.face(face) }
            }
            G::SamePlace { .. } | G::VertexOnEdge { .. } | G::EdgesMeet { .. } | G::Folded { .. } => violation,
        }
    }
}
