//! Voronoi diagrams: the cells of a window, or the edges alone, as far as they run.
//!
//! ```text
//!   cells                        edges
//!   ┌──────┬────────┐            ╲  ·   ╱
//!   │  •   │   •    │         •   ○────○   •     • site, ○ Voronoi vertex; rays end at the frame; over
//!   ├────┬─┴──┬─────┤            ╱  ·   ╲        both, if asked for, the Delaunay edges
//!   └────┴────┴─────┘
//! ```

use crate::figure::sketch::{Backdrop, Glyph, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::geometry::point::corners;
use crate::plane::{Voronoi, VoronoiCells, Window};

/// With more corners of cells than this, these have no marks of their own.
const MARKED: usize = 300;

/// The cells with their sites; with `triangulation`, the Delaunay edges over them.
///
/// Few cells are drawn one by one, many as paths by tiles and dots (see [`Detail`](crate::figure::Detail)): 10^5 sites take
/// some 3 MB.
///
/// Cost: O(n log n).
///
/// # Errors
/// [`SketchError`].
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::{Point, Subdivision, Window};
/// let sites = [(0., 0.), (3., 1.), (1., 4.)].map(Point::from);
/// let delaunay = Subdivision::delaunay(&sites)?.subdivision;
/// let voronoi = delaunay.voronoi()?;
/// let cells = voronoi.cells(Window::around(&sites))?;
/// let svg = figure::voronoi_cells(&voronoi, &cells, true, &FigureOptions::new("Cells"))?.to_svg();
/// assert!(svg.contains("site v2") && svg.contains("Delaunay edge"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn voronoi_cells(
    voronoi: &Voronoi<'_>,
    cells: &VoronoiCells,
    triangulation: bool,
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    let mut sketch = Sketch::new();
    let [low, high] = corners(cells.subdivision.vertices().map(|v| cells.subdivision.point(v)));
    add_sites(&mut sketch, voronoi, &Window { low, high }, triangulation);
    let options = options.clone().without_half_edges(cells.subdivision.edge_count());
    sketch.over(&cells.subdivision, Backdrop::Plain, &options)
}

/// The edges without any cells, cut off at the window; with `triangulation`, the Delaunay edges over them.
///
/// Cost: O(n log n).
///
/// # Errors
/// [`SketchError`].
pub fn voronoi_edges(
    voronoi: &Voronoi<'_>,
    window: &Window,
    triangulation: bool,
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    let mut sketch = Sketch::new();
    for edge in voronoi.edges() {
        let Some([from, to]) = voronoi.piece(edge, window) else { continue };
        let item = match edge.ends {
            [Some(_), Some(_)] => sketch.path(Role::Main, [from, to]),
            [Some(_), None] => sketch.ray(Role::Main, from, to),
            [None, Some(_)] => sketch.ray(Role::Main, to, from),
            [None, None] => sketch.line(Role::Main, from, to),
        };
        let [left, right] = edge.sites;
        item.title(format!("between {left} and {right}")).key("Voronoi edge");
    }
    add_sites(&mut sketch, voronoi, window, triangulation);
    let Window { low, high } = window;
    sketch.figure(&options.clone().crop([low.x, low.y], [high.x, high.y]))
}

/// The corners of the cells inside the window, if they are few; the triangulation, if asked for, and the sites, in the colour
/// of their edges.
fn add_sites(sketch: &mut Sketch, voronoi: &Voronoi<'_>, window: &Window, triangulation: bool) {
    let delaunay = voronoi.delaunay();
    if voronoi.corners().len() <= MARKED {
        for &corner in voronoi.corners().iter().filter(|&&corner| window.contains(corner)) {
            sketch.point(Role::Plain, corner).glyph(Glyph::Ring).title("a Voronoi vertex").key("Voronoi vertex");
        }
    }
    if triangulation {
        for e in delaunay.edges() {
            let ends = e.half_edges().map(|h| delaunay.point(delaunay.origin(h)));
            sketch.path(Role::Secondary, ends).title(format!("{e} of the triangulation")).key("Delaunay edge");
        }
    }
    for v in delaunay.vertices() {
        sketch.point(Role::Secondary, delaunay.point(v)).title(format!("site {v}")).key("site");
    }
}
