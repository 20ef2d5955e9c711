//! The kit beside the newest release of each peer: every program in a process of its own, one command for all.
//!
//! ```text
//!   main.rs    the table: runs the programs in turn, compares with goals.toml
//!   rows.rs    what is done, by whom            shapes.rs   polygons and points
//!   segments.rs surfaces.rs   more of it        native.rs   peers in C++, where they are installed
//! ```
//!
//! A row is run warm, with an allocator that keeps its memory, and cold, with the default one.

#[path = "../../src/inputs.rs"]
#[allow(dead_code)]
mod inputs;
mod native;
#[path = "../../ways/random.rs"]
mod random;
mod rows;
mod segments;
mod shapes;
mod surfaces;

use cpu_time::ProcessTime;
use native::{NATIVE, OURS};
use random::Random;
use rows::{ROWS, Row};
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::hint::black_box;
use std::process::{Command, ExitCode};

const HELP: &str = "\
The kit beside its peers: processor time, each program in a process of its own.

Usage: race [--rounds N] [--record] [PART]...

  PART        rows whose name contains this text; without any, all rows
  --rounds N  how often each program is started (7)
  --record    write down in goals.toml which goals are met now

Ends with 1 if a goal that was met before is missed by more than a quarter.";

/// The allocator keeps what it was given.
const WARM: &str = "glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=8294967296";
/// The two ways to run, warm and cold.
const MODES: [&str; 2] = ["warm", "cold"];
const GOALS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../goals.toml");
const LOCK: &str = include_str!("../Cargo.lock");
/// A goal that was met may be missed by so much before the command fails.
const MARGIN: f64 = 1.25;

/// All goals.
#[derive(Deserialize, Serialize)]
struct Goals {
    goal: Vec<Goal>,
}

