//! What the caller may choose about a figure.

use crate::figure::canvas::scene::{Hatch, Scene};
use crate::figure::canvas::text;
use crate::figure::canvas::vector::Xy;
use crate::figure::layout::grid::{PANEL, SHEET};
use crate::figure::{Overrides, Style, Unit};
use crate::ids::{Element, FaceId, Id};
use crate::plane::Point;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The usual width of a figure.
pub(crate) const WIDTH: f64 = 640.0;
/// How far a small structure may grow, if it stands alone.
const WIDEST: f64 = 1600.0;

/// How much of the structure is drawn. Chosen by the median length of the edges on the canvas, and by their
/// number, unless the caller fixes it.
///
/// ```text
///   median edge   >= 60 px    25 .. 60    8 .. 25        < 8
///                  Full        Arrows      Edges         Tiles
///                 ●─ h4 ─▸●   ●────▸●     ·────·     one path per tile
///   at most        2,000       5,000      20,000     any number of edges and of vertices
/// ```
///
/// A caller who fixes `Arrows` or `Full` for far more edges than there is room for waits for it: arrows and labels
/// look at all edges within some 24 px, so that the time grows with the square of the edges that crowd.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Detail {
    /// Edges as a few paths for each tile of 64 px; faces one by one only if there are at most 2000.
    Tiles,
    /// Every edge, vertex and face, but no half-edges.
    Edges,
    /// Half-edges too, without labels.
    Arrows,
    /// Everything, with all labels that fit.
    Full,
}

/// What is written into the faces.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[non_exhaustive]
pub enum FaceLabels {
    /// Nothing.
    Off,
    /// Their ids.
    Ids,
    /// The names given by the caller, ids where there is none. Of several faces with one name (a country and
    /// its islands) the largest gets the label.
    #[default]
    Names,
}

/// Choices for [`structure`](crate::figure::structure). All have defaults.
///
/// ```
/// # use dcel_kit::figure::FigureOptions;
/// # use dcel_kit::FaceId;
/// let options = FigureOptions::new("Two rooms").width(480.0).face_name(FaceId::new(1), "kitchen");
/// assert_eq!(options.prefix(), "two-rooms");
/// ```
#[must_use = "the options are returned, not changed in place"]
#[derive(Clone, PartialEq, Debug)]
pub struct FigureOptions {
    pub(crate) title: String,
    pub(crate) description: Option<String>,
    id_prefix: Option<String>,
    pub(crate) style: Style,
    pub(crate) width: Option<f64>,
    pub(crate) height: Option<f64>,
    /// The width before it grows, if the caller names none.
    pub(crate) usual_width: f64,
    /// How wide it may grow.
    pub(crate) widest: f64,
    /// How many panels or frames stand side by side, if that is said.
    pub(crate) columns: Option<usize>,
    pub(crate) detail: Option<Detail>,
    pub(crate) vertex_labels: bool,
    pub(crate) half_edge_labels: bool,
    pub(crate) face_labels: FaceLabels,
    pub(crate) overrides: Overrides,
    pub(crate) faces: Option<Vec<FaceId>>,
    pub(crate) crop: Option<[Point; 2]>,
    pub(crate) reach: Vec<Point>,
    pub(crate) unit: Unit,
    pub(crate) plain: bool,
    pub(crate) interactive: bool,
    pub(crate) names: BTreeMap<FaceId, String>,
}

impl Default for FigureOptions {
    fn default() -> Self {
        Self::new("Half-edge structure")
    }
}

impl FigureOptions {
    /// The defaults, with this title. Readers of the page hear the title; ids begin with it.
    pub fn new(title: impl AsRef<str>) -> Self {
        Self {
            title: text::clean(title.as_ref()),
            description: None,
            id_prefix: None,
            style: Style::default(),
            width: None,
            height: None,
            usual_width: WIDTH,
            widest: WIDEST,
            columns: None,
            detail: None,
            vertex_labels: true,
            half_edge_labels: true,
            face_labels: FaceLabels::Names,
            overrides: Overrides::default(),
            faces: None,
            crop: None,
            reach: Vec::new(),
            unit: Unit::Px,
            plain: false,
            interactive: false,
            names: BTreeMap::new(),
        }
    }

    /// The longer text for screen readers. Default: the counts and how to read the arrows.
    pub fn description(mut self, text: impl AsRef<str>) -> Self {
        self.description = Some(text::clean(text.as_ref()));
        self
    }

    /// What every id and every CSS rule begins with; two figures of one page need different ones. Characters
    /// other than ASCII letters, digits and `-` become `-`. Default: made from the title.
    pub fn id_prefix(mut self, prefix: impl AsRef<str>) -> Self {
        self.id_prefix = Some(slug(prefix.as_ref(), false));
        self
    }

