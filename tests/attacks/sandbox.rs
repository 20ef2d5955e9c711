//! Each barrier alone, with a program that was never scanned.

use super::class::{NONE, behind_each, home, launcher, running, sandbox};
use crate::trials::trials;
use dcel_lab::{End, Limits, Program, Ran, Sandbox, SandboxChoice};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::time::{Duration, Instant};

behind_each! {
    ends(ends_are_told_apart);
    deadlines(deadlines_hold);
    open_files(limits_of_files_hold);
    daemons(daemons_do_not_survive);
    files(files_of_the_grader_are_out_of_reach);
    network(the_network_is_out_of_reach);
    inherited(what_is_open_is_closed);
    others(other_processes_are_out_of_reach);
}

/// The attacking program, where everybody can reach it; compiled when the first test asks, removed after the last.
fn attacker() -> Arc<Attacker> {
    static PROGRAM: Mutex<Weak<Attacker>> = Mutex::new(Weak::new());
    let mut kept = PROGRAM.lock().unwrap_or_else(PoisonError::into_inner);
    kept.upgrade().unwrap_or_else(|| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::set_permissions(folder.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
        let source = home().join("tests/attacks/program.rs");
        let program = folder.path().join("program");
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let built = Command::new(rustc).args(["--edition=2024", "-o"]).arg(&program).arg(source).status().unwrap();
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

/// Where the user is one's own, what other tests start while an attack runs counts, too: room is left for that.
const LIMITS: Limits =
    Limits { seconds: 1.0, cpu_seconds: 5, memory_mb: 256, output_kb: 256, file_kb: 4, files: 32, processes: 64 };

fn run(choice: SandboxChoice, word: &str) -> Ran {
    run_within(choice, LIMITS, word)
}

fn run_within(choice: SandboxChoice, limits: Limits, word: &str) -> Ran {
    sandbox(choice).program(&attacker().program, limits).unwrap().run(word)
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

fn ends_are_told_apart(choice: SandboxChoice) {
    let attacker = attacker();
    let program = sandbox(choice).program(&attacker.program, LIMITS).unwrap();
    let echo = program.run("echo hello");
    assert_eq!((said(&echo).as_str(), echo.end), ("hello\n", End::Exited(0)));
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
        assert_eq!(program.run(word).end, end, "{word}");
    }
}

fn deadlines_hold(choice: SandboxChoice) {
    let short = Limits { seconds: 0.3, ..LIMITS };
    for word in ["loop", "sleep"] {
        let ran = run_within(choice, short, word);
        assert_eq!(ran.end, End::TimedOut, "{word}");
        assert!(ran.millis < 5000, "{word} took {} ms", ran.millis);
    }
}

fn processor_time_ends_a_loop_before_the_deadline() {
    // Unless the machine is very busy.
    let busy = Limits { seconds: 30.0, cpu_seconds: 1, ..LIMITS };
    let ran = run_within(NONE, busy, "loop");
    assert!(ran.end == End::TimedOut && ran.millis < 25_000, "{:?} after {} ms", ran.end, ran.millis);
}

fn limits_of_files_hold(choice: SandboxChoice) {
    let open: usize = said(&run(choice, "open")).trim().parse().unwrap();
    assert!((20..32).contains(&open), "{open} files");
    let dir = tempfile::tempdir().unwrap();
    std::fs::set_permissions(dir.path(), std::fs::Permissions::from_mode(0o777)).unwrap();
    let file = dir.path().join("file");
    let ran = run(choice, &format!("write {}", file.display()));
    if choice.namespaces || choice.own_files {
        assert!(said(&ran).starts_with("error") && !file.exists(), "{}", said(&ran));
    } else {
        assert!(matches!(ran.end, End::Signalled { signal: 25, .. }), "{:?}", ran.end);
        assert_eq!(std::fs::metadata(&file).unwrap().len(), 4096);
    }
}

/// The number of processes binds everybody but root.
fn fork_bombs_burn_out(choice: SandboxChoice) {
    let born: usize = said(&run_within(choice, Limits { processes: 8, ..LIMITS }, "fork")).trim().parse().unwrap();
    assert!((1..=8).contains(&born), "{born} processes");
    assert_nothing_runs("4.125");
}

fn fork_bombs_of_a_user_of_its_own_burn_out() {
    fork_bombs_burn_out(SandboxChoice { own_user: true, ..NONE });
}

fn fork_bombs_in_namespaces_burn_out() {
    fork_bombs_burn_out(SandboxChoice { own_user: true, namespaces: true, ..NONE });
}

fn daemons_do_not_survive(choice: SandboxChoice) {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let seconds = format!("5.{}{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
    let ran = run(choice, &format!("daemon {seconds}"));
    assert!(ran.millis < 4500, "the pipe was held for {} ms", ran.millis);
    assert!(said(&ran).starts_with("ok"), "the attack was not made: {}", said(&ran));
    assert_nothing_runs(&seconds);
}

fn files_of_the_grader_are_out_of_reach(choice: SandboxChoice) {
    let dir = tempfile::tempdir().unwrap();
    let solution = dir.path().join("lab.rs");
    std::fs::write(&solution, "the solution").unwrap();
    let read = format!("read {}", solution.display());
    let read_with = |mode| {
        std::fs::set_permissions(dir.path(), std::fs::Permissions::from_mode(mode)).unwrap();
        said(&run(choice, &read)).contains("the solution")
    };
    let sandboxed = choice.namespaces || choice.own_files;
    // Open to everybody: here the attack works wherever no barrier is made for it.
    assert_eq!(read_with(0o755), !sandboxed);
    assert_eq!(read_with(0o700), !sandboxed && !choice.own_user);
    if sandboxed {
        for word in
            ["list /home", "list /opt", "list /root", "read /etc/passwd", "read /etc/hostname", "list /usr/share"]
        {
            assert!(said(&run(choice, word)).starts_with("error"), "{word}: {}", said(&run(choice, word)));
        }
        let written = dir.path().join("x");
        std::fs::set_permissions(dir.path(), std::fs::Permissions::from_mode(0o777)).unwrap();
        assert!(said(&run(choice, &format!("write {}", written.display()))).starts_with("error"));
        for place in ["/x", "/usr/lib/x", "/proc/x", "/dev/x", "/dev/shm/x", "/tmp/x"] {
            assert!(said(&run(choice, &format!("write {place}"))).starts_with("error"), "{place}");
        }
    }
    if choice.own_files {
        assert!(said(&run(choice, "run /bin/true")).starts_with("error"));
    }
}

/// A file that was open when the launcher was started is closed before the program runs.
fn what_is_open_is_closed(choice: SandboxChoice) {
    let dir = tempfile::tempdir().unwrap();
    std::fs::set_permissions(dir.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
    let (secret, leaky) = (dir.path().join("secret"), dir.path().join("launcher"));
    std::fs::write(&secret, "seed = 99").unwrap();
    std::fs::set_permissions(&secret, std::fs::Permissions::from_mode(0o600)).unwrap();
    let script = format!("#!/bin/sh\nexec 7< '{}'\nexec '{}' \"$@\"\n", secret.display(), launcher().display());
    std::fs::write(&leaky, script).unwrap();
    std::fs::set_permissions(&leaky, std::fs::Permissions::from_mode(0o755)).unwrap();
    let attacker = attacker();
    // The attack by itself: a program started with the file open can read it.
    let open = format!("exec 7< '{}'; echo inherited | '{}'", secret.display(), attacker.program.display());
    let out = Command::new("/bin/sh").arg("-c").arg(open).output().unwrap();
    assert!(
        String::from_utf8_lossy(&out.stdout).contains("seed = 99"),
        "the attack does not even work without a sandbox"
    );
    let leaking = Sandbox::probe(Some(&leaky), choice);
    assert_eq!(leaking.up(), choice, "{:?}", leaking.said());
    let ran = leaking.program(&attacker.program, LIMITS).unwrap().run("inherited");
    assert_eq!((said(&ran).as_str(), ran.end), ("0\n", End::Exited(0)));
}

/// What others run can be seen where nothing but a user of its own stands before it.
fn other_processes_are_out_of_reach(choice: SandboxChoice) {
    let own = std::process::id();
    let seen = said(&run(choice, &format!("process {own}"))).contains("attacks");
    assert_eq!(seen, !choice.namespaces && !choice.own_files);
    for file in ["environ", "fd/0", "maps"] {
        let read = said(&run(choice, &format!("read /proc/{own}/{file}")));
        assert!(choice == NONE || read.starts_with("error"), "{file}: {read}");
    }
    if choice.namespaces {
        // The watcher is the first process there; the system's own root is gone.
        for word in ["read /proc/1/environ", "list /proc/1/root", "list /proc/1/cwd", "read /proc/1/fd/0", "list /old"]
        {
            assert!(said(&run(choice, word)).starts_with("error"), "{word}: {}", said(&run(choice, word)));
        }
        for word in ["read /proc/self/root/../../etc/passwd", "read /proc/self/cwd/../../etc/passwd"] {
            assert!(said(&run(choice, word)).starts_with("error"), "{word}");
        }
    }
    // Nor can it end what is not its own.
    if choice.own_user || choice.namespaces {
        let kill = said(&run(choice, &format!("kill {own}")));
        assert!(!kill.contains("ExitStatus(unix_wait_status(0))"), "{kill}");
    }
}

fn a_user_of_its_own_has_no_rights() {
    let status = said(&run(super::class::USER, "user"));
    let field =
        |key: &str| status.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_default().trim().to_owned();
    let users: Vec<u32> = field("Uid:").split_whitespace().map(|id| id.parse().unwrap()).collect();
    assert!(users.iter().all(|&id| id >= 61_184 && id == users[0]), "{users:?}");
    assert_eq!((field("CapEff:"), field("CapPrm:")), ("0".repeat(16), "0".repeat(16)));
    assert_eq!(field("NoNewPrivs:"), "1");
    assert_eq!(field("Groups:"), "");
}

/// Root, or whoever grades, has no rights in the namespaces either: nothing that covers can be taken away.
fn nobody_has_rights_in_namespaces() {
    let status = said(&run(super::class::SPACES, "user"));
    let field = |key: &str| status.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_default().trim();
    assert_ne!(field("Uid:").split_whitespace().next(), Some("0"), "{status}");
    assert_eq!((field("CapEff:"), field("CapPrm:")), ("0000000000000000", "0000000000000000"));
}

fn the_network_is_out_of_reach(choice: SandboxChoice) {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let ran = run(choice, &format!("connect {}", listener.local_addr().unwrap()));
    // Without a sandbox the attack works.
    let open = !choice.namespaces && !choice.own_files;
    assert_eq!(said(&ran).starts_with("ok"), open, "{}", said(&ran));
}

fn a_missing_wall_is_named() {
    let sandbox = Sandbox::probe(Some(launcher()), NONE);
    assert_eq!(sandbox.up(), NONE);
    let missing = sandbox.said().iter().filter(|barrier| barrier.missing.as_deref() == Some("switched off")).count();
    assert_eq!(missing, 3, "{:?}", sandbox.said());
    // A launcher that is none: no barrier stands, and no program runs.
    let broken = Sandbox::probe(Some(Path::new("/bin/false")), super::class::ALL);
    assert!(broken.said().iter().all(|barrier| barrier.missing.is_some()), "{:?}", broken.said());
}

fn a_wall_that_falls_later_stops_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let copy = folder.path().join("launcher");
    std::fs::copy(launcher(), &copy).unwrap();
    let attacker = attacker();
    let sandbox = Sandbox::probe(Some(&copy), NONE);
    let program = sandbox.program(&attacker.program, LIMITS).unwrap();
    assert_eq!(program.run("exit 0").end, End::Exited(0));
    std::fs::remove_file(&copy).unwrap();
    assert!(matches!(program.run("exit 0").end, End::NotStarted(_)));
    let nowhere = Sandbox::probe(Some(launcher()), NONE).program(&folder.path().join("gone"), LIMITS).unwrap();
    let end = nowhere.run("exit 0").end;
    assert!(matches!(&end, End::NotStarted(why) if why.contains("gone")), "{end:?}");
}

trials! {
    processor_time_ends_a_loop_before_the_deadline;
    fork_bombs_of_a_user_of_its_own_burn_out: Root;
    fork_bombs_in_namespaces_burn_out: Root, Namespaces;
    a_user_of_its_own_has_no_rights: Root;
    nobody_has_rights_in_namespaces: Namespaces;
    a_missing_wall_is_named;
    a_wall_that_falls_later_stops_the_run;
}
