//! What can be said of a call of lab 04 before it is made, so that failing calls can be told from passing ones.
//!
//! ```text
//!            he1                    the face is the outer one?  has more than 8 half-edges?  meets a vertex twice?
//!        ●───────▶●                 its stored half-edge is on the loop of the new face?
//!        ▲  face  │                 he1 comes after he2 on the walk from the stored half-edge?
//!        ●◀───────▼ he2             he1 starts at a vertex of degree 1?   …
//! ```

use super::spec::{Legal, may_split_face, midpoint as middle_of};
use crate::checks::walks::{cycle, star};
use crate::fault::Exchange;
use crate::features::FeatureSet;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

crate::features! {
    Same "same" "he1 and he2 are the same half-edge",
    Next "next" "he2 is the next of he1",
    Prev "prev" "he1 is the next of he2",
    OnlyNext "only_next" "he2 is the next of he1, and he1 is not the next of he2",
    OnlyPrev "only_prev" "he1 is the next of he2, and he2 is not the next of he1",
    NextOrPrev "next_or_prev" "one of the two half-edges is the next of the other",
    OtherFaces "other_faces" "he1 and he2 have different faces",
    Illegal "illegal" "the call must be refused",
    Legal "legal" "the call is legal",
    NoTwins "no_twins" "no twin is set",
    NoLinks "no_links" "no next and no prev are set",
    Blind "blind" "all vertices have the same position",
    Outer "outer" "the face is the outer one",
    Bounded "bounded" "the face is not the outer one",
    TwinOuter "twin_outer" "the face of the twin is the outer one",
    TwinBounded "twin_bounded" "the face of the twin is not the outer one",
    Border "border" "the edge lies on the outer face",
    Inside "inside" "no side of the edge lies on the outer face",
    StoredNew "stored_new" "the face stores a half-edge that goes over to the new face",
    StoredOld "stored_old" "the face stores a half-edge that stays in it",
    He1Stored "he1_stored" "the face stores he1",
    He2Stored "he2_stored" "the face stores he2",
    HeStored "he_stored" "the face of he stores he",
    TwinStored "twin_stored" "the face of the twin stores the twin",
    OriginStores "origin_stores" "the origin of he stores he",
    EndStores "end_stores" "the vertex at the end of he stores the twin",
    EndStoresOther "end_stores_other" "the vertex at the end of he stores another half-edge than the twin",
    Dangling "dangling" "the edge is a dangling one: it ends at a vertex of degree 1",
    StartsAlone "starts_alone" "he starts at a vertex of degree 1",
    EndsAlone "ends_alone" "he ends at a vertex of degree 1",
    Bridge "bridge" "the edge has the same face on both sides",
    TwoFaces "two_faces" "the edge has two different faces",
    FaceDangling "face_dangling" "the face has a dangling edge",
    FaceBridge "face_bridge" "the face has an edge with both of its sides in it",
    Twice "twice" "the face meets a vertex twice",
    CornerTwice "corner_twice" "the face meets the origin of he1 or of he2 twice",
    OneVertex "one_vertex" "he1 and he2 start at the same vertex",
    TwoVertices "two_vertices" "he1 and he2 start at two different vertices",
    Neighbours "neighbours" "an edge joins the two origins, though neither half-edge follows the other",
    He1Ends "he1_ends" "he1 ends where he2 starts, though he2 is not the next of it",
    He2Ends "he2_ends" "he2 ends where he1 starts, though he1 is not the next of it",
    EitherEnds "either_ends" "one of the two half-edges ends where the other starts, though the other is not its next",
    CornerAlone "corner_alone" "he1 or he2 starts at a vertex of degree 1",
    He1Bridge "he1_bridge" "he1 has its own face on the other side, too",
    He2Bridge "he2_bridge" "he2 has its own face on the other side, too",
    He1Twin "he1_twin" "the half-edge before he1 is its twin",
    He2Twin "he2_twin" "the half-edge before he2 is its twin",
    VertexAlone "vertex_alone" "the vertex has degree 1",
    VertexTwice "vertex_twice" "a face meets the vertex twice",
    VertexBorder "vertex_border" "the vertex lies on the outer face",
    VertexInside "vertex_inside" "the vertex does not lie on the outer face",
    NotTriangle "not_triangle" "a face at the vertex has more or fewer than three half-edges",
    New3 "new_3" "the new face gets three half-edges",
    New3More "new_3_more" "the new face gets more than three half-edges",
    Old3 "old_3" "the old face keeps three half-edges",
    Old3More "old_3_more" "the old face keeps more than three half-edges",
    He1After "he1_after" "he1 comes after he2 on the walk from the half-edge that the face stores",
    He2After "he2_after" "he2 comes after he1 on the walk from the half-edge that the face stores",
    He1Greater "he1_greater" "he1 has a greater number than he2",
    He2Greater "he2_greater" "he2 has a greater number than he1",
    HeGreater "he_greater" "he has a greater number than its twin",
    TwinGreater "twin_greater" "the twin has a greater number than he",
    StoredNotLeast "stored_not_least" "the face stores another half-edge than that with the smallest number",
    NotRising "not_rising" "the numbers of the half-edges do not rise along the face",
    Fraction "fraction" "a coordinate of the midpoint is not a whole number",
    Negative "negative" "a coordinate of the midpoint is negative",
    FourDecimals "four_decimals" "a coordinate of the midpoint has more than four decimals",
    NotFromZero "not_from_zero" "he does not start at (0, 0)",
    NotToZero "not_to_zero" "he does not end at (0, 0)",
    FarFraction "far_fraction" "a coordinate of the midpoint is not a multiple of 1/65536",
    Triangle "triangle" "the face of he has three half-edges",
    Vertex2 "degree_2" "the vertex has degree 2",
    _Vertex2More "degree_2_more" "the vertex has a degree above 2",
    _Vertex3More "degree_3_more" "the vertex has a degree above 3",
    _Vertex4More "degree_4_more" "the vertex has a degree above 4",
    _Vertex8More "degree_8_more" "the vertex has a degree above 8",
    _Vertex16More "degree_16_more" "the vertex has a degree above 16",
    Corner2More "corner_2_more" "he1 or he2 starts at a vertex with a degree above 2",
    End2More "end_2_more" "he ends at a vertex with a degree above 2",
    _Face1More "face_1_more" "the face has more than one half-edge",
    _Face2More "face_2_more" "the face has more than two half-edges",
    _Face3More "face_3_more" "the face has more than 3 half-edges",
    _Face4More "face_4_more" "the face has more than 4 half-edges",
    _Face6More "face_6_more" "the face has more than 6 half-edges",
    _Face8More "face_8_more" "the face has more than 8 half-edges",
    _Face12More "face_12_more" "the face has more than 12 half-edges",
    _Face16More "face_16_more" "the face has more than 16 half-edges",
    _Face24More "face_24_more" "the face has more than 24 half-edges",
    _Face32More "face_32_more" "the face has more than 32 half-edges",
    _Face64More "face_64_more" "the face has more than 64 half-edges",
    NewShorter "new_shorter" "the new face gets fewer half-edges than the old one keeps",
    OldShorter "old_shorter" "the old face keeps fewer half-edges than the new one gets",
    NewMeets1 "new_meets_1" "the new face comes to the origin of he1 more than once",
    NewMeets2 "new_meets_2" "the new face comes to the origin of he2 more than once",
    OldMeets1 "old_meets_1" "the old face still comes to the origin of he1 more than once",
    OldMeets2 "old_meets_2" "the old face still comes to the origin of he2 more than once",
    _New4More "new_4_more" "the new face gets more than 4 half-edges",
    _New5More "new_5_more" "the new face gets more than 5 half-edges",
    _New6More "new_6_more" "the new face gets more than 6 half-edges",
    _New7More "new_7_more" "the new face gets more than 7 half-edges",
    _New8More "new_8_more" "the new face gets more than 8 half-edges",
    _New9More "new_9_more" "the new face gets more than 9 half-edges",
    _New10More "new_10_more" "the new face gets more than 10 half-edges",
    _New12More "new_12_more" "the new face gets more than 12 half-edges",
    _New16More "new_16_more" "the new face gets more than 16 half-edges",
    _New24More "new_24_more" "the new face gets more than 24 half-edges",
    _New32More "new_32_more" "the new face gets more than 32 half-edges",
    _New64More "new_64_more" "the new face gets more than 64 half-edges",
    _Faces2More "faces_2_more" "there are more than 2 faces",
    _Faces3More "faces_3_more" "there are more than 3 faces",
    _Faces4More "faces_4_more" "there are more than 4 faces",
    _Faces8More "faces_8_more" "there are more than 8 faces",
    _Vertices8More "vertices_8_more" "there are more than 8 vertices",
    Half255 "half_255" "there are half-edges with numbers above 255",
    Later "later" "another call of the sequence came before it",
    AfterHalf "after_half" "an edge was split before, in the same sequence",
    AfterSplit "after_split" "a face was split before, in the same sequence",
    IsSplitFace "is_split_face" "split_face is called",
    IsSplitInHalf "is_split_in_half" "split_in_half is called",
}

