//! Vertices that are drawn at each other's places.
//!
//! ```text
//!   <g id="a-v1" data-x="4" ...><circle cx="62" .../></g>      v1 is drawn where v2 belongs,
//!   <g id="a-v2" data-x="0" ...><circle cx="578" .../></g>     and v2 where v1 does
//! ```

use super::beside::Extent;
use super::drawing::Drawing;
use super::pairing::Places;
use super::report::{Difference, Kind, Layer, Spot, counted, listed};
use crate::plane::Point;

/// How near to a place of a vertex a circle is drawn there, as a part of the drawing.
const NEAR: f64 = 2e-3;

/// The vertices of a drawing whose circles stand where it declares others, unless these are most of them: then it is
/// turned. `has_places`: places of the model are those of the reference.
pub(super) fn compare(drawing: &Drawing, has_places: bool) -> Option<Difference> {
    let declared = drawing.dots.iter().filter_map(|dot| Some((dot.at, dot.vertex.as_ref()?)));
    let (drawn, vertices): (Vec<Point>, Vec<&(String, Point)>) = declared.unzip();
    let models: Vec<Point> = vertices.iter().map(|(_, at)| *at).collect();
    let [canvas, model] = [&drawn, &models].map(|points| Extent::around(points.clone()));
    let scale = model.size() / canvas.size();
    let [from, to] = [canvas, model].map(|extent| extent.corners()[0]);
    let reach = NEAR * model.size();
    if !(scale.is_finite() && scale > 0.0) {
        return None;
    }
    let places = Places::of(&models, reach);
    let (mut told, mut spots) = (Vec::new(), Vec::new());
    for (at, (name, own)) in drawn.iter().zip(&vertices) {
        let here = Point::new(to.x + scale * (at.x - from.x), to.y + scale * (at.y - from.y));
        let other = places.near(here, reach).map(|i| vertices[i as usize]);
        if let Some((other, at)) = other.filter(|(other, _)| other != name) {
            // Two vertices at one place are told otherwise.
            if at != own {
                told.push(format!("{name} at {other}"));
                spots.push(Spot::At(*at));
            }
        }
    }
    if told.is_empty() || 2 * told.len() > drawn.len() {
        return None;
    }
    let text =
        counted(told.len(), "vertex is drawn where another one belongs", "vertices are drawn where others belong");
    let text = format!("{text}: {}", listed(&told));
    let spot = if has_places { Spot::all(spots) } else { Spot::Nowhere };
    Some(Difference::new(Kind::Vertex, Layer::Drawn, text, spot))
}
