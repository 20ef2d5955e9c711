//! What is cut by the frame.

use super::alone;
use super::read::{Drawing, P, inside};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Role, Sketch};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;
use std::cmp::Ordering;
use svg::node::element::path::{Command, Data, Position};

/// Numbers that look random and are the same in every run.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 40) as f64 / (1u64 << 24) as f64
}

/// The canvas, less its free line of 4 px.
fn on_frame(p: P, size: P) -> bool {
    (0..2).any(|i| [4.0, size[i] - 4.0].iter().any(|side| (p[i] - side).abs() < 0.005))
}

fn in_frame(p: P, size: P) -> bool {
    (0..2).all(|i| (3.995..=size[i] - 3.995).contains(&p[i]))
}

/// A sketch that fills the canvas from (0, 0) to (16, 10), and the place of a point on it.
fn stage() -> Sketch {
    let mut sketch = Sketch::new();
    sketch.region(Role::Plain, [[[0.0, 0.0], [16.0, 0.0], [16.0, 10.0], [0.0, 10.0]]]);
    sketch
}

fn place(drawn: &Drawing, p: P) -> P {
    let corners = drawn.groups["s-region-1"].rings("fi");
    let (low, high) = corners[0].iter().fold(([f64::MAX; 2], [f64::MIN; 2]), |(low, high), p| {
        ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
    });
    let scale = (high[0] - low[0]) / 16.0;
    [low[0] + p[0] * scale, high[1] - p[1] * scale]
}

#[test]
fn rays_and_lines_end_on_the_frame() {
    let mut seed = 1;
    let mut sketch = stage();
    let mut ends = Vec::new();
    for _ in 0..60 {
        let p = [16.0 * random(&mut seed), 10.0 * random(&mut seed)];
        let q = [16.0 * random(&mut seed), 10.0 * random(&mut seed)];
        sketch.ray(Role::Main, p, q);
        sketch.line(Role::Main, p, q);
        ends.push((p, q));
    }
    let drawn = Drawing::read(&alone(&sketch));
    for (i, &(p, q)) in ends.iter().enumerate() {
        let line = |kind: &str| drawn.groups[&format!("s-{kind}-{}", i + 1)].lines[0].clone();
        let (_, from, to) = line("ray");
        let (start, through) = (place(&drawn, p), place(&drawn, q));
        assert!((0..2).all(|k| (from[k] - start[k]).abs() < 0.02), "ray {p:?} starts at {from:?}, not {start:?}");
        assert!(on_frame(to, drawn.size), "ray {p:?} {q:?} ends at {to:?}");
        let [u, v] = [[to[0] - from[0], to[1] - from[1]], [through[0] - start[0], through[1] - start[1]]];
        let length = |v: P| (v[0] * v[0] + v[1] * v[1]).sqrt();
        assert!((u[0] * v[1] - u[1] * v[0]).abs() < 0.05 * length(v) + 0.02 * length(u), "not through {q:?}");
        assert!(u[0] * v[0] + u[1] * v[1] > 0.0, "ray {p:?} {q:?} runs backwards");
        let (_, a, b) = line("line");
        assert!(on_frame(a, drawn.size) && on_frame(b, drawn.size), "line {p:?} {q:?}: {a:?} {b:?}");
    }
}

#[test]
fn everything_stays_inside_the_frame_of_a_cropped_picture() {
    let options = FigureOptions::new("Test").crop([2.0, 2.0], [7.0, 6.0]).width(500.0);
    let drawn = Drawing::read(&super::everything().figure(&options).unwrap().to_svg());
    let mut seen = 0;
    // Below a wide picture there is the legend: the picture is 500 px times 400.
    for (id, group) in drawn.groups.iter().filter(|(id, _)| id.starts_with("s-") && !id.starts_with("s-key")) {
        for p in group.corners().into_iter().filter(|_| group.words.is_empty()) {
            // Marks and heads may look over the edge by their own size.
            let reach = if id.contains("point") || id.contains("portal") { 8.0 } else { 0.01 };
            assert!(
                (-reach..=500.0 + reach).contains(&p[0]) && (-reach..=400.0 + reach).contains(&p[1]),
                "{id}: {p:?}"
            );
            seen += 1;
        }
    }
    assert!(seen > 30, "{seen}");
}

