//! The drawing vocabulary: what a part of the kit needs to draw itself in a few lines, in the look of all figures.
//!
//! ```text
//!   Sketch ── region, path, ray, line, circle, arc, cone, point, portal, text, badge    world coordinates, y up
//!     │           each with a role: Main, Secondary, Start, Goal, Event, Right, Wrong …
//!     ├─ figure(options)                   alone
//!     ├─ over(view, backdrop, options)     on a half-edge structure, one layout for both
//!     └─ Multiples                         panels of one layout side by side
//! ```
//!
//! ```
//! use dcel_kit::figure::FigureOptions;
//! use dcel_kit::figure::sketch::{Role, Sketch};
//!
//! let mut sketch = Sketch::new();
//! sketch.region(Role::Plain, [vec![[0.0, 0.0], [8.0, 0.0], [8.0, 5.0], [0.0, 5.0]]]);
//! sketch.path(Role::Main, [[1.0, 1.0], [4.0, 3.0], [7.0, 4.0]]).arrow().key("the shortest path");
//! sketch.portal(Role::Secondary, [3.0, 5.0], [4.0, 3.0]).label("portal");
//! sketch.point(Role::Start, [1.0, 1.0]).label("start");
//! sketch.badge(Role::Wrong, [4.0, 3.0], "the path touches this corner");
//! let svg = sketch.figure(&FigureOptions::new("A path"))?.to_svg();
//! assert!(svg.contains("id=\"a-path-s-path-1\""));
//! # Ok::<(), dcel_kit::figure::sketch::SketchError>(())
//! ```
//!
//! What lies outside of the picture is cut off at its frame: rays and lines always, the rest if
//! [`crop`](super::FigureOptions::crop) chooses a part of the plane. Painted are areas first, then lines, portals,
//! points and words; within a kind, what was added first. Labels and badges look for places where they cover
//! neither each other nor a line or a mark; what finds none is in the [notes](super::Figure::notes).
//!
//! Of more than 2000 things those without a label are drawn in bulk: lines as a few thin paths, points as small dots,
//! one group for each role and kind in place of an id and a title for each. So 10^5 points take 1 MB.
//!
//! ```text
//!   clip.rs       Lines that end at the frame, and wedges cut by it
//!   draw.rs       From things to shapes, and where their labels may stand
//!   glyph.rs      Marks of points, told apart by their shape
//!   item.rs       One thing of a sketch, and what can be said about it
//!   legend.rs     The legend
//!   many.rs       Very many things
//!   multiples.rs  Small multiples
//!   places.rs     Where words stand: near what they belong to, on nothing
//!   role.rs       What things are for: the colour, the dash and the mark of each role
//!   round.rs      Circles and arcs, cut by the frame
//!   sheet.rs      A sketch on its canvas
//! ```

mod clip;
mod draw;
mod glyph;
mod item;
mod legend;
mod many;
mod multiples;
mod places;
mod role;
mod round;
mod sheet;

pub use crate::figure::sketch::multiples::Multiples;
pub use glyph::Glyph;
pub use item::Item;
pub use role::Role;
pub use sheet::Backdrop;

pub(in crate::figure) use draw::Canvas;
pub(in crate::figure) use legend::{Entry, merged, nodes as legend_nodes};
pub(in crate::figure) use multiples::Drawn;
#[cfg(feature = "solid")]
pub(in crate::figure) use multiples::common_fit;
pub(in crate::figure) use sheet::{Below, Drawing, check, extent, lone_fit, roles, scene};

use super::FigureError;
use crate::plane::{CoordinateError, Point};
use item::Kind;

/// Why a sketch cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SketchError {
    /// A coordinate is not a number, infinite, or too large to compute with.
    #[error("{item}: {error}")]
    Coordinate {
        /// The item, by its id.
        item: String,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// The structure below cannot be drawn.
    #[error(transparent)]
    Structure(#[from] FigureError),
}

/// Things to be drawn, in the coordinates of the plane.
///
/// Every method adds one thing and returns it, so that it can be told more: its label, its title for screen
/// readers, what the legend says about it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Sketch {
    items: Vec<Item>,
    /// How many things there are of each kind.
    counts: [usize; Kind::COUNT],
}

