//! What a command that makes a structure of the plane does with it: writes it, draws it, tells of it.

use super::picture::title;
use super::save::{Files, InPlace, save};
use super::{Answer, Crop, Failure, Output, Page, Target, say, tell};
use dcel_kit::figure::{Figure, FigureOptions};
use dcel_kit::io::{LeftOut, Model};
use std::io;
use std::path::{Path, PathBuf};

/// Where the results go.
#[derive(clap::Args, Debug)]
pub(crate) struct Results {
    /// Write the structure, for example as .dcel; - for dcel text instead of the report
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    in_place: InPlace,
    /// Draw it: .svg or .tex, .png or .pdf where the kit was built with them
    #[arg(long, value_name = "OUT.svg")]
    figure: Option<PathBuf>,
    #[command(flatten)]
    page: Page,
    #[command(flatten)]
    crop: Crop,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

/// A vertex that rounding has moved. The names are those of the JSON form.
#[derive(serde::Serialize)]
pub(crate) struct Moved {
    vertex: String,
    by: f64,
}

impl Moved {
    pub(crate) fn all(list: &[(dcel_kit::VertexId, f64)]) -> Vec<Self> {
        list.iter().map(|&(v, by)| Self { vertex: v.to_string(), by }).collect()
    }
}

impl Results {
    /// Refuses to write over the input, unless that is said, and to write two results into one file.
    pub(crate) fn check(&self, input: &Path) -> Result<(), Failure> {
        let files = Files::reading([input])
            .writes_or_replaces("-o", self.output.as_deref(), self.in_place)
            .writes("--figure", self.figure.as_deref());
        self.page.files(files).check()?;
        Target::optional(self.figure.as_deref(), &self.page, self.crop, "--figure").map(drop)
    }

    /// Whether the structure itself is the answer on standard output.
    pub(crate) fn is_text(&self) -> bool {
        self.output.as_ref().is_some_and(|path| path.as_os_str() == "-")
    }

    /// Draws, if asked to; the title is the name of the input, or this one for standard input without a name.
    pub(crate) fn draw(
        &self,
        input: &Path,
        unnamed: &str,
        out: &mut Output,
        draw: impl FnOnce(FigureOptions) -> Result<Figure, Failure>,
    ) -> Result<(), Failure> {
        let Some(target) = Target::optional(self.figure.as_deref(), &self.page, self.crop, "--figure")? else {
            return Ok(());
        };
        let drawn = draw(self.crop.apply_here(target.options(FigureOptions::new(title(input, unnamed)))))?;
        drawn.notes().iter().for_each(|note| say("note", note));
        target.write(&drawn, out)
    }

    /// If the structure is written, says what the input has of it that no structure holds.
    pub(crate) fn tell_left_out(&self, left_out: &LeftOut) {
        let notes = self.output.iter().flat_map(|_| left_out.notes(false));
        notes.for_each(|note| say("note", note));
    }

    /// Writes the structure, if asked to, and tells what was found, unless the structure is the answer.
    pub(crate) fn finish(
        &self,
        model: &Model<'_>,
        answer: &impl serde::Serialize,
        out: &mut Output,
        print: impl FnOnce(&mut Output) -> io::Result<()>,
    ) -> Result<Answer, Failure> {
        if let Some(path) = &self.output {
            save(path, model, out)?;
        }
        if self.is_text() { Ok(Answer::Yes) } else { tell(answer, self.json, out, print) }
    }
}
