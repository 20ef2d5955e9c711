//! Which files of the checkout a build with some features reads.
//!
//! ```text
//!   src/lib.rs ──mod──▶ src/figure/mod.rs ──mod──▶ src/figure/page.rs ──include_str!──▶ src/figure/page.css
//!        └── #[cfg(feature = "navmesh")] mod navmesh;      left out unless the feature is on
//! ```
//!
//! It reads the lines of our own sources, not Rust at large: one `mod name;` a line, its attributes on the lines before,
//! paths of `include_str!` and `include_bytes!` as literals.

use std::collections::BTreeSet;
use std::io;

/// The text of a file, by its path from the root of a checkout.
pub type Read<'a> = &'a dyn Fn(&str) -> io::Result<String>;

/// The files, as paths from the root of the checkout with `/`, that the crate at `entry` is built from.
///
/// # Errors
/// A file that cannot be read, or a module without a file.
pub(super) fn files_of_build(read: Read, entry: &str, features: &[&str]) -> io::Result<BTreeSet<String>> {
    let mut files = BTreeSet::new();
    let mut open = vec![entry.to_owned()];
    while let Some(path) = open.pop() {
        if files.contains(&path) {
            continue;
        }
        let text = read(&path).map_err(|error| io::Error::other(format!("{path}: {error}")))?;
        for needed in needs(&text, features) {
            match needed {
                Needed::Module(name) => open.push(file_of(read, &path, name)?),
                Needed::Text(relative) => {
                    files.insert(joined(&path, relative));
                }
            }
        }
        files.insert(path);
    }
    Ok(files)
}

/// What a source names.
enum Needed<'a> {
    Module(&'a str),
    /// A file that is included, seen from the folder of the source.
    Text(&'a str),
}

fn needs<'a>(text: &'a str, features: &[&str]) -> Vec<Needed<'a>> {
    let mut found = Vec::new();
    // Whether the attributes so far switch off what follows them.
    let mut off = false;
    for line in text.lines().map(str::trim) {
        if line.starts_with("#[cfg(") {
            off |= is_off(line, features);
            continue;
        }
        if !off && !line.starts_with("//") {
            for start in ["include_str!(\"", "include_bytes!(\""] {
                let included = line.split(start).skip(1).filter_map(|rest| rest.split('"').next());
                found.extend(included.map(Needed::Text));
            }
            let module = line.strip_suffix(';').and_then(|line| line.rsplit_once("mod "));
            let is_module = |(before, name): &(&str, &str)| {
                let before = before.trim();
                (before.is_empty() || before.starts_with("pub"))
                    && name.bytes().all(|b| b == b'_' || b.is_ascii_alphanumeric())
            };
            found.extend(module.filter(is_module).map(|(_, name)| Needed::Module(name)));
        }
        off &= line.starts_with("#[") || line.starts_with("//");
    }
    found
}

/// Whether a `cfg` leaves out what follows: tests, and features none of which is on.
fn is_off(attribute: &str, features: &[&str]) -> bool {
    let mut named = attribute.split("feature = \"").skip(1).filter_map(|rest| rest.split('"').next()).peekable();
    match named.peek() {
        Some(_) => !named.any(|feature| features.contains(&feature)),
        None => attribute.contains("test)"),
    }
}

/// The file of a module that the source at `path` declares.
fn file_of(read: Read, path: &str, module: &str) -> io::Result<String> {
    let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
    let folder = match file {
        "lib.rs" | "main.rs" | "mod.rs" => folder.to_owned(),
        file => format!("{folder}/{}", file.trim_end_matches(".rs")),
    };
    let places = [format!("{folder}/{module}.rs"), format!("{folder}/{module}/mod.rs")];
    let found = places.into_iter().find(|place| read(place).is_ok());
    found.ok_or_else(|| io::Error::other(format!("{path}: the module `{module}` has no file")))
}

/// A path that is seen from the folder of the file at `from`, seen from the root.
fn joined(from: &str, relative: &str) -> String {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in relative.split('/') {
        match part {
            ".." => drop(parts.pop()),
            "." => {}
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_and_texts_are_found_by_their_features() {
        let text = "//! mod not;\n#![doc = include_str!(\"../figures/a.svg\")]\nmod a;\npub mod b;\n#[cfg(feature = \"io\")]\n\
            pub(crate) mod c;\n#[cfg(feature = \"png\")]\n#[allow(x)]\nmod d;\n#[cfg(test)]\nmod e;\nmod f { }\n\
            #[cfg(doctest)]\n#[doc = include_str!(\"../README.md\")]\nstruct Readme;\nlet mod_x = include_bytes!(\"x.bin\");\n\
            let two = [include_str!(\"y\"), include_str!(\"z\")];\n";
        let names = |features: &[&str]| -> Vec<String> {
            let word = |needed| match needed {
                Needed::Module(name) => format!("mod {name}"),
                Needed::Text(path) => path.to_owned(),
            };
            needs(text, features).into_iter().map(word).collect()
        };
        assert_eq!(names(&["io"]), ["../figures/a.svg", "mod a", "mod b", "mod c", "x.bin", "y", "z"]);
        assert_eq!(names(&[]), ["../figures/a.svg", "mod a", "mod b", "x.bin", "y", "z"]);
        assert_eq!(joined("src/plane/seed.rs", "../../figures/x"), "figures/x");
    }
}
