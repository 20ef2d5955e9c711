//! Room where the edits are: a structure without coordinates that is too large to be drawn with all of its arrows.
//!
//! ```text
//!   each vertex as far from what the edits write as there are edges between      0    1    2    3  and more
//!   its room                                                                      1   1/2  1/4   FAR
//!
//!            ● ● ● ●
//!         ●           ●────            a ring of 100: where the edits are, half-edges have arrows and names;
//!         ●                ●           elsewhere edges are plain lines, and their half-edges are not drawn
//!         ●           ●────
//!            ● ● ● ●
//! ```

use super::draw::{Stage, union};
use super::frames::Film;
use crate::figure::canvas::vector::xy;
use crate::figure::flatten::Spread;
use crate::figure::layout::grid::SHEET;
use crate::figure::structure::picture::Picture;
use crate::figure::structure::skeleton::half_edges;
use crate::figure::{Detail, FigureError, FigureOptions};
use crate::ids::{Element, HalfEdgeId, VertexId, VertexMap};
use crate::plane::PlanarView;
use crate::topology::{Change, Dcel, Slot, View};
use std::collections::{BTreeSet, VecDeque};

/// The least room.
const FAR: f64 = 0.15;
/// A half-edge beside a shorter edge than this, in px, is not drawn.
const SHORT: f64 = 40.0;
/// A vertex without edits has a name if each edge there is at least so long, in px.
const NAMED: f64 = 26.0;
/// At least half of the edges that the edits touch must be as long as this, in px.
const NEAR: f64 = 25.0;
/// With more edges the part without edits would be one dark spot.
const MOST: usize = 1000;

impl Film {
    /// The same film with room where its edits are, if it is laid out and has no room for arrows otherwise. The options
    /// become those that it is to be drawn with.
    ///
    /// # Errors
    /// [`FigureError::NoRoom`] if there is none where the edits are.
    pub(super) fn with_room(&self, options: &mut FigureOptions) -> Result<Option<Self>, FigureError> {
        if self.kernels.is_empty() || options.detail.is_some() {
            return Ok(None);
        }
        let whole = union(&self.placed().0);
        let detail = Picture::<dyn PlanarView>::new(&whole, options)?.0.detail;
        let near = self.near();
        if detail >= Detail::Arrows || half_edges(&whole).count() > 2 * MOST || near.is_empty() {
            return Ok(None);
        }
        let mut film = self.without_states();
        for kernel in &self.kernels {
            let spread = Spread::with_room(kernel, film.spreads.last(), &rooms(kernel, &near));
            film.add_spread(kernel, spread);
        }
        options.usual_width = SHEET;
        options.detail = Some(Detail::Full);
        let (placed, _) = film.placed();
        let whole = union(&placed);
        let scale = Picture::<dyn PlanarView>::new(&whole, options)?.0.fit.scale;
        let is_near = |v: VertexId| near.contains(&Element::Vertex(v));
        let mut lengths = Vec::new();
        let mut unnamed = BTreeSet::new();
        for (kernel, placed) in film.kernels.iter().zip(&placed) {
            for h in kernel.half_edges() {
                let end = |h: HalfEdgeId| placed.table.origin(h).and_then(|v| placed.table.position(v));
                let Some((a, b)) = end(h).zip(placed.table.next(h).and_then(end)) else { continue };
                let length = xy(b.x - a.x, b.y - a.y).length() * scale;
                if ends(kernel, h).into_iter().all(is_near) {
                    lengths.push(length);
                } else if length < NAMED {
                    unnamed.extend(ends(kernel, h).into_iter().filter(|&v| !is_near(v)));
                }
            }
        }
        let mut overrides = options.overrides.clone();
        for v in unnamed.into_iter().filter(|&v| options.overrides.label_of(v).is_none()) {
            overrides = overrides.label(v, String::new());
        }
        options.overrides = overrides;
        lengths.sort_unstable_by(f64::total_cmp);
        if lengths.get(lengths.len() / 2).is_some_and(|&length| length < NEAR) {
            return Err(FigureError::NoRoom { detail });
        }
        Ok(Some(film))
    }

    /// The vertices that the edits write, or at which a half-edge begins or ends that they write; of faces, only what they
    /// are led through. Elements that are marked count, too.
    fn near(&self) -> BTreeSet<Element> {
        let mut out = BTreeSet::new();
        let shots = 0..self.edit_count();
        let changes = shots.clone().flat_map(|shot| self.journal(shot).changes());
        let written = changes.filter_map(|change| match *change {
            Change::Write { slot: Slot::Origin(h) | Slot::Next(h) | Slot::Prev(h), .. } => Some(Element::HalfEdge(h)),
            Change::Write { slot: Slot::Outgoing(v), .. } => Some(Element::Vertex(v)),
            Change::Write { .. } => None,
            Change::Added { element, .. } | Change::Removed { element } => Some(element),
        });
        for element in written.chain(shots.flat_map(|shot| self.marked(shot)).copied()) {
            for kernel in &self.kernels {
                let halves = match element {
                    Element::Vertex(v) => {
                        out.insert(Element::Vertex(v));
                        continue;
                    }
                    Element::HalfEdge(h) => vec![h],
                    Element::Edge(e) => e.half_edges().to_vec(),
                    Element::Face(_) => continue,
                };
                let there = halves.into_iter().filter(|&h| kernel.has_half_edge(h));
                out.extend(there.flat_map(|h| ends(kernel, h)).map(Element::Vertex));
            }
        }
        out
    }
}

impl Stage<'_> {
    /// Leaves out the half-edges beside short edges, with their names: the edges stay.
    pub(super) fn leave_out_short(&mut self) {
        for plate in &mut self.plates {
            let lengths = plate.shafts.iter().filter_map(|(h, shaft)| Some((h, shaft.as_ref()?.edge_length)));
            let short: Vec<HalfEdgeId> = lengths.filter(|&(_, length)| length < SHORT).map(|(h, _)| h).collect();
            for h in short {
                plate.shafts.set(h, None, None);
                plate.labels.half_edges.set(h, None, None);
            }
        }
    }
}

/// Where a half-edge begins and ends.
fn ends(kernel: &Dcel, h: HalfEdgeId) -> [VertexId; 2] {
    [kernel.origin(h), kernel.destination(h)]
}

/// The room of each vertex: half as much with each edge further away.
fn rooms(kernel: &Dcel, near: &BTreeSet<Element>) -> VertexMap<f64> {
    let mut out = VertexMap::filled(kernel.vertex_bound(), FAR);
    let mut queue: VecDeque<VertexId> = kernel.vertices().filter(|&v| near.contains(&Element::Vertex(v))).collect();
    queue.iter().for_each(|&v| out[v] = 1.0);
    while let Some(v) = queue.pop_front() {
        let room = 0.5 * out[v];
        for h in kernel.outgoing_half_edges(v).filter(|_| room > FAR) {
            let other = kernel.destination(h);
            if out[other] < room {
                out[other] = room;
                queue.push_back(other);
            }
        }
    }
    out
}
