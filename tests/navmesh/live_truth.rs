//! What is true of obstacles on a map, from what was given alone: no edge, no face, no cut.
//!
//! ```text
//!    │   ╱╲ │    │      Upright lines through all corners and crossings cut the plane into strips. Inside a strip no two
//!    │  ╱ ╲│    │      sides cross: the area of a strip is its width times what its middle line has inside.
//!    │ ╱   │╲   │
//! ```

use crate::maps::Random;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;

/// A polygon that blocks, or a wall if it has two corners.
pub(crate) type Shape = Vec<Point>;

/// A map as it was drawn, and what was put into it.
pub(crate) struct Truth<'a> {
    /// The rim of the map and of each hole.
    pub(crate) rings: &'a [Shape],
    pub(crate) shapes: &'a [Shape],
}

/// The sides of a polygon, or the one of a wall.
pub(crate) fn sides(shape: &[Point]) -> impl Iterator<Item = [Point; 2]> + '_ {
    let count = if shape.len() == 2 { 1 } else { shape.len() };
    (0..count).map(|i| [shape[i], shape[(i + 1) % shape.len()]])
}

/// Whether a point that is on no side is inside: an odd number of sides lies above it.
fn is_inside(shape: &[Point], p: Point) -> bool {
    let above = |&[a, b]: &[Point; 2]| {
        let [a, b] = if a.x <= b.x { [a, b] } else { [b, a] };
        a.x <= p.x && p.x < b.x && orientation(a, b, p).is_lt()
    };
    shape.len() > 2 && sides(shape).filter(above).count() % 2 == 1
}

fn distance([a, b]: [Point; 2], p: Point) -> f64 {
    let [x, y] = [b.x - a.x, b.y - a.y];
    let along = (((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y)).clamp(0.0, 1.0);
    (p.x - a.x - along * x).hypot(p.y - a.y - along * y)
}

/// Where the middle line of a strip is inside the shape.
fn spans(shape: &[Point], x: f64) -> Vec<[f64; 2]> {
    let height = |[a, b]: [Point; 2]| a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
    let cut = |&[a, b]: &[Point; 2]| a.x.min(b.x) < x && x < a.x.max(b.x);
    let mut heights: Vec<f64> = sides(shape).filter(cut).map(height).collect();
    heights.sort_by(f64::total_cmp);
    heights.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

fn length(mut spans: Vec<[f64; 2]>) -> f64 {
    spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut top = f64::NEG_INFINITY;
    let mut sum = 0.0;
    for [low, high] in spans {
        sum += (high - low.max(top)).max(0.0);
        top = top.max(high);
    }
    sum
}

/// The parts of the spans of one list that are in none of the other.
fn without(spans: Vec<[f64; 2]>, taken: &[[f64; 2]]) -> Vec<[f64; 2]> {
    taken.iter().fold(spans, |spans, &[low, high]| {
        let parts = spans.into_iter().flat_map(|[from, to]| [[from, to.min(low)], [from.max(high), to]]);
        parts.filter(|[from, to]| from < to).collect()
    })
}

impl Truth<'_> {
    /// The area of the map, and of the part of it that is free.
    pub(crate) fn areas(&self) -> [f64; 2] {
        let all: Vec<[Point; 2]> = self.rings.iter().chain(self.shapes).flat_map(|shape| sides(shape)).collect();
        let mut lines: Vec<f64> = all.iter().flatten().map(|p| p.x).collect();
        for (i, &[a, b]) in all.iter().enumerate() {
            for &[c, d] in &all[..i] {
                let across = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
                let [t, s] =
                    [[c, d], [a, b]].map(|[p, q]| ((c.x - a.x) * (q.y - p.y) - (c.y - a.y) * (q.x - p.x)) / across);
                if (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&s) {
                    lines.push(a.x + t * (b.x - a.x));
                }
            }
        }
        lines.sort_by(f64::total_cmp);
        let mut areas = [0.0; 2];
        for pair in lines.windows(2).filter(|pair| pair[0] < pair[1]) {
            let (middle, width) = (pair[0] + (pair[1] - pair[0]) / 2.0, pair[1] - pair[0]);
            let (rim, holes) = self.rings.split_first().expect("a map");
            let holes: Vec<[f64; 2]> = holes.iter().flat_map(|hole| spans(hole, middle)).collect();
            let map = without(spans(rim, middle), &holes);
            let blocked: Vec<[f64; 2]> = self.shapes.iter().flat_map(|shape| spans(shape, middle)).collect();
            areas[0] += width * length(map.clone());
            areas[1] += width * length(without(map, &blocked));
        }
        areas
    }

    /// Whether the point is on the map, and whether it is free there; `None` close to a side, where rounding counts.
    pub(crate) fn is_free(&self, p: Point) -> Option<[bool; 2]> {
        let mut all = self.rings.iter().chain(self.shapes).flat_map(|shape| sides(shape));
        if all.any(|side| distance(side, p) < 1e-9) {
            return None;
        }
        let (rim, holes) = self.rings.split_first()?;
        let on_map = is_inside(rim, p) && !holes.iter().any(|hole| is_inside(hole, p));
        Some([on_map, on_map && !self.shapes.iter().any(|shape| is_inside(shape, p))])
    }

    /// Points anywhere, and close to corners.
    pub(crate) fn probes(&self, random: &mut Random, anywhere: usize) -> Vec<Point> {
        let mut found: Vec<Point> =
            (0..anywhere).map(|_| Point::new(22.0 * random.unit() - 1.0, 22.0 * random.unit() - 1.0)).collect();
        for shape in self.shapes.iter().chain(self.rings) {
            for p in shape {
                let [dx, dy] = [(); 2].map(|()| (random.unit() - 0.5) * 0.2);
                found.push(Point::new(p.x + dx, p.y + dy));
            }
        }
        found
    }
}
