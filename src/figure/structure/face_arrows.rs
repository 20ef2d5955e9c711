//! Arrows between a face and its half-edges: dashed, from its label or to it.
//!
//! ```text
//!   ┌───────────────┐
//!   │      f1       │     straight, between the label and the shaft, if nothing is in the way;
//!   │       ╎       │     along the free band of the frame, if the face is the outer one;
//!   │       ▾       │     else a tag: the name once more, small, beside the shaft
//!   └─══════════════┘
//! ```

use crate::figure::canvas::text;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::{Crowd, INK, Shape};
use crate::figure::structure::arrows::Arrow;
use crate::figure::structure::captions::Label;
use crate::figure::structure::half_edges::Shaft;
use crate::ids::FaceId;

/// Free space between a label and its arrow.
const AIR: f64 = 4.0;
/// Distance of a head from the line of the shaft.
const TOUCH: f64 = 2.4;
/// Free space on both sides of an arrow.
const CLEAR: f64 = 1.2;
/// An arrow shorter than this is not worth drawing.
const SHORTEST: f64 = 9.0;
/// An arrow to a face further away than this becomes a tag.
const LONGEST: f64 = 170.0;
/// Length of the arrow beside a tag.
const STUB: f64 = 15.0;
/// Size of the name on a tag.
const TAG: f64 = 9.0;
/// The band of the frame in which an arrow of the outer face may go.
const BAND: f64 = 24.0;

/// An arrow, perhaps with a name of its own.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Tagged {
    pub(crate) arrow: Arrow,
    pub(crate) tag: Option<Label>,
}

impl Tagged {
    pub(crate) const fn plain(arrow: Arrow) -> Self {
        Self { arrow, tag: None }
    }
}

/// From the label of a face to its half-edge. `outer` is the size of the canvas if the face is the outer one.
pub(crate) fn boundary(
    face: FaceId,
    label: Option<&Label>,
    shaft: &Shaft,
    outer: Option<Xy>,
    crowd: &mut Crowd,
) -> Option<Tagged> {
    let places = [0.5, 0.62, 0.38, 0.74, 0.26, 0.82, 0.18];
    let straight = label.and_then(|label| {
        let mut ways = square(label, shaft).into_iter().chain(places).filter_map(|t| straight(label, touch(shaft, t)?));
        ways.find(|way| is_free(crowd, way))
    });
    let way = straight.or_else(|| {
        let (label, size) = (label?, outer?);
        let ways = places.iter().flat_map(|&t| round_the_frame(label, shaft, t, size));
        ways.filter(|way| is_free(crowd, way)).min_by(|a, b| way_length(a).total_cmp(&way_length(b)))
    });
    if let Some(way) = way {
        add(crowd, &way);
        return Arrow::through(&way).map(Tagged::plain);
    }
    tagged(face, shaft, &places, true, crowd)
}

/// From a half-edge to the label of its face.
pub(crate) fn face(face: FaceId, label: Option<&Label>, shaft: &Shaft, crowd: &mut Crowd) -> Option<Tagged> {
    let places = [0.64, 0.5, 0.36, 0.76, 0.24, 0.82, 0.18];
    let way = label.and_then(|label| {
        let ways = square(label, shaft).into_iter().chain(places).filter_map(|t| straight(label, touch(shaft, t)?));
        ways.filter(|way| way_length(way) <= LONGEST).find(|way| is_free(crowd, way))
    });
    if let Some(mut way) = way {
        add(crowd, &way);
        way.reverse();
        return Arrow::through(&way).map(Tagged::plain);
    }
    tagged(face, shaft, &places, false, crowd)
}

/// Where the arrow is square to the shaft, if that is on its middle part.
fn square(label: &Label, shaft: &Shaft) -> Option<f64> {
    let t = (label.at - shaft.middle).dot(shaft.along) / shaft.edge_length + 0.5;
    (0.2..=0.8).contains(&t).then_some(t)
}

/// Just beside the shaft at `t` of the edge, if the shaft reaches so far.
fn touch(shaft: &Shaft, t: f64) -> Option<Xy> {
    let along = (shaft.at(t) - shaft.tail).dot(shaft.along);
    (1.0..=shaft.length() - 1.0).contains(&along).then(|| shaft.at(t) + shaft.along.left() * TOUCH)
}

