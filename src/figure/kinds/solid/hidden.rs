//! Which parts of edges are hidden.
//!
//! ```text
//!     ●━━━━━━━●        outline: edges between a face that looks at the eye and one that looks away, and borders.
//!     ┃  seen ┃        An edge that passes behind changes between seen and hidden only at an outline.
//!  ●──╂┄┄┄┄┄┄┄╂──●
//!     ┗━━━━━━━┛
//! ```

use crate::figure::kinds::solid::camera::Picture;
use crate::figure::kinds::solid::inside::Outline;
use crate::figure::kinds::solid::tree::{Bounds, Tree};
use crate::ids::{EdgeId, FaceId, FaceMap};
use crate::plane::Point;
use crate::solid::Polyhedron;
use crate::solid::vector::{dot, minus};

/// Parts of an edge, from 0 at one end to 1 at the other: from, to, and whether it is hidden.
pub(super) type Stretches = Vec<(f64, f64, bool)>;

/// The solid and its picture, while it is looked at.
pub(super) struct Look<'a> {
    solid: &'a Polyhedron,
    pub(super) picture: &'a Picture,
    /// Whether a face looks at the eye.
    pub(super) front: FaceMap<bool>,
    /// Each face on the paper, and its box.
    pub(super) shapes: FaceMap<(Outline, Bounds)>,
    /// The area vector of each face, and the mean of its corners.
    pub(super) planes: FaceMap<[[f64; 3]; 2]>,
    outline: Vec<EdgeId>,
}

/// What may hide something, by where it is on the paper.
pub(super) struct Index {
    pub(super) polygons: Vec<FaceId>,
    pub(super) faces: Tree,
    outline: Tree,
}

/// Edges are looked for so much further out, in sizes of the solid, than where they are.
const MARGIN: f64 = 1e-6;

impl<'a> Look<'a> {
    pub(super) fn new(solid: &'a Polyhedron, picture: &'a Picture) -> Self {
        let mut front = FaceMap::filled(solid.face_bound(), false);
        let mut shapes = FaceMap::filled(solid.face_bound(), (Outline::default(), Bounds::NONE));
        let mut planes = FaceMap::filled(solid.face_bound(), [[0.0; 3]; 2]);
        for f in solid.polygon_faces() {
            let [normal, mean] = [solid.area_vector(f), solid.face_mean(f)];
            planes[f] = [normal, mean];
            front[f] = dot(normal, picture.ray(mean)) > 0.0;
            let corners: Vec<Point> = solid.incident_vertices(f).map(|v| picture.points[v]).collect();
            let near = solid.incident_vertices(f).map(|v| picture.nearness_on(solid.point(v), planes[f]));
            let near = near.fold(f64::NEG_INFINITY, f64::max);
            let bounds = corners.iter().fold(Bounds::NONE, |all, &p| all.with(Bounds::at(p)));
            shapes[f] = (Outline::new(corners), Bounds { near, ..bounds });
        }
        let mut look = Self { solid, picture, front, shapes, planes, outline: Vec::new() };
        let is_outline = |e: &EdgeId| {
            let [a, b] = look.sides(*e);
            look.front[a] != look.front[b] || solid.is_boundary_face(a) || solid.is_boundary_face(b)
        };
        look.outline = solid.edges().filter(is_outline).collect();
        look
    }

    pub(super) fn sides(&self, e: EdgeId) -> [FaceId; 2] {
        e.half_edges().map(|h| self.solid.topology().face(h))
    }

    pub(super) fn ends(&self, e: EdgeId) -> [[f64; 3]; 2] {
        e.half_edges().map(|h| self.solid.point(self.solid.topology().origin(h)))
    }

    pub(super) fn along(&self, e: EdgeId, t: f64) -> [f64; 3] {
        let [a, b] = self.ends(e);
        [0, 1, 2].map(|i| a[i] + t * (b[i] - a[i]))
    }

    /// Trees over the polygons and over the outline. O(n log n).
    pub(super) fn index(&self) -> Index {
        let polygons: Vec<FaceId> = self.solid.polygon_faces().collect();
        let outline: Vec<Bounds> = self.outline.iter().map(|&e| self.bounds(e)).collect();
        let flat = |i: usize| [outline[i].left + outline[i].right, outline[i].low + outline[i].high, 0.0];
        Index { faces: self.tree(&polygons), outline: Tree::new(&outline, flat), polygons }
    }

    fn tree(&self, faces: &[FaceId]) -> Tree {
        let bounds: Vec<Bounds> = faces.iter().map(|&f| self.shapes[f].1).collect();
        Tree::new(&bounds, |i| {
            let mean = self.planes[faces[i]][1];
            let Point { x, y } = self.picture.place(mean);
            [x, y, self.picture.nearness(mean)]
        })
    }

