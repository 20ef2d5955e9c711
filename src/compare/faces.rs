//! Layer 2, faces: which face is which, and half-edges with a wrong one.
//!
//! ```text
//!   every paired half-edge votes:  its face here <-> its face there      the most votes win; the others are wrong
//!   faces beside an edge that only one file has count as one face
//! ```

use super::links::Links;
use super::placed::Placed;
use super::report::{Difference, Kind, Layer, Slot, Spot};
use super::spelling::unnumbered;
use crate::figure::structure::skeleton::{faces, half_edges, mutual_twin};
use crate::geometry::grouping::Joined;
use crate::ids::{Element, FaceId, HalfEdgeId};
use crate::topology::{InnerComponent, Table, View, bounded_cycle};
use std::collections::{BTreeMap, BTreeSet};

/// So many half-edges are named in one sentence.
const NAMED: usize = 4;

/// Faces that count as one because an edge between them is missing in the other file: `is_paired` tells whether the other
/// file has a half-edge.
fn joined(table: &Table, is_paired: impl Fn(HalfEdgeId) -> bool) -> Joined {
    let mut out = Joined::none(table.face_bound());
    for h in half_edges(table).filter(|&h| !is_paired(h)) {
        let twin = mutual_twin(table, h).filter(|&t| !is_paired(t));
        let sides = [table.face(h), twin.and_then(|t| table.face(t))];
        if let [Some(f), Some(g)] = sides.map(|f| f.filter(|&f| table.has_face(f))) {
            out.join(f.number(), g.number());
        }
    }
    out
}

/// Faces in pairs: those of the reference to those of the student, by the first of those that count as one.
struct Pairing {
    mine: Joined,
    theirs: Joined,
    partner: BTreeMap<u32, u32>,
}

impl Pairing {
    fn new(expected: &Placed<'_>, found: &Placed<'_>, links: &Links) -> Self {
        let mut mine = joined(expected.table, |h| links.found(h).is_some());
        let mut theirs = joined(found.table, |h| links.expected(h).is_some());
        let mut votes: BTreeMap<(u32, u32), usize> = BTreeMap::new();
        for (f, g) in pairs(expected, found, links) {
            *votes.entry((mine.root(f.number()), theirs.root(g.number()))).or_default() += 1;
        }
        let mut votes: Vec<((u32, u32), usize)> = votes.into_iter().collect();
        votes.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
        let mut partner = BTreeMap::new();
        let mut taken = vec![false; found.table.face_bound()];
        for ((f, g), _) in votes {
            if !partner.contains_key(&f) && !taken[g as usize] {
                partner.insert(f, g);
                taken[g as usize] = true;
            }
        }
        Self { mine, theirs, partner }
    }
}

/// The faces of paired half-edges, where both have one.
fn pairs<'a>(
    expected: &'a Placed<'_>,
    found: &'a Placed<'_>,
    links: &'a Links,
) -> impl Iterator<Item = (FaceId, FaceId)> + 'a {
    half_edges(expected.table).filter_map(|h| {
        let f = expected.table.face(h).filter(|&f| expected.table.has_face(f))?;
        let g = found.table.face(links.found(h)?).filter(|&g| found.table.has_face(g))?;
        Some((f, g))
    })
}

/// Half-edges with a wrong face, the outer face, hole faces, isolated vertices, faces without a half-edge.
pub(super) fn compare(expected: &Placed<'_>, found: &Placed<'_>, links: &Links, out: &mut Vec<Difference>) {
    let mut pairing = Pairing::new(expected, found, links);
    wrong_faces(expected, found, links, &mut pairing, out);
    let mut say = |text: String, spot: Spot| out.push(Difference::new(Kind::Face, Layer::Declared, text, spot));
    let names = [expected.table.outer_face, found.table.outer_face];
    let roots = [
        names[0].map(|f| pairing.mine.root(f.number())),
        names[1].filter(|&f| found.table.has_face(f)).map(|f| pairing.theirs.root(f.number())),
    ];
    match roots {
        [Some(mine), theirs] if theirs.is_none() || pairing.partner.get(&mine).is_some_and(|g| Some(*g) != theirs) => {
            let yours = names[1].map_or_else(|| "no face of yours is marked".to_owned(), |f| format!("yours is {f}"));
            let right = pairing.partner.get(&mine).map(|g| format!("; it should be your {}", FaceId::new(*g)));
            say(format!("outer face (data-outer): {yours}{}", right.unwrap_or_default()), Spot::Nowhere);
        }
        [None, Some(_)] => say("outer face: the reference has none".to_owned(), Spot::Nowhere),
        _ => {}
    }
    for f in faces(expected.table) {
        let Some(&g) = pairing.partner.get(&pairing.mine.root(f.number())) else { continue };
        let g = FaceId::new(g);
        if expected.table.is_hole(f) != found.table.is_hole(g) && pairing.mine.root(f.number()) == f.number() {
            let (is, not) = if expected.table.is_hole(f) { ("is", "not") } else { ("is not", "one") };
            say(format!("face {f} {is} a hole face in the reference; yours ({g}) is {not}"), outline(expected, f));
        }
    }
    isolated(expected, found, links, &mut pairing, &mut say);
    let walked: BTreeSet<FaceId> = half_edges(found.table).filter_map(|h| found.table.face(h)).collect();
    let is_outer_of_nothing = |g: FaceId| found.table.outer_face == Some(g) && expected.graph.edges.is_empty();
    for g in faces(found.table).filter(|&g| !walked.contains(&g) && !is_outer_of_nothing(g)) {
        say(format!("face {g} of yours belongs to no half-edge"), Spot::Nowhere);
    }
}

