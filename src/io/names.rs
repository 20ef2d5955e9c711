//! Ids as text formats write them.

use std::fmt;

/// An id, or `none`.
pub(super) struct Pointer<T>(pub(super) Option<T>);

impl<T: fmt::Display> fmt::Display for Pointer<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Some(id) => id.fmt(f),
            None => f.write_str("none"),
        }
    }
}
