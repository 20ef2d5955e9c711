//! The records of a dump against what the mesh should be.
//!
//! ```text
//!   vertex     live as it should be, where it should be; outgoing: a half-edge with a face that starts there
//!   half-edge  twin of its twin; in a triangle: next, prev, face agree with the triangle; at a border: none of these
//!   face       its half-edge has it as its face
//!   beside     each half-edge is in the edge map, and nothing else; what is free is on its free list, once
//!   counts     as many live records as there should be, and no more records than were ever needed at a time
//! ```

use super::model::Model;
use crate::checks::faults::{Broken, law, told};
use crate::protocol::{Cell, Records};
use std::ops::Range;

/// A half-edge of a dump.
#[derive(Clone, Copy)]
struct HalfEdge {
    origin: Option<u32>,
    twin: Option<u32>,
    next: Option<u32>,
    prev: Option<u32>,
    face: Option<u32>,
}

/// The last field of a record: the odd numbers are those of live ones; see [`beside`] for the others.
fn state(row: &[Cell]) -> u32 {
    row.last().and_then(|cell| cell.number()).map_or(0, |state| state as u32)
}

/// Whether a record is live.
pub(super) fn is_live(row: &[Cell]) -> bool {
    state(row) % 2 == 1
}

fn half_edge(records: &Records, h: u32) -> Option<HalfEdge> {
    let row = records.row(1, h as usize).filter(|row| is_live(row))?;
    let [origin, twin, next, prev, face] = [0, 1, 2, 3, 4].map(|i| row[i].to());
    Some(HalfEdge { origin, twin, next, prev, face })
}

/// The sides of a model's triangles in the order of their ends, found by number: a large mesh is looked through often.
///
/// ```text
///   first      0         2    3            the sides from v0 are 0 and 1, that from v1 is 2, …
///   sides      (0, 1)  (0, 2)  (1, 2)  …   with the corners across them
/// ```
struct Sides {
    first: Vec<usize>,
    sides: Vec<((usize, usize), usize)>,
}

impl Sides {
    fn of(model: &Model) -> Self {
        let sides: Vec<((usize, usize), usize)> = model.across.iter().map(|(&side, &corner)| (side, corner)).collect();
        let mut first = vec![0; model.vertices.len() + 1];
        let mut next = 0;
        for (v, first) in first.iter_mut().enumerate() {
            next += sides[next..].iter().take_while(|((from, _), _)| *from < v).count();
            *first = next;
        }
        Self { first, sides }
    }

    /// The numbers of the sides that start at a vertex.
    fn from(&self, v: usize) -> Range<usize> {
        match self.first.get(v..v + 2) {
            Some(&[begin, end]) => begin..end,
            _ => 0..0,
        }
    }

    /// The number of a side.
    fn number(&self, from: u32, to: u32) -> Option<usize> {
        let all = self.from(from as usize);
        self.sides[all.clone()].binary_search_by_key(&(to as usize), |((_, to), _)| *to).ok().map(|i| all.start + i)
    }
}

/// The first law that is broken.
pub(super) fn broken(records: &Records, model: &Model) -> Option<Broken> {
    let sides = Sides::of(model);
    let all = vertices(records, model, &sides).and_then(|()| half_edges(records, model, &sides));
    all.and_then(|()| faces(records, model)).and_then(|()| beside(records)).err()
}

/// What the program says of the free lists and of the edge map.
fn beside(records: &Records) -> Result<(), Broken> {
    let names = [("v", "vertices"), ("h", "half-edges"), ("f", "faces")];
    let all = names
        .into_iter()
        .enumerate()
        .flat_map(|(table, name)| records.rows(table).enumerate().map(move |(number, row)| (name, number, state(row))));
    for ((letter, plural), number, state) in all {
        let wrong = match state {
            2 => ("free.missing", format!("{letter}{number} is free, but is not once on the list of free {plural}")),
            3 => ("free.live", format!("{letter}{number} exists, but is on the list of free {plural}")),
            4 | 5 if letter == "v" => (
                "map.stale",
                format!("the edge map has an entry that begins at v{number} and leads to no half-edge with these ends"),
            ),
            4 | 5 => ("map.none", format!("the edge map does not lead to {letter}{number} from its two ends")),
            _ => continue,
        };
        return Err(wrong);
    }
    Ok(())
}

