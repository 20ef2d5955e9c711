//! What the writers write: any view, with positions and names.

use super::format::Format;
use super::write_error::WriteError;
use crate::geometry::grouping::Groups;
use crate::ids::{FaceId, HalfEdgeId, VertexId, VertexMap};
use crate::plane::cycle::encloses;
use crate::plane::{PlanarView, Point};
use crate::topology::{InnerComponent, PolygonList, Table, View};

/// A half-edge structure with what a file needs besides: positions, names, and which faces are no polygons.
///
/// ```
/// use dcel_kit::io::{Format, Model, ReadOptions, Document, read_bytes, write};
/// let text = "dcel 1\nv0 0 0 out h0\nv1 1 0 out h1\n\
///             h0 origin v0 twin h1 next h1 prev h1 face f0\nh1 origin v1 twin h0 next h0 prev h0 face f0\n\
///             f0 outer half_edge h0 inner none\n";
/// let read = read_bytes(text.as_bytes(), Format::Dcel, "edge.dcel", &ReadOptions::default())?;
/// let Document::Table(table) = read.document else { unreachable!() };
/// let mut again = Vec::new();
/// write(&mut again, &Model::table(&table), Format::Dcel)?;
/// assert_eq!(String::from_utf8(again)?, text);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Model<'a> {
    pub(super) view: &'a dyn View,
    pub(super) in_space: bool,
    position: Box<dyn Fn(VertexId) -> Option<[f64; 3]> + 'a>,
    no_polygon: Box<dyn Fn(FaceId) -> bool + 'a>,
    name: Box<dyn Fn(FaceId) -> Option<&'a str> + 'a>,
}

impl<'a> Model<'a> {
    /// A structure in the plane. Its outer face and its hole faces are not written as polygons.
    pub fn planar<V: PlanarView>(view: &'a V) -> Self {
        Self {
            view,
            in_space: false,
            position: Box::new(|v| view.position(v).map(|p| [p.x, p.y, 0.0])),
            no_polygon: Box::new(|f| view.outer_face() == Some(f) || view.is_hole(f)),
            name: Box::new(|_| None),
        }
    }

    /// A table with the positions and names in its rows.
    #[must_use]
    pub fn table(table: &'a Table) -> Self {
        Self::planar(table).with_names(|f| table.faces.get(f.index())?.as_ref()?.name.as_deref())
    }

    /// A surface in space. Faces for which `is_boundary` holds stand for its borders and are not written.
    pub fn surface<V: View>(
        view: &'a V,
        position: impl Fn(VertexId) -> Option<[f64; 3]> + 'a,
        is_boundary: impl Fn(FaceId) -> bool + 'a,
    ) -> Self {
        Self {
            view,
            in_space: true,
            position: Box::new(position),
            no_polygon: Box::new(is_boundary),
            name: Box::new(|_| None),
        }
    }

    /// The same with names of the faces.
    #[must_use]
    pub fn with_names(self, name: impl Fn(FaceId) -> Option<&'a str> + 'a) -> Self {
        Self { name: Box::new(name), ..self }
    }

    pub(super) fn position(&self, v: VertexId) -> Option<[f64; 3]> {
        (self.position)(v)
    }

    pub(super) fn name(&self, f: FaceId) -> Option<&'a str> {
        (self.name)(f)
    }

    pub(super) fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        (0..self.view.vertex_bound() as u32).map(VertexId).filter(|&v| self.view.has_vertex(v))
    }

    pub(super) fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> + '_ {
        (0..self.view.half_edge_bound() as u32).map(HalfEdgeId).filter(|&h| self.view.has_half_edge(h))
    }

    pub(super) fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..self.view.face_bound() as u32).map(FaceId).filter(|&f| self.view.has_face(f))
    }

    fn is_polygon(&self, f: FaceId) -> bool {
        self.view.has_face(f) && !(self.no_polygon)(f)
    }
}

