//! Where names stand, and what they stand beside.
//!
//! ```text
//!   (v0)───h0──▸───(v1)      a vertex: near its disc, and no other vertex is much nearer; a half-edge: on its own side of
//!      f1                    its edge; a face: within its outline
//! ```
//!
//! A name may stand elsewhere if a line leads from it to what it names.

use super::drawing::{Dot, Drawing};
use super::painting::{Coat, Part, Shape};
use super::pairing::{Places, distance, distance_to, lies_on};
use super::spelling::Spelling;
use crate::figure::structure::skeleton::destination;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{Table, View};
use std::collections::BTreeMap;

/// A name stands at its half-edge if its box is no further from the edge than so many heights of its letters, or its
/// middle than this part of the edge; and at its vertex if its box is no further from the disc than so many heights, or
/// than this part of the shortest edge there.
pub(super) const HEIGHTS: f64 = 4.0;
const PART: f64 = 0.1;

/// What names stand beside.
pub(super) struct Around<'a> {
    drawing: &'a Drawing,
    table: &'a Table,
    vertices: BTreeMap<&'a str, Vertex>,
    places: Places,
    /// How near to a name a vertex is looked for.
    reach: f64,
    /// What fills each face, and what faces are called.
    fillings: BTreeMap<&'a str, Vec<u32>>,
    faces: BTreeMap<&'a str, Vec<String>>,
    /// Lines that may lead from names to what they name.
    leaders: Vec<[Point; 2]>,
}

/// A vertex on the canvas.
#[derive(Clone, Copy)]
struct Vertex {
    at: Point,
    radius: f64,
    /// How long the shortest edge at it is.
    nearest: f64,
}

impl<'a> Around<'a> {
    pub(super) fn new(drawing: &'a Drawing, table: &'a Table, span: f64) -> Self {
        let named = drawing.dots.iter().filter_map(|dot| Some((dot.vertex.as_ref()?.0.as_str(), dot)));
        let vertex = |dot: &Dot| Vertex { at: dot.at, radius: dot.radius, nearest: f64::INFINITY };
        let mut vertices: BTreeMap<&str, Vertex> = named.map(|(name, dot)| (name, vertex(dot))).collect();
        for h in (0..table.half_edges.len()).map(|i| HalfEdgeId::new(i as u32)) {
            let [Some(from), Some(to)] = [table.origin(h), destination(table, h)].map(|v| v.map(|v| v.to_string()))
            else {
                continue;
            };
            let Some([p, q]) = vertices.get(from.as_str()).zip(vertices.get(to.as_str())).map(|(v, w)| [v.at, w.at])
            else {
                continue;
            };
            if let Some(vertex) = vertices.get_mut(from.as_str()) {
                vertex.nearest = vertex.nearest.min(distance(p, q));
            }
        }
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
        let places = Places::of(&vertices.values().map(|vertex| vertex.at).collect::<Vec<_>>(), reach);
        let leaders = leaders(drawing);
        Self { drawing, table, vertices, places, reach, fillings, faces, leaders }
    }

    /// What a text says at an element.
    pub(super) fn spelling(&self, element: &str, text: &str) -> Spelling {
        let face = element.parse::<FaceId>().ok();
        let own = face.and_then(|f| self.table.faces.get(f.index())?.as_ref()?.name.as_deref());
        Spelling::of(element, own, text, |text| face.is_some() && self.faces.contains_key(text))
    }

    /// What has this text for its name.
    pub(super) fn named(&self, text: &str) -> Vec<String> {
        let vertex = text.parse::<VertexId>().is_ok_and(|v| v.index() < self.table.vertices.len());
        let half_edge = text.parse::<HalfEdgeId>().is_ok_and(|h| h.index() < self.table.half_edges.len());
        let face = text.parse::<FaceId>().is_ok_and(|f| f.index() < self.table.faces.len());
        let by_number = (vertex || half_edge || face).then(|| text.to_owned());
        by_number.into_iter().chain(self.faces.get(text).into_iter().flatten().cloned()).collect()
    }

