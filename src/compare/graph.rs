//! Vertices and edges of two drawings: what is missing, what is too much, what has moved.
//!
//! ```text
//!   expected  a ──── b        found  a ── m ── b      one sentence: a-b is cut in two at m
//!   expected  a ── m ── b     found  a ──── b         one sentence: m is missing
//! ```
//!
//! The declared structure and the drawn geometry are both compared by this.

use super::ink::Hidden;
use super::pairing::{Places, distance, edge_by, lies_on, span, strays};
use super::report::{Difference, GROUP, Kind, Layer, Spot, Writing, listed};
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};

/// With more left over than this on a side, nothing is looked for that belongs together.
const TANGLED: usize = 1000;

/// Points, and edges between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Graph {
    pub(super) points: Vec<Point>,
    /// What each point is called; empty names are left out of sentences.
    pub(super) names: Vec<String>,
    /// By the numbers of their ends, the smaller one first; sorted, none twice.
    pub(super) edges: Vec<[u32; 2]>,
}

impl Graph {
    /// Sorts the edges and takes out doubles and loops. Returns how many were double.
    pub(super) fn tidy(&mut self) -> usize {
        self.edges.iter_mut().for_each(|e| e.sort_unstable());
        self.edges.retain(|e| e[0] != e[1]);
        self.edges.sort_unstable();
        let before = self.edges.len();
        self.edges.dedup();
        before - self.edges.len()
    }

    pub(super) fn point(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    pub(super) fn ends(&self, edge: [u32; 2]) -> [Point; 2] {
        edge.map(|v| self.point(v))
    }
}

/// Which point is which, and what is left over.
#[derive(Clone, Debug, Default)]
pub(super) struct Matched {
    pub(super) to_found: Vec<Option<u32>>,
    pub(super) to_expected: Vec<Option<u32>>,
    /// Expected points whose partner lies elsewhere.
    pub(super) moved: Vec<u32>,
    /// Edges by expected points.
    pub(super) missing: Vec<[u32; 2]>,
    /// Edges by found points.
    pub(super) extra: Vec<[u32; 2]>,
    /// Found points at the place of another, with that one.
    doubles: BTreeMap<u32, u32>,
}

/// How two graphs are compared and told about.
pub(super) struct Telling<'a> {
    pub(super) layer: Layer,
    pub(super) writing: Writing,
    pub(super) tolerance: f64,
    /// The sentence about a found point, at this place, that the reference does not have; `None` for the corner of an
    /// area, which is told with the area.
    pub(super) extra_point: &'a dyn Fn(u32, &str) -> Option<String>,
    /// Whether an expected point is told if it is missing; the corner of an area is told with the area.
    pub(super) is_told: &'a dyn Fn(u32) -> bool,
    /// Why a missing edge cannot be seen, if it is drawn.
    pub(super) hidden: &'a dyn Fn([u32; 2]) -> Option<Hidden>,
}

impl Matched {
    /// Pairs the points by place, then those that have moved; then the edges by their ends. O(n log n).
    pub(super) fn new(expected: &Graph, found: &Graph, tolerance: f64) -> Self {
        let places = Places::of(&expected.points, 4.0 * tolerance);
        let mut out = Self {
            to_found: vec![None; expected.points.len()],
            to_expected: vec![None; found.points.len()],
            ..Self::default()
        };
        for (i, &p) in found.points.iter().enumerate() {
            let Some(v) = places.near(p, tolerance) else { continue };
            match out.to_found[v as usize] {
                None => {
                    out.to_found[v as usize] = Some(i as u32);
                    out.to_expected[i] = Some(v);
                }
                Some(first) => drop(out.doubles.insert(i as u32, first)),
            }
        }
        out.pair_strays(expected, found);
        out.pair_edges(expected, found);
        out
    }

    fn pair_strays(&mut self, expected: &Graph, found: &Graph) {
        let left = |partners: &[Option<u32>]| -> Vec<u32> {
            (0..partners.len() as u32).filter(|&i| partners[i as usize].is_none()).collect()
        };
        let missing = left(&self.to_found);
        let mut extra = left(&self.to_expected);
        extra.retain(|i| !self.doubles.contains_key(i));
        if missing.len() == self.to_found.len() {
            return;
        }
        let of = |graph: &Graph, list: &[u32]| list.iter().map(|&i| graph.point(i)).collect::<Vec<_>>();
        for (i, j) in strays(&of(expected, &missing), &of(found, &extra), span(&expected.points)) {
            self.to_found[missing[i] as usize] = Some(extra[j]);
            self.to_expected[extra[j] as usize] = Some(missing[i]);
            self.moved.push(missing[i]);
        }
    }