/// A model as points and polygons, numbered from 0 without gaps.
pub(super) struct Polygons {
    /// The vertex of each point.
    pub(super) points: Vec<[f64; 3]>,
    /// The face of each polygon.
    pub(super) faces: Vec<FaceId>,
    /// The corners of each polygon.
    pub(super) list: PolygonList,
}

impl Polygons {
    /// Takes the polygons out of a model. O(size).
    ///
    /// # Errors
    /// Whatever polygons cannot hold: see [`WriteError`].
    pub(super) fn of(model: &Model<'_>, format: Format) -> Result<Self, WriteError> {
        let view = model.view;
        check_edges(model, format)?;
        let mut numbers = VertexMap::filled(view.vertex_bound(), u32::MAX);
        let mut points = Vec::new();
        for v in model.vertices() {
            let alone = view.outgoing(v).is_none();
            if alone && format == Format::GeoJson {
                return Err(WriteError::Lost { element: v.into(), format: format.name() });
            }
            numbers[v] = points.len() as u32;
            points.push(model.position(v).ok_or(WriteError::NoPosition { vertex: v })?);
        }
        let mut polygons = Self { points, faces: Vec::new(), list: PolygonList::new() };
        let mut corners = Vec::new();
        let mut simple = SimpleCycles::default();
        for f in model.faces().filter(|&f| model.is_polygon(f)) {
            let rings = view.inner_components(f);
            let isolated = rings.iter().any(|ring| matches!(ring, InnerComponent::Isolated(_)));
            if isolated || (!rings.is_empty() && format != Format::GeoJson) {
                return Err(WriteError::FaceHasRings { face: f, format: format.name() });
            }
            let start = view.half_edge(f).ok_or(WriteError::NoBoundary { face: f })?;
            for (i, start) in [start].into_iter().chain(rings.iter().filter_map(|ring| ring.cycle())).enumerate() {
                cycle(view, f, start, &numbers, &mut corners)?;
                match simple.cut(&corners, polygons.points.len()) {
                    None if i == 0 => polygons.list.push_face(&corners),
                    None => polygons.list.push_hole(&corners),
                    Some(twice) => {
                        let (around, inside) = simple.parts(&polygons.points);
                        if format != Format::GeoJson || around.len() != usize::from(i == 0) {
                            let vertex = model.vertices().nth(twice as usize).unwrap_or(VertexId(twice));
                            return Err(WriteError::VertexTwice { face: f, vertex, format: format.name() });
                        }
                        around.into_iter().for_each(|cycle| polygons.list.push_face(cycle));
                        inside.into_iter().for_each(|cycle| polygons.list.push_hole(cycle));
                    }
                }
            }
            polygons.faces.push(f);
        }
        Ok(polygons)
    }
}

/// Refuses edges that no polygon shows: with the same polygon on both sides, or with none.
fn check_edges(model: &Model<'_>, format: Format) -> Result<(), WriteError> {
    let side = |h| model.view.face(h).filter(|&f| model.is_polygon(f));
    for h in model.half_edges() {
        let twin = model.view.twin(h);
        match (side(h), twin.and_then(side)) {
            (None, None) => return Err(WriteError::Lost { element: h.into(), format: format.name() }),
            (Some(a), Some(b)) if a == b => {
                return Err(WriteError::SameFaceTwice {
                    half_edge: h,
                    face: a,
                    in_space: model.in_space,
                    format: format.name(),
                });
            }
            _ => {}
        }
    }
    // In the plane, straight edges with the same ends would lie over each other.
    if model.in_space { check_ends(model, format) } else { Ok(()) }
}

