//! Meshes of triangles: made, numbered, read.
//!
//! ```text
//!   points, triangles ──build──▶ Table     the triangle t is f(t+1); the k-th edge that is stated has h(2k), h(2k+1);
//!                                          all that is no triangle is f0, whose half-edges are the walls
//! ```
//!
//! Written independently of the student's program, which makes the same of the same lines.

use crate::cases::cycles::sides_of;
use crate::cases::numbers::renumbered;
use crate::cases::random::Random;
use crate::checks::walks::{self, cycle};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{PlanarView, Point, Subdivision};
use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::cmp::Ordering;
use std::collections::{BTreeMap, VecDeque};

/// A point as two numbers.
pub(super) type Spot = [f64; 2];

/// Which way three points turn; `Greater` is to the left.
pub(super) fn turn(a: Spot, b: Spot, c: Spot) -> Ordering {
    orientation(a.into(), b.into(), c.into())
}

/// Whether two points are the same.
pub(super) fn same(a: Spot, b: Spot) -> bool {
    a.iter().zip(b).all(|(a, b)| a - b == 0.0)
}

/// The mesh of some triangles, each counter-clockwise. Every point is a corner of one.
pub(super) fn build(points: &[Spot], triangles: &[[usize; 3]]) -> Table {
    let id = |h: usize| Some(HalfEdgeId::new(h as u32));
    let (ends, sides) = sides_of(triangles);
    let mut face = vec![0; ends.len()];
    let mut next = vec![0; ends.len()];
    for (t, three) in sides.iter().enumerate() {
        for i in 0..3 {
            face[three[i]] = t + 1;
            next[three[i]] = three[(i + 1) % 3];
        }
    }
    let mut walls_from: Vec<Vec<usize>> = vec![Vec::new(); points.len()];
    for h in (0..ends.len()).filter(|&h| face[h] == 0) {
        walls_from[ends[h][0]].push(h);
    }
    for h in (0..ends.len()).filter(|&h| face[h] == 0) {
        // Through what is outside: clockwise from the way back.
        let at = points[ends[h][1]];
        let clockwise = |g: usize| {
            let angle = |p: Spot| (p[1] - at[1]).atan2(p[0] - at[0]);
            (angle(points[ends[h][0]]) - angle(points[ends[g][1]])).rem_euclid(std::f64::consts::TAU)
        };
        let walls = &walls_from[ends[h][1]];
        next[h] = walls.iter().copied().min_by(|&a, &b| clockwise(a).total_cmp(&clockwise(b))).unwrap_or(h);
    }
    let mut prev = vec![0; ends.len()];
    next.iter().enumerate().for_each(|(h, &next)| prev[next] = h);
    let mut outgoing = vec![None; points.len()];
    for &h in sides.iter().flatten() {
        outgoing[ends[h][0]].get_or_insert(h);
    }
    let row = |h: usize| HalfEdgeRow {
        origin: Some(VertexId::new(ends[h][0] as u32)),
        twin: id(h ^ 1),
        next: id(next[h]),
        prev: id(prev[h]),
        face: Some(FaceId::new(face[h] as u32)),
    };
    let stored = |h: Option<usize>| Some(FaceRow { half_edge: h.and_then(id), ..FaceRow::default() });
    let first_wall = (0..ends.len()).find(|&h| face[h] == 0);
    let vertex = |(v, &p): (usize, &Spot)| VertexRow { position: Some(p), outgoing: outgoing[v].and_then(id) };
    Table {
        outer_face: Some(FaceId::new(0)),
        vertices: points.iter().enumerate().map(|at| Some(vertex(at))).collect(),
        half_edges: (0..ends.len()).map(|h| Some(row(h))).collect(),
        faces: std::iter::once(stored(first_wall)).chain(sides.iter().map(|three| stored(Some(three[0])))).collect(),
    }
}

