//! A number for the sources that the page is made of: it changes whenever one of them does.

use std::fs;
use std::path::{Path, PathBuf};

/// What the page is made of, relative to the repository.
const SOURCES: [&str; 6] = [
    "Cargo.toml",
    "src",
    "figures/playground/Cargo.toml",
    "figures/playground/Cargo.lock",
    "figures/playground/src",
    "figures/playground/page",
];
/// Packages of their own, which are not in the page.
const APART: [&str; 2] = ["src/cli", "src/lab"];
/// Made by the kit of its own sources, and read by students' folders alone.
const MADE: &str = "src/sources";

/// The stamp of the sources below a repository, as 16 hexadecimal digits.
///
/// Source: Fowler, Noll, Vo: FNV-1a with 64 bits.
pub(crate) fn stamp(repository: &Path) -> std::io::Result<String> {
    let mut files = Vec::new();
    for source in SOURCES {
        gather(repository, Path::new(source), &mut files)?;
    }
    files.sort();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut take = |bytes: &[u8]| {
        for &byte in bytes.iter().chain(&[0]) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for file in files {
        // The same on every system.
        take(file.to_string_lossy().replace('\\', "/").as_bytes());
        let text = fs::read(repository.join(&file))?;
        let lines: Vec<u8> = text.into_iter().filter(|&byte| byte != b'\r').collect();
        take(&lines);
    }
    Ok(format!("{hash:016x}"))
}

fn gather(repository: &Path, path: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    let full = repository.join(path);
    if !full.is_dir() {
        files.push(path.to_owned());
        return Ok(());
    }
    for entry in fs::read_dir(full)? {
        let inner = path.join(entry?.file_name());
        let name = inner.to_string_lossy().replace('\\', "/");
        let package = APART.contains(&name.as_str()) && repository.join(&inner).join("Cargo.toml").is_file();
        if !package && name != MADE {
            gather(repository, &inner, files)?;
        }
    }
    Ok(())
}
