//! Work that two threads may share: at the same time with the feature `parallel`, one after the other without it.
//!
//! ```text
//!   both    a ──┐              pieces   ▒▒▒▒│▒▒▒▒│▒▒▒▒│▒▒      Who does what, and when, changes nothing: each piece of
//!               ├── (A, B)              work │work│work│work      work is given by the input alone, and writes to places
//!           b ──┘                                                 of its own. So the answer is the same, byte by byte.
//! ```

/// Whether there is a second thread: else work need not be prepared for it.
pub(crate) fn are_many() -> bool {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads() > 1;
    #[cfg(not(feature = "parallel"))]
    return false;
}

/// Both pieces of work.
#[cfg(feature = "parallel")]
pub(crate) fn both<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    rayon::join(a, b)
}

/// Both pieces of work.
#[cfg(not(feature = "parallel"))]
pub(crate) fn both<A, B>(a: impl FnOnce() -> A, b: impl FnOnce() -> B) -> (A, B) {
    (a(), b())
}

/// Hands out `to` in pieces of `size`, each with the number of its first place.
pub(crate) fn pieces<T: Send>(to: &mut [T], size: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    pieces_of([to], size, |first, [piece]| work(first, piece));
}

/// The same with columns of one length, of which each piece has the same rows.
pub(crate) fn pieces_of<T: Send, const N: usize>(
    columns: [&mut [T]; N],
    size: usize,
    work: impl Fn(usize, [&mut [T]; N]) + Sync,
) {
    hand_out(columns, 0, size, &work);
}

/// The rows before `at`, and the others.
pub(crate) fn halved<T, const N: usize>(columns: [&mut [T]; N], at: usize) -> [[&mut [T]; N]; 2] {
    let mut parts = columns.map(|column| column.split_at_mut(at));
    [parts.each_mut().map(|part| std::mem::take(&mut part.0)), parts.map(|part| part.1)]
}

fn hand_out<T: Send, const N: usize>(
    columns: [&mut [T]; N],
    first: usize,
    size: usize,
    work: &(impl Fn(usize, [&mut [T]; N]) + Sync),
) {
    let rows = columns.iter().map(|column| column.len()).min().unwrap_or(0);
    if rows == 0 {
        return;
    }
    if rows <= size {
        return work(first, columns);
    }
    let half = rows.div_ceil(size).div_ceil(2) * size;
    let [left, right] = halved(columns, half);
    both(|| hand_out(left, first, size, work), || hand_out(right, first + half, size, work));
}
