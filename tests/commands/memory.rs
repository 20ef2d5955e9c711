//! Promise: an input that needs more memory than there is ends with an error that says so and exit code 3, wherever the
//! memory runs out: never with an abort.
#![cfg(target_os = "linux")]

use crate::shell::{Folder, grid};
use std::fmt::Write as _;
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, Output};

/// Runs the command with so much address space, in KiB.
fn limited(folder: &Folder, call: &str, kib: u32) -> Output {
    let line = format!("ulimit -v {kib}; exec '{}' {call}", env!("CARGO_BIN_EXE_dcel"));
    // A backtrace would be the first to run out of memory, while it holds a lock.
    Command::new("bash")
        .args(["-c", &line])
        .env("RUST_BACKTRACE", "0")
        .current_dir(folder.path("."))
        .output()
        .expect("bash")
}

/// The least address space in which the call works, to 1 MiB.
fn least(folder: &Folder, call: &str) -> u32 {
    let works = |mib: u32| limited(folder, call, mib << 10).status.success();
    let (mut low, mut high) = (0, 1024);
    assert!(works(high), "{call}");
    while high - low > 1 {
        let middle = low.midpoint(high);
        *(if works(middle) { &mut high } else { &mut low }) = middle;
    }
    high
}

fn inputs() -> (Folder, Vec<String>) {
    const N: usize = 40_000;
    let folder = Folder::new();
    folder.write("tiny.obj", &grid(2));
    let (mut points, mut segments, mut rings) = (String::new(), String::new(), Vec::new());
    for i in 0..N {
        let (x, y) = (i % 300, i / 300);
        writeln!(points, "{x} {y}").expect("text");
        writeln!(segments, "{x} {y} {x} {}", y + 1).expect("text");
        if i % 4 == 0 {
            rings.push([[x, y], [x + 1, y], [x, y + 1], [x, y]]);
        }
    }
    folder.write("big.xy", &points);
    folder.write("big.segments", &segments);
    let polygon = |ring: &[[usize; 2]; 4]| format!(r#"{{"type":"Polygon","coordinates":[{ring:?}]}}"#);
    let list: Vec<String> = rings.iter().map(polygon).collect();
    folder.write("big.geojson", &format!(r#"{{"type":"GeometryCollection","geometries":[{}]}}"#, list.join(",")));
    let words = |ring: &[[usize; 2]; 4]| ring.map(|[x, y]| format!("{x} {y}")).join(",");
    let list: Vec<String> = rings.iter().map(|ring| format!("POLYGON(({}))", words(ring))).collect();
    folder.write("big.wkt", &format!("GEOMETRYCOLLECTION({})", list.join(",")));
    folder.write("big.obj", &grid(250));
    let calls = [
        "info big.geojson --trust",
        "info big.wkt --trust",
        "info big.obj --trust",
        "build big.segments -o out.dcel",
        "delaunay big.xy",
        "voronoi big.xy",
    ];
    (folder, calls.map(str::to_owned).to_vec())
}

#[test]
fn too_little_memory_is_an_error_wherever_it_runs_out() {
    let (folder, calls) = inputs();
    // What the program takes for itself, and some more for its first small lists.
    let base = least(&folder, "info tiny.obj") + 2;
    for call in &calls {
        let mut refused = 0;
        for step in 0..5 {
            let mib = base + step * step;
            let told = limited(&folder, call, mib << 10);
            let error = String::from_utf8_lossy(&told.stderr);
            assert_eq!(told.status.signal(), None, "{call} with {mib} MiB: {error}");
            if told.status.code() == Some(3) {
                refused += 1;
                assert!(error.contains("not enough memory"), "{call} with {mib} MiB: {error}");
                assert!(error.contains("help: "), "{call} with {mib} MiB: {error}");
            } else {
                assert!(matches!(told.status.code(), Some(0..=2)), "{call} with {mib} MiB: {error}");
            }
        }
        assert!(refused > 0, "{call} was never short of memory");
    }
}
