//! A list of faces: what is wrong with it, and the tables of its half-edges.

use crate::cases::cycles::from_cycles;
use crate::cases::numbers::renumbered;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId};
use std::collections::{BTreeMap, BTreeSet};

/// The ends of a half-edge.
pub(super) type Ends = [u32; 2];

/// A list of faces over so many vertices.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Soup {
    /// How many vertices there are.
    pub(super) vertices: u32,
    /// The corners of each face.
    pub(super) faces: Vec<Vec<u32>>,
}

impl Soup {
    /// A list of faces.
    pub(super) fn new<const N: usize>(vertices: u32, faces: &[[u32; N]]) -> Self {
        Self { vertices, faces: faces.iter().map(|face| face.to_vec()).collect() }
    }

    /// The list that the words of a call state, as OFF files write it: before each face stands how many corners it has.
    pub(super) fn of_words(vertices: usize, words: &[String]) -> Option<Self> {
        let numbers: Vec<u32> = words.iter().map(|word| word.parse().ok()).collect::<Option<_>>()?;
        let (mut faces, mut rest) = (Vec::new(), &numbers[..]);
        while let Some((&count, after)) = rest.split_first() {
            let (face, others) = after.split_at_checked(count as usize)?;
            faces.push(face.to_vec());
            rest = others;
        }
        Some(Self { vertices: vertices as u32, faces })
    }

    /// The list that the cycles of a table come from: all faces but the outer one.
    pub(super) fn of_table(table: &Table) -> Option<Self> {
        let mut faces = Vec::new();
        for f in (0..table.faces.len() as u32).map(FaceId::new).filter(|&f| table.outer_face != Some(f)) {
            let first = table.half_edge(f)?;
            let mut face = vec![table.origin(first)?.number()];
            let mut h = table.next(first)?;
            while h != first && face.len() <= table.half_edges.len() {
                face.push(table.origin(h)?.number());
                h = table.next(h)?;
            }
            faces.push(face);
        }
        Some(Self { vertices: table.vertices.len() as u32, faces })
    }

    /// The faces as the words of a call.
    pub(super) fn words(&self) -> Vec<u32> {
        self.faces.iter().flat_map(|face| std::iter::once(face.len() as u32).chain(face.iter().copied())).collect()
    }

    /// The half-edges of a face by their ends, in order.
    pub(super) fn sides(face: &[u32]) -> impl Iterator<Item = Ends> {
        (0..face.len()).map(|i| [face[i], face[(i + 1) % face.len()]])
    }

    /// Each refusal of `check_faces` that is true of the list.
    pub(super) fn bad_faces(&self) -> BTreeSet<String> {
        let mut all = BTreeSet::new();
        for (f, face) in self.faces.iter().enumerate() {
            if face.len() < 3 {
                all.insert(format!("face {f} of the list has fewer than three corners"));
            }
            for (i, v) in face.iter().enumerate() {
                if *v >= self.vertices {
                    all.insert(format!("face {f} of the list: there is no vertex {v}"));
                }
                if face[..i].contains(v) {
                    all.insert(format!("face {f} of the list has vertex {v} twice"));
                }
            }
        }
        all
    }

    /// Each refusal of `match_twins` that is true of the list.
    pub(super) fn edges_twice(&self) -> BTreeSet<String> {
        let mut met = BTreeSet::new();
        let all = self.faces.iter().flat_map(|face| Self::sides(face));
        let twice = all.filter(|&ends| !met.insert(ends));
        twice.map(|[from, to]| format!("the edge from vertex {from} to vertex {to} comes twice")).collect()
    }

    /// The half-edges of the border by their ends: they run against those of faces that have no twin.
    pub(super) fn border(&self) -> BTreeSet<Ends> {
        let sides: BTreeSet<Ends> = self.faces.iter().flat_map(|face| Self::sides(face)).collect();
        sides.iter().map(|&[a, b]| [b, a]).filter(|back| !sides.contains(back)).collect()
    }

    /// Each refusal of `close_border` that is true of the list.
    pub(super) fn pinched(&self) -> BTreeSet<String> {
        let mut begin = BTreeSet::new();
        let twice = self.border().into_iter().filter(|&[from, _]| !begin.insert(from));
        twice.map(|[from, _]| format!("the border comes to vertex {from} more than once")).collect()
    }

    /// Each refusal of `from_faces` that is true of the list; a border can be judged only if all else is right.
    pub(super) fn refusals(&self) -> BTreeSet<String> {
        let mut all = self.bad_faces();
        all.append(&mut self.edges_twice());
        if all.is_empty() { self.pinched() } else { all }
    }

    /// Whether the list is one that the handout leaves out: nothing refuses it, though fans of faces meet at a vertex.
    pub(super) fn has_vertex_of_two_fans_only(&self) -> bool {
        self.refusals().is_empty() && self.has_vertex_of_two_fans()
    }

