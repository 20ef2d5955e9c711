//! Promise: a file is written whole or not at all, and nothing that is read is ever written over by a slip.
//!
//! Named after the defect that showed it: `defects/disk_full.sh`.

use crate::shell::{Folder, SQUARE, grid};
use dcel_kit::files::ScratchFolder;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// What a good old file holds in these tests.
const OLD: &str = "precious\n";

/// Names in the folder that begin with a dot: temporaries.
fn hidden(folder: &Folder) -> Vec<String> {
    let entries = fs::read_dir(folder.path(".")).expect("the folder");
    let names = entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned());
    names.filter(|name| name.starts_with('.')).collect()
}

/// Runs a line of a shell in the folder, with `dcel` as the command.
#[cfg(unix)]
fn shell(folder: &Folder, line: &str) -> std::process::Output {
    let line = format!("dcel() {{ '{}' \"$@\"; }}; {line}", env!("CARGO_BIN_EXE_dcel"));
    Command::new("bash").args(["-c", &line]).current_dir(folder.path(".")).output().expect("bash")
}

/// Every command that writes a file, with calls that write `out.…`.
const WRITERS: [(&str, &str); 14] = [
    ("convert big.obj out.dcel", "out.dcel"),
    ("convert big.obj out.off", "out.off"),
    ("convert big.obj out.node", "out.node"),
    ("build big.geojson -o out.dcel", "out.dcel"),
    ("delaunay big.obj -o out.dcel", "out.dcel"),
    ("delaunay big.obj --figure out.svg", "out.svg"),
    ("voronoi big.obj --figure out.svg", "out.svg"),
    ("triangulate big.obj --figure out.svg", "out.svg"),
    ("figure big.obj -o out.svg", "out.svg"),
    ("figure big.obj --html out.html", "out.html"),
    ("script lab.dcels --film out.svg", "out.svg"),
    ("locate big.obj 1 1 -o out.svg", "out.svg"),
    ("solid make sphere 40 40 -o out.off", "out.off"),
    ("lab export 04 --student out.zip", "out.zip"),
];

fn with_inputs() -> Folder {
    let folder = Folder::new();
    folder.write("big.obj", &grid(16));
    folder.dcel("convert big.obj big.geojson").fine();
    folder.dcel("sample lab.dcels").fine();
    folder
}

/// A limit on the size of files stands for a full disk: the writing fails in its middle.
#[test]
#[cfg(unix)]
fn disk_full() {
    let folder = with_inputs();
    for (call, out) in WRITERS {
        folder.write(out, OLD);
        let told = shell(&folder, &format!("ulimit -f 2; dcel {call}"));
        let error = String::from_utf8_lossy(&told.stderr).into_owned();
        assert_eq!(told.status.code(), Some(3), "{call}: {error}");
        assert!(error.contains("out.") && error.contains("cannot be written: File too large"), "{call}: {error}");
        assert_eq!(folder.read(out), OLD, "{call}");
        assert_eq!(hidden(&folder), [""; 0], "{call}");
        // The same call is fine where there is room.
        folder.dcel(call).fine();
        assert!(folder.read_bytes(out).len() > 2000, "{call}");
    }
    let told = shell(&folder, "ulimit -f 2; dcel lab start 04 lab; dcel lab export 04 --student lab/");
    assert_eq!(told.status.code(), Some(3), "{told:?}");
    assert!(!folder.path("lab").exists() && hidden(&folder).is_empty(), "half a folder");
    fs::create_dir(folder.path("lab")).expect("a folder");
    assert_eq!(shell(&folder, "ulimit -f 2; dcel lab start 04 lab").status.code(), Some(3));
    assert_eq!(fs::read_dir(folder.path("lab")).expect("the old folder").count(), 0);
    folder.dcel("lab start 04 lab").fine();
}

