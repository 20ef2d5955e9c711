//! Arcs of circles as curves.
//!
//! ```text
//!    from ╭──╮         clockwise as seen, in pieces of at most an eighth of a circle, each one cubic curve:
//!        ╱ c  ╲        its control points lie on the tangents, 4/3 tan(t/4) of the radius from its ends
//!             to
//! ```

use crate::figure::canvas::vector::{Xy, xy};

/// The clockwise arc of a circle as cubic curves of at most an eighth of a circle.
pub(crate) fn arc(from: Xy, to: Xy, radius: f64, large: bool, cubic: &mut impl FnMut(Xy, Xy, Xy)) {
    let half = (to - from) * 0.5;
    let (chord, radius) = (half.length(), radius.max(half.length()));
    if chord == 0.0 {
        return;
    }
    let far = (radius * radius - chord * chord).max(0.0).sqrt() / chord;
    let beside = xy(-half.y, half.x) * if large { -far } else { far };
    let centre = from + half + beside;
    let spokes = [from - centre, to - centre];
    pieces(centre, radius, spokes, large, cubic);
}

fn pieces(centre: Xy, radius: f64, [u, v]: [Xy; 2], large: bool, cubic: &mut impl FnMut(Xy, Xy, Xy)) {
    let cosine = u.dot(v) / (radius * radius);
    if !large && cosine > 0.7 {
        // tan(t/2), then tan(t/4), of the angle t between the spokes.
        let half = ((1.0 - cosine).max(0.0) / (1.0 + cosine)).sqrt();
        let quarter = half / (1.0 + (1.0 + half * half).sqrt());
        let reach = 4.0 / 3.0 * quarter;
        let across = |w: Xy| xy(-w.y, w.x) * reach;
        cubic(centre + u + across(u), centre + v - across(v), centre + v);
        return;
    }
    let sum = u + v;
    let middle = match sum.length() {
        // Half a circle: a quarter of a turn further.
        length if length < 1e-9 * radius => xy(-u.y, u.x),
        length => sum * (radius / length) * if large { -1.0 } else { 1.0 },
    };
    pieces(centre, radius, [u, middle], false, cubic);
    pieces(centre, radius, [middle, v], false, cubic);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcs_of_all_sizes_end_where_they_should_and_stay_on_their_circle() {
        // By the angles between the ends, clockwise as one sees it: a quarter, a half, three quarters.
        let ends = [(xy(10.0, 0.0), xy(0.0, 10.0)), (xy(10.0, 0.0), xy(-10.0, 0.0)), (xy(10.0, 0.0), xy(0.0, -10.0))];
        for ((from, to), (large, eighths)) in ends.into_iter().zip([(false, 2), (false, 4), (true, 8)]) {
            let mut curves = Vec::new();
            let mut at = from;
            arc(from, to, 10.0, large, &mut |a, b, to| {
                curves.push([at, a, b, to]);
                at = to;
            });
            assert_eq!(curves.len(), eighths, "{from:?} {to:?}");
            assert!((at - to).length() < 1e-9);
            for [p, a, b, q] in curves {
                for t in [0.25, 0.5, 0.75, 1.0] {
                    let s = 1.0 - t;
                    let on = p * (s * s * s) + a * (3.0 * s * s * t) + b * (3.0 * s * t * t) + q * (t * t * t);
                    assert!((on.length() - 10.0).abs() < 1e-3, "{on:?}");
                }
                // Clockwise on the canvas, whose y points down: to the right of the way is the middle.
                assert!(p.x * q.y - p.y * q.x > 0.0);
            }
        }
    }
}
