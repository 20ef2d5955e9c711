//! What the exact search looked at: its cones.

use crate::figure::kinds::navmesh::route::length;
use crate::figure::kinds::navmesh::{Floor, Panel};
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
            let title = format!("through the portal of {} to {}", cone.from, cone.to);
            sketch.region(Role::Event, [[cone.root, cone.right, cone.left]]).key(&key).title(title);
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
        self.over(sketch, &self.nameless(options))
    }

    /// The panel of the cone with number `i`, after those before it.
    pub(in crate::figure) fn cone_panel(&self, cones: &[Cone], i: usize, route: &Route, number: &str) -> Panel {
        let mut sketch = Sketch::new();
        for cone in &cones[i.saturating_sub(CONES)..i] {
            sketch.region(Role::Dimmed, [[cone.root, cone.right, cone.left]]).key("cone that was met before");
        }
        let cone = &cones[i];
        sketch.region(Role::Event, [[cone.root, cone.right, cone.left]]).key("what is seen from its root");
        sketch.portal(Role::Secondary, cone.left, cone.right).key("the part of the portal that is seen");
        sketch.point(Role::Event, cone.root).key("the root of the cone");
        self.marks(&mut sketch, route);
        let far = length(cone.length);
        let text = format!("from {} through a portal into {}; {far} from the start to its root", cone.from, cone.to);
        (format!("Cone {number}"), text, sketch)
    }

    /// The panel of the path that was found.
    pub(in crate::figure) fn path_panel(&self, cones: usize, route: &Route) -> Panel {
        let mut sketch = Sketch::new();
        sketch.path(Role::Main, route.points.iter().copied()).arrow().key("the shortest path");
        self.marks(&mut sketch, route);
        ("The shortest path".to_owned(), format!("{} long, after {cones} cones", length(route.length)), sketch)
    }
}
