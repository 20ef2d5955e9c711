//! A route: the corridor of faces, the portals between them, the way.

use crate::figure::kinds::navmesh::{DOORS, Floor};
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::{Portal, Route};

impl Floor<'_> {
    /// The corridor, its portals with their left and right endpoints (up to 60 of them), and the path with its corners.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn route(&self, route: &Route, options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        self.corridor(&mut sketch, route);
        for portal in self.portal_ends(route) {
            let [left, right] = [portal.left, portal.right].map(|v| self.mesh.point(v));
            let key = "portal: its left endpoint a square, its right endpoint a ring";
            sketch.portal(Role::Secondary, left, right).key(key).title(format!("{} to {}", portal.from, portal.to));
        }
        let key = format!("the path, {}", length(route.length));
        sketch.path(Role::Main, route.points.iter().copied()).arrow().key(key);
        for &corner in &route.corners {
            sketch.point(Role::Event, self.mesh.point(corner)).key("a corner of the path").title(corner.to_string());
        }
        self.ends(&mut sketch, route);
        self.over(sketch, options)
    }

    /// The portals of a route, if they are few enough to be drawn.
    pub(super) fn portal_ends(&self, route: &Route) -> Vec<Portal> {
        if route.portals.len() <= DOORS { route.portal_ends(self.mesh).collect() } else { Vec::new() }
    }

    /// Adds the faces of a route.
    pub(super) fn corridor(&self, sketch: &mut Sketch, route: &Route) {
        let mut faces = route.faces.clone();
        // A route may enter a face twice; painted twice it would be a hole.
        faces.sort_unstable();
        faces.dedup();
        self.paint(sketch, Role::Main, faces.into_iter(), "the corridor");
    }

    /// Adds the start and the goal of a route, told in the legend: for pictures without room for words.
    pub(super) fn marks(&self, sketch: &mut Sketch, route: &Route) {
        if let [start, .., goal] = route.points.as_slice() {
            sketch.point(Role::Start, *start).key("start");
            sketch.point(Role::Goal, *goal).key("goal");
        }
    }

    /// Adds the start and the goal of a route.
    pub(super) fn ends(&self, sketch: &mut Sketch, route: &Route) {
        if let [start, .., goal] = route.points.as_slice() {
            sketch.point(Role::Start, *start).label("start");
            sketch.point(Role::Goal, *goal).label("goal");
        }
    }
}

/// A length with four digits behind the point, but no zeros at its end.
pub(super) fn length(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
