//! Builds the playground: one page with the kit as WebAssembly inside, from the sources beside it.
//!
//! ```text
//!   cargo build (wasm32) ──▶ bindings ──▶ gzip ──▶ base64 ─┐
//!   page/playground.html, .css, .js ──────────────────────────────────────┼──▶ figures/playground.html
//!   stamp.rs: a number for all sources ───────────────────────────────────┘
//! ```
//!
//! `cargo run --manifest-path figures/playground/builder/Cargo.toml`, anywhere in the repository; with `-- --check` nothing
//! is written, and the exit code says whether the page's stamp is that of the sources.
//!
//! `wasm-opt` is left out: it makes the page 2 % smaller, and version 108 of it, which Debian has, breaks the module.

mod stamp;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use wasm_bindgen_cli_support::Bindgen;

/// Where the page lies: for people, and for the command.
const PAGE: &str = "figures/playground.html";
const TARGET: &str = "wasm32-unknown-unknown";
/// The page must stay below this.
const LARGEST: usize = 1_200_000;

fn main() -> Result<(), Box<dyn Error>> {
    let repository = repository()?;
    let stamp = stamp::stamp(&repository)?;
    if std::env::args().any(|argument| argument == "--check") {
        let page = fs::read_to_string(repository.join(PAGE));
        let known = page.is_ok_and(|text| text.contains(&format!("content=\"{stamp}\"")));
        println!("sources {stamp}: the page is {}", if known { "current" } else { "older" });
        std::process::exit(i32::from(!known));
    }
    let (wasm, bindings) = module(&repository)?;
    let page = page(&repository, &wasm, &bindings, &stamp)?;
    println!("wasm {} bytes, page {} bytes", wasm.len(), page.len());
    if page.len() > LARGEST {
        return Err(format!("the page has {} bytes, more than {LARGEST}", page.len()).into());
    }
    Ok(fs::write(repository.join(PAGE), &page)?)
}

/// The folder that holds `figures/playground`, from the working directory upwards.
fn repository() -> Result<PathBuf, Box<dyn Error>> {
    let here = std::env::current_dir()?;
    let found = here.ancestors().find(|folder| folder.join("figures/playground/Cargo.toml").is_file());
    Ok(found.ok_or("call this in the repository of dcel-kit")?.to_owned())
}

/// The module, with the script that calls it.
fn module(repository: &Path) -> Result<(Vec<u8>, String), Box<dyn Error>> {
    let folder = repository.join("figures/playground");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--release", "--locked", "--target", TARGET])
        .current_dir(&folder)
        .env("CARGO_TARGET_DIR", folder.join("target"))
        // Places of this machine are no part of the page.
        .env(
            "RUSTFLAGS",
            format!("--remap-path-prefix={}=/kit --remap-path-prefix={}=/crates", repository.display(), crates()),
        )
        .status()?;
    if !built.success() {
        return Err(format!("cargo could not build it: is the target there? `rustup target add {TARGET}`").into());
    }
    let raw = folder.join("target").join(TARGET).join("release/dcel_playground.wasm");
    let mut bindgen = Bindgen::new();
    bindgen.input_path(raw).no_modules(true)?.typescript(false);
    bindgen.remove_name_section(true).remove_producers_section(true);
    let mut output = bindgen.generate_output()?;
    let bindings = output.js().to_owned();
    Ok((output.wasm_mut().emit_wasm(), bindings))
}

/// Where cargo keeps what it has unpacked.
fn crates() -> String {
    let home = std::env::var("CARGO_HOME").or_else(|_| std::env::var("HOME").map(|home| format!("{home}/.cargo")));
    format!("{}/registry/src", home.unwrap_or_else(|_| "/nowhere".to_owned()))
}

fn page(repository: &Path, wasm: &[u8], bindings: &str, stamp: &str) -> Result<String, Box<dyn Error>> {
    let read = |name: &str| fs::read_to_string(repository.join("figures/playground/page").join(name));
    let [html, css, js] = ["playground.html", "playground.css", "playground.js"].map(read);
    let (html, css, js) = (html?, css?, js?);
    // Nothing in a script element may end it.
    if [bindings, &js].iter().any(|script| script.contains("</script")) {
        return Err("a script holds </script".into());
    }
    let page = html
        .replace("/*CSS*/", &css)
        .replace("@@STAMP@@", stamp)
        .replace("/*BINDINGS*/", bindings)
        .replace("/*SCRIPT*/", &js)
        .replace("@@WASM@@", &base64(&gzip(wasm)?));
    Ok(page)
}

/// A gzip file without name and time.
fn gzip(bytes: &[u8]) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut out = Vec::new();
    zopfli::compress(zopfli::Options::default(), zopfli::Format::Gzip, bytes, &mut out)?;
    Ok(out)
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let number = chunk.iter().enumerate().fold(0_u32, |sum, (i, &byte)| sum | u32::from(byte) << (16 - 8 * i));
        for i in 0..4 {
            out.push(if i <= chunk.len() { char::from(LETTERS[(number >> (18 - 6 * i)) as usize & 63]) } else { '=' });
        }
    }
    out
}
