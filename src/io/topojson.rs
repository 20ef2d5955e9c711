//! TopoJSON: polygons whose borders are stored once, as arcs.
//!
//! ```text
//!   {"type": "Topology",
//!    "transform": {"scale": [2, 2], "translate": [10, 0]},
//!    "objects": {"states": {"type": "GeometryCollection", "geometries": [
//!      {"type": "Polygon", "arcs": [[0, -3]], "properties": {"name": "Ohio"}}, ...]}},
//!    "arcs": [[[0, 0], [1, 0], [0, 2]], ...]}
//!                 each position is the step from the one before; times scale, plus translate
//! ```
//!
//! A ring is a chain of arcs; -1 - i stands for arc i backwards. Two polygons that use the same arc share its
//! points exactly, and points of different arcs are joined where they come out equal.
//!
//! A file may hold several objects (`states`, `nation`). Without a choice the one with the most polygons is
//! read, of those without polygons the one with the most lines, then points, and a note says so. Lines and points beside polygons are skipped with a note; an object without polygons is
//! read as segments and points, and on request every object is, polygons by their outlines. Which way y points is not
//! written down: maps for the screen have it downwards, see [`ReadOptions::y_down`].
//!
//! Source: M. Bostock and C. Metcalf, *The TopoJSON Format Specification* (version 1).

use super::arrays::Arrays;
use super::document::ReadOptions;
use super::geojson::Shapes;
use super::geometries::{Skipped, polygons};
use super::nodes::{Fault, Node, Place, lacks, named, one_line, shape};
use super::problem::ReadProblem;
use super::rings::{Rings, same};
use super::soup::SegmentSoup;
use super::text::LineCounter;
use super::words::counted;
use crate::plane::check_coordinate;
use crate::progress::Stage;
use serde_json::value::RawValue;
use std::collections::BTreeMap;
use std::fmt::{self, Display};

/// Arcs may be used this often on average; a map uses each of them once or twice. Without a limit a small file
/// could ask for any amount of memory.
const REUSE: usize = 64;

/// The arcs in one flat list.
struct Arcs {
    points: Vec<[f64; 2]>,
    ends: Vec<usize>,
    transform: Option<Transform>,
}

/// From whole numbers to coordinates.
#[derive(Clone, Copy)]
struct Transform {
    scale: [f64; 2],
    translate: [f64; 2],
}

impl Transform {
    fn of(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Self { scale, translate } = self;
        [x * scale[0] + translate[0], y * scale[1] + translate[1]]
    }
}

/// Reads one object of a topology; `file` is the text it is a part of.
pub(super) fn read(
    root: &Node<'_>,
    file: &str,
    source: &str,
    options: &ReadOptions,
    notes: &mut Vec<String>,
) -> Result<Shapes, Fault> {
    let arcs = Arcs::read(root, file)?;
    let objects = root.objects.as_ref().ok_or_else(|| shape("the file", "an object \"objects\""))?;
    let (name, object) = choose(objects, file, options.object.as_deref(), notes)?;
    let segments = options.outlines || matches!(Contents::of(object, file), Contents { polygons: 0, lines: 1.., .. });
    let mut reader = Reader {
        file,
        arcs: &arcs,
        rings: Rings::default(),
        skipped: Skipped::default(),
        chains: segments.then(Rings::default),
        single: Vec::new(),
    };
    if options.close_rings {
        reader.rings.close_rings();
    }
    match &object.geometries {
        Some(geometries) => {
            for (i, geometry) in geometries.iter().enumerate() {
                reader.geometry(geometry, &format!("{}[{i}]", one_line(name)), None)?;
            }
        }
        None => reader.geometry(object, &one_line(name), None)?,
    }
    reader.skipped.note(notes);
    let Some(chains) = reader.chains else { return Ok(Shapes::Rings(reader.rings)) };
    reader.rings.closed().note_closed(notes);
    let (mut soup, mut lines) = (SegmentSoup::new(source), LineCounter::new(file));
    soup.mended_rings = reader.rings.closed().count();
    reader.rings.outlines(true, &mut lines, &mut soup);
    chains.outlines(false, &mut lines, &mut soup);
    for (point, offset) in reader.single {
        soup.point(point, lines.line(offset));
    }
    Ok(Shapes::Segments(soup))
}

