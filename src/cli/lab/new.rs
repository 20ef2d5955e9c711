//! `dcel lab new`: a lab of one's own.

use super::super::{Answer, Failure, Output};
use super::folder;
use dcel_lab::{Kit, NewLabError, Packed, new_lab, typed};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Make a lab of your own: a whole one that grades rightly, to be changed into yours
#[derive(clap::Args, Debug)]
#[command(after_help = "\
What is made is a lab with one task, two tests and one known mistake: count the edges on the border. Change \
README.md, solution/lab.rs and judge/lib.rs step by step; `lab verify` in program/ says after each step whether \
it still grades rightly. program/ is the program `dcel` with your lab in it: it checks, grades, verifies and \
exports.

The kit is found in the checkout that you are in; else --kit says where it is.

Examples:
  dcel lab new 12-mine --kit version=0.1
  dcel lab new 12-mine labs/12-mine --kit path=../dcel-kit")]
pub(crate) struct Args {
    /// The lab: a number, `-` and small letters
    #[arg(value_name = "NAME")]
    name: String,
    /// The folder to make; without it, one of that name here
    #[arg(value_name = "DIR")]
    dir: Option<PathBuf>,
    /// Where the kit is: path=FOLDER, git=URL or version=NUMBER
    #[arg(long, value_name = "PLACE")]
    kit: Option<Kit>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let kit = match &args.kit {
        // Where the lab is moved to, the kit must still be found.
        Some(Kit::Path(path)) => Kit::Path(checkout(path)?),
        Some(kit) => kit.clone(),
        None => around_here().map_or_else(|| Kit::Version(env!("CARGO_PKG_VERSION").to_owned()), Kit::Path),
    };
    let files = new_lab(&args.name, &kit).map_err(|error| match &error {
        NewLabError::Name(name) => {
            Failure::input(format!("`{name}` cannot be a lab"), "write a number, `-` and small letters: 12-mine")
        }
        error => Failure::input(error, "see `dcel help lab new`"),
    })?;
    let number = args.name.split('-').next().unwrap_or_default();
    let dir = args.dir.clone().unwrap_or_else(|| PathBuf::from(&args.name));
    let packed = files.into_iter().map(|(path, text)| (path, Packed::from(text))).collect();
    folder::make(&dir, &packed)?;
    let shown = dir.display();
    writeln!(out, "{}: a lab of one task, in {shown}", args.name)?;
    writeln!(out, "  {shown}/README.md           what students read")?;
    writeln!(out, "  {shown}/solution/lab.rs     the marked solution; src/lab.rs is made from it")?;
    writeln!(out, "  {shown}/judge/lib.rs        the cases, and what is right")?;
    writeln!(out, "  {shown}/bugs/, lab.toml     known mistakes, tests and points")?;
    writeln!(out, "\nNext:\n  cd {}", typed(&dir.join("program")))?;
    writeln!(
        out,
        "  cargo run -- lab verify {number}       does it grade rightly? (the first time it builds the kit)"
    )?;
    writeln!(out, "  cargo run -- lab start {number} DIR    the folder of a student")?;
    Ok(Answer::Yes)
}

/// The checkout of the kit around this place.
fn around_here() -> Option<PathBuf> {
    let here = std::env::current_dir().ok()?;
    here.ancestors().find(|above| is_checkout(above)).map(Path::to_owned)
}

fn is_checkout(folder: &Path) -> bool {
    ["src/lab/Cargo.toml", "src/cli/Cargo.toml"].iter().all(|file| folder.join(file).is_file())
}

/// A checkout that was named, as a path that holds from everywhere.
fn checkout(path: &Path) -> Result<PathBuf, Failure> {
    const HELP: &str = "name the folder of a checkout of the kit, the one with src/lab/Cargo.toml";
    if !is_checkout(path) {
        return Err(Failure::input(format!("{}: no checkout of the kit is there", path.display()), HELP));
    }
    std::path::absolute(path).map_err(|error| Failure::input(error, HELP))
}
