//! Structures, ids and points written and read by serde. The format is described on the page of the parent module.
//!
//! ```text
//!   write   columns, straight from the structure, nothing is put together first
//!   read    columns ──> Table ──> the same checks as for files ──> structure
//! ```

use crate::ids::{EdgeId, FaceId, HalfEdgeId, Id, IdMap, MAX_IDS, VertexId};
use crate::plane::{Point, Subdivision, TableError, dcel_of_table};
#[cfg(feature = "solid")]
use crate::solid::Polyhedron;
use crate::topology::{Dcel, FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow, violations};
use ::serde::de::{Deserialize, Deserializer, Error as _};
use ::serde::ser::{Serialize, SerializeStruct, Serializer};
use std::fmt::Display;

/// The version of the formats of all structures.
const VERSION: u32 = 1;

macro_rules! ids {
    ($($id:ty),*) => {$(
        impl Serialize for $id {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_u32(self.number())
            }
        }

        impl<'de> Deserialize<'de> for $id {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let number = u32::deserialize(deserializer)?;
                if (number as usize) < MAX_IDS {
                    Ok(Self::new(number))
                } else {
                    Err(D::Error::custom(format_args!("{number} is no number of an element: they are below {MAX_IDS}")))
                }
            }
        }
    )*};
}

ids!(VertexId, HalfEdgeId, EdgeId, FaceId);

impl<I: Id, T: Serialize> Serialize for IdMap<I, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.as_slice())
    }
}

impl<'de, I: Id, T: Deserialize<'de>> Deserialize<'de> for IdMap<I, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Vec::deserialize(deserializer).map(Into::into)
    }
}

impl Serialize for Point {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        [self.x, self.y].serialize(serializer)
    }
}

/// Refuses coordinates that cannot be computed with.
impl<'de> Deserialize<'de> for Point {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let point = Self::from(<[f64; 2]>::deserialize(deserializer)?);
        point.check().map_err(D::Error::custom)?;
        Ok(point)
    }
}

/// A list that is written while it is walked.
struct Column<F>(F);

impl<I: Iterator<Item: Serialize>, F: Fn() -> I> Serialize for Column<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq((self.0)())
    }
}

/// The number of a version that this kit reads.
struct Version;

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match u32::deserialize(deserializer)? {
            VERSION => Ok(Self),
            other => {
                Err(D::Error::custom(format_args!("version {other} of the format; this kit reads version {VERSION}")))
            }
        }
    }
}

impl Serialize for Dcel {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let pointer = |of: fn(&Self, HalfEdgeId) -> u32| {
            Column(move || {
                let all = (0..self.half_edge_bound() as u32).map(HalfEdgeId::new);
                all.map(move |h| self.has_half_edge(h).then(|| of(self, h)))
            })
        };
        let vertices = || (0..self.vertex_bound() as u32).map(VertexId::new);
        let faces = || (0..self.face_bound() as u32).map(FaceId::new);
        let mut record = serializer.serialize_struct("Dcel", 9)?;
        record.serialize_field("dcel", &VERSION)?;
        record.serialize_field("origin", &pointer(|d, h| d.origin(h).number()))?;
        record.serialize_field("next", &pointer(|d, h| d.next(h).number()))?;
        record.serialize_field("prev", &pointer(|d, h| d.prev(h).number()))?;
        record.serialize_field("face", &pointer(|d, h| d.face(h).number()))?;
        let outgoing = || vertices().map(|v| self.has_vertex(v).then(|| self.outgoing(v)).flatten());
        record.serialize_field("outgoing", &Column(outgoing))?;
        let half_edge = || faces().map(|f| self.has_face(f).then(|| self.half_edge(f)).flatten());
        record.serialize_field("half_edge", &Column(half_edge))?;
        record.serialize_field("free_vertices", &Column(|| vertices().filter(|&v| !self.has_vertex(v))))?;
        record.serialize_field("free_faces", &Column(|| faces().filter(|&f| !self.has_face(f))))?;
        record.end()
    }
}

/// A pointer as it is read: anything that is a number.
type Pointer = Option<u32>;

