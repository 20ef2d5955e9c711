//! Catmull–Clark: quads from all faces.
//!
//! ```text
//!   face vertex     the mean of the corners
//!   edge vertex     the mean of both ends and the two face vertices beside it;    on a sharp edge its middle
//!   old vertex      (Q + 2R + (n - 3) v) / n, with Q the mean of the face vertices round it, R the mean of
//!                   the middles of its n edges;                                   with sharp edges: sharp.rs
//! ```

use super::refine::{Coarse, PIECE, Pointers, Scheme, Sizes};
use super::sharp::{Point, add, move_vertices, weighted};
use super::{SubdivideError, SubdivideEvent, Subdivided};
use crate::geometry::threads::{both, pieces};
use crate::ids::{EdgeId, HalfEdgeId, VertexId};
use crate::solid::{Polyhedron, Selection};
use crate::topology::{Observer, TooMany};

pub(super) fn step(
    solid: &Polyhedron,
    creases: &Selection<EdgeId>,
    observer: &mut impl Observer<SubdivideEvent>,
) -> Result<Subdivided, SubdivideError> {
    let coarse = Coarse::new(solid, creases);
    let d = coarse.dcel();
    let (old, edges) = (d.vertex_bound(), d.edge_bound());
    // Faces that are refined get the numbers of their middles in order.
    let mut middle_of = vec![0; d.face_bound()];
    let mut middles = 0;
    for f in d.faces().filter(|f| !coarse.is_boundary[f.index()]) {
        middle_of[f.index()] = (old + edges + middles) as u32;
        middles += 1;
    }
    let (vertices, corners) = (old + edges + middles, coarse.corners.len());
    TooMany::check(vertices, 2 * edges + corners, corners + d.face_count() - middles)?;

    tell(&coarse, &middle_of, observer);
    let sizes = Sizes { vertices, edges: 2 * edges + corners, faces: corners };
    let linked = || {
        let mut columns = coarse.refined(&CatmullClark { coarse: &coarse, middle_of: &middle_of }, &sizes);
        // Of a vertex in a face, the spoke of the last corner.
        for &h in &coarse.corners {
            columns.outgoing[middle_of[d.face(h).index()] as usize] = coarse.inner(h) + 1;
        }
        columns
    };
    let (columns, points) = both(linked, || points(&coarse, &middle_of, vertices));
    Ok(Subdivided { polyhedron: coarse.finish(columns, points, corners), creases: coarse.finer_creases() })
}

/// Corner k of h: `2h, inner(h), inner(prev h) + 1, 2 prev(h).twin + 1`; inner edges are spokes, to the middle of the face.
struct CatmullClark<'c> {
    coarse: &'c Coarse<'c>,
    /// The vertex in the middle of each face.
    middle_of: &'c [u32],
}

impl Scheme for CatmullClark<'_> {
    #[inline]
    fn before(&self, h: HalfEdgeId) -> u32 {
        self.coarse.inner(h) + 1
    }

    #[inline]
    fn inner(&self, k: u32, h: HalfEdgeId) -> [Pointers; 2] {
        let (c, d) = (self.coarse, self.coarse.dcel());
        let [n, p] = [d.next(h), d.prev(h)];
        let out = Pointers { origin: c.middle(h), next: c.inner(p) + 1, prev: 2 * h.number(), face: k };
        let (next, prev, face) = (2 * h.twin().number() + 1, c.inner(n), c.corner[n.index()]);
        [out, Pointers { origin: self.middle_of[d.face(h).index()], next, prev, face }]
    }
}

/// The vertices that are made and moved: of faces, of edges, the old ones.
fn tell(coarse: &Coarse<'_>, middle_of: &[u32], observer: &mut impl Observer<SubdivideEvent>) {
    let (d, old) = (coarse.dcel(), coarse.dcel().vertex_bound());
    for f in d.faces().filter(|f| !coarse.is_boundary[f.index()]) {
        observer.observe(|| SubdivideEvent::Face { face: f, vertex: VertexId::new(middle_of[f.index()]) });
    }
    for e in d.edges() {
        observer.observe(|| SubdivideEvent::Edge { edge: e, vertex: VertexId::new((old + e.index()) as u32) });
    }
    d.vertices().for_each(|v| observer.observe(|| SubdivideEvent::Vertex(v)));
}

fn points(coarse: &Coarse<'_>, middle_of: &[u32], vertices: usize) -> Vec<Point> {
    let (d, solid) = (coarse.dcel(), &coarse.solid);
    let (old, edges) = (d.vertex_bound(), d.edge_bound());
    let mut points = vec![[0.0; 3]; vertices];
    let (others, of_faces) = points.split_at_mut(old + edges);
    for f in d.faces().filter(|f| !coarse.is_boundary[f.index()]) {
        let (mut sum, mut sides) = ([0.0; 3], 0.0);
        for v in d.incident_vertices(f) {
            add(&mut sum, solid.point(v));
            sides += 1.0;
        }
        of_faces[middle_of[f.index()] as usize - old - edges] = sum.map(|x| x / sides);
    }
    let of_faces = &*of_faces;
    let middle = |h| of_faces[middle_of[d.face(h).index()] as usize - old - edges];
    let (of_vertices, of_edges) = others.split_at_mut(old);
    pieces(of_edges, PIECE, |first, piece| {
        for (e, point) in (first as u32..).map(EdgeId::new).zip(piece) {
            let [a, b] = e.half_edges();
            let ends = weighted([(0.5, solid.point(d.origin(a))), (0.5, solid.point(d.origin(b)))]);
            *point =
                if coarse.is_sharp(a) { ends } else { weighted([(0.5, ends), (0.25, middle(a)), (0.25, middle(b))]) };
        }
    });
    move_vertices(coarse, of_vertices, |v, here| {
        let (mut ends, mut faces, mut n) = ([0.0; 3], [0.0; 3], 0.0);
        for h in d.outgoing_half_edges(v) {
            add(&mut ends, solid.point(d.destination(h)));
            add(&mut faces, middle(h));
            n += 1.0;
        }
        // 2R = v + the mean of the other ends.
        weighted([((n - 2.0) / n, here), (1.0 / (n * n), ends), (1.0 / (n * n), faces)])
    });
    points
}