/// One sentence for all half-edges that should have one face and have another.
fn wrong_faces(
    expected: &Placed<'_>,
    found: &Placed<'_>,
    links: &Links,
    pairing: &mut Pairing,
    out: &mut Vec<Difference>,
) {
    let mut wrong: BTreeMap<(FaceId, Option<FaceId>), Vec<HalfEdgeId>> = BTreeMap::new();
    for h in half_edges(expected.table) {
        let (Some(g), Some(f)) = (links.found(h), expected.table.face(h)) else { continue };
        let face = found.table.face(g);
        let root = face.filter(|&x| found.table.has_face(x)).map(|x| pairing.theirs.root(x.number()));
        if root.is_none() || pairing.partner.get(&pairing.mine.root(f.number())).copied() != root {
            wrong.entry((f, face)).or_default().push(h);
        }
    }
    for ((f, face), half_edges) in wrong {
        let names: Vec<String> = half_edges.iter().take(NAMED).map(ToString::to_string).collect();
        let rest =
            if half_edges.len() > NAMED { format!(" and {} more", half_edges.len() - NAMED) } else { String::new() };
        let (subject, verb) = if half_edges.len() == 1 { ("half-edge", "has") } else { ("half-edges", "have") };
        let got = match face {
            None => "no face".to_owned(),
            Some(x) if !found.table.has_face(x) => format!("face {x}, which does not exist"),
            Some(x) => format!("face {x}"),
        };
        let partner = pairing.partner.get(&pairing.mine.root(f.number())).map(|&g| FaceId::new(g));
        let wanted = match partner {
            Some(g) if g == f => f.to_string(),
            Some(g) => format!("{f} (your {g})"),
            None => {
                format!("a face of {} own, {f} in the reference", if half_edges.len() == 1 { "its" } else { "their" })
            }
        };
        let text = format!("{subject} {}{rest} {verb} {got}; expected {wanted}", names.join(", "));
        let back = |x: FaceId| pairing.partner.iter().find(|(_, g)| **g == x.number()).map(|(f, _)| FaceId::new(*f));
        let target = face.and_then(back).map(Element::Face);
        let spot = Spot::Pointer { half_edge: half_edges[0], pointer: Slot::Face, found: target };
        out.push(Difference::new(Kind::HalfEdge, Layer::Declared, text, spot));
    }
}

/// In which face each vertex without edges lies.
fn isolated(
    expected: &Placed<'_>,
    found: &Placed<'_>,
    links: &Links,
    pairing: &mut Pairing,
    say: &mut impl FnMut(String, Spot),
) {
    let lies_in = |placed: &Placed<'_>| -> BTreeMap<u32, FaceId> {
        let table = placed.table;
        let alone = |ring: &InnerComponent| placed.numbers.get(ring.isolated()?.index()).copied().flatten();
        faces(table).flat_map(|f| table.inner_components(f).iter().filter_map(alone).map(move |v| (v, f))).collect()
    };
    let theirs = lies_in(found);
    for (v, f) in lies_in(expected) {
        let Some(m) = links.vertex(v) else { continue };
        let partner = pairing.partner.get(&pairing.mine.root(f.number())).copied();
        let face = theirs.get(&m).copied();
        // Without half-edges no face has a partner.
        if partner.is_some() && face.map(|g| pairing.theirs.root(g.number())) != partner {
            let name = &expected.graph.names[v as usize];
            let got = face.map_or_else(|| "no face".to_owned(), |g| g.to_string());
            let text = format!("vertex {name} has no edges and lies in {f}; yours is listed by {got} (data-rings)");
            say(text, Spot::MissingVertex(expected.graph.points[v as usize]));
        }
    }
}

/// Faces that are called differently, their numbers in front of their names or behind left out.
pub(super) fn names(expected: &Placed<'_>, found: &Placed<'_>, links: &Links, out: &mut Vec<Difference>) {
    let mut pairing = Pairing::new(expected, found, links);
    for f in faces(expected.table) {
        let Some(&g) = pairing.partner.get(&pairing.mine.root(f.number())) else { continue };
        let g = FaceId::new(g);
        let name = |table: &Table, f: FaceId| table.faces[f.index()].as_ref().and_then(|row| row.name.clone());
        let [mine, theirs] = [name(expected.table, f), name(found.table, g)];
        let mut say = |text: String| out.push(Difference::new(Kind::Face, Layer::Declared, text, outline(expected, f)));
        if f != g {
            say(format!("face {f} is called {g}"));
        }
        let is_same = match (&mine, &theirs) {
            (Some(a), Some(b)) => unnumbered(&f.to_string(), a) == unnumbered(&g.to_string(), b),
            (a, b) => a == b,
        };
        if !is_same {
            let word =
                |name: Option<String>| name.map_or_else(|| "without a name".to_owned(), |n| format!("named `{n}`"));
            say(format!("face {f} is {}; expected {}", word(theirs), word(mine)));
        }
    }
}

/// The boundary of a face, to be drawn.
fn outline(expected: &Placed<'_>, f: FaceId) -> Spot {
    let corner = |h: HalfEdgeId| Some(expected.graph.point(expected.ends(h)?[0]));
    let start = expected.table.half_edge(f);
    Spot::Face(start.into_iter().flat_map(|h| bounded_cycle(expected.table, h)).filter_map(corner).collect())
}
