//! The writer of navigation meshes, version 2.
//!
//! ```text
//!        3 ───────── 2
//!        │  1    ╱   │      vertex 1 has the polygons 0 and 1 round it, then nothing: `1 0  3 0 1 -1`.
//!        │    ╱   0  │      Gaps beside each other count as one.
//!        0 ───────── 1
//! ```

use crate::geometry::number::Number;
use crate::ids::{FaceMap, HalfEdgeId, VertexId};
use crate::io::format::Format;
use crate::io::model::{Model, Polygons};
use crate::io::write_error::WriteError;
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Ordering;
use std::io::Write;

/// Writes version 2. Cost: O(size).
///
/// # Errors
/// [`WriteError::NotConvex`], or what is broken in the structure. Then nothing has been written.
pub(in crate::io) fn write(out: &mut impl Write, model: &Model<'_>, polygons: &Polygons) -> Result<(), WriteError> {
    let mut numbers = FaceMap::filled(model.view.face_bound(), -1);
    for (i, &f) in polygons.faces.iter().enumerate() {
        numbers[f] = i as i64;
    }
    check_convex(model, polygons)?;
    let number = |h: HalfEdgeId| model.view.face(h).and_then(|f| numbers.get(f).copied()).unwrap_or(-1);
    let mut text = format!("mesh\n2\n{} {}\n", polygons.points.len(), polygons.faces.len());
    let mut around = Vec::new();
    for (v, [x, y, _]) in model.vertices().zip(&polygons.points) {
        star(model, v, &number, &mut around)?;
        text.push_str(&format!("{} {}  {}", Number(*x), Number(*y), around.len()));
        append(&mut text, &around);
    }
    for (&f, corners) in polygons.faces.iter().zip(polygons.list.outer_cycles()) {
        let broken = |half_edge| WriteError::BrokenCycle { face: f, half_edge };
        let mut h = model.view.half_edge(f).ok_or(WriteError::NoBoundary { face: f })?;
        // The first neighbour is behind the edge that ends at the first corner.
        h = model.view.prev(h).ok_or(broken(h))?;
        around.clear();
        for _ in corners {
            around.push(model.view.twin(h).map_or(-1, number));
            h = model.view.next(h).ok_or(broken(h))?;
        }
        text.push_str(&corners.len().to_string());
        append(&mut text, corners);
        text.pop();
        text.push(' ');
        append(&mut text, &around);
    }
    Ok(out.write_all(text.as_bytes())?)
}

/// Appends the numbers, each after a blank, and the end of the line.
fn append(text: &mut String, numbers: &[impl ToString]) {
    for number in numbers {
        text.push(' ');
        text.push_str(&number.to_string());
    }
    text.push('\n');
}

/// The polygons round a vertex, counter-clockwise; gaps beside each other once.
fn star(
    model: &Model<'_>,
    v: VertexId,
    number: &impl Fn(HalfEdgeId) -> i64,
    around: &mut Vec<i64>,
) -> Result<(), WriteError> {
    around.clear();
    let Some(first) = model.view.outgoing(v) else {
        around.push(-1);
        return Ok(());
    };
    let mut h = first;
    for _ in 0..model.view.half_edge_bound() {
        let here = number(h);
        if here != -1 || around.last() != Some(&-1) {
            around.push(here);
        }
        // Counter-clockwise, the half-edge after h is the twin of the one before it.
        let Some(next) = model.view.prev(h).and_then(|p| model.view.twin(p)) else { break };
        if next == first {
            if around.len() > 1 && around.first() == Some(&-1) && around.last() == Some(&-1) {
                around.pop();
            }
            return Ok(());
        }
        h = next;
    }
    let face = model.view.face(h).unwrap_or(crate::FaceId::new(0));
    Err(WriteError::BrokenCycle { face, half_edge: h })
}

/// Refuses faces with a corner that points inwards. Straight corners are fine. Exact.
fn check_convex(model: &Model<'_>, polygons: &Polygons) -> Result<(), WriteError> {
    let vertices: Vec<VertexId> = model.vertices().collect();
    let point = |c: u32| Point::new(polygons.points[c as usize][0], polygons.points[c as usize][1]);
    for (&face, corners) in polygons.faces.iter().zip(polygons.list.outer_cycles()) {
        let n = corners.len();
        let turns = |k: &usize| {
            let [a, b, c] = [corners[(k + n - 1) % n], corners[*k], corners[(k + 1) % n]].map(point);
            orientation(a, b, c) == Ordering::Less
        };
        if let Some(k) = (0..n).find(turns) {
            let vertex = vertices[corners[k] as usize];
            return Err(WriteError::NotConvex { face, vertex, format: Format::Mesh.name() });
        }
    }
    Ok(())
}
