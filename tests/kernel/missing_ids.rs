//! An id that does not exist is named, and told how many there are: by every public function that takes one, as an error
//! or as a panic, unless the answer for such an id is an ordinary one.

use dcel_kit::navmesh::{LiveMesh, NavMesh};
use dcel_kit::plane::{ArrangeOptions, Location, Point, Subdivision, TriangulationMethod};
use dcel_kit::solid::grow::{pole, quads};
use dcel_kit::solid::{Direction, Platonic, Polyhedron};
use dcel_kit::topology::{
    Dcel, Editing, IdError, NoObserver, NoRecorder, OwnEditError, PolygonList, TableColumns, components,
};
use dcel_kit::{EdgeId, FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

const V: VertexId = VertexId::new(99);
const H: HalfEdgeId = HalfEdgeId::new(99);
const E: EdgeId = EdgeId::new(99);
const F: FaceId = FaceId::new(99);

/// What was said of functions, each by its name.
#[derive(Default)]
struct Table {
    rows: Vec<(&'static str, String)>,
}

impl Table {
    /// A function that must panic.
    fn panics<T>(&mut self, name: &'static str, call: impl FnOnce() -> T) {
        let said = match catch_unwind(AssertUnwindSafe(|| drop(call()))) {
            Ok(()) => "an answer".to_owned(),
            Err(said) => said.downcast_ref::<String>().cloned().unwrap_or_else(|| "no words".to_owned()),
        };
        self.rows.push((name, said));
    }

    /// A function that must refuse.
    fn refuses<T, E: Display>(&mut self, name: &'static str, answer: Result<T, E>) {
        self.rows.push((name, answer.map_or_else(|error| error.to_string(), |_| "an answer".to_owned())));
    }

    /// Checks what was said, and hands out the names.
    fn checked(self, missing: &[&str]) -> BTreeSet<&'static str> {
        for (name, said) in &self.rows {
            assert!(missing.iter().any(|missing| said.contains(missing)), "{name} said: {said}");
        }
        self.rows.into_iter().map(|(name, _)| name).collect()
    }
}

/// Functions for which an id that does not exist is an ordinary question: `None`, `false`, nothing, or a number made of
/// the id alone. Their answers are in their docs.
const ORDINARY: [&str; 37] = [
    "area",
    "block",
    "bounded_cycle",
    "climb",
    "component",
    "corner_of",
    "corners",
    "distance",
    "portal",
    "portal_path",
    "edge",
    "faces_around",
    "has_edge",
    "has_face",
    "has_half_edge",
    "has_vertex",
    "inner_components",
    "is_blocked",
    "is_boundary_face",
    "is_dead_end",
    "is_hole",
    "is_walkable",
    "is_wall",
    "layer",
    "neighbours",
    "outline",
    "set_hole",
    "set_hole_with",
    "set_wall",
    "sides",
    "support_from",
    "climb_observed",
    "triangles",
    "twin",
    "unblock",
    "vertices",
    "wedges",
];

fn topology() -> BTreeSet<&'static str> {
    let dcel = Dcel::polygon(5).expect("a pentagon");
    let (d, mut t) = (&dcel, Table::default());
    let (mut own, mut none) = (dcel.clone(), NoRecorder);
    t.panics("origin", || d.origin(H));
    t.panics("destination", || d.destination(H));
    t.panics("next", || d.next(H));
    t.panics("prev", || d.prev(H));
    t.panics("face", || d.face(H));
    t.panics("outgoing", || d.outgoing(V));
    t.panics("half_edge", || d.half_edge(F));
    t.panics("ccw", || d.ccw(H));
    t.panics("cw", || d.cw(H));
    t.panics("cycle", || d.cycle(H).count());
    t.panics("star", || d.star(H).count());
    t.panics("incident_half_edges", || d.incident_half_edges(F).count());
    t.panics("incident_vertices", || d.incident_vertices(F).count());
    t.panics("incident_edges", || d.incident_edges(F).count());
    t.panics("adjacent_faces", || d.adjacent_faces(F).count());
    t.panics("outgoing_half_edges", || d.outgoing_half_edges(V).count());
    t.panics("incoming_half_edges", || d.incoming_half_edges(V).count());
    t.panics("adjacent_vertices", || d.adjacent_vertices(V).count());
    t.panics("incident_faces", || d.incident_faces(V).count());
    t.panics("degree", || d.degree(V));
    t.panics("find_half_edge", || d.find_half_edge(V, VertexId::new(0)));
    t.refuses("can_split_face", d.can_split_face(H, H));
    t.refuses("split_face", own.split_face(H, H));
    t.refuses("split_face_with", own.split_face_with(H, H, &mut none));
    t.refuses("can_split_vertex", d.can_split_vertex(H, H));
    t.refuses("split_vertex", own.split_vertex(H, H));
    t.refuses("split_vertex_with", own.split_vertex_with(H, H, &mut none));
    t.refuses("can_split_isolated_vertex", d.can_split_isolated_vertex(V));
    t.refuses("split_isolated_vertex", own.split_isolated_vertex(V));
    t.refuses("split_isolated_vertex_with", own.split_isolated_vertex_with(V, &mut none));
    t.refuses("can_collapse_edge", d.can_collapse_edge(H));
    t.refuses("collapse_edge", own.collapse_edge(H));
    t.refuses("collapse_edge_with", own.collapse_edge_with(H, &mut none));
    t.refuses("can_join_faces", d.can_join_faces(H));
    t.refuses("join_faces", own.join_faces(H));
    t.refuses("join_faces_with", own.join_faces_with(H, &mut none));
    t.refuses("can_flip_edge", d.can_flip_edge(H));
    t.refuses("flip_edge", own.flip_edge(H));
    t.refuses("flip_edge_with", own.flip_edge_with(H, &mut none));
    t.refuses("can_join_edges", d.can_join_edges(H));
    t.refuses("join_edges", own.join_edges(H));
    t.refuses("join_edges_with", own.join_edges_with(H, &mut none));
    t.refuses("can_split_edge", d.can_split_edge(H));
    t.refuses("split_edge", own.split_edge(H));
    t.refuses("split_edge_with", own.split_edge_with(H, &mut none));
    t.refuses("can_join_vertices", d.can_join_vertices(H));
    t.refuses("join_vertices", own.join_vertices(H));
    t.refuses("join_vertices_with", own.join_vertices_with(H, &mut none));
    // In an edit of one's own a write that goes astray refuses the whole edit.
    let (h0, v0, f0) = (HalfEdgeId::new(0), VertexId::new(0), FaceId::new(0));
    t.refuses("remove_vertex", own.edit_with(&mut none, |e| e.remove_vertex(V)));
    t.refuses("remove_edge", own.edit_with(&mut none, |e| e.remove_edge(E)));
    t.refuses("remove_face", own.edit_with(&mut none, |e| e.remove_face(F)));
    let mut write = |name, write: &dyn Fn(&mut Editing<'_>)| {
        let answer: Result<(), OwnEditError<IdError>> = own.edit_with(&mut none, |e| {
            write(e);
            Ok(())
        });
        t.refuses(name, answer);
    };
    write("set_origin", &|e| e.set_origin(H, v0));
    write("set_next", &|e| e.set_next(h0, H));
    write("set_face", &|e| e.set_face(H, f0));
    write("set_outgoing", &|e| e.set_outgoing(V, Some(h0)));
    write("set_half_edge", &|e| e.set_half_edge(F, Some(h0)));
    let renumbering = own.compact();
    t.panics("half_edge", || renumbering.half_edge(H));
    assert_eq!(components(d).of(V), None);
    let one = ["there is no v99: there are 5 vertices", "there is no h99: there are 10 half-edges"];
    let others = ["there is no e99: there are 5 edges", "there is no f99: there are 2 faces"];
    let mut tried = t.checked(&[one[0], one[1], others[0], others[1]]);
    tried.insert("of");
    let columns = TableColumns::default();
    assert_eq!((columns.position(V), columns.name(F)), (None, None));
    tried.extend(["position", "name"]);
    tried
}

