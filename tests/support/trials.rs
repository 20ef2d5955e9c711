//! Tests that say when they run that this machine lacks what they need: `ignored, needs chromium`.
//!
//! ```text
//!   trials! { works; shows: Chromium; holds: Root, Namespaces; }     one list at the end of a file of tests
//!   main() ─▶ run(a::trials().chain(b::trials()))                    the arguments are those of other test programs
//! ```
//!
//! Nothing is asked when this is compiled, so a browser that is installed later is found. A test that is in no list is
//! dead code, and the compiler says so.
#![allow(dead_code)] // every test program needs another part

pub(crate) use libtest_mimic::Trial;
use libtest_mimic::{Arguments, Completion};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Something that not every machine has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Need {
    /// A browser: `$CHROMIUM`, else the first of a few names on the path.
    Chromium,
    /// `pdflatex` with TikZ.
    Latex,
    /// `../shared/data` beside the checkout.
    SharedData,
    /// To be the user that may do everything.
    Root,
    /// Own views of processes, network and files.
    Namespaces,
    /// To show a program nothing but its own files, without being root.
    Landlock,
}

impl Need {
    fn name(self) -> &'static str {
        match self {
            Self::Chromium => "chromium",
            Self::Latex => "LaTeX with TikZ",
            Self::SharedData => "../shared/data",
            Self::Root => "root",
            Self::Namespaces => "namespaces",
            Self::Landlock => "Landlock",
        }
    }

    fn is_met(self) -> bool {
        static MET: [OnceLock<bool>; 6] = [const { OnceLock::new() }; 6];
        *MET[self as usize].get_or_init(|| match self {
            Self::Chromium => chromium().is_some(),
            Self::Latex => said("pdflatex", &["--version"]).is_some() && said("kpsewhich", &["tikz.sty"]).is_some(),
            Self::SharedData => Path::new(env!("CARGO_MANIFEST_DIR"))
                .ancestors()
                .skip(1)
                .any(|above| above.join("../shared/data").is_dir() && above.join("labs").is_dir()),
            Self::Root => said("id", &["-u"]).is_some_and(|id| id.trim() == "0"),
            Self::Namespaces => {
                let kinds = ["--user", "--map-root-user", "--mount", "--net", "--ipc", "--pid", "--fork", "true"];
                said("unshare", &kinds).is_some()
            }
            Self::Landlock => has_landlock(),
        })
    }
}

/// What a short program says, if it can be run.
fn said(program: &str, args: &[&str]) -> Option<String> {
    let out = std::process::Command::new(program).args(args).output().ok().filter(|out| out.status.success())?;
    String::from_utf8(out.stdout).ok()
}

/// By the number of the system, unless it lists what it has switched on: where it is switched off without a word, the
/// tests fail.
fn has_landlock() -> bool {
    /// The first Linux with Landlock.
    const FIRST: (u32, u32) = (5, 13);
    if let Ok(modules) = std::fs::read_to_string("/sys/kernel/security/lsm") {
        return modules.contains("landlock");
    }
    let release = std::fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    let mut numbers = release.split(|c: char| !c.is_ascii_digit()).filter_map(|part| part.parse().ok());
    (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0)) >= FIRST
}

/// The browser of this machine.
pub(crate) fn chromium() -> Option<PathBuf> {
    const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    if let Some(path) = std::env::var_os("CHROMIUM") {
        return Some(PathBuf::from(path)).filter(|path| path.is_file());
    }
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let found = NAMES.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    cfg!(unix).then_some(found)?.find(|path| path.is_file())
}

/// A test by the path of its module, ignored with the reason where one of its needs is not met.
pub(crate) fn trial(module: &str, name: &str, needs: &'static [Need], test: fn()) -> Trial {
    // The first part is the name of the program.
    let module = module.split_once("::").map_or(String::new(), |(_, module)| format!("{module}::"));
    Trial::ignorable_test(format!("{module}{name}"), move || {
        if needs.iter().all(|need| need.is_met()) {
            test();
            return Ok(Completion::Completed);
        }
        let names: Vec<&str> = needs.iter().map(|need| need.name()).collect();
        let (last, others) = names.split_last().expect("a need that is not met");
        let names = if others.is_empty() { (*last).to_owned() } else { format!("{} and {last}", others.join(", ")) };
        Ok(Completion::ignored_with(format!("needs {names}")))
    })
}

/// The tests of this module: names, and after a colon what they need.
macro_rules! trials {
    ($($name:ident $(: $($need:ident),+)?;)*) => {
        pub(crate) fn trials() -> Vec<crate::trials::Trial> {
            vec![$(crate::trials::trial(
                module_path!(),
                stringify!($name),
                &[$($(crate::trials::Need::$need),+)?],
                $name,
            )),*]
        }
    };
}
pub(crate) use trials;

/// Runs the tests that the arguments of the program choose, and ends it.
pub(crate) fn run(mut trials: Vec<Trial>) -> ! {
    let mut arguments: Vec<String> = std::env::args().collect();
    // After `--exact` there may be several names, as other test programs have it.
    if arguments.iter().any(|word| word == "--exact") {
        let is_name = |word: &String| !word.starts_with('-');
        let names: Vec<String> = arguments.iter().skip(1).filter(|word| is_name(word)).cloned().collect();
        trials.retain(|trial| names.iter().any(|name| name == trial.name()));
        let program = arguments.remove(0);
        arguments.retain(|word| !is_name(word) && word != "--exact");
        arguments.insert(0, program);
    }
    libtest_mimic::run(&Arguments::from_iter(arguments), trials).exit()
}
