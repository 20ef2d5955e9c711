//! The looks of figures by the command line: what is refused, and where the fault lies.

use crate::shell::Folder;
use crate::shell::watched::Watched;
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
        (
            ["-o", "page.html"],
            "page.html: a figure is no page\nhelp: end the name in .svg; dcel figure writes pages with --html",
        ),
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

/// The same words for every command that draws.
#[test]
fn every_command_that_draws_takes_a_page() {
    let folder = Folder::new();
    for sample in ["square.obj", "square.dcel", "sites.xy", "roads.wkt", "cube.off", "rooms.map", "house.obj"] {
        assert_eq!(folder.dcel(&format!("sample {sample}")).code, Some(0), "{sample}");
    }
    for sample in ["parcels.geojson", "floods.geojson"] {
        assert_eq!(folder.dcel(&format!("sample {sample}")).code, Some(0), "{sample}");
    }
    folder.write("lab.dcels", "rectangle\nsplit_in_half h0\n");
    folder.write("style.json", r##"{ "dark": { "ink": "#fedcba" } }"##);
    for command in [
        "figure square.obj -o",
        "build roads.wkt --mend --figure",
        "triangulate square.dcel --figure",
        "delaunay sites.xy --figure",
        "voronoi sites.xy --figure",
        "overlay parcels.geojson floods.geojson -o",
        "locate square.obj 1 1 -o",
        "script lab.dcels --film",
        "film hull sites.xy -o",
        "solid figure cube.off -o",
        "solid schlegel cube.off --figure",
        "navmesh path rooms.map 1 1 22 12 -o",
        "navmesh path house.obj --up z 1 1 0 1 1 3 -o",
        "navmesh info rooms.map -o",
        "navmesh distances rooms.map 1 1 -o",
    ] {
        // The page reaches the picture: its width in its unit, its colours, its lack of a style sheet.
        let looks = "--width 12cm --theme dark --plain --style style.json";
        let told = folder.dcel(&format!("{command} out.svg {looks}"));
        assert_eq!(told.code, Some(0), "{command}: {told:?}");
        let svg = folder.read("out.svg");
        let head = &svg[..svg.find('>').unwrap()];
        assert!(head.contains("cm\"") && !svg.contains("<style"), "{command}: {head}");
        assert!(svg.contains("#fedcba"), "{command}: the ink of the style file");
        std::fs::remove_file(folder.path("out.svg")).unwrap();
        // TeX knows the same colours.
        let told = folder.dcel(&format!("{command} out.tikz --theme dark --style style.json"));
        assert_eq!(told.code, Some(0), "{command}: {told:?}");
        let tikz = folder.read("out.tikz");
        assert!(tikz.contains("\\begin{tikzpicture}") && tikz.contains("{HTML}{FEDCBA}"), "{command}");
        std::fs::remove_file(folder.path("out.tikz")).unwrap();
        // The style file is an input: it is never written over.
        let told = folder.dcel(&format!("{command} style.json --style style.json"));
        told.fails(2, "style.json", "");
        assert!(folder.read("style.json").contains("fedcba"), "{command}");
    }
    // Without a figure there is nothing to look at.
    for command in
        ["delaunay sites.xy", "locate square.obj 1 1", "navmesh info rooms.map", "overlay square.obj square.obj"]
    {
        folder.dcel(&format!("{command} --theme dark")).fails(
            2,
            "--theme is about a figure, and none is drawn",
            "OUT.svg",
        );
        folder.dcel(&format!("{command} --crop 0,0,1,1")).fails(2, "--crop is about a figure", "OUT.svg");
    }
}

#[test]
fn columns_and_parts_are_chosen() {
    let folder = Folder::new();
    folder.dcel("sample sites.xy");
    let size = |columns: &str| {
        let told = folder.dcel(&format!("film hull sites.xy -o out.svg {columns}"));
        assert_eq!(told.code, Some(0), "{told:?}");
        let svg = folder.read("out.svg");
        let size = svg[svg.find("viewBox=\"0 0 ").unwrap() + 13..].split('"').next().unwrap().to_owned();
        let numbers: Vec<f64> = size.split(' ').map(|x| x.parse().unwrap()).collect();
        (numbers[0], numbers[1])
    };
    let [(w1, h1), (w2, h2), (w3, _)] = ["--columns 1", "", "--columns 3"].map(size);
    assert!(w1 < 420.0 && h1 > 1.8 * h2, "one column is narrow and high: {w1} {h1}, two: {w2} {h2}");
    assert!((800.0..=830.0).contains(&w2) && w3 > 1.4 * w2, "two fit a page, three are wider: {w2} {w3}");
    folder.dcel("film hull sites.xy -o out.svg --columns 0").fails(2, "0 is not in 1..=100", "");
    // A part of the plane: what lies outside is not drawn.
    folder.dcel("delaunay sites.xy --figure whole.svg");
    folder.dcel("delaunay sites.xy --figure part.svg --crop 0,0,1,1");
    assert!(folder.read("part.svg").len() < folder.read("whole.svg").len());
}

#[test]
fn a_watched_figure_is_drawn_again_when_a_file_is_saved_and_stays_when_it_is_broken() {
    let shell = Folder::new();
    shell.write("two.obj", SQUARES);
    shell.write("rooms.txt", "f1 \"hall\"\n");
    std::fs::create_dir(shell.path("out")).unwrap();
    let picture = || std::fs::read_to_string(shell.path("out/two.svg")).unwrap();
    let watched = Watched::start(&shell, "figure two.obj --colours rooms.txt --watch -o out/two.svg");
    assert!(watched.says("drawn: out/two.svg", 60));
    assert!(picture().contains(">hall<"));
    assert!(watched.is_silent("drawn", 1), "nothing was saved, yet it was drawn again");
    // As many editors do it: a new file takes the place of the old one.
    shell.write("rooms.new", "f1 \"kitchen\"\n");
    std::fs::rename(shell.path("rooms.new"), shell.path("rooms.txt")).unwrap();
    assert!(watched.says("drawn: out/two.svg", 60));
    assert!(picture().contains(">kitchen<"));
    let last = picture();
    shell.write("two.obj", "v 0 0 0\nf 1 2 3\n");
    assert!(watched.says("error: two.obj:2:", 60));
    assert_eq!(picture(), last);
    shell.write("two.obj", SQUARES.rsplit_once("f 2").unwrap().0);
    assert!(watched.says("drawn: out/two.svg", 60));
    assert!(!picture().contains("f2"), "one square is left");
}

#[test]
fn watching_needs_a_file_to_read_and_one_to_write() {
    let dir = tempfile::tempdir().unwrap();
    let (code, _, err) = figure(dir.path(), &["--watch"]);
    assert_eq!(code, 2);
    assert!(err.contains("no file to draw into") && err.contains("-o OUT.svg"), "{err}");
    let shell = Folder::new();
    shell.dcel("figure - --watch -o two.svg").fails(2, "standard input cannot be watched", "name of a file");
    shell.dcel("figure none.obj --watch -o two.svg").fails(2, "none.obj", "");
}

#[test]
fn a_film_of_what_an_algorithm_refuses_shows_it_and_the_call_fails() {
    let shell = Folder::new();
    shell.dcel("sample --all .").fine();
    for (arguments, error, marked) in [
        ("climb house.obj --direction 0,0,1", "house.obj: the surface has a border at f5", "border at f5"),
        ("funnel rooms.map --from 1,1 --to 300,12", "the goal (300, 12) is not on the mesh", "nearest place"),
    ] {
        shell.dcel(&format!("film {arguments} -o out.svg")).fails(2, error, "");
        let svg = shell.read("out.svg");
        assert!(svg.contains(">Refused<") && svg.contains("r-wrong") && svg.contains(marked), "{arguments}: {svg}");
        std::fs::remove_file(shell.path("out.svg")).unwrap();
    }
    // What is wrong with the call or the file is no refusal of the algorithm.
    shell.dcel("film walk square.obj --face f99 -o out.svg").fails(2, "there is no f99", "");
    assert!(!shell.path("out.svg").exists());
}
