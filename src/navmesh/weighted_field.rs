//! Fields of distances with costs, on a map of the plane.

use super::links::check;
use super::marks::{CLOSED, ID};
use super::weighted::{Cells, common};
use super::{DistanceField, Link, LinkError, NavMesh, Planner, QueryPoint, Stop};
use crate::ids::{FaceId, FaceMap, VertexId};

impl Planner {
    /// What it costs to get from a place to all vertices, as far as that is no more than `limit`, where a unit of length
    /// in a face costs as much as `costs` says. Links lead from place to place of this mesh.
    ///
    /// Not exact: paths pass sides at their ends and at some points between, so each cost is that of a path and never less
    /// than the least. In trials with costs from 1 to 20 it was 10 % more at most, and 0.1 % on average; where faces that cost
    /// nothing meet thin ones that are dear it can be more. Where all faces cost the same and there are no links it is exact.
    /// On a closed side between two faces each counts for its own side.
    ///
    /// Cost: O(n log n), with some 500 steps for each triangle and up to 3,000 for a thin one, and a look at every side for
    /// the start and for each end of a link.
    ///
    /// # Errors
    /// [`LinkError`].
    ///
    /// # Panics
    /// If `costs` is shorter than [`face_bound`](NavMesh::face_bound).
    ///
    /// ```
    /// use dcel_kit::navmesh::{NavMesh, Planner};
    /// use dcel_kit::{FaceId, FaceMap, VertexId, plane::{Point, Subdivision}};
    /// // Grass below, mud above.
    /// let points = [(0., 0.), (4., 0.), (4., 1.), (0., 1.), (4., 2.), (0., 2.)].map(Point::from);
    /// let mut fields = dcel_kit::topology::PolygonList::new();
    /// [[0, 1, 2, 3], [3, 2, 4, 5]].iter().for_each(|field| fields.push_face(field));
    /// let mesh = NavMesh::new(&Subdivision::from_polygons(points.to_vec(), &fields)?)?;
    /// let mut costs = FaceMap::filled(mesh.face_bound(), 1.0);
    /// costs[FaceId::new(2)] = 3.0;
    /// let field = Planner::new().weighted_distance_field(&mesh, &costs, &[], &mesh.place(points[3])?, f64::INFINITY)?;
    /// // Along the edge between them the lesser cost counts; up the side of the mud the greater.
    /// assert_eq!([2, 5].map(|v| field.distance(VertexId::new(v))), [Some(4.0), Some(3.0)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn weighted_distance_field(
        &mut self,
        mesh: &NavMesh,
        costs: &FaceMap<f64>,
        links: &[Link],
        start: &QueryPoint,
        limit: f64,
    ) -> Result<DistanceField, LinkError> {
        assert!(costs.len() >= mesh.face_bound(), "{} costs for {} faces", costs.len(), mesh.face_bound());
        check(1, links, &[&Stop { layer: 0, place: *start }])?;
        let free = || mesh.faces().filter(|&f| mesh.is_walkable(f));
        let mut field = DistanceField::new(mesh, start, limit);
        if let Some(cost) = common(costs, free()).filter(|&cost| cost > 0.0 && links.is_empty()) {
            let exact = self.distance_field(mesh, start, limit / cost);
            for v in (0..mesh.vertex_bound() as u32).map(VertexId::new) {
                exact.distance(v).into_iter().for_each(|length| field.see(v.number(), cost * length));
            }
            field.work = exact.work;
            return Ok(field);
        }
        let mut cells = Cells::default();
        let mut cell_of = vec![u32::MAX; mesh.face_bound()];
        free().for_each(|f| cell_of[f.index()] = cells.cell(costs[f]));
        let corners: Vec<(VertexId, u32)> = (0..mesh.vertex_bound() as u32)
            .map(VertexId::new)
            .flat_map(|v| {
                // Nobody passes from wedge to wedge.
                let nodes = mesh.wedges(v).into_iter().map(|wedge| {
                    let p = mesh.point(v);
                    let node = cells.node([p.x, p.y, 0.0]);
                    wedge.into_iter().for_each(|f| cells.put(cell_of[f.index()], node));
                    (v, node)
                });
                nodes.collect::<Vec<_>>()
            })
            .collect();
        for f in free() {
            for s in mesh.range(f) {
                let across = mesh.sides[s].across;
                let is_open = across & CLOSED == 0;
                let beyond = FaceId::new(across & ID);
                if !is_open || f < beyond {
                    let ends = mesh.ends(f, s).map(|v| mesh.point(v)).map(|p| [p.x, p.y, 0.0]);
                    let beside = [f, beyond].map(|f| cell_of[f.index()]);
                    cells.side(ends, [Some(beside[0]), is_open.then_some(beside[1])]);
                }
            }
        }
        let mut at = Vec::new();
        let mut stand = |place: &QueryPoint| {
            let node = cells.stop([place.point.x, place.point.y, 0.0]);
            at.clear();
            mesh.add_faces_at(place, &mut at);
            at.iter().for_each(|f| cells.put(cell_of[f.index()], node));
            node
        };
        let first = stand(start);
        let ends: Vec<([u32; 2], f64)> =
            links.iter().map(|link| ([stand(&link.from.place), stand(&link.to.place)], link.cost)).collect();
        ends.into_iter().for_each(|(ends, cost)| cells.jump(ends, cost));
        let (least, work) = cells.spread(first, limit);
        corners.into_iter().for_each(|(v, node)| field.see(v.number(), least[node as usize]));
        field.work = work;
        Ok(field)
    }
}