/// What an object holds, counted. The order is that of preference.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
struct Contents {
    polygons: usize,
    lines: usize,
    points: usize,
}

impl Contents {
    fn of(node: &Node<'_>, file: &str) -> Self {
        // What has the wrong shape counts as nothing here and is named when it is read.
        let wrong = || shape("", "");
        let arc = |arrays: &mut Arrays<'_>, _| number(arrays, wrong).map(drop);
        let list = |arrays: &mut Arrays<'_>| arrays.each(wrong, arc);
        let lists = |arrays: &mut Arrays<'_>| arrays.each(wrong, |arrays, _| list(arrays));
        let position = |arrays: &mut Arrays<'_>| arrays.position().map(drop).ok_or_else(|| Fault::from(wrong()));
        match node.kind().as_deref() {
            Some("Polygon") => Self { polygons: 1, ..Self::default() },
            Some("LineString") => Self { lines: 1, ..Self::default() },
            Some("Point") => Self { points: 1, ..Self::default() },
            Some("MultiPolygon") => Self { polygons: items(node.arcs, file, lists), ..Self::default() },
            Some("MultiLineString") => Self { lines: items(node.arcs, file, list), ..Self::default() },
            Some("MultiPoint") => Self { points: items(node.coordinates, file, position), ..Self::default() },
            Some("GeometryCollection") => {
                let parts = node.geometries.iter().flatten().map(|part| Self::of(part, file));
                parts.fold(Self::default(), |sum, part| Self {
                    polygons: sum.polygons + part.polygons,
                    lines: sum.lines + part.lines,
                    points: sum.points + part.points,
                })
            }
            _ => Self::default(),
        }
    }

    fn is_empty(self) -> bool {
        self == Self::default()
    }
}

impl Display for Contents {
    /// `2 polygons, 1 line`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds =
            [(self.polygons, "polygon", "polygons"), (self.lines, "line", "lines"), (self.points, "point", "points")];
        let there = kinds.into_iter().filter(|kind| kind.0 > 0 || self.is_empty() && kind.1 == "polygon");
        let words: Vec<String> = there.map(|(count, one, many)| counted(count, one, many)).collect();
        f.write_str(&words.join(", "))
    }
}

/// How many items an array has.
fn items(value: Option<&RawValue>, file: &str, item: impl Fn(&mut Arrays<'_>) -> Result<(), Fault>) -> usize {
    let mut count = 0;
    let count_one = |arrays: &mut Arrays<'_>, _| {
        count += 1;
        item(arrays)
    };
    // Of an array that goes wrong the items before that count.
    drop(value.map(|value| Arrays::new(value, file).each(|| shape("", ""), count_one)));
    count
}

