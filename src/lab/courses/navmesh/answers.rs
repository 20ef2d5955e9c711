//! What each function of the lab should answer.
//!
//! ```text
//!   neighbours f    the triangles across the sides, in any rotation     locate p     any triangle with p in it
//!   corridor f g    any with as few triangles as possible               portals      left and right, one by one
//!   funnel, path    the one shortest path: corners bit for bit
//! ```

use super::funnel::{Sleeve, shortest};
use super::mesh::{
    Spot, contains, corners, corridor, distances, is_triangle, neighbours, place, portals, same, sides, triangles_of,
    turn,
};
use crate::answers::{Function, Wrong};
use crate::checks::cyclic::is_rotation;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, VertexId};

/// All functions of the lab.
pub(super) const FUNCTIONS: &[Function] = &[
    Function { word: "neighbours", test: "neighbours", wrong: wrong_neighbours },
    Function { word: "locate_by_scan", test: "locate_by_scan", wrong: wrong_triangle },
    Function { word: "locate", test: "locate", wrong: wrong_triangle },
    Function { word: "corridor", test: "corridor", wrong: wrong_corridor },
    Function { word: "portals", test: "portals", wrong: wrong_portals },
    Function { word: "funnel", test: "funnel", wrong: wrong_funnel },
    Function { word: "path", test: "path", wrong: wrong_path },
];

/// The numbers of a call that are ids, and the points after them.
pub(super) struct Asked {
    pub(super) ids: Vec<u32>,
    pub(super) points: Vec<Spot>,
}

/// What a call asks for, by its words.
pub(super) fn asked(exchange: &Exchange) -> Asked {
    let face = |word: &String| word.strip_prefix('f').and_then(|digits| digits.parse().ok());
    let mut ids: Vec<u32> = exchange.words.iter().map_while(face).collect();
    let numbers: Vec<f64> = exchange.words[ids.len()..].iter().filter_map(|word| word.parse().ok()).collect();
    if exchange.function == "portals" {
        ids = numbers.iter().map(|&x| x as u32).collect();
        return Asked { ids, points: Vec::new() };
    }
    Asked { ids, points: numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect() }
}

/// What a call of `funnel` asks for.
pub(super) fn sleeve_of(exchange: &Exchange) -> Option<Sleeve> {
    let [start, goal, ends @ ..] = &asked(exchange).points[..] else { return None };
    let portals = ends.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
    Some(Sleeve { start: *start, goal: *goal, portals })
}

fn ids(values: &[Value]) -> Option<Vec<u32>> {
    values.iter().map(Value::id).collect()
}

fn numbers(ids: &[u32]) -> Value {
    Value::List(ids.iter().map(|&id| Value::Id(id)).collect())
}

fn wrong_neighbours(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let (table, f) = (exchange.before()?, *asked(exchange).ids.first()?);
    let right = neighbours(table, f);
    let Some(found) = ids(values) else { return Some(Wrong::kind("a list of triangles")) };
    let all = sides(table, f).into_iter().filter_map(|h| table.face(table.twin(h)?)).map(FaceId::number);
    let all: Vec<u32> = all.collect();
    let reversed: Vec<u32> = right.iter().rev().copied().collect();
    let outer = table.outer_face.map(FaceId::number);
    let because = match found.iter().any(|&g| Some(g) == outer) {
        true => "behind a wall there is the outer face, which is no triangle",
        false => "the triangles across the sides, counter-clockwise",
    };
    (!is_rotation(&found, &right) && found != right).then(|| {
        Wrong::value(&numbers(&right), because).is([
            (found == all, "what is across all three sides, the outer face included"),
            (found.len() > 1 && is_rotation(&found, &reversed), "the right ones clockwise"),
            (found.len() + 1 == right.len(), "one too few"),
            (found.iter().all(|&g| g == f), "the triangle itself"),
        ])
    })
}

