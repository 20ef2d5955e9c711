//! The way from given segments to a subdivision, step by step.

use super::chains::Split;
use super::collinear::{Pieces, Stretch};
use super::crossed::Cuts;
use super::error::{SegmentFault, SegmentsError};
use super::faults::all_faults;
use super::graph::{Distinct, Graph, Single};
use super::settled::{proved_by_faces, where_nothing_meets};
use super::split::split as split_all;
use super::trace::{Seen, look, trace};
use super::{ArrangeOptions, Arranged};
use crate::geometry::both::of_both;
use crate::ids::{HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::plane::meet::{Grid, NoMeetings};
use std::ops::Range;

/// Segments whose points are distinct.
pub(super) struct Input {
    distinct: Distinct,
    /// The number of given segments.
    count: usize,
    /// The ends of the segments that have length.
    long: Vec<[u32; 2]>,
    /// The input numbers of the segments that have length; empty if all have.
    names: Vec<u32>,
    /// The segments without length, and where they are.
    zero: Vec<(u32, Point)>,
    /// So many segments at the beginning are known to meet at common ends only, and so are the others, each by themselves.
    first: Option<usize>,
    /// Whether points were given by themselves, and the faults among them.
    points_given: bool,
    faults: Vec<SegmentFault>,
}

impl Input {
    /// Segments by the coordinates of their ends.
    pub(super) fn segments(segments: &[[Point; 2]]) -> Self {
        let zero = without_length(segments.len(), |i| segments[i][0] == segments[i][1], |i| segments[i][0]);
        let (distinct, names) = if zero.is_empty() {
            (Distinct::without_order(segments.as_flattened()), Vec::new())
        } else {
            let long = || segments.iter().enumerate().filter(|(_, s)| s[0] != s[1]);
            let ends: Vec<Point> = long().flat_map(|(_, &ends)| ends).collect();
            (Distinct::without_order(&ends), long().map(|(i, _)| i as u32).collect())
        };
        let long = distinct.number.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect();
        Self {
            distinct,
            count: segments.len(),
            long,
            names,
            zero,
            first: None,
            points_given: false,
            faults: Vec::new(),
        }
    }

    /// Points, and segments by the numbers of their ends.
    pub(super) fn graph(points: &[Point], segments: &[[u32; 2]], options: &ArrangeOptions) -> Self {
        let distinct = Distinct::without_order(points);
        let mut faults = Vec::new();
        if !options.merge && !options.split && distinct.points.len() < points.len() {
            faults = super::graph::same_places(points, &distinct.number, options.most_faults.saturating_add(1));
        }
        Self { faults, ..Self::of(distinct, points, segments) }
    }

    /// The same for two graphs one behind the other: the first so many segments are known to meet at common ends only, and
    /// so are the others. What is equal is joined.
    pub(super) fn two_graphs(points: Vec<Point>, segments: Vec<[u32; 2]>, first: usize) -> Self {
        let mut input = match Distinct::of_all(points) {
            Ok(distinct) if segments.iter().all(|[a, b]| a != b) => Self {
                distinct,
                count: segments.len(),
                long: segments,
                names: Vec::new(),
                zero: Vec::new(),
                first: None,
                points_given: true,
                faults: Vec::new(),
            },
            Ok(Distinct { points, .. }) | Err(points) => Self::of(Distinct::without_order(&points), &points, &segments),
        };
        input.first = Some(first);
        input
    }

    fn of(distinct: Distinct, points: &[Point], segments: &[[u32; 2]]) -> Self {
        let number = &distinct.number;
        let ends = |i: usize| of_both(segments[i], |p| number[p as usize]);
        let has_length = |i: &usize| {
            let [a, b] = ends(*i);
            a != b
        };
        let zero = without_length(segments.len(), |i| !has_length(&i), |i| points[segments[i][0] as usize]);
        let long = (0..segments.len()).filter(has_length).map(ends).collect();
        let names = if zero.is_empty() {
            Vec::new()
        } else {
            (0..segments.len()).filter(has_length).map(|i| i as u32).collect()
        };
        let count = segments.len();
        Self { count, long, names, zero, first: None, points_given: true, faults: Vec::new(), distinct }
    }

    /// Whether it is known that no edge is there twice: two graphs have no point in common, or no two segments have.
    fn are_single(&self) -> bool {
        let may_share_points = self.points_given && self.first.is_none();
        !may_share_points && self.distinct.points.len() == self.distinct.number.len()
    }

    /// By edge a bit for the first segments and one for the others, if each of them are known to meet at common ends only.
    fn sets(&self, half: &[u32], edges: usize) -> Vec<u8> {
        let Some(first) = self.first else { return Vec::new() };
        let mut sets = vec![0; edges];
        for (long, &h) in half.iter().enumerate() {
            sets[(h >> 1) as usize] |= if (self.name(long) as usize) < first { 1 } else { 2 };
        }
        sets
    }

    /// The input number of a segment that has length.
    fn name(&self, long: usize) -> u32 {
        self.names.get(long).copied().unwrap_or(long as u32)
    }
}

fn without_length(count: usize, is_point: impl Fn(usize) -> bool, at: impl Fn(usize) -> Point) -> Vec<(u32, Point)> {
    (0..count).filter(|&i| is_point(i)).map(|i| (i as u32, at(i))).collect()
}

pub(super) fn arrange(mut input: Input, options: &ArrangeOptions) -> Result<Arranged, SegmentsError> {
    let mut repeated = Vec::new();
    let Single { edges, half } = if input.are_single() {
        Single::as_given(std::mem::take(&mut input.long))
    } else {
        Single::new(input.distinct.points.len(), &input.long, |second, first| {
            repeated.push((input.name(second as usize), input.name(first as usize)));
        })
    };
    if !(options.merge || options.split) {
        input.faults.extend(input.zero.iter().map(|&(segment, at)| SegmentFault::ZeroLength { segment, at }));
        input.faults.extend(repeated.iter().map(|&(second, first)| SegmentFault::Repeated { first, second }));
    }
    let points = std::mem::take(&mut input.distinct.points);
    let mut graph = Graph { points, edges, order: std::mem::take(&mut input.distinct.order) };
    let mut given = graph.points.len();
    let mut pieces = None;
    let grid = if options.split { options.grid.map(|size| checked(size, &graph.points)).transpose()? } else { None };
    let mut cuts = None;
    if options.split && grid.is_none() {
        cuts = match Cuts::without_sweep(&graph, &input.sets(&half, graph.edges.len())) {
            Err(NoMeetings::Overlap) => {
                pieces = Some(Pieces::cut(&mut graph));
                Cuts::without_sweep(&graph, &[]).ok()
            }
            found => found.ok(),
        };
    }
    let whole = graph.edges.len();
    let (split, seen) = match cuts {
        Some(cuts) if cuts.is_empty() => (Split::none(whole), where_nothing_meets(&graph)?),
        Some(cuts) => split_all(&mut graph, None, Some(cuts))?,
        None if grid.is_some() => {
            pieces = pieces.or_else(|| Some(Pieces::cut(&mut graph)));
            split_all(&mut graph, grid, None)?
        }
        None => match proved_by_faces(&mut graph)? {
            Some(made) => (Split::none(whole), Seen::Made(Box::new(made))),
            None => {
                let seen = look(&graph)?;
                if options.split && seen.intersection().is_some() {
                    pieces = pieces.or_else(|| Some(Pieces::cut(&mut graph)));
                    split_all(&mut graph, None, None)?
                } else {
                    (Split::none(whole), seen)
                }
            }
        },
    };
    let pieces = pieces.unwrap_or_else(|| Pieces::whole(whole));
    refuse(&input, &half, &graph, &seen, options.most_faults.clamp(1, usize::MAX - 1))?;

    let chains = Chains::new(&input, &half, &pieces, &split);
    let mut vertices = if input.points_given { input.distinct.number } else { Vec::new() };
    let (mut displaced, mut displaced_points) = (Vec::new(), 0);
    let mut grid = None;
    if let Some(snapped) = split.snapped {
        vertices.iter_mut().for_each(|v| *v = snapped.number[*v as usize]);
        given = snapped.given;
        displaced_points = snapped.displaced.len();
        displaced = worst(snapped.displaced);
        grid = Some(snapped.grid.size());
    }
    let subdivision = trace(&mut graph, seen)?;
    let collapsed = (0..chains.spans.len()).filter(|&i| chains.spans[i].is_empty()).map(|i| i as u32);
    let zero_length: Vec<u32> = input.zero.into_iter().map(|(segment, _)| segment).collect();
    Ok(Arranged {
        vertices: vertices.into_iter().map(VertexId::new).collect(),
        collapsed: collapsed.filter(|i| zero_length.binary_search(i).is_err()).collect(),
        zero_length,
        repeated,
        crossings: (given as u32..subdivision.vertex_bound() as u32).map(VertexId::new).collect(),
        moved: worst(split.made),
        displaced,
        displaced_points,
        grid,
        farthest: split.farthest,
        rounds: split.rounds,
        chains,
        subdivision,
    })
}

/// The grid that was asked for, if it fits the points.
fn checked(size: f64, points: &[Point]) -> Result<Grid, SegmentsError> {
    let reach = points.iter().map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
    let finest = Grid::finest(reach).size();
    match Grid::of(size) {
        Some(grid) if grid.size() >= finest => Ok(grid),
        _ => Err(SegmentsError::Grid { size, finest }),
    }
}

/// Fails if anything was found that the options do not allow, with not more than `limit` faults.
fn refuse(input: &Input, half: &[u32], graph: &Graph, seen: &Seen, limit: usize) -> Result<(), SegmentsError> {
    let mut faults = input.faults.clone();
    let mut more = faults.len() > limit;
    faults.truncate(limit);
    if seen.intersection().is_some() && !more {
        // The first segment with the ends of an edge gives it its name.
        let mut names = vec![0; graph.edges.len()];
        for (i, &h) in half.iter().enumerate().rev() {
            names[(h >> 1) as usize] = input.name(i);
        }
        let point_name = |p: u32| input.distinct.number.iter().position(|&q| q == p).map_or(p, |i| i as u32);
        let found;
        (found, more) = all_faults(graph, limit - faults.len(), (&|e| names[e as usize], &point_name));
        faults.extend(found);
    }
    if faults.is_empty() { Ok(()) } else { Err(SegmentsError::Faults { faults, more }) }
}

/// For every given segment the half-edges it has become. Segments that overlap share them: each has a stretch of the
/// chain of its line.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Chains {
    /// The half-edges, line by line; behind them, if a segment runs against its line, all of them once more, backwards.
    halves: Vec<HalfEdgeId>,
    /// By segment: where its half-edges are.
    spans: Vec<Range<u32>>,
}

