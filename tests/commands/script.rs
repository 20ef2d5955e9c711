//! `dcel script`: what is told, what is drawn, and the exit codes.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Runs `dcel script - ARGS` with a script on standard input.
fn script(text: &str, args: &[&str]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_dcel"))
        .args(["script", "-"])
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

fn told(output: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

const REFUSED: &str = "rectangle\nlet a = split_face h2 h4\nsplit_in_half h0.next.prev\n";

#[test]
fn calls_are_told_with_their_ids_and_what_they_returned() {
    let (code, out, err) = told(&script("rectangle\nlet a = split_face h2 h4.next.next # wall\nwalk_face a\n", &[]));
    let expected = "2: let a = split_face h2 h4.next.next\n   split_face h2 h8\n   returned h12, f2\n\
                    3: walk_face a\n   along f2: h12 (v1) h8 (v4) h10 (v5) h0 (v0)\n";
    assert_eq!((code, out.as_str(), err.as_str()), (Some(0), expected, ""));
}

#[test]
fn a_refused_edit_ends_the_script_unless_it_is_to_go_on() {
    let (code, out, err) = told(&script(REFUSED, &[]));
    assert_eq!((code, out.as_str()), (Some(1), "2: let a = split_face h2 h4\n   refused\n"));
    assert!(err.starts_with("refused: <stdin>:2: h4 is next of h2"), "{err}");
    let (code, out, _) = told(&script(REFUSED, &["--keep-going"]));
    assert_eq!(code, Some(1));
    assert!(out.ends_with("3: split_in_half h0.next.prev\n   split_in_half h0\n   returned v6, h12\n"), "{out}");
}

#[test]
fn a_wrong_word_is_an_input_error() {
    let (code, out, err) = told(&script("rectangle\nsplit_fase h2 h8\n", &[]));
    assert_eq!((code, out.as_str()), (Some(2), ""));
    assert!(err.starts_with("error: <stdin>:2:1: unknown statement `split_fase`\nhelp: known: split_face"), "{err}");
    assert_eq!(told(&script("rectangle", &["--film", "film.gif"])).0, Some(2));
}

#[test]
fn the_dump_is_the_structure_and_json_holds_every_write() {
    let (_, out, _) = told(&script("rectangle\njoin_edges h0\n", &["--dump"]));
    assert!(out.contains("dcel 1\nv0 -250 -150 out h0\nv2 250 -150"), "{out}");
    let (code, out, _) = told(&script("rectangle\nsplit_face h2 h8\ndump\n", &["--json"]));
    let answer: serde_json::Value = serde_json::from_str(&out).unwrap();
    let split = &answer["steps"][0];
    assert_eq!((code, split["call"].as_str()), (Some(0), Some("split_face h2 h8")));
    assert_eq!(split["returned"], serde_json::json!(["h12", "f2"]));
    assert_eq!(split["steps"][2]["changes"][0], "h0.next: h2 -> h12");
    assert!(answer["steps"][1]["dump"].as_str().unwrap().starts_with("dcel 1\n"));
}

#[test]
fn films_are_drawings_or_pages() {
    let dir = tempfile::tempdir().unwrap();
    let film = |name: &str, more: &[&str]| {
        let path = dir.path().join(name);
        let args = [&["--film", path.to_str().unwrap()], more].concat();
        assert_eq!(told(&script("rectangle\ncaption A < B\nsplit_face h2 h8\n", &args)).0, Some(0));
        std::fs::read_to_string(path).unwrap()
    };
    let strip = film("strip.svg", &[]);
    assert!(strip.contains("data-figure=\"dcel-strip\"") && strip.contains("A &lt; B") && !strip.contains("<a "));
    let stepper = film("stepper.svg", &["--stepper"]);
    assert!(stepper.contains("data-figure=\"dcel-stepper\"") && stepper.contains("<a href=\"#script-step-1\">"));
    let page = film("page.html", &[]);
    assert!(page.starts_with("<!DOCTYPE html>\n") && page.contains("data-figure=\"dcel-stepper\""));
}

/// The scripts of the help and of the reference figures.
#[test]
fn the_scripts_of_the_project_run() {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/scripts");
    let mut count = 0;
    for entry in std::fs::read_dir(dir).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "dcels") {
            continue;
        }
        let output = Command::new(env!("CARGO_BIN_EXE_dcel")).arg("script").arg(&path).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", path.display());
        count += 1;
    }
    assert!(count >= 5, "{count} scripts");
}

