//! Walks that come back to where they began: compared up to the start, and told apart by what went wrong.
//!
//! ```text
//!   expected   a b c d        c d a b   right: it may start anywhere
//!                             d c b a   the other way round
//!                             a b c     the last one is left out         a b c d a   the first one comes twice
//! ```

dcel_kit::named! {
    /// How a walk differs from the right one.
    #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
    pub enum WalkFault {
        /// The right elements in the opposite order.
        Reversed = "they come in clockwise order: the opposite way round",
        /// The right walk, and its first element once more.
        StartRepeated = "the start comes twice: the walk should stop before it comes back to its start",
        /// The right walk, but it stops one early.
        OneMissing = "one is left out: the walk stops one step too early, or begins one too late",
        /// A piece of the right walk, more than one element short.
        StopsEarly = "the walk stops before it has come round",
        /// Nothing at all.
        Empty = "nothing was returned",
        /// The right elements, all once, in another order.
        Disordered = "all are there, but not in the order of the walk",
        /// An element comes more often than it should.
        Repeated = "some come more than once",
        /// Elements that do not belong to the walk.
        Strangers = "some do not belong there",
    }

    /// What is wrong, in words.
    fn words as Display;
}

/// What is wrong with `found` as the closed walk `expected`; `None` if it is that walk from any start.
///
/// Cost: O(n log n) for n elements.
#[must_use]
pub fn compare(found: &[u32], expected: &[u32]) -> Option<WalkFault> {
    if is_rotation(found, expected) {
        return None;
    }
    let reversed: Vec<u32> = expected.iter().rev().copied().collect();
    let (n, m) = (found.len(), expected.len());
    if n == 0 {
        return Some(WalkFault::Empty);
    }
    if is_rotation(found, &reversed) {
        return Some(WalkFault::Reversed);
    }
    if n == m + 1 && found[0] == found[m] && is_rotation(&found[1..], expected) {
        return Some(WalkFault::StartRepeated);
    }
    let [mut sorted, mut wanted] = [found.to_vec(), expected.to_vec()];
    sorted.sort_unstable();
    wanted.sort_unstable();
    if sorted.iter().any(|x| wanted.binary_search(x).is_err()) {
        return Some(WalkFault::Strangers);
    }
    if n < m && is_piece(found, expected) {
        return Some(if n + 1 == m { WalkFault::OneMissing } else { WalkFault::StopsEarly });
    }
    if sorted == wanted {
        return Some(WalkFault::Disordered);
    }
    let too_often = sorted.chunk_by(|a, b| a == b).any(|same| {
        let wanted_times = wanted.partition_point(|&x| x <= same[0]) - wanted.partition_point(|&x| x < same[0]);
        same.len() > wanted_times
    });
    Some(if too_often { WalkFault::Repeated } else { WalkFault::StopsEarly })
}

/// Whether two closed walks are the same up to their start.
#[must_use]
pub fn is_rotation<T: PartialEq>(found: &[T], expected: &[T]) -> bool {
    found.len() == expected.len() && is_piece(found, expected)
}

/// Whether `piece` is a stretch of the closed walk, at most once round. Search by failure links (Knuth, Morris and
/// Pratt, *Fast pattern matching in strings*, 1977), so that long walks of equal elements cost no more.
fn is_piece<T: PartialEq>(piece: &[T], walk: &[T]) -> bool {
    if piece.len() > walk.len() {
        return false;
    }
    let mut border = vec![0; piece.len()];
    for i in 1..piece.len() {
        let mut k = border[i - 1];
        while k > 0 && piece[i] != piece[k] {
            k = border[k - 1];
        }
        border[i] = k + usize::from(piece[i] == piece[k]);
    }
    let mut matched = 0;
    for x in walk.iter().chain(walk) {
        if matched == piece.len() {
            return true;
        }
        while matched > 0 && *x != piece[matched] {
            matched = border[matched - 1];
        }
        matched += usize::from(*x == piece[matched]);
    }
    matched == piece.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_walk_may_start_anywhere_and_every_mistake_has_its_name() {
        use WalkFault as W;
        let walk = [4, 7, 1, 9];
        for (found, fault) in [
            (&[1, 9, 4, 7][..], None),
            (&[4, 7, 1, 9], None),
            (&[9, 1, 7, 4], Some(W::Reversed)),
            (&[7, 4, 9, 1], Some(W::Reversed)),
            (&[1, 9, 4, 7, 1], Some(W::StartRepeated)),
            (&[7, 1, 9], Some(W::OneMissing)),
            (&[9, 4], Some(W::StopsEarly)),
            (&[], Some(W::Empty)),
            (&[4, 1, 7, 9], Some(W::Disordered)),
            (&[4, 7, 1, 1], Some(W::Repeated)),
            (&[4, 4, 7, 7, 1, 1, 9, 9], Some(W::Repeated)),
            (&[4, 7, 1, 8], Some(W::Strangers)),
            (&[4, 1], Some(W::StopsEarly)),
        ] {
            assert_eq!(compare(found, &walk), fault, "{found:?}");
        }
        // A walk that passes an element twice, as round an antenna.
        assert_eq!(compare(&[2, 1, 2, 3], &[1, 2, 3, 2]), None);
        assert_eq!(compare(&[1, 2, 3], &[1, 2, 3, 2]), Some(W::OneMissing));
        assert_eq!(compare(&[1, 2, 2, 3], &[1, 2, 3, 2]), Some(W::Disordered));
        assert_eq!(compare(&[1; 50_000], &[1; 50_001]), Some(W::OneMissing));
        assert_eq!(compare(&[], &[]), None);
    }
}
