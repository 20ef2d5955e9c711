//! Structures to draw, made from points and segments without the kit's own builders.
//!
//! At every vertex the outgoing half-edges are sorted by angle; `next` of a half-edge is the one clockwise
//! before its twin. A cycle with positive area bounds a face; every other one is a ring of the smallest face
//! round it, or of f0.

use dcel_kit::topology::{FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

pub(crate) type P = [f64; 2];

pub(crate) fn h(i: usize) -> HalfEdgeId {
    HalfEdgeId::new(i as u32)
}

/// The plane subdivided by segments; half-edge 2i runs along segment i. Points without segments are isolated.
pub(crate) fn plane(points: &[P], segments: &[(usize, usize)]) -> Table {
    let ends = |i: usize| {
        let (a, b) = segments[i / 2];
        if i.is_multiple_of(2) { (a, b) } else { (b, a) }
    };
    let count = 2 * segments.len();
    let mut star: Vec<Vec<usize>> = vec![Vec::new(); points.len()];
    for i in 0..count {
        star[ends(i).0].push(i);
    }
    let angle = |i: usize| {
        let (a, b) = ends(i);
        (points[b][1] - points[a][1]).atan2(points[b][0] - points[a][0])
    };
    let mut next = vec![0; count];
    for round in &mut star {
        round.sort_by(|&a, &b| angle(a).total_cmp(&angle(b)));
        for (k, &i) in round.iter().enumerate() {
            next[i ^ 1] = round[(k + round.len() - 1) % round.len()];
        }
    }
    let mut prev = vec![0; count];
    next.iter().enumerate().for_each(|(i, &n)| prev[n] = i);

    let mut cycle_of = vec![usize::MAX; count];
    let mut cycles: Vec<Vec<usize>> = Vec::new();
    for start in 0..count {
        if cycle_of[start] == usize::MAX {
            let mut at = start;
            let mut cycle = Vec::new();
            while cycle_of[at] == usize::MAX {
                cycle_of[at] = cycles.len();
                cycle.push(at);
                at = next[at];
            }
            cycles.push(cycle);
        }
    }
    let ring = |cycle: &[usize]| cycle.iter().map(|&i| points[ends(i).0]).collect::<Vec<P>>();
    let areas: Vec<f64> = cycles.iter().map(|cycle| doubled_area(&ring(cycle))).collect();
    let bounded: Vec<usize> = (0..cycles.len()).filter(|&c| areas[c] > 1e-12).collect();
    let mut faces = vec![FaceRow::default()];
    let mut face_of_cycle = vec![0; cycles.len()];
    for &c in &bounded {
        face_of_cycle[c] = faces.len();
        faces.push(FaceRow { half_edge: Some(h(cycles[c][0])), ..FaceRow::default() });
    }
    let home = |p: P, own: &[usize], face_of_cycle: &[usize]| {
        let candidates = bounded.iter().copied().filter(|&c| {
            let r = ring(&cycles[c]);
            !own.iter().any(|&i| cycle_of[i ^ 1] == c && own.contains(&i) && touches(&r, p)) && inside(&r, p)
        });
        candidates.min_by(|&a, &b| areas[a].total_cmp(&areas[b])).map_or(0, |c| face_of_cycle[c])
    };
    for c in 0..cycles.len() {
        if areas[c] > 1e-12 {
            continue;
        }
        let leftmost = cycles[c]
            .iter()
            .map(|&i| points[ends(i).0])
            .min_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        let face = home(leftmost.unwrap(), &cycles[c], &face_of_cycle);
        face_of_cycle[c] = face;
        let first = h(cycles[c][0]);
        if face == 0 && faces[0].half_edge.is_none() {
            faces[0].half_edge = Some(first);
        } else {
            faces[face].inner_components.push(InnerComponent::Cycle(first));
        }
    }
    for (v, round) in star.iter().enumerate() {
        if round.is_empty() {
            let face = home(points[v], &[], &face_of_cycle);
            faces[face].inner_components.push(InnerComponent::Isolated(VertexId::new(v as u32)));
        }
    }
    let row = |i: usize| HalfEdgeRow {
        origin: Some(VertexId::new(ends(i).0 as u32)),
        twin: Some(h(i ^ 1)),
        next: Some(h(next[i])),
        prev: Some(h(prev[i])),
        face: Some(FaceId::new(face_of_cycle[cycle_of[i]] as u32)),
    };
    Table {
        vertices: points
            .iter()
            .zip(&star)
            .map(|(&p, round)| Some(VertexRow { position: Some(p), outgoing: round.first().map(|&i| h(i)) }))
            .collect(),
        half_edges: (0..count).map(|i| Some(row(i))).collect(),
        faces: faces.into_iter().map(Some).collect(),
        outer_face: Some(FaceId::new(0)),
    }
}

fn doubled_area(ring: &[P]) -> f64 {
    let n = ring.len();
    (0..n).map(|i| ring[i][0] * ring[(i + 1) % n][1] - ring[(i + 1) % n][0] * ring[i][1]).sum()
}

fn touches(ring: &[P], p: P) -> bool {
    ring.contains(&p)
}

fn inside(ring: &[P], p: P) -> bool {
    let n = ring.len();
    if touches(ring, p) {
        return false;
    }
    let crosses = |i: usize| {
        let (a, b) = (ring[i], ring[(i + 1) % n]);
        (a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0]
    };
    (0..n).filter(|&i| crosses(i)).count() % 2 == 1
}

/// A closed polygon as segments from vertex `first` on.
pub(crate) fn closed(first: usize, n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).map(move |i| (first + i, first + (i + 1) % n))
}

