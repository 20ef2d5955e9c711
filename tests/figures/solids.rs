//! Solids: what is grey is what an eye sees, found again by a ray for each of many places.

use super::cases::P;
use super::common::Random;
use super::drawn::{inside, length, minus, read};
use dcel_kit::figure::{Camera, FaceLabels, FigureOptions, HiddenLines, solid};
use dcel_kit::solid::Polyhedron;
use dcel_kit::solid::grow::Shape;
use dcel_kit::topology::PolygonList;

type V = [f64; 3];

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: V) -> V {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// Boxes in the cells of a lattice: none touches another, many stand before others.
fn boxes(random: &mut Random, count: usize) -> Polyhedron {
    let sides: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let (mut points, mut faces) = (Vec::new(), PolygonList::new());
    for (k, cell) in random.shuffled(27).into_iter().take(count).enumerate() {
        let ends = [cell % 3, cell / 3 % 3, cell / 9].map(|at| {
            let share = random.below(1000) as f64 / 1000.0;
            [at as f64 + 0.3 * share, at as f64 + 0.95 - 0.4 * share]
        });
        points.extend((0..8).map(|i: usize| [ends[0][i & 1], ends[1][i >> 1 & 1], ends[2][i >> 2]]));
        sides.iter().for_each(|side| faces.push_face(&side.map(|corner| corner + 8 * k as u32)));
    }
    Polyhedron::from_polygons(points, &faces).unwrap()
}

/// The outlines of all faces on the paper, y up.
struct Flat {
    faces: Vec<(String, Vec<P>, V, V)>,
    towards: V,
    right: V,
    up: V,
}

impl Flat {
    fn new(of: &Polyhedron, towards: V) -> Self {
        let towards = unit(towards);
        let right = unit(cross([0.0, 0.0, 1.0], towards));
        let up = cross(towards, right);
        let outline = |f| {
            let corners: Vec<V> = of.incident_vertices(f).map(|v| of.point(v)).collect();
            let normal = (1..corners.len() - 1).fold([0.0; 3], |sum, i| {
                let minus = |k: usize| [0, 1, 2].map(|j| corners[k][j] - corners[0][j]);
                let area = cross(minus(i), minus(i + 1));
                [0, 1, 2].map(|j| sum[j] + area[j])
            });
            let flat = corners.iter().map(|&p| [dot(p, right), dot(p, up)]).collect();
            (f.to_string(), flat, normal, corners[0])
        };
        Self { faces: of.faces().map(outline).collect(), towards, right, up }
    }

    /// The face that a ray through a place of the paper meets first.
    fn first(&self, at: P) -> Option<&str> {
        let from = [0, 1, 2].map(|i| at[0] * self.right[i] + at[1] * self.up[i]);
        let near = |normal: V, on: V| dot(normal, [0, 1, 2].map(|i| on[i] - from[i])) / dot(normal, self.towards);
        let seen = self.faces.iter().filter(|(_, flat, ..)| inside(std::slice::from_ref(flat), at));
        let depths = seen.map(|(name, _, normal, on)| (near(*normal, *on), name));
        depths.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, name)| name.as_str())
    }

    /// The distance to the nearest edge.
    fn clear(&self, at: P) -> f64 {
        let sides =
            self.faces.iter().flat_map(|(_, flat, ..)| (0..flat.len()).map(|i| (flat[i], flat[(i + 1) % flat.len()])));
        let distance = |(a, b): (P, P)| {
            let (d, e) = (minus(b, a), minus(at, a));
            let t = ((d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1])).clamp(0.0, 1.0);
            length(minus(at, [a[0] + d[0] * t, a[1] + d[1] * t]))
        };
        sides.map(distance).fold(f64::INFINITY, f64::min)
    }
}

fn bounds(points: impl Iterator<Item = P>) -> [P; 2] {
    points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
        [[low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])]]
    })
}

/// Every place is grey just once if a face is seen there, and white if none is; a face that is seen whole is the one
/// that the ray meets.
#[test]
fn what_is_grey_is_what_is_seen() {
    let mut random = Random(2_026);
    let mut solids = vec![
        ("torus".to_owned(), Shape::Torus { n: 12, m: 8 }.build().unwrap().polyhedron),
        ("torus 3 4".to_owned(), Shape::Torus { n: 3, m: 4 }.build().unwrap().polyhedron),
    ];
    solids.extend([2, 5, 12, 20].map(|n| (format!("{n} boxes"), boxes(&mut random, n))));
    let (mut seen, mut white, mut in_parts) = (0, 0, 0);
    for (name, of) in &solids {
        for towards in [[1.3, -2.4, 1.1], [-0.7, 0.9, 2.0], [2.0, 0.3, -0.2]] {
            let options = FigureOptions::new("solid").face_labels(FaceLabels::Off);
            let camera = Camera { towards, distance: None };
            let drawn = read(&solid(of, &camera, HiddenLines::LeftOut, &options).unwrap().to_svg());
            let flat = Flat::new(of, towards);
            let areas: Vec<(&String, &Vec<Vec<P>>)> = drawn
                .areas
                .iter()
                .filter(|(owner, _)| owner.starts_with('f') || owner.starts_with("s-region"))
                .flat_map(|(owner, areas)| areas.iter().map(move |(_, rings)| (owner, rings)))
                .collect();
            let [low, high] = bounds(flat.faces.iter().flat_map(|(_, flat, ..)| flat.iter().copied()));
            let [first, last] = bounds(areas.iter().flat_map(|(_, rings)| rings.iter().flatten().copied()));
            let scale = (last[0] - first[0]) / (high[0] - low[0]);
            assert!((scale - (last[1] - first[1]) / (high[1] - low[1])).abs() < 1e-3 * scale, "{name} {towards:?}");
            for _ in 0..1500 {
                let [x, y] = [0, 1].map(|i| {
                    let share = random.below(1_000_000) as f64 / 1e6;
                    low[i] - 0.05 + (high[i] - low[i] + 0.1) * share
                });
                if flat.clear([x, y]) * scale < 0.6 {
                    continue;
                }
                let on_canvas = [first[0] + (x - low[0]) * scale, first[1] + (high[1] - y) * scale];
                let grey: Vec<&str> = areas
                    .iter()
                    .filter(|(_, rings)| inside(rings, on_canvas))
                    .map(|(owner, _)| owner.as_str())
                    .collect();
                let context = format!("{name} from {towards:?} at {on_canvas:?}: {grey:?}");
                match flat.first([x, y]) {
                    None => {
                        assert!(grey.is_empty(), "{context}, nothing is there");
                        white += 1;
                    }
                    Some(face) => {
                        assert_eq!(grey.len(), 1, "{context}, {face} is there");
                        if grey[0].starts_with('f') {
                            assert_eq!(grey[0], face, "{context}");
                        } else {
                            assert!(!drawn.areas.contains_key(face), "{context}: {face} is seen whole");
                            in_parts += 1;
                        }
                        seen += 1;
                    }
                }
            }
        }
    }
    assert!(seen > 8000 && white > 5000 && in_parts > 1500, "{seen} {white} {in_parts}");
}
