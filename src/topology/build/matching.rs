//! Which corners are the two halves of one edge, and the numbers of the half-edges.
//!
//! ```text
//!   smaller end   edges met so far
//!       ...
//!       3         -> e9 (3, 4) -> e2 (3, 8)      A half-edge (4, 3) looks in list 3 and finds its twin in e9.
//!       4         -> e5 (4, 7)                   A second (3, 4) finds e9, too: a clash.
//!       ...
//! ```
//!
//! Both halves of an edge look in the same short list; nothing is hashed. There are two ways, with the same
//! answer. When faces that are near each other in the input share vertices, the lists in use stay in the cache,
//! and each half-edge is looked up as it comes: [`streamed`]. When the input jumps about, or when a list grows
//! long because a vertex has very many edges, half-edges are brought together first: [`dealt`](super::dealt).

use super::dealt::dealt;
use super::faces::Faces;
use crate::topology::links::{NONE, TAG};
use std::ops::Range;

/// Searching a list gives up after so many edges.
pub(super) const DEEPEST: usize = 64;
/// Ends a list. Links are tagged once both halves of their edge have been met, so the end must bear a tag.
pub(super) const END: u32 = NONE & !TAG;

/// Why matching stopped.
pub(super) enum Stop {
    /// Two half-edges run in the same direction between the same vertices, or three share an edge.
    Clash,
    /// A list is too long to be searched.
    LongList,
}

/// The numbers of the half-edges: edges in the order in which the corners first meet them, the half met first
/// even.
pub(super) struct Numbers {
    /// By corner: its half-edge.
    pub(super) half_edge: Vec<u32>,
    /// By edge: the corners of its even and its odd half; `NONE` if no face has the odd one.
    pub(super) corners: Vec<[u32; 2]>,
    /// Memory that was needed on the way, to be used again.
    pub(super) spare: [Vec<u32>; 3],
}

/// Numbers the half-edges of `faces`, or finds out that two are in each other's way. O(vertices + corners).
pub(super) fn number<F: Faces + ?Sized>(faces: &F, vertices: usize) -> Result<Numbers, Stop> {
    if is_local(faces.corners(), vertices) {
        match streamed(faces, vertices) {
            Err(Stop::LongList) => {}
            done => return done,
        }
    }
    dealt(faces, vertices)
}

/// Reads one word of each cache line of a range, so that they are at hand when they are wanted out of order:
/// the hardware fetches ahead along straight lines only.
#[inline(always)]
pub(super) fn read_ahead(words: &[u32], range: Range<usize>) {
    const LINE: usize = 16;
    for at in range.step_by(LINE) {
        std::hint::black_box(words.get(at).copied());
    }
}

/// Whether faces that are near each other in the input share vertices, so that the lists in use are in the
/// cache: judged by a piece from the middle of the input. O(1), but for a byte for each vertex.
fn is_local(corners: &[u32], vertices: usize) -> bool {
    const PIECE: usize = 1 << 16;
    let start = (corners.len() / 2).saturating_sub(PIECE / 2);
    let Some(piece) = corners.get(start..start + PIECE) else { return true };
    let mut seen = vec![false; vertices];
    let again = piece.iter().filter(|&&v| std::mem::replace(&mut seen[v as usize], true)).count();
    2 * again >= PIECE
}

/// Looks each half-edge up in the lists as it comes.
pub(super) fn streamed<F: Faces + ?Sized>(faces: &F, vertices: usize) -> Result<Numbers, Stop> {
    /// An edge in the list of its smaller end: its greater end, tagged if the even half starts there, and the
    /// edge met before it.
    struct Node {
        far: u32,
        link: u32,
    }
    let count = faces.corners().len();
    let mut heads = vec![END; vertices];
    let mut nodes = Vec::<Node>::with_capacity(count / 2 + count / 16);
    let mut half_edge = Vec::with_capacity(count);
    let mut corners = Vec::<[u32; 2]>::with_capacity(count / 2 + count / 16);
    faces.try_for_each_half_edge(|corner, from, to| {
        let head = &mut heads[from.min(to) as usize];
        let far = from.max(to) | u32::from(from > to) << 31;
        let mut at = *head;
        let mut depth = 0;
        while at != END {
            let node = &mut nodes[at as usize];
            if (node.far ^ far) & !TAG == 0 {
                if node.far == far || node.link & TAG != 0 {
                    return Err(Stop::Clash);
                }
                node.link |= TAG;
                corners[at as usize][1] = corner;
                half_edge.push(2 * at + 1);
                return Ok(());
            }
            depth += 1;
            if depth > DEEPEST {
                return Err(Stop::LongList);
            }
            at = node.link & !TAG;
        }
        let edge = nodes.len() as u32;
        nodes.push(Node { far, link: *head });
        *head = edge;
        corners.push([corner, NONE]);
        half_edge.push(2 * edge);
        Ok(())
    })?;
    Ok(Numbers { half_edge, corners, spare: [const { Vec::new() }; 3] })
}
