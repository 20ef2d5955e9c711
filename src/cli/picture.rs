//! A figure as a file: SVG, TeX, or PNG and PDF where the kit was built with them; the ending of the name decides.

use super::looks::{Crop, Dress, Page};
use super::{Failure, Output};
use dcel_kit::figure::{Figure, FigureOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Where a figure goes, in which form, and how it looks.
#[derive(Debug)]
pub(crate) struct Target {
    form: Form,
    dress: Dress,
}

#[derive(Debug)]
enum Form {
    /// SVG on standard output.
    Stdout,
    Svg(PathBuf),
    /// A document of its own.
    Tex(PathBuf),
    /// A picture for a document.
    Tikz(PathBuf),
    Pdf(PathBuf),
    /// With the pixels for each px.
    Png(PathBuf, f64),
    /// A film to be played.
    Page(PathBuf),
}

impl Target {
    /// What the name asks for; a name without an ending means SVG, none or `-` standard output. Reads the style file.
    pub(crate) fn new(path: Option<&Path>, page: &Page) -> Result<Self, Failure> {
        Self::in_one_of(path, page, false)
    }

    /// The same for a film: it may be a page, too.
    pub(crate) fn of_film(path: &Path, page: &Page) -> Result<Self, Failure> {
        Self::in_one_of(Some(path), page, true)
    }

    /// The same for a command that draws only if it is asked to by the option `flag`.
    pub(crate) fn optional(path: Option<&Path>, page: &Page, crop: Crop, flag: &str) -> Result<Option<Self>, Failure> {
        match (path, page.given().or(crop.given())) {
            (Some(path), _) => Self::new(Some(path), page).map(Some),
            (None, None) => Ok(None),
            (None, Some(option)) => {
                let what = format!("{option} is about a figure, and none is drawn");
                Err(Failure::input(what, format!("name one: {flag} OUT.svg")))
            }
        }
    }

    /// Whether the name of a file says what kind of picture it is.
    pub(crate) fn is_named(path: &Path) -> bool {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        ending.is_some_and(|ending| ["svg", "png", "pdf", "tex", "tikz", "html", "htm"].contains(&&*ending))
    }

    fn in_one_of(path: Option<&Path>, page: &Page, film: bool) -> Result<Self, Failure> {
        let dress = page.dress()?;
        let path = path.filter(|path| path.as_os_str() != "-");
        let ending = path.and_then(Path::extension).map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let form = match (path, ending.as_deref()) {
            (None, _) => Form::Stdout,
            (Some(path), Some("png")) if cfg!(feature = "png") => {
                Form::Png(path.to_owned(), dress.scale.unwrap_or(2.0))
            }
            (Some(path), Some("pdf")) if cfg!(feature = "png") => Form::Pdf(path.to_owned()),
            (Some(path), Some("png")) => return Err(not_built(path, "PNG", "")),
            (Some(path), Some("pdf")) => {
                let help = "; with Debian's librsvg2-bin: rsvg-convert -f pdf in.svg -o out.pdf";
                return Err(not_built(path, "PDF", help));
            }
            (Some(path), Some("tex")) => Form::Tex(path.to_owned()),
            (Some(path), Some("tikz")) => Form::Tikz(path.to_owned()),
            (Some(path), None | Some("svg")) => Form::Svg(path.to_owned()),
            (Some(path), Some("html" | "htm")) if film => Form::Page(path.to_owned()),
            (Some(path), Some("html" | "htm")) => {
                let what = format!("{}: a figure is no page", path.display());
                return Err(Failure::input(what, "end the name in .svg; dcel figure writes pages with --html"));
            }
            (Some(path), Some(_)) => {
                let kind = if film { "film" } else { "figure" };
                let what = format!("{}: a {kind} cannot be written in this format", path.display());
                let page = if film { ".html, " } else { "" };
                return Err(Failure::input(what, format!("end the name in {page}.svg, .png, .pdf, .tex or .tikz")));
            }
        };
        if dress.scale.is_some() && !matches!(form, Form::Png(..)) {
            let what = "--scale is for pixels, and this would have none";
            return Err(Failure::input(what, "give a name that ends in .png, or choose the size by --width"));
        }
        Ok(Self { form, dress })
    }

    /// The file, if it is one.
    pub(crate) fn path(&self) -> Option<&Path> {
        match &self.form {
            Form::Stdout => None,
            Form::Svg(path)
            | Form::Tex(path)
            | Form::Tikz(path)
            | Form::Pdf(path)
            | Form::Png(path, _)
            | Form::Page(path) => Some(path),
        }
    }

    /// Whether it is a page that plays a film.
    pub(crate) fn is_page(&self) -> bool {
        matches!(self.form, Form::Page(_))
    }

    /// The options with what was said about looks.
    pub(crate) fn options(&self, options: FigureOptions) -> FigureOptions {
        self.dress.put_on(options)
    }

    /// Writes the figure there.
    pub(crate) fn write(&self, figure: &Figure, out: &mut Output) -> Result<(), Failure> {
        let (path, bytes) = match &self.form {
            Form::Stdout => return Ok(out.write_all(figure.to_svg().as_bytes())?),
            Form::Svg(path) | Form::Page(path) => (path, figure.to_svg().into_bytes()),
            Form::Tex(path) => (path, figure.to_tex().into_bytes()),
            Form::Tikz(path) => (path, figure.to_tikz().into_bytes()),
            Form::Pdf(path) => (path, pdf(figure, path)?),
            Form::Png(path, scale) => (path, pixels(figure, path, *scale)?),
        };
        super::save::put(path, bytes)
    }
}

/// What figures of a file are called: by its name without the ending, or by another one if it is standard input.
pub(crate) fn title(file: &Path, unnamed: &str) -> String {
    let stem = file.file_stem().filter(|stem| *stem != "-");
    stem.map_or_else(|| unnamed.to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// Whether a name asks for a page.
pub(crate) fn is_page(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ["html", "htm"].iter().any(|page| ending.eq_ignore_ascii_case(page)))
}

#[cfg(feature = "png")]
fn pixels(figure: &Figure, path: &Path, scale: f64) -> Result<Vec<u8>, Failure> {
    tell_strange(figure);
    figure.to_png(scale).map_err(|error| Failure::about(path.display(), error))
}

#[cfg(feature = "png")]
fn pdf(figure: &Figure, path: &Path) -> Result<Vec<u8>, Failure> {
    tell_strange(figure);
    figure.to_pdf().map_err(|error| Failure::about(path.display(), error))
}

#[cfg(feature = "png")]
fn tell_strange(figure: &Figure) {
    let strange = figure.without_glyph();
    if !strange.is_empty() {
        super::failure::say("note", format_args!("boxes stand for what the bundled font does not have: {strange}"));
    }
}

#[cfg(not(feature = "png"))]
fn pixels(_: &Figure, path: &Path, _: f64) -> Result<Vec<u8>, Failure> {
    Err(not_built(path, "PNG", ""))
}

#[cfg(not(feature = "png"))]
fn pdf(_: &Figure, path: &Path) -> Result<Vec<u8>, Failure> {
    Err(not_built(path, "PDF", ""))
}

fn not_built(path: &Path, what: &str, more: &str) -> Failure {
    let what = format!("{}: this dcel was built without {what}", path.display());
    let help = "install one with it: cargo install --path . --features png; or run one: cargo run --release --features \
                png -- figure ...; or write an .svg";
    Failure::input(what, format!("{help}{more}"))
}
