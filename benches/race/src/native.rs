//! Programs that are built for themselves: peers in C++, of the folder `peers`, where a compiler and the library are
//! installed; and those of navmeshes, of the package above, because a peer there keeps earcut at an old release.

use crate::{rows, segments, surfaces};
use std::path::PathBuf;
use std::process::Command;

/// One who does what a row says, in a program of its own.
pub struct Native {
    pub row: &'static str,
    pub name: &'static str,
    /// The file in `peers`, without its end.
    library: &'static str,
    task: &'static str,
    /// Numbers that the program reads from a file: first how many elements there are.
    input: fn() -> Vec<f64>,
}

/// A library and what its programs are linked with.
const LIBRARIES: [(&str, &[&str]); 5] = [
    ("arrangement", &["-lgmp", "-lmpfr"]),
    ("cgal", &["-lgmp", "-lmpfr"]),
    ("geos", &["-lgeos_c"]),
    ("opensubdiv", &["-losdCPU"]),
    ("qhull", &["-lqhull_r"]),
];

/// What the kit is called.
pub const OURS: &str = "dcel-kit";
/// The program of ways over navmeshes.
const WAYS: &str = "ways";
/// Its package.
const ABOVE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// All of them.
pub const NATIVE: &[Native] = &[
    native("intersection of coasts", "GEOS", "geos", "intersection", || shapes(&rows::coasts())),
    native("intersection of squares", "GEOS", "geos", "intersection", || shapes(&rows::two_rows())),
    native("overlay of coasts", "CGAL", "arrangement", "overlay", || shapes(&rows::coasts())),
    native("segments that meet at ends", "CGAL", "arrangement", "segments", plain),
    native("segments that meet at ends", "GEOS", "geos", "polygonize", plain),
    native("splits", "CGAL", "cgal", "splits", surfaces::choices),
    native("Catmull-Clark", "OpenSubdiv", "opensubdiv", "catmull-clark", || surfaces::torus_in_numbers(false)),
    native("Loop", "OpenSubdiv", "opensubdiv", "loop", || surfaces::torus_in_numbers(true)),
    native("Delaunay, random", "CGAL", "cgal", "delaunay", || flat(&rows::random(500_000))),
    native("Delaunay, lattice", "CGAL", "cgal", "delaunay", || flat(&rows::lattice(500_000))),
    native("Delaunay, clusters", "CGAL", "cgal", "delaunay", || flat(&rows::clusters(500_000))),
    native("constrained Delaunay", "CGAL", "cgal", "constrained", || {
        let (points, edges) = rows::street_map(100_000);
        let mut all = flat(&points);
        all.extend(edges.iter().flatten().map(|&i| f64::from(i)));
        all
    }),
    native("hull, random", "CGAL", "cgal", "hull", || flat(&rows::random(1_000_000))),
    native("hull, circle", "CGAL", "cgal", "hull", || flat(&rows::on_a_circle(1_000_000))),
    native("hull, clusters", "CGAL", "cgal", "hull", || flat(&rows::clusters(1_000_000))),
    native("hull in space, ball", "qhull", "qhull", "hull", || flat(&rows::ball(1_000_000))),
    native("hull in space, ball", "CGAL", "cgal", "hull in space", || flat(&rows::ball(1_000_000))),
    native("hull in space, sphere", "qhull", "qhull", "hull", || flat(&rows::sphere(100_000))),
    native("hull in space, sphere", "CGAL", "cgal", "hull in space", || flat(&rows::sphere(100_000))),
    native("ways, caves", OURS, WAYS, "dcel-kit exact caves", Vec::new),
    native("ways, caves", "polyanya", WAYS, "polyanya exact caves", Vec::new),
    native("ways, caves", "polyanya, merged", WAYS, "merged exact caves", Vec::new),
    native("places, caves", OURS, WAYS, "dcel-kit locate caves", Vec::new),
    native("places, caves", "polyanya", WAYS, "polyanya locate caves", Vec::new),
    native("ways, blocks", OURS, WAYS, "dcel-kit exact blocks", Vec::new),
    native("ways, blocks", "polyanya", WAYS, "polyanya exact blocks", Vec::new),
    native("ways, blocks", "polyanya, merged", WAYS, "merged exact blocks", Vec::new),
    native("places, blocks", OURS, WAYS, "dcel-kit locate blocks", Vec::new),
    native("places, blocks", "polyanya", WAYS, "polyanya locate blocks", Vec::new),
];

