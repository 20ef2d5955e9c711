//! Ids as text formats write them.

use crate::topology::InnerComponent;
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

/// An inner component by its half-edge or its vertex.
pub(super) struct RingName(pub(super) InnerComponent);

impl fmt::Display for RingName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            InnerComponent::Cycle(h) => h.fmt(f),
            InnerComponent::Isolated(v) => v.fmt(f),
        }
    }
}