impl Sketch {
    /// Nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The things in the order in which they were added.
    #[must_use]
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    fn add(&mut self, role: Role, kind: Kind) -> &mut Item {
        let count = &mut self.counts[kind.number()];
        *count += 1;
        self.items.push(Item::new(role, kind, *count));
        let last = self.items.len() - 1;
        &mut self.items[last]
    }

    /// The inside of closed outlines by the even-odd rule: an outline inside another one is a hole.
    pub fn region<R, P>(&mut self, role: Role, rings: impl IntoIterator<Item = R>) -> &mut Item
    where
        R: IntoIterator<Item = P>,
        P: Into<Point>,
    {
        let rings = rings.into_iter().map(|ring| ring.into_iter().map(Into::into).collect()).collect();
        self.add(role, Kind::Region(rings))
    }

    /// A line from point to point.
    pub fn path<P: Into<Point>>(&mut self, role: Role, points: impl IntoIterator<Item = P>) -> &mut Item {
        self.add(role, Kind::Path(points.into_iter().map(Into::into).collect()))
    }

    /// From a point through another one as far as the frame. Both count for the size of the picture.
    pub fn ray(&mut self, role: Role, from: impl Into<Point>, through: impl Into<Point>) -> &mut Item {
        self.add(role, Kind::Ray([from.into(), through.into()]))
    }

    /// Through two points, from frame to frame.
    pub fn line(&mut self, role: Role, a: impl Into<Point>, b: impl Into<Point>) -> &mut Item {
        self.add(role, Kind::Line([a.into(), b.into()]))
    }

    /// A circle; [`filled`](Item::filled) makes it a disc.
    pub fn circle(&mut self, role: Role, centre: impl Into<Point>, radius: f64) -> &mut Item {
        self.add(role, Kind::Circle { centre: centre.into(), radius, fits: true })
    }

    /// The circle through three points, dashed. It does not count for the size of the picture: a triangle that is
    /// almost flat has a very large one. Three points of a line have none; that is noted.
    pub fn circumcircle(&mut self, role: Role, points: [impl Into<Point>; 3]) -> &mut Item {
        self.add(role, Kind::round_through(points.map(Into::into))).dashed()
    }

    /// Counter-clockwise round `centre`, from the point `from` to the direction of `to`.
    pub fn arc(
        &mut self,
        role: Role,
        centre: impl Into<Point>,
        from: impl Into<Point>,
        to: impl Into<Point>,
    ) -> &mut Item {
        self.add(role, Kind::Arc([centre.into(), from.into(), to.into()]))
    }

    /// What is seen from `apex` between two rays: counter-clockwise from the one through `right` to the one through
    /// `left`, as far as the frame, or as far as [`until`](Item::until) says.
    pub fn cone(
        &mut self,
        role: Role,
        apex: impl Into<Point>,
        right: impl Into<Point>,
        left: impl Into<Point>,
    ) -> &mut Item {
        self.add(role, Kind::Cone { corners: [apex.into(), right.into(), left.into()], end: None })
    }

    /// A point with the mark of its role.
    pub fn point(&mut self, role: Role, at: impl Into<Point>) -> &mut Item {
        self.add(role, Kind::Point(at.into(), role.glyph()))
    }

    /// A passage: a thick line whose left end (seen by who passes) has a square, its right end a ring.
    pub fn portal(&mut self, role: Role, left: impl Into<Point>, right: impl Into<Point>) -> &mut Item {
        self.add(role, Kind::Portal([left.into(), right.into()]))
    }

    /// Words at a point, or as near to it as there is room.
    pub fn text(&mut self, role: Role, at: impl Into<Point>, words: impl AsRef<str>) -> &mut Item {
        self.add(role, Kind::Text(at.into())).label(words)
    }

    /// A numbered disc at a point, or as near to it as there is room. The legend says what the number means. Badges
    /// are numbered from 1 in the order in which they are added.
    pub fn badge(&mut self, role: Role, at: impl Into<Point>, words: impl AsRef<str>) -> &mut Item {
        self.add(role, Kind::Badge(at.into())).key(words)
    }
}
