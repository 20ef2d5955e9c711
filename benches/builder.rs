//! Lists of triangles to half-edge structures, against other crates.
//!
//! `cargo bench --bench builder` measures 10^6 triangles in three orders; `-- linear` our growth to 10^7.

use dcel_kit::topology::Dcel;
use dcel_kit_benches::{compare, ordered, print, program, shuffled, three_orders};
use lox::core::{DirectedEdgeMesh, HalfEdgeMesh, half_edge::TriConfig};
use lox::prelude::*;

fn lox<M: MeshMut + 'static>(vertices: usize, triangles: &[[u32; 3]]) -> M {
    let mut mesh = M::empty();
    mesh.reserve_for_vertices(vertices as u32);
    mesh.reserve_for_faces(triangles.len() as u32);
    for _ in 0..vertices {
        mesh.add_vertex();
    }
    for t in triangles {
        mesh.add_triangle(t.map(lox::VertexHandle::new));
    }
    mesh
}

fn alum(vertices: usize, triangles: &[[u32; 3]]) -> alum::PolyMeshF32 {
    let mut mesh = alum::PolyMeshF32::with_capacity(vertices, vertices * 3, triangles.len());
    for _ in 0..vertices {
        mesh.add_vertex(Default::default()).expect("a vertex fits");
    }
    for t in triangles {
        let [a, b, c] = t.map(alum::VH::from);
        mesh.add_tri_face(a, b, c).expect("the triangles are a surface");
    }
    mesh
}

fn ours(vertices: usize, triangles: &[[u32; 3]]) -> Dcel {
    Dcel::from_triangles(vertices, triangles).expect("the triangles are a surface").dcel
}

fn main() {
    if std::env::args().any(|arg| arg == "linear") {
        return linear();
    }
    let goals = ["<= 1.0 lox", "<= 0.25 lox", "<= 0.85 lox"];
    for (input, goal) in three_orders(1_000_000).iter().zip(goals) {
        let (n, t) = (input.vertices, &input.triangles[..]);
        let dcel = ours(n, t);
        let mut programs = [
            program("dcel-kit", || ours(n, t)),
            program("copy of the result", || dcel.clone()),
            program("lox half-edge", || lox::<HalfEdgeMesh<TriConfig>>(n, t)),
            program("lox directed edge", || lox::<DirectedEdgeMesh>(n, t)),
            program("alum", || alum(n, t)),
        ];
        let ns = compare(&mut programs, 7, t.len());
        print(&format!("{}, ns per triangle (goal {goal})", input.name), &programs, &ns);
    }
}

fn linear() {
    for count in [10_000, 100_000, 1_000_000, 10_000_000] {
        for input in [ordered(count), shuffled(count)] {
            let mut programs = [program("dcel-kit", || ours(input.vertices, &input.triangles))];
            let ns = compare(&mut programs, 7, count);
            print(&format!("{}, {count} triangles, ns per triangle", input.name), &programs, &ns);
        }
    }
}
