//! Full cells: whatever crowds there, a query looks at O(log k) of its k edges.
//!
//! ```text
//!    │╲___     ______│    The way down is a search in a tree. Edges that reach from side to side are in order from
//!    │    ╲___╱      │    bottom to top; the others lie between two of them. A part that has such others is cut at
//!    │ ────┬──────── │    the middle one of their ends, where some come to reach from side to side:
//!    │ ___╱│╲_____   │
//!    │╱____│_________│        edge ── above it ──> ...          cut ── right of it ──> ...
//!       cut here               └───── below it ──> ...            └─── left of it ───> ...
//! ```
//!
//! The parts between edges hang as high in the tree as they are full, so that its depth is O(log k). An edge is split
//! by O(log k) cuts at most. The way left along the bottom is a binary search in the edges across it, and what has no
//! inside to the right of a point is found among the *posts*: vertical edges, and vertices without an edge that leads
//! to the right.
//!
//! Source: Preparata, *A new approach to planar point location*, 1981 (the trapezoid method).

use super::Location;
use super::lines::{Lines, TAG, face_right_of, on_edge};
use super::order::{Ends, crosses_level, is_above, is_above_level, is_left_of, is_right};
use crate::geometry::predicates::{left_to_right, orientation};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use std::cmp::Ordering;
use std::ops::Range;

/// A place in the tree where nothing more is to be asked.
const END: u32 = u32::MAX;

/// All crowded cells, in arrays common to all.
#[derive(Clone, Default, Debug)]
pub(super) struct Crowds {
    list: Vec<Crowd>,
    nodes: Vec<Node>,
    /// Edges across the bottoms from left to right.
    sills: Vec<u32>,
    /// Vertical edges, and with the `TAG` vertices, from left to right.
    posts: Vec<u32>,
    worst: usize,
}

/// One crowded cell: the root of its tree and its ranges of the arrays.
#[derive(Clone, Debug)]
struct Crowd {
    root: u32,
    sill: Range<u32>,
    posts: Range<u32>,
}

/// One question: is the point above the edge `key`, or, with the `TAG`, to the right of the origin of `key`?
#[derive(Clone, Copy, Debug)]
struct Node {
    key: u32,
    no: u32,
    yes: u32,
}

impl Crowds {
    /// Adds the cell with these edges and vertices; returns its number. O(k log^2 k).
    pub(super) fn add(&mut self, lines: &impl Lines, list: &[u32], corner: Point, right: f64) -> u32 {
        let edges = || list.iter().filter(|&word| word & TAG == 0).map(|&word| HalfEdgeId::new(word));
        let sill_start = self.sills.len() as u32;
        let on_sill = |h: &HalfEdgeId| {
            let ends = lines.ends(*h);
            crosses_level(ends, corner.y) && !is_left_of(ends, corner)
        };
        self.sills.extend(edges().filter(on_sill).map(HalfEdgeId::number));
        let sill = sill_start..self.sills.len() as u32;
        let ends = |word: u32| lines.ends(HalfEdgeId::new(word));
        self.sills[sill_start as usize..].sort_unstable_by(|&e, &g| order_by(is_right(ends(e), ends(g)), e == g));

        let posts = self.add_posts(lines, list);
        let mut inside: Vec<HalfEdgeId> = edges()
            .filter(|&h| {
                let [a, b] = lines.ends(h);
                a.x < b.x && a.x < right && b.x > corner.x
            })
            .collect();
        let mut plan = Plan { lines, nodes: &mut self.nodes };
        let (root, depth) = plan.part(&mut inside, [corner.x, right]);
        let search = |range: &Range<u32>| (usize::BITS - range.len().leading_zeros()) as usize;
        self.worst = self.worst.max(depth + search(&sill) + search(&posts));
        self.list.push(Crowd { root, sill, posts });
        self.list.len() as u32 - 1
    }

