//! STL in both forms: corners are joined, faces are cut, and what is wrong has its place.

use super::shapes::{L, prism};
use dcel_kit::io::stl::rounding;
use dcel_kit::io::{Document, Format, Model, PolygonSoup, ReadOptions, WriteError, read_bytes, write};
use dcel_kit::solid::{Archimedean, Hand, Platonic, Polyhedron};
use dcel_kit::topology::{PolygonList, isomorphic};

fn written(solid: &Polyhedron) -> Result<Vec<u8>, WriteError> {
    let model = Model::surface(solid, |v| Some(solid.point(v)), |f| solid.is_boundary_face(f));
    let mut out = Vec::new();
    write(&mut out, &model, Format::Stl)?;
    Ok(out)
}

fn written_as_binary(solid: &Polyhedron) -> Result<Vec<u8>, WriteError> {
    let model = Model::surface(solid, |v| Some(solid.point(v)), |f| solid.is_boundary_face(f));
    let mut out = Vec::new();
    write(&mut out, &model, Format::StlBinary)?;
    Ok(out)
}

fn read(bytes: &[u8]) -> Result<(PolygonSoup, Vec<String>), String> {
    let read = read_bytes(bytes, Format::Stl, "a.stl", &ReadOptions::default()).map_err(|error| error.to_string())?;
    let Document::Polygons(soup) = read.document else { panic!("not polygons") };
    Ok((soup, read.notes))
}

