//! Which faces and which parts of edges are seen.
//!
//! ```text
//!     ●━━━━━━━●        outline: edges between a face that looks at the eye and one that looks away, and borders.
//!     ┃  seen ┃        An edge that passes behind changes between seen and hidden only at an outline.
//!  ●──╂┄┄┄┄┄┄┄╂──●
//!     ┗━━━━━━━┛
//! ```

use crate::figure::kinds::solid::camera::{Picture, dot, minus};
use crate::ids::{EdgeId, FaceId, FaceMap};
use crate::plane::Point;
use crate::solid::Polyhedron;

/// Parts of an edge, from 0 at one end to 1 at the other: from, to, and whether it is hidden.
type Stretches = Vec<(f64, f64, bool)>;

/// A straight part of an edge on the paper.
pub(super) struct Piece {
    pub(super) ends: [Point; 2],
    pub(super) is_hidden: bool,
}

/// What is seen of a solid.
pub(super) struct Seen {
    /// The faces that are seen whole.
    pub(super) faces: Vec<FaceId>,
    /// The parts of the edges that are no sides of these, from edge to edge, in order.
    pub(super) pieces: Vec<Piece>,
}

/// The solid and its picture, while it is looked at.
struct Look<'a> {
    solid: &'a Polyhedron,
    picture: &'a Picture,
    /// Whether a face looks at the eye.
    front: FaceMap<bool>,
    /// The corners of each face on the paper, and the least and greatest x and y of them.
    shapes: FaceMap<(Vec<Point>, [f64; 4])>,
    /// The area vector of each face, and the mean of its corners.
    planes: FaceMap<[[f64; 3]; 2]>,
    outline: Vec<EdgeId>,
}

impl Seen {
    pub(super) fn new(solid: &Polyhedron, picture: &Picture) -> Self {
        let look = Look::new(solid, picture);
        let is_convex = solid.check_convex().is_ok();
        let mut whole = look.front.clone();
        let mut cut: Vec<(EdgeId, Stretches)> = Vec::new();
        for e in solid.edges() {
            let sides = look.sides(e);
            let away = sides.iter().all(|&f| solid.is_boundary_face(f) || !look.front[f]);
            let closed = sides.iter().all(|&f| !solid.is_boundary_face(f));
            let pieces = match (is_convex, away && closed) {
                (_, true) => vec![(0.0, 1.0, true)],
                (true, false) => vec![(0.0, 1.0, false)],
                (false, false) => look.cut(e),
            };
            if pieces.iter().any(|&(.., hidden)| hidden) {
                sides.iter().for_each(|&f| whole[f] = false);
            }
            cut.push((e, pieces));
        }
        if !is_convex {
            look.clear_covered(&mut whole);
        }
        let faces: Vec<FaceId> = solid.polygon_faces().filter(|&f| whole[f]).collect();
        let mut seen = Self { faces, pieces: Vec::new() };
        // Hidden parts first, so that seen ones lie over them.
        let rest: Vec<_> = cut.into_iter().filter(|&(e, _)| !look.sides(e).iter().any(|&f| whole[f])).collect();
        for hidden in [true, false] {
            for (e, pieces) in &rest {
                for &(from, to, _) in pieces.iter().filter(|&&(.., is_hidden)| is_hidden == hidden) {
                    let ends = [from, to].map(|t| picture.place(look.along(*e, t)));
                    seen.pieces.push(Piece { ends, is_hidden: hidden });
                }
            }
        }
        seen
    }
}

impl<'a> Look<'a> {
    fn new(solid: &'a Polyhedron, picture: &'a Picture) -> Self {
        let mut front = FaceMap::filled(solid.face_bound(), false);
        let mut shapes = FaceMap::filled(solid.face_bound(), (Vec::new(), [0.0; 4]));
        let mut planes = FaceMap::filled(solid.face_bound(), [[0.0; 3]; 2]);
        for f in solid.polygon_faces() {
            let [normal, mean] = [solid.area_vector(f), solid.face_mean(f)];
            planes[f] = [normal, mean];
            front[f] = dot(normal, picture.ray(mean)) > 0.0;
            let corners: Vec<Point> = solid.incident_vertices(f).map(|v| picture.points[v]).collect();
            let empty = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
            let bounds = corners.iter().fold(empty, |[a, b, c, d], p| [a.min(p.x), b.max(p.x), c.min(p.y), d.max(p.y)]);
            shapes[f] = (corners, bounds);
        }
        let mut look = Self { solid, picture, front, shapes, planes, outline: Vec::new() };
        look.outline = solid
            .edges()
            .filter(|&e| {
                let [a, b] = look.sides(e);
                look.front[a] != look.front[b] || solid.is_boundary_face(a) || solid.is_boundary_face(b)
            })
            .collect();
        look
    }

