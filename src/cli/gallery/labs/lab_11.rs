//! The reference figures of lab 11.

use super::{Made, outline};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Multiples, Role, Sketch};
use dcel_lab::cases::handouts::GEM;

/// The direction of the climb.
pub(in crate::gallery) const DIRECTION: [f64; 3] = [1.0, 2.0, 5.0];
/// The vertices of the climb from the lowest corner.
const CLIMB: [usize; 3] = [0, 2, 7];

/// Where a point is in the picture, as the handout's program has it.
fn projected([x, y, z]: [f64; 3]) -> [f64; 2] {
    [x + 0.5 * y, z + 0.25 * y]
}

/// The picture that lab 11 asks for: the edges of the gem, and the climb.
pub(in crate::gallery) fn climb(options: &FigureOptions) -> Made<String> {
    let at = |v: usize| projected(GEM[v]);
    let mut sketch = Sketch::new();
    for k in 1..=6 {
        for edge in [[k, k % 6 + 1], [k, 7], [k, 0]] {
            sketch.path(Role::Plain, edge.map(at));
        }
    }
    sketch.path(Role::Goal, CLIMB.map(at)).solid();
    for v in CLIMB {
        sketch.point(Role::Plain, at(v)).label(format!("v{v}"));
    }
    Ok(sketch.figure(options)?.to_svg())
}

/// A polygon, and a climb over it.
fn panel(corners: &[[f64; 2]], climb: &[usize], end: &str) -> Sketch {
    let mut sketch = Sketch::new();
    outline(&mut sketch, [Role::Main, Role::Plain], corners);
    for step in climb.windows(2) {
        sketch.path(Role::Goal, [corners[step[0]], corners[step[1]]]).solid().arrow();
    }
    for (i, p) in corners.iter().enumerate() {
        let is_end = climb.last() == Some(&i);
        let label = if is_end { end } else { "from" };
        let point = sketch.point(if is_end { Role::Goal } else { Role::Plain }, *p);
        if is_end || climb.first() == Some(&i) {
            point.label(label);
        }
    }
    sketch
}

/// Where a climb upwards ends: at the top, at a lower peak, on a plateau.
pub(in crate::gallery) fn stuck(options: &FigureOptions) -> Made<String> {
    let convex = [[-10.0, -100.0], [90.0, -50.0], [105.0, 30.0], [35.0, 95.0], [-70.0, 60.0], [-100.0, -30.0]];
    let dented = [[0.0, -100.0], [95.0, -30.0], [75.0, 95.0], [10.0, -10.0], [-55.0, 45.0], [-100.0, -40.0]];
    let level =
        [[-90.0, -90.0], [-45.0, -90.0], [0.0, -90.0], [45.0, -90.0], [90.0, -90.0], [90.0, 90.0], [-90.0, 90.0]];
    let mut panels = Multiples::new();
    panels.sketch("Convex", "the climb ends at the top", panel(&convex, &[0, 1, 2, 3], "top"));
    panels.sketch("Not convex", "it ends at a lower peak", panel(&dented, &[5, 4], "stuck"));
    panels.sketch("A plateau", "both neighbours are as high: it ends at once", panel(&level, &[2], "stuck"));
    Ok(panels.figure(options)?.to_svg())
}
