//! Segments: those that meet at ends, those that cross, and subdivisions of them laid over each other.

use crate::Random;
use crate::inputs::delaunay;
use crate::rows::{Prepared, coasts, edges, rings, work};
use dcel_kit::plane::{ArrangeOptions, Point, Subdivision};
use dcel_kit::topology::Dcel;

/// The edges of a Delaunay triangulation of random points.
pub fn plain() -> Vec<[[f64; 2]; 2]> {
    let input = delaunay(200_000);
    let mut random = Random::new(2);
    let places: Vec<[f64; 2]> = (0..input.vertices).map(|_| [random.unit(), random.unit()]).collect();
    let dcel = Dcel::from_triangles(input.vertices, &input.triangles).expect("a surface").dcel;
    dcel.edges().map(|e| e.half_edges().map(|h| places[dcel.origin(h).index()])).collect()
}

/// Short random segments, with nearly as many crossings.
fn crossing() -> Vec<[Point; 2]> {
    let (count, mut random) = (100_000, Random::new(4));
    let length = 2.0 / f64::from(count).sqrt();
    let mut one = || {
        let p = Point::new(random.unit(), random.unit());
        [p, Point::new(p.x + (random.unit() - 0.5) * 2.0 * length, p.y + (random.unit() - 0.5) * 2.0 * length)]
    };
    (0..count).map(|_| one()).collect()
}

pub fn our_segments() -> Prepared {
    let segments: Vec<[Point; 2]> = plain().into_iter().map(|ends| ends.map(Point::from)).collect();
    work(segments.len(), move || Subdivision::from_segments(&segments).expect("they meet at ends"))
}

pub fn our_crossings() -> Prepared {
    let segments = crossing();
    let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
    work(segments.len(), move || Subdivision::arrange_segments(&segments, &options).expect("all can be split"))
}

/// Tells the crossings as it finds them, by doubles, and builds nothing.
pub fn geo_crossings() -> Prepared {
    let at = |p: Point| geo::coord! { x: p.x, y: p.y };
    let lines: Vec<geo::Line> = crossing().into_iter().map(|[p, q]| geo::Line::new(at(p), at(q))).collect();
    work(lines.len(), move || lines.iter().copied().collect::<geo::sweep::Intersections<_>>().count())
}

pub fn our_overlay() -> Prepared {
    let of = coasts();
    let [a, b] = [rings(&of[0]), rings(&of[1])];
    work(edges(&of), move || a.overlay(&b).expect("not too many"))
}
