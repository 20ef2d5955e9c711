//! The lists of faces that cases ask about.
//!
//! ```text
//!   good          one border, several, none; faces that no edge joins; vertices that no face has; faces of any length
//!   of two sides  a directed edge twice, three faces at an edge         pinched   fans that meet at a vertex
//!   random        a few cells with gaps, whole or cut, their vertices renumbered, the faces in any order
//! ```

use super::soup::Soup;
use crate::cases::random::Random;

/// A list with the name of its case.
pub(super) type Named = (&'static str, Soup);

fn of(vertices: u32, faces: &[&[u32]]) -> Soup {
    Soup { vertices, faces: faces.iter().map(|face| face.to_vec()).collect() }
}

/// Lists that are right.
pub(super) fn good() -> Vec<Named> {
    vec![
        ("triangle", Soup::new(3, &[[0, 1, 2]])),
        ("two", Soup::new(4, &[[0, 1, 2], [0, 2, 3]])),
        ("late_start", Soup::new(4, &[[2, 0, 1], [3, 0, 2]])),
        ("quadrangle", of(6, &[&[0, 1, 4, 5], &[1, 2, 3], &[1, 3, 4]])),
        ("handout", of(7, &[&[0, 1, 6], &[1, 2, 3, 6], &[3, 4, 6], &[6, 4, 5, 0]])),
        ("isolated", Soup::new(5, &[[1, 3, 4]])),
        ("apart", Soup::new(6, &[[0, 1, 2], [3, 4, 5]])),
        ("tetrahedron", Soup::new(4, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]])),
        ("two_sides", Soup::new(3, &[[0, 1, 2], [0, 2, 1]])),
        ("ring", Soup::new(6, &[[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]])),
        ("belt", of(8, &[&[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]])),
        ("nothing", of(2, &[])),
        ("fan", fan(6)),
    ]
}

/// Lists that are right, with more records than a byte can count, and faces and fans longer than small numbers.
pub(super) fn large() -> Vec<Named> {
    vec![
        ("fan_of_40", fan(40)),
        ("polygon", Soup { vertices: 300, faces: vec![(0..300).collect()] }),
        ("cells", cells(13)),
        ("ring_of_120", ring(120)),
    ]
}

/// So many triangles round vertex 0, all the way.
fn fan(n: u32) -> Soup {
    Soup { vertices: n + 1, faces: (0..n).map(|i| vec![0, i + 1, (i + 1) % n + 1]).collect() }
}

/// A ring of so many quadrangles: two border cycles.
fn ring(n: u32) -> Soup {
    Soup { vertices: 2 * n, faces: (0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]).collect() }
}

/// So many times so many cells, each cut in two triangles.
pub(super) fn cells(n: u32) -> Soup {
    let vertex = |x: u32, y: u32| y * (n + 1) + x;
    let places = (0..n).flat_map(|y| (0..n).map(move |x| (x, y)));
    let faces = places.flat_map(|(x, y)| {
        let [a, b, c, d] = [vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)];
        [vec![a, b, c], vec![a, c, d]]
    });
    Soup { vertices: (n + 1) * (n + 1), faces: faces.collect() }
}

/// Lists in which two half-edges run from the same vertex to the same vertex.
pub(super) fn with_edges_twice() -> Vec<Named> {
    vec![
        ("same_face_twice", Soup::new(3, &[[0, 1, 2], [0, 1, 2]])),
        ("turned_over", Soup::new(4, &[[0, 1, 2], [0, 3, 2], [1, 3, 2]])),
        ("three_at_an_edge", Soup::new(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]])),
        ("far_apart", of(8, &[&[0, 1, 2], &[3, 4, 5], &[5, 4, 6], &[7, 0, 1]])),
        ("last_side", Soup::new(5, &[[0, 1, 2], [2, 3, 4], [4, 2, 0]])),
    ]
}

/// Lists that are right up to a vertex at which fans of faces meet.
pub(super) fn pinched() -> Vec<Named> {
    vec![
        ("bow_tie", Soup::new(5, &[[0, 1, 2], [0, 3, 4]])),
        ("three_fans", Soup::new(7, &[[0, 1, 2], [3, 0, 4], [5, 6, 0]])),
        ("at_the_end", Soup::new(7, &[[0, 1, 2], [0, 2, 3], [3, 4, 6], [4, 5, 6]])),
        ("round_a_gap", Soup::new(6, &[[0, 1, 5], [1, 2, 3], [5, 3, 4]])),
    ]
}

/// Lists with a number that no vertex has.
pub(super) fn bad_index() -> Vec<Named> {
    vec![
        ("one_too_far", Soup::new(3, &[[0, 1, 3]])),
        ("far", Soup::new(4, &[[0, 1, 2], [0, 2, 900]])),
        ("first_corner", Soup::new(4, &[[0, 1, 2], [4, 0, 2]])),
        ("second_corner", Soup::new(4, &[[7, 1, 2], [3, 0, 2]])),
        ("no_vertices", Soup::new(0, &[[0, 1, 2]])),
        ("long_face", of(5, &[&[0, 1, 2], &[0, 2, 3, 4, 5]])),
        ("past_a_byte", Soup::new(300, &[[0, 1, 299], [0, 299, 300]])),
    ]
}

