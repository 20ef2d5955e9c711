//! What has a place has a number in the picture of differences, the same as in the list.

use super::declared::{BARB, LINE, changed, reference, within};
use super::halves::names;
use super::pen::table;
use super::{judge, kit, ship};
use dcel_kit::compare::{Comparison, Options, compare};
use dcel_kit::figure::FigureOptions;

/// How many numbers stand in the picture, each once more in the list.
fn badges(answer: &Comparison) -> usize {
    let svg = answer.figure(&FigureOptions::new("numbers")).unwrap().to_svg();
    let count = svg.matches("class=\"badge\"").count();
    assert!(count.is_multiple_of(2), "{count}");
    count / 2
}

#[test]
fn half_edges_that_are_drawn_wrong_have_numbers() {
    // One without its barb, one without its line.
    let svg = changed(|lines| {
        let all: Vec<String> = names().collect();
        let (barb, line) = (within(lines, &all[3], BARB), within(lines, &all[20], LINE));
        lines[barb].clear();
        lines[line] = lines[line].replacen("<line", "<line style=\"stroke:none\"", 1);
    });
    let answer = judge(&reference(), &svg);
    assert_eq!((answer.differences().len(), badges(&answer)), (2, 2), "{}", answer.text());
}

#[test]
fn vertices_at_each_others_places_have_one_number() {
    let svg = changed(|lines| {
        let [a, b] = ["v1", "v2"].map(|name| within(lines, name, "<circle"));
        lines.swap(a, b);
    });
    let answer = judge(&reference(), &svg);
    assert!(answer.text().contains("2 vertices are drawn where others belong"), "{}", answer.text());
    assert_eq!(badges(&answer), answer.differences().len(), "{}", answer.text());
}

#[test]
fn names_have_numbers() {
    let reference = kit(&table(&ship()));
    // The names of a vertex, of a half-edge and of a face.
    let mut svg = reference.clone();
    for name in ["v3", "h8", "f2"] {
        let at = svg.find(&format!(">{name}</text>")).unwrap();
        svg.replace_range(at + 1..at + 3, "xx");
    }
    let answer = compare(&reference, &svg, &Options::new().names(true)).unwrap();
    assert_eq!((answer.differences().len(), badges(&answer)), (3, 3), "{}", answer.text());
}

#[test]
fn broken_invariants_have_numbers_where_something_breaks_them() {
    let right = table(&ship());
    let mut wrong = right.clone();
    wrong.faces[2].as_mut().unwrap().half_edge = Some(crate::common::h(1));
    let answer = dcel_kit::compare::compare_tables(&right, &wrong, &Options::new());
    assert!(answer.text().contains("your structure breaks an invariant"), "{}", answer.text());
    assert_eq!(badges(&answer), answer.differences().len(), "{}", answer.text());
}
