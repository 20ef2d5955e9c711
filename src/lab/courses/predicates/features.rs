//! What can be said of a call of lab 01 before it is made.

use super::functions::{SURE, TOLERANCE, apart, orientation, place_in_circle, place_in_triangle, points, products};
use super::map::naive;
use super::sum::{self, ExactSum};
use crate::fault::Exchange;
use crate::features::FeatureSet;

crate::features! {
    Straight "straight" "the points are on one line",
    Left "left" "the points turn left",
    Right "right" "the points turn right",
    NotRight "not_right" "the points do not turn right",
    NotLeft "not_left" "the points do not turn left",
    Bent "bent" "the points are not on one line",
    DoublesWrong "doubles_wrong" "doubles give the wrong sign",
    DoublesZero "doubles_zero" "the formula in doubles gives 0, though the points are not on one line",
    Even "even" "the two products are the same double",
    Opposite "opposite" "the two products have different signs",
    OtherNegative "other_negative" "the product that is subtracted is negative",
    BothNegative "both_negative" "both products are negative",
    Doubt "doubt" "the products differ by less than the error bound",
    OtherNotZero "other_not_zero" "the product that is subtracted is not 0",
    SignOfSum "sign_of_products" "the sum of the two products has another sign than their difference",
    OriginMatters "origin_matters" "the area would be another one if the first point were (0, 0)",
    CoordinatesLose "coordinates_lose" "products of the coordinates themselves have lost digits of the area",
    SmallArea "small_area" "the area is smaller than 1e-9, and not 0",
    Slopes "slopes" "the difference of the slopes has another sign than the area",
    DoublesOpposite "doubles_opposite" "doubles give the wrong sign, and not 0",
    DoublesWrongLarge "doubles_wrong_large" "doubles give the wrong sign, and the products differ by more than 1e-12",
    SureSmall "sure_small" "doubles are sure, and the products differ by less than 1e-12",
    SureRight "sure_right" "doubles are sure that the points turn right",
    SureClose "sure_close" "doubles are sure, and the products agree in their first nine digits",
    RoundedProducts "rounded_products" "the sum of the six products, each rounded, has the wrong sign",
    RoundedDifferences "rounded_differences" "the differences of the coordinates are rounded, and that changes the sign",
    LastProduct "last_product" "it changes the sign to subtract p.y · r.x instead of adding it",
    OnSide "on_side" "the point is on a side",
    OnCorner "on_corner" "the point is a corner",
    OnBoundary "on_boundary" "the point is on the boundary",
    Inside "inside" "the point is inside",
    Outside "outside" "the point is outside",
    OnLine "on_line" "the point is outside, on the line of a side",
    OnlyThird "only_third" "only the side from c to a tells that the point is outside",
    OnLineSecond "on_line_second" "the point is outside, on the line through b and c",
    CornersLeft "corners_left" "the corners run counter-clockwise",
    CornersRight "corners_right" "the corners run clockwise",
    InsideRight "inside_right" "the point is inside, and the corners run clockwise",
    OutsideRight "outside_right" "the point is outside, and the corners run clockwise",
    InBox "in_box" "the point is outside, but within the smallest upright box round the triangle",
    OnCircle "on_circle" "the fourth point is on the circle",
    InCircle "in_circle" "the fourth point is inside the circle",
    OutCircle "out_circle" "the fourth point is outside of the circle",
    OffCircle "off_circle" "the fourth point is not on the circle",
    OffCircleRight "off_circle_right" "the fourth point is not on the circle, and the first three run clockwise",
    CircleMiddle "circle_middle" "it changes the sign of the determinant to add its middle product",
    CircleDiameter "circle_diameter" "the circle with the diameter a c says something else",
    NoNumbers "no_numbers" "there are no numbers",
    SumZero "sum_zero" "the sum is zero",
    SumPositive "sum_positive" "the sum is above zero",
    SumNegative "sum_negative" "the sum is below zero",
    SumLost "sum_lost" "the sum in doubles has the wrong sign",
    SumRounded "sum_rounded" "doubles round on the way to the sum",
    SortedLost "sorted_lost" "the sum in doubles has the wrong sign, also with the smallest numbers first",
    Compensated "compensated" "one further double for all that is missing is not enough",
    SmallestPart "smallest_part" "the smallest part of the exact sum has another sign than the sum",
    LargestLast "largest_last" "the largest number comes last",
    _Numbers3 "numbers_3" "there are more than 3 numbers",
    _Numbers4 "numbers_4" "there are more than 4 numbers",
    _Numbers5 "numbers_5" "there are more than 5 numbers",
    _Numbers8 "numbers_8" "there are more than 8 numbers",
    _Numbers12 "numbers_12" "there are more than 12 numbers",
    _Numbers16 "numbers_16" "there are more than 16 numbers",
    _Numbers64 "numbers_64" "there are more than 64 numbers",
    NotOrigin "not_origin" "the first point is not (0, 0)",
    Fraction "fraction" "a coordinate is not a whole number",
    Negative "negative" "a coordinate is negative",
    Tiny "tiny" "a number is not 0 and smaller than 1e-15",
    Far "far" "a number is larger than 1e8",
}

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let mut set = FeatureSet::default();
    let numbers = exchange.numbers();
    set.add(Word::Tiny, numbers.iter().any(|x| *x != 0.0 && x.abs() < 1e-15));
    set.add(Word::Far, numbers.iter().any(|x| x.abs() > 1e8));
    if exchange.function == "sign_of_sum" {
        add_sum(&mut set, &numbers);
        set.more(VOCABULARY, "numbers_N", numbers.len());
        return Some(set.bits());
    }
    set.add(Word::Fraction, numbers.iter().any(|x| x.fract() != 0.0));
    set.add(Word::Negative, numbers.iter().any(|x| *x < 0.0));
    set.add(Word::NotOrigin, numbers.iter().take(2).any(|x| *x != 0.0));
    match exchange.function {
        "in_triangle" => add_triangle(&mut set, points(exchange)?),
        "in_circle" => add_circle(&mut set, points(exchange)?),
        _ => add_turn(&mut set, points(exchange)?),
    }
    Some(set.bits())
}