/// Lists with a face of too few corners, or one that comes to a vertex twice.
pub(super) fn bad_corners() -> Vec<Named> {
    vec![
        ("side_by_side", Soup::new(3, &[[0, 1, 1]])),
        ("first_and_last", Soup::new(3, &[[0, 1, 0]])),
        ("all_three", Soup::new(3, &[[2, 2, 2]])),
        ("across", of(5, &[&[0, 1, 2], &[1, 3, 4, 3, 2]])),
        ("far_across", of(7, &[&[0, 1, 2, 3, 4, 1, 5, 6]])),
        ("two_corners", of(3, &[&[0, 1, 2], &[0, 2]])),
        ("one_corner", of(3, &[&[1], &[0, 1, 2]])),
        ("no_corner", of(3, &[&[0, 1, 2], &[]])),
    ]
}

/// Every list of one, two or three different triangles over four vertices.
pub(super) fn exhaustive() -> Vec<Soup> {
    let corners: [[u32; 3]; 8] =
        [[0, 1, 2], [0, 2, 1], [0, 1, 3], [0, 3, 1], [0, 2, 3], [0, 3, 2], [1, 2, 3], [1, 3, 2]];
    let some = (1u32..256).filter(|some| some.count_ones() <= 3);
    let faces = |some: u32| (0..8).filter(|i| some >> i & 1 == 1).map(|i| corners[i]).collect::<Vec<_>>();
    some.map(|some| Soup::new(4, &faces(some))).collect()
}

/// A list from cells of which some are missing, some cut: right, or pinched.
pub(super) fn random(numbers: &mut Random) -> Soup {
    let (n, m) = (1 + numbers.below(3), 1 + numbers.below(3));
    let vertices = (n + 1) * (m + 1) + numbers.below(2);
    let name = numbers.order(vertices);
    let vertex = |x: usize, y: usize| name[y * (n + 1) + x] as u32;
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for (x, y) in (0..m).flat_map(|y| (0..n).map(move |x| (x, y))) {
        let [a, b, c, d] = [vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)];
        match numbers.below(5) {
            0 => {}
            1 => faces.push(vec![a, b, c, d]),
            2 => faces.push(vec![b, c, d]),
            3 => faces.extend([vec![a, b, c], vec![a, c, d]]),
            _ => faces.extend([vec![a, b, d], vec![b, c, d]]),
        }
    }
    for face in &mut faces {
        let by = numbers.below(face.len());
        face.rotate_left(by);
    }
    let order = numbers.order(faces.len());
    Soup { vertices: vertices as u32, faces: order.into_iter().map(|f| faces[f].clone()).collect() }
}

/// The list with one slip: a face turned over, said twice, with a wrong corner.
pub(super) fn with_a_slip(mut soup: Soup, numbers: &mut Random) -> Soup {
    if soup.faces.is_empty() {
        soup.faces.push(vec![0, 1, soup.vertices]);
    }
    let f = numbers.below(soup.faces.len());
    match numbers.below(4) {
        0 => soup.faces[f].reverse(),
        1 => soup.faces.push(soup.faces[f].clone()),
        2 => {
            let at = numbers.below(soup.faces[f].len());
            soup.faces[f][at] = numbers.below(soup.vertices as usize) as u32;
        }
        _ => {
            let at = numbers.below(soup.faces[f].len());
            soup.faces[f][at] = soup.vertices + numbers.below(3) as u32;
        }
    }
    soup
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_list_is_what_its_group_says() {
        for (name, soup) in good().into_iter().chain(large()) {
            assert!(soup.refusals().is_empty() && !soup.has_vertex_of_two_fans(), "{name}");
        }
        for (name, soup) in with_edges_twice() {
            assert!(soup.bad_faces().is_empty() && !soup.edges_twice().is_empty(), "{name}");
        }
        for (name, soup) in pinched() {
            assert!(soup.bad_faces().is_empty() && soup.edges_twice().is_empty(), "{name}");
            assert!(!soup.pinched().is_empty() && soup.has_vertex_of_two_fans(), "{name}");
        }
        for (name, soup) in bad_index() {
            assert!(soup.bad_faces().iter().all(|why| why.contains("no vertex")), "{name}");
            assert!(!soup.bad_faces().is_empty(), "{name}");
        }
        for (name, soup) in bad_corners() {
            assert!(soup.bad_faces().iter().all(|why| why.contains("twice") || why.contains("fewer")), "{name}");
            assert!(!soup.bad_faces().is_empty(), "{name}");
        }
    }

    #[test]
    fn random_lists_are_of_both_kinds() {
        let mut numbers = Random::new(1, "lists");
        let mut refused = 0;
        for _ in 0..200 {
            let soup = random(&mut numbers);
            assert!(soup.bad_faces().is_empty() && soup.edges_twice().is_empty(), "{soup:?}");
            assert_eq!(soup.pinched().is_empty(), !soup.has_vertex_of_two_fans(), "{soup:?}");
            refused += usize::from(!soup.refusals().is_empty());
        }
        assert!((20..180).contains(&refused), "{refused}");
    }
}
