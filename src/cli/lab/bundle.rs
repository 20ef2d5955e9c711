//! `dcel lab bundle`: what is compiled into the kit of labs and sources, written anew.

use super::super::{Answer, Failure, Output, save};
use dcel_kit::files::ScratchFolder;
use dcel_lab::{COPIES, KitBuild, LabFiles, Package};
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Write anew what is compiled into the kit: the labs, the manifests and versions of its own sources
#[derive(clap::Args, Debug)]
pub(crate) struct Args {
    /// The repository
    #[arg(value_name = "DIR", default_value = ".")]
    dir: PathBuf,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    const HELP: &str = "go to the root of the kit's repository";
    for name in LabFiles::bundled_names() {
        let lab = LabFiles::read(&args.dir.join("labs").join(&name)).map_err(|error| Failure::input(error, HELP))?;
        let path = args.dir.join("src/lab/bundle").join(format!("{name}.txt"));
        let lab = lab.handed_out();
        save::put(&path, lab.to_archive())?;
        writeln!(out, "{}: {} files", path.display(), lab.iter().count())?;
    }
    for (made, of) in COPIES {
        let text =
            fs::read_to_string(args.dir.join(of)).map_err(|error| Failure::input(format!("{of}: {error}"), HELP))?;
        save::put(&args.dir.join(made), text)?;
    }
    for build in KitBuild::ALL {
        let folder = args.dir.join(build.folder());
        let manifests = build.manifests(&args.dir).map_err(|error| Failure::input(error, HELP))?;
        save::put(&folder.join("Cargo.lock.txt"), versions(&args.dir, build, &manifests)?)?;
        writeln!(out, "{}: {} packages", folder.display(), manifests.len())?;
        for (package, manifest) in manifests {
            save::put(&folder.join(format!("{}.toml.txt", package.name())), manifest)?;
        }
    }
    Ok(Answer::Yes)
}

/// The lock file of a build, as cargo writes it: the versions of the checkout, as far as they are needed.
fn versions(checkout: &Path, build: KitBuild, manifests: &BTreeMap<Package, String>) -> Result<String, Failure> {
    let made = || -> std::io::Result<String> {
        let scratch = ScratchFolder::new("dcel-bundle")?;
        let folder = scratch.path();
        for (path, text) in build.workspace(manifests) {
            let path = folder.join(path);
            fs::create_dir_all(path.parent().unwrap_or(folder))?;
            fs::write(path, text)?;
        }
        fs::copy(checkout.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let ran = Command::new(cargo).args(["update", "--workspace", "--offline"]).current_dir(folder).output()?;
        if !ran.status.success() {
            return Err(std::io::Error::other(String::from_utf8_lossy(&ran.stderr).into_owned()));
        }
        fs::read_to_string(folder.join("Cargo.lock"))
    };
    made().map_err(|error| Failure::writing("a temporary folder", &error))
}
