//! Which faces hang together by open sides.
//!
//! ```text
//!   ┌───┬───┐  ┌───┐
//!   │ 0 │ 0 │  │ 1 │      "There is no path" is proved by two numbers that differ.
//!   └───┴───┘  └───┘
//! ```

use super::marks::{CLOSED, ID, NONE};
use super::mesh::{ComponentId, NavMesh};
use crate::ids::FaceId;

impl NavMesh {
    /// The component of `f`; `None` if nobody may stand in it. O(1).
    #[must_use]
    pub fn component(&self, f: FaceId) -> Option<ComponentId> {
        let face = self.faces.get(f.index())?;
        (face.component != NONE).then_some(ComponentId(face.component))
    }

    /// The components, in the order of their numbers, each with the number of its faces.
    pub fn components(&self) -> impl Iterator<Item = (ComponentId, usize)> + '_ {
        let numbered = self.component_sizes.iter().enumerate();
        numbered.filter(|&(_, &size)| size > 0).map(|(c, &size)| (ComponentId(c as u32), size as usize))
    }

    /// The number of components. O(number of components).
    #[must_use]
    pub fn component_count(&self) -> usize {
        self.components().count()
    }

    /// The faces of a component in the order of their numbers. O(number of all faces).
    pub fn component_faces(&self, component: ComponentId) -> impl Iterator<Item = FaceId> + '_ {
        self.faces().filter(move |&f| self.component(f) == Some(component))
    }

    /// Numbers all components anew, in the order of their first faces. O(n).
    pub(super) fn label_components(&mut self) {
        self.component_sizes.clear();
        self.free_components.clear();
        self.faces.iter_mut().for_each(|face| face.component = NONE);
        for f in 0..self.faces.len() as u32 {
            if self.is_walkable(FaceId::new(f)) && self.faces[f as usize].component == NONE {
                let number = self.component_sizes.len() as u32;
                self.component_sizes.push(0);
                self.flood(f, number);
            }
        }
    }

    /// Gives the number to `f` and to all that can be reached from there through faces with other numbers.
    pub(super) fn flood(&mut self, f: u32, number: u32) {
        let mut stack = vec![f];
        while let Some(f) = stack.pop() {
            if self.faces[f as usize].component != number {
                self.set_component(f, number);
                let open = self.sides_of(FaceId::new(f)).iter().filter(|side| side.across & CLOSED == 0);
                stack.extend(open.map(|side| side.across & ID));
            }
        }
    }

    pub(super) fn set_component(&mut self, f: u32, component: u32) {
        if self.faces[f as usize].component == component {
            return;
        }
        self.visited += 1;
        let before = std::mem::replace(&mut self.faces[f as usize].component, component);
        if let Some(size) = self.component_sizes.get_mut(before as usize) {
            *size -= 1;
            if *size == 0 {
                self.free_components.insert(before);
            }
        }
        if let Some(size) = self.component_sizes.get_mut(component as usize) {
            *size += 1;
            if *size == 1 {
                self.free_components.remove(&component);
            }
        }
    }
}
