//! Which markers a line carries: small drawings at its start, at its corners and at its end.
//!
//! ```text
//!   marker-start ▸────▸────▸ marker-end
//!                 marker-mid
//! ```

use std::rc::Rc;

/// A place on a line where a marker can stand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Stand {
    Start,
    Middle,
    End,
}

/// The ids of the markers at the start, at the corners and at the end.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Markers([Option<Rc<str>>; 3]);

impl Markers {
    /// `key` is `marker` for all places, or the property of one of them; `value` is `none` or `url(#...)`.
    pub(super) fn set(&mut self, key: &str, value: &str) {
        let link = value.strip_prefix("url(").and_then(|rest| rest.split(')').next());
        let id = link.and_then(|link| link.trim_matches(['"', '\'', ' ']).strip_prefix('#'));
        for (own, place) in self.0.iter_mut().zip(["marker-start", "marker-mid", "marker-end"]) {
            if ["marker", place].contains(&key) {
                *own = id.map(Rc::from);
            }
        }
    }

    pub(super) fn at(&self, end: Stand) -> Option<Rc<str>> {
        self.0[end as usize].clone()
    }

    pub(super) fn is_any(&self) -> bool {
        self.0.iter().any(Option::is_some)
    }
}
