//! The kit's types in the terms of other crates. Needs the features of the module `interop`:
//! `cargo test -p dcel-tests --features interop --test interop`.
#![allow(clippy::unwrap_used, clippy::float_cmp)] // a test may panic, and compares what must be the same number

mod common;

use common::Random;
use dcel_kit::plane::{CoordinateError, PlanarView};
use dcel_kit::solid::{Platonic, Polyhedron, grow::Shape};
use dcel_kit::topology::{Dcel, IsomorphismOptions, Table, isomorphic_with, position_key, violations};
use dcel_kit::{EdgeId, FaceId, FaceMap, HalfEdgeId, Point, Subdivision, VertexId, VertexMap};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

fn h(number: u32) -> HalfEdgeId {
    HalfEdgeId::new(number)
}

/// Segments of a small grid: faces, dangling edges, bridges, components in components, borders that touch themselves.
fn random_subdivision(seed: u64) -> Subdivision {
    let mut random = Random(seed);
    let mut segments = Vec::new();
    let coordinate = |random: &mut Random| random.below(7) as f64 + [0.0, 0.0, 0.1][random.below(3)];
    for _ in 0..8 {
        segments.push([0, 0].map(|_| Point::new(coordinate(&mut random), coordinate(&mut random))));
    }
    let mut ring = |corners: [[f64; 2]; 4]| {
        segments.extend((0..4).map(|i| [corners[i], corners[(i + 1) % 4]].map(Point::from)));
    };
    ring([[-2.0, -2.0], [9.0, -2.0], [9.0, 9.0], [-2.0, 9.0]]);
    for _ in 0..random.below(6) {
        let [x, y] = [0, 0].map(|_| random.below(9) as f64 - 1.0);
        ring([[x - 0.5, y], [x, y - 0.5], [x + 0.5, y], [x, y + 0.5]]);
    }
    let options = dcel_kit::plane::ArrangeOptions { split: true, merge: true, ..Default::default() };
    Subdivision::arrange_segments(&segments, &options).unwrap().subdivision
}

fn is_same_place(a: &Subdivision, b: &Subdivision) -> bool {
    let key = |s: &Subdivision, v| position_key(s.position(v).map(|p| [p.x, p.y]).unwrap());
    isomorphic_with(a, b, &IsomorphismOptions::new().keys(&|v| key(a, v), &|v| key(b, v))).is_ok()
}

mod through_serde {
    use super::*;

    fn again<T: serde::Serialize + DeserializeOwned>(value: &T) -> T {
        serde_json::from_str(&serde_json::to_string(value).unwrap()).unwrap()
    }

    fn refusal<T: DeserializeOwned + std::fmt::Debug>(value: Value) -> String {
        serde_json::from_value::<T>(value).unwrap_err().to_string()
    }

