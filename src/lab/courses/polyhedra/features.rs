//! What can be said of a call of this lab before it is made.

use super::counts::{common, counts, euler_of, parts_of, sizes};
use super::surface::Surface;
use super::{angles, dual, merging};
use crate::FeatureSet;
use crate::fault::Exchange;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::View;
use std::f64::consts::PI;

crate::features! {
    Removed "removed" "something was removed before",
    Parts "parts" "the surface has several parts",
    Handle "handle" "the surface is connected and has a handle",
    TwoHandles "two_handles" "the surface has two handles",
    NotTwo "not_two" "V - E + F is not 2",
    NotThreeHalves "not_three_halves" "a face has more than three corners",
    ThreeCorners "three_corners" "the mean of the first three corners of a face is not that of all",
    Records256 "records_256" "there are more than 256 half-edges",

    Degree2 "degree_2" "the vertex has at most two edges",
    Degree3 "degree_3" "the vertex has more than two edges",
    Degree8 "degree_8" "the vertex has more than 8 edges",
    Degree16 "degree_16" "the vertex has more than 16 edges",

    FacesOnly "faces_only" "all faces have equally many corners, but not all vertices equally many edges",
    VerticesOnly "vertices_only" "all vertices have equally many edges, but not all faces equally many corners",
    Regular "regular" "all faces have equally many corners and all vertices equally many edges",
    Unequal "unequal" "faces have another number of corners than vertices have edges",
    FaceBetween "face_between" "the first and the last face have equally many corners, and one between them has not",
    FaceLast "face_last" "only the last face has another number of corners",
    VertexBetween "vertex_between" "the first and the last vertex have equally many edges, and one between them has not",
    VertexLast "vertex_last" "only the last vertex has another number of edges",

    ArcCosine "arc_cosine" "the arc cosine of a quotient is too far from the angle",
    OtherCorners "other_corners" "not all faces at the vertex are regular polygons",
    Obtuse "obtuse" "a face has an angle of more than a right one at the vertex",
    NotHalf "not_half" "the angles at the vertex do not add up to pi",
    Degree4 "degree_4" "the vertex has more than three edges",
    Reflex "reflex" "the edge is reflex",
    Flat "flat" "the two faces are in one plane",
    Right "right" "the two faces are at a right angle",
    NotRight "not_right" "the two faces are not at a right angle",
    Tiny "tiny" "all coordinates are below a millionth of a millionth",
    Square "square" "one of the two faces has more than three corners",

    SameFace "same_face" "one face lies on both sides of the edge",
    TwoFaces "two_faces" "two different faces lie beside the edge",
    FaceStores "face_stores" "the face on the left stores this half-edge",
    FaceStoresGone "face_stores_gone" "one face lies on both sides of the edge, and stores this half-edge",
    OriginStores "origin_stores" "the origin stores this half-edge",
    DestinationStores "destination_stores" "the destination stores the twin",
    RightBig "right_big" "the face on the right has more than three corners",
    RightLarge "right_large" "the face on the right has more than 8 corners",
    Dangling "dangling" "the edge ends at a vertex without another edge",
}

/// What holds of a call.
pub(super) fn of(_: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let surface = Surface::of(exchange.records_before()?);
    let mut set = FeatureSet::default();
    let argument = exchange.called.and_then(|(arguments, _)| arguments.first().copied());
    match exchange.function {
        "deficit_angle" => of_vertex_angle(&surface, argument?, &mut set)?,
        "dihedral_angle" => of_edge_angle(&surface, HalfEdgeId::new(argument?), &mut set)?,
        "merge_faces" => of_edge(&surface, HalfEdgeId::new(argument?), &mut set)?,
        "vertices_around" => of_vertex(&surface, argument?, &mut set),
        "regular" => of_sizes(&surface, &mut set),
        _ => of_surface(&surface, &mut set),
    }
    Some(set.bits())
}

fn of_surface(surface: &Surface, set: &mut FeatureSet) {
    let (euler, parts) = (euler_of(surface), parts_of(surface).1);
    let [_, e, f] = counts(surface);
    set.add(Word::Removed, surface.has_removed());
    set.add(Word::Parts, parts > 1);
    set.add(Word::Handle, parts == 1 && euler < 2);
    set.add(Word::TwoHandles, parts == 1 && euler < 0);
    set.add(Word::NotTwo, euler != 2);
    set.add(Word::NotThreeHalves, 2 * e != 3 * f);
    set.add(Word::ThreeCorners, dual::differs_from_first_three(surface));
    set.add(Word::Records256, surface.table.half_edges.len() > 256);
}

fn of_vertex(surface: &Surface, v: u32, set: &mut FeatureSet) {
    let degree = surface.spokes(v).len();
    set.either(Word::Degree2, Word::Degree3, degree <= 2);
    set.add(Word::Degree8, degree > 8);
    set.add(Word::Degree16, degree > 16);
    set.add(Word::Removed, surface.has_removed());
    set.add(Word::Records256, surface.table.half_edges.len() > 256);
}

