//! An edit that the kit does not have, in one file: a new vertex inside a face, joined to all its corners.
//!
//! ```text
//!   ●───────────●        ●───────────●
//!   │           │        │ ╲       ╱ │     V + 1, E + k, F + k - 1 for a face with k sides
//!   │     f     │  ==>   │    ╲ ╱    │
//!   │           │        │    ╱ ╲    │     It is written by recorded setters, so it can be undone, filmed, and
//!   │           │        │ ╱       ╲ │     said in a script; the kit checks the invariants before it is final.
//!   ●───────────●        ●───────────●
//! ```
//!
//! Run it: `cargo run --example own_edit`
//!
//! It prints:
//!
//! ```text
//! poke_face f1 returned v5
//!   1. Create the vertex, and an edge from it to every corner.
//!   2. Make a triangle of every side and its two spokes.
//! V 6 E 10 F 6
//! poke_face f1 returned v5
//! round v5: h10 (v0) h12 (v1) h14 (v2) h16 (v3) h18 (v4)
//! ```

use dcel_kit::edits::{Call, EditError, Given, Kind, Parameter, Returned, Row, Takes};
use dcel_kit::topology::{Dcel, IdError, Journal, Recorder, TooMany, measure, violations};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

/// Why a face cannot be poked.
#[derive(Debug)]
pub(crate) enum PokeError {
    /// There is no such face.
    Id(IdError),
    /// The structure is full.
    TooMany(TooMany),
}

impl std::fmt::Display for PokeError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Id(error) => error.fmt(f),
            Self::TooMany(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for PokeError {}

impl From<IdError> for PokeError {
    fn from(error: IdError) -> Self {
        Self::Id(error)
    }
}

impl From<TooMany> for PokeError {
    fn from(error: TooMany) -> Self {
        Self::TooMany(error)
    }
}

/// Joins a new vertex inside `f` to all corners of `f`, which keeps one of the triangles. Returns the vertex.
pub(crate) fn poke_face(dcel: &mut Dcel, f: FaceId, rec: &mut impl Recorder) -> Result<VertexId, EditError> {
    let poke = dcel.edit_with(rec, |e| {
        e.check(f)?;
        let sides: Vec<HalfEdgeId> = e.incident_half_edges(f).collect();
        e.step(1, "Create the vertex, and an edge from it to every corner.");
        let centre = e.add_vertex()?;
        let mut spokes = Vec::new();
        for &side in &sides {
            let [out, back] = e.add_edge()?;
            e.set_origin(out, centre);
            e.set_origin(back, e.origin(side));
            spokes.push(out);
        }
        e.step(2, "Make a triangle of every side and its two spokes.");
        for (i, &side) in sides.iter().enumerate() {
            let (to, from) = (spokes[i], spokes[(i + 1) % spokes.len()].twin());
            e.set_next(to, side);
            e.set_next(side, from);
            e.set_next(from, to);
            let face = if i == 0 { f } else { e.add_face()? };
            [to, side, from].into_iter().for_each(|h| e.set_face(h, face));
            e.set_half_edge(face, Some(side));
        }
        e.set_outgoing(centre, Some(spokes[0]));
        Ok::<_, PokeError>(centre)
    });
    poke.map_err(EditError::new)
}

/// The row of the table that makes it a word: `poke_face F`.
pub(crate) static POKE_FACE: Row = Row::new(
    "poke_face",
    &[Parameter { name: "f", takes: Takes::Element(Kind::Face) }],
    &[Given::New(Kind::Vertex)],
    "Join a new vertex inside a face to all its corners",
)
.on_kernel(|dcel, arguments, log| poke_face(dcel, arguments.face(), log).map(Returned::of));

/// Pokes the inside of a pentagon, by call and by script, and takes it back.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut pentagon = Dcel::polygon(5)?;
    let (before, mut journal) = (pentagon.clone(), Journal::new());

    let call = Call::new(&POKE_FACE, [pentagon.face(HalfEdgeId::new(0)).into()])?;
    let returned = call.apply(&mut pentagon, &mut journal)?;
    println!("{call} returned {returned}");
    for step in journal.steps() {
        println!("  {}. {}", step.number, step.what);
    }
    let counts = measure(&pentagon);
    println!("V {} E {} F {}", pentagon.vertex_count(), pentagon.edge_count(), pentagon.face_count());
    assert_eq!(counts.closed_euler(), 2);
    assert_eq!((pentagon.vertex_count(), pentagon.edge_count(), pentagon.face_count()), (6, 10, 6));
    assert!(violations(&pentagon).is_empty());

    let text = "ring 5\nlet c = poke_face f1\nwalk_vertex c\n";
    let script = dcel_kit::script::Script::parse_kernel_with(text, "own", &[&POKE_FACE])?;
    let run = script.run();
    for step in &run.steps {
        println!("{}", step.outcome);
    }
    assert_eq!(run.end.degree(VertexId::new(5)), 5);

    pentagon.undo(&mut journal, 0);
    assert_eq!(pentagon, before);
    Ok(())
}
