//! How far everything is from one place.

use crate::figure::kinds::navmesh::Floor;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::ids::VertexId;
use crate::navmesh::DistanceField;

/// With more vertices than this, their distances are titles only: words would hide the map.
pub(super) const WORDS: usize = 60;

impl Floor<'_> {
    /// The faces that can be reached whole within the limit of a distance field, and the distance to each vertex.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn reach(&self, field: &DistanceField, options: &FigureOptions) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        self.paint(&mut sketch, Role::Main, field.faces_within(self.mesh), "reached whole within the limit");
        let vertices = (0..self.mesh.vertex_bound() as u32).map(VertexId::new);
        let reached: Vec<(VertexId, f64)> = vertices.filter_map(|v| Some((v, field.distance(v)?))).collect();
        for &(v, distance) in &reached {
            let words = length((distance * 100.0).round() / 100.0);
            let point = sketch.point(Role::Event, self.mesh.point(v)).key("a vertex and how far it is");
            let point = point.title(format!("{v}: {distance}"));
            if reached.len() <= WORDS {
                point.label(words);
            }
        }
        sketch.point(Role::Start, field.start().point).label("start");
        self.over(sketch, options)
    }
}
