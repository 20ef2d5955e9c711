//! The way in: from a path or from bytes to a [`Document`].

use super::blocks::{Blocks, Origin};
use super::document::{Document, Read, ReadOptions};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::text::{LARGEST_FILE, note_of_the_end};
use super::{dcel, grid, json, mesh, obj, off, ply, poly, segments, stl, triangle, wkt};
use std::fs::File;
use std::path::{Path, PathBuf};

/// Reads a file that is in memory. `source_name` is what errors call it.
///
/// y points up in the result (see [`ReadOptions::y_down`]); polygons keep the direction they have in the file.
/// Cost: O(length), and O(n log n) for the joining of equal points in the JSON formats.
///
/// # Errors
/// [`ReadError`] with the place of the first problem. Triangle's format needs two files: see
/// [`read_triangle`] and [`read_path`].
///
/// ```
/// use dcel_kit::io::{Document, Format, ReadOptions, read_bytes};
/// let text = "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n";
/// let read = read_bytes(text.as_bytes(), Format::Obj, "corner.obj", &ReadOptions::default())?;
/// let Document::Polygons(soup) = read.document else { unreachable!() };
/// assert_eq!((soup.points.len(), soup.faces.cycle(0)), (3, &[0, 1, 2][..]));
///
/// let error = read_bytes(b"v 0 0\nv 1 x\n", Format::Obj, "bad.obj", &ReadOptions::default()).unwrap_err();
/// assert!(error.to_string().starts_with("bad.obj:2:5: `x` is not a number"));
/// # Ok::<(), dcel_kit::io::ReadError>(())
/// ```
pub fn read_bytes(bytes: &[u8], format: Format, source_name: &str, options: &ReadOptions) -> Result<Read, ReadError> {
    let read = match format {
        Format::Obj | Format::Off | Format::Dcel | Format::Segments => {
            return read_blocks(&mut Blocks::whole(bytes, source_name)?, format, options);
        }
        Format::Ply | Format::PlyBinary => ply::read(bytes, source_name),
        Format::Stl | Format::StlBinary => stl::read(bytes, source_name),
        Format::Mesh => mesh::read(bytes, source_name),
        Format::Map => grid::read(bytes, source_name),
        Format::GeoJson | Format::TopoJson => json::read(bytes, source_name, options),
        Format::Wkt => wkt::read(bytes, source_name, options),
        Format::Poly => poly::read(triangle::File { bytes, source: source_name }, None),
        Format::Triangle => {
            let problem = ReadProblem::PartnerMissing { partner: "of this .node or .ele file".to_owned() };
            Err(ReadError::whole(source_name, problem, "give the path of one of the two files, not its contents"))
        }
        Format::Tables => {
            let problem = ReadProblem::WriteOnly { format: format.name() };
            Err(ReadError::whole(source_name, problem, "keep the structure as .dcel text to read it again"))
        }
    };
    let mut read = read?;
    if is_of_lines(read.format) && !is_binary(bytes) {
        read.notes.extend(note_of_the_end(bytes));
    }
    Ok(turned(read, options))
}

/// Reads a file of lines block by block.
pub(super) fn read_blocks(blocks: &mut Blocks<'_>, format: Format, options: &ReadOptions) -> Result<Read, ReadError> {
    let mut read = match format {
        Format::Obj => obj::read(blocks),
        Format::Off => off::read(blocks),
        Format::Segments => segments::read(blocks),
        _ => dcel::read(blocks, options.columns),
    }?;
    read.notes.extend(blocks.note());
    Ok(turned(read, options))
}

/// Whether the header of a PLY file says that numbers follow as they are in memory.
fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(b"ply") && bytes.windows(13).take(200).any(|part| part == b"format binary")
}

