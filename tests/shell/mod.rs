//! A folder of small files and the command in it.
#![allow(dead_code, unreachable_pub)] // every test file uses another part

pub(crate) mod watched;

use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Two triangles: v0 (0, 0), v1 (4, 0), v2 (4, 3), v3 (0, 3); f1 = 0 1 2, f2 = 0 2 3.
pub const SQUARE: &str = "v 0 0\nv 4 0\nv 4 3\nv 0 3\nf 1 2 3\nf 1 3 4\n";

/// A 10 x 10 square named `Garden` with a square hole from (2, 2) to (4, 4), and a triangle `Shed` far off.
pub const GARDEN: &str = r#"{"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "Garden"}, "geometry": {"type": "Polygon", "coordinates":
    [[[0,0],[10,0],[10,10],[0,10],[0,0]], [[2,2],[4,2],[4,4],[2,4],[2,2]]]}},
  {"type": "Feature", "properties": {"name": "Shed"}, "geometry": {"type": "Polygon", "coordinates":
    [[[20,0],[21,2],[22,0],[20,0]]]}}]}"#;

/// The unit cube.
pub const CUBE: &str = "OFF\n8 6 12\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
    4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// The triangle v0 (0, 0), v1 (4, 0), v2 (2, 3) with the isolated vertex v3 in it; f1 is named `Ohio`.
pub const TRIANGLE: &str = "dcel 1\nv0 0 0 out h0\nv1 4 0 out h2\nv2 2 3 out h4\nv3 2 1 out none\n\
    h0 origin v0 twin h1 next h2 prev h4 face f1\nh1 origin v1 twin h0 next h5 prev h3 face f0\n\
    h2 origin v1 twin h3 next h4 prev h0 face f1\nh3 origin v2 twin h2 next h1 prev h5 face f0\n\
    h4 origin v2 twin h5 next h0 prev h2 face f1\nh5 origin v0 twin h4 next h3 prev h1 face f0\n\
    f0 outer half_edge h1 inner none\nf1 half_edge h0 inner v3 name \"Ohio\"\n";

/// What a call gave.
#[derive(Debug)]
pub struct Told {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
    /// Whether `--json` was asked for.
    json: bool,
}

impl Told {
    /// The answer of a call that must have gone well.
    #[track_caller]
    pub fn fine(self) -> String {
        assert_eq!(self.code, Some(0), "{self:?}");
        self.out
    }

    /// The JSON answer of a call that must have gone well.
    #[track_caller]
    pub fn json(self) -> Value {
        serde_json::from_str(&self.fine()).expect("JSON")
    }

    /// Checks the exit code and the beginning of the error message.
    #[track_caller]
    pub fn fails(&self, code: i32, error: &str, help: &str) {
        assert_eq!(self.code, Some(code), "{self:?}");
        // With --json the error is the answer, and nothing else is.
        if self.json {
            let answer: Value = serde_json::from_str(&self.out).unwrap_or_else(|_| panic!("no JSON: {self:?}"));
            assert!(answer["error"].is_object(), "an answer in spite of the failure: {self:?}");
        } else {
            assert_eq!(self.out, "", "an answer in spite of the failure: {self:?}");
        }
        let found = self.err.lines().find_map(|line| line.strip_prefix("error: ")).unwrap_or("");
        assert!(found.contains(error), "expected `{error}`: {self:?}");
        assert!(self.err.contains(help), "expected the help `{help}`: {self:?}");
    }
}

/// A temporary folder with the files above.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder"));
        let files = [("square.obj", SQUARE), ("garden.json", GARDEN), ("cube.off", CUBE), ("triangle.dcel", TRIANGLE)];
        files.into_iter().for_each(|(name, text)| folder.write(name, text));
        folder
    }

    /// A folder without any files.
    pub fn empty() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).expect("a file in the temporary folder");
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).expect("a file in the temporary folder")
    }

    pub fn read_bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).expect("a file in the temporary folder")
    }

    /// The command with nothing on standard input; `arguments` are separated by blanks.
    pub fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_dcel"));
        command.args(arguments.split_whitespace()).current_dir(self.0.path());
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command.env("COLUMNS", "100").env_remove("NO_COLOR");
        command
    }

    pub fn dcel(&self, arguments: &str) -> Told {
        told(&mut self.command(arguments))
    }

    pub fn dcel_on(&self, path: &Path, arguments: &str) -> Told {
        told(self.command(arguments).arg(path))
    }

    /// The same with a text on standard input.
    pub fn dcel_with(&self, input: &str, arguments: &str) -> Told {
        let mut command = self.command(arguments);
        let mut child = command.stdin(Stdio::piped()).spawn().expect("the command starts");
        let mut stdin = child.stdin.take().expect("standard input");
        stdin.write_all(input.as_bytes()).expect("the command reads");
        drop(stdin);
        collect(&command, child.wait_with_output().expect("the command ends"))
    }
}

fn told(command: &mut Command) -> Told {
    let output = command.output().expect("the command starts");
    collect(command, output)
}

fn collect(command: &Command, output: std::process::Output) -> Told {
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Told {
        code: output.status.code(),
        out: text(output.stdout),
        err: text(output.stderr),
        json: command.get_args().any(|word| word == "--json"),
    }
}

/// A grid of `n` x `n` squares, each cut into two triangles.
pub fn grid(n: usize) -> String {
    let mut text = String::new();
    for i in 0..(n + 1) * (n + 1) {
        text += &format!("v {} {}\n", i % (n + 1), i / (n + 1));
    }
    for i in (0..n * (n + 1)).filter(|i| i % (n + 1) < n) {
        let [a, b, c, d] = [i + 1, i + 2, i + n + 3, i + n + 2];
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}
