//! Predict the verdict: which of four calls is refused, and why?

use super::structures::random;
use super::{Dice, Verdict};
use crate::edits::{Argument, Call, rows};
use crate::ids::{Element, HalfEdgeId};
use crate::plane::{PlaneJournal, SplitFaceError, Subdivision};
use crate::play::reply::named;
use crate::topology::{self, Table};

/// Four calls, one of them refused, and three reasons.
#[derive(Clone, Debug)]
pub(super) struct Predict {
    pub(super) table: Table,
    calls: Vec<String>,
    refused: usize,
    reasons: Vec<String>,
    why: usize,
    /// Whether the call was found, so that the reason is asked for.
    found: bool,
}

impl Predict {
    pub(super) fn new(dice: &mut Dice, level: u32) -> Self {
        let mut quiz = None;
        for _ in 0..200 {
            quiz = Self::try_new(dice, level);
            if quiz.is_some() {
                break;
            }
        }
        quiz.unwrap_or_else(Self::plain)
    }

    fn try_new(dice: &mut Dice, level: u32) -> Option<Self> {
        let s = random(dice, 2 * level as usize);
        let half_edges: Vec<HalfEdgeId> = s.half_edges().collect();
        let call = |dice: &mut Dice, kind: usize| -> Option<Call<Subdivision>> {
            let a = *dice.pick(&half_edges)?;
            let b = *dice.pick(&half_edges)?;
            let one = |row| Call::new(row, [Argument::from(a)]).ok();
            match kind {
                0 => one(&rows::split_in_half),
                1 => one(&rows::flip_edge),
                2 => one(&rows::join_edges),
                _ => Call::new(&rows::split_face, [Argument::from(a), Argument::from(b)]).ok(),
            }
        };
        let verdict = |call: &Call<Subdivision>| call.apply(&mut s.clone(), &mut PlaneJournal::new());
        let mut refused = None;
        for _ in 0..400 {
            let candidate = call(dice, 9)?;
            let Err(error) = verdict(&candidate) else { continue };
            // At the first level the reason is seen in the tables; later it is seen in the plane alone.
            let of_plane = !matches!(error.downcast_ref(), Some(SplitFaceError::Topology(_)));
            if of_plane == (level > 1) {
                refused = Some((candidate, error));
                break;
            }
        }
        let (bad, error) = refused?;
        let mut calls = vec![bad.clone()];
        for _ in 0..400 {
            if calls.len() == 4 {
                break;
            }
            let kind = dice.below(if level == 1 { 6 } else { 9 });
            let kind = if level == 1 && (kind == 1 || kind == 2) { 9 } else { kind };
            let candidate = call(dice, kind)?;
            if verdict(&candidate).is_ok() && !calls.contains(&candidate) {
                calls.push(candidate);
            }
        }
        if calls.len() < 4 {
            return None;
        }
        dice.shuffle(&mut calls);
        let place = calls.iter().position(|call| *call == bad)?;
        let mut reasons = decoys(&s, &bad, error.downcast_ref()?);
        dice.shuffle(&mut reasons);
        reasons.truncate(2);
        reasons.push(error.to_string());
        dice.shuffle(&mut reasons);
        let why = reasons.iter().position(|reason| *reason == error.to_string())?;
        let calls = calls.iter().map(ToString::to_string).collect();
        Some(Self { table: Table::from_planar_view(&s), calls, refused: place, reasons, why, found: false })
    }

    /// A question about the lab's rectangle, should chance never give one.
    fn plain() -> Self {
        let s = Subdivision::lab_rectangle();
        let error = "h0 bounds f1, but h1 bounds f0: a face is split between two of its own corners".to_owned();
        let calls = ["split_face h0 h4", "split_face h0 h1", "split_in_half h2", "split_face h2 h8"];
        Self {
            table: Table::from_planar_view(&s),
            calls: calls.map(str::to_owned).to_vec(),
            refused: 1,
            reasons: vec![error],
            why: 0,
            found: false,
        }
    }

