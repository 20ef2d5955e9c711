//! Layer 3, faces: filled outlines against the faces of the reference.
//!
//! ```text
//!   ring of points, tidied, in its smallest rotation        equal: filled; equal the other way round: reversed
//! ```

use super::drawn::Critic;
use super::graph::Graph;
use super::ink::Hidden;
use super::pairing::{edge_by, ring_sides};
use super::report::{GROUP, Kind, Spot, counted, listed};
use super::rings;
use super::sketch::Outline;
use super::strangers::translated;
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};

/// With more differing edges than this, no edge excuses a face.
const EXCUSES: usize = 100;

impl Critic<'_> {
    pub(super) fn faces(&mut self) {
        let target = self.target;
        let expected = &target.sketch.outlines;
        if expected.is_empty() {
            if !self.found.outlines.is_empty() {
                let count = counted(self.found.outlines.len(), "filled polygon", "filled polygons");
                self.notes.push(format!("{count} not compared: the reference fills no faces"));
            }
            return;
        }
        if self.found.outlines.is_empty() {
            let text = "no face is filled: draw each bounded face as a filled polygon, counter-clockwise".to_owned();
            return self.say(Kind::Face, text, Spot::Nowhere);
        }
        let mut faces: BTreeMap<Vec<u32>, (usize, usize)> = BTreeMap::new();
        for (i, outline) in expected.iter().enumerate() {
            faces.entry(rings::canonical(&outline.ring)).or_insert((i, 0));
        }
        let count = self.expected().points.len() as u32;
        let excuses = Excuses::new(self);
        // The reference says no more of how its faces run than it does itself: those of other programs run either way.
        let is_free = |face: &Outline| rings::area(self.points(&face.ring, self.expected()).into_iter()) < 0.0;
        let mut reversed = Vec::new();
        let (mut strange, mut backwards) = (Vec::new(), Vec::new());
        let mut pale = Vec::new();
        for (number, outline) in self.found.outlines.iter().enumerate() {
            let ring = rings::canonical(&translated(outline, self.matched, count));
            let is_face = || faces.contains_key(&ring) || faces.contains_key(&rings::reversed(&ring));
            if self.hollow.contains(&number) && is_face() {
                continue;
            }
            if let Some((i, count)) = faces.get_mut(&ring) {
                *count += 1;
                if let Some(why) = self.pale.get(&number) {
                    pale.push((*why, &expected[*i]));
                }
            } else {
                reversed.push((rings::reversed(&ring), ring, outline));
            }
        }
        let welcome: BTreeSet<&Vec<u32>> = target.sketch.welcome.iter().collect();
        let mut outer = 0;
        for (ring, own, outline) in reversed {
            // The outer face and holes run the other way round, and may be drawn, too.
            let is_welcome = welcome.contains(&own) || welcome.contains(&ring);
            match faces.get_mut(&ring) {
                Some((i, count)) if *count == 0 => {
                    *count += 1;
                    backwards.extend((!is_free(&expected[*i])).then_some(&expected[*i]));
                }
                _ if is_welcome => outer += 1,
                Some(_) => {}
                None if excuses.found(outline) => {}
                None => strange.push(outline),
            }
        }
        let missing = faces.values().filter(|(_, count)| *count == 0).map(|(i, _)| &expected[*i]);
        let (excused, missing): (Vec<&Outline>, Vec<&Outline>) = missing.partition(|face| excuses.expected(face));
        if !excused.is_empty() {
            let (one, many) = ("face lies beside what differs and is", "faces lie beside what differs and are");
            self.notes.push(counted(excused.len(), one, many) + " not compared");
        }
        if outer > 0 || self.fills_hole {
            self.notes.push("the outer face, or a hole, is filled, too".to_owned());
        }
        self.tell(&missing, ["is not filled", "are not filled"]);
        let paper = ["cannot be told from the paper: fill it with another colour", "cannot be told from the paper"];
        let clip = ["cannot be seen: its clip-path cuts it off", "cannot be seen, their clip-path cuts them off"];
        let canvas =
            ["cannot be seen: it lies outside of the viewBox", "cannot be seen, they lie outside of the viewBox"];
        for (reason, said) in [(Hidden::Paper, paper), (Hidden::Clip, clip), (Hidden::Canvas, canvas)] {
            let group: Vec<&Outline> = pale.iter().filter(|(why, _)| *why == reason).map(|(_, face)| *face).collect();
            self.tell(&group, said);
        }
        for outline in strange {
            let points = self.points(&outline.ring, &self.found.graph);
            let text = format!("filled polygon along {} is no face of the reference", target.writing().along(&points));
            self.say(Kind::Face, text, Spot::ExtraFace(points));
        }
        for window in self.windows {
            let along = target.writing().along(&window.ring);
            let text = format!("a hole along {along} is left where the reference fills a face");
            self.say(Kind::Face, text, Spot::ExtraFace(window.ring.clone()));
        }
        let clockwise = [
            "runs clockwise: list its corners counter-clockwise",
            "run clockwise (list their corners counter-clockwise)",
        ];
        self.tell(&backwards, clockwise);
    }

    /// A sentence for each face, or one for many.
    fn tell(&mut self, outlines: &[&Outline], [one, many]: [&str; 2]) {
        let named = |outline: &&Outline| match outline.name.as_str() {
            "" => format!("along {}", self.target.writing().along(&self.points(&outline.ring, self.expected()))),
            name => name.to_owned(),
        };
        if outlines.len() >= GROUP {
            let names = listed(&outlines.iter().map(named).collect::<Vec<_>>());
            let spots =
                outlines.iter().map(|outline| Spot::Face(self.points(&outline.ring, self.expected()))).collect();
            return self.say(Kind::Face, format!("{} faces {many}: {names}", outlines.len()), Spot::all(spots));
        }
        for outline in outlines {
            let points = self.points(&outline.ring, self.expected());
            let what = if outline.name.is_empty() { "face".to_owned() } else { format!("face {}", outline.name) };
            let text = format!("{what} along {} {one}", self.target.writing().along(&points));
            self.say(Kind::Face, text, Spot::Face(points));
        }
    }

    fn points(&self, ring: &[u32], graph: &Graph) -> Vec<Point> {
        ring.iter().map(|&v| graph.point(v)).collect()
    }
}