/// The columns of a structure as they are read, right or wrong.
#[derive(::serde::Deserialize)]
struct Columns {
    #[serde(rename = "dcel")]
    _version: Version,
    origin: Vec<Pointer>,
    next: Vec<Pointer>,
    prev: Vec<Pointer>,
    face: Vec<Pointer>,
    outgoing: Vec<Pointer>,
    half_edge: Vec<Pointer>,
    free_vertices: Vec<u32>,
    free_faces: Vec<u32>,
}

impl Columns {
    /// As a table, with the twins that are meant. Whether it obeys the laws is not looked at.
    fn table(self) -> Result<Table, String> {
        let half_edges = self.origin.len();
        for (name, column) in [("next", &self.next), ("prev", &self.prev), ("face", &self.face)] {
            if column.len() != half_edges {
                return Err(format!(
                    "`origin` has {half_edges} places and `{name}` has {}: both need one for each half-edge",
                    column.len()
                ));
            }
        }
        if !half_edges.is_multiple_of(2) {
            return Err(format!("`origin` has {half_edges} places: half-edges come in pairs"));
        }
        let half_edge = |h: u32| {
            let i = h as usize;
            let row = HalfEdgeRow {
                origin: self.origin[i].map(VertexId::new),
                twin: Some(HalfEdgeId::new(h).twin()),
                next: self.next[i].map(HalfEdgeId::new),
                prev: self.prev[i].map(HalfEdgeId::new),
                face: self.face[i].map(FaceId::new),
            };
            // Where there is no half-edge, all four pointers are null.
            (row != HalfEdgeRow { twin: row.twin, ..HalfEdgeRow::default() }).then_some(row)
        };
        let mut table = Table {
            half_edges: (0..half_edges as u32).map(half_edge).collect(),
            vertices: self.outgoing.iter().map(|h| Some(vertex_row(*h))).collect(),
            faces: self.half_edge.iter().map(|h| Some(face_row(*h))).collect(),
            outer_face: None,
        };
        for v in self.free_vertices.into_iter().map(VertexId::new) {
            let row = table.vertices.get_mut(v.index()).and_then(Option::take).ok_or_else(|| not_free(v))?;
            if let Some(h) = row.outgoing {
                return Err(format!("{v} is said to be free, and to have the outgoing half-edge {h}"));
            }
        }
        for f in self.free_faces.into_iter().map(FaceId::new) {
            let row = table.faces.get_mut(f.index()).and_then(Option::take).ok_or_else(|| not_free(f))?;
            if let Some(h) = row.half_edge {
                return Err(format!("{f} is said to be free, and to have the half-edge {h}"));
            }
        }
        Ok(table)
    }
}

fn vertex_row(outgoing: Pointer) -> VertexRow {
    VertexRow { outgoing: outgoing.map(HalfEdgeId::new), ..VertexRow::default() }
}

fn face_row(half_edge: Pointer) -> FaceRow {
    FaceRow { half_edge: half_edge.map(HalfEdgeId::new), ..FaceRow::default() }
}

fn not_free(element: impl Display) -> String {
    format!("{element} is said to be free twice, or is beyond the last number")
}

impl<'de> Deserialize<'de> for Dcel {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let table = Columns::deserialize(deserializer)?.table().map_err(D::Error::custom)?;
        let violations = violations(&table);
        if violations.is_empty() {
            return Ok(dcel_of_table(&table));
        }
        Err(D::Error::custom(TableError::Invariants { violations }))
    }
}

/// An inner component as it is written.
#[derive(::serde::Serialize, ::serde::Deserialize)]
#[serde(rename_all = "lowercase")]
enum Inner {
    Cycle(HalfEdgeId),
    Vertex(VertexId),
}

impl From<InnerComponent> for Inner {
    fn from(ring: InnerComponent) -> Self {
        match ring {
            InnerComponent::Cycle(h) => Self::Cycle(h),
            InnerComponent::Isolated(v) => Self::Vertex(v),
        }
    }
}

impl From<Inner> for InnerComponent {
    fn from(inner: Inner) -> Self {
        match inner {
            Inner::Cycle(h) => Self::Cycle(h),
            Inner::Vertex(v) => Self::Isolated(v),
        }
    }
}

/// The place of every vertex, by number.
fn places<P>(dcel: &Dcel, point: impl Fn(VertexId) -> P) -> impl Iterator<Item = Option<P>> {
    let all = (0..dcel.vertex_bound() as u32).map(VertexId::new);
    all.map(move |v| dcel.has_vertex(v).then(|| point(v)))
}

