//! Lines that end at the frame, and wedges cut by it.
//!
//! ```text
//!   ┌──────────────┐       A line that reaches the frame ends exactly on it: the coordinate of the side is
//!   │    ╱▒▒▒▒▒▒▒▒▒│       taken over, not computed.
//!   │  ╱▒▒▒▒▒▒▒▒▒▒▒│       A wedge is the frame cut by the half-planes of its two rays; one of more than
//!   │ ●────────────│       180° is the frame without the wedge that is missing.
//!   └──────────────┘
//! ```
//!
//! Source: Liang and Barsky, *A new concept and method for line clipping*, 1984.

use crate::figure::canvas::crop::cut_by_side;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use std::cmp::Ordering;

/// The part of `p + t · way` with `from <= t <= to` inside the box.
fn part(p: Xy, way: Xy, from: f64, to: f64, frame: &Bounds) -> Option<(Xy, Xy)> {
    let mut ends = [(from, None), (to, None)];
    for (x, step, low, high) in [(true, way.x, frame.min.x, frame.max.x), (false, way.y, frame.min.y, frame.max.y)] {
        let start = if x { p.x } else { p.y };
        if step == 0.0 {
            if start < low || start > high {
                return None;
            }
            continue;
        }
        let (near, far) = if step > 0.0 { (low, high) } else { (high, low) };
        let at = |side: f64| (side - start) / step;
        if at(near) > ends[0].0 {
            ends[0] = (at(near), Some((x, near)));
        }
        if at(far) < ends[1].0 {
            ends[1] = (at(far), Some((x, far)));
        }
    }
    let on = |(t, side): (f64, Option<(bool, f64)>)| {
        let q = p + way * t;
        match side {
            Some((true, x)) => xy(x, q.y.clamp(frame.min.y, frame.max.y)),
            Some((false, y)) => xy(q.x.clamp(frame.min.x, frame.max.x), y),
            None => q,
        }
    };
    (ends[0].0 <= ends[1].0).then(|| (on(ends[0]), on(ends[1])))
}

/// The part of a segment inside the frame.
pub(super) fn segment(a: Xy, b: Xy, frame: &Bounds) -> Option<(Xy, Xy)> {
    let (from, to) = part(a, b - a, 0.0, 1.0, frame)?;
    // An end inside stays as it is, whatever rounding does to a + (b - a).
    let inside = |p: Xy| frame.contains(&Bounds { min: p, max: p });
    Some((if inside(a) { a } else { from }, if inside(b) { b } else { to }))
}

/// The part of the ray from `p` on inside the frame.
pub(super) fn ray(p: Xy, way: Xy, frame: &Bounds) -> Option<(Xy, Xy)> {
    part(p, way, 0.0, f64::INFINITY, frame)
}

/// The part of the line through `p` inside the frame.
pub(super) fn line(p: Xy, way: Xy, frame: &Bounds) -> Option<(Xy, Xy)> {
    part(p, way, f64::NEG_INFINITY, f64::INFINITY, frame)
}

/// The parts of a polyline inside the frame.
pub(super) fn polyline(points: &[Xy], frame: &Bounds) -> Vec<Vec<Xy>> {
    let mut out: Vec<Vec<Xy>> = Vec::new();
    for w in points.windows(2) {
        let Some((a, b)) = segment(w[0], w[1], frame) else { continue };
        match out.last_mut() {
            Some(run) if run.last() == Some(&a) => run.push(b),
            _ => out.push(vec![a, b]),
        }
    }
    out
}

/// The rings (even-odd) of the wedge that runs counter-clockwise from the ray along `right` to the ray along
/// `left`, inside the frame. `turn` is the side of `right` on which `left` lies.
pub(super) fn wedge(apex: Xy, right: Xy, left: Xy, turn: Ordering, frame: &Bounds) -> Vec<Vec<Xy>> {
    let corners = frame.corners().to_vec();
    let beside = |ring: &[Xy], inward: Xy| cut_by_side(ring, inward, apex.dot(inward));
    match turn {
        Ordering::Greater => vec![beside(&beside(&corners, right.left()), left.left() * -1.0)],
        Ordering::Equal => vec![beside(&corners, right.left())],
        Ordering::Less => {
            let missing = beside(&beside(&corners, left.left()), right.left() * -1.0);
            vec![corners, missing]
        }
    }
}

