//! Counts and triangles that others state (`../shared/data`, families O03 and O04).

use crate::families::{check, edges};
use dcel_kit::plane::{Point, Subdivision};
use serde_json::Value;
use std::path::{Path, PathBuf};

fn data(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(path)
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn point(position: &Value) -> Point {
    Point::new(position[0].as_f64().unwrap(), position[1].as_f64().unwrap())
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_point_sets_that_broke_others() {
    let expected = json(&data("O03-delaunator/expected.json"));
    let fixtures = expected.as_object().unwrap();
    assert_eq!(fixtures.len(), 8);
    for (name, stated) in fixtures {
        // Not by serde_json, which may be off by a last place: these points are about last places.
        let text = std::fs::read_to_string(data("O03-delaunator/fixtures").join(name)).unwrap();
        let words = text.split(|c: char| "[], \r\n\t".contains(c)).filter(|word| !word.is_empty());
        let numbers: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
        let points: Vec<Point> = numbers.chunks_exact(2).map(|xy| Point::new(xy[0], xy[1])).collect();
        let built = Subdivision::delaunay(&points).unwrap();
        let s = &built.subdivision;
        let outline = s.incident_half_edges(s.outer_face()).count();
        let found = [points.len(), s.vertex_count(), outline, s.face_count() - 1, s.edge_count()];
        let keys = ["points", "distinct", "hull_points_incl_collinear", "triangles", "edges"];
        assert_eq!(found.map(|n| n as u64), keys.map(|key| stated[key].as_u64().unwrap()), "{name}");
        assert_eq!(s.geometry_violations(), [], "{name}");
        assert_eq!(s.non_delaunay_edges(|_| false).count(), 0, "{name}");
        if s.vertex_count() < 120 {
            check(s, name);
        }
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_triangles_of_a_map_program() {
    let folder = data("O04-turf/turf-tin/test");
    let points: Vec<Point> = json(&folder.join("Points.json"))["features"]
        .as_array()
        .unwrap()
        .iter()
        .map(|feature| point(&feature["geometry"]["coordinates"]))
        .collect();
    let s = Subdivision::delaunay(&points).unwrap().subdivision;
    let stated = json(&folder.join("Tin.json"));
    let triangles = stated["features"].as_array().unwrap();
    assert_eq!(s.face_count() - 1, triangles.len());
    let sides: std::collections::BTreeSet<_> = triangles
        .iter()
        .flat_map(|triangle| {
            let ring: Vec<Point> =
                triangle["geometry"]["coordinates"][0].as_array().unwrap().iter().map(point).collect();
            ring.windows(2).map(|w| [w[0], w[1]]).collect::<Vec<_>>()
        })
        .map(|ends| {
            let mut ends = ends.map(|p| [p.x.to_bits(), p.y.to_bits()]);
            ends.sort_unstable();
            ends
        })
        .collect();
    assert_eq!(edges(&s), sides);
}
