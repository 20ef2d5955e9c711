//! Before, expected, yours: one failing call in three drawings.
//!
//! ```text
//!   before       expected                             yours
//!   as it was    the half-edges at fault are red,     links: what is missing red and dashed, what is there
//!                the pointers at fault have arrows    instead blue; faces, representatives: as in `expected`
//! ```

use super::ascii;
use crate::Element;
use crate::figure::compare::diff_figure;
use crate::figure::{self, Colour, Figure, FigureError, FigureOptions, Overrides, Pointers};
use crate::lab::Picture;
use crate::lab::checks::align::{Field, differences};
use crate::lab::course::Course;
use crate::lab::fault::{Exchange, Fault};
use crate::topology::Table;

/// The colour of what is wrong.
const RED: Colour = Colour(0xc8_1e_1e);
/// With more half-edges than this, arrows would be a thicket.
const ARROWS: usize = 60;

/// The picture of a call; `None` if it cannot be drawn, or nothing is known of the structures.
pub(super) fn of(course: &dyn Course, exchange: &Exchange, faults: &[&Fault]) -> Option<Picture> {
    let before = exchange.before?;
    let yours = exchange.after.unwrap_or(before);
    let expected = course.expected(exchange)?;
    let wrong: Vec<Element> = faults.iter().flat_map(|fault| fault.elements.iter().copied()).collect();
    let families = families(&expected, yours);
    let draw = |table: &Table, title: &str, families: &[Pointers], red: &[Element]| {
        let options = FigureOptions::new(title).id_prefix(title).overrides(marked(red));
        svg(table, families, &options)
    };
    Some(Picture {
        before: draw(before, "Before", &[], &[])?,
        expected: draw(&expected, "Expected", &families, &wrong)?,
        yours: difference(&expected, yours).or_else(|| draw(yours, "Yours", &families, &wrong))?,
        ascii: ascii::of(before, &expected, yours, exchange),
    })
}

/// What differs in links and places, numbered. `None` if the links agree: faces and representatives are seen better
/// by their arrows, all of them.
fn difference(expected: &Table, yours: &Table) -> Option<String> {
    let shown = [Field::Origin, Field::Twin, Field::Next, Field::Prev, Field::Position];
    if !differences(expected, yours).iter().any(|difference| shown.contains(&difference.field)) {
        return None;
    }
    let options = FigureOptions::new("Yours").id_prefix("Yours");
    Some(diff_figure(expected, yours, &options).ok()?.to_svg())
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
    let with_arrows = (!families.is_empty() && table.half_edges.len() <= ARROWS)
        .then(|| figure::pointers(table, families, options))
        .and_then(Result::ok);
    let drawn: Result<Figure, FigureError> = with_arrows.map_or_else(|| figure::structure(table, options), Ok);
    Some(drawn.ok()?.to_svg())
}
