//! Shared by the benchmarks: inputs, and measuring several programs against each other in one run.

mod inputs;

use cpu_time::ProcessTime;
use std::hint::black_box;

pub use dcel_kit_ways::{Random, maps};
pub use inputs::{Triangles, delaunay, ordered, shuffled, three_orders};

/// What a program made: handed back so that dropping it is not measured.
pub type Made = Box<dyn std::any::Any>;

/// One program under measurement: its name, and a function that prepares a run.
pub type Program<'a> = (&'a str, Box<dyn FnMut() -> Run<'a> + 'a>);

/// One run; only this is measured.
pub type Run<'a> = Box<dyn FnOnce() -> Made + 'a>;

/// A program without preparation.
pub fn program<'a, T: 'static>(name: &'a str, run: impl Fn() -> T + Clone + 'a) -> Program<'a> {
    (
        name,
        Box::new(move || {
            let run = run.clone();
            Box::new(move || Box::new(run()))
        }),
    )
}

/// Runs all programs in turn, `rounds` times, and returns the median nanoseconds of each, divided by `elements`.
/// What is measured is processor time of this process, so that others on the machine disturb it less.
pub fn compare(programs: &mut [Program<'_>], rounds: usize, elements: usize) -> Vec<f64> {
    let mut times = vec![Vec::new(); programs.len()];
    for round in 0..=rounds {
        for (program, times) in programs.iter_mut().zip(&mut times) {
            let run = program.1();
            let start = ProcessTime::now();
            let made = black_box(run());
            let time = start.elapsed().as_nanos() as f64;
            drop(made);
            if round > 0 {
                times.push(time / elements as f64);
            }
        }
    }
    times
        .into_iter()
        .map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect()
}

/// Prints a table: nanoseconds, and how many times as long as the first program each takes.
pub fn print(title: &str, programs: &[Program<'_>], ns: &[f64]) {
    println!("{title}");
    for ((name, _), time) in programs.iter().zip(ns) {
        println!("  {name:25} {time:8.2}   {:6.2}x   (ours / this: {:.2})", time / ns[0], ns[0] / time);
    }
    println!();
}

/// Prints how the time of one program grows with its input, as the `linear` runs do: for each size the time an element
/// takes and, from the second size on, the exponent e of time = size^e since the size before. `prepare` makes the input
/// and returns what is measured. Returns the nanoseconds of each size.
pub fn growth<T: 'static, R: Fn() -> T>(name: &str, sizes: &[usize], prepare: impl Fn(usize) -> R) -> Vec<f64> {
    println!("{name}");
    let mut all = Vec::new();
    let mut before: Option<(usize, f64)> = None;
    for &size in sizes {
        let run = prepare(size);
        let ns = compare(&mut [program(name, &run)], 3, 1)[0];
        let exponent = before.map_or_else(String::new, |(less, time)| {
            format!("   exponent {:.2}", (ns / time).ln() / (size as f64 / less as f64).ln())
        });
        println!("  {size:>9}  {:10.3} ms  {:10.1} ns each{exponent}", ns / 1e6, ns / size as f64);
        before = Some((size, ns));
        all.push(ns);
    }
    println!();
    all
}

/// From 12,500 to 100,000: doubled three times.
pub const DOUBLED: [usize; 4] = [12_500, 25_000, 50_000, 100_000];
