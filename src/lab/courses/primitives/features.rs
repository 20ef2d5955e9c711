//! What can be said of a call before it is made: the report says which of it all failing calls have in common.

use super::reference::{round, turned};
use crate::FeatureSet;
use crate::fault::Exchange;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::View;

crate::features! {
    Spur "spur" "no half-edge moves",
    OneMoves "one_moves" "one half-edge moves",
    SeveralMove "several_move" "several half-edges move",
    Refused "refused" "the split has to be refused",
    Belong "belong" "the split can be made",
    TwoFaces "two_faces" "the new edge lies between two different faces",
    Stored "stored" "the vertex knows a half-edge that moves",
    StoredFace "stored_face" "the face knows a half-edge of the new face",
    Antenna "antenna" "a dangling edge is on the new face",
    Torus "torus" "the surface is a torus",
    Sphere "sphere" "the surface is a sphere",
    Tip "tip" "the half-edge begins at the tip of a spur",
    NoTip "no_tip" "the half-edge does not begin at the tip of a spur",
    OnePiece "one_piece" "there is nothing to cut",
    SquareCells "square_cells" "there are as many rows as columns",
    OneLayer "one_layer" "there is one layer, row or piece",
    NoLayer "no_layer" "there is no layer",
    Many "many" "the face has more than 8 sides",
    Triangle "triangle" "the face has three sides",
    TwoRings "two_rings" "there are two rings or more",
    OneRing "one_ring" "there is one ring",
    PoleBelow "pole_below" "there is a pole below",
    PoleAbove "pole_above" "there is a pole above",
    Open "open" "there is no pole",
}

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let mut set = FeatureSet::default();
    let numbers: Vec<usize> = exchange.words.iter().filter_map(|word| word.parse().ok()).collect();
    if let ("revolve", [_, rows @ ..]) = (exchange.function, exchange.words) {
        let radius_is_0 = |word: Option<&String>| word.and_then(|word| word.parse().ok()) == Some(0.0);
        let ends = [radius_is_0(rows.first()), radius_is_0(rows.iter().rev().nth(1))];
        let rings = rows.len() / 2 - ends.iter().filter(|&&end| end).count();
        set.either(Word::TwoRings, Word::OneRing, rings > 1);
        set.add(Word::PoleBelow, ends[0]);
        set.add(Word::PoleAbove, ends[1]);
        set.add(Word::Open, ends == [false; 2]);
    } else if let [.., last] = numbers[..] {
        set.add(Word::NoLayer, last == 0);
        set.add(Word::OneLayer, last == 1);
        set.add(Word::OnePiece, numbers.iter().all(|&n| n == 1));
        set.add(Word::SquareCells, matches!(numbers[..], [n, m] if n == m));
    }
    let Some(before) = exchange.before() else { return Some(set.bits()) };
    let genus = super::growth::genus(before);
    set.add(Word::Torus, genus == 1);
    set.add(Word::Sphere, genus == 0);
    let ids: Vec<HalfEdgeId> = exchange.called?.0.iter().map(|&id| HalfEdgeId::new(id)).collect();
    match (exchange.function, &ids[..]) {
        ("split_vertex", &[first, last]) => {
            let is_refused = before.origin(first) != before.origin(last);
            set.either(Word::Refused, Word::Belong, is_refused);
            let beside = [first, last].map(|h| before.twin(h).and_then(|twin| before.face(twin)));
            set.add(Word::TwoFaces, !is_refused && beside[0] != beside[1]);
            let mut moved = Vec::new();
            let mut h = first;
            while !is_refused && h != last && moved.len() <= before.half_edges.len() {
                moved.push(h);
                h = turned(before, h)?;
            }
            set.add(Word::Spur, !is_refused && moved.is_empty());
            set.add(Word::OneMoves, moved.len() == 1);
            set.add(Word::SeveralMove, moved.len() > 1);
            set.add(Word::Stored, before.outgoing(before.origin(first)?).is_some_and(|h| moved.contains(&h)));
        }
        ("split_face", &[h1, h2]) => {
            set.either(Word::Refused, Word::Belong, before.face(h1) != before.face(h2));
            if before.face(h1) == before.face(h2) {
                let all = round(before, h2)?;
                let new = &all[..all.iter().position(|&h| h == h1)?];
                set.add(Word::StoredFace, before.half_edge(before.face(h1)?).is_some_and(|h| new.contains(&h)));
                set.add(Word::Antenna, new.iter().any(|&h| before.twin(h).is_some_and(|h| new.contains(&h))));
                set.add(Word::Many, all.len() > 8);
            }
        }
        (_, &[h, ..]) => {
            let sides = round(before, h)?.len();
            set.add(Word::Many, sides > 8);
            set.add(Word::Triangle, sides == 3);
            if exchange.function == "divide" {
                set.either(Word::Tip, Word::NoTip, turned(before, h) == Some(h));
            }
        }
        _ => {}
    }
    Some(set.bits())
}
