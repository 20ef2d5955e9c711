//! Points that were located, over the structure; what they lie on is blue, and walks to them are arrows.
//!
//! ```text
//!   ┌───────────┬──────┐
//!   │▒▒▒▒▒▒▒▒▒▒▒│      │     ① a point in a face     ▲ where the walks start     ─ ─▸ the straight way to a point
//!   │▲─ ─ ─ ─ ▸①│      │
//!   └───────────┴──────┘
//! ```

use crate::figure::sketch::{Backdrop, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::ids::{FaceId, FaceMap, VertexId};
use crate::plane::{Location, Point, Subdivision};

/// Draws points and where they were found. Each has a numbered badge if the legend has words for it; `start` is the
/// vertex from which a walk led to each, if there were walks.
///
/// Cost: O(n log n) and O(half-edges of the faces that were found).
///
/// # Errors
/// [`SketchError`].
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::plane::{Point, Subdivision};
/// use dcel_kit::VertexId;
/// let lab = Subdivision::lab_rectangle();
/// let p = Point::new(10.0, 20.0);
/// let walk = lab.walk_from(VertexId::new(0), p)?;
/// let found = [(p, walk.location, Some("inside".to_owned()))];
/// let svg = figure::located(&lab, &found, Some(VertexId::new(0)), &FigureOptions::new("Where"))?.to_svg();
/// assert!(svg.contains("where the walks start") && svg.contains("inside"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn located(
    s: &Subdivision,
    found: &[(Point, Location, Option<String>)],
    start: Option<VertexId>,
    options: &FigureOptions,
) -> Result<Figure, SketchError> {
    let mut sketch = Sketch::new();
    let mut faces: Vec<FaceId> = Vec::new();
    let mut seen = FaceMap::filled(s.face_bound(), false);
    seen[s.outer_face()] = true;
    for &(_, at, _) in found {
        match at {
            Location::Face(f) if !std::mem::replace(&mut seen[f], true) => faces.push(f),
            Location::Edge(h) => {
                sketch.path(Role::Main, [h, h.twin()].map(|h| s.point(s.origin(h))));
            }
            _ => {}
        }
    }
    for &f in &faces {
        sketch.region(Role::Main, s.cycles(f).map(|h| s.cycle(h).map(|h| s.point(s.origin(h)))));
    }
    if let Some(start) = start {
        for &(p, ..) in found.iter().filter(|&&(p, ..)| p != s.point(start)) {
            sketch.path(Role::Secondary, [s.point(start), p]).arrow();
        }
        sketch.point(Role::Start, s.point(start)).key("where the walks start");
    }
    for (p, _, words) in found {
        sketch.point(Role::Event, *p);
        if let Some(words) = words {
            sketch.badge(Role::Event, *p, words);
        }
    }
    sketch.over(s, Backdrop::Plain, options)
}