fn vertices(records: &Records, model: &Model, sides: &Sides) -> Result<(), Broken> {
    let (found, expected) = (records.len(0), model.vertices.len());
    law(found == expected, "vertex.records", || format!("there are {found} vertex records, expected {expected}"))?;
    for (v, row) in records.rows(0).enumerate() {
        let Some(place) = model.place(v) else {
            law(!is_live(row), "vertex.live", || format!("v{v} is live still, although it was removed"))?;
            continue;
        };
        law(is_live(row), "vertex.dead", || format!("v{v} is not live, although it exists"))?;
        let is_there = place.iter().zip(row).all(|(x, cell)| cell.number() == Some(*x));
        law(is_there, "vertex.place", || format!("v{v} is not at ({}, {}, {})", place[0], place[1], place[2]))?;
        let has_face = !sides.from(v).is_empty();
        let Some(h) = row[3].to() else {
            law(!has_face, "vertex.none", || {
                format!("v{v} has no outgoing half-edge, although triangles have it as a corner")
            })?;
            continue;
        };
        law(has_face, "vertex.stale", || {
            format!("v{v} has no triangle, but its outgoing half-edge is h{h}; expected none")
        })?;
        let to = half_edge(records, h);
        let to = told(to, "vertex.free", || format!("the outgoing half-edge of v{v} is h{h}, which is free"))?;
        law(to.origin == Some(v as u32), "vertex.outgoing", || {
            format!("the outgoing half-edge of v{v} is h{h}, which does not start there")
        })?;
        law(to.face.is_some(), "vertex.border", || {
            format!("the outgoing half-edge of v{v} is h{h}, which has no face; another one has")
        })?;
    }
    Ok(())
}

fn half_edges(records: &Records, model: &Model, sides: &Sides) -> Result<(), Broken> {
    // The half-edge of each side, and that of the other direction where no triangle has it.
    let mut met: Vec<[Option<u32>; 2]> = vec![[None; 2]; sides.sides.len()];
    for h in 0..records.len(1) as u32 {
        let Some(of) = half_edge(records, h) else { continue };
        let get = |to: Option<u32>| to.and_then(|to| half_edge(records, to));
        let twin = told(get(of.twin), "twin.none", || format!("the twin of h{h} is not set, or free"))?;
        let is_mutual = twin.twin == Some(h) && of.twin != Some(h);
        law(is_mutual, "twin.twin", || format!("the twin of the twin of h{h} is not h{h}"))?;
        let ends = of.origin.zip(twin.origin);
        let (from, to) = told(ends, "origin.none", || format!("the origin of h{h} or of its twin is not set"))?;
        let side = sides.number(from, to);
        let edge = side.map(|side| (side, 0)).or_else(|| Some((sides.number(to, from)?, 1)));
        let (edge, way) = told(edge, "edge.orphan", || {
            format!("the edge of v{from} and v{to} is still there, although no triangle has it")
        })?;
        if let Some(other) = met[edge][way].replace(h) {
            return Err(("double", format!("h{other} and h{h} both lead from v{from} to v{to}")));
        }
        let Some(side) = side else {
            if let Some(f) = of.face {
                let words = format!("h{h} from v{from} to v{to} has the face f{f}, although no triangle is there");
                return Err(("face.stale", words));
            }
            law(of.next.or(of.prev).is_none(), "border.links", || {
                format!("h{h} lies at a border, but its next or prev is set; expected neither")
            })?;
            continue;
        };
        law(of.face.is_some(), "face.none", || {
            format!("h{h} from v{from} to v{to} has no face, although a triangle is there")
        })?;
        let corner = sides.sides[side].1;
        let links = get(of.next).zip(get(of.prev));
        let (next, prev) = told(links, "next.none", || format!("the next or prev of h{h} is not set, or free"))?;
        law(next.prev == Some(h) && prev.next == Some(h), "next.prev", || {
            format!("next and prev of h{h} do not agree with those of its neighbours")
        })?;
        law(next.origin == Some(to) && prev.origin == Some(corner as u32), "next.origin", || {
            format!("from h{h}, v{from} to v{to}, the triangle should go on to v{corner}")
        })?;
        law(next.face == of.face && prev.face == of.face, "face.cycle", || {
            format!("the half-edges of the triangle of h{h} have different faces")
        })?;
    }
    if let Some(side) = met.iter().position(|[there, _]| there.is_none()) {
        let (a, b) = sides.sides[side].0;
        return Err(("edge.none", format!("there is no half-edge from v{a} to v{b}, although a triangle is there")));
    }
    let (found, most) = (records.len(1), 2 * model.most[0]);
    law(found <= most, "half_edge.records", || {
        format!("there are {found} half-edge records, where {most} are enough: free ones should be used again")
    })
}

fn faces(records: &Records, model: &Model) -> Result<(), Broken> {
    let live = records.rows(2).filter(|row| is_live(row)).count();
    let expected = model.across.len() / 3;
    law(live == expected, "face.live", || format!("{live} faces are live, expected {expected}"))?;
    for (f, row) in records.rows(2).enumerate().filter(|(_, row)| is_live(row)) {
        let side = row[0].to().and_then(|h| half_edge(records, h));
        law(side.and_then(|side| side.face) == Some(f as u32), "face.half_edge", || {
            format!("the incident half-edge of f{f} does not have f{f} as its face")
        })?;
    }
    let (found, most) = (records.len(2), model.most[1]);
    law(found <= most, "face.records", || {
        format!("there are {found} face records, where {most} are enough: free ones should be used again")
    })
}
