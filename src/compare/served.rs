//! What `url(#...)` paints: a gradient or a pattern, and what is painted where it is not there.
//!
//! ```text
//!   url(#missing)    nothing         url(#missing) red    red         url(#there) red    what servers.rs has read
//! ```

use super::colour::{Paint, paint};
use std::collections::BTreeMap;

/// What one gradient or pattern paints.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Server {
    pub(super) paint: Paint,
    /// Whether it paints nothing on what has no width or no height: its numbers are parts of the box round it.
    pub(super) by_box: bool,
}

/// All gradients and patterns of a file, by id.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Servers(pub(super) BTreeMap<String, Server>);

/// A paint as it was written, worked out.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Served {
    pub(super) paint: Paint,
    /// What is painted instead on what has no width or no height, if that is something else.
    pub(super) flat: Option<Paint>,
    /// Whether it is a gradient or a pattern.
    pub(super) is_server: bool,
}

impl Servers {
    /// The value of `fill` or `stroke`: a colour, or `url(#...)` with what is painted where that is not there.
    pub(super) fn paint(&self, text: &str) -> Served {
        let plain = |paint| Served { paint, flat: None, is_server: false };
        let text = text.trim();
        let Some((link, rest)) =
            text.get(..4).filter(|start| start.eq_ignore_ascii_case("url(")).and_then(|_| text[4..].split_once(')'))
        else {
            return plain(paint(text));
        };
        let fallback = if rest.trim().is_empty() { Paint::None } else { paint(rest) };
        let id = link.trim_matches(['"', '\'', ' ']).strip_prefix('#');
        match id.and_then(|id| self.0.get(id)) {
            Some(server) => Served { paint: server.paint, flat: server.by_box.then_some(fallback), is_server: true },
            None => plain(fallback),
        }
    }
}
