//! What `merge` has left behind: one polygon, linked both ways, which is the hull of the two.

use super::hull::{hull, of_corners};
use super::polygons::{NEXT, PREV, cycle, link};
use super::tangents::asked_two;
use crate::answers::Wrong;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::plane::Point;

/// What is wrong with the answer of `merge`, and with the polygon of the corner that it gave back.
pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let [first, second] = asked_two(exchange)?;
    let [Value::Id(returned)] = values else { return Some(Wrong::kind("one corner")) };
    let after = exchange.records_after()?;
    let points: Vec<Point> = first.iter().chain(&second).map(|c| c.place).collect();
    let expected = hull(&points);
    let Some(found) = cycle(after, *returned) else {
        let because = format!("from c{returned}, next does not come back to where it began");
        return Some(Wrong::because("open", because));
    };
    let places: Vec<Point> = found.iter().map(|c| c.place).collect();
    if let Some(wrong) = of_corners(&expected, &points, &places) {
        return Some(Wrong {
            expected: None,
            because: format!("the polygon of c{returned} is not the hull of the two: {}", wrong.because),
            ..wrong
        });
    }
    let torn = found.iter().find_map(|c| {
        let next = link(after, c.number, NEXT)?;
        (link(after, next, PREV) != Some(c.number)).then_some((c.number, next))
    });
    torn.map(|(c, next)| {
        let prev = link(after, next, PREV).map_or("not set".to_owned(), |prev| format!("c{prev}"));
        Wrong::because("prev", format!("the next of c{c} is c{next}, but the prev of c{next} is {prev}"))
    })
}
