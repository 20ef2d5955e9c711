//! The sweeps: where segments cross, monotone pieces; and the dual of a Delaunay triangulation.

use super::{assert_every_frame_differs, numbers, points, star};
use dcel_kit::figure::algorithms;
use dcel_kit::plane::{Corner, MonotoneEvent, Point, Subdivision, SweepEvent, sweep_segments_observed};
use std::collections::BTreeSet;

type Whole = [i128; 2];

/// A place as an exact fraction: both numerators, and the denominator.
fn crossing([a, b]: [Whole; 2], [c, d]: [Whole; 2]) -> Option<(i128, i128, i128)> {
    let minus = |p: Whole, q: Whole| [p[0] - q[0], p[1] - q[1]];
    let cross = |p: Whole, q: Whole| p[0] * q[1] - p[1] * q[0];
    let (r, s) = (minus(b, a), minus(d, c));
    let below = cross(r, s);
    if below == 0 {
        return None;
    }
    let (t, u) = (cross(minus(c, a), s), cross(minus(c, a), r));
    let inside = |t: i128| if below > 0 { 0 <= t && t <= below } else { below <= t && t <= 0 };
    (inside(t) && inside(u)).then(|| reduced(a[0] * below + t * r[0], a[1] * below + t * r[1], below))
}

fn reduced(x: i128, y: i128, below: i128) -> (i128, i128, i128) {
    let gcd = |mut a: i128, mut b: i128| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.abs()
    };
    let divisor = gcd(gcd(x, y), below) * below.signum();
    (x / divisor, y / divisor, below / divisor)
}

/// Segments on a small grid of which no two lie on one line.
fn segments(seed: u64, count: usize) -> Vec<[Whole; 2]> {
    let mut number = numbers(seed);
    let mut out: Vec<[Whole; 2]> = Vec::new();
    while out.len() < count {
        let mut point = || [i128::from(number(30)), i128::from(number(30))];
        let new = [point(), point()];
        let cross = |[a, b]: [Whole; 2], p: Whole| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        let on_a_line = |old: &[Whole; 2]| cross(*old, new[0]) == 0 && cross(*old, new[1]) == 0;
        if new[0] != new[1] && !out.iter().any(on_a_line) {
            out.push(new);
        }
    }
    out
}

