//! A mistake is called by a true name or by none: one that breaks the same law in the same calls as a known one, but in
//! another way, must not have its name.

use crate::shell::Folder;
use serde_json::Value;
use std::fs;

/// Of labs: what stands once in the solution, and what is written instead. Each is caught by the test that catches a known
/// mistake of the same function.
const ALIKE: [(&str, &str, &str); 7] = [
    // Not edges counted twice: the last sign.
    ("09-two-primitives", "v - h / 2 + f", "v - h / 2 - f"),
    // Not the last spoke, but the first, is missing.
    ("09-two-primitives", "&corners[1..]", "&corners[2..]"),
    // Not the front alone, but the back alone, is cut.
    ("09-two-primitives", "\n    square.fill(start, n, m);", ""),
    // Not rounded: exchanged.
    ("05-triangle-list", "new_vertex(point.x, point.y)", "new_vertex(point.y, point.x)"),
    ("08-voronoi", "self.twin(self.prev(h))", "self.prev(self.twin(h))"),
    // Not the last triangle, but the first, is forgotten.
    ("02-triangulation", "triangles.push(corner);", "triangles.push(corner); triangles.remove(0);"),
    // Not a side of the hull: the dots.
    ("03-convex-hulls", "svg.dot(dot);", "let _ = dot;"),
];

/// And one that is a known mistake, written in another way.
const KNOWN: (&str, &str, &str, &str) =
    ("09-two-primitives", "v - h / 2 + f", "v + f - h", "half-edges are counted, not edges");

#[test]
fn a_mistake_like_a_known_one_does_not_have_its_name() {
    let folder = Folder::empty();
    let names = |lab: &str, find: &str, write: &str| -> Vec<Value> {
        if !folder.path(lab).exists() {
            folder.dcel(&format!("lab start {lab} {lab}")).fine();
        }
        let labs = concat!(env!("CARGO_MANIFEST_DIR"), "/../../labs");
        let solution = fs::read_to_string(format!("{labs}/{lab}/solution/lab.rs")).unwrap();
        assert_eq!(solution.matches(find).count(), 1, "{lab}: {find}");
        fs::write(folder.path(&format!("{lab}/src/lab.rs")), solution.replace(find, write)).unwrap();
        let report: Value = serde_json::from_str(&folder.dcel(&format!("lab check {lab} --json")).out).unwrap();
        let tests = report["tests"].as_array().unwrap();
        assert!(tests.iter().any(|test| test["verdict"] == "wrong"), "{lab}: {write} is caught: {tests:#?}");
        tests.iter().flat_map(|test| test["bugs"].as_array().unwrap().clone()).collect()
    };
    for (lab, find, write) in ALIKE {
        assert_eq!(names(lab, find, write), Vec::<Value>::new(), "{lab}: {write}");
    }
    let (lab, find, write, title) = KNOWN;
    assert_eq!(names(lab, find, write), [title]);
}
