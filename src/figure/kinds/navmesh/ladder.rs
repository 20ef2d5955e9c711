//! The ladder: the way of every rung, and how much longer it is than the shortest.
//!
//! ```text
//!   breadth 1.27 x      centroid 1.09 x     midpoint 1.04 x
//!   ┌────────────┐      ┌────────────┐      ┌────────────┐
//!   │ corridor   │      │            │      │            │       each with its own corridor and way,
//!   └────────────┘      └────────────┘      └────────────┘
//!   closest 1.00 x      exact               all ways
//!   ┌────────────┐      ┌────────────┐      ┌────────────┐       the last panel has all of them
//!   └────────────┘      └────────────┘      └────────────┘
//! ```

use crate::figure::kinds::navmesh::Floor;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Backdrop, Multiples, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::{Route, Rung};

impl Floor<'_> {
    /// The routes side by side, and all ways in one panel. Lengths are compared with the exact one, or with the least
    /// if none is exact.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn ladder(&self, routes: &[(Rung, Route)], options: &FigureOptions) -> Result<Figure, SketchError> {
        let exact = routes.iter().find(|(rung, _)| *rung == Rung::Exact).map(|(_, route)| route.length);
        let least = exact.unwrap_or_else(|| routes.iter().map(|(_, route)| route.length).fold(f64::INFINITY, f64::min));
        let mut sheet = Multiples::new();
        let mut together = Sketch::new();
        for (rung, route) in routes {
            let heading = match rung {
                Rung::Exact => format!("exact: {}", length(route.length)),
                _ => format!("{rung}: {}, {}", length(route.length), ratio(route.length, least)),
            };
            let mut sketch = Sketch::new();
            self.corridor(&mut sketch, route);
            for portal in self.portals(route) {
                let posts = [portal.left, portal.right].map(|v| self.mesh.point(v));
                sketch.path(Role::Secondary, posts).key("door of the corridor");
            }
            sketch.path(Role::Main, route.points.iter().copied()).arrow().key("the way through the corridor");
            self.marks(&mut sketch, route);
            self.blocked(&mut sketch);
            let about =
                format!("{}; {} faces, {} taken from the queue", how(*rung), route.faces.len(), route.work.pops);
            sheet.over(&heading, &about, self.map, Backdrop::Dimmed, sketch);
            // Under the dashed ones, the exact way shows where they leave it.
            if *rung == Rung::Exact {
                together.path(Role::Main, route.points.iter().copied()).key("exact");
            }
        }
        for (rung, route) in routes.iter().filter(|(rung, _)| *rung != Rung::Exact) {
            together.path(role(*rung), route.points.iter().copied()).key(rung.name());
        }
        if let Some((_, route)) = routes.first() {
            self.marks(&mut together, route);
        }
        sheet.over("all ways", "where one line is seen, they agree", self.map, Backdrop::Dimmed, together);
        sheet.columns(3).figure(&self.nameless(options))
    }
}

/// How much of the shortest way, as in `1.0274 x the shortest`.
fn ratio(value: f64, least: f64) -> String {
    if least > 0.0 { format!("{:.4} x the shortest", value / least) } else { "no length".to_owned() }
}

/// What a rung does.
const fn how(rung: Rung) -> &'static str {
    match rung {
        Rung::Breadth => "the fewest faces, then the funnel",
        Rung::Centroid => "A* from centroid to centroid, then the funnel",
        Rung::Midpoint => "A* from midpoint to midpoint of the doors, then the funnel",
        Rung::Closest => "A* to the closest point of each door, then the funnel",
        Rung::Aimed => "A* along the straight line to the goal, then the funnel",
        Rung::Exact => "cones instead of faces: the shortest way of all",
    }
}

/// How the way of a rung is drawn beside the others.
const fn role(rung: Rung) -> Role {
    match rung {
        Rung::Breadth => Role::Secondary,
        Rung::Centroid => Role::Event,
        Rung::Midpoint => Role::Wrong,
        Rung::Closest => Role::Right,
        Rung::Aimed => Role::Goal,
        Rung::Exact => Role::Main,
    }
}
