//! Vertices that are dragged, dropped and nudged.

use super::{NOTHING, Outcome, Over, Scene, Session, TITLE, tables};
use crate::edits::{Argument, Call, rows};
use crate::ids::{Element, VertexId};
use crate::plane::Point;
use crate::play::reply::{Message, Reply, Tone, element, named};
use crate::topology::Table;

impl Session {
    pub(super) fn vertex(&self, id: &str) -> Result<VertexId, String> {
        match tables::find(&self.scene.table(), id)? {
            Element::Vertex(v) => Ok(v),
            other => Err(format!("{other} cannot be dragged: only vertices can")),
        }
    }

    pub(super) fn drag(&mut self, id: &str, x: f64, y: f64) -> Outcome {
        self.may_edit()?;
        let Some(Element::Vertex(v)) = element(id) else {
            return Err(format!("{id} cannot be dragged: only vertices can"));
        };
        let p = self.canvas.point(x, y).ok_or("there is no picture to drag in")?;
        if let Scene::Points(points) = &self.scene {
            let held = points.held(v.index(), p)?;
            let mut reply = Reply::default();
            let table = Table::from_planar_view(held.delaunay());
            let options = self.canvas.options(TITLE);
            let figure = self.canvas.draw(&table, options, false).map_err(|error| error.to_string())?;
            reply.svg = Some(figure.to_svg());
            reply.over = Some(held.over(&self.canvas));
            return Ok((NOTHING, reply));
        }
        let Scene::Plane { work, .. } = &self.scene else {
            return Err("without coordinates nothing can be dragged".to_owned());
        };
        let s = work.now();
        s.topology().check(v).map_err(|error| error.to_string())?;
        let verdict = s.can_set_point(v, p);
        let mut over = Over::default();
        let class = if verdict.is_ok() { "drag" } else { "drag bad" };
        let table = self.table();
        if let Err(error) = &verdict {
            for crossed in named(&error.to_string()).into_iter().filter(|&element| element != v.into()) {
                over.mark("mark bad", &self.canvas, &table, crossed);
            }
        }
        if let Some(at) = self.canvas.place(p) {
            for h in s.outgoing_half_edges(v) {
                if let Some(end) = self.canvas.place(s.point(s.destination(h))) {
                    over.line(class, at, end);
                }
            }
            over.circle(class, at, 8.0);
        }
        let message = match verdict {
            Ok(()) => Message::new(Tone::Note, format!("{v} at ({}, {})", p.x, p.y)),
            Err(error) => Message::new(Tone::Refused, error.to_string()),
        };
        Ok((NOTHING, Reply { over: Some(over.0), message: Some(message), ..Reply::default() }))
    }

    pub(super) fn drop_at(&mut self, id: &str, x: f64, y: f64) -> Outcome {
        let v = self.vertex(id)?;
        let p = self.canvas.point(x, y).ok_or("there is no picture to drag in")?;
        self.put(v, p)
    }

    pub(super) fn nudge(&mut self, id: &str, x: f64, y: f64) -> Outcome {
        let v = self.vertex(id)?;
        let step = self.canvas.step();
        let at = self.scene.subdivision().ok_or("without coordinates nothing can be moved")?.point(v);
        let moved = self.put(v, Point::new(at.x + step * x, at.y + step * y))?;
        self.chosen = vec![v.into()];
        Ok(moved)
    }

    pub(super) fn put(&mut self, v: VertexId, p: Point) -> Outcome {
        self.may_edit()?;
        if let Some(quiz) = &self.quiz
            && !quiz.round.allows("set_point")
        {
            return Err("only split_face and split_in_half draw this: corners stay where they are".to_owned());
        }
        if let Scene::Points(_) = self.scene {
            return self.change_points(|points| points.place(v.index(), p), format!("{v} at ({}, {})", p.x, p.y));
        }
        let call = Call::new(&rows::set_point, [Argument::from(v), Argument::from(p)]);
        let moved = self.plane_edit(call.map_err(|error| error.to_string())?)?;
        self.chosen = vec![v.into()];
        Ok(moved)
    }
}