    /// The prefix of the ids that the figure will have.
    #[must_use]
    pub fn prefix(&self) -> String {
        self.id_prefix.clone().unwrap_or_else(|| slug(&self.title, true))
    }

    /// Colours, sizes and fonts. Default: [`Style::default`].
    pub fn style(mut self, style: Style) -> Self {
        self.style = style;
        self
    }

    /// Width of the canvas in px (100 to 20,000). Default: 640, and for at most 60 edges up to 1600, until the
    /// median edge is 110 px long. A drawing that reaches the height first makes the canvas narrower. A legend or a table
    /// then stands below the picture, not beside it.
    pub fn width(mut self, px: f64) -> Self {
        self.width = px.is_finite().then(|| px.clamp(100.0, 20_000.0));
        self
    }

    /// Greatest height of the canvas in px (100 to 20,000). Default: 5/4 of the width.
    pub fn max_height(mut self, px: f64) -> Self {
        self.height = px.is_finite().then(|| px.clamp(100.0, 20_000.0));
        self
    }

    /// Fixes the level of detail. Default: chosen, see [`Detail`].
    pub fn detail(mut self, detail: Detail) -> Self {
        self.detail = Some(detail);
        self
    }

    /// Leaves half-edges out of a drawing of so many edges: up to 5000 of them [`Detail::Edges`] is fixed, beyond the
    /// level is chosen, see [`Detail`].
    pub fn without_half_edges(self, edges: usize) -> Self {
        if edges <= 5000 { self.detail(Detail::Edges) } else { self }
    }