#[test]
fn the_sweep_stops_at_all_ends_and_crossings_and_keeps_the_segments_in_order() {
    for seed in 0..60 {
        let whole = segments(seed, 3 + seed as usize % 9);
        let given: Vec<[Point; 2]> =
            whole.iter().map(|ends| ends.map(|[x, y]| Point::new(x as f64, y as f64))).collect();
        let mut events: Vec<SweepEvent> = Vec::new();
        sweep_segments_observed(&given, &mut events).unwrap();
        let ends = whole.as_flattened().iter().map(|&[x, y]| (x, y, 1));
        let crossings = (0..whole.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        let crossings: Vec<_> = crossings.filter_map(|(i, j)| crossing(whole[i], whole[j])).collect();
        let places: BTreeSet<_> = ends.chain(crossings).collect();
        assert_eq!(events.len(), places.len(), "seed {seed}");
        let mut sorted: Vec<_> = places.into_iter().collect();
        sorted.sort_by(|a, b| (a.0 * b.2, a.1 * b.2).cmp(&(b.0 * a.2, b.1 * a.2)));
        for (event, &(x, y, below)) in events.iter().zip(&sorted) {
            assert!((event.at.x - x as f64 / below as f64).abs() < 1e-9, "seed {seed}");
            assert!((event.at.y - y as f64 / below as f64).abs() < 1e-9, "seed {seed}");
            // Just right of the event: those that start there or before and end after, by height.
            let far = |ends: &[Whole; 2]| *ends.iter().max().unwrap();
            let near = |ends: &[Whole; 2]| *ends.iter().min().unwrap();
            let at = |p: Whole| (p[0] * below, p[1] * below).cmp(&(x, y));
            let cut = |i: &u32| {
                let ends = &whole[*i as usize];
                at(near(ends)).is_le() && at(far(ends)).is_gt()
            };
            let mut expected: Vec<u32> = (0..whole.len() as u32).filter(cut).collect();
            // By height there, and among those through one point by slope: upright ones come last. Points straight above
            // the event come later, so that segments through them are still in the order from before.
            let height = |i: u32| {
                let [[ax, ay], [bx, by]] = [near(&whole[i as usize]), far(&whole[i as usize])];
                let [x, y] = [x, y].map(|x| x as f64 / below as f64);
                let slope = (by - ay) as f64 / (bx - ax) as f64;
                let height = if ax == bx { y } else { ay as f64 + slope * (x - ax as f64) };
                ((height * 1e6).round(), if height > y + 1e-6 { -slope } else { slope })
            };
            expected.sort_by(|&i, &j| height(i).partial_cmp(&height(j)).unwrap());
            assert_eq!(event.status, expected, "seed {seed} at {:?}", event.at);
            let number = |list: &[u32], wanted: fn(&[Whole; 2]) -> Whole| {
                list.iter().all(|&i| at(wanted(&whole[i as usize])).is_eq())
            };
            assert!(number(&event.starting, |ends| *ends.iter().min().unwrap()), "seed {seed}");
            assert!(number(&event.ending, |ends| *ends.iter().max().unwrap()), "seed {seed}");
        }
        let film = algorithms::segment_sweep(&given, 1000).unwrap();
        assert_eq!(film.len(), events.len() + 2, "seed {seed}");
        assert_every_frame_differs(&film);
    }
    // Equal segments take part once, those without length as points.
    let [a, b, c] = [(0.0, 0.0), (4.0, 2.0), (2.0, 7.0)].map(Point::from);
    let mut events: Vec<SweepEvent> = Vec::new();
    sweep_segments_observed(&[[c, c], [a, b], [b, a]], &mut events).unwrap();
    let started: Vec<&[u32]> = events.iter().map(|event| &event.starting[..]).collect();
    assert_eq!(started, [&[1][..], &[], &[]]);
    let film = algorithms::segment_sweep(&[], 10).unwrap();
    assert_eq!(film.len(), 2);
    assert!(algorithms::segment_sweep(&[[a, Point::new(f64::NAN, 0.0)]], 10).is_err());
}

#[test]
fn the_monotone_sweep_meets_each_corner_once_and_tells_what_it_is() {
    for seed in 0..60 {
        let corners = 5 + seed as usize % 12;
        let given = star(seed, corners);
        let mut events = Vec::new();
        let added = given.clone().triangulate_monotone_observed(&mut events).unwrap();
        let f = given.faces().find(|&f| f != given.outer_face()).unwrap();
        let round: Vec<_> = given.incident_vertices(f).collect();
        let n = round.len();
        let mut met = Vec::new();
        for event in &events {
            if let MonotoneEvent::Corner { at, corner } = event {
                let i = round.iter().position(|v| v == at).unwrap();
                let [a, b, c] = [round[(i + n - 1) % n], round[i], round[(i + 1) % n]].map(|v| given.point(v));
                let left = |p: Point| (p.x, p.y) < (b.x, b.y);
                // Twice the area of the corner's triangle, with all numbers whole.
                let turns_left = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0;
                let expected = match (left(a), left(c), turns_left) {
                    (true, true, true) => Corner::End,
                    (true, true, false) => Corner::Merge,
                    (false, false, true) => Corner::Start,
                    (false, false, false) => Corner::Split,
                    (true, false, _) => Corner::Lower,
                    (false, true, _) => Corner::Upper,
                };
                assert_eq!(*corner, expected, "{at}, seed {seed}");
                met.push((b.x, b.y));
            }
        }
        assert_eq!(met.len(), n, "seed {seed}");
        assert!(met.windows(2).all(|pair| pair[0] < pair[1]), "from left to right, seed {seed}");
        let joins = events.iter().filter(|event| matches!(event, MonotoneEvent::Diagonal { .. })).count();
        let cuts = events.iter().filter(|event| matches!(event, MonotoneEvent::Cut(_))).count();
        assert_eq!((joins + cuts, added.diagonals.len()), (n - 3, n - 3), "seed {seed}");
        // The pieces alone: as many as the other way to make them finds.
        let pieces = given.clone().split_into_monotone(f).unwrap();
        assert_eq!(pieces.diagonals.len(), joins, "seed {seed}");
        // Every split and merge corner is an end of one of the diagonals.
        for event in &events {
            if let MonotoneEvent::Corner { at, corner: Corner::Split | Corner::Merge } = event {
                let touches = |event: &&MonotoneEvent| matches!(event, MonotoneEvent::Diagonal { from, to } if from == at || to == at);
                assert!(events.iter().any(|event| touches(&event)), "{at}, seed {seed}");
            }
        }
        let film = algorithms::monotone(&given, 1000).unwrap();
        assert_eq!(film.len(), events.len() + 2, "seed {seed}");
        assert_every_frame_differs(&film);
    }
}

#[test]
fn a_voronoi_film_shows_each_site_and_its_edges() {
    for seed in 0..30 {
        let delaunay = Subdivision::delaunay(&points(seed, 3 + seed as usize % 14)).unwrap().subdivision;
        let film = algorithms::voronoi(&delaunay, 1000).unwrap();
        assert_eq!(film.len(), delaunay.vertex_count() + 2, "seed {seed}");
        // A side of a cell for each neighbour that is not across the diagonal of four points on a circle.
        let diagram = delaunay.voronoi().unwrap();
        for (heading, text) in film.captions().filter(|(heading, _)| heading.starts_with("Cell")) {
            let site = heading.rsplit(' ').next().unwrap();
            let sides = diagram.edges().iter().filter(|edge| edge.sites.iter().any(|v| v.to_string() == site)).count();
            let said = match sides {
                1 => "one edge,".to_owned(),
                count => format!("{count} edges"),
            };
            assert!(text.starts_with(&said), "{site}: {text}, seed {seed}");
        }
        assert_every_frame_differs(&film);
    }
    let square = Subdivision::lab_rectangle();
    assert!(algorithms::voronoi(&square, 10).is_err());
}
