//! The triangulations that cases begin with.
//!
//! ```text
//!   fixed    a kite, a square, quadrilaterals that are straight or turn in, fans, grids, a bay, the sites of the handout
//!   swept    points joined from left to right, each with all that it sees: thin triangles
//!   shaken   the same after flips at random           odd   links only: after flips that no plane allows
//! ```

use super::{flip, mistakes};
use crate::cases::cycles::{from_cycles, link, row_mut};
use crate::cases::handouts::SITES;
use crate::cases::numbers::{self, store_any, store_last};
use crate::cases::random::Random;
use crate::cases::starts::triangles;
use crate::checks::walks::{blind, half_edges};
use crate::protocol::{Start, Structure};
use dcel_kit::plane::predicates::{in_circle, orientation};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::{HalfEdgeRow, Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Points, and the corners of triangles, counter-clockwise.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Mesh {
    pub(super) name: String,
    pub(super) points: Vec<[f64; 2]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Mesh {
    fn new(name: &str, points: &[[f64; 2]], triangles: &[[u32; 3]]) -> Self {
        Self { name: name.to_owned(), points: points.to_vec(), triangles: triangles.to_vec() }
    }

    /// As a line that a student can type.
    pub(super) fn start(&self) -> Start {
        triangles(&self.points, &self.triangles)
    }

    /// As a table: the triangle t has the half-edges 3t, 3t + 1, 3t + 2 and the face t + 1; those of the outer face 0
    /// come last, in the order of their twins. Vertices and faces know the last of their half-edges.
    pub(super) fn table(&self) -> Table {
        let mut faces: Vec<&[u32]> = vec![&[]];
        faces.extend(self.triangles.iter().map(<[u32; 3]>::as_slice));
        let mut table = from_cycles(&self.points, &faces);
        let border: Vec<HalfEdgeId> = half_edges(&table).filter(|&h| table.twin(h).is_none()).collect();
        let mut leaving: BTreeMap<Option<VertexId>, HalfEdgeId> = BTreeMap::new();
        for &own in &border {
            let new = HalfEdgeId::new(table.half_edges.len() as u32);
            let origin = table.next(own).and_then(|next| table.origin(next));
            let row = HalfEdgeRow { origin, twin: Some(own), face: table.outer_face, ..HalfEdgeRow::default() };
            table.half_edges.push(Some(row));
            leaving.insert(origin, new);
            if let Some(row) = row_mut(&mut table, own) {
                row.twin = Some(new);
            }
        }
        for own in border {
            if let Some((h, &next)) = table.twin(own).zip(leaving.get(&table.origin(own))) {
                link(&mut table, h, next);
            }
        }
        let all = half_edges(&table);
        store_last(&mut table, all);
        table
    }

    fn subdivision(&self) -> Option<Subdivision> {
        Subdivision::from_triangles(self.points.iter().copied().map(Point::from).collect(), &self.triangles).ok()
    }

    /// The triangulation after flips at random.
    pub(super) fn shaken(&self, random: &mut Random) -> Option<Self> {
        let mut built = self.subdivision()?;
        for _ in 0..2 * self.triangles.len() {
            let edges: Vec<HalfEdgeId> = built.edges().map(|edge| edge.half_edges()[0]).collect();
            if let Some(&h) = random.pick(&edges).filter(|&&h| built.can_flip_edge(h).is_ok()) {
                built.flip_edge(h).ok()?;
            }
        }
        let corners = |f| built.incident_vertices(f).map(VertexId::number).collect::<Vec<u32>>().try_into().ok();
        Some(Self { triangles: built.faces().skip(1).map(corners).collect::<Option<_>>()?, ..self.clone() })
    }
}

/// Points joined from left to right, each with all that it sees. Nothing if they are on one line.
pub(super) fn swept(name: &str, points: &[[f64; 2]]) -> Option<Mesh> {
    let at = |v: u32| Point::from(points[v as usize]);
    let turn = |a: u32, b: u32, c: u32| orientation(at(a), at(b), at(c));
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by(|&a, &b| at(a).x.total_cmp(&at(b).x).then(at(a).y.total_cmp(&at(b).y)));
    // The first ones may be on one line; the first that is not is joined with all of them.
    let apex = (2..order.len()).find(|&k| turn(order[0], order[1], order[k]).is_ne())?;
    let mut hull: Vec<u32> = order[..apex].to_vec();
    if turn(order[0], order[1], order[apex]).is_lt() {
        hull.reverse();
    }
    let mut all: Vec<[u32; 3]> = hull.windows(2).map(|pair| [pair[0], pair[1], order[apex]]).collect();
    hull.push(order[apex]);
    for &p in &order[apex + 1..] {
        let n = hull.len();
        let sees = |i: usize| turn(hull[i % n], hull[(i + 1) % n], p).is_lt();
        let first = (0..n).find(|&i| sees(i) && !sees(i + n - 1))?;
        let count = (0..n).take_while(|&k| sees(first + k)).count();
        all.extend((first..first + count).map(|i| [hull[(i + 1) % n], hull[i % n], p]));
        hull = (first + count..=first + n).map(|i| hull[i % n]).chain([p]).collect();
    }
    Some(Mesh::new(name, points, &all))
}

/// Triangles round the first of some points, which see each other in this order.
fn fan(name: &str, points: &[[f64; 2]]) -> Mesh {
    let all: Vec<[u32; 3]> = (1..points.len() as u32 - 1).map(|i| [0, i, i + 1]).collect();
    Mesh::new(name, points, &all)
}

/// So many times so many square cells, cut this way or that.
fn grid(name: &str, n: u32) -> Mesh {
    let points: Vec<[f64; 2]> =
        (0..=n).flat_map(|y| (0..=n).map(move |x| [f64::from(x) * 3.0, f64::from(y) * 3.0])).collect();
    let mut all = Vec::new();
    for (x, y) in (0..n).flat_map(|y| (0..n).map(move |x| (x, y))) {
        let a = y * (n + 1) + x;
        let [b, c, d] = [a + 1, a + n + 2, a + n + 1];
        all.extend(if (x + y) % 3 == 0 { [[a, b, d], [b, c, d]] } else { [[a, b, c], [a, c, d]] });
    }
    Mesh::new(name, &points, &all)
}

/// Cells that lean over, each cut along its long diagonal.
pub(super) fn slanted_mesh(n: u32, m: u32) -> Mesh {
    let points: Vec<[f64; 2]> = (0..=m).flat_map(|y| (0..=n).map(move |x| [f64::from(x + y), f64::from(y)])).collect();
    let cells = (0..m).flat_map(|y| (0..n).map(move |x| y * (n + 1) + x));
    let all: Vec<[u32; 3]> = cells.flat_map(|a| [[a, a + 1, a + n + 2], [a, a + n + 2, a + n + 1]]).collect();
    Mesh::new("slanted", &points, &all)
}

/// The same as a line whose structure is known.
pub(super) fn slanted(n: u32, m: u32) -> Start {
    Start::known(format!("slanted {n} {m}"), Structure::HalfEdges(Arc::new(slanted_mesh(n, m).table())))
}

/// All points with whole coordinates on a circle about (0, 0), which are `count`, counter-clockwise.
fn on_circle(radius: i64) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = Vec::new();
    for x in -radius..=radius {
        let y = ((radius * radius - x * x) as f64).sqrt().round() as i64;
        if x * x + y * y == radius * radius {
            all.push([x as f64, y as f64]);
            if y > 0 {
                all.push([x as f64, -y as f64]);
            }
        }
    }
    all.sort_by(|p, q| p[1].atan2(p[0]).total_cmp(&q[1].atan2(q[0])));
    all
}

/// A polygon on a circle, cut from side to side, all of it legal; and a further vertex inside its first triangle. So
/// one flip makes the next one due, from one end to the other.
pub(super) fn wave(name: &str, radius: i64, backwards: bool) -> Mesh {
    let mut points = on_circle(radius);
    let (mut low, mut high) = (0, points.len() as u32 - 1);
    let mut all = Vec::new();
    while low + 1 < high {
        all.push([low, low + 1, high]);
        low += 1;
        if low + 1 < high {
            all.push([low, high - 1, high]);
            high -= 1;
        }
    }
    let first = all.remove(0);
    let mean = [0, 1].map(|axis| first.iter().map(|&v| points[v as usize][axis]).sum::<f64>() / 3.0);
    let p = points.len() as u32;
    points.push(mean);
    all.splice(0..0, (0..3).map(|i| [first[i], first[(i + 1) % 3], p]));
    if backwards {
        all.reverse();
    }
    Mesh::new(name, &points, &all)
}

/// Triangulations that are always the same, the simplest first.
pub(super) fn fixed() -> Vec<Mesh> {
    let far = 1_000_000_000_000.0;
    let parabola = |n: u32| (0..n).map(|k| [f64::from(k), f64::from(k * k)]).collect::<Vec<_>>();
    let turned = |n: u32| (0..n).map(|k| (k + n - 1) % n).map(|k| parabola(n)[k as usize]).collect::<Vec<_>>();
    let mut all = vec![
        Mesh::new("triangle", &[[0., 0.], [4., 0.], [1., 3.]], &[[0, 1, 2]]),
        Mesh::new("kite", &[[0., 0.], [3., -1.], [6., 0.], [3., 1.]], &[[0, 1, 2], [0, 2, 3]]),
        Mesh::new("legal_kite", &[[0., 0.], [3., -1.], [6., 0.], [3., 1.]], &[[0, 1, 3], [1, 2, 3]]),
        Mesh::new("square", &[[0., 0.], [4., 0.], [4., 4.], [0., 4.]], &[[0, 1, 2], [0, 2, 3]]),
        Mesh::new("arrow", &[[0., 0.], [4., 0.], [4., 3.], [2., 1.]], &[[0, 1, 3], [1, 2, 3]]),
        Mesh::new("arrow_back", &[[2., 1.], [4., 3.], [0., 0.], [4., 0.]], &[[2, 3, 0], [0, 3, 1]]),
        Mesh::new("straight", &[[0., 0.], [2., 0.], [4., 0.], [3., 5.]], &[[0, 1, 3], [1, 2, 3]]),
        Mesh::new("straight_top", &[[0., 0.], [3., -5.], [4., 0.], [1., 0.]], &[[3, 0, 1], [3, 1, 2]]),
        Mesh::new("inside", &[[0., 0.], [9., 0.], [3., 8.], [4., 3.]], &[[0, 1, 3], [1, 2, 3], [2, 0, 3]]),
        fan("pentagon", &turned(5)),
        fan("legal_pentagon", &parabola(5)),
        // An edge that a flip makes illegal on a side that is not the next or the one before.
        fan("fan", &[[0., 0.], [3., -2.], [6., -2.], [9., 0.], [6., 2.], [3., 2.]]),
        Mesh::new("thin", &[[0., 0.], [1e8, 0.], [4e7, 1.]], &[[0, 1, 2]]),
        Mesh::new(
            "bay",
            &[[0., 0.], [8., 0.], [9., 5.], [5., 2.], [1., 6.], [3., 1.]],
            &[[0, 1, 5], [1, 3, 5], [1, 2, 3], [0, 5, 4], [4, 5, 3]],
        ),
        // The nearest vertex beyond an edge may be in the circle though the corner across is not.
        Mesh::new(
            "behind",
            &[[0., 0.], [10., 0.], [5., 2.], [5., -9.], [13., -4.], [5., -1.]],
            &[[0, 1, 2], [0, 5, 1], [0, 3, 5], [5, 3, 1], [1, 3, 4]],
        ),
        grid("grid", 3),
        Mesh { name: "slanted".to_owned(), ..slanted_mesh(3, 2) },
        fan("parabola", &turned(12)),
        wave("circle", 65, false),
    ];
    let lines: [(&str, &[[f64; 2]]); 6] = [
        ("sites", &SITES),
        ("hexagon", &[[0., 0.], [6., 0.], [3., 5.], [-3., 5.], [-6., 0.], [-3., -5.], [3., -5.]]),
        ("tenths", &[[0.1, 0.2], [3.3, 0.7], [2.9, 2.3], [0.3, 3.1], [1.7, 1.3], [0.7, 1.9]]),
        ("tiny", &[[1e-30, 0.], [5e-30, 1e-30], [3e-30, 4e-30], [3e-30, 1.5e-30]]),
        ("far", &[[far, far], [far + 5., far - 1.], [far + 6., far + 4.], [far + 1., far + 5.], [far + 3., far + 1.]]),
        ("far_square", &[[1e15, 1e15], [1e15 + 4., 1e15], [1e15 + 4., 1e15 + 4.], [1e15, 1e15 + 4.]]),
    ];
    all.extend(lines.into_iter().filter_map(|(name, points)| swept(name, points)));
    all.extend(nearly_round());
    let mut random = Random::new(7, "large");
    all.push(fan("parabola_of_40", &turned(40)));
    all.extend(swept("large", &random.places(120, 10_000)));
    all
}

/// Quadrilaterals whose corners are nearly on one circle: doubles mistake some of them.
fn nearly_round() -> Vec<Mesh> {
    let mut random = Random::new(7, "nearly round");
    let mut all: Vec<Mesh> = Vec::new();
    // As many that doubles mistake, of those that are not legal and of those that are.
    let mut left = [3, 3];
    let round = on_circle(5);
    for _ in 0..4000 {
        let (x, y) = (random.below(900) as f64 / 10.0 + 0.1, random.below(900) as f64 / 10.0 + 0.2);
        let scale = (1 + random.below(40)) as f64 / 10.0;
        let mut chosen = random.order(round.len());
        chosen.truncate(4);
        chosen.sort_unstable();
        let points = [0, 1, 2, 3].map(|i| {
            let [u, v] = round[chosen[i]];
            [x + scale * u, y + scale * v]
        });
        let [a, b, c, d] = points.map(Point::from);
        let legal = !in_circle(a, c, d, b).is_gt();
        let mistaken = mistakes::rounded_is_legal([points[0], points[2], points[3], points[1]]) != legal;
        let turns = orientation(a, b, c).is_gt() && orientation(a, c, d).is_gt();
        if turns && mistaken && left[usize::from(legal)] > 0 {
            left[usize::from(legal)] -= 1;
            all.push(Mesh::new(&format!("nearly_round_{}", all.len()), &points, &[[0, 1, 2], [0, 2, 3]]));
        }
    }
    all
}

/// A triangulation that looks random, of points some of which lie on one circle, swept or shaken.
pub(super) fn random(random: &mut Random, name: &str, most: usize) -> Option<Mesh> {
    let count = 4 + random.below(most);
    let size = if random.below(2) == 0 { 7 } else { 100 };
    let mesh = swept(name, &random.places(count, size))?;
    if random.below(2) == 0 { mesh.shaken(random) } else { Some(mesh) }
}

/// The same structure with other numbers of its half-edges and faces, the outer one too, and other stored half-edges.
pub(super) fn renumbered(table: &Table, random: &mut Random) -> Table {
    let (of_half_edges, of_faces) = (random.order(table.half_edges.len()), random.order(table.faces.len()));
    let half_edge = |h: HalfEdgeId| HalfEdgeId::new(of_half_edges[h.index()] as u32);
    let face = |f: FaceId| FaceId::new(of_faces[f.index()] as u32);
    let mut out = numbers::renumbered(table, |v| v, half_edge, face);
    store_any(&mut out, half_edges(table).map(half_edge), random);
    out
}

/// Links only, after flips that need not be possible in the plane: vertices of three, two and more edges, several edges
/// between two vertices.
pub(super) fn odd(mesh: &Mesh, random: &mut Random) -> Table {
    let mut table = blind(&mesh.table());
    for _ in 0..3 * mesh.triangles.len() {
        let all: Vec<HalfEdgeId> = half_edges(&table).filter(|&h| flip::is_plain(&table, h)).collect();
        if let Some(&h) = random.pick(&all) {
            flip::flip(&mut table, h);
        }
    }
    renumbered(&table, random)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::violations;

    fn is_sound(mesh: &Mesh) {
        assert_eq!(violations(&mesh.table()), [], "{}", mesh.name);
        assert!(mesh.subdivision().is_some(), "{} is no triangulation", mesh.name);
    }

    #[test]
    fn all_triangulations_are_sound() {
        let mut from = Random::new(3, "meshes");
        let mut all = fixed();
        assert_eq!(all.len(), 19 + 6 + 6 + 2);
        all.extend((0..40).filter_map(|i| random(&mut from, &format!("{i}"), 12)));
        all.extend([wave("wave", 32_045, false), wave("wave", 32_045, true), slanted_mesh(9, 5)]);
        all.iter().for_each(is_sound);
        let sizes: Vec<usize> = [65, 32_045].map(|radius| on_circle(radius).len()).into();
        assert_eq!(sizes, [36, 324]);
    }

    #[test]
    fn numbers_change_and_nothing_else() {
        let mut from = Random::new(3, "numbers");
        for mesh in fixed() {
            let table = renumbered(&mesh.table(), &mut from);
            assert_eq!(violations(&table), [], "{}", mesh.name);
            let points = table.vertices.iter().flatten().filter_map(|row| row.position).collect::<Vec<_>>();
            assert_eq!(points, mesh.points);
            assert!(dcel_kit::topology::isomorphic(&table, &mesh.table()).is_ok(), "{}", mesh.name);
            assert_eq!(violations(&odd(&mesh, &mut from)), [], "{}", mesh.name);
        }
    }
}