/// The same triangles as the text, as bytes; coordinates of `soup` must be singles.
fn binary(soup: &PolygonSoup) -> Vec<u8> {
    let mut bytes = b"solid by name only".to_vec();
    bytes.resize(80, 0);
    bytes.extend((soup.faces.face_count() as u32).to_le_bytes());
    for cycle in soup.faces.outer_cycles() {
        bytes.extend([0; 12]);
        for &corner in cycle {
            soup.points[corner as usize].iter().for_each(|&x| bytes.extend((x as f32).to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn a_cube_goes_out_in_triangles_and_comes_back_joined_from_text_and_from_bytes() {
    let cube = Polyhedron::platonic(Platonic::Cube);
    let text = written(&cube).unwrap();
    assert_eq!(Format::from_content(&text), Some(Format::Stl));
    let (soup, notes) = read(&text).unwrap();
    assert_eq!((soup.points.len(), soup.faces.face_count(), notes.len()), (8, 12, 0));
    let again = Polyhedron::from_polygons(soup.points.clone(), &soup.faces).unwrap();
    assert!((again.signed_volume() - 8.0).abs() < 1e-12);
    // Line 4 is the first corner: solid, facet, outer loop, vertex.
    assert_eq!((soup.places.vertex(0), soup.places.face(1)), ("a.stl:4".to_owned(), "a.stl:11".to_owned()));

    let bytes = binary(&soup);
    assert_eq!(Format::from_content(&bytes), Some(Format::Stl), "although it starts with the word of the text form");
    let (from_bytes, _) = read(&bytes).unwrap();
    assert_eq!((from_bytes.points.clone(), from_bytes.faces.clone()), (soup.points, soup.faces));
    let from_bytes = Polyhedron::from_polygons(from_bytes.points, &from_bytes.faces).unwrap();
    assert!(isomorphic(&from_bytes, &again).is_ok());
}

#[test]
fn binary_files_come_back_as_they_went() {
    for solid in [
        Polyhedron::platonic(Platonic::Cube),
        Polyhedron::platonic(Platonic::Dodecahedron),
        Polyhedron::archimedean(Archimedean::SnubCube(Hand::Left)),
    ] {
        let bytes = written_as_binary(&solid).unwrap();
        assert_eq!((Format::from_content(&bytes), bytes.len() % 50), (Some(Format::Stl), 34));
        let (text, (soup, notes)) = (read(&written(&solid).unwrap()).unwrap().0, read(&bytes).unwrap());
        let singles: Vec<[f64; 3]> = text.points.iter().map(|p| p.map(|x| f64::from(x as f32))).collect();
        assert_eq!((soup.points.clone(), &soup.faces, notes.len()), (singles, &text.faces, 0));
        let again = Polyhedron::from_polygons(soup.points, &soup.faces).unwrap();
        assert!(written_as_binary(&again).unwrap() == bytes, "not byte for byte");
    }
    let bytes = written_as_binary(&Polyhedron::platonic(Platonic::Cube)).unwrap();
    let normal: Vec<f32> = bytes[84..96].chunks(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect();
    assert_eq!(normal.iter().map(|x| x.abs()).sum::<f32>(), 1.0);
    let error = |base: &[[f64; 2]], height: f64| written_as_binary(&prism(base, height)).unwrap_err().to_string();
    let near = [[1.0, 1.0], [2.0, 1.0], [2.00000001, 1.00000001], [1.0, 2.0]];
    let close = error(&near, 1.0);
    assert!(close.starts_with("(2, 1, 0) and (2.00000001, 1.00000001, 0) are the same in single precision"), "{close}");
    let large = error(&near[..2].iter().chain(&near[3..]).copied().collect::<Vec<_>>(), 1e40);
    assert!(large.starts_with("1e40 at a corner of f1 is too large for single precision"), "{large}");
    let refused = written_as_binary(&prism(&L, 1.0)).unwrap_err().to_string();
    assert!(refused.starts_with("f0 is not convex"), "{refused}");
}

#[test]
fn zeros_of_both_signs_are_one_and_triangles_without_three_corners_are_left_out() {
    let facet = |corners: [&str; 3]| {
        let lines = corners.map(|c| format!("vertex {c}\n")).concat();
        format!("facet normal 0 0 0\nouter loop\n{lines}endloop\nendfacet\n")
    };
    let text = format!(
        "SOLID two\n{}{}{}EndSolid two\nsolid more\n{}endsolid\n",
        facet(["0 0 1", "1 0 1", "-0 1 1"]),
        facet(["0 1 1", "1 -0 1", "1 1 2"]),
        facet(["5 5 5", "6 6 6", "5.0 5e0 5"]),
        facet(["0 0 1", "0 1 1", "-3 0.1 0.2"]),
    );
    let (soup, notes) = read(text.as_bytes()).unwrap();
    assert_eq!((soup.points.len(), soup.faces.face_count()), (5, 3));
    assert_eq!(soup.faces.cycle(1), [2, 1, 3]);
    assert_eq!(notes, ["1 triangle with two equal corners was left out"]);
}

#[test]
fn what_is_no_stl_is_named_with_its_place() {
    let error = |text: &str| read(text.as_bytes()).unwrap_err();
    assert!(
        error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n").starts_with("a.stl:4:12: `x` is not a number")
    );
    assert!(
        error("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n")
            .starts_with("a.stl:7:1: expected `endloop`")
    );
    assert!(error("solid\nfacet\nouter loop\nvertex 0 0 0\n").contains("`vertex`"));
    assert!(error("hello").starts_with("a.stl:1:1: expected `solid`"));
    let (soup, _) = read(&written(&Polyhedron::platonic(Platonic::Tetrahedron)).unwrap()).unwrap();
    let mut bytes = binary(&soup);
    bytes[0] = b'x';
    bytes[84 + 50 + 12 + 4..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    assert!(read(&bytes).unwrap_err().starts_with("a.stl: byte 150: y is NaN"));
    bytes.pop();
    assert!(read(&bytes).unwrap_err().contains("are not what the count says"));
    let refused = written(&prism(&L, 1.0)).unwrap_err().to_string();
    assert!(refused.starts_with("f0 is not convex"), "{refused}");
}

#[test]
fn more_than_a_binary_file_counts_is_noted_and_fewer_is_refused() {
    let (soup, _) = read(&written(&Polyhedron::platonic(Platonic::Tetrahedron)).unwrap()).unwrap();
    for start in [*b"solid", *b"other"] {
        let mut bytes = binary(&soup);
        bytes[..5].copy_from_slice(&start);
        let counted = |count: u32| {
            let mut bytes = bytes.clone();
            bytes[80..84].copy_from_slice(&count.to_le_bytes());
            bytes
        };
        let (more, notes) = read(&counted(3)).unwrap();
        assert_eq!(
            (&more.faces, &notes[..]),
            (&soup.faces, &["the file counts 3 triangles and holds 4: all were read".to_owned()][..])
        );
        let (same, notes) = read(&[&bytes[..], &[7; 4]].concat()).unwrap();
        assert_eq!(
            (&same.faces, &notes[..]),
            (&soup.faces, &["4 bytes were left out behind 4 counted triangles".to_owned()][..])
        );
        let error = read(&counted(5)).unwrap_err();
        assert!(error.contains("the data end inside triangle 4 of 5, counted from 0"), "{error}");
        let (none, _) = read(&bytes).unwrap();
        assert_eq!(none.faces, soup.faces);
    }
}

#[test]
fn what_single_precision_folds_is_refused_and_what_it_rounds_is_told() {
    let triangle = |corners: Vec<[f64; 3]>| {
        Polyhedron::from_polygons(corners, &PolygonList::from_triangles(&[[0, 1, 2]])).unwrap()
    };
    // All three lie at y = 4000000 then.
    let flat = triangle(vec![[4e6, 4e6 + 0.05, 0.0], [4e6 + 3.0, 4e6 + 0.05, 0.0], [4e6 + 1.0, 4e6 + 0.12, 0.0]]);
    let error = written_as_binary(&flat).unwrap_err().to_string();
    assert!(error.starts_with("a triangle of f0 is flat or turned over in single precision"), "{error}");
    let moved = triangle(vec![[0.1, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.25]]);
    let model = Model::surface(&moved, |v| Some(moved.point(v)), |f| moved.is_boundary_face(f));
    let note = rounding(&model, Format::StlBinary).unwrap();
    assert!(
        note.starts_with("1 point was rounded to single precision, none further than 1.50e-9 in x, y or z"),
        "{note}"
    );
    assert_eq!((rounding(&model, Format::Stl), rounding(&model, Format::Obj)), (None, None));
}

#[test]
fn no_normal_is_written_as_minus_zero() {
    let corners = vec![[0., 0., 0.], [4., -0., 0.], [4., 3., 0.], [0., 3., 0.]];
    let flat = Polyhedron::from_polygons(corners, &PolygonList::from_triangles(&[[0, 1, 2], [0, 2, 3]])).unwrap();
    let text = String::from_utf8(written(&flat).unwrap()).unwrap();
    let normals: Vec<&str> = text.lines().filter(|line| line.starts_with("facet")).collect();
    assert_eq!(normals, ["facet normal 0 0 1"; 2]);
    let bytes = written_as_binary(&flat).unwrap();
    let minus = (-0.0_f32).to_le_bytes();
    assert!(bytes[84..96].chunks(4).all(|x| x != minus), "{:?}", &bytes[84..96]);
}
