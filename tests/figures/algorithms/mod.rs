//! Films of algorithms: the events are what an independent, slow program sees, and no frame repeats the last one.

mod paths;
mod refusals;
mod space;
mod sweeps;
mod walks;

use dcel_kit::figure::{FigureOptions, SketchFilm, algorithms};
use dcel_kit::plane::predicates::{in_circle, orientation};
use dcel_kit::plane::{EarEvent, FlipEvent, HullEvent, Point, Subdivision, convex_hull_observed};
use dcel_kit::{EdgeId, VertexId};
use std::collections::BTreeSet;

/// Numbers that look random, from a seed.
fn numbers(mut seed: u64) -> impl FnMut(u64) -> u64 {
    move |below| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) % below
    }
}

fn points(seed: u64, count: usize) -> Vec<Point> {
    let mut number = numbers(seed);
    (0..count).map(|_| Point::new(number(20) as f64, number(20) as f64)).collect()
}

/// A polygon that winds round the origin: a corner in each direction, near or far.
fn star(seed: u64, corners: usize) -> Subdivision {
    let mut number = numbers(seed);
    let corner = |i: usize| {
        let angle = i as f64 / corners as f64 * std::f64::consts::TAU;
        let radius = 2.0 + number(30) as f64;
        Point::new((radius * angle.cos() * 64.0).round(), (radius * angle.sin() * 64.0).round())
    };
    Subdivision::polygon(&(0..corners).map(corner).collect::<Vec<_>>()).unwrap()
}

/// The pictures of the frames without their captions.
fn pictures(film: &SketchFilm) -> Vec<String> {
    let figures = film.singles(&FigureOptions::new("Film")).unwrap();
    let without_words = |svg: &str| {
        let lines = svg.lines().filter(|line| !line.contains("class=\"ct\"") && !line.contains("class=\"cs\""));
        let lines = lines.filter(|line| !line.contains("<title") && !line.contains("<desc"));
        lines.collect::<Vec<_>>().join("\n")
    };
    figures.iter().map(|figure| without_words(&figure.to_svg())).collect()
}

#[track_caller]
fn assert_every_frame_differs(film: &SketchFilm) {
    let pictures = pictures(film);
    let captions: Vec<_> = film.captions().collect();
    for (i, pair) in pictures.windows(2).enumerate() {
        assert_ne!(pair[0], pair[1], "frames {i} and {}: {:?}, {:?}", i + 1, captions[i], captions[i + 1]);
    }
}

/// The triangles as sets of corners.
fn triangles(s: &Subdivision) -> BTreeSet<BTreeSet<VertexId>> {
    let inner = s.faces().filter(|&f| f != s.outer_face());
    inner.map(|f| s.incident_vertices(f).collect()).collect()
}

