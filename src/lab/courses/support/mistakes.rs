//! Usual mistakes of tasks 5 to 7, carried out: does one of them show in a call?
//!
//! Nothing here decides a verdict. A feature of a call says that such a mistake shows in it; if the calls in which it
//! shows are those that fail, the report says so.

use super::model::{Model, Place};
use std::cmp::Ordering::{Equal, Greater};
use std::collections::BTreeSet;

/// How much of a plateau is searched.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Plateau {
    /// The neighbours of the vertex where the climb ends.
    Neighbours,
    /// All of it.
    #[cfg(test)]
    Whole,
}

/// The first vertex of the highest dot product, as doubles have it.
pub(super) fn rounded_scan(model: &Model, d: Place) -> Option<usize> {
    let height = |v: usize| model.place(v).map_or(0.0, |p| (0..3).map(|i| d[i] * p[i]).sum::<f64>());
    model.live().reduce(|kept, v| if height(v) > height(kept) { v } else { kept })
}

/// A climb as task 6 asks for it.
pub(super) fn climb(model: &Model, from: usize, d: Place) -> Vec<usize> {
    std::iter::successors(Some(from), |&v| model.steepest(v, d)).collect()
}

/// Whether a climb by the first neighbour that is higher takes a step that is not the steepest one.
pub(super) fn goes_to_first_higher(model: &Model, from: usize, d: Place) -> bool {
    let mut here = from;
    while let Some(steepest) = model.steepest(here, d) {
        let first = model.neighbours(here).into_iter().find(|&u| model.higher(d, u, here) == Greater);
        let first = first.unwrap_or(steepest);
        if model.higher(d, steepest, first) == Greater {
            return true;
        }
        here = first;
    }
    false
}

/// Where a climb across plateaus ends.
pub(super) fn support(model: &Model, from: usize, d: Place, plateau: Plateau) -> usize {
    let mut here = from;
    loop {
        here = climb(model, here, d).last().copied().unwrap_or(here);
        let (mut open, mut met, mut up) = (vec![here], BTreeSet::from([here]), None);
        while let Some(v) = open.pop().filter(|_| up.is_none()) {
            for u in model.neighbours(v) {
                let goes_on = v == here || plateau != Plateau::Neighbours;
                match model.higher(d, u, here) {
                    Greater => up = up.or(Some(u)),
                    Equal if goes_on && met.insert(u) => open.push(u),
                    _ => {}
                }
            }
        }
        match up {
            Some(higher) => here = higher,
            None => return here,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::solids::{cube, gem};
    use super::*;

    #[test]
    fn the_search_of_whole_plateaus_is_right_and_that_of_neighbours_is_not() {
        let cube = cube("cube", 4).model();
        let up = [0.0, 0.0, 1.0];
        let mut stuck = 0;
        for from in cube.live() {
            let top = cube.highest(up).unwrap();
            assert!(cube.higher(up, support(&cube, from, up, Plateau::Whole), top).is_eq());
            stuck += usize::from(cube.higher(up, support(&cube, from, up, Plateau::Neighbours), top).is_lt());
        }
        assert!(stuck > 0 && stuck < cube.live().count(), "{stuck}");
    }

    #[test]
    fn the_climb_of_the_handout() {
        let gem = gem().model();
        let d = [1.0, 2.0, 5.0];
        assert_eq!(climb(&gem, 0, d), [0, 2, 7]);
        assert!(goes_to_first_higher(&gem, 0, d));
        let far = 2.0_f64.powi(56);
        let near = Model::new(&[[far, 0.0, 0.0], [far, 1.0, 0.0]], &[]);
        assert_eq!((rounded_scan(&near, [far, 1.0, 0.0]), near.highest([far, 1.0, 0.0])), (Some(0), Some(1)));
    }
}
