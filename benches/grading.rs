//! Grading submissions to lab 04: how long one takes once the machine is warm, and a class of 200.
//!
//! `cargo bench --bench grading [-- submissions]`. The submissions are the solution and the bugs of the zoo, in turn,
//! each with a line of its own, so that no two files are equal and nothing comes from a cache. What is measured is the
//! time on the clock, since most of the work is done by other processes; the peer is the compiler alone.

use dcel_lab::{GradeOptions, Grader, Lab, Outcome, Plan, Submission, launched};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

const SOLUTION: &str = "solution/lab.rs";

/// The submissions, written into `folder`.
fn class(lab: &Lab, folder: &Path, size: usize) -> Vec<PathBuf> {
    let solution = lab.files.get(SOLUTION).expect("the lab has a solution");
    let bugs = lab.bugs.iter().map(|bug| bug.apply(solution).expect("every bug fits the solution"));
    let texts: Vec<String> = std::iter::once(solution.to_owned()).chain(bugs).collect();
    let write = |i: usize| {
        let path = folder.join(format!("student-{i:03}.rs"));
        std::fs::write(&path, format!("{}\n// Handed in by student {i}.\n", texts[i % texts.len()]))
            .expect("the folder can be written to");
        path
    };
    (0..size).map(write).collect()
}

/// The memory of this process in MB, as the system tells it; 0 where it does not.
fn megabytes() -> f64 {
    let pages = std::fs::read_to_string("/proc/self/statm").ok().and_then(|text| {
        let resident: f64 = text.split(' ').nth(1)?.parse().ok()?;
        Some(resident)
    });
    pages.unwrap_or(0.0) * 4096.0 / 1e6
}

fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}

/// The compiler on the solution and its driver, as it builds a submission, without walls and without grading.
fn compile(lab: &Lab, folder: &Path) -> f64 {
    for (name, text) in lab.files.iter().filter(|(name, _)| name.starts_with("src/")) {
        let text = if name == "src/lab.rs" { lab.files.get(SOLUTION).unwrap_or(text) } else { text };
        let path = folder.join(&name["src/".len()..]);
        std::fs::create_dir_all(path.parent().unwrap_or(folder)).expect("folders can be made");
        std::fs::write(path, text).expect("the folder can be written to");
    }
    let start = Instant::now();
    let done = Command::new("rustc")
        .args(["--edition", "2024", "main.rs"])
        .current_dir(folder)
        .output()
        .expect("rustc is installed");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    start.elapsed().as_secs_f64()
}

fn main() -> ExitCode {
    if let Some(code) = launched() {
        return code;
    }
    let size = std::env::args().skip(1).find_map(|word| word.parse().ok()).unwrap_or(200);
    // The solution and the known mistakes are only in a checkout.
    let lab = Lab::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../labs/04-half-edge"))
        .expect("lab 04 is beside this package");
    let folder = std::env::temp_dir().join(format!("dcel-kit-grading-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the submissions can be made");
    let compiled_here = folder.join("alone");
    std::fs::create_dir_all(&compiled_here).expect("a folder for the compiler can be made");
    let files = class(&lab, &folder, size);
    let submissions = Submission::class(&files, None).expect("the files can be read");
    let grader = Grader::new(lab.clone(), &GradeOptions::default()).expect("work folders can be made");
    let (stand, missing): (Vec<_>, Vec<_>) = grader.sandbox().iter().partition(|barrier| barrier.missing.is_none());
    println!("{} barriers stand, {} are missing", stand.len(), missing.len());
    let plan = Plan::with_seed(4);

    let (mut ours, mut alone) = (Vec::new(), Vec::new());
    for round in 0..8 {
        let start = Instant::now();
        let report = grader.grade(&submissions[0], &plan);
        let took = start.elapsed().as_secs_f64();
        assert_eq!(report.points(), report.max_points(), "the solution has all points");
        let compiled = compile(&lab, &compiled_here);
        if round > 0 {
            ours.push(took);
            alone.push(compiled);
        }
    }
    let (ours, alone) = (median(ours), median(alone));
    println!("one submission, warm: {ours:.2} s (goal 1.5); the compiler alone: {alone:.2} s; {:.2}x", ours / alone);

    let start = Instant::now();
    let mut done = 0;
    let outcome = grader.grade_all(&submissions, &plan, |_, _| {
        done += 1;
        if done % (size / 4).max(1) == 0 {
            println!("{done:4} graded, {:6.1} s, {:.1} MB", start.elapsed().as_secs_f64(), megabytes());
        }
    });
    assert!(matches!(outcome, Outcome::All), "the whole class is graded");
    let took = start.elapsed().as_secs_f64();
    println!("{size} submissions: {took:.0} s, {:.2} s each (goal: 200 in 300 s)", took / size as f64);
    // Nothing to be done if somebody else has cleaned up.
    let _ = std::fs::remove_dir_all(folder);
    ExitCode::SUCCESS
}
