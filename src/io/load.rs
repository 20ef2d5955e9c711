//! From a file to a structure: reading, building, and where in the file the things stand that do not fit.
//!
//! ```text
//!   read_path ──┬─ polygons, flat ──────> Subdivision ──┐
//!               ├─ polygons in space ───> Polyhedron  ──┤
//!               ├─ segments ────────────> Subdivision ──┼─> Loaded: structure, names, notes
//!               └─ table ───────────────> Subdivision ──┘
//!
//!   mesh.obj:17: faces 3 and 5 both run from vertex 2 to vertex 4: reverse one of them (face 5: line 19)
//!   └─ where ──┘ └─ what the builder says, counted from 0 ───────────────────────────┘ └─ the others ──┘
//! ```

use super::arrange::{arrange, describe, is_as_given};
use super::document::{Document, Read, ReadOptions};
use super::format::Format;
use super::left_out::LeftOut;
use super::load_error::{LoadError, Whereabouts};
use super::mend::{Covering, MendedSoup, mend};
use super::misfit::{Misfit, Told};
use super::read::{read_path, source_name};
use super::room::{for_corners, for_half_edges, for_segments};
use super::soup::{Places, PolygonSoup};
use super::words::counted;
use crate::ids::{FaceId, FaceMap, VertexId};
use crate::plane::{ConvertError, ConvertOptions, Converted, Point, Subdivision};
use crate::solid::Polyhedron;
use crate::topology::{BuildError, Mode, PolygonList, View};
use std::path::Path;

/// What is told where there was nothing to mend.
pub const NOTHING_TO_MEND: &str = "nothing to mend";

/// How to load a file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct LoadOptions {
    /// How to read it.
    pub read: ReadOptions,
    /// Turn round the faces of a plane that run clockwise, and those of a surface that are wound against the rest.
    /// GeoJSON, TopoJSON and well-known text are always treated so: their rings may run either way.
    pub orient: bool,
    /// Split segments where they meet, and polygons of the plane that overlap, touch or cross, instead of refusing
    /// them; see [`Subdivision::arrange_graph`] and [`Subdivision::mend_polygons`]. The notes say what was done,
    /// also if there was nothing to do.
    pub mend: bool,
    /// In the plane, believe polygons that share no edge and no vertex that they do not overlap. Without it all edges
    /// are checked against each other.
    pub trust: bool,
    /// Plane or surface, whatever the file looks like. Without it, points with different z make a surface.
    pub mode: Option<Mode>,
}

/// A structure out of a file.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum Structure {
    /// A subdivision of the plane.
    Plane(Subdivision),
    /// A surface in space.
    Surface(Polyhedron),
}

/// What was loaded.
#[derive(Clone, PartialEq, Debug)]
pub struct Loaded {
    /// The structure. In the plane face i of the file is f(i + 1), on a surface f(i); vertex i is v(i). Tables
    /// keep their numbers as [`Subdivision::from_table`] says; for segments see [`Subdivision::arrange_graph`].
    pub structure: Structure,
    /// The names of the faces; shorter than the structure, or empty, where no more are known.
    pub names: FaceMap<Option<String>>,
    /// Which polygons cover each face, if the polygons had to be mended.
    pub covering: Option<Covering>,
    /// What was dropped, repaired or chosen, one sentence each: for the user.
    pub notes: Vec<String>,
    /// What the file says of its polygons and is not in the structure; writing another file loses it.
    pub left_out: LeftOut,
    /// The format it was.
    pub format: Format,
    /// Where the points and faces stood; nothing for tables.
    pub places: Option<Places>,
}

/// Reads a file and makes a structure of it; `-` is standard input.
///
/// Cost: that of the reader and of the builder, about linear; O(n log n) for tables and for the full check.
///
/// # Errors
/// [`LoadError`] with the places of what does not fit.
pub fn load(path: &Path, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let columns = ReadOptions { columns: true, ..options.read.clone() };
    assemble(read_path(path, &columns)?, &source_name(path), options)
}