/// A command that is ended while its temporary grows.
#[cfg(unix)]
fn ended_by(signal: &str) -> (Folder, Option<i32>) {
    use std::os::unix::process::ExitStatusExt;
    let folder = Folder::new();
    folder.write("big.obj", &grid(150));
    folder.write("out.dcel", OLD);
    let mut child = folder.command("convert big.obj out.dcel").spawn().expect("the command starts");
    let temporary = folder.path(".out.dcel.dcel-part");
    while fs::metadata(&temporary).map_or(0, |data| data.len()) < 10_000 {
        assert!(child.try_wait().expect("the command").is_none(), "ended before it was looked at");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill");
    assert!(kill.success(), "ended before the signal");
    let status = child.wait().expect("the command ends");
    (folder, status.signal())
}

/// Whether this process ignores a signal, where the system tells that.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.and_then(|bits| u64::from_str_radix(bits.trim(), 16).ok()).is_some_and(|bits| bits >> (signal - 1) & 1 == 1)
}

#[test]
#[cfg(unix)]
fn a_signal_leaves_the_old_file_and_no_temporary() {
    let all = [("-INT", 2), ("-TERM", 15), ("-HUP", 1)];
    // What is ignored when these tests begin stays ignored: under nohup a command goes on after the last of them.
    for (signal, number) in all.into_iter().filter(|&(_, number)| !is_ignored(number)) {
        let (folder, ended) = ended_by(signal);
        assert_eq!(ended, Some(number), "{signal}: the shell must be told the same");
        assert_eq!(folder.read("out.dcel"), OLD, "{signal}");
        assert_eq!(hidden(&folder), [""; 0], "{signal}");
    }
}

#[test]
#[cfg(unix)]
fn a_killed_command_leaves_one_temporary_that_the_next_run_replaces() {
    let (folder, _) = ended_by("-KILL");
    assert_eq!(folder.read("out.dcel"), OLD);
    assert_eq!(hidden(&folder), [".out.dcel.dcel-part"]);
    folder.dcel("convert square.obj out.dcel").fine();
    assert_eq!(hidden(&folder), [""; 0]);
    assert_eq!(folder.dcel("validate out.dcel").fine(), "out.dcel: valid\n");
}

#[test]
fn a_temporary_in_use_is_left_alone() {
    let folder = Folder::new();
    let other = fs::File::create(folder.path(".out.dcel.dcel-part")).expect("a file");
    other.lock().expect("a lock");
    folder.dcel("convert square.obj out.dcel").fine();
    assert_eq!(hidden(&folder), [".out.dcel.dcel-part"]);
    drop(other);
    folder.dcel("convert square.obj out.dcel").fine();
    assert_eq!(hidden(&folder), [""; 0]);
}

/// Many processes make and remove folders of one name: one that looks for what was left behind sees those of others
/// before they are locked.
#[test]
#[cfg(unix)]
fn scratch_folders_of_many_processes_are_never_taken_away() {
    const ROOM: &str = "DCEL_TEST_ROOM";
    if let Some(room) = std::env::var_os(ROOM) {
        let target = Path::new(&room).join("scratch");
        for _ in 0..3000 {
            let folder = ScratchFolder::beside(&target).expect("a folder");
            assert!(folder.path().is_dir(), "another process has removed it");
        }
        return;
    }
    let room = Folder::new();
    let myself = std::env::current_exe().expect("this program has a path");
    let mut others = Vec::new();
    for _ in 0..6 {
        let mut command = Command::new(&myself);
        command.args(["scratch_folders_of_many_processes_are_never_taken_away", "--nocapture"]);
        command.env(ROOM, room.path(".")).stdout(Stdio::piped()).stderr(Stdio::piped());
        others.push(command.spawn().expect("this program starts"));
    }
    for other in others {
        let done = other.wait_with_output().expect("it ends");
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        assert!(String::from_utf8_lossy(&done.stdout).contains("1 passed"), "it ran");
    }
    assert!(hidden(&room).is_empty(), "{:?}", hidden(&room));
}

#[test]
#[cfg(unix)]
fn a_temporary_that_is_a_link_is_never_followed() {
    let folder = Folder::new();
    folder.write("victim", OLD);
    std::os::unix::fs::symlink("victim", folder.path(".out.dcel.dcel-part")).expect("a link");
    folder.dcel("convert square.obj out.dcel").fine();
    assert_eq!((folder.read("victim").as_str(), fs::read_link(folder.path("out.dcel")).is_err()), (OLD, true));
}