fn plane() -> BTreeSet<&'static str> {
    let lab = Subdivision::lab_rectangle();
    let (s, mut t) = (&lab, Table::default());
    let (mut own, mut none) = (lab.clone(), NoRecorder);
    let at = Point::new(1.0, 1.0);
    let (method, v0) = (TriangulationMethod::default(), VertexId::new(0));
    t.panics("point", || s.point(V));
    t.panics("area", || s.area(F));
    t.panics("cycles", || s.cycles(F).count());
    t.panics("midpoint", || s.midpoint(H));
    t.panics("is_locally_delaunay", || s.is_locally_delaunay(H));
    t.refuses("locate_from", s.locate_from(V, at));
    t.refuses("walk_from", s.walk_from(V, at));
    t.refuses("walk_from_observed", s.walk_from_observed(V, at, &mut NoObserver));
    t.refuses("triangulate_face", own.triangulate_face(F, method));
    t.refuses("triangulate_face_with", own.triangulate_face_with(F, method, &mut none));
    t.refuses("split_into_monotone", own.split_into_monotone(F));
    t.refuses("can_split_face", s.can_split_face(H, H));
    t.refuses("split_face", own.split_face(H, H));
    t.refuses("split_face_with", own.split_face_with(H, H, &mut none));
    t.refuses("can_remove_edge", s.can_remove_edge(E));
    t.refuses("remove_edge", own.remove_edge(E));
    t.refuses("remove_edge_with", own.remove_edge_with(E, &mut none));
    t.refuses("remove_vertex", own.remove_vertex(V));
    t.refuses("remove_vertex_with", own.remove_vertex_with(V, &mut none));
    t.refuses("can_insert_edge", s.can_insert_edge(v0, V));
    t.refuses("insert_edge", own.insert_edge(V, v0));
    t.refuses("insert_edge_with", own.insert_edge_with(V, v0, &mut none));
    t.refuses("insert_dangling_edge", own.insert_dangling_edge(V, at));
    t.refuses("insert_dangling_edge_with", own.insert_dangling_edge_with(V, at, &mut none));
    t.refuses("insert_vertex_in", own.insert_vertex_in(F, at));
    t.refuses("insert_vertex_in_with", own.insert_vertex_in_with(F, at, &mut none));
    t.refuses("can_join_faces", s.can_join_faces(H));
    t.refuses("join_faces", own.join_faces(H));
    t.refuses("join_faces_with", own.join_faces_with(H, &mut none));
    t.refuses("can_flip_edge", s.can_flip_edge(H));
    t.refuses("flip_edge", own.flip_edge(H));
    t.refuses("flip_edge_with", own.flip_edge_with(H, &mut none));
    t.refuses("can_join_edges", s.can_join_edges(H));
    t.refuses("join_edges", own.join_edges(H));
    t.refuses("join_edges_with", own.join_edges_with(H, &mut none));
    t.refuses("can_split_edge", s.can_split_edge(H, at));
    t.refuses("split_edge", own.split_edge(H, at));
    t.refuses("split_edge_with", own.split_edge_with(H, at, &mut none));
    t.refuses("split_in_half", own.split_in_half(H));
    t.refuses("split_in_half_with", own.split_in_half_with(H, &mut none));
    t.refuses("can_set_point", s.can_set_point(V, at));
    t.refuses("move_vertex", own.move_vertex(V, [1.0, 0.0]));
    t.refuses("move_vertex_with", own.move_vertex_with(V, [1.0, 0.0], &mut none));
    t.refuses("set_point", own.set_point(V, at));
    t.refuses("set_point_with", own.set_point_with(V, at, &mut none));
    let overlay = s.overlay(s).expect("the same twice");
    t.panics("edges_of_a", || overlay.edges_of_a(E).len());
    t.panics("edges_of_b", || overlay.edges_of_b(E).len());
    t.panics("is_in", || overlay.is_in(F));
    let mut list = PolygonList::new();
    list.push_face(&[0, 1, 2]);
    let points = [(0., 0.), (4., 0.), (0., 4.)].map(Point::from);
    let mended = Subdivision::mend_polygons(&points, &list).expect("a triangle");
    t.panics("outlines", || mended.outlines(E).len());
    t.panics("count", || mended.cover.count(F));
    t.panics("polygons", || mended.cover.polygons(F));
    let arranged = Subdivision::arrange_segments(&[[points[0], points[1]]], &ArrangeOptions::default());
    let along = arranged.expect("one segment").segments_along();
    t.panics("of", || along.of(E).len());
    let counts = [s.vertex_count(), s.half_edge_count(), s.edge_count(), s.face_count()];
    let [v, h, e, f] = counts;
    t.checked(&[
        &format!("there is no v99: there are {v} vertices"),
        &format!("there is no h99: there are {h} half-edges"),
        &format!("there is no e99: there are {e} edges"),
        &format!("there is no f99: there are {f} faces"),
        "there is no e99: there are 3 edges",
        "there is no e99: there is 1 edge, e0",
        "there is no f99: there are 2 faces",
    ])
}

