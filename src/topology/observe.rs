//! Watching an algorithm.
//!
//! ```text
//!   algorithm ── observe(|| event) ──▶ NoObserver   nothing is made, nothing is kept
//!                                 └──▶ Vec<event>   what a film is drawn from
//! ```

/// Sees what an algorithm does, event by event. What an event is, each algorithm says.
///
/// Observing is monomorphised and an event is made only for who looks: an algorithm with [`NoObserver`] is the algorithm
/// without events.
///
/// ```
/// use dcel_kit::topology::{NoObserver, Observer};
/// fn sum(numbers: &[u32], observer: &mut impl Observer<u32>) -> u32 {
///     let mut sum = 0;
///     for number in numbers {
///         sum += number;
///         observer.observe(|| sum);
///     }
///     sum
/// }
/// let mut sums = Vec::new();
/// assert_eq!(sum(&[1, 2, 4], &mut sums), sum(&[1, 2, 4], &mut NoObserver));
/// assert_eq!(sums, [1, 3, 7]);
/// ```
pub trait Observer<E> {
    /// Something has happened, or is about to happen, as the event says.
    fn observe(&mut self, event: impl FnOnce() -> E);
}

/// Looks at nothing, at no cost.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoObserver;

impl<E> Observer<E> for NoObserver {
    #[inline(always)]
    fn observe(&mut self, _: impl FnOnce() -> E) {}
}

impl<E> Observer<E> for Vec<E> {
    fn observe(&mut self, event: impl FnOnce() -> E) {
        self.push(event());
    }
}