fn add_turn(set: &mut FeatureSet, [p, q, r]: [[f64; 2]; 3]) {
    let (truth, doubles, [one, other]) = (orientation(p, q, r), naive(p, q, r), products(p, q, r));
    set.either(Word::Straight, Word::Bent, truth == 0);
    set.either(Word::Left, Word::NotLeft, truth > 0);
    set.either(Word::Right, Word::NotRight, truth < 0);
    set.add(Word::DoublesWrong, doubles != truth);
    set.add(Word::DoublesZero, doubles == 0 && truth != 0);
    set.add(Word::Even, one - other == 0.0);
    set.add(Word::Opposite, one * other < 0.0);
    set.add(Word::OtherNegative, other < 0.0);
    set.add(Word::BothNegative, one < 0.0 && other < 0.0);
    set.add(Word::OtherNotZero, other != 0.0);
    set.add(Word::SignOfSum, sum::sign_of(&[one, other]) != sum::sign_of(&[one, -other]));
    let may_differ = TOLERANCE * (one.abs() + other.abs());
    set.add(Word::OriginMatters, (q[0] * r[1] - q[1] * r[0] - (one - other)).abs() > may_differ);
    set.add(Word::CoordinatesLose, (apart(p, q, r) - (one - other)).abs() > may_differ);
    set.add(Word::SmallArea, doubles != 0 && (one - other).abs() < 1e-9);
    let slope = |to: [f64; 2]| (to[1] - p[1]) / (to[0] - p[0]);
    let slopes = (slope(r) - slope(q)).partial_cmp(&0.0).map_or(0, |sign| sign as i32);
    set.add(Word::Slopes, slopes != doubles);
    let (gap, size) = ((one - other).abs(), one.abs() + other.abs());
    let sure = gap > SURE * size;
    set.add(Word::DoublesOpposite, doubles != truth && doubles != 0);
    set.add(Word::DoublesWrongLarge, doubles != truth && gap > 1e-12);
    set.add(Word::SureSmall, sure && gap <= 1e-12);
    set.add(Word::SureRight, sure && truth < 0);
    set.add(Word::SureClose, sure && gap <= 4e6 * (f64::EPSILON / 2.0) * size);
    let six = [q[0] * r[1], -q[0] * p[1], -p[0] * r[1], -q[1] * r[0], q[1] * p[0], p[1] * r[0]];
    set.add(Word::RoundedProducts, sum::sign_of(&six) != truth);
    set.add(Word::RoundedDifferences, {
        let mut exact = ExactSum::default();
        exact.add_product(q[0] - p[0], r[1] - p[1]);
        exact.add_product(-(q[1] - p[1]), r[0] - p[0]);
        exact.sign() != truth
    });
    set.add(Word::LastProduct, {
        let mut exact = ExactSum::default();
        for (a, b) in [(q[0], r[1]), (-q[0], p[1]), (-p[0], r[1]), (-q[1], r[0]), (q[1], p[0]), (-p[1], r[0])] {
            exact.add_product(a, b);
        }
        exact.sign() != truth
    });
    set.add(Word::Doubt, (one - other).abs() <= 4.0 * (f64::EPSILON / 2.0) * (one.abs() + other.abs()));
}

fn add_triangle(set: &mut FeatureSet, [p, a, b, c]: [[f64; 2]; 4]) {
    let place = place_in_triangle(p, [a, b, c]);
    let clockwise = orientation(a, b, c) < 0;
    let corner = [a, b, c].contains(&p);
    let on_a_line = [(a, b), (b, c), (c, a)].into_iter().any(|(from, to)| orientation(from, to, p) == 0);
    let within = |i: usize| {
        let all = [a[i], b[i], c[i]];
        all.iter().any(|x| *x <= p[i]) && all.iter().any(|x| *x >= p[i])
    };
    set.add(Word::OnCorner, corner);
    set.add(Word::OnSide, place == 0 && !corner);
    set.add(Word::OnBoundary, place == 0);
    set.add(Word::Inside, place > 0);
    set.add(Word::Outside, place < 0);
    set.add(Word::OnLine, place < 0 && on_a_line);
    set.either(Word::CornersRight, Word::CornersLeft, clockwise);
    set.add(Word::InsideRight, clockwise && place > 0);
    set.add(Word::OutsideRight, clockwise && place < 0);
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| orientation(from, to, p));
    set.add(Word::OnlyThird, place < 0 && sides[0] * sides[1] >= 0);
    set.add(Word::OnLineSecond, place < 0 && sides[1] == 0);
    set.add(Word::InBox, place < 0 && within(0) && within(1));
}

