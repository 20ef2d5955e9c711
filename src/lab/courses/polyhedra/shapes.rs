//! Closed surfaces by the corners of their faces, the simplest first.

use super::merging::merged;
use super::surface::Surface;
use crate::cases::cycles;
use crate::cases::random::Random;

/// The corners of faces.
pub(super) type Faces = Vec<Vec<u32>>;

/// The surface with these faces, all vertices at one place.
pub(super) fn blind(faces: &Faces) -> Surface {
    let vertices = faces.iter().flatten().max().map_or(0, |v| v + 1);
    Surface::of_faces(vec![[0.0; 3]; vertices as usize], faces)
}

pub(super) fn tetrahedron() -> Faces {
    vec![vec![0, 1, 2], vec![0, 3, 1], vec![1, 3, 2], vec![2, 3, 0]]
}

fn cube() -> Faces {
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]].map(Vec::from).into()
}

/// A polygon below, joined to one more vertex.
fn pyramid(n: u32) -> Faces {
    let mut faces = vec![(0..n).rev().collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n]));
    faces
}

/// Two pyramids, base to base.
pub(super) fn bipyramid(n: u32) -> Faces {
    let side = |i: u32| [vec![i, (i + 1) % n, n], vec![(i + 1) % n, i, n + 1]];
    (0..n).flat_map(side).collect()
}

