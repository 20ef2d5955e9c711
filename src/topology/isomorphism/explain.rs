//! Why two views that are not equal differ: found after the fact, for the message only.

use super::difference::Difference;
use super::world::World;
use crate::ids::{Element, HalfEdgeId};
use std::collections::BTreeMap;

/// Fails if degrees or face lengths are distributed differently.
pub(super) fn histograms(world: &World) -> Result<(), Difference> {
    let split = world.split;
    let degrees = balance(world, &world.vertices, &world.origin, split.vertex);
    if let Some((degree, [found, expected])) = degrees {
        return Err(Difference::Degrees { degree, found, expected });
    }
    let lengths = balance(world, &world.faces, &world.face, split.face);
    if let Some((length, [found, expected])) = lengths {
        return Err(Difference::FaceLengths { length, found, expected });
    }
    Ok(())
}

/// The lowest number of half-edges that differently many elements of the two sides have.
fn balance(world: &World, elements: &[u32], column: &[u32], split: u32) -> Option<(usize, [usize; 2])> {
    let bound = elements.iter().max().map_or(0, |&x| x as usize + 1);
    let mut sizes = vec![0_usize; bound];
    world.half_edges.iter().for_each(|&h| sizes[column[h as usize] as usize] += 1);
    let mut histogram = BTreeMap::<usize, [usize; 2]>::new();
    for &x in elements {
        histogram.entry(sizes[x as usize]).or_default()[usize::from(x >= split)] += 1;
    }
    histogram.into_iter().find(|(_, [found, expected])| found != expected)
}

/// Follows pointers on both sides at once from the half-edges that can have one partner only, and reports the
/// first that lead apart. For the message only: nothing rests on it.
pub(super) fn first_pointer(world: &World) -> Option<Difference> {
    let split = world.split;
    let mut seeds: BTreeMap<[u32; 2], [Vec<u32>; 2]> = BTreeMap::new();
    for &h in &world.half_edges {
        let key = [world.label[h as usize], world.label[world.twin[h as usize] as usize]];
        seeds.entry(key).or_default()[usize::from(h >= split.half_edge)].push(h);
    }
    let mut pairs = Pairs::default();
    let mut queue: Vec<(u32, u32)> = seeds
        .values()
        .filter_map(|[a, b]| match (&a[..], &b[..]) {
            (&[a], &[b]) => Some((a, b)),
            _ => None,
        })
        .collect();
    queue.retain(|&(a, b)| pairs.half_edges.pair(a, b).is_ok());
    queue.sort_unstable_by(|x, y| y.cmp(x));
    while let Some((a, b)) = queue.pop() {
        let (i, j) = (a as usize, b as usize);
        let name = |pointer: &str| format!("{}.{pointer}", HalfEdgeId(a));
        let vertex = |v| split.vertex(v).into();
        let half_edge = |h| split.half_edge(h).into();
        let face = |f| split.face(f).into();
        let (v, w) = (world.origin[i], world.origin[j]);
        let agree = world.vertex_label[v as usize] == world.vertex_label[w as usize];
        if let Err(partner) = pairs.vertices.pair_if(agree, v, w) {
            return Some(pointer(name("origin"), vertex(v), partner.map(vertex), vertex(w)));
        }
        for (what, column) in [("twin", &world.twin), ("next", &world.next), ("prev", &world.prev)] {
            let (c, d) = (column[i], column[j]);
            let agree = world.label[c as usize] == world.label[d as usize];
            match pairs.half_edges.pair_if(agree, c, d) {
                Ok(true) => queue.push((c, d)),
                Ok(false) => {}
                Err(partner) => return Some(pointer(name(what), half_edge(c), partner.map(half_edge), half_edge(d))),
            }
        }
        let (f, g) = (world.face[i], world.face[j]);
        let agree = world.face_label[f as usize] == world.face_label[g as usize];
        if let Err(partner) = pairs.faces.pair_if(agree, f, g) {
            return Some(pointer(name("face"), face(f), partner.map(face), face(g)));
        }
    }
    None
}

fn pointer(pointer: String, found: Element, corresponds: Option<Element>, expected: Element) -> Difference {
    Difference::Pointer { pointer, found, corresponds, expected }
}

#[derive(Default)]
struct Pairs {
    vertices: Bijection,
    half_edges: Bijection,
    faces: Bijection,
}

/// A map that is one to one, while it grows.
#[derive(Default)]
struct Bijection {
    to: BTreeMap<u32, u32>,
    from: BTreeMap<u32, u32>,
}

impl Bijection {
    /// Pairs `a` with `b`: whether that is new, or the partner `a` has instead if it cannot be.
    fn pair(&mut self, a: u32, b: u32) -> Result<bool, Option<u32>> {
        match (self.to.get(&a), self.from.get(&b)) {
            (None, None) => {
                self.to.insert(a, b);
                self.from.insert(b, a);
                Ok(true)
            }
            (Some(&c), _) if c == b => Ok(false),
            (partner, _) => Err(partner.copied()),
        }
    }

    fn pair_if(&mut self, agree: bool, a: u32, b: u32) -> Result<bool, Option<u32>> {
        if agree { self.pair(a, b) } else { Err(self.to.get(&a).copied()) }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{IsomorphismOptions, isomorphic_with};
    use super::*;
    use crate::topology::Dcel;

    /// Two pentagons, each cut into a triangle and a quadrilateral on one side, and one half-edge that both share.
    #[test]
    fn elements_are_named_by_their_numbers_in_the_structure_they_are_in() {
        let said = |from, ends: [u32; 2], shared| {
            let [one, other] = ends.map(|to| {
                let mut cut = Dcel::polygon(5).unwrap();
                cut.split_face(HalfEdgeId(from), HalfEdgeId(to)).unwrap();
                cut
            });
            let fixed = |element| element == Element::HalfEdge(HalfEdgeId(shared));
            isomorphic_with(&one, &other, &IsomorphismOptions::new().fixed(&fixed)).unwrap_err().to_string()
        };
        assert_eq!(said(1, [5, 7], 6), "h11.origin = v3, which corresponds to v3 (expected v4)");
        assert_eq!(said(2, [6, 8], 8), "h6.prev = h10, which corresponds to nothing there (expected h0)");
    }
}
