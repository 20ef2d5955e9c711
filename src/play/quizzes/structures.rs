//! Structures to ask about: polygons cut by random splits, the same for the same seed.

use crate::ids::{HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};
use crate::play::dice::Dice;

/// Convex polygons with unequal sides, so that no two corners look alike.
const POLYGONS: [&[(f64, f64)]; 4] = [
    &[(-250., -150.), (0., -150.), (250., -150.), (250., 150.), (0., 150.), (-250., 150.)],
    &[(-240., -140.), (60., -160.), (250., -20.), (190., 150.), (-90., 160.), (-250., 40.)],
    &[(-200., -150.), (130., -150.), (250., 10.), (90., 160.), (-230., 120.)],
    &[(-250., -60.), (-90., -160.), (120., -150.), (250., -30.), (200., 120.), (20., 165.), (-180., 120.)],
];

/// A polygon cut by so many splits; faces stay large enough to be read.
pub(super) fn random(dice: &mut Dice, splits: usize) -> Subdivision {
    let corners: Vec<Point> = dice.pick(&POLYGONS).copied().unwrap_or(POLYGONS[0]).iter().map(|&p| p.into()).collect();
    let mut s = Subdivision::polygon(&corners).unwrap_or_else(|_| Subdivision::lab_rectangle());
    let mut made = 0;
    for _ in 0..40 * splits {
        if made == splits {
            break;
        }
        let half_edges: Vec<HalfEdgeId> = s.half_edges().filter(|&h| s.face(h) != s.outer_face()).collect();
        let Some(&a) = dice.pick(&half_edges) else { break };
        let cycle: Vec<HalfEdgeId> = s.cycle(a).collect();
        if cycle.len() < 4 {
            let long = distance(&s, s.origin(a), s.destination(a)) > 180.0;
            made += usize::from(long && s.split_in_half(a).is_ok());
            continue;
        }
        let Some(&b) = dice.pick(&cycle) else { break };
        let far = distance(&s, s.origin(a), s.origin(b)) > 120.0;
        made += usize::from(far && s.split_face(a, b).is_ok());
    }
    s
}

fn distance(s: &Subdivision, u: VertexId, v: VertexId) -> f64 {
    let (p, q) = (s.point(u), s.point(v));
    ((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y)).sqrt()
}
