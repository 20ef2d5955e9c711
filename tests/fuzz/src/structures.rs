//! Builders: polygons and segments out of bytes.

use crate::Outcome;
use crate::bytes::Bytes;
use dcel_kit::io::{Document, Format, Model, ReadOptions, read_bytes, write};
use dcel_kit::plane::{ArrangeOptions, Arranged, ConvertOptions, Point, Subdivision};
use dcel_kit::solid::Polyhedron;
use dcel_kit::topology::{PolygonList, components, violations};
use dcel_kit::{FaceId, VertexId};

/// The first byte holds the options, then points, then polygons.
///
/// ```text
///   .......1 orient   ......1. full check   .....1.. insert touching corners   ....1... in space
///   ..11.... mode of coordinates
/// ```
pub(crate) fn from_polygons(data: &[u8]) -> Outcome {
    let mut bytes = Bytes(&data[..data.len().min(600)]);
    let flags = bytes.byte();
    let (mode, in_space) = (flags >> 4, flags & 8 != 0);
    let count = bytes.below(40);
    let points: Vec<[f64; 3]> = (0..count)
        .map(|_| {
            let [x, y] = [(); 2].map(|()| bytes.coordinate(mode));
            [x, y, if in_space { bytes.coordinate(mode) } else { 0.0 }]
        })
        .collect();
    let mut list = PolygonList::new();
    while !bytes.is_empty() && list.face_count() < 200 {
        let head = bytes.byte();
        // One number too many can be named, so that there are corners without points.
        let corners: Vec<u32> = (0..head % 16).map(|_| bytes.below(count + 1) as u32).collect();
        if head >= 224 { list.push_hole(&corners) } else { list.push_face(&corners) }
    }
    if in_space {
        return in_space_of(&points, &list);
    }
    let points: Vec<Point> = points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
    let options =
        ConvertOptions { orient: flags & 1 != 0, full_check: flags & 2 != 0, insert_touching: flags & 4 != 0 };
    let converted = match Subdivision::convert_polygons(points.clone(), &list, &options) {
        Ok(converted) => converted,
        Err(error) => {
            let (faces, message) = (error.faces(), error.to_string());
            assert!(faces.iter().all(|&f| (f as usize) < list.face_count()), "{message}: faces {faces:?}");
            assert!(!message.is_empty());
            return Outcome::of(&message);
        }
    };
    let s = &converted.subdivision;
    // How components lie in each other is only right where it was looked whether they cross: that is the full check.
    let is_nesting = |rule: &str| rule == "E2";
    let broken: Vec<_> = violations(s).into_iter().filter(|broken| !is_nesting(broken.rule.id)).collect();
    assert_eq!(broken, []);
    if options.full_check || options.insert_touching {
        assert_eq!(violations(s), []);
        assert_eq!(s.geometry_violations(), []);
    }
    for (i, point) in (0..).zip(&points) {
        let v = VertexId::new(i);
        assert_eq!(s.has_vertex(v), !converted.unused_vertices.contains(&v), "{v}");
        assert!(!s.has_vertex(v) || s.point(v) == *point, "{v} has moved");
    }
    for face in 0..list.face_count() {
        let f = FaceId::new(face as u32 + 1);
        let cycles = s.cycles(f).count() + usize::from(s.half_edge(f).is_some() && s.cycles(f).count() == 0);
        assert!(s.has_face(f) && cycles > 0, "{f}");
        assert!(!s.is_hole(f), "{f} was given, and is a hole");
        let corners: Vec<u32> = s.incident_vertices(f).map(VertexId::number).collect();
        let mut given = list.cycle(outer_cycle(&list, face)).to_vec();
        // A hole that touches the outer cycle at a corner is one cycle with it.
        if converted.inserted.is_empty() && list.cycles(face).count() == 1 {
            if converted.turned.contains(&(face as u32)) {
                given.reverse();
            }
            let start = given.iter().position(|v| *v == corners[0]);
            assert!(start.is_some(), "{f} has other corners: {corners:?} for {given:?}");
            given.rotate_left(start.unwrap_or_default());
            assert_eq!(corners, given, "{f}");
        }
    }
    // Asked for less, the answer is the same.
    if options.full_check && !options.insert_touching {
        let less = ConvertOptions { full_check: false, ..options };
        let less = Subdivision::convert_polygons(points, &list, &less).expect("the full check found nothing");
        assert!(less == converted, "the full check changed something");
    }
    assert_comes_back(s);
    Outcome(s.face_count().min(6) as u64)
        .and(Outcome(s.hole_faces().count().min(3) as u64))
        .and(Outcome(converted.inserted.len().min(2) as u64))
        .and(Outcome(components(s).count().min(3) as u64))
}

/// The number of the outer cycle of a face among all cycles.
fn outer_cycle(list: &PolygonList, face: usize) -> usize {
    (0..face).map(|f| list.cycles(f).count()).sum()
}

fn in_space_of(points: &[[f64; 3]], list: &PolygonList) -> Outcome {
    let built = Polyhedron::from_polygons(points.to_vec(), list);
    let oriented = Polyhedron::from_polygons_oriented(points.to_vec(), list.clone());
    match (built, oriented) {
        (Ok(surface), Ok((oriented, turned))) => {
            assert_eq!(violations(&surface), []);
            assert!(turned.is_empty() && oriented == surface, "what fits was turned: {turned:?}");
            Outcome(surface.face_count().min(6) as u64)
        }
        (Ok(_), Err(error)) => panic!("it fits as it is, and cannot be turned so that it does: {error}"),
        (Err(_), Ok((surface, turned))) => {
            assert_eq!(violations(&surface), []);
            assert!(!turned.is_empty(), "nothing was turned, and now it fits");
            Outcome(turned.len().min(3) as u64)
        }
        (Err(error), Err(other)) => {
            assert!(error.faces().iter().all(|&f| (f as usize) < list.face_count()), "{error}");
            Outcome::of(&error.to_string()).and(Outcome::of(&other.to_string()))
        }
    }
}

