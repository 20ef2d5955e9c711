//! What is selected, by clicks, by links and by walks.

use super::{Message, NOTHING, Outcome, Reply, SELECTION, Scene, Session, Tone, said};
use crate::edits::{Argument, Call, rows};
use crate::ids::{Element, VertexId};
use crate::play::walk;
use crate::topology::has;

impl Session {
    pub(super) fn under(&self, x: f64, y: f64, reach: f64) -> Option<Element> {
        if let Some(table) = self.quiz.as_ref().and_then(|quiz| quiz.round.table()) {
            return self.canvas.near(table, x, y, reach);
        }
        self.canvas.pick(self.scene.subdivision()?, x, y, reach)
    }

    pub(super) fn pick(&mut self, found: Element, at: Option<[f64; 2]>) -> Outcome {
        if self.quiz.as_ref().is_some_and(|quiz| quiz.round.wants(false)) {
            return match found {
                Element::HalfEdge(h) => self.answer(&h.to_string()),
                _ => said(NOTHING, Tone::Note, format!("this is {found}: click a half-edge, on its side of the edge")),
            };
        }
        let place = at.and_then(|[x, y]| self.canvas.point(x, y));
        if let Some(row) = self.waiting {
            return self.complete(row, found);
        }
        let before = self.chosen.last().copied();
        if let (Scene::Points(_), Element::Face(_) | Element::HalfEdge(_), Some(p)) = (&self.scene, found, place)
            && self.quiz.is_none()
        {
            return self.change_points(|points| points.add(p), format!("a point at ({}, {})", p.x, p.y));
        }
        if let (Scene::Plane { .. }, Some(Element::Vertex(u)), Element::Vertex(v)) = (&self.scene, before, found)
            && u != v
            && self.broken.is_none()
            && self.may_edit().is_ok()
        {
            return self.join_corners(u, v);
        }
        if before == Some(found) && matches!(found, Element::Vertex(_)) {
            self.leave();
            return Ok((SELECTION, Reply::default()));
        }
        self.chosen = vec![found];
        self.at = place;
        Ok((SELECTION, Reply::default()))
    }

    /// `split_face` between two corners: of the half-edges that start there, those in whose corners the segment begins and
    /// ends; along an edge, those that have one face, a bounded one if there is one.
    pub(super) fn join_corners(&mut self, u: VertexId, v: VertexId) -> Outcome {
        let Some(s) = self.scene.subdivision() else { return Err("this scene has no places".to_owned()) };
        let (from, to) = (s.corners_towards(u, s.point(v)), s.corners_towards(v, s.point(u)));
        let pairs = from.iter().flat_map(|&a| to.iter().map(move |&b| (a, b)));
        let best = pairs.min_by_key(|&(a, b)| (s.face(a) != s.face(b), s.face(a) == s.outer_face()));
        let call = match best {
            Some((a, b)) => Call::new(&rows::split_face, [Argument::from(a), Argument::from(b)]),
            // A vertex without edges has no corner: the plane's own word for joining two vertices.
            None => Call::new(&rows::insert_edge, [Argument::from(u), Argument::from(v)]),
        };
        self.plane_edit(call.map_err(|error| error.to_string())?).or_else(|reason| {
            self.chosen = vec![v.into()];
            Ok((SELECTION, self.refusal(&reason)))
        })
    }

    pub(super) fn follow(&mut self, link: &str) -> Outcome {
        let Some(&from) = self.chosen.last() else { return Err("select a half-edge first".to_owned()) };
        if self.quiz.as_ref().is_some_and(|quiz| !quiz.round.shows_tables()) {
            return Err("follow the links in your head: that is the question".to_owned());
        }
        let known = walk::link(link).ok_or_else(|| format!("`{link}` is no link"))?;
        let table = self.table();
        let to = walk::step(&table, from, known);
        let Some(to) = to.filter(|&to| has(&table, to)) else {
            return Err(format!("{from}.{link} leads nowhere"));
        };
        // While an edit waits for a second element, the first one stays.
        if self.waiting.is_none() || self.chosen.len() > 1 {
            self.chosen.pop();
        }
        self.chosen.push(to);
        said(SELECTION, Tone::Done, format!("{from}.{link} = {to}"))
    }

    pub(super) fn walk(&mut self, path: &str) -> Outcome {
        if self.quiz.as_ref().is_some_and(|quiz| !quiz.round.shows_tables()) {
            return Err("follow the links in your head: that is the question".to_owned());
        }
        let walked = walk::walk(&self.table(), path)?;
        let Some(&last) = walked.last() else { return Err("write a path such as h2.next.twin".to_owned()) };
        self.chosen = vec![last];
        let trail: Vec<String> = walked.iter().map(ToString::to_string).collect();
        let text = format!("{} = {last}", path.trim());
        let message = Some(Message { tone: Tone::Done, text, elements: vec![last.to_string()] });
        Ok((SELECTION, Reply { message, trail: Some(trail), ..Reply::default() }))
    }
}