/// What holds of a call. `earlier` are the calls before it in the same sequence.
pub(super) fn of(earlier: &[&Exchange], exchange: &Exchange) -> Option<u128> {
    let (before, arguments) = (exchange.before()?, exchange.called?.0);
    let mut set = FeatureSet::default();
    let of_table = |set: &mut FeatureSet| whole(set, before);
    match (exchange.function, arguments) {
        ("split_face", &[h1, h2]) => {
            of_table(&mut set);
            split_face(&mut set, before, [h1, h2].map(HalfEdgeId::new))?;
            set.add(Word::IsSplitFace, true);
        }
        ("split_in_half", &[h]) => {
            of_table(&mut set);
            half_edge(&mut set, before, HalfEdgeId::new(h));
            midpoint(&mut set, before, HalfEdgeId::new(h));
            set.add(Word::IsSplitInHalf, true);
        }
        ("walk_face" | "walk_vertices", &[f]) => face(&mut set, before, FaceId::new(f)),
        ("walk_vertex", &[v]) => vertex(&mut set, before, VertexId::new(v)),
        ("destination" | "destination_by_next", &[h]) => half_edge(&mut set, before, HalfEdgeId::new(h)),
        _ => return None,
    }
    let was = |function| earlier.iter().any(|other| other.function == function);
    set.add(Word::Later, !earlier.is_empty());
    set.add(Word::AfterHalf, was("split_in_half"));
    set.add(Word::AfterSplit, was("split_face"));
    Some(set.bits())
}

