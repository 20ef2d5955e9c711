//! Random splits that grow a polygon to 10^4 edges, and joins that take it back, ns per operation.
//!
//! Each operation takes a random half-edge and either splits its edge or, if its face has more than three
//! sides, cuts a triangle off. The choices are made beforehand, so that only the edits are measured. Then the same with
//! the two primitives: in place of its edge its origin is split, and up to three half-edges move.

use alum::{EditableTopology, HH, HasTopology, VH};
use dcel_kit::topology::Dcel;
use dcel_kit::{FaceId, HalfEdgeId};
use dcel_kit_benches::{Program, Random, Run, compare, print};

const EDGES: usize = 10_000;
/// How often the script is run for one measurement.
const TIMES: usize = 50;

/// An edit of ours. The new faces are the triangles.
#[derive(Clone, Copy)]
enum Edit {
    SplitEdge(HalfEdgeId),
    SplitFace(HalfEdgeId, HalfEdgeId),
}

/// The script, and the half-edges that take it back: joined from the end.
fn script() -> Vec<(Edit, HalfEdgeId)> {
    let mut random = Random::new(5);
    let mut d = square();
    let mut script = Vec::new();
    while d.edge_count() < EDGES {
        let h = HalfEdgeId::new(random.below(d.half_edge_count()) as u32);
        let third = d.next(d.next(h));
        if random.below(2) == 0 && d.next(third) != h && third != h {
            let (new, _) = d.split_face(third, h).expect("the face has more than three sides");
            script.push((Edit::SplitFace(third, h), new));
        } else {
            d.split_edge(h).expect("there is room");
            script.push((Edit::SplitEdge(h), h));
        }
    }
    script
}

fn square() -> Dcel {
    Dcel::polygon(4).expect("a square is a polygon")
}

fn grow(d: &mut Dcel, script: &[(Edit, HalfEdgeId)]) {
    for &(edit, _) in script {
        match edit {
            Edit::SplitEdge(h) => drop(d.split_edge(h).expect("recorded")),
            Edit::SplitFace(h1, h2) => drop(d.split_face(h1, h2).expect("recorded")),
        }
    }
}

fn join(d: &mut Dcel, script: &[(Edit, HalfEdgeId)]) {
    for &(edit, h) in script.iter().rev() {
        match edit {
            Edit::SplitEdge(_) => drop(d.join_edges(h).expect("recorded")),
            Edit::SplitFace(..) => drop(d.join_faces(h).expect("recorded")),
        }
    }
}

/// A vertex split in place of the edge split; both arguments are half-edges.
#[derive(Clone, Copy)]
enum Primitive {
    SplitVertex(HalfEdgeId, HalfEdgeId),
    SplitFace(HalfEdgeId, HalfEdgeId),
}

/// The script of the two primitives, and the new half-edges, which take it back.
fn primitives() -> Vec<(Primitive, HalfEdgeId)> {
    let mut random = Random::new(6);
    let mut d = square();
    let mut script = Vec::new();
    while d.edge_count() < EDGES {
        let h = HalfEdgeId::new(random.below(d.half_edge_count()) as u32);
        let third = d.next(d.next(h));
        if random.below(2) == 0 && d.next(third) != h && third != h {
            let (new, _) = d.split_face(third, h).expect("the face has more than three sides");
            script.push((Primitive::SplitFace(third, h), new));
        } else {
            let last = (0..random.below(4)).fold(h, |x, _| d.ccw(x));
            let (new, _) = d.split_vertex(h, last).expect("both start at one vertex");
            script.push((Primitive::SplitVertex(h, last), new));
        }
    }
    script
}

fn grow_by_primitives(d: &mut Dcel, script: &[(Primitive, HalfEdgeId)]) {
    for &(edit, _) in script {
        match edit {
            Primitive::SplitVertex(first, last) => drop(d.split_vertex(first, last).expect("recorded")),
            Primitive::SplitFace(h1, h2) => drop(d.split_face(h1, h2).expect("recorded")),
        }
    }
}

fn join_by_primitives(d: &mut Dcel, script: &[(Primitive, HalfEdgeId)]) {
    for &(edit, h) in script.iter().rev() {
        match edit {
            Primitive::SplitVertex(..) => drop(d.join_vertices(h).expect("recorded")),
            Primitive::SplitFace(..) => drop(d.join_faces(h).expect("recorded")),
        }
    }
}

