//! Promise: the examples in the help of `dcel lab` and `dcel grade` run as they stand, in a folder with what they name.
//! Those of all other commands run in `tests/commands/samples.rs`.

use crate::shell::Folder;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The commands below `Examples:`, one a line.
fn examples(folder: &Folder, command: &str) -> Vec<String> {
    let help = folder.dcel(&format!("{command} --help")).fine();
    let (_, text) = help.split_once("\nExamples:\n").unwrap_or_else(|| panic!("{command}: no example"));
    text.lines().map(|line| line.trim().to_owned()).filter(|line| !line.is_empty()).collect()
}

/// The commands below one.
#[cfg(unix)]
fn commands(folder: &Folder, above: &str) -> Vec<String> {
    let help = folder.dcel(&format!("{above} --help")).fine();
    let (_, list) = help.split_once("\nCommands:\n").unwrap_or_else(|| panic!("{above}: nothing below it"));
    let lines = list.lines().take_while(|line| line.starts_with("  ")).filter(|line| !line.starts_with("   "));
    let names = lines.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help");
    names.map(|name| format!("{above} {name}")).collect()
}

#[test]
#[cfg(unix)]
fn the_examples_of_lab_and_grade_run() {
    let folder = Folder::empty();
    let in_shell = |line: &str, place: &str| {
        let line = format!("dcel() {{ '{}' \"$@\"; }}; {line}", env!("CARGO_BIN_EXE_dcel"));
        let mut command = Command::new("bash");
        command.args(["-c", &line]).current_dir(folder.path(place));
        // `~` of the examples; cargo and rustup stay where they are.
        let home = std::env::var("HOME").unwrap_or_default();
        let own = |variable: &str, below: &str| std::env::var(variable).unwrap_or_else(|_| format!("{home}/{below}"));
        command.env("CARGO_HOME", own("CARGO_HOME", ".cargo")).env("RUSTUP_HOME", own("RUSTUP_HOME", ".rustup"));
        command.env("HOME", folder.path("."));
        command.output().unwrap()
    };
    folder.dcel("lab start 04 my-lab").fine();
    for place in ["submissions", "labs"] {
        fs::create_dir(folder.path(place)).unwrap();
    }
    let lab = fs::read_to_string(folder.path("my-lab/src/lab.rs")).unwrap();
    folder.write("lab.rs", &lab);
    folder.write("submissions/ada.rs", &lab);
    let packed = fs::File::create(folder.path("submissions.zip")).unwrap();
    let mut packed = zip::ZipWriter::new(packed);
    packed.start_file("ada.rs", zip::write::SimpleFileOptions::default()).unwrap();
    std::io::Write::write_all(&mut packed, lab.as_bytes()).unwrap();
    packed.finish().unwrap();
    folder.write("late.csv", "submission,points,reason\nada,-1,late\n");
    folder.write("course.toml", "title = \"Geometry\"\n\n[[lab]]\nname = \"04\"\n");
    folder.dcel("grade 04 submissions/ada.rs --report json=class.json").fine();
    let mut count = 0;
    // A checkout beside the folder of who makes a lab.
    let kit = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap();
    std::os::unix::fs::symlink(&kit, folder.path("dcel-kit")).unwrap();
    fs::create_dir(folder.path("mine")).unwrap();
    for command in commands(&folder, "lab").iter().map(String::as_str).chain(["lab", "grade", "gradebook"]) {
        for example in examples(&folder, command) {
            // These take minutes, the network, or never end: that they are understood must do.
            let long = ["lab watch", "lab verify", "--vendor"].iter().any(|part| example.contains(part));
            let made = ["lab start 04 my-lab", "--student lab04/"].iter().any(|part| example.contains(part));
            if made {
                let _ = fs::remove_dir_all(folder.path("my-lab"));
            }
            // Without the name of a folder it is the one that one is in.
            let inside =
                ["check", "hint", "idea", "reset"].iter().any(|name| example.starts_with(&format!("dcel lab {name}")));
            let place = match () {
                () if inside && !example.contains("my-lab") => "my-lab",
                () if example.starts_with("dcel lab new") => "mine",
                () => ".",
            };
            let line = if long { format!("{example} --help") } else { example.clone() };
            let output = in_shell(&line, place);
            // Of a lab that nobody has begun nothing passes yet.
            let asks = ["check", "idea"].iter().any(|name| example.starts_with(&format!("dcel lab {name}")));
            let expected = i32::from(!long && asks);
            let error = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(expected), "{example}: {error}");
            if example.contains("--json") {
                assert!(serde_json::from_slice::<serde_json::Value>(&output.stdout).is_ok(), "{example}");
            }
            if made {
                let _ = folder.dcel("lab start 04 my-lab");
            }
            count += 1;
        }
    }
    for made in ["mine/12-mine/lab.toml", "mine/labs/12-mine/lab.toml"] {
        assert!(folder.path(made).is_file(), "{made}");
    }
    assert!(count >= 29, "only {count} examples were found");
}
