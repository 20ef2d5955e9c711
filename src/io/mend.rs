//! Polygons of a file that do not fit together, mended, with a report.

use super::load_error::{LoadError, Whereabouts};
use super::misfit::Told;
use super::soup::Places;
use super::words::{at_most, counted, note};
use crate::geometry::number::Number;
use crate::ids::{FaceId, FaceMap, VertexId};
use crate::plane::{Cover, Mended, SegmentsError, Subdivision};
use std::collections::{BTreeMap, BTreeSet};

/// So many names stand on one face; more are counted.
const NAMES: usize = 6;
/// Names are looked for among so many polygons of a face.
const LOOKED_AT: usize = 100;
/// So many places and overlaps are told; more are counted.
const SHOWN: usize = 3;

/// Which polygons of the file cover each face, by name.
#[derive(Clone, PartialEq, Debug)]
pub struct Covering {
    /// The polygons by their numbers in the file.
    pub cover: Cover,
    /// How many polygons there are.
    pub polygons: usize,
    /// The name of each polygon, or nothing at all if the file has no names.
    pub names: Vec<Option<String>>,
    /// The sum of the areas that are covered more than once, each counted once: the exact sum, rounded.
    pub overlapping: f64,
}

impl Covering {
    /// The names of the polygons that cover a face, each once, in the order of the file.
    pub fn names(&self, f: FaceId) -> impl Iterator<Item = &str> {
        let mut seen = BTreeSet::new();
        let named = self.cover.polygons(f).into_iter().filter_map(|i| self.names.get(i as usize)?.as_deref());
        named.filter(move |&name| seen.insert(name))
    }

    /// The faces that polygons of this name cover, in increasing order.
    #[must_use]
    pub fn faces_named(&self, fits: impl Fn(&str) -> bool) -> Vec<FaceId> {
        let mut wanted: Vec<bool> = self.names.iter().map(|name| name.as_deref().is_some_and(&fits)).collect();
        wanted.resize(self.polygons, false);
        let counts = self.cover.count_marked(&wanted);
        counts.iter().filter(|(_, count)| **count > 0).map(|(f, _)| f).collect()
    }
}

/// The subdivision that the polygons cut the plane into, with the names of its faces and what to tell.
pub(super) struct MendedSoup {
    pub(super) subdivision: Subdivision,
    pub(super) names: FaceMap<Option<String>>,
    pub(super) covering: Covering,
    pub(super) notes: Vec<String>,
}

/// Mends polygons. `blocked` are those that are no part of the domain, in increasing order.
pub(super) fn mend(told: &Told<'_>, names: Vec<Option<String>>, blocked: &[u32]) -> Result<MendedSoup, LoadError> {
    let mended = Subdivision::mend_polygons(told.points, told.faces).map_err(|error| refused(told.places, error))?;
    let covered = mended.subdivision.face_count() - mended.cover.uncovered().count();
    let polygons = counted(told.faces.face_count(), "polygon", "polygons");
    let mut notes = vec![format!("mended: {polygons} became {}", counted(covered, "face", "faces"))];
    note_splits(&mended, told, &mut notes);
    let overlapping = note_overlaps(&mended, told, &mut notes);
    note_rest(&mended, told, &mut notes);
    let Mended { mut subdivision, cover, .. } = mended;
    // Of a pile of polygons the sets of the faces are quadratic in their number: nothing goes through them whole.
    let mut marked = vec![false; told.faces.face_count()];
    blocked.iter().for_each(|&polygon| marked[polygon as usize] = true);
    let holes = cover.count_marked(&marked);
    for (f, _) in holes.iter().filter(|(_, count)| **count > 0) {
        subdivision.set_hole(f, true);
    }
    let named: Vec<bool> = (0..marked.len()).map(|i| names.get(i).is_some_and(Option::is_some)).collect();
    let mut by_face = FaceMap::default();
    if named.contains(&true) {
        let counts = cover.count_marked(&named);
        cover.visit(|f, polygons| {
            if counts[f] > 0 {
                by_face.set(f, Some(joined(polygons, &names, told)), None);
            }
        });
    }
    Ok(MendedSoup {
        subdivision,
        names: by_face,
        covering: Covering { cover, polygons: told.faces.face_count(), names, overlapping },
        notes,
    })
}

fn refused(places: &Places, error: SegmentsError) -> LoadError {
    let first = match error {
        SegmentsError::Coordinate { point, .. } => places.vertex(point as usize),
        _ => places.source.clone(),
    };
    LoadError::Segments { at: Box::new(Whereabouts { first, others: Vec::new() }), error }
}

/// `Ohio & Erie`: the names of some polygons, each once; without a name, a polygon by its path.
fn joined(polygons: &BTreeSet<u32>, names: &[Option<String>], told: &Told<'_>) -> String {
    let name = |&i: &u32| names.get(i as usize).and_then(Option::clone);
    let mut shown: Vec<String> = Vec::new();
    let mut looked_at = 0;
    for i in polygons.iter().take(LOOKED_AT) {
        let word = name(i).unwrap_or_else(|| told.polygon(*i));
        if !shown.contains(&word) {
            if shown.len() == NAMES {
                break;
            }
            shown.push(word);
        }
        looked_at += 1;
    }
    let more = polygons.len() - looked_at;
    let rest = if more > 0 { format!(" & {more} more") } else { String::new() };
    shown.join(" & ") + &rest
}