    fn sides(&self, e: EdgeId) -> [FaceId; 2] {
        e.half_edges().map(|h| self.solid.topology().face(h))
    }

    fn ends(&self, e: EdgeId) -> [[f64; 3]; 2] {
        e.half_edges().map(|h| self.solid.point(self.solid.topology().origin(h)))
    }

    fn along(&self, e: EdgeId, t: f64) -> [f64; 3] {
        let [a, b] = self.ends(e);
        [0, 1, 2].map(|i| a[i] + t * (b[i] - a[i]))
    }

    /// The parts of an edge. Neighbours that are alike are one part.
    fn cut(&self, e: EdgeId) -> Stretches {
        let [a, b] = self.ends(e).map(|p| self.picture.place(p));
        let mut places = vec![0.0, 1.0];
        for &other in self.outline.iter().filter(|&&other| other != e) {
            let [c, d] = self.ends(other).map(|p| self.picture.place(p));
            let (along, across) = ([b.x - a.x, b.y - a.y], [d.x - c.x, d.y - c.y]);
            let turn = along[0] * across[1] - along[1] * across[0];
            let gap = [c.x - a.x, c.y - a.y];
            let t = (gap[0] * across[1] - gap[1] * across[0]) / turn;
            let u = (gap[0] * along[1] - gap[1] * along[0]) / turn;
            if (1e-9..1.0 - 1e-9).contains(&t) && (-1e-9..1.0 + 1e-9).contains(&u) {
                places.push(self.place_in_space(e, t));
            }
        }
        places.sort_by(f64::total_cmp);
        let mut pieces = Stretches::new();
        for pair in places.windows(2).filter(|pair| pair[1] - pair[0] > 1e-9) {
            let hidden = self.is_covered(self.along(e, f64::midpoint(pair[0], pair[1])), &self.sides(e));
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

    /// Whether a face that is none of `own` lies between `p` and the eye.
    fn is_covered(&self, p: [f64; 3], own: &[FaceId]) -> bool {
        let at = self.picture.place(p);
        self.solid.polygon_faces().filter(|f| !own.contains(f)).any(|f| self.covers(f, p, at))
    }

    fn covers(&self, f: FaceId, p: [f64; 3], at: Point) -> bool {
        let (corners, [left, right, low, high]) = &self.shapes[f];
        if at.x < *left || at.x > *right || at.y < *low || at.y > *high || !is_inside(corners, at) {
            return false;
        }
        let [normal, mean] = self.planes[f];
        let ray = self.picture.ray(p);
        let steps = dot(normal, minus(mean, p)) / dot(normal, ray);
        let size = dot(ray, ray).sqrt();
        steps.is_finite() && steps * size > 1e-7 * self.picture.size
    }

    /// Takes faces out that something stands in front of, although all of their edges are seen.
    fn clear_covered(&self, whole: &mut FaceMap<bool>) {
        for &e in &self.outline {
            let middle = self.along(e, 0.5);
            let at = self.picture.place(middle);
            let own = self.sides(e);
            for f in self.solid.polygon_faces().filter(|f| !own.contains(f)) {
                let (corners, [left, right, low, high]) = &self.shapes[f];
                let near = at.x >= *left && at.x <= *right && at.y >= *low && at.y <= *high;
                if whole[f] && near && is_inside(corners, at) && !self.covers(f, middle, at) {
                    whole[f] = false;
                }
            }
        }
    }
}

/// Whether a point lies in a polygon, by the number of sides to its right.
fn is_inside(corners: &[Point], at: Point) -> bool {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let crossed =
        sides.filter(|(a, b)| (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x));
    crossed.count() % 2 == 1
}
