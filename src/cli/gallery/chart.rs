//! Growth on logarithmic axes: equal ratios are equally far from each other, so that powers are straight lines.
//!
//! What is drawn is rounded to hundredths of a px: a last bit of a logarithm that differs between machines is not seen.

use dcel_kit::figure::sketch::{Role, Sketch};

/// What the plot takes of the picture, in units of the sketch.
const SIZE: [f64; 2] = [10.0, 6.0];
/// How long the marks of the axes are.
const TICK: f64 = 0.12;
/// The roles of the series, in turn.
const ROLES: [Role; 4] = [Role::Main, Role::Secondary, Role::Start, Role::Goal];

/// A chart with logarithmic axes.
pub(super) struct Chart {
    pub(super) sketch: Sketch,
    low: [f64; 2],
    high: [f64; 2],
    /// The roles that are left.
    roles: std::slice::Iter<'static, Role>,
}

impl Chart {
    /// The axes between two corners, a line across at each power of ten.
    pub(super) fn new([x, y]: [&str; 2], low: [f64; 2], high: [f64; 2]) -> Self {
        let mut chart = Self { sketch: Sketch::new(), low, high, roles: ROLES.iter() };
        let (corner, right, top) = (chart.at(low), chart.at([high[0], low[1]]), chart.at([low[0], high[1]]));
        for axis in [0, 1] {
            for value in (0..6).flat_map(|e| (1..10).map(move |digit| f64::from(digit * 10_i32.pow(e)))) {
                if value < low[axis] || value > high[axis] {
                    continue;
                }
                let (mut from, mut to) = (low, high);
                (from[axis], to[axis]) = (value, value);
                let (from, to) = (chart.at(from), chart.at(to));
                let beside = |gap: f64| if axis == 0 { [from[0], from[1] - gap] } else { [from[0] - gap, from[1]] };
                let is_power = value.log10().fract() < 1e-9;
                if is_power {
                    chart.sketch.path(Role::Dimmed, [from, to]);
                    chart.sketch.text(Role::Plain, beside([3.0, 5.0][axis] * TICK), value.to_string());
                }
                let length = if is_power { TICK } else { 0.5 * TICK };
                chart.sketch.path(Role::Plain, [from, beside(length)]);
            }
        }
        chart.sketch.path(Role::Plain, [top, corner, right]);
        chart.sketch.text(Role::Plain, [0.5 * SIZE[0], -8.0 * TICK], x);
        chart.sketch.text(Role::Plain, [0.0, SIZE[1] + 4.0 * TICK], y);
        chart
    }

    fn at(&self, values: [f64; 2]) -> [f64; 2] {
        let share = |i: usize| (values[i] / self.low[i]).log10() / (self.high[i] / self.low[i]).log10();
        [SIZE[0] * share(0), SIZE[1] * share(1)]
    }

    /// Points joined in order, with a name at the last.
    pub(super) fn series(&mut self, name: &str, samples: impl IntoIterator<Item = [f64; 2]>) {
        let role = *self.roles.next().unwrap_or(&Role::Plain);
        let points: Vec<[f64; 2]> = samples.into_iter().map(|sample| self.at(sample)).collect();
        self.sketch.path(role, points.iter().copied());
        for (i, &point) in points.iter().enumerate() {
            let mark = self.sketch.point(role, point);
            if i + 1 == points.len() {
                mark.label(name);
            }
        }
    }

    /// A growth to compare with: a straight line between two points of the plot.
    pub(super) fn growth(&mut self, name: &str, from: [f64; 2], to: [f64; 2]) {
        let ends = [self.at(from), self.at(to)];
        self.sketch.path(Role::Plain, ends).dashed().label(name);
    }
}
