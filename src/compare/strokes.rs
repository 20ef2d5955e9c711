//! Whether lines that are no edges are seen, and small areas: those of half-edges.

use super::eye::{Eye, FAINT, contrast};
use super::painting::Shape;
use crate::plane::Point;
use std::ops::Range;

/// Points along a line that are looked at.
const POINTS: usize = 8;

impl Eye<'_> {
    /// Whether something is seen of the lines among these coats; `without` is the answer if there are none. `strays` are
    /// the coats of what lies in a wrong place, sorted: a line below one of these, of its colour, is seen with it.
    pub(super) fn any_line(&mut self, coats: Range<u32>, without: bool, strays: &[Range<u32>]) -> bool {
        let painting = self.painting;
        let mut lines = coats.filter(|&i| matches!(painting.coats[i as usize].shape, Shape::Stroke(..))).peekable();
        let is_any = lines.peek().is_some();
        if is_any { lines.any(|i| self.line(i, strays)) } else { without }
    }

    /// Whether one line is seen at half of the points along it.
    fn line(&mut self, i: u32, strays: &[Range<u32>]) -> bool {
        let own = &self.painting.coats[i as usize];
        let Shape::Stroke([a, b], _) = own.shape else { return false };
        let is_stray = |j: u32| {
            let next = strays.partition_point(|range| range.start <= j);
            next > 0 && strays[next - 1].contains(&j)
        };
        let mut seen = 0;
        for k in 0..POINTS {
            if self.is_tired() {
                return true;
            }
            let t = (k as f64 + 0.5) / POINTS as f64;
            self.look(Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)));
            let all = self.colour(|_, _| true);
            let without = self.colour(|j, coat| {
                let goes_with = is_stray(j) && contrast(coat.colour, own.colour) < FAINT;
                j != i && !goes_with
            });
            seen += usize::from(contrast(all, without) >= FAINT);
        }
        2 * seen >= POINTS
    }

    /// Whether a coat changes the colour at one of these points.
    pub(super) fn shows(&mut self, i: u32, points: &[Point]) -> bool {
        points.iter().any(|&p| {
            if !self.is_tired() {
                self.look(p);
            }
            self.is_tired() || contrast(self.colour(|_, _| true), self.colour(|j, _| j != i)) >= FAINT
        })
    }
}