#[test]
fn the_input_is_not_written_over() {
    let folder = Folder::new();
    folder.write("style.svg", "{}");
    folder.write("points.svg", "1 1\n");
    folder.write("sites.xy", "0 0\n4 0\n2 3\n");
    folder.write("s.dcels", "rectangle\nsplit_face h2 h8\n");
    fs::hard_link(folder.path("square.obj"), folder.path("hard.obj")).expect("a hard link");
    for (call, error, help) in [
        ("convert square.obj square.obj", "square.obj: this is the input itself", "--in-place"),
        ("convert square.obj ./square.obj", "under another name, which is square.obj", "--in-place"),
        ("convert square.obj hard.obj", "hard.obj: this is the input itself under another name", "--in-place"),
        ("delaunay sites.xy -o sites.xy", "sites.xy: this is the input itself", "--in-place"),
        ("delaunay sites.xy --figure sites.xy", "sites.xy: this is the input itself", "choose another name"),
        ("figure square.obj --style style.svg -o style.svg", "style.svg: --style reads this file", "another name"),
        ("locate square.obj --points points.svg -o points.svg", "points.svg: --points reads this file", ""),
        ("script s.dcels --film s.dcels", "s.dcels: this is the input itself", ""),
        ("solid figure cube.off -o cube.off", "", "end the name in .svg"),
        ("solid dual cube.off -o cube.off", "cube.off: this is the input itself", "--in-place"),
        ("overlay square.obj garden.json -o garden.json", "garden.json: this is the input itself", ""),
        (
            "delaunay sites.xy -o new.svg --figure new.svg",
            "new.svg: -o and --figure would both be written",
            "two files",
        ),
        ("voronoi sites.xy -o a.dcel --figure ./a.dcel", "a.dcel: -o and --figure would both", "two files"),
        ("convert square.obj new.obj --in-place", "--in-place: what OUT names is not the input", "leave"),
        ("solid make cube -o new.off --in-place", "--in-place: what -o names is not the input", "leave"),
        ("overlay - -", "standard input cannot be both A and B", "as a file first"),
        ("locate - --points -", "standard input cannot be both", "as a file first"),
        ("compare - -", "standard input cannot be both", "as a file first"),
    ] {
        folder.dcel(call).fails(2, error, help);
    }
    // The shell opens it under no name.
    for call in ["dcel convert - square.obj --format obj < square.obj", "dcel delaunay - -o sites.xy < sites.xy"] {
        let told = shell(&folder, call);
        let error = String::from_utf8_lossy(&told.stderr);
        let is_told = error.contains("this is the input itself under another name, which is standard input");
        assert!(told.status.code() == Some(2) && is_told == cfg!(unix), "{call}: {error}");
    }
    assert!(shell(&folder, "dcel convert - new.obj --format obj < square.obj").status.success());
    assert!(shell(&folder, "cat square.obj | dcel convert - new.obj --format obj").status.success());
    assert_eq!(folder.read("square.obj"), SQUARE);
    assert_eq!(folder.read("sites.xy"), "0 0\n4 0\n2 3\n");
    // Two files of one pair.
    folder.dcel("convert square.obj pair.node").fine();
    folder.dcel("convert pair.node pair.ele").fails(2, "this is the input itself", "");
    // On request, and with the new contents.
    folder.dcel("convert square.obj square.obj --in-place").fine();
    assert!(folder.read("square.obj").starts_with("# 4 points, 2 polygons\n"));
    assert_eq!(folder.dcel("info square.obj --json").json()["edges"], 5);
}