fn whole(set: &mut FeatureSet, table: &Table) {
    set.more(VOCABULARY, "faces_N_more", table.faces.len());
    set.more(VOCABULARY, "vertices_N_more", table.vertices.len());
    set.add(Word::Half255, table.half_edges.len() > 256);
    let mut places = table.vertices.iter().flatten().map(|row| row.position);
    let first = places.next();
    set.add(Word::Blind, table.vertices.len() > 1 && places.all(|place| Some(place) == first));
}

fn degree(table: &Table, v: VertexId) -> usize {
    table.outgoing(v).map_or(0, |h| star(table, h).len())
}

/// The features of a face, whose half-edges are given.
fn loop_of(set: &mut FeatureSet, table: &Table, f: FaceId, walk: &[HalfEdgeId]) {
    set.either(Word::Outer, Word::Bounded, table.outer_face == Some(f));
    let origins: BTreeSet<Option<VertexId>> = walk.iter().map(|&h| table.origin(h)).collect();
    set.add(Word::Twice, origins.len() < walk.len());
    let has_own_twin = |h: &HalfEdgeId| table.twin(*h).is_some_and(|twin| table.face(twin) == Some(f));
    set.add(Word::FaceBridge, walk.iter().any(has_own_twin));
    set.add(Word::FaceDangling, walk.iter().any(|&h| table.next(h).is_some() && table.next(h) == table.twin(h)));
    set.more(VOCABULARY, "face_N_more", walk.len());
}

fn face(set: &mut FeatureSet, table: &Table, f: FaceId) {
    let Some(stored) = table.half_edge(f) else { return };
    let walk = cycle(table, stored);
    loop_of(set, table, f, &walk);
    set.add(Word::StoredNotLeast, walk.iter().min() != Some(&stored));
    let least = walk.iter().enumerate().min_by_key(|&(_, h)| h).map_or(0, |(at, _)| at);
    let (end, begin) = walk.split_at(least);
    let from_least: Vec<HalfEdgeId> = begin.iter().chain(end).copied().collect();
    set.add(Word::NotRising, !from_least.is_sorted());
}

