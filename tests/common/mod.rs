//! What the tests of the kernel share: tables to start from, a second opinion on the invariants, a naive model of the
//! edits, random numbers, and scripts that can be printed and replayed.

#![allow(dead_code, unreachable_pub)] // every test file is a crate of its own and uses its own part of this
#![allow(clippy::unwrap_used)] // a test may panic

pub mod brute;
pub mod model;
pub mod script;

use dcel_kit::topology::{Dcel, FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow};
use dcel_kit::{FaceId, HalfEdgeId, Id, VertexId};
use std::collections::BTreeMap;

pub fn h(number: u32) -> HalfEdgeId {
    HalfEdgeId::new(number)
}

pub fn v(number: u32) -> VertexId {
    VertexId::new(number)
}

pub fn f(number: u32) -> FaceId {
    FaceId::new(number)
}

/// A small random number generator (splitmix64), so that a seed is all there is to print.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    pub fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }

    pub fn shuffled(&mut self, n: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            order.swap(i, self.below(i + 1));
        }
        order
    }
}

/// A plane table from bounded faces given counter-clockwise. `f0` is the outer face; the faces are `f1, f2, ...`
/// in the order given; vertices that no face uses become isolated vertices of `f0`. Every vertex lies on at most
/// one border cycle, once.
pub fn planar(vertices: usize, faces: &[Vec<u32>]) -> Table {
    let mut table = Table { outer_face: Some(f(0)), ..Table::default() };
    table.faces.push(Some(FaceRow::default()));
    let mut by_ends = BTreeMap::new();
    for corners in faces {
        let (start, n) = (table.half_edges.len() as u32, corners.len() as u32);
        let face = f(table.faces.len() as u32);
        for i in 0..n {
            let (from, to) = (corners[i as usize], corners[((i + 1) % n) as usize]);
            by_ends.insert((from, to), h(start + i));
            table.half_edges.push(Some(HalfEdgeRow {
                origin: Some(v(from)),
                twin: None,
                next: Some(h(start + (i + 1) % n)),
                prev: Some(h(start + (i + n - 1) % n)),
                face: Some(face),
            }));
        }
        table.faces.push(Some(FaceRow { half_edge: Some(h(start)), ..FaceRow::default() }));
    }
    let inner = by_ends.clone();
    for (&(from, to), &half) in &inner {
        let twin = *by_ends.entry((to, from)).or_insert_with(|| {
            table.half_edges.push(Some(HalfEdgeRow { origin: Some(v(to)), face: Some(f(0)), ..Default::default() }));
            h(table.half_edges.len() as u32 - 1)
        });
        row(&mut table, half).twin = Some(twin);
        row(&mut table, twin).twin = Some(half);
    }
    let outer: BTreeMap<u32, HalfEdgeId> =
        by_ends.iter().filter(|(ends, _)| !inner.contains_key(ends)).map(|(&(from, _), &half)| (from, half)).collect();
    for (&(from, to), &half) in &by_ends {
        if !inner.contains_key(&(from, to)) {
            let next = outer[&to];
            row(&mut table, half).next = Some(next);
            row(&mut table, next).prev = Some(half);
        }
    }
    table.vertices = vec![Some(VertexRow::default()); vertices];
    for (&(from, _), &half) in &by_ends {
        table.vertices[from as usize].as_mut().unwrap().outgoing = Some(half);
    }
    let mut rings = Vec::new();
    let mut seen = vec![false; table.half_edges.len()];
    for &start in outer.values() {
        let mut at = start;
        if !seen[at.index()] {
            rings.push(InnerComponent::Cycle(start));
        }
        while !std::mem::replace(&mut seen[at.index()], true) {
            at = table.half_edges[at.index()].unwrap().next.unwrap();
        }
    }
    let isolated = (0..vertices as u32).filter(|&i| table.vertices[i as usize].unwrap().outgoing.is_none());
    let isolated: Vec<InnerComponent> = isolated.map(|i| InnerComponent::Isolated(v(i))).collect();
    let face = table.faces[0].as_mut().unwrap();
    if let Some(InnerComponent::Cycle(first)) = rings.first().copied() {
        face.half_edge = Some(first);
        rings.remove(0);
    }
    face.inner_components = rings.into_iter().chain(isolated).collect();
    table
}

pub fn row(table: &mut Table, half: HalfEdgeId) -> &mut HalfEdgeRow {
    table.half_edges[half.index()].as_mut().unwrap()
}

/// The triangulated grid of `columns` by `rows` squares, each cut by one diagonal.
pub fn triangle_grid(columns: u32, rows: u32) -> Table {
    let at = |x, y| y * (columns + 1) + x;
    let squares = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
    let faces = squares.flat_map(|(x, y)| {
        [vec![at(x, y), at(x + 1, y), at(x + 1, y + 1)], vec![at(x, y), at(x + 1, y + 1), at(x, y + 1)]]
    });
    planar(((columns + 1) * (rows + 1)) as usize, &faces.collect::<Vec<_>>())
}

