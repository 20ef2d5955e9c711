//! Merged faces and junctions through changes of the mesh: what is near the change is taken out and made anew.
//!
//! ```text
//!   before the edit   merged faces of the near faces fall apart     ┌───────┬───┐      ┌───┬───┬───┐
//!   the edit                                                       │   a   │ b │ ──>  │ · │ f │ · │  f is blocked:
//!   after it          so do those of faces that became or ceased   └───────┴───┘      └───┴───┴───┘  a and b fall apart
//!                     to be dead ends; then loose faces are put together, and marks written anew
//! ```
//!
//! Nothing is done for what has not been made yet. Cost: O(k log k) for k sides of the merged faces, and faces of the
//! corridors, that are taken out or lie beside them.

use super::NavMesh;
use super::junctions::Junctions;
use super::marks::ID;
use super::merged::Merged;
use crate::geometry::grouping::sorted;
use crate::ids::{FaceId, VertexId};
use std::collections::BTreeSet;

/// What is carried through a change.
pub(super) struct Upkeep {
    merged: Option<Merged>,
    junctions: Option<Junctions>,
    /// The faces of merged faces that were taken apart.
    loose: Vec<u32>,
}

impl Upkeep {
    /// Begins a change of faces among the near ones.
    pub(super) fn begin(mesh: &mut NavMesh, near: &BTreeSet<u32>) -> Self {
        let mut upkeep = Self { merged: mesh.merged.take(), junctions: mesh.junctions.take(), loose: Vec::new() };
        mesh.renumbered = false;
        if upkeep.merged.is_some() || upkeep.junctions.is_some() {
            mesh.written = Some(Vec::new());
        }
        if let Some(merged) = &mut upkeep.merged {
            merged.take_apart(mesh, near.iter().copied(), &mut upkeep.loose);
        }
        upkeep
    }

    /// Ends the change: `near` are the faces near it, before and after, and `corners` the vertices whose marks were
    /// written anew.
    pub(super) fn finish(mut self, mesh: &mut NavMesh, near: &BTreeSet<u32>, corners: &BTreeSet<VertexId>) {
        let Some(mut written) = mesh.written.take() else { return };
        // Of each face the first note says what it was before.
        written.sort_by_key(|&(f, _)| f);
        written.dedup_by_key(|&mut (f, _)| f);
        let mut changed: Vec<u32> = near.iter().copied().collect();
        for &(f, was_dead_end) in &written {
            if mesh.is_peeled(f) != was_dead_end {
                changed.push(f);
                changed.extend(mesh.sides_of(FaceId::new(f)).iter().map(|side| side.across & ID));
            }
        }
        changed.retain(|&f| near.contains(&f) || mesh.has_face(FaceId::new(f)));
        let changed = sorted(changed);
        // What names sides by their numbers is lost if these are others.
        if let Some(mut merged) = self.merged.filter(|_| !mesh.renumbered) {
            merged.take_apart(mesh, changed.iter().copied(), &mut self.loose);
            if !merged.is_spent() {
                let around = corners.iter().flat_map(|&v| mesh.faces_around(v)).map(FaceId::number);
                let marked = sorted(written.iter().map(|&(f, _)| f).chain(around).collect());
                self.loose.extend(&changed);
                merged.put_together(mesh, sorted(self.loose));
                marked.into_iter().for_each(|f| merged.mark_again(mesh, f));
                mesh.merged = merged.into();
            }
        }
        if let Some(mut junctions) = self.junctions
            && junctions.mend(mesh, &changed)
        {
            mesh.junctions = junctions.into();
        }
    }
}