fn vertex(set: &mut FeatureSet, table: &Table, v: VertexId) {
    let Some(stored) = table.outgoing(v) else { return };
    let spokes = star(table, stored);
    set.add(Word::VertexAlone, spokes.len() == 1);
    set.add(Word::Vertex2, spokes.len() == 2);
    set.more(VOCABULARY, "degree_N_more", spokes.len());
    let faces: BTreeSet<Option<FaceId>> = spokes.iter().map(|&h| table.face(h)).collect();
    let is_triangle = |&h: &HalfEdgeId| cycle_of_three(table, h);
    set.add(Word::NotTriangle, !spokes.iter().all(is_triangle));
    set.add(Word::VertexTwice, faces.len() < spokes.len());
    set.either(Word::VertexBorder, Word::VertexInside, faces.contains(&table.outer_face));
}

/// Whether the face of a half-edge is closed after three steps, and not before.
fn cycle_of_three(table: &Table, h: HalfEdgeId) -> bool {
    let steps: Vec<Option<HalfEdgeId>> =
        std::iter::successors(Some(Some(h)), |at| Some(at.and_then(|at| table.next(at)))).skip(1).take(3).collect();
    steps[0] != Some(h) && steps[2] == Some(h)
}

/// The features of a half-edge and its edge; they are also those of splitting it.
fn half_edge(set: &mut FeatureSet, table: &Table, h: HalfEdgeId) {
    let rows = || table.half_edges.iter().flatten();
    set.add(Word::NoTwins, rows().all(|row| row.twin.is_none()));
    set.add(Word::NoLinks, rows().all(|row| row.next.is_none() && row.prev.is_none()));
    let f = table.face(h);
    set.either(Word::Outer, Word::Bounded, f.is_some() && f == table.outer_face);
    set.add(Word::HeStored, f.and_then(|f| table.half_edge(f)) == Some(h));
    set.add(Word::OriginStores, table.origin(h).and_then(|v| table.outgoing(v)) == Some(h));
    if f.is_some() && table.next(h).is_some() {
        set.add(Word::Triangle, cycle(table, h).len() == 3);
    }
    let Some(twin) = table.twin(h) else { return };
    set.either(Word::HeGreater, Word::TwinGreater, h > twin);
    let g = table.face(twin);
    set.either(Word::TwinOuter, Word::TwinBounded, g.is_some() && g == table.outer_face);
    set.either(Word::Border, Word::Inside, [f, g].contains(&table.outer_face));
    set.either(Word::Bridge, Word::TwoFaces, f == g);
    set.add(Word::TwinStored, g.and_then(|g| table.half_edge(g)) == Some(twin));
    let (starts, ends) = (table.prev(h) == Some(twin), table.next(h) == Some(twin));
    set.add(Word::StartsAlone, starts);
    set.add(Word::EndsAlone, ends);
    set.add(Word::Dangling, starts || ends);
    if let Some(end) = table.origin(twin) {
        set.either(Word::EndStores, Word::EndStoresOther, table.outgoing(end) == Some(twin));
        set.add(Word::End2More, degree(table, end) > 2);
    }
}

fn midpoint(set: &mut FeatureSet, table: &Table, h: HalfEdgeId) {
    let place = |v: Option<VertexId>| table.vertices.get(v?.index()).copied().flatten()?.position;
    let ends = (place(table.origin(h)), place(table.twin(h).and_then(|twin| table.origin(twin))));
    let (Some(p), Some(q)) = ends else { return };
    let middle = middle_of(p, q);
    set.add(Word::Fraction, middle.iter().any(|x| x.fract() != 0.0));
    set.add(Word::Negative, middle.iter().any(|&x| x < 0.0));
    let decimals = |x: &f64| (x * 1e4).round() / 1e4;
    set.add(Word::FourDecimals, middle.iter().any(|x| (decimals(x) - x).abs() > 0.0));
    set.add(Word::NotFromZero, p.iter().any(|&x| x != 0.0));
    set.add(Word::NotToZero, q.iter().any(|&x| x != 0.0));
    set.add(Word::FarFraction, middle.iter().any(|x| (x * 65_536.0).fract() != 0.0));
}