/// Compares the drawn area with exact orientations, point by point.
#[test]
fn a_cone_holds_what_lies_between_its_rays() {
    let cases: [([P; 3], Option<[P; 2]>); 6] = [
        ([[3.0, 3.0], [12.0, 2.0], [9.0, 9.0]], None),
        ([[3.0, 3.0], [9.0, 9.0], [12.0, 2.0]], None),
        ([[8.0, 5.0], [9.0, 5.0], [7.0, 5.0]], None),
        ([[8.0, 5.0], [8.0, 6.0], [8.5, 5.5]], None),
        ([[3.0, 3.0], [12.0, 2.0], [9.0, 9.0]], Some([[12.0, 2.0], [9.0, 9.0]])),
        ([[0.0, 0.0], [16.0, 1.0], [1.0, 10.0]], Some([[9.0, 0.0], [9.0, 10.0]])),
    ];
    for ([apex, right, left], end) in cases {
        let mut sketch = stage();
        let cone = sketch.cone(Role::Main, apex, right, left);
        if let Some([p, q]) = end {
            cone.until(p, q);
        }
        let drawn = Drawing::read(&alone(&sketch));
        let area = drawn.groups["s-cone-1"].rings("fi");
        let [a, r, l] = [apex, right, left].map(Point::from);
        let side = |a: Point, b: Point, p: Point| orientation(a, b, p);
        let (mut within, mut without) = (0, 0);
        for i in 0..64 {
            for j in 0..40 {
                let p = [0.13 + 0.25 * f64::from(i), 0.11 + 0.25 * f64::from(j)];
                let w = Point::from(p);
                let (of_right, of_left) = (side(a, r, w), side(a, l, w));
                let mut expected = match side(a, r, l) {
                    Ordering::Greater => of_right.is_gt() && of_left.is_lt(),
                    Ordering::Less => of_right.is_gt() || of_left.is_lt(),
                    Ordering::Equal => of_right.is_gt(),
                };
                if let Some(ends) = end {
                    let [p, q] = ends.map(Point::from);
                    expected &= side(p, q, w) == side(p, q, a);
                }
                // Points within a hundredth of a px of a border may fall on either side of it.
                let c = place(&drawn, p);
                let near = [[0.05, 0.05], [-0.05, 0.05], [0.05, -0.05], [-0.05, -0.05]]
                    .map(|d| inside(&area, [c[0] + d[0], c[1] + d[1]]));
                if near.iter().all(|&n| n == near[0]) {
                    assert_eq!(near[0], expected, "cone {apex:?} {right:?} {left:?} {end:?} at {p:?}");
                }
                within += usize::from(expected);
                without += usize::from(!expected);
            }
        }
        assert!(within > 20 && without > 20, "{within} {without}");
    }
}

#[test]
fn circles_are_cut_at_the_frame_and_pass_their_three_points() {
    let triangle = [[1.0, 1.0], [15.0, 2.0], [8.0, 3.5]];
    let mut sketch = stage();
    sketch.circumcircle(Role::Main, triangle);
    sketch.circle(Role::Goal, [8.0, 5.0], 1.5);
    let drawn = Drawing::read(&alone(&sketch));
    assert_eq!(drawn.groups["s-circle-2"].discs.len(), 1, "a whole circle stays one");
    let arcs = &drawn.groups["s-circle-1"].paths;
    assert!(!arcs.is_empty());
    let circle = round(arcs);
    for (from, to, radius) in circle {
        assert!(on_frame(from, drawn.size) && on_frame(to, drawn.size), "{from:?} {to:?}");
        assert!(in_frame(from, drawn.size) && in_frame(to, drawn.size));
        // The centre from the chord: on the side that both solutions leave, one has the three points at its radius.
        let [mx, my] = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let half = 0.5 * (dx * dx + dy * dy).sqrt();
        let rise = (radius * radius - half * half).sqrt();
        let centres = [1.0, -1.0].map(|s| [mx - s * rise * dy / (2.0 * half), my + s * rise * dx / (2.0 * half)]);
        let passes = |c: P| {
            triangle.iter().all(|&p| {
                let q = place(&drawn, p);
                (((q[0] - c[0]).powi(2) + (q[1] - c[1]).powi(2)).sqrt() - radius).abs() < 0.3
            })
        };
        assert!(centres.into_iter().any(passes), "{arcs:?}");
    }
}

