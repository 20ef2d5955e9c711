//! The flat view of a map that was edited, read anew where the edit was.
//!
//! ```text
//!   sides   f1 f1 f1 | f2 f2 f2 | f3 f3 f3 f3 | f2 f2 f2 f2      A face that is read again has its sides at the end;
//!                      spent                    new              when half of all are spent, they close ranks.
//! ```

use crate::ids::{EdgeId, FaceId, VertexId};
use crate::navmesh::mesh::{FaceRecord, MOST, NONE, place_of};
use crate::navmesh::{NavMesh, NavMeshError};
use crate::plane::Subdivision;
use std::collections::BTreeSet;

impl NavMesh {
    /// Reads faces anew from the map they come from, after edits there that concern no others; those that have gone are
    /// among them. Says of each whether it is blocked, and of edges whether they are walls. Cost: as for
    /// [`block`](Self::block) of all of them.
    pub(super) fn read_again(
        &mut self,
        map: &Subdivision,
        faces: &[(FaceId, bool)],
        walls: &[(EdgeId, bool)],
    ) -> Result<(), NavMeshError> {
        if map.vertex_bound() >= MOST || map.half_edge_bound() >= MOST || map.face_bound() >= MOST {
            return Err(NavMeshError::TooMany);
        }
        let mut result = Ok(());
        let ids: Vec<FaceId> = faces.iter().map(|&(f, _)| f).collect();
        let mut corners: BTreeSet<VertexId> = ids.iter().flat_map(|&f| self.corners(f)).collect();
        self.change(&ids, |mesh| {
            for v in mesh.points.len()..map.vertex_bound() {
                mesh.points.push(place_of(map, VertexId::new(v as u32)));
                mesh.fans.push(NONE);
            }
            mesh.faces.resize(map.face_bound().max(mesh.faces.len()), FaceRecord::ABSENT);
            walls.iter().for_each(|&(edge, wall)| mesh.put_wall(edge, wall));
            for &(f, blocked) in faces {
                mesh.spent_sides += mesh.range(f).len();
                mesh.faces[f.index()] = FaceRecord::ABSENT;
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
        let mut grid = std::mem::take(&mut self.grid);
        ids.iter().filter(|&&f| self.has_face(f)).for_each(|f| grid.add(self, f.number()));
        self.grid = grid;
        if self.grid.is_stale() {
            self.index_all(map);
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
        self.renumbered = true;
    }
}
