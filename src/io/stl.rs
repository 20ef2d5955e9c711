//! STL: triangles by their coordinates, nothing shared.
//!
//! ```text
//!   solid cube                      text: normals are read over, and so are names
//!   facet normal 0 0 -1
//!     outer loop
//!       vertex 0 0 0
//!       vertex 0 1 0                 binary: 80 bytes of anything, the number of triangles (u32), and for each
//!       vertex 1 1 0                 twelve singles (normal, three corners) and two bytes of anything
//!     endloop
//!   endfacet
//!   ...
//!   endsolid cube
//! ```
//!
//! Corners with equal coordinates become one point: exactly equal, with -0 = 0, and nothing else. Triangles with two
//! equal corners are left out, with a note: their other two edges are one, and the triangles behind them meet there.
//! A file is binary if its length is what the count says, whatever its first word; another length is noted, or refused if
//! triangles are missing, where the first word is not `solid` or a byte of the file is zero, which no text has.
//!
//! Written as text, or as binary in single precision: then each coordinate is rounded to the nearest single, and
//! a structure in which two points become one, or a triangle is flat or turned over then, is refused, for it would come
//! back as another one, or not at all. Faces with more corners are cut into triangles from their first corner; faces for
//! which that is wrong, because they are not convex, are refused.
//!
//! Source: 3D Systems, *StereoLithography Interface Specification*, 1988.

use super::document::{Document, Read};
use super::format::Format;
use super::model::{Model, Polygons};
use super::problem::{ReadError, ReadProblem};
use super::room::reserved;
use super::soup::SoupBuilder;
use super::text::{Scanner, Syntax};
use super::words::{at_most, counted, note};
use super::write_error::WriteError;
use crate::geometry::equal::first_of_equals;
use crate::geometry::number::Number;
use crate::plane::predicates::orientation;
use crate::plane::{Point, check_coordinate};
use crate::progress::Stage;
use crate::solid::vector::{dot, normal, plus};
use crate::topology::PolygonList;
use std::cmp::Ordering;
use std::io::Write;

const SYNTAX: Syntax = Syntax { comments: false, continuation: false, quotes: false, separators: false };
/// Bytes before the first triangle of a binary file.
const HEAD: usize = 84;
/// Bytes of a triangle.
const TRIANGLE: usize = 50;

/// Whether the length of a file is that of a binary STL file with its count.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    length_of_binary(bytes) == Some(bytes.len() as u64)
}

/// How long a file is if it is a binary STL file that starts like this.
pub(super) fn length_of_binary(start: &[u8]) -> Option<u64> {
    let count = start.get(HEAD - 4..).and_then(<[u8]>::first_chunk).map(|count| u32::from_le_bytes(*count));
    count.map(|count| HEAD as u64 + u64::from(count) * TRIANGLE as u64)
}

/// Reads an STL file, text or binary. O(n log n), for finding equal corners.
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    let starts_solid = bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    let mut notes = Vec::new();
    // A binary file may begin with that word, too; text holds no zeros.
    let is_text = bytes.len() < HEAD || starts_solid && !is_binary(bytes) && !bytes.contains(&0);
    let corners = if is_text { text(bytes, source)? } else { binary(whole(bytes, source, &mut notes)?, source)? };
    let soup = join(&corners, &mut notes).finish(source, true)?;
    Ok(Read { document: Document::Polygons(soup), notes, format: Format::Stl })
}

/// A binary file up to the end of its triangles. Notes more than its count says: whole triangles are taken, other bytes
/// are not.
///
/// # Errors
/// If there are fewer triangles than it says.
fn whole<'a>(bytes: &'a [u8], source: &str, notes: &mut Vec<String>) -> Result<&'a [u8], ReadError> {
    let said = length_of_binary(bytes).map_or(0, |length| ((length - HEAD as u64) / TRIANGLE as u64) as usize);
    let (there, rest) = ((bytes.len() - HEAD) / TRIANGLE, (bytes.len() - HEAD) % TRIANGLE);
    if there < said {
        let bytes = bytes.len();
        let inside = format!("triangle {there} of {said}, counted from 0: {bytes} bytes are not what the count says");
        let help = "the file was cut off, or is no STL file: get it again";
        let offset = Some((HEAD + there * TRIANGLE) as u64);
        return Err(ReadError { offset, ..ReadError::whole(source, ReadProblem::Truncated { inside }, help) });
    }
    if rest > 0 {
        let left_out = counted(bytes.len() - HEAD - said * TRIANGLE, "byte was", "bytes were");
        notes.push(format!("{left_out} left out behind {}", counted(said, "counted triangle", "counted triangles")));
        return Ok(&bytes[..HEAD + said * TRIANGLE]);
    }
    if there > said {
        let says = counted(said, "triangle", "triangles");
        notes.push(format!("the file counts {says} and holds {there}: all were read"));
    }
    Ok(bytes)
}

/// Three corners for each triangle, each with its line; 0 where lines mean nothing.
type Corners = Vec<([f64; 3], u32)>;