fn of_sizes(surface: &Surface, set: &mut FeatureSet) {
    let [faces, vertices] = sizes(surface);
    let (p, q) = (common(&faces), common(&vertices));
    set.add(Word::FacesOnly, p.is_some() && q.is_none());
    set.add(Word::VerticesOnly, p.is_none() && q.is_some());
    set.add(Word::Regular, p.is_some() && q.is_some());
    set.add(Word::Unequal, p.is_some() && q.is_some() && p != q);
    let between = |sizes: &[usize]| common(sizes).is_none() && sizes.first() == sizes.last();
    let last = |sizes: &[usize]| common(sizes).is_none() && common(&sizes[..sizes.len() - 1]).is_some();
    set.add(Word::FaceBetween, between(&faces));
    set.add(Word::FaceLast, last(&faces));
    set.add(Word::VertexBetween, between(&vertices));
    set.add(Word::VertexLast, last(&vertices));
    set.add(Word::Removed, surface.has_removed());
    set.add(Word::Handle, euler_of(surface) < 2);
}

fn is_tiny(surface: &Surface) -> bool {
    surface.points.iter().flatten().all(|x| x.abs() < 1e-12)
}

fn of_vertex_angle(surface: &Surface, v: u32, set: &mut FeatureSet) -> Option<()> {
    set.add(Word::ArcCosine, angles::arc_cosine_loses_deficit(surface, v)?);
    set.add(Word::OtherCorners, !angles::has_regular_corners(surface, v)?);
    set.add(Word::Obtuse, angles::has_obtuse_corner(surface, v)?);
    let half = PI - angles::deficit(surface, v)?;
    set.add(Word::NotHalf, half.abs() > angles::TOLERANCE);
    let degree = surface.spokes(v).len();
    set.add(Word::Degree4, degree > 3);
    set.add(Word::Degree8, degree > 8);
    set.add(Word::Tiny, is_tiny(surface));
    Some(())
}

fn of_edge_angle(surface: &Surface, h: HalfEdgeId, set: &mut FeatureSet) -> Option<()> {
    let angle = angles::dihedral(surface, h)?;
    set.add(Word::ArcCosine, angles::arc_cosine_loses_dihedral(surface, h)?);
    set.add(Word::Flat, (angle - PI).abs() <= angles::TOLERANCE);
    set.add(Word::Reflex, angle > PI + angles::TOLERANCE);
    let is_right = (angle - PI / 2.0).abs() <= angles::TOLERANCE;
    set.either(Word::Right, Word::NotRight, is_right);
    set.add(Word::Tiny, is_tiny(surface));
    let sides = [surface.table.face(h)?, surface.table.face(surface.table.twin(h)?)?];
    set.add(Word::Square, sides.iter().any(|&f| surface.of_face(f).len() > 3));
    Some(())
}

fn of_edge(surface: &Surface, h: HalfEdgeId, set: &mut FeatureSet) -> Option<()> {
    let twin = surface.table.twin(h)?;
    let (left, right) = (surface.table.face(h)?, surface.table.face(twin)?);
    let stored = |f: dcel_kit::FaceId| surface.table.faces.get(f.index()).and_then(|row| row.as_ref()?.half_edge);
    let outgoing = |h: HalfEdgeId| {
        let origin = surface.table.origin(h)?;
        surface.table.vertices.get(origin.index())?.as_ref()?.outgoing
    };
    let same = merging::merged(surface, h).is_none();
    set.either(Word::SameFace, Word::TwoFaces, same);
    set.add(Word::FaceStoresGone, same && stored(left) == Some(h));
    set.add(Word::FaceStores, !same && stored(left) == Some(h));
    set.add(Word::OriginStores, !same && outgoing(h) == Some(h));
    set.add(Word::DestinationStores, !same && outgoing(twin) == Some(twin));
    let size = surface.of_face(right).len();
    set.add(Word::RightBig, !same && size > 3);
    set.add(Word::RightLarge, !same && size > 8);
    set.add(Word::Dangling, surface.table.next(h) == Some(twin) || surface.table.next(twin) == Some(h));
    set.add(Word::Removed, surface.has_removed());
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::{shapes, starts};

    fn said(set: FeatureSet) -> Vec<&'static str> {
        VOCABULARY.iter().filter(|feature| set.has(VOCABULARY, feature.id)).map(|feature| feature.id).collect()
    }

    #[test]
    fn surfaces_are_said_to_be_what_they_are() {
        let of = |wanted: &str| {
            let all = shapes::all().into_iter().chain(shapes::parts());
            let (_, faces) = all.into_iter().find(|(name, _)| *name == wanted).unwrap();
            let (mut set, mut sizes) = (FeatureSet::default(), FeatureSet::default());
            of_surface(&shapes::blind(&faces), &mut set);
            of_sizes(&shapes::blind(&faces), &mut sizes);
            (said(set), said(sizes))
        };
        assert_eq!(of("tetrahedron"), (vec![], vec!["regular"]));
        assert_eq!(of("bipyramid"), (vec![], vec!["faces_only"]));
        assert_eq!(of("prism"), (vec!["not_three_halves"], vec!["vertices_only"]));
        let double = vec!["handle", "two_handles", "not_two", "not_three_halves"];
        assert_eq!(of("double_torus").0, double);
        assert_eq!(of("two_tori").0, ["parts", "not_two", "not_three_halves"]);
    }

    #[test]
    fn angles_are_said_to_be_what_they_are() {
        let (_, needle) = &starts::sharp()[0];
        let mut set = FeatureSet::default();
        of_vertex_angle(needle, 3, &mut set).unwrap();
        assert_eq!(said(set), ["arc_cosine", "other_corners", "not_half"]);
        let cube = starts::solids().into_iter().find(|(name, _)| name == "cube").unwrap().1;
        let mut set = FeatureSet::default();
        of_edge_angle(&cube, HalfEdgeId::new(0), &mut set).unwrap();
        assert_eq!(said(set), ["right", "square"]);
    }
}
