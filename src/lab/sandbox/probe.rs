//! Trying the barriers from inside, and what is said of them then: a barrier is reported only after a program behind it has
//! failed to pass it.

use super::inside::{Answers, Questions, spaces};
use super::linux::Resident;
use super::processes::{runs, start_of};
use super::spec::{INSIDE, WORD};
use super::{Barrier, Hidden, Limits, Runner, Sandbox, SandboxChoice, Task, View, unguessable};
use crate::End;
use std::fs;
use std::net::{Ipv4Addr, TcpListener, UdpSocket};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Files that everybody may read and that no submission has a use for.
const OTHERS: [&str; 4] = ["/etc/passwd", "/etc/group", "/usr/share/common-licenses/GPL-3", "/usr/share/zoneinfo/UTC"];
/// Of a hidden folder so many files are tried, among so many entries.
const LEAVES: usize = 8;
const MOST_ENTRIES: usize = 2000;
/// How long a word that was sent may be under way.
const UNDER_WAY: Duration = Duration::from_millis(20);

/// What came of a trial.
struct Trial {
    answers: Answers,
    /// How many of the files are those of [`OTHERS`].
    others: Vec<&'static str>,
    process: bool,
    network: bool,
    /// What was started is still there.
    stayed: bool,
}

/// Runs the program that tries everything, in the sandbox of a resident, with a view of the file system.
fn trial(resident: &Resident, mut view: View, files: &[PathBuf]) -> Result<Trial, String> {
    let others: Vec<&str> = OTHERS.into_iter().filter(|path| fs::File::open(path).is_ok()).collect();
    let door = |error: std::io::Error| format!("the sandbox cannot be tried: {error}");
    let tcp = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).map_err(door)?;
    let udp = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).map_err(door)?;
    udp.set_read_timeout(Some(UNDER_WAY)).map_err(door)?;
    let process = std::process::id().cast_signed();
    let questions = Questions {
        files: others.iter().map(PathBuf::from).chain(files.iter().cloned()).collect(),
        process,
        began: start_of(process).unwrap_or_default(),
        spaces: spaces(),
        tcp: tcp.local_addr().map_err(door)?.port(),
        udp: udp.local_addr().map_err(door)?.port(),
        token: unguessable(),
    };
    // The launcher itself: whoever starts it has it open already, wherever it lies.
    let program = PathBuf::from("/proc/self/exe");
    view.run.push(program.clone());
    let task = Task {
        program,
        args: [WORD, INSIDE].map(str::to_owned).into(),
        env: Vec::new(),
        folder: PathBuf::from("/"),
        view,
        limits: Limits { seconds: 20.0, ..Limits::default() },
    };
    let text = serde_json::to_string(&questions).map_err(|error| error.to_string())?;
    let ran = resident.run(&task, &text);
    let answers: Answers = match ran.end {
        End::Exited(0) => serde_json::from_slice(&ran.stdout).map_err(|error| format!("a trial said {error}"))?,
        End::NotStarted(why) => return Err(why),
        end => return Err(format!("a trial ended with {end:?}")),
    };
    let network = answers.tcp || udp.recv(&mut [0; 64]).is_ok();
    let stayed = answers.stays && runs(&questions.token);
    Ok(Trial { process: answers.process || answers.signal, network, stayed, others, answers })
}

impl Trial {
    /// What got through the barrier of this name, or nothing.
    fn past_own_user(&self, own: u32) -> Option<String> {
        let Answers { user, root, signal, .. } = &self.answers;
        (*root || *user == own || *signal).then(|| format!("a program ran as user {user} and had rights it should not"))
    }

    fn past_own_files(&self) -> Option<String> {
        let read = self.answers.files.iter().find_map(|&i| self.others.get(i))?;
        Some(format!("a program could read {read}"))
    }

    fn past_namespaces(&self) -> Option<String> {
        let said = |through: bool, what: &str| through.then(|| what.to_owned());
        said(self.process, "a program could see another process")
            .or_else(|| said(self.network, "a program could reach the network"))
            .or_else(|| said(self.answers.memory, "a program could reach the shared memory of others"))
            .or_else(|| said(self.answers.root, "a program had rights of root"))
            .or_else(|| self.past_own_files())
    }

    fn past_the_end(&self) -> Option<String> {
        self.stayed.then(|| "a program could leave something running".to_owned())
    }

    /// The places of the other files that were read.
    fn read(&self) -> impl Iterator<Item = usize> + '_ {
        self.answers.files.iter().filter_map(|i| i.checked_sub(self.others.len()))
    }
}

