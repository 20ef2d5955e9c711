//! The way of an agent with a radius: the margin it keeps, the corridor that is left, the agent where it turns.

use crate::figure::kinds::navmesh::Floor;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::{Inset, Route};
use crate::plane::Point;

impl Floor<'_> {
    /// A route through an inset of this map: the margin, in which the middle of the agent must not be, the corridor
    /// beside it, the way, and the agent at its ends.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn clearance(&self, inset: &Inset, route: &Route, options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        let own = Floor::new(inset.map(), inset.mesh());
        // Inside the map and not inside the inset: twice inside is outside.
        let map = self.mesh.faces().filter(|&f| self.mesh.is_walkable(f)).map(|f| self.ring(f));
        let rings: Vec<Vec<Point>> = map.chain(inset.mesh().faces().map(|f| own.ring(f))).collect();
        let radius = inset.radius();
        sketch.region(Role::Wrong, rings).plain().key(format!("nearer to a border than the radius, {radius}"));
        own.corridor(&mut sketch, route);
        let key = format!("the path, {}", length(route.length));
        sketch.path(Role::Main, route.points.iter().copied()).arrow().key(key);
        if let [start, .., goal] = route.points.as_slice() {
            sketch.circle(Role::Start, *start, radius).key("the agent at the start");
            sketch.circle(Role::Goal, *goal, radius).key("the agent at the goal");
        }
        self.ends(&mut sketch, route);
        self.over(sketch, options)
    }
}
