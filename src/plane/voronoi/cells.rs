//! The cells of a diagram in a window, as a subdivision.
//!
//! ```text
//!   ┌─────┬─────────┐      The edges inside the window and its border, joined where they have equal ends. What
//!   │  ·  │    ·    │      rounding has made to meet elsewhere is split exactly, and a face that came to be
//!   │     ●─────────┤      without any site goes to one of its neighbours. Every cell then holds its site and no
//!   │   ╱     ·     │      other, by an exact test.
//!   └──┴────────────┘
//! ```

use super::{Voronoi, VoronoiError, Window};
use crate::ids::{FaceId, FaceMap, HalfEdgeId, VertexId, VertexMap};
use crate::plane::{ArrangeOptions, Location, Point, Subdivision};
use std::cmp::Ordering;

/// The cells of a Voronoi diagram in a window.
#[derive(Clone, PartialEq, Debug)]
pub struct VoronoiCells {
    /// The window cut into cells: its bounded faces.
    pub subdivision: Subdivision,
    /// The cell of each site; none for numbers without a vertex.
    pub cells: VertexMap<Option<FaceId>>,
    /// The site of each cell; none for `f0` and numbers without a face.
    pub sites: FaceMap<Option<VertexId>>,
    /// How many faces had come to be by rounding and were joined to a cell.
    pub slivers: usize,
}

impl Voronoi<'_> {
    /// The cells inside a window, which must hold all sites.
    ///
    /// A cell is a face with exactly one site inside, by an exact test. Its corners are rounded; so it may be not
    /// quite convex, and corners closer to each other than doubles can tell are one vertex.
    ///
    /// Cost: O(n log n); O(n log² n) where the sites crowd in a small part of the window.
    ///
    /// # Errors
    /// [`VoronoiError`]: the window, a site outside of it, or two sites so close to each other that no edge of doubles
    /// parts them.
    pub fn cells(&self, window: Window) -> Result<VoronoiCells, VoronoiError> {
        window.check()?;
        let sites: Vec<VertexId> = self.delaunay.vertices().collect();
        if let Some(&site) = sites.iter().find(|&&v| !window.contains(self.delaunay.point(v))) {
            return Err(VoronoiError::SiteOutside { site, point: self.delaunay.point(site) });
        }
        let (subdivision, site_of, slivers) = match self.known_cells(&window) {
            Some((subdivision, site_of)) => (subdivision, site_of, 0),
            None => self.arranged_cells(&window, &sites)?,
        };
        let mut cells = VertexMap::filled(self.delaunay.vertex_bound(), None);
        for (face, site) in site_of.iter() {
            if let &Some(site) = site {
                cells[site] = Some(face);
            }
        }
        Ok(VoronoiCells { subdivision, cells, sites: site_of, slivers })
    }

    /// The cells by the arrangement of all edges, whatever rounding has done to them; the site of each, and how many
    /// faces were given away.
    pub(super) fn arranged_cells(
        &self,
        window: &Window,
        sites: &[VertexId],
    ) -> Result<(Subdivision, FaceMap<Option<VertexId>>, usize), VoronoiError> {
        let mut segments: Vec<[Point; 2]> = self.edges().iter().filter_map(|edge| self.piece(edge, window)).collect();
        let at_border = segments.as_flattened().iter().copied().filter(|&p| !window.contains(p));
        let at_border: Vec<_> = at_border.chain(window.corners()).map(|p| (p, ())).collect();
        segments.extend(border(window, &at_border).into_iter().map(|ends| ends.map(|(p, ())| p)));
        let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
        let mut subdivision = Subdivision::arrange_segments(&segments, &options)?.subdivision;

        let places: Vec<Point> = sites.iter().map(|&v| self.delaunay.point(v)).collect();
        let mut site_of: FaceMap<Option<VertexId>> = FaceMap::filled(subdivision.face_bound(), None);
        for (&site, location) in sites.iter().zip(subdivision.locate_all(&places)) {
            let Location::Face(face) = location else {
                return Err(VoronoiError::TooClose { site, other: self.nearest_to(site) });
            };
            if let Some(other) = site_of[face].replace(site) {
                return Err(VoronoiError::TooClose { site, other });
            }
        }
        let empty: Vec<FaceId> = subdivision.faces().skip(1).filter(|&f| site_of[f].is_none()).collect();
        for &sliver in &empty {
            subdivision.give_away(sliver, &site_of);
        }
        Ok((subdivision, site_of, empty.len()))
    }

    /// The nearest of the sites beside a site, for messages.
    fn nearest_to(&self, site: VertexId) -> VertexId {
        let p = self.delaunay.point(site);
        let distance = |v: VertexId| (self.delaunay.point(v).x - p.x).hypot(self.delaunay.point(v).y - p.y);
        let beside = self.delaunay.adjacent_vertices(site);
        beside.min_by(|&v, &w| distance(v).total_cmp(&distance(w))).unwrap_or(site)
    }
}

/// The border of the window, cut at its corners and where segments end on it, which is given in any order with whatever is
/// known of each place. O(n log n).
pub(super) fn border<T: Copy>(window: &Window, ends: &[(Point, T)]) -> Vec<[(Point, T); 2]> {
    let Window { low, high } = *window;
    let along = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    let mut border = Vec::new();
    let mut side = |mut on: Vec<(Point, T)>, order: fn(&Point) -> f64| {
        on.sort_by(|(p, _), (q, _)| along(order(p), order(q)));
        on.dedup_by_key(|(p, _)| *p);
        border.extend(on.windows(2).map(|pair| [pair[0], pair[1]]));
    };
    // Ends on the border have its very coordinate.
    let same = |a: f64, b: f64| along(a, b).is_eq();
    for y in [low.y, high.y] {
        side(ends.iter().copied().filter(|(p, _)| same(p.y, y)).collect(), |p| p.x);
    }
    for x in [low.x, high.x] {
        side(ends.iter().copied().filter(|(p, _)| same(p.x, x)).collect(), |p| p.y);
    }
    border
}

impl Subdivision {
    /// Joins a bounded face to a neighbour, if possible to one with a site, and removes what then has the same face
    /// on both sides.
    fn give_away(&mut self, sliver: FaceId, sites: &FaceMap<Option<VertexId>>) {
        let around: Vec<HalfEdgeId> = self.dcel.incident_half_edges(sliver).collect();
        let beside = |h: HalfEdgeId| self.dcel.face(h.twin());
        let bounded = || around.iter().copied().filter(|&h| beside(h) != self.outer_face() && beside(h) != sliver);
        let with_site = bounded().find(|&h| sites.get(beside(h)).is_some_and(Option::is_some));
        let Some(h) = with_site.or_else(|| bounded().next()) else { return };
        if self.join_faces(h).is_err() {
            return;
        }
        for h in around {
            let inside = |s: &Self| s.dcel.has_half_edge(h) && s.dcel.face(h) == s.dcel.face(h.twin());
            if inside(self) {
                let ends = [self.dcel.origin(h), self.dcel.destination(h)];
                let removed = self.remove_edge(h.edge()).is_ok();
                for v in ends {
                    if removed && self.dcel.has_vertex(v) && self.dcel.outgoing(v).is_none() {
                        // It lies alone now: a point that nothing needs.
                        let _ = self.remove_vertex(v);
                    }
                }
            }
        }
    }
}
