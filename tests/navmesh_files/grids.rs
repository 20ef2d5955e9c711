//! `.map`: rectangles and regions against a flood fill of the cells.

use crate::{Random, plane};
use dcel_kit::FaceId;
use dcel_kit::io::{Format, Grid};
use dcel_kit::plane::Subdivision;

fn text(rows: &[String]) -> String {
    format!("type octile\nheight {}\nwidth {}\nmap\n{}\n", rows.len(), rows[0].len(), rows.join("\n"))
}

/// Twice the signed area of all cycles of a face.
fn area2(s: &Subdivision, f: FaceId) -> f64 {
    let cross = |h| {
        let [a, b] = [s.origin(h), s.destination(h)].map(|v| s.point(v));
        a.x * b.y - b.x * a.y
    };
    s.cycles(f).flat_map(|h| s.cycle(h)).map(cross).sum()
}

/// The faces of the domain.
fn domain(s: &Subdivision) -> Vec<FaceId> {
    s.faces().filter(|&f| f != s.outer_face() && !s.is_hole(f)).collect()
}

/// The sizes of the regions of cells for which `is` holds, by flood fill; with `ring`, the cells one step outside of
/// the grid belong to it, too.
fn regions(rows: &[String], is: impl Fn(u8) -> bool, ring: bool) -> Vec<usize> {
    let (w, h) = (rows[0].len() as i64, rows.len() as i64);
    let m = i64::from(ring);
    let there = |x: i64, y: i64| {
        let inside = (0..w).contains(&x) && (0..h).contains(&y);
        if inside {
            is(rows[y as usize].as_bytes()[x as usize])
        } else {
            ring && (-m..w + m).contains(&x) && (-m..h + m).contains(&y)
        }
    };
    let mut seen = std::collections::BTreeSet::new();
    let mut sizes = Vec::new();
    for start in (-m..h + m).flat_map(|y| (-m..w + m).map(move |x| (x, y))) {
        if !there(start.0, start.1) || !seen.insert(start) {
            continue;
        }
        let (mut stack, mut size) = (vec![start], 0);
        while let Some((x, y)) = stack.pop() {
            size += 1;
            for next in [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)] {
                if there(next.0, next.1) && seen.insert(next) {
                    stack.push(next);
                }
            }
        }
        sizes.push(size);
    }
    sizes.sort_unstable();
    sizes
}

fn check(rows: &[String], context: &str) {
    let file = text(rows);
    let grid = Grid::parse(file.as_bytes(), "file").expect("a good map");
    let open = |b: u8| b == b'.';
    let stated = regions(rows, open, false);
    // The outside is one of the blocked regions; the others are holes.
    let holes = regions(rows, |b| !open(b), true).len() - 1;

    let s = grid.regions().expect("regions");
    assert_eq!(s.hole_faces().count(), holes, "holes of regions, {context}");
    let mut areas: Vec<usize> = domain(&s).into_iter().map(|f| (area2(&s, f) / 2.0) as usize).collect();
    areas.sort_unstable();
    assert_eq!(areas, stated, "regions, {context}");

    if grid.open_cells() == 0 {
        return;
    }
    let r = plane(file.as_bytes(), Format::Map);
    assert_eq!(r.hole_faces().count(), holes, "holes of rectangles, {context}");
    assert_eq!(domain(&r).into_iter().map(|f| area2(&r, f)).sum::<f64>() as usize, 2 * grid.open_cells(), "{context}");
    for f in domain(&r) {
        let corners: Vec<_> = r.incident_vertices(f).map(|v| r.point(v)).collect();
        let xs = corners.iter().map(|p| p.x).fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
        let ys = corners.iter().map(|p| p.y).fold((f64::MAX, f64::MIN), |(a, b), y| (a.min(y), b.max(y)));
        assert!((2.0 * (xs.1 - xs.0) * (ys.1 - ys.0) - area2(&r, f)).abs() < 0.5, "{f} is no rectangle, {context}");
    }
    // Of neighbouring open cells, one can always cross to the other: the pieces hang together as the cells do.
    let mut pieces = Vec::new();
    let mut seen = dcel_kit::FaceMap::filled(r.face_bound(), false);
    for f in domain(&r) {
        let (mut stack, mut area) = (vec![f], 0.0);
        while let Some(f) = stack.pop() {
            if !std::mem::replace(&mut seen[f], true) {
                area += area2(&r, f) / 2.0;
                stack.extend(r.adjacent_faces(f).filter(|&g| g != r.outer_face() && !r.is_hole(g)));
            }
        }
        if area > 0.0 {
            pieces.push(area as usize);
        }
    }
    pieces.sort_unstable();
    assert_eq!(pieces, stated, "rectangles, {context}");
}

