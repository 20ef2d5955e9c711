//! Where words stand: near what they belong to, on nothing.
//!
//! ```text
//!      start            A label is tried close by on all sides, then further and further away. One that had to
//!     ▲                 go far is tied to its thing by a thin line.
//!           ╲ portal
//! ```

use crate::figure::canvas::scene::Node;
use crate::figure::canvas::text;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::structure::captions::Label;

/// Distances from the thing.
const GAPS: [f64; 9] = [2.5, 5.0, 8.0, 12.0, 17.0, 23.0, 30.0, 38.0, 48.0];
/// From this distance on there is a tie.
const TIED: f64 = 11.0;
/// Labels longer than this are cut short.
const LONGEST: usize = 48;
/// Upper right first, as in the books.
const COMPASS: [(f64, f64); 12] = [
    (0.8, -0.6),
    (1.0, 0.0),
    (-0.8, -0.6),
    (-1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.8, 0.6),
    (-0.8, 0.6),
    (0.4, -0.9165),
    (-0.4, -0.9165),
    (0.4, 0.9165),
    (-0.4, 0.9165),
];

/// A point beside which words may stand.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Anchor {
    pub(super) at: Xy,
    /// How far its own ink reaches.
    pub(super) clear: f64,
    /// In which directions; none: on the point itself.
    pub(super) ways: Vec<Xy>,
    /// Whether it is a point, past which words may run, and not a line.
    pub(super) is_point: bool,
}

impl Anchor {
    pub(super) fn centred(at: Xy) -> Self {
        Self { at, clear: 0.0, ways: Vec::new(), is_point: true }
    }

    pub(super) fn round(at: Xy, clear: f64) -> Self {
        Self { at, clear, ways: COMPASS.map(|(x, y)| xy(x, y)).to_vec(), is_point: true }
    }

    pub(super) fn beside(at: Xy, clear: f64, ways: Vec<Xy>) -> Self {
        Self { at, clear, ways, is_point: false }
    }

    /// The middle of a box of this half size in a direction.
    fn middle(&self, way: Xy, gap: f64, half: Xy) -> Xy {
        if self.is_point {
            // A corner of the box, or a side if the direction is nearly that of an axis.
            let shift = |along: f64, half: f64| half * (1.6 * along).clamp(-1.0, 1.0);
            return self.at + way * (self.clear + gap) + xy(shift(way.x, half.x), shift(way.y, half.y));
        }
        // As far from the line as the support function of the box says.
        self.at + way * (self.clear + gap + half.x * way.x.abs() + half.y * way.y.abs())
    }
}

/// Where something has found room.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Place {
    pub(super) at: Xy,
    pub(super) tie: Option<(Xy, Xy)>,
}

/// The first free place for a box of this half size, which the crowd then knows.
pub(super) fn find(anchors: &[Anchor], half: Xy, frame: &Bounds, crowd: &mut Crowd) -> Option<Place> {
    let room = frame.grown(-1.0);
    let centred =
        anchors.iter().filter(|anchor| anchor.ways.is_empty()).map(|anchor| Place { at: anchor.at, tie: None });
    let around = GAPS.iter().flat_map(|&gap| {
        let places = move |anchor: &Anchor| {
            let (from, clear) = (anchor.at, anchor.clear);
            let place = move |&way: &Xy| {
                let at = anchor.middle(way, gap, half);
                let near = xy(from.x.clamp(at.x - half.x, at.x + half.x), from.y.clamp(at.y - half.y, at.y + half.y));
                let tie = (gap >= TIED).then(|| (from + (near - from).unit().unwrap_or(way) * clear, near));
                Place { at, tie }
            };
            anchor.ways.iter().map(place).collect::<Vec<_>>()
        };
        anchors.iter().flat_map(places).collect::<Vec<_>>()
    });
    let is_free = |place: &Place| {
        crowd.has_room(place.at, half, &room, 1.5)
            && place.tie.is_none_or(|(from, to)| crowd.crossings(from, to).is_some())
    };
    let place = centred.chain(around).find(is_free)?;
    crowd.add(Shape::Box(Bounds::around(place.at, half.x, half.y)), 0);
    crowd.add_all(place.tie.map(|(from, to)| Shape::Segment(from, to, 0.5)), 0);
    Some(place)
}

/// A label in one line, if there is room.
pub(super) fn label(
    words: &str,
    size: f64,
    anchors: &[Anchor],
    frame: &Bounds,
    crowd: &mut Crowd,
) -> Option<Vec<Node>> {
    let words = text::shortened(words, LONGEST);
    let half = xy(0.5 * text::width(&words, size, false), text::half_height(size));
    let place = find(anchors, half, frame, crowd)?;
    let mut nodes: Vec<Node> = place.tie.map(|(from, to)| Node::Line { class: "tie", from, to }).into_iter().collect();
    nodes.extend(Label { at: place.at, size, lines: vec![words] }.nodes("tx"));
    Some(nodes)
}

/// The radius of a badge.
const BADGE: f64 = 9.0;

/// A numbered disc, if there is room.
pub(super) fn badge(number: usize, anchors: &[Anchor], frame: &Bounds, crowd: &mut Crowd) -> Option<Vec<Node>> {
    let place = find(anchors, xy(BADGE + 0.5, BADGE + 0.5), frame, crowd)?;
    let mut nodes: Vec<Node> = place.tie.map(|(from, to)| Node::Line { class: "tie", from, to }).into_iter().collect();
    nodes.extend(badge_at(number, place.at));
    Some(nodes)
}

/// The disc and its number.
pub(super) fn badge_at(number: usize, at: Xy) -> [Node; 2] {
    let text = number.to_string();
    let size = [11.0, 10.0, 7.5][(text.len() - 1).min(2)];
    [Node::Disc { class: "gl", centre: at, radius: BADGE }, Node::Text { class: "bn", at, size, text }]
}
