//! Each wall alone, with a program that was never scanned.

use super::class::{NONE, USER, launcher, running};
use dcel_kit::lab::{End, Limits, Program, Ran, WallChoice, Walls};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Arc, Mutex, Weak};
use std::time::{Duration, Instant};

const SPACES: WallChoice = WallChoice { namespaces: true, ..NONE };
const FILES: WallChoice = WallChoice { own_files: true, ..NONE };
const ALL: WallChoice = WallChoice { own_user: true, namespaces: true, own_files: true };

/// The attacking program, where everybody can reach it; compiled when the first test asks, removed after the last.
fn attacker() -> Arc<Attacker> {
    static PROGRAM: Mutex<Weak<Attacker>> = Mutex::new(Weak::new());
    let mut kept = PROGRAM.lock().unwrap();
    kept.upgrade().unwrap_or_else(|| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::set_permissions(folder.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/attacks/program.rs");
        let program = folder.path().join("program");
        let built = Command::new("rustc").args(["--edition=2024", "-o"]).arg(&program).arg(source).status().unwrap();
        assert!(built.success());
        let made = Arc::new(Attacker { program, _folder: folder });
        *kept = Arc::downgrade(&made);
        made
    })
}

struct Attacker {
    program: PathBuf,
    _folder: tempfile::TempDir,
}

/// The walls of a choice, or `None` with a word if this machine does not have all of them.
fn walls(choice: WallChoice) -> Option<Walls> {
    let walls = Walls::probe(Some(launcher()), choice);
    if walls.up() == choice {
        return Some(walls);
    }
    println!("not here: {choice:?}: {:?}", walls.said());
    None
}

const LIMITS: Limits =
    Limits { seconds: 1.0, cpu_seconds: 5, memory_mb: 256, output_kb: 256, file_kb: 4, files: 32, processes: 8 };

fn run(choice: WallChoice, word: &str) -> Option<Ran> {
    run_within(choice, LIMITS, word)
}

fn run_within(choice: WallChoice, limits: Limits, word: &str) -> Option<Ran> {
    let attacker = attacker();
    Some(walls(choice)?.program(&attacker.program, limits).unwrap().run(word))
}

fn said(ran: &Ran) -> String {
    String::from_utf8_lossy(&ran.stdout).into_owned()
}