    pub(super) fn text(&self) -> String {
        if self.found {
            format!("Yes, {} is refused. Why?", self.calls[self.refused])
        } else {
            "Three of these calls are made, one is refused. Which one? Each is tried on this drawing, not after the others."
                .to_owned()
        }
    }

    pub(super) fn choices(&self) -> Vec<String> {
        if self.found { self.reasons.clone() } else { self.calls.clone() }
    }

    pub(super) fn answer(&mut self, answer: &str) -> Result<Verdict, String> {
        let choices = if self.found { &self.reasons } else { &self.calls };
        let chosen: Option<usize> = answer.parse().ok().filter(|&i| i < choices.len());
        let chosen = chosen.ok_or("choose one of the answers".to_owned())?;
        let why = &self.reasons[self.why];
        let told = format!("{} is refused: {why}", self.calls[self.refused]);
        let trail: Vec<Element> = named(&told).into_iter().filter(|e| !matches!(e, Element::Edge(_))).collect();
        if !self.found {
            if chosen != self.refused {
                let text = format!("{} is made; {told}", self.calls[chosen]);
                return Ok(Verdict { right: false, over: true, text, trail });
            }
            self.found = true;
            let text = format!("yes, {} is refused", self.calls[chosen]);
            return Ok(Verdict { right: true, over: false, text, trail: Vec::new() });
        }
        let right = chosen == self.why;
        let text = if right { format!("right: {told}") } else { format!("not that; {told}") };
        Ok(Verdict { right, over: true, text, trail })
    }

    /// The refused call and the number of its reason: for tests.
    #[cfg(test)]
    pub(super) fn solution(&self) -> (usize, usize, &[String]) {
        (self.refused, self.why, &self.calls)
    }
}

/// Other refusals of the same call in the library's words, none of which is true of it.
fn decoys(s: &Subdivision, call: &Call<Subdivision>, truth: &SplitFaceError) -> Vec<String> {
    let [Element::HalfEdge(h1), Element::HalfEdge(h2)] = call.elements()[..] else { return Vec::new() };
    let cycle: Vec<HalfEdgeId> = s.cycle(h1).collect();
    // An edge that the segment does not cross: one that ends where the segment begins.
    let beside = s.prev(h1);
    let of_same_face = s.face(h1) == s.face(h2);
    let mut all = Vec::new();
    if s.origin(h1) != s.origin(h2) {
        all.push(SplitFaceError::SameVertex { h1, h2, vertex: s.origin(h1) });
        let joined = s.outgoing_half_edges(s.origin(h1)).any(|h| s.destination(h) == s.origin(h2));
        if !joined {
            all.push(SplitFaceError::EdgeExists { h1, h2, existing: h1 });
        }
    }
    if !of_same_face || !matches!(truth, SplitFaceError::EdgeCrosses { .. }) {
        all.push(SplitFaceError::EdgeCrosses { h1, h2, crossed: beside });
    }
    if of_same_face
        && !matches!(truth, SplitFaceError::EdgeThroughVertex { .. } | SplitFaceError::EdgeOutsideFace { .. })
    {
        all.push(SplitFaceError::EdgeThroughVertex { h1, h2, vertex: s.origin(cycle[cycle.len() / 2]) });
    }
    if s.next(h1) != h2 {
        all.push(topology::SplitFaceError::NextOf { h1, h2 }.into());
    }
    if s.prev(h1) != h2 {
        all.push(topology::SplitFaceError::PrevOf { h1, h2 }.into());
    }
    let of_plane = |error: &SplitFaceError| !matches!(error, SplitFaceError::Topology(_));
    let same_kind = |error: &SplitFaceError| std::mem::discriminant(error) == std::mem::discriminant(truth);
    all.iter().filter(|error| !(of_plane(error) && same_kind(error))).map(ToString::to_string).collect()
}
