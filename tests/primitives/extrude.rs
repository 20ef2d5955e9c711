//! Extrusion against doing it on lists of corners.

use crate::common::Random;
use crate::grow::{Looked, counts, from_lists};
use dcel_kit::solid::Selection;
use dcel_kit::solid::grow::{GrowError, Primitives, Shape, extrude};
use dcel_kit::topology::{Dcel, isomorphic};
use dcel_kit::{FaceId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

fn corners(d: &Dcel, f: FaceId) -> Vec<u32> {
    d.incident_vertices(f).map(VertexId::number).collect()
}

/// Replaces every vertex of the border by a new one in the selected faces and adds the walls. `None` if the selection
/// touches itself in a vertex.
fn on_lists(d: &Dcel, is_in: impl Fn(FaceId) -> bool) -> Option<Dcel> {
    let mut lists: Vec<(bool, Vec<u32>)> = d.faces().map(|f| (is_in(f), corners(d, f))).collect();
    let sides = |list: &[u32]| (0..list.len()).map(|i| (list[i], list[(i + 1) % list.len()])).collect::<Vec<_>>();
    let inside: BTreeSet<(u32, u32)> = lists.iter().filter(|(is, _)| *is).flat_map(|(_, list)| sides(list)).collect();
    let border: Vec<(u32, u32)> = inside.iter().copied().filter(|&(a, b)| !inside.contains(&(b, a))).collect();
    let mut above = BTreeMap::new();
    for &(foot, _) in &border {
        let new = (d.vertex_count() + above.len()) as u32;
        if above.insert(foot, new).is_some() {
            return None;
        }
    }
    for (_, list) in lists.iter_mut().filter(|(is, _)| *is) {
        list.iter_mut().for_each(|v| *v = above.get(v).copied().unwrap_or(*v));
    }
    lists.extend(border.iter().map(|&(a, b)| (false, vec![a, b, above[&b], above[&a]])));
    let faces: Vec<Vec<u32>> = lists.into_iter().map(|(_, list)| list).collect();
    Some(from_lists(d.vertex_count() + above.len(), &faces))
}

#[test]
fn random_selections_are_lifted_as_lists_of_corners_say() {
    let starts =
        [Shape::Torus { n: 5, m: 4 }, Shape::Sphere { sides: 5, bands: 4 }, Shape::Cuboid { x: 2, y: 2, z: 2 }];
    let (mut compared, mut touching) = (0, 0);
    for seed in 0..90 {
        let mut random = Random(seed);
        let start = starts[seed as usize % 3].build().unwrap().polyhedron.topology().clone();
        // A patch that grows over edges, or scattered faces.
        let mut selection = Selection::new();
        let mut patch = vec![FaceId::new(random.below(start.face_count()) as u32)];
        for _ in 0..1 + random.below(9) {
            let from = patch[random.below(patch.len())];
            let near: Vec<FaceId> = start.adjacent_faces(from).collect();
            let scattered = FaceId::new(random.below(start.face_count()) as u32);
            patch.push(if seed % 4 == 3 { scattered } else { near[random.below(near.len())] });
        }
        patch.iter().for_each(|&f| selection.add(f, 2));
        let is_in = |f: FaceId| patch.contains(&f);
        let border: Vec<_> =
            start.half_edges().filter(|&a| is_in(start.face(a)) && !is_in(start.face(a.twin()))).collect();

        let mut looked = Looked::new(start.clone());
        let made = extrude(&mut looked, &selection, 2).unwrap();
        let (after, context) = (looked.dcel(), format!("seed {seed}: {:?} of {patch:?}", starts[seed as usize % 3]));
        let [v, e, f] = counts(&start);
        let b = border.len();
        assert_eq!(counts(after), [v + b, e + 2 * b, f + b], "{context}");
        assert_eq!(looked.splits, 2 * b, "{context}");
        assert!(made.walls.iter().all(|wall| after.incident_half_edges(wall.face).count() == 4), "{context}");
        for &wall in &made.walls {
            assert_eq!((after.face(wall.foot), after.face(wall.foot.twin())), (wall.face, wall.below), "{context}");
            assert!(border.contains(&wall.foot), "{context}");
        }
        // The caps keep their ids and stand on the new vertices and the inner ones.
        let on_caps: BTreeSet<VertexId> = patch.iter().flat_map(|&f| after.incident_vertices(f)).collect();
        let moving = made.lifted.iter().map(|&(_, top)| top).chain(made.inner.iter().copied());
        assert_eq!(on_caps, moving.collect(), "{context}");
        match on_lists(&start, is_in) {
            Some(expected) => {
                compared += 1;
                assert_eq!(isomorphic(after, &expected).map(drop), Ok(()), "{context}");
            }
            None => touching += 1,
        }
    }
    assert!(compared > 40 && touching > 10, "{compared} {touching}");
}

#[test]
fn what_has_no_border_or_too_few_sides_is_refused() {
    let mut torus = Shape::Torus { n: 3, m: 3 }.build().unwrap().polyhedron.topology().clone();
    let mut all = Selection::new();
    torus.faces().for_each(|f| all.add(f, 1));
    let before = torus.clone();
    assert_eq!(extrude(&mut torus, &all, 1), Err(GrowError::NoBorder { selected: 9, faces: 9 }));
    let mut gone = Selection::new();
    gone.add(FaceId::new(9), 1);
    assert!(matches!(extrude(&mut torus, &gone, 1), Err(GrowError::Id(_))));
    assert_eq!(torus, before);
    let mut two = Dcel::polygon(2).unwrap();
    let mut one = Selection::new();
    one.add(FaceId::new(1), 1);
    let (face, h) = (FaceId::new(1), dcel_kit::HalfEdgeId::new(0));
    assert_eq!(extrude(&mut two, &one, 1), Err(GrowError::FewSides { h, face, sides: 2, least: 3 }));
    assert_eq!(two, Dcel::polygon(2).unwrap());
}
