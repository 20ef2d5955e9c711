//! Build script: tells the tests whether the shared test data lies beside the project, and whether there is a
//! browser.
//!
//! Tests that need them are marked `#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]` and
//! `#[cfg_attr(not(chromium), ignore = "needs chromium")]`, so that they are listed as ignored, with the reason,
//! where these are absent. The browser is `$CHROMIUM`, else the first of a few names on the path; tests find its
//! path in `env!("CHROMIUM_PATH")`.

use std::path::{Path, PathBuf};

const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

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
}

fn browser() -> Option<PathBuf> {
    if let Some(path) = std::env::var_os("CHROMIUM") {
        return Some(PathBuf::from(path)).filter(|path| path.is_file());
    }
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let found = BROWSERS.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    cfg!(unix).then_some(found)?.find(|path| path.is_file())
}
