//! What can be said of a call of lab 06 before it is made, so that failing calls can be told from passing ones.

use super::answers::{asked, is_on_border, path, sleeve_of};
use super::funnel::{Sleeve, shortest};
use super::mesh::{Spot, corridor, is_triangle, neighbours, portals, same, triangles_of, turn};
use super::mistakes::{Beyond, Funnel, walk};
use super::mistakes::{deep_is_longer, funnel_goes_wrong, scan_goes_wrong, takes_0_for_outer, walk_goes_wrong};
use crate::fault::Exchange;
use crate::features::FeatureSet;
use dcel_kit::FaceId;
use dcel_kit::topology::Table;
use std::cmp::Ordering;

crate::features! {
    Same "same" "start and goal are the same",
    OuterAsked "outer_asked" "the outer face is asked for",
    Unreachable "unreachable" "no corridor leads there",
    Reachable "reachable" "a corridor leads there",
    Outside "outside" "the point is in no triangle",
    Corner "corner" "the point is a corner of triangles",
    Border "border" "the point lies on a side of a triangle",
    Inside "inside" "the point lies inside a triangle",
    InLast "in_last" "only the triangle with the greatest number has the point in it",
    Barred "barred" "a wall lies across the straight way to the point",
    ElsewhereStart "elsewhere" "the point is not in the triangle where the walk begins",
    Wall "wall" "a side of the triangle is a wall",
    Walls2 "walls_2" "two sides of the triangle, or more, are walls",
    Three "three" "the triangle has three neighbours",
    OuterNot0 "outer_not_0" "the outer face is not f0",
    TwinNotBeside "twin_not_beside" "f0 is a triangle",
    Blind "blind" "all vertices have the same position",
    StartsOnPortal "start_on_portal" "the start lies on the first portal",
    StartIsEnd "start_is_end" "the start is an end of a portal",
    GoalOnPortal "goal_on_portal" "the goal lies on the last portal",
    GoalIsEnd "goal_is_end" "the goal is an end of a portal",
    NoPortal "no_portal" "there is no portal",
    Straight "straight" "the shortest path has no corner",
    Turns "turns" "the shortest path has a corner",
    Turns1More "turns_1_more" "the shortest path has more than one corner",
    TurnsLeft "turns_left" "the shortest path turns left somewhere",
    TurnsRight "turns_right" "the shortest path turns right somewhere",
    TurnsBoth "turns_both" "the shortest path turns left and right",
    TurnsAtLast "turns_at_last" "the shortest path turns at an end of the last portal",
    TurnsAtFirst "turns_at_first" "the shortest path turns at an end of the first portal",
    Touches "touches" "the shortest path passes an end of a portal without a turn",
    Fan "fan" "several portals in a row have an end in common at which the path turns",
    Fraction "fraction" "a coordinate is not a whole number",
    Many8 "many_8" "there are more than 8 triangles or portals on the way",
    Many2 "many_2" "there are more than 2 triangles or portals on the way",
    TwoWays "two_ways" "the fewest triangles are fewer than those of another way",
    Large "large" "there are more than 1,000 half-edges",
    Apart "apart" "both are triangles, but no corridor leads from one to the other",
    SomePortal "some_portal" "there is a portal",
    SmallerRight "smaller_right" "the right end of a portal has a smaller number than the left one",
    ZeroAcross "zero_across" "f0 or a wall is across a side, and the outer face is not f0",
    OnTheLine "on_the_line" "a point on the line of a side, taken to be beyond it, changes the answer",
    RoundedSide "rounded_side" "rounding turns the sign of a product of differences, and with it the answer",
    DeepLonger "deep_longer" "a search that goes deep first finds a longer corridor",
    KeepsStraight "keeps_straight" "an end of a portal that is straight on would be listed as a corner",
    NeverRound "never_round" "the path goes from one side round ends of the other",
    RoundOne "round_one" "the path goes from one side round two ends of the other",
    GoalJoined "goal_joined" "the goal is not reached from the end of the left chain",
    RoundedTurn "rounded_turn" "rounding turns the sign of a product of differences, and with it the path",
}

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let mut set = FeatureSet::default();
    let asked = asked(exchange);
    if exchange.function == "funnel" {
        add_sleeve(&sleeve_of(exchange)?, &mut set);
        return Some(set.bits());
    }
    let table = exchange.before()?;
    set.add(Word::Large, table.half_edges.len() > 1000);
    set.add(Word::OuterNot0, table.outer_face != Some(FaceId::new(0)));
    set.add(Word::TwinNotBeside, is_triangle(table, 0));
    let first = table.vertices.first().and_then(|row| row.as_ref()?.position);
    set.add(Word::Blind, table.vertices.iter().flatten().all(|row| row.position == first));
    match (exchange.function, &asked.ids[..], &asked.points[..]) {
        ("neighbours", &[f], _) => {
            let count = neighbours(table, f).len();
            set.add(Word::Wall, count < 3);
            set.add(Word::Walls2, count < 2);
            set.add(Word::Three, count == 3);
            set.add(Word::ZeroAcross, takes_0_for_outer(table, f));
        }
        ("corridor", &[start, goal], _) => {
            let way = corridor(table, start, goal);
            set.add(Word::Same, start == goal);
            set.add(Word::OuterAsked, !is_triangle(table, start) || !is_triangle(table, goal));
            set.either(Word::Unreachable, Word::Reachable, way.is_none());
            let both = is_triangle(table, start) && is_triangle(table, goal);
            set.add(Word::Apart, both && way.is_none());
            set.add(Word::DeepLonger, both && deep_is_longer(table, start, goal));
            let steps = way.as_ref().map_or(0, Vec::len);
            set.add(Word::Many2, steps > 2);
            set.add(Word::Many8, steps > 8);
            set.add(Word::TwoWays, way.is_some_and(|way| has_round(table, &way)));
        }
        ("portals", ids, _) => {
            let all = portals(table, ids).unwrap_or_default();
            set.either(Word::NoPortal, Word::SomePortal, all.is_empty());
            set.add(Word::SmallerRight, all.iter().any(|[left, right]| right < left));
            set.add(Word::Many2, ids.len() > 2);
            set.add(Word::Many8, ids.len() > 8);
        }
        ("path", _, &[start, goal]) => {
            let way = path(table, start, goal);
            set.add(Word::Outside, [start, goal].iter().any(|&p| triangles_of(table, p).is_empty()));
            set.add(Word::Same, same(start, goal));
            set.either(Word::Unreachable, Word::Reachable, way.is_none());
            add_point(table, start, &mut set);
            let way = way.unwrap_or_default();
            set.add(Word::Straight, way.len() == 2);
            add_turns(&way, &mut set);
        }
        (_, ids, &[p]) => {
            add_point(table, p, &mut set);
            let goes_wrong = |wrong| match ids {
                &[from] => walk_goes_wrong(table, from, p, wrong),
                _ => scan_goes_wrong(table, p, wrong),
            };
            set.add(Word::OnTheLine, goes_wrong(Beyond::OnTheLine));
            set.add(Word::RoundedSide, goes_wrong(Beyond::Rounded));
            if let &[from] = ids {
                let all = triangles_of(table, p);
                set.add(Word::ElsewhereStart, !all.contains(&from));
                let comes_to_a_wall = walk(table, from, p, Beyond::Exactly).is_some_and(|(_, wall)| wall);
                set.add(Word::Barred, !all.contains(&from) && comes_to_a_wall);
            }
        }
        _ => {}
    }
    Some(set.bits())
}

