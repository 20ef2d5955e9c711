//! The options of figures that are about looks: theme, style file, part, colours.

use super::Failure;
use super::choice::{Choice, one_of};
use super::save::Files;
use super::subject::Subject;
use dcel_kit::FaceId;
use dcel_kit::figure::{FigureOptions, Overrides, Style, Theme, Unit};
use std::path::{Path, PathBuf};

/// How it looks.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Looks")]
pub(crate) struct Looks {
    /// Width, as a number of px or with mm or cm, 100 to 20000 px [default: 640, more for few edges]
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    width: Option<(f64, Unit)>,
    /// For which pages
    #[arg(long, value_name = "THEME", default_value = "auto", value_parser = one_of(THEMES))]
    theme: Theme,
    /// A JSON file with the fields of the style to change: colours, sizes, font
    #[arg(long, value_name = "FILE")]
    style: Option<PathBuf>,
    /// A file of colours and labels, a line an element: f3 #aabbcc "label"
    #[arg(long, value_name = "FILE")]
    colours: Option<PathBuf>,
    /// Draw these faces only
    #[arg(long, value_name = "f1,f3,...", value_delimiter = ',')]
    faces: Vec<FaceId>,
    /// Draw the part of the plane between two corners only
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = corners, allow_hyphen_values = true)]
    crop: Option<[f64; 4]>,
    /// No style sheet: for slide and drawing programs that read no CSS
    #[arg(long)]
    plain: bool,
}

/// For which pages a figure is.
static THEMES: &[Choice<Theme>] = &[
    ("auto", "Light, and dark for readers who prefer that", Theme::Auto),
    ("light", "Always light", Theme::Light),
    ("dark", "Always dark", Theme::Dark),
];

pub(super) fn length(text: &str) -> Result<(f64, Unit), String> {
    let (px, unit) = Unit::parse_length(text).map_err(|error| error.to_string())?;
    let in_range = (100.0..=20_000.0).contains(&px);
    if in_range { Ok((px, unit)) } else { Err("choose 100 to 20000 px, that is 26.5 to 5291 mm".to_owned()) }
}

pub(super) fn corners(text: &str) -> Result<[f64; 4], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse::<f64>()).collect();
    let numbers: Option<[f64; 4]> = numbers.ok().and_then(|numbers| numbers.try_into().ok());
    let is_box = |[x0, y0, x1, y1]: &[f64; 4]| [x1 - x0, y1 - y0].iter().all(|s| s.is_finite() && *s != 0.0);
    let help = "write two corners of a box as four numbers, for example 0,0,6,4";
    numbers.filter(is_box).ok_or_else(|| help.to_owned())
}

impl Looks {
    /// Adds the files that are read.
    pub(crate) fn files<'a>(&'a self, files: Files<'a>) -> Files<'a> {
        files.reads("--style", self.style.as_ref()).reads("--colours", self.colours.as_ref())
    }

    /// Adds the choices to `options`. Reads the files, which must fit the structure.
    pub(crate) fn apply(&self, options: FigureOptions, subject: &Subject) -> Result<FigureOptions, Failure> {
        let mut options = self.page(options)?;
        if let Some(path) = &self.colours {
            let refused = |error| Failure::input(format!("{}:{error}", path.display()), "");
            let overrides = Overrides::parse(&read(path)?).map_err(refused)?;
            overrides.check(subject.view()).map_err(refused)?;
            options = options.overrides(overrides);
        }
        if !self.faces.is_empty() {
            options = options.faces(self.faces.iter().copied());
        }
        if let Some([x0, y0, x1, y1]) = self.crop {
            options = options.crop([x0, y0], [x1, y1]);
        }
        Ok(options)
    }

    /// The choices that have nothing to do with a structure.
    pub(crate) fn page(&self, options: FigureOptions) -> Result<FigureOptions, Failure> {
        let style = match &self.style {
            None => Style::default(),
            Some(path) => Style::from_json(&read(path)?)
                .map_err(|error| Failure::input(format!("{}:{error}", path.display()), ""))?,
        };
        let options = options.plain(self.plain).style(style.theme(self.theme));
        Ok(match self.width {
            Some((px, unit)) => options.width(px).unit(unit),
            None => options,
        })
    }
}

fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path)
        .map_err(|error| Failure::input(format!("{}: cannot be read: {error}", path.display()), "name a text file"))
}
