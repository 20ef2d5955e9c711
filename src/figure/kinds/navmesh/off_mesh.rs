//! Ends of a path that nobody can stand at.

use crate::figure::kinds::navmesh::Floor;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::geometry::point::corners;
use crate::plane::Point;

impl Floor<'_> {
    /// A start and a goal, and for each that is off the mesh the nearest place that is on it, with the line to it. A
    /// point so far away that the map would be hard to see is left out; its nearest place is shown.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn off_mesh(&self, ends: [(Point, Option<Point>); 2], options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        for ((role, (asked, nearest)), name) in [Role::Start, Role::Goal].into_iter().zip(ends).zip(["start", "goal"]) {
            let shown = self.is_near(asked);
            if let Some(nearest) = nearest {
                if shown && nearest != asked {
                    sketch.path(role, [asked, nearest]).dashed().key(format!("from the {name} to the nearest place"));
                }
                sketch.point(Role::Event, nearest).key("the nearest place on the mesh");
            }
            if shown {
                let label = if nearest.is_some() { format!("{name}, off the mesh") } else { name.to_owned() };
                sketch.point(role, asked).label(label);
            }
        }
        self.over(sketch, options)
    }

    /// Whether a point is no further from the box round the map than that is wide and high.
    fn is_near(&self, p: Point) -> bool {
        let [low, high] = corners(self.map.vertices().map(|v| self.map.point(v)));
        let size = Point::new(high.x - low.x, high.y - low.y);
        let is_near = |x: f64, low: f64, high: f64, size: f64| x >= low - size && x <= high + size;
        is_near(p.x, low.x, high.x, size.x) && is_near(p.y, low.y, high.y, size.y)
    }
}
