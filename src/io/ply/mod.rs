//! Polygon File Format (PLY), as text and as binary of either byte order.
//!
//! ```text
//!   ply
//!   format ascii 1.0                       or binary_little_endian, binary_big_endian
//!   comment anything
//!   element vertex 4                       elements in any order; unknown ones are skipped
//!   property float x                       properties in any order and of any type; unknown ones are skipped
//!   property float y
//!   property float z
//!   element face 1
//!   property list uchar int vertex_indices (or vertex_index)
//!   end_header
//!   0 0 0                                  as text: one record a line
//!   1 0 0
//!   1 1 0
//!   0 1 0
//!   4 0 1 2 3
//! ```
//!
//! Errors of the header and of text name line and column; errors of binary data name the byte. Not read, by
//! name: triangle strips.
//!
//! Own reader: crate ply-rs-bw names no place in an error and makes a map for each element.
//!
//! Source: G. Turk, *The PLY polygon file format* (1994).
//!
//! ```text
//!   body.rs  The records of a PLY file, from text or from binary data
//! ```

mod body;
mod header;

use super::document::{Document, Read};
use super::problem::{ReadError, ReadProblem};
use super::soup::SoupBuilder;
use crate::io::Format;
use body::{Binary, Records, Text};
use header::{Element, Encoding, Header, Kind, Property};

const Z: usize = 2;

/// Reads a PLY file. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    let header = Header::read(bytes, source)?;
    let end = header.end;
    match header.encoding {
        Encoding::Text => elements(&header, Text::new(bytes, end, source)?, source),
        Encoding::LittleEndian => elements(&header, Binary::<true>::new(bytes, end, source), source),
        Encoding::BigEndian => elements(&header, Binary::<false>::new(bytes, end, source), source),
    }
}

fn elements(header: &Header, mut records: impl Records, source: &str) -> Result<Read, ReadError> {
    let mut soup = SoupBuilder::with_room(header.points, records.remaining(), 6, source)?;
    let mut gives_z = false;
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => gives_z = points(element, &mut records, &mut soup)?,
            "face" => faces(element, header.points, &mut records, &mut soup)?,
            _ => others(element, &mut records)?,
        }
    }
    let mut notes = Vec::new();
    records.finish(&mut notes)?;
    Ok(Read { document: Document::Polygons(soup.finish(source, gives_z)?), notes, format: Format::Ply })
}

/// Reads the points; returns whether they have a z.
fn points(element: &Element, records: &mut impl Records, soup: &mut SoupBuilder) -> Result<bool, ReadError> {
    let axis = |property: &Property| {
        ["x", "y", "z"].iter().position(|axis| property.name == *axis).filter(|_| property.list.is_none())
    };
    let axes: Vec<Option<usize>> = element.properties.iter().map(axis).collect();
    for i in 0..element.count {
        let line = records.begin(element, i)?;
        let mut point = [0.0; 3];
        for (property, axis) in element.properties.iter().zip(&axes) {
            match axis {
                Some(k) => point[*k] = records.coordinate(['x', 'y', 'z'][*k], property.kind)?,
                None => skip(property, records)?,
            }
        }
        records.end()?;
        soup.points.push(point);
        soup.vertex_lines.extend(line);
    }
    Ok(axes.contains(&Some(Z)))
}

fn faces(element: &Element, points: u64, records: &mut impl Records, soup: &mut SoupBuilder) -> Result<(), ReadError> {
    let mut corners = Vec::new();
    for i in 0..element.count {
        let line = records.begin(element, i)?;
        for property in &element.properties {
            match property.list {
                Some(count) if property.is_corners() => {
                    corners.clear();
                    for _ in 0..records.count(count)? {
                        corners.push(records.index(property.kind, points)?);
                    }
                }
                _ => skip(property, records)?,
            }
        }
        records.end()?;
        if corners.is_empty() {
            let (wanted, found) = ("a face with at least one corner".into(), format!("face {i} without any"));
            return Err(records.error_here(ReadProblem::Expected { wanted, found }));
        }
        soup.faces.push_face(&corners);
        soup.face_lines.extend(line);
    }
    Ok(())
}

/// Steps over the records of an element the kit does not know.
fn others(element: &Element, records: &mut impl Records) -> Result<(), ReadError> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for i in 0..element.count {
        records.begin(element, i)?;
        for property in &element.properties {
            skip(property, records)?;
        }
        records.end()?;
    }
    Ok(())
}

fn skip(property: &Property, records: &mut impl Records) -> Result<(), ReadError> {
    let values = match property.list {
        Some(count) => records.count(count)?,
        None => 1,
    };
    records.skip(values, property.kind)
}

impl Property {
    /// Whether this is the list of the corners of a face.
    fn is_corners(&self) -> bool {
        self.list.is_some() && matches!(self.name.as_str(), "vertex_index" | "vertex_indices")
    }
}

impl Kind {
    /// Whether the type holds whole numbers.
    fn is_whole(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}
