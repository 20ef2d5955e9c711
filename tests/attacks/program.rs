//! A program that does what the word on its standard input says. Compiled by `sandbox.rs` and run in the sandbox.
//!
//! What it starts ends by itself after a few seconds, so that it does no harm even where a barrier is down.

use std::fs;
use std::hint::black_box;
use std::io::{Read, Write};
use std::process::{Command, Stdio};
use std::time::Duration;

fn main() {
    // Called by itself: stays as long as it is told.
    if let Some(seconds) = std::env::args().nth(1) {
        return std::thread::sleep(Duration::from_secs_f64(seconds.parse().expect("seconds")));
    }
    let mut input = String::new();
    std::io::stdin().read_to_string(&mut input).expect("text");
    let words: Vec<&str> = input.split_whitespace().collect();
    match words[..] {
        ["echo", word] => println!("{word}"),
        ["user"] => println!("{}", fs::read_to_string("/proc/self/status").expect("own status")),
        ["exit", code] => std::process::exit(code.parse().expect("a code")),
        ["abort"] => std::process::abort(),
        ["overflow"] => println!("{}", deeper(0)),
        ["loop"] => loop {
            black_box(0);
        },
        ["sleep"] => std::thread::sleep(Duration::from_secs(20)),
        ["memory"] => {
            let mut hoard = Vec::new();
            for _ in 0..64 {
                hoard.push(black_box(vec![1_u8; 64 << 20]));
            }
            println!("{}", hoard.len());
        }
        ["flood"] => {
            let line = [b'x'; 4096];
            while std::io::stdout().write_all(&line).is_ok() {}
        }
        ["read", path] => say(fs::read_to_string(path)),
        ["list", path] => say(fs::read_dir(path).map(Iterator::count)),
        ["write", path] => say(fs::write(path, [0; 100_000])),
        ["connect", address] => say(std::net::TcpStream::connect(address).map(drop)),
        ["run", program, ..] => {
            say(Command::new(program).args(&words[2..]).stdin(Stdio::null()).output().map(|out| out.status));
        }
        // The name of the process of this number.
        ["process", pid] => println!("{}", fs::read_to_string(format!("/proc/{pid}/comm")).unwrap_or_default()),
        // What this process was handed besides its streams: how many, and what is in the seventh.
        ["inherited"] => {
            let entries = fs::read_dir("/proc/self/fd").map(|all| all.filter_map(Result::ok).collect::<Vec<_>>());
            let links = entries.unwrap_or_default().into_iter().filter_map(|entry| fs::read_link(entry.path()).ok());
            let files = links.filter(|link| link.is_absolute() && !link.starts_with("/proc") && link.as_os_str() != "/dev/null");
            println!("{}", files.count());
            if let Ok(text) = fs::read_to_string("/proc/self/fd/7") {
                println!("{text}");
            }
        }
        // At most fifty, each for a few seconds.
        ["fork"] => {
            let born = (0..50).filter(|_| stay("4.125").is_ok()).count();
            println!("{born}");
        }
        ["open"] => {
            let files: Vec<_> = (0..500).map_while(|_| fs::File::open("/dev/null").ok()).collect();
            println!("{}", files.len());
        }
        // With the pipes in its hand, and in a session of its own where there is a program for that.
        ["daemon", seconds] => {
            let setsid = Command::new("/usr/bin/setsid").args(["-f", "/bin/sleep", seconds]).status();
            say(setsid.map(drop).or_else(|_| Command::new("/proc/self/exe").arg(seconds).spawn().map(drop)));
        }
        ["kill", pid] => say(Command::new("/bin/kill").args(["-9", pid]).status()),
        _ => panic!("what is {input:?}?"),
    }
}

fn stay(seconds: &str) -> std::io::Result<std::process::Child> {
    Command::new("/proc/self/exe").arg(seconds).stdin(Stdio::null()).stdout(Stdio::null()).spawn()
}

fn deeper(depth: u64) -> u64 {
    let here = black_box([depth; 64]);
    if black_box(depth) == u64::MAX { 0 } else { deeper(depth + 1) + here[3] }
}

fn say<T: std::fmt::Debug>(what: std::io::Result<T>) {
    match what {
        Ok(what) => println!("ok {what:?}"),
        Err(error) => println!("error {error}"),
    }
}