/// The part of rings on that side of the line through `p` and `q` on which `apex` lies.
pub(super) fn before(rings: &[Vec<Xy>], apex: Xy, p: Xy, q: Xy) -> Vec<Vec<Xy>> {
    let across = (q - p).left();
    let inward = if (apex - p).dot(across) >= 0.0 { across } else { across * -1.0 };
    rings.iter().map(|ring| cut_by_side(ring, inward, p.dot(inward))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::layout::pole::area;

    fn frame() -> Bounds {
        Bounds { min: xy(4.0, 4.0), max: xy(104.1, 84.3) }
    }

    #[test]
    fn rays_and_lines_end_exactly_on_the_frame() {
        let frame = frame();
        let sides = [frame.min.x, frame.max.x].map(f64::to_bits);
        let levels = [frame.min.y, frame.max.y].map(f64::to_bits);
        let on = |p: Xy| sides.contains(&p.x.to_bits()) || levels.contains(&p.y.to_bits());
        for i in 0..97 {
            let p = xy(10.0 + 0.77 * f64::from(i), 20.0 + 0.33 * f64::from(i));
            for way in [xy(1.0, 0.3), xy(-0.7, 1.1), xy(-1e-3, -2.0), xy(3e7, -1e7), xy(0.0, 1.0), xy(-1.0, 0.0)] {
                let (from, to) = ray(p, way, &frame).unwrap();
                assert_eq!(from, p);
                assert!(on(to), "{p:?} {way:?}: {to:?}");
                let (a, b) = line(p, way, &frame).unwrap();
                assert!(on(a) && on(b) && b == to, "{a:?} {b:?}");
            }
        }
        assert_eq!(ray(xy(200.0, 40.0), xy(1.0, 0.0), &frame), None, "it looks away");
        assert!(ray(xy(200.0, 40.0), xy(-1.0, 0.0), &frame).is_some());
        assert_eq!(line(xy(0.0, 0.0), xy(0.0, 1.0), &frame), None);
    }

    #[test]
    fn a_polyline_that_leaves_comes_back_as_a_second_part() {
        let points = [xy(10.0, 10.0), xy(50.0, 10.0), xy(50.0, 200.0), xy(60.0, 200.0), xy(60.0, 10.0)];
        let parts = polyline(&points, &frame());
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[0], [xy(10.0, 10.0), xy(50.0, 10.0), xy(50.0, 84.3)]);
        assert_eq!(parts[1], [xy(60.0, 84.3), xy(60.0, 10.0)]);
    }

    #[test]
    fn a_wedge_and_the_missing_one_make_the_frame() {
        let frame = frame();
        let whole = frame.size().x * frame.size().y;
        for apex in [xy(50.0, 40.0), xy(-30.0, 40.0), xy(50.0, 300.0)] {
            let (right, left) = (xy(1.0, 0.4), xy(0.2, -1.0));
            let narrow = wedge(apex, right, left, Ordering::Greater, &frame);
            let wide = wedge(apex, left, right, Ordering::Less, &frame);
            let cut: f64 = area(&wide[..1]) - area(&wide[1..]);
            assert!((area(&narrow) + cut - whole).abs() < 1e-6, "{apex:?}");
        }
        let half = wedge(xy(50.0, 44.3), xy(1.0, 0.0), xy(-1.0, 0.0), Ordering::Equal, &frame);
        assert!((area(&half) - frame.size().x * 40.3).abs() < 1e-6, "the part above");
    }

    #[test]
    fn an_end_segment_cuts_on_the_far_side() {
        let frame = frame();
        let apex = xy(20.0, 44.0);
        let wedge = wedge(apex, xy(1.0, 0.5), xy(1.0, -0.5), Ordering::Greater, &frame);
        for (p, q) in [(xy(60.0, 0.0), xy(60.0, 80.0)), (xy(60.0, 80.0), xy(60.0, 0.0))] {
            let triangle = before(&wedge, apex, p, q);
            assert!((area(&triangle) - 0.5 * 40.0 * 40.0).abs() < 1e-6);
        }
    }
}
