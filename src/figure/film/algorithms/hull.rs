//! A convex hull, as Andrew's scan finds it: corners come, and go again.

use super::numbered;
use crate::figure::SketchFilm;
use crate::figure::sketch::{Role, Sketch};
use crate::plane::{HullError, HullEvent, Point, convex_hull_observed};

/// The film of [`convex_hull`](crate::plane::convex_hull): a frame for each corner that comes or goes, at most `most` of
/// them.
///
/// # Errors
/// [`HullError`].
///
/// ```
/// use dcel_kit::figure::algorithms;
/// let points = [(0., 0.), (2., 1.), (4., 0.), (2., 3.)].map(Into::into);
/// let film = algorithms::convex_hull(&points, 50)?;
/// assert!(film.captions().any(|(heading, _)| heading.contains("point 1 goes again")));
/// # Ok::<(), dcel_kit::plane::HullError>(())
/// ```
pub fn convex_hull(points: &[Point], most: usize) -> Result<SketchFilm, HullError> {
    let mut events = Vec::new();
    let corners = convex_hull_observed(points, &mut events)?;
    let aside = events.iter().find_map(|event| match event {
        HullEvent::Sorted { aside } => Some(*aside),
        _ => None,
    });
    let steps: Vec<HullEvent> = events.into_iter().filter(|event| !matches!(event, HullEvent::Sorted { .. })).collect();
    let mut film = SketchFilm::new();
    let text = match aside.unwrap_or(0) {
        0 => "they are taken from left to right".to_owned(),
        1 => "one is inside for sure, or repeats another; the rest is taken from left to right".to_owned(),
        count => format!("{count} are inside for sure, or repeat others; the rest is taken from left to right"),
    };
    film.frame(&format!("{} points", points.len()), &text, dots(points));
    let place = |i: u32| points[i as usize];
    let (mut chain, mut next): (Vec<u32>, usize) = (Vec::new(), 0);
    for (i, number) in numbered(steps.len(), most) {
        while next < i {
            apply(&mut chain, steps[next]);
            next += 1;
        }
        let mut sketch = dots(points);
        let kept = match steps[i] {
            HullEvent::Dropped { .. } => chain.len().saturating_sub(1),
            _ => chain.len(),
        };
        if kept > 1 {
            sketch.path(Role::Main, chain[..kept].iter().map(|&i| place(i))).key("boundary so far");
        }
        let (what, text) = match steps[i] {
            HullEvent::Dropped { corner, point } => {
                let from = kept.checked_sub(1).map(|last| place(chain[last]));
                let bend = from.into_iter().chain([place(corner), place(point)]);
                sketch.path(Role::Wrong, bend).key("no left turn");
                sketch.point(Role::Event, place(point)).key("new point");
                (format!("point {corner} goes again"), format!("on the way to point {point} it does not turn left"))
            }
            HullEvent::Taken(point) => {
                if let Some(&last) = chain.last() {
                    sketch.path(Role::Secondary, [place(last), place(point)]).key("new side");
                }
                sketch.point(Role::Event, place(point)).key("new point");
                (format!("point {point} comes"), "it is the last corner for now".to_owned())
            }
            _ => ("the lower side is done".to_owned(), "now the same from right to left".to_owned()),
        };
        film.frame(&format!("Step {number}: {what}"), &text, sketch);
    }
    let mut end = dots(points);
    if corners.len() > 1 {
        let round = corners.iter().chain(corners.first());
        end.path(Role::Main, round.map(|&i| place(i))).key("convex hull");
    }
    for &i in &corners {
        end.point(Role::Main, place(i)).key("corner of the hull");
    }
    film.frame("The convex hull", &format!("{} corners, each a left turn", corners.len()), end);
    Ok(film)
}

fn dots(points: &[Point]) -> Sketch {
    let mut sketch = Sketch::new();
    for (i, &p) in points.iter().enumerate() {
        let dot = sketch.point(Role::Plain, p).title(format!("point {i}"));
        if points.len() <= 40 {
            dot.label(i.to_string());
        }
    }
    sketch
}

fn apply(chain: &mut Vec<u32>, step: HullEvent) {
    match step {
        HullEvent::Dropped { .. } => drop(chain.pop()),
        HullEvent::Taken(point) => chain.push(point),
        // The last point of the way there is the first of the way back.
        HullEvent::Turned => drop(chain.pop()),
        HullEvent::Sorted { .. } => {}
    }
}
