//! Solids that others have made and measured: 120 convex ones, and two folders of meshes.

use super::common::Random;
use dcel_kit::io::{LoadOptions, Structure, load};
use dcel_kit::solid::{Direction, PartCounts, Polyhedron};
use dcel_kit::topology::{Mode, PolygonList, violations};
use serde_json::Value;
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

fn shared(place: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(place)
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

fn numbers(list: &Value) -> Vec<u32> {
    list.as_array().unwrap().iter().map(|n| n.as_u64().unwrap() as u32).collect()
}

/// 5 regular, 13 Archimedean and 92 Johnson solids, 10 prisms and antiprisms.
#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_120_convex_solids_have_their_counts_edges_angles_and_duals() {
    let expected = json(&shared("O06-polyhedra-json/expected.json"));
    let mut random = Random(1);
    for (name, expected) in expected.as_object().unwrap() {
        let file = json(&shared("O06-polyhedra-json").join(name));
        let points = file["vertices"].as_array().unwrap().iter();
        let points = points.map(|p| std::array::from_fn(|i| p[i].as_f64().unwrap())).collect();
        let mut faces = PolygonList::new();
        file["faces"].as_array().unwrap().iter().for_each(|face| faces.push_face(&numbers(face)));
        let solid = Polyhedron::from_polygons(points, &faces).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(violations(&solid), [], "{name}");

        let count = |key: &str| expected[key].as_u64().unwrap() as usize;
        let [part] = solid.parts()[..] else { panic!("{name}: one piece") };
        assert_eq!((part.vertices, part.edges, part.faces), (count("V"), count("E"), count("F")), "{name}");
        assert_eq!((part.euler(), part.genus(), part.borders), (2, 0, 0), "{name}");
        assert!(part.is_within_edge_bound(), "{name}");
        let ends = |a: u32, b: u32| (a.min(b), a.max(b));
        let listed: BTreeSet<_> =
            file["edges"].as_array().unwrap().iter().map(numbers).map(|e| ends(e[0], e[1])).collect();
        let edges = solid.edges().map(|e| e.half_edges().map(|h| solid.topology().origin(h).number()));
        assert_eq!(edges.map(|[a, b]| ends(a, b)).collect::<BTreeSet<_>>(), listed, "{name}");

        // Coordinates have six decimals, so faces are bent by a millionth, and angles are off by as much.
        assert!((solid.total_deficit() - 2.0 * TAU).abs() < 1e-4, "{name}: {}", solid.total_deficit());
        assert!(solid.signed_volume() > 0.0, "{name}");
        let dual = solid.dual().unwrap_or_else(|error| panic!("{name}: {error}")).solid;
        assert_eq!(violations(&dual), [], "{name}");
        assert_eq!(
            (dual.vertex_count(), dual.edge_count(), dual.face_count()),
            (solid.face_count(), solid.edge_count(), solid.vertex_count()),
            "{name}"
        );
        let convex = solid.check_convex().unwrap_or_else(|error| panic!("{name}: {error}"));
        for _ in 0..50 {
            let d: [f64; 3] = std::array::from_fn(|_| random.below(2001) as f64 - 1000.0);
            let direction = Direction::try_from(d).unwrap();
            let found = convex.support(direction);
            assert_eq!(found, convex.support_by_search(direction), "{name} {d:?}");
            let far = |v| (0..3).map(|i| d[i] * solid.point(v)[i]).sum::<f64>();
            let furthest = solid.vertices().map(far).fold(f64::NEG_INFINITY, f64::max);
            assert!(far(found) >= furthest - 1e-12 * furthest.abs(), "{name} {d:?}");
        }
    }
    assert_eq!(expected.as_object().unwrap().len(), 120);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn meshes_of_others_have_their_counts_and_handles() {
    let mut read = 0;
    for folder in ["O11-pmp-small", "O13-trimesh-small"] {
        for (name, expected) in json(&shared(folder).join("expected.json")).as_object().unwrap() {
            let options = LoadOptions { mode: Some(Mode::Surface), ..LoadOptions::default() };
            let loaded = load(&shared(folder).join(name), &options);
            let surface = match loaded.map(|loaded| loaded.structure) {
                Ok(Structure::Surface(surface)) if surface.face_count() > 0 => surface,
                Ok(Structure::Surface(_)) => continue,
                other => {
                    let fine = expected["oriented_manifold"] == true && !name.starts_with("empty");
                    assert!(!fine, "{name}: {other:?}");
                    continue;
                }
            };
            assert_eq!(expected["oriented_manifold"], true, "{name}");
            let count = |key: &str| expected[key].as_i64().unwrap();
            let parts = surface.parts();
            let sum = |of: fn(&PartCounts) -> i64| parts.iter().map(of).sum::<i64>();
            assert_eq!(parts.len() as i64, count("components"), "{name}");
            // Theirs counts the one square of this file as two triangles.
            let cut = i64::from(name == "plane.ply");
            assert_eq!(sum(|p| p.edges as i64), count("E") - cut, "{name}");
            assert_eq!(sum(PartCounts::euler), count("chi"), "{name}");
            assert_eq!(sum(|p| p.borders as i64), count("boundary_loops"), "{name}");
            assert_eq!(sum(PartCounts::genus) as f64, expected["genus_total"].as_f64().unwrap(), "{name}");
            read += 1;
        }
    }
    assert!(read >= 25, "{read}");
}