fn add_circle(set: &mut FeatureSet, points: [[f64; 2]; 4]) {
    let place = place_in_circle(points);
    let clockwise = orientation(points[0], points[1], points[2]) < 0;
    // Cases have whole coordinates: doubles are exact.
    let [a, b, c, d] = points;
    let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|[x, y]| [x - d[0], y - d[1]]);
    let part = |x: f64, y: f64, one: f64| (x * x + y * y) * one;
    let parts = [part(ax, ay, bx * cy - by * cx), part(bx, by, ax * cy - ay * cx), part(cx, cy, ax * by - ay * bx)];
    let sign = |x: f64| x.partial_cmp(&0.0).map_or(0, |sign| sign as i32);
    set.add(Word::CircleMiddle, sign(parts[0] + parts[1] + parts[2]) != sign(parts[0] - parts[1] + parts[2]));
    set.add(Word::CircleDiameter, sign(-(ax * cx + ay * cy)) != place);
    set.either(Word::OnCircle, Word::OffCircle, place == 0);
    set.add(Word::InCircle, place > 0);
    set.add(Word::OutCircle, place < 0);
    set.add(Word::OffCircleRight, place != 0 && clockwise);
    set.either(Word::CornersRight, Word::CornersLeft, clockwise);
}

fn add_sum(set: &mut FeatureSet, numbers: &[f64]) {
    let sign = sum::sign_of(numbers);
    let plain: f64 = numbers.iter().sum();
    let plain = plain.partial_cmp(&0.0).map_or(0, |sign| sign as i32);
    // Whether a partial sum is not a double.
    let mut so_far = 0.0;
    let mut rounded = false;
    for &x in numbers {
        rounded |= sum::sign_of(&[so_far, x, -(so_far + x)]) != 0;
        so_far += x;
    }
    let exact = grown(numbers, false);
    set.add(Word::SmallestPart, exact.first().map_or(0, |&x| sum::sign_of(&[x])) != sign);
    set.add(Word::Compensated, grown(numbers, true).last().map_or(0, |&x| sum::sign_of(&[x])) != sign);
    let largest = numbers.iter().map(|x| x.abs()).fold(0.0, f64::max);
    set.add(Word::NoNumbers, numbers.is_empty());
    set.add(Word::SumZero, sign == 0);
    set.add(Word::SumPositive, sign > 0);
    set.add(Word::SumNegative, sign < 0);
    let mut sorted = numbers.to_vec();
    sorted.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    set.add(Word::SortedLost, sum::sign_of(&[sorted.iter().sum()]) != sign);
    set.add(Word::SumLost, plain != sign);
    set.add(Word::SumRounded, rounded);
    set.add(Word::LargestLast, numbers.last().is_some_and(|x| x.abs() >= largest));
}

/// The sum in parts that do not overlap, the smallest first (Shewchuk's grow-expansion); or, as a compensated sum has it,
/// all but the largest part as one double.
fn grown(numbers: &[f64], compensated: bool) -> Vec<f64> {
    let mut parts = Vec::<f64>::new();
    for &added in numbers {
        let (mut carry, mut next) = (added, Vec::new());
        for part in parts {
            let total = carry + part;
            let of_part = total - carry;
            let missing = (carry - (total - of_part)) + (part - of_part);
            next.extend((missing != 0.0).then_some(missing));
            carry = total;
        }
        next.extend((carry != 0.0).then_some(carry));
        parts = match next.split_last() {
            Some((&largest, rest)) if compensated => vec![rest.iter().sum(), largest],
            _ => next,
        };
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::random::Random;
    use crate::courses::predicates::points::random_sum;

    #[test]
    fn the_parts_of_a_sum_are_the_sum_and_their_largest_has_its_sign() {
        let mut random = Random::new(3, "parts");
        let mut lost = 0;
        for i in 0..200 {
            let numbers = random_sum(&mut random, 1 + i % 5);
            let (parts, sign) = (grown(&numbers, false), sum::sign_of(&numbers));
            let rest: Vec<f64> = numbers.iter().copied().chain(parts.iter().map(|x| -x)).collect();
            assert_eq!(sum::sign_of(&rest), 0, "{numbers:?}");
            assert_eq!(parts.last().map_or(0, |&x| sum::sign_of(&[x])), sign, "{numbers:?}");
            lost += usize::from(grown(&numbers, true).last().map_or(0, |&x| sum::sign_of(&[x])) != sign);
        }
        assert!((1..200).contains(&lost), "{lost} compensated sums are wrong");
    }
}