fn add_point(table: &Table, p: Spot, set: &mut FeatureSet) {
    let all = triangles_of(table, p);
    let on_border = all.iter().any(|&f| is_on_border(table, f, p));
    let at_corner = table.vertices.iter().flatten().any(|row| row.position == Some(p));
    set.add(Word::Outside, all.is_empty());
    set.add(Word::Corner, at_corner);
    set.add(Word::Border, on_border && !at_corner);
    set.add(Word::Inside, !all.is_empty() && !on_border);
    let last = (0..table.faces.len() as u32).rev().find(|&f| is_triangle(table, f));
    set.add(Word::InLast, all.len() == 1 && last == all.first().copied());
}

/// Whether a triangle of a corridor has a neighbour outside of it.
fn has_round(table: &Table, way: &[u32]) -> bool {
    way.iter().any(|&f| neighbours(table, f).iter().any(|g| !way.contains(g)))
}

fn add_turns(path: &[Spot], set: &mut FeatureSet) {
    let turns: Vec<Ordering> = path.windows(3).map(|at| turn(at[0], at[1], at[2])).collect();
    let (left, right) = (turns.contains(&Ordering::Greater), turns.contains(&Ordering::Less));
    set.add(Word::Turns, !turns.is_empty());
    set.add(Word::Turns1More, turns.len() > 1);
    set.add(Word::TurnsLeft, left);
    set.add(Word::TurnsRight, right);
    set.add(Word::TurnsBoth, left && right);
}

