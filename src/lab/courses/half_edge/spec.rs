//! What the two splits should make of a structure, written down once more and independently of the kit's own.
//!
//! ```text
//!            h1 ┌──>──●                       h1 ┌──>──●        split_face(h1, h2):
//!      p1 ──>── ●                      p1 ──>── ●                 a, b  new, twins
//!         one face f           ==>         new │a│b│ f            p1.next = a, a.next = h2
//!               ●                              ● ──<── p2         p2.next = b, b.next = h1
//!    h2 ──<──┘  └──<── p2            h2 ──<──┘                    the cycle of h2 is the new face
//!
//!      p ───he──▶ q                 p ─he─▶ m ──c──▶ q          split_in_half(he): he keeps its origin
//!        ◀───t───             ==>     ◀─x──   ◀──y──            {x, y} = {t, d}: either is right
//! ```
//!
//! Works on tables, because that is what a student's program gives. The table before must obey the laws; the
//! functions refuse one that is too broken to tell what should come of it.

use crate::cases::cycles::{link, row_mut};
use crate::checks::align::New;
use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

dcel_kit::named! {
    /// Whether a face may be split between the origins of two of its half-edges.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    pub enum Legal {
        /// It may.
        Yes = "they are two corners of one face, and no edge of it joins them",
        /// Both are the same half-edge.
        Same = "both are the same half-edge",
        /// They bound different faces.
        DifferentFaces = "they bound different faces",
        /// The second follows the first.
        NextOf = "the second is next of the first, so an edge joins their origins already",
        /// The first follows the second.
        PrevOf = "the second is prev of the first, so an edge joins their origins already",
        /// One of them does not exist, or lacks a pointer that would be needed.
        Unknown = "the structure around them is broken",
    }

    /// The reason, as the end of a sentence about `h1` and `h2`.
    fn because;
}

/// Whether `split_face(h1, h2)` should be carried out.
#[must_use]
pub fn may_split_face(table: &Table, h1: HalfEdgeId, h2: HalfEdgeId) -> Legal {
    let ends = (table.face(h1), table.face(h2), table.next(h1), table.next(h2));
    let (Some(f1), Some(f2), Some(n1), Some(n2)) = ends else { return Legal::Unknown };
    if f1 != f2 {
        Legal::DifferentFaces
    } else if h1 == h2 {
        Legal::Same
    } else if n1 == h2 {
        Legal::NextOf
    } else if n2 == h1 {
        Legal::PrevOf
    } else {
        Legal::Yes
    }
}

/// The structure after a legal `split_face(h1, h2)`; `None` if it is not legal.
#[must_use]
pub fn split_face(before: &Table, h1: HalfEdgeId, h2: HalfEdgeId) -> Option<(Table, New)> {
    if may_split_face(before, h1, h2) != Legal::Yes {
        return None;
    }
    let old = before.face(h1)?;
    let (o1, o2) = (before.origin(h1)?, before.origin(h2)?);
    let (p1, p2) = (before.prev(h1)?, before.prev(h2)?);
    let mut after = before.clone();
    let [a, b] = [0, 1].map(|i| HalfEdgeId::new((before.half_edges.len() + i) as u32));
    let new = FaceId::new(before.faces.len() as u32);
    let row = |origin, twin| HalfEdgeRow {
        origin: Some(origin),
        twin: Some(twin),
        face: Some(old),
        ..HalfEdgeRow::default()
    };
    after.half_edges.extend([Some(row(o1, b)), Some(row(o2, a))]);
    after.faces.push(Some(FaceRow { half_edge: Some(a), ..FaceRow::default() }));
    link(&mut after, p1, a)?;
    link(&mut after, a, h2)?;
    link(&mut after, p2, b)?;
    link(&mut after, b, h1)?;
    let mut at = a;
    for _ in 0..after.half_edges.len() {
        let row = row_mut(&mut after, at)?;
        row.face = Some(new);
        at = row.next?;
        if at == a {
            after.faces.get_mut(old.index())?.as_mut()?.half_edge = Some(b);
            return Some((after, New { half_edges: vec![a, b], faces: vec![new], ..New::default() }));
        }
    }
    None
}

/// Which half of the twin's side is the new one after an edge was split.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TwinSide {
    /// The old twin starts at the midpoint now and stays the twin of `he`.
    Moved,
    /// The old twin keeps its origin and is the twin of the new half-edge after `he`.
    Kept,
}

/// The structure after `split_in_half(he)`: the new half-edges are the one after `he`, and the one on the other
/// side. `None` if the table is too broken.
#[must_use]
pub fn split_in_half(before: &Table, he: HalfEdgeId, side: TwinSide) -> Option<(Table, New)> {
    let t = before.twin(he)?;
    let (p, q) = (before.origin(he)?, before.origin(t)?);
    let mut after = before.clone();
    let [c, d] = [0, 1].map(|i| HalfEdgeId::new((before.half_edges.len() + i) as u32));
    let m = VertexId::new(before.vertices.len() as u32);
    let [from, to] = [p, q].map(|v| before.vertices.get(v.index())?.as_ref()?.position);
    let position = from.zip(to).map(|(from, to)| midpoint(from, to));
    after.vertices.push(Some(VertexRow { position, outgoing: Some(c) }));
    let row =
        |origin, twin, face| HalfEdgeRow { origin: Some(origin), twin: Some(twin), face, ..HalfEdgeRow::default() };
    let rows = match side {
        TwinSide::Moved => [row(m, d, before.face(he)), row(q, c, before.face(t))],
        TwinSide::Kept => [row(m, t, before.face(he)), row(m, he, before.face(t))],
    };
    after.half_edges.extend(rows.map(Some));
    let n = after.next(he)?;
    link(&mut after, he, c)?;
    link(&mut after, c, n)?;
    match side {
        TwinSide::Moved => {
            row_mut(&mut after, t)?.origin = Some(m);
            let before_t = after.prev(t)?;
            link(&mut after, before_t, d)?;
            link(&mut after, d, t)?;
            let end = after.vertices.get_mut(q.index())?.as_mut()?;
            if end.outgoing == Some(t) {
                end.outgoing = Some(d);
            }
        }
        TwinSide::Kept => {
            row_mut(&mut after, he)?.twin = Some(d);
            row_mut(&mut after, t)?.twin = Some(c);
            let after_t = after.next(t)?;
            link(&mut after, t, d)?;
            link(&mut after, d, after_t)?;
        }
    }
    Some((after, New { half_edges: vec![c, d], vertices: vec![m], ..New::default() }))
}

/// The point half-way, by the formula of the handout.
#[must_use]
pub fn midpoint([px, py]: [f64; 2], [qx, qy]: [f64; 2]) -> [f64; 2] {
    [f64::midpoint(px, qx), f64::midpoint(py, qy)]
}