/// Whether a file of this format could go on after any line, or after any number in it, so that only the end of the
/// last line tells that it is whole.
fn is_of_lines(format: Format) -> bool {
    match format {
        Format::Ply | Format::Mesh | Format::Poly => true,
        // These are told by the blocks.
        Format::Obj | Format::Off | Format::Segments | Format::Dcel => false,
        // These close what they open, or count the characters of a line.
        Format::GeoJson | Format::TopoJson | Format::Wkt | Format::Stl | Format::Map => false,
        // The two files of this one are read together.
        Format::Triangle => false,
        Format::PlyBinary | Format::StlBinary | Format::Tables => false,
    }
}

/// Reads the two files of Triangle's format that are in memory.
///
/// # Errors
/// As [`read_bytes`]; the error names the file it is in.
pub fn read_triangle(
    node: &[u8],
    ele: &[u8],
    node_name: &str,
    ele_name: &str,
    options: &ReadOptions,
) -> Result<Read, ReadError> {
    let files = [triangle::File { bytes: node, source: node_name }, triangle::File { bytes: ele, source: ele_name }];
    let [node, ele] = files;
    let mut read = triangle::read(node, ele)?;
    for file in files {
        read.notes.extend(note_of_the_end(file.bytes).map(|note| format!("{}: {note}", file.source)));
    }
    Ok(turned(read, options))
}

/// Reads a file; `-` is standard input. Of `.node` and `.ele` either may be given, the other one is found
/// beside it.
///
/// # Errors
/// As [`read_bytes`], and what the machine says.
pub fn read_path(path: &Path, options: &ReadOptions) -> Result<Read, ReadError> {
    let source = source_name(path);
    let mut blocks = open(path, &source)?;
    let format = format_of(path, &mut blocks, options)?;
    read_opened(path, blocks, format, options)
}

/// The format: as it is asked for, by the name of the file, by its start.
pub(super) fn format_of(
    path: &Path,
    blocks: &mut Blocks<'_>,
    options: &ReadOptions,
) -> Result<Option<Format>, ReadError> {
    let by_name = || if is_stdin(path) { None } else { Format::from_path(path).filter(|format| format.can_read()) };
    match options.format.or_else(by_name) {
        None => Format::from_start(blocks),
        format => Ok(format),
    }
}

/// Reads a file that is open, of which the format is known or cannot be known.
pub(super) fn read_opened(
    path: &Path,
    mut blocks: Blocks<'_>,
    format: Option<Format>,
    options: &ReadOptions,
) -> Result<Read, ReadError> {
    let (stdin, source) = (is_stdin(path), blocks.source());
    match format {
        Some(format @ (Format::Obj | Format::Segments | Format::Dcel)) => {
            return read_blocks(&mut blocks, format, options);
        }
        // If the header counts wrongly, the lines are looked at again.
        Some(format @ Format::Off) if blocks.can_restart() => return read_blocks(&mut blocks, format, options),
        _ => {}
    }
    let bytes = blocks.into_whole()?;
    match format {
        Some(Format::Triangle) if !stdin => pair(path, &bytes, options),
        Some(Format::Poly) if !stdin => {
            // Its points may be in a file of their own.
            let node = partner_of(path, true);
            let points = if node.exists() { Some(load_path(&node)?) } else { None };
            let (name, poly) = (node.display().to_string(), triangle::File { bytes: &bytes, source });
            let node = points.as_deref().map(|bytes| triangle::File { bytes, source: &name });
            let mut read = poly::read(poly, node)?;
            read.notes.extend(note_of_the_end(&bytes));
            Ok(turned(read, options))
        }
        Some(format) => read_bytes(&bytes, format, source, options),
        None if bytes.is_empty() => Err(ReadError::whole(source, ReadProblem::Empty, "")),
        None => {
            let names: Vec<_> = Format::ALL.into_iter().filter(|f| f.can_read()).map(Format::name).collect();
            let help = format!("say it: {}", names.join(", "));
            Err(ReadError::whole(source, ReadProblem::UnknownFormat, help))
        }
    }
}

