//! What the handouts draw: the judges begin with it, and so do the figures.

use dcel_kit::plane::Point;

/// The sites of labs 07 and 08.
pub const SITES: [[f64; 2]; 12] = [
    [-180.0, -110.0],
    [-40.0, -150.0],
    [120.0, -120.0],
    [210.0, -20.0],
    [150.0, 110.0],
    [10.0, 150.0],
    [-150.0, 120.0],
    [-230.0, 10.0],
    [-60.0, -20.0],
    [60.0, 40.0],
    [-50.0, 70.0],
    [80.0, -60.0],
];

/// The points of lab 03; tangents are drawn from the last one.
pub const POINTS: [[f64; 2]; 15] = [
    [-250.0, -60.0],
    [-110.0, -150.0],
    [30.0, -150.0],
    [110.0, -90.0],
    [130.0, 40.0],
    [40.0, 140.0],
    [-130.0, 150.0],
    [-220.0, 80.0],
    [-40.0, -150.0],
    [-120.0, 20.0],
    [0.0, 60.0],
    [20.0, -60.0],
    [-60.0, 90.0],
    [-160.0, -60.0],
    [250.0, -10.0],
];

/// The map of lab 06: a room with two partitions and a pillar.
pub const MAP: [[f64; 2]; 13] = [
    [-250.0, -150.0],
    [-110.0, -150.0],
    [-80.0, 60.0],
    [-50.0, -150.0],
    [250.0, -150.0],
    [250.0, 150.0],
    [110.0, 150.0],
    [80.0, -60.0],
    [50.0, 150.0],
    [-250.0, 150.0],
    [160.0, 0.0],
    [200.0, 40.0],
    [200.0, -50.0],
];
/// Its triangles; the triangle t is f(t + 1).
pub const MAP_TRIANGLES: [[usize; 3]; 13] = [
    [0, 1, 2],
    [0, 2, 9],
    [2, 3, 7],
    [2, 7, 8],
    [2, 8, 9],
    [3, 4, 7],
    [4, 5, 11],
    [4, 12, 7],
    [4, 11, 12],
    [5, 6, 11],
    [6, 7, 10],
    [6, 10, 11],
    [7, 12, 10],
];
/// Where the path of lab 06 begins.
pub const START: [f64; 2] = [-150.0, -120.0];
/// Where it ends.
pub const GOAL: [f64; 2] = [235.0, 60.0];

/// The gem of lab 11: a pyramid with six sides above and below.
pub const GEM: [[f64; 3]; 8] = [
    [0.0, 0.0, -60.0],
    [120.0, -20.0, -10.0],
    [60.0, 100.0, 0.0],
    [-70.0, 90.0, -10.0],
    [-120.0, -10.0, 0.0],
    [-40.0, -110.0, 0.0],
    [70.0, -100.0, -10.0],
    [20.0, 10.0, 150.0],
];

/// The points of the list of lab 05.
pub const LIST_POINTS: [[f64; 2]; 7] =
    [[-250.0, -150.0], [0.0, -150.0], [250.0, -150.0], [250.0, 150.0], [0.0, 150.0], [-250.0, 150.0], [0.0, 0.0]];
/// Its faces.
pub const LIST_FACES: [&[u32]; 4] = [&[0, 1, 6], &[1, 2, 3, 6], &[3, 4, 6], &[6, 4, 5, 0]];

/// The circle through three points, as lab 07 draws it: a polygon of 56 corners.
#[must_use]
pub fn circle([a, b, c]: [Point; 3]) -> Vec<Point> {
    const CORNERS: u32 = 56;
    // The centre, seen from a: where the lines meet that halve two sides.
    let [p, q] = [b, c].map(|to| [to.x - a.x, to.y - a.y]);
    let [pp, qq] = [p, q].map(|v| (v[0] * v[0] + v[1] * v[1]) / 2.0);
    let det = p[0] * q[1] - p[1] * q[0];
    let [x, y] = [(pp * q[1] - qq * p[1]) / det, (p[0] * qq - q[0] * pp) / det];
    let at = |i: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(CORNERS)).sin_cos();
        Point::new(a.x + x + x.hypot(y) * cos, a.y + y + x.hypot(y) * sin)
    };
    (0..CORNERS).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_goes_through_its_three_points() {
        let [a, b, c] = [[-180.0, -110.0], [120.0, -120.0], [10.0, 150.0]].map(|[x, y]| Point::new(x, y));
        let corners = circle([a, b, c]);
        let n = corners.len() as f64;
        // All corners are in the middle of the circle, taken together.
        let [x, y] = [|p: &Point| p.x, |p: &Point| p.y].map(|of| corners.iter().map(of).sum::<f64>() / n);
        let away = |p: &Point| (p.x - x).hypot(p.y - y);
        for p in [a, b, c].iter().chain(&corners) {
            assert!(
                (away(p) - away(&a)).abs() < 1e-9,
                "{p:?} is {} from the centre, and {a:?} is {}",
                away(p),
                away(&a)
            );
        }
    }

    #[test]
    fn the_faces_of_the_list_turn_left_and_fill_a_rectangle() {
        let area = |face: &&[u32]| {
            let at = |i: usize| LIST_POINTS[face[i % face.len()] as usize];
            (0..face.len()).map(|i| at(i)[0] * at(i + 1)[1] - at(i)[1] * at(i + 1)[0]).sum::<f64>() / 2.0
        };
        let areas: Vec<i64> = LIST_FACES.iter().map(|face| area(face) as i64).collect();
        assert_eq!(areas, [18_750, 56_250, 18_750, 56_250]);
        assert_eq!(areas.iter().sum::<i64>(), 500 * 300);
    }
}
