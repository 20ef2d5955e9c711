//! Files that a command writes: which it may write, and how.

use super::failure::{is_json_wanted, say};
use super::{Failure, Output};
use dcel_kit::files::{WholeFolder, is_same_file, is_standard_input, write_whole};
use dcel_kit::io::{Format, Model, losses, write, write_path};
use std::io;
use std::path::{Path, PathBuf};

/// Leave to write the result over the input.
#[derive(clap::Args, Clone, Copy, Default, Debug)]
pub(crate) struct InPlace {
    /// Write the result over the input, which is refused otherwise
    #[arg(long)]
    in_place: bool,
}

/// The files of a call, with the flags that name them: what is read, and what is written.
#[derive(Default)]
pub(crate) struct Files<'a> {
    read: Vec<(&'static str, &'a Path)>,
    written: Vec<(&'static str, &'a Path)>,
    /// The flag of the output that may be the input, and whether it is said to be.
    in_place: Option<(&'static str, bool)>,
}

impl<'a> Files<'a> {
    /// The files that are read, without a flag.
    pub(crate) fn reading<P: AsRef<Path> + ?Sized + 'a>(files: impl IntoIterator<Item = &'a P>) -> Self {
        Self { read: files.into_iter().map(|file| ("", file.as_ref())).collect(), ..Self::default() }
    }

    /// A file that a flag names and that is read, too.
    pub(crate) fn reads(mut self, flag: &'static str, file: Option<&'a PathBuf>) -> Self {
        self.read.extend(file.map(|file| (flag, file.as_path())));
        self
    }

    /// A file that is written.
    pub(crate) fn writes(mut self, flag: &'static str, file: Option<&'a Path>) -> Self {
        self.written.extend(file.map(|file| (flag, file)));
        self
    }

    /// A structure that is written, over the input if that is said.
    pub(crate) fn writes_or_replaces(mut self, flag: &'static str, file: Option<&'a Path>, in_place: InPlace) -> Self {
        self.in_place = Some((flag, in_place.in_place));
        self.writes(flag, file)
    }

    /// What is read.
    pub(crate) fn sources(&self) -> Vec<PathBuf> {
        self.read.iter().map(|(_, file)| file.to_path_buf()).collect()
    }

    /// Refuses to write over what is read, and to write two results into one file or onto standard output. Before any
    /// work is done.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        self.check_standard_output()?;
        let mut replaced = false;
        for (i, &(flag, target)) in self.written.iter().enumerate() {
            let may_be = self.in_place.filter(|(output, _)| *output == flag);
            for &(source, file) in &self.read {
                if !overwrites(file, target) {
                    continue;
                }
                if source.is_empty() && may_be.is_some_and(|(_, said)| said) {
                    replaced = true;
                    continue;
                }
                return Err(over_an_input(source, file, target, may_be.is_some() && source.is_empty()));
            }
            for &(other, file) in &self.written[..i] {
                if overwrites(file, target) {
                    let what = format!("{}: {} and {flag} would both be written there", target.display(), other);
                    return Err(Failure::input(what, "name two files"));
                }
            }
        }
        if let Some((output, true)) = self.in_place.filter(|_| !replaced) {
            let what = format!("--in-place: what {output} names is not the input");
            return Err(Failure::input(what, "leave --in-place out, or name the input again as the output"));
        }
        Ok(())
    }

    /// Standard output holds one result: the answer in JSON is one, too.
    fn check_standard_output(&self) -> Result<(), Failure> {
        let mut there = self.written.iter().filter(|(_, file)| file.as_os_str() == "-").map(|&(flag, _)| flag);
        let Some(first) = there.next() else { return Ok(()) };
        let other = if is_json_wanted() { Some("--json") } else { there.next() };
        other.map_or(Ok(()), |other| {
            let what = format!("{first} - and {other} would both be written to standard output");
            Err(Failure::call(what, format!("name a file after {first}, or leave {other} out")))
        })
    }
}

