//! Where names stand, and what they stand beside.
//!
//! ```text
//!   (v0)───h0──▸───(v1)      a vertex: no other vertex is much nearer; a half-edge: on its own side of its edge
//!      f1                    a face: within its outline
//! ```

use super::drawing::Drawing;
use super::pairing::{Places, distance, lies_on};
use crate::figure::structure::skeleton::destination;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{Table, View};
use std::collections::BTreeMap;

/// A name stands at its half-edge if its box is no further from the edge than so many heights of its letters, or its
/// middle than this part of the edge.
pub(super) const HEIGHTS: f64 = 4.0;
const PART: f64 = 0.1;

/// What names stand beside.
pub(super) struct Around<'a> {
    drawing: &'a Drawing,
    table: &'a Table,
    vertices: BTreeMap<&'a str, Point>,
    places: Places,
    /// How near to a name a vertex is looked for.
    reach: f64,
    /// What fills each face, and what faces are called.
    fillings: BTreeMap<&'a str, Vec<u32>>,
    faces: BTreeMap<&'a str, Vec<String>>,
}

impl<'a> Around<'a> {
    pub(super) fn new(drawing: &'a Drawing, table: &'a Table, span: f64) -> Self {
        let vertices: BTreeMap<&str, Point> =
            drawing.dots.iter().filter_map(|dot| Some((dot.vertex.as_ref()?.0.as_str(), dot.at))).collect();
        let reach = span / (vertices.len().max(1) as f64).sqrt();
        let mut fillings: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
        for outline in &drawing.outlines {
            fillings.entry(outline.name.as_str()).or_default().push(outline.coat);
        }
        let mut faces: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for (i, row) in table.faces.iter().enumerate() {
            if let Some(name) = row.as_ref().and_then(|row| row.name.as_deref()) {
                faces.entry(name).or_default().push(FaceId::new(i as u32).to_string());
            }
        }
        let places = Places::of(&vertices.values().copied().collect::<Vec<_>>(), reach);
        Self { drawing, table, vertices, places, reach, fillings, faces }
    }

    /// Whether a text is the name of something else of the same kind.
    pub(super) fn is_other(&self, element: &str, text: &str) -> bool {
        let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        if text == element {
            return false;
        }
        let Ok(f) = element.parse::<FaceId>() else {
            return text.get(..1) == element.get(..1) && text.get(1..).is_some_and(is_number);
        };
        let own = self.table.faces.get(f.index()).and_then(|row| row.as_ref()?.name.as_deref());
        let is_name = |name: Option<&str>| name == Some(text);
        !is_name(own) && (self.faces.contains_key(text) || text.parse::<FaceId>().is_ok())
    }

    /// What has this text for its name.
    pub(super) fn named(&self, text: &str) -> Vec<String> {
        let has_row = |i: usize, rows: [usize; 3], kind: usize| i < rows[kind];
        let rows = [self.table.vertices.len(), self.table.half_edges.len(), self.table.faces.len()];
        let vertex = text.parse::<VertexId>().is_ok_and(|v| has_row(v.index(), rows, 0));
        let half_edge = text.parse::<HalfEdgeId>().is_ok_and(|h| has_row(h.index(), rows, 1));
        let face = text.parse::<FaceId>().is_ok_and(|f| has_row(f.index(), rows, 2));
        let by_number = (vertex || half_edge || face).then(|| text.to_owned());
        by_number.into_iter().chain(self.faces.get(text).into_iter().flatten().cloned()).collect()
    }

    /// Whether letters stand where something is that a group declares.
    pub(super) fn is_at_place(&self, element: &str, letters: u32) -> bool {
        let coat = &self.drawing.painting.coats[letters as usize];
        let middle = coat.middle();
        if element.parse::<VertexId>().is_ok() {
            let Some(&at) = self.vertices.get(element) else { return true };
            // Only a vertex that is much nearer is named instead.
            let nearer = self.places.near(middle, (0.5 * distance(at, middle)).min(self.reach));
            return nearer.is_none_or(|i| self.places.points()[i as usize] == at);
        }
        if let Ok(h) = element.parse::<HalfEdgeId>() {
            let place = |v: Option<VertexId>| self.vertices.get(v?.to_string().as_str()).copied();
            let ends = place(self.table.origin(h)).zip(place(destination(self.table, h)));
            let Some((from, to)) = ends.filter(|(from, to)| from != to) else { return true };
            let left = (to.x - from.x) * (middle.y - from.y) - (to.y - from.y) * (middle.x - from.x);
            let reach = (0.5 * coat.diameter() + HEIGHTS * coat.thickness()).max(PART * distance(from, to));
            return left > 0.0 && lies_on(middle, [from, to], reach);
        }
        let covers = |&coat: &u32| self.drawing.painting.coats[coat as usize].covers(middle).0;
        self.fillings.get(element).is_none_or(|coats| coats.iter().any(covers))
    }
}