/// Square cells, row by row from below, each cut in two by a diagonal that goes up.
pub(super) fn cells(n: usize, m: usize) -> Table {
    let points: Vec<Spot> = (0..(n + 1) * (m + 1)).map(|v| [(v % (n + 1)) as f64, (v / (n + 1)) as f64]).collect();
    let corner = |cell: usize| cell / n * (n + 1) + cell % n;
    let triangles: Vec<[usize; 3]> = (0..n * m)
        .flat_map(|cell| {
            let [a, d] = [corner(cell), corner(cell) + n + 1];
            [[a, a + 1, d + 1], [a, d + 1, d]]
        })
        .collect();
    build(&points, &triangles)
}

/// Triangles of random points with small whole coordinates, locally Delaunay; some are left out, so that there are
/// walls inside, and parts that do not hang together.
pub(super) fn random_mesh(random: &mut Random, count: usize) -> Option<Table> {
    let points: Vec<Point> = (0..count).map(|_| Point::new(random.below(13) as f64, random.below(11) as f64)).collect();
    let all = Subdivision::delaunay(&points).ok()?.subdivision;
    let table = Table::from_view(&all);
    let place = |v: u32| all.position(VertexId::new(v)).map_or([0.0; 2], |p| [p.x, p.y]);
    let mut numbers: BTreeMap<u32, usize> = BTreeMap::new();
    let (mut spots, mut triangles) = (Vec::new(), Vec::new());
    for f in 0..table.faces.len() as u32 {
        let f = FaceId::new(f);
        let corners = table.half_edge(f).filter(|_| table.outer_face != Some(f)).map(|h| corners_from(&table, h));
        let Some(corners) = corners.filter(|corners| corners.len() == 3 && random.below(6) > 0) else { continue };
        let mut three = [0; 3];
        for (slot, v) in three.iter_mut().zip(corners) {
            *slot = *numbers.entry(v).or_insert_with(|| {
                spots.push(place(v));
                spots.len() - 1
            });
        }
        triangles.push(three);
    }
    (!triangles.is_empty()).then(|| build(&spots, &triangles))
}

/// A mesh that grows triangle by triangle, each at a wall of the others, so that exactly one corridor leads from any of
/// them to any other. No point lies on a triangle that it is no corner of.
pub(super) fn random_tree(random: &mut Random, count: usize) -> Table {
    let mut points: Vec<Spot> = vec![[0.0, 0.0], [8.0, 0.0], [3.0, 7.0]];
    let mut triangles = vec![[0, 1, 2]];
    let mut walls = vec![[0, 1], [1, 2], [2, 0]];
    let mut tries = 0;
    while triangles.len() < count && tries < 400 {
        tries += 1;
        let which = random.below(walls.len());
        let [a, b] = walls[which];
        let middle = [0, 1].map(|axis| ((points[a][axis] + points[b][axis]) / 2.0).floor());
        let p = middle.map(|x| x + random.below(17) as f64 - 8.0);
        // On the right of the wall: outside.
        let corners = [points[b], points[a], p];
        let is_free = turn(corners[0], corners[1], p) == Ordering::Greater
            && triangles.iter().all(|other: &[usize; 3]| apart(corners, other.map(|v| points[v])))
            && triangles.iter().all(|other: &[usize; 3]| !contains(other.map(|v| points[v]), p))
            && points.iter().enumerate().all(|(v, &q)| v == a || v == b || !contains(corners, q));
        if is_free {
            let new = points.len();
            points.push(p);
            triangles.push([b, a, new]);
            walls.swap_remove(which);
            walls.extend([[a, new], [new, b]]);
        }
    }
    build(&points, &triangles)
}

/// Whether a point lies in a triangle, its border included.
pub(super) fn contains([a, b, c]: [Spot; 3], p: Spot) -> bool {
    [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| turn(from, to, p) != Ordering::Less)
}

/// Whether the insides of two triangles have no point in common: a side of one has the other on its right.
pub(super) fn apart(one: [Spot; 3], other: [Spot; 3]) -> bool {
    let separates = |of: [Spot; 3], from: [Spot; 3]| {
        (0..3).any(|i| from.iter().all(|&p| turn(of[i], of[(i + 1) % 3], p) != Ordering::Greater))
    };
    separates(one, other) || separates(other, one)
}

