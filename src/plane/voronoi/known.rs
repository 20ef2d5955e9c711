//! Cells put together from the diagram itself: which edges meet, and which site lies on which side, is known.
//!
//! ```text
//!        ●────────●        Rounded corners may still make edges cross. They do not if each site sees the whole border of
//!       ╱ ╲      ╱         its cell from the left, that is, if each edge makes a triangle with the site that runs
//!      ╱    · ──╱          counter-clockwise, and if the border of the whole is that of the window. Then the triangles
//!     ●─────────●          cover the window, and as a map from the cells to the plane that never turns a triangle over
//!                          and runs once round the border covers every place just once, they do not overlap.
//! ```
//!
//! All of this is exact. Where it does not hold, nothing is said here: the edges have to be arranged.

use super::cells::border;
use super::{Voronoi, Window};
use crate::geometry::predicates::orientation;
use crate::ids::{FaceMap, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};

const NONE: u32 = u32::MAX;

/// The ends of the pieces of a diagram, numbered in the order in which they first come.
struct Ends {
    points: Vec<Point>,
    edges: Vec<[u32; 2]>,
}

impl Ends {
    fn number(&mut self, p: Point) -> u32 {
        // No coordinate is -0, as in every subdivision that is made of segments.
        self.points.push(Point::new(p.x + 0.0, p.y + 0.0));
        self.points.len() as u32 - 1
    }
}

impl Voronoi<'_> {
    /// The window cut into the cells, with the site of each face; none where rounding has changed more than places.
    /// O(n), and O(k log k) for k edges that leave the window.
    pub(super) fn known_cells(&self, window: &Window) -> Option<(Subdivision, FaceMap<Option<VertexId>>)> {
        // Nearly all corners and edges of the diagram lie in most windows; in most of them few edges leave the window.
        let with_border = |count: usize| count + count / 16 + 64;
        let mut ends = Ends {
            points: Vec::with_capacity(with_border(self.corners.len())),
            edges: Vec::with_capacity(with_border(self.edges.len())),
        };
        let mut number_of = vec![NONE; self.corners.len()];
        let mut at_border: Vec<(Point, u32)> = Vec::new();
        let mut sites: Vec<[VertexId; 2]> = Vec::with_capacity(self.edges.len());
        for edge in &self.edges {
            let Some(piece) = self.piece(edge, window) else { continue };
            let mut id = |i: usize| match edge.ends[i] {
                Some(corner) if window.contains(piece[i]) => {
                    let number = &mut number_of[corner as usize];
                    if *number == NONE {
                        *number = ends.number(piece[i]);
                    }
                    *number
                }
                _ => {
                    let number = ends.number(piece[i]);
                    at_border.push((piece[i], number));
                    number
                }
            };
            let ids = [id(0), id(1)];
            ends.edges.push(ids);
            sites.push(edge.sites);
        }
        let inner = ends.edges.len() as u32;
        let expected = at_border.len() + 4;
        at_border.extend(window.corners().map(|p| (p, NONE)));
        let mut corners = [NONE; 4];
        let mut first = None;
        for [from, to] in border(window, &at_border) {
            let ids = [from, to].map(|(p, number)| match number {
                NONE => {
                    let corner = window.corners().iter().position(|&q| q == p).unwrap_or_default();
                    if corners[corner] == NONE {
                        corners[corner] = ends.number(p);
                    }
                    corners[corner]
                }
                number => number,
            });
            // The lower side comes first, from left to right: outside is behind it.
            first.get_or_insert(2 * ends.edges.len() as u32 + 1);
            ends.edges.push(ids);
        }
        // Of ends at one place the border keeps one.
        if ends.edges.len() as u32 - inner != expected as u32 {
            return None;
        }
        let outside = first?;
        let subdivision = Subdivision::disk(ends.points, ends.edges, outside).ok()?;
        let site_of = self.seen_from_sites(&subdivision, &sites, expected)?;
        Some((subdivision, site_of))
    }

    /// The site of each face, if each sees all of its border and the outer border has so many edges, all of the window.
    fn seen_from_sites(
        &self,
        cells: &Subdivision,
        sites: &[[VertexId; 2]],
        border: usize,
    ) -> Option<FaceMap<Option<VertexId>>> {
        let dcel = &cells.dcel;
        let outer = dcel.half_edge(cells.outer_face())?;
        let is_border = |e: usize| e >= sites.len();
        let mut around = dcel.cycle(outer);
        if dcel.cycle(outer).count() != border || !around.all(|h| is_border(h.edge().index())) {
            return None;
        }
        let mut site_of: FaceMap<Option<VertexId>> = FaceMap::filled(cells.face_bound(), None);
        for f in dcel.faces().skip(1) {
            let site = |h: HalfEdgeId| sites.get(h.edge().index()).map(|pair| pair[h.index() & 1]);
            let mine = dcel.incident_half_edges(f).find_map(site)?;
            let place = self.delaunay.point(mine);
            let sees = dcel.incident_half_edges(f).all(|h| {
                site(h).is_none_or(|other| other == mine)
                    && orientation(place, cells.point(dcel.origin(h)), cells.point(dcel.destination(h))).is_gt()
            });
            if !sees {
                return None;
            }
            site_of[f] = Some(mine);
        }
        // Faces that do not overlap have different sites inside.
        let seen = site_of.iter().filter(|(_, site)| site.is_some()).count();
        (seen == self.delaunay.vertex_count()).then_some(site_of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::xorshift;

    /// What is put together is, to the last number, what the arrangement of all edges gives; where rounding spoils the
    /// cells, nothing is put together.
    #[test]
    fn known_cells_are_those_of_the_arrangement() {
        let (mut known, mut unknown) = ([0; 6], [0; 6]);
        for seed in 1..4_000_u64 {
            let mut random = xorshift(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let mut next = |below: u64| ((random() >> 20) % below) as f64;
            let kind = seed as usize % 6;
            let near = f64::EPSILON * [2.0, 8.0, 32.0, 512.0][next(4) as usize];
            let count = 1 + next(if seed % 70 == 0 { 300 } else { 12 }) as usize;
            let mut place = || match kind {
                0 => Point::new(next(1 << 20), next(1 << 20)),
                1 => Point::new(next(9), next(9)),
                // So near each other, far from 0, that their corners are.
                2 => Point::new(1.0 + next(100) * near, 1.0 + next(100) * near),
                3 => Point::new(1e9 + next(5000) * 1e-6, next(5000) * 1e-6),
                // Needles.
                4 => Point::new(next(1 << 20), next(4) * 1e-7),
                _ => Point::new((next(1 << 20)).cos(), next(3) - 1.0),
            };
            let points: Vec<Point> = (0..count).map(|_| place()).collect();
            let Ok(built) = Subdivision::delaunay(&points) else { continue };
            let voronoi = built.subdivision.voronoi().unwrap();
            let window = Window::around(&points);
            let sites: Vec<VertexId> = built.subdivision.vertices().collect();
            match voronoi.known_cells(&window) {
                None => unknown[kind] += 1,
                Some((cells, site_of)) => {
                    known[kind] += 1;
                    let (arranged, its_sites, slivers) = voronoi.arranged_cells(&window, &sites).unwrap();
                    assert_eq!((cells, site_of, 0), (arranged, its_sites, slivers), "seed {seed}");
                }
            }
        }
        assert!(known.iter().all(|&count| count > 5) && unknown[2] > 20, "{known:?}, {unknown:?}");
    }
}
