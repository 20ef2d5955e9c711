//! The grader run by somebody who is not root, and by anybody where no namespaces can be had: `dcel grade` with an
//! instructor's secret, and the attacks of this program once more.
//!
//! ```text
//!   root ─▶ chroot into a second view of the same files ─▶ no user namespaces there, as in many containers
//!        └▶ setpriv to a user without rights, with a toolchain and a program that this user can reach
//! ```

use super::class::{HOME, home};
use crate::trials::trials;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Arc, Mutex, Weak};

/// Somebody who has no account.
const USER: &str = "54321";
/// Nobody can guess it.
const SECRET: &str = "seed = 99\n";

/// What an ordinary user needs, where everybody can reach it.
struct Place {
    folder: tempfile::TempDir,
    rustc: PathBuf,
}

/// Made when the first test asks, removed after the last.
fn place() -> Arc<Place> {
    static PLACE: Mutex<Weak<Place>> = Mutex::new(Weak::new());
    let mut kept = PLACE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    kept.upgrade().unwrap_or_else(|| {
        let made = Arc::new(Place::new());
        *kept = Arc::downgrade(&made);
        made
    })
}

impl Place {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let to = folder.path();
        fs::set_permissions(to, fs::Permissions::from_mode(0o755)).unwrap();
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let sysroot = Command::new(rustc).args(["--print", "sysroot"]).output().unwrap().stdout;
        let script = "set -e; link() { cp -rlL \"$@\" 2>/dev/null || cp -rL \"$@\"; }
            mkdir -p toolchain/bin toolchain/lib/rustlib tests/attacks tmp second
            link \"$1\"/bin/cargo \"$1\"/bin/rustc toolchain/bin/
            link \"$1\"/lib/*.so* toolchain/lib/
            for target in \"$1\"/lib/rustlib/*-*-*; do link \"$target\" toolchain/lib/rustlib/; done
            link \"$2\" dcel; link \"$3\" attacks; cp -r \"$4\"/labs \"$4\"/figures .; cp \"$4\"/tests/attacks/program.rs tests/attacks/
            cp labs/04-half-edge/solution/lab.rs right.rs; chmod -R a+rX .; chmod 1777 tmp";
        let made = Command::new("/bin/sh")
            .args(["-c", script, "sh", String::from_utf8(sysroot).unwrap().trim(), env!("CARGO_BIN_EXE_dcel")])
            .arg(std::env::current_exe().unwrap())
            .arg(home())
            .current_dir(to)
            .output()
            .unwrap();
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        let rustc = to.join("toolchain/bin/rustc");
        Self { folder, rustc }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs something, as root or not, with namespaces or not.
    fn run(&self, program: &Path, args: &[&str], ordinary: bool, namespaces: bool) -> Output {
        let user = format!("setpriv --reuid {USER} --regid {USER} --clear-groups");
        // Where the root folder is another one, the system makes no user namespaces; the files are the same.
        let script = match (ordinary, namespaces) {
            (false, true) => "exec \"$0\" \"$@\"".to_owned(),
            (true, true) => format!("exec {user} \"$0\" \"$@\""),
            (_, false) => format!(
                "mount --rbind / '{0}' && cd '{0}' && exec chroot . {1} \"$0\" \"$@\"",
                self.path("second").display(),
                if ordinary { &user } else { "env" }
            ),
        };
        let mut command = Command::new("unshare");
        command.args(["--mount", "/bin/sh", "-c", &script]).arg(program).args(args);
        command.env("RUSTC", &self.rustc).env("TMPDIR", self.path("tmp")).env(HOME, self.folder.path());
        command.current_dir("/").output().unwrap()
    }
}

