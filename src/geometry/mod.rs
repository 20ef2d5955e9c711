//! The ground under all rooms that compute with coordinates.
//!
//! ```text
//!   point.rs  predicates.rs         points, the range in which signs are exact, the signs
//!   expansion.rs                    exact sums and products
//!   interval.rs  double_double.rs   bounds that decide without them most of the time
//!   two.rs                          two doubles at once
//!   number.rs                       numbers as they are written
//!   grouping.rs  both.rs            things by groups: a counting sort; both things of a pair
//!   equal.rs  places.rs             equal points; and all from left to right
//!   threads.rs                      work that threads may share
//!   space.rs  random.rs             vectors in space; numbers that look random
//! ```
//!
//! What is public of it stands in [`plane`](crate::plane).

pub(crate) mod both;
pub(crate) mod double_double;
pub(crate) mod equal;
pub(crate) mod expansion;
pub(crate) mod grouping;
pub(crate) mod interval;
#[cfg(any(feature = "io", feature = "solid"))]
pub(crate) mod number;
pub(crate) mod places;
pub(crate) mod point;
pub mod predicates;
#[cfg(any(feature = "navmesh", feature = "play", feature = "solid", test))]
pub(crate) mod random;
#[cfg(any(feature = "navmesh", feature = "solid"))]
pub(crate) mod space;
pub(crate) mod threads;
pub(crate) mod two;