/// From the edge of the label's box to `to`.
fn straight(label: &Label, to: Xy) -> Option<Vec<Xy>> {
    let bounds = label.bounds().grown(AIR);
    let way = to - label.at;
    let half = bounds.size() * 0.5;
    let leave = (half.x / way.x.abs()).min(half.y / way.y.abs());
    let from = label.at + way * leave;
    (leave < 1.0 && (to - from).length() >= SHORTEST).then(|| vec![from, to])
}

/// Out of the label in the top right corner, along the band, straight down onto the shaft; both ways round.
fn round_the_frame(label: &Label, shaft: &Shaft, t: f64, size: Xy) -> Vec<Vec<Xy>> {
    let Some(from) = touch(shaft, t) else { return Vec::new() };
    let aside = shaft.along.left();
    let frame = Bounds { min: xy(BAND, BAND), max: size - xy(BAND, BAND) };
    let reach = |at: f64, step: f64, low: f64, high: f64| match step {
        s if s > 1e-6 => (high - at) / s,
        s if s < -1e-6 => (low - at) / s,
        _ => f64::INFINITY,
    };
    let across = reach(from.x, aside.x, frame.min.x, frame.max.x);
    let down = reach(from.y, aside.y, frame.min.y, frame.max.y);
    let foot = from + aside * across.min(down);
    let own = label.bounds().grown(AIR);
    let (left, below) = (xy(own.min.x, frame.min.y), xy(frame.max.x, own.max.y));
    let [top_left, bottom_right] = [frame.min, frame.max];
    let bottom_left = xy(frame.min.x, frame.max.y);
    let (by_left, by_right): (&[Xy], &[Xy]) = match (across < down, aside.x < 0.0, aside.y < 0.0) {
        (true, true, _) => (&[top_left], &[bottom_right, bottom_left]),
        (true, false, _) => (&[top_left, bottom_left, bottom_right], &[]),
        (false, _, true) => (&[], &[bottom_right, bottom_left, top_left]),
        (false, _, false) => (&[top_left, bottom_left], &[bottom_right]),
    };
    let way = |start: Xy, bends: &[Xy]| [&[start], bends, &[foot, from]].concat();
    vec![way(left, by_left), way(below, by_right)]
}

/// A short arrow on the face side of the shaft and the name of the face at its other end.
fn tagged(face: FaceId, shaft: &Shaft, places: &[f64], inward: bool, crowd: &mut Crowd) -> Option<Tagged> {
    let (name, aside) = (face.to_string(), shaft.along.left());
    let half = xy(0.5 * text::width(&name, TAG, true), text::half_height(TAG));
    let tag_at = |p: Xy| p + aside * (STUB + 1.5 + half.x * aside.x.abs() + half.y * aside.y.abs());
    let fits = |p: &Xy| {
        let p = *p;
        let bounds = Bounds::around(tag_at(p), half.x, half.y);
        is_free(crowd, &[p + aside * STUB, p]) && crowd.blocker(&bounds.grown(1.0)).is_none()
    };
    let p = places.iter().filter_map(|&t| touch(shaft, t)).find(fits)?;
    let tag = Label { at: tag_at(p), size: TAG, lines: vec![name] };
    let (near, far) = (p, p + aside * STUB);
    let way = if inward { [far, near] } else { [near, far] };
    add(crowd, &way);
    crowd.add(Shape::Box(tag.bounds()), u32::MAX);
    Some(Tagged { arrow: Arrow::through(&way)?, tag: Some(tag) })
}

fn way_length(way: &[Xy]) -> f64 {
    way.windows(2).map(|step| (step[1] - step[0]).length()).sum()
}

fn add(crowd: &mut Crowd, way: &[Xy]) {
    crowd.add_all(way.windows(2).map(|step| Shape::Segment(step[0], step[1], 1.0)), u32::MAX);
}

/// Whether the way keeps clear of everything in this drawing.
fn is_free(crowd: &Crowd, way: &[Xy]) -> bool {
    way.windows(2).all(|step| {
        let (from, along) = (step[0], step[1] - step[0]);
        let count = (along.length() / 2.0) as usize + 1;
        (0..=count).all(|i| {
            let p = from + along * (i as f64 / count as f64);
            crowd.nearest(p, CLEAR, |tag| tag != INK) >= CLEAR
        })
    })
}
