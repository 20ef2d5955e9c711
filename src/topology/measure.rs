//! Counts: components, Euler characteristic, genus, boundary cycles.
//!
//! ```text
//!      ●───●───●            one component: V = 6, E = 7, three cycles (two inside, one outside)
//!      │   │   │   ·        and the isolated vertex, a component of its own
//!      ●───●───●
//!                           V - E + (cycles + isolated vertices) = 7 - 7 + (3 + 1) = 4 = (2 - 0) + (2 - 0)
//! ```
//!
//! For each component V - E + cycles = 2 - 2g, where an isolated vertex counts as one cycle and g is the genus:
//! 0 on the sphere and in the plane, 1 on a torus. This holds for every legal structure; that g is 0 everywhere
//! is an invariant of the plane only.
//!
//! All of it is linear in the size of the view and bounded on broken views, whose counts mean little.

use super::flat::{Flat, NONE, closed_orbits};
use super::view::View;
use crate::geometry::grouping::Joined;
use crate::ids::{FaceId, VertexId, VertexMap};
use std::convert::Infallible;
use std::ops::ControlFlow;

/// What the faces of a view cover.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Mode {
    /// The whole plane; one of the faces is the outer one.
    Plane,
    /// Closed surfaces, possibly with boundary faces: no face is the outer one.
    Surface,
}

/// The counts of one connected component.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ComponentCounts {
    /// The vertex of the component with the lowest number.
    pub first_vertex: VertexId,
    /// Vertices.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Boundary cycles of faces, on both sides of the edges; 1 for an isolated vertex.
    pub cycles: usize,
}

impl ComponentCounts {
    /// V - E + cycles.
    #[must_use]
    pub const fn euler(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.cycles as i64
    }

    /// The genus: handles of the closed surface that the component spans, 0 for everything in the plane.
    #[must_use]
    pub const fn genus(&self) -> i64 {
        (2 - self.euler()) / 2
    }
}

/// The counts of a view, as `dcel info` prints them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Counts {
    /// Plane if the view names an outer face.
    pub mode: Mode,
    /// Vertices, isolated ones included.
    pub vertices: usize,
    /// Half-edges.
    pub half_edges: usize,
    /// Edges: half as many.
    pub edges: usize,
    /// Face records of every kind.
    pub face_records: usize,
    /// Faces that Euler's relation counts. In the plane all records, the outer face included; on a surface all
    /// but the boundary faces.
    pub faces: usize,
    /// Boundary cycles of all faces.
    pub cycles: usize,
    /// Cycles of boundary faces: of the outer face and the hole faces in the plane.
    pub boundary_cycles: usize,
    /// Vertices without edges.
    pub isolated_vertices: usize,
    /// One entry for each connected component, in the order of their first vertices.
    pub components: Vec<ComponentCounts>,
}

impl Counts {
    /// V - E + F. In the plane this is 1 + the number of components.
    #[must_use]
    pub const fn euler(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.faces as i64
    }

    /// V - E + (cycles + isolated vertices): the sum of 2 - 2g over all components.
    #[must_use]
    pub const fn closed_euler(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.cycles as i64 + self.isolated_vertices as i64
    }

    /// The genus of all components together.
    #[must_use]
    pub fn genus(&self) -> i64 {
        self.components.iter().map(ComponentCounts::genus).sum()
    }
}

/// Counts a view. Boundary faces are its outer face and its hole faces.
///
/// ```
/// use dcel_kit::topology::{Dcel, measure};
/// let counts = measure(&Dcel::polygon(6)?);
/// assert_eq!((counts.vertices, counts.edges, counts.faces, counts.closed_euler()), (6, 6, 2, 2));
/// # Ok::<(), dcel_kit::topology::PolygonError>(())
/// ```
#[must_use]
pub fn measure<V: View + ?Sized>(view: &V) -> Counts {
    let outer = view.outer_face();
    measure_with(view, |f| outer == Some(f) || view.is_hole(f))
}

