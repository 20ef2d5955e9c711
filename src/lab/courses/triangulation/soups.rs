//! What `triangulate` should leave: triangles that cover the polygon and do not overlap.
//!
//! Many triangulations are right. These are the checks, and together they are a proof: all triangles turn left; each side
//! of the polygon is a side of exactly one triangle, and every other side is met once in each direction. So the
//! boundaries of the triangles add up to that of the polygon, and as each triangle covers its places once, so do all
//! together.

use super::geometry::turn;
use super::lists::{cycle, next, place, places, prev};
use crate::checks::faults::{Broken, law, told};
use crate::fault::{Exchange, Fault, FaultKind};
use crate::protocol::{CallEnd, Records, Value};
use std::collections::{BTreeMap, BTreeSet};

/// The test.
pub(super) const TEST: &str = "triangulate";

/// A place that can be compared.
fn key([x, y]: [f64; 2]) -> [u64; 2] {
    // 0 and -0 are the same place.
    [(x + 0.0).to_bits(), (y + 0.0).to_bits()]
}

/// What is wrong with one call.
pub(super) fn judge(exchange: &Exchange) -> Option<Fault> {
    let (&[first], end) = exchange.called? else { return None };
    let fault = |kind, tag: &str, words: String| {
        Fault::new(TEST, kind, exchange.step, ["triangulate", tag], format!("triangulate c{first}: {words}"))
    };
    let values = match end {
        CallEnd::Returned(values) => values,
        end => return Some(fault(FaultKind::of_end(end)?, "end", end.words())),
    };
    let polygon = places(exchange.records_before()?, first)?;
    let returned: Option<Vec<u32>> = values.iter().map(Value::id).collect();
    let Some(returned) = returned else {
        return Some(fault(FaultKind::Wrong, "type", "that is not a list of corners".to_owned()));
    };
    let (tag, words) = wrong(&polygon, exchange.records_after()?, &returned)?;
    Some(fault(FaultKind::Wrong, tag, words))
}

/// What is wrong with the triangles at some corners: a word for it, and a sentence.
fn wrong(polygon: &[[f64; 2]], after: &Records, returned: &[u32]) -> Option<Broken> {
    covers(polygon, after, returned).err()
}

fn covers(polygon: &[[f64; 2]], after: &Records, returned: &[u32]) -> Result<(), Broken> {
    let n = polygon.len();
    let mut seen = BTreeSet::new();
    let mut sides: BTreeMap<[[u64; 2]; 2], u32> = BTreeMap::new();
    let all = || 0..after.len(0) as u32;
    for corner in all() {
        let back = next(after, corner).and_then(|next| prev(after, next));
        law(back == Some(corner), "links", || format!("c{corner}.next.prev is not c{corner}"))?;
    }
    for &corner in returned {
        let corners = told(cycle(after, corner), "cycle", || {
            format!("next leads nowhere, or does not come back, from c{corner}")
        })?;
        law(corners.len() == 3, "size", || {
            format!("the polygon of c{corner}, which is returned, has {} corners", corners.len())
        })?;
        let is_new = corners.iter().all(|&corner| seen.insert(corner));
        law(is_new, "twice", || format!("the triangle of c{corner} is returned twice"))?;
        let [p, q, r] = [0, 1, 2].map(|i| place(after, corners[i]).unwrap_or_default());
        let told = format!("({}, {}), ({}, {}), ({}, {})", p[0], p[1], q[0], q[1], r[0], r[1]);
        let way = turn(p, q, r);
        law(way != 0, "flat", || format!("the triangle {told} is flat: its corners are on one line"))?;
        law(way == 1, "clockwise", || format!("the triangle {told} runs clockwise: it lies outside of the polygon"))?;
        for (a, b) in [(p, q), (q, r), (r, p)] {
            *sides.entry([key(a), key(b)]).or_default() += 1;
        }
    }
    let (count, due) = (returned.len(), n - 2);
    law(count == due, if count < due { "fewer" } else { "more" }, || {
        format!("there are {count} triangles, expected {due}: a polygon of {n} corners has {due}")
    })?;
    let own: BTreeSet<[[u64; 2]; 2]> = (0..n).map(|k| [key(polygon[k]), key(polygon[(k + 1) % n])]).collect();
    let odd = own.iter().any(|side| sides.get(side) != Some(&1))
        || sides.iter().any(|(&[a, b], &times)| times != 1 || !own.contains(&[a, b]) && sides.get(&[b, a]) != Some(&1));
    law(!odd, "cover", || "the triangles do not cover the polygon once: some overlap, or lie outside".to_owned())?;
    all().try_for_each(|corner| {
        law(seen.contains(&corner), "left over", || {
            format!("c{corner} belongs to none of the triangles that are returned")
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::triangulation::geometry::triangles;
    use crate::courses::triangulation::lists::of_places;
    use crate::courses::triangulation::polygons::small;

    #[test]
    fn a_triangulation_passes_and_a_changed_one_does_not() {
        for (name, polygon) in small() {
            let soup: Vec<Vec<[f64; 2]>> = triangles(&polygon).iter().map(|t| t.map(|k| polygon[k]).to_vec()).collect();
            let corners: Vec<u32> = (0..soup.len() as u32).map(|i| 3 * i + 1).collect();
            assert_eq!(wrong(&polygon, &of_places(&soup), &corners), None, "{name}");
            let told =
                |soup: &[Vec<[f64; 2]>], corners: &[u32]| wrong(&polygon, &of_places(soup), corners).map(|w| w.0);
            assert_eq!(told(&soup, &corners[1..]), Some("fewer"), "{name}");
            assert_eq!(told(&soup, &[&corners[..], &[0]].concat()), Some("twice"), "{name}");
            let mut other = soup.clone();
            other[0].reverse();
            assert_eq!(told(&other, &corners), Some("clockwise"), "{name}");
            let mut other = soup.clone();
            other[0] = other[1].clone();
            assert_eq!(told(&other, &corners), Some("cover"), "{name}");
            let mut other = soup.clone();
            other.push(soup[0].clone());
            assert_eq!(told(&other, &corners), Some("left over"), "{name}");
            let mut other = soup.clone();
            other[0][1] = other[0][0];
            assert_eq!(told(&other, &corners), Some("flat"), "{name}");
        }
    }

    #[test]
    fn the_four_triangles_of_a_square_with_both_diagonals_are_too_many() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let [a, b, c, d] = square;
        let wrong = |soup: [[[f64; 2]; 3]; 2]| wrong(&square, &of_places(&soup.map(|t| t.to_vec())), &[0, 3]);
        assert_eq!(wrong([[a, b, c], [a, c, d]]), None);
        assert_eq!(wrong([[a, b, c], [a, b, d]]).map(|w| w.0), Some("cover"));
    }
}
