//! The map of the states, read from TopoJSON into segments.

use super::cases::{P, plane};
use dcel_kit::FaceId;
use dcel_kit::topology::Table;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// The structure and the name of every face that is (a part of) a state.
pub(crate) fn load() -> (Table, Vec<(FaceId, String)>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures/data/states-albers-10m.json");
    let json: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let arcs: Vec<Vec<[i64; 2]>> = json["arcs"].as_array().unwrap().iter().map(arc).collect();

    let mut numbers: BTreeMap<[i64; 2], usize> = BTreeMap::new();
    let mut points: Vec<P> = Vec::new();
    let mut vertex = |p: [i64; 2]| {
        *numbers.entry(p).or_insert_with(|| {
            points.push([p[0] as f64 * 0.010_151_986, -(p[1] as f64) * 0.005_935_99]);
            points.len() - 1
        })
    };
    let mut segments = Vec::new();
    let mut along: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    let mut parts: Vec<(String, Vec<usize>)> = Vec::new();
    for state in json["objects"]["states"]["geometries"].as_array().unwrap() {
        let name = state["properties"]["name"].as_str().unwrap();
        let polygons = state["arcs"].as_array().unwrap();
        let single = [state["arcs"].clone()];
        let polygons = if state["type"] == "Polygon" { &single[..] } else { &polygons[..] };
        for ring in polygons.iter().flat_map(|polygon| polygon.as_array().unwrap()) {
            let mut corners: Vec<usize> = Vec::new();
            for index in ring.as_array().unwrap() {
                let index = index.as_i64().unwrap();
                let arc = &arcs[if index < 0 { !index } else { index } as usize];
                let mut run: Vec<usize> = arc.iter().map(|&p| vertex(p)).collect();
                if index < 0 {
                    run.reverse();
                }
                corners.extend(run);
            }
            corners.dedup();
            corners.pop();
            let mut distinct = corners.clone();
            distinct.sort_unstable();
            distinct.dedup();
            if distinct.len() < 3 {
                continue;
            }
            for (i, &a) in corners.iter().enumerate() {
                let b = corners[(i + 1) % corners.len()];
                if !along.contains_key(&(a, b)) {
                    along.insert((a, b), 2 * segments.len());
                    along.insert((b, a), 2 * segments.len() + 1);
                    segments.push((a, b));
                }
            }
            parts.push((name.to_owned(), corners));
        }
    }
    let table = plane(&points, &segments);
    let mut names = Vec::new();
    for (name, corners) in parts {
        let n = corners.len();
        let area: f64 = (0..n)
            .map(|i| (points[corners[i]], points[corners[(i + 1) % n]]))
            .map(|(a, b)| a[0] * b[1] - b[0] * a[1])
            .sum();
        let (a, b) = if area > 0.0 { (corners[0], corners[1]) } else { (corners[1], corners[0]) };
        names.push((table.half_edges[along[&(a, b)]].unwrap().face.unwrap(), name));
    }
    (table, names)
}

/// The points of an arc: differences of integers.
fn arc(arc: &Value) -> Vec<[i64; 2]> {
    let mut at = [0, 0];
    let step = |step: &Value| {
        at = [at[0] + step[0].as_i64().unwrap(), at[1] + step[1].as_i64().unwrap()];
        at
    };
    arc.as_array().unwrap().iter().map(step).collect()
}
