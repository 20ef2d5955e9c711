//! What can be said of a call of this lab before it is made.

use super::hull::{self, hull};
use super::mistakes::{self, Gift, Scan, Walk};
use super::polygons::{Corner, is_between, points};
use super::tangents::{asked, asked_two, common, from_point};
use crate::FeatureSet;
use crate::fault::Exchange;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{left_to_right, orientation};

crate::features! {
    NoPoint "no_point" "there is no point",
    OnePlace "one_place" "all points are at one place",
    OneLine "one_line" "all points are on one line, at more than one place",
    Equal "equal" "two points are equal",
    OnSide "on_side" "a point lies on a side of the hull",
    OnLastSide "on_last_side" "a point lies on the side that ends at the leftmost corner",
    Leftmost "leftmost" "several points are leftmost",
    Lowest "lowest" "several points are lowest",
    FirstInside "first_inside" "the first point is no corner of the hull",
    Near "near" "plain doubles get a turn wrong",
    ScanOne "scan_one" "to take at most one point off, before the next is added, gives another result",
    ScanByX "scan_by_x" "to sort by x alone gives another result",
    GiftInLine "gift_in_line" "to take any one of the points straight on, and not the last, gives another result",
    GiftLeftmost "gift_leftmost" "to begin at the first leftmost point of the list, and not at the lowest, gives another result",
    Tiny "tiny" "all coordinates are below a millionth of a millionth",
    Area "area" "the hull has more than two corners",
    UpperSide "upper_side" "the hull has a corner above the line from its first to its last one",
    TwoPlaces "two_places" "there are two different points",
    ManyCorners "many_corners" "the hull has more than 8 corners",
    ManyPoints "many_points" "there are more than 100 points",

    NotOutside "not_outside" "the point is not outside of the polygon",
    OnBorder "on_border" "the point lies on a side of the polygon",
    OnSideLine "on_side_line" "the point lies on the line of a side, and outside",
    FirstMet "first_met" "of two corners on a tangent, the further one is met first, from the given corner on",
    LastSide "last_side" "only the last side, from the given corner on, shows that the point is outside",
    TwoTangents "two_tangents" "the two tangents touch different corners",
    GivenTouches "given_touches" "a tangent touches the given corner",
    FewCorners "few_corners" "the polygon has one or two corners",
    OneCorner "one_corner" "the polygon has one corner",
    Large "large" "a polygon has more than 8 corners",

    Single "single" "one of the polygons has one corner",
    Pair "pair" "one of the polygons has one or two corners",
    InLine "in_line" "more than two corners lie on a common tangent",
    AllInLine "all_in_line" "all corners are on one line",
    FromGiven "from_given" "to begin at the given corners gives another result",
    NotPast "not_past" "an inner corner lies on the lower tangent",
    OnceEach "once_each" "for the lower tangent, the first end has to be moved again after the second one",
    Differ "differ" "the two tangents are different",
    SameX "same_x" "the last corner of the first and the first corner of the second polygon are above each other",
    GivenFirst "given_first" "the first given corner is not the last of its polygon, from left to right",
    GivenSecond "given_second" "the second given corner is not the first of its polygon, from left to right",
    GivenGone "given_gone" "the first given corner is no corner of the hull",
    BothGone "both_gone" "no given corner is a corner of the hull",
    LowerTurns "lower_turns" "the lower tangent ends at neither of the two corners between which nothing lies",
    UpperTurns "upper_turns" "the upper tangent ends at neither of the two corners between which nothing lies",
}

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let mut set = FeatureSet::default();
    match exchange.function {
        "gift_wrapping" | "graham_scan" | "hull_by_halves" => {
            of_points(exchange.function, &points(exchange.records_before()?), &mut set);
        }
        "tangents" => of_a_point(exchange, &mut set)?,
        _ => of_two(exchange, &mut set)?,
    }
    Some(set.bits())
}