    #[test]
    fn ids_maps_and_points_come_back_and_bad_ones_are_refused() {
        assert_eq!(
            serde_json::to_value((VertexId::new(3), h(7), EdgeId::new(3), FaceId::new(0))).unwrap(),
            json!([3, 7, 3, 0])
        );
        assert_eq!(again(&h(2_147_483_645)), h(2_147_483_645));
        assert!(refusal::<VertexId>(json!(2_147_483_646_u32)).contains("below 2147483646"));
        let names: std::collections::BTreeMap<FaceId, String> = [(FaceId::new(4), "hall".to_owned())].into();
        assert_eq!(serde_json::to_string(&names).unwrap(), r#"{"4":"hall"}"#);
        assert_eq!(again(&names), names);
        let map: VertexMap<String> = vec!["a".to_owned(), "b".to_owned()].into();
        assert_eq!((serde_json::to_value(&map).unwrap(), again(&map)), (json!(["a", "b"]), map.clone()));
        let point = Point::new(0.1 + 0.2, -1e-30);
        assert_eq!(again(&point), point);
        assert_eq!(
            refusal::<Point>(json!([1e300, 0])),
            CoordinateError::OutOfRange { axis: 'x', value: 1e300 }.to_string()
        );
        let (component, obstacle) = (dcel_kit::navmesh::ComponentId(5), dcel_kit::navmesh::ObstacleId(6));
        assert_eq!(again(&(component, obstacle)), (component, obstacle));
    }

    /// JSON brings every coordinate back to the last bit: without `float_roundtrip` about one in ten thousand is off.
    #[test]
    fn coordinates_come_back_to_the_last_bit() {
        let mut random = Random(7);
        for _ in 0..20_000 {
            let x = f64::from_bits(random.next() % (0x7fe0 << 48)) % 1e50 + random.below(1000) as f64 / 7.0;
            let point = Point::new(x, -x / 3.0);
            if point.check().is_ok() {
                let [a, b] = [point, again(&point)].map(|p| [p.x.to_bits(), p.y.to_bits()]);
                assert_eq!(a, b, "{x:e}");
            }
        }
    }

    #[test]
    fn structures_come_back_with_their_free_numbers() {
        let mut d = Dcel::polygon(5).unwrap();
        d.split_face(h(0), h(4)).unwrap();
        d.split_face(h(4), h(8)).unwrap();
        d.join_faces(h(10)).unwrap();
        assert_eq!((d.edge_count(), d.edge_bound()), (6, 7));
        let mut back = again(&d);
        assert_eq!(back, d);
        // The free numbers are given out again, the lowest one first.
        assert_eq!(back.split_edge(h(0)).unwrap(), d.split_edge(h(0)).unwrap());
        assert_eq!((d.edge_bound(), back), (7, d));
        for closed in [Dcel::torus(), Dcel::new()] {
            assert_eq!(again(&closed), closed);
        }
        for seed in 0..60 {
            let s = random_subdivision(seed);
            assert_eq!(again(&s), s, "seed {seed}");
        }
        for solid in [
            Polyhedron::platonic(Platonic::Dodecahedron),
            Shape::Torus { n: 5, m: 4 }.build().unwrap().polyhedron,
            Polyhedron::new(),
        ] {
            assert_eq!(again(&solid), solid);
        }
        let mut open = Polyhedron::platonic(Platonic::Cube);
        open.remove_face(FaceId::new(2)).unwrap();
        assert_eq!(again(&open), open);
        assert_eq!(open.boundary_faces().len(), 1);
    }

    /// Each number of a structure, set to something else: refused by a sentence, or a sound structure. Never a panic.
    #[test]
    fn nothing_broken_gets_in() {
        let room = serde_json::to_value(Subdivision::lab_rectangle()).unwrap();
        let cube = serde_json::to_value(Polyhedron::platonic(Platonic::Cube)).unwrap();
        let (mut refused, mut accepted) = (0, 0);
        for (whole, is_plane) in [(room, true), (cube, false)] {
            let columns = whole["structure"].as_object().unwrap().clone();
            for (name, column) in columns.iter().filter(|(_, column)| column.is_array()) {
                for i in 0..column.as_array().unwrap().len() {
                    for wrong in [json!(null), json!(0), json!(3), json!(99), json!(4_294_967_295_u32)] {
                        let mut broken = whole.clone();
                        broken["structure"][name.as_str()][i] = wrong;
                        let sound = if is_plane {
                            serde_json::from_value::<Subdivision>(broken)
                                .map(|s| violations(&s).is_empty() && s.geometry_violations().is_empty())
                        } else {
                            serde_json::from_value::<Polyhedron>(broken).map(|p| violations(p.topology()).is_empty())
                        };
                        match sound {
                            Ok(sound) => {
                                assert!(sound, "{name}[{i}]");
                                accepted += 1;
                            }
                            Err(error) => {
                                assert!(error.to_string().len() > 10, "{error}");
                                refused += 1;
                            }
                        }
                    }
                }
            }
        }
        assert!(refused > 500 && accepted > 20, "{refused} refused, {accepted} accepted");
    }

    #[test]
    fn refusals_are_those_of_the_readers() {
        let room = serde_json::to_value(Subdivision::lab_rectangle()).unwrap();
        let with = |change: &dyn Fn(&mut Value)| {
            let mut room = room.clone();
            change(&mut room);
            refusal::<Subdivision>(room)
        };
        assert_eq!(with(&|room| room["subdivision"] = json!(2)), "version 2 of the format; this kit reads version 1");
        let table = |change: &dyn Fn(&mut Table)| {
            let lab = Subdivision::lab_rectangle();
            let mut table = Table::from_view(&lab);
            for v in lab.vertices() {
                table.vertices[v.index()].as_mut().unwrap().position = lab.position(v).map(|p| [p.x, p.y]);
            }
            change(&mut table);
            Subdivision::from_table(&table).unwrap_err().to_string()
        };
        assert_eq!(
            with(&|room| room["structure"]["next"][0] = json!(4)),
            table(&|table| table.half_edges[0].as_mut().unwrap().next = Some(h(4)))
        );
        assert_eq!(
            with(&|room| room["points"][1] = json!(null)),
            table(&|table| table.vertices[1].as_mut().unwrap().position = None)
        );
        assert_eq!(
            with(&|room| room["points"][0] = json!([400.0, 0.0])),
            table(&|table| table.vertices[0].as_mut().unwrap().position = Some([400.0, 0.0]))
        );
        assert!(with(&|room| drop(room["structure"]["prev"].as_array_mut().unwrap().pop())).contains("`prev` has 11"));
        assert!(with(&|room| drop(room["points"].as_array_mut().unwrap().pop())).contains("`points` has 5"));
        assert_eq!(with(&|room| room["holes"] = json!([7])), "`holes`: there is no f7: there are 2 faces");
        assert!(with(&|room| room["structure"]["free_vertices"] = json!([1])).contains("v1 is said to be free"));
        let cube = serde_json::to_value(Polyhedron::platonic(Platonic::Cube)).unwrap();
        let mut broken = cube;
        broken["boundary_faces"] = json!([9]);
        assert!(refusal::<Polyhedron>(broken).contains("f9 was named as a boundary face"));
    }

    /// Files that say little and promise much: memory grows with the file alone.
    #[test]
    fn large_numbers_do_not_ask_for_memory() {
        let text = r#"{"dcel":1,"origin":[4000000000,0],"next":[1,0],"prev":[1,0],"face":[0,0],"outgoing":[0],"half_edge":[0],"free_vertices":[],"free_faces":[]}"#;
        let error = serde_json::from_str::<Dcel>(text).unwrap_err().to_string();
        assert!(error.contains("h0.origin = v4000000000"), "{error}");
    }
}

mod through_geo_types {
    use super::*;
    use dcel_kit::interop::GeoError;
    use geo_types::{Coord, LineString, MultiLineString, MultiPolygon, Polygon, coord, line_string, polygon};