fn solid() -> BTreeSet<&'static str> {
    let cube = Polyhedron::platonic(Platonic::Cube);
    let (c, measures, mut t) = (&cube, cube.measures(), Table::default());
    let mut own = cube.clone();
    let mut journal = dcel_kit::solid::SurfaceJournal::new();
    t.panics("point", || c.point(V));
    t.panics("area_vector", || c.area_vector(F));
    t.panics("normal", || c.normal(F));
    t.panics("face_mean", || c.face_mean(F));
    t.panics("bend_of_face", || c.bend_of_face(F));
    t.panics("is_flat", || c.is_flat(F));
    t.panics("check_convex_face", || c.check_convex_face(F).is_ok());
    for of in [true, false] {
        t.panics("corner_angle", || if of { c.corner_angle(H) } else { measures.corner_angle(H) });
        t.panics("dihedral_angle", || if of { c.dihedral_angle(E) } else { measures.dihedral_angle(E) });
        t.panics("deficit_angle", || if of { c.deficit_angle(V) } else { measures.deficit_angle(V) });
        t.panics("vertex_area", || if of { c.vertex_area(V) } else { measures.vertex_area(V) });
        t.panics("gauss_curvature", || if of { c.gauss_curvature(V) } else { measures.gauss_curvature(V) });
        t.panics("mean_curvature", || if of { c.mean_curvature(V) } else { measures.mean_curvature(V) });
    }
    t.refuses("schlegel", c.schlegel(F));
    t.refuses("pole", pole(&mut c.topology().clone(), H));
    t.refuses("quads", quads(&mut c.topology().clone(), H));
    t.refuses("can_collapse_edge", c.can_collapse_edge(H));
    t.refuses("collapse_edge", own.collapse_edge(H));
    t.refuses("collapse_edge_with", own.collapse_edge_with(H, &mut journal));
    t.refuses("remove_face", own.remove_face(F));
    t.refuses("remove_face_with", own.remove_face_with(F, &mut journal));
    t.refuses("remove_vertex", own.remove_vertex(V));
    t.refuses("remove_vertex_with", own.remove_vertex_with(V, &mut journal));
    let corners = [VertexId::new(0), VertexId::new(1), V];
    t.refuses("can_add_face", c.can_add_face(&corners));
    t.refuses("add_face", own.add_face(&corners));
    t.refuses("add_face_with", own.add_face_with(&corners, &mut journal));
    t.refuses("bevel_edge", own.bevel_edge(H, 0.2));
    t.refuses("bevel_edge_with", own.bevel_edge_with(H, 0.2, &mut journal));
    t.refuses("bevel_face", own.bevel_face(F, 0.2, 0.1));
    t.refuses("bevel_face_with", own.bevel_face_with(F, 0.2, 0.1, &mut journal));
    t.refuses("bevel_vertex", own.bevel_vertex(V, 0.2));
    t.refuses("bevel_vertex_with", own.bevel_vertex_with(V, 0.2, &mut journal));
    t.refuses("bisect_edge", own.bisect_edge(H));
    t.refuses("bisect_edge_with", own.bisect_edge_with(H, &mut journal));
    t.refuses("extrude_face", own.extrude_face(F, 0.5));
    t.refuses("extrude_face_with", own.extrude_face_with(F, 0.5, &mut journal));
    t.refuses("flip_edge", own.flip_edge(H));
    t.refuses("flip_edge_with", own.flip_edge_with(H, &mut journal));
    t.refuses("inset_face", own.inset_face(F, 0.2));
    t.refuses("inset_face_with", own.inset_face_with(F, 0.2, &mut journal));
    t.refuses("join_edges", own.join_edges(H));
    t.refuses("join_edges_with", own.join_edges_with(H, &mut journal));
    t.refuses("join_faces", own.join_faces(H));
    t.refuses("join_faces_with", own.join_faces_with(H, &mut journal));
    t.refuses("move_vertex", own.move_vertex(V, [0.0; 3]));
    t.refuses("move_vertex_with", own.move_vertex_with(V, [0.0; 3], &mut journal));
    t.refuses("set_point", own.set_point(V, [0.0; 3]));
    t.refuses("set_point_with", own.set_point_with(V, [0.0; 3], &mut journal));
    t.refuses("split_edge", own.split_edge(H, [0.0; 3]));
    t.refuses("split_edge_with", own.split_edge_with(H, [0.0; 3], &mut journal));
    t.refuses("split_face", own.split_face(H, H));
    t.refuses("split_face_with", own.split_face_with(H, H, &mut journal));
    t.refuses("split_in_half", own.split_in_half(H));
    t.refuses("split_in_half_with", own.split_in_half_with(H, &mut journal));
    t.refuses("can_bevel_edge", c.can_bevel_edge(H, 0.2));
    t.refuses("can_bevel_vertex", c.can_bevel_vertex(V, 0.2));
    // A hint that does not exist is not used.
    let convex = c.check_convex().expect("a cube");
    let up = Direction::try_from([0.1, 0.2, 1.0]).expect("finite");
    assert_eq!(convex.support_from(up, V), convex.support(up));
    let one = ["there is no v99: there are 8 vertices", "there is no h99: there are 24 half-edges"];
    t.checked(&[one[0], one[1], "there is no e99: there are 12 edges", "there is no f99: there are 6 faces"])
}