    fn pair_edges(&mut self, expected: &Graph, found: &Graph) {
        let translated = |edge: &[u32; 2]| edge_by(*edge, &self.to_expected);
        let mut present: Vec<[u32; 2]> = found.edges.iter().filter_map(translated).collect();
        present.sort_unstable();
        let known = |edge: Option<[u32; 2]>| edge.is_some_and(|edge| expected.edges.binary_search(&edge).is_ok());
        self.extra = found.edges.iter().filter(|edge| !known(translated(edge))).copied().collect();
        self.missing = expected.edges.iter().filter(|edge| present.binary_search(edge).is_err()).copied().collect();
    }

    /// How many points and edges are missing, moved or too much.
    pub(super) fn faults(&self) -> usize {
        let alone = |partners: &[Option<u32>]| partners.iter().filter(|partner| partner.is_none()).count();
        let points = alone(&self.to_found) + alone(&self.to_expected) + self.moved.len();
        points + self.missing.len() + self.extra.len()
    }

    /// The number of expected edges that are there.
    pub(super) fn agreeing_edges(&self, expected: &Graph) -> usize {
        expected.edges.len() - self.missing.len()
    }

    /// One sentence for each thing that is missing, too much or elsewhere; what belongs together in one.
    pub(super) fn differences(&self, expected: &Graph, found: &Graph, telling: &Telling<'_>) -> Vec<Difference> {
        let mut tale = Tale { matched: self, expected, found, telling, out: Vec::new() };
        let (mut missing, mut extra) = (self.missing.clone(), self.extra.clone());
        let (mut joined, mut cuts) = (BTreeSet::new(), BTreeSet::new());
        if missing.len().max(extra.len()) <= TANGLED {
            joined = tale.joined(&mut missing, &mut extra);
            cuts = tale.cuts(&mut missing, &mut extra);
        }
        tale.vertices(&joined, &cuts);
        tale.edges(&missing, &extra);
        tale.out
    }
}

struct Tale<'a> {
    matched: &'a Matched,
    expected: &'a Graph,
    found: &'a Graph,
    telling: &'a Telling<'a>,
    out: Vec<Difference>,
}