#[test]
fn scripts_without_coordinates_are_played_on_the_kernel() {
    let text = "torus\nlet a = split_vertex h0 h1\njoin_vertices a\nflip_edge h0\n";
    let (code, out, err) = told(&script(text, &["--dump"]));
    let expected = "2: let a = split_vertex h0 h1\n   returned h4, v1\n3: join_vertices a\n   join_vertices h4\n   returned v1\n\
                    4: flip_edge h0\n   refused\n";
    assert!(out.starts_with(expected), "{out}");
    assert_eq!(code, Some(1), "{err}");
    assert!(err.starts_with("refused: <stdin>:4: f0 lies on both sides of h0"), "{err}");
    assert!(out.contains("dcel 1\nv0 out h"), "{out}");
    let (code, out, _) = told(&script("surface 2\nlet a = split_isolated_vertex v1\nsplit_edge a\n", &["--json"]));
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &json["steps"][0]["returned"]), (Some(0), &serde_json::json!(["h0", "f0"])));
    assert_eq!(json["steps"][1]["call"], "split_edge h0");
    let (code, _, err) = told(&script("surface 3 / 0 1\n", &[]));
    assert_eq!(code, Some(2));
    assert!(err.starts_with("error: <stdin>:1:1: face 0 has a cycle with 2 corners"), "{err}");
}

/// A surface in space has three coordinates, which .dcel does not hold.
#[test]
fn scripts_in_space_dump_what_solids_are_read_from() {
    let count = |text: &str, word: &str| text.lines().filter(|line| line.starts_with(word)).count();
    for args in [&[][..], &["--dump"]] {
        let text = if args.is_empty() {
            "solid cube\nbevel_vertex v0 0.25\ndump\n"
        } else {
            "solid cube\nbevel_vertex v0 0.25\n"
        };
        let (code, out, err) = told(&script(text, args));
        assert_eq!((code, err.as_str()), (Some(0), ""), "{out}");
        // A corner became three, and a triangle.
        assert_eq!((count(&out, "v "), count(&out, "f ")), (10, 7), "{out}");
    }
}

