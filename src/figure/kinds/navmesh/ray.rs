//! A ray: the faces it runs through, and the wall it ends at.

use crate::figure::kinds::navmesh::Floor;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::Raycast;
use crate::plane::Point;

impl Floor<'_> {
    /// The faces a ray ran through, its line up to what it hit, the side that was hit, and what is out of sight behind.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn ray(&self, ends: [Point; 2], cast: &Raycast, options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        self.paint(&mut sketch, Role::Main, cast.faces.iter().copied(), "the faces on the way");
        let end = cast.hit.map_or(ends[1], |hit| hit.point);
        let words = match cast.hit {
            Some(hit) => format!("the ray, {} up to the wall", length(hit.distance)),
            None => "the ray: nothing is in its way".to_owned(),
        };
        let sides = cast.hit.into_iter().flat_map(|hit| self.mesh.sides(hit.face).map(move |side| (hit, side)));
        for (hit, side) in sides.filter(|(hit, side)| side.half_edge == hit.half_edge) {
            let ends = [side.from, side.to].map(|v| self.mesh.point(v));
            sketch.path(Role::Wrong, ends).key("the side that is hit").title(hit.half_edge.to_string());
        }
        sketch.path(Role::Main, [ends[0], end]).arrow().key(words);
        sketch.point(Role::Start, ends[0]).label("start");
        match cast.hit {
            Some(hit) => sketch.point(Role::Event, hit.point).label("hit"),
            None => sketch.point(Role::Goal, ends[1]).label("end"),
        };
        self.over(sketch, options)
    }
}
