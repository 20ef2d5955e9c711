//! Shared by the benchmarks: inputs, and measuring several programs against each other in one run.

use cpu_time::ProcessTime;
use std::hint::black_box;

/// A list of triangles over the vertices `0 .. vertices`.
pub struct Triangles {
    /// What the tables call it.
    pub name: &'static str,
    /// The number of vertices.
    pub vertices: usize,
    /// Three corners each, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
}

/// A small generator of random numbers (xorshift64*), so that every run has the same inputs.
pub struct Random(u64);

impl Random {
    /// A generator with this seed.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number below `bound`.
    pub fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.bits()) * bound as u128) >> 64) as usize
    }

    /// A number in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Puts the items in random order.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }
}

/// A square grid of about `count` triangles, row by row.
pub fn ordered(count: usize) -> Triangles {
    let side = ((count / 2) as f64).sqrt().round() as u32;
    let at = |x: u32, y: u32| y * (side + 1) + x;
    let triangles = (0..side)
        .flat_map(|y| (0..side).map(move |x| (x, y)))
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    Triangles { name: "ordered", vertices: ((side + 1) * (side + 1)) as usize, triangles }
}

/// The same grid with vertices and triangles renumbered at random.
pub fn shuffled(count: usize) -> Triangles {
    let mut random = Random::new(1);
    let grid = ordered(count);
    let mut new: Vec<u32> = (0..grid.vertices as u32).collect();
    random.shuffle(&mut new);
    let mut triangles: Vec<_> = grid.triangles.iter().map(|t| t.map(|v| new[v as usize])).collect();
    random.shuffle(&mut triangles);
    Triangles { name: "shuffled", vertices: grid.vertices, triangles }
}

/// The Delaunay triangulation of random points, as its program lists it: about `count` triangles.
pub fn delaunay(count: usize) -> Triangles {
    let mut random = Random::new(2);
    let points: Vec<_> = (0..count / 2).map(|_| delaunator::Point { x: random.unit(), y: random.unit() }).collect();
    let corners = delaunator::triangulate(&points).triangles;
    let triangles = corners.chunks_exact(3).map(|t| [t[0] as u32, t[1] as u32, t[2] as u32]).collect();
    Triangles { name: "Delaunay", vertices: points.len(), triangles }
}

/// The three orders of the tables.
pub fn three_orders(count: usize) -> [Triangles; 3] {
    [ordered(count), shuffled(count), delaunay(count)]
}

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
/// and returns what is measured.
pub fn growth<T: 'static, R: Fn() -> T>(name: &str, sizes: &[usize], prepare: impl Fn(usize) -> R) {
    println!("{name}");
    let mut before: Option<(usize, f64)> = None;
    for &size in sizes {
        let run = prepare(size);
        let ns = compare(&mut [program(name, &run)], 3, 1)[0];
        let exponent = before.map_or_else(String::new, |(less, time)| {
            format!("   exponent {:.2}", (ns / time).ln() / (size as f64 / less as f64).ln())
        });
        println!("  {size:>9}  {:10.3} ms  {:10.1} ns each{exponent}", ns / 1e6, ns / size as f64);
        before = Some((size, ns));
    }
    println!();
}

/// From 12,500 to 100,000: doubled three times.
pub const DOUBLED: [usize; 4] = [12_500, 25_000, 50_000, 100_000];