fn of_points(function: &str, points: &[Point], set: &mut FeatureSet) {
    let hull = hull(points);
    let n = hull.len();
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, q| left_to_right(*p, *q));
    let is_on = |p: &Point, i: usize| *p != hull[i] && *p != hull[(i + 1) % n] && hull::is_on_side(&hull, i, *p);
    // A large set has one feature that says so; the others would take long.
    let few = if points.len() <= 400 { points } else { &[] };
    let other = |found: Vec<Point>| hull::of_corners(&hull, points, &found).is_some();
    let is_few = points.len() <= 400;
    // A mistake of one algorithm says nothing of the other.
    let (is_scan, is_gift) = (is_few && function == "graham_scan", is_few && function == "gift_wrapping");
    set.add(Word::ScanOne, is_scan && other(mistakes::scan(points, Scan::AtMostOne)));
    set.add(Word::ScanByX, is_scan && other(mistakes::scan(points, Scan::ByX)));
    set.add(Word::GiftInLine, is_gift && other(mistakes::gift(points, Gift::AnyInLine)));
    set.add(Word::GiftLeftmost, is_gift && other(mistakes::gift(points, Gift::AnyLeftmost)));
    set.add(Word::Tiny, n > 1 && points.iter().all(|p| p.x.abs() < 1e-12 && p.y.abs() < 1e-12));
    set.add(Word::Area, n > 2);
    set.add(Word::TwoPlaces, n > 1);
    let ends = sorted.first().zip(sorted.last());
    set.add(Word::UpperSide, ends.is_some_and(|(a, b)| hull.iter().any(|p| orientation(*a, *b, *p).is_gt())));
    set.add(Word::NoPoint, points.is_empty());
    set.add(Word::OnePlace, n == 1);
    set.add(Word::OneLine, n == 2);
    set.add(Word::Equal, sorted.windows(2).any(|pair| pair[0] == pair[1]));
    set.add(Word::OnSide, few.iter().any(|p| (0..n).any(|i| is_on(p, i))));
    set.add(Word::OnLastSide, n > 2 && few.iter().any(|p| is_on(p, n - 1)));
    let several = |by: fn(&Point) -> f64| {
        let least = points.iter().map(by).fold(f64::INFINITY, f64::min);
        points.iter().filter(|p| by(p) <= least).count() > 1
    };
    set.add(Word::Leftmost, several(|p| p.x));
    set.add(Word::Lowest, several(|p| p.y));
    set.add(Word::FirstInside, points.first().is_some_and(|p| !hull.contains(p)));
    set.add(Word::Near, points.len() <= 60 && is_near(points));
    set.add(Word::ManyCorners, n > 8);
    set.add(Word::ManyPoints, points.len() > 100);
}

