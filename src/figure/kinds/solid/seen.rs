//! What is seen of a solid: whole faces, parts of faces, parts of edges.

use crate::figure::kinds::solid::camera::Picture;
use crate::figure::kinds::solid::hidden::{Look, Stretches};
use crate::figure::kinds::solid::parts::parts;
use crate::ids::{EdgeId, FaceId};
use crate::plane::Point;
use crate::solid::Polyhedron;

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
    /// What is seen of other faces: cells of the paper, each with its holes.
    pub(super) parts: Vec<Vec<Vec<Point>>>,
}

impl Seen {
    pub(super) fn new(solid: &Polyhedron, picture: &Picture) -> Self {
        let look = Look::new(solid, picture);
        let index = solid.check_convex().is_err().then(|| look.index());
        let mut whole = look.front.clone();
        let mut cut: Vec<(EdgeId, Stretches)> = Vec::new();
        let mut cover = None;
        for e in solid.edges() {
            let sides = look.sides(e);
            let away = sides.iter().all(|&f| solid.is_boundary_face(f) || !look.front[f]);
            let closed = sides.iter().all(|&f| !solid.is_boundary_face(f));
            let pieces = match (&index, away && closed) {
                (_, true) => vec![(0.0, 1.0, true)],
                (None, false) => vec![(0.0, 1.0, false)],
                (Some(index), false) => look.cut(e, index, &mut cover),
            };
            if pieces.iter().any(|&(.., hidden)| hidden) {
                sides.iter().for_each(|&f| whole[f] = false);
            }
            cut.push((e, pieces));
        }
        if index.is_some() {
            look.clear_covered(&mut whole);
        }
        let faces: Vec<FaceId> = solid.polygon_faces().filter(|&f| whole[f]).collect();
        let parts = index.map_or_else(Vec::new, |index| parts(&look, &index, &whole, &cut));
        let mut seen = Self { faces, pieces: Vec::new(), parts };
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
