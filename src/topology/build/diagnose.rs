//! What exactly is wrong along an edge, once matching has found that something is.
//!
//! ```text
//!      ●─────────────●         edge 1 2: face 0 runs 1 -> 2, face 1 runs 2 -> 1      fits
//!       \  f0  ^ |  f1         edge 1 2: face 0 runs 1 -> 2, face 1 runs 1 -> 2      mixed winding
//!        \     | v             edge 1 2: face 0, face 1 and face 2                   three faces
//! ```

use super::BuildError;
use super::faces::Faces;

/// One corner, with the ends of its half-edge in increasing order.
#[derive(Clone, Copy)]
struct Use {
    ends: (u32, u32),
    corner: u32,
    forward: bool,
}

/// Names the clash at the first face that does not fit the faces before it.
///
/// That is the first face with a half-edge that an earlier face has already, or with an edge that has two
/// faces already; the report is about its first such corner. If an earlier face at that edge has the same
/// corners in the same cyclic order, it is a repetition; else, if the edge has three faces or more, all of them
/// are named, those that come later, too; else two faces run in the same direction.
///
/// Cost: O(n log n) for n corners. The caller knows that there is a clash.
pub(super) fn clash<F: Faces + ?Sized>(faces: &F) -> BuildError {
    let mut uses = Vec::with_capacity(faces.corners().len());
    let _ = faces.try_for_each_cycle::<()>(|_, _, corners| {
        for (k, &from) in corners.iter().enumerate() {
            let to = corners[(k + 1) % corners.len()];
            let corner = uses.len() as u32;
            uses.push(Use { ends: (from.min(to), from.max(to)), corner, forward: from < to });
        }
        Ok(())
    });
    uses.sort_unstable_by_key(|u| (u.ends, u.corner));
    let misfit = |edge: &[Use]| match edge {
        [_] => None,
        [a, b] => (a.forward == b.forward).then_some(b.corner),
        [a, b, c, ..] => Some(if a.forward == b.forward { b.corner } else { c.corner }),
        [] => None,
    };
    let edge = uses
        .chunk_by(|a, b| a.ends == b.ends)
        .filter_map(|edge| Some((misfit(edge)?, edge)))
        .min_by_key(|&(corner, _)| corner);
    let (corner, edge) = edge.expect("matching found a clash");

    let places = locate(faces, edge);
    let at = places.iter().position(|place| place.corner == corner).expect("the corner is one of the edge");
    let (earlier, misfit) = (&places[..at], &places[at]);
    if let Some(twice) = earlier.iter().find(|place| place.repeats(misfit)) {
        return BuildError::SameFaceTwice { first: twice.face, second: misfit.face };
    }
    let (u, v) = edge[0].ends;
    match places[..] {
        [ref first, ref second] if edge[0].forward => {
            BuildError::MixedWinding { u, v, first: first.face, second: second.face }
        }
        [ref first, ref second] => BuildError::MixedWinding { u: v, v: u, first: first.face, second: second.face },
        _ => BuildError::ThreeFaces { u, v, faces: places.iter().map(|place| place.face).collect() },
    }
}

/// Where a corner is: its face, and its cycle from that corner on.
struct Place {
    corner: u32,
    face: u32,
    outer: bool,
    cycle: Vec<u32>,
}

impl Place {
    /// Whether both are the outer cycles of two faces and have the same corners in the same cyclic order.
    /// Both are known to run along the same edge.
    fn repeats(&self, other: &Self) -> bool {
        let start = self.cycle.iter().position(|&v| v == other.cycle[0]);
        self.outer
            && other.outer
            && self.cycle.len() == other.cycle.len()
            && start.is_some_and(|start| {
                let (tail, head) = self.cycle.split_at(start);
                other.cycle[..head.len()] == *head && other.cycle[head.len()..] == *tail
            })
    }
}

fn locate<F: Faces + ?Sized>(faces: &F, edge: &[Use]) -> Vec<Place> {
    let mut places = Vec::with_capacity(edge.len());
    let mut end = 0;
    let _ = faces.try_for_each_cycle::<()>(|face, cycle, corners| {
        end += corners.len() as u32;
        while let Some(found) = edge.get(places.len()).filter(|found| found.corner < end) {
            places.push(Place { corner: found.corner, face, outer: cycle == 0, cycle: corners.to_vec() });
        }
        if places.len() < edge.len() { Ok(()) } else { Err(()) }
    });
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::PolygonList;

    /// Both run from v0 to v1.
    #[test]
    fn a_face_and_a_hole_with_the_same_corners_are_not_the_same_face_twice() {
        let (triangle, around) = ([0, 1, 2], [3, 4, 5]);
        let [mut hole_last, mut hole_first] = [PolygonList::new(), PolygonList::new()];
        hole_last.push_face(&triangle);
        hole_last.push_face(&around);
        hole_last.push_hole(&triangle);
        hole_first.push_face(&around);
        hole_first.push_hole(&triangle);
        hole_first.push_face(&triangle);
        for faces in [hole_last, hole_first] {
            assert_eq!(clash(&faces), BuildError::MixedWinding { u: 0, v: 1, first: 0, second: 1 });
        }
    }
}
