//! The runner for the stable toolchain: replays the corpora, then mutates them for a while.
//!
//! ```text
//!   replay                     the corpora of all targets
//!   replay --seconds 30        and then 30 s of mutated inputs for each target, two targets at a time
//!   replay obj ply             these targets only
//!   replay --seed 7            another seed; it is printed, and the same seed gives the same inputs in the same order
//!   replay obj FILE            one input
//! ```
//!
//! Every target runs in a process of its own with 2 GiB of memory (where there is `sh`). A panic, an input that takes
//! more than ten seconds, and a process that dies are failures: the input is written to `failures/`, and the command
//! that repeats it is printed.

#![forbid(unsafe_code)]

mod mutate;

use mutate::{Random, mutant};
use std::collections::HashSet;
use std::fs;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use targets::{Outcome, TARGETS, Target, find};

/// An input that takes longer is a failure.
const PATIENCE: Duration = Duration::from_secs(10);
/// So much memory a process has, in KiB.
const MEMORY: usize = 2 << 20;
/// So long an input may become.
const LONGEST: usize = 1 << 14;
/// So many inputs are kept to be mutated.
const POOL: usize = 4000;

struct Asked {
    names: Vec<String>,
    files: Vec<PathBuf>,
    seconds: u64,
    seed: u64,
    jobs: usize,
    /// This process runs a target itself.
    inside: bool,
    /// Each input is written down before it is tried, up to this one: the last process died of it.
    careful: bool,
}

fn main() -> ExitCode {
    let asked = match read_arguments() {
        Ok(asked) => asked,
        Err(message) => {
            eprintln!("{message}");
            return ExitCode::from(2);
        }
    };
    let fine = if asked.inside || !asked.files.is_empty() {
        asked.names.iter().all(|name| find(name).is_some_and(|target| Runner { name, target, asked: &asked }.run()))
    } else {
        all(&asked)
    };
    if fine { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn read_arguments() -> Result<Asked, String> {
    let mut asked =
        Asked { names: Vec::new(), files: Vec::new(), seconds: 0, seed: 1, jobs: 2, inside: false, careful: false };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut number = || {
            let next = words.next().and_then(|word| word.parse::<u64>().ok());
            next.ok_or_else(|| format!("{word} needs a whole number, such as {word} 30"))
        };
        match word.as_str() {
            "--seconds" => asked.seconds = number()?,
            "--seed" => asked.seed = number()?,
            "--jobs" => asked.jobs = number()?.max(1) as usize,
            "--inside" => asked.inside = true,
            "--careful" => asked.careful = true,
            name if find(name).is_some() => asked.names.push(word),
            file if Path::new(file).is_file() => asked.files.push(PathBuf::from(file)),
            _ => {
                let known: Vec<&str> = TARGETS.iter().map(|(name, _)| *name).collect();
                return Err(format!("{word} is neither a target nor a file; the targets are {}", known.join(" ")));
            }
        }
    }
    if asked.names.is_empty() {
        if !asked.files.is_empty() {
            return Err("name the target before the file, such as: replay obj FILE".to_owned());
        }
        asked.names = TARGETS.iter().map(|(name, _)| (*name).to_owned()).collect();
    }
    Ok(asked)
}

fn home() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Runs every target in a process of its own, some at a time. Returns whether all is well.
fn all(asked: &Asked) -> bool {
    println!("seed {}, {} s a target, {} at a time", asked.seed, asked.seconds, asked.jobs);
    let next = AtomicUsize::new(0);
    let failed = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..asked.jobs {
            scope.spawn(|| {
                while let Some(name) = asked.names.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if !in_a_process(name, asked) {
                        failed.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push(name.clone());
                    }
                }
            });
        }
    });
    let failed = failed.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    if !failed.is_empty() {
        println!("failed: {}", failed.join(" "));
    }
    failed.is_empty()
}

/// Whether the target held. A process that died is tried again with care, to learn of which input.
fn in_a_process(name: &str, asked: &Asked) -> bool {
    let run = |careful: bool| {
        let me = std::env::current_exe().expect("this program has a path");
        let mut command = if cfg!(unix) {
            let mut command = Command::new("sh");
            command.arg("-c").arg(format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\"")).arg(me);
            command
        } else {
            Command::new(me)
        };
        command.args(["--inside", "--seed", &asked.seed.to_string(), "--seconds", &asked.seconds.to_string(), name]);
        if careful {
            command.arg("--careful");
        }
        let out = command.stderr(Stdio::inherit()).output();
        let out = out.unwrap_or_else(|error| panic!("{name} cannot be run: {error}"));
        print!("{}", String::from_utf8_lossy(&out.stdout));
        out.status
    };
    let status = run(false);
    match status.code() {
        Some(0) => true,
        Some(1) => false,
        _ => {
            println!("{name}: the process died ({status}); again, input by input");
            let _ = fs::remove_file(last_input(name));
            if run(true).success() {
                println!("{name}: it did not die again: was it stopped from outside?");
            } else {
                told(name, "it died", &fs::read(last_input(name)).unwrap_or_default());
            }
            false
        }
    }
}