    /// The box of an edge on the paper, with a margin.
    fn bounds(&self, e: EdgeId) -> Bounds {
        let [a, b] = self.ends(e).map(|p| Bounds::at(self.picture.place(p)));
        a.with(b).wider(MARGIN * self.picture.size)
    }

    /// The parts of an edge. Neighbours that are alike are one part. `cover` is the face that hid something last: what
    /// comes next is likely to lie behind it, too.
    pub(super) fn cut(&self, e: EdgeId, index: &Index, cover: &mut Option<FaceId>) -> Stretches {
        let [a, b] = self.ends(e).map(|p| self.picture.place(p));
        let mut places = vec![0.0, 1.0];
        let own = self.bounds(e);
        index.outline.any(
            |bounds| own.touches(bounds) && bounds.meets_line(a, b),
            |other| {
                let other = self.outline[other];
                let [c, d] = self.ends(other).map(|p| self.picture.place(p));
                let (along, across) = ([b.x - a.x, b.y - a.y], [d.x - c.x, d.y - c.y]);
                let turn = along[0] * across[1] - along[1] * across[0];
                let gap = [c.x - a.x, c.y - a.y];
                let t = (gap[0] * across[1] - gap[1] * across[0]) / turn;
                let u = (gap[0] * along[1] - gap[1] * along[0]) / turn;
                if other != e && (1e-9..1.0 - 1e-9).contains(&t) && (-1e-9..1.0 + 1e-9).contains(&u) {
                    places.push(self.place_in_space(e, t));
                }
                false
            },
        );
        places.sort_by(f64::total_cmp);
        let mut pieces = Stretches::new();
        for pair in places.windows(2).filter(|pair| pair[1] - pair[0] > 1e-9) {
            let middle = self.along(e, f64::midpoint(pair[0], pair[1]));
            let own = self.sides(e);
            let again = cover.filter(|f| !own.contains(f) && self.covers(*f, middle, self.picture.place(middle)));
            let found = again.or_else(|| self.cover_of(middle, &own, index));
            let hidden = found.is_some();
            *cover = found.or(*cover);
            match pieces.last_mut() {
                Some(last) if last.2 == hidden => last.1 = pair[1],
                _ => pieces.push((pair[0], pair[1], hidden)),
            }
        }
        pieces
    }

    /// The part of an edge in space for a part of it on the paper: with an eye nearby the two are not the same.
    fn place_in_space(&self, e: EdgeId, t: f64) -> f64 {
        let [a, b] = self.ends(e).map(|p| self.picture.depth(p));
        t * a / (t * a + (1.0 - t) * b)
    }

    /// A face that is none of `own` and lies between `p` and the eye.
    fn cover_of(&self, p: [f64; 3], own: &[FaceId], index: &Index) -> Option<FaceId> {
        let (at, near) = (self.picture.place(p), self.picture.nearness(p));
        let mut cover = None;
        index.faces.any(
            |bounds| bounds.holds(at) && bounds.near >= near,
            |i| {
                let f = index.polygons[i];
                cover = (!own.contains(&f) && self.covers(f, p, at)).then_some(f);
                cover.is_some()
            },
        );
        cover
    }

    fn covers(&self, f: FaceId, p: [f64; 3], at: Point) -> bool {
        let (outline, bounds) = &self.shapes[f];
        if !bounds.holds(at) || !outline.contains(at) {
            return false;
        }
        let [normal, mean] = self.planes[f];
        let ray = self.picture.ray(p);
        let steps = dot(normal, minus(mean, p)) / dot(normal, ray);
        let size = dot(ray, ray).sqrt();
        steps.is_finite() && steps * size > 1e-7 * self.picture.size
    }

    /// Takes faces out that something stands in front of, although all of their edges are seen.
    pub(super) fn clear_covered(&self, whole: &mut FaceMap<bool>) {
        let faces: Vec<FaceId> = self.solid.polygon_faces().filter(|&f| whole[f]).collect();
        let tree = self.tree(&faces);
        for &e in &self.outline {
            let middle = self.along(e, 0.5);
            let at = self.picture.place(middle);
            let own = self.sides(e);
            tree.any(
                |bounds| bounds.holds(at),
                |i| {
                    let f = faces[i];
                    let (outline, bounds) = &self.shapes[f];
                    let behind = whole[f] && !own.contains(&f) && bounds.holds(at) && outline.contains(at);
                    if behind && !self.covers(f, middle, at) {
                        whole[f] = false;
                    }
                    false
                },
            );
        }
    }
}