/// All bytes of a file, or of standard input for `-`.
///
/// # Errors
/// [`ReadError`]: what the machine says; too little memory; more bytes than any reader takes.
pub fn read_whole(path: &Path) -> Result<Vec<u8>, ReadError> {
    let bytes = load_path(path)?;
    if bytes.len() as u64 >= LARGEST_FILE {
        let problem = ReadProblem::TooLarge { what: "bytes", limit: LARGEST_FILE };
        return Err(ReadError::whole(&source_name(path), problem, ""));
    }
    Ok(bytes)
}

fn is_stdin(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// What errors call the file: its path, or `<stdin>` for `-`.
#[must_use]
pub fn source_name(path: &Path) -> String {
    if is_stdin(path) { "<stdin>".to_owned() } else { path.display().to_string() }
}

/// Reads `path` and the file that belongs to it.
fn pair(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Read, ReadError> {
    let is_ele = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("ele"));
    let partner = partner_of(path, is_ele);
    let name = |path: &Path| path.display().to_string();
    if !partner.exists() {
        let problem = ReadProblem::PartnerMissing { partner: name(&partner) };
        return Err(ReadError::whole(&name(path), problem, "the points are in .node, the triangles in .ele"));
    }
    let other = load_path(&partner)?;
    if is_ele {
        read_triangle(&other, bytes, &name(&partner), &name(path), options)
    } else {
        read_triangle(bytes, &other, &name(path), &name(&partner), options)
    }
}

/// `a.node` for `a.ele` and the other way round, in capitals if the given one is.
fn partner_of(path: &Path, is_ele: bool) -> PathBuf {
    let extension = if is_ele { "node" } else { "ele" };
    let capitals = path.extension().and_then(|e| e.to_str()).is_some_and(|e| e.bytes().all(|b| b.is_ascii_uppercase()));
    path.with_extension(if capitals { extension.to_ascii_uppercase() } else { extension.to_owned() })
}

/// Opens a file, or standard input for `-`; nothing is read yet.
pub(super) fn open<'a>(path: &Path, source: &'a str) -> Result<Blocks<'a>, ReadError> {
    if is_stdin(path) {
        return Ok(Blocks::pieces(Origin::Once(Box::new(std::io::stdin().lock())), source, None));
    }
    if path.is_dir() {
        let problem = ReadProblem::Io { reason: "it is a directory".to_owned() };
        return Err(ReadError::whole(source, problem, "give a file in it"));
    }
    let file = File::open(path).map_err(|error| {
        ReadError::whole(source, ReadProblem::Io { reason: error.to_string() }, "check the name of the file")
    })?;
    // Files that are made while they are read have no length.
    let length = file.metadata().ok().filter(|data| data.is_file() && data.len() > 0).map(|data| data.len());
    let origin = if length.is_some() { Origin::Again(Box::new(file)) } else { Origin::Once(Box::new(file)) };
    Ok(Blocks::pieces(origin, source, length.map(|length| usize::try_from(length).unwrap_or(usize::MAX))))
}

/// All bytes, but not more than a file may have.
fn load_path(path: &Path) -> Result<Vec<u8>, ReadError> {
    open(path, &source_name(path))?.into_whole()
}

/// Turns y upwards, if the file has it downwards.
fn turned(mut read: Read, options: &ReadOptions) -> Read {
    if options.y_down || read.format == Format::Map {
        // 0 - y, so that 0 stays 0 and does not become -0.
        match &mut read.document {
            Document::Polygons(soup) => {
                soup.places.y_down = true;
                soup.points.iter_mut().for_each(|p| p[1] = 0.0 - p[1]);
            }
            Document::Segments(soup) => {
                soup.points.iter_mut().chain(&mut soup.hole_points).for_each(|p| p.y = 0.0 - p.y);
            }
            Document::Columns(table) => table.positions_mut().for_each(|p| p[1] = 0.0 - p[1]),
            Document::Table(table) => {
                let rows = table.vertices.iter_mut().flatten();
                rows.filter_map(|row| row.position.as_mut()).for_each(|p| p[1] = 0.0 - p[1]);
            }
        }
    }
    read
}
