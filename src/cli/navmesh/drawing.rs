//! The figure of a command: where it goes, and how large it is.

use super::super::{Crop, Failure, Files, Output, Page, Target, say};
use super::map::Map;
use dcel_kit::figure::sketch::SketchError;
use dcel_kit::figure::{Figure, FigureOptions};
use dcel_kit::plane::Point;
use std::path::PathBuf;

/// The figure.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Figure")]
pub(super) struct Drawing {
    /// Draw it: .svg or .tex, .png or .pdf where the kit was built with them
    #[arg(short, long, value_name = "OUT.svg")]
    output: Option<PathBuf>,
    #[command(flatten)]
    page: Page,
    #[command(flatten)]
    crop: Crop,
}

/// Where a figure goes, and which part of the map it shows.
pub(super) struct Canvas {
    target: Target,
    crop: Crop,
}

impl Drawing {
    /// Where it goes; refuses the file that is read, and names of other kinds. Before any work is done.
    pub(super) fn target(&self, input: &std::path::Path) -> Result<Option<Canvas>, Failure> {
        self.page.files(Files::reading([input]).writes("-o", self.output.as_deref())).check()?;
        let target = Target::optional(self.output.as_deref(), &self.page, self.crop, "-o")?;
        Ok(target.map(|target| Canvas { target, crop: self.crop }))
    }
}

impl Canvas {
    /// The choices about a figure of this title.
    pub(super) fn options(&self, map: &Map, title: &str) -> FigureOptions {
        self.options_with(title, |p| map.point(p))
    }

    /// The same; `place` takes points of the file to those of the picture.
    pub(super) fn options_with(&self, title: &str, place: impl Fn([f64; 2]) -> Point) -> FigureOptions {
        self.crop.apply(self.target.options(FigureOptions::new(title)), place)
    }
}

/// Writes a figure, and tells what could not be drawn.
pub(super) fn save(canvas: &Canvas, drawn: Result<Figure, SketchError>, out: &mut Output) -> Result<(), Failure> {
    let figure = drawn.map_err(|error| Failure::input(error, ""))?;
    figure.notes().iter().for_each(|note| say("note", note));
    canvas.target.write(&figure, out)
}
