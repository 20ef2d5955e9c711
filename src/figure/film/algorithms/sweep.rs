//! The sweep that finds where segments cross: the line, the event, the segments it cuts.

use super::{number, shown};
use crate::figure::SketchFilm;
use crate::figure::sketch::{Role, Sketch};
use crate::plane::{Point, SegmentsError, SweepEvent, sweep_segments_observed};
use std::collections::BTreeSet;

/// Of so many segments at most the names are drawn.
const MOST_NAMES: usize = 40;

/// The film of the sweep over segments: a frame for each event point, at most `most` of them.
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
    let mut events = Vec::new();
    sweep_segments_observed(segments, &mut events)?;
    let mut film = SketchFilm::new();
    let text = "a line sweeps from left to right; only neighbours on it can cross next";
    film.frame(&format!("{} segments", segments.len()), text, given(segments, &BTreeSet::new(), &[]));
    let mut found: Vec<Point> = Vec::new();
    let (mut next, mut before) = (0, None);
    for i in shown(events.len(), most) {
        for event in &events[next..=i] {
            found.extend(meets(event).then_some(event.at));
        }
        next = i + 1;
        let number = number(i, before, events.len());
        before = Some(i);
        let event = &events[i];
        let done: BTreeSet<u32> = events[..=i].iter().flat_map(|event| event.ending.iter().copied()).collect();
        let mut sketch = given(segments, &done, &event.status);
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
    let mut end = given(segments, &BTreeSet::new(), &[]);
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

/// All segments: those that are done in grey, those that the line cuts in blue.
fn given(segments: &[[Point; 2]], done: &BTreeSet<u32>, status: &[u32]) -> Sketch {
    let mut sketch = Sketch::new();
    for (number, ends) in (0..).zip(segments) {
        let (role, key) = if status.contains(&number) {
            (Role::Main, "segment that the sweep line cuts")
        } else if done.contains(&number) {
            (Role::Dimmed, "segment behind the line")
        } else {
            (Role::Plain, "segment ahead of it")
        };
        let path = sketch.path(role, *ends).title(format!("segment {number}"));
        if !status.is_empty() || !done.is_empty() {
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
