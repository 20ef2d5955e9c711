//! The table: a row for each edit.
//!
//! ```text
//!   word (name: what it takes, ...) -> [what it gives, ...] "what it does";
//!   { structure |the structure, its log| the call; }
//! ```

use super::arguments::Arguments;
use super::kind::{Given, Kind, Parameter, Takes};
use super::returned::{EditError, Returned};
use super::row::Row;
use crate::ids::FaceId;
use crate::plane::Affine;

/// What a parameter takes, by the word that reads it.
#[allow(non_upper_case_globals)] // the words themselves
mod takes {
    use super::{Kind, Takes};

    pub(super) const vertex: Takes = Takes::Element(Kind::Vertex);
    pub(super) const half_edge: Takes = Takes::Element(Kind::HalfEdge);
    pub(super) const edge: Takes = Takes::Element(Kind::Edge);
    pub(super) const face: Takes = Takes::Element(Kind::Face);
    pub(super) const place: Takes = Takes::Place;
    pub(super) const number: Takes = Takes::Number;
    pub(super) const switch: Takes = Takes::Switch;
    pub(super) const map: Takes = Takes::Map;
    pub(super) const vertices: Takes = Takes::Vertices;
}

/// What an edit gives back, by the word in a row.
#[allow(non_upper_case_globals)] // the words themselves
mod gives {
    use super::{Given, Kind};

    pub(super) const vertex: Given = Given::New(Kind::Vertex);
    pub(super) const half_edge: Given = Given::New(Kind::HalfEdge);
    pub(super) const face: Given = Given::New(Kind::Face);
    pub(super) const vertex_gone: Given = Given::Gone(Kind::Vertex);
    pub(super) const face_gone: Given = Given::Gone(Kind::Face);
}

macro_rules! parameters {
    (( $($name:ident: $takes:ident),* )) => {
        &[$(Parameter { name: stringify!($name), takes: takes::$takes }),*]
    };
}

/// A variable for each argument.
macro_rules! read {
    ($arguments:ident ( $($name:ident: $takes:ident),* )) => {
        $(let $name = $arguments.$takes();)*
    };
}

/// An edit as a column of a row has it: it reads the arguments, and is made.
macro_rules! edit {
    ($list:tt |$s:ident, $log:ident| $edit:expr) => {
        |$s, arguments: &mut Arguments<'_>, $log| {
            read!(arguments $list);
            $edit.map(Returned::of).map_err(EditError::new)
        }
    };
}

/// The row with one more column.
macro_rules! with {
    ($row:ident kernel $($edit:tt)*) => {
        $row.on_kernel(edit!($($edit)*))
    };
    ($row:ident plane $($edit:tt)*) => {
        $row.on_plane(edit!($($edit)*))
    };
    ($row:ident solid $($edit:tt)*) => {{
        #[cfg(feature = "solid")]
        let $row = $row.on_solid(edit!($($edit)*));
        $row
    }};
}

/// The rows as statics with their words as names, and the table of all. A row says its edit once for all columns in which
/// it is written alike.
macro_rules! rows {
    ($(
        $word:ident $list:tt -> [ $($gives:ident),* ] $help:literal;
        { $($($column:ident)+ |$s:ident, $log:ident| $edit:expr;)+ }
    )*) => {
        $(
            #[doc = $help]
            #[allow(non_upper_case_globals)] // the word itself
            pub static $word: Row = {
                let row = Row::new(
                    stringify!($word),
                    parameters!($list),
                    &[$(gives::$gives),*],
                    $help,
                );
                $($(
                    #[allow(unused_variables)] // of a row that takes nothing
                    let row = with!(row $column $list |$s, $log| $edit);
                )+)+
                row
            };
        )*

        /// All rows.
        pub static TABLE: &[&Row] = &[$(&$word),*];
    };
}

