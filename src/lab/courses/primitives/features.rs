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
        set.either(Word::TwoRings as u32, Word::OneRing as u32, rings > 1);
        set.add(Word::PoleBelow as u32, ends[0]);
        set.add(Word::PoleAbove as u32, ends[1]);
        set.add(Word::Open as u32, ends == [false; 2]);
    } else if let [.., last] = numbers[..] {
        set.add(Word::NoLayer as u32, last == 0);
        set.add(Word::OneLayer as u32, last == 1);
        set.add(Word::OnePiece as u32, numbers.iter().all(|&n| n == 1));
        set.add(Word::SquareCells as u32, matches!(numbers[..], [n, m] if n == m));
    }
    let Some(before) = exchange.before() else { return Some(set.bits()) };
    let genus = super::growth::genus(before);
    set.add(Word::Torus as u32, genus == 1);
    set.add(Word::Sphere as u32, genus == 0);
    let ids: Vec<HalfEdgeId> = exchange.called?.0.iter().map(|&id| HalfEdgeId::new(id)).collect();
    match (exchange.function, &ids[..]) {
        ("split_vertex", &[first, last]) => {
            let is_refused = before.origin(first) != before.origin(last);
            set.either(Word::Refused as u32, Word::Belong as u32, is_refused);
            let beside = [first, last].map(|h| before.twin(h).and_then(|twin| before.face(twin)));
            set.add(Word::TwoFaces as u32, !is_refused && beside[0] != beside[1]);
            let mut moved = Vec::new();
            let mut h = first;
            while !is_refused && h != last && moved.len() <= before.half_edges.len() {
                moved.push(h);
                h = turned(before, h)?;
            }
            set.add(Word::Spur as u32, !is_refused && moved.is_empty());
            set.add(Word::OneMoves as u32, moved.len() == 1);
            set.add(Word::SeveralMove as u32, moved.len() > 1);
            set.add(Word::Stored as u32, before.outgoing(before.origin(first)?).is_some_and(|h| moved.contains(&h)));
        }
        ("split_face", &[h1, h2]) => {
            set.either(Word::Refused as u32, Word::Belong as u32, before.face(h1) != before.face(h2));
            if before.face(h1) == before.face(h2) {
                let all = round(before, h2)?;
                let new = &all[..all.iter().position(|&h| h == h1)?];
                set.add(Word::StoredFace as u32, before.half_edge(before.face(h1)?).is_some_and(|h| new.contains(&h)));
                set.add(Word::Antenna as u32, new.iter().any(|&h| before.twin(h).is_some_and(|h| new.contains(&h))));
                set.add(Word::Many as u32, all.len() > 8);
            }
        }
        (_, &[h, ..]) => {
            let sides = round(before, h)?.len();
            set.add(Word::Many as u32, sides > 8);
            set.add(Word::Triangle as u32, sides == 3);
            if exchange.function == "divide" {
                set.either(Word::Tip as u32, Word::NoTip as u32, turned(before, h) == Some(h));
            }
        }
        _ => {}
    }
    Some(set.bits())
}
