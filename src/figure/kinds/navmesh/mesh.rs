//! What a navmesh knows before anybody asks for a way.

use crate::figure::kinds::navmesh::Floor;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::plane::Point;

impl Floor<'_> {
    /// The dual graph: a node for each face, a line through the portal for each pair of neighbours. Faces that lead
    /// nowhere else, and the portals to them, are grey.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn dual(&self, options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        for f in self.mesh.faces() {
            for side in self.mesh.sides(f).filter(|side| side.open && f < side.across) {
                let [a, b] = [side.from, side.to].map(|v| self.mesh.point(v));
                let portal = Point::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
                let dead = self.mesh.is_dead_end(f) || self.mesh.is_dead_end(side.across);
                let (role, key) = if dead { (Role::Dimmed, "to a dead end") } else { (Role::Main, "neighbours") };
                let way = [self.middle(f), portal, self.middle(side.across)];
                sketch.path(role, way).key(key).title(format!("{f} and {} across {}", side.across, side.half_edge));
            }
        }
        for f in self.mesh.faces().filter(|&f| self.mesh.is_walkable(f)) {
            let role = if self.mesh.is_dead_end(f) { Role::Dimmed } else { Role::Main };
            sketch.point(role, self.middle(f)).title(f.to_string());
        }
        self.over(sketch, options)
    }

    /// Dead ends: the faces that searches leave out unless the start or the goal lies in them, each with an arrow to
    /// the face by which it is left. What remains is the core.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn dead_ends(&self, options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        let walkable = || self.mesh.faces().filter(|&f| self.mesh.is_walkable(f));
        let core = walkable().filter(|&f| !self.mesh.is_dead_end(f));
        self.paint(&mut sketch, Role::Main, core, "the core: searches look here");
        let peeled = walkable().filter(|&f| self.mesh.is_dead_end(f));
        self.paint(&mut sketch, Role::Event, peeled, "dead ends: peeled off when the mesh is made");
        for f in walkable() {
            if let Some(portal) = self.mesh.portal(f) {
                let way = [self.middle(f), self.middle(portal)];
                let arrow = sketch.path(Role::Event, way).arrow().key("the way out of a dead end");
                arrow.title(format!("{f} to {portal}"));
            }
        }
        self.over(sketch, options)
    }

    /// Adds the faces that were blocked.
    pub(super) fn blocked(&self, sketch: &mut Sketch) {
        let rings: Vec<_> = self.mesh.faces().filter(|&f| self.mesh.is_blocked(f)).map(|f| self.ring(f)).collect();
        if !rings.is_empty() {
            sketch.region(Role::Wrong, rings).hatched().key("blocked");
        }
    }
}
