//! Viewports: how a `viewBox` is fitted into the room it has.
//!
//! ```text
//!   viewBox 0 0 100 50 in 300 x 300:   meet  ┌──────┐  the box whole, in the middle      none  stretched
//!                                            │▒▒▒▒▒▒│                                    slice cut off
//!                                            └──────┘
//! ```

use super::numbers::list;
use super::transform::Transform;

/// So much may two scales differ because sides were rounded.
const ROUNDED: f64 = 0.004;

/// Left, top, width, height.
pub(super) type Room = [f64; 4];

/// The value of a `viewBox`; boxes without width or height are none.
pub(super) fn view_box(text: &str) -> Option<Room> {
    match list(text)?[..] {
        [x, y, width, height] if width > 0.0 && height > 0.0 => Some([x, y, width, height]),
        _ => None,
    }
}

/// Whether the value of a `viewBox` is a box without width or height, in which nothing is shown.
pub(super) fn is_empty(text: &str) -> bool {
    matches!(list(text).as_deref(), Some(&[_, _, width, height]) if width == 0.0 || height == 0.0)
}

/// Whether a value of `preserveAspectRatio` lets both sides have a scale of their own.
pub(super) fn stretches(ratio: &str) -> bool {
    ratio.split_whitespace().find(|word| *word != "defer") == Some("none")
}

/// How a box is stretched when it is fitted into a room of this size: x keeps its scale. Differences that come from
/// rounded sides are none.
pub(super) fn stretch(inside: Room, [width, height]: [f64; 2], ratio: &str) -> Transform {
    let factor = (height / inside[3]) / (width / inside[2]);
    let is_stretched = stretches(ratio) && factor.is_finite() && factor > 0.0 && (factor - 1.0).abs() > ROUNDED;
    if is_stretched { Transform::scale(1.0, factor) } else { Transform::IDENTITY }
}

/// The map from the coordinates of a box to those of the room it is fitted into; `ratio` is the value of
/// `preserveAspectRatio`.
pub(super) fn fitted(inside: Room, room: Room, ratio: &str) -> Transform {
    let mut words = ratio.split_whitespace().filter(|word| *word != "defer");
    let align = words.next().unwrap_or("xMidYMid");
    let [x, y] = [room[2] / inside[2], room[3] / inside[3]];
    let scale = match words.next() {
        _ if align == "none" => [x, y],
        Some("slice") => [x.max(y); 2],
        _ => [x.min(y); 2],
    };
    // What is left over, and the part of it that comes before.
    let part = |word: &str| match word {
        "Min" | "min" => 0.0,
        "Max" | "max" => 1.0,
        _ => 0.5,
    };
    let parts = [align.get(1..4).map_or(0.5, part), align.get(5..8).map_or(0.5, part)];
    let at = |i: usize| {
        let left_over = room[2 + i] - scale[i] * inside[2 + i];
        let part = if align == "none" { 0.0 } else { parts[i] };
        room[i] + part * left_over - scale[i] * inside[i]
    };
    Transform::translate(at(0), at(1)).after(&Transform::scale(scale[0], scale[1]))
}

/// What of the coordinates of a box is shown when it is fitted into a room of this size.
pub(super) fn shown(inside: Room, size: Option<[f64; 2]>, ratio: &str) -> Room {
    let Some([width, height]) = size else { return inside };
    if !(width > 0.0 && height > 0.0) {
        return inside;
    }
    let map = fitted(inside, [0.0, 0.0, width, height], ratio);
    let [a, b] = [map.apply([0.0, 0.0]), map.apply([1.0, 1.0])];
    let scale = [b[0] - a[0], b[1] - a[1]];
    [-a[0] / scale[0], -a[1] / scale[1], width / scale[0], height / scale[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_is_fitted_as_browsers_do() {
        let inside = view_box("10 20 100,50").unwrap();
        let room = [0.0, 0.0, 300.0, 300.0];
        for (ratio, corner, far) in [
            ("", [0, 75], [300, 225]),
            ("xMinYMin meet", [0, 0], [300, 150]),
            ("xMidYMax", [0, 150], [300, 300]),
            ("none", [0, 0], [300, 300]),
            ("xMidYMid slice", [-150, 0], [450, 300]),
        ] {
            let map = fitted(inside, room, ratio);
            assert_eq!(map.apply([10.0, 20.0]).map(|x| x.round() as i32), corner, "{ratio}");
            assert_eq!(map.apply([110.0, 70.0]).map(|x| x.round() as i32), far, "{ratio}");
        }
        assert_eq!(view_box("0 0 0 5"), None);
    }

    #[test]
    #[allow(clippy::float_cmp)] // exact equality is meant
    fn round_a_box_that_is_fitted_more_is_shown() {
        assert_eq!(shown([0.0, 0.0, 100.0, 50.0], Some([100.0, 100.0]), ""), [0.0, -25.0, 100.0, 100.0]);
        assert_eq!(shown([5.0, 5.0, 1.0, 1.0], None, ""), [5.0, 5.0, 1.0, 1.0]);
        assert_eq!(shown([0.0, 0.0, 100.0, 50.0], Some([100.0, 100.0]), "xMinYMin slice"), [0.0, 0.0, 50.0, 50.0]);
    }
}
