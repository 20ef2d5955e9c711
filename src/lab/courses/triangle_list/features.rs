//! What can be said of a call before it is made: the report says which of it all failing calls have in common.

use super::mistakes;
use super::soup::Soup;
use crate::FeatureSet;
use crate::fault::Exchange;
use dcel_kit::topology::View;
use dcel_kit::{HalfEdgeId, VertexId};
use std::collections::BTreeSet;

crate::features! {
    Index "index" "a face names a vertex that does not exist",
    IndexNext "index_next" "a face names the vertex just after the last one",
    Short "short" "a face has fewer than three corners",
    TwoCorners "two_corners" "a face has two corners",
    Twice "twice" "a face has a vertex twice",
    TwiceApart "twice_apart" "a face has a vertex twice, not at corners side by side",
    BadLater "bad_later" "the first face is right, and a later one is not",
    Bad "bad" "a face of the list is wrong",
    OnlyCheck "only_check" "only check_faces can find what is wrong",
    EdgeTwice "edge_twice" "an edge comes twice in the same direction",
    Pinched "pinched" "the border comes to a vertex twice",
    Right "right" "nothing is wrong with the list",
    Empty "empty" "there are no faces",
    Closed "closed" "there are faces and no border",
    Borders "borders" "there are several border cycles",
    Border "border" "there is a border",
    Inner "inner" "two faces share an edge",
    Isolated "isolated" "a vertex has no face",
    Longer "longer" "a face has more than three corners",
    Mixed "mixed" "the half-edges are not numbered face by face",
    Numbered "numbered" "to take the half-edge with the number after it, instead of next, gives another result",
    AnyWay "any_way" "to match half-edges by their two ends, in whatever order, gives another result",
    InOrder "in_order" "to link the border in the order of the numbers of the half-edges inside gives another result",
    Known "known" "a corner of the face knows an outgoing half-edge already",
    Unknown "unknown" "no corner of the face knows an outgoing half-edge yet",
    Later "later" "there are faces already",
    ManyFaces "many_faces" "there are more than 3 faces",
    PastByte "past_byte" "there are more than 255 corners in the list",
    ManyVertices "many_vertices" "there are more than 255 vertices",
    Bits "bits" "a coordinate needs more bits than an f32 has",
    Cells "cells" "the list has 100,352 triangles",
    Many "many" "a face has more than 8 corners",
}

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let mut set = FeatureSet::default();
    if exchange.function == "from_cells" {
        set.add(Word::Cells, true);
        return Some(set.bits());
    }
    let before = exchange.before()?;
    let places = before.vertices.iter().flatten().filter_map(|row| row.position).flatten();
    set.add(Word::Bits, places.into_iter().any(|x| f64::from(x as f32).total_cmp(&x).is_ne()));
    if exchange.function == "add_face" {
        let corners: Vec<u32> = exchange.words.iter().map(|word| word.parse().ok()).collect::<Option<_>>()?;
        let known = corners.iter().any(|&v| before.outgoing(VertexId::new(v)).is_some());
        set.either(Word::Known, Word::Unknown, known);
        set.add(Word::Later, before.faces.len() > 1);
        set.add(Word::Longer, corners.len() > 3);
        set.add(Word::Many, corners.len() > 8);
        return Some(set.bits());
    }
    let soup = match exchange.function {
        "match_twins" | "close_border" => {
            let mixed = (0..before.half_edges.len() as u32).map(HalfEdgeId::new);
            set.add(
                Word::Mixed,
                mixed.zip(1..).any(|(h, after)| before.next(h).is_some_and(|next| next.number() > after)),
            );
            let soup = Soup::of_table(before)?;
            set.add(Word::Numbered, mistakes::numbered_differs(before, &soup));
            set.add(Word::AnyWay, mistakes::any_way_differs(before, &soup));
            set.add(Word::InOrder, mistakes::in_order_differs(before));
            soup
        }
        "check_faces" | "from_faces" => Soup::of_words(before.vertices.len(), exchange.words)?,
        _ => return None,
    };
    list(&soup, &mut set);
    Some(set.bits())
}

