//! A command that goes on until it is ended.

use super::Folder;
use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::time::{Duration, Instant};

/// What a watching command says, line by line as it comes.
pub(crate) struct Watched {
    child: std::process::Child,
    lines: std::sync::mpsc::Receiver<String>,
    /// Lines that came while others were waited for: what is said in two streams comes in any order.
    early: std::cell::RefCell<Vec<String>>,
}

impl Watched {
    pub(crate) fn start(shell: &Folder, arguments: &str) -> Self {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_dcel"))
            .args(arguments.split_whitespace())
            .current_dir(shell.path(""))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let (send, lines) = std::sync::mpsc::channel();
        let pipes: [Box<dyn std::io::Read + Send>; 2] =
            [Box::new(child.stdout.take().unwrap()), Box::new(child.stderr.take().unwrap())];
        for pipe in pipes {
            let send = send.clone();
            std::thread::spawn(move || {
                let mut lines = BufReader::new(pipe).lines().map_while(Result::ok);
                lines.try_for_each(|line| send.send(line))
            });
        }
        Self { child, lines, early: std::cell::RefCell::default() }
    }

    /// Waits for a line with these words; whether it came within the seconds. Each line is heard once.
    pub(crate) fn says(&self, words: &str, seconds: u64) -> bool {
        let mut early = self.early.borrow_mut();
        if let Some(i) = early.iter().position(|line| line.contains(words)) {
            early.remove(i);
            return true;
        }
        let end = Instant::now() + Duration::from_secs(seconds);
        while let Ok(line) = self.lines.recv_timeout(end.saturating_duration_since(Instant::now())) {
            if line.contains(words) {
                return true;
            }
            early.push(line);
        }
        false
    }

    /// Whether it says nothing of this kind for so long, from now on.
    pub(crate) fn is_silent(&self, words: &str, seconds: u64) -> bool {
        self.early.borrow_mut().clear();
        !self.says(words, seconds)
    }
}

impl Drop for Watched {
    fn drop(&mut self) {
        // It watches until it is ended.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