fn wrong_triangle(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let (table, p) = (exchange.before()?, *asked(exchange).points.first()?);
    let all = triangles_of(table, p);
    let on_border = all.len() > 1 || all.iter().any(|&f| is_on_border(table, f, p));
    match values {
        [Value::Refusal(_)] => {
            let first = *all.first()?;
            let how = if on_border { "on the border of" } else { "in" };
            let wrong = Wrong::because("refused", format!("the point lies {how} f{first}"));
            Some(wrong.is([(on_border, "a refusal, although the point lies on a border")]))
        }
        [Value::Id(f)] if all.contains(f) => None,
        [Value::Id(f)] if !is_triangle(table, *f) => Some(
            Wrong::because("no_triangle", "that is no triangle")
                .is([(table.outer_face == Some(FaceId::new(*f)), "the outer face")]),
        ),
        [Value::Id(f)] => {
            let because = match all.first() {
                Some(right) => format!("the point is not in it; it lies in f{right}"),
                None => "the point is in no triangle, expected a refusal".to_owned(),
            };
            let start = asked(exchange).ids.first() == Some(f);
            Some(Wrong::because("elsewhere", because).is([(start, "the triangle where the walk begins")]))
        }
        _ => Some(Wrong::kind("a triangle or a refusal")),
    }
}

/// Whether a point lies on a side or at a corner of a triangle that contains it.
pub(super) fn is_on_border(table: &Table, f: u32, p: Spot) -> bool {
    let Some([a, b, c]) = corners(table, f).filter(|&corners| contains(corners, p)) else { return false };
    [(a, b), (b, c), (c, a)].iter().any(|&(from, to)| turn(from, to, p).is_eq())
}

fn wrong_corridor(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = exchange.before()?;
    let &[start, goal] = &asked(exchange).ids[..] else { return None };
    let best = corridor(table, start, goal);
    if let [Value::Refusal(_)] = values {
        let best = best?;
        return Some(Wrong::because("refused", format!("there is a corridor: {}", faces(&best))));
    }
    let Some(found) = ids(values) else { return Some(Wrong::kind("a list of triangles, or a refusal")) };
    let Some(best) = best else {
        let wrong =
            Wrong::because("unreachable", format!("no corridor leads from f{start} to f{goal}, expected a refusal"));
        return Some(wrong.is([(found.is_empty(), "an empty list"), (found == [goal], "only the goal")]));
    };
    let is_neighbour = |pair: &[u32]| is_triangle(table, pair[0]) && neighbours(table, pair[0]).contains(&pair[1]);
    let reversed: Vec<u32> = found.iter().rev().copied().collect();
    let holds = [
        (
            reversed == best || reversed.first() == Some(&start) && reversed.last() == Some(&goal) && start != goal,
            "the way back",
        ),
        (found.is_empty(), "an empty list"),
        (found[..] == best[..best.len() - 1] && !found.is_empty(), "a right one without the goal"),
        (found[..] == best[1..] && !found.is_empty(), "a right one without the start"),
    ];
    let wrong = |tag: &str, because: String| Some(Wrong::because(tag, because).is(holds));
    if found.first() != Some(&start) {
        return wrong("start", format!("it should begin with f{start}"));
    }
    if found.last() != Some(&goal) {
        return wrong("goal", format!("it should end with f{goal}"));
    }
    if let Some(pair) = found.windows(2).find(|pair| !is_neighbour(pair)) {
        return wrong("neighbours", format!("f{} is no neighbour of f{}", pair[1], pair[0]));
    }
    let more = found.len() > best.len();
    more.then(|| {
        let because = format!("{} triangles, but {} are enough: {}", found.len(), best.len(), faces(&best));
        Wrong::because("longer", because)
    })
}

fn faces(ids: &[u32]) -> String {
    const NAMED: usize = 12;
    let words: Vec<String> = ids.iter().take(NAMED).map(|f| format!("f{f}")).collect();
    let more = if ids.len() > NAMED { ", …" } else { "" };
    format!("{}{more}", words.join(", "))
}

