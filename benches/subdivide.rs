//! One step of subdivision to 10^6 faces, ns per new face: Catmull–Clark on quads, Loop on triangles.

use alum::{DVec3, PolyMeshF64, VH};
use dcel_kit::VertexId;
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Polyhedron, Selection};
use dcel_kit::topology::PolygonList;
use dcel_kit_benches::{Program, compare, print, program};

/// Steps about the axis and about the tube: each quad becomes four.
const SIDE: usize = 500;

type Lists = (Vec<[f64; 3]>, Vec<Vec<u32>>);

fn torus() -> Polyhedron {
    Shape::Torus { n: SIDE, m: SIDE }.build().expect("a torus of this size fits").polyhedron
}

fn lists(solid: &Polyhedron, triangles: bool) -> Lists {
    let points = (0..solid.vertex_bound() as u32).map(|v| solid.point(VertexId::new(v))).collect();
    let mut faces = Vec::new();
    for f in solid.faces() {
        let c: Vec<u32> = solid.incident_vertices(f).map(VertexId::number).collect();
        if triangles {
            faces.extend([vec![c[0], c[1], c[2]], vec![c[0], c[2], c[3]]]);
        } else {
            faces.push(c);
        }
    }
    (points, faces)
}

fn ours((points, faces): &Lists) -> Polyhedron {
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    Polyhedron::from_polygons(points.clone(), &list).expect("the faces of a torus fit together")
}

fn theirs((points, faces): &Lists) -> PolyMeshF64 {
    let mut mesh = PolyMeshF64::with_capacity(points.len(), 3 * points.len(), faces.len());
    for p in points {
        mesh.add_vertex(DVec3(p[0], p[1], p[2])).expect("a vertex fits");
    }
    for face in faces {
        let corners: Vec<VH> = face.iter().map(|&v| VH::from(v)).collect();
        mesh.add_face(&corners).expect("the faces of a torus fit together");
    }
    mesh
}

/// A program that subdivides a mesh of the peer, which is made anew each time.
fn peer<'a>(name: &'a str, lists: &'a Lists, step: fn(&mut PolyMeshF64)) -> Program<'a> {
    let prepare = move || -> dcel_kit_benches::Run<'a> {
        let mut mesh = theirs(lists);
        Box::new(move || {
            step(&mut mesh);
            Box::new(mesh)
        })
    };
    (name, Box::new(prepare))
}

fn main() {
    let none = Selection::new();
    let quads = lists(&torus(), false);
    let solid = ours(&quads);
    let mut programs = [
        program("Catmull-Clark", || solid.catmull_clark(&none).expect("it fits")),
        peer("alum", &quads, |mesh| mesh.subdivide_catmull_clark(1, true).expect("it fits")),
    ];
    let ns = compare(&mut programs, 7, 4 * quads.1.len());
    print("Catmull-Clark, ns per new face, 10^6 of them", &programs, &ns);

    let triangles = lists(&torus(), true);
    let solid = ours(&triangles);
    let mut programs = [
        program("Loop", || solid.loop_subdivision(&none).expect("it fits")),
        peer("alum", &triangles, |mesh| mesh.subdivide_loop(1, true).expect("it fits")),
    ];
    let ns = compare(&mut programs, 7, 4 * triangles.1.len());
    print("Loop, ns per new face, 2 * 10^6 of them", &programs, &ns);
}