    fn square(x: f64, y: f64, side: f64) -> Polygon<f64> {
        polygon![(x: x, y: y), (x: x + side, y: y), (x: x + side, y: y + side), (x: x, y: y + side)]
    }

    /// The signed area by the sum over the sides, and whether a ring passes a point twice.
    fn area(ring: &LineString<f64>) -> f64 {
        ring.lines().map(|l| l.start.x * l.end.y - l.end.x * l.start.y).sum::<f64>() / 2.0
    }

    #[test]
    fn points_come_and_go() {
        let p = Point::new(1.5, -2.0);
        assert_eq!(Point::from(Coord::from(p)), p);
        assert_eq!(Point::from(geo_types::Point::from(p)), p);
        assert_eq!(Coord::from(p), coord! { x: 1.5, y: -2.0 });
    }

    #[test]
    fn rings_either_way_holes_and_corners_on_sides() {
        let mut hole = square(1., 1., 1.).exterior().clone();
        let outer = LineString(square(0., 0., 4.).exterior().0.iter().rev().copied().collect());
        for _ in 0..2 {
            // The neighbour has a corner in the middle of the right side.
            let right = polygon![(x: 4., y: 0.), (x: 6., y: 0.), (x: 6., y: 4.), (x: 4., y: 4.), (x: 4., y: 2.)];
            let map = MultiPolygon(vec![Polygon::new(outer.clone(), vec![hole.clone()]), right]);
            let s = Subdivision::try_from(&map).unwrap();
            assert_eq!((s.vertex_count(), s.face_count(), s.hole_faces().count()), (11, 4, 1));
            assert_eq!((s.area(FaceId::new(1)), s.area(FaceId::new(2))), (15.0, 8.0));
            let out = s.polygon_of(FaceId::new(1)).unwrap();
            assert_eq!((area(out.exterior()), area(&out.interiors()[0])), (16.0, -1.0));
            assert!(out.exterior().is_closed() && out.interiors()[0].is_closed());
            assert_eq!(MultiPolygon::from(&s).0.len(), 2);
            hole.0.reverse();
        }
    }

    #[test]
    fn what_does_not_fit_is_named_with_its_place() {
        let both = MultiPolygon(vec![square(0., 0., 4.), square(1., 1., 9.)]);
        let error = Subdivision::try_from(&both).unwrap_err();
        assert!(error.to_string().contains("cross"), "{error}");
        let empty = MultiPolygon(vec![square(0., 0., 4.), Polygon::new(LineString(vec![]), vec![])]);
        assert_eq!(Subdivision::try_from(&empty).unwrap_err(), GeoError::Empty { polygon: 1 });
        let bad = polygon![(x: 0., y: 0.), (x: f64::NAN, y: 1.), (x: 2., y: 2.)];
        let error = Subdivision::try_from(&bad).unwrap_err().to_string();
        assert!(error.starts_with("vertex 1: x is NaN"), "{error}");
        let twisted = polygon![(x: 0., y: 0.), (x: 4., y: 4.), (x: 4., y: 0.), (x: 0., y: 4.), (x: -1., y: 2.)];
        assert!(Subdivision::try_from(&twisted).is_err());
        assert!(Subdivision::try_from(&MultiPolygon::<f64>(vec![])).unwrap().face_count() == 1);
    }

