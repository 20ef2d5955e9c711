//! What merging two faces should leave, and what merging all of them should.
//!
//! ```text
//!   the face on the left of h    h a b c                   the corners of the two, h and its twin t left out,
//!   the face on its right        t x y         ──▶  a b c x y     are the corners of the one that stays
//! ```

use super::counts::euler_of;
use super::surface::Surface;
use crate::answers::Wrong;
use crate::checks::duals;
use crate::checks::faults::named;
use crate::fault::Exchange;
use crate::protocol::Value;
use dcel_kit::topology::{HalfEdgeRow, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

/// The surface without the edge of `h`; nothing if one face lies on both sides.
pub(super) fn merged(surface: &Surface, h: HalfEdgeId) -> Option<Surface> {
    let twin = surface.table.twin(h)?;
    let (stays, goes) = (surface.table.face(h)?, surface.table.face(twin)?);
    if stays == goes {
        return None;
    }
    let from = |f: FaceId, first: HalfEdgeId| {
        let mut round = surface.of_face(f);
        let at = round.iter().position(|&h| h == first)?;
        round.rotate_left(at);
        Some(round.split_off(1))
    };
    let mut round = from(stays, h)?;
    round.extend(from(goes, twin)?);
    let mut after = surface.clone();
    let rows = &mut after.table.half_edges;
    for (i, &g) in round.iter().enumerate() {
        let (next, prev) = (round[(i + 1) % round.len()], round[(i + round.len() - 1) % round.len()]);
        let row = rows[g.index()].as_mut()?;
        (row.next, row.prev, row.face) = (Some(next), Some(prev), Some(stays));
    }
    (rows[h.index()], rows[twin.index()]) = (None, None);
    after.table.faces[goes.index()] = None;
    after.table.faces[stays.index()].as_mut()?.half_edge = round.first().copied();
    for v in [surface.table.origin(h)?, surface.table.origin(twin)?] {
        let other = after.half_edges().find(|&g| after.table.origin(g) == Some(v));
        after.table.vertices[v.index()].as_mut()?.outgoing = other;
    }
    Some(after)
}

pub(super) fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let before = Surface::of(exchange.records_before()?);
    let h = HalfEdgeId::new(*exchange.called?.0.first()?);
    let after = Surface::of(exchange.records_after()?);
    let Some(expected) = merged(&before, h) else {
        let face = before.table.face(h)?;
        let [Value::Refusal(named)] = values else {
            let because = format!("{face} lies on both sides of h{}, so the answer is an Err", h.number());
            return Some(Wrong::because("accepted", because));
        };
        if *named != format!("f{}", face.number()) {
            return Some(Wrong::because("names", format!("the face on both sides of h{} is {face}", h.number())));
        }
        let changed = after != before;
        return changed
            .then(|| Wrong::because("changed", "the call is refused, and something has changed all the same"));
    };
    if let [Value::Refusal(_)] = values {
        return Some(Wrong::because("refused", "two different faces lie on the sides of that edge"));
    }
    if !values.is_empty() {
        return Some(Wrong::kind("nothing"));
    }
    rows(&expected, &after).or_else(|| elements(&expected, &after)).or_else(|| duals::representatives("", &after.table))
}

/// The first half-edge that is not as it should be.
fn rows(expected: &Surface, after: &Surface) -> Option<Wrong> {
    let lengths = |surface: &Surface| [surface.points.len(), surface.table.half_edges.len(), surface.table.faces.len()];
    if lengths(expected) != lengths(after) {
        return Some(Wrong::because("lengths", "a record was added, or taken out of its list"));
    }
    let pairs = (0_u32..).zip(expected.table.half_edges.iter().zip(&after.table.half_edges));
    for (h, (wanted, own)) in pairs {
        match (wanted, own) {
            (None, Some(_)) => return Some(Wrong::because("left", format!("h{h} was not removed"))),
            (Some(_), None) => return Some(Wrong::because("gone", format!("h{h} was removed"))),
            (Some(wanted), Some(own)) if wanted != own => return Some(field(h, wanted, own)),
            _ => {}
        }
    }
    None
}

