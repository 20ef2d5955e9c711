//! Before, expected, yours: one failing call in three drawings of one layout.
//!
//! ```text
//!   before       expected                             yours
//!   as it was    the half-edges at fault are red,     the same as it is; of a walk that does not come back, the
//!                the pointers at fault have arrows;   half-edges that it goes round are red
//!                the right answer of a walk is red
//! ```

use super::ascii;
use crate::Picture;
use crate::checks::align::{Field, differences};
use crate::fault::{Exchange, Fault};
use crate::judge::Judge;
use crate::protocol::CallEnd;
use dcel_kit::figure::{self, Colour, Detail, Figure, FigureError, FigureOptions, Overrides, Pointers};
use dcel_kit::topology::Table;
use dcel_kit::{Element, HalfEdgeId};

/// The colour of what is wrong.
const RED: Colour = Colour(0xc8_1e_1e);
/// With more half-edges than this, arrows would be a thicket.
const ARROWS: usize = 60;
/// The widths that a drawing may have, in px. A page shows it at three quarters of that or more, so that its letters
/// can be read; wider ones are scrolled.
const WIDTH: [f64; 2] = [560.0, 1100.0];

/// The picture of a call; `None` if it cannot be drawn, or nothing is known of the structures.
pub(super) fn of(judge: &dyn Judge, exchange: &Exchange, faults: &[&Fault]) -> Option<Picture> {
    let before = exchange.before()?;
    let yours = exchange.after().unwrap_or(before);
    let expected = judge.expected(exchange)?;
    let wrong: Vec<Element> = faults.iter().flat_map(|fault| fault.elements.iter().copied()).collect();
    let round = walked(exchange);
    let mut families = families(&expected, yours);
    if !round.is_empty() && !families.contains(&Pointers::Next) {
        families.insert(0, Pointers::Next);
    }
    let layout = Layout::of([before, &expected, yours], &families);
    let draw = |table: &Table, title: &str, families: &[Pointers], red: &[Element]| {
        let options = layout.options(title).overrides(marked(red));
        svg(table, families, &options)
    };
    let red = if round.is_empty() { &wrong } else { &round };
    // Of a call that only reads, what it should have returned is red where it is expected.
    let answer = judge.answer(exchange);
    let right: &[Element] = match () {
        () if !answer.is_empty() => &answer,
        () if round.is_empty() => &wrong,
        () => &[],
    };
    Some(Picture {
        before: draw(before, "Before", &families, &[])?,
        expected: draw(&expected, "Expected", &families, right)?,
        yours: draw(yours, "Yours", &families, red)?,
        ascii: ascii::of(before, &expected, yours),
    })
}

/// The half-edges that a call read last before it was stopped: those that it went round, if it did.
fn walked(exchange: &Exchange) -> Vec<Element> {
    let Some((_, CallEnd::Stopped(stopped))) = exchange.called else { return Vec::new() };
    let number = |word: &String| word.strip_prefix('h')?.parse().ok();
    stopped.elements.iter().filter_map(number).map(|number| HalfEdgeId::new(number).into()).collect()
}

/// What the three drawings share: the box that they show, their width, and how much of each half-edge they show.
struct Layout {
    corners: Vec<[f64; 2]>,
    width: f64,
    detail: Detail,
}

impl Layout {
    fn of(tables: [&Table; 3], families: &[Pointers]) -> Self {
        let mut corners: Vec<[f64; 2]> = Vec::new();
        for [x, y] in tables.iter().flat_map(|table| table.vertices.iter().flatten()).filter_map(|row| row.position) {
            match &mut corners[..] {
                [low, high] => {
                    (low[0], low[1]) = (low[0].min(x), low[1].min(y));
                    (high[0], high[1]) = (high[0].max(x), high[1].max(y));
                }
                _ => corners = vec![[x, y]; 2],
            }
        }
        // The richest of them asks for the most room.
        let richest = tables.iter().max_by_key(|table| table.half_edges.len());
        let natural = richest.and_then(|table| {
            let options = FigureOptions::new("").reach(corners.iter().copied());
            drawn(table, families, &options)
        });
        let width = natural.as_ref().map_or(WIDTH[0], |figure| figure.size().0.clamp(WIDTH[0], WIDTH[1]));
        let sized = FigureOptions::new("").reach(corners.iter().copied()).width(width);
        let least =
            tables.iter().filter_map(|table| drawn(table, families, &sized)).map(|figure| figure.detail()).min();
        Self { corners, width, detail: least.unwrap_or(Detail::Arrows) }
    }

    fn options(&self, title: &str) -> FigureOptions {
        let options = FigureOptions::new(title).id_prefix(title).reach(self.corners.iter().copied());
        options.width(self.width).detail(self.detail)
    }
}

/// The families of pointers in which two structures differ.
fn families(expected: &Table, yours: &Table) -> Vec<Pointers> {
    let family = |field| match field {
        Field::Next | Field::Prev => Some(Pointers::Next),
        Field::Twin => Some(Pointers::Twin),
        Field::Face => Some(Pointers::Face),
        Field::Outgoing => Some(Pointers::Outgoing),
        Field::Boundary => Some(Pointers::Boundary),
        Field::Origin | Field::Position | Field::OuterFace => None,
    };
    let mut all: Vec<Pointers> = differences(expected, yours).iter().filter_map(|d| family(d.field)).collect();
    all.sort_unstable();
    all.dedup();
    all.truncate(2);
    all
}

fn marked(elements: &[Element]) -> Overrides {
    elements.iter().fold(Overrides::default(), |marks, &element| match element {
        Element::HalfEdge(_) | Element::Vertex(_) => marks.colour(element, RED),
        Element::Edge(_) | Element::Face(_) => marks,
    })
}

fn svg(table: &Table, families: &[Pointers], options: &FigureOptions) -> Option<String> {
    Some(drawn(table, families, options)?.to_svg())
}

fn drawn(table: &Table, families: &[Pointers], options: &FigureOptions) -> Option<Figure> {
    let with_arrows = (!families.is_empty() && table.half_edges.len() <= ARROWS)
        .then(|| figure::pointers(table, families, options))
        .and_then(Result::ok);
    let drawn: Result<Figure, FigureError> = with_arrows.map_or_else(|| figure::structure(table, options), Ok);
    drawn.ok()
}