/// The same edits in alum: split an edge with a new vertex, or insert an edge from one half-edge to another.
#[derive(Clone, Copy)]
enum AlumEdit {
    SplitEdge(HH),
    InsertEdge(HH, HH),
}

fn alum_square() -> alum::PolyMeshF32 {
    let mut mesh = alum::PolyMeshF32::with_capacity(EDGES, EDGES, EDGES);
    let corners: Vec<VH> = (0..4).map(|_| mesh.add_vertex(Default::default()).expect("a vertex fits")).collect();
    mesh.add_face(&corners).expect("a square is a face");
    mesh
}

fn alum_grow(mesh: &mut alum::PolyMeshF32, script: &[AlumEdit]) {
    for &edit in script {
        match edit {
            AlumEdit::SplitEdge(h) => {
                let v = mesh.add_vertex(Default::default()).expect("a vertex fits");
                EditableTopology::split_edge(mesh, h, v, false).expect("recorded");
            }
            AlumEdit::InsertEdge(prev, next) => drop(mesh.insert_edge(prev, next, None).expect("recorded")),
        }
    }
}

fn alum_script() -> Vec<AlumEdit> {
    let mut random = Random::new(5);
    let mut mesh = alum_square();
    let mut script = Vec::new();
    while mesh.num_edges() < EDGES {
        let h = HH::from(random.below(mesh.num_halfedges()) as u32);
        let third = h.next(&mesh).next(&mesh);
        let edit = if random.below(2) == 0 && third.next(&mesh) != h && h.face(&mesh).is_some() {
            AlumEdit::InsertEdge(h.prev(&mesh), third)
        } else {
            AlumEdit::SplitEdge(h)
        };
        alum_grow(&mut mesh, &[edit]);
        script.push(edit);
    }
    script
}

/// A program that edits copies, which are made beforehand.
fn on_copies<'a, T: Copies>(name: &'a str, start: &'a T, edit: impl Fn(&mut T::Copy) + Copy + 'a) -> Program<'a> {
    let prepare = move || -> Run<'a> {
        let mut all: Vec<_> = (0..TIMES).map(|_| start.copy()).collect();
        Box::new(move || {
            all.iter_mut().for_each(edit);
            Box::new(all)
        })
    };
    (name, Box::new(prepare))
}

trait Copies {
    type Copy: 'static;
    fn copy(&self) -> Self::Copy;
}

/// Copies get the room of the grown structure, as those of alum do.
impl Copies for Dcel {
    type Copy = Self;
    fn copy(&self) -> Self {
        let mut copy = self.clone();
        let room = EDGES.saturating_sub(self.edge_count());
        copy.reserve(room, room, room);
        copy
    }
}

/// Meshes of alum cannot be cloned here: each is made anew.
struct AlumStart;

impl Copies for AlumStart {
    type Copy = (alum::PolyMeshF32,);
    fn copy(&self) -> Self::Copy {
        (alum_square(),)
    }
}

fn main() {
    let script = script();
    let alum_script = alum_script();
    let start = square();
    let mut grown = start.clone();
    grow(&mut grown, &script);
    let small = (0..grown.face_bound()).filter(|&f| grown.incident_half_edges(FaceId::new(f as u32)).count() < 8);
    println!("{} edits, {} of {} faces have fewer than 8 sides\n", script.len(), small.count(), grown.face_count());

    let mut programs = [
        on_copies("splits", &start, |d| grow(d, &script)),
        on_copies("joins", &grown, |d| join(d, &script)),
        on_copies("alum splits", &AlumStart, |mesh| alum_grow(&mut mesh.0, &alum_script)),
    ];
    let ns = compare(&mut programs, 15, TIMES * script.len());
    print("ns per edit (goal: splits <= 17 ns on a quiet machine, <= 0.17 alum)", &programs, &ns);

    let script = primitives();
    let mut grown = start.clone();
    grow_by_primitives(&mut grown, &script);
    let mut programs = [
        on_copies("vertex and face splits", &start, |d| grow_by_primitives(d, &script)),
        on_copies("vertex and face joins", &grown, |d| join_by_primitives(d, &script)),
    ];
    let ns = compare(&mut programs, 15, TIMES * script.len());
    print("ns per edit, the two primitives", &programs, &ns);
}