fn wrong_portals(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let (table, corridor) = (exchange.before()?, asked(exchange).ids);
    let right: Vec<[u32; 2]> =
        portals(table, &corridor)?.into_iter().map(|portal| portal.map(VertexId::number)).collect();
    let Some(found) = values.iter().map(Value::ids).collect::<Option<Vec<[u32; 2]>>>() else {
        return Some(Wrong::kind("a list of portals"));
    };
    if found == right {
        return None;
    }
    let swapped: Vec<[u32; 2]> = right.iter().map(|&[left, right]| [right, left]).collect();
    let at = found.iter().zip(&right).position(|(a, b)| a != b);
    let because = match at {
        _ if found.len() != right.len() => {
            format!("{} triangles have {} portals between them", corridor.len(), right.len())
        }
        Some(i) => format!(
            "from f{} to f{} one passes between v{} on the left and v{} on the right",
            corridor[i],
            corridor[i + 1],
            right[i][0],
            right[i][1]
        ),
        None => String::new(),
    };
    let sorted = |portal: &[u32; 2]| [portal[0].min(portal[1]), portal[0].max(portal[1])];
    Some(Wrong::because(if found.len() == right.len() { "ends" } else { "count" }, because).is([
        (found == swapped, "left and right exchanged, in all portals"),
        (found.iter().map(sorted).eq(right.iter().map(sorted)), "left and right exchanged, in some portals"),
        (found.iter().all(|portal| portal[0] == portal[1]), "the same vertex on both sides"),
    ]))
}

fn points(values: &[Value]) -> Option<Vec<Spot>> {
    values.iter().map(Value::point).collect()
}

fn wrong_funnel(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    wrong_points(&shortest(&sleeve_of(exchange)?), values)
}

fn wrong_points(right: &[Spot], values: &[Value]) -> Option<Wrong> {
    let Some(found) = points(values) else { return Some(Wrong::kind("a list of points")) };
    if found == right {
        return None;
    }
    let expected = Value::List(right.iter().map(|p| Value::Point(p.to_vec())).collect());
    let straight = found.windows(3).find(|at| turn(at[0], at[1], at[2]).is_eq());
    let (tag, because) = if found.first() != right.first() {
        ("start", "it should begin at the start".to_owned())
    } else if found.last() != right.last() {
        ("goal", "it should end at the goal".to_owned())
    } else if found.windows(2).any(|pair| same(pair[0], pair[1])) {
        ("twice", "a point stands there twice in a row".to_owned())
    } else if let Some(at) = straight.filter(|_| right.iter().all(|p| found.contains(p))) {
        ("straight", format!("the path does not turn at ({}, {})", at[1][0], at[1][1]))
    } else {
        ("corners", "the corners of the shortest path".to_owned())
    };
    let missing = right.iter().filter(|p| !found.contains(p)).count();
    let only_missing = found.iter().all(|p| right.contains(p));
    let wrong = Wrong::because(tag, because).is([
        (found.len() == 2 && right.len() > 2, "straight from the start to the goal, without a corner"),
        (found[..] == right[..right.len() - 1], "the right ones without the goal"),
        (only_missing && missing == 1, "one corner too few"),
        (
            missing == 0 && found.len() > right.len(),
            "the right corners and others where the path does not turn, or need not pass",
        ),
    ]);
    Some(Wrong { expected: Some(expected.words()), ..wrong })
}

/// The path from point to point in a mesh in which one corridor leads from triangle to triangle.
pub(super) fn path(table: &Table, start: Spot, goal: Spot) -> Option<Vec<Spot>> {
    let [from, to] = [start, goal].map(|p| triangles_of(table, p));
    let away = distances(table, *from.first()?);
    let to = *to.iter().find(|&&f| away[f as usize].is_some())?;
    let corridor = corridor(table, from[0], to)?;
    let portals = portals(table, &corridor)?.into_iter().map(|portal| portal.map(|v| place(table, v))).collect();
    Some(shortest(&Sleeve { start, goal, portals }))
}

fn wrong_path(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let table = exchange.before()?;
    let &[start, goal] = &asked(exchange).points[..] else { return None };
    let refused = matches!(values, [Value::Refusal(_)]);
    match path(table, start, goal) {
        None if refused => None,
        None => {
            let outside = [start, goal].iter().any(|&p| triangles_of(table, p).is_empty());
            let because = if outside { "one of the points is in no triangle" } else { "no corridor leads there" };
            Some(Wrong::because("no_path", format!("{because}, expected a refusal")))
        }
        Some(_) if refused => Some(Wrong::because("refused", "there is a path")),
        Some(right) => wrong_points(&right, values),
    }
}
