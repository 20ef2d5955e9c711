//! Promise: with `--json` every error is one JSON value on standard output, of the shape that `dcel --help` tells.

use crate::shell::{Folder, Told};
use serde_json::{Value, json};

#[track_caller]
fn error(told: &Told) -> Value {
    let answer: Value = serde_json::from_str(&told.out).unwrap_or_else(|why| panic!("{why}: {told:?}"));
    let error = answer["error"].clone();
    let keys: Vec<&String> = error.as_object().unwrap_or_else(|| panic!("{told:?}")).keys().collect();
    assert_eq!(keys, ["exit_code", "help", "kind", "message", "notes", "place"]);
    assert_eq!(error["exit_code"], json!(told.code));
    // People read the same on standard error.
    assert!(told.err.contains("error: "), "{told:?}");
    error
}

#[test]
fn errors_are_json_with_their_place() {
    let folder = Folder::new();
    folder.write("bad.obj", "v 0 0\nv 1 x\n");
    folder.write("twice.obj", "v 0 0\nv 1 0\nv 0 1\nv 1 1\nf 1 2 3\nf 1 2 4\n");
    folder.write(
        "flood.json",
        &crate::shell::GARDEN.replace("[[20,0],[21,2],[22,0],[20,0]]", "[[5,5],[16,6],[16,5],[5,5]]"),
    );
    folder.dcel("convert square.obj pair.node").fine();
    std::fs::write(folder.path("pair.ele"), "1 3 0\n1 1 2 9\n").expect("a file");
    folder.write("style.json", "{\"fill\": 3,}\n");
    for (call, kind, message, place) in [
        ("info none.obj --json", "input", "cannot be read: ", json!(["none.obj", null, null])),
        ("info bad.obj --json", "input", "`x` is not a number", json!(["bad.obj", 2, 5])),
        ("validate bad.obj --json", "input", "`x` is not a number", json!(["bad.obj", 2, 5])),
        ("info twice.obj --json", "input", "face 0 and face 1 overlap", json!(["twice.obj", 5, null])),
        ("info flood.json --json", "input", "G3: features[0] \"Garden\"", json!(["flood.json", 3, 6])),
        ("triangulate pair.node --json", "input", "point 9 does not exist", json!(["pair.ele", 2, 7])),
        (
            "walk square.obj --face f9 --json",
            "input",
            "there is no f9: there are 3 faces",
            json!(["square.obj", null, null]),
        ),
        (
            "delaunay square.obj --figure no/x.svg --json",
            "machine",
            "cannot be written: ",
            json!(["no/x.svg", null, null]),
        ),
        ("locate square.obj 1 --json", "input", "", Value::Null),
        ("overlay square.obj square.obj --grid 0 --json", "input", "", Value::Null),
        ("info --json", "usage", "the following required arguments", Value::Null),
        ("info square.obj --jsn --json", "usage", "unexpected argument '--jsn'", Value::Null),
        ("inof --json", "usage", "unrecognized subcommand 'inof'", Value::Null),
        ("lab list 99 --json", "input", "there is no lab `99`", Value::Null),
        ("lab check nowhere --json", "input", "no lab is there", json!(["nowhere", null, null])),
        ("navmesh info none.map --json", "input", "cannot be read", json!(["none.map", null, null])),
        ("solid info none.off --json", "input", "cannot be read", json!(["none.off", null, null])),
        ("script none.dcels --json", "input", "cannot be read", json!(["none.dcels", null, null])),
        ("compare none.svg none.svg --json", "input", "cannot be read", json!(["none.svg", null, null])),
    ] {
        let told = folder.dcel(call);
        let found = error(&told);
        assert_eq!(found["kind"], kind, "{call}: {told:?}");
        assert!(found["message"].as_str().is_some_and(|text| text.starts_with(message)), "{call}: {told:?}");
        if !place.is_null() {
            let at = &found["place"];
            assert_eq!(json!([at["file"], at["line"], at["column"]]), place, "{call}: {told:?}");
        }
    }
    let told = folder.dcel_with("v 0 0\nv 1 x\n", "info - --json");
    assert_eq!(error(&told)["place"], json!({"file": "<stdin>", "line": 2, "column": 5}));
    assert_eq!(error(&told)["help"], "write a number such as 1.5, with a decimal point");
    // Without the flag nothing is said on standard output.
    folder.dcel("info none.obj").fails(2, "none.obj: cannot be read", "");
    // An answer is one value as before.
    assert_eq!(folder.dcel("info square.obj --json").json()["edges"], 5);
    assert_eq!(folder.dcel("lab list --json").json()[0]["name"], "01-predicates");
    let lab = folder.dcel("lab list 04 --json").json();
    assert_eq!((&lab["points"], lab["tasks"].as_array().map(Vec::len)), (&json!(100), Some(8)));
    assert!(lab["tasks"][0]["tests"][0]["points"].as_u64().is_some_and(|points| points > 0), "{lab}");
    let told = folder.dcel("--help").fine();
    for word in ["--json", "kind", "message", "place", "notes", "help", "exit_code", "usage, input or machine"] {
        assert!(told.contains(word), "{word} is not in the help");
    }
}

#[test]
fn standard_output_that_fails_is_told_on_standard_error_alone() {
    if cfg!(target_os = "linux") {
        let folder = Folder::new();
        let full = std::fs::File::options().write(true).open("/dev/full").expect("/dev/full");
        let output = folder.command("info square.obj --json").stdout(full).output().expect("the command starts");
        assert_eq!(output.status.code(), Some(3));
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(error.starts_with("error: <stdout>: cannot be written"), "{error}");
    }
}

#[test]
fn numbers_below_zero_are_numbers_and_helps_can_be_followed() {
    let folder = Folder::new();
    folder.write("cross.segments", "0 0 4 4\n0 4 4 0\n");
    folder.dcel("build cross.segments --mend --grid -1").fails(2, "-1", "");
    let told = folder.dcel("build cross.segments --mend --grid -1");
    assert!(!told.err.contains("unexpected argument") && !told.err.contains("-- -1"), "{told:?}");
    folder.write("sites.xy", "0 0\n4 0\n0 4\n4 0\n");
    folder.dcel("info sites.xy").fails(2, "the format is not known", "help: points alone have no faces: dcel delaunay");
    folder.dcel("voronoi sites.xy --box 0 0 1 1").fails(
        2,
        "does not lie inside the window",
        "help: give a larger --box",
    );
    assert!(folder.dcel("voronoi sites.xy").err.contains("note: points that repeat earlier ones, 1: 3 = 1"));
    folder.write("plan.segments", "0 0 4 0\n4 0 0 4\n0 4 0 0\n");
    folder.dcel("build plan.segments --hole 99,99").fails(2, "lies in the outer face", "help: a point of a hole lies");
    folder.dcel("compare none.svg mine.svg").fails(2, "none.svg: cannot be read", "help: check the name");
}
