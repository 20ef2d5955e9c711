//! Which face gets which hue: neighbours differ, and the same input always gives the same picture.
//!
//! Faces with the same name are one country and share a hue. The countries are taken off one by one, always one
//! with the fewest neighbours left, and coloured in the reverse order: a planar map never meets more than
//! five coloured neighbours that way, so seven hues are enough. Each country first tries the hue of its own
//! turn, so that a small figure shows f1, f2, f3, ... in the order of the palette.
//!
//! Source: Matula and Beck, *Smallest-last ordering and clustering and graph coloring algorithms*, 1983.

use crate::figure::FigureOptions;
use crate::figure::structure::faces::Region;
use crate::figure::structure::skeleton::half_edges;
use crate::geometry::grouping::Groups;
use crate::ids::{FaceId, FaceMap};
use crate::plane::PlanarView;
use std::collections::BTreeMap;

/// The number of hues.
pub(crate) const HUES: usize = 7;

const NO_COUNTRY: u32 = u32::MAX;

/// The hue of each region. Hole faces and the outer face take no part. O(half-edges log half-edges).
pub(crate) fn hues<V: PlanarView + ?Sized>(view: &V, regions: &[Region], options: &FigureOptions) -> Vec<u8> {
    let mut country = FaceMap::filled(view.face_bound(), NO_COUNTRY);
    let mut by_name: BTreeMap<&str, u32> = BTreeMap::new();
    let mut count = 0;
    // A face without a name has the turn of its id, so that it keeps its hue when others go.
    let mut turns: Vec<usize> = Vec::new();
    let outer = view.outer_face();
    for face in regions.iter().map(|region| region.face) {
        if view.is_hole(face) || view.outer_face() == Some(face) {
            continue;
        }
        let number = options.name(face).map_or(count, |name| *by_name.entry(name).or_insert(count));
        country[face] = number;
        if number == count {
            let named = options.name(face).is_some();
            let earlier = usize::from(outer.is_some_and(|outer| outer < face));
            turns.push(if named { number as usize } else { face.index() - earlier });
            count += 1;
        }
    }
    let hue = colour(&turns, &borders(view, &country));
    let of = |face: FaceId| match country[face] {
        NO_COUNTRY => 0,
        number => hue[number as usize],
    };
    regions.iter().map(|region| of(region.face)).collect()
}

/// The pairs of neighbours, both ways, sorted, each once.
fn borders<V: PlanarView + ?Sized>(view: &V, country: &FaceMap<u32>) -> Vec<(u32, u32)> {
    let of = |face: Option<FaceId>| face.and_then(|f| country.get(f).copied()).filter(|&c| c != NO_COUNTRY);
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    for h in half_edges(view) {
        let across = view.twin(h).and_then(|t| view.face(t));
        if let (Some(a), Some(b)) = (of(view.face(h)), of(across))
            && a != b
        {
            pairs.extend([(a, b), (b, a)]);
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Colours a graph given by its sorted pairs, and the hue that each vertex tries first. O(vertices + pairs).
fn colour(turns: &[usize], pairs: &[(u32, u32)]) -> Vec<u8> {
    let count = turns.len();
    let neighbours = Groups::new(count, pairs.iter().map(|&(a, b)| (a as usize, b as usize)));
    let mut degree: Vec<usize> = (0..count).map(|a| neighbours.of(a).len()).collect();
    let mut buckets: Vec<Vec<usize>> = vec![Vec::new(); degree.iter().max().map_or(0, |&d| d + 1)];
    for a in (0..count).rev() {
        buckets[degree[a]].push(a);
    }
    let mut taken = vec![false; count];
    let mut order = Vec::with_capacity(count);
    let mut least = 0;
    while least < buckets.len() {
        let Some(a) = buckets[least].pop() else {
            least += 1;
            continue;
        };
        if taken[a] || degree[a] != least {
            continue;
        }
        taken[a] = true;
        order.push(a);
        for &b in neighbours.of(a).iter().filter(|&&b| !taken[b]) {
            degree[b] -= 1;
            buckets[degree[b]].push(b);
        }
        least = least.saturating_sub(1);
    }

    let mut hue = vec![u8::MAX; count];
    for &a in order.iter().rev() {
        let mut used = [0usize; HUES];
        for &b in neighbours.of(a) {
            if let Some(uses) = used.get_mut(usize::from(hue[b])) {
                *uses += 1;
            }
        }
        let turn = |i: usize| (turns[a] + i) % HUES;
        let best = (0..HUES).min_by_key(|&i| (used[turn(i)], i)).map_or(0, turn);
        hue[a] = best as u8;
    }
    hue
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(edges: &[(u32, u32)]) -> Vec<(u32, u32)> {
        let mut pairs: Vec<_> = edges.iter().flat_map(|&(a, b)| [(a, b), (b, a)]).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    fn turns(count: usize) -> Vec<usize> {
        (0..count).collect()
    }

    #[test]
    fn neighbours_differ_in_a_triangulated_grid() {
        let n = 30u32;
        let mut edges = Vec::new();
        for i in 0..n * n {
            let (x, y) = (i % n, i / n);
            edges.extend(
                [(x + 1 < n, i + 1), (y + 1 < n, i + n), (x + 1 < n && y + 1 < n, i + n + 1)]
                    .iter()
                    .filter(|e| e.0)
                    .map(|e| (i, e.1)),
            );
        }
        let pairs = graph(&edges);
        let hue = colour(&turns((n * n) as usize), &pairs);
        assert!(pairs.iter().all(|&(a, b)| hue[a as usize] != hue[b as usize]));
    }

    #[test]
    fn few_countries_keep_the_order_of_the_palette() {
        assert_eq!(
            colour(&turns(5), &graph(&[(0, 1), (1, 2), (2, 3), (3, 0), (4, 0), (4, 1), (4, 2), (4, 3)])),
            [0, 1, 2, 3, 4]
        );
        // The eighth country has the hue of the first, unless they are neighbours.
        assert_eq!(colour(&turns(8), &[])[7], 0);
        assert_ne!(colour(&turns(8), &graph(&[(0, 7)]))[7], colour(&turns(8), &graph(&[(0, 7)]))[0]);
    }
}