#[test]
fn random_maps_have_the_regions_of_a_flood_fill() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let (w, h) = (1 + random.below(9), 1 + random.below(9));
        let density = 1 + random.below(9);
        let row = |random: &mut Random| (0..w).map(|_| if random.below(10) < density { '@' } else { '.' }).collect();
        let rows: Vec<String> = (0..h).map(|_| row(&mut random)).collect();
        check(&rows, &format!("seed {seed}:\n{}", rows.join("\n")));
    }
}

#[test]
fn y_of_a_map_points_down_in_the_file_and_up_in_the_kit() {
    let s = plane(b"type octile\r\nheight 2\r\nwidth 3\r\nmap\r\n...\r\n@@.\r\n", Format::Map);
    let points: Vec<_> = s.vertices().map(|v| (s.point(v).x, s.point(v).y)).collect();
    assert_eq!(points, [(0.0, 0.0), (3.0, 0.0), (0.0, -1.0), (2.0, -1.0), (3.0, -1.0), (2.0, -2.0), (3.0, -2.0)]);
    assert!(points.iter().all(|p| p.1.is_sign_negative() == (p.1 < 0.0)), "no -0");
    let grid = Grid::parse(b"type octile\nheight 2\nwidth 3\nmap\n...\n@@.\n", "file").expect("a map");
    let soup = grid.rectangles().expect("rectangles");
    assert_eq!(soup.points.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>(), points);
    // The face of the first row is in line 5 of the file, that of the second in line 6.
    assert_eq!(soup.places.face_lines.iter().collect::<Vec<_>>(), [5, 6]);
}

#[test]
fn double_corners_are_kept_as_touching_borders() {
    let rows = ["..@@", "..@@", "@@..", "@@.."].map(String::from);
    let grid = Grid::parse(text(&rows).as_bytes(), "file").expect("a map");
    assert_eq!(grid.double_corners().collect::<Vec<_>>(), [[2, 2]]);
    let s = plane(text(&rows).as_bytes(), Format::Map);
    let corner = s.vertices().find(|&v| s.point(v) == (2.0, -2.0).into()).expect("the double corner");
    assert_eq!(s.outgoing_half_edges(corner).count(), 4);
    let faces: Vec<_> = s.incident_faces(corner).collect();
    let blocked = faces.iter().filter(|&&f| f == s.outer_face()).count();
    assert_eq!((faces.len(), blocked), (4, 2), "two open and two blocked corners, in turn: {faces:?}");
    check(&rows, "double corner");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_cape_has_its_eleven_double_corners() {
    let bytes = std::fs::read(crate::data("O15-gppc-acrossthecape/AcrosstheCape.map")).expect("the map");
    let grid = Grid::parse(&bytes, "cape").expect("a map");
    assert_eq!((grid.width(), grid.height(), grid.double_corners().count()), (768, 768, 11));
    let s = plane(&bytes, Format::Map);
    let area: f64 = domain(&s).into_iter().map(|f| area2(&s, f)).sum();
    assert_eq!(area as usize, 2 * grid.open_cells());
    let regions = grid.regions().expect("regions");
    assert_eq!(regions.hole_faces().count(), s.hole_faces().count());
}
