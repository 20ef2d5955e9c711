//! A class that hands in: a folder of submissions, a grader's secret, and what must be true afterwards.

use dcel_lab::{
    Barrier, GradeOptions, Grader, Hidden, Lab, Limits, Outcome, Plan, Report, Sandbox, SandboxChoice, Submission,
};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

pub(crate) const NONE: SandboxChoice = SandboxChoice { own_user: false, namespaces: false, own_files: false };
pub(crate) const USER: SandboxChoice = SandboxChoice { own_user: true, ..NONE };

/// The variable that names another place for the checkout and its program: one that an ordinary user can reach.
pub(crate) const HOME: &str = "ATTACKS_HOME";

/// Where the checkout is.
pub(crate) fn home() -> PathBuf {
    std::env::var_os(HOME).map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."), PathBuf::from)
}

pub(crate) fn launcher() -> &'static Path {
    static PLACE: OnceLock<PathBuf> = OnceLock::new();
    let other = || std::env::var_os(HOME).map(|home| Path::new(&home).join("dcel"));
    PLACE.get_or_init(|| other().unwrap_or_else(|| env!("CARGO_BIN_EXE_dcel").into()))
}

pub(crate) const SPACES: SandboxChoice = SandboxChoice { namespaces: true, ..NONE };
pub(crate) const FILES: SandboxChoice = SandboxChoice { own_files: true, ..NONE };
pub(crate) const ORDINARY: SandboxChoice = SandboxChoice { own_user: false, ..ALL };
pub(crate) const ALL: SandboxChoice = SandboxChoice { own_user: true, namespaces: true, own_files: true };

/// A test for each choice of barriers: ignored, with the reason, where this machine does not have all of them.
macro_rules! behind_each {
    ($($name:ident($attack:path);)*) => {
        $(mod $name {
            #[allow(unused_imports)]
            use super::*;
            use crate::class::{ALL, FILES, NONE, ORDINARY, SPACES, USER};

            fn without_walls() {
                $attack(NONE);
            }

            fn as_a_user_of_its_own() {
                $attack(USER);
            }

            fn in_namespaces() {
                $attack(SPACES);
            }

            fn with_its_own_files_only() {
                $attack(FILES);
            }

            fn as_an_ordinary_user_grades() {
                $attack(ORDINARY);
            }

            fn behind_all_of_them() {
                $attack(ALL);
            }

            crate::trials::trials! {
                without_walls;
                as_a_user_of_its_own: Root;
                in_namespaces: Namespaces;
                with_its_own_files_only: Landlock;
                as_an_ordinary_user_grades: Namespaces, Landlock;
                behind_all_of_them: Root, Namespaces, Landlock;
            }
        })*

        /// The tests of all these attacks.
        pub(crate) fn behind_each() -> Vec<crate::trials::Trial> {
            [$($name::trials()),*].into_iter().flatten().collect()
        }
    };
}
pub(crate) use behind_each;

/// The barriers of a choice, tried once. All of them are there: a test that needs one that is not is ignored, and does
/// not run.
pub(crate) fn sandbox(choice: SandboxChoice) -> Sandbox {
    static TRIED: Mutex<Vec<(SandboxChoice, Sandbox)>> = Mutex::new(Vec::new());
    let mut tried = TRIED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, sandbox)) = tried.iter().find(|(known, _)| *known == choice) {
        return sandbox.clone();
    }
    let sandbox = Sandbox::probe(Some(launcher()), choice);
    assert_eq!(sandbox.up(), choice, "{:?}", sandbox.said());
    let fallen = |barrier: &&Barrier| barrier.missing.as_deref().is_some_and(|why| why != "switched off");
    assert_eq!(sandbox.said().iter().find(fallen), None);
    tried.push((choice, sandbox.clone()));
    sandbox
}

pub(crate) struct Class {
    pub(crate) lab: Lab,
    folder: tempfile::TempDir,
}

impl Class {
    /// The lab of the repository, with less memory.
    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        for (name, mode) in [("rooms", 0o755), ("handed-in", 0o755), ("grader", 0o700)] {
            std::fs::create_dir(folder.path().join(name)).unwrap();
            std::fs::set_permissions(folder.path().join(name), std::fs::Permissions::from_mode(mode)).unwrap();
        }
        std::fs::set_permissions(folder.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
        let place = home().join("labs/04-half-edge");
        let mut lab = Lab::read(&place).unwrap();
        lab.manifest.limits = Limits { memory_mb: 256, output_kb: 8192, ..lab.manifest.limits };
        let class = Self { lab, folder };
        std::fs::write(class.secret(), "pub fn the_solution() {}").unwrap();
        class
    }

    /// A file that only the grader may read.
    pub(crate) fn secret(&self) -> PathBuf {
        self.folder.path().join("grader/solution.rs")
    }

    /// Where a submission of this name goes.
    pub(crate) fn place(&self, name: &str) -> PathBuf {
        self.folder.path().join("handed-in").join(name)
    }

    /// Hands in a single file.
    pub(crate) fn file(&self, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
        let path = self.place(&format!("{name}.rs"));
        std::fs::write(&path, text).unwrap();
        path
    }

    /// Hands in a folder.
    pub(crate) fn folder(&self, name: &str, files: &[(&str, &str)]) -> PathBuf {
        let folder = self.place(name);
        std::fs::create_dir_all(&folder).unwrap();
        for (path, text) in files {
            let path = folder.join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        folder
    }

    pub(crate) fn options(&self) -> GradeOptions {
        GradeOptions {
            launcher: Some(launcher().to_path_buf()),
            work_folders: Some(self.folder.path().join("rooms")),
            hidden: vec![Hidden::new("the solution", vec![self.folder.path().join("grader")])],
            ..GradeOptions::default()
        }
    }

    /// The reports in the order of the submissions; every one of them is there.
    pub(crate) fn grade(&self, submissions: &[PathBuf], options: &GradeOptions) -> Vec<Report> {
        let grader = Grader::new(self.lab.clone(), options).unwrap();
        let mut reports: Vec<Option<Report>> = vec![None; submissions.len()];
        let named: Vec<Submission> = submissions.iter().map(|path| Submission::at(path)).collect();
        let outcome = grader.grade_all(&named, &Plan::with_seed(4), |i, report| {
            assert!(reports[i].is_none(), "{} has two reports", submissions[i].display());
            assert_eq!(report.seed, 4);
            reports[i] = Some(report);
        });
        assert_eq!(outcome, Outcome::All);
        reports.into_iter().map(|report| report.expect("a report for every submission")).collect()
    }

    /// No process of a submission, none of its files.
    pub(crate) fn assert_nothing_is_left(&self) {
        let begin = Instant::now();
        while let Some(line) = running("4.375").or_else(|| running(&self.folder.path().to_string_lossy())) {
            assert!(begin.elapsed() < Duration::from_secs(2), "{line} is still running");
            std::thread::sleep(Duration::from_millis(5));
        }
        let work_folders: Vec<_> = std::fs::read_dir(self.folder.path().join("rooms")).unwrap().collect();
        assert!(work_folders.is_empty(), "{work_folders:?}");
    }
}

/// The command line of a process with these words in it, if one runs; what has ended but is not yet forgotten aside.
pub(crate) fn running(words: &str) -> Option<String> {
    let of = |entry: std::fs::DirEntry| std::fs::read(entry.path().join("cmdline")).ok();
    let lines = std::fs::read_dir("/proc").unwrap().filter_map(|entry| of(entry.ok()?));
    let mut lines = lines.map(|line| String::from_utf8_lossy(&line).replace('\0', " "));
    lines.find(|line| line.contains(words))
}
