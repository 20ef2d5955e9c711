//! A root folder of its own: a new file system that holds what a program may see, and nothing else.
//!
//! ```text
//!   /                 empty memory, read-only
//!   /lib  ─▶ usr/lib  links as outside
//!   /usr/lib          bound, read-only; what is hidden in it is covered
//!   /room/target      bound; may be written
//!   /proc             new, of this namespace of processes
//!   /etc/passwd       not there
//! ```
//!
//! Made by the first process of the namespaces, which has all rights in them; the program gets none of these, so it
//! cannot take anything away that is mounted here.

use super::spec::Files;
use nix::mount::{MntFlags, MsFlags, mount, umount2};
use nix::unistd::pivot_root;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs::{self, File};
use std::os::unix::ffi::OsStringExt;
use std::os::unix::fs::symlink;
use std::path::{Component, Path, PathBuf};

/// The system's own root, and the new one, while both are there.
const OLD: &str = "/old";
const NEW: &str = "/new";
/// A file with nothing in it, which covers hidden files.
const EMPTY: &str = "/empty";
/// Folders on which the work can be done: in these namespaces only, so whatever is in them stays.
const PLACES: [&str; 4] = ["/tmp", "/var/tmp", "/run", "/mnt"];
/// So many links in one path are followed.
const MOST_LINKS: usize = 40;

const NOTHING: Option<&str> = None;

/// What is done at a path.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Deed {
    Cover,
    Show,
    ShowToWrite,
}

/// Makes the root folder and goes there. What is not there, or cannot be reached by this user, is not shown.
pub(super) fn enter(files: &Files, hidden: &[PathBuf]) -> Result<(), String> {
    let parts = parts(files, hidden);
    let why = |error| format!("a root of its own: {error}");
    mount(NOTHING, "/", NOTHING, MsFlags::MS_REC | MsFlags::MS_PRIVATE, NOTHING).map_err(why)?;
    let place = PLACES.iter().map(Path::new).find(|place| place.is_dir()).ok_or("a root of its own: no /tmp")?;
    let plain = MsFlags::MS_NOSUID | MsFlags::MS_NODEV;
    mount(Some("tmpfs"), place, Some("tmpfs"), plain, Some("size=1m,mode=755")).map_err(why)?;
    let make = |name: &str| place.join(&name[1..]);
    let made = [OLD, NEW].iter().try_for_each(|name| fs::create_dir(make(name)));
    made.and_then(|()| File::create(make(EMPTY)).map(drop)).map_err(|error| format!("a root of its own: {error}"))?;
    pivot_root(place, &make(OLD)).map_err(why)?;
    go_to("/")?;
    mount(Some(NEW), NEW, NOTHING, MsFlags::MS_BIND, NOTHING).map_err(why)?;
    let mut written = Vec::new();
    for (_, deed, path) in &parts {
        match deed {
            Deed::Cover => cover(path).map_err(|error| format!("covering what is hidden: {error}"))?,
            Deed::Show | Deed::ShowToWrite => {
                let shown = show(path).map_err(|error| format!("showing {}: {error}", path.display()))?;
                written.extend(shown.filter(|_| *deed == Deed::ShowToWrite));
            }
        }
    }
    processes()?;
    seal(&written)?;
    umount2(OLD, MntFlags::MNT_DETACH).map_err(why)?;
    go_to(NEW)?;
    pivot_root(".", ".").map_err(why)?;
    umount2(".", MntFlags::MNT_DETACH).map_err(why)?;
    go_to("/")
}

fn go_to(folder: &str) -> Result<(), String> {
    std::env::set_current_dir(folder).map_err(|error| format!("a root of its own: {error}"))
}

/// All that is to be done, outer folders before what is in them; a path that is hidden and needed is shown.
fn parts(files: &Files, hidden: &[PathBuf]) -> BTreeSet<(PathBuf, Deed, PathBuf)> {
    let own = |path: &&PathBuf| !path.starts_with("/proc");
    let real = |path: &PathBuf| path.canonicalize().unwrap_or_else(|_| path.clone());
    let with = |deed| move |path: &PathBuf| (real(path), deed, path.clone());
    let shown = files.read.iter().chain(&files.run).filter(own).map(with(Deed::Show));
    let written = files.write.iter().filter(own).map(with(Deed::ShowToWrite));
    hidden.iter().map(with(Deed::Cover)).chain(shown).chain(written).collect()
}

/// Binds a path of the old root at the same place of the new one; where that is, without links.
fn show(path: &Path) -> std::io::Result<Option<PathBuf>> {
    let Some(real) = lay(path)? else { return Ok(None) };
    let (from, to) = (Path::new(OLD).join(&real), Path::new(NEW).join(&real));
    if to.symlink_metadata().is_err() {
        if from.is_dir() { fs::create_dir(&to)? } else { File::create(&to).map(drop)? }
    }
    mount(Some(&from), &to, NOTHING, MsFlags::MS_BIND | MsFlags::MS_REC, NOTHING)?;
    Ok(Some(to))
}

