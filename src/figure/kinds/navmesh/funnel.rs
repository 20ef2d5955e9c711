//! The funnel, portal by portal: how the path through a corridor is pulled straight.

use crate::figure::kinds::navmesh::{Floor, Panel};
use crate::figure::sketch::{Backdrop, Multiples, Role, Sketch, SketchError};
use crate::figure::{Figure, FigureOptions};
use crate::navmesh::{FunnelStep, Portal, Route};

/// So many panels at most; of longer routes the steps at which the path bends are shown, each with the one before, and
/// the last.
const PANELS: usize = 12;

impl Floor<'_> {
    /// One panel for each portal of a route, and one for the goal: the certain path, the two chains of the funnel, the
    /// portal that was passed last.
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate that cannot be drawn.
    pub fn funnel(&self, route: &Route, options: &FigureOptions) -> Result<Figure, SketchError> {
        let steps = route.funnel_steps(self.mesh);
        let portals: Vec<_> = route.portal_ends(self.mesh).collect();
        let mut sheet = Multiples::new();
        for i in shown(&steps) {
            let (heading, text, sketch) = self.funnel_panel(route, &steps[i], i, portals.get(i));
            sheet.over(&heading, &text, self.map, Backdrop::Dimmed, sketch);
        }
        sheet.figure(&self.nameless(options))
    }

    /// The heading, the text and the sketch of each panel.
    pub(in crate::figure) fn funnel_panels(&self, route: &Route) -> Vec<Panel> {
        let steps = route.funnel_steps(self.mesh);
        let portals: Vec<_> = route.portal_ends(self.mesh).collect();
        let panel = |(i, step)| self.funnel_panel(route, step, i, portals.get(i));
        steps.iter().enumerate().map(panel).collect()
    }

    fn funnel_panel(&self, route: &Route, step: &FunnelStep, i: usize, portal: Option<&Portal>) -> Panel {
        let mut sketch = Sketch::new();
        self.corridor(&mut sketch, route);
        if let [.., apex] = step.way.as_slice() {
            if let ([.., left], [.., right]) = (step.left.as_slice(), step.right.as_slice())
                && portal.is_some()
            {
                sketch.portal(Role::Secondary, *left, *right).key("the portal: left endpoint a square, right a ring");
            }
            for (role, points, key) in [
                (Role::Right, &step.left, "left chain of the funnel"),
                (Role::Wrong, &step.right, "right chain of the funnel"),
                (Role::Main, &step.way, "the way as far as it is certain"),
            ] {
                // A chain may be no longer than its apex.
                if points.windows(2).any(|pair| pair[0] != pair[1]) {
                    sketch.path(role, points.iter().copied()).key(key);
                }
            }
            sketch.point(Role::Event, *apex).key("the apex");
        }
        self.marks(&mut sketch, route);
        let (heading, about) = match portal {
            Some(portal) => {
                (format!("{}. {}", i + 1, portal.half_edge), format!("from {} to {}", portal.from, portal.to))
            }
            None => (format!("{}. the goal", i + 1), "both chains end there: the way is found".to_owned()),
        };
        (heading, about, sketch)
    }
}

/// The steps to show: all, or those at which the apex moves with the ones before them, and the last.
fn shown(steps: &[FunnelStep]) -> Vec<usize> {
    let all: Vec<usize> = (0..steps.len()).collect();
    if all.len() <= PANELS {
        return all;
    }
    let moves = |i: &usize| *i > 0 && steps[*i].way.len() > steps[i - 1].way.len();
    let mut chosen: Vec<usize> = all.iter().copied().filter(moves).flat_map(|i| [i - 1, i]).collect();
    chosen.dedup();
    chosen.truncate(PANELS - 1);
    chosen.extend(all.last().filter(|last| !chosen.contains(last)));
    chosen
}
