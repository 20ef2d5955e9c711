//! Who is running: the table of processes, read from `/proc`.

use std::fs;

/// A line of the table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Process {
    pub(super) pid: i32,
    pub(super) parent: i32,
    /// The real user.
    pub(super) user: u32,
    pub(super) threads: u64,
    /// Ended, but nobody has asked how.
    pub(super) zombie: bool,
}

/// All processes that can be seen. One that ends while the table is read may be missing.
pub(super) fn processes() -> Vec<Process> {
    let Ok(entries) = fs::read_dir("/proc") else { return Vec::new() };
    let pids = entries.filter_map(|entry| entry.ok()?.file_name().to_str()?.parse().ok());
    pids.filter_map(process).collect()
}

fn process(pid: i32) -> Option<Process> {
    parse(pid, &fs::read_to_string(format!("/proc/{pid}/status")).ok()?)
}

/// The first number after a key. The name of a process cannot forge a line: line ends in it are escaped.
fn parse(pid: i32, status: &str) -> Option<Process> {
    let field = |key: &str| status.lines().find_map(|line| line.strip_prefix(key))?.split_whitespace().next();
    Some(Process {
        pid,
        parent: field("PPid:")?.parse().ok()?,
        user: field("Uid:")?.parse().ok()?,
        threads: field("Threads:").and_then(|n| n.parse().ok()).unwrap_or(1),
        zombie: field("State:")? == "Z",
    })
}

/// Those of them that come from `root`, however far down, without `root`.
pub(super) fn descendants(table: &[Process], root: i32) -> Vec<i32> {
    let mut found = vec![root];
    let mut next = 0;
    while next < found.len() {
        let parent = found[next];
        let children = table.iter().filter(|p| p.parent == parent && p.pid != parent).map(|p| p.pid);
        let new: Vec<i32> = children.filter(|pid| !found.contains(pid)).collect();
        found.extend(new);
        next += 1;
    }
    found.remove(0);
    found
}

/// When a process began, in the system's own count; nothing if it cannot be seen.
pub(super) fn start_of(pid: i32) -> Option<String> {
    let line = fs::read_to_string(format!("/proc/{pid}/stat")).ok()?;
    // The name in brackets may hold anything.
    line.rsplit(')').next()?.split_whitespace().nth(19).map(str::to_owned)
}

/// Whether a process runs that was called with this word.
pub(super) fn runs(word: &str) -> bool {
    let words = |pid: &Process| fs::read(format!("/proc/{}/cmdline", pid.pid)).unwrap_or_default();
    processes().iter().any(|process| words(process).split(|&byte| byte == 0).any(|part| part == word.as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};

    #[test]
    fn the_table_knows_this_process_and_its_children() {
        let own = i32::try_from(std::process::id()).unwrap();
        let word = format!("word-of-{own}");
        let mut command = Command::new("/bin/sh");
        let mut child = command.args(["-c", "read line", &word]).stdin(Stdio::piped()).spawn().unwrap();
        let pid = i32::try_from(child.id()).unwrap();
        let table = processes();
        let found = descendants(&table, own);
        assert!(start_of(pid).is_some_and(|start| start.parse::<u64>().is_ok()));
        // While a process becomes another program, there is a moment in which it was called with nothing.
        let begin = Instant::now();
        while !runs(&word) {
            assert!(begin.elapsed() < Duration::from_secs(20), "it is not seen");
            std::thread::sleep(Duration::from_millis(1));
        }
        assert!(!runs(&format!("{word}0")) && !runs(&word[.."word-of-".len()]), "a word is a whole one");
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(!runs(&word), "it is gone");
        assert!(found.contains(&pid) && !found.contains(&own), "{found:?}");
        assert!(table.iter().any(|p| p.pid == own && p.threads >= 1 && !p.zombie));
    }

    #[test]
    fn a_loop_in_a_changing_table_ends() {
        let row = |pid, parent| Process { pid, parent, user: 0, threads: 1, zombie: false };
        assert_eq!(descendants(&[row(1, 0), row(2, 3), row(3, 2), row(4, 3), row(5, 1)], 3), [2, 4]);
        assert_eq!(
            parse(7, "Name:\tx\\nUid: 0\nState:\tZ (zombie)\nPPid:\t3\nUid:\t5\t6\t7\t8\n").map(|p| p.user),
            Some(5)
        );
    }
}
