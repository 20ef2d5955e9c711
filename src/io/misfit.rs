//! Polygons that do not fit together, described by what stands in the file: names, rings, coordinates.
//!
//! ```text
//!   map.json:2:93: G3: features[0] "A" polygon 0 ring 0 and features[1] "B" polygon 0 ring 0 cross at (2, 2): ...
//!   └ ring, if known ┘  └── elements by their paths, or as face 3 ──┘                       └ in the file's coordinates
//! ```

use super::outline::{Directions, Outline};
use super::soup::Places;
use super::touches::closed_chain;
use crate::geometry::number::Number;
use crate::ids::VertexId;
use crate::plane::predicates::{left_to_right, orientation};
use crate::plane::{
    ArrangeOptions, ConvertError, GeometryViolation, InsertedCorner, Point, SegmentFault, SegmentsError, Subdivision,
};
use crate::topology::{BuildError, PolygonList};

/// The polygons of a file, and where they stand in it.
pub(super) struct Told<'a> {
    pub(super) points: &'a [Point],
    pub(super) faces: &'a PolygonList,
    pub(super) places: &'a Places,
}

/// A misfit in words.
pub(super) struct Misfit {
    pub(super) what: String,
    /// The rings it speaks of, by face and cycle; empty if the error says by itself what it speaks of.
    pub(super) rings: Vec<[u32; 2]>,
}

/// The ends of a side, by number.
type Side = [u32; 2];