/// Faces that differ because an edge or a vertex beside them does, which is told already.
struct Excuses {
    missing: Vec<[u32; 2]>,
    extra: Vec<[u32; 2]>,
    /// Extra edges by points of the reference.
    chords: Vec<[u32; 2]>,
    lost: Vec<bool>,
    strange: Vec<bool>,
    back: Vec<Option<u32>>,
}

impl Excuses {
    fn new(critic: &Critic<'_>) -> Self {
        let matched = critic.matched;
        let translated = |edge: &[u32; 2]| edge_by(*edge, &matched.to_expected);
        let mut out = Self {
            missing: matched.missing.clone(),
            extra: matched.extra.clone(),
            chords: matched.extra.iter().filter_map(translated).collect(),
            lost: (0..).zip(&matched.to_found).map(|(v, m)| m.is_none() && critic.target.sketch.is_told(v)).collect(),
            strange: (0..).zip(&matched.to_expected).map(|(m, v)| v.is_none() && critic.found.is_told(m)).collect(),
            back: matched.to_expected.clone(),
        };
        out.extra.sort_unstable();
        if out.missing.len().max(out.extra.len()) > EXCUSES {
            out.chords.clear();
        }
        out
    }

    fn expected(&self, outline: &Outline) -> bool {
        let ring = &outline.ring;
        let has_both = |[a, b]: &[u32; 2]| ring.contains(a) && ring.contains(b);
        ring.iter().any(|&v| self.lost[v as usize])
            || sides(ring).any(|side| self.missing.binary_search(&side).is_ok())
            || self.chords.iter().any(has_both)
    }

    fn found(&self, outline: &Outline) -> bool {
        let ring = &outline.ring;
        if ring.iter().any(|&m| self.strange[m as usize])
            || sides(ring).any(|side| self.extra.binary_search(&side).is_ok())
        {
            return true;
        }
        let corners: Vec<Option<u32>> = ring.iter().map(|&m| self.back[m as usize]).collect();
        let has_both = |[a, b]: &[u32; 2]| corners.contains(&Some(*a)) && corners.contains(&Some(*b));
        self.missing.len() <= EXCUSES && self.missing.iter().any(has_both)
    }
}

/// The sides of an outline, the smaller number first.
fn sides(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    ring_sides(ring).map(|[a, b]| [a.min(b), a.max(b)])
}
