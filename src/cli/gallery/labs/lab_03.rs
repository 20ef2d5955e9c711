//! The figures of lab 03.

use super::{Made, dots, outline};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Multiples, Role, Sketch};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Point, convex_hull};
use dcel_lab::cases::handouts::POINTS;
use std::cmp::Ordering;

fn hull(points: &[[f64; 2]]) -> Made<Vec<[f64; 2]>> {
    let all: Vec<Point> = points.iter().copied().map(Point::from).collect();
    Ok(convex_hull(&all)?.into_iter().map(|i| points[i as usize]).collect())
}

/// The picture that lab 03 asks for.
pub(in crate::gallery) fn picture(options: &FigureOptions) -> Made<String> {
    let mut sketch = Sketch::new();
    let [points @ .., eye] = POINTS;
    let corners = hull(&points)?;
    outline(&mut sketch, [Role::Main; 2], &corners);
    // A tangent has all corners on one side.
    let touches = |touched: &[f64; 2]| {
        let sides = || corners.iter().map(|&c| orientation(eye.into(), (*touched).into(), c.into()));
        sides().all(Ordering::is_ge) || sides().all(Ordering::is_le)
    };
    for &touched in corners.iter().filter(|&corner| touches(corner)) {
        sketch.path(Role::Secondary, [eye, touched]).solid();
    }
    dots(&mut sketch, Role::Plain, POINTS);
    Ok(sketch.figure(options)?.to_svg())
}

/// Three ways to a hull, each in the middle of its work.
pub(in crate::gallery) fn three_ways(options: &FigureOptions) -> Made<String> {
    let [points @ .., _] = POINTS;
    let corners = hull(&points)?;

    let mut gift = Sketch::new();
    gift.path(Role::Main, corners[..3].to_vec()).solid();
    for other in [[110.0, -90.0], [20.0, -60.0], [130.0, 40.0], [0.0, 60.0]] {
        gift.path(Role::Dimmed, [corners[2], other]);
    }
    gift.path(Role::Main, [corners[2], corners[3]]).arrow().label("next corner");
    dots(&mut gift, Role::Plain, points);

    let mut scan = Sketch::new();
    scan.path(Role::Main, [[-250.0, -60.0], [-110.0, -150.0], [30.0, -150.0], [110.0, -90.0]]).solid();
    scan.path(Role::Secondary, [[110.0, -90.0], [130.0, 40.0]]).arrow().label("left turn: stays");
    scan.path(Role::Dimmed, [[-40.0, -150.0], [20.0, -60.0], [30.0, -150.0]]).label("taken off again");
    dots(&mut scan, Role::Plain, points);

    let mut halves = Sketch::new();
    let (left, right): (Vec<[f64; 2]>, Vec<[f64; 2]>) = points.iter().partition(|p| p[0] < -70.0);
    let parts = [hull(&left)?, hull(&right)?];
    outline(&mut halves, [Role::Main; 2], &parts[0]);
    outline(&mut halves, [Role::Secondary; 2], &parts[1]);
    halves.path(Role::Event, [[-110.0, -150.0], [30.0, -150.0]]).solid().label("lower tangent");
    halves.path(Role::Event, [[-130.0, 150.0], [40.0, 140.0]]).solid().label("upper tangent");
    dots(&mut halves, Role::Plain, points);

    let mut panels = Multiples::new();
    panels.sketch("Gift wrapping", "from corner to corner", gift);
    panels.sketch("Graham's scan", "from left to right", scan);
    panels.sketch("By halves", "two hulls are merged", halves);
    Ok(panels.figure(options)?.to_svg())
}
