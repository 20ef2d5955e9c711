//! Which figure `dcel figure` draws: the structure, a part enlarged, its pointers, one half-edge, its tables.

use super::choice::{Choice, one_of};
use super::looks;
use dcel_kit::figure::{self, Figure, FigureError, FigureOptions, Pointers};
use dcel_kit::plane::PlanarView;
use dcel_kit::{Element, HalfEdgeId};

/// What to show.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "What to show")]
pub(crate) struct Kind {
    /// A panel for each family of pointers, the rest grey
    #[arg(long, value_name = "FAMILY,…", value_delimiter = ',', group = "kind", value_parser = one_of(FAMILIES))]
    pointers: Vec<&'static [Pointers]>,
    /// One half-edge with all its pointers named, for example h5
    #[arg(long, value_name = "HALF-EDGE", group = "kind")]
    focus: Option<HalfEdgeId>,
    /// The vertex, half-edge and face tables beside the picture
    #[arg(long, group = "kind")]
    tables: bool,
    /// The dual graph over the structure: a point in each face, a line across each edge
    ///
    /// Time grows with the square of the edges of one face, if it is as winding as a spiral or a comb;
    /// so does the size, up to a limit.
    #[arg(long, group = "kind")]
    pub(crate) dual: bool,
    /// A part of the plane enlarged below the picture; `auto`: the surroundings of the shortest edge
    #[arg(long, value_name = "X0,Y0,X1,Y1|auto", group = "kind", value_parser = corners, allow_hyphen_values = true)]
    inset: Option<Window>,
    /// With --tables: the element marked in the picture and in its table, for example h5, v3 or f1
    #[arg(long, value_name = "ELEMENT", requires = "tables", value_parser = element)]
    highlight: Option<Element>,
}

/// A part of the plane, or the one that the kit chooses.
#[derive(Clone, Copy, Debug)]
struct Window(Option<[[f64; 2]; 2]>);

fn corners(text: &str) -> Result<Window, String> {
    if text == "auto" {
        return Ok(Window(None));
    }
    let [x0, y0, x1, y1] = looks::corners(text).map_err(|help| format!("{help}, or auto"))?;
    Ok(Window(Some([[x0, y0], [x1, y1]])))
}

/// A family of pointers, or all of them.
static FAMILIES: &[Choice<&[Pointers]>] = &[
    ("next", "The half-edge after each", &[Pointers::Next]),
    ("twin", "The other half of each", &[Pointers::Twin]),
    ("outgoing", "The half-edge that each vertex knows", &[Pointers::Outgoing]),
    ("half-edge", "The half-edge that each face knows", &[Pointers::Boundary]),
    ("face", "The face of each half-edge", &[Pointers::Face]),
    ("all", "All five", &Pointers::ALL),
];

fn element(text: &str) -> Result<Element, String> {
    let half_edge = || text.parse().map(Element::HalfEdge);
    let vertex = || text.parse().map(Element::Vertex);
    let face = || text.parse().map(Element::Face);
    let parsed = half_edge().or_else(|_| vertex()).or_else(|_| face());
    parsed.map_err(|_| "name a half-edge, a vertex or a face: h5, v3, f1".to_owned())
}

impl Kind {
    pub(crate) fn draw(&self, view: &dyn PlanarView, options: &FigureOptions) -> Result<Figure, FigureError> {
        if let Some(h) = self.focus {
            return figure::focus(view, h, options);
        }
        if let Some(Window(corners)) = self.inset {
            return figure::inset(view, corners, options);
        }
        if self.tables {
            return figure::tables(view, self.highlight, options);
        }
        if self.pointers.is_empty() {
            return figure::structure(view, options);
        }
        figure::pointers(view, &self.pointers.concat(), options)
    }
}
