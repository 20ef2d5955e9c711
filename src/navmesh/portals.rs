//! Portals for an agent that is no point: which it fits through, and how far it keeps off their endpoints.
//!
//! ```text
//!   ▨●──┄┄┄──────┄┄┄──●▨      Of the portal only the part is left whose ends are the radius away from endpoints on a
//!       r          r           border. An endpoint with free ground all round may be passed at any distance.
//! ```
//!
//! Quick, on the mesh as it is, and no promise about what lies between two portals; for that see `inset.rs`.

use super::funnel::{self, Endpoint, Funnel};
use super::nearest::distance;
use super::{NavMesh, Route};
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;

/// How much of a portal is lost at the endpoints, at its start and its end.
fn lost(mesh: &NavMesh, endpoints: [VertexId; 2], radius: f64) -> [f64; 2] {
    endpoints.map(|v| if mesh.is_on_border(v) { radius } else { 0.0 })
}

/// Whether an agent of the radius fits through side `s` of `face`.
pub(super) fn fits(mesh: &NavMesh, face: FaceId, s: usize, radius: f64) -> bool {
    let endpoints = mesh.ends(face, s);
    let [a, b] = endpoints.map(|v| mesh.point(v));
    let width = distance(a, b);
    // No look at the borders where there is room in any case.
    width >= 2.0 * radius || width >= lost(mesh, endpoints, radius).iter().sum()
}

/// Pulls a route straight again, off the endpoints.
pub(super) fn keep_off(mesh: &NavMesh, radius: f64, route: &mut Route, funnel: &mut Funnel) {
    let ([Some(&start), Some(&goal)], true) = ([route.points.first(), route.points.last()], radius > 0.0) else {
        return;
    };
    funnel.start(Endpoint::free(start));
    for portal in route.portal_ends(mesh) {
        let [left, right] = [portal.left, portal.right].map(|v| mesh.point(v));
        let [from_left, from_right] = lost(mesh, [portal.left, portal.right], radius);
        let width = distance(left, right);
        let along = |a: Point, b: Point, way: f64| {
            let t = (way / width).min(1.0);
            Endpoint::free(Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t))
        };
        funnel.pass(along(left, right, from_left), along(right, left, from_right));
    }
    let way = funnel.finish(Endpoint::free(goal));
    route.points = way.iter().map(|endpoint| endpoint.point).collect();
    route.points.dedup();
    if route.points.len() == 1 {
        route.points.push(goal);
    }
    route.corners.clear();
    route.length = funnel::length(&route.points);
}