/// The same structure under other numbers, with a few numbers left unused.
pub fn renumbered(table: &Table, random: &mut Random) -> Table {
    let gap = 3;
    let [vs, hs, fs] = [table.vertices.len(), table.half_edges.len(), table.faces.len()]
        .map(|n| random.shuffled(n + gap).into_iter().take(n).map(|i| i as u32).collect::<Vec<u32>>());
    let (to_v, to_h, to_f) =
        (|x: VertexId| v(vs[x.index()]), |x: HalfEdgeId| h(hs[x.index()]), |x: FaceId| f(fs[x.index()]));
    let mut out = Table {
        vertices: vec![None; vs.len() + gap],
        half_edges: vec![None; hs.len() + gap],
        faces: vec![None; fs.len() + gap],
        outer_face: table.outer_face.map(to_f),
    };
    for (i, row) in table.vertices.iter().enumerate() {
        out.vertices[vs[i] as usize] = row.map(|row| VertexRow { outgoing: row.outgoing.map(to_h), ..row });
    }
    for (i, row) in table.half_edges.iter().enumerate() {
        out.half_edges[hs[i] as usize] = row.map(|row| HalfEdgeRow {
            origin: row.origin.map(to_v),
            twin: row.twin.map(to_h),
            next: row.next.map(to_h),
            prev: row.prev.map(to_h),
            face: row.face.map(to_f),
        });
    }
    for (i, row) in table.faces.iter().enumerate() {
        out.faces[fs[i] as usize] = row.as_ref().map(|row| FaceRow {
            half_edge: row.half_edge.map(to_h),
            inner_components: row
                .inner_components
                .iter()
                .map(|ring| match *ring {
                    InnerComponent::Cycle(a) => InnerComponent::Cycle(to_h(a)),
                    InnerComponent::Isolated(a) => InnerComponent::Isolated(to_v(a)),
                })
                .collect(),
            ..row.clone()
        });
    }
    out
}

/// A table of random pointers, some of them missing, some leading nowhere.
pub fn garbage(random: &mut Random) -> Table {
    fn id<I: Id>(random: &mut Random, bound: usize) -> Option<I> {
        (random.below(12) != 0).then(|| {
            // Mostly the low numbers, so that many pointers meet; now and then one that does not exist.
            let bound = if random.below(3) == 0 { bound + 2 } else { bound / 2 + 1 };
            I::from_index(random.below(bound))
        })
    }
    let [vs, hs, fs] = [8, 16, 6].map(|most| random.below(most + 1));
    let present = |random: &mut Random| random.below(10) != 0;
    let mut table = Table::default();
    for _ in 0..vs {
        let row = VertexRow { position: None, outgoing: id(random, hs) };
        table.vertices.push(present(random).then_some(row));
    }
    for _ in 0..hs {
        let row = HalfEdgeRow {
            origin: id(random, vs),
            twin: id(random, hs),
            next: id(random, hs),
            prev: id(random, hs),
            face: id(random, fs),
        };
        table.half_edges.push(present(random).then_some(row));
    }
    for _ in 0..fs {
        let rings = (0..random.below(4)).filter_map(|i| {
            if i == 0 {
                id(random, vs).map(InnerComponent::Isolated)
            } else {
                id(random, hs).map(InnerComponent::Cycle)
            }
        });
        let rings = rings.collect();
        let row =
            FaceRow { half_edge: id(random, hs), inner_components: rings, hole: random.below(4) == 0, name: None };
        table.faces.push(present(random).then_some(row));
    }
    table.outer_face = if random.below(2) == 0 { id(random, fs) } else { None };
    table
}

/// Small structures of every awkward kind, reached by edits alone.
pub fn zoo() -> Vec<(&'static str, Dcel)> {
    let polygon = |n| Dcel::polygon(n).unwrap();
    let edited = |mut dcel: Dcel, edit: fn(&mut Dcel)| {
        edit(&mut dcel);
        dcel
    };
    vec![
        ("a loop", polygon(1)),
        ("two parallel edges", polygon(2)),
        ("a triangle", polygon(3)),
        ("a square", polygon(4)),
        ("a hexagon", polygon(6)),
        ("one edge", edited(polygon(2), |d| assert_eq!(d.join_faces(h(0)), Ok(f(1))))),
        ("a path of two edges", edited(polygon(3), |d| assert_eq!(d.join_faces(h(0)), Ok(f(1))))),
        (
            "a loop round the end of a path",
            edited(polygon(3), |d| {
                d.join_faces(h(1)).unwrap();
                let corners: Vec<_> = d.half_edges().filter(|&a| d.degree(d.origin(a)) == 2).collect();
                d.split_face(corners[0], corners[1]).unwrap();
            }),
        ),
        (
            "four vertices and two parallel diagonals",
            edited(polygon(4), |d| {
                d.split_face(h(0), h(4)).unwrap();
                d.split_face(h(7), h(3)).unwrap();
            }),
        ),
        (
            "a triangle with a dangling edge",
            edited(polygon(4), |d| {
                d.split_face(h(0), h(4)).unwrap();
                d.join_faces(h(4)).unwrap();
            }),
        ),
        (
            "a loop alone in its face, with a tail outside",
            edited(polygon(4), |d| {
                d.split_face(h(0), h(4)).unwrap();
                d.join_faces(h(6)).unwrap();
                d.join_edges(h(9)).unwrap();
                d.join_edges(h(9)).unwrap();
            }),
        ),
        (
            "removed elements between live ones",
            edited(polygon(6), |d| {
                d.split_face(h(0), h(4)).unwrap();
                d.split_face(h(6), h(10)).unwrap();
                d.split_edge(h(2)).unwrap();
                d.join_faces(h(12)).unwrap();
                d.join_edges(h(2)).unwrap();
            }),
        ),
    ]
}