#[test]
fn each_flip_is_forced_by_its_circle_and_leads_to_the_next_triangulation() {
    for seed in 0..40 {
        let mut s = star(seed, 12);
        s.triangulate(dcel_kit::plane::TriangulationMethod::Monotone).unwrap();
        let given = s.clone();
        let mut events = Vec::new();
        let flips = s.make_delaunay_observed(|_| false, &mut events);
        // Once more with sets of corners and nothing else: what an edge is, the given structure says.
        let mut now = triangles(&given);
        let mut ends: Vec<BTreeSet<VertexId>> =
            given.edges().map(|e: EdgeId| e.half_edges().map(|h| given.origin(h)).into()).collect();
        let mut forced = 0;
        for event in &events {
            let (e, is_flipped) = match event {
                FlipEvent::Kept(e) => (e, false),
                FlipEvent::Flipped(e) => (e, true),
            };
            let edge = &mut ends[e.index()];
            let beside: Vec<BTreeSet<VertexId>> = now.iter().filter(|t| edge.is_subset(t)).cloned().collect();
            let [one, other] = &beside[..] else {
                assert!(!is_flipped, "{e} has one triangle only, seed {seed}");
                continue;
            };
            let apex = |t: &BTreeSet<VertexId>| *t.difference(edge).next().unwrap();
            let (c, d) = (apex(one), apex(other));
            let at: Vec<Point> = one.iter().map(|&v| given.point(v)).collect();
            let turn = orientation(at[0], at[1], at[2]);
            let side = in_circle(at[0], at[1], at[2], given.point(d));
            let is_inside = if turn.is_gt() { side.is_gt() } else { side.is_lt() };
            assert_eq!(is_inside, is_flipped, "{e}, seed {seed}");
            if is_flipped {
                let [a, b] = [*edge.first().unwrap(), *edge.last().unwrap()];
                for gone in &beside {
                    now.remove(gone);
                }
                now.extend([[a, c, d].into(), [b, c, d].into()]);
                *edge = [c, d].into();
                forced += 1;
            }
        }
        assert_eq!((forced, &now), (flips, &triangles(&s)), "seed {seed}");
        let film = algorithms::lawson_flips(&given, |_| false, 1000);
        assert_eq!(film.len(), 2 + 2 * flips, "seed {seed}");
        assert_every_frame_differs(&film);
    }
}

#[test]
fn each_ear_turns_left_and_is_empty_and_each_other_corner_is_not() {
    for seed in 0..40 {
        let given = star(seed, 14);
        let mut events = Vec::new();
        given.clone().triangulate_ears_observed(&mut events).unwrap();
        let mut left: Vec<VertexId> = given.vertices().collect();
        let mut cut = 0;
        for event in &events {
            let (corners, is_ear) = match event {
                EarEvent::Cut(corners) => (corners, true),
                EarEvent::Refused { corners, .. } => (corners, false),
            };
            let place = left.iter().position(|v| v == &corners[1]).unwrap();
            let n = left.len();
            assert_eq!(*corners, [left[(place + n - 1) % n], left[place], left[(place + 1) % n]], "seed {seed}");
            let [a, b, c] = corners.map(|v| given.point(v));
            let is_convex = orientation(a, b, c).is_gt();
            let is_in = |v: &VertexId| {
                let p = given.point(*v);
                [[a, b], [b, c], [c, a]].iter().all(|&[from, to]| orientation(from, to, p).is_ge())
            };
            let is_empty = !left.iter().filter(|v| !corners.contains(v)).any(is_in);
            assert_eq!(is_convex && is_empty, is_ear, "{event:?}, seed {seed}");
            if let EarEvent::Refused { is_convex: said, .. } = event {
                assert_eq!(*said, is_convex, "{event:?}, seed {seed}");
            } else {
                left.remove(place);
                cut += 1;
            }
        }
        // n corners make n - 2 triangles; the last one is not cut off.
        assert_eq!((cut, left.len()), (14 - 3, 3), "seed {seed}");
        let film = algorithms::ear_clipping(&given, 1000).unwrap();
        assert_eq!(film.len(), events.len() + 2, "seed {seed}");
        assert_every_frame_differs(&film);
    }
}

