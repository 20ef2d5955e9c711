//! The options of figures that are about looks: size, theme, style file, part, colours.

use super::Failure;
use super::choice::{Choice, number, numbers, one_of, within};
use super::save::Files;
use super::subject::Subject;
use dcel_kit::FaceId;
use dcel_kit::figure::{FigureOptions, Overrides, Style, Theme, Unit};
use dcel_kit::io::read_whole;
use dcel_kit::plane::Point;
use std::path::{Path, PathBuf};

/// How a figure looks, whatever it shows. Every command that draws takes these.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Looks")]
pub(crate) struct Page {
    /// Width, as a number of px or with mm or cm, 100 to 20000 px; of one panel or frame, if there are several
    /// [default: 640, more for few edges]
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    width: Option<(f64, Unit)>,
    /// For which pages [default: auto]
    #[arg(long, value_name = "THEME", value_parser = one_of(THEMES))]
    theme: Option<Theme>,
    /// A JSON file with the fields of the style to change: colours, sizes, font
    #[arg(long, value_name = "FILE")]
    style: Option<PathBuf>,
    /// No style sheet: for slide and drawing programs that read no CSS
    #[arg(long)]
    plain: bool,
    /// How many panels or frames stand side by side
    #[arg(long, value_name = "N", value_parser = within(1u16..=100))]
    columns: Option<u16>,
    /// Pixels of a .png for each px, 0.1 to 20 [default: 2]
    #[arg(long, value_name = "N", value_parser = number)]
    scale: Option<f64>,
}

/// Which part of the plane is drawn.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
#[command(next_help_heading = "Looks")]
pub(crate) struct Crop {
    /// Draw the part of the plane between two corners only
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = corners, allow_hyphen_values = true)]
    crop: Option<[f64; 4]>,
}

/// What is drawn of a structure, and in which colours.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Looks")]
pub(crate) struct Looks {
    /// A file of colours and labels, a line an element: f3 #aabbcc "label"
    #[arg(long, value_name = "FILE")]
    colours: Option<PathBuf>,
    /// Draw these faces only
    #[arg(long, value_name = "f1,f3,...", value_delimiter = ',')]
    faces: Vec<FaceId>,
}

/// A page whose style file was read.
#[derive(Clone, Debug)]
pub(crate) struct Dress {
    style: Style,
    page: Page,
}

/// For which pages a figure is.
static THEMES: &[Choice<Theme>] = &[
    ("auto", "Light, and dark for readers who prefer that", Theme::Auto),
    ("light", "Always light", Theme::Light),
    ("dark", "Always dark", Theme::Dark),
];

fn length(text: &str) -> Result<(f64, Unit), String> {
    let (px, unit) = Unit::parse_length(text).map_err(|error| error.to_string())?;
    let in_range = (100.0..=20_000.0).contains(&px);
    if in_range { Ok((px, unit)) } else { Err("choose 100 to 20000 px, that is 26.5 to 5291 mm".to_owned()) }
}

pub(crate) fn corners(text: &str) -> Result<[f64; 4], String> {
    let is_box = |[x0, y0, x1, y1]: &[f64; 4]| [x1 - x0, y1 - y0].iter().all(|s| s.is_finite() && *s != 0.0);
    let help = "write two corners of a box as four numbers, for example 0,0,6,4";
    numbers(text).filter(is_box).ok_or_else(|| help.to_owned())
}

impl Page {
    /// Adds the file that is read.
    pub(crate) fn files<'a>(&'a self, files: Files<'a>) -> Files<'a> {
        files.reads("--style", self.style.as_ref())
    }

    /// The first option that was given.
    pub(super) fn given(&self) -> Option<&'static str> {
        let all = [
            ("--width", self.width.is_some()),
            ("--theme", self.theme.is_some()),
            ("--style", self.style.is_some()),
            ("--plain", self.plain),
            ("--columns", self.columns.is_some()),
            ("--scale", self.scale.is_some()),
        ];
        all.iter().find(|(_, given)| *given).map(|(name, _)| *name)
    }

    /// Reads the style file.
    pub(super) fn dress(&self) -> Result<Dress, Failure> {
        let style = match &self.style {
            None => Style::default(),
            Some(path) => Style::from_json(&read(path)?)
                .map_err(|error| Failure::input(format!("{}:{error}", path.display()), ""))?,
        };
        let style = style.theme(self.theme.unwrap_or(Theme::Auto));
        Ok(Dress { style, page: self.clone() })
    }
}

impl Dress {
    /// Adds the choices to `options`.
    pub(crate) fn put_on(&self, options: FigureOptions) -> FigureOptions {
        let mut options = options.plain(self.page.plain).style(self.style.clone());
        if let Some((px, unit)) = self.page.width {
            options = options.width(px).unit(unit);
        }
        match self.page.columns {
            Some(columns) => options.columns(columns.into()),
            None => options,
        }
    }

    /// The pixels for each px, if they were asked for.
    pub(super) fn scale(&self) -> Option<f64> {
        self.page.scale
    }
}

impl Crop {
    /// Adds the part to `options`; `place` takes points of the file to those of the picture.
    pub(crate) fn apply(self, options: FigureOptions, place: impl Fn([f64; 2]) -> Point) -> FigureOptions {
        let Some([x0, y0, x1, y1]) = self.crop else { return options };
        let [a, b] = [[x0, y0], [x1, y1]].map(place);
        options.crop([a.x, a.y], [b.x, b.y])
    }

    /// The same where points are drawn where the file has them.
    pub(crate) fn apply_here(self, options: FigureOptions) -> FigureOptions {
        self.apply(options, Point::from)
    }

    /// The option, if it was given.
    pub(super) fn given(self) -> Option<&'static str> {
        self.crop.map(|_| "--crop")
    }
}

impl Looks {
    /// Adds the file that is read.
    pub(crate) fn files<'a>(&'a self, files: Files<'a>) -> Files<'a> {
        files.reads("--colours", self.colours.as_ref())
    }

    /// Adds the choices to `options`. Reads the file, which must fit the structure.
    pub(crate) fn apply(&self, mut options: FigureOptions, subject: &Subject) -> Result<FigureOptions, Failure> {
        if let Some(path) = &self.colours {
            let refused = |error| Failure::input(format!("{}:{error}", path.display()), "");
            let overrides = Overrides::parse(&read(path)?).map_err(refused)?;
            overrides.check(subject.view()).map_err(refused)?;
            options = options.overrides(overrides);
        }
        if !self.faces.is_empty() {
            options = options.faces(self.faces.iter().copied());
        }
        Ok(options)
    }
}

fn read(path: &Path) -> Result<String, Failure> {
    let bytes = read_whole(path)?;
    let text = String::from_utf8(bytes)
        .map_err(|_| Failure::input(format!("{}: this is not text in UTF-8", path.display()), "name a text file"))?;
    Ok(text.trim_start_matches('\u{feff}').to_owned())
}