/// Killed processes need a moment to be gone.
fn assert_nothing_runs(words: &str) {
    let begin = Instant::now();
    while running(words).is_some() {
        assert!(begin.elapsed() < Duration::from_secs(2), "{words} is still running");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn ends_are_told_apart_behind_every_wall() {
    let attacker = attacker();
    for choice in [NONE, USER, SPACES, FILES, ALL] {
        let Some(walls) = walls(choice) else { continue };
        let program = walls.program(&attacker.program, LIMITS).unwrap();
        let echo = program.run("echo hello");
        assert_eq!((said(&echo).as_str(), echo.end), ("hello\n", End::Exited(0)), "{choice:?}");
        for (word, end) in [
            ("exit 3", End::Exited(3)),
            // The launcher's own codes cannot be borrowed.
            ("exit 191", End::Exited(191)),
            ("exit 190", End::Exited(180)),
            ("abort", End::Signalled { signal: 6, name: "SIGABRT" }),
            ("overflow", End::StackOverflow),
            ("memory", End::OutOfMemory),
            ("flood", End::OutputLimit),
        ] {
            assert_eq!(program.run(word).end, end, "{word} behind {choice:?}");
        }
    }
}

#[test]
fn deadlines_hold_behind_every_wall() {
    let short = Limits { seconds: 0.3, ..LIMITS };
    for choice in [NONE, USER, SPACES, ALL] {
        for word in ["loop", "sleep"] {
            let Some(ran) = run_within(choice, short, word) else { continue };
            assert_eq!(ran.end, End::TimedOut, "{word} behind {choice:?}");
            assert!(ran.millis < 5000, "{word} took {} ms behind {choice:?}", ran.millis);
        }
    }
    // Long before the deadline, unless the machine is very busy.
    let busy = Limits { seconds: 30.0, cpu_seconds: 1, ..LIMITS };
    let ran = run_within(NONE, busy, "loop").unwrap();
    assert!(ran.end == End::TimedOut && ran.millis < 25_000, "{:?} after {} ms", ran.end, ran.millis);
}

#[test]
fn limits_of_the_system_hold() {
    for choice in [USER, ALL] {
        let Some(ran) = run(choice, "open") else { continue };
        let open: usize = said(&ran).trim().parse().unwrap();
        assert!((20..32).contains(&open), "{open} files behind {choice:?}");
    }
    let dir = tempfile::tempdir().unwrap();
    std::fs::set_permissions(dir.path(), std::fs::Permissions::from_mode(0o777)).unwrap();
    let file = dir.path().join("file");
    for choice in [NONE, USER] {
        let Some(ran) = run(choice, &format!("write {}", file.display())) else { continue };
        assert!(matches!(ran.end, End::Signalled { signal: 25, .. }), "{:?}", ran.end);
        assert_eq!(std::fs::metadata(&file).unwrap().len(), 4096);
        std::fs::remove_file(&file).unwrap();
    }
}

#[test]
fn fork_bombs_burn_out() {
    // The number of processes binds everybody but root.
    for choice in [USER, WallChoice { namespaces: true, ..USER }] {
        let Some(ran) = run(choice, "fork") else { continue };
        let born: usize = said(&ran).trim().parse().unwrap();
        assert!((1..=8).contains(&born), "{born} processes behind {choice:?}");
        assert_nothing_runs("/bin/sleep 4.125");
    }
}

#[test]
fn daemons_do_not_survive() {
    for (i, choice) in [NONE, USER, SPACES, ALL].into_iter().enumerate() {
        let seconds = format!("5.{}{i}", std::process::id());
        let Some(ran) = run(choice, &format!("daemon {seconds}")) else { continue };
        assert!(ran.millis < 4500, "the pipe was held for {} ms behind {choice:?}", ran.millis);
        assert_nothing_runs(&format!("/bin/sleep {seconds}"));
    }
}

#[test]
fn files_of_the_grader_are_out_of_reach() {
    let dir = tempfile::tempdir().unwrap();
    let solution = dir.path().join("lab.rs");
    std::fs::write(&solution, "the solution").unwrap();
    let read = format!("read {}", solution.display());
    std::fs::set_permissions(dir.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
    assert!(said(&run(NONE, &read).unwrap()).contains("the solution"), "the attack does not even work without walls");
    if let Some(ran) = run(FILES, &read) {
        assert!(said(&ran).contains("ermission denied"), "{}", said(&ran));
        assert!(said(&run(FILES, "list /tmp").unwrap()).starts_with("error"));
        assert!(said(&run(FILES, "list /proc").unwrap()).starts_with("error"));
        assert!(said(&run(FILES, "run /bin/true").unwrap()).starts_with("error"));
        assert!(said(&run(FILES, &format!("write {}", dir.path().join("x").display())).unwrap()).starts_with("error"));
    }
    std::fs::set_permissions(dir.path(), std::fs::Permissions::from_mode(0o700)).unwrap();
    for choice in [USER, ALL] {
        let Some(ran) = run(choice, &read) else { continue };
        assert!(said(&ran).contains("ermission denied"), "{}", said(&ran));
    }
}

#[test]
fn a_user_of_its_own_has_no_rights() {
    let Some(ran) = run(USER, "user") else { return };
    let status = said(&ran);
    let field =
        |key: &str| status.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_default().trim().to_owned();
    let users: Vec<u32> = field("Uid:").split_whitespace().map(|id| id.parse().unwrap()).collect();
    assert!(users.iter().all(|&id| id >= 61_184 && id == users[0]), "{users:?}");
    assert_eq!((field("CapEff:"), field("CapPrm:")), ("0".repeat(16), "0".repeat(16)));
    assert_eq!(field("NoNewPrivs:"), "1");
    assert_eq!(field("Groups:"), "");
    // Nor can it end what is not its own: this very process, for one.
    let kill = run(USER, &format!("kill {}", std::process::id())).unwrap();
    assert!(!said(&kill).contains("ExitStatus(unix_wait_status(0))"), "{}", said(&kill));
}

#[test]
fn the_network_is_out_of_reach() {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let connect = format!("connect {}", listener.local_addr().unwrap());
    assert!(said(&run(NONE, &connect).unwrap()).starts_with("ok"), "the attack does not even work without walls");
    for choice in [SPACES, FILES, ALL] {
        let Some(ran) = run(choice, &connect) else { continue };
        assert!(said(&ran).starts_with("error"), "{} behind {choice:?}", said(&ran));
    }
}

#[test]
fn a_missing_wall_is_named() {
    let walls = Walls::probe(Some(launcher()), NONE);
    assert_eq!(walls.up(), NONE);
    let missing = walls.said().iter().filter(|wall| wall.missing.as_deref() == Some("switched off")).count();
    assert_eq!(missing, 3, "{:?}", walls.said());
    // A launcher that is none: no wall stands, and no program runs.
    let broken = Walls::probe(Some(Path::new("/bin/false")), ALL);
    assert!(broken.said().iter().all(|wall| wall.missing.is_some()), "{:?}", broken.said());
}

#[test]
fn a_wall_that_falls_later_stops_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let copy = folder.path().join("launcher");
    std::fs::copy(launcher(), &copy).unwrap();
    let attacker = attacker();
    let walls = Walls::probe(Some(&copy), NONE);
    let program = walls.program(&attacker.program, LIMITS).unwrap();
    assert_eq!(program.run("exit 0").end, End::Exited(0));
    std::fs::remove_file(&copy).unwrap();
    assert!(matches!(program.run("exit 0").end, End::NotStarted(_)));
    let nowhere = Walls::probe(Some(launcher()), NONE).program(&folder.path().join("gone"), LIMITS).unwrap();
    let end = nowhere.run("exit 0").end;
    assert!(matches!(&end, End::NotStarted(why) if why.contains("gone")), "{end:?}");
}