/// [`measure`] with other boundary faces: on a surface, the faces that stand for missing ones.
#[must_use]
pub fn measure_with<V: View + ?Sized>(view: &V, is_boundary: impl Fn(FaceId) -> bool) -> Counts {
    count(&Flat::read(view), &is_boundary)
}

pub(super) fn count(flat: &Flat<'_>, is_boundary: &dyn Fn(FaceId) -> bool) -> Counts {
    let parts = parts(flat);
    let mode = if flat.outer.is_some() { Mode::Plane } else { Mode::Surface };
    let half_edges = flat.half_edges().count();
    let mut counts = Counts {
        mode,
        vertices: flat.vertices().count(),
        half_edges,
        edges: half_edges / 2,
        face_records: flat.faces().count(),
        faces: flat.faces().filter(|&f| mode == Mode::Plane || !is_boundary(FaceId(f))).count(),
        cycles: 0,
        boundary_cycles: 0,
        isolated_vertices: 0,
        components: vec![ComponentCounts { first_vertex: VertexId(0), vertices: 0, edges: 0, cycles: 0 }; parts.count],
    };
    for v in flat.vertices().collect::<Vec<_>>().into_iter().rev() {
        let part = &mut counts.components[parts.of[VertexId(v)] as usize];
        part.first_vertex = VertexId(v);
        part.vertices += 1;
    }
    for h in flat.half_edges().filter(|&h| flat.origin[h as usize] != NONE) {
        // Half-edges for now; halved below.
        counts.components[parts.of[VertexId(flat.origin[h as usize])] as usize].edges += 1;
    }
    for part in &mut counts.components {
        if part.edges == 0 {
            part.cycles = 1;
            counts.isolated_vertices += 1;
        }
        part.edges /= 2;
    }
    let mut seen = vec![false; flat.next.len()];
    let next = |h: u32| Some(flat.next[h as usize]).filter(|&n| n != NONE);
    let _ = closed_orbits::<Infallible>(
        flat.half_edges(),
        |h| !std::mem::replace(&mut seen[h as usize], true),
        next,
        |cycle| {
            let (origin, face) = (flat.origin[cycle[0] as usize], flat.face[cycle[0] as usize]);
            counts.cycles += 1;
            counts.boundary_cycles += usize::from(face != NONE && is_boundary(FaceId(face)));
            if origin != NONE {
                counts.components[parts.of[VertexId(origin)] as usize].cycles += 1;
            }
            ControlFlow::Continue(())
        },
    );
    counts
}

/// Which connected component each vertex belongs to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Components {
    of: VertexMap<u32>,
    count: usize,
}

impl Components {
    /// The number of components. An isolated vertex is one.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// The component of `v`, from 0 on in the order of their lowest vertices; `None` if `v` does not exist.
    #[must_use]
    pub fn of(&self, v: VertexId) -> Option<u32> {
        self.of.get(v).copied().filter(|&part| part != NONE)
    }
}

/// The connected components: vertices joined by edges belong together. Faces join nothing: an island in a
/// face is a component of its own.
///
/// Cost: linear but for the inverse Ackermann function (union by lowest number, halving paths).
#[must_use]
pub fn components<V: View + ?Sized>(view: &V) -> Components {
    parts(&Flat::read(view))
}

