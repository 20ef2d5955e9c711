//! What a shell gets: completions with names of files by their ends, and manual pages.

use crate::shell::Folder;
use std::collections::BTreeSet;

impl Folder {
    /// What may follow, asked as fish does: the words before the cursor, then the one at it.
    pub(crate) fn completed(&self, words: &str, current: &str) -> Vec<String> {
        let mut command = self.command("");
        command.env("DCEL_COMPLETE", "fish").args(["--", "dcel"]).args(words.split_whitespace()).arg(current);
        let output = command.output().expect("the command starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        text.lines().map(|line| line.split('\t').next().unwrap_or_default().to_owned()).collect()
    }
}

fn folder() -> Folder {
    let folder = Folder::new();
    for name in ["notes.md", "room.map", "room.scen", "split.dcels", "old.svg", "old.html", "old.png"] {
        folder.write(name, "");
    }
    std::fs::create_dir(folder.path("maps")).expect("a folder");
    folder
}

#[test]
fn files_are_completed_by_their_ends() {
    let folder = folder();
    let all = ["cube.off", "garden.json", "room.map", "square.obj", "triangle.dcel", "maps/", "-"];
    let wanted = |words: &str, current: &str| -> BTreeSet<String> {
        folder.completed(words, current).into_iter().filter(|word| !word.starts_with("--")).collect()
    };
    let expected = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<BTreeSet<_>>();
    let info = wanted("info", "");
    assert!(info.is_superset(&expected(&all)), "{info:?}");
    for name in ["notes.md", "room.scen", "split.dcels", "old.svg"] {
        assert!(!info.contains(name), "{name} is offered to `dcel info`");
    }
    assert_eq!(wanted("info", "sq"), expected(&["square.obj"]));
    assert_eq!(wanted("script", "s"), expected(&["split.dcels"]));
    assert_eq!(wanted("navmesh scenario room.map", "r"), expected(&["room.scen"]));
    assert_eq!(wanted("compare", "o"), expected(&["old.svg"]));
    assert_eq!(wanted("locate square.obj -o", "o"), expected(&["old.png", "old.svg"]));
    assert_eq!(wanted("figure square.obj --html", "o"), expected(&["old.html"]));
    assert_eq!(wanted("sample --all", ""), expected(&[".", "maps/"]));
}

#[test]
fn commands_options_and_values_are_completed() {
    let folder = folder();
    assert_eq!(folder.completed("", "tri"), ["triangulate"]);
    assert_eq!(folder.completed("navmesh", "sc"), ["scenario"]);
    assert_eq!(folder.completed("triangulate square.obj", "--me"), ["--method", "--mend"]);
    assert_eq!(folder.completed("triangulate square.obj --method", "m"), ["monotone"]);
}

/// As a person at the keyboard: the script is read by bash, and its function asked.
#[cfg(target_os = "linux")]
#[test]
fn bash_completes_by_the_script() {
    let folder = folder();
    folder.write("completions", &folder.dcel("completions bash").fine());
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_dcel")).parent().expect("a folder").to_owned();
    let ask = "source ./completions; COMP_WORDS=(dcel info sq); COMP_CWORD=2; COMP_TYPE=9; COMP_LINE='dcel info sq'; \
        f=$(complete -p dcel | sed 's/.*-F \\([^ ]*\\).*/\\1/'); $f dcel sq info; printf '%s\\n' \"${COMPREPLY[@]}\"";
    let mut bash = std::process::Command::new("bash");
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let output = bash.args(["-c", ask]).current_dir(folder.path("")).env("PATH", path).output().expect("bash");
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(String::from_utf8_lossy(&output.stdout), "square.obj\n", "{told}");
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = Folder::empty();
    let told = folder.dcel("man pages").fine();
    let files: BTreeSet<String> = std::fs::read_dir(folder.path("pages"))
        .expect("the pages")
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"))
        .collect();
    assert_eq!(told, format!("pages: {} pages\n", files.len()));
    let commands = folder.completed("", "");
    for command in commands.iter().filter(|word| !word.starts_with('-') && *word != "help") {
        assert!(files.contains(&format!("dcel-{command}.1")), "dcel {command} has no page");
        for below in folder.completed(command, "") {
            // Files of the folder, options and values are no commands.
            if folder.dcel(&format!("help {command} {below}")).code == Some(0) && below != "help" {
                assert!(files.contains(&format!("dcel-{command}-{below}.1")), "dcel {command} {below} has no page");
            }
        }
    }
    assert!(files.contains("dcel-navmesh-path.1") && !files.contains("dcel-lab-bundle.1"));
    for file in &files {
        let page = folder.read(&format!("pages/{file}"));
        let name = file.trim_end_matches(".1");
        assert!(page.contains(&format!(".TH {name} 1")), "{file}");
        assert!(page.contains(".SH SYNOPSIS") && page.contains(".SH DESCRIPTION"), "{file}");
    }
    let page = folder.read("pages/dcel-info.1");
    assert!(page.contains("dcel info square.obj"), "the examples are in the page");
    // A second call changes nothing, and a file in the way is named.
    folder.dcel("man pages").fine();
    folder.write("taken", "");
    folder.dcel("man taken").fails(3, "taken", "");
}
