//! Every refusal of the new edits, by name; nothing changes.

use crate::common::{f, h, v};
use dcel_kit::topology::{CollapseEdgeError, Dcel, IdError, JoinVerticesError, SplitVertexError};
use std::collections::BTreeSet;
use std::fmt::Debug;

/// Refuses and changes nothing, not even the ids of later edits.
pub(crate) fn refused<T: Debug, E: Debug>(dcel: &Dcel, call: impl Fn(&mut Dcel) -> Result<T, E>) -> E {
    let mut after = dcel.clone();
    let error = call(&mut after).expect_err("this call must be refused");
    assert_eq!(&after, dcel, "refused with {error:?}, yet something changed");
    error
}

/// All variants of the enum are among the errors, but the unreachable.
pub(crate) fn covers<E: Debug>(source: &str, name: &str, errors: &[E], unreachable: &[&str]) {
    let word = |text: &str| text.split(|c: char| !c.is_alphanumeric()).next().unwrap().to_owned();
    let body = source.split(&format!("pub enum {name} {{")).nth(1).unwrap().split("\n}").next().unwrap();
    let lines = body.lines().filter_map(|line| line.strip_prefix("    "));
    let there: BTreeSet<String> = lines.filter(|l| l.starts_with(|c: char| c.is_ascii_uppercase())).map(word).collect();
    let reached = errors.iter().map(|e| word(&format!("{e:?}")));
    assert_eq!(reached.chain(unreachable.iter().map(|&x| x.to_owned())).collect::<BTreeSet<_>>(), there);
}

/// A square whose edge e4 and vertex v4, a spur, were taken away again.
fn with_removed() -> Dcel {
    let mut square = Dcel::polygon(4).unwrap();
    let (a, m) = square.split_vertex(h(0), h(0)).unwrap();
    square.join_vertices(a).unwrap();
    assert_eq!((a, m), (h(8), v(4)));
    square
}

#[test]
fn split_vertex_refuses() {
    let d = with_removed();
    let (removed, missing) =
        (IdError::Removed(h(8).into()), IdError::OutOfRange { element: h(99).into(), count: 8, bound: 10 });
    let call = |a, b| refused(&d, move |d| d.split_vertex(h(a), h(b)));
    let errors = [
        call(8, 0),
        call(0, 8),
        call(99, 0),
        call(0, 2),
        refused(&d, |d| d.split_isolated_vertex(v(1))),
        refused(&d, |d| d.split_isolated_vertex(v(4))),
    ];
    assert_eq!(errors[..3], [removed, removed, missing].map(SplitVertexError::Id));
    let (first, last) = (h(0), h(2));
    assert_eq!(errors[3], SplitVertexError::DifferentOrigins { first, v1: v(0), last, v2: v(1) });
    assert_eq!(errors[4], SplitVertexError::NotIsolated { vertex: v(1), outgoing: h(2) });
    assert_eq!(errors[5], SplitVertexError::Id(IdError::Removed(v(4).into())));
    assert_eq!(errors[4].to_string(), "v1 is not isolated, h2 starts there: name the corner, split_vertex(h2, h2)");
    covers(include_str!("../../src/topology/edit/split_vertex.rs"), "SplitVertexError", &errors, &["TooMany"]);
}

#[test]
fn join_vertices_refuses() {
    let torus = Dcel::torus();
    let errors = [refused(&with_removed(), |d| d.join_vertices(h(9))), refused(&torus, |d| d.join_vertices(h(3)))];
    assert_eq!(errors[0], JoinVerticesError::Id(IdError::Removed(h(9).into())));
    assert_eq!(errors[1], JoinVerticesError::Loop { h: h(3), vertex: v(0) });
    assert_eq!(
        errors[1].to_string(),
        "h3 is a loop at v0: there are no two vertices to join; join_faces(h3) takes a loop away"
    );
    covers(include_str!("../../src/topology/edit/join_vertices.rs"), "JoinVerticesError", &errors, &[]);
}

#[test]
fn collapse_edge_refuses() {
    let solid = |n, faces: &[[u32; 3]]| Dcel::from_triangles(n, faces).unwrap().dcel;
    let tetrahedron = solid(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    let bipyramid = solid(5, &[[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]]);
    // A strip of triangles; v1 and v2 both lie on its border, the edge between them does not.
    let strip = solid(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]]);
    let mut spur = Dcel::polygon(4).unwrap();
    let (tip, _) = spur.split_vertex(h(0), h(0)).unwrap();
    let edge = |d: &Dcel, a, b| d.find_half_edge(v(a), v(b)).unwrap();
    let (waist, across) = (edge(&bipyramid, 0, 1), edge(&strip, 1, 2));
    let errors = [
        refused(&with_removed(), |d| d.collapse_edge(h(8))),
        refused(&Dcel::torus(), |d| d.collapse_edge(h(0))),
        refused(&spur, |d| d.collapse_edge(tip)),
        refused(&Dcel::polygon(2).unwrap(), |d| d.collapse_edge(h(0))),
        refused(&Dcel::polygon(3).unwrap(), |d| d.collapse_edge(h(0))),
        refused(&tetrahedron, |d| d.collapse_edge(h(0))),
        refused(&bipyramid, |d| d.collapse_edge(waist)),
        refused(&strip, |d| d.collapse_edge(across)),
    ];
    assert_eq!(
        errors,
        [
            CollapseEdgeError::Id(IdError::Removed(h(8).into())),
            CollapseEdgeError::Loop { h: h(0), vertex: v(0) },
            CollapseEdgeError::SameFace { h: tip, face: f(0) },
            CollapseEdgeError::ParallelEdge { h: h(0), other: h(3) },
            CollapseEdgeError::TooSmall { h: h(0), vertices: 3 },
            CollapseEdgeError::TooSmall { h: h(0), vertices: 4 },
            CollapseEdgeError::CommonNeighbour { h: waist, vertex: v(2) },
            CollapseEdgeError::CommonFace { h: across, face: f(4) },
        ]
    );
    assert_eq!(
        errors[7].to_string(),
        format!(
            "f4 touches both ends of {across} without lying beside it, and would be pinched; collapse another edge"
        )
    );
    covers(include_str!("../../src/topology/edit/collapse_edge.rs"), "CollapseEdgeError", &errors, &[]);
}
