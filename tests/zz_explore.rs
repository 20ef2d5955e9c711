//! The engine of the labs against real programs and made-up ones: right verdicts, names and scripts.
#![cfg(feature = "lab")]

use dcel_kit::lab::{Bug, Driver, Lab, Limits, Plan, Report, Signatures, Verdict, grade_program, signature};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("labs/04-half-edge")
}

fn lab() -> Lab {
    Lab::read(&folder()).unwrap()
}

/// The driver with this text as the student's file.
fn build(dir: &Path, name: &str, source: &str) -> Driver {
    let dir = dir.join(name);
    fs::create_dir_all(&dir).unwrap();
    for file in fs::read_dir(folder().join("src")).unwrap() {
        let file = file.unwrap();
        fs::copy(file.path(), dir.join(file.file_name())).unwrap();
    }
    fs::write(dir.join("lab.rs"), source).unwrap();
    let driver = dir.join("driver");
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let arguments = ["--edition", "2024", "-A", "warnings", "main.rs", "-o"];
    let out = Command::new(rustc).args(arguments).arg(&driver).current_dir(&dir).output().unwrap();
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    Driver::new(driver, Limits { seconds: 5.0, ..Limits::default() })
}

fn solution() -> String {
    fs::read_to_string(folder().join("solution/lab.rs")).unwrap()
}

fn verdicts(report: &Report) -> Vec<(&str, Verdict)> {
    report.tests.iter().map(|test| (test.name.as_str(), test.verdict)).collect()
}

#[test]
fn explore() {
    let dir = tempfile::tempdir().unwrap();
    let lab = lab();
    let driver = build(dir.path(), "solution", &solution());
    let report = grade_program(&lab, &driver, &Plan::with_seed(1));
    println!("{:?} {} ms {}", verdicts(&report), report.millis, report.points());
    for t in &report.tests { if t.verdict != Verdict::Passed { println!("{} {} {:?} {:?}", t.name, t.message, t.findings, t.script); } }
    let driver = build(dir.path(), "starter", &fs::read_to_string(folder().join("src/lab.rs")).unwrap());
    let report = grade_program(&lab, &driver, &Plan::with_seed(1));
    println!("{:?} {} ms", verdicts(&report), report.millis);
    let zoo = std::env::var("ZOO").unwrap_or_default();
    let mut all = Vec::new();
    let mut paths: Vec<_> = fs::read_dir(&zoo).into_iter().flatten().map(|f| f.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        let bug = match Bug::parse(&fs::read_to_string(&path).unwrap(), "x") { Ok(b) => b, Err(e) => { println!("{path:?} {e}"); continue } };
        let source = match bug.apply(&solution()) { Ok(b) => b, Err(e) => { println!("{path:?} {e}"); continue } };
        let driver = build(dir.path(), &format!("bug{}", bug.number), &source);
        let t = std::time::Instant::now();
        let report = grade_program(&lab, &driver, &Plan::with_seed(1));
        println!("{} {} ({} ms, {:?})", bug.number, bug.title, report.millis, t.elapsed());
        for t in &report.tests {
            if t.verdict != Verdict::Passed && t.verdict != Verdict::Skipped {
                println!("    {} {} {}\n       {}", t.name, t.verdict, t.message, t.script.as_deref().unwrap_or("-").replace('\n', "; "));
            }
        }
        all.push((bug.number, signature(&lab, &driver)));
    }
    let s = Signatures::new(all.clone());
    for (n, sig) in &all {
        let same: Vec<u32> = all.iter().filter(|(m, other)| m != n && other == sig).map(|(m, _)| *m).collect();
        println!("{n} {sig:?} {}", if same.is_empty() { String::new() } else { format!("SAME AS {same:?}") });
    }
    let _ = s.to_text();
}
