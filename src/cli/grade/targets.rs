//! `FORMAT=FILE`: where a report goes.

use super::super::{Failure, Output};
use dcel_kit::lab::Report;
use dcel_kit::lab::reports::Format;
use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::str::FromStr;

/// What stands for the name of a submission in the name of a file.
const PLACE: &str = "{submission}";

/// A format and a file.
#[derive(Clone, Debug)]
pub(super) struct Target {
    format: Format,
    file: String,
}

impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let known = || Format::ALL.map(Format::name).join(", ");
        let (name, file) = text.split_once('=').ok_or("write FORMAT=FILE, for example html=class.html")?;
        let format =
            Format::by_name(name).ok_or_else(|| format!("there is no format `{name}`; there is {}", known()))?;
        if file.is_empty() {
            return Err("after the `=` comes the name of a file, or `-`".to_owned());
        }
        Ok(Self { format, file: file.to_owned() })
    }
}

impl Target {
    pub(super) fn is_standard_output(&self) -> bool {
        self.file == "-"
    }

    /// Writes the reports: one file, or one each where the name has a place for the name of the submission.
    pub(super) fn write(&self, reports: &[Report], out: &mut Output) -> Result<(), Failure> {
        if self.file.contains(PLACE) {
            let mut taken = BTreeSet::new();
            for report in reports {
                self.put(&self.file.replace(PLACE, &free_name(report, &mut taken)), &self.format.one(report), out)?;
            }
            return Ok(());
        }
        let text = match reports {
            [report] => self.format.one(report),
            _ => self.format.class(reports).map_err(|error| {
                let what = error.to_string();
                let (what, help) = what.split_once("; ").unwrap_or((&what, ""));
                Failure::input(what, help)
            })?,
        };
        self.put(&self.file, &text, out)
    }

    fn put(&self, file: &str, text: &str, out: &mut Output) -> Result<(), Failure> {
        if self.is_standard_output() {
            return Ok(out.write_all(text.as_bytes())?);
        }
        if let Some(parent) = Path::new(file).parent() {
            fs::create_dir_all(parent).map_err(|error| Failure::writing(parent.display(), &error))?;
        }
        fs::write(file, text).map_err(|error| Failure::writing(file, &error))
    }
}

/// The name of a submission as part of a file's name, a different one for each.
fn free_name(report: &Report, taken: &mut BTreeSet<String>) -> String {
    let name = report.submission.as_deref().unwrap_or("submission");
    let plain: String =
        name.chars().map(|c| if c.is_alphanumeric() || "-_.@+ ".contains(c) { c } else { '_' }).collect();
    let plain = plain.trim_matches(['.', ' ']).to_owned();
    let plain = if plain.is_empty() { "submission".to_owned() } else { plain };
    let numbered = |i: u32| if i == 1 { plain.clone() } else { format!("{plain}-{i}") };
    let name = (1..).map(numbered).find(|name| !taken.contains(name)).unwrap_or_else(|| numbered(0));
    taken.insert(name.clone());
    name
}
