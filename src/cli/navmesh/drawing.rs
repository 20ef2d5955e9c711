//! The figure of a command: where it goes, and how large it is.

use super::super::Output;
use super::super::failure::{Failure, say};
use super::super::looks;
use super::super::picture::{Pixels, Target};
use super::super::save::Files;
use super::map::Map;
use dcel_kit::figure::sketch::SketchError;
use dcel_kit::figure::{Figure, FigureOptions, Unit};
use dcel_kit::plane::Point;
use std::path::PathBuf;

/// The figure.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Figure")]
pub(super) struct Drawing {
    /// Draw it: .svg, or .png where the kit was built with it
    #[arg(short, long, value_name = "OUT.svg")]
    output: Option<PathBuf>,
    /// Width, as a number of px or with mm or cm
    #[arg(long, value_name = "LENGTH", value_parser = looks::length, requires = "output")]
    width: Option<(f64, Unit)>,
    /// Draw the part of the map between two corners only
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = looks::corners, allow_hyphen_values = true, requires = "output")]
    crop: Option<[f64; 4]>,
    #[command(flatten)]
    pixels: Pixels,
}

impl Drawing {
    /// Where it goes; refuses the file that is read, and names of other kinds. Before any work is done.
    pub(super) fn target(&self, input: &std::path::Path) -> Result<Option<Target>, Failure> {
        let Some(file) = &self.output else { return Ok(None) };
        Files::reading([input]).writes("-o", Some(file)).check()?;
        Target::new(Some(file), self.pixels).map(Some)
    }

    /// The choices about the size of a figure of this title.
    pub(super) fn options(&self, map: &Map, title: &str) -> FigureOptions {
        self.options_with(title, |p| map.point(p))
    }

    /// The same; `place` takes points of the file to those of the picture.
    pub(super) fn options_with(&self, title: &str, place: impl Fn([f64; 2]) -> Point) -> FigureOptions {
        let mut options = FigureOptions::new(title);
        if let Some((px, unit)) = self.width {
            options = options.width(px).unit(unit);
        }
        if let Some([x0, y0, x1, y1]) = self.crop {
            let [a, b] = [[x0, y0], [x1, y1]].map(place);
            options = options.crop([a.x, a.y], [b.x, b.y]);
        }
        options
    }
}

/// Writes a figure, and tells what could not be drawn.
pub(super) fn save(target: &Target, drawn: Result<Figure, SketchError>, out: &mut Output) -> Result<(), Failure> {
    let figure = drawn.map_err(|error| Failure::input(error, ""))?;
    figure.notes().iter().for_each(|note| say("note", note));
    target.write(&figure, out)
}
