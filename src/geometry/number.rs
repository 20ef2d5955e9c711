//! How numbers are written into files and messages: exactly, and as short as possible.

use std::fmt;

/// A number with as few digits as bring back the same number; with an exponent where that is shorter to read.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
#[cfg_attr(not(feature = "io"), allow(unreachable_pub))] // public as `io::Number`
pub struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0.0 || (1e-5..1e16).contains(&self.0.abs()) {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}