#[test]
fn a_hull_takes_each_point_twice_and_drops_all_that_are_no_corners() {
    for seed in 0..60 {
        let points = points(seed, 3 + seed as usize % 15);
        let mut events = Vec::new();
        let corners = convex_hull_observed(&points, &mut events).unwrap();
        // A corner is a point at which some line has all other places strictly on one side: of the two neighbours in
        // angle no third point lies between. By brute force: no two places have it in their triangle with a third.
        let places: BTreeSet<(u64, u64)> = points.iter().map(|p| (p.x as u64, p.y as u64)).collect();
        let at = |&(x, y): &(u64, u64)| Point::new(x as f64, y as f64);
        let is_corner = |p: &(u64, u64)| {
            let others: Vec<Point> = places.iter().filter(|q| *q != p).map(at).collect();
            let p = at(p);
            let covers = |a: &Point, b: &Point, c: &Point| {
                let turns = [(a, b), (b, c), (c, a)].map(|(from, to)| orientation(*from, *to, p));
                let flat = orientation(*a, *b, *c).is_eq();
                !flat && (turns.iter().all(|turn| turn.is_ge()) || turns.iter().all(|turn| turn.is_le()))
            };
            let between = |a: &Point, b: &Point| {
                let inside = |low: f64, x: f64, high: f64| low.min(high) <= x && x <= low.max(high);
                orientation(*a, *b, p).is_eq() && inside(a.x, p.x, b.x) && inside(a.y, p.y, b.y)
            };
            let pairs = || others.iter().flat_map(|a| others.iter().map(move |b| (a, b)));
            !pairs().any(|(a, b)| between(a, b) || others.iter().any(|c| covers(a, b, c)))
        };
        let expected: BTreeSet<(u64, u64)> = places.iter().copied().filter(is_corner).collect();
        let found: BTreeSet<(u64, u64)> =
            corners.iter().map(|&i| &points[i as usize]).map(|p| (p.x as u64, p.y as u64)).collect();
        assert_eq!(found, expected, "seed {seed}");

        let count = |wanted: fn(&HullEvent) -> bool| events.iter().filter(|event| wanted(event)).count();
        let taken = count(|event| matches!(event, HullEvent::Taken(_)));
        let dropped = count(|event| matches!(event, HullEvent::Dropped { .. }));
        let aside = events.iter().find_map(|event| match event {
            HullEvent::Sorted { aside } => Some(*aside as usize),
            _ => None,
        });
        // Both sides have the ends in common.
        let rest = points.len() - aside.unwrap();
        let ends = if corners.len() == 1 { 1 } else { 2 };
        assert_eq!((taken, dropped), (2 * rest, 2 * rest - corners.len() - ends), "seed {seed}");
        assert_eq!(count(|event| matches!(event, HullEvent::Turned)), 1);
        let film = algorithms::convex_hull(&points, 1000).unwrap();
        assert_eq!(film.len(), taken + dropped + 1 + 2, "seed {seed}");
        assert_every_frame_differs(&film);
    }
}

#[test]
fn of_many_events_some_are_shown_and_the_others_are_counted() {
    let points = points(1, 400);
    let film = algorithms::convex_hull(&points, 12).unwrap();
    assert_eq!(film.len(), 12 + 2);
    assert!(film.captions().any(|(heading, _)| heading.contains("not shown")));
    let mut s = star(3, 300);
    s.triangulate(dcel_kit::plane::TriangulationMethod::Monotone).unwrap();
    let film = algorithms::lawson_flips(&s, |_| false, 5);
    assert_eq!(film.len(), 2 + 2 * 5);
    // The last frames are those of the last flip, whatever is left out before.
    let (_, text) = film.captions().last().unwrap();
    let flips = s.make_delaunay(|_| false);
    assert!(text.starts_with(&format!("{flips} flips")), "{text}");
}

#[test]
fn a_page_plays_the_frames_and_shows_them_without_a_script() {
    let film = algorithms::ear_clipping(&star(5, 7), 100).unwrap();
    let page = film.page(&FigureOptions::new("Ears & more")).unwrap();
    assert_eq!(page.matches("<li><a href=\"#ears-more-step-").count(), film.len());
    assert!(page.contains("<title>Ears &amp; more</title>") && page.contains("id=\"ears-more-step-0\""));
    assert!(!page.contains("src=") && !page.contains("@import"), "nothing comes from outside");
    // Frames alone have one size.
    let sizes: BTreeSet<String> = film
        .singles(&FigureOptions::new("Ears"))
        .unwrap()
        .iter()
        .map(|figure| {
            let svg = figure.to_svg();
            svg[svg.find("viewBox").unwrap()..].split('"').nth(1).unwrap().to_owned()
        })
        .collect();
    assert_eq!(sizes.len(), 1, "{sizes:?}");
}