    fn add_posts(&mut self, lines: &impl Lines, list: &[u32]) -> Range<u32> {
        let start = self.posts.len();
        for &word in list {
            self.posts.push(word);
            if word & TAG == 0 {
                let h = HalfEdgeId::new(word);
                let [a, b] = lines.ends(h);
                let end = lines.origin(h.twin()).number() | TAG;
                if a.x < b.x {
                    *self.posts.last_mut().expect("the word just pushed") = end;
                } else {
                    self.posts.push(end);
                }
            }
        }
        // A vertical edge comes after a vertex at its lower end.
        self.posts[start..].sort_unstable_by(|&p, &q| {
            left_to_right(foot(lines, p), foot(lines, q)).then((p & TAG == 0).cmp(&(q & TAG == 0)))
        });
        let mut kept = start;
        for i in start..self.posts.len() {
            if i == start || self.posts[i] != self.posts[i - 1] {
                self.posts[kept] = self.posts[i];
                kept += 1;
            }
        }
        self.posts.truncate(kept);
        start as u32..kept as u32
    }

    /// Where the point lies, unless it lies in the face at the corner.
    pub(super) fn locate(&self, lines: &impl Lines, number: u32, level: f64, p: Point) -> Option<Location> {
        let crowd = &self.list[number as usize];
        if let Some(found) = self.on_post(lines, crowd, p) {
            return Some(found);
        }
        let mut below = None;
        let mut at = crowd.root;
        while let Some(node) = self.nodes.get(at as usize) {
            let h = HalfEdgeId::new(node.key & !TAG);
            let yes = if node.key & TAG != 0 {
                p.x >= lines.point(lines.origin(h)).x
            } else {
                let [a, b] = lines.ends(h);
                match orientation(a, b, p) {
                    Ordering::Equal => return Some(on_edge(lines, h, p)),
                    Ordering::Less => false,
                    Ordering::Greater => {
                        below = Some((h, [a, b]));
                        true
                    }
                }
            };
            at = if yes { node.yes } else { node.no };
        }
        let face = match below {
            Some((h, ends)) if is_above_level(ends, p, level) => Some(lines.face(h)),
            _ => self.left_along_bottom(lines, number, Point::new(p.x, level)),
        };
        face.map(Location::Face)
    }

    /// The vertex or vertical edge at the point, if it is a post.
    fn on_post(&self, lines: &impl Lines, crowd: &Crowd, p: Point) -> Option<Location> {
        let posts = &self.posts[crowd.posts.start as usize..crowd.posts.end as usize];
        let after = posts.partition_point(|&post| left_to_right(foot(lines, post), p).is_le());
        let post = *posts.get(after.checked_sub(1)?)?;
        if post & TAG != 0 {
            let v = VertexId::new(post & !TAG);
            return (lines.point(v) == p).then_some(Location::Vertex(v));
        }
        let h = HalfEdgeId::new(post);
        let [a, b] = lines.ends(h);
        (a.x >= p.x && p.y < b.y).then(|| on_edge(lines, h, p))
    }

    /// The face right of the first edge met on the way from the point, which lies on the bottom, left to the corner.
    pub(super) fn left_along_bottom(&self, lines: &impl Lines, number: u32, from: Point) -> Option<FaceId> {
        let Range { start, end } = self.list[number as usize].sill;
        let sill = &self.sills[start as usize..end as usize];
        let ends = |word: u32| lines.ends(HalfEdgeId::new(word));
        let met = sill.partition_point(|&word| is_left_of(ends(word), from));
        let h = HalfEdgeId::new(*sill.get(met.checked_sub(1)?)?);
        Some(face_right_of(lines, h, lines.ends(h)))
    }

    /// The most edges that one query looks at.
    pub(super) fn worst(&self) -> usize {
        self.worst
    }

    pub(super) fn memory_bytes(&self) -> usize {
        self.list.capacity() * size_of::<Crowd>()
            + self.nodes.capacity() * size_of::<Node>()
            + (self.sills.capacity() + self.posts.capacity()) * size_of::<u32>()
    }
}

/// Where a post stands: the place of a vertex, the lower end of a vertical edge.
fn foot(lines: &impl Lines, post: u32) -> Point {
    let v = if post & TAG != 0 { VertexId::new(post & !TAG) } else { lines.origin(HalfEdgeId::new(post)) };
    lines.point(v)
}

fn order_by(greater: bool, equal: bool) -> Ordering {
    match (equal, greater) {
        (true, _) => Ordering::Equal,
        (_, true) => Ordering::Greater,
        _ => Ordering::Less,
    }
}

/// The making of one tree.
struct Plan<'a, L> {
    lines: &'a L,
    nodes: &'a mut Vec<Node>,
}

/// The edges between two that reach from side to side: where they start in the list.
struct Gaps {
    /// One more than there are gaps.
    starts: Vec<usize>,
}

