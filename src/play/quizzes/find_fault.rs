//! Find the fault: one pointer leads elsewhere. Which one?
//!
//! The faults are those that programs make: a `prev` that was forgotten, a `face` that was not given to all, a twin set one
//! way, an `origin` mistaken for the other end, a representative that stayed behind.

use super::structures::random;
use super::{Dice, Message, Verdict};
use crate::ids::Element;
use crate::play::broken::{POINTERS, faults, get, set};
use crate::play::tables::{find, name};
use crate::topology::{Table, View, violations};

/// A structure with one wrong pointer.
#[derive(Clone, Debug)]
pub(super) struct FindFault {
    pub(super) table: Table,
    level: u32,
    owner: Element,
    pointer: &'static str,
    should_be: String,
}

impl FindFault {
    pub(super) fn new(dice: &mut Dice, level: u32) -> Self {
        let s = random(dice, [1, 3, 5][(level.clamp(1, 3) - 1) as usize]);
        let sound = Table::from_planar_view(&s);
        let half_edges: Vec<Element> = s.half_edges().map(Element::from).collect();
        let vertices: Vec<Element> = s.vertices().map(Element::from).collect();
        let faces: Vec<Element> = s.faces().map(Element::from).collect();
        for _ in 0..1000 {
            let pointer = POINTERS[dice.below(POINTERS.len())];
            let (owners, targets) = match pointer {
                "origin" => (&half_edges, &vertices),
                "face" => (&half_edges, &faces),
                "outgoing" => (&vertices, &half_edges),
                "half_edge" => (&faces, &half_edges),
                _ => (&half_edges, &half_edges),
            };
            let (Some(&owner), Some(&to)) = (dice.pick(owners), dice.pick(targets)) else { continue };
            let mut table = sound.clone();
            let Ok(Some(before)) = set(&mut table, owner, pointer, &to.to_string()) else { continue };
            if before != to && !violations(&table).is_empty() {
                return Self { table, level, owner, pointer, should_be: before.to_string() };
            }
        }
        // Never reached: every second try breaks something. A structure without a `next` is broken for certain.
        let owner = half_edges.first().copied().unwrap_or(crate::ids::HalfEdgeId::new(0).into());
        let mut table = sound;
        let should_be = get(&table, owner, "next").map_or_else(String::new, |to| to.to_string());
        let _ = set(&mut table, owner, "next", "none");
        Self { table, level, owner, pointer: "next", should_be }
    }

    pub(super) fn text(&self) -> String {
        let help = if self.level == 1 { " The broken invariants are listed below." } else { "" };
        format!("One pointer in these tables is wrong. Find it, and click its cell.{help}")
    }

    /// What is broken, once the answer is given or where the level tells it.
    pub(super) fn faults(&self, answered: bool) -> Vec<Message> {
        if answered || self.level == 1 { faults(&self.table) } else { Vec::new() }
    }

    /// A pointer is the right answer if it alone, led elsewhere, mends everything.
    pub(super) fn answer(&self, answer: &str) -> Result<Verdict, String> {
        let (id, pointer) =
            answer.split_once('.').ok_or("click the cell of a pointer, or write it as h3.next".to_owned())?;
        let owner = find(&self.table, id)?;
        let pointer = pointer.trim();
        let known = POINTERS.contains(&pointer) && set(&mut self.table.clone(), owner, pointer, "none").is_ok();
        if !known {
            return Err(format!("{owner} has no pointer `{pointer}`"));
        }
        let right = self.mends(owner, pointer);
        let now = name(get(&self.table, owner, pointer));
        let is = name(get(&self.table, self.owner, self.pointer));
        let fault = format!("{}.{} is {is} and should be {}", self.owner, self.pointer, self.should_be);
        let text = match (right, (owner, pointer) == (self.owner, self.pointer)) {
            (true, true) => format!("right: {fault}"),
            (true, false) => format!("right: another {pointer} of {owner} mends it, too; planted was: {fault}"),
            (false, _) => format!("{owner}.{pointer} = {now} is not the fault; {fault}"),
        };
        Ok(Verdict { right, over: true, text, trail: vec![self.owner] })
    }

    /// Whether some other target of this pointer leaves nothing broken.
    fn mends(&self, owner: Element, pointer: &str) -> bool {
        let (letter, bound) = match pointer {
            "origin" => ('v', self.table.vertex_bound()),
            "face" => ('f', self.table.face_bound()),
            _ => ('h', self.table.half_edge_bound()),
        };
        let mut table = self.table.clone();
        (0..bound)
            .any(|i| set(&mut table, owner, pointer, &format!("{letter}{i}")).is_ok() && violations(&table).is_empty())
    }

    /// The half-edge, vertex or face at fault: for tests.
    #[cfg(test)]
    pub(super) fn planted(&self) -> String {
        format!("{}.{}", self.owner, self.pointer)
    }
}
