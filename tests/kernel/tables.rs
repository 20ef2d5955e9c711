//! Tables become subdivisions with the same ids.

use dcel_kit::io::{Document, Format, ReadOptions, read_bytes};
use dcel_kit::plane::{ConvertOptions, PlanarView, Point, Subdivision, TableError};
use dcel_kit::topology::{IsomorphismOptions, PolygonList, Table, View, isomorphic_with, position_key};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

/// A table with the positions of the view.
fn table_of(view: &impl PlanarView) -> Table {
    let mut table = Table::from_view(view);
    for (v, row) in table.vertices.iter_mut().enumerate() {
        let position = view.position(VertexId::new(v as u32)).map(|p| [p.x, p.y]);
        row.iter_mut().for_each(|row| row.position = position);
    }
    table
}

fn read(text: &str) -> Table {
    let read = read_bytes(text.as_bytes(), Format::Dcel, "test.dcel", &ReadOptions::default()).unwrap();
    match read.document {
        Document::Table(table) => table,
        other => panic!("{other:?}"),
    }
}

/// A square with a square hole and an island in the hole, and a triangle beside it.
fn nested() -> Subdivision {
    let square = |x: f64, r: f64| [(x - r, -r), (x + r, -r), (x + r, r), (x - r, r)].map(Point::from);
    let mut points = [square(0.0, 9.0), square(0.0, 6.0), square(0.0, 3.0)].concat();
    points.extend([(20.0, 0.0), (22.0, 0.0), (21.0, 2.0)].map(Point::from));
    let mut faces = PolygonList::new();
    faces.push_face(&[0, 1, 2, 3]);
    faces.push_hole(&[4, 7, 6, 5]);
    faces.push_face(&[8, 9, 10, 11]);
    faces.push_face(&[12, 13, 14]);
    Subdivision::convert_polygons(points, &faces, &ConvertOptions::default()).unwrap().subdivision
}

#[test]
fn the_same_structure_comes_back() {
    for subdivision in [Subdivision::new(), Subdivision::lab_rectangle(), nested()] {
        assert_eq!(Subdivision::from_table(&table_of(&subdivision)).unwrap(), subdivision);
    }
}

#[test]
fn removed_elements_stay_free_and_the_lowest_is_given_out_first() {
    let mut lab = Subdivision::lab_rectangle();
    let h = HalfEdgeId::new;
    let (a, _) = lab.split_face(h(2), h(8)).unwrap();
    lab.split_in_half(a).unwrap();
    let mut table = table_of(&lab);
    // Two free pairs in the middle of the table: h4, h5 and h6, h7.
    let shift = |g: HalfEdgeId| if g.number() < 4 { g } else { h(g.number() + 4) };
    let rows = std::mem::take(&mut table.half_edges);
    table.half_edges = rows[..4].iter().copied().chain(vec![None; 4]).chain(rows[4..].iter().copied()).collect();
    for row in table.half_edges.iter_mut().flatten() {
        (row.twin, row.next, row.prev) = (row.twin.map(shift), row.next.map(shift), row.prev.map(shift));
    }
    table.vertices.iter_mut().flatten().for_each(|row| row.outgoing = row.outgoing.map(shift));
    table.faces.iter_mut().flatten().for_each(|row| row.half_edge = row.half_edge.map(shift));
    let bare = |table: &Table| {
        let mut table = table.clone();
        table.vertices.iter_mut().flatten().for_each(|row| row.position = None);
        table
    };
    let mut subdivision = Subdivision::from_table(&table).unwrap();
    assert_eq!(Table::from_view(&subdivision), bare(&table));
    assert_eq!(subdivision.half_edge_count(), table.half_edges.iter().flatten().count());
    assert_eq!(table_of(&subdivision), table);
    let start = subdivision.half_edge(FaceId::new(1)).unwrap();
    let long = subdivision.incident_half_edges(FaceId::new(1)).nth(2).unwrap();
    let (first, _) = subdivision.split_face(start, long).unwrap();
    assert_eq!(first.edge().number(), 2, "the lowest free pair is h4, h5");
}

const SCRAMBLED: &str = "dcel 1
v0 0 0 out h0
v2 4 0 out h1
v3 2 3 out h2
h0 origin v0 twin h3 next h1 prev h2 face f0
h1 origin v2 twin h9 next h2 prev h0 face f0
h2 origin v3 twin h5 next h0 prev h1 face f0
h3 origin v2 twin h0 next h5 prev h9 face f7
h5 origin v0 twin h2 next h9 prev h3 face f7
h9 origin v3 twin h1 next h3 prev h5 face f7
f0 half_edge h0 inner none name \"Ohio\"
f7 outer half_edge h9 inner none
";

