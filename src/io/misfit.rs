//! Polygons that do not fit together, described by what stands in the file: names, rings, coordinates.
//!
//! ```text
//!   map.json:2:93: G3: features[0] "A" polygon 0 ring 0 and features[1] "B" polygon 0 ring 0 cross at (2, 2): ...
//!   └ ring, if known ┘  └── elements by their paths, or as face 3 ──┘                       └ in the file's coordinates
//! ```

use super::soup::Places;
use crate::geometry::number::Number;
use crate::ids::VertexId;
use crate::plane::predicates::{left_to_right, orientation};
use crate::plane::{
    ArrangeOptions, ConvertError, GeometryViolation, InsertedCorner, Point, SegmentFault, SegmentsError, Subdivision,
};
use crate::topology::{BuildError, PolygonList};

/// The polygons of a file, and where they stand in it.
pub(super) struct Told<'a> {
    pub(super) points: &'a [[f64; 3]],
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
    /// What is wrong.
    pub(super) fn misfit(&self, error: &ConvertError) -> Misfit {
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
            ConvertError::OverlapAtEdge { u, v, first, second } => {
                let (one, other) = (self.ring_with(first, [u, v]), self.ring_with(second, [u, v]));
                let edge = format!("the edge {} -> {}", self.at(u), self.at(v));
                let what = match one == other {
                    true => format!("{} runs twice along {edge}", self.name(one)),
                    false => format!("{}: both lie on the same side of {edge}", self.two(one, other, "overlap")),
                };
                Misfit { what, rings: vec![one, other] }
            }
            ConvertError::OverlapAtVertex { vertex, first, second } => {
                let (one, other) = (self.ring_at(first, vertex), self.ring_at(second, vertex));
                let what = match one == other {
                    true => format!("{} overlaps itself at its corner {}", self.name(one), self.at(vertex)),
                    false => format!("{} at their common corner {}", self.two(one, other, "overlap"), self.at(vertex)),
                };
                Misfit { what, rings: vec![one, other] }
            }
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
                Misfit { what, rings: vec![[face, 0]] }
            }
            ConvertError::CommonEdge { face, u, v } => {
                let mut rings = self.rings_of(face).filter(|&ring| self.has_side(ring, [u, v]));
                let one = rings.next().unwrap_or([face, 0]);
                let other = rings.next().unwrap_or(one);
                self.in_common(one, other, [u, v])
            }
            ConvertError::InsideFace { face, vertex } => {
                let inner = self.rings().find(|&[f, c]| f != face && self.cycle([f, c]).contains(&vertex));
                let inner = inner.unwrap_or([face, 0]);
                let (name, outer, at) = (self.name(inner), self.polygon(face), self.at(vertex));
                let what =
                    format!("{name} lies inside {outer}, which has no hole there: they overlap, for example at {at}");
                Misfit { what, rings: vec![inner, [face, 0]] }
            }
        }
    }

    /// Whether the format has lines for its faces: then elements are numbered, else they have paths.
    fn by_path(&self) -> bool {
        self.places.face_path(0).is_some()
    }

    fn plain(&self, error: &ConvertError) -> Misfit {
        let what = error.to_string();
        let rings = error.faces().into_iter().map(|f| [f, 0]).collect();
        match error {
            ConvertError::Coordinate { vertex, error } if self.by_path() => {
                Misfit { what: format!("{error} (vertex {vertex})"), rings }
            }
            _ => Misfit { what, rings },
        }
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
                (format!("{} repeats {}", self.polygon(second), self.polygon(first)), rings(vec![second, first]))
            }
            BuildError::ThreeFaces { u, v, ref faces } => {
                let all: Vec<String> = faces.iter().map(|&f| self.polygon(f)).collect();
                let what = format!("{} have {} in common: they overlap", all.join(", "), self.side([u, v]));
                (what, faces.iter().map(|&f| self.ring_with(f, [u, v])).collect())
            }
            ref other => (other.to_string(), rings(other.faces())),
        };
        Misfit { what, rings }
    }

    fn without_area(&self, face: u32) -> Misfit {
        let point = |v: u32| self.point(v);
        let flat = |corners: &[u32]| match *corners {
            [a, b, ..] => corners.iter().all(|&c| orientation(point(a), point(b), point(c)).is_eq()),
            _ => true,
        };
        let cycles = self.faces.cycle_range(face as usize).len() as u32;
        let ring = (0..cycles).map(|c| [face, c]).find(|&ring| flat(self.cycle(ring))).unwrap_or([face, 0]);
        let by_place = |&a: &u32, &b: &u32| left_to_right(point(a), point(b));
        let (first, last) =
            (self.cycle(ring).iter().copied().min_by(by_place), self.cycle(ring).iter().copied().max_by(by_place));
        let ends = [first, last].map(|v| v.map_or_else(String::new, |v| self.at(v)));
        let what =
            format!("{} has no area: its corners lie on one line, from {} to {}", self.name(ring), ends[0], ends[1]);
        Misfit { what, rings: vec![ring] }
    }

    fn geometry(&self, violation: &GeometryViolation) -> Misfit {
        let invariant = violation.rule().id;
        match *violation {
            GeometryViolation::EdgesMeet { first, second } => {
                let (first, second) = (first.map(VertexId::number), second.map(VertexId::number));
                let (one, other) = (self.ring_of(first), self.ring_of(second));
                let (one, other) = (one.unwrap_or([0, 0]), other.unwrap_or([0, 0]));
                let along = self.overlap(first, second);
                let sides = along.as_ref().map_or_else(|| self.sides_cross(first, second), String::clone);
                let what = match (one == other, along.is_some()) {
                    (true, true) => format!("{invariant}: {} runs along itself{sides}", self.name(one)),
                    (true, false) => format!("{invariant}: {} crosses itself{sides}", self.name(one)),
                    (false, true) => format!("{invariant}: {}{sides}", self.two(one, other, "run along each other")),
                    (false, false) => format!("{invariant}: {}{sides}", self.two(one, other, "cross")),
                };
                Misfit { what, rings: vec![one, other] }
            }
            GeometryViolation::VertexOnEdge { vertex, ends } => {
                let (vertex, side) = (vertex.number(), ends.map(VertexId::number));
                let one = self.rings().find(|&ring| self.cycle(ring).contains(&vertex)).unwrap_or([0, 0]);
                let other = self.ring_of(side).unwrap_or([0, 0]);
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
                let [a, b] = vertices;
                let what = format!(
                    "{invariant}: vertices {a} and {b} lie at the same place, {}: use one for both",
                    self.at(a)
                );
                Misfit { what, rings: rings.into_iter().flatten().collect() }
            }
            GeometryViolation::Folded { vertex } => self.folded(vertex.number()),
            ref other => Misfit { what: other.to_string(), rings: Vec::new() },
        }
    }

    /// At a vertex the sides follow each other in a wrong order. Holes of a polygon that have a side in common do that.
    fn folded(&self, vertex: u32) -> Misfit {
        let rings: Vec<[u32; 2]> = self.rings().filter(|&ring| self.cycle(ring).contains(&vertex)).collect();
        for (i, &one) in rings.iter().enumerate() {
            let corners = self.cycle(one);
            for k in (0..corners.len()).filter(|&k| corners[k] == vertex) {
                for end in [corners[(k + 1) % corners.len()], corners[(k + corners.len() - 1) % corners.len()]] {
                    let fits = |&&other: &&[u32; 2]| other[0] == one[0] && self.has_side(other, [vertex, end]);
                    if let Some(&other) = rings[i + 1..].iter().find(fits) {
                        return self.in_common(one, other, [vertex, end]);
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
            return format!("rings {} and {} of {} {do_what}", one[1], other[1], self.polygon(one[0]));
        }
        format!("{} and {} {do_what}", self.name(one), self.name(other))
    }

    /// `features[3] "Ohio" polygon 0`, or `face 3`.
    pub(super) fn polygon(&self, face: u32) -> String {
        self.places.face_path(face as usize).map_or_else(|| format!("face {face}"), str::to_owned)
    }

    /// `features[3] "Ohio" polygon 0 ring 1`, or `face 3`.
    pub(super) fn name(&self, [face, cycle]: [u32; 2]) -> String {
        if self.by_path() { format!("{} ring {cycle}", self.polygon(face)) } else { self.polygon(face) }
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
        let [x, y, _] = self.points[vertex as usize];
        Point::new(x, y)
    }

    fn cycle(&self, ring: [u32; 2]) -> &[u32] {
        self.faces.cycle(self.number(ring))
    }

    /// All rings, by face and cycle.
    fn rings(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let cycles = |face: u32| (0..self.faces.cycle_range(face as usize).len() as u32).map(move |c| [face, c]);
        (0..self.faces.face_count() as u32).flat_map(cycles)
    }

    fn has_side(&self, ring: [u32; 2], [a, b]: Side) -> bool {
        let corners = self.cycle(ring);
        let after = |i: usize| corners[(i + 1) % corners.len()];
        (0..corners.len()).any(|i| [corners[i], after(i)] == [a, b] || [corners[i], after(i)] == [b, a])
    }

    /// The first ring with this side.
    fn ring_of(&self, side: Side) -> Option<[u32; 2]> {
        self.rings().find(|&ring| self.has_side(ring, side))
    }

    /// The ring of a face with this side.
    fn ring_with(&self, face: u32, side: Side) -> [u32; 2] {
        self.rings_of(face).find(|&ring| self.has_side(ring, side)).unwrap_or([face, 0])
    }

    /// The ring of a face with this corner, the last one if several have it.
    fn ring_at(&self, face: u32, vertex: u32) -> [u32; 2] {
        self.rings_of(face).filter(|&ring| self.cycle(ring).contains(&vertex)).last().unwrap_or([face, 0])
    }

    fn rings_of(&self, face: u32) -> impl Iterator<Item = [u32; 2]> + '_ {
        (0..self.faces.cycle_range(face as usize).len() as u32).map(move |cycle| [face, cycle])
    }
}
