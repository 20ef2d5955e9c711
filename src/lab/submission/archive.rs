//! Archives that were handed in: looked into, never unpacked.
//!
//! ```text
//!   .zip   .tar   .tar.gz   .tgz      only the files that can matter are kept, in memory, up to a length
//!   ../x   /x   an archive in it      refused: with its name
//! ```
//!
//! Nothing is written to the disk, so no entry can land anywhere. The number of entries, the length of each file
//! that is kept, and how much a compressed stream may unpack to are limited: a bomb costs a moment and no memory.

use super::parts::{Content, Kind, Part, is_passed_over, kind};
use flate2::read::GzDecoder;
use std::fs::File;
use std::io::{self, Cursor, Read, Seek};
use std::path::Path;

/// The most entries that are looked at.
const MOST_ENTRIES: usize = 20_000;
/// How much a compressed stream may unpack to, with all that is passed over in it.
const MOST_UNPACKED: u64 = 512 << 20;

/// Which files of an archive are kept.
pub(super) struct Keep<'a> {
    /// Up to which length, by the name of a file; `None` passes it over.
    pub(super) longest: &'a dyn Fn(&str) -> Option<u64>,
    /// How long all of them together may be.
    pub(super) together: u64,
}

/// The parts of an archive on the disk, or why it cannot be looked into.
pub(super) fn of_file(path: &Path, keep: &Keep) -> io::Result<Result<Vec<Part>, String>> {
    let file = File::open(path)?;
    Ok(read(file, kind(&path.to_string_lossy()), keep))
}

/// The parts of an archive in memory.
pub(super) fn of_bytes(bytes: &[u8], name: &str, keep: &Keep) -> Result<Vec<Part>, String> {
    read(Cursor::new(bytes), kind(name), keep)
}

fn read(from: impl Read + Seek, kind: Kind, keep: &Keep) -> Result<Vec<Part>, String> {
    match kind {
        Kind::Zip => read_zip(from, keep),
        Kind::Tar => read_tar(from, keep),
        Kind::TarGz => read_tar(GzDecoder::new(from), keep),
        Kind::Foreign | Kind::None => Err("this kind of archive is not opened; hand in a .zip or a .tar.gz".to_owned()),
    }
}

fn read_zip(from: impl Read + Seek, keep: &Keep) -> Result<Vec<Part>, String> {
    let mut zip = zip::ZipArchive::new(from).map_err(|error| format!("this is no whole zip archive: {error}"))?;
    if zip.len() > MOST_ENTRIES {
        return Err(too_many(zip.len()));
    }
    let mut parts = Vec::new();
    let mut left = keep.together;
    for i in 0..zip.len() {
        let cannot = |error: zip::result::ZipError| format!("entry {} cannot be read: {error}", i + 1);
        let (path, link, cap) = {
            let entry = zip.by_index_raw(i).map_err(cannot)?;
            let path = safe(&entry.name().map_err(cannot)?)?;
            if entry.is_dir() {
                continue;
            }
            let cap = kept(&path, keep);
            if cap.is_some() && entry.encrypted() {
                return Err(format!("`{path}` is encrypted; hand in an archive without a password"));
            }
            (path, entry.is_symlink(), cap)
        };
        if !link && cap.is_none() {
            continue;
        }
        let mut entry = zip.by_index(i).map_err(|error| format!("`{path}` cannot be unpacked: {error}"))?;
        let content = if link {
            let mut to = String::new();
            let _ = (&mut entry).take(1000).read_to_string(&mut to);
            Content::Link(to)
        } else {
            let size = entry.size();
            take(&mut entry, cap.unwrap_or_default(), size, &path, &mut left)?
        };
        parts.push(Part { path, content });
    }
    Ok(sorted(parts))
}

fn read_tar(from: impl Read, keep: &Keep) -> Result<Vec<Part>, String> {
    let not_whole = |error: io::Error| format!("this is no whole tar archive: {error}");
    let mut tar = tar::Archive::new(from.take(MOST_UNPACKED));
    let mut parts = Vec::new();
    let mut unpacked = 0;
    let mut left = keep.together;
    for (i, entry) in tar.entries().map_err(not_whole)?.enumerate() {
        if unpacked >= MOST_UNPACKED {
            return Err(too_long());
        }
        let mut entry = entry.map_err(not_whole)?;
        unpacked += entry.size();
        if i >= MOST_ENTRIES {
            return Err(too_many(i));
        }
        let path = safe(&String::from_utf8_lossy(&entry.path_bytes()))?;
        let kind = entry.header().entry_type();
        let content = if kind.is_symlink() || kind.is_hard_link() {
            Content::Link(entry.link_name_bytes().map_or_else(String::new, |to| String::from_utf8_lossy(&to).into()))
        } else if let Some(cap) = kept(&path, keep).filter(|_| kind.is_file()) {
            let size = entry.size();
            take(&mut entry, cap, size, &path, &mut left)?
        } else {
            continue;
        };
        parts.push(Part { path, content });
    }
    if unpacked >= MOST_UNPACKED {
        return Err(too_long());
    }
    Ok(sorted(parts))
}

fn too_many(entries: usize) -> String {
    format!("it has {entries} files and more; hand in yours alone, without `target`")
}

fn too_long() -> String {
    format!("it unpacks to more than {} MB; hand in your file alone, without `target`", MOST_UNPACKED >> 20)
}

/// The file's bytes, if there are no more than `cap`, whatever the archive says of its length.
fn take(entry: &mut impl Read, cap: u64, said: u64, path: &str, left: &mut u64) -> Result<Content, String> {
    if said > cap {
        return Ok(Content::TooLarge(said));
    }
    let mut bytes = Vec::new();
    let cannot = |error: io::Error| format!("`{path}` cannot be unpacked: {error}");
    entry.take(cap + 1).read_to_end(&mut bytes).map_err(cannot)?;
    *left = left.checked_sub(bytes.len() as u64).ok_or("it holds more of such files than anybody writes")?;
    Ok(if bytes.len() as u64 > cap { Content::TooLarge(bytes.len() as u64) } else { Content::Bytes(bytes) })
}

/// Up to which length a file is kept: not at all in folders that are passed over.
fn kept(path: &str, keep: &Keep) -> Option<u64> {
    let mut names: Vec<&str> = path.split('/').collect();
    let name = names.pop()?;
    let out_of_the_way = name.starts_with('.') || names.into_iter().any(is_passed_over);
    if out_of_the_way { None } else { (keep.longest)(name) }
}

/// The path of an entry, if it stays inside. Archives made on Windows may have `\`.
fn safe(path: &str) -> Result<String, String> {
    let path = path.replace('\\', "/");
    let drive = path.as_bytes().get(1) == Some(&b':');
    if path.starts_with('/') || drive || path.split('/').any(|part| part == "..") {
        return Err(format!("`{path}` lies outside of the archive; make it with the ordinary tools"));
    }
    Ok(path.split('/').filter(|part| !part.is_empty() && *part != ".").collect::<Vec<_>>().join("/"))
}

/// Those in fewer folders first, then in the order of names, as a walk through a folder finds them.
fn sorted(mut parts: Vec<Part>) -> Vec<Part> {
    parts.sort_by(|a, b| {
        let depth = |part: &Part| part.path.matches('/').count();
        depth(a).cmp(&depth(b)).then_with(|| a.path.cmp(&b.path))
    });
    parts
}
