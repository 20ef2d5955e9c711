//! The winged-edge tables of the lecture slides, as text.
//!
//! ```text
//!            w_o ╲   ╱               o     the opposite half-edge: the twin
//!                 ╲ ╱                w_i   the wing that comes in: the one before, along the face
//!                  ● v               w_o   the wing that goes out: the one after
//!           f      ^                 v     the vertex it ends at
//!                  │ h               f     the face on its left
//!                  ●
//!                 ╱ ╲
//!            w_i ╱   ╲
//! ```
//!
//! Source: Kazhdan's slides on 3D convex hulls after O'Rourke, *Computational Geometry in C*, chapter 4; there the
//! rows are numbered from 1, here they have the names of the elements.

use super::Polyhedron;
use crate::geometry::number::Number;
use std::fmt::{self, Display, Formatter};

/// The tables of a surface; printed by `Display`.
#[derive(Clone, Copy, Debug)]
pub struct WingedEdges<'a>(&'a Polyhedron);

impl Polyhedron {
    /// The vertex list, the face list and the half-edge list of the slides. Boundary faces are marked.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron};
    /// let text = Polyhedron::platonic(Platonic::Tetrahedron).winged_edges().to_string();
    /// assert!(text.starts_with("Vertex list\nid   x   y   z  h\nv0   1   1   1  h0"));
    /// ```
    #[must_use]
    pub fn winged_edges(&self) -> WingedEdges<'_> {
        WingedEdges(self)
    }
}

impl Display for WingedEdges<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (solid, dcel) = (self.0, self.0.topology());
        let or_none = |h: Option<crate::HalfEdgeId>| h.map_or("none".to_owned(), |h| h.to_string());
        let vertices = solid.vertices().map(|v| {
            let [x, y, z] = solid.point(v).map(|x| Number(x).to_string());
            [v.to_string(), x, y, z, or_none(dcel.outgoing(v))]
        });
        table(f, "Vertex list", ["id", "x", "y", "z", "h"], vertices.collect())?;
        let faces = solid.faces().map(|face| {
            let mark = if solid.is_boundary_face(face) { "border" } else { "" };
            [face.to_string(), or_none(dcel.half_edge(face)), mark.to_owned()]
        });
        table(f, "\nFace list", ["id", "h", ""], faces.collect())?;
        let half_edges = solid.half_edges().map(|h| {
            let [o, w_i, w_o] = [h.twin(), dcel.prev(h), dcel.next(h)].map(|h| h.to_string());
            [h.to_string(), o, w_i, w_o, dcel.destination(h).to_string(), dcel.face(h).to_string()]
        });
        table(f, "\nHalf-edge list", ["id", "o", "w_i", "w_o", "v", "f"], half_edges.collect())
    }
}

/// A heading, the names of the columns, and the rows; numbers on the right.
fn table<const N: usize>(
    f: &mut Formatter<'_>,
    heading: &str,
    names: [&str; N],
    mut rows: Vec<[String; N]>,
) -> fmt::Result {
    writeln!(f, "{heading}")?;
    rows.insert(0, names.map(str::to_owned));
    let widths: [usize; N] = std::array::from_fn(|i| rows.iter().map(|row| row[i].len()).max().unwrap_or(0));
    for row in rows {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(widths) {
            let is_number = cell.parse::<f64>().is_ok() || matches!(cell.as_str(), "x" | "y" | "z");
            let padded = if is_number { format!("{cell:>width$}") } else { format!("{cell:<width$}") };
            line.push_str(&padded);
            line.push_str("  ");
        }
        writeln!(f, "{}", line.trim_end())?;
    }
    Ok(())
}