#[test]
#[cfg(unix)]
fn links_and_permissions_stay() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    fs::create_dir(folder.path("far")).expect("a folder");
    for (link, to) in [("link.obj", "square.obj"), ("to.dcel", "far/new.dcel"), ("on.dcel", "to.dcel")] {
        std::os::unix::fs::symlink(to, folder.path(link)).expect("a link");
    }
    folder.dcel("convert square.obj link.obj").fails(2, "this is the input itself under another name", "");
    // The link stays, and what it leads to is written, whether it is there or not.
    for _ in 0..2 {
        folder.dcel("convert square.obj on.dcel").fine();
        assert_eq!(fs::read_link(folder.path("on.dcel")).expect("a link").to_string_lossy(), "to.dcel");
        assert_eq!(folder.dcel("validate far/new.dcel").fine(), "far/new.dcel: valid\n");
    }
    for mode in [0o600, 0o755, 0o664] {
        fs::set_permissions(folder.path("far/new.dcel"), fs::Permissions::from_mode(mode)).expect("permissions");
        folder.dcel("convert square.obj far/new.dcel").fine();
        let now = fs::metadata(folder.path("far/new.dcel")).expect("the file").permissions().mode();
        assert_eq!(now & 0o777, mode);
    }
    std::os::unix::fs::symlink("loop.dcel", folder.path("loop.dcel")).expect("a link");
    folder.dcel("convert square.obj loop.dcel").fails(
        3,
        "loop.dcel: cannot be written: its links lead in a circle",
        "",
    );
}

#[test]
#[cfg(unix)]
fn devices_and_pipes_are_written_to_as_they_are() {
    let folder = Folder::new();
    let dcel = folder.dcel("convert square.obj - --to dcel").fine();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    let piped = shell(&folder, "dcel convert square.obj /dev/stdout --to dcel | cat");
    assert_eq!(text(piped.stdout), dcel);
    // Standard output that is a file is not begun anew, and loses nothing that is written before or after.
    shell(&folder, "(echo before; dcel convert square.obj /dev/stdout --to dcel; echo after) > all.txt");
    assert_eq!(folder.read("all.txt"), format!("before\n{dcel}after\n"));
    shell(&folder, "dcel convert square.obj >(cat > piped.txt) --to dcel; wait $!; sleep 0.2");
    assert_eq!(folder.read("piped.txt"), dcel);
    shell(&folder, "mkfifo fifo; cat fifo > from.txt & dcel convert square.obj fifo --to dcel; wait");
    assert_eq!(folder.read("from.txt"), dcel);
    folder.dcel("convert square.obj /dev/null --to dcel").fine();
    folder.dcel("delaunay square.obj -o /dev/null --figure /dev/null").fails(2, "", "dcel");
    if cfg!(target_os = "linux") {
        folder.dcel("convert square.obj /dev/full --to dcel").fails(3, "/dev/full: cannot be written", "make room");
        folder.dcel("figure square.obj -o /sys/x.svg").fails(3, "no file can be made in /sys", "may write to");
    }
    fs::create_dir(folder.path("box.dcel")).expect("a folder");
    folder.dcel("convert square.obj box.dcel").fails(3, "box.dcel: cannot be written", "give the name of a file in it");
    folder.dcel("convert square.obj new/ --to dcel").fails(
        3,
        "new/: cannot be written",
        "give the name of a file in it",
    );
    assert_eq!(hidden(&folder), [""; 0]);
}