/// Two polygons, joined by squares.
pub(super) fn prism(n: u32) -> Faces {
    let mut faces = vec![(0..n).rev().collect(), (n..2 * n).collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
    faces
}

/// As the line `torus N M` has it.
pub(super) fn torus(n: u32, m: u32) -> Faces {
    cycles::torus(n, m).into_iter().map(Vec::from).collect()
}

/// The torus with the fewest vertices: seven, each joined with all others.
fn seven_vertices() -> Faces {
    (0..7).flat_map(|i| [vec![i, (i + 1) % 7, (i + 3) % 7], vec![i, (i + 3) % 7, (i + 2) % 7]]).collect()
}

/// Two tori, glued together where a face was taken out of each: genus 2.
fn double_torus() -> Faces {
    let [mut first, second] = [torus(3, 4), torus(3, 3)];
    let hole = first.remove(0);
    let other = [0, 3, 4, 1];
    let glued = |v: u32| match other.iter().position(|&corner| corner == v) {
        Some(i) => hole[(4 - i) % 4],
        None => v + 12,
    };
    first.extend(second.into_iter().skip(1).map(|face| face.into_iter().map(glued).collect::<Vec<u32>>()));
    renumbered(&first)
}

fn beside(mut first: Faces, second: Faces) -> Faces {
    let shift = first.iter().flatten().max().map_or(0, |v| v + 1);
    first.extend(second.into_iter().map(|face| face.into_iter().map(|v| v + shift).collect()));
    first
}

/// The vertices numbered on without gaps.
fn renumbered(faces: &Faces) -> Faces {
    let mut used: Vec<u32> = faces.concat();
    used.sort_unstable();
    used.dedup();
    let number = |v: &u32| used.partition_point(|w| w < v) as u32;
    faces.iter().map(|face| face.iter().map(number).collect()).collect()
}

/// Small ones, and some that are not so small.
pub(super) fn all() -> Vec<(&'static str, Faces)> {
    vec![
        ("tetrahedron", tetrahedron()),
        ("pyramid", pyramid(4)),
        ("prism", prism(3)),
        ("bipyramid", bipyramid(3)),
        ("cube", cube()),
        ("octahedron", bipyramid(4)),
        ("pyramid_of_6", pyramid(6)),
        ("bipyramid_of_5", bipyramid(5)),
        ("seven_vertices", seven_vertices()),
        ("torus_of_9", torus(3, 3)),
        ("torus_of_12", torus(3, 4)),
        ("double_torus", double_torus()),
    ]
}

/// Surfaces that are nearly regular: where those stand that are unlike the others, first, last or between.
pub(super) fn unlike() -> Vec<(&'static str, Faces)> {
    let faces = |order: [usize; 5]| order.map(|i| prism(3)[i].clone()).into();
    let vertices = |numbers: [u32; 5]| {
        let face = |face: Vec<u32>| face.into_iter().map(|v| numbers[v as usize]).collect();
        bipyramid(3).into_iter().map(face).collect()
    };
    vec![
        ("prism.squares_first_and_last", faces([2, 3, 0, 1, 4])),
        ("prism.triangles_first_and_last", faces([0, 2, 3, 4, 1])),
        ("bipyramid.tips_between", vertices([0, 1, 4, 2, 3])),
        ("bipyramid.tips_first_and_last", vertices([1, 2, 3, 0, 4])),
    ]
}

/// Surfaces that are regular but for one face or one vertex, which is the first, the last or another one. Something was
/// removed from each.
pub(super) fn unlike_one() -> Vec<(&'static str, Surface)> {
    // Each of v0, v2, v4 joined with each of v1, v3, v5, on a torus: 4, 4 and 10 corners, the ten of two faces merged.
    let [one, other] = [vec![0, 1, 2, 5], vec![0, 3, 4, 1]];
    let [small, large] = [vec![0, 5, 4], vec![4, 3, 2, 1, 4, 5, 2, 3, 0]];
    let first = vec![small.clone(), one.clone(), large.clone(), other.clone()];
    let between = vec![one.clone(), small.clone(), large.clone(), other.clone()];
    let last = vec![large, one, other, small];
    // The faces of a tetrahedron merged to one: three edges are left, all of one vertex.
    let star = |edges: [[u32; 2]; 3]| without(&tetrahedron(), &edges);
    vec![
        ("one_face.first", without(&first, &[[4, 0]])),
        ("one_face.between", without(&between, &[[4, 0]])),
        ("one_face.last", without(&last, &[[4, 0]])),
        ("one_vertex.first", star([[1, 2], [2, 3], [3, 1]])),
        ("one_vertex.between", star([[0, 1], [1, 3], [3, 0]])),
        ("one_vertex.last", star([[0, 1], [1, 2], [2, 0]])),
    ]
}

/// A surface without some edges, each by its ends: the face on the left of the edge stays.
fn without(faces: &Faces, edges: &[[u32; 2]]) -> Surface {
    edges.iter().fold(blind(faces), |surface, &[from, to]| {
        let h = surface.half_edges().find(|&h| surface.start(h) == Some(from) && surface.end(h) == Some(to));
        h.and_then(|h| merged(&surface, h)).unwrap_or(surface)
    })
}

/// Surfaces of several parts.
pub(super) fn parts() -> Vec<(&'static str, Faces)> {
    vec![
        ("two_tetrahedra", beside(tetrahedron(), tetrahedron())),
        ("cube_and_torus", beside(cube(), torus(3, 3))),
        ("torus_and_tetrahedron", beside(torus(3, 4), tetrahedron())),
        ("two_tori", beside(torus(3, 3), seven_vertices())),
        ("three_parts", beside(beside(tetrahedron(), cube()), bipyramid(3))),
    ]
}

/// Large ones: numbers past 256, a vertex with 300 neighbours, a face with 300 corners.
pub(super) fn large() -> Vec<(&'static str, Faces)> {
    vec![
        ("bipyramid_of_40", bipyramid(40)),
        ("pyramid_of_300", pyramid(300)),
        ("prism_of_300", prism(300)),
        ("torus_of_300", torus(15, 20)),
    ]
}

/// A surface that looks random: a simple one, some faces cut in two or given a vertex in the middle, all numbers
/// exchanged. `several` says whether it may have several parts.
pub(super) fn random(random: &mut Random, several: bool) -> Faces {
    let mut from: Vec<(&str, Faces)> = all();
    if several {
        from.extend(parts());
    }
    let mut faces = random.pick(&from).map_or_else(tetrahedron, |(_, faces)| faces.clone());
    for _ in 0..random.below(6) {
        let face = random.below(faces.len());
        if random.below(2) == 0 {
            stellate(&mut faces, face);
        } else {
            cut(&mut faces, face, random);
        }
    }
    exchanged(&faces, random)
}

/// A vertex in the middle of a face, joined to its corners.
fn stellate(faces: &mut Faces, face: usize) {
    let middle = faces.iter().flatten().max().map_or(0, |v| v + 1);
    let corners = faces.swap_remove(face);
    let n = corners.len();
    faces.extend((0..n).map(|i| vec![corners[i], corners[(i + 1) % n], middle]));
}

/// A diagonal through a face, if it has one that no edge has already.
fn cut(faces: &mut Faces, face: usize, random: &mut Random) {
    let n = faces[face].len();
    faces[face].rotate_left(random.below(n));
    let other = 2 + random.below(n.max(4) - 3);
    if other + 1 >= n {
        return;
    }
    let (a, b) = (faces[face][0], faces[face][other]);
    let joins = |f: &Vec<u32>| (0..f.len()).any(|i| [[a, b], [b, a]].contains(&[f[i], f[(i + 1) % f.len()]]));
    if faces.iter().any(joins) {
        return;
    }
    let mut rest = faces[face].split_off(other);
    faces[face].push(b);
    rest.push(a);
    faces.push(rest);
}

/// The same surface with other numbers.
fn exchanged(faces: &Faces, random: &mut Random) -> Faces {
    let vertices = faces.iter().flatten().max().map_or(0, |v| v + 1);
    let numbers = random.order(vertices as usize);
    let order = random.order(faces.len());
    let face = |i: usize| {
        let mut face: Vec<u32> = faces[i].iter().map(|&v| numbers[v as usize] as u32).collect();
        let by = random.below(face.len());
        face.rotate_left(by);
        face
    };
    order.into_iter().map(face).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::counts::{euler_of, parts_of, sizes};
    use dcel_kit::topology::View;

    fn is_closed(name: &str, faces: &Faces) {
        let surface = blind(faces);
        for h in surface.half_edges() {
            assert_eq!(surface.table.twin(h).and_then(|t| surface.table.twin(t)), Some(h), "{name}: {h}");
        }
        for v in 0..surface.points.len() as u32 {
            let starting = surface.half_edges().filter(|&h| surface.start(h) == Some(v)).count();
            assert_eq!(surface.spokes(v).len(), starting, "{name}: v{v}");
        }
    }

    #[test]
    fn the_surfaces_are_closed_and_have_the_numbers_of_the_books() {
        let counts = all().into_iter().chain(parts()).chain(large()).map(|(name, faces)| {
            is_closed(name, &faces);
            let surface = blind(&faces);
            (name, euler_of(&surface), parts_of(&surface).1)
        });
        let expected = [
            ("tetrahedron", 2, 1),
            ("pyramid", 2, 1),
            ("prism", 2, 1),
            ("bipyramid", 2, 1),
            ("cube", 2, 1),
            ("octahedron", 2, 1),
            ("pyramid_of_6", 2, 1),
            ("bipyramid_of_5", 2, 1),
            ("seven_vertices", 0, 1),
            ("torus_of_9", 0, 1),
            ("torus_of_12", 0, 1),
            ("double_torus", -2, 1),
            ("two_tetrahedra", 4, 2),
            ("cube_and_torus", 2, 2),
            ("torus_and_tetrahedron", 2, 2),
            ("two_tori", 0, 2),
            ("three_parts", 6, 3),
            ("bipyramid_of_40", 2, 1),
            ("pyramid_of_300", 2, 1),
            ("prism_of_300", 2, 1),
            ("torus_of_300", 0, 1),
        ];
        assert_eq!(counts.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn what_is_unlike_stands_where_its_name_says() {
        let sizes_of = |wanted: &str| {
            let nearly = unlike().into_iter().map(|(name, faces)| (name, blind(&faces))).chain(unlike_one());
            sizes(&nearly.into_iter().find(|(name, _)| *name == wanted).unwrap().1)
        };
        for (name, faces) in unlike() {
            is_closed(name, &faces);
        }
        let threes = vec![3; 6];
        assert_eq!(sizes_of("prism.squares_first_and_last"), [vec![4, 4, 3, 3, 4], threes.clone()]);
        assert_eq!(sizes_of("prism.triangles_first_and_last"), [vec![3, 4, 4, 4, 3], threes.clone()]);
        assert_eq!(sizes_of("bipyramid.tips_between"), [threes.clone(), vec![4, 4, 3, 3, 4]]);
        assert_eq!(sizes_of("bipyramid.tips_first_and_last"), [threes.clone(), vec![3, 4, 4, 4, 3]]);
        assert_eq!(sizes_of("one_face.first"), [vec![10, 4, 4], threes.clone()]);
        assert_eq!(sizes_of("one_face.between"), [vec![4, 10, 4], threes.clone()]);
        assert_eq!(sizes_of("one_face.last"), [vec![4, 4, 10], threes]);
        assert_eq!(sizes_of("one_vertex.first"), [vec![6], vec![3, 1, 1, 1]]);
        assert_eq!(sizes_of("one_vertex.between"), [vec![6], vec![1, 1, 3, 1]]);
        assert_eq!(sizes_of("one_vertex.last"), [vec![6], vec![1, 1, 1, 3]]);
        assert!(unlike_one().iter().all(|(_, surface)| surface.has_removed()));
    }

    #[test]
    fn what_looks_random_is_closed_and_keeps_the_characteristic_of_what_it_began_with() {
        let mut from = Random::new(5, "shapes");
        for i in 0..200 {
            let faces = random(&mut from, false);
            is_closed(&format!("{i}"), &faces);
            let surface = blind(&faces);
            assert!([2, 0, -2].contains(&euler_of(&surface)) && parts_of(&surface).1 == 1, "{i}");
        }
    }
}