pub(crate) fn polygon(points: &[P]) -> Table {
    plane(points, &closed(0, points.len()).collect::<Vec<_>>())
}

/// The cube-like subdivision of the lab's handout: a square in a square, corners joined.
pub(crate) fn cube() -> Table {
    let points = [[0., 0.], [6., 0.], [6., 6.], [0., 6.], [1.8, 1.8], [4.2, 1.8], [4.2, 4.2], [1.8, 4.2]];
    plane(&points, &[(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)])
}

/// Concave face, island, dangling chains, a very short edge, a sharp corner.
pub(crate) fn stress() -> Table {
    let points = [
        [0., 0.],
        [10., 0.],
        [10., 7.],
        [7.4, 7.],
        [7.4, 3.2],
        [2.6, 3.2],
        [2.6, 7.],
        [0., 7.],
        [8.2, 1.],
        [9.2, 1.],
        [8.7, 1.9],
        [1.3, 5.4],
        [1.3, 4.2],
        [4.2, 1.6],
        [4.5, 1.6],
        [12.6, 0.35],
        [3.4, 1.2],
    ];
    let mut segments: Vec<_> = closed(0, 8).chain(closed(8, 3)).collect();
    segments.extend([(7, 11), (11, 12), (5, 13), (13, 14), (1, 15), (15, 2), (13, 16)]);
    plane(&points, &segments)
}

/// A rectangle split by diagonals and halves, as in the lab.
pub(crate) fn lab() -> Table {
    let points = [[0., 0.], [3., 0.], [6., 0.], [6., 4.], [3., 4.], [0., 4.], [3., 2.]];
    let mut segments: Vec<_> = closed(0, 6).collect();
    segments.extend([(1, 6), (6, 4), (6, 2), (0, 6), (6, 3)]);
    plane(&points, &segments)
}

/// A square with an island (itself with an inner square), an isolated vertex, and a second component beside.
pub(crate) fn islands() -> Table {
    let square = |x: f64, y: f64, s: f64| [[x, y], [x + s, y], [x + s, y + s], [x, y + s]];
    let mut points = Vec::new();
    for p in [square(0., 0., 8.), square(2., 2., 4.), square(3., 3., 2.), square(9.5, 1., 2.)] {
        points.extend(p);
    }
    points.extend([[1., 7.], [10.5, 6.]]);
    let segments: Vec<_> = (0..4).flat_map(|k| closed(4 * k, 4)).collect();
    let mut table = plane(&points, &segments);
    let hole = table.half_edges[2 * 8].unwrap().face.unwrap();
    table.faces[hole.index()].as_mut().unwrap().hole = true;
    table
}

/// Two squares that share one vertex.
pub(crate) fn touching() -> Table {
    let points = [[0., 0.], [3., 0.], [3., 3.], [0., 3.], [6., 3.], [6., 6.], [3., 6.]];
    let mut segments: Vec<_> = closed(0, 4).collect();
    segments.extend([(2, 4), (4, 5), (5, 6), (6, 2)]);
    plane(&points, &segments)
}

/// A corner of about one degree, and an edge of about one px.
pub(crate) fn slivers() -> Table {
    let points = [[0., 0.], [10., 0.], [10., 0.175], [10., 5.], [0., 5.], [0., 4.99]];
    let mut segments: Vec<_> = closed(0, 6).collect();
    segments.push((0, 2));
    plane(&points, &segments)
}

/// Isolated vertices a few px away from an edge and from a corner.
pub(crate) fn close() -> Table {
    plane(&[[0., 0.], [6., 0.], [6., 4.], [0., 4.], [3., 0.07], [5.9, 3.9]], &closed(0, 4).collect::<Vec<_>>())
}

/// A wheel with `n` spokes.
pub(crate) fn hub(n: usize) -> Table {
    let mut points = vec![[0., 0.]];
    for i in 0..n {
        let t = i as f64 * std::f64::consts::TAU / n as f64;
        points.push([5. * t.cos(), 5. * t.sin()]);
    }
    let mut segments: Vec<_> = closed(1, n).collect();
    segments.extend((1..=n).map(|i| (0, i)));
    plane(&points, &segments)
}

