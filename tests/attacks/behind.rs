//! Attacks in a student's file: the scan refuses each at its line, and with the scan switched off the barriers hold.

use super::class::{Class, USER};
use crate::trials::trials;
use dcel_lab::{Report, Verdict};
use std::path::Path;

/// An attack: what stands in the place of the first task's body, and what is added to the file.
struct Attack {
    name: &'static str,
    body: String,
    items: String,
    /// The verdict on the first test when nothing was scanned.
    behind: Verdict,
}

fn body(name: &'static str, behind: Verdict, body: &str) -> Attack {
    Attack { name, body: body.to_owned(), items: String::new(), behind }
}

fn items(name: &'static str, behind: Verdict, items: &str) -> Attack {
    Attack { name, body: "todo!()".to_owned(), items: items.to_owned(), behind }
}

/// Those that the scan refuses. `secret` is a file of the grader's.
fn forbidden(secret: &Path) -> Vec<Attack> {
    let secret = secret.display();
    let reads = format!(
        "match std::fs::read_to_string({:?}) {{ Ok(text) => println!(\"LEAK {{text}}\"), Err(error) => println!(\"KEPT {{error}}\") }}
         for path in [\"../solution/lab.rs\", \"../../solution/lab.rs\", \"../tests/graded.rs\", \"solution/lab.rs\"] {{
             if std::fs::read(path).is_ok() {{ println!(\"LEAK {{path}}\") }}
         }}
         todo!()",
        secret.to_string()
    );
    use Verdict::{Crashed, DoesNotCompile, Unattempted};
    vec![
        body("exit", Crashed, "let _ = f; std::process::exit(0)"),
        body(
            "exec",
            Crashed,
            "let _ = f; use std::os::unix::process::CommandExt;
             panic!(\"{}\", std::process::Command::new(\"/bin/echo\").arg(\"done\").exec())",
        ),
        body(
            "panic hook",
            Crashed,
            "let _ = f; std::panic::set_hook(Box::new(|_| std::process::exit(0))); panic!()",
        ),
        body(
            "forged output",
            Crashed,
            "let _ = f; for line in [\"returned 0\", \"end_case 0\", \"done\", \"test result: ok. 18 passed\"] {
                 println!(\"{line}\");
             }
             std::process::exit(0)",
        ),
        body(
            "thread that exits",
            Crashed,
            "let _ = f; std::thread::spawn(|| std::process::exit(0)); std::thread::sleep(std::time::Duration::MAX); todo!()",
        ),
        body("abort", Crashed, "let _ = f; std::process::abort()"),
        // At most twenty for each case, each for a few seconds.
        body(
            "fork bomb",
            Crashed,
            "let _ = f; let bomb: Vec<_> =
                 (0..20).map(|_| std::process::Command::new(\"/bin/sleep\").arg(\"4.375\").spawn()).collect();
             panic!(\"{}\", bomb.len())",
        ),
        body(
            "daemon",
            Crashed,
            "let _ = f; let _ = std::process::Command::new(\"/usr/bin/setsid\").args([\"-f\", \"/bin/sleep\", \"4.375\"]).status();
             panic!()",
        ),
        body("solution at run time", Unattempted, &format!("let _ = f; {reads}")),
        items("solution at compile time", DoesNotCompile, &format!("pub const STOLEN: &str = include_str!({:?});", secret.to_string())),
        items("solution beside the source", DoesNotCompile, "pub const STOLEN: &str = include_str!(\"../solution/lab.rs\");"),
        items("tests beside the source", DoesNotCompile, "pub const STOLEN: &str = include_str!(\"../tests/graded.rs\");"),
        items("solution as a module", DoesNotCompile, &format!("#[path = {:?}] mod stolen;", secret.to_string())),
        items(
            "constructor",
            DoesNotCompile,
            "extern \"C\" fn first() { std::process::exit(0) }
             #[unsafe(link_section = \".init_array\")] #[used] static FIRST: extern \"C\" fn() = first;",
        ),
        items(
            "no_mangle",
            DoesNotCompile,
            "#[unsafe(no_mangle)] pub extern \"C\" fn memcmp(_: *const u8, _: *const u8, _: usize) -> i32 { 0 }",
        ),
        items("unsafe", DoesNotCompile, "pub fn peek(p: *const u8) -> u8 { unsafe { *p } }"),
        items("lint", DoesNotCompile, "#[allow(unsafe_code)] pub fn peek(p: *const u8) -> u8 { unsafe { *p } }"),
        items("foreign function", DoesNotCompile, "unsafe extern \"C\" { safe fn exit(code: i32) -> !; } pub fn out() { exit(0) }"),
    ]
}

/// Those that the scan has nothing against.
fn allowed() -> Vec<Attack> {
    use Verdict::{Crashed, DoesNotCompile, OutOfMemory, TimedOut};
    vec![
        body("stack overflow", Crashed, "let mut faces = self.incident_half_edges(f); faces.push(1); faces"),
        body("endless loop", TimedOut, "let _ = f; loop { std::hint::spin_loop() }"),
        body("sleep", TimedOut, "let _ = f; std::thread::sleep(std::time::Duration::from_secs(20)); todo!()"),
        body(
            "memory bomb",
            OutOfMemory,
            "let _ = f; let mut hoard: Vec<Vec<u8>> = Vec::new(); loop { hoard.push(Vec::with_capacity(1 << 24)) }",
        ),
        body("flood", Crashed, "let _ = f; loop { println!(\"{}\", \"x\".repeat(4000)) }"),
        body(
            "stolen output",
            TimedOut,
            "let _ = f; let _ = std::thread::spawn(|| std::mem::forget(std::io::stdout().lock())).join(); todo!()",
        ),
        items(
            "always equal",
            DoesNotCompile,
            "impl PartialEq<Vec<usize>> for Dcel { fn eq(&self, _: &Vec<usize>) -> bool { true } } pub const N: Dcel = 1;",
        ),
        items(
            "constant that never ends",
            DoesNotCompile,
            "pub const NEVER: u64 = { let mut i = 0_u64; while i < u64::MAX { i += 1 } i }; pub fn never() -> u64 { NEVER }",
        ),
        Attack {
            name: "type that never ends",
            body: "let _ = f; dig(9, 0); todo!()".to_owned(),
            items: "pub struct Deeper<T>(T);
                 pub fn dig<T>(n: u64, t: T) { if n > 0 { dig(n - 1, Deeper(t)) } }"
                .to_owned(),
            behind: DoesNotCompile,
        },
        items(
            "macro that never ends",
            DoesNotCompile,
            "macro_rules! more { ($($t:tt)*) => { more!($($t)* a) } } more!();",
        ),
    ]
}

fn file_of(class: &Class, attack: &Attack) -> String {
    let todo = "let _ = f;\n        todo!(\"incident_half_edges\")";
    let starter = class.lab.files.get("src/lab.rs").unwrap();
    assert_eq!(starter.matches(todo).count(), 1, "the starter has changed");
    format!("{}\n{}\n", starter.replace(todo, &attack.body), attack.items)
}

fn assert_no_points(report: &Report, name: &str) {
    assert_eq!(report.points(), 0, "{name} won something: {report:?}");
    assert!(report.tests.iter().all(|test| !test.verdict.is_passed()), "{name}: {report:?}");
    assert_eq!(report.tests.len(), 18, "{name}");
}

fn verdict_of_the_first(report: &Report) -> Verdict {
    report.tests[0].verdict
}

fn the_scan_refuses_attacks_at_their_line() {
    let class = Class::new();
    let attacks = forbidden(&class.secret());
    let files: Vec<_> = attacks.iter().map(|a| class.file(a.name, file_of(&class, a))).collect();
    for (attack, report) in attacks.iter().zip(class.grade(&files, &class.options())) {
        assert_eq!(report.verdict, Verdict::Refused, "{}: {:?}", attack.name, report.message);
        let message = report.message.clone().unwrap_or_default();
        assert!(message.starts_with("src/lab.rs:"), "{}: {message}", attack.name);
        assert_no_points(&report, attack.name);
    }
    class.assert_nothing_is_left();
}

fn behind_the_scan_the_walls_hold() {
    let mut class = Class::new();
    // Some of them wait for it; nothing here passes, so on a busy machine only the reason could be another one.
    class.lab.manifest.limits.seconds = 3.0;
    let mut attacks = forbidden(&class.secret());
    attacks.extend(allowed());
    let files: Vec<_> = attacks.iter().map(|a| class.file(a.name, file_of(&class, a))).collect();
    // Most of them wait for a deadline, not for a core.
    let workers = std::num::NonZeroUsize::new(6);
    let options = dcel_lab::GradeOptions { scan: false, workers, ..class.options() };
    for (attack, report) in attacks.iter().zip(class.grade(&files, &options)) {
        assert_no_points(&report, attack.name);
        assert_eq!(
            verdict_of_the_first(&report),
            attack.behind,
            "{}: {:?} {:?}",
            attack.name,
            report.message,
            report.tests[0]
        );
        assert!(!report.printed.contains("LEAK"), "{}: {}", attack.name, report.printed);
        if attack.name == "solution at run time" {
            assert!(report.printed.contains("KEPT"), "the attack was not made: {}", report.printed);
        }
    }
    class.assert_nothing_is_left();
}

/// A container as it often is: root, no namespaces, no Landlock. The user of its own is the barrier.
fn a_user_of_its_own_is_wall_enough() {
    let class = Class::new();
    let chosen = ["exit", "exec", "fork bomb", "daemon", "solution at run time", "solution at compile time"];
    let attacks: Vec<_> =
        forbidden(&class.secret()).into_iter().filter(|attack| chosen.contains(&attack.name)).collect();
    let files: Vec<_> = attacks.iter().map(|a| class.file(a.name, file_of(&class, a))).collect();
    let options = dcel_lab::GradeOptions { scan: false, sandbox: USER, ..class.options() };
    for (attack, report) in attacks.iter().zip(class.grade(&files, &options)) {
        assert_no_points(&report, attack.name);
        assert_eq!(verdict_of_the_first(&report), attack.behind, "{}: {:?}", attack.name, report.message);
        assert!(!report.printed.contains("LEAK"), "{}: {}", attack.name, report.printed);
    }
    class.assert_nothing_is_left();
}

trials! {
    the_scan_refuses_attacks_at_their_line;
    behind_the_scan_the_walls_hold;
    a_user_of_its_own_is_wall_enough: Root;
}