    /// Whether fans of faces meet at a vertex without a common edge: all faces round it, from one of them on, across
    /// edges, must be all that have it as a corner.
    pub(super) fn has_vertex_of_two_fans(&self) -> bool {
        (0..self.vertices).any(|v| {
            let round: Vec<[u32; 2]> = self.faces.iter().filter_map(|face| neighbours(face, v)).collect();
            let Some(first) = round.first() else { return false };
            let mut reached = BTreeSet::from(*first);
            while let Some(more) = round.iter().find(|[a, b]| reached.contains(a) != reached.contains(b)) {
                reached.extend(more);
            }
            round.iter().any(|[a, _]| !reached.contains(a))
        })
    }

    /// What is right: the face, the half-edge after it and the one before it, of each half-edge by its ends. The list
    /// has no refusals.
    pub(super) fn half_edges(&self) -> BTreeMap<Ends, Right> {
        let mut all = BTreeMap::new();
        for (f, face) in self.faces.iter().enumerate() {
            let sides: Vec<Ends> = Self::sides(face).collect();
            for (i, &ends) in sides.iter().enumerate() {
                let (next, prev) = (sides[(i + 1) % sides.len()], sides[(i + sides.len() - 1) % sides.len()]);
                all.insert(ends, Right { face: f as u32 + 1, next, prev });
            }
        }
        let border = self.border();
        let (mut from, mut to) = (BTreeMap::new(), BTreeMap::new());
        for &ends in &border {
            from.insert(ends[0], ends);
            to.insert(ends[1], ends);
        }
        for ends in border {
            if let (Some(&next), Some(&prev)) = (from.get(&ends[1]), to.get(&ends[0])) {
                all.insert(ends, Right { face: 0, next, prev });
            }
        }
        all
    }

    /// The half-edges of the faces, in the order `order` of their numbers: with twins, but without a border.
    pub(super) fn table(&self, order: &[usize], twins: bool) -> Table {
        let mut faces: Vec<&[u32]> = vec![&[]];
        faces.extend(self.faces.iter().map(Vec::as_slice));
        let mut table = from_cycles(&vec![[0.0; 2]; self.vertices as usize], &faces);
        if !twins {
            table.half_edges.iter_mut().flatten().for_each(|row| row.twin = None);
        }
        renumbered(&table, |v| v, |h| HalfEdgeId::new(order[h.index()] as u32), |f| f)
    }
}

/// The corners of a face before and after a vertex.
fn neighbours(face: &[u32], v: u32) -> Option<[u32; 2]> {
    let at = face.iter().position(|&corner| corner == v)?;
    Some([face[(at + face.len() - 1) % face.len()], face[(at + 1) % face.len()]])
}

/// What is right of a half-edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Right {
    /// The face on its left: 0 is the outer one.
    pub(super) face: u32,
    /// The half-edge after it.
    pub(super) next: Ends,
    /// The half-edge before it.
    pub(super) prev: Ends,
}

#[cfg(test)]
mod tests {
    use super::super::lists;
    use super::*;
    use crate::cases::cycles::from_cycles;

    /// The structure of two triangles that was stated with its outer face says the same as the list without it.
    #[test]
    fn the_half_edges_are_those_of_cycles_that_were_stated_with_the_outer_face() {
        let soup = Soup::new(4, &[[0, 1, 2], [0, 2, 3]]);
        let stated = from_cycles(&[[0.0; 2]; 4], &[&[0, 3, 2, 1], &[0, 1, 2], &[0, 2, 3]]);
        let ends = |h: HalfEdgeId| {
            let end = |h| stated.origin(h).unwrap().number();
            [end(h), end(stated.twin(h).unwrap())]
        };
        let rows = (0..stated.half_edges.len() as u32).map(HalfEdgeId::new).map(|h| {
            let right = Right {
                face: stated.face(h).unwrap().number(),
                next: ends(stated.next(h).unwrap()),
                prev: ends(stated.prev(h).unwrap()),
            };
            (ends(h), right)
        });
        assert_eq!(soup.half_edges(), rows.collect());
    }

    /// Counted in another way: how often each pair of vertices lies on a side.
    #[test]
    fn a_list_has_an_edge_twice_or_every_pair_of_vertices_lies_on_at_most_two_sides() {
        for soup in lists::exhaustive() {
            let count = |ends: Ends| {
                let all = soup.faces.iter().flat_map(|face| Soup::sides(face));
                all.filter(|&other| other == ends).count()
            };
            let pairs = (0..4).flat_map(|a| (0..4).map(move |b| [a, b]));
            assert_eq!(!soup.edges_twice().is_empty(), pairs.clone().any(|ends| count(ends) > 1), "{soup:?}");
            let border = pairs.filter(|&[a, b]| count([a, b]) == 0 && count([b, a]) > 0);
            assert_eq!(soup.border(), border.collect(), "{soup:?}");
        }
    }

    #[test]
    fn words_and_tables_give_the_list_back() {
        for soup in lists::good().into_iter().map(|(_, soup)| soup) {
            let words: Vec<String> = soup.words().iter().map(u32::to_string).collect();
            assert_eq!(Soup::of_words(soup.vertices as usize, &words), Some(soup.clone()));
            let corners: usize = soup.faces.iter().map(Vec::len).sum();
            let order: Vec<usize> = (0..corners).rev().collect();
            assert_eq!(Soup::of_table(&soup.table(&order, true)), Some(soup));
        }
    }
}
