//! Build script: tells the tests whether the shared test data lies beside the project.
//!
//! Tests that need it are marked `#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]`, so that they
//! are listed as ignored, with the reason, where it is absent.

use std::path::Path;

fn main() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    println!("cargo::rustc-check-cfg=cfg(shared_data)");
    println!("cargo::rerun-if-changed=tests/support/build.rs");
    println!("cargo::rerun-if-changed={}", data.display());
    if data.is_dir() {
        println!("cargo::rustc-cfg=shared_data");
    }
}
