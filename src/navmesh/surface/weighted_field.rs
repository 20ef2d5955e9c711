//! Fields of distances with costs, on a surface.

use super::super::links::{LinkError, checked_costs};
use super::super::weighted::{Cells, common};
use super::{NONE, NavSurface, SurfaceField, SurfaceLink, SurfacePlanner, SurfacePoint};
use crate::ids::{FaceMap, VertexId};

impl SurfacePlanner {
    /// What it costs to get from a place to all vertices, along the surface and over links, as far as that is no more than
    /// `limit`, where a unit of length in a face costs as much as `costs` says. As good and as dear as
    /// [in the plane](super::super::Planner::weighted_distance_field).
    ///
    /// # Errors
    /// [`LinkError`].
    ///
    /// # Panics
    /// If `costs` is shorter than [`face_bound`](NavSurface::face_bound).
    pub fn weighted_distance_field(
        &mut self,
        surface: &NavSurface,
        costs: &FaceMap<f64>,
        links: &[SurfaceLink],
        start: &SurfacePoint,
        limit: f64,
    ) -> Result<SurfaceField, LinkError> {
        assert!(costs.len() >= surface.face_bound(), "{} costs for {} faces", costs.len(), surface.face_bound());
        checked_costs(links.iter().map(|link| link.cost))?;
        if let Some(cost) = common(costs, surface.faces()).filter(|&cost| cost > 0.0 && links.is_empty()) {
            let mut field = self.distance_field(surface, start, limit / cost);
            (0..field.lengths.len() as u32).for_each(|v| field.lengths[VertexId::new(v)] *= cost);
            return Ok(field);
        }
        let mut cells = Cells::default();
        for &p in &surface.points {
            cells.node(p);
        }
        for t in 0..surface.triangle_count() {
            let cell = cells.cell(costs[surface.face_of(t)]);
            (3 * t..3 * t + 3).for_each(|s| cells.put(cell, surface.sides[s].origin));
        }
        for s in 0..surface.sides.len() {
            let twin = surface.sides[s].twin;
            if twin == NONE || (s as u32) < twin {
                let beside = [s as u32 / 3, twin / 3];
                cells.side(surface.ends(s), [Some(beside[0]), (twin != NONE).then_some(beside[1])]);
            }
        }
        let mut stand = |place: &SurfacePoint| {
            let node = cells.stop(place.point);
            surface.triangles_at(place).into_iter().for_each(|t| cells.put(t as u32, node));
            node
        };
        let first = stand(start);
        let ends: Vec<([u32; 2], f64)> =
            links.iter().map(|link| ([stand(&link.from), stand(&link.to)], link.cost)).collect();
        ends.into_iter().for_each(|(ends, cost)| cells.jump(ends, cost));
        let (least, work) = cells.spread(first, limit);
        Ok(SurfaceField::over(surface, work, |node| least[node]))
    }
}
