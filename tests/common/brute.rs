//! A second opinion on the invariants and on equality, slow and written differently from the kit: by sets of half-edges
//! instead of walks with marks, and by trying every root.

use dcel_kit::topology::{InnerComponent, Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

type Half = HalfEdgeId;

/// Whether a table obeys every invariant.
pub fn legal(table: &Table) -> bool {
    check(table).is_some()
}

fn orbit(start: Half, step: impl Fn(Half) -> Half) -> BTreeSet<Half> {
    let mut all = BTreeSet::new();
    let mut at = start;
    while all.insert(at) {
        at = step(at);
    }
    all
}

/// `None` at the first broken invariant.
fn check(table: &Table) -> Option<()> {
    let holds = |invariant: bool| invariant.then_some(());
    let halves: BTreeSet<Half> = ids(&table.half_edges).map(HalfEdgeId::new).collect();
    let vertices: BTreeSet<VertexId> = ids(&table.vertices).map(VertexId::new).collect();
    let faces: BTreeSet<FaceId> = ids(&table.faces).map(FaceId::new).collect();

    let mut origin = BTreeMap::new();
    let (mut twin, mut next, mut prev, mut face) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
    for &a in &halves {
        origin.insert(a, table.origin(a).filter(|x| vertices.contains(x))?);
        twin.insert(a, table.twin(a).filter(|x| halves.contains(x))?);
        next.insert(a, table.next(a).filter(|x| halves.contains(x))?);
        prev.insert(a, table.prev(a).filter(|x| halves.contains(x))?);
        face.insert(a, table.face(a).filter(|x| faces.contains(x))?);
    }
    for a in &halves {
        holds(twin[a] != *a && twin[&twin[a]] == *a)?;
        holds(next[&prev[a]] == *a && prev[&next[a]] == *a)?;
        holds(origin[&next[a]] == origin[&twin[a]])?;
    }
    let mut lonely = BTreeSet::new();
    for &x in &vertices {
        let here: BTreeSet<Half> = halves.iter().copied().filter(|a| origin[a] == x).collect();
        match table.outgoing(x) {
            None => {
                holds(here.is_empty())?;
                lonely.insert(x);
            }
            Some(a) => holds(here.contains(&a) && orbit(a, |b| twin[&prev[&b]]) == here)?,
        }
    }
    let outer = table.outer_face;
    if let Some(x) = outer {
        holds(faces.contains(&x) && !table.is_hole(x))?;
    }
    let mut placed = BTreeSet::new();
    for &x in &faces {
        let here: BTreeSet<Half> = halves.iter().copied().filter(|a| face[a] == x).collect();
        let mut listed: Vec<Half> = table.half_edge(x).into_iter().collect();
        for ring in table.inner_components(x) {
            match *ring {
                InnerComponent::Cycle(a) => listed.push(a),
                InnerComponent::Isolated(y) => holds(lonely.contains(&y) && placed.insert(y))?,
            }
        }
        holds(table.half_edge(x).is_some() || (outer == Some(x) && listed.is_empty()))?;
        let mut covered = BTreeSet::new();
        for a in listed {
            holds(here.contains(&a) && !covered.contains(&a))?;
            covered.extend(orbit(a, |b| next[&b]));
        }
        holds(covered == here)?;
    }
    if outer.is_none() {
        return Some(());
    }
    holds(placed == lonely)?;

    // The plane: genus 0, and every component inside exactly one face, all of them inside the outer one.
    let mut part_of: BTreeMap<VertexId, VertexId> = vertices.iter().map(|&x| (x, x)).collect();
    loop {
        let before = part_of.clone();
        for a in &halves {
            let low = part_of[&origin[a]].min(part_of[&origin[&twin[a]]]);
            part_of.insert(origin[a], low);
            part_of.insert(origin[&twin[a]], low);
        }
        if part_of == before {
            break;
        }
    }
    let parts: BTreeSet<VertexId> = part_of.values().copied().collect();
    for part in &parts {
        let count_v = vertices.iter().filter(|x| part_of[x] == *part).count();
        let mine: BTreeSet<Half> = halves.iter().copied().filter(|a| part_of[&origin[a]] == *part).collect();
        let cycles: BTreeSet<BTreeSet<Half>> = mine.iter().map(|&a| orbit(a, |b| next[&b])).collect();
        holds(count_v + cycles.len() + usize::from(mine.is_empty()) == mine.len() / 2 + 2)?;
    }
    holds(vertices.len() + faces.len() == halves.len() / 2 + 1 + parts.len())?;
    // Where each component lies, and the face seen outside it: follow these outwards to the outer face.
    let mut lies_in: BTreeMap<VertexId, FaceId> = BTreeMap::new();
    for &x in &faces {
        let first = table.half_edge(x).filter(|_| outer == Some(x)).map(InnerComponent::Cycle);
        for ring in first.iter().chain(table.inner_components(x)) {
            let part = match *ring {
                InnerComponent::Cycle(a) => part_of[&origin[&a]],
                InnerComponent::Isolated(y) => y,
            };
            holds(lies_in.insert(part, x).is_none())?;
        }
    }
    for part in &parts {
        let mut at = *lies_in.get(part)?;
        let mut steps = 0;
        while Some(at) != outer {
            at = *lies_in.get(&part_of[&origin[&table.half_edge(at)?]])?;
            steps += 1;
            holds(steps <= faces.len())?;
        }
    }
    Some(())
}

fn ids<T>(rows: &[Option<T>]) -> impl Iterator<Item = u32> + '_ {
    rows.iter().enumerate().filter(|(_, row)| row.is_some()).map(|(i, _)| i as u32)
}

/// A code of a connected legal structure without rings that is equal for equal structures only: the smallest of
/// the walks from all half-edges, with faces numbered as they are met.
pub fn code<V: View>(view: &V) -> Vec<[usize; 3]> {
    let halves = (0..view.half_edge_bound() as u32).map(HalfEdgeId::new).filter(|&a| view.has_half_edge(a));
    halves.map(|root| walk_code(view, root)).min().unwrap_or_default()
}

fn walk_code<V: View>(view: &V, root: Half) -> Vec<[usize; 3]> {
    let (mut order, mut faces) = (vec![root], Vec::new());
    let mut code = Vec::new();
    while let Some(&a) = order.get(code.len()) {
        let mut number = |b: Half| {
            order.iter().position(|&c| c == b).unwrap_or_else(|| {
                order.push(b);
                order.len() - 1
            })
        };
        let pair = (number(view.next(a).unwrap()), number(view.twin(a).unwrap()));
        let x = view.face(a).unwrap();
        let face = faces.iter().position(|&y| y == x).unwrap_or_else(|| {
            faces.push(x);
            faces.len() - 1
        });
        code.push([pair.0, pair.1, face]);
    }
    code
}
