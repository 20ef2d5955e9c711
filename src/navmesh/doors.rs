//! Doors for an agent that is no point: which it fits through, and how far it keeps off their posts.
//!
//! ```text
//!   ▨●──┄┄┄──────┄┄┄──●▨      Of the door only the part is left whose ends are the radius away from posts on a
//!       r          r           border. A post with free ground all round may be passed at any distance.
//! ```
//!
//! Quick, on the mesh as it is, and no promise about what lies between two doors; for that see `inset.rs`.

use super::funnel::{self, Funnel, Post};
use super::nearest::distance;
use super::{NavMesh, Route};
use crate::ids::{FaceId, VertexId};
use crate::plane::Point;

/// How much of a door is lost at the posts, at its start and its end.
fn lost(mesh: &NavMesh, posts: [VertexId; 2], radius: f64) -> [f64; 2] {
    posts.map(|v| if mesh.is_on_border(v) { radius } else { 0.0 })
}

/// Whether an agent of the radius fits through side `s` of `face`.
pub(super) fn fits(mesh: &NavMesh, face: FaceId, s: usize, radius: f64) -> bool {
    let posts = mesh.ends(face, s);
    let [a, b] = posts.map(|v| mesh.point(v));
    let width = distance(a, b);
    // No look at the borders where there is room in any case.
    width >= 2.0 * radius || width >= lost(mesh, posts, radius).iter().sum()
}

/// Pulls a route straight again, off the posts.
pub(super) fn keep_off(mesh: &NavMesh, radius: f64, route: &mut Route, funnel: &mut Funnel) {
    let ([Some(&start), Some(&goal)], true) = ([route.points.first(), route.points.last()], radius > 0.0) else {
        return;
    };
    funnel.start(Post::free(start));
    for portal in route.portals(mesh) {
        let [left, right] = [portal.left, portal.right].map(|v| mesh.point(v));
        let [from_left, from_right] = lost(mesh, [portal.left, portal.right], radius);
        let width = distance(left, right);
        let along = |a: Point, b: Point, way: f64| {
            let t = (way / width).min(1.0);
            Post::free(Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t))
        };
        funnel.pass(along(left, right, from_left), along(right, left, from_right));
    }
    let way = funnel.finish(Post::free(goal));
    route.points = way.iter().map(|post| post.point).collect();
    route.points.dedup();
    if route.points.len() == 1 {
        route.points.push(goal);
    }
    route.corners.clear();
    route.length = funnel::length(&route.points);
}
