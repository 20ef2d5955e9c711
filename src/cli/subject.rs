//! What a command works on: a subdivision, a surface or a table.

use super::Failure;
use dcel_kit::io::{Covering, Format, LeftOut, Model, Places};
use dcel_kit::plane::{PlanarView, Point, Subdivision};
use dcel_kit::solid::Polyhedron;
use dcel_kit::topology::{Mode, TableColumns, View};
use dcel_kit::{FaceId, FaceMap, VertexId};

/// A structure with its names.
pub(crate) struct Subject {
    pub(crate) kind: Kind,
    /// Names of faces that the structure itself does not hold.
    pub(crate) names: FaceMap<Option<String>>,
    /// Which polygons cover each face, if polygons had to be mended.
    pub(crate) covering: Option<Covering>,
    /// Whether the plane was not checked, on request.
    pub(crate) trusted: bool,
    pub(crate) source: String,
    pub(crate) format: Format,
    pub(crate) places: Option<Places>,
    /// What the file says and is not here.
    pub(crate) left_out: LeftOut,
}

pub(crate) enum Kind {
    Plane(Subdivision),
    Surface(Polyhedron),
    /// Any table, right or wrong, with the ids of its file.
    Table(TableColumns),
}

impl Subject {
    /// A table as it stands in its file.
    pub(crate) fn of_table(table: TableColumns, source: String, format: Format) -> Self {
        let (names, covering, places, left_out) = (FaceMap::default(), None, None, LeftOut::default());
        Self { kind: Kind::Table(table), names, covering, trusted: false, source, format, places, left_out }
    }

    pub(crate) fn view(&self) -> &dyn View {
        match &self.kind {
            Kind::Plane(subdivision) => subdivision,
            Kind::Surface(polyhedron) => polyhedron,
            Kind::Table(table) => table,
        }
    }

    /// The subdivision of the plane.
    ///
    /// # Errors
    /// If it is a surface, or a table that was kept as it is.
    pub(crate) fn plane(&self) -> Result<&Subdivision, Failure> {
        match &self.kind {
            Kind::Plane(subdivision) => Ok(subdivision),
            Kind::Surface(_) | Kind::Table(_) => {
                let what = format!("{}: this is a surface in space, no subdivision of the plane", self.source);
                Err(Failure::input(what, "drop z with --plane, if its faces do not overlap then"))
            }
        }
    }

    /// The structure as something to draw; nothing for surfaces.
    pub(crate) fn planar(&self) -> Option<&dyn PlanarView> {
        match &self.kind {
            Kind::Plane(subdivision) => Some(subdivision),
            Kind::Table(table) => Some(table),
            Kind::Surface(_) => None,
        }
    }

    /// Plane or surface.
    pub(crate) fn mode(&self) -> Mode {
        if self.view().outer_face().is_some() { Mode::Plane } else { Mode::Surface }
    }

    pub(crate) fn mode_name(&self) -> &'static str {
        match self.mode() {
            Mode::Plane => "plane",
            Mode::Surface => "surface",
        }
    }

    /// Two or three coordinates.
    pub(crate) fn position(&self, v: VertexId) -> Option<Vec<f64>> {
        match &self.kind {
            Kind::Surface(polyhedron) => polyhedron.has_vertex(v).then(|| polyhedron.point(v).to_vec()),
            _ => self.planar()?.position(v).map(|Point { x, y }| vec![x, y]),
        }
    }

    pub(crate) fn name(&self, f: FaceId) -> Option<&str> {
        match &self.kind {
            Kind::Table(table) => table.name(f),
            _ => self.names.get(f)?.as_deref(),
        }
    }

    /// Whether `f` is no face of the domain: the outer face, a hole face, a face that stands for a border.
    pub(crate) fn is_boundary(&self, f: FaceId) -> bool {
        let view = self.view();
        let border = matches!(&self.kind, Kind::Surface(polyhedron) if polyhedron.is_boundary_face(f));
        border || view.outer_face() == Some(f) || view.is_hole(f)
    }

    pub(crate) fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        (0..self.view().vertex_bound() as u32).map(VertexId::new).filter(|&v| self.view().has_vertex(v))
    }

    pub(crate) fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..self.view().face_bound() as u32).map(FaceId::new).filter(|&f| self.view().has_face(f))
    }

    /// What the writers take.
    pub(crate) fn model(&self) -> Model<'_> {
        match &self.kind {
            Kind::Plane(subdivision) => Model::planar(subdivision).with_names(|f| self.name(f)),
            Kind::Table(table) => Model::planar(table).with_names(|f| table.name(f)),
            Kind::Surface(polyhedron) => {
                let position = |v| polyhedron.has_vertex(v).then(|| polyhedron.point(v));
                Model::surface(polyhedron, position, |f| polyhedron.is_boundary_face(f)).with_names(|f| self.name(f))
            }
        }
    }
}