fn text(bytes: &[u8], source: &str) -> Result<Corners, ReadError> {
    let mut scanner = Scanner::new(bytes, source, SYNTAX)?;
    expect(&mut scanner, "solid")?;
    scanner.rest_of_line();
    let mut corners = Vec::new();
    loop {
        let word = scanner.need_anywhere(|| "`facet` or `endsolid`".to_owned())?;
        if word.text.eq_ignore_ascii_case(b"endsolid") {
            scanner.rest_of_line();
            // Some programs write several solids into a file.
            match scanner.word_anywhere() {
                None => return Ok(corners),
                Some(next) if next.text.eq_ignore_ascii_case(b"solid") => {
                    scanner.rest_of_line();
                    continue;
                }
                Some(next) => return Err(scanner.expected(next, "`solid` or the end of the file", "")),
            }
        }
        if !word.text.eq_ignore_ascii_case(b"facet") {
            return Err(scanner.expected(word, "`facet` or `endsolid`", ""));
        }
        scanner.rest_of_line();
        expect(&mut scanner, "outer")?;
        expect(&mut scanner, "loop")?;
        for _ in 0..3 {
            expect(&mut scanner, "vertex")?;
            let line = scanner.line();
            let mut point = [0.0; 3];
            for (value, axis) in point.iter_mut().zip(['x', 'y', 'z']) {
                *value = scanner.need_coordinate(axis, || "a vertex".to_owned())?;
            }
            corners.push((point, line));
        }
        expect(&mut scanner, "endloop")?;
        expect(&mut scanner, "endfacet")?;
    }
}

fn expect(scanner: &mut Scanner<'_>, wanted: &'static str) -> Result<(), ReadError> {
    let word = scanner.need_anywhere(|| format!("`{wanted}`"))?;
    if word.text.eq_ignore_ascii_case(wanted.as_bytes()) {
        return Ok(());
    }
    Err(scanner.expected(word, format!("`{wanted}`"), "STL holds triangles only"))
}

fn binary(bytes: &[u8], source: &str) -> Result<Corners, ReadError> {
    let mut corners = reserved(bytes.len() / TRIANGLE * 3, source)?;
    let stage = Stage::new("reading", bytes.len() / TRIANGLE);
    for (i, triangle) in bytes[HEAD..].chunks_exact(TRIANGLE).enumerate() {
        stage.at(i);
        for k in 0..3 {
            let mut point = [0.0; 3];
            for (axis, value) in point.iter_mut().enumerate() {
                let at = 12 + 12 * k + 4 * axis;
                let single = triangle[at..].first_chunk().map_or(f32::NAN, |bytes| f32::from_le_bytes(*bytes));
                *value = f64::from(single);
                check_coordinate(['x', 'y', 'z'][axis], *value).map_err(|error| ReadError {
                    offset: Some((HEAD + i * TRIANGLE + at) as u64),
                    ..ReadError::whole(source, error.into(), "")
                })?;
            }
            corners.push((point, 0));
        }
    }
    Ok(corners)
}

/// Joins equal corners; points are numbered in the order in which they first come.
fn join(corners: &[([f64; 3], u32)], notes: &mut Vec<String>) -> SoupBuilder {
    // -0 + 0 = 0: the two zeros are one coordinate.
    let points: Vec<[f64; 3]> = corners.iter().map(|(point, _)| point.map(|x| x + 0.0)).collect();
    let same_as = first_of_equals(&points);
    let mut numbers = vec![u32::MAX; points.len()];
    let mut soup = SoupBuilder::default();
    let mut left_out = 0;
    let has_lines = corners.first().is_some_and(|&(_, line)| line > 0);
    for (start, triangle) in (0..).step_by(3).zip(same_as.chunks_exact(3)) {
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
        if a == b || b == c || c == a {
            left_out += 1;
            continue;
        }
        let mut face = [0; 3];
        for (k, &same) in triangle.iter().enumerate() {
            if numbers[same as usize] == u32::MAX {
                numbers[same as usize] = soup.points.len() as u32;
                soup.points.push(points[same as usize]);
                soup.vertex_lines.extend(has_lines.then_some(corners[start + k].1));
            }
            face[k] = numbers[same as usize];
        }
        soup.faces.push_face(&face);
        soup.face_lines.extend(has_lines.then_some(corners[start].1));
    }
    let (one, many) = ("triangle with two equal corners was", "triangles with two equal corners were");
    note(notes, left_out, one, many, " left out");
    soup
}

/// Refuses faces that do not fall into triangles from their first corner.
fn check_fans(polygons: &Polygons) -> Result<(), WriteError> {
    let at = |corner: u32| polygons.points[corner as usize];
    for (&face, cycle) in polygons.faces.iter().zip(polygons.list.outer_cycles()) {
        if cycle.len() > 3 && !is_fan(cycle, at) {
            return Err(WriteError::NoFan { face, format: Format::Stl.name() });
        }
    }
    Ok(())
}

