//! Structures to write, random numbers, and short ways to read.

use dcel_kit::io::{Document, Format, PolygonSoup, Read, ReadError, ReadOptions, read_bytes};
use dcel_kit::topology::{FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;

/// A reproducible stream of random numbers (xorshift64*, Vigna 2016).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number below `bound`.
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        ((self.bits() >> 32) as usize * bound) >> 32
    }

    /// A coordinate of any size that the kit accepts.
    pub(crate) fn coordinate(&mut self) -> f64 {
        loop {
            let value = match self.below(4) {
                0 => self.below(1000) as f64 - 500.0,
                1 => -0.0,
                _ => f64::from_bits(self.bits()),
            };
            if dcel_kit::plane::check_coordinate('x', value).is_ok() {
                return value;
            }
        }
    }
}

pub(crate) fn read(text: &[u8], format: Format) -> Result<Read, ReadError> {
    read_bytes(text, format, "file", &ReadOptions::default())
}

pub(crate) fn soup(text: &[u8], format: Format) -> PolygonSoup {
    match read(text, format).unwrap_or_else(|error| panic!("{error}")).document {
        Document::Polygons(soup) => soup,
        other => panic!("not polygons: {other:?}"),
    }
}

pub(crate) fn table(text: &[u8]) -> Table {
    match read(text, Format::Dcel).unwrap_or_else(|error| panic!("{error}")).document {
        Document::Table(table) => table,
        other => panic!("not a table: {other:?}"),
    }
}

/// A face as its cycles of points, the outer one first, and whether it is a hole face.
pub(crate) struct Face {
    pub(crate) cycles: Vec<Vec<usize>>,
    pub(crate) hole: bool,
}

impl Face {
    pub(crate) fn new(cycles: &[&[usize]]) -> Self {
        Self { cycles: cycles.iter().map(|c| c.to_vec()).collect(), hole: false }
    }
}

/// The half-edge table of faces that fit together; what is on nobody's left belongs to `f0`, whose cycles must
/// not touch each other.
pub(crate) fn structure(points: &[[f64; 2]], faces: &[Face]) -> Table {
    let mut table = Table { outer_face: Some(FaceId::new(0)), ..Table::default() };
    table.vertices = points.iter().map(|&p| Some(VertexRow { position: Some(p), outgoing: None })).collect();
    let mut ids: BTreeMap<(usize, usize), HalfEdgeId> = BTreeMap::new();
    let mut half_edge = |table: &mut Table, a: usize, b: usize| {
        if let Some(&known) = ids.get(&(a, b)) {
            return known;
        }
        let id = table.half_edges.len() as u32;
        for (h, twin, v, w) in [(id, id + 1, a, b), (id + 1, id, b, a)] {
            ids.insert((v, w), HalfEdgeId::new(h));
            let (origin, twin) = (Some(VertexId::new(v as u32)), Some(HalfEdgeId::new(twin)));
            table.half_edges.push(Some(HalfEdgeRow { origin, twin, ..HalfEdgeRow::default() }));
        }
        HalfEdgeId::new(id)
    };
    table.faces.push(Some(FaceRow::default()));
    for (i, face) in faces.iter().enumerate() {
        let mut starts = Vec::new();
        for cycle in &face.cycles {
            let n = cycle.len();
            let ring: Vec<HalfEdgeId> = (0..n).map(|k| half_edge(&mut table, cycle[k], cycle[(k + 1) % n])).collect();
            link(&mut table, &ring, FaceId::new(i as u32 + 1));
            starts.push(ring[0]);
        }
        let rings = starts[1..].iter().map(|&h| InnerComponent::Cycle(h)).collect();
        table.faces.push(Some(FaceRow {
            half_edge: Some(starts[0]),
            inner_components: rings,
            hole: face.hole,
            name: None,
        }));
    }
    outer_cycles(&mut table);
    table
}

/// Gives the half-edges without a face to `f0`.
fn outer_cycles(table: &mut Table) {
    let free = |table: &Table| table.half_edges.iter().position(|row| row.unwrap().face.is_none());
    let mut starts = Vec::new();
    while let Some(start) = free(table) {
        let mut ring = vec![HalfEdgeId::new(start as u32)];
        loop {
            let end = table.half_edges[ring.last().unwrap().index() ^ 1].unwrap().origin;
            let next =
                table.half_edges.iter().position(|row| row.unwrap().face.is_none() && row.unwrap().origin == end);
            let next = HalfEdgeId::new(next.unwrap() as u32);
            if next == ring[0] {
                break;
            }
            ring.push(next);
        }
        link(table, &ring, FaceId::new(0));
        starts.push(ring[0]);
    }
    let outer = table.faces[0].as_mut().unwrap();
    outer.half_edge = starts.first().copied();
    outer.inner_components = starts.iter().skip(1).map(|&h| InnerComponent::Cycle(h)).collect();
}

fn link(table: &mut Table, ring: &[HalfEdgeId], face: FaceId) {
    for (k, &h) in ring.iter().enumerate() {
        let row = table.half_edges[h.index()].as_mut().unwrap();
        row.face = Some(face);
        row.next = Some(ring[(k + 1) % ring.len()]);
        row.prev = Some(ring[(k + ring.len() - 1) % ring.len()]);
        let v = row.origin.unwrap();
        table.vertices[v.index()].as_mut().unwrap().outgoing.get_or_insert(h);
    }
}

/// A grid of `n` x `n` squares, every second one cut into two triangles, with coordinates that need all digits.
pub(crate) fn grid(n: usize, triangles_only: bool) -> Table {
    let at = |i: usize, j: usize| j * (n + 1) + i;
    let points: Vec<[f64; 2]> =
        (0..=n).flat_map(|j| (0..=n).map(move |i| [i as f64 / 3.0, j as f64 * 1e-7 / 7.0])).collect();
    let mut faces = Vec::new();
    for (i, j) in (0..n).flat_map(|j| (0..n).map(move |i| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        if triangles_only || (i + j) % 2 == 0 {
            faces.push(Face::new(&[&[a, b, c]]));
            faces.push(Face::new(&[&[a, c, d]]));
        } else {
            faces.push(Face::new(&[&[a, b, c, d]]));
        }
    }
    structure(&points, &faces)
}

/// A square `f1` with an island: a square `f2` that holds a hole face `f3`.
pub(crate) fn island() -> Table {
    let square = |r: f64| [[-r, -r], [r, -r], [r, r], [-r, r]];
    let points: Vec<[f64; 2]> = [square(3.0), square(2.0), square(1.0)].concat();
    let mut faces = vec![
        Face::new(&[&[0, 1, 2, 3], &[4, 7, 6, 5]]),
        Face::new(&[&[4, 5, 6, 7], &[8, 11, 10, 9]]),
        Face::new(&[&[8, 9, 10, 11]]),
    ];
    faces[2].hole = true;
    structure(&points, &faces)
}
