//! The three tables of a half-edge structure as on the lecture slides, in aligned columns.
//!
//! ```text
//!   Vertex | Coordinates | IncidentEdge
//!   -------+-------------+-------------
//!   v0     | (0, 0)      | h0
//!
//!   Half-edge | Origin | Twin | IncidentFace | Next | Prev
//!   ----------+--------+------+--------------+------+-----
//!   h0        | v0     | h1   | f1           | h2   | h4
//!
//!   Face | OuterComponent | InnerComponents
//!   -----+----------------+----------------
//!   f0   | none           | h1
//!   f1   | h0             | none
//! ```
//!
//! The outer face has no outer component here: all its cycles are inner components. A column `Name` and a
//! column `Hole` follow where a face has a name or is a hole face.
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 2.2.

use super::model::Model;
use super::names::Pointer;
use crate::geometry::number::Number;
use crate::ids::Element;
use crate::topology::InnerComponent;
use std::io::{self, Write};

/// Writes the three tables. O(size of the model).
pub(super) fn write(out: &mut impl Write, model: &Model<'_>) -> io::Result<()> {
    vertices(out, model)?;
    writeln!(out)?;
    half_edges(out, model)?;
    writeln!(out)?;
    faces(out, model)
}

fn vertices(out: &mut impl Write, model: &Model<'_>) -> io::Result<()> {
    let coordinates = |[x, y, z]: [f64; 3]| match model.in_space {
        true => format!("({}, {}, {})", Number(x), Number(y), Number(z)),
        false => format!("({}, {})", Number(x), Number(y)),
    };
    let rows = model.vertices().map(|v| {
        let position = model.position(v).map(coordinates);
        vec![v.to_string(), Pointer(position).to_string(), Pointer(model.view.outgoing(v)).to_string()]
    });
    table(out, &["Vertex", "Coordinates", "IncidentEdge"], &rows.collect::<Vec<_>>())
}

fn half_edges(out: &mut impl Write, model: &Model<'_>) -> io::Result<()> {
    let view = model.view;
    let rows = model.half_edges().map(|h| {
        vec![
            h.to_string(),
            Pointer(view.origin(h)).to_string(),
            Pointer(view.twin(h)).to_string(),
            Pointer(view.face(h)).to_string(),
            Pointer(view.next(h)).to_string(),
            Pointer(view.prev(h)).to_string(),
        ]
    });
    table(out, &["Half-edge", "Origin", "Twin", "IncidentFace", "Next", "Prev"], &rows.collect::<Vec<_>>())
}

fn faces(out: &mut impl Write, model: &Model<'_>) -> io::Result<()> {
    let view = model.view;
    let names = model.faces().any(|f| model.name(f).is_some());
    let holes = model.faces().any(|f| view.is_hole(f));
    let rows = model.faces().map(|f| {
        let (mut outer, mut inner) = (view.half_edge(f), view.inner_components(f).to_vec());
        if view.outer_face() == Some(f) {
            inner.splice(0..0, outer.take().map(InnerComponent::Cycle));
        }
        let inner = inner.into_iter().map(|ring| Element::from(ring).to_string()).collect::<Vec<_>>().join(", ");
        let inner = if inner.is_empty() { "none".to_owned() } else { inner };
        let mut row = vec![f.to_string(), Pointer(outer).to_string(), inner];
        if names {
            row.push(model.name(f).unwrap_or("").escape_debug().to_string());
        }
        if holes {
            row.push(if view.is_hole(f) { "hole" } else { "" }.to_owned());
        }
        row
    });
    let mut heads = vec!["Face", "OuterComponent", "InnerComponents"];
    heads.extend(names.then_some("Name"));
    heads.extend(holes.then_some("Hole"));
    table(out, &heads, &rows.collect::<Vec<_>>())
}

/// Writes rows in columns as wide as their widest cell; no blanks at the ends of lines.
fn table(out: &mut impl Write, heads: &[&str], rows: &[Vec<String>]) -> io::Result<()> {
    let width = |c: usize| {
        let cells = rows.iter().map(|row| row[c].chars().count());
        cells.chain([heads[c].chars().count()]).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..heads.len()).map(width).collect();
    let line = |cells: &mut dyn Iterator<Item = &str>| {
        // By hand: a width in a format string ends at 65,535.
        let blanks = |cell: &str, width: usize| " ".repeat(width.saturating_sub(cell.chars().count()));
        let padded: Vec<String> =
            cells.zip(&widths).map(|(cell, &width)| format!("{cell}{}", blanks(cell, width))).collect();
        padded.join(" | ").trim_end().to_owned()
    };
    writeln!(out, "{}", line(&mut heads.iter().copied()))?;
    let rule: Vec<String> = widths.iter().map(|&width| "-".repeat(width)).collect();
    writeln!(out, "{}", rule.join("-+-"))?;
    for row in rows {
        writeln!(out, "{}", line(&mut row.iter().map(String::as_str)))?;
    }
    Ok(())
}