    /// Whether letters stand where something is that a group declares, or a line leads from them to it.
    pub(super) fn is_at_place(&self, element: &str, letters: u32) -> bool {
        let coat = &self.drawing.painting.coats[letters as usize];
        self.stands_at(element, coat) || self.is_led_to(element, coat)
    }

    fn stands_at(&self, element: &str, coat: &Coat) -> bool {
        let middle = coat.middle();
        if element.parse::<VertexId>().is_ok() {
            let Some(&Vertex { at, radius, nearest }) = self.vertices.get(element) else { return true };
            let nearest = if nearest.is_finite() { nearest } else { 0.0 };
            let far = radius + (HEIGHTS * coat.thickness()).max(PART * nearest);
            // Only a vertex that is much nearer is named instead.
            let nearer = self.places.near(middle, (0.5 * distance(at, middle)).min(self.reach));
            return coat.distance(at) <= far && nearer.is_none_or(|i| self.places.points()[i as usize] == at);
        }
        if let Ok(h) = element.parse::<HalfEdgeId>() {
            let Some([from, to]) = self.ends(h) else { return true };
            let left = (to.x - from.x) * (middle.y - from.y) - (to.y - from.y) * (middle.x - from.x);
            let reach = (0.5 * coat.diameter() + HEIGHTS * coat.thickness()).max(PART * distance(from, to));
            return left > 0.0 && lies_on(middle, [from, to], reach);
        }
        self.fillings.get(element).is_none_or(|coats| coats.iter().any(|&coat| self.covers(coat, middle)))
    }

    /// Whether one of the lines that may lead to something begins at these letters and ends there.
    fn is_led_to(&self, element: &str, coat: &Coat) -> bool {
        let height = coat.thickness();
        let is_there = |p: Point| {
            if let Some(vertex) = self.vertices.get(element) {
                return distance(p, vertex.at) <= vertex.radius + height;
            }
            if let Ok(h) = element.parse::<HalfEdgeId>() {
                return self.ends(h).is_some_and(|ends| lies_on(p, ends, height));
            }
            self.fillings.get(element).is_some_and(|coats| coats.iter().any(|&coat| self.covers(coat, p)))
        };
        let leads = |[p, q]: [Point; 2]| coat.distance(p) <= height && is_there(q);
        self.leaders.iter().any(|&[p, q]| leads([p, q]) || leads([q, p]))
    }

    /// Where the ends of a half-edge are drawn, if these are two places.
    fn ends(&self, h: HalfEdgeId) -> Option<[Point; 2]> {
        let place = |v: Option<VertexId>| self.vertices.get(v?.to_string().as_str()).map(|vertex| vertex.at);
        let (from, to) = place(self.table.origin(h)).zip(place(destination(self.table, h)))?;
        (from != to).then_some([from, to])
    }

    fn covers(&self, coat: u32, p: Point) -> bool {
        self.drawing.painting.coats[coat as usize].covers(p).0
    }
}

/// The lines of a drawing that are no edges and belong to no half-edge.
fn leaders(drawing: &Drawing) -> Vec<[Point; 2]> {
    let coats = &drawing.painting.coats;
    let mut is_free = vec![true; coats.len()];
    for half in &drawing.halves {
        is_free[half.coats.start as usize..half.coats.end as usize].fill(false);
    }
    let free = coats.iter().zip(is_free).filter(|(coat, is_free)| *is_free && coat.part == Part::Other);
    free.filter_map(|(coat, _)| Some(coat.stroke()?.ends)).collect()
}

impl Coat {
    /// How far a point is from an area; 0 within it. Of anything else the distance from the middle of its box.
    fn distance(&self, p: Point) -> f64 {
        match &self.shape {
            Shape::Area(_) if self.covers(p).0 => 0.0,
            Shape::Area(area) => area.sides().map(|side| distance_to(p, side)).fold(f64::INFINITY, f64::min),
            _ => distance(self.middle(), p),
        }
    }
}