/// Start, end and radius of a path of one arc, whatever form it is written in.
fn round(paths: &[(String, String)]) -> Vec<(P, P, f64)> {
    let read = |(_, data): &(String, String)| {
        let data = Data::parse(data.as_str()).unwrap();
        let [Command::Move(_, start), Command::EllipticalArc(position, arc)] = &data[..] else {
            panic!("not one arc: {data:?}")
        };
        let point = |at: &[f32]| [f64::from(at[0]), f64::from(at[1])];
        let (start, end) = (point(start), point(&arc[5..]));
        let relative = matches!(position, Position::Relative);
        (start, if relative { [start[0] + end[0], start[1] + end[1]] } else { end }, f64::from(arc[0]))
    };
    paths.iter().map(read).collect()
}

#[test]
fn holes_of_regions_stay_open_and_heads_point_forwards() {
    let mut sketch = Sketch::new();
    let outer = vec![[0.0, 0.0], [16.0, 0.0], [16.0, 10.0], [0.0, 10.0]];
    sketch.region(Role::Plain, [outer, vec![[4.0, 4.0], [8.0, 4.0], [8.0, 8.0]]]);
    sketch.path(Role::Main, [[1.0, 1.0], [9.0, 1.0], [9.0, 5.0]]).arrow();
    let drawn = Drawing::read(&alone(&sketch));
    let area = drawn.groups["s-region-1"].rings("fi");
    assert!(inside(&area, place(&drawn, [2.0, 5.0])) && !inside(&area, place(&drawn, [7.0, 5.0])));
    let path = &drawn.groups["s-path-1"];
    let head = &path.rings("gl")[0];
    let tip = place(&drawn, [9.0, 5.0]);
    assert!((0..2).all(|i| (head[0][i] - tip[i]).abs() < 0.02), "the tip is at the end: {head:?} {tip:?}");
    assert!(head[1..].iter().all(|p| p[1] > tip[1] + 3.0), "and points up: {head:?}");
    let line = &path.rings("ln")[0];
    let last = line.last().unwrap();
    assert!(last[1] > tip[1] + 2.0, "the line ends inside the head: {line:?}");
}

#[test]
fn the_left_end_of_a_portal_has_a_square_and_the_right_end_a_ring() {
    let mut sketch = stage();
    sketch.portal(Role::Secondary, [4.0, 6.0], [4.0, 2.0]);
    let drawn = Drawing::read(&alone(&sketch));
    let portal = &drawn.groups["s-portal-1"];
    let (left, right) = (place(&drawn, [4.0, 6.0]), place(&drawn, [4.0, 2.0]));
    let near = |a: P, b: P| (0..2).all(|i| (a[i] - b[i]).abs() < 0.02);
    assert!(near(portal.discs[0].0, right), "{portal:?}");
    let square = &portal.rings("gl")[0];
    let centre = [0, 1].map(|i| 0.25 * square.iter().map(|p| p[i]).sum::<f64>());
    assert!(square.len() == 4 && near(centre, left), "{square:?}");
    assert!(portal.lines.iter().any(|line| near(line.1, left) && near(line.2, right)));
}
