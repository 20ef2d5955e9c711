//! Half-edges alone: edits, and steps of subdivision.

use crate::Random;
use crate::rows::{Prepared, work};
use alum::{DVec3, EditableTopology, HH, HasTopology, PolyMeshF32, PolyMeshF64, VH};
use dcel_kit::HalfEdgeId;
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Polyhedron, Selection};
use dcel_kit::topology::{Dcel, PolygonList};

/// A square grows to so many edges, so often.
const EDGES: usize = 10_000;
const TIMES: usize = 50;
/// Steps about the axis of a torus and about its tube: each quad becomes four.
const SIDE: usize = 500;

/// Which half-edge, as a part of all, and whether its face is to be split, else its edge.
pub fn choices() -> Vec<f64> {
    let mut random = Random::new(5);
    let mut all = vec![(EDGES * TIMES) as f64, EDGES as f64, TIMES as f64];
    all.extend((0..4 * EDGES).map(|_| random.unit()));
    all
}

fn chosen() -> impl Iterator<Item = (f64, bool)> {
    let all = choices();
    let pairs: Vec<(f64, bool)> = all[3..].chunks_exact(2).map(|pair| (pair[0], pair[1] < 0.5)).collect();
    pairs.into_iter()
}

pub fn our_splits() -> Prepared {
    #[derive(Clone, Copy)]
    enum Edit {
        Edge(HalfEdgeId),
        Face(HalfEdgeId, HalfEdgeId),
    }
    let grow = |d: &mut Dcel, edit: Edit| match edit {
        Edit::Edge(h) => drop(d.split_edge(h).expect("there is room")),
        Edit::Face(a, b) => drop(d.split_face(a, b).expect("the face has more than three sides")),
    };
    let start = Dcel::polygon(4).expect("a square");
    let (mut d, mut script) = (start.clone(), Vec::new());
    for (at, splits_face) in chosen().take(EDGES - 4) {
        let h = HalfEdgeId::new((at * d.half_edge_count() as f64) as u32);
        let third = d.next(d.next(h));
        let is_large = d.next(third) != h && third != h;
        let edit = if splits_face && is_large { Edit::Face(third, h) } else { Edit::Edge(h) };
        grow(&mut d, edit);
        script.push(edit);
    }
    work(script.len() * TIMES, move || {
        let grown = |_| {
            let mut d = start.clone();
            d.reserve(EDGES, EDGES, EDGES);
            script.iter().for_each(|&edit| grow(&mut d, edit));
            d
        };
        (0..TIMES).map(grown).collect::<Vec<_>>()
    })
}

pub fn alum_splits() -> Prepared {
    #[derive(Clone, Copy)]
    enum Edit {
        Edge(HH),
        Face(HH, HH),
    }
    let square = || {
        let mut mesh = PolyMeshF32::with_capacity(EDGES, EDGES, EDGES);
        let corners: Vec<VH> = (0..4).map(|_| mesh.add_vertex(Default::default()).expect("a vertex fits")).collect();
        mesh.add_face(&corners).expect("a square is a face");
        mesh
    };
    let grow = |mesh: &mut PolyMeshF32, edit: Edit| match edit {
        Edit::Edge(h) => {
            let v = mesh.add_vertex(Default::default()).expect("a vertex fits");
            EditableTopology::split_edge(mesh, h, v, false).expect("there is room");
        }
        Edit::Face(prev, next) => drop(mesh.insert_edge(prev, next, None).expect("the face is large")),
    };
    let (mut mesh, mut script) = (square(), Vec::new());
    for (at, splits_face) in chosen().take(EDGES - 4) {
        let h = HH::from((at * mesh.num_halfedges() as f64) as u32);
        let third = h.next(&mesh).next(&mesh);
        let is_large = third.next(&mesh) != h && h.face(&mesh).is_some();
        let edit = if splits_face && is_large { Edit::Face(h.prev(&mesh), third) } else { Edit::Edge(h) };
        grow(&mut mesh, edit);
        script.push(edit);
    }
    work(script.len() * TIMES, move || {
        let grown = |_| {
            let mut mesh = square();
            script.iter().for_each(|&edit| grow(&mut mesh, edit));
            mesh
        };
        (0..TIMES).map(grown).collect::<Vec<_>>()
    })
}

/// Corners and faces of a torus: quads, or each quad as two triangles.
fn torus(triangles: bool) -> (Vec<[f64; 3]>, Vec<Vec<u32>>) {
    let solid = Shape::Torus { n: SIDE, m: SIDE }.build().expect("a torus of this size fits").polyhedron;
    let mut faces = Vec::new();
    for f in solid.faces() {
        let c: Vec<u32> = solid.incident_vertices(f).map(|v| v.number()).collect();
        if triangles {
            faces.extend([vec![c[0], c[1], c[2]], vec![c[0], c[2], c[3]]]);
        } else {
            faces.push(c);
        }
    }
    (solid.vertices().map(|v| solid.point(v)).collect(), faces)
}

/// The same as numbers: new faces, vertices, faces, corners of a face, then places and corners.
pub fn torus_in_numbers(triangles: bool) -> Vec<f64> {
    let (points, faces) = torus(triangles);
    let head = [4 * faces.len(), points.len(), faces.len(), faces[0].len()].map(|n| n as f64);
    let corners = faces.iter().flatten().map(|&v| f64::from(v));
    head.into_iter().chain(points.into_iter().flatten()).chain(corners).collect()
}

pub fn our_subdivision(triangles: bool) -> Prepared {
    let (points, faces) = torus(triangles);
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    let solid = Polyhedron::from_polygons(points, &list).expect("the faces of a torus fit together");
    let none = Selection::new();
    work(4 * faces.len(), move || {
        let step = if triangles { solid.loop_subdivision(&none) } else { solid.catmull_clark(&none) };
        step.expect("it fits").polyhedron
    })
}

/// The peer works in place: each time on a mesh that was made before.
pub fn alum_subdivision(triangles: bool) -> Prepared {
    let (points, faces) = torus(triangles);
    let mesh = || {
        let mut mesh = PolyMeshF64::with_capacity(points.len(), 3 * points.len(), faces.len());
        for p in &points {
            mesh.add_vertex(DVec3(p[0], p[1], p[2])).expect("a vertex fits");
        }
        for face in &faces {
            let corners: Vec<VH> = face.iter().map(|&v| VH::from(v)).collect();
            mesh.add_face(&corners).expect("the faces of a torus fit together");
        }
        mesh
    };
    let mut ready: Vec<PolyMeshF64> = (0..4).map(|_| mesh()).collect();
    work(4 * faces.len(), move || {
        let mut mesh = ready.pop().expect("one for each run");
        let step = if triangles { mesh.subdivide_loop(1, true) } else { mesh.subdivide_catmull_clark(1, true) };
        step.expect("it fits");
        mesh
    })
}
