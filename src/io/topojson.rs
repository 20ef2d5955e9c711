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
//! read, and a note says so. Which way y points is not written down: maps for the screen have it downwards,
//! see [`ReadOptions::y_down`].
//!
//! Source: M. Bostock and C. Metcalf, *The TopoJSON Format Specification* (version 1).

use super::json::{Fault, Object, Skipped, array, feature_name, items, polygons, shape, typed};
use super::problem::ReadProblem;
use super::read::ReadOptions;
use super::rings::{Rings, same};
use serde_json::Value;

/// Arcs may be used this often on average; a map uses each of them once or twice. Without a limit a small file
/// could ask for any amount of memory.
const REUSE: usize = 64;

/// The arcs in one flat list.
struct Arcs {
    points: Vec<[f64; 2]>,
    ends: Vec<usize>,
}

/// Reads the rings of one object of a topology.
pub(super) fn read(value: &Value, options: &ReadOptions, notes: &mut Vec<String>) -> Result<Rings, Fault> {
    let (root, _) = typed(value, "the file")?;
    let arcs = Arcs::read(root)?;
    let objects = root.get("objects").and_then(Value::as_object);
    let objects = objects.ok_or_else(|| shape("the file", "an object \"objects\""))?;
    let (name, object) = choose(objects, options.object.as_deref(), notes)?;
    let mut reader = Reader { arcs: &arcs, rings: Rings::default(), skipped: Skipped::default(), empty: 0 };
    match object.get("geometries") {
        Some(Value::Array(geometries)) => {
            for (i, geometry) in geometries.iter().enumerate() {
                reader.geometry(geometry, &format!("{name}[{i}]"), None)?;
            }
        }
        _ => reader.geometry(object, name, None)?,
    }
    reader.skipped.note(notes);
    if reader.empty > 0 {
        notes.push(format!("{} polygons without any ring were skipped", reader.empty));
    }
    Ok(reader.rings)
}

/// The object that was asked for, or the one with the most polygons.
fn choose<'a>(
    objects: &'a Object,
    wanted: Option<&str>,
    notes: &mut Vec<String>,
) -> Result<(&'a str, &'a Value), Fault> {
    let all: Vec<(&str, &Value, usize)> =
        objects.iter().map(|(name, object)| (name.as_str(), object, polygon_count(object))).collect();
    let list = || all.iter().map(|(name, _, n)| format!("{name} ({n} polygons)")).collect::<Vec<_>>().join(", ");
    if let Some(wanted) = wanted {
        let found = all.iter().find(|(name, ..)| *name == wanted);
        return found.map(|&(name, object, _)| (name, object)).ok_or_else(|| Fault {
            what: shape(&format!("object {wanted:?}"), "one of the objects of the file"),
            help: format!("the file has {}", list()).into(),
        });
    }
    // Of equals the first one: `rev`, because max_by_key takes the last.
    let best = all.iter().rev().max_by_key(|(_, _, n)| *n);
    let &(name, object, _) = best.ok_or_else(|| shape("the file", "at least one object"))?;
    if all.iter().filter(|(_, _, n)| *n > 0).count() > 1 {
        notes.push(format!("the file has the objects {}; {name} was read (choose with --object)", list()));
    }
    Ok((name, object))
}

fn polygon_count(value: &Value) -> usize {
    let length = |key: &str| value.get(key).and_then(Value::as_array).map_or(0, Vec::len);
    match value.get("type").and_then(Value::as_str) {
        Some("Polygon") => 1,
        Some("MultiPolygon") => length("arcs"),
        Some("GeometryCollection") => {
            value.get("geometries").and_then(Value::as_array).map_or(0, |all| all.iter().map(polygon_count).sum())
        }
        _ => 0,
    }
}

