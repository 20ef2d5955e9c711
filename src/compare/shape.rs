//! Layer 4: how lines hang together, wherever they lie.
//!
//! ```text
//!        \ | /            The lines at a point follow each other in the order of their directions; that order
//!       ── ● ──           gives next, and next gives the cycles: the half-edge structure of the drawing.
//!        / | \            A cycle is a bounded face if it runs counter-clockwise.
//! ```

use super::graph::Graph;
use super::report::{Difference, Kind, Layer, Spot};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::{Point, predicates::orientation};
use crate::topology::{FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow, View, bounded_cycle, isomorphic};
use std::cmp::Ordering;

/// Drawings with more edges are not compared in this way.
const EDGES: usize = 5_000;

/// The structure of a drawing: faces from f1 on are bounded, f0 has all other cycles, islands in faces among them.
pub(super) fn rebuild(graph: &Graph) -> Table {
    let (mut table, cycles) = linked(graph);
    let mut rings = Vec::new();
    table.faces.push(None);
    for (start, area) in cycles {
        if area > 0.0 {
            let face = FaceId::new(table.faces.len() as u32);
            table.faces.push(Some(FaceRow { half_edge: Some(start), ..FaceRow::default() }));
            give(&mut table, start, face);
        } else {
            rings.push(InnerComponent::Cycle(start));
            give(&mut table, start, FaceId::new(0));
        }
    }
    let alone = |(v, row): (usize, &Option<VertexRow>)| {
        row.as_ref().filter(|row| row.outgoing.is_none()).map(|_| InnerComponent::Isolated(VertexId::new(v as u32)))
    };
    rings.extend(table.vertices.iter().enumerate().filter_map(alone));
    let boundary = rings.first().and_then(|ring| ring.cycle());
    if boundary.is_some() {
        rings.remove(0);
    }
    table.faces[0] = Some(FaceRow { half_edge: boundary, inner_components: rings, ..FaceRow::default() });
    table.outer_face = Some(FaceId::new(0));
    table
}

/// The points along every cycle that does not run counter-clockwise: the outlines seen from outside.
pub(super) fn outside(graph: &Graph) -> Vec<Vec<u32>> {
    let (table, cycles) = linked(graph);
    let corner = |h: HalfEdgeId| table.origin(h).map(VertexId::number);
    let outer = cycles.into_iter().filter(|(_, area)| *area <= 0.0);
    outer.map(|(start, _)| bounded_cycle(&table, start).filter_map(corner).collect()).collect()
}

/// One sentence: the right shape in the wrong place, the mirror image, or wrong connections. O(n²) at worst, with
/// n at most 5000.
pub(super) fn compare(expected: &Graph, found: &Graph) -> Difference {
    let text = if expected.edges.len().max(found.edges.len()) > EDGES {
        "hardly any vertex lies where it should: compare the coordinates".to_owned()
    } else {
        let (mine, theirs) = (surface(expected), surface(found));
        let mirrored = || {
            let points = found.points.iter().map(|p| Point::new(-p.x, p.y)).collect();
            surface(&Graph { points, ..found.clone() })
        };
        match isomorphic(&theirs, &mine) {
            Ok(_) => {
                "right shape, wrong place: the lines are connected as they should be, but the vertices lie elsewhere"
                    .to_owned()
            }
            Err(_) if isomorphic(&mirrored(), &mine).is_ok() => {
                "mirrored, and in the wrong place: the lines are connected as in a mirror image".to_owned()
            }
            Err(difference) => format!("wrong connections, and hardly any vertex lies where it should: {difference}"),
        }
    };
    Difference::new(Kind::Drawing, Layer::Shape, text, Spot::Nowhere)
}

/// Every cycle a face of its own; those that do not run counter-clockwise are hole faces.
fn surface(graph: &Graph) -> Table {
    let (mut table, cycles) = linked(graph);
    for (start, area) in cycles {
        let face = FaceId::new(table.faces.len() as u32);
        table.faces.push(Some(FaceRow { half_edge: Some(start), hole: area <= 0.0, ..FaceRow::default() }));
        give(&mut table, start, face);
    }
    table
}

fn give(table: &mut Table, start: HalfEdgeId, face: FaceId) {
    let mut at = start;
    while let Some(row) = table.half_edges[at.index()].as_mut().filter(|row| row.face.is_none()) {
        row.face = Some(face);
        let Some(next) = row.next else { return };
        at = next;
    }
}

/// The half-edges with all pointers but faces, and for each cycle a half-edge and twice its area. Edge i has the
/// half-edges 2i and 2i + 1. O(n log n).
fn linked(graph: &Graph) -> (Table, Vec<(HalfEdgeId, f64)>) {
    let mut leaving: Vec<Vec<HalfEdgeId>> = vec![Vec::new(); graph.points.len()];
    let h = |number: usize| HalfEdgeId::new(number as u32);
    for (i, &[a, b]) in graph.edges.iter().enumerate() {
        leaving[a as usize].push(h(2 * i));
        leaving[b as usize].push(h(2 * i + 1));
    }
    let tip = |h: HalfEdgeId| graph.point(graph.edges[h.edge().index()][usize::from(h.number().is_multiple_of(2))]);
    let mut next = vec![h(0); 2 * graph.edges.len()];
    for (v, round) in leaving.iter_mut().enumerate() {
        let at = graph.points[v];
        round.sort_by(|&a, &b| by_direction(at, tip(a), tip(b)).then(a.cmp(&b)));
        // The one that leaves clockwise of the twin that arrives.
        for (i, out) in round.iter().enumerate() {
            let before = round[(i + round.len() - 1) % round.len()];
            next[out.twin().index()] = before;
        }
    }
    let mut prev = next.clone();
    next.iter().enumerate().for_each(|(i, n)| prev[n.index()] = h(i));
    let row = |i: usize| HalfEdgeRow {
        origin: Some(VertexId::new(graph.edges[i / 2][i % 2])),
        twin: Some(h(i).twin()),
        next: Some(next[i]),
        prev: Some(prev[i]),
        face: None,
    };
    let vertices = graph.points.iter().zip(&leaving);
    let table = Table {
        vertices: vertices
            .map(|(p, round)| Some(VertexRow { position: Some([p.x, p.y]), outgoing: round.first().copied() }))
            .collect(),
        half_edges: (0..next.len()).map(|i| Some(row(i))).collect(),
        faces: Vec::new(),
        outer_face: None,
    };
    let mut cycles = Vec::new();
    let mut walked = vec![false; next.len()];
    for start in 0..next.len() {
        if walked[start] {
            continue;
        }
        let (mut at, mut area) = (start, 0.0);
        let base = tip(h(start));
        while !std::mem::replace(&mut walked[at], true) {
            let (p, q) = (tip(h(at).twin()), tip(h(at)));
            area += (p.x - base.x) * (q.y - base.y) - (p.y - base.y) * (q.x - base.x);
            at = next[at].index();
        }
        cycles.push((h(start), area));
    }
    (table, cycles)
}

/// Counter-clockwise from the positive x axis.
fn by_direction(at: Point, a: Point, b: Point) -> Ordering {
    let upper = |p: Point| (p.y, p.x) > (at.y, at.x);
    upper(b).cmp(&upper(a)).then_with(|| orientation(at, a, b).reverse())
}
