//! Triangulations: the diagonals that cut a subdivision, and Delaunay triangulations with their empty circles.
//!
//! ```text
//!   ┌───────┐        ╭───────╮
//!   │╲     ╱│       ╱ ●─────● ╲     no point lies inside the circle round a triangle
//!   │  ╲ ╱  │      │   ╲   ╱   │
//!   └───────┘       ╲    ●    ╱
//! ```

use crate::figure::sketch::{Backdrop, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::ids::EdgeId;
use crate::plane::Subdivision;

/// More diagonals than this are drawn as edges like all others.
const SKETCHED: usize = 400;

/// The diagonals of a subdivision that was cut into triangles or monotone pieces, over what it was before.
///
/// Cost: O(n log n).
///
/// # Errors
/// [`SketchError`].
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::{Subdivision, TriangulationMethod};
/// let before = Subdivision::lab_rectangle();
/// let mut after = before.clone();
/// let made = after.triangulate(TriangulationMethod::Monotone)?;
/// let svg = figure::triangulation(&before, &after, &made.diagonals, &FigureOptions::new("Cut"))?.to_svg();
/// assert_eq!(svg.matches("<title>diagonal e").count(), made.diagonals.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn triangulation(
    before: &Subdivision,
    after: &Subdivision,
    diagonals: &[EdgeId],
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    if diagonals.len() > SKETCHED {
        return Ok(crate::figure::structure(after, options)?);
    }
    // Without half-edges there is room to tell diagonals from edges.
    let options = options.clone().without_half_edges(before.edge_count());
    diagonals_of(after, diagonals).over(before, Backdrop::Plain, &options)
}

/// The diagonals as a sketch, to be laid over something, or a panel beside others.
#[must_use]
pub fn diagonals_of(after: &Subdivision, diagonals: &[EdgeId]) -> Sketch {
    let mut sketch = Sketch::new();
    for diagonal in diagonals {
        let ends = diagonal.half_edges().map(|h| after.point(after.origin(h)));
        sketch.path(Role::Main, ends).title(format!("diagonal {diagonal}")).key("diagonal");
    }
    sketch
}

/// A Delaunay triangulation; edges for which `stays` holds are those that had to stay. With `circles`, the circle round
/// each triangle.
///
/// Cost: O(n log n).
///
/// # Errors
/// [`SketchError`].
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::{Point, Subdivision};
/// let sites = [(0., 0.), (3., 1.), (1., 4.), (4., 5.)].map(Point::from);
/// let delaunay = Subdivision::delaunay(&sites)?.subdivision;
/// let svg = figure::delaunay(&delaunay, true, |_| false, &FigureOptions::new("Sites"))?.to_svg();
/// assert!(svg.contains("circle of f1") && svg.contains("circle of f2"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn delaunay(
    s: &Subdivision,
    circles: bool,
    stays: impl Fn(EdgeId) -> bool,
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    let mut sketch = Sketch::new();
    for f in s.faces().filter(|&f| circles && f != s.outer_face()) {
        let corners: Vec<_> = s.incident_vertices(f).map(|v| s.point(v)).collect();
        if let &[a, b, c] = corners.as_slice() {
            sketch.circumcircle(Role::Secondary, [a, b, c]).title(format!("circle of {f}")).key("empty circle");
        }
    }
    for e in s.edges().filter(|&e| stays(e)) {
        let ends = e.half_edges().map(|h| s.point(s.origin(h)));
        sketch.path(Role::Main, ends).title(format!("{e} stays")).key("edge that stays");
    }
    sketch.over(s, Backdrop::Plain, options)
}