impl Arcs {
    /// Reads all arcs and brings their points to their final coordinates.
    fn read(root: &Object) -> Result<Self, ReadProblem> {
        let transform = root.get("transform").map(transform).transpose()?;
        let mut arcs = Self { points: Vec::new(), ends: Vec::new() };
        for (i, arc) in array(root, "arcs", "the file")?.iter().enumerate() {
            let place = || format!("arcs[{i}]");
            let mut at = [0.0; 2];
            for (k, position) in items(arc, &place(), "an array of positions")?.iter().enumerate() {
                let number = |k: usize| position.get(k).and_then(Value::as_f64);
                let (Some(x), Some(y)) = (number(0), number(1)) else {
                    return Err(shape(&format!("{} position {k}", place()), "a position [x, y] of numbers"));
                };
                arcs.points.push(match transform {
                    None => [x, y],
                    Some((scale, translate)) => {
                        at = [at[0] + x, at[1] + y];
                        [at[0] * scale[0] + translate[0], at[1] * scale[1] + translate[1]]
                    }
                });
            }
            arcs.ends.push(arcs.points.len());
        }
        Ok(arcs)
    }

    /// The points of arc `i`.
    fn get(&self, i: usize) -> Option<&[[f64; 2]]> {
        let start = i.checked_sub(1).map_or(Some(0), |before| self.ends.get(before).copied())?;
        self.points.get(start..*self.ends.get(i)?)
    }
}

fn transform(value: &Value) -> Result<([f64; 2], [f64; 2]), ReadProblem> {
    let pair = |key: &str| {
        let numbers = value.get(key);
        let number = |k: usize| numbers.and_then(|n| n.get(k)).and_then(Value::as_f64);
        number(0).zip(number(1)).map(|(x, y)| [x, y])
    };
    pair("scale")
        .zip(pair("translate"))
        .ok_or_else(|| shape("transform", "\"scale\" and \"translate\", two numbers each"))
}

struct Reader<'a> {
    arcs: &'a Arcs,
    rings: Rings,
    skipped: Skipped,
    empty: usize,
}

impl Reader<'_> {
    fn geometry(&mut self, value: &Value, place: &str, name: Option<&str>) -> Result<(), ReadProblem> {
        let (geometry, kind) = match value.get("type") {
            Some(Value::Null) => return Ok(()),
            _ => typed(value, place)?,
        };
        let own = feature_name(geometry);
        let name = own.as_deref().or(name);
        let place = own.as_ref().map_or_else(|| place.to_owned(), |name| format!("{place} {name:?}"));
        match kind {
            "Polygon" | "MultiPolygon" => {
                let arcs = self.arcs;
                let value = array(geometry, "arcs", &place)?;
                let mut read = |value: &Value, place: &str, rings: &mut Rings| ring(value, place, rings, arcs);
                self.empty += polygons(value, kind == "Polygon", &place, name, &mut self.rings, &mut read)?;
                Ok(())
            }
            "GeometryCollection" => {
                for (i, part) in array(geometry, "geometries", &place)?.iter().enumerate() {
                    self.geometry(part, &format!("{place} geometries[{i}]"), name)?;
                }
                Ok(())
            }
            kind if self.skipped.add(kind) => Ok(()),
            kind => Err(shape(&place, format!("a geometry, not the type {kind:?}"))),
        }
    }
}

/// Appends the points of a chain of arcs; each arc must start where the one before ends.
fn ring(value: &Value, place: &str, rings: &mut Rings, arcs: &Arcs) -> Result<(), ReadProblem> {
    let here = || place.to_owned();
    let mut first = true;
    for reference in items(value, place, "an array of arcs")? {
        let index = reference.as_i64().ok_or_else(|| shape(place, "whole numbers of arcs"))?;
        let forwards = index >= 0;
        let number = usize::try_from(if forwards { index } else { !index }).ok();
        let points = number
            .and_then(|i| arcs.get(i))
            .ok_or_else(|| shape(place, format!("arcs that exist, not {index} (there are {})", arcs.ends.len())))?;
        let at = |k: usize| if forwards { points[k] } else { points[points.len() - 1 - k] };
        if !first && !points.is_empty() {
            let last = rings.last_point();
            if last.is_some_and(|last| !same(last, at(0))) {
                return Err(ReadProblem::BrokenRing { place: here(), arc: index });
            }
        }
        if rings.point_count() > REUSE * arcs.points.len() {
            return Err(ReadProblem::TooLarge {
                what: "points in the rings for each point of an arc",
                limit: REUSE as u64,
            });
        }
        for k in usize::from(!first)..points.len() {
            rings.point(at(k), here)?;
        }
        first &= points.is_empty();
    }
    rings.end_ring(here)
}
