//! Random edit scripts: their arguments are resolved against the structure as it is, half of them so that the
//! call has a fair chance, and the resolved calls can be printed and typed in again.

use super::h;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Dcel, Recorder};
use proptest::prelude::*;

/// A call with raw numbers; see [`Op::resolve`].
#[derive(Clone, Copy, Debug)]
pub struct Op {
    pub kind: u8,
    pub first: u16,
    pub second: u16,
}

/// A call with half-edges.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Call {
    SplitFace(HalfEdgeId, HalfEdgeId),
    SplitEdge(HalfEdgeId),
    JoinFaces(HalfEdgeId),
    JoinEdges(HalfEdgeId),
}

/// Scripts on polygons with 1 to 7 corners.
pub fn scripts(length: usize) -> impl Strategy<Value = (u32, Vec<Op>)> {
    let op = (0..12_u8, any::<u16>(), any::<u16>()).prop_map(|(kind, first, second)| Op { kind, first, second });
    (1..8_u32, prop::collection::vec(op, 0..length))
}

/// What every property runs with: no files beside the sources; a failure prints the shrunk script.
pub fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

impl Op {
    /// The call this means on `dcel`: any id up to one past the bound (so removed and missing ones, too), or a
    /// second argument on the face of the first.
    pub fn resolve(self, dcel: &Dcel) -> Call {
        let bound = dcel.half_edge_bound() + 1;
        let first = h((self.first as usize % bound) as u32);
        match self.kind {
            0 => Call::SplitFace(first, h((self.second as usize % bound) as u32)),
            1..=4 if dcel.has_half_edge(first) => {
                let steps = self.second as usize % dcel.cycle(first).count();
                Call::SplitFace(first, dcel.cycle(first).nth(steps).unwrap())
            }
            1..=4 => Call::SplitFace(first, first),
            5..=7 => Call::SplitEdge(first),
            8..=9 => Call::JoinFaces(first),
            _ => Call::JoinEdges(first),
        }
    }
}

impl Call {
    /// Makes the call; the text of the error if it is refused.
    pub fn apply(self, dcel: &mut Dcel, rec: &mut impl Recorder) -> Result<(), String> {
        match self {
            Self::SplitFace(a, b) => dcel.split_face_with(a, b, rec).map(drop).map_err(|e| e.to_string()),
            Self::SplitEdge(a) => dcel.split_edge_with(a, rec).map(drop).map_err(|e| e.to_string()),
            Self::JoinFaces(a) => dcel.join_faces_with(a, rec).map(drop).map_err(|e| e.to_string()),
            Self::JoinEdges(a) => dcel.join_edges_with(a, rec).map(drop).map_err(|e| e.to_string()),
        }
    }
}

impl std::fmt::Display for Call {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::SplitFace(a, b) => write!(out, "split_face {a} {b}"),
            Self::SplitEdge(a) => write!(out, "split_edge {a}"),
            Self::JoinFaces(a) => write!(out, "join_faces {a}"),
            Self::JoinEdges(a) => write!(out, "join_edges {a}"),
        }
    }
}

/// The calls so far, one a line, to replay by hand.
#[derive(Default)]
pub struct Log(String);

impl Log {
    pub fn new(corners: u32) -> Self {
        Self(format!("replay:\npolygon {corners}\n"))
    }

    pub fn add(&mut self, call: Call) -> &str {
        self.0.push_str(&format!("{call}\n"));
        &self.0
    }

    pub fn text(&self) -> &str {
        &self.0
    }
}

/// Every call on all live half-edges, legal or not.
pub fn all_calls(dcel: &Dcel) -> Vec<Call> {
    let halves: Vec<HalfEdgeId> = dcel.half_edges().collect();
    let pairs = halves.iter().flat_map(|&a| halves.iter().map(move |&b| Call::SplitFace(a, b)));
    let single = halves.iter().flat_map(|&a| [Call::SplitEdge(a), Call::JoinFaces(a), Call::JoinEdges(a)]);
    pairs.chain(single).collect()
}
