//! An independent answer to "which faces do these edges cut the plane into": all from scratch, from points and
//! edges alone, in whole numbers, in quadratic time. It shares no code with the library.

use dcel_kit::plane::Subdivision;
use dcel_kit::topology::InnerComponent;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// A face as the set of its cycles; a cycle as its vertex numbers, rotated so that the smallest form comes
/// first; an isolated vertex as a cycle of one.
pub(crate) type Face = BTreeSet<Vec<u32>>;

/// The least rotation.
pub(crate) fn canonical(cycle: &[u32]) -> Vec<u32> {
    (0..cycle.len()).map(|i| [&cycle[i..], &cycle[..i]].concat()).min().unwrap_or_default()
}

/// The faces as the subdivision has them: `f0` and the others.
pub(crate) fn faces_of(s: &Subdivision) -> (Face, BTreeMap<Face, u32>) {
    let face = |f| -> Face {
        let cycles = s.cycles(f).map(|h| s.cycle(h).map(|h| s.origin(h).number()).collect::<Vec<_>>());
        let isolated = s.inner_components(f).iter().filter_map(|ring| match ring {
            InnerComponent::Isolated(v) => Some(vec![v.number()]),
            InnerComponent::Cycle(_) => None,
        });
        let all: Vec<Vec<u32>> = cycles.chain(isolated).map(|c| canonical(&c)).collect();
        let set: Face = all.iter().cloned().collect();
        assert_eq!(set.len(), all.len(), "{f} lists a cycle twice");
        set
    };
    let bounded: Vec<_> = s.faces().filter(|&f| f != s.outer_face()).collect();
    let map: BTreeMap<Face, u32> = bounded.iter().map(|&f| (face(f), f.number())).collect();
    assert_eq!(map.len(), bounded.len(), "two faces with the same cycles");
    (face(s.outer_face()), map)
}

/// The faces that the edges of the subdivision cut the plane into, traced anew.
pub(crate) fn trace(s: &Subdivision) -> (Face, BTreeSet<Face>) {
    let points: BTreeMap<u32, (i128, i128)> = s.vertices().map(|v| (v.number(), whole(s, v))).collect();
    let mut around: BTreeMap<u32, Vec<u32>> = points.keys().map(|&v| (v, Vec::new())).collect();
    for e in s.edges() {
        let [a, b] = e.half_edges().map(|h| s.origin(h).number());
        around.get_mut(&a).expect("an end is a vertex").push(b);
        around.get_mut(&b).expect("an end is a vertex").push(a);
    }
    for (v, list) in &mut around {
        list.sort_by(|a, b| compare_angle(points[v], points[a], points[b]));
    }
    let mut cycles: Vec<Vec<u32>> = Vec::new();
    let mut seen: BTreeSet<(u32, u32)> = BTreeSet::new();
    for (&u, list) in &around {
        for &v in list {
            let (mut a, mut b) = (u, v);
            let mut cycle = Vec::new();
            while seen.insert((a, b)) {
                cycle.push(a);
                // Turn as far left as possible: the neighbour before the way back, counter-clockwise.
                let at = around[&b].iter().position(|&w| w == a).expect("edges are listed at both ends");
                let next = around[&b][(at + around[&b].len() - 1) % around[&b].len()];
                (a, b) = (b, next);
            }
            if !cycle.is_empty() {
                cycles.push(cycle);
            }
        }
    }
    cycles.extend(around.iter().filter(|(_, list)| list.is_empty()).map(|(&v, _)| vec![v]));

    let (bounds, rings): (Vec<Vec<u32>>, Vec<Vec<u32>>) = cycles.into_iter().partition(|c| area(&points, c) > 0);
    let mut outer = Face::new();
    let mut faces: Vec<Face> = bounds.iter().map(|c| Face::from([canonical(c)])).collect();
    for ring in rings {
        let v = *ring.iter().min_by_key(|v| points[v]).expect("no cycle is empty");
        let home = (0..bounds.len())
            .filter(|&i| !bounds[i].contains(&v) && winds(&points, &bounds[i], points[&v]))
            .min_by_key(|&i| area(&points, &bounds[i]));
        match home {
            Some(i) => faces[i].insert(canonical(&ring)),
            None => outer.insert(canonical(&ring)),
        };
    }
    (outer, faces.into_iter().collect())
}

/// Coordinates as whole numbers of 2^-40: exact for the points of the tests.
fn whole(s: &Subdivision, v: dcel_kit::VertexId) -> (i128, i128) {
    let p = s.point(v);
    let scale = |x: f64| {
        let y = x * (1u64 << 40) as f64;
        assert!(y.fract() == 0.0 && y.abs() < 1e30, "{x} is no multiple of 2^-40");
        y as i128
    };
    (scale(p.x), scale(p.y))
}

fn cross(o: (i128, i128), a: (i128, i128), b: (i128, i128)) -> i128 {
    (a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0)
}

fn compare_angle(o: (i128, i128), a: (i128, i128), b: (i128, i128)) -> Ordering {
    let upper = |p: (i128, i128)| p.1 > o.1 || (p.1 == o.1 && p.0 > o.0);
    upper(b).cmp(&upper(a)).then_with(|| 0.cmp(&cross(o, a, b)))
}

fn area(points: &BTreeMap<u32, (i128, i128)>, cycle: &[u32]) -> i128 {
    let sides = cycle.iter().zip(cycle.iter().cycle().skip(1));
    sides.map(|(a, b)| cross((0, 0), points[a], points[b])).sum()
}

/// Winding number by quarter turns, not zero.
fn winds(points: &BTreeMap<u32, (i128, i128)>, cycle: &[u32], q: (i128, i128)) -> bool {
    let mut winding = 0;
    for (a, b) in cycle.iter().zip(cycle.iter().cycle().skip(1)) {
        let (a, b) = (points[a], points[b]);
        if a.1 <= q.1 && b.1 > q.1 && cross(a, b, q) > 0 {
            winding += 1;
        }
        if a.1 > q.1 && b.1 <= q.1 && cross(a, b, q) < 0 {
            winding -= 1;
        }
    }
    winding != 0
}

/// Fails with a message that starts with `context` unless the subdivision has exactly the traced faces.
pub(crate) fn assert_traced(s: &Subdivision, context: &str) {
    let (outer, faces) = faces_of(s);
    let (traced_outer, traced) = trace(s);
    assert_eq!(outer, traced_outer, "{context}: the outer face");
    assert_eq!(faces.keys().cloned().collect::<BTreeSet<_>>(), traced, "{context}: the bounded faces");
    for f in s.faces() {
        for h in s.cycles(f) {
            assert!(s.cycle(h).all(|g| s.face(g) == f), "{context}: a half-edge on a cycle of {f} points elsewhere");
        }
    }
    assert_eq!(s.geometry_violations(), [], "{context}");
}

/// A small generator of numbers (xorshift), printed by its seed.
pub(crate) struct Numbers(u64);

impl Numbers {
    pub(crate) fn new(seed: u64) -> Self {
        let mut numbers = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        (0..8).for_each(|_| {
            numbers.below(2);
        });
        numbers
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % bound
    }
}
