//! The manners of the command: exit codes, help, pipes, bad files, standard input.

use crate::samples::commands;
use crate::shell::{CUBE, Folder, GARDEN, SQUARE, TRIANGLE, grid};
use std::process::Stdio;

const COMMANDS: [&str; 16] = [
    "info",
    "validate",
    "walk",
    "compare",
    "convert",
    "build",
    "locate",
    "overlay",
    "triangulate",
    "delaunay",
    "voronoi",
    "figure",
    "play",
    "sample",
    "completions",
    "man",
];

#[test]
fn wrong_calls_and_bad_files_give_2() {
    let folder = Folder::new();
    folder.write("empty.obj", "");
    folder.write("notes.md", "hello\n");
    std::fs::create_dir(folder.path("box.obj")).expect("a folder");
    std::fs::write(folder.path("raw.obj"), [0xff, 0xfe, 0x00, 0x80]).expect("a file");
    for (call, error, help) in [
        ("info missing.obj", "missing.obj: cannot be read", "check the name"),
        ("info box.obj", "box.obj: cannot be read: it is a directory", "give a file in it"),
        ("info empty.obj", "empty.obj: the file is empty", ""),
        ("info notes.md", "notes.md: the format is not known", "obj, off, ply"),
        ("info raw.obj", "raw.obj", "UTF-8"),
        ("info square.obj --format step", "`step` is not a format", ""),
        ("info square.obj --format tables", "tables is written, not read", ".dcel"),
        ("info square.obj --format off", "square.obj:1:1", ""),
        ("info square.obj --plane --surface", "cannot be used with", ""),
        ("info garden.json --object x --y-up", "unexpected argument '--y-up'", ""),
        ("info", "required", "Usage"),
        ("inof square.obj", "unrecognized subcommand 'inof'", "info"),
        ("completions csh", "invalid value 'csh'", "bash"),
    ] {
        folder.dcel(call).fails(2, error, help);
    }
    // Without any argument the help is the answer to a call that lacks something.
    let told = folder.dcel("");
    assert_eq!((told.code, told.out.as_str()), (Some(2), ""));
    assert!(told.err.contains("Usage: dcel <COMMAND>"), "{}", told.err);
}

#[test]
fn misfits_name_lines_and_options() {
    let folder = Folder::new();
    folder.write("clockwise.obj", &SQUARE.replace("f 1 2 3", "f 3 2 1").replace("f 1 3 4", "f 4 3 1"));
    folder.dcel("info clockwise.obj").fails(2, "clockwise.obj:5: face 0 runs clockwise, as all faces do", "--orient");
    let told = folder.dcel("info clockwise.obj --orient");
    assert!(told.err.contains("note: 2 of 2 faces ran clockwise and were turned round"), "{}", told.err);
    folder.dcel("info clockwise.obj --y-down").fine();
    folder.write("mixed.obj", &SQUARE.replace("f 1 3 4", "f 4 3 1"));
    folder.dcel("info mixed.obj").fails(
        2,
        "mixed.obj:5: faces 0 and 1 both run from",
        "counted from 0; face 1: line 6",
    );
    folder.write("flat.obj", "v 0 0\nv 1 0\nv 2 0\nv 0 1\nf 1 2 4\nf 1 3 2\n");
    folder.dcel("info flat.obj").fails(2, "flat.obj:6: face 1 has no area", "remove it");
    folder.write("huge.obj", &SQUARE.replace("v 4 3", "v 4 1e300"));
    folder.dcel("info huge.obj").fails(2, "huge.obj:3", "scale the input");
    folder.write("tiny.obj", &SQUARE.replace("v 4 3", "v 4 1e-300"));
    folder.dcel("info tiny.obj").fails(2, "tiny.obj:3", "make it 0, or scale the input");
    let garden = GARDEN.replace("[[20,0],[21,2],[22,0],[20,0]]", "[[20,0],[21,0],[20,0]]");
    folder.write("thin.json", &garden);
    folder.dcel("info thin.json").fails(2, "\"Shed\"", "--drop-degenerate-rings");
    let told = folder.dcel("info thin.json --drop-degenerate-rings");
    assert!(told.err.contains("dropped") && told.code == Some(0), "{told:?}");
    folder.write("shed.json", &GARDEN.replace("[[20,0],[21,2],[22,0],[20,0]]", "[[5,5],[6,6],[6,5],[5,5]]"));
    folder.dcel("info shed.json").fails(2, "\"Garden\"", "");
    folder
        .write("spare.obj", &format!("v 9 9\n{}", SQUARE.replace("f 1 2 3", "f 2 3 4").replace("f 1 3 4", "f 2 4 5")));
    assert!(folder.dcel("info spare.obj").err.contains("v0 was left out: no face uses it"));
}