/// Makes a structure of what was read. `source_name` is what errors call the file of a table.
///
/// # Errors
/// [`LoadError`]; [`LoadError::Read`] only if there is not enough memory.
///
/// ```
/// use dcel_kit::io::{Format, LoadOptions, ReadOptions, assemble, read_bytes};
/// let text = "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\nf 1 2 3\n";
/// let read = read_bytes(text.as_bytes(), Format::Obj, "twice.obj", &ReadOptions::default())?;
/// let error = assemble(read, "twice.obj", &LoadOptions::default()).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "twice.obj:4: face 1 repeats face 0: leave one of them out (face 1: line 5)",
/// );
/// # Ok::<(), dcel_kit::io::ReadError>(())
/// ```
pub fn assemble(read: Read, source_name: &str, options: &LoadOptions) -> Result<Loaded, LoadError> {
    match &read.document {
        Document::Polygons(soup) => for_corners(soup.faces.corner_count(), source_name),
        Document::Segments(soup) => for_segments(soup.segments.len(), source_name),
        Document::Table(table) => for_half_edges(table.half_edges.len(), source_name),
        Document::Columns(table) => for_half_edges(table.half_edge_bound(), source_name),
    }?;
    let Read { document, mut notes, format } = read;
    let in_file = |error| LoadError::Table { source_name: source_name.to_owned(), error };
    let (subdivision, names) = match document {
        Document::Polygons(soup) => return polygons(soup, options, notes, format),
        Document::Segments(soup) => {
            let arranged = arrange(&soup, options.mend)?;
            notes.extend(describe(&arranged));
            if options.mend && is_as_given(&arranged) && soup.mended_rings == 0 {
                notes.push(NOTHING_TO_MEND.to_owned());
            }
            (arranged.subdivision, FaceMap::default())
        }
        Document::Columns(mut table) => {
            let names = table.names_in_plane();
            (Subdivision::from_columns(&mut table).map_err(in_file)?, names)
        }
        Document::Table(table) => {
            let subdivision = Subdivision::from_table(&table).map_err(in_file)?;
            // The outer face is f0 now; see Subdivision::from_table.
            let mut names: Vec<_> = table.faces.into_iter().map(|row| row?.name).collect();
            if let Some(outer) = table.outer_face {
                names.swap(0, outer.index());
            }
            (subdivision, names.into())
        }
    };
    let (structure, left_out) = (Structure::Plane(subdivision), LeftOut::default());
    Ok(Loaded { structure, names, covering: None, notes, left_out, format, places: None })
}

/// A subdivision or a surface of polygons.
fn polygons(
    soup: PolygonSoup,
    options: &LoadOptions,
    mut notes: Vec<String>,
    format: Format,
) -> Result<Loaded, LoadError> {
    let mode = options.mode.unwrap_or(if soup.has_z { Mode::Surface } else { Mode::Plane });
    if mode == Mode::Plane {
        return plane(soup, options, notes, format);
    }
    let PolygonSoup { points, faces, names, places, left_out, .. } = soup;
    let structure = surface(points, faces, &places, options, &mut notes)?;
    let names = named(names, 0);
    Ok(Loaded { structure, names, covering: None, notes, left_out, format, places: Some(places) })
}

/// The names of faces, of which the first one has the number `first`.
fn named(names: Vec<Option<String>>, first: u32) -> FaceMap<Option<String>> {
    let mut by_face = FaceMap::default();
    for (i, name) in names.into_iter().enumerate().filter(|(_, name)| name.is_some()) {
        by_face.set(FaceId::new(i as u32 + first), name, None);
    }
    by_face
}