/// The first byte holds the options, the second the size of the grid, then segments by their ends.
///
/// ```text
///   .......1 merge   ......1. split   .....1.. grid   ....1... ends by number   ..11.... mode of coordinates
/// ```
pub(crate) fn from_segments(data: &[u8]) -> Outcome {
    let mut bytes = Bytes(&data[..data.len().min(400)]);
    let flags = bytes.byte();
    let (mode, by_number) = (flags >> 4, flags & 8 != 0);
    let size = bytes.byte();
    let grid = (flags & 4 != 0).then(|| f64::from(size.cast_signed()) / 16.0);
    let options = ArrangeOptions { merge: flags & 1 != 0, split: flags & 2 != 0, grid, ..ArrangeOptions::default() };
    let (points, ends) = if by_number {
        let count = bytes.below(40);
        let points: Vec<Point> =
            (0..count).map(|_| Point::new(bytes.coordinate(mode), bytes.coordinate(mode))).collect();
        let mut ends = Vec::new();
        while !bytes.is_empty() && ends.len() < 60 {
            ends.push([(); 2].map(|()| bytes.below(count + 1) as u32));
        }
        (points, ends)
    } else {
        let mut points = Vec::new();
        while !bytes.is_empty() && points.len() < 80 {
            points.push(Point::new(bytes.coordinate(mode), bytes.coordinate(mode)));
        }
        points.truncate(points.len() / 2 * 2);
        let ends = (0..points.len() as u32 / 2).map(|i| [2 * i, 2 * i + 1]).collect();
        (points, ends)
    };
    let arrange = |options: &ArrangeOptions| {
        if by_number {
            return Subdivision::arrange_graph(&points, &ends, options);
        }
        let pairs: Vec<[Point; 2]> = ends.iter().map(|pair| pair.map(|i| points[i as usize])).collect();
        Subdivision::arrange_segments(&pairs, options)
    };
    let arranged = match arrange(&options) {
        Ok(arranged) => arranged,
        Err(error) => {
            let message = error.to_string();
            let is_fault = matches!(error, dcel_kit::plane::SegmentsError::Faults { .. });
            assert!(!message.is_empty());
            assert!(!options.split || !is_fault, "refused for meeting: {message}");
            return Outcome::of(&message);
        }
    };
    let s = &arranged.subdivision;
    assert_eq!(violations(s), []);
    assert_eq!(s.geometry_violations(), []);
    chains(&arranged, &points, &ends);
    // What needs no splitting is not split.
    if !options.split {
        let split = ArrangeOptions { split: true, grid: None, ..options };
        let split = arrange(&split).expect("it fits without");
        assert_eq!((split.rounds, split.crossings.len()), (0, 0), "split without need");
        assert!(split.subdivision == *s, "splitting what fits changed it");
    }
    assert_comes_back(s);
    Outcome(s.face_count().min(6) as u64)
        .and(Outcome(components(s).count().min(3) as u64))
        .and(Outcome(arranged.rounds.into()))
        .and(Outcome(arranged.crossings.len().min(3) as u64))
        .and(Outcome(arranged.moved.len().min(2) as u64))
        .and(Outcome(arranged.collapsed.len().min(2) as u64))
}

/// Claims that every segment became a chain of edges from its first end to its second.
fn chains(arranged: &Arranged, points: &[Point], ends: &[[u32; 2]]) {
    let s = &arranged.subdivision;
    let free = arranged.grid.is_none();
    let mut on_edge = vec![0_usize; s.edge_bound()];
    for (i, pair) in ends.iter().enumerate() {
        let [p, q] = pair.map(|end| points[end as usize]);
        let chain = arranged.chain(i);
        for link in chain.windows(2) {
            assert_eq!(s.destination(link[0]), s.origin(link[1]), "the chain of segment {i} is broken");
        }
        chain.iter().for_each(|h| on_edge[h.edge().index()] += 1);
        let (Some(first), Some(last)) = (chain.first(), chain.last()) else {
            let known = arranged.zero_length.contains(&(i as u32)) || arranged.collapsed.contains(&(i as u32));
            assert!(known && (p == q || !free), "segment {i} is lost");
            continue;
        };
        if free {
            assert_eq!([s.point(s.origin(*first)), s.point(s.destination(*last))], [p, q], "segment {i}");
        }
    }
    let along = arranged.segments_along();
    for e in s.edges() {
        assert!(!along.of(e).is_empty(), "{e} belongs to no segment");
        assert!(on_edge[e.index()] >= along.of(e).len().min(1), "{e}");
    }
}

/// Claims that the kit's own text gives the subdivision back.
fn assert_comes_back(s: &Subdivision) {
    let mut text = Vec::new();
    write(&mut text, &Model::planar(s), Format::Dcel).expect("the kit's own text holds everything");
    let read = read_bytes(&text, Format::Dcel, "file", &ReadOptions::default());
    let Document::Table(table) = read.unwrap_or_else(|error| panic!("{error}")).document else { panic!("no table") };
    // Without the full check polygons may overlap; then the table is refused, too.
    match Subdivision::from_table(&table) {
        // Ids after the last one that exists are forgotten, so the texts are compared.
        Ok(again) => {
            let mut second = Vec::new();
            write(&mut second, &Model::planar(&again), Format::Dcel).expect("as before");
            assert!(second == text, "the subdivision changed");
        }
        Err(error) => assert!(!s.geometry_violations().is_empty(), "{error}"),
    }
}