/// Whether all triangles from the first corner face the same way: in the plane z = 0 exactly, elsewhere by their normals.
fn is_fan(cycle: &[u32], at: impl Fn(u32) -> [f64; 3]) -> bool {
    if cycle.iter().all(|&corner| at(corner)[2].abs() <= 0.0) {
        let sides = |t: [u32; 3]| {
            let [a, b, c] = t.map(|corner| Point::new(at(corner)[0], at(corner)[1]));
            orientation(a, b, c)
        };
        return [Ordering::Greater, Ordering::Less].iter().any(|side| fans(cycle).all(|t| sides(t) == *side));
    }
    let normal_of = |t: [u32; 3]| normal(t.map(&at));
    let whole = fans(cycle).map(normal_of).fold([0.0; 3], plus);
    fans(cycle).all(|t| dot(normal_of(t), whole) > 0.0)
}

/// The corners of each triangle and its unit normal; a normal of 0 if it has no area.
fn facets<'a>(list: &'a PolygonList, points: &'a [[f64; 3]]) -> impl Iterator<Item = [[f64; 3]; 4]> + 'a {
    list.outer_cycles().flat_map(fans).map(move |triangle| {
        let [a, b, c] = triangle.map(|corner| points[corner as usize]);
        let normal = normal([a, b, c]);
        let size = dot(normal, normal).sqrt();
        // + 0.0, so that no normal is written as -0.
        [normal.map(|x| if size > 0.0 { x / size + 0.0 } else { 0.0 }), a, b, c]
    })
}

/// Writes the polygons as text.
pub(super) fn write(out: &mut impl Write, polygons: &Polygons) -> Result<(), WriteError> {
    check_fans(polygons)?;
    writeln!(out, "solid")?;
    for [normal, corners @ ..] in facets(&polygons.list, &polygons.points) {
        let [x, y, z] = normal.map(Number);
        writeln!(out, "facet normal {x} {y} {z}\n  outer loop")?;
        for [x, y, z] in corners.map(|point| point.map(Number)) {
            writeln!(out, "    vertex {x} {y} {z}")?;
        }
        writeln!(out, "  endloop\nendfacet")?;
    }
    Ok(writeln!(out, "endsolid")?)
}

/// Writes the polygons as binary, each coordinate as the nearest single. O(n log n), for finding equal points.
pub(super) fn write_binary(out: &mut impl Write, polygons: &Polygons) -> Result<(), WriteError> {
    check_fans(polygons)?;
    for (&face, cycle) in polygons.faces.iter().zip(polygons.list.outer_cycles()) {
        let coordinates = cycle.iter().flat_map(|&corner| polygons.points[corner as usize]);
        if let Some(coordinate) = { coordinates }.find(|&x| !(x as f32).is_finite()) {
            return Err(WriteError::TooLarge { face, coordinate });
        }
    }
    let singles: Vec<[f64; 3]> = polygons.points.iter().map(|p| p.map(|x| f64::from(x as f32) + 0.0)).collect();
    for (&point, same) in polygons.points.iter().zip(first_of_equals(&singles)) {
        let other = polygons.points[same as usize];
        if other.partial_cmp(&point) != Some(Ordering::Equal) {
            return Err(WriteError::TooClose { points: [other, point] });
        }
    }
    for (&face, cycle) in polygons.faces.iter().zip(polygons.list.outer_cycles()) {
        let [given, rounded] = [&polygons.points, &singles]
            .map(|points| fans(cycle).map(|triangle| normal(triangle.map(|corner| points[corner as usize]))));
        if given.zip(rounded).any(|(given, rounded)| dot(given, rounded) <= 0.0) {
            return Err(WriteError::Folded { face });
        }
    }
    let count: usize = polygons.list.outer_cycles().map(|cycle| cycle.len() - 2).sum();
    let mut head = [0; HEAD];
    head[..HEAD - 4].fill(b' ');
    // A count beyond 32 bits does not fit into ids either.
    head[HEAD - 4..].copy_from_slice(&(count as u32).to_le_bytes());
    out.write_all(&head)?;
    for facet in facets(&polygons.list, &singles) {
        for value in facet.as_flattened() {
            out.write_all(&(*value as f32).to_le_bytes())?;
        }
        out.write_all(&[0; 2])?;
    }
    Ok(())
}

/// What a format rounds of the positions of a model, in a sentence: binary STL holds them in single precision. O(V).
#[must_use]
pub fn rounding(model: &Model<'_>, format: Format) -> Option<String> {
    if format != Format::StlBinary {
        return None;
    }
    let off = |x: f64| (f64::from(x as f32) - x).abs();
    let offs = model.vertices().filter_map(|v| model.position(v)).map(|p| p.map(off).into_iter().fold(0.0, f64::max));
    let (mut count, mut most) = (0, 0.0_f64);
    offs.filter(|&off| off > 0.0).for_each(|off| (count, most) = (count + 1, most.max(off)));
    let points = counted(count, "point was", "points were");
    let told = || format!("{points} rounded to single precision, none further than {} in x, y or z", at_most(most));
    (count > 0).then(told)
}

/// The triangles from the first corner of a cycle.
fn fans(cycle: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    cycle[1..].windows(2).map(|pair| [cycle[0], pair[0], pair[1]])
}