#[test]
fn a_machine_that_refuses_gives_3() {
    let folder = Folder::new();
    folder.dcel("convert square.obj no/where.off").fails(3, "no/where.off: cannot be written", "directory first");
    std::fs::create_dir(folder.path("box.off")).expect("a folder");
    folder.dcel("convert square.obj box.off").fails(3, "box.off: cannot be written", "");
    if cfg!(target_os = "linux") {
        for command in ["info square.obj", "--help", "info --help", "help navmesh", "--version"] {
            let full = std::fs::File::options().write(true).open("/dev/full").expect("/dev/full");
            let output = folder.command(command).stdout(full).output().expect("the command starts");
            assert_eq!(output.status.code(), Some(3), "{command}");
            let error = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(error.starts_with("error: <stdout>: cannot be written"), "{command}: {error}");
        }
    }
}

/// A pipe that nobody reads.
fn closed_pipe() -> Stdio {
    let (_, writer) = std::io::pipe().expect("a pipe");
    writer.into()
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let folder = Folder::new();
    folder.write("grid.obj", &grid(40));
    for call in [
        "info square.obj",
        "info square.obj --json",
        "validate --rules",
        "walk grid.obj --face f0 --json",
        "walk grid.obj --face f0",
        "convert grid.obj - --to dcel",
        "figure grid.obj",
        "completions zsh",
        "help walk",
    ] {
        let output = folder.command(call).stdout(closed_pipe()).output().expect("the command starts");
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!((output.status.code(), error.as_str()), (Some(0), ""), "{call}");
    }
}

