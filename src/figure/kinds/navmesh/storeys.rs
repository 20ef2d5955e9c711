//! Surfaces in space, drawn from above: one panel for each layer.

use crate::figure::kinds::navmesh::reach::WORDS;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Multiples, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::geometry::interval::range;
use crate::ids::VertexId;
use crate::navmesh::{NavSurface, SurfaceField, SurfaceLink, SurfacePoint, SurfaceRoute};
use std::collections::BTreeMap;

/// A surface, ready to be drawn.
///
/// ```
/// use dcel_kit::figure::{FigureOptions, navmesh::Storeys};
/// use dcel_kit::{navmesh::NavSurface, topology::PolygonList};
/// let points = [[0., 0., 0.], [4., 0., 3.], [4., 2., 3.], [0., 2., 0.]];
/// let mut faces = PolygonList::new();
/// faces.push_face(&[0, 1, 2, 3]);
/// let ramp = NavSurface::new(&points, &faces, None)?;
/// let svg = Storeys::new(&ramp).map(&FigureOptions::new("A ramp"))?.to_svg();
/// assert!(svg.contains("heights 0 to 3"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Storeys<'a> {
    surface: &'a NavSurface,
}

fn plan(p: [f64; 3]) -> [f64; 2] {
    [p[0], p[1]]
}

impl<'a> Storeys<'a> {
    /// Of this surface.
    #[must_use]
    pub fn new(surface: &'a NavSurface) -> Self {
        Self { surface }
    }

    /// The layers alone.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn map(&self, options: &FigureOptions) -> Result<Figure, SketchError> {
        self.panels(options, |_, _| {})
    }

    /// Paths, or the legs of one, and the links between them. What of a path lies on another layer is a thin dashed line.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn paths(
        &self,
        paths: &[&SurfaceRoute],
        links: &[SurfaceLink],
        ends: &[SurfacePoint; 2],
        options: &FigureOptions,
    ) -> Result<Figure, SketchError> {
        let whole: f64 = paths.iter().map(|path| path.length).sum();
        let key = format!("the path, {} along the surface", length(whole));
        self.panels(options, |layer, sketch| {
            for path in paths {
                let mut first = 0;
                for run in path.layers.chunk_by(|a, b| a == b) {
                    let points = path.points[first..=first + run.len()].iter().map(|&p| plan(p));
                    first += run.len();
                    if run[0] == layer {
                        sketch.path(Role::Main, points).arrow().key(&key);
                    } else {
                        sketch.path(Role::Dimmed, points).dashed().key("the path on another layer");
                    }
                }
            }
            for link in links {
                let ends = [link.from, link.to];
                if ends.iter().any(|place| place.layer == layer) {
                    let line = sketch.path(Role::Secondary, ends.map(|place| plan(place.point))).arrow();
                    line.key("a link of the path").title(format!("a link that costs {}", link.cost));
                }
            }
            let [start, goal] = ends;
            for (place, role, label) in [(start, Role::Start, "start"), (goal, Role::Goal, "goal")] {
                if place.layer == layer {
                    sketch.point(role, plan(place.point)).label(label);
                }
            }
        })
    }

    /// How far the vertices are from a place.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn reach(
        &self,
        field: &SurfaceField,
        start: &SurfacePoint,
        options: &FigureOptions,
    ) -> Result<Figure, SketchError> {
        self.panels(options, |layer, sketch| {
            let faces = self.surface.faces().filter(|&f| self.surface.layer(f) == Some(layer));
            let vertices: BTreeMap<VertexId, [f64; 3]> = faces.flat_map(|f| self.surface.vertices(f)).collect();
            let reached: Vec<_> = vertices.iter().filter_map(|(&v, &p)| Some((v, p, field.distance(v)?))).collect();
            for &(v, p, distance) in &reached {
                let point = sketch.point(Role::Event, plan(p)).key("a vertex and how far it is");
                let point = point.title(format!("{v}: {distance}"));
                if reached.len() <= WORDS {
                    point.label(length((distance * 100.0).round() / 100.0));
                }
            }
            if start.layer == layer {
                sketch.point(Role::Start, plan(start.point)).label("start");
            }
        })
    }

    /// A panel for each layer, or a picture if there is one only; `add` puts things into it.
    fn panels(&self, options: &FigureOptions, add: impl Fn(usize, &mut Sketch)) -> Result<Figure, SketchError> {
        let count = self.surface.layer_count();
        let mut panels = Multiples::new();
        for layer in 0..count {
            let mut sketch = Sketch::new();
            let [low, high] = self.layer(layer, &mut sketch);
            add(layer, &mut sketch);
            let heights = format!("heights {} to {}", length(low), length(high));
            panels.sketch(&format!("layer {layer}"), &heights, sketch);
        }
        if count == 1 {
            panels.columns(1);
        }
        panels.figure(options)
    }

    /// Adds the faces of a layer. Returns its least and its greatest height.
    fn layer(&self, layer: usize, sketch: &mut Sketch) -> [f64; 2] {
        let faces = || self.surface.faces().filter(|&f| self.surface.layer(f) == Some(layer));
        let triangles: Vec<[[f64; 3]; 3]> = faces().flat_map(|f| self.surface.triangles(f)).collect();
        sketch.region(Role::Plain, triangles.iter().map(|t| t.map(plan))).plain().key("the surface");
        let (mut inner, mut border, mut leading) = (Vec::new(), Vec::new(), Vec::new());
        for (ends, beyond) in faces().flat_map(|f| self.surface.outline(f)) {
            let line = ends.map(plan);
            match beyond.map(|f| self.surface.layer(f) == Some(layer)) {
                None => border.push(line),
                Some(false) => leading.push(line),
                // Once, of the two faces that have it.
                Some(true) if line[0] < line[1] => inner.push(line),
                Some(true) => {}
            }
        }
        for (lines, role, key) in [
            (inner, Role::Dimmed, "an edge to pass"),
            (border, Role::Plain, "a border"),
            (leading, Role::Secondary, "an edge to another layer"),
        ] {
            for line in lines {
                sketch.path(role, line).solid().key(key);
            }
        }
        range(triangles.iter().flatten().map(|p| p[2]))
    }
}
