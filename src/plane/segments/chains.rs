//! What became of the edges of a graph that was split: a chain of edges for each, and the points that were made or moved.

use crate::plane::meet::Grid;
/// What became of the edges of a graph.
pub(super) struct Split {
    /// Where the chain of each edge starts in `chain`, and the end.
    pub(super) starts: Vec<u32>,
    /// Half-edges of the new edges, one chain after another: twice the edge, plus 1 against its direction.
    pub(super) chain: Vec<u32>,
    /// The points made for crossings, and a distance from the segments that cross there that is not exceeded.
    pub(super) made: Vec<(u32, f64)>,
    pub(super) rounds: u32,
    /// What the grid did, if one was used.
    pub(super) snapped: Option<Snapped>,
    /// No point of an edge is further from its chain, nor the other way round.
    pub(super) farthest: f64,
}

/// What became of the points of a graph that was rounded to a grid.
pub(super) struct Snapped {
    pub(super) grid: Grid,
    /// The new number of each point; those of the points that were there before come first.
    pub(super) number: Vec<u32>,
    /// How many points those before have become.
    pub(super) given: usize,
    /// The points that moved, by their new numbers, and how far.
    pub(super) displaced: Vec<(u32, f64)>,
}

impl Split {
    /// Every edge is its own chain.
    pub(super) fn none(edges: usize) -> Self {
        Self {
            starts: (0..=edges as u32).collect(),
            chain: (0..edges as u32).map(|e| 2 * e).collect(),
            made: Vec::new(),
            rounds: 0,
            snapped: None,
            farthest: 0.0,
        }
    }
}
