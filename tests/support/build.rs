//! Build script: tells the tests whether the shared test data lies beside the project, and whether there is a
//! browser.
//!
//! Tests that need them are marked `#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]` and
//! `#[cfg_attr(not(chromium), ignore = "needs chromium")]`, so that they are listed as ignored, with the reason,
//! where these are absent. In the same way `root`, `namespaces` and `landlock` say which of the grader's walls this user
//! of this machine can have; a test of a wall never passes without trying it. The browser is `$CHROMIUM`, else the first of a few names on the path; tests find its
//! path in `env!("CHROMIUM_PATH")`.

use std::path::{Path, PathBuf};

const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/// The first Linux with Landlock.
const LANDLOCK: (u32, u32) = (5, 13);

fn main() {
    // Asked now, not when this was compiled: a target folder may outlive the place of the checkout.
    let package = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let data = package.join("../shared/data");
    println!("cargo::rustc-check-cfg=cfg(shared_data)");
    println!("cargo::rustc-check-cfg=cfg(chromium)");
    println!("cargo::rerun-if-changed=tests/support/build.rs");
    println!("cargo::rerun-if-env-changed=CHROMIUM");
    if data.is_dir() {
        // Only where it exists: a path that does not would make every build start over.
        println!("cargo::rerun-if-changed={}", data.display());
        println!("cargo::rustc-cfg=shared_data");
    }
    let browser = browser();
    println!("cargo::rustc-env=CHROMIUM_PATH={}", browser.as_deref().unwrap_or(Path::new("")).display());
    if browser.is_some() {
        println!("cargo::rustc-cfg=chromium");
    }
    for (name, there) in [("root", is_root()), ("namespaces", has_namespaces()), ("landlock", has_landlock())] {
        println!("cargo::rustc-check-cfg=cfg({name})");
        if there {
            println!("cargo::rustc-cfg={name}");
        }
    }
}

/// What a short program says, if it can be run.
fn said(program: &str, args: &[&str]) -> Option<String> {
    let out = std::process::Command::new(program).args(args).output().ok().filter(|out| out.status.success())?;
    String::from_utf8(out.stdout).ok()
}

fn is_root() -> bool {
    said("id", &["-u"]).is_some_and(|id| id.trim() == "0")
}

fn has_namespaces() -> bool {
    said("unshare", &["--user", "--map-root-user", "--mount", "--net", "--ipc", "--pid", "--fork", "true"]).is_some()
}

/// By the number of the system, unless it lists what it has switched on: where it is switched off without a word, the
/// tests fail.
fn has_landlock() -> bool {
    if let Ok(modules) = std::fs::read_to_string("/sys/kernel/security/lsm") {
        return modules.contains("landlock");
    }
    let release = std::fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    let mut numbers = release.split(|c: char| !c.is_ascii_digit()).filter_map(|part| part.parse().ok());
    (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0)) >= LANDLOCK
}

fn browser() -> Option<PathBuf> {
    if let Some(path) = std::env::var_os("CHROMIUM") {
        return Some(PathBuf::from(path)).filter(|path| path.is_file());
    }
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let found = BROWSERS.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    cfg!(unix).then_some(found)?.find(|path| path.is_file())
}
