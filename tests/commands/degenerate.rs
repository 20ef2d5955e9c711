//! Promise: each kind of bad input ends in one clear sentence that names the file, the line and the elements, with
//! exit code 2, or in a success that is documented. Nothing panics.

use std::path::Path;
use std::process::{Command, Output};

fn dcel(arguments: &[&str], folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_dcel")).args(arguments).current_dir(folder).output().unwrap()
}

const SQUARE: &str = "v 0 0\nv 4 0\nv 4 4\nv 0 4\n";

/// File name, contents, what the error must say.
fn refused() -> Vec<(&'static str, Vec<u8>, Vec<&'static str>)> {
    let text = |head: &str, tail: &str| format!("{head}{tail}").into_bytes();
    let mut binary = b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n\
        element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        .to_vec();
    binary.extend([0u8; 40]);
    vec![
        ("nan.obj", text("v 0 0\nv nan 1\n", ""), vec!["nan.obj:2:3", "x", "finite"]),
        ("inf.off", text("OFF\n3 1 0\n0 0 0\n1 -inf 0\n0 1 0\n3 0 1 2\n", ""), vec!["inf.off:4:3", "y", "finite"]),
        ("far.obj", text("v 0 0\nv 1 0\nv 0 1e300\nf 1 2 3\n", ""), vec!["far.obj:3:5", "1e300", "range"]),
        ("tiny.obj", text("v 0 0\nv 1 1e-200\nv 0 1\nf 1 2 3\n", ""), vec!["tiny.obj:2:5", "1e-200", "range"]),
        ("repeat.obj", text(SQUARE, "f 1 2 3 2\n"), vec!["repeat.obj:5", "vertex 1", "line 2"]),
        ("missing.obj", text(SQUARE, "f 1 2 9\n"), vec!["missing.obj:5:7", "9"]),
        ("zero.obj", text(SQUARE, "f 0 1 2\n"), vec!["zero.obj:5:3", "0"]),
        ("two.obj", text(SQUARE, "f 1 2 3\nf 3 4\n"), vec!["two.obj:6", "2 corners"]),
        ("bow.obj", text(SQUARE, "f 1 3 2 4\n"), vec!["bow.obj:5", "crosses", "(0, 0) -> (4, 4)", "(4, 0) -> (0, 4)"]),
        (
            "three.obj",
            text(SQUARE, "v 2 -9\nf 1 2 3\nf 1 2 4\nf 2 1 5\n"),
            vec!["three.obj:6", "three", "line 7", "line 8"],
        ),
        ("mixed.obj", text(SQUARE, "f 1 2 3\nf 1 4 3\n"), vec!["mixed.obj:5", "line 6"]),
        ("twice.obj", text(SQUARE, "f 1 2 3\nf 2 3 1\n"), vec!["twice.obj:5", "line 6", "repeats"]),
        ("flat.obj", text("v 0 0\nv 1 1\nv 2 2\n", "f 1 2 3\n"), vec!["flat.obj:4", "no area"]),
        ("empty.obj", Vec::new(), vec!["empty.obj", "empty"]),
        ("empty.json", Vec::new(), vec!["empty.json", "empty"]),
        ("cut.ply", binary, vec!["cut.ply", "byte"]),
        ("cut.json", text("{\"type\": \"FeatureCollection\",\n \"features\": [", ""), vec!["cut.json:2"]),
        ("crlf.obj", text("v 0 0\r\nv 1 0\r\nv 1 1\r\nf 1 2 7\r\n", ""), vec!["crlf.obj:4:7", "7"]),
    ]
}

#[test]
fn every_bad_input_is_named_with_its_place_and_elements() {
    let folder = tempfile::tempdir().unwrap();
    for (name, contents, wanted) in refused() {
        std::fs::write(folder.path().join(name), contents).unwrap();
        for command in [vec!["info", name], vec!["info", "--json", name], vec!["figure", name]] {
            let output = dcel(&command, folder.path());
            let stderr = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(2), "{command:?}: {stderr}");
            if command.contains(&"--json") {
                let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
                let keys: Vec<&String> = answer.as_object().unwrap().keys().collect();
                assert_eq!(keys, ["error"], "{command:?}: an answer beside the error");
            } else {
                assert!(output.stdout.is_empty(), "{command:?}: an answer beside the error");
            }
            assert!(stderr.starts_with("error: "), "{command:?}: {stderr}");
            for part in &wanted {
                assert!(stderr.contains(part), "{command:?}: `{part}` is not in\n{stderr}");
            }
        }
    }
}

#[test]
fn input_that_looks_odd_but_is_right_is_taken() {
    let folder = tempfile::tempdir().unwrap();
    let cases: [(&str, &str, &[&str]); 6] = [
        ("crlf.obj", "v 0 0\r\nv 1 0\r\nv 1 1\r\nf 1 2 3\r\n", &[]),
        ("tabs.off", "OFF # header\n\n3\t1\t0\n0 0 0\n1 0 0\n0 1 0\n# a face\n3 0 1 2", &[]),
        ("negative.obj", "v 0 0\nv 1 0\nv 1 1\nf -3 -2 -1\n", &[]),
        ("clockwise.obj", "v 0 0\nv 1 0\nv 1 1\nf 1 3 2\n", &["--orient"]),
        ("down.obj", "v 0 0\nv 1 0\nv 1 1\nf 1 3 2\n", &["--y-down"]),
        ("unused.obj", "v 0 0\nv 9 9\nv 1 0\nv 1 1\nf 1 3 4\n", &[]),
    ];
    for (name, contents, flags) in cases {
        std::fs::write(folder.path().join(name), contents).unwrap();
        let output = dcel(&[&["info", "--json", name], flags].concat(), folder.path());
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{name}: {stderr}");
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let counts = ["vertices", "edges", "faces", "euler"].map(|key| answer[key].as_i64().unwrap());
        assert_eq!(counts, [3, 3, 2, 2], "{name}");
        assert_eq!(answer["valid"], true, "{name}");
        assert_eq!(
            ["unused.obj", "clockwise.obj", "tabs.off"].contains(&name),
            stderr.contains("note: "),
            "{name}: {stderr}"
        );
    }
}