fn over_an_input(flag: &str, file: &Path, target: &Path, may_be: bool) -> Failure {
    let other = match file {
        file if file == target => String::new(),
        file if file.as_os_str() == "-" => ", which is standard input".to_owned(),
        file => format!(", which is {}", file.display()),
    };
    let what = match flag {
        "" if file == target => "this is the input itself".to_owned(),
        "" => format!("this is the input itself under another name{other}"),
        flag => format!("{flag} reads this file{other}"),
    };
    let help = if may_be { "choose another name, or say --in-place" } else { "choose another name" };
    Failure::input(format!("{}: {what}", target.display()), help)
}

/// Whether writing one would destroy the other.
fn overwrites(file: &Path, target: &Path) -> bool {
    let is_named = |path: &Path| path.as_os_str() != "-";
    if !is_named(file) {
        return is_named(target) && with_partners(target).iter().any(|target| is_standard_input(target));
    }
    is_named(target) && with_partners(file).iter().any(|a| with_partners(target).iter().any(|b| is_same_file(a, b)))
}

/// The file, and those that belong to it: of Triangle's formats the one with the points or the triangles.
fn with_partners(path: &Path) -> Vec<PathBuf> {
    let partners: &[&str] = match Format::from_path(path) {
        Some(Format::Triangle) => &["node", "ele"],
        Some(Format::Poly) => &["node"],
        _ => &[],
    };
    [path.to_owned()].into_iter().chain(partners.iter().map(|end| path.with_extension(end))).collect()
}

/// Writes a file, whole or not at all.
pub(crate) fn put(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
    write_whole(path, bytes).map_err(|error| Failure::writing(path.display(), &error))
}

/// Writes a structure; the end of the name decides the format. `-` is dcel text on standard output.
pub(crate) fn save(path: &Path, model: &Model<'_>, out: &mut Output) -> Result<(), Failure> {
    save_as(path, None, Format::Dcel, "end it in .dcel", model, out)
}

/// Writes a structure in this format, or in the one that the end of the name tells, and says what it loses; `usual` is the
/// format of standard output. `help` says how to name a file whose format is not known.
pub(crate) fn save_as(
    path: &Path,
    format: Option<Format>,
    usual: Format,
    help: &str,
    model: &Model<'_>,
    out: &mut Output,
) -> Result<(), Failure> {
    let format = format.or_else(|| Format::from_path(path));
    let lost = losses(model, format.unwrap_or(usual));
    let written = match format {
        format if path.as_os_str() == "-" => write(out, model, format.unwrap_or(usual)),
        Some(format) => write_path(path, model, format),
        None => {
            let what = format!("{}: the file name does not say which format to write", path.display());
            return Err(Failure::input(what, help));
        }
    };
    written.map_err(|error| Failure::of_writing(path, error))?;
    lost.iter().for_each(|note| say("note", note));
    Ok(())
}

/// Makes a folder with these files, by their paths in it. One that exists must be empty: nothing is ever written over. The
/// folder is there when it is complete, and not before.
pub(crate) fn put_folder<'a>(dir: &Path, files: impl IntoIterator<Item = (&'a str, &'a [u8])>) -> Result<(), Failure> {
    const ANOTHER: &str = "name a folder that does not exist yet";
    let folder = WholeFolder::create(dir).map_err(|error| match error.kind() {
        io::ErrorKind::DirectoryNotEmpty => Failure::input(format!("{}: is not empty", dir.display()), ANOTHER),
        io::ErrorKind::NotADirectory => Failure::input(format!("{}: {error}", dir.display()), ANOTHER),
        _ => Failure::writing(dir.display(), &error),
    })?;
    let written = files.into_iter().try_for_each(|(path, bytes)| folder.write(path, bytes));
    written.and_then(|()| folder.commit()).map_err(|error| Failure::writing(dir.display(), &error))
}