impl Chains {
    pub(super) fn of(&self, segment: usize) -> &[HalfEdgeId] {
        let Range { start, end } = self.spans[segment];
        &self.halves[start as usize..end as usize]
    }

    pub(super) fn count(&self) -> usize {
        self.spans.len()
    }

    fn new(input: &Input, half: &[u32], pieces: &Pieces, split: &Split) -> Self {
        let mut halves: Vec<HalfEdgeId> = Vec::with_capacity(split.chain.len());
        let mut starts = Vec::with_capacity(pieces.runs.len() + 1);
        for &piece in &pieces.runs {
            starts.push(halves.len() as u32);
            let e = (piece >> 1) as usize;
            let chain = &split.chain[split.starts[e] as usize..split.starts[e + 1] as usize];
            let chain = chain.iter().map(|&h| HalfEdgeId::new(h));
            if piece & 1 == 0 { halves.extend(chain) } else { halves.extend(chain.rev().map(HalfEdgeId::twin)) }
        }
        starts.push(halves.len() as u32);
        let forwards = halves.len() as u32;
        let mut zero = input.zero.iter().map(|&(segment, _)| segment).peekable();
        let mut long = half.iter();
        let mut spans = Vec::with_capacity(input.count);
        let mut backwards = false;
        for segment in 0..input.count as u32 {
            let long = if zero.next_if_eq(&segment).is_some() { None } else { long.next() };
            spans.push(long.map_or(0..0, |&h| {
                let Stretch { range, backwards: against } = &pieces.stretches[(h >> 1) as usize];
                let [start, end] = of_both([range.start, range.end], |place| starts[place as usize]);
                if *against == (h & 1 == 1) {
                    return start..end;
                }
                backwards = true;
                2 * forwards - end..2 * forwards - start
            }));
        }
        if backwards {
            halves.extend_from_within(..);
            halves[forwards as usize..].reverse();
            halves[forwards as usize..].iter_mut().for_each(|h| *h = h.twin());
        }
        Self { halves, spans }
    }
}

/// The vertices that do not lie where they should, each with the greatest of its distances.
fn worst(mut moved: Vec<(u32, f64)>) -> Vec<(VertexId, f64)> {
    moved.retain(|moved| moved.1 > 0.0);
    moved.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
    moved.dedup_by_key(|moved| moved.0);
    moved.into_iter().map(|(v, by)| (VertexId::new(v), by)).collect()
}