impl Gaps {
    /// How full the gaps `from..to` are together; empty ones count as well.
    fn weight(&self, from: usize, to: usize) -> usize {
        2 * (self.starts[to] - self.starts[from]) + (to - from)
    }
}

impl<L: Lines> Plan<'_, L> {
    fn ends(&self, h: HalfEdgeId) -> Ends {
        self.lines.ends(h)
    }

    /// The tree for the part between two verticals; every edge meets it. Returns the root and the depth.
    fn part(&mut self, edges: &mut [HalfEdgeId], [left, right]: [f64; 2]) -> (u32, usize) {
        let spans = |[a, b]: Ends| a.x <= left && b.x >= right;
        edges.sort_by_cached_key(|&h| !spans(self.ends(h)));
        let (across, others) = edges.split_at_mut(edges.partition_point(|&h| spans(self.ends(h))));
        across.sort_unstable_by(|&e, &g| order_by(is_above(self.ends(e), self.ends(g)), e == g));
        let gap = |h: HalfEdgeId| across.partition_point(|&e| is_above(self.ends(h), self.ends(e)));
        let mut placed: Vec<(usize, HalfEdgeId)> = others.iter().map(|&h| (gap(h), h)).collect();
        placed.sort_unstable();
        let mut starts = vec![0; across.len() + 2];
        for (i, &(gap, h)) in placed.iter().enumerate() {
            others[i] = h;
            starts[gap + 1] = i + 1;
        }
        for i in 1..starts.len() {
            starts[i] = starts[i].max(starts[i - 1]);
        }
        drop(placed);
        self.between(across, others, &Gaps { starts }, 0..across.len() + 1, [left, right])
    }

    /// The tree for some of the gaps.
    fn between(
        &mut self,
        across: &[HalfEdgeId],
        others: &[HalfEdgeId],
        gaps: &Gaps,
        range: Range<usize>,
        sides: [f64; 2],
    ) -> (u32, usize) {
        if range.len() == 1 {
            let edges = gaps.starts[range.start]..gaps.starts[range.end];
            return self.cut(&others[edges], sides);
        }
        // The edge that halves the weight is asked first.
        let half = gaps.weight(range.start, range.end) / 2;
        let (mut low, mut high) = (range.start + 1, range.end - 1);
        while low < high {
            let middle = low.midpoint(high);
            if gaps.weight(range.start, middle) < half { low = middle + 1 } else { high = middle }
        }
        let at = self.node(across[low - 1].number());
        let (no, depth) = self.between(across, others, gaps, range.start..low, sides);
        let (yes, other_depth) = self.between(across, others, gaps, low..range.end, sides);
        self.close(at, [no, yes], depth.max(other_depth))
    }

    /// The tree for edges none of which reaches from side to side.
    fn cut(&mut self, edges: &[HalfEdgeId], [left, right]: [f64; 2]) -> (u32, usize) {
        let halves = edges.iter().flat_map(|&h| [h, h.twin()]);
        let mut inner: Vec<HalfEdgeId> = halves
            .filter(|&h| {
                let x = self.ends(h)[0].x;
                left < x && x < right
            })
            .collect();
        if inner.is_empty() {
            return (END, 0);
        }
        let middle = inner.len() / 2;
        inner.select_nth_unstable_by(middle, |&g, &h| self.ends(g)[0].x.total_cmp(&self.ends(h)[0].x));
        let cut = inner[middle];
        drop(inner);
        let x = self.ends(cut)[0].x;
        let at = self.node(cut.number() | TAG);
        let mut side: Vec<HalfEdgeId> = edges.iter().copied().filter(|&h| self.ends(h)[0].x < x).collect();
        let (no, depth) = self.part(&mut side, [left, x]);
        side.clear();
        side.extend(edges.iter().filter(|&&h| self.ends(h)[1].x > x));
        let (yes, other_depth) = self.part(&mut side, [x, right]);
        self.close(at, [no, yes], depth.max(other_depth))
    }

    fn node(&mut self, key: u32) -> u32 {
        self.nodes.push(Node { key, no: END, yes: END });
        self.nodes.len() as u32 - 1
    }

    fn close(&mut self, at: u32, [no, yes]: [u32; 2], depth: usize) -> (u32, usize) {
        let node = &mut self.nodes[at as usize];
        (node.no, node.yes) = (no, yes);
        (at, depth + 1)
    }
}
