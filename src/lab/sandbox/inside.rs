//! What a program can do from inside the sandbox: a small one that tries, in the place of the student's.
//!
//! ```text
//!   grader ──questions──▶ launcher ▸ barriers ▸ this ──answers──▶ grader: a barrier that was passed is not reported as one
//! ```

use super::processes::start_of;
use super::spec::{INSIDE, WORD};
use nix::sys::signal::kill;
use nix::unistd::{Pid, Uid, geteuid, setresuid, setsid};
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io::Read;
use std::net::{Ipv4Addr, TcpStream, UdpSocket};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::Duration;

/// How long what tries to stay would stay.
const STAY: Duration = Duration::from_secs(5);

/// What is to be tried.
#[derive(Clone, Default, Debug, Serialize, Deserialize)]
pub(super) struct Questions {
    /// Files to read, folders to list.
    pub(super) files: Vec<PathBuf>,
    /// A process of somebody else: its number, and when it began.
    pub(super) process: i32,
    pub(super) began: String,
    /// The namespaces of that process.
    pub(super) spaces: [String; 2],
    /// Doors of that process to the network.
    pub(super) tcp: u16,
    pub(super) udp: u16,
    /// The name of what tries to outlive the program.
    pub(super) token: String,
}

/// What succeeded.
#[derive(Clone, Default, Debug, Serialize, Deserialize)]
pub(super) struct Answers {
    /// The places of the files that could be read.
    pub(super) files: Vec<usize>,
    /// The process could be seen.
    pub(super) process: bool,
    /// It could have been sent a signal.
    pub(super) signal: bool,
    /// Its shared memory could be reached.
    pub(super) memory: bool,
    pub(super) tcp: bool,
    /// As whom all this was tried, and whether that user could become root or has rights of root.
    pub(super) user: u32,
    pub(super) root: bool,
    /// Something was started that tries to stay.
    pub(super) stays: bool,
}

/// Tries what standard input asks for. `stay`: tries to outlive its parent instead.
pub(super) fn answer(stay: bool) -> ExitCode {
    if stay {
        let _ = setsid();
        std::thread::sleep(STAY);
        return ExitCode::SUCCESS;
    }
    let mut text = String::new();
    let read = std::io::stdin().read_to_string(&mut text);
    let Ok(questions) = read.map_err(drop).and_then(|_| serde_json::from_str(&text).map_err(drop)) else {
        return ExitCode::from(2);
    };
    match serde_json::to_string(&answers(&questions)) {
        Ok(text) => println!("{text}"),
        Err(_) => return ExitCode::from(2),
    }
    ExitCode::SUCCESS
}

fn answers(questions: &Questions) -> Answers {
    let Questions { files, process, began, token, .. } = questions;
    let spaces = spaces();
    let same = |i: usize| spaces[i].is_empty() || spaces[i] == questions.spaces[i];
    let udp = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0));
    let _ = udp.and_then(|socket| socket.send_to(token.as_bytes(), (Ipv4Addr::LOCALHOST, questions.udp)));
    let daemon = Command::new("/proc/self/exe")
        .args([WORD, INSIDE, token])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    Answers {
        files: (0..files.len()).filter(|&i| reads(&files[i])).collect(),
        process: start_of(*process).is_some_and(|start| start == *began),
        // Elsewhere the number means another process.
        signal: same(0) && kill(Pid::from_raw(*process), None).is_ok(),
        memory: same(1),
        tcp: TcpStream::connect((Ipv4Addr::LOCALHOST, questions.tcp)).is_ok(),
        user: geteuid().as_raw(),
        root: has_rights() || (!geteuid().is_root() && becomes_root()),
        stays: daemon.is_ok(),
    }
}

/// Whether there is something to be read there. A cover is empty.
fn reads(path: &Path) -> bool {
    match fs::read_dir(path) {
        Ok(mut entries) => entries.next().is_some(),
        Err(_) => File::open(path).is_ok_and(|mut file| matches!(file.read(&mut [0]), Ok(1))),
    }
}

fn becomes_root() -> bool {
    let root = Uid::from_raw(0);
    setresuid(root, root, root).is_ok()
}

fn has_rights() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let rights = status.lines().find_map(|line| line.strip_prefix("CapEff:"));
    rights.is_some_and(|rights| rights.trim().bytes().any(|digit| digit != b'0'))
}

/// The namespaces of processes and of shared memory that this process is in; empty if it cannot be said.
pub(super) fn spaces() -> [String; 2] {
    ["pid", "ipc"].map(|name| {
        let link = fs::read_link(format!("/proc/self/ns/{name}"));
        link.map(|link| link.to_string_lossy().into_owned()).unwrap_or_default()
    })
}
