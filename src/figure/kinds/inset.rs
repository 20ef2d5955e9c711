//! A picture, and a part of it enlarged below: for structures in which long and short edges stand together.
//!
//! ```text
//!   ┌──────────────────────┐
//!   │              ┌─┐     │    a box round the part
//!   └──────────────┴─┴─────┘
//!     ╱              ╲          lines from the box to its enlargement
//!   ┌──────────────────────┐
//!   │  ●────▸●             │    the same elements; their ids begin with z-
//!   └──────────────────────┘
//! ```

use crate::figure::canvas::crop;
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::fit::Fit;
use crate::figure::layout::grid::GAP;
use crate::figure::structure::look::Look;
use crate::figure::structure::part::Part;
use crate::figure::structure::picture::Picture;
use crate::figure::structure::plate::Plate;
use crate::figure::structure::skeleton::{destination, half_edges};
use crate::figure::{Detail, Figure, FigureError, FigureOptions};
use crate::plane::{PlanarView, Point};

/// How many lengths of the shortest edge the part reaches from its middle, if nobody names the part.
const AROUND: f64 = 5.0;
/// The box is never drawn smaller than this.
const SMALLEST: f64 = 10.0;

/// Draws a structure, and below it the part between two corners enlarged; without corners, the surroundings of the shortest
/// edge. The title of the elements, their names and their level of detail are those of each drawing by itself.
///
/// Cost: that of two [structure](crate::figure::structure()) figures.
///
/// # Errors
/// Those of [`structure`](crate::figure::structure()).
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::{Point, Subdivision};
/// let points = [[0.0, 0.0], [1000.0, 0.0], [1001.0, 1.0], [1000.0, 2.0], [0.0, 500.0]];
/// let kite = Subdivision::polygon(&points.map(Point::from))?;
/// let svg = figure::inset(&kite, None, &FigureOptions::new("Kite"))?.to_svg();
/// assert!(svg.contains("id=\"kite-z-v2\""));
/// assert!(!svg.contains("id=\"kite-z-v0\""), "that corner is far away");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn inset(
    view: &dyn PlanarView,
    corners: Option<[[f64; 2]; 2]>,
    options: &FigureOptions,
) -> Result<Figure, FigureError> {
    let mut options = options.checked();
    options.crop = None;
    let view: &dyn PlanarView = &Part::of(view, &options)?;
    let (picture, mut notes) = Picture::new(view, &options)?;
    let (fit, detail) = (picture.fit, picture.detail);
    let mut scene = picture.scene(Vec::new());
    let (whole, noted) = nodes(picture, &Look::default());
    scene.nodes = whole;
    notes.0 = noted;

    let Some([a, b]) = corners.or_else(|| around_shortest(view)) else {
        return Ok(Figure { scene, detail, notes: notes.0 });
    };
    let mut close = options.clone().crop(a, b).face_labels(options.face_labels);
    close.width = Some(fit.size.x);
    let (picture, _) = Picture::new(view, &close)?;
    let (near, near_detail) = (picture.fit, picture.detail);
    let (enlarged, noted) = nodes(picture, &Look::instance("z"));
    notes.0.extend(noted.into_iter().map(|note| format!("enlarged: {note}")));

    let mut framed = crop::framed(enlarged, near.size, &close);
    framed.extend(outline(crop::window(near.size).grown(-0.5)));
    let shift = xy(0.5 * (fit.size.x - near.size.x), fit.size.y + 2.0 * GAP);
    let part = part(&fit, [a, b]);
    scene.nodes.extend(outline(part));
    let lower = [xy(part.min.x, part.max.y), part.max];
    let upper = [shift, shift + xy(near.size.x, 0.0)];
    scene.nodes.extend(lower.into_iter().zip(upper).map(|(from, to)| Node::Line { class: "leader", from, to }));
    scene.nodes.push(Node::Group(Group { class: "inset", shift: Some(shift), nodes: framed, ..Group::default() }));
    scene.size = xy(fit.size.x, shift.y + near.size.y);
    Ok(Figure { scene, detail: detail.max(near_detail), notes: notes.0 })
}

/// What is drawn of a picture, and what is left out.
fn nodes<V: PlanarView + ?Sized>(picture: Picture<'_, V>, look: &Look) -> (Vec<Node>, Vec<String>) {
    let mut notes = crate::figure::structure::notes::Notes::default();
    if picture.detail < Detail::Edges {
        let nodes = picture.by_tiles(&mut notes, look);
        return (nodes, notes.0);
    }
    let view = picture.view;
    let plate = Plate::place(picture, notes, &[]);
    (plate.nodes(view, look, Vec::new()), plate.notes.0)
}

/// The place of the part on the canvas.
fn part(fit: &Fit, corners: [[f64; 2]; 2]) -> Bounds {
    let placed = corners.map(|[x, y]| fit.place(Point::new(x, y)));
    let Bounds { min, max } = Bounds::of(placed).unwrap_or(Bounds { min: Xy::default(), max: Xy::default() });
    let air = xy((SMALLEST - (max.x - min.x)).max(0.0), (SMALLEST - (max.y - min.y)).max(0.0)) * 0.5;
    Bounds { min: min - air, max: max + air }
}

fn outline(b: Bounds) -> [Node; 4] {
    let corners = b.corners();
    [0, 1, 2, 3].map(|i| Node::Line { class: "leader", from: corners[i], to: corners[(i + 1) % 4] })
}

/// The surroundings of the shortest edge that has a length.
fn around_shortest(view: &dyn PlanarView) -> Option<[[f64; 2]; 2]> {
    let ends = |h| Some((view.position(view.origin(h)?)?, view.position(destination(view, h)?)?));
    let length = |a: Point, b: Point| (b.x - a.x).abs().max((b.y - a.y).abs());
    let edges = half_edges(view).filter_map(ends).filter(|&(a, b)| length(a, b) > 0.0);
    let (a, b) = edges.min_by(|&(a, b), &(p, q)| length(a, b).total_cmp(&length(p, q)))?;
    let (middle, far) = ([0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y], AROUND * length(a, b));
    Some([middle.map(|x| x - far), middle.map(|x| x + far)])
}