/// The same mesh with other numbers of faces and edges; any face is the outer one, any half-edge is stored.
pub(super) fn relabelled(table: &Table, random: &mut Random) -> Table {
    let faces = random.order(table.faces.len());
    let edges = random.order(table.half_edges.len() / 2);
    let flips: Vec<usize> = edges.iter().map(|_| random.below(2)).collect();
    let new_h =
        |h: HalfEdgeId| HalfEdgeId::new((2 * edges[h.index() / 2] + (h.index() ^ flips[h.index() / 2]) % 2) as u32);
    let new_f = |f: FaceId| FaceId::new(faces[f.index()] as u32);
    let mut out = renumbered(table, |v| v, new_h, new_f);
    for (f, row) in table.faces.iter().enumerate() {
        let Some(mut stored) = row.as_ref().and_then(|row| row.half_edge) else { continue };
        for _ in 0..random.below(3) {
            stored = table.next(stored).unwrap_or(stored);
        }
        let row = FaceRow { half_edge: Some(new_h(stored)), ..FaceRow::default() };
        out.faces[faces[f]] = Some(row);
    }
    out
}

fn corners_from(table: &Table, h: HalfEdgeId) -> Vec<u32> {
    cycle(table, h).into_iter().filter_map(|h| table.origin(h)).map(VertexId::number).collect()
}

/// Whether there is such a face, and it is a triangle.
pub(super) fn is_triangle(table: &Table, f: u32) -> bool {
    (f as usize) < table.faces.len() && table.outer_face != Some(FaceId::new(f))
}

/// All triangles.
pub(super) fn triangles(table: &Table) -> impl Iterator<Item = u32> + '_ {
    (0..table.faces.len() as u32).filter(|&f| is_triangle(table, f))
}

/// The sides of a triangle, counter-clockwise from the stored one.
pub(super) fn sides(table: &Table, f: u32) -> Vec<HalfEdgeId> {
    table.half_edge(FaceId::new(f)).map_or_else(Vec::new, |h| cycle(table, h))
}

/// The place of a vertex.
pub(super) fn place(table: &Table, v: VertexId) -> Spot {
    walks::place(table, v).unwrap_or_default()
}

/// The corners of a triangle.
pub(super) fn corners(table: &Table, f: u32) -> Option<[Spot; 3]> {
    let corners: Vec<Spot> = sides(table, f).into_iter().filter_map(|h| Some(place(table, table.origin(h)?))).collect();
    corners.try_into().ok()
}

/// What is on the other side of each side of a triangle, walls left out.
pub(super) fn neighbours(table: &Table, f: u32) -> Vec<u32> {
    let across = |h: HalfEdgeId| table.twin(h).and_then(|twin| table.face(twin)).map(FaceId::number);
    sides(table, f).into_iter().filter_map(across).filter(|&g| is_triangle(table, g)).collect()
}

/// How many steps each face is away from a triangle; `None` for those that cannot be reached.
pub(super) fn distances(table: &Table, from: u32) -> Vec<Option<u32>> {
    let mut away = vec![None; table.faces.len()];
    let mut queue = VecDeque::from([(from, 0)]);
    while let Some((f, steps)) = queue.pop_front() {
        if is_triangle(table, f) && away[f as usize].is_none() {
            away[f as usize] = Some(steps);
            queue.extend(neighbours(table, f).into_iter().map(|g| (g, steps + 1)));
        }
    }
    away
}

/// A corridor with as few triangles as possible.
pub(super) fn corridor(table: &Table, start: u32, goal: u32) -> Option<Vec<u32>> {
    let away = distances(table, goal);
    let steps = |f: u32| away.get(f as usize).copied().flatten();
    steps(start).filter(|_| is_triangle(table, start))?;
    let mut corridor = vec![start];
    let mut at = start;
    while at != goal {
        at = neighbours(table, at).into_iter().find(|&g| steps(g) < steps(at))?;
        corridor.push(at);
    }
    Some(corridor)
}