#[test]
fn frames_slips_and_ends_of_a_film_are_written_or_nothing_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let text = "rectangle\nsplit_face h2 h8\n";
    let dir = folder.path().join("frames");
    let frames = |more: &[&str]| told(&script(text, &[&["--frames", dir.to_str().unwrap()], more].concat()));
    let (code, out, err) = frames(&["--width", "400"]);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert!(out.contains("returned h12, f2"), "{out}");
    let mut names: Vec<String> =
        std::fs::read_dir(&dir).unwrap().map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    assert_eq!(names, ["01.svg", "02.svg", "03.svg", "04.svg", "05.svg", "06.svg", "07.svg"]);
    for name in &names {
        let svg = std::fs::read_to_string(dir.join(name)).unwrap();
        assert_eq!(svg.matches("<svg").count(), 1);
        assert!(svg.contains("width=\"400\""), "{name}");
        // Of the colours those that the frame needs.
        assert_eq!(svg.contains(".made .pl"), ("03.svg".."07.svg").contains(&name.as_str()), "{name}");
    }
    let (code, out, err) = frames(&[]);
    assert_eq!((code, out.as_str()), (Some(2), ""), "a folder that is there is left alone, and nothing is told");
    assert!(err.contains("is not empty"), "{err}");

    let file = folder.path().join("film.svg");
    let film = |more: &[&str]| {
        let told = told(&script(text, &[&["--film", file.to_str().unwrap()], more].concat()));
        (told.0, told.1, told.2, std::fs::read_to_string(&file).unwrap_or_default())
    };
    let (code, _, err, svg) = film(&["--slip", "h12.next", "--slip", "h13.next = h8"]);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert!(svg.contains("left out: h12.next = h8; h13.next = h8 instead of h2"), "both are said");
    let (code, _, _, svg) = film(&["--ends"]);
    assert_eq!((code, svg.matches("class=\"fr").count()), (Some(0), 2));
    let (code, out, err, after) = film(&["--slip", "h99.next"]);
    assert_eq!((code, out.as_str(), after), (Some(2), "", svg), "what was there stays");
    assert!(err.contains("no edit writes h99.next"), "{err}");
    for wrong in [&["--slip", "h12.twin"][..], &["--slip", "h12.next", "--ends"]] {
        assert_eq!(film(wrong).0, Some(2), "{wrong:?}");
    }
    assert_eq!(told(&script(text, &["--slip", "h12.next"])).0, Some(2), "a slip needs a film");
}

#[test]
fn scripts_of_all_grounds_have_films() {
    let folder = tempfile::tempdir().unwrap();
    for (text, id) in [
        ("rectangle\nsplit_face h2 h8\n", "id=\"script-0-h0\""),
        ("torus\nlet a = split_vertex h0 h1\n", "id=\"script-0-v0-4\""),
        ("surface 2\nlet a = split_isolated_vertex v1\n", "id=\"script-0-v1\""),
        ("surface 0\n", "id=\"script-step-0\""),
        ("solid cube\nbevel_vertex v0 0.25\n", "id=\"script-1-v8\""),
    ] {
        for ending in ["svg", "html"] {
            let file = folder.path().join(format!("film.{ending}"));
            let (code, _, err) = told(&script(text, &["--film", file.to_str().unwrap()]));
            assert_eq!((code, err.as_str()), (Some(0), ""), "{text}");
            assert!(std::fs::read_to_string(&file).unwrap().contains(id), "{text}: {ending}");
        }
    }
}

/// Marks and a caption after the last edit belong to the frame after it.
#[test]
fn the_last_highlight_of_a_film_is_drawn() {
    let folder = crate::shell::Folder::empty();
    let edits = "rectangle\nlet a = split_face h2 h8\ncaption the new face\n";
    let film = |marks: &str| {
        folder.write("marks.dcels", &format!("{edits}{marks}"));
        folder.dcel("script marks.dcels --film marks.svg").fine();
        folder.read("marks.svg")
    };
    // Of the last frame, the seventh, the new face and the new half-edge.
    let hot = |svg: &str| -> Vec<String> {
        let groups =
            svg.split("<g class=\"").skip(1).filter(|group| group.split('"').next().is_some_and(|c| c.contains("hot")));
        groups.filter_map(|group| group.split("id=\"marks-6-").nth(1)?.split('"').next().map(str::to_owned)).collect()
    };
    let (plain, marked) = (film(""), film("highlight a.face a\n"));
    assert!(!hot(&plain).contains(&"f2".to_owned()), "{:?}", hot(&plain));
    assert!(hot(&marked).contains(&"f2".to_owned()) && hot(&marked).contains(&"h12".to_owned()), "{:?}", hot(&marked));
    let last = film("highlight a.face\nhighlight a\n");
    assert!(!hot(&last).contains(&"f2".to_owned()), "the last marks count");
    // A script without any edit, too.
    folder.write("marks.dcels", "rectangle\nhighlight h2\n");
    folder.dcel("script marks.dcels --film marks.svg").fine();
    assert!(folder.read("marks.svg").contains("hot"));
}
