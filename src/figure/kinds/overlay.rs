//! Two subdivisions on each other: both, their overlay, and what belongs to one or to both; or a region made of them.
//!
//! ```text
//!   a              b              overlay          regions
//!   ┌──────┐          ┌──────┐    ┌──────┐         ┌──────┐        a alone, b alone, both, each in its colour
//!   │      │       │      │       │   ◆──┼──┐      │   ┌──┼──┐     ◆ where edges cross
//!   └──────┘       └──────┘       └───┼──◆  │      └───┼──┘  │
//!                                     └─────┘          └─────┘
//! ```

use crate::figure::canvas::text::counted;
use crate::figure::sketch::{Backdrop, Multiples, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::ids::FaceId;
use crate::plane::{Operation, Overlay, Subdivision};

/// a, b, both with their crossings, and what belongs to one of them or to both. Half-edges are drawn if there is room for
/// those of all.
///
/// Cost: O(n log n).
///
/// # Errors
/// [`SketchError`].
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::{Point, Subdivision};
/// let square = |x: f64| {
///     Subdivision::polygon(&[(x, x), (x + 2., x), (x + 2., x + 2.), (x, x + 2.)].map(Point::from))
/// };
/// let (a, b) = (square(0.)?, square(1.)?);
/// let both = a.overlay(&b)?;
/// let svg = figure::overlay(&a, &b, &both, &FigureOptions::new("Two squares"))?.to_svg();
/// assert!(svg.contains("in both") && svg.contains("2 crossings"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn overlay(
    a: &Subdivision,
    b: &Subdivision,
    both: &Overlay,
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    let s = &both.subdivision;
    let mut crossings = Sketch::new();
    both.crossings.iter().for_each(|&v| {
        crossings.point(Role::Event, s.point(v));
    });
    let mut regions = Sketch::new();
    add_region(&mut regions, Role::Main, s, |f| both.is_in(f) == [true, false], "in a alone");
    add_region(&mut regions, Role::Secondary, s, |f| both.is_in(f) == [false, true], "in b alone");
    add_region(&mut regions, Role::Goal, s, |f| both.is_in(f) == [true; 2], "in both");
    let faces = |s: &Subdivision| counted(s.face_count(), "face", "faces");
    let mut panels = Multiples::new();
    panels.structure("a", &faces(a), a);
    panels.structure("b", &faces(b), b);
    let text = format!("{}, {}", faces(s), counted(both.crossings.len(), "crossing", "crossings"));
    panels.over("overlay", &text, s, Backdrop::Plain, crossings);
    panels.sketch("regions", "faces of a and of b, without hole faces", regions);
    panels.figure(&roomy(options, [a, b, s]))
}

/// A region made by an operation on two subdivisions, and the edges it was made from.
///
/// Cost: O(n).
///
/// # Errors
/// [`SketchError`].
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::{Operation, Parts, Point, Subdivision};
/// let [a, b] = [0., 1.].map(|x| Subdivision::polygon(&[(x, 0.), (x + 2., 0.), (x, 2.)].map(Point::from)).unwrap());
/// let rest = a.overlay(&b)?.region(Operation::Difference, Parts::Joined)?;
/// let svg = figure::region([&a, &b], Operation::Difference, &rest, &FigureOptions::new("Rest"))?.to_svg();
/// assert!(svg.contains("edges of b"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn region(
    [a, b]: [&Subdivision; 2],
    operation: Operation,
    made: &Subdivision,
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    let mut sketch = Sketch::new();
    add_region(&mut sketch, Role::Main, made, |f| !made.is_hole(f), operation.name());
    outlines(&mut sketch, Role::Secondary, a, "edges of a");
    outlines(&mut sketch, Role::Goal, b, "edges of b");
    sketch.figure(&roomy(options, [a, b, made]))
}

/// Half-edges only if there is room for those of all.
fn roomy(options: &FigureOptions, drawn: [&Subdivision; 3]) -> FigureOptions {
    options.clone().without_half_edges(drawn.iter().map(|s| s.edge_count()).sum())
}

/// The outlines of the faces for which `chosen` holds.
fn add_region(sketch: &mut Sketch, role: Role, s: &Subdivision, chosen: impl Fn(FaceId) -> bool, key: &str) {
    let faces = s.faces().filter(|&f| f != s.outer_face() && chosen(f));
    let cycles = |f| s.cycles(f).map(|h| s.cycle(h).map(|h| s.point(s.origin(h))).collect::<Vec<_>>());
    let all: Vec<Vec<_>> = faces.flat_map(cycles).collect();
    if !all.is_empty() {
        sketch.region(role, all).key(key);
    }
}

/// All edges as lines.
fn outlines(sketch: &mut Sketch, role: Role, s: &Subdivision, key: &str) {
    for (i, e) in s.edges().enumerate() {
        let path = sketch.path(role, e.half_edges().map(|h| s.point(s.origin(h))));
        if i == 0 {
            path.key(key);
        }
    }
}