    /// How many panels of small multiples, or frames of a strip, stand side by side. Default: as many as a page of 830 px
    /// holds.
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = Some(columns.max(1));
        self
    }

    /// Keeps the structure in the background: all faces in one grey, names at faces alone.
    pub(crate) fn quiet(mut self) -> Self {
        self.style.tints = [crate::figure::Colour(0x00c8_cdd4); 7];
        self.style.light.tint_opacity = 0.36;
        if let Some(dark) = &mut self.style.dark {
            dark.tint_opacity = 0.3;
        }
        self.vertex_labels(false).half_edge_labels(false)
    }

    /// Whether vertices show their names. Default: yes.
    pub fn vertex_labels(mut self, on: bool) -> Self {
        self.vertex_labels = on;
        self
    }

    /// Whether half-edges show their names. Default: yes.
    pub fn half_edge_labels(mut self, on: bool) -> Self {
        self.half_edge_labels = on;
        self
    }

    /// What the faces show. Default: [`FaceLabels::Names`].
    pub fn face_labels(mut self, labels: FaceLabels) -> Self {
        self.face_labels = labels;
        self
    }

    /// Whether the half-edge under the mouse, with the keyboard's focus or named by the address (`file.svg#FIG-h5`)
    /// shows its pointers: next, prev (as the next of that), twin, face and origin. No script is needed. Needs
    /// [`Detail::Arrows`] at least. Default: no.
    pub fn interactive(mut self, on: bool) -> Self {
        self.interactive = on;
        self
    }

    /// Names one face. Faces with the same name share a tint, and one label. A name that reads like an id (`f0`) is drawn in
    /// quotation marks; a face with an empty name shows its id.
    pub fn face_name(mut self, face: FaceId, name: impl AsRef<str>) -> Self {
        self.names.insert(face, text::clean(name.as_ref()));
        self
    }

    /// Names many faces, see [`face_name`](Self::face_name).
    pub fn face_names<N: AsRef<str>>(self, names: impl IntoIterator<Item = (FaceId, N)>) -> Self {
        names.into_iter().fold(self, |options, (face, name)| options.face_name(face, name))
    }

    /// Colours and labels of single elements. Labels of faces are names, see [`face_name`](Self::face_name).
    pub fn overrides(mut self, overrides: Overrides) -> Self {
        self.names.extend(overrides.face_labels().map(|(face, name)| (face, name.to_owned())));
        self.overrides = overrides;
        self
    }

    /// Draws these faces only, with their half-edges and vertices, as large as there is room for. Default: all.
    /// Films always show all faces, and so do the tables of a page.
    pub fn faces(mut self, faces: impl IntoIterator<Item = FaceId>) -> Self {
        self.faces = Some(faces.into_iter().collect());
        self
    }

    /// Shows the part of the plane between two corners only: the picture ends there, without a free band round
    /// it. Default: everything. Corners that span no area, or that are no numbers, change nothing. Films always show
    /// everything.
    pub fn crop(mut self, corner: [f64; 2], opposite: [f64; 2]) -> Self {
        let [a, b] = [corner, opposite].map(|[x, y]| Point::new(x, y));
        let is_box = |a: Point, b: Point| [b.x - a.x, b.y - a.y].iter().all(|side| side.is_finite() && *side != 0.0);
        self.crop = is_box(a, b).then_some([a, b]);
        self
    }

    /// Leaves room for these points, too, as if there were vertices. Two figures of one width that reach to the same
    /// points have one scale, and what stands at one place stands at one place in both. Default: none. A cropped
    /// figure shows its window.
    pub fn reach(mut self, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let finite = |[x, y]: &[f64; 2]| x.is_finite() && y.is_finite();
        self.reach = points.into_iter().filter(finite).map(|[x, y]| Point::new(x, y)).collect();
        self
    }

    /// The unit in which the file states its width and height. Default: px, 96 of them an inch.
    pub fn unit(mut self, unit: Unit) -> Self {
        self.unit = unit;
        self
    }

    /// Whether the file has no style sheet: every element carries its colours and fonts itself, those for light
    /// pages. For slide and drawing programs that read no CSS. Default: no.
    pub fn plain(mut self, on: bool) -> Self {
        self.plain = on;
        self
    }

    /// The name of an element on the canvas: its label, or its id.
    pub(crate) fn caption<I: Id + Into<Element>>(&self, id: I) -> String {
        self.overrides.label_of(id).map_or_else(|| id.to_string(), str::to_owned)
    }

    /// How wide a figure may be with what stands beside its picture: as wide as the caller says, else a page.
    pub(crate) fn page(&self) -> f64 {
        self.width.unwrap_or(SHEET)
    }

    /// The style sheet of a figure.
    pub(crate) fn css(&self) -> String {
        let prefix = self.prefix();
        format!("{}{}", self.style.css(&prefix), self.overrides.css(&prefix))
    }

    /// A document of this kind without nodes; `about` is what it says of itself unless the caller describes it.
    pub(crate) fn scene(&self, kind: &str, size: Xy, about: String) -> Scene {
        let step = self.style.hatch_step;
        Scene {
            size,
            unit: self.unit,
            plain: self.plain,
            prefix: self.prefix(),
            title: self.title.clone(),
            description: self.description.clone().unwrap_or(about),
            attributes: vec![("data-figure", kind.to_owned())],
            css: self.css(),
            hatches: vec![
                Hatch { name: "hatch", step, degrees: 45 },
                Hatch { name: "hole-hatch", step: 1.6 * step, degrees: -45 },
            ],
            nodes: Vec::new(),
        }
    }

    /// The same options with a style that the layout can work with.
    pub(crate) fn checked(&self) -> Self {
        Self { style: self.style.checked(), ..self.clone() }
    }

    /// The same for panels on a sheet.
    pub(crate) fn of_panels(&self) -> Self {
        Self { usual_width: PANEL, widest: SHEET, ..self.checked() }
    }

    pub(crate) fn name(&self, face: FaceId) -> Option<&str> {
        self.names.get(&face).map(String::as_str)
    }

    /// The name of a face as it is drawn: none if it is empty; in quotation marks if it could be taken for an id.
    pub(crate) fn drawn_name(&self, face: FaceId) -> Option<Cow<'_, str>> {
        let name = self.name(face).filter(|name| !name.trim().is_empty())?;
        let number = name.trim().strip_prefix(['v', 'h', 'e', 'f']);
        let is_id = number.is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()));
        Some(if is_id { Cow::Owned(format!("\u{201c}{name}\u{201d}")) } else { Cow::Borrowed(name) })
    }
}

/// Letters, digits and single hyphens, beginning with a letter.
fn slug(text: &str, lower: bool) -> String {
    let mut out = String::new();
    for c in text.chars().take(64) {
        if c.is_ascii_alphanumeric() {
            out.push(if lower { c.to_ascii_lowercase() } else { c });
        } else if !out.is_empty() && !out.ends_with('-') {
            out.push('-');
        }
    }
    let out = out.trim_end_matches('-');
    match out.chars().next() {
        None => "figure".to_owned(),
        Some(c) if c.is_ascii_alphabetic() => out.to_owned(),
        Some(_) => format!("figure-{out}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_are_names_that_css_and_xml_accept() {
        for (title, prefix) in [
            ("The cube-like subdivision", "the-cube-like-subdivision"),
            ("5 steps", "figure-5-steps"),
            ("Ünïcode <&> \"x\"", "n-code-x"),
            ("", "figure"),
            ("---", "figure"),
        ] {
            assert_eq!(FigureOptions::new(title).prefix(), prefix, "{title}");
        }
        assert_eq!(FigureOptions::default().id_prefix("A b{}").prefix(), "A-b");
    }
}
