//! The structures that the tour and the reference figures show.

use super::Made;
use dcel_kit::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use dcel_kit::io::{Document, Format, ReadOptions, read_bytes};
use dcel_kit::plane::{ConvertOptions, Point, Subdivision};
use dcel_kit::sources;
use dcel_kit::topology::{PolygonList, Table};
use std::collections::BTreeSet;

/// One of the two edits of the lab, by the numbers of its half-edges.
#[derive(Clone, Copy)]
pub(crate) enum LabStep {
    SplitFace(u32, u32),
    SplitInHalf(u32),
}

/// From the six-vertex rectangle to 8 vertices, 12 edges and 6 faces, with the two edits alone.
pub(crate) const LAB_STEPS: [LabStep; 6] = [
    LabStep::SplitFace(2, 8),
    LabStep::SplitInHalf(12),
    LabStep::SplitFace(6, 13),
    LabStep::SplitFace(14, 10),
    LabStep::SplitInHalf(16),
    LabStep::SplitFace(20, 4),
];

/// Makes one step; the answer names what is new.
pub(crate) fn take_step(lab: &mut Subdivision, step: LabStep) -> Made<String> {
    Ok(match step {
        LabStep::SplitFace(h1, h2) => {
            let (h1, h2) = (HalfEdgeId::new(h1), HalfEdgeId::new(h2));
            let (new, face) = lab.split_face(h1, h2)?;
            let (from, to) = (lab.origin(new), lab.destination(new));
            format!("split_face({h1}, {h2})   joins {from} and {to} by {new} and {}: new face {face}", new.twin())
        }
        LabStep::SplitInHalf(h) => {
            let h = HalfEdgeId::new(h);
            let (middle, after) = lab.split_in_half(h)?;
            format!("split_in_half({h})   puts {middle} at {}: {after} follows {h}", lab.point(middle))
        }
    })
}

/// The result of [`LAB_STEPS`].
pub(crate) fn lab_subdivision() -> Made<Subdivision> {
    let mut lab = Subdivision::lab_rectangle();
    for step in LAB_STEPS {
        take_step(&mut lab, step)?;
    }
    Ok(lab)
}

/// A square in a square with their corners joined: 8 vertices, 12 edges, 6 faces, like a cube seen from above.
pub(crate) fn cube() -> Made<Subdivision> {
    let points = [(0., 0.), (6., 0.), (6., 6.), (0., 6.), (1.8, 1.8), (4.2, 1.8), (4.2, 4.2), (1.8, 4.2)];
    quads(points)
}

/// A quad inside of another one, and those between their sides: the corners of the outer one, then of the inner one.
pub(crate) fn quads(points: [(f64, f64); 8]) -> Made<Subdivision> {
    let mut faces = PolygonList::new();
    for face in [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]] {
        faces.push_face(&face);
    }
    Ok(Subdivision::from_polygons(points.map(Point::from).to_vec(), &faces)?)
}

/// The corners of the bounded faces of a triangulation.
pub(crate) fn triangles(plane: &Subdivision) -> impl Iterator<Item = [Point; 3]> {
    let corners = |f| plane.incident_vertices(f).map(|v| plane.point(v)).collect::<Vec<_>>();
    plane.faces().skip(1).filter_map(move |f| corners(f).try_into().ok())
}

/// The cube as somebody might hand it in: the edge v5-v6 is missing, v5-v7 is too much, the half-edge from v4 to v0
/// goes back on its own twin, and v2 has slipped.
pub(crate) fn wrong_cube() -> Made<Table> {
    let mut cube = cube()?;
    let between = |plane: &Subdivision, from: u32, to: u32| {
        let ends = [from, to].map(VertexId::new);
        plane.edges().flat_map(EdgeId::half_edges).find(|&h| [plane.origin(h), plane.destination(h)] == ends)
    };
    if let Some(h) = between(&cube, 5, 6) {
        cube.join_faces(h)?;
    }
    if let (Some(before), Some(after)) = (between(&cube, 4, 5), between(&cube, 6, 7)) {
        cube.split_face(cube.next(before), cube.next(after))?;
    }
    let mut table = Table::from_planar_view(&cube);
    if let Some(h) = between(&cube, 4, 0)
        && let Some(row) = &mut table.half_edges[h.index()]
    {
        row.next = row.twin;
    }
    if let Some(row) = &mut table.vertices[2] {
        row.position = Some([6.25, 6.25]);
    }
    Ok(table)
}