const fn native(
    row: &'static str,
    name: &'static str,
    library: &'static str,
    task: &'static str,
    input: fn() -> Vec<f64>,
) -> Native {
    Native { row, name, library, task, input }
}

fn flat<const N: usize>(points: &[[f64; N]]) -> Vec<f64> {
    std::iter::once(points.len() as f64).chain(points.iter().flatten().copied()).collect()
}

fn plain() -> Vec<f64> {
    let all = segments::plain();
    std::iter::once(all.len() as f64).chain(all.into_iter().flatten().flatten()).collect()
}

fn shapes(both: &[Vec<crate::shapes::Ring>; 2]) -> Vec<f64> {
    let mut all = vec![rows::edges(both) as f64];
    for shape in both {
        all.push(shape.len() as f64);
        for ring in shape {
            all.extend(flat(ring));
        }
    }
    all
}

impl Native {
    /// Its release, which its program tells; none of ours.
    pub fn version(&self) -> String {
        if self.name == OURS {
            return String::new();
        }
        let told = Command::new(self.program()).arg("version").output();
        told.map(|told| String::from_utf8_lossy(&told.stdout).trim().to_owned()).unwrap_or_default()
    }

    /// Where its program lies, once it is built.
    fn program(&self) -> PathBuf {
        match self.library {
            WAYS => [ABOVE, "target", "release", WAYS].iter().collect(),
            library => kept().join(library),
        }
    }

    /// How to run it; why not, if it cannot be run here.
    pub fn command(&self) -> Result<Command, String> {
        let program = self.program();
        let mut command = Command::new(&program);
        command.arg(self.task);
        if self.library == WAYS {
            let mut build = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".into()));
            build.args(["build", "--quiet", "--locked", "--release", "-p", "dcel-kit-ways"]).current_dir(ABOVE);
            let done = build.args(["--target-dir", "target"]).output().map_err(|e| e.to_string())?;
            return if done.status.success() { Ok(command) } else { Err("it does not compile".to_owned()) };
        }
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/peers");
        let (_, libraries) = LIBRARIES.iter().find(|(name, _)| *name == self.library).expect("a known library");
        let kept = kept();
        std::fs::create_dir_all(&kept).map_err(|e| format!("{}: {e}", kept.display()))?;
        if !program.exists() {
            let source = PathBuf::from(folder).join(format!("{}.cpp", self.library));
            let compiler = std::env::var("CXX").unwrap_or_else(|_| "c++".into());
            let mut compile = Command::new(compiler);
            compile.args(["-O3", "-DNDEBUG", "-std=c++17", "-o"]).arg(&program).arg(source).args(*libraries);
            let done = compile.output().map_err(|e| e.to_string())?;
            if !done.status.success() {
                let said = String::from_utf8_lossy(&done.stderr).into_owned();
                return Err(said.lines().find(|line| line.contains("error")).unwrap_or("no compiler").to_owned());
            }
        }
        let input = kept.join(format!("{}, {}", self.row, self.name));
        if !input.exists() {
            let bytes: Vec<u8> = (self.input)().into_iter().flat_map(f64::to_ne_bytes).collect();
            std::fs::write(&input, bytes).map_err(|e| format!("{}: {e}", input.display()))?;
        }
        command.arg(input);
        Ok(command)
    }
}

/// Where programs and inputs are kept.
fn kept() -> PathBuf {
    std::env::temp_dir().join(format!("dcel-race-{}", std::process::id()))
}

/// Takes away what was compiled and written.
pub fn clear() {
    let _ = std::fs::remove_dir_all(kept());
}