fn plane(
    soup: PolygonSoup,
    options: &LoadOptions,
    mut notes: Vec<String>,
    format: Format,
) -> Result<Loaded, LoadError> {
    let PolygonSoup { points, has_z, faces, names, places, blocked, any_direction, mended_rings, left_out, .. } = soup;
    if has_z {
        notes.push("the z of the points was dropped".to_owned());
    }
    // What was read of a large file stands once: these are the places of the vertices if all is well.
    let mut points: Vec<Point> = points.into_iter().map(|[x, y, _]| Point::new(x, y)).collect();
    points.shrink_to_fit();
    let convert = ConvertOptions {
        orient: options.orient || any_direction,
        full_check: !options.trust,
        // Formats with coordinates only cannot say that a vertex is to be part of a side.
        insert_touching: (any_direction || options.mend) && !options.trust,
    };
    let converted = Subdivision::convert_taking(&mut points, &faces, &convert);
    let Converted { mut subdivision, turned, unused_vertices, inserted } = match converted {
        Ok(converted) => converted,
        Err(error) if options.mend && can_be_mended(&error) => {
            let told = Told { points: &points, faces: &faces, places: &places };
            let MendedSoup { subdivision, names, covering, notes: told } = mend(&told, names, &blocked)?;
            notes.extend(told);
            let (structure, covering) = (Structure::Plane(subdivision), Some(covering));
            return Ok(Loaded { structure, names, covering, notes, left_out, format, places: None });
        }
        Err(error) => {
            let told = Told { points: &points, faces: &faces, places: &places };
            let Misfit { what, rings } = told.misfit(&error, convert.full_check);
            let at = Box::new(Whereabouts::of_misfit(&told, &error, &rings));
            return Err(LoadError::Plane { at, error, what });
        }
    };
    if !any_direction && !turned.is_empty() {
        let of = counted(faces.face_count(), "face", "faces");
        let were = if turned.len() == 1 { "was" } else { "were" };
        notes.push(format!("{} of {of} ran clockwise and {were} turned round", turned.len()));
    }
    note_unused(&mut notes, &unused_vertices);
    if let Some(first) = inserted.first() {
        let count = counted(inserted.len(), "corner was inserted", "corners were inserted");
        let told = Told { points: subdivision.points_by_number(), faces: &faces, places: &places };
        notes.push(format!("{count} where vertices lie inside sides, the first {}", told.inserted(first)));
    }
    if options.mend && inserted.is_empty() && mended_rings == 0 {
        notes.push(NOTHING_TO_MEND.to_owned());
    }
    for &face in &blocked {
        subdivision.set_hole(FaceId::new(face + 1), true);
    }
    let structure = Structure::Plane(subdivision);
    let names = named(names, 1);
    Ok(Loaded { structure, names, covering: None, notes, left_out, format, places: Some(places) })
}

/// Whether the polygons can be split so that they fit together.
fn can_be_mended(error: &ConvertError) -> bool {
    !matches!(
        error,
        ConvertError::Coordinate { .. }
            | ConvertError::Build(BuildError::IndexOutOfRange { .. } | BuildError::TooMany(_))
            | ConvertError::Clockwise { .. }
    )
}

fn surface(
    points: Vec<[f64; 3]>,
    faces: PolygonList,
    places: &Places,
    options: &LoadOptions,
    notes: &mut Vec<String>,
) -> Result<Structure, LoadError> {
    let (bound, count) = (points.len() as u32, faces.face_count());
    let built = match options.orient {
        true => Polyhedron::from_polygons_oriented(points, faces),
        false => Polyhedron::from_polygons(points, &faces).map(|polyhedron| (polyhedron, Vec::new())),
    };
    let (polyhedron, turned) = built.map_err(|error| {
        let at = Whereabouts::new(places, &error.faces(), &error.vertices());
        LoadError::Surface { at: Box::new(at), error }
    })?;
    if !turned.is_empty() {
        let of = counted(count, "face", "faces");
        let were = if turned.len() == 1 { "was" } else { "were" };
        notes.push(format!("{} of {of} {were} wound against the rest and turned round", turned.len()));
    }
    let unused: Vec<_> = (0..bound).map(VertexId::new).filter(|&v| !polyhedron.has_vertex(v)).collect();
    note_unused(notes, &unused);
    Ok(Structure::Surface(polyhedron))
}

fn note_unused(notes: &mut Vec<String>, unused: &[VertexId]) {
    if let Some(first) = unused.first() {
        let count = unused.len();
        notes.push(match count {
            1 => format!("{first} was left out: no face uses it"),
            _ => format!("{count} vertices were left out, {first} the first of them: no face uses them"),
        });
    }
}
