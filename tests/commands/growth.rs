//! Promise: what once grew with the square or the cube of an input is done at sizes at which the square would not be: the
//! limits are those of the operating system, several times what is needed.
#![cfg(target_os = "linux")]

use crate::shell::Folder;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::process::Command;

/// Runs the command with so many seconds of processor time and so much address space, in MiB; its answer.
fn within(folder: &Folder, seconds: u32, mib: u32, call: &str) -> String {
    let line = format!("ulimit -t {seconds} -v {}; exec '{}' {call}", mib << 10, env!("CARGO_BIN_EXE_dcel"));
    let told = Command::new("bash").args(["-c", &line]).current_dir(folder.path(".")).output().expect("bash");
    assert!(told.status.success(), "{call}: {}: {}", told.status, String::from_utf8_lossy(&told.stderr));
    String::from_utf8_lossy(&told.stdout).into_owned()
}

/// `cylinder.sh`: a solid with two faces of very many corners.
#[test]
fn cylinders_of_very_many_sides() {
    let folder = Folder::new();
    const N: usize = 60_000;
    within(&folder, 20, 2048, &format!("solid make cylinder {N} 1 -o cyl.off"));
    let info = within(&folder, 20, 2048, "solid info cyl.off");
    assert!(info.contains(&format!("{} vertices, {} edges, {} faces", 2 * N, 3 * N, N + 2)), "{info}");
    assert!(within(&folder, 20, 2048, "solid support cyl.off 1,2,3").contains('v'));
    within(&folder, 20, 2048, "solid figure cyl.off -o cyl.svg");
    assert!(folder.read("cyl.svg").contains("</svg>"));
}

/// One face: out along one arm, and back along the other.
fn spiral(corners: usize) -> String {
    let (mut text, half) = (String::new(), corners / 2);
    let arms = (0..half).map(|i| (i, 0.5)).chain((0..half).rev().map(|i| (i, 0.0)));
    for (i, off) in arms {
        // Turns lie 1 apart, and steps are of one length.
        let angle = (4.0 * i as f64 + 40.0).sqrt();
        let radius = angle / TAU + off;
        writeln!(text, "v {:?} {:?} 0", radius * angle.cos(), radius * angle.sin()).expect("text");
    }
    let all: Vec<String> = (1..=corners).map(|i| i.to_string()).collect();
    text + &format!("f {}\n", all.join(" "))
}

/// `ears_spiral.py`: most corners of a spiral are not convex for long, or hide others.
#[test]
fn ears_of_a_long_spiral() {
    let folder = Folder::new();
    const N: usize = 12_000;
    folder.write("spiral.obj", &spiral(N));
    within(&folder, 20, 2048, "triangulate --method ears spiral.obj -o ears.obj");
    assert_eq!(folder.read("ears.obj").lines().filter(|line| line.starts_with("f ")).count(), N - 2);
}

/// `cdt_spokes.sh`: one vertex with very many edges that all are kept.
#[test]
fn constrained_edges_round_one_hub() {
    let folder = Folder::new();
    const N: usize = 60_000;
    let mut text = String::new();
    for i in 0..N {
        let angle = TAU * i as f64 / N as f64;
        writeln!(text, "0 0 {:?} {:?}", 1e6 * angle.cos(), 1e6 * angle.sin()).expect("text");
    }
    folder.write("spokes.segments", &text);
    let told = within(&folder, 20, 2048, "delaunay --constrained spokes.segments --json");
    let told: serde_json::Value = serde_json::from_str(&told).expect("JSON");
    assert_eq!(told["vertices"], N + 1, "{told}");
}

/// `split_overlaps.sh`: segments from one point along one line; each lies in all longer ones.
#[test]
fn overlaps_along_one_line() {
    let folder = Folder::new();
    const N: usize = 20_000;
    let text: String = (1..=N).map(|i| format!("0 0 {i} 0\n")).collect();
    folder.write("overlap.segments", &text);
    let told = within(&folder, 20, 512, "build --split-crossings overlap.segments --json");
    let told: serde_json::Value = serde_json::from_str(&told).expect("JSON");
    assert_eq!((&told["vertices"], &told["edges"]), (&(N + 1).into(), &N.into()), "{told}");
}

/// The lines of a dual graph are as long as the faces are winding: past hundreds of megabytes they are refused.
#[test]
fn duals_of_winding_faces_are_refused_before_the_memory_is_full() {
    let folder = Folder::new();
    folder.write("spiral.obj", &spiral(600));
    within(&folder, 20, 1024, "figure --dual spiral.obj -o small.svg");
    folder.write("spiral.obj", &spiral(20_000));
    let line = "ulimit -t 60 -v 2097152; exec \"$0\" figure --dual spiral.obj -o large.svg";
    let mut command = Command::new("bash");
    let told = command.args(["-c", line, env!("CARGO_BIN_EXE_dcel")]).current_dir(folder.path(".")).output();
    let told = told.expect("bash");
    let why = String::from_utf8_lossy(&told.stderr);
    assert!(!told.status.success() && why.contains("bend more than 8388608 times"), "{}: {why}", told.status);
    assert!(why.contains("triangulate"), "{why}");
    assert!(!folder.path("large.svg").exists());
}
