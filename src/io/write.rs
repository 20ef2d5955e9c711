//! The way out: from a [`Model`] to a file.
//!
//! Output is the same for the same structure, byte for byte. Numbers have as few digits as bring back the same
//! number. Polygons and points come in the order of the ids; removed ids leave no gap.

use super::dcel::quote;
use super::format::Format;
use super::model::{Model, Polygons};
use super::names::Pointer;
use super::words::counted;
use super::write_error::WriteError;
use super::{mesh, stl, tables};
use crate::files::WholeFile;
use crate::geometry::number::Number;
use crate::ids::Element;
use crate::progress::Stage;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Writes a model. Cost: O(size of the model).
///
/// # Errors
/// [`WriteError`] if the format cannot hold the structure; then nothing has been written.
pub fn write(out: &mut impl Write, model: &Model<'_>, format: Format) -> Result<(), WriteError> {
    write_to(out, model, format)
}

/// [`write()`], compiled once for all that can be written to.
fn write_to(out: &mut dyn Write, model: &Model<'_>, format: Format) -> Result<(), WriteError> {
    let mut out = BufWriter::new(Lines { out, stage: Stage::new("writing", lines_of(model, format)) });
    match format {
        Format::Obj => obj(&mut out, &Polygons::of(model, format)?)?,
        Format::Off => off(&mut out, &Polygons::of(model, format)?)?,
        Format::Ply => ply(&mut out, &Polygons::of(model, format)?)?,
        Format::PlyBinary => ply_binary(&mut out, &Polygons::of(model, format)?)?,
        Format::Stl => stl::write(&mut out, &Polygons::of(model, format)?)?,
        Format::StlBinary => stl::write_binary(&mut out, &Polygons::of(model, format)?)?,
        Format::GeoJson => geojson(&mut out, model, &Polygons::of(in_plane(model, format)?, format)?)?,
        Format::Mesh => mesh::write(&mut out, model, &Polygons::of(in_plane(model, format)?, format)?)?,
        Format::Dcel => dcel(&mut out, in_plane(model, format)?)?,
        Format::Tables => tables::write(&mut out, model)?,
        Format::Triangle => return Err(WriteError::TwoFiles),
        Format::TopoJson | Format::Map | Format::Wkt | Format::Poly | Format::Segments => {
            return Err(WriteError::ReadOnly { format: format.name() });
        }
    }
    Ok(out.flush()?)
}

/// About how many lines a format takes; none if it is binary.
fn lines_of(model: &Model<'_>, format: Format) -> usize {
    let [vertices, faces] = [model.vertices().count(), model.faces().count()];
    match format {
        Format::Dcel | Format::Tables => vertices + faces + model.half_edges().count(),
        Format::Stl => 7 * faces,
        Format::GeoJson => faces,
        Format::PlyBinary | Format::StlBinary => 0,
        _ => vertices + faces,
    }
}

/// Counts the lines that are written.
struct Lines<'a> {
    out: &'a mut dyn Write,
    stage: Stage,
}

impl Write for Lines<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.stage.add(bytes[..written].iter().filter(|&&b| b == b'\n').count());
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Writes a triangulation as the `.node` and the `.ele` file of Triangle, numbered from 1.
///
/// # Errors
/// As [`write()`], and [`WriteError::NotTriangle`].
pub fn write_triangle(node: &mut impl Write, ele: &mut impl Write, model: &Model<'_>) -> Result<(), WriteError> {
    let polygons = Polygons::of(in_plane(model, Format::Triangle)?, Format::Triangle)?;
    let mut sizes = polygons.faces.iter().zip(polygons.list.outer_cycles());
    if let Some((&face, cycle)) = sizes.find(|(_, cycle)| cycle.len() != 3) {
        return Err(WriteError::NotTriangle { face, corners: cycle.len() });
    }
    let (mut node, mut ele) = (BufWriter::new(node), BufWriter::new(ele));
    writeln!(node, "{} 2 0 0", polygons.points.len())?;
    for (i, [x, y, _]) in polygons.points.iter().enumerate() {
        writeln!(node, "{} {} {}", i + 1, Number(*x), Number(*y))?;
    }
    writeln!(ele, "{} 3 0", polygons.faces.len())?;
    for (i, cycle) in polygons.list.outer_cycles().enumerate() {
        write!(ele, "{}", i + 1)?;
        corners(&mut ele, cycle, 1)?;
    }
    node.flush()?;
    Ok(ele.flush()?)
}

/// Writes a model to a file, whole or not at all: see [`crate::files`]. `-` is standard output. Triangle's format becomes
/// two files beside each other.
///
/// # Errors
/// As [`write()`] and [`write_triangle`]; then an old file of that name is as it was.
pub fn write_path(path: &Path, model: &Model<'_>, format: Format) -> Result<(), WriteError> {
    if path.as_os_str() == "-" {
        return write(&mut io::stdout().lock(), model, format);
    }
    if format == Format::Triangle {
        let mut node = WholeFile::create(&path.with_extension("node"))?;
        let mut ele = WholeFile::create(&path.with_extension("ele"))?;
        write_triangle(&mut node, &mut ele, model)?;
        node.commit()?;
        return Ok(ele.commit()?);
    }
    let mut file = WholeFile::create(path)?;
    write(&mut file, model, format)?;
    Ok(file.commit()?)
}

fn in_plane<'m, 'a>(model: &'m Model<'a>, format: Format) -> Result<&'m Model<'a>, WriteError> {
    if model.in_space { Err(WriteError::InSpace { format: format.name() }) } else { Ok(model) }
}

