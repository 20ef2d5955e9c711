//! Promise: `dcel sample` writes files on which the example of every help text runs as it stands.

use crate::shell::Folder;
use std::fs;
use std::process::Command;

/// What is run elsewhere: labs are built by cargo, in `tests/labs`; the figures are drawn by the tests of figures.
const ELSEWHERE: [&str; 5] = ["lab", "grade", "gradebook", "tour", "figures"];

/// All commands, those below others too: `info`, `navmesh path`, ...
pub(crate) fn commands(folder: &Folder, above: &str) -> Vec<String> {
    let help = folder.dcel(&format!("{above} --help")).fine();
    let Some((_, list)) = help.split_once("\nCommands:\n") else { return vec![above.to_owned()] };
    let list = list.lines().take_while(|line| line.starts_with("  "));
    let names = list.filter(|line| !line.starts_with("   ")).filter_map(|line| line.split_whitespace().next());
    let mut all = vec![above.to_owned()];
    for name in names.filter(|name| *name != "help") {
        all.extend(commands(folder, format!("{above} {name}").trim()));
    }
    all
}

/// The commands below `Examples:`, each as it is typed in a shell.
fn examples(help: &str) -> Vec<String> {
    let Some((_, text)) = help.split_once("\nExamples:\n") else { return Vec::new() };
    let mut all: Vec<String> = Vec::new();
    let mut open = false;
    for line in text.lines().map(|line| line.strip_prefix("  ").unwrap_or(line)).filter(|line| !line.is_empty()) {
        match all.last_mut().filter(|last| open || last.ends_with('\\')) {
            Some(last) => {
                last.push('\n');
                last.push_str(line);
            }
            None => all.push(line.to_owned()),
        }
        open = all.last().is_some_and(|last| last.matches('\'').count() % 2 == 1);
    }
    all
}

#[test]
#[cfg(unix)]
fn the_examples_of_every_help_text_run_on_the_samples() {
    let folder = Folder::new();
    let mut count = 0;
    for command in commands(&folder, "") {
        if ELSEWHERE.contains(&command.split(' ').next().unwrap_or_default()) {
            continue;
        }
        let help = folder.dcel(&format!("{command} --help")).fine();
        let examples = examples(&help);
        assert!(!examples.is_empty(), "{command}: no example");
        let place = Folder::empty();
        place.dcel("sample --all .").fine();
        for example in examples {
            let line = format!("dcel() {{ '{}' \"$@\"; }}; {example}", env!("CARGO_BIN_EXE_dcel"));
            let output = Command::new("bash").args(["-c", &line]).current_dir(place.path(".")).output().expect("bash");
            let expected = match () {
                () if example.contains("broken") || example.contains("mine.svg") => 1,
                () if example.contains(".png") && cfg!(not(feature = "png")) => 2,
                () => 0,
            };
            let error = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(expected), "{example}: {error}");
            count += 1;
        }
    }
    assert!(count >= 60, "only {count} examples were found");
}

#[test]
fn samples_are_listed_and_written_and_nothing_is_written_over() {
    let folder = Folder::empty();
    let list = folder.dcel("sample").fine();
    let samples = folder.dcel("sample --json").json();
    let names: Vec<&str> = samples.as_array().expect("a list").iter().filter_map(|s| s["name"].as_str()).collect();
    assert!(names.len() >= 20 && names.iter().all(|name| list.contains(&format!("  {name} "))), "{list}");
    folder.dcel("sample --all new/samples").fine();
    assert_eq!(fs::read_dir(folder.path("new/samples")).expect("the folder").count(), names.len());
    folder.dcel("sample square.obj cube.off").fine();
    assert_eq!(folder.read("cube.off"), folder.dcel("sample cube.off -o -").fine());
    // Again is no harm; something else of that name is.
    folder.dcel("sample square").fine();
    folder.write("cube.off", "mine");
    folder.dcel("sample square.dcel cube.off").fails(
        2,
        "cube.off: is there already, and holds something else",
        "--all",
    );
    folder.dcel("sample tetrahedron.off -o cube.off").fails(2, "cube.off: is there already", "");
    assert_eq!((folder.read("cube.off").as_str(), folder.path("square.dcel").exists()), ("mine", false));
    folder.dcel("sample sqare.obj").fails(2, "there is no sample `sqare.obj`", "did you mean square.obj?");
    folder.dcel("sample square.obj cube.off -o both").fails(
        2,
        "-o names one file, and these are 2 samples",
        "one by one",
    );
    folder.dcel("sample -o x").fails(2, "required", "");
}

#[test]
fn samples_are_what_they_are_said_to_be() {
    let folder = Folder::empty();
    folder.dcel("sample --all .").fine();
    // The structure is that of the drawing, and that of the polygons.
    folder.dcel("convert square.obj again.dcel").fine();
    assert_eq!(folder.read("square.dcel"), folder.read("again.dcel"));
    assert_eq!(folder.dcel("compare square.dcel square.obj --ids").code, Some(0));
    folder.dcel("figure square.obj --detail edges -o drawn.svg").fine();
    assert_eq!(folder.dcel("compare drawn.svg expected.svg").code, Some(0));
    let told = folder.dcel("compare expected.svg mine.svg");
    assert!(told.code == Some(1) && told.out.contains("1 difference") && told.out.contains("is missing"), "{told:?}");
    assert_eq!(folder.dcel("validate broken.dcel").code, Some(1));
    folder.dcel("info fields.geojson").fails(2, "cross at", "--mend");
    folder.dcel("build roads.wkt").fails(2, "cross", "--mend");
    assert_eq!(folder.dcel("build plan.poly --json").json()["hole_faces"], serde_json::json!(["f2"]));
    assert_eq!(folder.dcel("navmesh info floor.obj --up y --json").code, Some(0));
    for solid in ["cube.off", "tetrahedron.off"] {
        let info = folder.dcel(&format!("solid info {solid} --json")).json();
        assert_eq!((&info["convex"], &info["closed"]), (&true.into(), &true.into()), "{solid}");
        assert!(info["volume"].as_f64().is_some_and(|volume| volume > 0.0), "{solid}: {info}");
    }
    // A line that is cut off in a sample would be told.
    for name in ["square.obj", "square.dcel", "plan.poly", "rings.segments", "cube.off", "sites.xy", "rooms.map"] {
        assert!(folder.read(name).ends_with('\n'), "{name}");
    }
}