/// The vertices on the left and on the right of each side that a corridor passes.
pub(super) fn portals(table: &Table, corridor: &[u32]) -> Option<Vec<[VertexId; 2]>> {
    let portal = |pair: &[u32]| {
        let leads = |h: &HalfEdgeId| table.twin(*h).and_then(|twin| table.face(twin)) == Some(FaceId::new(pair[1]));
        let side = sides(table, pair[0]).into_iter().find(leads)?;
        // A triangle is on the left of its sides: who leaves it sees the end of a side on the left.
        Some([table.origin(table.next(side)?)?, table.origin(side)?])
    };
    corridor.windows(2).map(portal).collect()
}

/// The triangles that a point lies in.
pub(super) fn triangles_of(table: &Table, p: Spot) -> Vec<u32> {
    triangles(table).filter(|&f| corners(table, f).is_some_and(|corners| contains(corners, p))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::violations;

    #[test]
    fn meshes_obey_the_laws_of_half_edges() {
        let mut random = Random::new(1, "meshes");
        let mut tables = vec![cells(1, 1), cells(20, 7)];
        tables.extend((0..40).map(|i| random_tree(&mut random, 2 + i % 9)));
        for table in tables {
            let other = relabelled(&table, &mut random);
            for table in [&table, &other] {
                assert_eq!(violations(table), []);
                assert!(triangles(table).all(|f| corners(table, f).is_some_and(|[a, b, c]| turn(a, b, c).is_gt())));
            }
        }
    }

    #[test]
    fn random_meshes_are_locally_delaunay_and_have_walls_inside() {
        use dcel_kit::plane::predicates::in_circle;
        let mut random = Random::new(2, "meshes");
        let mut outer_cycles = 0;
        for _ in 0..60 {
            let Some(table) = random_mesh(&mut random, 12) else { continue };
            let mut walls: Vec<HalfEdgeId> = (0..table.half_edges.len() as u32).map(HalfEdgeId::new).collect();
            walls.retain(|&h| table.face(h) == table.outer_face);
            outer_cycles += usize::from(cycle(&table, walls[0]).len() < walls.len());
            for f in triangles(&table) {
                let [a, b, c] = corners(&table, f).unwrap().map(Point::from);
                let inside = |g: u32| corners(&table, g).unwrap().iter().any(|&d| in_circle(a, b, c, d.into()).is_gt());
                assert!(!neighbours(&table, f).into_iter().any(inside), "{f}");
            }
        }
        assert!(outer_cycles > 10, "{outer_cycles}");
    }

    #[test]
    fn corridors_are_as_short_as_the_best_of_all() {
        // All walks without a repetition, by brute force.
        fn fewest(table: &Table, at: u32, goal: u32, seen: &mut Vec<u32>) -> Option<usize> {
            if at == goal {
                return Some(seen.len());
            }
            let mut best = None;
            for g in triangles(table) {
                let shares = |h: &HalfEdgeId| sides(table, g).contains(&HalfEdgeId::new(h.number() ^ 1));
                if !seen.contains(&g) && sides(table, at).iter().any(shares) {
                    seen.push(g);
                    let found = fewest(table, g, goal, seen);
                    best = best.into_iter().chain(found).min();
                    seen.pop();
                }
            }
            best
        }
        let mut random = Random::new(3, "meshes");
        let mut unreachable = 0;
        for _ in 0..40 {
            let Some(table) = random_mesh(&mut random, 8) else { continue };
            for goal in triangles(&table) {
                let best = fewest(&table, 1, goal, &mut vec![1]);
                assert_eq!(corridor(&table, 1, goal).map(|corridor| corridor.len()), best);
                unreachable += usize::from(best.is_none());
            }
        }
        assert!(unreachable > 10, "{unreachable}");
    }
}