impl Serialize for Subdivision {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let dcel = self.topology();
        let points = || places(dcel, |v| self.point(v));
        let components = || {
            let listed = dcel.faces().map(|f| (f, self.inner_components(f))).filter(|(_, rings)| !rings.is_empty());
            listed.map(|(f, rings)| (f, rings.iter().map(|&ring| Inner::from(ring)).collect::<Vec<_>>()))
        };
        let mut record = serializer.serialize_struct("Subdivision", 5)?;
        record.serialize_field("subdivision", &VERSION)?;
        record.serialize_field("structure", dcel)?;
        record.serialize_field("points", &Column(points))?;
        record.serialize_field("inner_components", &Column(components))?;
        record.serialize_field("holes", &Column(|| self.hole_faces()))?;
        record.end()
    }
}

#[derive(::serde::Deserialize)]
struct SubdivisionRecord {
    #[serde(rename = "subdivision")]
    _version: Version,
    structure: Columns,
    points: Vec<Option<[f64; 2]>>,
    inner_components: Vec<(FaceId, Vec<Inner>)>,
    holes: Vec<FaceId>,
}

impl SubdivisionRecord {
    fn table(self) -> Result<Table, String> {
        let mut table = self.structure.table()?;
        check_points(self.points.len(), table.vertices.len())?;
        for (row, position) in table.vertices.iter_mut().zip(self.points) {
            if let Some(row) = row {
                row.position = position;
            }
        }
        for (f, inner) in self.inner_components {
            face_named(&mut table, "inner_components", f)?
                .inner_components
                .extend(inner.into_iter().map(InnerComponent::from));
        }
        for f in self.holes {
            face_named(&mut table, "holes", f)?.hole = true;
        }
        table.outer_face = Some(FaceId::new(0));
        Ok(table)
    }
}

fn face_named<'a>(table: &'a mut Table, field: &str, f: FaceId) -> Result<&'a mut FaceRow, String> {
    let bound = table.faces.len();
    let row = table.faces.get_mut(f.index()).and_then(Option::as_mut);
    row.ok_or_else(|| format!("`{field}`: {}", crate::ids::Element::from(f).missing(bound, bound)))
}

fn check_points(points: usize, vertices: usize) -> Result<(), String> {
    if points == vertices {
        return Ok(());
    }
    Err(format!("`points` has {points} places and `outgoing` has {vertices}: both need one for each vertex"))
}

impl<'de> Deserialize<'de> for Subdivision {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let table = SubdivisionRecord::deserialize(deserializer)?.table().map_err(D::Error::custom)?;
        Self::from_table(&table).map_err(D::Error::custom)
    }
}

#[cfg(feature = "solid")]
impl Serialize for Polyhedron {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let dcel = self.topology();
        let points = || places(dcel, |v| self.point(v));
        let mut record = serializer.serialize_struct("Polyhedron", 4)?;
        record.serialize_field("polyhedron", &VERSION)?;
        record.serialize_field("structure", dcel)?;
        record.serialize_field("points", &Column(points))?;
        record.serialize_field("boundary_faces", &Column(|| self.boundary_faces()))?;
        record.end()
    }
}

#[cfg(feature = "solid")]
#[derive(::serde::Deserialize)]
struct PolyhedronRecord {
    #[serde(rename = "polyhedron")]
    _version: Version,
    structure: Dcel,
    points: Vec<Option<[f64; 3]>>,
    boundary_faces: Vec<FaceId>,
}

#[cfg(feature = "solid")]
impl<'de> Deserialize<'de> for Polyhedron {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let PolyhedronRecord { structure, points, boundary_faces, .. } = PolyhedronRecord::deserialize(deserializer)?;
        check_points(points.len(), structure.vertex_bound()).map_err(D::Error::custom)?;
        if let Some(vertex) = structure.vertices().find(|v| points[v.index()].is_none()) {
            return Err(D::Error::custom(crate::solid::PartsError::NoPoint { vertex, bound: points.len() }));
        }
        let points: Vec<[f64; 3]> = points.into_iter().map(Option::unwrap_or_default).collect();
        Self::from_parts(structure, points.into(), boundary_faces).map_err(D::Error::custom)
    }
}
