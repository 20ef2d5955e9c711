//! A figure as a file: SVG, or PNG where the kit was built with it; the ending of the name decides.

use super::{Failure, Output};
use dcel_kit::figure::Figure;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What may be said about pixels.
#[derive(clap::Args, Clone, Copy, Debug)]
pub(crate) struct Pixels {
    /// Pixels of a .png for each px, 0.1 to 20 [default: 2]
    #[arg(long, value_name = "N")]
    scale: Option<f64>,
}

/// Where a figure goes, and in which form.
#[derive(Debug)]
pub(crate) enum Target {
    /// SVG on standard output.
    Stdout,
    Svg(PathBuf),
    /// With the pixels for each px.
    Png(PathBuf, f64),
}

impl Target {
    /// What the name asks for; a name without an ending means SVG, none or `-` standard output.
    pub(crate) fn new(path: Option<&Path>, pixels: Pixels) -> Result<Self, Failure> {
        let path = path.filter(|path| path.as_os_str() != "-");
        let ending = path.and_then(Path::extension).map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let target = match (path, ending.as_deref()) {
            (None, _) => Self::Stdout,
            (Some(path), Some("png")) if cfg!(feature = "png") => {
                return Ok(Self::Png(path.to_owned(), pixels.scale.unwrap_or(2.0)));
            }
            (Some(path), Some("png")) => return Err(without_png(path)),
            (Some(path), None | Some("svg")) => Self::Svg(path.to_owned()),
            (Some(path), Some("pdf")) => {
                let what = format!("{}: figures are SVG or PNG", path.display());
                let help = "write an .svg, then: rsvg-convert -f pdf in.svg -o out.pdf (Debian: librsvg2-bin)";
                return Err(Failure::input(what, help));
            }
            (Some(path), Some(_)) => {
                let what = format!("{}: this would be SVG or PNG", path.display());
                return Err(Failure::input(what, "give a name that ends in .svg or .png"));
            }
        };
        if pixels.scale.is_some() {
            let what = "--scale is for pixels, and this would be SVG";
            return Err(Failure::input(what, "give -o a name that ends in .png, or choose the size by --width"));
        }
        Ok(target)
    }

    /// The file, if it is one.
    pub(crate) fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::Svg(path) | Self::Png(path, _) => Some(path),
        }
    }

    /// Writes the figure there.
    pub(crate) fn write(&self, figure: &Figure, out: &mut Output) -> Result<(), Failure> {
        let (path, bytes) = match self {
            Self::Stdout => return Ok(out.write_all(figure.to_svg().as_bytes())?),
            Self::Svg(path) => (path, figure.to_svg().into_bytes()),
            Self::Png(path, scale) => (path, pixels(figure, path, *scale)?),
        };
        super::save::put(path, bytes)
    }
}

/// Whether a name asks for a page.
pub(crate) fn is_page(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ["html", "htm"].iter().any(|page| ending.eq_ignore_ascii_case(page)))
}

#[cfg(feature = "png")]
fn pixels(figure: &Figure, path: &Path, scale: f64) -> Result<Vec<u8>, Failure> {
    let strange = figure.without_glyph();
    if !strange.is_empty() {
        super::failure::say("note", format_args!("boxes stand for what the bundled font does not have: {strange}"));
    }
    figure.to_png(scale).map_err(|error| Failure::about(path.display(), error))
}

#[cfg(not(feature = "png"))]
fn pixels(_: &Figure, path: &Path, _: f64) -> Result<Vec<u8>, Failure> {
    Err(without_png(path))
}

fn without_png(path: &Path) -> Failure {
    let what = format!("{}: this dcel was built without PNG", path.display());
    let help = "install one with it: cargo install --path . --features png; or run one: cargo run --release --features \
                png -- figure ...; or write an .svg";
    Failure::input(what, help)
}