/// Makes the folders and links on the way to a path. The path without links, relative to the root; nothing if it
/// is not there or out of this user's reach.
fn lay(path: &Path) -> std::io::Result<Option<PathBuf>> {
    let parts = |path: &Path| -> Vec<OsString> {
        let named = |part: Component| match part {
            Component::Normal(name) => Some(name.to_owned()),
            Component::ParentDir => Some("..".into()),
            _ => None,
        };
        path.components().rev().filter_map(named).collect()
    };
    let (mut rest, mut at, mut links) = (parts(path), PathBuf::new(), 0);
    while let Some(part) = rest.pop() {
        if part == ".." {
            at.pop();
            continue;
        }
        let next = at.join(part);
        let (outside, inside) = (Path::new(OLD).join(&next), Path::new(NEW).join(&next));
        let Ok(data) = outside.symlink_metadata() else { return Ok(None) };
        let missing = inside.symlink_metadata().is_err();
        if data.is_symlink() {
            links += 1;
            let Ok(to) = fs::read_link(&outside) else { return Ok(None) };
            if links > MOST_LINKS {
                return Ok(None);
            }
            if missing {
                symlink(&to, &inside)?;
            }
            if to.is_absolute() {
                at = PathBuf::new();
            }
            rest.extend(parts(&to));
            continue;
        }
        if missing && !rest.is_empty() {
            fs::create_dir(&inside)?;
        }
        at = next;
    }
    Ok(Some(at))
}

/// Lays nothing over a path, if it can be seen at all.
fn cover(path: &Path) -> nix::Result<()> {
    let real = path.strip_prefix("/").unwrap_or(path);
    let inside = Path::new(NEW).join(real);
    match inside.symlink_metadata() {
        Err(_) => Ok(()),
        Ok(data) if data.is_dir() => {
            let flags = MsFlags::MS_NOSUID | MsFlags::MS_NODEV | MsFlags::MS_NOEXEC;
            mount(Some("tmpfs"), &inside, Some("tmpfs"), flags, Some("size=64k,mode=755"))
        }
        Ok(_) => mount(Some(EMPTY), &inside, NOTHING, MsFlags::MS_BIND, NOTHING),
    }
}

/// The table of processes: that of the namespace. Where the system does not allow a new one, the old one is taken,
/// and the trial from inside finds that other processes can be seen.
fn processes() -> Result<(), String> {
    let why = |error: String| format!("/proc: {error}");
    let place = Path::new(NEW).join("proc");
    fs::create_dir(&place).map_err(|error| why(error.to_string()))?;
    let flags = MsFlags::MS_NOSUID | MsFlags::MS_NODEV | MsFlags::MS_NOEXEC;
    mount(Some("proc"), &place, Some("proc"), flags, NOTHING)
        .or_else(|_| {
            let old = Path::new(OLD).join("proc");
            mount(Some(&old), &place, NOTHING, MsFlags::MS_BIND | MsFlags::MS_REC, NOTHING)
        })
        .map_err(|error| why(error.to_string()))?;
    // One more namespace of users is needed, for the program; it cannot make any of its own then. Where this cannot
    // be said, it can, and gains nothing by it.
    let _ = fs::write(place.join("sys/user/max_user_namespaces"), "1");
    Ok(())
}

/// Makes everything read-only that is not to be written.
fn seal(written: &[PathBuf]) -> Result<(), String> {
    let table = fs::read_to_string(Path::new(NEW).join("proc/self/mountinfo")).map_err(|e| format!("mounts: {e}"))?;
    let proc = Path::new(NEW).join("proc");
    for line in table.lines() {
        let Some((point, options)) = mount_point(line) else { continue };
        let open = point.starts_with(&proc) || written.iter().any(|place| point.starts_with(place));
        if !point.starts_with(NEW) || open || options.contains(MsFlags::MS_RDONLY) {
            continue;
        }
        let flags = options | MsFlags::MS_REMOUNT | MsFlags::MS_BIND | MsFlags::MS_RDONLY;
        mount(NOTHING, &point, NOTHING, flags, NOTHING)
            .map_err(|error| format!("{} cannot be made read-only: {error}", point.display()))?;
    }
    Ok(())
}

/// Where a line of `mountinfo` is mounted, and those of its flags that a remount must keep.
fn mount_point(line: &str) -> Option<(PathBuf, MsFlags)> {
    let mut fields = line.split(' ').skip(4);
    let point = PathBuf::from(OsString::from_vec(unescaped(fields.next()?)));
    let flag = |word: &str| match word {
        "ro" => MsFlags::MS_RDONLY,
        "nosuid" => MsFlags::MS_NOSUID,
        "nodev" => MsFlags::MS_NODEV,
        "noexec" => MsFlags::MS_NOEXEC,
        "noatime" => MsFlags::MS_NOATIME,
        "nodiratime" => MsFlags::MS_NODIRATIME,
        "relatime" => MsFlags::MS_RELATIME,
        _ => MsFlags::empty(),
    };
    Some((point, fields.next()?.split(',').map(flag).collect()))
}

/// Blanks, tabs, line ends and backslashes are written as three octal digits.
fn unescaped(text: &str) -> Vec<u8> {
    let bytes = text.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        let code = text.get(i + 1..i + 4).filter(|_| bytes[i] == b'\\').and_then(|c| u8::from_str_radix(c, 8).ok());
        out.push(code.unwrap_or(bytes[i]));
        i += if code.is_some() { 4 } else { 1 };
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_the_table_of_mounts_is_read() {
        let line = r"36 35 98:0 /mnt1 /new/a\040b\134 rw,nosuid,noatime master:1 - ext3 /dev/root rw,errors=continue";
        let (point, flags) = mount_point(line).unwrap();
        assert_eq!(point, Path::new(r"/new/a b\"));
        assert_eq!(flags, MsFlags::MS_NOSUID | MsFlags::MS_NOATIME);
        assert!(mount_point("36 35").is_none());
    }
}
