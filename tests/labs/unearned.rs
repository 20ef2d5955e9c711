//! Nothing is given for nothing: a function that does nothing, or always gives the same answer, is right wherever that
//! happens to be the answer. As long as what it builds on is not written, that must not be worth a point.

use crate::shell::Folder;
use serde_json::Value;

/// Of each lab in which that could be: a function, and what stands in the place of its `todo!()`.
const IDLE: [(&str, &str, &str); 5] = [
    ("01", "in_triangle", "false"),
    ("02", "split", "None"),
    ("02", "is_ear", "true"),
    ("07", "delaunify", "Vec::new()"),
    ("08", "ray", "None"),
];

#[test]
fn idle_functions_earn_nothing() {
    let folder = Folder::empty();
    for (lab, function, idle) in IDLE {
        let name = format!("{lab}-{function}");
        folder.dcel(&format!("lab start {lab} {name}")).fine();
        let file = folder.path(&format!("{name}/src/lab.rs"));
        let starter = std::fs::read_to_string(&file).unwrap();
        let todo = format!("todo!(\"{function}\")");
        assert_eq!(starter.matches(&todo).count(), 1, "{name}");
        std::fs::write(&file, starter.replace(&todo, idle)).unwrap();
        let report: Value = serde_json::from_str(&folder.dcel(&format!("lab check {name} --json")).out).unwrap();
        let tests = report["tests"].as_array().unwrap();
        let earned: Vec<_> = tests.iter().filter(|test| test["verdict"] == "passed").collect();
        assert!(earned.is_empty(), "{name}: {earned:#?}");
        assert!(tests.iter().any(|test| test["verdict"] == "wrong"), "{name}: it is written, and wrong: {tests:#?}");
    }
}
