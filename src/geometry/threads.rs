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
#[cfg(feature = "parallel")]
pub(crate) fn pieces<T: Send>(to: &mut [T], size: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    use rayon::prelude::*;
    to.par_chunks_mut(size).enumerate().for_each(|(i, piece)| work(i * size, piece));
}

/// Hands out `to` in pieces of `size`, each with the number of its first place.
#[cfg(not(feature = "parallel"))]
pub(crate) fn pieces<T>(to: &mut [T], size: usize, work: impl Fn(usize, &mut [T])) {
    to.chunks_mut(size).enumerate().for_each(|(i, piece)| work(i * size, piece));
}
