//! The ladder: the path of every path algorithm, and how much longer it is than the shortest.
//!
//! ```text
//!   breadth 1.27 x      centroid 1.09 x     midpoint 1.04 x
//!   ┌────────────┐      ┌────────────┐      ┌────────────┐
//!   │ corridor   │      │            │      │            │       each with its own corridor and way,
//!   └────────────┘      └────────────┘      └────────────┘
//!   closest 1.00 x      exact               how much longer
//!   ┌────────────┐      ┌────────────┐      breadth  ▇▇▇▇▇▇▇▇
//!   └────────────┘      └────────────┘      centroid ▇▇▇           the last panel compares them all
//! ```

use crate::figure::kinds::navmesh::Floor;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Backdrop, Multiples, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::geometry::point::corners;
use crate::navmesh::{PathAlgorithm, Route};

/// The part of a panel's width that the names of the bars have.
const NAMES: f64 = 0.4;

impl Floor<'_> {
    /// The routes side by side, and a bar for each. Lengths are compared with the exact one, or with the least
    /// if none is exact.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn ladder(&self, routes: &[(PathAlgorithm, Route)], options: &FigureOptions) -> Result<Figure, SketchError> {
        let exact =
            routes.iter().find(|(algorithm, _)| *algorithm == PathAlgorithm::Exact).map(|(_, route)| route.length);
        let least = exact.unwrap_or_else(|| routes.iter().map(|(_, route)| route.length).fold(f64::INFINITY, f64::min));
        let mut sheet = Multiples::new();
        for (algorithm, route) in routes {
            let heading = match algorithm {
                PathAlgorithm::Exact => format!("exact: {}", length(route.length)),
                _ => format!("{algorithm}: {}, {}", length(route.length), ratio(route.length, least)),
            };
            let mut sketch = Sketch::new();
            self.corridor(&mut sketch, route);
            for portal in self.portal_ends(route) {
                let endpoints = [portal.left, portal.right].map(|v| self.mesh.point(v));
                sketch.path(Role::Secondary, endpoints).key("portal of the corridor");
            }
            sketch.path(Role::Main, route.points.iter().copied()).arrow().key("the path through the corridor");
            self.marks(&mut sketch, route);
            self.blocked(&mut sketch);
            let about =
                format!("{}; {} faces, {} taken from the queue", how(*algorithm), route.faces.len(), route.work.pops);
            sheet.over(&heading, &about, self.map, Backdrop::Dimmed, sketch);
        }
        sheet.sketch("how much longer", "than the shortest path", self.bars(routes, least));
        sheet.figure(&self.nameless(options))
    }

    /// A bar for each route: by how much it is longer than `least`.
    fn bars(&self, routes: &[(PathAlgorithm, Route)], least: f64) -> Sketch {
        let [low, high] = corners(self.map.vertices().map(|v| self.map.point(v)));
        let excess = |route: &Route| if least > 0.0 { route.length / least - 1.0 } else { 0.0 };
        let most = routes.iter().map(|(_, route)| excess(route)).fold(f64::MIN_POSITIVE, f64::max);
        let (width, step) = (high.x - low.x, (high.y - low.y) / routes.len().max(1) as f64);
        let left = low.x + NAMES * width;
        let mut sketch = Sketch::new();
        for (i, (algorithm, route)) in routes.iter().enumerate() {
            let middle = high.y - (i as f64 + 0.5) * step;
            let right = left + excess(route) / most * (high.x - left);
            let [top, bottom] = [middle + 0.25 * step, middle - 0.25 * step];
            let words = match algorithm {
                PathAlgorithm::Exact => algorithm.to_string(),
                _ => format!("{algorithm} + {:.1} %", 100.0 * excess(route)),
            };
            if right > left {
                let bar = [[left, bottom], [right, bottom], [right, top], [left, top]];
                sketch.region(Role::Main, [bar]).title(&words);
            }
            sketch.text(Role::Plain, [low.x + 0.5 * NAMES * width, middle], &words);
        }
        sketch.path(Role::Plain, [[left, low.y], [left, high.y]]).title("as short as can be");
        sketch
    }
}

/// How much of the shortest path, as in `1.0274 x the shortest`.
fn ratio(value: f64, least: f64) -> String {
    if least > 0.0 { format!("{:.4} x the shortest", value / least) } else { "no length".to_owned() }
}

/// What a path algorithm does.
const fn how(algorithm: PathAlgorithm) -> &'static str {
    match algorithm {
        PathAlgorithm::Breadth => "the fewest faces, then the funnel",
        PathAlgorithm::Centroid => "A* from centroid to centroid, then the funnel",
        PathAlgorithm::Midpoint => "A* from midpoint to midpoint of the portals, then the funnel",
        PathAlgorithm::Closest => "A* to the closest point of each portal, then the funnel",
        PathAlgorithm::Aimed => "A* along the straight line to the goal, then the funnel",
        PathAlgorithm::Exact => "cones instead of faces: the shortest path of all",
    }
}
