//! A path over links: its legs, and the links between them.

use crate::figure::kinds::navmesh::Floor;
use crate::figure::kinds::navmesh::route::length;
use crate::figure::sketch::{Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::{Link, LinkedRoute};

impl Floor<'_> {
    /// The legs of a path that lie on the layer of this map, the links it uses, and those it does not.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn linked(
        &self,
        layer: usize,
        path: &LinkedRoute,
        links: &[Link],
        options: &FigureOptions,
    ) -> Result<Figure, SketchError> {
        let mut sketch = Sketch::new();
        for leg in path.legs.iter().filter(|leg| leg.layer == layer) {
            self.corridor(&mut sketch, &leg.route);
        }
        for (i, link) in links.iter().enumerate().filter(|(_, link)| [link.from.layer, link.to.layer] == [layer; 2]) {
            let (role, key) = match path.links.contains(&i) {
                true => (Role::Secondary, "a link of the path"),
                false => (Role::Event, "a link that is not used"),
            };
            let ends = [link.from, link.to].map(|stop| stop.place.point);
            sketch.path(role, ends).arrow().key(key).title(format!("link {i}, costs {}", link.cost));
        }
        for leg in path.legs.iter().filter(|leg| leg.layer == layer && leg.route.length > 0.0) {
            let key = format!("the path, {} with its links", length(path.cost));
            sketch.path(Role::Main, leg.route.points.iter().copied()).arrow().key(key);
        }
        let ends = [path.legs.first(), path.legs.last()].map(|leg| leg.filter(|leg| leg.layer == layer));
        if let Some(point) = ends[0].and_then(|leg| leg.route.points.first()) {
            sketch.point(Role::Start, *point).label("start");
        }
        if let Some(point) = ends[1].and_then(|leg| leg.route.points.last()) {
            sketch.point(Role::Goal, *point).label("goal");
        }
        self.over(sketch, options)
    }
}