pub(super) fn parts(flat: &Flat<'_>) -> Components {
    let mut joined = Joined::none(flat.outgoing.len());
    for h in flat.half_edges() {
        let twin = flat.twin(h);
        let (u, v) = (flat.origin[h as usize], if twin == NONE { NONE } else { flat.origin[twin as usize] });
        if u != NONE && v != NONE {
            joined.join(u, v);
        }
    }
    let mut components = Components { of: VertexMap::filled(flat.outgoing.len(), NONE), count: 0 };
    // The root of a component is its lowest vertex, so it has its number before the others ask for it.
    for v in flat.vertices() {
        let root = joined.root(v);
        if root == v {
            components.of[VertexId(v)] = components.count as u32;
            components.count += 1;
        } else {
            components.of[VertexId(v)] = components.of[VertexId(root)];
        }
    }
    components
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::HalfEdgeId;
    use crate::topology::{Dcel, Table};

    /// A torus from one vertex, two loops and one face: the boundary a b a^-1 b^-1.
    fn torus() -> Table {
        let mut table = Table::from_view(&Dcel::polygon(1).unwrap());
        let row = table.half_edges[0].unwrap();
        let cycle = [0, 2, 1, 3];
        table.half_edges = vec![Some(row); 4];
        for (i, &h) in cycle.iter().enumerate() {
            let row = table.half_edges[h].as_mut().unwrap();
            row.origin = Some(VertexId(0));
            row.face = Some(FaceId(0));
            row.twin = Some(HalfEdgeId(h as u32 ^ 1));
            row.next = Some(HalfEdgeId(cycle[(i + 1) % 4] as u32));
            row.prev = Some(HalfEdgeId(cycle[(i + 3) % 4] as u32));
        }
        table.faces.truncate(1);
        table.faces[0].as_mut().unwrap().half_edge = Some(HalfEdgeId(0));
        table
    }

    #[test]
    fn a_torus_has_genus_one_and_breaks_no_law() {
        let torus = torus();
        assert_eq!(crate::topology::violations(&torus), []);
        let counts = measure(&torus);
        assert_eq!((counts.mode, counts.closed_euler(), counts.genus()), (Mode::Surface, 0, 1));
        assert_eq!((counts.vertices, counts.edges, counts.cycles, counts.components.len()), (1, 2, 1, 1));
    }

    #[test]
    fn components_are_numbered_by_their_lowest_vertex() {
        // Vertices of two triangles in one table, shuffled: v0 v2 v4 and v1 v3 v5; v6 is isolated, v7 missing.
        let one = Table::from_view(&Dcel::polygon(3).unwrap());
        let mut both = Table::default();
        both.vertices.resize(8, one.vertices[0]);
        both.vertices[6].as_mut().unwrap().outgoing = None;
        both.vertices[7] = None;
        for part in 0..2u32 {
            both.half_edges.extend(one.half_edges.iter().map(|row| {
                let mut row = row.unwrap();
                let shift = |h: HalfEdgeId| HalfEdgeId(h.0 + 6 * part);
                row.origin = row.origin.map(|v| VertexId(2 * v.0 + part));
                (row.twin, row.next, row.prev) = (row.twin.map(shift), row.next.map(shift), row.prev.map(shift));
                Some(row)
            }));
        }
        both.faces = one.faces;
        let parts = components(&both);
        let of: Vec<_> = (0..8).map(|v| parts.of(VertexId(v))).collect();
        assert_eq!(parts.count(), 3);
        assert_eq!(of, [Some(0), Some(1), Some(0), Some(1), Some(0), Some(1), Some(2), None]);
        let counts = measure(&both);
        let firsts: Vec<_> = counts.components.iter().map(|c| (c.first_vertex.0, c.vertices, c.edges)).collect();
        assert_eq!(firsts, [(0, 3, 3), (1, 3, 3), (6, 1, 0)]);
        assert_eq!((counts.cycles, counts.isolated_vertices, counts.closed_euler()), (4, 1, 6));
    }

    #[test]
    fn boundary_faces_are_not_faces_of_a_surface_but_of_the_plane() {
        let mut table = Table::from_view(&Dcel::polygon(4).unwrap());
        let surface = measure_with(&table, |f| f.0 == 1);
        assert_eq!((surface.faces, surface.face_records, surface.boundary_cycles, surface.euler()), (1, 2, 1, 1));
        table.outer_face = Some(FaceId(0));
        let plane = measure(&table);
        assert_eq!((plane.mode, plane.faces, plane.boundary_cycles, plane.euler()), (Mode::Plane, 2, 1, 2));
        table.faces[1].as_mut().unwrap().hole = true;
        assert_eq!(measure(&table).boundary_cycles, 2);
    }
}
