//! Circles and arcs, cut by the frame.
//!
//! ```text
//!        ╭───╮
//!   ┌───╱─────╲──┐      Where the circle crosses the four sides it is cut; of the pieces in counter-clockwise
//!   │  │   ∘   │ │      order those whose middle is inside are kept. Directions are unit vectors: nothing
//!   └───╲─────╱──┘      here needs an angle.
//!        ╰───╯
//! ```

use crate::figure::canvas::scene::{Node, Step};
use crate::figure::canvas::vector::{Bounds, Xy, xy};

/// A circle of the canvas.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Round {
    pub(super) centre: Xy,
    pub(super) radius: f64,
}

/// A piece of a circle, counter-clockwise as seen, from one direction to another; the whole of it if they are
/// equal.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Piece {
    pub(super) from: Xy,
    pub(super) to: Xy,
}

/// How far it is round from `from` to `to`: more than 0, up to 4.
fn sweep(from: Xy, to: Xy) -> f64 {
    let turn = to.pseudo_angle() - from.pseudo_angle();
    if turn > 0.0 { turn } else { turn + 4.0 }
}

/// The direction in the middle.
fn middle(from: Xy, to: Xy) -> Xy {
    if from == to {
        return from * -1.0;
    }
    let sum = (from + to).unit().unwrap_or_else(|| from.left());
    let on_the_way = sweep(from, sum) <= sweep(from, to);
    if on_the_way { sum } else { sum * -1.0 }
}

impl Piece {
    pub(super) const WHOLE: Self = Self { from: xy(1.0, 0.0), to: xy(1.0, 0.0) };
}

impl Round {
    fn at(&self, direction: Xy) -> Xy {
        self.centre + direction * self.radius
    }

    /// Whether the whole circle is inside.
    pub(super) fn is_inside(&self, frame: &Bounds) -> bool {
        frame.contains(&Bounds::around(self.centre, self.radius, self.radius))
    }

    /// The parts of a piece inside the frame.
    pub(super) fn inside(&self, piece: Piece, frame: &Bounds) -> Vec<Piece> {
        let mut cuts = Vec::new();
        for (side, x) in [(frame.min.x, true), (frame.max.x, true), (frame.min.y, false), (frame.max.y, false)] {
            let along = (side - if x { self.centre.x } else { self.centre.y }) / self.radius;
            if along.abs() < 1.0 {
                let across = (1.0 - along * along).sqrt();
                cuts.extend([across, -across].map(|across| if x { xy(along, across) } else { xy(across, along) }));
            }
        }
        if piece == Piece::WHOLE
            && let Some(&cut) = cuts.first()
        {
            // Begin at the frame, so that no piece is cut where nothing is.
            return self.inside(Piece { from: cut, to: cut }, frame);
        }
        let end = sweep(piece.from, piece.to);
        cuts.retain(|&cut| cut != piece.from && sweep(piece.from, cut) < end);
        cuts.sort_by(|&a, &b| sweep(piece.from, a).total_cmp(&sweep(piece.from, b)));
        let ends = cuts.iter().copied().chain([piece.to]);
        let pieces = std::iter::once(piece.from).chain(cuts.iter().copied()).zip(ends);
        let inside = |&(from, to): &(Xy, Xy)| {
            let p = self.at(middle(from, to));
            frame.contains(&Bounds { min: p, max: p })
        };
        pieces.filter(inside).map(|(from, to)| Piece { from, to }).collect()
    }

    /// A piece as a line.
    pub(super) fn curve(&self, piece: Piece, class: &'static str) -> Node {
        if piece.from == piece.to {
            return Node::Disc { class, centre: self.centre, radius: self.radius };
        }
        // Steps go clockwise, pieces counter-clockwise.
        let step =
            Step::Round { radius: self.radius, large: sweep(piece.from, piece.to) > 2.0, to: self.at(piece.from) };
        Node::Curve { class, start: self.at(piece.to), steps: vec![step] }
    }

    /// Points along a piece, close enough for clearances and for areas that are cut.
    pub(super) fn points(&self, piece: Piece) -> Vec<Xy> {
        let mut ways = vec![piece.from, middle(piece.from, piece.to), piece.to];
        for _ in 0..5 {
            let finer = ways.windows(2).flat_map(|w| [middle(w[0], w[1]), w[1]]);
            ways = std::iter::once(piece.from).chain(finer).collect();
        }
        ways.into_iter().map(|way| self.at(way)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame() -> Bounds {
        Bounds { min: xy(0.0, 0.0), max: xy(100.0, 60.0) }
    }

    #[test]
    fn a_circle_across_two_sides_leaves_two_arcs_inside() {
        let round = Round { centre: xy(50.0, 30.0), radius: 40.0 };
        assert!(!round.is_inside(&frame()));
        let pieces = round.inside(Piece::WHOLE, &frame());
        assert_eq!(pieces.len(), 2, "{pieces:?}");
        for p in pieces.iter().flat_map(|&piece| round.points(piece)) {
            assert!(frame().grown(1e-9).contains(&Bounds { min: p, max: p }), "{p:?}");
            assert!(((p - round.centre).length() - 40.0).abs() < 1e-9);
        }
    }

    #[test]
    fn circles_inside_outside_and_around() {
        let inside = |x, y, radius| Round { centre: xy(x, y), radius }.inside(Piece::WHOLE, &frame());
        assert_eq!(inside(50.0, 30.0, 20.0), [Piece::WHOLE]);
        assert!(inside(50.0, 30.0, 500.0).is_empty());
        assert!(inside(300.0, 30.0, 20.0).is_empty());
    }

    #[test]
    fn middles_lie_on_the_way() {
        let (east, north, west, south) = (xy(1.0, 0.0), xy(0.0, -1.0), xy(-1.0, 0.0), xy(0.0, 1.0));
        assert_eq!(middle(east, west), north);
        assert_eq!(middle(west, east), south);
        assert_eq!(middle(east, east), west);
        let far = middle(north, east);
        assert!(far.x < 0.0 && far.y > 0.0, "three quarters from north to east: {far:?}");
        let round = Round { centre: xy(0.0, 0.0), radius: 1.0 };
        let way = round.points(Piece { from: south, to: north });
        assert!(way.iter().all(|p| p.x >= -1e-12), "from south by east to north");
        let Node::Curve { start, steps, .. } = round.curve(Piece { from: south, to: west }, "ln") else { panic!() };
        assert_eq!(start, west);
        assert_eq!(steps, [Step::Round { radius: 1.0, large: true, to: south }]);
    }
}