/// How much of a peer's time we may take.
#[derive(Deserialize, Serialize)]
struct Goal {
    row: String,
    peer: String,
    share: f64,
    /// The ways to run in which it was met when it was last written down.
    met: Vec<String>,
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).filter(|arg| arg != "--bench").collect();
    match run(&args) {
        Ok(code) => code,
        Err(message) => {
            eprintln!("error: {message}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &[String]) -> Result<ExitCode, String> {
    if let [first, row, program] = args
        && first == "--one"
    {
        return one(row, program);
    }
    let (mut rounds, mut record, mut parts) = (7, false, Vec::new());
    let mut rest = args.iter();
    while let Some(arg) = rest.next() {
        match arg.as_str() {
            "--rounds" => {
                let number = rest.next().ok_or("--rounds takes a number")?;
                rounds = number.parse().ok().filter(|&n| n > 0).ok_or(format!("`{number}` is no number of rounds"))?;
            }
            "--record" => record = true,
            "--help" | "-h" => {
                println!("{HELP}");
                return Ok(ExitCode::SUCCESS);
            }
            flag if flag.starts_with('-') => return Err(format!("there is no option {flag}")),
            part => parts.push(part.to_owned()),
        }
    }
    let chosen: Vec<&Row> = ROWS
        .iter()
        .filter(|row| parts.is_empty() || parts.iter().any(|part| row.name.contains(part.as_str())))
        .collect();
    if chosen.is_empty() {
        let all: Vec<&str> = ROWS.iter().map(|row| row.name).collect();
        return Err(format!("no row is called so; there are: {}", all.join("; ")));
    }
    table(&chosen, rounds, record)
}

/// Runs one program of one row in this process, and prints nanoseconds an element: the median of three runs after a
/// first one.
fn one(row: &str, program: &str) -> Result<ExitCode, String> {
    let row = ROWS.iter().find(|known| known.name == row).ok_or("no such row")?;
    let program = row.programs.iter().find(|known| known.name == program).ok_or("no such program")?;
    let (elements, mut work) = (program.prepare)();
    drop(black_box(work()));
    let mut times = [0.0; 3].map(|_: f64| {
        let start = ProcessTime::now();
        let made = black_box(work());
        let time = start.elapsed().as_nanos() as f64 / elements as f64;
        drop(made);
        time
    });
    times.sort_by(f64::total_cmp);
    println!("{}", times[1]);
    Ok(ExitCode::SUCCESS)
}

/// One who takes part in a row.
struct Runner {
    name: &'static str,
    /// Its release, as far as it is known.
    version: String,
    /// Whether it is a peer.
    peer: bool,
    command: Command,
}

/// Those who take part, ours first; peers in C++ that are not installed are told.
fn runners(row: &Row) -> Result<Vec<Runner>, String> {
    let this = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut all = Vec::new();
    for program in row.programs {
        let mut command = Command::new(&this);
        command.args(["--one", row.name, program.name]);
        let version = version(program.package).to_owned();
        all.push(Runner { name: program.name, version, peer: program.package != "dcel-kit", command });
    }
    for native in NATIVE.iter().filter(|native| native.row == row.name) {
        match native.command() {
            Ok(command) => {
                let peer = native.name != OURS;
                all.push(Runner { name: native.name, version: native.version(), peer, command });
            }
            Err(_) => println!("  {:40} absent", native.name),
        }
    }
    Ok(all)
}

/// Nanoseconds an element, in a process of its own.
fn elsewhere(row: &str, runner: &mut Runner, mode: &str) -> Result<f64, String> {
    runner.command.env_remove("GLIBC_TUNABLES");
    if mode == "warm" {
        runner.command.env("GLIBC_TUNABLES", WARM);
    }
    let output = runner.command.output().map_err(|e| e.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout);
    let said = String::from_utf8_lossy(&output.stderr);
    text.trim().parse().map_err(|_| format!("{} on {row}: no time, but {}", runner.name, said.trim()))
}

fn table(rows: &[&Row], rounds: usize, record: bool) -> Result<ExitCode, String> {
    let text = std::fs::read_to_string(GOALS).map_err(|e| format!("{GOALS}: {e}"))?;
    let mut goals: Goals = toml::from_str(&text).map_err(|e| format!("{GOALS}: {e}"))?;
    let mut lost = Vec::new();
    println!("{:42} {:>9} {:>9}   ours / peer: warm, cold; goal", "ns an element (medians)", "warm", "cold");
    for row in rows {
        println!("{}", row.name);
        let mut runners = runners(row)?;
        if runners.is_empty() {
            continue;
        }
        // Programs and ways to run take turns, so that what else the machine does meets all of them.
        let mut times = vec![[const { Vec::new() }; 2]; runners.len()];
        for _ in 0..rounds {
            for (runner, times) in runners.iter_mut().zip(&mut times) {
                for (mode, times) in MODES.iter().zip(times) {
                    times.push(elsewhere(row.name, runner, mode)?);
                }
            }
        }
        let medians: Vec<[f64; 2]> = times.into_iter().map(|both| both.map(median)).collect();
        let ours = medians[0];
        for (runner, &[warm, cold]) in runners.iter().zip(&medians) {
            let mut line = format!("  {:40} {warm:9.1} {cold:9.1}", format!("{} {}", runner.name, runner.version));
            let shares = [ours[0] / warm, ours[1] / cold];
            if runner.peer {
                let _ = write!(line, "   {:.2}, {:.2}", shares[0], shares[1]);
            }
            let goal = goals.goal.iter_mut().find(|goal| goal.row == row.name && goal.peer == runner.name);
            if let Some(goal) = goal {
                let _ = write!(line, "; goal {}", goal.share);
                let mut met = Vec::new();
                for (mode, share) in MODES.iter().zip(shares) {
                    let _ = write!(line, ", {mode} {}", if share <= goal.share { "met" } else { "missed" });
                    if share <= goal.share {
                        met.push((*mode).to_owned());
                    }
                    if goal.met.iter().any(|before| before == mode) && share > goal.share * MARGIN {
                        let text = format!("{}, {mode}: {share:.2} of {}, goal {}", row.name, runner.name, goal.share);
                        lost.push(text);
                    }
                }
                goal.met = met;
            }
            println!("{line}");
        }
    }
    native::clear();
    if record {
        let head =
            text.lines().take_while(|line| line.starts_with('#')).fold(String::new(), |all, line| all + line + "\n");
        let goals = toml::to_string(&goals).map_err(|e| e.to_string())?;
        std::fs::write(GOALS, format!("{head}\n{goals}")).map_err(|e| format!("{GOALS}: {e}"))?;
    }
    lost.iter().for_each(|goal| println!("no longer met: {goal}"));
    Ok(if lost.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The release of a package that the lock file names; none for ours. Of several, of which other peers hold older ones, the
/// newest.
fn version(package: &str) -> &str {
    let name = format!("name = \"{package}\"\nversion = \"");
    match LOCK.rsplit_once(&name) {
        Some((_, rest)) if package != "dcel-kit" => rest.split('"').next().unwrap_or_default(),
        _ => "",
    }
}
