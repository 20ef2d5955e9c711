//! A figure as a file: SVG, TeX, or PNG and PDF where the kit was built with them; the ending of the name decides.

use super::looks::{Crop, Dress, Page};
use super::{Failure, Output};
use dcel_kit::figure::{Figure, FigureOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Where a figure goes, in which form, and how it looks.
#[derive(Debug)]
pub(crate) struct Target {
    /// None is standard output.
    path: Option<PathBuf>,
    form: Form,
    dress: Dress,
}

#[derive(Debug)]
enum Form {
    Svg,
    /// A document of its own.
    Tex,
    /// A picture for a document.
    Tikz,
    Pdf,
    /// With the pixels for each px.
    Png(f64),
    /// A film to be played.
    Page,
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
            (None, _) | (_, None | Some("svg")) => Form::Svg,
            (_, Some("png")) if cfg!(feature = "png") => Form::Png(dress.scale().unwrap_or(2.0)),
            (_, Some("pdf")) if cfg!(feature = "png") => Form::Pdf,
            (Some(path), Some("png")) => return Err(not_built(path, "PNG", "")),
            (Some(path), Some("pdf")) => {
                let help = "; with Debian's librsvg2-bin: rsvg-convert -f pdf in.svg -o out.pdf";
                return Err(not_built(path, "PDF", help));
            }
            (_, Some("tex")) => Form::Tex,
            (_, Some("tikz")) => Form::Tikz,
            (_, Some("html" | "htm")) if film => Form::Page,
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
        if dress.scale().is_some() && !matches!(form, Form::Png(..)) {
            let what = "--scale is for pixels, and this would have none";
            return Err(Failure::input(what, "give a name that ends in .png, or choose the size by --width"));
        }
        Ok(Self { path: path.map(Path::to_owned), form, dress })
    }

    /// The file, if it is one.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Whether it is a page that plays a film.
    pub(crate) fn is_page(&self) -> bool {
        matches!(self.form, Form::Page)
    }

    /// The options with what was said about looks.
    pub(crate) fn options(&self, options: FigureOptions) -> FigureOptions {
        self.dress.put_on(options)
    }

    /// Writes the figure there.
    pub(crate) fn write(&self, figure: &Figure, out: &mut Output) -> Result<(), Failure> {
        let path = self.path().unwrap_or("-".as_ref());
        let bytes = match self.form {
            Form::Svg | Form::Page => figure.to_svg().into_bytes(),
            Form::Tex => figure.to_tex().into_bytes(),
            Form::Tikz => figure.to_tikz().into_bytes(),
            Form::Pdf => rendered(figure, path, None)?,
            Form::Png(scale) => rendered(figure, path, Some(scale))?,
        };
        if self.path.is_some() { super::save::put(path, bytes) } else { Ok(out.write_all(&bytes)?) }
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

/// A figure as pixels, so many for each px, or as PDF.
#[cfg(feature = "png")]
fn rendered(figure: &Figure, path: &Path, scale: Option<f64>) -> Result<Vec<u8>, Failure> {
    let strange = figure.without_glyph();
    if !strange.is_empty() {
        super::failure::say("note", format_args!("boxes stand for what the bundled font does not have: {strange}"));
    }
    let made = match scale {
        Some(scale) => figure.to_png(scale).map_err(|error| error.to_string()),
        None => figure.to_pdf().map_err(|error| error.to_string()),
    };
    made.map_err(|error| Failure::about(path.display(), error))
}

#[cfg(not(feature = "png"))]
fn rendered(_: &Figure, path: &Path, _: Option<f64>) -> Result<Vec<u8>, Failure> {
    Err(not_built(path, "PNG", ""))
}

fn not_built(path: &Path, what: &str, more: &str) -> Failure {
    let what = format!("{}: this dcel was built without {what}", path.display());
    let help = "install one with it: cargo install --path . --features png; or run one: cargo run --release --features \
                png -- figure ...; or write an .svg";
    Failure::input(what, format!("{help}{more}"))
}