fn list(soup: &Soup, set: &mut FeatureSet) {
    let n = soup.vertices;
    let any = |holds: fn(&[u32]) -> bool| soup.faces.iter().any(|face| holds(face));
    let is_bad = |face: &Vec<u32>| !Soup { vertices: n, faces: vec![face.clone()] }.bad_faces().is_empty();
    let bad = soup.faces.iter().position(is_bad);
    let index = soup.faces.iter().flatten().any(|&v| v >= n);
    set.add(Word::Index, index);
    set.add(Word::IndexNext, soup.faces.iter().flatten().any(|&v| v == n));
    set.add(Word::Short, any(|face| face.len() < 3));
    set.add(Word::TwoCorners, any(|face| face.len() == 2));
    set.add(Word::Twice, any(|face| face.iter().collect::<BTreeSet<_>>().len() < face.len()));
    set.add(Word::TwiceApart, any(apart));
    set.add(Word::BadLater, bad.is_some_and(|f| f > 0));
    set.add(Word::Bad, bad.is_some());
    let without_corner = any(<[u32]>::is_empty);
    let only_check = index || without_corner || bad.is_some() && soup.edges_twice().is_empty();
    set.add(Word::OnlyCheck, only_check);
    set.add(Word::Longer, any(|face| face.len() > 3));
    set.add(Word::Many, any(|face| face.len() > 8));
    set.add(Word::Empty, soup.faces.is_empty());
    set.add(Word::ManyFaces, soup.faces.len() > 3);
    set.add(Word::ManyVertices, n > 255);
    set.add(Word::PastByte, soup.faces.iter().map(Vec::len).sum::<usize>() > 255);
    let corners: BTreeSet<u32> = soup.faces.iter().flatten().copied().collect();
    set.add(Word::Isolated, (0..n).any(|v| !corners.contains(&v)));
    if bad.is_some() {
        return;
    }
    let (twice, border) = (!soup.edges_twice().is_empty(), soup.border());
    let pinched = !twice && !soup.pinched().is_empty();
    set.add(Word::EdgeTwice, twice);
    set.add(Word::Pinched, pinched);
    set.add(Word::Right, !twice && !pinched);
    set.add(Word::Closed, border.is_empty() && !soup.faces.is_empty());
    set.add(Word::Border, !border.is_empty());
    set.add(Word::Inner, border.len() < soup.faces.iter().map(Vec::len).sum());
    if !twice && !pinched {
        set.add(Word::Borders, border_cycles(soup) > 1);
    }
}

/// Whether a vertex comes twice, at corners that are not side by side.
fn apart(face: &[u32]) -> bool {
    let n = face.len();
    (0..n).any(|i| (i + 2..n).any(|j| face[i] == face[j] && j - i + 1 < n))
}

fn border_cycles(soup: &Soup) -> usize {
    let right = soup.half_edges();
    let mut left = soup.border();
    let mut cycles = 0;
    while let Some(mut ends) = left.pop_first() {
        cycles += 1;
        while let Some(half_edge) = right.get(&ends).filter(|half_edge| left.remove(&half_edge.next)) {
            ends = half_edge.next;
        }
    }
    cycles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn border_cycles_are_counted() {
        let ring = Soup::new(6, &[[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]]);
        assert_eq!(border_cycles(&ring), 2);
        assert_eq!(border_cycles(&Soup::new(3, &[[0, 1, 2]])), 1);
        assert_eq!(border_cycles(&Soup::new(3, &[[0, 1, 2], [0, 2, 1]])), 0);
    }

    #[test]
    fn corners_side_by_side_are_so_round_the_end_of_the_face_too() {
        assert!(!apart(&[0, 1, 0]) && !apart(&[0, 0, 1]) && apart(&[0, 1, 0, 2]));
    }
}