impl Tale<'_> {
    fn say(&mut self, kind: Kind, text: String, spot: Spot) {
        self.out.push(Difference::new(kind, self.telling.layer, text, spot));
    }

    /// ` v5-v6`, if the ends have names.
    fn edge(&self, edge: [u32; 2]) -> String {
        let [a, b] = edge.map(|v| self.expected.names[v as usize].as_str());
        let name = if a.is_empty() || b.is_empty() { String::new() } else { format!(" {a}-{b}") };
        format!("{name} between {}", self.telling.writing.between(self.expected.ends(edge)))
    }

    fn vertex(&self, v: u32) -> String {
        let name = &self.expected.names[v as usize];
        let at = self.telling.writing.point(self.expected.point(v));
        if name.is_empty() { format!("vertex at {at}") } else { format!("vertex {name} at {at}") }
    }

    /// Missing vertices in the middle of an edge that runs through: takes their edges off the lists.
    fn joined(&mut self, missing: &mut Vec<[u32; 2]>, extra: &mut Vec<[u32; 2]>) -> BTreeSet<u32> {
        let mut out = BTreeSet::new();
        let lost: BTreeSet<u32> = missing.iter().flatten().copied().collect();
        for v in lost.into_iter().filter(|&v| self.matched.to_found[v as usize].is_none()) {
            let Some([a, b]) = two_neighbours(v, missing) else { continue };
            let Some(through) = edge_by([a, b], &self.matched.to_found) else { continue };
            let Some(i) = extra.iter().position(|&edge| edge == through) else { continue };
            if !lies_on(self.expected.point(v), self.expected.ends([a, b]), self.telling.tolerance) {
                continue;
            }
            extra.remove(i);
            missing.retain(|edge| !edge.contains(&v));
            let ends = self.telling.writing.between(self.expected.ends([a, b]));
            let text = format!("{} is missing: the edge between {ends} is not split there", self.vertex(v));
            self.say(Kind::Vertex, text, Spot::MissingVertex(self.expected.point(v)));
            out.insert(v);
        }
        out
    }

    /// Found vertices that cut an expected edge in two.
    fn cuts(&mut self, missing: &mut Vec<[u32; 2]>, extra: &mut Vec<[u32; 2]>) -> BTreeSet<u32> {
        let mut out = BTreeSet::new();
        let new: BTreeSet<u32> = extra.iter().flatten().copied().collect();
        for m in new.into_iter().filter(|&m| self.matched.to_expected[m as usize].is_none()) {
            let Some(ends) = two_neighbours(m, extra) else { continue };
            let Some(whole) = edge_by(ends, &self.matched.to_expected) else { continue };
            let Some(i) = missing.iter().position(|&edge| edge == whole) else { continue };
            let at = self.found.point(m);
            if !lies_on(at, self.expected.ends(whole), self.telling.tolerance) {
                continue;
            }
            missing.remove(i);
            extra.retain(|edge| !edge.contains(&m));
            let (edge, place) = (self.edge(whole), self.telling.writing.point(at));
            let text = format!("edge{edge} is cut in two at {place}, where the reference has no vertex");
            self.say(Kind::Edge, text, Spot::ExtraVertex(at));
            out.insert(m);
        }
        out
    }

    fn vertices(&mut self, joined: &BTreeSet<u32>, cuts: &BTreeSet<u32>) {
        let (matched, writing) = (self.matched, self.telling.writing);
        for v in 0..self.expected.points.len() as u32 {
            let at = self.expected.point(v);
            match matched.to_found[v as usize] {
                None if !joined.contains(&v) && (self.telling.is_told)(v) => {
                    let text = format!("{} is missing", self.vertex(v));
                    self.say(Kind::Vertex, text, Spot::MissingVertex(at));
                }
                Some(i) if matched.moved.contains(&v) => {
                    let place = self.found.point(i);
                    let away = writing.distance(distance(at, place));
                    let text = format!("{} is {away} away: yours lies at {}", self.vertex(v), writing.point(place));
                    self.say(Kind::Vertex, text, Spot::Moved(at, place));
                }
                _ => {}
            }
        }
        for m in (0..self.found.points.len() as u32).filter(|&m| matched.to_expected[m as usize].is_none()) {
            let at = self.found.point(m);
            let place = writing.point(at);
            if let Some(&first) = matched.doubles.get(&m) {
                let [mine, other] = [m, first].map(|i| self.found.names[i as usize].as_str());
                let text = format!("vertex {mine} of yours at {place} lies at the same place as {other}");
                self.say(Kind::Vertex, text, Spot::ExtraVertex(at));
            } else if !cuts.contains(&m) {
                let text = (self.telling.extra_point)(m, &place);
                text.into_iter().for_each(|text| self.say(Kind::Vertex, text, Spot::ExtraVertex(at)));
            }
        }
    }

    fn edges(&mut self, missing: &[[u32; 2]], extra: &[[u32; 2]]) {
        let writing = self.telling.writing;
        // Those that cannot be seen for the same reason together, in the order of the first.
        let mut groups: Vec<(Option<Hidden>, Vec<[u32; 2]>)> = Vec::new();
        for &edge in missing {
            let why = (self.telling.hidden)(edge);
            match groups.iter_mut().find(|group| why.is_some() && group.0 == why) {
                Some(group) => group.1.push(edge),
                None => groups.push((why, vec![edge])),
            }
        }
        for (why, group) in groups {
            if let Some(why) = why.filter(|_| group.len() >= GROUP) {
                let places: Vec<String> = group.iter().map(|&e| self.edge(e).trim_start().to_owned()).collect();
                let text = format!("{} edges cannot be seen, {}: {}", group.len(), why.reason(true), listed(&places));
                let spots = group.iter().map(|&edge| Spot::MissingEdge(self.expected.ends(edge))).collect();
                self.say(Kind::Edge, text, Spot::all(spots));
                continue;
            }
            for edge in group {
                let text = match why {
                    Some(why) => format!("edge{} cannot be seen: {}", self.edge(edge), why.reason(false)),
                    None => format!("edge{} is missing", self.edge(edge)),
                };
                self.say(Kind::Edge, text, Spot::MissingEdge(self.expected.ends(edge)));
            }
        }
        for &edge in extra {
            let ends = self.found.ends(edge);
            let text = format!("edge between {} is not in the reference", writing.between(ends));
            self.say(Kind::Edge, text, Spot::ExtraEdge(ends));
        }
    }
}

/// The two other ends of the edges at `v`, if there are just two.
fn two_neighbours(v: u32, edges: &[[u32; 2]]) -> Option<[u32; 2]> {
    let mut others = edges.iter().filter(|edge| edge.contains(&v)).map(|&[a, b]| if a == v { b } else { a });
    let both = [others.next()?, others.next()?];
    others.next().is_none().then_some(both)
}