/// A square grid of `side` times `side` faces.
pub(crate) fn grid(side: u32) -> Made<Subdivision> {
    let across = side + 1;
    let points = (0..across * across).map(|k| Point::new(f64::from(k % across), f64::from(k / across)));
    let mut faces = PolygonList::new();
    for k in (0..across * side).filter(|k| k % across < side) {
        faces.push_face(&[k, k + 1, k + across + 1, k + across]);
    }
    Ok(Subdivision::from_polygons(points.collect(), &faces)?)
}

/// A face with two holes, an island in one of them, a second component outside.
pub(crate) fn rings() -> Made<Subdivision> {
    let points = [
        [(0., 0.), (14., 0.), (14., 8.), (0., 8.)].as_slice(),
        &[(1., 1.), (7., 1.), (7., 7.), (1., 7.)],
        &[(8.4, 1.4), (12.8, 1.4), (10.8, 6.4)],
        &[(2.2, 2.2), (5.8, 2.2), (4.4, 5.6)],
        &[(15.6, 0.6), (20., 0.6), (18.4, 5.6)],
    ];
    let mut faces = PolygonList::new();
    faces.push_face(&[0, 1, 2, 3]);
    faces.push_hole(&[4, 5, 6, 7]);
    faces.push_hole(&[8, 9, 10]);
    faces.push_face(&[11, 12, 13]);
    faces.push_face(&[14, 15, 16]);
    let points = points.concat().into_iter().map(Point::from).collect();
    Ok(Subdivision::from_polygons(points, &faces)?)
}

/// The map of the tour.
pub(crate) struct States {
    pub(crate) subdivision: Subdivision,
    /// The name of the state that face f(i + 1) is a part of.
    names: Vec<Option<String>>,
    /// What the reader dropped.
    pub(crate) notes: Vec<String>,
}

/// The file, as it came: npm package us-atlas 3.0.1, ISC licence, shapes of the US Census Bureau.
const STATES: &[u8] = sources::STATES;
/// What messages call it.
pub(crate) const STATES_FILE: &str = "figures/data/states-albers-10m.json";

/// Converts the map of the states. Its y points down, and it holds one ring without area.
pub(crate) fn states() -> Made<States> {
    let options = ReadOptions { y_down: true, drop_degenerate_rings: true, ..ReadOptions::default() };
    let read = read_bytes(STATES, Format::TopoJson, STATES_FILE, &options)?;
    let Document::Polygons(soup) = read.document else { return Err("the map holds no polygons".into()) };
    let points = soup.points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
    let options = ConvertOptions { orient: true, full_check: true, ..ConvertOptions::default() };
    let subdivision = Subdivision::convert_polygons(points, &soup.faces, &options)?.subdivision;
    Ok(States { subdivision, names: soup.names, notes: read.notes })
}

impl States {
    /// The name of the state that `f` is a part of; none for the outer face.
    pub(crate) fn name(&self, f: FaceId) -> Option<&str> {
        self.names.get(f.index().checked_sub(1)?)?.as_deref()
    }

    /// All faces with their names.
    pub(crate) fn named_faces(&self) -> impl Iterator<Item = (FaceId, &str)> {
        self.subdivision.faces().filter_map(|f| Some((f, self.name(f)?)))
    }

    /// The states across the borders of a state: twins of the half-edges of its faces.
    pub(crate) fn neighbours(&self, state: &str) -> BTreeSet<&str> {
        let map = &self.subdivision;
        self.named_faces()
            .filter(|&(_, name)| name == state)
            .flat_map(|(f, _)| map.cycles(f).flat_map(|h| map.cycle(h)))
            .filter_map(|h| self.name(map.face(h.twin())))
            .filter(|&name| name != state)
            .collect()
    }

    /// The vertices where exactly these states meet.
    pub(crate) fn meeting_points(&self, states: &BTreeSet<&str>) -> Vec<VertexId> {
        let meet = |v: &VertexId| {
            let around: BTreeSet<&str> = self.subdivision.incident_faces(*v).filter_map(|f| self.name(f)).collect();
            around == *states
        };
        self.subdivision.vertices().filter(meet).collect()
    }
}
