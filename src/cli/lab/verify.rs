//! `dcel lab verify`: does the lab grade rightly?

use super::super::{Answer, Failure, Output, failure, save};
use dcel_kit::files::ScratchFolder;
use dcel_lab::{Lab, LabFiles, starter, verify};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Prove that a lab grades rightly: solution, starter, every known mistake
#[derive(clap::Args, Debug)]
#[command(after_help = "\
The solution passes everything; the starter compiles without warnings and is unattempted everywhere; every bug is \
caught and called by its name; every test catches a bug; a student's folder holds nothing of the solution; two runs \
give the same report.

It reads the labs of a checkout, because a program for students holds no solution and no wrong ones: the checkout that \
you are in, or the folder that --labs names.

Examples:
  dcel lab verify
  dcel lab verify 04
  dcel lab verify 04 --labs ~/dcel-kit/labs
  dcel lab verify 04 --write
  dcel lab verify --from labs/04-half-edge")]
pub(crate) struct Args {
    /// The lab: its name, or its number; without it, every lab
    #[arg(value_name = "LAB", conflicts_with = "from")]
    lab: Option<String>,
    /// The folder of the labs; without it, `labs` of the checkout that you are in
    #[arg(long, value_name = "DIR", conflicts_with = "from")]
    labs: Option<PathBuf>,
    /// The folder of one lab
    #[arg(long, value_name = "DIR")]
    from: Option<PathBuf>,
    /// Write what is made from the solution: the starter src/lab.rs, and how the known mistakes fail,
    /// bugs/signatures.toml
    #[arg(long)]
    write: bool,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let folders = match &args.from {
        Some(folder) => vec![folder.clone()],
        None => {
            let names = match &args.lab {
                Some(name) => vec![super::lab(name)?.name],
                None => LabFiles::known_names(),
            };
            let (own, names): (Vec<_>, Vec<_>) =
                names.into_iter().partition(|name| LabFiles::own_folder(name).is_some());
            let own: Vec<PathBuf> = own.iter().filter_map(|name| LabFiles::own_folder(name)).collect();
            // Who brings a lab along need not have those of the kit at hand.
            let folder = if names.is_empty() { Ok(PathBuf::new()) } else { labs(args.labs.as_deref(), &names) };
            let of_kit: Vec<PathBuf> = match folder {
                Ok(folder) => names.iter().map(|name| folder.join(name)).collect(),
                Err(_) if args.lab.is_none() && !own.is_empty() => Vec::new(),
                Err(failure) => return Err(failure),
            };
            of_kit.into_iter().chain(own).collect()
        }
    };
    if args.write {
        folders.iter().try_for_each(|folder| write_starter(folder, &read(folder)?, out))?;
    }
    let labs = folders.iter().map(|folder| read(folder)).collect::<Result<Vec<_>, _>>()?;
    let mut answer = Answer::Yes;
    for (folder, lab) in folders.iter().zip(&labs) {
        writeln!(out, "{}: {} bugs against {} tests", lab.name, lab.bugs.len(), lab.manifest.tests.len())?;
        out.flush()?;
        let room = ScratchFolder::new("dcel-verify").map_err(|error| Failure::writing("a temporary folder", &error))?;
        let found = verify(lab, room.path()).map_err(|error| {
            Failure::input(format!("the lab cannot be built: {error}"), "a Rust toolchain is needed: see rustup.rs")
        })?;
        // Where nothing judges, or something is missing, nothing is known of how they fail.
        if !found.rows.is_empty() || found.holds() {
            writeln!(out, "{}", found.matrix().trim_end())?;
        }
        if args.write && !found.rows.is_empty() {
            let path = folder.join("bugs/signatures.toml");
            save::put(&path, found.signatures.to_text())?;
            writeln!(out, "{}: written", path.display())?;
        }
        for problem in &found.problems {
            failure::say("wrong", problem);
        }
        if found.holds() {
            writeln!(out, "{} grades rightly\n", lab.name)?;
        } else {
            answer = Answer::No;
        }
    }
    Ok(answer)
}

/// Writes the starter, if it is not what the solution makes of it. What is wrong with the marks is said by the
/// verification.
fn write_starter(folder: &Path, lab: &Lab, out: &mut Output) -> Result<(), Failure> {
    let made = lab.files.get("solution/lab.rs").and_then(|solution| starter(solution).ok());
    let Some(made) = made.filter(|made| lab.files.get("src/lab.rs") != Some(made)) else { return Ok(()) };
    let path = folder.join("src/lab.rs");
    save::put(&path, made)?;
    Ok(writeln!(out, "{}: written", path.display())?)
}

pub(super) fn read(folder: &Path) -> Result<Lab, Failure> {
    Lab::read(folder).map_err(|error| Failure::input(error, "mend what is named, or name the folder of another lab"))
}

/// The folder of the labs: the one named, or that of the checkout around this place.
pub(super) fn labs(named: Option<&Path>, names: &[String]) -> Result<PathBuf, Failure> {
    const HELP: &str = "go into a checkout of the kit, or name its folder with --labs DIR";
    let holds = |folder: &Path| names.iter().all(|name| folder.join(name).join("lab.toml").is_file());
    if let Some(folder) = named {
        let what = || Failure::input(format!("{}: {} is not there", folder.display(), names.join(", ")), HELP);
        return if holds(folder) { Ok(folder.to_owned()) } else { Err(what()) };
    }
    let here = std::env::current_dir().map_err(|error| Failure::input(error, HELP))?;
    let found = here.ancestors().map(|above| above.join("labs")).find(|folder| holds(folder));
    found.ok_or_else(|| Failure::input("no labs are here: a solution and wrong ones are not in this program", HELP))
}