fn split_face(set: &mut FeatureSet, table: &Table, [h1, h2]: [HalfEdgeId; 2]) -> Option<()> {
    let legal = may_split_face(table, h1, h2);
    set.either(Word::Legal, Word::Illegal, legal == Legal::Yes);
    set.add(Word::Same, h1 == h2);
    let (next, prev) = (table.next(h1) == Some(h2), table.next(h2) == Some(h1));
    set.add(Word::Next, next);
    set.add(Word::Prev, prev);
    set.add(Word::OnlyNext, next && !prev);
    set.add(Word::OnlyPrev, prev && !next);
    set.add(Word::NextOrPrev, next || prev);
    set.add(Word::OtherFaces, table.face(h1) != table.face(h2));
    set.either(Word::He1Greater, Word::He2Greater, h1 > h2);
    let f = table.face(h1)?;
    let (o1, o2) = (table.origin(h1)?, table.origin(h2)?);
    set.add(Word::OneVertex, o1 == o2 && h1 != h2);
    set.add(Word::TwoVertices, o1 != o2);
    let spokes = table.outgoing(o1).map_or_else(Vec::new, |h| star(table, h));
    let joined = spokes.iter().any(|&h| table.twin(h).and_then(|twin| table.origin(twin)) == Some(o2));
    set.add(Word::Neighbours, joined && legal == Legal::Yes);
    let ends_at =
        |h, next: HalfEdgeId, v| table.next(h) != Some(next) && table.next(h).and_then(|n| table.origin(n)) == Some(v);
    set.add(Word::He1Ends, ends_at(h1, h2, o2));
    set.add(Word::He2Ends, ends_at(h2, h1, o1));
    set.add(Word::EitherEnds, ends_at(h1, h2, o2) || ends_at(h2, h1, o1));
    let degrees = [spokes.len(), degree(table, o2)];
    set.add(Word::CornerAlone, degrees.contains(&1));
    set.add(Word::Corner2More, degrees.iter().any(|&degree| degree > 2));
    for (h, bridge, twin) in [(h1, Word::He1Bridge, Word::He1Twin), (h2, Word::He2Bridge, Word::He2Twin)] {
        set.add(bridge, table.twin(h).and_then(|twin| table.face(twin)) == table.face(h));
        set.add(twin, table.prev(h) == table.twin(h));
    }
    let stored = table.half_edge(f)?;
    let walk = cycle(table, stored);
    loop_of(set, table, f, &walk);
    let at_corner = |v| walk.iter().filter(|&&h| table.origin(h) == Some(v)).count();
    set.add(Word::CornerTwice, at_corner(o1) > 1 || at_corner(o2) > 1);
    set.add(Word::He1Stored, stored == h1);
    set.add(Word::He2Stored, table.face(h2).and_then(|f| table.half_edge(f)) == Some(h2));
    if legal != Legal::Yes {
        return Some(());
    }
    let place = |wanted: HalfEdgeId| walk.iter().position(|&h| h == wanted);
    let (i1, i2) = (place(h1)?, place(h2)?);
    set.either(Word::He1After, Word::He2After, i1 > i2);
    // The new face gets he2 and what follows up to he1; the stored half-edge is the first of the walk.
    let new = (i1 + walk.len() - i2) % walk.len();
    set.either(Word::StoredNew, Word::StoredOld, i2 == 0 || (i1 < i2 && i1 != 0));
    let (gets, keeps) = (new + 1, walk.len() - new + 1);
    set.either(Word::New3More, Word::New3, gets > 3);
    set.either(Word::Old3More, Word::Old3, keeps > 3);
    set.add(Word::NewShorter, gets < keeps);
    set.add(Word::OldShorter, keeps < gets);
    // The new face also begins at the origin of he1 and comes to that of he2; the old one the other way about.
    let meets = |v, from: usize, count: usize| {
        (0..count).filter(|i| table.origin(walk[(from + i) % walk.len()]) == Some(v)).count()
    };
    set.add(Word::NewMeets1, meets(o1, i2, new) > 0);
    set.add(Word::NewMeets2, meets(o2, i2, new) > 1);
    set.add(Word::OldMeets1, meets(o1, i1, walk.len() - new) > 1);
    set.add(Word::OldMeets2, meets(o2, i1, walk.len() - new) > 0);
    set.more(VOCABULARY, "new_N_more", gets);
    Some(())
}