#[test]
fn other_twins_and_another_outer_face_are_renumbered() {
    let table = read(SCRAMBLED);
    let subdivision = Subdivision::from_table(&table).unwrap();
    // h0 h3 | h1 h9 | h2 h5 become h0 h1 | h2 h3 | h4 h5; f7 becomes f0 and f0 becomes f7.
    let (h, f) = (HalfEdgeId::new, FaceId::new);
    let inside: Vec<_> = subdivision.incident_half_edges(f(7)).collect();
    let outside: Vec<_> = subdivision.incident_half_edges(f(0)).collect();
    assert_eq!((inside, outside), (vec![h(0), h(2), h(4)], vec![h(3), h(1), h(5)]));
    assert_eq!((subdivision.face_count(), subdivision.vertex_count()), (2, 3));
    assert!(!subdivision.has_vertex(VertexId::new(1)) && !subdivision.has_face(f(1)));
    let place = |view: &dyn PlanarView, v| view.position(v).map(|p| position_key([p.x, p.y])).unwrap();
    let (a, b) = (|v| place(&table, v), |v| place(&subdivision, v));
    assert!(isomorphic_with(&table, &subdivision, &IsomorphismOptions::new().keys(&a, &b).representatives()).is_ok());
}

#[test]
fn errors_speak_of_the_ids_of_the_table() {
    let told = |text: &str| Subdivision::from_table(&read(text)).unwrap_err().to_string();
    let upside_down = SCRAMBLED.replace("v3 2 3", "v3 2 -3");
    assert_eq!(
        told(&upside_down),
        "G6: the cycle of h9 surrounds a bounded region, so it cannot be an inner component of f7 (the first of 2 violations)"
    );
    let Err(TableError::Geometry { violations }) = Subdivision::from_table(&read(&upside_down)) else { panic!() };
    assert_eq!(violations[1].to_string(), "G5: the boundary of f0, from h0 on, does not run counter-clockwise");

    let broken = SCRAMBLED.replace("next h5 prev h9", "next h9 prev h9");
    let Err(TableError::Invariants { violations }) = Subdivision::from_table(&read(&broken)) else { panic!() };
    assert!(violations.iter().any(|v| v.rule.id == "N2"), "{violations:?}");
    assert_eq!(told(&SCRAMBLED.replace("f7 outer", "f7")), "no face is the outer one; mark the unbounded face");
    let no_place = SCRAMBLED.replace("v2 4 0", "v2");
    assert_eq!(
        Subdivision::from_table(&read(&no_place)).unwrap_err(),
        TableError::NoPosition { vertex: VertexId::new(2) }
    );
    let mut far = read(SCRAMBLED);
    far.vertices[3].as_mut().unwrap().position = Some([f64::NAN, 0.0]);
    let error = Subdivision::from_table(&far).unwrap_err();
    assert!(matches!(error, TableError::Coordinate { vertex, .. } if vertex == VertexId::new(3)), "{error}");
}

#[test]
fn rings_and_holes_are_kept() {
    let nested = nested();
    let mut table = table_of(&nested);
    assert_eq!(nested.hole_faces().count(), 1);
    // The hole face changes numbers with the outer face: f4 <-> f0, and its ring, the island, goes with it.
    let hole = nested.hole_faces().next().unwrap();
    let swap = |f: FaceId| match f {
        f if f == hole => FaceId::new(0),
        f if f.number() == 0 => hole,
        f => f,
    };
    table.faces.swap(0, hole.index());
    table.half_edges.iter_mut().flatten().for_each(|row| row.face = row.face.map(swap));
    table.outer_face = Some(hole);
    assert_eq!(Subdivision::from_table(&table).unwrap(), nested);
    // A ring in a face that does not surround it is G7.
    let mut elsewhere = table_of(&nested);
    let ring = elsewhere.faces[1].as_mut().unwrap().inner_components.pop().unwrap();
    elsewhere.faces[3].as_mut().unwrap().inner_components.push(ring);
    assert!(Subdivision::from_table(&elsewhere).is_err());
    assert!(nested.inner_components(FaceId::new(1)).len() == 1 && View::is_hole(&nested, hole));
}
