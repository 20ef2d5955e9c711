//! Points by place, each with a number.

use super::pairing::Places;
use crate::plane::Point;

/// Points by place: those near an expected point become one, and so do those near each other.
pub(super) struct Snap {
    expected: Places,
    /// The number of each expected point, once something is drawn there.
    pub(super) numbers: Vec<Option<u32>>,
    others: Places,
    other_numbers: Vec<u32>,
    pub(super) points: Vec<Point>,
    tolerance: f64,
}

impl Snap {
    pub(super) fn new(expected: &[Point], tolerance: f64) -> Self {
        Self {
            expected: Places::of(expected, 4.0 * tolerance),
            numbers: vec![None; expected.len()],
            others: Places::new(4.0 * tolerance),
            other_numbers: Vec::new(),
            points: Vec::new(),
            tolerance,
        }
    }

    /// The number of what is at a place, a new one if need be.
    pub(super) fn number(&mut self, p: Point) -> u32 {
        let next = self.points.len() as u32;
        let number = match self.expected.near(p, self.tolerance) {
            Some(v) => *self.numbers[v as usize].get_or_insert(next),
            None => {
                let i = self.others.near_or_add(p, self.tolerance) as usize;
                if i == self.other_numbers.len() {
                    self.other_numbers.push(next);
                }
                self.other_numbers[i]
            }
        };
        if number == next {
            self.points.push(p);
        }
        number
    }

    /// The numbers of both ends, if something is drawn at both.
    pub(super) fn known(&self, [a, b]: [Point; 2]) -> Option<[u32; 2]> {
        Some([self.drawn(a)?, self.drawn(b)?])
    }

    /// The number of what is drawn at a place.
    pub(super) fn drawn(&self, p: Point) -> Option<u32> {
        match self.expected.near(p, self.tolerance) {
            Some(v) => self.numbers[v as usize],
            None => self.others.near(p, self.tolerance).map(|i| self.other_numbers[i as usize]),
        }
    }

    /// Whether a place is that of an expected point, or something is drawn there.
    pub(super) fn is_known(&self, p: Point) -> bool {
        self.expected.near(p, self.tolerance).is_some() || self.drawn(p).is_some()
    }
}