impl Told<'_> {
    /// What is wrong. Unless all was `checked`, sides may cross that nobody looked at.
    pub(super) fn misfit(&self, error: &ConvertError, checked: bool) -> Misfit {
        match *error {
            ConvertError::Build(ref error) => self.build(error),
            ConvertError::Coordinate { .. } | ConvertError::Clockwise { .. } => self.plain(error),
            ConvertError::ZeroArea { face } => self.without_area(face),
            ConvertError::SelfCrossing { face, first, second } => {
                let (first, second) = ([first.0, first.1], [second.0, second.1]);
                let ring = self.ring_with(face, first);
                let told = format!("{} crosses itself{}", self.name(ring), self.sides_cross(first, second));
                Misfit { what: told, rings: vec![ring] }
            }
            ConvertError::SelfTouching { face, vertex, side } => {
                let (side, ring) = ([side.0, side.1], self.ring_with(face, [side.0, side.1]));
                let (name, at) = (self.name(ring), self.at(vertex));
                let on = if side.contains(&vertex) { String::new() } else { format!(": inside {}", self.side(side)) };
                Misfit { what: format!("{name} touches itself at {at}{on}"), rings: vec![ring] }
            }
            ConvertError::OverlapAtEdge { u, v, first, second } => self.overlap_at_edge([u, v], [first, second]),
            ConvertError::OverlapAtVertex { vertex, first, second } => self.overlap_at_vertex(vertex, [first, second]),
            ConvertError::Geometry(violation) => self.geometry(&violation),
            ConvertError::HoleOutside { face, vertex } => {
                let ring = self.ring_at(face, vertex);
                let (name, at) = (self.name(ring), self.at(vertex));
                let what = format!(
                    "{name} is to be a hole, but does not lie inside ring 0 and outside of the other rings: its leftmost corner is {at}"
                );
                Misfit { what, rings: vec![ring] }
            }
            ConvertError::InPieces { face } => {
                let what = format!("the inside of {} is cut into pieces by its holes", self.polygon(face));
                self.in_pieces(face, what)
            }
            ConvertError::CommonEdge { face, u, v } => self.common_edge(face, [u, v]),
            ConvertError::InsideFace { face, vertex } => self.inside(face, vertex, checked),
        }
    }

    /// Two rings run along an edge in the same direction, what is to be covered on their left.
    fn overlap_at_edge(&self, side: Side, [first, second]: [u32; 2]) -> Misfit {
        if first == second {
            return self.common_edge(first, side);
        }
        let [p, q] = side.map(|v| self.point(v));
        let ring = |face| {
            let on_left = |&ring: &[u32; 2]| self.outline(ring).is_left_of([p, q]) == Some(ring[1] == 0);
            self.rings_of(face).find(on_left).unwrap_or_else(|| self.ring_with(face, side))
        };
        let (one, other) = (ring(first), ring(second));
        let edge = format!("the edge {} -> {}", self.at(side[0]), self.at(side[1]));
        // What a hole goes round is no part of its polygon; nobody knows yet whether the hole lies inside.
        let what = match [one, other].iter().find(|ring| ring[1] > 0) {
            None => format!("{}: both lie on the same side of {edge}", self.two(one, other, "overlap")),
            Some(&hole) => {
                let (two, side, hole) = (self.two(one, other, "have in common"), self.side(side), self.name(hole));
                format!("{two} {side}: as {hole} is a hole, both polygons would lie on the same side of it")
            }
        };
        Misfit { what, rings: vec![one, other] }
    }

    /// Two rings of one polygon run along an edge.
    fn common_edge(&self, face: u32, side: Side) -> Misfit {
        let [p, q] = side.map(|v| self.point(v));
        let left = |ring| Some((ring, self.outline(ring).is_left_of([p, q])?));
        let all: Vec<([u32; 2], bool)> = self.rings_of(face).filter_map(left).collect();
        let edge = || format!("the edge {} -> {}", self.at(side[0]), self.at(side[1]));
        let &[(one, left), (other, other_left), ..] = all.as_slice() else {
            let ring = all.first().map_or([face, 0], |first| first.0);
            return Misfit { what: format!("{} runs twice along {}", self.name(ring), edge()), rings: vec![ring] };
        };
        let rings = vec![one, other];
        match (one[1], left == other_left) {
            (0, false) => {
                let (two, side, number) = (self.two(one, other, "have"), self.side(side), self.ring_number(other));
                let what = format!("{two} in common {side}, and ring {number} lies outside of ring 0 there");
                Misfit { what, rings }
            }
            (1.., true) => {
                let two = self.two(one, other, "overlap");
                Misfit { what: format!("{two}: both lie on the same side of {}", edge()), rings }
            }
            _ => self.in_common(one, other, side),
        }
    }

    /// What is covered round a vertex overlaps, or holes do, or they stick out.
    fn overlap_at_vertex(&self, vertex: u32, faces: [u32; 2]) -> Misfit {
        let v = self.point(vertex);
        let wedge = |ring| Some((ring, self.outline(ring).wedge(v)?));
        let wedges: Vec<([u32; 2], [Point; 2])> = self.rings().filter_map(wedge).collect();
        let directions = Directions::new(v, wedges.iter().flat_map(|(_, ends)| *ends).collect());
        let around: Vec<([u32; 2], Vec<bool>)> =
            wedges.iter().map(|&(ring, ends)| (ring, directions.covered(ends))).collect();
        let meet = |a: &[bool], b: &[bool]| a.iter().zip(b).any(|(a, b)| *a && *b);
        // Two polygons, of which each covers what follows a direction.
        let mut polygons: Vec<([u32; 2], Vec<bool>)> = Vec::new();
        for rings in around.chunk_by(|a, b| a.0[0] == b.0[0]) {
            let face = rings[0].0[0];
            let holes = if rings[0].0[1] == 0 { &rings[1..] } else { rings };
            let whole = self.outline([face, 0]).place_of(v).is_gt();
            let hidden = self.rings_of(face).skip(1).any(|hole| self.outline(hole).place_of(v).is_gt());
            let mut covered = if rings[0].0[1] == 0 { rings[0].1.clone() } else { vec![whole; rings[0].1.len()] };
            for (i, covered) in covered.iter_mut().enumerate() {
                *covered &= !hidden && !holes.iter().any(|hole| hole.1[i]);
            }
            polygons.push((rings[0].0, covered));
        }
        // Two rings of one polygon.
        let within = |one: &([u32; 2], Vec<bool>), other: &([u32; 2], Vec<bool>)| {
            one.0[0] == other.0[0]
                && match one.0[1] {
                    0 => other.1.iter().zip(&one.1).any(|(hole, shell)| *hole && !shell),
                    _ => meet(&one.1, &other.1),
                }
        };
        let pairs = |n: usize| (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j)));
        let place = |one: [u32; 2], other: [u32; 2]| {
            let corner = [one, other].iter().all(|&ring| self.outline(ring).has_corner(v));
            format!("at their common {} {}", if corner { "corner" } else { "point" }, self.at(vertex))
        };
        if let Some((i, j)) = pairs(polygons.len()).find(|&(i, j)| meet(&polygons[i].1, &polygons[j].1)) {
            let (one, other) = (polygons[i].0, polygons[j].0);
            let what = format!("{} {}", self.two(one, other, "overlap"), place(one, other));
            return Misfit { what, rings: vec![one, other] };
        }
        if let Some((i, j)) = pairs(around.len()).find(|&(i, j)| within(&around[i], &around[j])) {
            let (one, other) = (around[i].0, around[j].0);
            let what = match one[1] {
                0 => {
                    let two = self.two(one, other, "do not fit together");
                    format!("{two} {}: ring {} sticks out there", place(one, other), self.ring_number(other))
                }
                _ => format!("{} {}", self.two(one, other, "overlap"), place(one, other)),
            };
            return Misfit { what, rings: vec![one, other] };
        }
        // Nothing overlaps there: sides of different length may run along each other.
        let along = |&(i, j): &(usize, usize)| {
            let ends = [wedges[i].1, wedges[j].1].concat();
            Directions::new(v, ends).count() < 4
        };
        let pair = pairs(wedges.len()).find(along);
        let (i, j) = pair.unwrap_or((0, wedges.len().saturating_sub(1)));
        let [one, other] = [i, j].map(|k| wedges.get(k).map_or([faces[0], 0], |wedge| wedge.0));
        let do_what = if pair.is_some() { "run along each other" } else { "do not fit together" };
        Misfit { what: format!("{} at {}", self.two(one, other, do_what), self.at(vertex)), rings: vec![one, other] }
    }

    /// A part of the input lies in a face, or begins there; `face` is one of those near.
    fn inside(&self, face: u32, vertex: u32, checked: bool) -> Misfit {
        let p = self.point(vertex);
        let at = self.at(vertex);
        let inner = self.rings().find(|&ring| ring[0] != face && self.cycle(ring).contains(&vertex));
        let inner = inner.or_else(|| self.rings().find(|&ring| self.cycle(ring).contains(&vertex)));
        let inner = inner.unwrap_or([face, 0]);
        let name = self.name(inner);
        let covers = |&outer: &u32| outer != inner[0] && self.covers(outer, p);
        let Some(outer) = std::iter::once(face).chain(0..self.faces.face_count() as u32).find(covers) else {
            let what = format!("{name} does not fit what lies round its corner {at}");
            return Misfit { what, rings: vec![inner] };
        };
        let around = self.polygon(outer);
        let what = match checked {
            true => format!("{name} lies inside {around}, which has no hole there: they overlap, for example at {at}"),
            false => format!("a corner of {name}, {at}, lies inside {around}: they overlap"),
        };
        Misfit { what, rings: vec![inner, [outer, 0]] }
    }

    /// Which rings of a polygon cut it into pieces, and where they touch.
    fn in_pieces(&self, face: u32, what: String) -> Misfit {
        const SHOWN: usize = 6;
        let corners = |ring| self.cycle(ring).iter().map(|&v| self.point(v)).collect();
        let Some(chain) = closed_chain(&self.rings_of(face).map(corners).collect::<Vec<_>>()) else {
            return Misfit { what, rings: vec![[face, 0]] };
        };
        let mut rings: Vec<[u32; 2]> = chain.rings.iter().map(|&ring| [face, ring]).collect();
        rings.sort_unstable();
        let numbers: Vec<String> = rings.iter().map(|&ring| format!("ring {}", self.ring_number(ring))).collect();
        let places: Vec<String> = chain.places.iter().map(|&p| self.in_file(p)).collect();
        let (numbers, places) = (listed(&numbers, SHOWN), listed(&places, SHOWN));
        let in_turn = if rings.len() > 2 { " one after another" } else { "" };
        rings.truncate(SHOWN);
        Misfit { what: format!("{what}: {numbers} touch{in_turn} at {places}"), rings }
    }

    /// Whether a polygon covers a point inside of it: that it does not only touch.
    fn covers(&self, face: u32, p: Point) -> bool {
        let mut holes = self.rings_of(face).skip(1);
        self.outline([face, 0]).place_of(p).is_gt() && holes.all(|hole| self.outline(hole).place_of(p).is_lt())
    }

    /// Whether the format has lines for its faces: then elements are numbered, else they have paths.
    fn by_path(&self) -> bool {
        self.places.face_path(0).is_some()
    }

    fn plain(&self, error: &ConvertError) -> Misfit {
        let what = match error {
            ConvertError::Coordinate { vertex, error } if self.by_path() => format!("{error} (vertex {vertex})"),
            _ => error.to_string(),
        };
        Misfit { what, rings: error.faces().into_iter().map(|f| [f, 0]).collect() }
    }

    fn build(&self, error: &BuildError) -> Misfit {
        let rings = |faces: Vec<u32>| faces.into_iter().map(|f| [f, 0]).collect::<Vec<_>>();
        if !self.by_path() {
            return Misfit { what: error.to_string(), rings: Vec::new() };
        }
        let (what, rings) = match *error {
            BuildError::RepeatedVertex { face, vertex } => {
                let ring = self.ring_at(face, vertex);
                (format!("{} touches itself: it passes {} twice", self.name(ring), self.at(vertex)), vec![ring])
            }
            BuildError::SameFaceTwice { first, second } => {
                let with_holes = [first, second].iter().any(|&face| self.rings_of(face).len() > 1);
                let name = |face| if with_holes { self.name([face, 0]) } else { self.polygon(face) };
                (format!("{} repeats {}", name(second), name(first)), rings(vec![second, first]))
            }
            BuildError::ThreeFaces { u, v, ref faces } => self.three(faces, [u, v]),
            ref other => (other.to_string(), rings(other.faces())),
        };
        Misfit { what, rings }
    }

    /// More than two rings run along a side.
    fn three(&self, faces: &[u32], side: Side) -> (String, Vec<[u32; 2]>) {
        let mut apart = faces.to_vec();
        apart.dedup();
        if apart.len() == faces.len() {
            let all: Vec<String> = faces.iter().map(|&f| self.polygon(f)).collect();
            let what = format!("{} have {} in common: they overlap", all.join(", "), self.side(side));
            return (what, faces.iter().map(|&f| self.ring_with(f, side)).collect());
        }
        let rings: Vec<[u32; 2]> =
            apart.iter().flat_map(|&f| self.rings_of(f).filter(|&ring| self.has_side(ring, side))).collect();
        let all: Vec<String> = rings.iter().map(|&ring| self.name(ring)).collect();
        let what =
            format!("{} have {} in common: no more than two rings can have a side", all.join(", "), self.side(side));
        (what, rings)
    }

    fn without_area(&self, face: u32) -> Misfit {
        let point = |v: u32| self.point(v);
        let flat = |corners: &[u32]| match *corners {
            [a, b, ..] => corners.iter().all(|&c| orientation(point(a), point(b), point(c)).is_eq()),
            _ => true,
        };
        let ring = self.rings_of(face).find(|&ring| flat(self.cycle(ring))).unwrap_or([face, 0]);
        let by_place = |&a: &u32, &b: &u32| left_to_right(point(a), point(b));
        let corners = || self.cycle(ring).iter().copied();
        let ends = [corners().min_by(by_place), corners().max_by(by_place)];
        let ends = ends.map(|v| v.map_or_else(String::new, |v| self.at(v)));
        let what =
            format!("{} has no area: its corners lie on one line, from {} to {}", self.name(ring), ends[0], ends[1]);
        Misfit { what, rings: vec![ring] }
    }

    fn geometry(&self, violation: &GeometryViolation) -> Misfit {
        let invariant = violation.rule().id;
        match *violation {
            GeometryViolation::EdgesMeet { first, second } => {
                let (first, second) = (first.map(VertexId::number), second.map(VertexId::number));
                let (one, other) = apart(&self.rings_with(first), &self.rings_with(second));
                // As the file has them: corners may have been inserted.
                let (first, second) = (self.whole_side(one, first), self.whole_side(other, second));
                let (alone, both, sides) = match self.overlap(first, second) {
                    Some(sides) => ("runs along itself", "run along each other", sides),
                    None => ("crosses itself", "cross", self.sides_cross(first, second)),
                };
                let two = || self.two(one, other, both);
                let what = if one == other { format!("{} {alone}", self.name(one)) } else { two() };
                Misfit { what: format!("{invariant}: {what}{sides}"), rings: vec![one, other] }
            }
            GeometryViolation::VertexOnEdge { vertex, ends } => {
                let (vertex, side) = (vertex.number(), ends.map(VertexId::number));
                let with: Vec<[u32; 2]> = self.rings().filter(|&ring| self.cycle(ring).contains(&vertex)).collect();
                let (one, other) = apart(&with, &self.rings_with(side));
                let side = self.whole_side(other, side);
                let at = self.at(vertex);
                let what = match one == other {
                    true => format!("{invariant}: {} touches itself at {at}", self.name(one)),
                    false => format!("{invariant}: {} at {at}", self.two(one, other, "touch")),
                };
                Misfit { what: format!("{what}, inside {}", self.side(side)), rings: vec![one, other] }
            }
            GeometryViolation::SamePlace { first, second } => {
                let vertices = [first.number(), second.number()];
                let rings = vertices.map(|v| self.rings().find(|&ring| self.cycle(ring).contains(&v)));
                let ([a, b], at) = (vertices, self.at(vertices[0]));
                let what = format!("{invariant}: vertices {a} and {b} lie at the same place, {at}: use one for both");
                Misfit { what, rings: rings.into_iter().flatten().collect() }
            }
            GeometryViolation::Folded { vertex } => self.folded(vertex.number()),
            ref other => Misfit { what: other.to_string(), rings: Vec::new() },
        }
    }

    /// At a vertex the sides follow each other in a wrong order. Holes of a polygon that have a side in common do that.
    fn folded(&self, vertex: u32) -> Misfit {
        let with = |&ring: &[u32; 2]| self.outline(ring).wedge(self.point(vertex)).is_some();
        let rings: Vec<[u32; 2]> = self.rings().filter(with).collect();
        for &one in &rings {
            let corners = self.cycle(one);
            for k in (0..corners.len()).filter(|&k| corners[k] == vertex) {
                for end in [corners[(k + 1) % corners.len()], corners[(k + corners.len() - 1) % corners.len()]] {
                    let mut others = rings.iter().filter(|&&other| other != one && other[0] == one[0]);
                    if others.any(|&other| self.has_side(other, [vertex, end])) {
                        return self.common_edge(one[0], [vertex, end]);
                    }
                }
            }
        }
        let names: Vec<String> = rings.iter().map(|&ring| self.name(ring)).collect();
        Misfit { what: format!("G4: {} overlap round {}", names.join(", "), self.at(vertex)), rings }
    }

    /// Two rings of a polygon have a side.
    fn in_common(&self, one: [u32; 2], other: [u32; 2], side: Side) -> Misfit {
        let (two, side) = (self.two(one, other, "have"), self.side(side));
        let what = format!("{two} in common {side}, so that none of the polygon lies between them");
        Misfit { what, rings: vec![one, other] }
    }

    /// ` at (2, 2): the side (0, 0) -> (4, 4) and ...`: where two sides cross.
    fn sides_cross(&self, first: Side, second: Side) -> String {
        let place = match self.fault(first, second) {
            Some(SegmentFault::Crossing { at, .. } | SegmentFault::Touching { at, .. }) => {
                format!(" at {}", self.in_file(at))
            }
            _ => String::new(),
        };
        format!("{place}: {} and {}", self.side(first), self.side(second))
    }

    /// ` from (0, 0) to (2, 2): the side ...`, if two sides run along each other.
    fn overlap(&self, first: Side, second: Side) -> Option<String> {
        let Some(SegmentFault::Overlapping { from, to, .. }) = self.fault(first, second) else { return None };
        let (from, to) = (self.in_file(from), self.in_file(to));
        Some(format!(" from {from} to {to}: {} and {}", self.side(first), self.side(second)))
    }

    /// How two sides meet, if they do so elsewhere than at common ends.
    fn fault(&self, first: Side, second: Side) -> Option<SegmentFault> {
        let ends = |side: Side| side.map(|v| self.point(v));
        let met = Subdivision::arrange_segments(&[ends(first), ends(second)], &ArrangeOptions::default());
        let Err(SegmentsError::Faults { faults, .. }) = met else { return None };
        faults.first().copied()
    }

    /// `A and B overlap`, or `rings 0 and 1 of A overlap`.
    fn two(&self, one: [u32; 2], other: [u32; 2], do_what: &str) -> String {
        if one[0] == other[0] {
            let numbers = [one, other].map(|ring| self.ring_number(ring));
            return format!("rings {} and {} of {} {do_what}", numbers[0], numbers[1], self.polygon(one[0]));
        }
        format!("{} and {} {do_what}", self.name(one), self.name(other))
    }

    /// `features[3] "Ohio" polygon 0`, or `face 3`.
    pub(super) fn polygon(&self, face: u32) -> String {
        self.places.face_path(face as usize).map_or_else(|| format!("face {face}"), str::to_owned)
    }

    /// `features[3] "Ohio" polygon 0 ring 1`, or `face 3`.
    pub(super) fn name(&self, ring: [u32; 2]) -> String {
        let polygon = self.polygon(ring[0]);
        if self.by_path() { format!("{polygon} ring {}", self.ring_number(ring)) } else { polygon }
    }

    /// The number of a ring in its polygon as the file has it: rings before it may have been left out.
    fn ring_number(&self, ring: [u32; 2]) -> u32 {
        self.places.ring_numbers.get(self.number(ring)).copied().unwrap_or(ring[1])
    }

    /// A corner that was inserted: where, and into what.
    pub(super) fn inserted(&self, corner: &InsertedCorner) -> String {
        format!("at {} into {}", self.at(corner.vertex), self.name([corner.face, corner.cycle]))
    }

    /// The number of a ring among all.
    pub(super) fn number(&self, [face, cycle]: [u32; 2]) -> usize {
        self.faces.cycle_range(face as usize).start + cycle as usize
    }

    fn side(&self, [a, b]: Side) -> String {
        format!("the side {} -> {}", self.at(a), self.at(b))
    }

    /// The place of a vertex as the file has it.
    fn at(&self, vertex: u32) -> String {
        self.in_file(self.point(vertex))
    }

    /// A point as the file has it.
    pub(super) fn in_file(&self, p: Point) -> String {
        let y = if self.places.y_down { 0.0 - p.y } else { p.y };
        format!("({}, {})", Number(p.x), Number(y))
    }

    fn point(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    fn cycle(&self, ring: [u32; 2]) -> &[u32] {
        self.faces.cycle(self.number(ring))
    }

    /// All rings, by face and cycle.
    fn rings(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        (0..self.faces.face_count() as u32).flat_map(|face| self.rings_of(face))
    }

    fn outline(&self, ring: [u32; 2]) -> Outline {
        Outline::new(self.cycle(ring).iter().map(|&v| self.point(v)))
    }

    /// Whether a ring has a side by its ends.
    fn has_ends(&self, ring: [u32; 2], [a, b]: Side) -> bool {
        let corners = self.cycle(ring);
        let after = |i: usize| corners[(i + 1) % corners.len()];
        (0..corners.len()).any(|i| [corners[i], after(i)] == [a, b] || [corners[i], after(i)] == [b, a])
    }

    /// Whether a side of a ring runs along the whole of this one.
    fn has_side(&self, ring: [u32; 2], side: Side) -> bool {
        self.has_ends(ring, side) || self.outline(ring).sides_along(side.map(|v| self.point(v))).next().is_some()
    }

    /// The rings with this side; if none has it by its ends, those of which a side runs along it.
    fn rings_with(&self, side: Side) -> Vec<[u32; 2]> {
        let by_ends: Vec<[u32; 2]> = self.rings().filter(|&ring| self.has_ends(ring, side)).collect();
        if by_ends.is_empty() { self.rings().filter(|&ring| self.has_side(ring, side)).collect() } else { by_ends }
    }

    /// The side of a ring, of which this may be a part.
    fn whole_side(&self, ring: [u32; 2], side: Side) -> Side {
        if self.has_ends(ring, side) {
            return side;
        }
        let [p, q] = side.map(|v| self.point(v));
        let corners = self.cycle(ring);
        let sides = (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]]);
        let mut whole = sides.filter(|ends| {
            let ends = ends.map(|v| self.point(v));
            Outline::new(ends.into_iter()).sides_along([p, q]).next().is_some()
        });
        whole.next().unwrap_or(side)
    }

    /// The ring of a face with this side.
    fn ring_with(&self, face: u32, side: Side) -> [u32; 2] {
        let by_ends = self.rings_of(face).find(|&ring| self.has_ends(ring, side));
        let any = || self.rings_of(face).find(|&ring| self.has_side(ring, side));
        by_ends.or_else(any).unwrap_or([face, 0])
    }

    /// The ring of a face with this corner, the last one if several have it.
    fn ring_at(&self, face: u32, vertex: u32) -> [u32; 2] {
        self.rings_of(face).filter(|&ring| self.cycle(ring).contains(&vertex)).last().unwrap_or([face, 0])
    }

    fn rings_of(&self, face: u32) -> impl ExactSizeIterator<Item = [u32; 2]> + '_ {
        (0..self.faces.cycle_range(face as usize).len() as u32).map(move |cycle| [face, cycle])
    }
}

/// `a, b and c`; of a long list the first ones, and how many more.
fn listed(words: &[String], most: usize) -> String {
    let shown = &words[..words.len().min(most)];
    let more = words.len() - shown.len();
    match shown {
        _ if more > 0 => format!("{} and {more} more", shown.join(", ")),
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => shown.concat(),
    }
}

/// One ring of each list, not the same if that can be.
fn apart(ones: &[[u32; 2]], others: &[[u32; 2]]) -> ([u32; 2], [u32; 2]) {
    let pairs = ones.iter().flat_map(|&one| others.iter().map(move |&other| (one, other)));
    let first = || (ones.first().copied().unwrap_or([0, 0]), others.first().copied().unwrap_or([0, 0]));
    pairs.clone().find(|(one, other)| one != other).unwrap_or_else(first)
}