/// The first few of a long list, and how many there are beside them.
fn listed(all: impl ExactSizeIterator<Item = String>) -> String {
    let rest = all.len().saturating_sub(SHOWN);
    let first = all.take(SHOWN).collect::<Vec<_>>().join("; ");
    if rest == 0 { first } else { format!("{first}; and {rest} more") }
}

/// What was split, and what moved.
fn note_splits(mended: &Mended, told: &Told<'_>, notes: &mut Vec<String>) {
    let s = &mended.subdivision;
    let around = |v: VertexId| {
        let outlines = s.outgoing_half_edges(v).flat_map(|h| mended.outlines(h.edge()));
        let all: BTreeSet<_> = outlines.copied().collect();
        all.into_iter().map(|i| told.polygon(i)).collect::<Vec<_>>()
    };
    let place = |&v: &VertexId| {
        let (polygons, at) = (around(v), told.in_file(s.point(v)));
        match polygons.as_slice() {
            [] => at,
            [one] => format!("{one} crosses itself at {at}"),
            [most @ .., last] if most.len() < SHOWN => format!("{} and {last} cross at {at}", most.join(", ")),
            many => format!("{} polygons cross at {at}", many.len()),
        }
    };
    let crossings = format!(" where sides cross: {}", listed(mended.crossings.iter().map(place)));
    note(notes, mended.crossings.len(), "vertex was made", "vertices were made", &crossings);
    let places = mended.touching.iter().map(|&v| told.in_file(s.point(v)));
    let touching = format!(" inside sides, which were split there: {}", listed(places));
    note(notes, mended.touching.len(), "corner lies", "corners lie", &touching);
    let grid = mended.grid.map_or_else(String::new, |grid| format!(" to a grid of {}", Number(grid)));
    let moved = format!(" by rounding{grid}; no side moved further than {}", at_most(mended.farthest));
    note(notes, mended.moved.len(), "vertex was moved", "vertices were moved", &moved);
}

/// What overlaps, largest first; returns the area of all.
fn note_overlaps(mended: &Mended, told: &Told<'_>, notes: &mut Vec<String>) -> f64 {
    let mut groups: BTreeMap<Vec<u32>, (usize, Vec<FaceId>)> = BTreeMap::new();
    let mut all = Vec::new();
    mended.cover.visit(|f, polygons| {
        if polygons.len() > 1 {
            // Of a crowd only the first ones make the group, so that deep piles take no room.
            let group = groups.entry(polygons.iter().copied().take(NAMES).collect()).or_default();
            group.0 = group.0.max(polygons.len());
            group.1.push(f);
            all.push(f);
        }
    });
    if all.is_empty() {
        return 0.0;
    }
    let mut told_groups: Vec<(f64, String)> = Vec::new();
    for (polygons, (count, faces)) in &groups {
        let area = mended.subdivision.area_of(faces.iter().copied());
        let mut names: Vec<String> = polygons.iter().map(|&i| told.polygon(i)).collect();
        if *count > names.len() {
            names.push(format!("{} more", count - names.len()));
        }
        let last = names.pop().unwrap_or_default();
        let words = format!("{} and {last} overlap in area {}", names.join(", "), Number(area));
        told_groups.push((area, words));
    }
    told_groups.sort_by(|a, b| b.0.total_cmp(&a.0));
    let total = mended.subdivision.area_of(all.iter().copied());
    let words = listed(told_groups.into_iter().map(|group| group.1));
    let overlaps = format!(" covered more than once, area {} in all: {words}", Number(total));
    note(notes, all.len(), "face is", "faces are", &overlaps);
    total
}

/// What was left out, and what has no part in the result.
fn note_rest(mended: &Mended, told: &Told<'_>, notes: &mut Vec<String>) {
    let both = " left out: the same polygons, or none, lie on both sides";
    note(notes, mended.left_out, "piece of a side was", "pieces of sides were", both);
    let why = " an outer ring that encloses nothing, so that the other rings were taken as outlines";
    let hollow = listed(mended.hollow.iter().map(|&i| told.polygon(i)));
    note(notes, mended.hollow.len(), "polygon has", "polygons have", &format!("{why}: {hollow}"));
    let mut covers = vec![false; told.faces.face_count()];
    for e in mended.subdivision.edges() {
        mended.outlines(e).iter().for_each(|&i| covers[i as usize] = true);
    }
    let lost: Vec<u32> = (0..covers.len() as u32).filter(|&i| !covers[i as usize]).collect();
    let nothing = format!(" nothing: {}", listed(lost.iter().map(|&i| told.polygon(i))));
    note(notes, lost.len(), "polygon covers", "polygons cover", &nothing);
}
