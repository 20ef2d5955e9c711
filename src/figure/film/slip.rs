//! An assignment that is forgotten, or that writes something else.

use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::topology::{Change, Slot};
use std::fmt;
use std::str::FromStr;

/// An assignment of an edit that goes wrong.
///
/// ```
/// use dcel_kit::figure::Slip;
/// let forgotten: Slip = "h13.next".parse()?;
/// let another: Slip = "h13.next = h4".parse()?;
/// assert_eq!(forgotten.to_string(), "h13.next");
/// assert_eq!(another.to_string(), "h13.next = h4");
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Slip {
    /// The pointer that should be written.
    pub slot: Slot,
    /// What is written instead; nothing: the assignment is left out.
    pub instead: Option<Element>,
}

impl fmt::Display for Slip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.instead {
            Some(target) => write!(f, "{} = {target}", self.slot),
            None => write!(f, "{}", self.slot),
        }
    }
}

/// A pointer, and after `=` what is written to it instead.
impl FromStr for Slip {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (slot, target) = text.split_once('=').map_or((text, None), |(slot, target)| (slot, Some(target.trim())));
        let slot = self::slot(slot.trim())?;
        let instead = target.map(|target| self::target(slot, target)).transpose()?;
        Ok(Self { slot, instead })
    }
}

fn slot(text: &str) -> Result<Slot, String> {
    let unknown = || {
        format!(
            "`{text}` is no pointer that an edit writes: write h6.next, h6.prev, h6.origin, h6.face, v0.outgoing or f1.half_edge"
        )
    };
    let (element, pointer) = text.split_once('.').ok_or_else(unknown)?;
    let half_edge = |slot: fn(HalfEdgeId) -> Slot| element.parse().map(slot).map_err(|_| unknown());
    match pointer {
        "next" => half_edge(Slot::Next),
        "prev" => half_edge(Slot::Prev),
        "origin" => half_edge(Slot::Origin),
        "face" => half_edge(Slot::Face),
        "outgoing" => element.parse().map(Slot::Outgoing).map_err(|_| unknown()),
        "half_edge" => element.parse().map(Slot::HalfEdge).map_err(|_| unknown()),
        _ => Err(unknown()),
    }
}

/// What a pointer of this kind may lead to.
fn target(slot: Slot, text: &str) -> Result<Element, String> {
    let (kind, found) = match slot {
        Slot::Origin(_) => ("vertex, such as v3", text.parse::<VertexId>().ok().map(Element::from)),
        Slot::Face(_) => ("face, such as f1", text.parse::<FaceId>().ok().map(Element::from)),
        _ => ("half-edge, such as h5", text.parse::<HalfEdgeId>().ok().map(Element::from)),
    };
    found.ok_or_else(|| format!("{slot} leads to a {kind}, not to `{text}`"))
}

impl Slip {
    /// The change as it is made with the slip; nothing if it is left out.
    pub(super) fn of(slips: &[Self], change: &Change) -> Option<Change> {
        match *change {
            Change::Write { slot, old, .. } => match slips.iter().find(|slip| slip.slot == slot) {
                Some(slip) => slip.instead.map(|target| Change::Write { slot, old, new: Some(target) }),
                None => Some(*change),
            },
            other => Some(other),
        }
    }

    /// In words, if it is among the changes of a step.
    pub(super) fn in_step(self, changes: &[Change]) -> Option<String> {
        let written = changes.iter().rev().find_map(|change| match *change {
            Change::Write { slot, new, .. } if slot == self.slot => Some(new),
            _ => None,
        })?;
        let right = written.map_or_else(|| "none".to_owned(), |target| target.to_string());
        Some(match self.instead {
            Some(target) => format!("{} = {target} instead of {right}", self.slot),
            None => format!("left out: {} = {right}", self.slot),
        })
    }
}
