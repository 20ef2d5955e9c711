//! What the exact search looked at: its cones.

use crate::figure::kinds::navmesh::Floor;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::{Cone, Route};
use crate::plane::Point;

/// So many cones are drawn at most, the first ones.
const CONES: usize = 400;

impl Floor<'_> {
    /// The cones that a search has looked at, each from its root to the portal it falls on, and the path that was found.
    /// Of more than 400 cones the first are drawn.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn cones(&self, cones: &[Cone], route: &Route, options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        let drawn = &cones[..cones.len().min(CONES)];
        let key = format!("what is seen from the root of a cone; {} of {} cones", drawn.len(), cones.len());
        for cone in drawn {
            let ring = [cone.root, cone.right, cone.left];
            sketch
                .region(Role::Event, [ring])
                .key(&key)
                .title(format!("through the portal of {} to {}", cone.from, cone.to));
        }
        // The start has its own mark; every other root is drawn once.
        let start = route.points.first().copied();
        let mut roots: Vec<Point> = drawn.iter().map(|cone| cone.root).filter(|&p| Some(p) != start).collect();
        roots.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        roots.dedup();
        for root in roots {
            sketch.point(Role::Event, root).key("a corner round which a path may bend");
        }
        sketch.path(Role::Main, route.points.iter().copied()).arrow().key("the shortest path");
        self.ends(&mut sketch, route);
        self.blocked(&mut sketch);
        self.over(&sketch, &self.nameless(options))
    }
}