fn last_input(name: &str) -> PathBuf {
    home().join("failures").join(format!("{name}-last"))
}

/// Writes a failing input down and says how to repeat it.
fn told(name: &str, why: &str, input: &[u8]) {
    let folder = home().join("failures");
    let file = folder.join(format!("{name}-{:016x}", Outcome::of(&String::from_utf8_lossy(input)).0));
    let written = fs::create_dir_all(&folder).and_then(|()| fs::write(&file, input));
    println!("{name}: {why}");
    match written {
        Ok(()) => {
            let shown = file.strip_prefix(home()).unwrap_or(&file).display();
            println!("  {} bytes: repeat it in tests/fuzz with\n  cargo run --release -- {name} {shown}", input.len());
        }
        Err(error) => println!("  it cannot be written to {}: {error}", file.display()),
    }
}

struct Runner<'a> {
    name: &'a str,
    target: Target,
    asked: &'a Asked,
}

/// What is being tried, for the thread that watches the time.
static TRIED: Mutex<Option<(Instant, Vec<u8>)>> = Mutex::new(None);

impl Runner<'_> {
    fn run(&self) -> bool {
        if !self.asked.files.is_empty() {
            // One input, with the panic as it comes.
            for file in &self.asked.files {
                let input = fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
                let begin = Instant::now();
                let outcome = (self.target)(&input);
                println!("{}: {}: {:?} in {:?}", self.name, file.display(), outcome, begin.elapsed());
            }
            return true;
        }
        std::panic::set_hook(Box::new(|_| ()));
        watch(self.name.to_owned());
        let (corpus, words) = (self.corpus(), self.words());
        if corpus.is_empty() {
            println!("{}: no corpus", self.name);
            return false;
        }
        let mut seen = HashSet::new();
        let mut fine = true;
        for input in &corpus {
            match self.holds(input) {
                Some(outcome) => drop(seen.insert(outcome)),
                None => fine = false,
            }
        }
        let (mut tried, begin) = (0_u64, Instant::now());
        let mut pool = corpus.clone();
        let mut random = Random::new(self.asked.seed);
        while fine && begin.elapsed() < Duration::from_secs(self.asked.seconds) {
            let input = mutant(&mut random, &pool, &words, LONGEST);
            tried += 1;
            match self.holds(&input) {
                Some(outcome) => {
                    if seen.insert(outcome) && pool.len() < POOL {
                        pool.push(input);
                    }
                }
                None => fine = false,
            }
        }
        println!("{}: {} of the corpus, {tried} mutated, {} outcomes", self.name, corpus.len(), seen.len());
        fine
    }

    /// What came of an input; nothing if it broke a promise.
    fn holds(&self, input: &[u8]) -> Option<Outcome> {
        if self.asked.careful {
            let _ = fs::create_dir_all(home().join("failures"));
            let _ = fs::write(last_input(self.name), input);
        }
        let set = |tried| *TRIED.lock().unwrap_or_else(std::sync::PoisonError::into_inner) = tried;
        set(Some((Instant::now(), input.to_vec())));
        let outcome = catch_unwind(AssertUnwindSafe(|| (self.target)(input)));
        set(None);
        outcome
            .map_err(|panic| {
                let words = panic.downcast_ref::<String>().map(String::as_str);
                let words = words.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("a panic");
                told(self.name, &words.chars().take(2000).collect::<String>(), input);
            })
            .ok()
    }

    /// The inputs that are kept, by name.
    fn corpus(&self) -> Vec<Vec<u8>> {
        let entries = fs::read_dir(home().join("corpus").join(self.name));
        let mut files: Vec<PathBuf> = entries.into_iter().flatten().flatten().map(|entry| entry.path()).collect();
        files.sort();
        files.iter().filter_map(|file| fs::read(file).ok()).collect()
    }

    /// The words of the dictionary, as libFuzzer has them: one a line in double quotes.
    fn words(&self) -> Vec<Vec<u8>> {
        let text = fs::read_to_string(home().join("words").join(format!("{}.dict", self.name))).unwrap_or_default();
        let inside = text.lines().filter_map(|line| line.trim().strip_prefix('"')?.strip_suffix('"'));
        inside
            .map(|word| word.replace("\\x0a", "\n").replace("\\\"", "\"").replace("\\\\", "\\").into_bytes())
            .collect()
    }
}

/// Ends the process if an input takes too long.
fn watch(name: String) {
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(Duration::from_millis(250));
            let tried = TRIED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            if let Some((_, input)) = tried.as_ref().filter(|(begin, _)| begin.elapsed() > PATIENCE) {
                told(&name, "it takes more than ten seconds", input);
                let _ = std::io::stdout().flush();
                std::process::exit(1);
            }
        }
    });
}
