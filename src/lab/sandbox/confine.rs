//! The barriers themselves: what a step of the launcher does to itself. All of it lasts, and is handed down.

use super::Limits;
use super::spec::Files;
use landlock::{
    ABI, Access, AccessFs, AccessNet, CompatLevel, Compatible, PathBeneath, PathFd, Ruleset, RulesetAttr,
    RulesetCreatedAttr, RulesetStatus, Scope,
};
use nix::sched::{CloneFlags, unshare};
use nix::sys::prctl;
use nix::sys::resource::{Resource, getrlimit, setrlimit};
use nix::unistd::{Gid, Uid, close, getegid, geteuid, setgroups, setresgid, setresuid};
use std::fs;
use std::path::{Path, PathBuf};

/// Becomes a user who owns nothing. There is no way back.
pub(super) fn become_user(user: u32) -> Result<(), String> {
    let why = |error| format!("user {user}: {error}");
    let (uid, gid) = (Uid::from_raw(user), Gid::from_raw(user));
    setgroups(&[]).map_err(why)?;
    setresgid(gid, gid, gid).map_err(why)?;
    setresuid(uid, uid, uid).map_err(why)?;
    if geteuid() != uid || setresuid(Uid::from_raw(0), Uid::from_raw(0), Uid::from_raw(0)).is_ok() {
        return Err(format!("user {user} could become root again"));
    }
    // The change made this process opaque, to itself as well: it could not write its own uid_map.
    prctl::set_dumpable(true).map_err(why)
}

/// Closes whatever this process was handed but its standard streams: a file that is open needs no leave to be read.
pub(super) fn close_inherited() {
    let numbers = |folder: &str| -> Option<Vec<i32>> {
        let entries = fs::read_dir(folder).ok()?;
        Some(entries.filter_map(|entry| entry.ok()?.file_name().to_str()?.parse().ok()).collect())
    };
    let most = getrlimit(Resource::RLIMIT_NOFILE).map_or(1024, |(soft, _)| soft.min(1 << 16)) as i32;
    let open = numbers("/proc/self/fd").or_else(|| numbers("/dev/fd")).unwrap_or_else(|| (0..most).collect());
    for number in open.into_iter().filter(|&number| number > 2) {
        // One of them was the folder that has just been read.
        let _ = close(number);
    }
}

/// Enters namespaces of its own: no network, no shared memory, and for the next process that is started its own
/// processes. Has all rights in them, for the root folder that the next process makes.
pub(super) fn enter_namespaces() -> Result<(), String> {
    let (uid, gid) = (geteuid(), getegid());
    let all = CloneFlags::CLONE_NEWUSER
        | CloneFlags::CLONE_NEWPID
        | CloneFlags::CLONE_NEWNET
        | CloneFlags::CLONE_NEWIPC
        | CloneFlags::CLONE_NEWNS;
    unshare(all).map_err(|e| format!("unshare: {e}"))?;
    map_user(0, uid.as_raw(), gid.as_raw())
}

/// Gives up all rights in the namespaces: in one more of users it is a user without any, and what was mounted cannot
/// be taken away from there.
pub(super) fn leave_rights(inside: u32) -> Result<(), String> {
    unshare(CloneFlags::CLONE_NEWUSER).map_err(|e| format!("unshare: {e}"))?;
    map_user(inside, 0, 0)
}

fn map_user(inside: u32, uid: u32, gid: u32) -> Result<(), String> {
    let write = |name: &str, text: String| fs::write(name, text).map_err(|e| format!("{name}: {e}"));
    write("/proc/self/uid_map", format!("{inside} {uid} 1"))?;
    write("/proc/self/setgroups", "deny".to_owned())?;
    write("/proc/self/gid_map", format!("{inside} {gid} 1"))
}

/// Sees these files only; opens no TCP connection; sends signals and abstract sockets to its own kind only. The last
/// two where the kernel knows them.
pub(super) fn only_files(files: &Files) -> Result<(), String> {
    let why = |error: landlock::RulesetError| format!("files: {error}");
    let abi = ABI::V6;
    let mut rules = Ruleset::default()
        .set_compatibility(CompatLevel::HardRequirement)
        .handle_access(AccessFs::from_all(ABI::V1))
        .map_err(why)?
        .set_compatibility(CompatLevel::BestEffort)
        .handle_access(AccessFs::from_all(abi))
        .map_err(why)?
        .handle_access(AccessNet::from_all(abi))
        .map_err(why)?
        .scope(Scope::from_all(abi))
        .map_err(why)?
        .create()
        .map_err(why)?;
    let read = AccessFs::ReadFile | AccessFs::ReadDir;
    let kinds = [(&files.read, read), (&files.run, read | AccessFs::Execute), (&files.write, AccessFs::from_all(abi))];
    for (paths, access) in kinds {
        for path in paths {
            // A path that is not there needs no leave.
            let Ok(fd) = PathFd::new(path) else { continue };
            let access = if path.is_dir() { access } else { access & AccessFs::from_file(abi) };
            rules = rules.add_rule(PathBeneath::new(fd, access)).map_err(why)?;
        }
    }
    match rules.restrict_self().map_err(why)?.ruleset {
        RulesetStatus::NotEnforced => Err("files: the kernel does not know Landlock".to_owned()),
        _ => Ok(()),
    }
}

/// Sets the system's limits; no process can raise them again.
pub(super) fn limits(limits: &Limits) -> Result<(), String> {
    // One second more kills for good: the first signal can be caught.
    let processor = (Resource::RLIMIT_CPU, limits.cpu_seconds, limits.cpu_seconds.saturating_add(1));
    let rest = [
        (Resource::RLIMIT_AS, limits.memory_mb << 20),
        (Resource::RLIMIT_FSIZE, limits.file_kb << 10),
        (Resource::RLIMIT_NOFILE, limits.files),
        (Resource::RLIMIT_NPROC, limits.processes),
        (Resource::RLIMIT_STACK, 8 << 20),
        (Resource::RLIMIT_CORE, 0),
        (Resource::RLIMIT_MEMLOCK, 0),
        (Resource::RLIMIT_MSGQUEUE, 0),
    ];
    let rest = rest.map(|(what, value)| (what, value, value));
    for (what, soft, hard) in std::iter::once(processor).chain(rest) {
        let (_, most) = getrlimit(what).map_err(|e| format!("{what:?}: {e}"))?;
        setrlimit(what, soft.min(most), hard.min(most)).map_err(|e| format!("{what:?}: {e}"))?;
    }
    Ok(())
}

/// The programs that load programs: without leave to run them nothing starts.
pub(super) fn loaders() -> Vec<PathBuf> {
    let folders = ["/lib64", "/lib"].map(Path::new);
    let entries = folders.iter().filter_map(|folder| fs::read_dir(folder).ok()).flatten();
    let named = entries.filter_map(Result::ok).filter(|e| e.file_name().as_encoded_bytes().starts_with(b"ld-"));
    named.map(|entry| entry.path()).collect()
}
