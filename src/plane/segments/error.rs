//! Why segments are no plane graph.

use crate::plane::{CoordinateError, Point};
use crate::topology::TooMany;

/// One thing that is wrong with segments. Segments and points are numbered from 0 in the order of the input.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SegmentFault {
    /// A segment whose ends are the same point.
    #[error("segment {segment} has no length: both its ends are {at}")]
    ZeroLength {
        /// The segment.
        segment: u32,
        /// Its only point.
        at: Point,
    },
    /// A segment with the same ends as an earlier one, in either direction.
    #[error("segment {second} repeats segment {first}")]
    Repeated {
        /// The earlier segment.
        first: u32,
        /// The later segment.
        second: u32,
    },
    /// Two points of a graph at the same place.
    #[error("points {first} and {second} lie at the same place {at}")]
    SamePlace {
        /// The earlier point.
        first: u32,
        /// The later point.
        second: u32,
        /// Where.
        at: Point,
    },
    /// Two segments that cross in a point interior to both.
    #[error("segments {first} and {second} cross at {at}")]
    Crossing {
        /// One segment.
        first: u32,
        /// The other segment.
        second: u32,
        /// The crossing, rounded to doubles.
        at: Point,
    },
    /// An end of a segment in the interior of another segment.
    #[error("segment {segment} ends at {at} in the interior of segment {on}")]
    Touching {
        /// The segment that ends there.
        segment: u32,
        /// Its end.
        at: Point,
        /// The segment that runs on.
        on: u32,
    },
    /// A point without segments in the interior of a segment.
    #[error("point {point}, {at}, lies in the interior of segment {on}")]
    PointOnSegment {
        /// The point.
        point: u32,
        /// Where.
        at: Point,
        /// The segment.
        on: u32,
    },
    /// Two segments on one line that share more than a point.
    #[error("segments {first} and {second} overlap from {from} to {to}")]
    Overlapping {
        /// One segment.
        first: u32,
        /// The other segment.
        second: u32,
        /// Where the common part starts.
        from: Point,
        /// Where it ends.
        to: Point,
    },
}

impl SegmentFault {
    /// The segments the message speaks of.
    #[must_use]
    pub fn segments(&self) -> Vec<u32> {
        match *self {
            Self::ZeroLength { segment, .. } => vec![segment],
            Self::Repeated { first, second }
            | Self::Crossing { first, second, .. }
            | Self::Overlapping { first, second, .. } => vec![first, second],
            Self::Touching { segment, on, .. } => vec![segment, on],
            Self::PointOnSegment { on, .. } => vec![on],
            Self::SamePlace { .. } => Vec::new(),
        }
    }

    /// The points the message speaks of by number.
    #[must_use]
    pub fn points(&self) -> Vec<u32> {
        match *self {
            Self::SamePlace { first, second, .. } => vec![first, second],
            Self::PointOnSegment { point, .. } => vec![point],
            _ => Vec::new(),
        }
    }
}

/// Why no subdivision can be made of segments.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SegmentsError {
    /// A point whose coordinates cannot be used. The ends of segment i are the points 2i and 2i + 1 if no points are
    /// given.
    #[error("point {point}: {error}")]
    Coordinate {
        /// The point.
        point: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// A segment that refers to a point that is not there.
    #[error("segment {segment} leads to point {point}, but there {}", if *.points == 1 { "is 1 point".to_owned() } else { format!("are {points} points") })]
    NoSuchPoint {
        /// The segment.
        segment: u32,
        /// The number it gives.
        point: u32,
        /// How many points there are.
        points: usize,
    },
    /// The segments meet in other places than at common ends.
    #[error("{}{}", faults.first().map_or_else(String::new, ToString::to_string), others(faults.len(), *more))]
    Faults {
        /// What is wrong, from left to right; at least one.
        faults: Vec<SegmentFault>,
        /// Whether the search ended at the limit of the options.
        more: bool,
    },
    /// A grid that points cannot be rounded to.
    #[error(
        "the grid {size} cannot be used: give a number from {finest:e}, the finest that doubles reach here, to 2^201"
    )]
    Grid {
        /// The grid asked for.
        size: f64,
        /// The finest one for these points.
        finest: f64,
    },
    /// More elements than ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

fn others(count: usize, more: bool) -> String {
    match (count, more) {
        (_, true) => format!(" (the first of more than {count} faults)"),
        (0 | 1, false) => String::new(),
        (_, false) => format!(" (the first of {count} faults)"),
    }
}
