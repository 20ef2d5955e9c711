//! Something of both things of a pair.

/// What a function gives for each of the two.
///
/// In loops that are passed a million times it takes the place of `array::map`, which not every way to build the kit writes out
/// on the spot: a fifth of the instructions of an overlay were calls of it.
#[inline(always)]
pub(crate) fn of_both<T, U>([a, b]: [T; 2], mut of: impl FnMut(T) -> U) -> [U; 2] {
    let a = of(a);
    [a, of(b)]
}