/// Refuses two edges with the same ends. O(E log d), with d the most edges at a vertex.
fn check_ends(model: &Model<'_>, format: Format) -> Result<(), WriteError> {
    let ends = |h: HalfEdgeId| {
        let [a, b] = [Some(h), model.view.twin(h)].map(|h| h.and_then(|h| model.view.origin(h)));
        a.zip(b).map(|(a, b)| (a.min(b), a.max(b))).filter(|(a, _)| a.index() < model.view.vertex_bound())
    };
    let edges =
        (0..model.view.half_edge_bound() as u32).step_by(2).filter(|&h| model.view.has_half_edge(HalfEdgeId(h)));
    let pairs = edges.filter_map(|h| ends(HalfEdgeId(h)).map(|(a, _)| (a.index(), h)));
    let mut by_vertex = Groups::new(model.view.vertex_bound(), pairs);
    for v in 0..model.view.vertex_bound() {
        let here = by_vertex.of_mut(v);
        here.sort_unstable_by_key(|&h| (ends(HalfEdgeId(h)), h));
        let same = here.windows(2).find(|pair| ends(HalfEdgeId(pair[0])) == ends(HalfEdgeId(pair[1])));
        if let Some(pair) = same {
            let edges = [pair[0], pair[1]].map(|h| HalfEdgeId(h).edge());
            return Err(WriteError::EdgeTwice { edges, format: format.name() });
        }
    }
    Ok(())
}

/// A cycle cut where it passes a vertex twice, into cycles that pass each of their vertices once.
///
/// ```text
///   3 ●─────────────● 2
///     │   5 ●       │        0 1 2 3 0 4 5   ──>   0 1 2 3   round the face
///     │    ╱ ╲      │                              0 4 5     round what it leaves out
///     │   ╱   ● 4   │
///     │  ╱ ╱        │
///   0 ●─────────────● 1
/// ```
#[derive(Default)]
struct SimpleCycles {
    cycles: Vec<Vec<u32>>,
    /// Where in the walk so far a vertex stands, or `u32::MAX`.
    places: Vec<u32>,
    walk: Vec<u32>,
}

impl SimpleCycles {
    /// Cuts a cycle; `bound` is above all vertices. Returns a vertex that it passes twice; if there is none, nothing is
    /// kept. O(corners).
    fn cut(&mut self, corners: &[u32], bound: usize) -> Option<u32> {
        self.cycles.clear();
        self.places.resize(bound, u32::MAX);
        let mut twice = None;
        for &v in corners {
            let place = self.places[v as usize];
            if place != u32::MAX {
                twice.get_or_insert(v);
                let cycle: Vec<u32> = self.walk.drain(place as usize..).collect();
                cycle.iter().for_each(|&u| self.places[u as usize] = u32::MAX);
                self.cycles.push(cycle);
            }
            self.places[v as usize] = self.walk.len() as u32;
            self.walk.push(v);
        }
        self.walk.iter().for_each(|&u| self.places[u as usize] = u32::MAX);
        let last = std::mem::take(&mut self.walk);
        if twice.is_some() {
            self.cycles.push(last);
        } else {
            self.walk = last;
            self.walk.clear();
        }
        twice
    }

    /// The cycles that run counter-clockwise, and the others.
    fn parts(&self, points: &[[f64; 3]]) -> (Vec<&Vec<u32>>, Vec<&Vec<u32>>) {
        let at = |&v: &u32| points[v as usize];
        self.cycles.iter().partition(|cycle| encloses(cycle.iter().map(at).map(|[x, y, _]| Point::new(x, y))))
    }
}

/// The corners of the cycle through `start`.
fn cycle(
    view: &dyn View,
    face: FaceId,
    start: HalfEdgeId,
    numbers: &VertexMap<u32>,
    corners: &mut Vec<u32>,
) -> Result<(), WriteError> {
    corners.clear();
    let mut h = start;
    for _ in 0..view.half_edge_bound() {
        let number = view.origin(h).and_then(|v| numbers.get(v).copied()).filter(|&n| n != u32::MAX);
        corners.push(number.ok_or(WriteError::BrokenCycle { face, half_edge: h })?);
        match view.next(h).filter(|&next| view.has_half_edge(next)) {
            Some(next) if next == start => return Ok(()),
            Some(next) => h = next,
            None => break,
        }
    }
    Err(WriteError::BrokenCycle { face, half_edge: h })
}