/// `dcel grade 04 FILE --secret FILE`: full marks, hidden cases in a sandbox as good as can be had, and no word of where
/// the secret is.
fn grades_with_a_secret(ordinary: bool, namespaces: bool) {
    let place = place();
    let secret = tempfile::Builder::new().prefix("sec").suffix(".toml").tempfile_in(place.path("tmp")).unwrap();
    fs::write(secret.path(), SECRET).unwrap();
    let owner = if ordinary { USER.parse().ok() } else { None };
    std::os::unix::fs::chown(secret.path(), owner, owner).unwrap();
    let name = secret.path().to_str().unwrap();
    let right = place.path("right.rs");
    for format in ["text=-", "html=-", "json=-", "markdown=-"] {
        let args = ["grade", "04", right.to_str().unwrap(), "--seed", "4", "--secret", name, "--report", format];
        let out = place.run(&place.path("dcel"), &args, ordinary, namespaces);
        let (said, complained) = (String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr));
        assert!(out.status.success(), "{format}: {said}{complained}");
        let file = secret.path().file_name().unwrap().to_str().unwrap();
        assert!(!said.contains(file) && !complained.contains(file), "{format} tells where it is: {said}{complained}");
        assert!(!said.contains("seed = 99"), "{format}");
        if format == "text=-" {
            assert!(said.contains("100 of 100 points"), "{said}{complained}");
            let sandbox = said.lines().find(|line| line.starts_with("Sandbox:")).unwrap();
            let missing = said.lines().find(|line| line.starts_with("Not in the sandbox:")).unwrap_or_default();
            for thing in ["the labs with their solutions", "the instructor's secret", "what was handed in"] {
                assert!(sandbox.contains(&format!("{thing} out of reach")), "{said}");
            }
            assert_eq!(sandbox.contains("own root folder"), namespaces, "{said}");
            assert_eq!(sandbox.contains("own user"), !ordinary, "{said}");
            assert_eq!(missing.contains("own user"), ordinary, "{said}");
        }
    }
}

fn a_secret_as_root() {
    grades_with_a_secret(false, true);
}

fn a_secret_as_an_ordinary_user() {
    grades_with_a_secret(true, true);
}

fn a_secret_as_root_without_namespaces() {
    grades_with_a_secret(false, false);
}

fn a_secret_as_an_ordinary_user_without_namespaces() {
    grades_with_a_secret(true, false);
}

/// Runs tests of this program as an ordinary user: all whose names end so.
fn once_more(endings: &[&str], namespaces: bool) {
    let place = place();
    let attacks = place.path("attacks");
    let listed = Command::new(&attacks).arg("--list").output().unwrap().stdout;
    let listed = String::from_utf8(listed).unwrap();
    let names = listed.lines().filter_map(|line| line.strip_suffix(": test"));
    let names: Vec<&str> = names.filter(|name| endings.iter().any(|ending| name.ends_with(ending))).collect();
    assert!(names.len() >= 8, "{listed}");
    let args: Vec<&str> = ["--exact", "--test-threads=2"].into_iter().chain(names.iter().copied()).collect();
    let out = place.run(&attacks, &args, true, namespaces);
    let said = String::from_utf8_lossy(&out.stdout);
    assert!(out.status.success(), "{said}{}", String::from_utf8_lossy(&out.stderr));
    assert!(said.contains(&format!("{} passed; 0 failed; 0 ignored", names.len())), "{said}");
}

fn attacks_on_an_ordinary_user() {
    once_more(&["::in_namespaces", "::as_an_ordinary_user_grades"], true);
}

fn attacks_on_an_ordinary_user_without_namespaces() {
    let endings = ["::with_its_own_files_only", "::without_walls", "::as_an_ordinary_user_grades_without_namespaces"];
    once_more(&endings, false);
}

trials! {
    a_secret_as_root: Root, Namespaces, Landlock;
    a_secret_as_an_ordinary_user: Root, Namespaces, Landlock;
    a_secret_as_root_without_namespaces: Root, Landlock;
    a_secret_as_an_ordinary_user_without_namespaces: Root, Landlock;
    attacks_on_an_ordinary_user: Root, Namespaces, Landlock;
    attacks_on_an_ordinary_user_without_namespaces: Root, Landlock;
}
