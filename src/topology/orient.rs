//! Which faces must be turned round so that all fit, and whether that is possible at all.
//!
//! ```text
//!    ●──<──●──>──●        f0 and f1 run along their edge in the same direction: one of them is turned.
//!    │ f0  ^ f1  │        From face to face this fixes all faces of a piece but for one choice: the majority
//!    ●──>──●──<──●        stays. If a way round comes back to a face and wants it turned, the way is a
//!                         Moebius strip, and no choice helps.
//! ```

use super::PolygonList;
use crate::geometry::grouping::Groups;

/// A surface with one side: there is no way to turn its faces so that they fit.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "the surface has one side only: faces {} form a Moebius strip, each beside the next and the last beside the first; \
     no turning helps: cut the strip open, or leave one of its faces out",
    list(.band)
)]
pub struct OneSided {
    /// Faces by their numbers in the input, each sharing an edge with the next and the last with the first. Who
    /// goes round them comes back on the other side.
    pub band: Vec<u32>,
}

fn list(faces: &[u32]) -> String {
    const SHOWN: usize = 12;
    let shown: Vec<String> = faces.iter().take(SHOWN).map(u32::to_string).collect();
    let rest = if faces.len() > SHOWN { format!(" ... ({} in all)", faces.len()) } else { String::new() };
    format!("{}{rest}", shown.join(", "))
}

/// A face beside another one.
#[derive(Clone, Copy)]
struct Beside {
    face: u32,
    /// Both run along their edge in the same direction.
    clash: bool,
}

/// The faces to turn round so that no two faces run along an edge in the same direction, in increasing order. Of
/// each connected piece the smaller part is turned; of equal parts the one without the lowest face. Edges with
/// three faces or more say nothing and are passed over; corners may be any numbers.
///
/// Cost: O(n log n) for n corners.
///
/// # Errors
/// [`OneSided`] names a Moebius strip.
///
/// ```
/// use dcel_kit::topology::{PolygonList, faces_to_turn};
/// assert_eq!(faces_to_turn(&PolygonList::from_triangles(&[[0, 1, 2], [1, 2, 3], [1, 4, 2]])), Ok(vec![]));
/// assert_eq!(faces_to_turn(&PolygonList::from_triangles(&[[0, 1, 2], [1, 2, 3], [3, 2, 4]])), Ok(vec![0]));
/// let strip = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]];
/// let one_sided = faces_to_turn(&PolygonList::from_triangles(&strip)).unwrap_err();
/// assert_eq!(one_sided.band.len(), 5);
/// ```
pub fn faces_to_turn(polygons: &PolygonList) -> Result<Vec<u32>, OneSided> {
    let neighbours = neighbours(polygons);
    let count = polygons.face_count();
    // By face: turned or not relative to the first one of its piece, and who was there before.
    let mut turned: Vec<Option<bool>> = vec![None; count];
    let mut from: Vec<u32> = (0..count as u32).collect();
    let mut to_turn = Vec::new();
    let mut piece: Vec<u32> = Vec::new();
    for first in 0..count as u32 {
        if turned[first as usize].is_some() {
            continue;
        }
        piece.clear();
        piece.push(first);
        turned[first as usize] = Some(false);
        let mut done = 0;
        while let Some(&face) = piece.get(done) {
            done += 1;
            let is_turned = turned[face as usize] == Some(true);
            for beside in neighbours.of(face as usize) {
                let wanted = is_turned ^ beside.clash;
                match turned[beside.face as usize] {
                    None => {
                        turned[beside.face as usize] = Some(wanted);
                        from[beside.face as usize] = face;
                        piece.push(beside.face);
                    }
                    Some(is) if is != wanted => return Err(OneSided { band: band(&from, face, beside.face) }),
                    Some(_) => {}
                }
            }
        }
        let minority = piece.iter().filter(|&&face| turned[face as usize] == Some(true)).count() * 2 <= piece.len();
        to_turn.extend(piece.iter().filter(|&&face| turned[face as usize] == Some(minority)));
    }
    to_turn.sort_unstable();
    Ok(to_turn)
}

/// The way from `a` back to where the ways to `a` and `b` part, and on to `b`.
fn band(from: &[u32], a: u32, b: u32) -> Vec<u32> {
    let up = |&face: &u32| Some(from[face as usize]).filter(|&before| before != face);
    let way = |face: u32| std::iter::successors(Some(face), up).collect::<Vec<u32>>();
    let (mut to_a, mut to_b) = (way(a), way(b));
    let mut common = None;
    while to_a.last().is_some_and(|x| to_b.last() == Some(x)) {
        common = to_a.pop();
        to_b.pop();
    }
    to_a.into_iter().chain(common).chain(to_b.into_iter().rev()).collect()
}

/// For each face the faces behind those of its edges that have two faces.
fn neighbours(polygons: &PolygonList) -> Groups<Beside> {
    let mut sides: Vec<((u32, u32), u32, bool)> = Vec::with_capacity(polygons.corner_count());
    for face in 0..polygons.face_count() {
        for corners in polygons.cycles(face) {
            for (i, &from) in corners.iter().enumerate() {
                let to = corners[(i + 1) % corners.len()];
                sides.push(((from.min(to), from.max(to)), face as u32, from < to));
            }
        }
    }
    sides.sort_unstable();
    let mut pairs: Vec<(u32, Beside)> = Vec::with_capacity(sides.len());
    for edge in sides.chunk_by(|a, b| a.0 == b.0) {
        if let [(_, a, forward_a), (_, b, forward_b)] = *edge {
            let clash = forward_a == forward_b;
            pairs.extend([(a, Beside { face: b, clash }), (b, Beside { face: a, clash })]);
        }
    }
    pairs.sort_unstable_by_key(|&(face, beside)| (face, beside.face));
    Groups::new(polygons.face_count(), pairs.into_iter().map(|(face, beside)| (face as usize, beside)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_equal_parts_the_one_with_the_lowest_face_stays() {
        assert_eq!(faces_to_turn(&PolygonList::from_triangles(&[[0, 1, 2], [1, 2, 3]])), Ok(vec![1]));
    }
}