/// The corners of a cycle, each after a blank, and the end of the line.
fn corners(out: &mut impl Write, cycle: &[u32], first: u32) -> io::Result<()> {
    for corner in cycle {
        write!(out, " {}", corner + first)?;
    }
    writeln!(out)
}

fn points(out: &mut impl Write, before: &str, points: &[[f64; 3]]) -> io::Result<()> {
    for [x, y, z] in points {
        writeln!(out, "{before}{} {} {}", Number(*x), Number(*y), Number(*z))?;
    }
    Ok(())
}

fn obj(out: &mut impl Write, polygons: &Polygons) -> io::Result<()> {
    // Without this line a drawing of nothing would be an empty file, which no reader takes.
    let points_there = counted(polygons.points.len(), "point", "points");
    writeln!(out, "# {points_there}, {}", counted(polygons.faces.len(), "polygon", "polygons"))?;
    points(out, "v ", &polygons.points)?;
    for cycle in polygons.list.outer_cycles() {
        write!(out, "f")?;
        corners(out, cycle, 1)?;
    }
    Ok(())
}

fn off(out: &mut impl Write, polygons: &Polygons) -> io::Result<()> {
    writeln!(out, "OFF\n{} {} 0", polygons.points.len(), polygons.faces.len())?;
    points(out, "", &polygons.points)?;
    polygons_with_sizes(out, polygons)
}

fn polygons_with_sizes(out: &mut impl Write, polygons: &Polygons) -> io::Result<()> {
    for cycle in polygons.list.outer_cycles() {
        write!(out, "{}", cycle.len())?;
        corners(out, cycle, 0)?;
    }
    Ok(())
}

/// The header of a PLY file; returns whether a byte can hold the number of corners of each face.
fn ply_header(out: &mut impl Write, polygons: &Polygons, encoding: &str) -> io::Result<bool> {
    let small = polygons.list.outer_cycles().all(|cycle| cycle.len() <= u8::MAX as usize);
    let size = if small { "uchar" } else { "uint" };
    writeln!(out, "ply\nformat {encoding} 1.0")?;
    writeln!(out, "element vertex {}\nproperty double x\nproperty double y\nproperty double z", polygons.points.len())?;
    writeln!(out, "element face {}\nproperty list {size} int vertex_indices", polygons.faces.len())?;
    writeln!(out, "end_header")?;
    Ok(small)
}

fn ply(out: &mut impl Write, polygons: &Polygons) -> io::Result<()> {
    ply_header(out, polygons, "ascii")?;
    points(out, "", &polygons.points)?;
    polygons_with_sizes(out, polygons)
}

fn ply_binary(out: &mut impl Write, polygons: &Polygons) -> io::Result<()> {
    let small = ply_header(out, polygons, "binary_little_endian")?;
    for value in polygons.points.as_flattened() {
        out.write_all(&value.to_le_bytes())?;
    }
    for cycle in polygons.list.outer_cycles() {
        let size = (cycle.len() as u32).to_le_bytes();
        out.write_all(if small { &size[..1] } else { &size })?;
        for corner in cycle {
            out.write_all(&corner.to_le_bytes())?;
        }
    }
    Ok(())
}

fn geojson(out: &mut impl Write, model: &Model<'_>, polygons: &Polygons) -> io::Result<()> {
    writeln!(out, "{{\"type\":\"FeatureCollection\",\"features\":[")?;
    for (i, &face) in polygons.faces.iter().enumerate() {
        write!(out, "{{\"type\":\"Feature\",\"id\":\"{face}\",\"properties\":{{")?;
        if let Some(name) = model.name(face) {
            write!(out, "\"name\":{}", serde_json::to_string(name)?)?;
        }
        write!(out, "}},\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":[")?;
        for (k, cycle) in polygons.list.cycles(i).enumerate() {
            write!(out, "{}", if k == 0 { "[" } else { ",[" })?;
            for (j, &corner) in cycle.iter().chain(cycle.first()).enumerate() {
                let [x, y, _] = polygons.points[corner as usize];
                write!(out, "{}[{},{}]", if j == 0 { "" } else { "," }, Number(x), Number(y))?;
            }
            write!(out, "]")?;
        }
        writeln!(out, "]}}}}{}", if i + 1 < polygons.faces.len() { "," } else { "" })?;
    }
    writeln!(out, "]}}")
}

fn dcel(out: &mut impl Write, model: &Model<'_>) -> io::Result<()> {
    let view = model.view;
    writeln!(out, "dcel 1")?;
    for v in model.vertices() {
        write!(out, "{v}")?;
        if let Some([x, y, _]) = model.position(v) {
            write!(out, " {} {}", Number(x), Number(y))?;
        }
        writeln!(out, " out {}", Pointer(view.outgoing(v)))?;
    }
    for h in model.half_edges() {
        let (origin, twin, next) = (Pointer(view.origin(h)), Pointer(view.twin(h)), Pointer(view.next(h)));
        let (prev, face) = (Pointer(view.prev(h)), Pointer(view.face(h)));
        writeln!(out, "{h} origin {origin} twin {twin} next {next} prev {prev} face {face}")?;
    }
    for f in model.faces() {
        let outer = if view.outer_face() == Some(f) { " outer" } else { "" };
        write!(out, "{f}{outer} half_edge {} inner", Pointer(view.half_edge(f)))?;
        match view.inner_components(f) {
            [] => write!(out, " none")?,
            rings => rings.iter().try_for_each(|&ring| write!(out, " {}", Element::from(ring)))?,
        }
        if view.is_hole(f) {
            write!(out, " hole")?;
        }
        if let Some(name) = model.name(f) {
            write!(out, " name {}", quote(name))?;
        }
        writeln!(out)?;
    }
    Ok(())
}