fn add_sleeve(sleeve: &Sleeve, set: &mut FeatureSet) {
    let Sleeve { start, goal, portals } = sleeve;
    let path = shortest(sleeve);
    let ends = || portals.iter().flatten();
    let corners = &path[1..path.len().max(2) - 1];
    let on = |portal: Option<&[Spot; 2]>, p: &Spot| portal.is_some_and(|&[a, b]| turn(a, b, *p).is_eq());
    let at = |portal: Option<&[Spot; 2]>| portal.is_some_and(|portal| corners.iter().any(|p| portal.contains(p)));
    let slips = [
        (Word::KeepsStraight, Funnel::KeepsStraight),
        (Word::NeverRound, Funnel::NeverRound),
        (Word::RoundOne, Funnel::RoundOne),
        (Word::GoalJoined, Funnel::GoalJoined),
        (Word::RoundedTurn, Funnel::Rounded),
    ];
    slips.into_iter().for_each(|(word, wrong)| set.add(word, funnel_goes_wrong(sleeve, wrong)));
    set.add(Word::Same, same(*start, *goal));
    set.add(Word::StartsOnPortal, on(portals.first(), start));
    set.add(Word::GoalOnPortal, on(portals.last(), goal));
    set.add(Word::StartIsEnd, ends().any(|end| same(*end, *start)));
    set.add(Word::GoalIsEnd, ends().any(|end| same(*end, *goal)));
    set.add(Word::NoPortal, portals.is_empty());
    set.add(Word::Straight, path.len() == 2);
    add_turns(&path, set);
    set.add(Word::TurnsAtFirst, at(portals.first()));
    set.add(Word::TurnsAtLast, at(portals.last()));
    let between = |pair: &[Spot], end: &Spot| {
        !same(*end, pair[0]) && !same(*end, pair[1]) && turn(pair[0], pair[1], *end).is_eq() && {
            let inside = |axis: usize| (pair[0][axis] - end[axis]) * (pair[1][axis] - end[axis]) <= 0.0;
            inside(0) && inside(1)
        }
    };
    set.add(Word::Touches, path.windows(2).any(|pair| ends().any(|end| between(pair, end))));
    let is_hub = |p: &Spot| portals.windows(2).any(|two| two[0].contains(p) && two[1].contains(p));
    set.add(Word::Fan, corners.iter().any(is_hub));
    set.add(Word::Fraction, ends().chain([start, goal]).flatten().any(|x| x.fract() != 0.0));
    set.add(Word::Many2, portals.len() > 2);
    set.add(Word::Many8, portals.len() > 8);
}