fn navmesh() -> BTreeSet<&'static str> {
    let mut t = Table::default();
    let map = Subdivision::lab_rectangle();
    let mut mesh = NavMesh::new(&map).expect("convex faces");
    t.panics("point", || mesh.point(V));
    t.refuses("place_in", mesh.place_in(F, Point::new(1.0, 1.0)));
    assert_eq!((mesh.block(F), mesh.unblock(F), mesh.set_wall(F, E, true)), (None, None, None));
    assert_eq!((mesh.component(F), mesh.portal(F), mesh.has_face(F)), (None, None, false));
    let live = LiveMesh::new(map.clone()).expect("convex faces");
    assert_eq!((live.area(F), live.area(FaceId::new(1))), (None, Some(0)));
    assert!(!mesh.is_blocked(F) && !mesh.is_walkable(F) && !mesh.is_dead_end(F) && !mesh.is_wall(E));
    assert_eq!((mesh.corners(F).count(), mesh.sides(F).count(), mesh.neighbours(F).count()), (0, 0, 0));
    assert!(mesh.faces_around(V).is_empty() && mesh.wedges(V).is_empty());
    assert_ne!(mesh.locate(Point::new(1.0, 1.0)), dcel_kit::navmesh::Location::Outer);
    // Whether there is such a face is no question of `place_in`: the point does not lie in it.
    t.checked(&["there is no v99: there are 6 vertices", "f99"])
}

