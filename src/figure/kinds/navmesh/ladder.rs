//! The ladder: the path of every path algorithm, and how much longer it is than the shortest.
//!
//! ```text
//!   breadth 1.27 x      centroid 1.09 x     midpoint 1.04 x
//!   ┌────────────┐      ┌────────────┐      ┌────────────┐
//!   │ corridor   │      │            │      │            │       each with its own corridor and way,
//!   └────────────┘      └────────────┘      └────────────┘
//!   closest 1.00 x      exact               all paths
//!   ┌────────────┐      ┌────────────┐      ┌────────────┐       the last panel has all of them
//!   └────────────┘      └────────────┘      └────────────┘
//! ```

use crate::figure::kinds::navmesh::Floor;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Backdrop, Multiples, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::{PathAlgorithm, Route};

impl Floor<'_> {
    /// The routes side by side, and all paths in one panel. Lengths are compared with the exact one, or with the least
    /// if none is exact.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn ladder(&self, routes: &[(PathAlgorithm, Route)], options: &FigureOptions) -> Result<Figure, SketchError> {
        let exact =
            routes.iter().find(|(algorithm, _)| *algorithm == PathAlgorithm::Exact).map(|(_, route)| route.length);
        let least = exact.unwrap_or_else(|| routes.iter().map(|(_, route)| route.length).fold(f64::INFINITY, f64::min));
        let mut sheet = Multiples::new();
        let mut together = Sketch::new();
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
            // Under the dashed ones, the exact way shows where they leave it.
            if *algorithm == PathAlgorithm::Exact {
                together.path(Role::Main, route.points.iter().copied()).key("exact");
            }
        }
        for (algorithm, route) in routes.iter().filter(|(algorithm, _)| *algorithm != PathAlgorithm::Exact) {
            together.path(role(*algorithm), route.points.iter().copied()).key(algorithm.name());
        }
        if let Some((_, route)) = routes.first() {
            self.marks(&mut together, route);
        }
        sheet.over("all paths", "where one line is seen, they agree", self.map, Backdrop::Dimmed, together);
        sheet.columns(3).figure(&self.nameless(options))
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

/// How the path of a path algorithm is drawn beside the others.
const fn role(algorithm: PathAlgorithm) -> Role {
    match algorithm {
        PathAlgorithm::Breadth => Role::Secondary,
        PathAlgorithm::Centroid => Role::Event,
        PathAlgorithm::Midpoint => Role::Wrong,
        PathAlgorithm::Closest => Role::Right,
        PathAlgorithm::Aimed => Role::Goal,
        PathAlgorithm::Exact => Role::Main,
    }
}
