//! Why there is no path: the two components, and what keeps them apart.

use crate::figure::canvas::text::counted;
use crate::figure::kinds::navmesh::Floor;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::ComponentId;
use crate::plane::Point;

impl Floor<'_> {
    /// The proof that there is no path: all that can be reached from the start, and all from which the goal can be
    /// reached, in two colours. No face has both.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn apart(
        &self,
        ends: [Point; 2],
        components: [ComponentId; 2],
        options: &FigureOptions,
    ) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        let names = ["can be reached from the start", "leads to the goal"];
        for ((role, component), name) in [Role::Start, Role::Goal].into_iter().zip(components).zip(names) {
            let faces = self.mesh.component_faces(component);
            let count = self.mesh.component_faces(component).count();
            let key = format!("{component}, {}: {name}", counted(count, "face", "faces"));
            self.paint(&mut sketch, role, faces, &key);
        }
        sketch.point(Role::Start, ends[0]).label("start");
        sketch.point(Role::Goal, ends[1]).label("goal");
        self.over(sketch, options)
    }
}
