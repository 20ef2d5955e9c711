//! The sweep that finds where segments cross: the line, the event, the segments it cuts.

use super::{numbered, shown};
use crate::figure::SketchFilm;
use crate::figure::sketch::{Role, Sketch};
use crate::plane::{Point, SegmentsError, SweepEvent, sweep_segments_observed};
use crate::topology::Observer;

/// Of so many segments at most the names are drawn.
const MOST_NAMES: usize = 40;

/// The film of the sweep over segments: a frame for each event point, at most `most` of them.
///
/// Cost: that of the sweep, the segments in each frame, and those that the line cuts at each event: n² in all if n segments
/// lie over each other. Memory: the segments in each frame.
///
/// # Errors
/// [`SegmentsError`]: what is no number, or out of range, or too much.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::plane::Point;
/// let segment = |x0, y0, x1, y1| [Point::new(x0, y0), Point::new(x1, y1)];
/// let film = algorithms::segment_sweep(&[segment(0., 0., 4., 2.), segment(0., 2., 4., 0.)], 40)?;
/// assert_eq!(film.len(), 5 + 2);
/// assert!(film.captions().any(|(heading, _)| heading.contains("s0 and s1 cross")));
/// # Ok::<(), dcel_kit::plane::SegmentsError>(())
/// ```
pub fn segment_sweep(segments: &[[Point; 2]], most: usize) -> Result<SketchFilm, SegmentsError> {
    let mut count = Count(0);
    sweep_segments_observed(segments, &mut count)?;
    let frames = shown(count.0, most);
    let mut kept = Kept { shown: &frames, events: Vec::with_capacity(count.0) };
    sweep_segments_observed(segments, &mut kept)?;
    let events = kept.events;
    let mut film = SketchFilm::new();
    let text = "a line sweeps from left to right; only neighbours on it can cross next";
    film.frame(&format!("{} segments", segments.len()), text, given(segments, None));
    let mut found: Vec<Point> = Vec::new();
    let mut next = 0;
    for (i, number) in numbered(count.0, most) {
        for event in &events[next..=i] {
            found.extend(meets(event).then_some(event.at));
        }
        next = i + 1;
        let event = &events[i];
        let mut places = vec![Place::Ahead; segments.len()];
        events[..=i].iter().flat_map(|event| &event.ending).for_each(|&s| places[s as usize] = Place::Behind);
        event.status.iter().for_each(|&s| places[s as usize] = Place::Cut);
        let mut sketch = given(segments, Some(&places));
        for &p in &event.expected {
            sketch.point(Role::Goal, p).key("crossing that is known and waits");
        }
        for &p in found.iter().filter(|&&p| p != event.at) {
            sketch.point(Role::Right, p).key("place where segments meet");
        }
        sketch.line(Role::Event, event.at, Point::new(event.at.x, event.at.y + 1.0)).key("the sweep line");
        sketch.point(Role::Event, event.at).key("the event point");
        film.frame(&format!("Event {number}: {}", what(event)), &status(event), sketch);
    }
    let mut end = given(segments, None);
    for &p in &found {
        end.point(Role::Right, p).key("place where segments meet");
    }
    let text = match found.len() {
        0 => "no two of them meet".to_owned(),
        1 => "they meet at one place".to_owned(),
        count => format!("they meet at {count} places"),
    };
    film.frame(&format!("{} event points", events.len()), &text, end);
    Ok(film)
}

/// Whether segments meet there otherwise than end to end.
fn meets(event: &SweepEvent) -> bool {
    !event.through.is_empty()
}

/// Counts events; none is made.
struct Count(usize);

impl Observer<SweepEvent> for Count {
    fn observe(&mut self, _: impl FnOnce() -> SweepEvent) {
        self.0 += 1;
    }
}

/// Keeps all events, but what the line cuts only of those that are shown: all of it would be quadratic.
struct Kept<'a> {
    /// The numbers of the events that are shown, in increasing order.
    shown: &'a [usize],
    events: Vec<SweepEvent>,
}

impl Observer<SweepEvent> for Kept<'_> {
    fn observe(&mut self, event: impl FnOnce() -> SweepEvent) {
        let mut event = event();
        if self.shown.binary_search(&self.events.len()).is_err() {
            (event.status, event.expected) = (Vec::new(), Vec::new());
        }
        self.events.push(event);
    }
}

/// Where a segment lies, seen from the sweep line.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    Ahead,
    Cut,
    Behind,
}

/// All segments: those that are done in grey, those that the line cuts in blue.
fn given(segments: &[[Point; 2]], places: Option<&[Place]>) -> Sketch {
    let mut sketch = Sketch::new();
    let is_plain = places.is_none_or(|places| places.iter().all(|place| *place == Place::Ahead));
    for (number, ends) in segments.iter().enumerate() {
        let (role, key) = match places.map_or(Place::Ahead, |places| places[number]) {
            Place::Ahead => (Role::Plain, "segment ahead of it"),
            Place::Cut => (Role::Main, "segment that the sweep line cuts"),
            Place::Behind => (Role::Dimmed, "segment behind the line"),
        };
        let path = sketch.path(role, *ends).title(format!("segment {number}"));
        if !is_plain {
            path.key(key);
        }
        if segments.len() <= MOST_NAMES {
            path.label(format!("s{number}"));
        }
    }
    sketch
}

fn names(list: &[u32]) -> String {
    let names: Vec<String> = list.iter().map(|number| format!("s{number}")).collect();
    match &names[..] {
        [] => "nothing".to_owned(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

fn what(SweepEvent { ending, through, starting, .. }: &SweepEvent) -> String {
    let mut parts = Vec::new();
    if through.len() > 1 {
        parts.push(format!("{} cross", names(through)));
    } else if let [one] = through[..] {
        parts.push(format!("s{one} passes through"));
    }
    let verb = |list: &[u32], one: &'static str, many: &'static str| if list.len() == 1 { one } else { many };
    if !ending.is_empty() {
        parts.push(format!("{} {}", names(ending), verb(ending, "ends", "end")));
    }
    if !starting.is_empty() {
        parts.push(format!("{} {}", names(starting), verb(starting, "starts", "start")));
    }
    if parts.is_empty() { "a point".to_owned() } else { parts.join(", ") }
}

fn status(event: &SweepEvent) -> String {
    match event.status.len() {
        0 => "the line cuts nothing".to_owned(),
        count if count > 12 => format!("the line cuts {count} segments"),
        _ => format!("from bottom to top the line cuts {}", names(&event.status)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_line_cuts_is_kept_of_the_frames_alone() {
        // Lines over each other, which end one after the other: the line cuts half of them at most events.
        let line = |i: u32| [Point::new(f64::from(i), f64::from(i)), Point::new(f64::from(1000 + i), f64::from(i))];
        let segments: Vec<[Point; 2]> = (0..300).map(line).collect();
        let (mut all, frames) = (Vec::new(), shown(600, 5));
        sweep_segments_observed(&segments, &mut all).expect("numbers");
        let mut kept = Kept { shown: &frames, events: Vec::new() };
        sweep_segments_observed(&segments, &mut kept).expect("numbers");
        assert_eq!((all.len(), kept.events.len()), (600, 600));
        for (i, (event, kept)) in all.iter().zip(&kept.events).enumerate() {
            let is_shown = frames.contains(&i);
            assert_eq!(kept.status, if is_shown { event.status.as_slice() } else { &[] }, "event {i}");
            assert_eq!((kept.at, &kept.ending, &kept.starting), (event.at, &event.ending, &event.starting));
        }
        assert_eq!(segment_sweep(&segments, 5).expect("numbers").len(), 5 + 2);
    }
}