/// The names of the public functions in the folder that take an id.
fn with_ids(folder: &Path, names: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).expect("a folder of the sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            with_ids(&path, names);
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a source");
        let text = text.split("#[cfg(test)]").next().unwrap_or_default();
        for function in text.split("pub fn ").skip(1) {
            let name: String = function.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let mut depth = 0;
            let mut parameters = String::new();
            for c in function.chars().skip_while(|&c| c != '(') {
                depth += i32::from(c == '(') - i32::from(c == ')');
                match depth {
                    0 => break,
                    1 => parameters.push(c),
                    _ => {} // what closures take
                }
            }
            let takes =
                |kind: &str| [format!(": {kind}"), format!(": &[{kind}]")].iter().any(|p| parameters.contains(p));
            if ["VertexId", "HalfEdgeId", "EdgeId", "FaceId"].into_iter().any(takes) {
                names.insert(name);
            }
        }
    }
}

#[test]
fn an_id_that_does_not_exist_is_named_by_every_function_that_takes_one() {
    let known: [BTreeSet<&str>; 4] = [topology(), plane(), solid(), navmesh()];
    for (folder, tried) in ["topology", "plane", "solid", "navmesh"].into_iter().zip(known) {
        let mut names = BTreeSet::new();
        with_ids(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../src").join(folder), &mut names);
        assert!(names.len() > 15, "{folder} has more functions that take ids than {names:?}");
        let left: Vec<&String> =
            names.iter().filter(|name| !tried.contains(name.as_str()) && !ORDINARY.contains(&name.as_str())).collect();
        assert!(left.is_empty(), "functions of {folder} that take an id and are not tried here: {left:?}");
    }
    assert!(matches!(Subdivision::lab_rectangle().locate(Point::new(-9.0, 0.0)), Location::Face(_)));
}

/// The two halves of a removed edge, a removed vertex and a removed face, asked for in each structure.
#[cfg(debug_assertions)]
#[test]
fn a_removed_id_is_named_by_every_getter_in_debug_builds() {
    let mut lab = Subdivision::lab_rectangle();
    let (h, f) = lab.split_face(HalfEdgeId::new(2), HalfEdgeId::new(8)).unwrap();
    let (v, half) = lab.split_in_half(h).unwrap();
    lab.join_edges(h).unwrap();
    lab.join_faces(h).unwrap();
    let mut cube = Polyhedron::platonic(Platonic::Cube);
    cube.remove_vertex(VertexId::new(0)).unwrap();
    let (corner, gone) = (VertexId::new(0), cube.topology());
    let edge = (0..24).map(HalfEdgeId::new).find(|&h| !gone.has_half_edge(h)).unwrap();
    let face = (0..6).map(FaceId::new).find(|&f| !gone.has_face(f)).unwrap();
    assert!(!lab.has_half_edge(h) && !lab.has_half_edge(half) && !lab.has_vertex(v) && !lab.has_face(f));
    let mut t = Table::default();
    for (h, v, f, s) in [(h, v, f, lab.topology()), (edge, corner, face, cube.topology())] {
        for h in [h, h.twin()] {
            t.panics("origin", || s.origin(h));
            t.panics("destination", || s.destination(h));
            t.panics("next", || s.next(h));
            t.panics("prev", || s.prev(h));
            t.panics("face", || s.face(h));
            t.panics("cw", || s.cw(h));
            t.panics("ccw", || s.ccw(h));
            t.panics("cycle", || s.cycle(h).count());
            t.panics("star", || s.star(h).count());
        }
        t.panics("outgoing", || s.outgoing(v));
        t.panics("degree", || s.degree(v));
        t.panics("half_edge", || s.half_edge(f));
        t.panics("incident_half_edges", || s.incident_half_edges(f).count());
    }
    t.panics("point", || lab.point(v));
    t.panics("inner_components", || lab.inner_components(f).len());
    t.panics("is_hole", || lab.is_hole(f));
    t.panics("point", || cube.point(corner));
    t.panics("is_boundary_face", || cube.is_boundary_face(face));
    for (name, said) in &t.rows {
        assert!(said.contains("was removed earlier") && !said.contains("42949"), "{name} said: {said}");
    }
    let named = |element: String| t.rows.iter().any(|(_, said)| said.starts_with(&element));
    assert!(
        [v.to_string(), f.to_string(), h.to_string(), h.twin().to_string(), corner.to_string()].map(named) == [true; 5]
    );
}