/// Tries each barrier by itself, and then all together. Those that stand, and what is said of each.
///
/// The trials wait more than they work, so that all of them are made at the same time, as if every barrier stood; one that
/// was made with a barrier that does not stand is made again without it.
pub(super) fn probe(launcher: &Path, choice: SandboxChoice) -> (SandboxChoice, Vec<Barrier>) {
    let none = SandboxChoice { own_user: false, namespaces: false, own_files: false };
    let attempt_now = |up: SandboxChoice| {
        let sandbox = Sandbox::of(launcher, up, Vec::new());
        let resident = Resident::new(&sandbox).map_err(|error| error.to_string())?;
        trial(&resident, View::default(), &[])
    };
    let within = |up: SandboxChoice| {
        up.own_user <= choice.own_user && up.own_files <= choice.own_files && up.namespaces <= choice.namespaces
    };
    let mut likely = vec![none];
    for up in [
        SandboxChoice { own_user: true, ..none },
        SandboxChoice { own_files: true, namespaces: false, ..choice },
        SandboxChoice { own_files: false, namespaces: true, ..choice },
        choice,
    ] {
        if within(up) && !likely.contains(&up) {
            likely.push(up);
        }
    }
    let mut made: Vec<(SandboxChoice, Result<Trial, String>)> = std::thread::scope(|scope| {
        let begun: Vec<_> = likely.into_iter().map(|up| (up, scope.spawn(move || attempt_now(up)))).collect();
        let broke = |_| Err("a trial of the sandbox broke off".to_owned());
        begun.into_iter().map(|(up, trial)| (up, trial.join().unwrap_or_else(broke))).collect()
    });
    let mut attempt = |up: SandboxChoice| match made.iter().position(|(made, _)| *made == up) {
        Some(at) => made.swap_remove(at).1,
        None => attempt_now(up),
    };
    let base = attempt(none).map(|trial| trial.past_the_end());
    let own = nix::unistd::geteuid().as_raw();
    let (mut up, mut said) = (none, Vec::new());
    let mut barrier = |name: &str, wanted: bool, tried: &mut dyn FnMut() -> Result<Option<String>, String>| {
        let (stands, missing) = match &base {
            Err(why) => (false, Some(why.clone())),
            Ok(_) if !wanted => (false, Some("switched off".to_owned())),
            Ok(_) => tried().map_or_else(|why| (false, Some(why)), |passed| (true, passed)),
        };
        said.push(Barrier { name: name.to_owned(), missing });
        stands
    };
    up.own_user = barrier("own user", choice.own_user, &mut || {
        attempt(SandboxChoice { own_user: true, ..none }).map(|trial| trial.past_own_user(own))
    });
    up.own_files = barrier("own files only", choice.own_files, &mut || {
        attempt(SandboxChoice { own_files: true, ..up }).map(|trial| trial.past_own_files())
    });
    up.namespaces = barrier(NAMESPACES, choice.namespaces, &mut || {
        let alone = attempt(SandboxChoice { namespaces: true, own_files: false, ..up });
        alone.and_then(|trial| attempt(SandboxChoice { namespaces: true, ..up }).map(|_| trial.past_namespaces()))
    });
    let missing = base.unwrap_or_else(Some);
    said.push(Barrier { name: "nothing stays".to_owned(), missing });
    (up, said)
}

/// What the namespaces keep apart.
pub(super) const NAMESPACES: &str = "own root folder, processes, network and shared memory";

/// Tries to reach what is hidden, with the view that the compiler has and with that of the student's program.
/// `needed`: what lies within something hidden and is shown all the same.
pub(super) fn out_of_reach(
    sandbox: &Sandbox,
    hidden: &[Hidden],
    tools: &[PathBuf],
    needed: &[PathBuf],
) -> Vec<Barrier> {
    let apart = |path: &PathBuf| !needed.iter().any(|need| path.starts_with(need));
    let mut files = Vec::new();
    let mut of = Vec::new();
    for (i, thing) in hidden.iter().enumerate() {
        for path in &thing.paths {
            let found = leaves(path);
            let found = if found.is_empty() { vec![path.clone()] } else { found };
            let found: Vec<PathBuf> = found.into_iter().filter(|path| apart(path)).collect();
            of.extend(found.iter().map(|_| i));
            files.extend(found);
        }
    }
    let mut missing: Vec<Option<String>> = vec![None; hidden.len()];
    let mut said = Vec::new();
    let build = View { run: tools.to_vec(), write: Vec::new(), tools: true };
    for (when, view) in [("when it is compiled", build), ("when it runs", View::default())] {
        let resident = sandbox.resident().map_err(|error| error.to_string());
        let tried = resident.and_then(|resident| trial(&resident, view, &files));
        match tried {
            Ok(trial) => {
                for i in trial.read() {
                    missing[of[i]].get_or_insert_with(|| reach(sandbox.up, when));
                }
                let claimed = sandbox.up.own_files || sandbox.up.namespaces;
                if let Some(why) = trial.past_own_files().filter(|_| claimed) {
                    said.push(Barrier { name: format!("no files of others {when}"), missing: Some(why) });
                }
            }
            Err(why) => missing.iter_mut().for_each(|line| {
                line.get_or_insert_with(|| format!("it could not be tried from inside: {why}"));
            }),
        }
    }
    said.extend(hidden.iter().zip(missing).map(|(thing, missing)| Barrier { name: thing.barrier(), missing }));
    said
}

fn reach(up: SandboxChoice, when: &str) -> String {
    let who = if up.own_user { "every user of this machine" } else { "a program of the user who grades" };
    let help = if up.own_user { ": take the rights of others away (chmod 700)" } else { "" };
    format!("{who} can read it, also {when}{help}")
}

/// Some files in a folder, or the file itself; none if there are only folders, or it cannot be read.
fn leaves(path: &Path) -> Vec<PathBuf> {
    let (mut found, mut folders, mut entries) = (Vec::new(), vec![path.to_path_buf()], 0);
    if path.is_file() {
        return folders;
    }
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok) {
            entries += 1;
            if found.len() == LEAVES || entries > MOST_ENTRIES {
                return found;
            }
            match entry.file_type() {
                Ok(kind) if kind.is_dir() => folders.push(entry.path()),
                Ok(kind) if kind.is_file() && entry.metadata().is_ok_and(|data| data.len() > 0) => {
                    found.push(entry.path());
                }
                _ => {}
            }
        }
    }
    found
}
