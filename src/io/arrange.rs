//! From points and segments of a file to a subdivision, with the lines of what does not fit.

use super::Number;
use super::load_error::{LoadError, Whereabouts};
use super::room::for_segments;
use super::soup::SegmentSoup;
use super::words::{at_most, note};
use crate::ids::VertexId;
use crate::plane::{ArrangeOptions, Arranged, MarkHolesError, SegmentFault, SegmentsError, Subdivision};

/// Makes a subdivision of points and segments. Points at the same place are joined, and segments that are there
/// already or have no length left out. With `split`, segments are split where they meet; see
/// [`ArrangeOptions`]. Hole points mark their faces.
///
/// Cost: O(n log n), and O((n + k) log n) a round to split at k intersections.
///
/// # Errors
/// [`LoadError`] with the lines of the segments that do not fit.
pub fn arrange(soup: &SegmentSoup, split: bool) -> Result<Arranged, LoadError> {
    arrange_with(soup, &ArrangeOptions { split, ..ArrangeOptions::default() })
}

/// The same with all options; points are joined and segments left out in any case.
///
/// # Errors
/// [`LoadError`] with the lines of the segments that do not fit.
pub fn arrange_with(soup: &SegmentSoup, options: &ArrangeOptions) -> Result<Arranged, LoadError> {
    for_segments(soup.segments.len(), &soup.source)?;
    let options = ArrangeOptions { merge: true, ..*options };
    let mut arranged = Subdivision::arrange_graph(&soup.points, &soup.segments, &options)
        .map_err(|error| LoadError::Segments { at: Box::new(whereabouts(soup, &error)), error })?;
    arranged.subdivision.mark_holes(&soup.hole_points).map_err(|error| {
        let (MarkHolesError::Coordinate { index, .. }
        | MarkHolesError::NotInside { index, .. }
        | MarkHolesError::Outside { index, .. }) = error;
        LoadError::Holes { place: soup.at_line(soup.hole_lines.get(index as usize)), error }
    })?;
    Ok(arranged)
}

/// Where the segments and points of the first fault stand.
fn whereabouts(soup: &SegmentSoup, error: &SegmentsError) -> Whereabouts {
    let (segments, points) = match error {
        SegmentsError::Faults { faults, .. } => {
            faults.first().map_or_else(Default::default, |fault| (fault.segments(), fault.points()))
        }
        SegmentsError::Coordinate { point, .. } => (Vec::new(), vec![*point]),
        SegmentsError::NoSuchPoint { segment, .. } => (vec![*segment], Vec::new()),
        SegmentsError::Grid { .. } | SegmentsError::TooMany(_) => (Vec::new(), Vec::new()),
    };
    let segments = segments.into_iter().map(|i| (format!("segment {i}"), soup.place(i as usize)));
    let points = points.into_iter().map(|i| (format!("point {i}"), soup.point_place(i as usize)));
    Whereabouts::of(&soup.source, points.chain(segments))
}

/// The place of a fault, and the fault: `roads.wkt:3: segments 2 and 7 cross at (1, 1)`.
pub fn faults_with_places<'a>(soup: &'a SegmentSoup, faults: &'a [SegmentFault]) -> impl Iterator<Item = String> + 'a {
    faults.iter().map(|fault| {
        let segment = fault.segments().first().map(|&i| soup.place(i as usize));
        let place = segment.or_else(|| fault.points().first().map(|&i| soup.point_place(i as usize)));
        let rest: String = fault.segments().iter().skip(1).map(|&i| side_of(soup, i)).collect();
        format!("{}: {fault}{rest}", place.unwrap_or_else(|| soup.source.clone()))
    })
}

/// ` (segment 7 of states[3] "Ohio" polygon 0 ring 1)`, where the format tells of what segments are sides.
fn side_of(soup: &SegmentSoup, segment: u32) -> String {
    let path = soup.path(segment as usize);
    if path.is_empty() { String::new() } else { format!(" (segment {segment} of {path})") }
}

/// Whether nothing was split and nothing moved. Segments that are there already, or have no length, are left out whether or
/// not others are split.
#[must_use]
pub fn is_as_given(arranged: &Arranged) -> bool {
    let Arranged { crossings, moved, displaced, collapsed, .. } = arranged;
    let none_moved = moved.is_empty() && displaced.is_empty() && collapsed.is_empty();
    crossings.is_empty() && none_moved && arranged.split_segments().next().is_none()
}

/// What was merged, split and moved, one sentence each.
#[must_use]
pub fn describe(arranged: &Arranged) -> Vec<String> {
    let mut notes = Vec::new();
    let mut add = |count: usize, one: &str, many: &str, rest: &str| note(&mut notes, count, one, many, rest);
    let zero = arranged.zero_length.len();
    add(zero, "segment without length was left out", "segments without length were left out", "");
    let repeated = arranged.repeated.len();
    let (one, many) = ("segment repeats an earlier one and was", "segments repeat earlier ones and were");
    add(repeated, one, many, " left out");
    let crossings = arranged.crossings.len();
    add(crossings, "vertex was made where segments cross", "vertices were made where segments cross", "");
    let split = arranged.split_segments().count();
    add(split, "segment was split where it meets others", "segments were split where they meet others", "");
    let furthest = arranged.moved.iter().map(|moved| moved.1).fold(0.0, f64::max);
    let by = format!(" moved by rounding, none further than {}", at_most(furthest));
    add(arranged.moved.len(), "crossing was", "crossings were", &by);
    if let Some(grid) = arranged.grid {
        notes.push(on_grid(grid, arranged.displaced_points, &arranged.displaced, arranged.farthest));
    }
    match arranged.collapsed[..] {
        [] => {}
        [one] => notes.push(format!("segment {one} is shorter than a step of the grid and became a point")),
        [ref first @ .., last] => {
            let count = arranged.collapsed.len();
            let shown: Vec<String> = first.iter().take(SHOWN).map(u32::to_string).collect();
            let rest = if count > SHOWN + 1 { format!(" and {} more", count - SHOWN) } else { format!(" and {last}") };
            let shown = shown.join(", ") + &rest;
            notes.push(format!("{count} segments are shorter than a step of the grid and became points: {shown}"));
        }
    }
    if let Some((edge, [one, other])) = arranged.grid.and_then(|_| arranged.first_shared_edge()) {
        notes.push(format!("segments lie on each other on the grid, the first of them {one} and {other} along {edge}"));
    }
    notes
}

/// So many segments are named in a row; more are counted.
const SHOWN: usize = 3;

/// What a grid did to the points of the input, in one sentence: how many moved, the vertices that they became, and how far
/// an edge is from what it was.
#[must_use]
pub fn on_grid(grid: f64, moved: usize, displaced: &[(VertexId, f64)], farthest: f64) -> String {
    let (grid, most) = (Number(grid), displaced.iter().map(|moved| moved.1).fold(0.0, f64::max));
    if moved == 0 && farthest <= 0.0 {
        return format!("points were rounded to a grid of {grid}: nothing moved");
    }
    let points = match moved {
        0 => "no point of the input moved".to_owned(),
        1 => format!("1 point of the input moved, by {}", at_most(most)),
        more => format!("{more} points of the input moved, none further than {}", at_most(most)),
    };
    format!("points were rounded to a grid of {grid}: {points}, and no edge further than {}", at_most(farthest))
}