/// As an ordinary user: a folder that may not be written to, and a file that may not be in one that may.
#[test]
#[cfg(unix)]
fn what_is_write_protected_stays_as_it_is() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
    use std::os::unix::process::CommandExt;
    const NOBODY: u32 = 65534;
    let folder = Folder::new();
    let mode = |name: &str, mode| fs::set_permissions(folder.path(name), fs::Permissions::from_mode(mode)).expect(name);
    let am_root = fs::metadata(folder.path("square.obj")).expect("the file").uid() == 0;
    for name in ["closed", "open"] {
        fs::create_dir(folder.path(name)).expect("a folder");
    }
    folder.write("closed/out.off", OLD);
    folder.write("open/out.off", OLD);
    mode("open/out.off", 0o444);
    mode("closed/out.off", 0o666);
    mode("closed", 0o555);
    let mut program = std::path::PathBuf::from(env!("CARGO_BIN_EXE_dcel"));
    if am_root {
        // Nothing is closed to the administrator.
        program = folder.path("dcel");
        fs::copy(env!("CARGO_BIN_EXE_dcel"), &program).expect("a copy");
        chown(folder.path("open"), Some(NOBODY), Some(NOBODY)).expect("another owner");
        mode(".", 0o755);
    }
    for (out, error, help) in [
        ("closed/out.off", "no file can be made in closed, where it is written before", "choose a place"),
        ("closed/new.off", "no file can be made in closed, where it is written before", "choose a place"),
        ("open/out.off", "Permission denied", "choose a place"),
    ] {
        let mut command = Command::new(&program);
        command.args(["convert", "cube.off", out]).current_dir(folder.path(".")).stdin(Stdio::null());
        if am_root {
            command.uid(NOBODY).gid(NOBODY);
        }
        let told = command.output().expect("the command starts");
        let text = String::from_utf8_lossy(&told.stderr).into_owned();
        assert_eq!(told.status.code(), Some(3), "{out}: {text}");
        assert!(text.contains(error) && text.contains(help), "{out}: {text}");
    }
    mode("closed", 0o755);
    assert_eq!((folder.read("closed/out.off"), folder.read("open/out.off")), (OLD.to_owned(), OLD.to_owned()));
}

/// What an input would take is asked for before it is needed.
#[test]
#[cfg(target_os = "linux")]
fn too_little_memory_is_told_and_the_old_file_stays() {
    let folder = Folder::new();
    folder.write("big.obj", &grid(300));
    folder.write("small.obj", &grid(2));
    folder.write("out.dcel", OLD);
    let mut refused = 0;
    // Where the machine has too little even to read the file, the program is aborted; never is anything half written.
    for kilobytes in (40_000..=200_000).step_by(10_000) {
        // With the least of all, not even the program can be loaded, or a small file be read.
        if !shell(&folder, &format!("ulimit -v {kilobytes}; dcel info small.obj")).status.success() {
            continue;
        }
        let told = shell(&folder, &format!("ulimit -v {kilobytes}; dcel convert big.obj out.dcel"));
        let error = String::from_utf8_lossy(&told.stderr).into_owned();
        match told.status.code() {
            Some(3) => {
                let (_, rest) = error.split_once("big.obj: not enough memory: this takes about ").expect("the reason");
                let megabytes: u32 = rest.split(' ').next().and_then(|number| number.parse().ok()).expect("a number");
                // The file has 4 MB, its structure takes 39.
                refused += u32::from(megabytes > 30);
            }
            Some(0) => break,
            _ => assert!(error.contains("memory") || error.contains("shared"), "{kilobytes}: {error}"),
        }
        assert_eq!(folder.read("out.dcel"), OLD, "{kilobytes}");
    }
    assert!(refused > 0, "never refused in order");
    folder.dcel("convert big.obj out.dcel").fine();
}

/// A table whose faces f1 and f2 lie over each other: all pointers are right, and the places are not.
fn folded() -> String {
    let mut text = crate::shell::TRIANGLE.replace("v2 2 3 out h4", "v2 2 -3 out h4");
    text = text.replace("v3 2 1 out none\n", "").replace(" inner v3 name \"Ohio\"", " inner none");
    text
}

/// Only dcel text may hold what is no subdivision of the plane.
#[test]
fn a_broken_structure_is_written_as_dcel_only() {
    let folder = Folder::new();
    folder.dcel("sample broken.dcel").fine();
    folder.write("folded.dcel", &folded());
    for file in ["broken.dcel", "folded.dcel"] {
        assert_eq!(folder.dcel(&format!("validate {file}")).code, Some(1), "{file}");
        for format in ["obj", "off", "ply", "ply-binary", "stl", "triangle", "geojson", "mesh", "tables"] {
            let help = format!("all that is broken in it is named by: dcel validate {file}");
            folder.dcel(&format!("convert {file} out.x --to {format}")).fails(2, &format!("{file}: "), &help);
            assert!(!folder.path("out.x").exists() && !folder.path("out.node").exists(), "{file} {format}");
        }
        folder.dcel(&format!("convert {file} copy.dcel")).fine();
        folder.dcel(&format!("figure {file} -o out.svg")).fine();
    }
    // A sound one keeps the ids of its file.
    assert!(folder.dcel("convert triangle.dcel - --to tables").fine().contains("f1"));
    folder.dcel("convert garden.json garden.dcel").fine();
    assert!(folder.dcel("convert garden.dcel - --to geojson").fine().contains("Shed"));
}

