//! What algorithms refuse is drawn, at the elements that the refusal names.

use super::star;
use dcel_kit::figure::{FigureOptions, SketchFilm, algorithms};
use dcel_kit::ids::Element;
use dcel_kit::plane::{Point, TriangulateError};
use dcel_kit::solid::{NotConvex, Platonic, Polyhedron};
use dcel_kit::topology::PolygonList;
use dcel_kit::{EdgeId, FaceId, HalfEdgeId, VertexId};

/// The marks of the only frame: what kind each is.
fn marks(film: &SketchFilm) -> Vec<String> {
    let [figure] = &film.singles(&FigureOptions::new("Refused")).unwrap()[..] else { panic!("one frame") };
    let svg = figure.to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let wrong = document.descendants().filter(|n| n.attribute("class").is_some_and(|class| class.contains("r-wrong")));
    let kind = |n: roxmltree::Node<'_, '_>| {
        let (_, name) = n.attribute("id")?.split_once("-s-")?;
        let (kind, number) = name.split_once('-')?;
        number.parse::<u32>().ok().filter(|_| kind != "key").map(|_| kind.to_owned())
    };
    wrong.filter_map(kind).collect()
}

#[test]
fn elements_and_places_of_the_plane_are_marked() {
    let s = star(5, 9);
    let elements: [Element; 4] =
        [VertexId::new(3).into(), HalfEdgeId::new(4).into(), EdgeId::new(6).into(), FaceId::new(1).into()];
    let film = algorithms::refusal(&s, "no", &elements, &[(Point::new(0.0, 0.0), "here")]);
    assert_eq!(marks(&film), ["path", "path", "path", "point", "point"]);
    let svg = film.strip(&FigureOptions::new("Refused")).unwrap().to_svg();
    assert!(["v3", "h4", "e6", "here"].iter().all(|word| svg.contains(&format!(">{word}<"))), "{svg}");
    let gone: [Element; 4] =
        [VertexId::new(300).into(), HalfEdgeId::new(400).into(), EdgeId::new(600).into(), FaceId::new(100).into()];
    assert_eq!(marks(&algorithms::refusal(&s, "no", &gone, &[])), [""; 0]);
    let error = TriangulateError::NotPlanar { face: FaceId::new(1), vertex: VertexId::new(2) };
    assert_eq!(marks(&algorithms::refusal(&s, "no", &error.elements(), &[])).len(), 2);
}

/// A prism over a polygon of the plane.
fn prism(base: &[[f64; 2]]) -> Polyhedron {
    let n = base.len() as u32;
    let points = [0.0, 1.0].iter().flat_map(|&z| base.iter().map(move |&[x, y]| [x, y, z])).collect();
    let mut faces = PolygonList::new();
    faces.push_face(&(0..n).rev().collect::<Vec<u32>>());
    faces.push_face(&(n..2 * n).collect::<Vec<u32>>());
    (0..n).for_each(|i| faces.push_face(&[i, (i + 1) % n, n + (i + 1) % n, n + i]));
    Polyhedron::from_polygons(points, &faces).unwrap()
}

#[test]
fn what_keeps_a_solid_from_being_convex_is_marked() {
    let corner = prism(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
    let mut open = Polyhedron::platonic(Platonic::Cube);
    open.remove_face(FaceId::new(2)).unwrap();
    let mut two = Polyhedron::platonic(Platonic::Tetrahedron);
    two.add_vertex([9.0, 9.0, 9.0]).unwrap();
    for (solid, kind) in [(corner, "reflex"), (open, "border"), (two, "pieces")] {
        let error: NotConvex = solid.check_convex().err().unwrap();
        let (text, elements) = (error.to_string(), error.elements());
        assert!(text.contains(kind), "{text}");
        assert!(!elements.is_empty() && elements.iter().all(|e| text.contains(&e.to_string())), "{text}: {elements:?}");
        let film = algorithms::refusal_in_space(&solid, &text, &elements);
        assert_eq!(film.captions().collect::<Vec<_>>(), [("Refused", text.as_str())]);
        assert_eq!(marks(&film).len(), elements.len(), "{text}");
    }
    let cube = Polyhedron::platonic(Platonic::Cube);
    assert_eq!(marks(&algorithms::refusal_in_space(&cube, "no", &[FaceId::new(77).into()])), [""; 0]);
}