#[test]
fn nobody_has_to_listen_to_the_talk() {
    let folder = Folder::new();
    let output = folder.command("info missing.obj").stderr(closed_pipe()).output().expect("the command starts");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn standard_input_and_line_ends() {
    let folder = Folder::new();
    for text in [SQUARE.to_owned(), SQUARE.replace('\n', "\r\n"), format!("\u{feff}{SQUARE}")] {
        let info = folder.dcel_with(&text, "info - --json").json();
        assert_eq!((&info["source"], &info["edges"]), (&"<stdin>".into(), &5.into()), "{text:?}");
    }
    assert_eq!(folder.dcel_with(TRIANGLE, "validate -").fine(), "<stdin>: valid\n");
    assert_eq!(folder.dcel_with(GARDEN, "info - --json").json()["faces"], 4);
    folder.dcel_with("v 0 0\nv 1 x\n", "info -").fails(2, "<stdin>:2:5: `x` is not a number", "");
    folder.dcel_with("", "info -").fails(2, "<stdin>: the file is empty", "");
    folder.dcel_with("hello\n", "info -").fails(2, "<stdin>: the format is not known", "say it");
    assert_eq!(folder.dcel_with(SQUARE, "info - --format obj").code, Some(0));
}

/// Not `-`: the title is what a reader of the page sees and hears.
#[test]
fn figures_of_standard_input_have_a_title() {
    let folder = Folder::new();
    folder.write("tiles.obj", "v 3 1\nv 8 1\nv 12.5 8\nv 3 6\nf 1 2 3 4\n");
    for (input, call, title) in [
        (SQUARE, "figure -", "Half-edge structure"),
        (SQUARE, "triangulate - --figure", "Triangles"),
        (SQUARE, "delaunay - --figure", "Delaunay"),
        (SQUARE, "locate - 1 1 -o", "Points in standard input"),
        (SQUARE, "overlay - tiles.obj -o", "Overlay of standard input and tiles"),
        (SQUARE, "overlay tiles.obj - --operation xor -o", "xor of tiles and standard input"),
        (SQUARE, "navmesh path - 1 1 1 1 -o", "A way through the map"),
        (CUBE, "solid figure -", "Solid"),
    ] {
        let call = if call.ends_with('-') { call.to_owned() } else { format!("{call} drawn.svg") };
        let out = folder.dcel_with(input, &call).fine();
        let svg = if out.contains("<svg") { out } else { folder.read("drawn.svg") };
        assert!(svg.contains(&format!(">{title}</title>")), "{call}: {}", &svg[..svg.len().min(400)]);
    }
}

#[test]
fn every_option_is_in_the_help_and_explained() {
    let folder = Folder::new();
    assert_eq!(folder.dcel("help --help").fine(), folder.dcel("--help").fine());
    for command in COMMANDS {
        let options = folder.completed(command, "--");
        assert!(options.contains(&"--help".to_owned()), "{command}: {options:?}");
        let help = folder.dcel(&format!("{command} --help")).fine();
        assert_eq!(folder.dcel(&format!("help {command}")).fine(), help);
        let lines: Vec<&str> = help.lines().map(str::trim).collect();
        for option in &options {
            let explained = lines
                .iter()
                .position(|line| line.split([' ', ',']).any(|word| word == option) && line.starts_with('-'));
            let at = explained.unwrap_or_else(|| panic!("{command}: {option} is not in the help"));
            assert!(lines.get(at + 1).is_some_and(|line| line.len() > 4) || lines[at].contains("  "), "{option}");
        }
        assert!(help.contains("\nExamples:\n"), "{command} has no example");
    }
    assert_eq!(folder.dcel("--version").fine(), format!("dcel {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn the_help_fits_60_columns_and_is_plain_in_a_pipe() {
    let folder = Folder::new();
    for command in COMMANDS.into_iter().chain(["", "tour", "figures"]) {
        let call = format!("{command} --help");
        for variable in ["NO_COLOR", "OTHER"] {
            let mut narrow = folder.command(&call);
            let output = narrow.env("COLUMNS", "60").env(variable, "1").output().expect("the command starts");
            let text = String::from_utf8(output.stdout).expect("UTF-8");
            let long: Vec<&str> = text.lines().filter(|line| line.chars().count() > 60).collect();
            assert!(long.is_empty() && text.len() > 200, "{command}: {long:?}");
            assert!(!text.contains('\u{1b}'), "{command}: colours in a pipe");
        }
    }
}

/// A line that was ended by hand is seen at the next width: the first word after it had room.
#[test]
fn paragraphs_of_the_help_fill_the_terminal() {
    let folder = Folder::new();
    for command in commands(&folder, "") {
        for width in [60, 100] {
            let mut asked = folder.command(&format!("{command} --help"));
            let output = asked.env("COLUMNS", width.to_string()).output().expect("the command starts");
            let text = String::from_utf8(output.stdout).expect("UTF-8");
            let lines: Vec<&str> = text.lines().collect();
            assert!(lines.len() > 5, "dcel {command} --help: {text}");
            for pair in lines.windows(2) {
                let is_paragraph = pair.iter().all(|line| !line.is_empty() && !line.starts_with(' '));
                let word = pair[1].split(' ').next().unwrap_or_default();
                let had_room = pair[0].chars().count() + 1 + word.chars().count() <= width;
                assert!(!is_paragraph || !had_room, "dcel {command} --help, {width} columns: {pair:#?}");
            }
        }
    }
}