/// What differs in a half-edge.
fn field(h: u32, wanted: &HalfEdgeRow, own: &HalfEdgeRow) -> Wrong {
    let fields = [
        ("next", named(own.next), named(wanted.next)),
        ("prev", named(own.prev), named(wanted.prev)),
        ("twin", named(own.twin), named(wanted.twin)),
        ("face", named(own.face), named(wanted.face)),
        ("origin", named(own.origin), named(wanted.origin)),
    ];
    let all: Vec<&str> = fields.iter().filter(|(_, own, wanted)| own != wanted).map(|(name, ..)| *name).collect();
    let (name, own, wanted) = fields.iter().find(|(_, own, wanted)| own != wanted).unwrap_or(&fields[0]);
    Wrong::because(&all.join("."), format!("the {name} of h{h} is {own}, expected {wanted}"))
}

/// Vertices and faces that should be there, or should not.
fn elements(expected: &Surface, after: &Surface) -> Option<Wrong> {
    if expected.points != after.points {
        return Some(Wrong::because("moved", "a vertex was moved"));
    }
    let pairs = (0..).zip(expected.table.faces.iter().zip(&after.table.faces));
    for (f, (wanted, own)) in pairs {
        match (wanted, own) {
            (None, Some(_)) => return Some(Wrong::because("face_left", format!("f{f} was not removed"))),
            (Some(_), None) => return Some(Wrong::because("face_gone", format!("f{f} was removed"))),
            _ => {}
        }
    }
    None
}

/// Merging all faces: one is left, the edges are some of those that there were, and nothing else was lost.
pub(super) fn wrong_all(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let before = Surface::of(exchange.records_before()?);
    let expected = euler_of(&before) == 2;
    let [Value::Truth(found)] = values else { return Some(Wrong::kind("yes or no")) };
    if *found != expected {
        let because = if expected { "the surface has no handle" } else { "the surface has a handle" };
        return Some(Wrong { tag: "answer".to_owned(), ..Wrong::value(&Value::Truth(expected), because) });
    }
    let after = Surface::of(exchange.records_after()?);
    let faces: Vec<FaceId> = after.faces().collect();
    let [face] = faces[..] else {
        return Some(Wrong::because("faces", format!("{} faces are left, expected one", faces.len())));
    };
    if before.points != after.points || before.table.half_edges.len() != after.table.half_edges.len() {
        return Some(Wrong::because("lengths", "a record was added or taken out of its list, or a vertex was moved"));
    }
    for h in after.half_edges() {
        let same = |row: &Surface| (row.table.origin(h).map(VertexId::number), row.table.twin(h));
        if same(&before) != same(&after) {
            return Some(Wrong::because("edges", format!("{h} has another origin or twin than before")));
        }
        if after.table.next(h).and_then(|next| after.table.prev(next)) != Some(h) {
            return Some(Wrong::because("links", format!("the prev of the next of {h} is not {h}")));
        }
    }
    let round = after.of_face(face).len();
    let left = after.half_edges().count();
    if round != left {
        let because = format!("{left} half-edges are left, and the walk round {face} comes to {round}");
        return Some(Wrong::because("round", because));
    }
    let wanted = before.half_edges().count() - 2 * (before.faces().count() - 1);
    if left != wanted {
        let because = format!("{} edges are left, expected {}", left / 2, wanted / 2);
        return Some(Wrong::because("count", because));
    }
    duals::representatives("", &after.table)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::shapes;

    #[test]
    fn every_merge_keeps_the_euler_number_until_one_face_is_left() {
        for (name, faces) in shapes::all() {
            let mut surface = shapes::blind(&faces);
            let euler = euler_of(&surface);
            loop {
                let after = surface.half_edges().find_map(|h| merged(&surface, h));
                let Some(after) = after else { break };
                assert_eq!(euler_of(&after), euler, "{name}");
                assert_eq!(duals::representatives("", &after.table), None, "{name}");
                let corners: usize = after.faces().map(|f| after.of_face(f).len()).sum();
                assert_eq!(corners, after.half_edges().count(), "{name}: every half-edge is on one face");
                surface = after;
            }
            assert_eq!(surface.faces().count(), 1, "{name}");
            let edges = surface.half_edges().count() / 2;
            assert_eq!(edges + 1 == surface.points.len(), euler == 2, "{name}: a tree is left of a sphere only");
        }
    }
}
