//! Points and corners, as the lines of a dump have them.

use crate::harness::{Cell, Column, Link, Structure, Table};
use crate::polygons::{Corner, Point, Polygons};

const fn link(name: &'static str) -> Column {
    Column::Link(Link { name, letter: 'c' })
}

impl Structure for Polygons {
    const TABLES: &'static [Table] = &[
        Table {
            letter: 'p',
            word: "point",
            name: "point",
            plural: "points",
            columns: &[Column::Number, Column::Number],
            shortcuts: &[],
        },
        Table {
            letter: 'c',
            word: "corner",
            name: "corner",
            plural: "corners",
            columns: &[Column::Number, Column::Number, link("next"), link("prev")],
            shortcuts: &[],
        },
    ];
    const SINGLES: &'static [&'static str] = &[];

    fn len(&self, table: usize) -> usize {
        [self.points.len(), self.corners.len()][table]
    }

    fn rows(&self, table: usize) -> impl Fn(usize) -> Vec<Cell> {
        move |number| {
            if table == 0 {
                let Point { x, y } = self.points[number];
                return vec![Cell::Number(x), Cell::Number(y)];
            }
            let Corner { pos, next, prev } = self.corners[number];
            vec![Cell::Number(pos.x), Cell::Number(pos.y), Cell::Link(next), Cell::Link(prev)]
        }
    }

    fn add(&mut self, _: usize, row: &[Cell]) {
        let pos = Point { x: row[0].number(), y: row[1].number() };
        match row {
            [_, _, next, prev] => self.corners.push(Corner { pos, next: next.to(), prev: prev.to() }),
            _ => self.points.push(pos),
        }
    }

    fn differs(&self, before: &Self, table: usize) -> impl Fn(usize) -> bool {
        move |number| match table {
            0 => self.points[number] != before.points[number],
            _ => self.corners[number] != before.corners[number],
        }
    }

    fn single(&self, _: usize) -> Option<usize> {
        None
    }

    fn set_single(&mut self, _: usize, _: Option<usize>) {}
}
