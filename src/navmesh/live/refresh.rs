//! The flat view of a map that was edited, read anew where the edit was.
//!
//! ```text
//!   sides   f1 f1 f1 | f2 f2 f2 | f3 f3 f3 f3 | f2 f2 f2 f2      A face that is read again has its sides in a place of
//!                      spent                    new              that size which another has left, or at the end; when
//!                                                                half of all are spent, they close ranks.
//! ```

use crate::ids::{EdgeId, FaceId, VertexId};
use crate::navmesh::marks::{MOST, NONE};
use crate::navmesh::mesh::place_of;
use crate::navmesh::{NavMesh, NavMeshError};
use crate::plane::Subdivision;
use std::collections::BTreeSet;

impl NavMesh {
    /// Makes a record for each number, so that any of them can become a face. O(n), if the map has many holes.
    pub(super) fn make_room_for_edits(&mut self, map: &Subdivision) {
        if self.faces.hole_slot(0).is_some() {
            self.holes.unpack(map, &self.faces);
            self.faces.resize(map.face_bound());
            self.index_all(map);
        }
    }

    /// A piece was cut off the hole `of`.
    pub(super) fn put_hole(&mut self, piece: FaceId, of: FaceId) {
        self.holes.put(&self.faces, piece, of);
    }

    /// A face is gone.
    pub(super) fn forget_hole(&mut self, face: FaceId) {
        self.holes.forget(face);
    }

    /// How many cells were written, and faces visited, by all edits so far.
    pub(super) fn counts(&self) -> [usize; 2] {
        [self.grid.written(), self.visited]
    }

    /// Reads faces anew from the map they come from, after edits there that concern no others; those that have gone are
    /// among them. Says of each whether it is blocked, of edges whether they are walls, and which vertices are new: some are
    /// in holes only. Cost: as for
    /// [`block`](Self::block) of all of them.
    pub(super) fn read_again(
        &mut self,
        map: &Subdivision,
        faces: &[(FaceId, bool)],
        walls: &[(EdgeId, bool)],
        vertices: &[VertexId],
    ) -> Result<(), NavMeshError> {
        if map.vertex_bound() >= MOST || map.half_edge_bound() >= MOST || map.face_bound() >= MOST {
            return Err(NavMeshError::TooMany);
        }
        let mut result = Ok(());
        let ids: Vec<FaceId> = faces.iter().map(|&(f, _)| f).collect();
        let mut corners: BTreeSet<VertexId> = ids.iter().flat_map(|&f| self.corners(f)).collect();
        corners.extend(vertices);
        let mut gone = Vec::new();
        ids.iter().filter(|&&f| self.has_face(f)).for_each(|&f| self.grid.cells_of(self, f, &mut gone));
        self.change(&ids, |mesh| {
            for v in mesh.points.len()..map.vertex_bound() {
                mesh.points.push(place_of(map, VertexId::new(v as u32)));
                mesh.fans.push(NONE);
            }
            mesh.faces.resize(map.face_bound());
            walls.iter().for_each(|&(edge, wall)| mesh.put_wall(edge, wall));
            ids.iter().for_each(|&f| mesh.drop_face(f));
            for &(f, blocked) in faces {
                if !map.has_face(f) || map.is_hole(f) {
                    continue;
                }
                result = result.and(mesh.read_face(map, f));
                if mesh.has_face(f) {
                    mesh.set_blocked(f, blocked);
                    corners.extend(map.incident_vertices(f));
                }
            }
            for v in corners {
                mesh.points[v.index()] = place_of(map, v);
                if map.has_vertex(v) {
                    mesh.find_fans_of(map, v);
                } else {
                    mesh.fans[v.index()] = NONE;
                    mesh.more_fans.remove(&v.number());
                }
            }
            mesh.close_ranks();
        });
        let come: Vec<FaceId> = ids.into_iter().filter(|&f| self.has_face(f)).collect();
        let mut grid = std::mem::take(&mut self.grid);
        let is_mended = grid.mend(self, gone, &come);
        self.grid = grid;
        if !is_mended || self.grid.is_stale() {
            self.index_again(map);
        }
        result
    }

    /// Leaves out the sides that no face has, once they are as many as the others.
    fn close_ranks(&mut self) {
        if 2 * self.spent_sides < self.sides.len() + 64 {
            return;
        }
        let (sides, half_edges) = (std::mem::take(&mut self.sides), std::mem::take(&mut self.half_edges));
        for i in 0..self.faces.len() {
            let range = self.range(FaceId::new(i as u32));
            if range.is_empty() {
                continue;
            }
            self.faces[i].start = self.sides.len() as u32;
            self.sides.extend_from_slice(&sides[range.clone()]);
            self.half_edges.extend_from_slice(&half_edges[range]);
        }
        self.spent_sides = 0;
        self.free_sides.clear();
        self.renumbered = true;
    }
}
