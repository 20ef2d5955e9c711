//! Build script of the tests: tells them whether the shared test data lies beside the checkout.
//!
//! Tests that need it are marked `#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]`, so that they are
//! listed as ignored, with the reason, where it is absent. What a test finds out when it runs is in `trials.rs`.

use std::path::PathBuf;

fn main() {
    // Asked now, not when this was compiled: a target folder may outlive the place of the checkout.
    let package = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let data = package.join("../../shared/data");
    println!("cargo::rustc-check-cfg=cfg(shared_data)");
    println!("cargo::rerun-if-changed=support/build.rs");
    if data.is_dir() {
        // Only where it exists: a path that does not would make every build start over.
        println!("cargo::rerun-if-changed={}", data.display());
        println!("cargo::rustc-cfg=shared_data");
    }
}