    #[test]
    fn lines_become_edges_and_edges_lines() {
        let lines = MultiLineString(vec![
            line_string![(x: 0., y: 0.), (x: 4., y: 0.), (x: 0., y: 3.), (x: 0., y: 0.)],
            line_string![(x: 4., y: 0.), (x: 9., y: 0.)],
        ]);
        let s = Subdivision::try_from(&lines).unwrap();
        assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (4, 4, 2));
        let back = MultiLineString::from(&s);
        assert_eq!(back.0.len(), 4);
        assert!(is_same_place(&Subdivision::try_from(&back).unwrap(), &s));
        let crossing = MultiLineString(vec![
            line_string![(x: 0., y: 0.), (x: 2., y: 2.)],
            line_string![(x: 0., y: 2.), (x: 2., y: 0.)],
        ]);
        assert!(Subdivision::try_from(&crossing).unwrap_err().to_string().contains("cross at (1, 1)"));
    }

    /// Faces with dangling edges, bridges and pinched borders: the polygon covers what the face covers, by simple rings.
    #[test]
    fn polygons_cover_their_faces() {
        let (mut interiors, mut dangling) = (0, 0);
        for seed in 0..300 {
            let s = random_subdivision(seed);
            assert_eq!(s.polygon_of(FaceId::new(0)), None);
            for f in s.faces().skip(1) {
                let polygon = s.polygon_of(f).unwrap();
                let rings: Vec<_> = std::iter::once(polygon.exterior()).chain(polygon.interiors()).collect();
                assert!(area(rings[0]) > 0.0 && rings[1..].iter().all(|ring| area(ring) < 0.0), "seed {seed}: {f}");
                let sum: f64 = rings.iter().map(|ring| area(ring)).sum();
                assert!((sum - s.area(f)).abs() < 1e-9, "seed {seed}: {f}: {sum}, {}", s.area(f));
                for ring in &rings {
                    let mut corners: Vec<_> = ring.0[1..].iter().map(|c| [c.x.to_bits(), c.y.to_bits()]).collect();
                    let all = corners.len();
                    corners.sort_unstable();
                    corners.dedup();
                    assert_eq!((corners.len(), ring.is_closed()), (all, true), "seed {seed}: {f} is no simple ring");
                }
                interiors += rings.len() - 1;
                dangling += usize::from(s.cycles(f).flat_map(|h| s.cycle(h)).any(|h| s.face(s.twin(h)) == f));
            }
        }
        assert!(interiors > 20 && dangling > 100, "{interiors} holes, {dangling} faces with dangling edges");
    }

    /// Out and in again: polygon i is face i + 1, with the same rings.
    #[test]
    fn polygons_of_a_map_make_the_map_again() {
        let corners = |polygon: &Polygon<f64>| {
            let rings = std::iter::once(polygon.exterior()).chain(polygon.interiors());
            let bits = |ring: &LineString<f64>| {
                let mut corners: Vec<_> = ring.0[1..].iter().map(|c| [c.x.to_bits(), c.y.to_bits()]).collect();
                corners.sort_unstable();
                corners
            };
            let mut rings: Vec<_> = rings.map(bits).collect();
            rings[1..].sort_unstable();
            rings
        };
        let mut tried = 0;
        for seed in 0..100 {
            let s = random_subdivision(seed);
            let polygons = MultiPolygon::from(&s);
            let again = Subdivision::try_from(&polygons).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
            for (i, polygon) in polygons.0.iter().enumerate() {
                let f = FaceId::new(i as u32 + 1);
                assert_eq!(corners(&again.polygon_of(f).unwrap()), corners(polygon), "seed {seed}: {f}");
                tried += 1;
            }
            assert_eq!(again.hole_faces().count(), 0, "seed {seed}: the faces of a map fill it");
        }
        assert!(tried > 500, "{tried}");
    }
}

#[test]
fn points_are_vectors_of_games() {
    let p = Point::new(0.1, -2.5);
    assert_eq!(Point::from(glam::DVec2::from(p)), p);
    assert_eq!(Point::from(glam::Vec2::new(0.1, 2.0)), Point::new(f64::from(0.1_f32), 2.0));
    assert_eq!(Point::from(mint::Point2::from(p)), p);
    assert_eq!(Point::from(mint::Vector2::from(p)), p);
    assert_eq!(mint::Point2::from(p), mint::Point2 { x: 0.1, y: -2.5 });
    // Points in space are arrays, which these crates take as they are.
    let cube = Polyhedron::platonic(Platonic::Cube);
    let corner = cube.point(VertexId::new(0));
    assert_eq!(glam::DVec3::from(corner).to_array(), corner);
    assert_eq!(<[f64; 3]>::from(mint::Point3::from(corner)), corner);
    let _: FaceMap<()> = FaceMap::filled(cube.face_bound(), ());
}
