//! Walks round every vertex and round every face, against crate lox, ns per half-edge.
//!
//! "links" reads only what the walk itself needs; "neighbours" also reads the vertex at the other end, as the
//! iterators of lox always do.

use dcel_kit::topology::Dcel;
use dcel_kit_benches::{compare, print, program, three_orders};
use lox::core::{HalfEdgeMesh, half_edge::PolyConfig};
use lox::prelude::*;

fn rings(d: &Dcel) -> u32 {
    d.vertices().flat_map(|v| d.outgoing_half_edges(v)).fold(0_u32, |sum, h| sum ^ h.number())
}

fn neighbours(d: &Dcel) -> u32 {
    d.vertices().flat_map(|v| d.adjacent_vertices(v)).fold(0_u32, |sum, v| sum ^ v.number())
}

fn faces(d: &Dcel) -> u32 {
    d.faces().flat_map(|f| d.incident_half_edges(f)).fold(0_u32, |sum, h| sum ^ h.number())
}

fn corners(d: &Dcel) -> u32 {
    d.faces().flat_map(|f| d.incident_vertices(f)).fold(0_u32, |sum, v| sum ^ v.number())
}

fn main() {
    for input in three_orders(1_000_000) {
        let plain = Dcel::from_triangles(input.vertices, &input.triangles).expect("the triangles are a surface").dcel;
        let mut compact = plain.clone();
        let _ = compact.compact();
        let mut lox = HalfEdgeMesh::<PolyConfig>::empty();
        for _ in 0..input.vertices {
            lox.add_vertex();
        }
        for t in &input.triangles {
            lox.add_triangle(t.map(lox::VertexHandle::new));
        }
        let lox_rings = || {
            let around = lox.vertex_handles().flat_map(|v| lox.vertices_around_vertex(v));
            around.fold(0_u32, |sum, v| sum ^ v.idx())
        };
        let lox_faces = || {
            let around = lox.face_handles().flat_map(|f| lox.vertices_around_face(f));
            around.fold(0_u32, |sum, v| sum ^ v.idx())
        };
        let mut programs = [
            program("vertices: neighbours", || neighbours(&plain)),
            program("  links", || rings(&plain)),
            program("  compacted, neighbours", || neighbours(&compact)),
            program("  compacted, links", || rings(&compact)),
            program("  lox half-edge", lox_rings),
            program("faces: corners", || corners(&plain)),
            program("  links", || faces(&plain)),
            program("  compacted, corners", || corners(&compact)),
            program("  compacted, links", || faces(&compact)),
            program("  lox half-edge", lox_faces),
        ];
        let ns = compare(&mut programs, 7, plain.half_edge_count());
        print(&format!("{}, ns per half-edge", input.name), &programs[..5], &ns[..5]);
        print(&format!("{}, ns per half-edge", input.name), &programs[5..], &ns[5..]);
    }
}