/// Standard output holds one result.
#[test]
fn two_results_on_standard_output_are_refused() {
    let folder = Folder::new();
    folder.write("sites.xy", "0 0\n4 0\n0 4\n");
    for call in [
        "overlay garden.json square.obj --json -o -",
        "voronoi sites.xy --json --figure -",
        "delaunay sites.xy --json --figure -",
        "triangulate square.obj --json --figure -",
        "locate square.obj 1 1 --json -o -",
        "solid make cube --json -o -",
        "solid dual cube.off --json -o -",
        "build garden.json --json --figure -",
    ] {
        let told = folder.dcel(call);
        told.fails(2, "would both be written to standard output", "name a file after");
        let answer: serde_json::Value = serde_json::from_str(&told.out).expect("JSON");
        assert_eq!(answer["error"]["kind"], "usage", "{call}");
    }
    for call in ["build garden.json", "delaunay sites.xy", "voronoi sites.xy", "triangulate square.obj"] {
        let told = folder.dcel(&format!("{call} -o - --figure -"));
        told.fails(2, "-o - and --figure would both be written to standard output", "name a file after -o");
        assert!(folder.dcel(&format!("{call} -o -")).fine().starts_with("dcel 1\n"));
        assert!(folder.dcel(&format!("{call} --figure -")).fine().contains("<svg"));
    }
    folder.dcel("solid make cube --json -o cube2.off").json();
}

/// What a file says and a structure does not keep is told when another file is written, once for each kind.
#[test]
fn what_a_map_loses_is_told_once() {
    let folder = Folder::new();
    let ring = |x: u8| format!("[[[{x},0],[{},0],[{x},1],[{x},0]]]", x + 1);
    let feature = |id: &str, properties: &str, x: u8| {
        format!(
            r#"{{"type":"Feature",{id}"properties":{properties},"geometry":{{"type":"MultiPolygon","coordinates":[{},{}]}}}}"#,
            ring(x),
            ring(x + 2)
        )
    };
    let all = [
        feature(r#""id":"x1","#, r#"{"name":"A","pop":5}"#, 0),
        feature(r#""id":2,"#, r#"{"name":"B","pop":[6]}"#, 10),
    ];
    folder.write("pr.geojson", &format!(r#"{{"type":"FeatureCollection","features":[{}]}}"#, all.join(",")));
    let notes = |told: crate::shell::Told| told.err.lines().map(str::to_owned).collect::<Vec<_>>();
    let told = notes(folder.dcel("convert pr.geojson out.geojson"));
    let ids = "note: 2 ids of features are lost: names are kept";
    let properties = "note: properties of 2 features are lost: only names are kept";
    let groups = "note: 2 multipolygons were taken apart: each of its polygons is a feature by itself";
    assert_eq!(told, [ids, properties, groups].map(str::to_owned));
    assert_eq!(notes(folder.dcel("convert pr.geojson out.dcel")), [ids, properties].map(str::to_owned));
    // Whoever writes no file loses nothing; neither does a file that says no more than is kept.
    assert_eq!(notes(folder.dcel("info pr.geojson")), Vec::<String>::new());
    let plain = feature(r#""id":7,"#, "null", 0)
        .replace("MultiPolygon", "Polygon")
        .replace(&format!("[{},{}]", ring(0), ring(2)), &ring(0));
    folder.write("plain.geojson", &plain);
    assert_eq!(notes(folder.dcel("convert plain.geojson out.geojson")), Vec::<String>::new());
}