/// Whether plain doubles get the turn of some three points wrong.
fn is_near(points: &[Point]) -> bool {
    let n = points.len();
    let plain = |a: Point, b: Point, c: Point| (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    (0..n).any(|i| {
        (0..n).any(|j| {
            (0..n).any(|k| {
                let [a, b, c] = [points[i], points[j], points[k]];
                plain(a, b, c).partial_cmp(&0.0) != Some(orientation(a, b, c))
            })
        })
    })
}

fn of_a_point(exchange: &Exchange, set: &mut FeatureSet) -> Option<()> {
    let (corners, p) = asked(exchange)?;
    let n = corners.len();
    let tangents = from_point(&corners, p);
    let ends = |i: usize| (corners[i].place, corners[(i + 1) % n].place);
    set.add(Word::NotOutside, tangents.is_none());
    let on_line = |i: usize| n > 1 && orientation(ends(i).0, ends(i).1, p).is_eq();
    let is_on = |i: usize| on_line(i) && is_between(ends(i).0, p, ends(i).1);
    set.add(Word::OnBorder, (0..n).any(is_on));
    set.add(Word::OnSideLine, tangents.is_some() && (0..n).any(on_line));
    set.add(Word::FirstMet, tangents.is_some() && mistakes::first_met(&corners, p) != tangents);
    set.add(Word::LastSide, mistakes::only_last_side(&corners, p));
    set.add(Word::TwoTangents, tangents.is_some_and(|[right, left]| right != left));
    set.add(Word::GivenTouches, tangents.is_some_and(|ends| ends.contains(&corners[0].number)));
    set.add(Word::FewCorners, n < 3);
    set.add(Word::OneCorner, n == 1);
    set.add(Word::Large, n > 8);
    Some(())
}

fn of_two(exchange: &Exchange, set: &mut FeatureSet) -> Option<()> {
    let [first, second] = asked_two(exchange)?;
    let tangents = common(&first, &second)?;
    let all: Vec<Corner> = first.iter().chain(&second).copied().collect();
    let places: Vec<Point> = all.iter().map(|c| c.place).collect();
    let hull = hull(&places);
    let last = *first.iter().max_by(|c, d| left_to_right(c.place, d.place))?;
    let begin = *second.iter().min_by(|c, d| left_to_right(c.place, d.place))?;
    for (word, wrong) in
        [(Word::FromGiven, Walk::FromGiven), (Word::NotPast, Walk::NotPast), (Word::OnceEach, Walk::OnceEach)]
    {
        set.add(word, mistakes::walk_differs(&first, &second, wrong)?);
    }
    set.add(Word::Differ, tangents[0] != tangents[1]);
    set.add(Word::Single, first.len() == 1 || second.len() == 1);
    set.add(Word::Pair, first.len() < 3 || second.len() < 3);
    let place = |number: u32| all.iter().find(|c| c.number == number).map(|c| c.place);
    let in_line = tangents.iter().any(|&[a, b]| {
        let (Some(a), Some(b)) = (place(a), place(b)) else { return false };
        places.iter().filter(|p| orientation(a, b, **p).is_eq()).count() > 2
    });
    set.add(Word::InLine, in_line);
    set.add(Word::AllInLine, hull.len() < 3);
    set.add(Word::SameX, last.place.x >= begin.place.x);
    set.add(Word::GivenFirst, first[0] != last);
    set.add(Word::GivenSecond, second[0] != begin);
    let gone = [first[0], second[0]].map(|c| !hull.contains(&c.place));
    set.add(Word::GivenGone, gone[0]);
    set.add(Word::BothGone, gone[0] && gone[1]);
    let [lower, upper] = tangents.map(|[a, b]| a != last.number && b != begin.number);
    set.add(Word::LowerTurns, lower);
    set.add(Word::UpperTurns, upper);
    set.add(Word::Large, first.len() > 8 || second.len() > 8);
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_said_to_be_what_they_are() {
        let said_of = |function: &str, places: &[[f64; 2]]| {
            let mut set = FeatureSet::default();
            of_points(function, &places.iter().map(|&p| p.into()).collect::<Vec<_>>(), &mut set);
            VOCABULARY.iter().filter(|f| set.has(VOCABULARY, f.id)).map(|f| f.id).collect::<Vec<_>>()
        };
        let said = |places: &[[f64; 2]]| said_of("graham_scan", places);
        assert_eq!(said(&[]), ["no_point"]);
        assert_eq!(said(&[[1., 1.], [1., 1.]]), ["one_place", "equal", "leftmost", "lowest"]);
        assert_eq!(said(&[[0., 0.], [2., 2.], [1., 1.]]), ["one_line", "on_side", "two_places"]);
        assert_eq!(
            said(&[[2., 1.], [0., 0.], [6., 1.], [3., 5.]]),
            ["first_inside", "scan_one", "area", "upper_side", "two_places"]
        );
        // What a scan would do wrong is not said of another algorithm.
        assert_eq!(
            said_of("gift_wrapping", &[[2., 1.], [0., 0.], [6., 1.], [3., 5.]]),
            ["first_inside", "area", "upper_side", "two_places"]
        );
        assert_eq!(
            said(&[[0., 0.], [9., 1.], [4., 4.], [2., 2.]]),
            ["on_side", "on_last_side", "area", "upper_side", "two_places"]
        );
    }
}