/// The object that was asked for, or the one with the most polygons; if there is none, with the most lines, then points.
fn choose<'o, 'a>(
    objects: &'o BTreeMap<String, Node<'a>>,
    file: &str,
    wanted: Option<&str>,
    notes: &mut Vec<String>,
) -> Result<(&'o str, &'o Node<'a>), Fault> {
    let all: Vec<(&str, &Node<'_>, Contents)> =
        objects.iter().map(|(name, object)| (name.as_str(), object, Contents::of(object, file))).collect();
    let list = || all.iter().map(|(name, _, holds)| format!("{name} ({holds})")).collect::<Vec<_>>().join(", ");
    if let Some(wanted) = wanted {
        let found = all.iter().find(|(name, ..)| *name == wanted);
        return found.map(|&(name, object, _)| (name, object)).ok_or_else(|| Fault {
            help: format!("the file has {}", list()).into(),
            ..shape(&format!("object {wanted:?}"), "one of the objects of the file").into()
        });
    }
    // Of equals the first one: `rev`, because max_by_key takes the last.
    let best = all.iter().rev().max_by_key(|(_, _, holds)| *holds);
    let &(name, object, _) = best.ok_or_else(|| shape("the file", "at least one object"))?;
    if all.iter().filter(|(_, _, holds)| !holds.is_empty()).count() > 1 {
        notes.push(format!("the file has the objects {}; {name} was read (choose with --object)", list()));
    }
    Ok((name, object))
}

fn number(arrays: &mut Arrays<'_>, wrong: impl FnOnce() -> ReadProblem) -> Result<i64, Fault> {
    let at = arrays.offset();
    arrays.integer().ok_or_else(|| Fault::at(at, wrong()))
}

impl Arcs {
    /// Reads all arcs and brings their points to their final coordinates.
    fn read(root: &Node<'_>, file: &str) -> Result<Self, Fault> {
        let read = |of: &super::nodes::Transform<'_>| -> Result<Transform, Fault> {
            Ok(Transform { scale: pair(of.scale, file)?, translate: pair(of.translate, file)? })
        };
        let transform = root.transform.as_deref().map(read).transpose()?;
        let mut arcs = Self { points: Vec::new(), ends: Vec::new(), transform };
        let stage = Stage::new("reading", file.len());
        let value = root.arcs.ok_or_else(|| lacks("the file", "arcs"))?;
        Arrays::new(value, file).each(
            || lacks("the file", "arcs"),
            |arrays, i| {
                let mut at = [0.0; 2];
                arrays.each(
                    || shape(&format!("arcs[{i}]"), "an array of positions"),
                    |arrays, k| {
                        let offset = arrays.offset();
                        let wrong = || shape(&format!("arcs[{i}] position {k}"), "a position [x, y] of numbers");
                        let ([x, y], _) = arrays.position().ok_or_else(|| Fault::at(offset, wrong()))?;
                        arcs.points.push(match transform {
                            None => [x, y],
                            Some(transform) => {
                                at = [at[0] + x, at[1] + y];
                                transform.of(at)
                            }
                        });
                        Ok(())
                    },
                )?;
                arcs.ends.push(arcs.points.len());
                stage.set(arrays.offset());
                Ok(())
            },
        )?;
        Ok(arcs)
    }

    /// The points of arc `i`.
    fn get(&self, i: usize) -> Option<&[[f64; 2]]> {
        let start = i.checked_sub(1).map_or(Some(0), |before| self.ends.get(before).copied())?;
        self.points.get(start..*self.ends.get(i)?)
    }
}

/// One of the two members of the transform.
fn pair(value: Option<&RawValue>, file: &str) -> Result<[f64; 2], Fault> {
    let pair = value.and_then(|value| Some(Arrays::new(value, file).position()?.0));
    pair.ok_or_else(|| shape("transform", "\"scale\" and \"translate\", two numbers each").into())
}

struct Reader<'a> {
    file: &'a str,
    arcs: &'a Arcs,
    rings: Rings,
    skipped: Skipped,
    /// Takes the lines, if the file is read as segments.
    chains: Option<Rings>,
    /// Single points with their bytes in the file, if it is.
    single: Vec<([f64; 2], usize)>,
}