/// A tree: all half-edges on one cycle of f0.
pub(crate) fn antenna() -> Table {
    plane(&[[0., 0.], [2., 0.], [3., 1.], [3., -1.], [4.5, 1.4], [0.2, 1.5]], &[(0, 1), (1, 2), (1, 3), (2, 4), (0, 5)])
}

/// `n` x `n` vertices, squares or triangles, with known links: no angles, so large grids are fast.
pub(crate) fn grid(n: usize, triangles: bool) -> Table {
    let at = |x: usize, y: usize| y * n + x;
    let points: Vec<P> = (0..n * n).map(|i| [(i % n) as f64, (i / n) as f64]).collect();
    let mut faces: Vec<Vec<usize>> = Vec::new();
    for y in 0..n - 1 {
        for x in 0..n - 1 {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            if triangles {
                faces.extend([vec![a, b, c], vec![a, c, d]]);
            } else {
                faces.push(vec![a, b, c, d]);
            }
        }
    }
    discs(&points, &faces)
}

/// Faces of one disc without holes that touches itself nowhere; twins by matching directed edges.
pub(crate) fn discs(points: &[P], faces: &[Vec<usize>]) -> Table {
    let mut directed = std::collections::HashMap::new();
    let mut edges = Vec::new();
    for face in faces {
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            if !directed.contains_key(&(a, b)) {
                directed.insert((a, b), 2 * edges.len());
                directed.insert((b, a), 2 * edges.len() + 1);
                edges.push((a, b));
            }
        }
    }
    let empty = HalfEdgeRow::default();
    let mut rows = vec![empty; 2 * edges.len()];
    for (i, row) in rows.iter_mut().enumerate() {
        let (a, b) = edges[i / 2];
        row.origin = Some(VertexId::new(if i.is_multiple_of(2) { a } else { b } as u32));
        row.twin = Some(h(i ^ 1));
    }
    let mut face_rows = vec![FaceRow::default()];
    for face in faces {
        let cycle: Vec<usize> = (0..face.len()).map(|k| directed[&(face[k], face[(k + 1) % face.len()])]).collect();
        for (k, &i) in cycle.iter().enumerate() {
            let n = cycle[(k + 1) % cycle.len()];
            rows[i].next = Some(h(n));
            rows[n].prev = Some(h(i));
            rows[i].face = Some(FaceId::new(face_rows.len() as u32));
        }
        face_rows.push(FaceRow { half_edge: Some(h(cycle[0])), ..FaceRow::default() });
    }
    let border: Vec<usize> = (0..rows.len()).filter(|&i| rows[i].face.is_none()).collect();
    let mut leaves = vec![None; points.len()];
    for &i in &border {
        leaves[rows[i].origin.unwrap().index()] = Some(i);
    }
    for &i in &border {
        let n = leaves[rows[i ^ 1].origin.unwrap().index()].unwrap();
        rows[i].next = Some(h(n));
        rows[n].prev = Some(h(i));
        rows[i].face = Some(FaceId::new(0));
    }
    face_rows[0].half_edge = border.first().map(|&i| h(i));
    let mut vertices: Vec<Option<VertexRow>> =
        points.iter().map(|&p| Some(VertexRow { position: Some(p), outgoing: None })).collect();
    for (i, row) in rows.iter().enumerate() {
        vertices[row.origin.unwrap().index()].as_mut().unwrap().outgoing = Some(h(i));
    }
    Table {
        vertices,
        half_edges: rows.into_iter().map(Some).collect(),
        faces: face_rows.into_iter().map(Some).collect(),
        outer_face: Some(FaceId::new(0)),
    }
}

/// Small structures of every kind, by name.
pub(crate) fn all() -> Vec<(&'static str, Table)> {
    vec![
        ("cube", cube()),
        ("stress", stress()),
        ("lab", lab()),
        ("islands", islands()),
        ("touching", touching()),
        ("slivers", slivers()),
        ("hub-12", hub(12)),
        ("hub-200", hub(200)),
        ("dangling edge", antenna()),
        ("close", close()),
        ("grid-4", grid(4, true)),
        ("grid-10", grid(10, true)),
        ("grid-25", grid(25, false)),
        ("one-point", plane(&[[3., 4.]], &[])),
        ("one-edge", plane(&[[0., 0.], [1., 0.]], &[(0, 1)])),
        ("vertical", plane(&[[0., 0.], [0., 1.], [0., 3.]], &[(0, 1), (1, 2)])),
        ("tiny", polygon(&[[0., 0.], [1e-9, 0.], [0., 1e-9]])),
        ("huge", polygon(&[[-1e9, 0.], [1e9, 0.], [0., 2e9]])),
        ("far", polygon(&[[1e9, 1e9], [1e9 + 1e-5, 1e9], [1e9, 1e9 + 1e-5]])),
        ("flat", polygon(&[[0., 0.], [1000., 0.], [1000., 1.], [0., 1.]])),
        ("tall", polygon(&[[0., 0.], [1., 0.], [1., 1000.], [0., 1000.]])),
        ("empty", plane(&[], &[])),
    ]
}
