//! The records of polygons, as the lines of a dump have them.

use crate::harness::{Cell, Column, Link, Structure, Table};
use crate::point::Point;
use crate::polygon::{Corner, Polygons};

impl Structure for Polygons {
    const TABLES: &'static [Table] = &[Table {
        letter: 'c',
        word: "corner",
        name: "corner",
        plural: "corners",
        columns: &[
            Column::Number,
            Column::Number,
            Column::Link(Link { name: "next", letter: 'c' }),
            Column::Link(Link { name: "prev", letter: 'c' }),
        ],
        shortcuts: &[],
    }];
    const SINGLES: &'static [&'static str] = &[];

    fn len(&self, _: usize) -> usize {
        self.corners.len()
    }

    fn rows(&self, _: usize) -> impl Fn(usize) -> Vec<Cell> {
        |number| {
            let Corner { pos, next, prev } = self.corners[number];
            vec![Cell::Number(pos.x), Cell::Number(pos.y), Cell::Link(next), Cell::Link(prev)]
        }
    }

    fn add(&mut self, _: usize, row: &[Cell]) {
        if let [x, y, next, prev] = row {
            let pos = Point { x: x.number(), y: y.number() };
            self.corners.push(Corner { pos, next: next.to(), prev: prev.to() });
        }
    }

    fn differs(&self, before: &Self, _: usize) -> impl Fn(usize) -> bool {
        |number| self.corners[number] != before.corners[number]
    }

    fn single(&self, _: usize) -> Option<usize> {
        None
    }

    fn set_single(&mut self, _: usize, _: Option<usize>) {}
}
