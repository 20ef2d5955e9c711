//! The looks of figures by the command line: what is refused, and where the fault lies.

use crate::shell::Folder;
use std::path::Path;
use std::process::Command;

const SQUARES: &str = "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nv 8 0 0\nv 8 3 0\nf 1 2 3 4\nf 2 5 6 3\n";

/// Exit code, standard output, standard error.
fn figure(dir: &Path, args: &[&str]) -> (i32, String, String) {
    std::fs::write(dir.join("two.obj"), SQUARES).unwrap();
    let command =
        Command::new(env!("CARGO_BIN_EXE_dcel")).current_dir(dir).args(["figure", "two.obj"]).args(args).output();
    let output = command.unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn faults_in_files_are_told_with_file_line_and_column() {
    let dir = tempfile::tempdir().unwrap();
    for (file, text, option, message) in [
        ("rooms.txt", "f1 \"a\"\n  f7 #fff\n", "--colours", "error: rooms.txt:2:3: there is no f7: there are 3 faces"),
        ("rooms.txt", "f1 blue\n", "--colours", "error: rooms.txt:1:4: `blue` is neither a colour"),
        ("style.json", "{\n \"inc\": \"#000\" }", "--style", "error: style.json:2:6: unknown field `inc`"),
        ("style.json", "{ \"light\": { \"ink\": \"black\" } }", "--style", "error: style.json:1:"),
    ] {
        std::fs::write(dir.path().join(file), text).unwrap();
        let (code, out, err) = figure(dir.path(), &[option, file]);
        assert_eq!((code, out.as_str()), (2, ""), "{err}");
        assert!(err.starts_with(message), "{err}");
    }
    let (code, _, err) = figure(dir.path(), &["--style", "none.json"]);
    assert_eq!(code, 2);
    assert!(err.starts_with("error: none.json: cannot be read"), "{err}");
}

#[test]
fn values_that_cannot_be_are_refused_with_an_example() {
    let dir = tempfile::tempdir().unwrap();
    for (args, message) in [
        (["--width", "12inch"], "for example 800, 120mm or 12cm"),
        (["--width", "9mm"], "choose 100 to 20000 px"),
        (["--crop", "0,0,0,4"], "for example 0,0,6,4"),
        (["--crop", "0,0,4"], "for example 0,0,6,4"),
        (["--faces", "f1,x"], "`x` is not the name of a face"),
        (["--faces", "f1,f3"], "there is no f3: there are 3 faces"),
    ] {
        let (code, out, err) = figure(dir.path(), &args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}: {err}");
        assert!(err.contains(message), "{args:?}: {err}");
    }
}

#[test]
fn the_options_reach_the_drawing() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("rooms.txt"), "f2 #123456 \"hall\"\n").unwrap();
    std::fs::write(dir.path().join("style.json"), r##"{ "light": { "half_edge": "#102030" } }"##).unwrap();
    let draw = |args: &[&str]| {
        let (code, out, err) = figure(dir.path(), args);
        assert_eq!(code, 0, "{args:?}: {err}");
        out
    };
    let svg = draw(&[
        "--faces",
        "f2",
        "--colours",
        "rooms.txt",
        "--style",
        "style.json",
        "--theme",
        "light",
        "--width",
        "12cm",
    ]);
    assert!(svg.contains("width=\"12cm\"") && svg.contains("hall") && svg.contains("#102030"));
    assert!(svg.contains("#two #two-f2 .face{fill:#123456") && !svg.contains("two-f1\"") && !svg.contains("@media"));
    assert!(!draw(&["--plain"]).contains("<style") && draw(&[]).contains("<style"));
    assert!(!draw(&["--crop=-1,-1,3,2"]).contains("id=\"two-v2\"") && draw(&[]).contains("id=\"two-v2\""));
}

/// Every option of looks and drawing changes every kind of figure, or is refused.
#[test]
fn no_option_is_ignored() {
    let folder = Folder::new();
    folder.write("style.json", r##"{ "light": { "ink": "#102030" }, "vertex_radius": 12.5 }"##);
    folder.write("rooms.txt", "f1 #123456 \"hall\"\n");
    let options = [
        "--title Other",
        "--id-prefix p",
        "--max-height 180",
        "--width 900",
        "--width 12cm",
        "--theme light",
        "--theme dark",
        "--style style.json",
        "--colours rooms.txt",
        "--faces f1",
        "--crop 0,0,3,2",
        "--plain",
        "--no-labels",
        "--no-vertex-labels",
        "--no-half-edge-labels",
        "--face-labels off",
        "--detail arrows",
    ];
    for kind in ["", "--pointers next", "--pointers all", "--focus h0", "--tables", "--tables --highlight h0"] {
        let base = folder.dcel(&format!("figure square.obj {kind}")).fine();
        for option in options {
            let told = folder.dcel(&format!("figure square.obj {kind} {option}"));
            // The names of the focus are its subject.
            let has_no_say = kind.starts_with("--focus") && option == "--no-half-edge-labels";
            assert_eq!(told.out == base, has_no_say, "`{kind} {option}`: {}", told.err);
            assert!(told.code == Some(0), "`{kind} {option}`: {}", told.err);
        }
        folder.dcel(&format!("figure square.obj {kind} --faces f9")).fails(2, "there is no f9: there are 3 faces", "");
    }
    let base = folder.dcel("figure --records").fine();
    for option in options {
        let told = folder.dcel(&format!("figure --records {option}"));
        assert!(told.code == Some(2) || told.out != base, "`{option}` is ignored by the records");
    }
    folder.dcel("figure square.obj --focus h5 --faces f1").fails(2, "h5 is not in the drawing", "faces");
    folder.dcel("figure square.obj --tables --highlight h77").fails(2, "h77 is not in the drawing", "number");
}