impl Reader<'_> {
    fn geometry(&mut self, geometry: &Node<'_>, path: &str, name: Option<&str>) -> Result<(), Fault> {
        // A geometry of type null stands for nothing.
        let Some(kind) = geometry.kind() else { return Ok(()) };
        let own = geometry.name();
        let path = named(path, own.as_deref());
        let name = own.as_deref().or(name);
        match kind.as_ref() {
            "Polygon" | "MultiPolygon" => {
                let (one, arcs) = (kind == "Polygon", self.arcs);
                let value = geometry.arcs.ok_or_else(|| lacks(&path, "arcs"))?;
                let mut read =
                    |arrays: &mut Arrays<'_>, place: Place<'_>, rings: &mut Rings| ring(arrays, &place, rings, arcs);
                let mut arrays = Arrays::new(value, self.file);
                geometry.count_left_out(&mut self.rings.left_out);
                self.skipped.empty += polygons(&mut arrays, one, &path, name, &mut self.rings, &mut read)?;
                Ok(())
            }
            "GeometryCollection" => {
                let parts = geometry.geometries.as_ref().ok_or_else(|| lacks(&path, "geometries"))?;
                for (i, part) in parts.iter().enumerate() {
                    self.geometry(part, &format!("{path} geometries[{i}]"), name)?;
                }
                Ok(())
            }
            "LineString" | "MultiLineString" if self.chains.is_some() => {
                let value = geometry.arcs.ok_or_else(|| lacks(&path, "arcs"))?;
                let mut arrays = Arrays::new(value, self.file);
                if kind == "LineString" {
                    return self.line(&mut arrays, &path, 0);
                }
                arrays.each(|| shape(&path, "an array of lines"), |arrays, line| self.line(arrays, &path, line))
            }
            "Point" | "MultiPoint" if self.chains.is_some() => {
                let value = geometry.coordinates.ok_or_else(|| lacks(&path, "coordinates"))?;
                let mut arrays = Arrays::new(value, self.file);
                if kind == "Point" {
                    return self.point(&mut arrays, &path);
                }
                arrays.each(|| shape(&path, "an array of positions"), |arrays, _| self.point(arrays, &path))
            }
            kind if self.skipped.add(kind) => Ok(()),
            kind => Err(shape(&path, format!("a geometry, not the type {kind:?}")).into()),
        }
    }

    fn line(&mut self, arrays: &mut Arrays<'_>, path: &str, line: usize) -> Result<(), Fault> {
        let Some(chains) = &mut self.chains else { return Ok(()) };
        let (at, before) = (arrays.offset(), chains.point_count());
        ring(arrays, &format!("{path} line {line}"), chains, self.arcs)?;
        if chains.point_count() == before + 1 {
            return Err(Fault::at(at, shape(path, "two positions or more")));
        }
        chains.end_chain(at);
        Ok(())
    }

    fn point(&mut self, arrays: &mut Arrays<'_>, path: &str) -> Result<(), Fault> {
        let at = arrays.offset();
        let position = arrays.position();
        let (point, _) = position.ok_or_else(|| Fault::at(at, shape(path, "a position [x, y] of numbers")))?;
        let [x, y] = self.arcs.transform.map_or(point, |transform| transform.of(point));
        let checked = check_coordinate('x', x).and_then(|()| check_coordinate('y', y));
        checked.map_err(|error| Fault::at(at, ReadProblem::CoordinateAt { place: path.to_owned(), error }))?;
        self.single.push(([x + 0.0, y + 0.0], at));
        Ok(())
    }
}

/// Appends the points of a chain of arcs; each arc must start where the one before ends.
fn ring(arrays: &mut Arrays<'_>, place: &dyn Display, rings: &mut Rings, arcs: &Arcs) -> Result<(), Fault> {
    let here = || place.to_string();
    let mut first = true;
    arrays.each(
        || shape(&here(), "an array of arcs"),
        |arrays, _| {
            let offset = arrays.offset();
            let index = number(arrays, || shape(&here(), "whole numbers of arcs"))?;
            let forwards = index >= 0;
            let points = usize::try_from(if forwards { index } else { !index }).ok().and_then(|i| arcs.get(i));
            let points = points.ok_or_else(|| {
                let wanted = format!("arcs that exist, not {index} (there are {})", arcs.ends.len());
                Fault::at(offset, shape(&here(), wanted))
            })?;
            let at = |k: usize| if forwards { points[k] } else { points[points.len() - 1 - k] };
            if !first && !points.is_empty() && rings.last_point().is_some_and(|last| !same(last, at(0))) {
                return Err(Fault::at(offset, ReadProblem::BrokenRing { place: here(), arc: index }));
            }
            if rings.point_count() > REUSE * arcs.points.len() {
                let what = "points in the rings for each point of an arc";
                return Err(Fault::at(offset, ReadProblem::TooLarge { what, limit: REUSE as u64 }));
            }
            for k in usize::from(!first)..points.len() {
                rings.point(at(k), here).map_err(|problem| Fault::at(offset, problem))?;
            }
            first &= points.is_empty();
            Ok(())
        },
    )
}