rows! {
    split_face(a: half_edge, b: half_edge) -> [half_edge, face]
        "Split a face by a new edge from the origin of A to the origin of B"; {
        kernel plane solid |s, log| s.split_face_with(a, b, log);
    }

    split_in_half(a: half_edge) -> [vertex, half_edge]
        "Split an edge by a new vertex in its middle"; {
        plane solid |s, log| s.split_in_half_with(a, log);
    }

    split_edge(a: half_edge, at: place) -> [vertex, half_edge]
        "Split an edge by a new vertex"; {
        kernel |d, log| { let _ = at; d.split_edge_with(a, log) };
        plane solid |s, log| s.split_edge_with(a, at.into(), log);
    }

    split_vertex(a: half_edge, b: half_edge) -> [half_edge, vertex]
        "Split a vertex: its half-edges from A on, up to B and without it, move to a new vertex"; {
        kernel |d, log| d.split_vertex_with(a, b, log);
    }

    split_isolated_vertex(v: vertex) -> [half_edge, face]
        "Split a vertex without edges: an edge and a face round it are new"; {
        kernel |d, log| d.split_isolated_vertex_with(v, log);
    }

    join_faces(a: half_edge) -> [face_gone]
        "Join the faces on both sides of an edge; the edge goes"; {
        kernel plane solid |s, log| s.join_faces_with(a, log);
    }

    join_edges(a: half_edge) -> [vertex_gone]
        "Join an edge with the one after it; the vertex between them goes"; {
        kernel plane solid |s, log| s.join_edges_with(a, log);
    }

    join_vertices(a: half_edge) -> [vertex_gone]
        "Join the two ends of an edge, whatever becomes of the faces beside it"; {
        kernel |d, log| d.join_vertices_with(a, log);
    }

    collapse_edge(a: half_edge) -> [vertex_gone]
        "Join the two ends of an edge if the surface stays one; two-sided faces go, too"; {
        kernel solid |s, log| s.collapse_edge_with(a, log);
    }

    flip_edge(a: half_edge) -> []
        "Turn an edge: both its ends move on to the next corner, counter-clockwise"; {
        kernel plane solid |s, log| s.flip_edge_with(a, log);
    }

    insert_vertex(at: place) -> [vertex]
        "Insert a vertex: into an edge, which it splits, or into a face"; {
        plane |s, log| s.insert_vertex_with(at.into(), log);
    }

    insert_vertex_in(f: face, at: place) -> [vertex]
        "Insert a vertex inside a face"; {
        plane |s, log| s.insert_vertex_in_with(f, at.into(), log);
    }

    insert_edge(u: vertex, v: vertex) -> [half_edge, face]
        "Join two vertices by a straight edge"; {
        plane |s, log| s.insert_edge_with(u, v, log);
    }

    insert_dangling_edge(v: vertex, at: place) -> [vertex, half_edge]
        "Insert a dangling edge from a vertex to a new one"; {
        plane |s, log| s.insert_dangling_edge_with(v, at.into(), log);
    }

    insert_segment(p: place, q: place) -> [half_edge, vertex]
        "Insert a segment through everything; what it crosses is split"; {
        plane |s, log| s.insert_segment_with(p.into(), q.into(), log);
    }

    remove_edge(e: edge) -> [face_gone]
        "Remove an edge; the faces beside it are joined"; {
        plane |s, log| s.remove_edge_with(e, log);
    }

    remove_vertex(v: vertex) -> [face_gone]
        "Remove a vertex with its edges, in space with its faces"; {
        plane solid |s, log| s.remove_vertex_with(v, log);
    }

    add_vertex(at: place) -> [vertex]
        "Add a vertex without edges"; {
        solid |p, log| p.add_vertex_with(at.into(), log);
    }

    add_face(v: vertices) -> [face]
        "Add a face with these corners, counter-clockwise as seen from outside"; {
        solid |p, log| p.add_face_with(&v, log);
    }

    remove_face(f: face) -> []
        "Remove a face and the edges that have no other"; {
        solid |p, log| p.remove_face_with(f, log);
    }

    bisect_edge(a: half_edge) -> [vertex, half_edge]
        "Split an edge in its middle, and the triangles beside it"; {
        solid |p, log| p.bisect_edge_with(a, log);
    }

    bevel_vertex(v: vertex, t: number) -> [half_edge, face]
        "Cut off a vertex: a face takes its place, its corners after a share T of each edge"; {
        solid |p, log| p.bevel_vertex_with(v, t, log);
    }

    bevel_edge(a: half_edge, t: number) -> [half_edge, face]
        "Cut off an edge: a face takes its place, its corners after a share T of each other edge"; {
        solid |p, log| p.bevel_edge_with(a, t, log);
    }

    bevel_face(f: face, t: number, d: number) -> [half_edge]
        "Inset a face by a share T of the way to its middle and pull it out by a distance D"; {
        solid |p, log| p.bevel_face_with(f, t, d, log);
    }

    inset_face(f: face, t: number) -> [half_edge]
        "Put a smaller face into a face, a share T of the way to its middle"; {
        solid |p, log| p.inset_face_with(f, t, log);
    }

    extrude_face(f: face, d: number) -> [half_edge]
        "Pull a face out by a distance D, with walls at its sides; 0 leaves it in place"; {
        solid |p, log| p.extrude_face_with(f, d, log);
    }

    set_hole(f: face, hole: switch) -> []
        "Say whether a bounded face is a hole of the domain"; {
        plane |s, log| s.set_hole_with(f, hole, log).ok_or(NoBoundedFace(f));
    }

    set_point(v: vertex, at: place) -> []
        "Move a vertex with its edges"; {
        plane solid |s, log| s.set_point_with(v, at.into(), log);
    }

    move_vertex(v: vertex, d: place) -> []
        "Move a vertex by a way, with its edges"; {
        plane |s, log| s.move_vertex_with(v, d.xy(), log);
        solid |p, log| p.move_vertex_with(v, d.into(), log);
    }

    transform_by(m: map) -> []
        "Transform everything by an affine map: x' = XX x + XY y + DX, y' = YX x + YY y + DY, in space with z"; {
        plane |s, log| s.transform_with(&m.in_plane(), log);
        solid |p, log| p.transform_with(&m.in_space(), log);
    }

    translate_by(at: place) -> []
        "Move everything"; {
        plane |s, log| s.transform_with(&Affine::translation(at.xy()), log);
        solid |p, log| p.transform_with(&Affine::translation(at.into()), log);
    }

    scale_by(s: number) -> []
        "Make everything larger by a factor, seen from the origin"; {
        plane solid |p, log| p.transform_with(&Affine::scaling(s), log);
    }

    reflect_x() -> []
        "Mirror everything: x becomes -x"; {
        plane solid |s, log| s.transform_with(&Affine::reflection(0), log);
    }

    quarter_turn() -> []
        "Turn everything by a right angle, counter-clockwise, in space about the z axis"; {
        plane solid |s, log| s.transform_with(&Affine::quarter_turn(), log);
    }
}

/// Only bounded faces that exist can be holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{0} is no bounded face: only those can be holes; choose another face than f0")]
struct NoBoundedFace(FaceId);
