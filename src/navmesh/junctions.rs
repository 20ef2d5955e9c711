//! Junctions and reduced corridors: the few faces at which there is a choice, and what lies between them.
//!
//! ```text
//!   ┌───┬───┬───┬───┐      Leave the dead ends away. A face with three or more exits is a junction (X). The others
//!   │ · │ · │ X │ · │ ..   have two, and stand in rows from one junction to the next: reduced corridors. Whoever is in one can
//!   ├───┼───┼───┼───┘      but go on; so a search for the fewest faces may take a reduced corridor in one step.
//!   │ · │ ▒ │ · │
//!   ├───┼───┼───┤          A component with one round trip, or none, has no junction: it is a single reduced corridor, whose
//!   │ · │ · │ · │          last face is beside its first.
//!   └───┴───┴───┘
//! ```
//!
//! With h holes in a component of triangles there are at most 2 (h - 1) junctions, however fine the triangles are.
//!
//! When the mesh changes, the reduced corridors and junctions at the change are dropped, and others put behind the last ones. Once
//! half of all is dropped the whole is made anew, when it is needed next.
//!
//! Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006 (the reduced graph of TRA*: their
//! level-3 nodes are the junctions, their corridors the reduced corridors).

use super::NavMesh;
use super::curve::Curve;
use super::many_corners::FEW;
use super::marks::{CLOSED, DEAD_END, ID, NONE};
use crate::geometry::grouping::sorted;
use crate::ids::{FaceId, VertexId};
use std::collections::BTreeMap;
use std::ops::Range;

/// In the spot of a face: it is a junction, and the rest is its number.
pub(super) const CROSSING: u32 = 1 << 31;

/// Junctions and reduced corridors in flat arrays.
#[derive(Clone, Debug, Default)]
pub(super) struct Junctions {
    /// The face of each junction.
    faces: Vec<u32>,
    /// Where the links of each junction begin, and, at last, where they end.
    starts: Vec<u32>,
    links: Vec<Link>,
    reduced_corridors: Vec<CorridorRecord>,
    /// The faces of all reduced corridors, one reduced corridor after the other.
    row: Vec<u32>,
    /// The endpoints of the portals of each reduced corridor, the right one first for who runs from its first end to its second: one
    /// more than it has faces.
    portals: Vec<[u32; 2]>,
    /// Where each face is: [`CROSSING`] and a number, a place in `row`, or [`NONE`].
    spots: Vec<u32>,
    /// How many links and places in `row` are of no use any more.
    spent: usize,
}

/// In the first end of a reduced corridor: it was dropped.
const DROPPED: u32 = NONE - 1;

/// An exit from a junction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Link {
    /// The junction it leads to.
    pub(super) to: u32,
    /// How many portals there are on the way.
    pub(super) portals: u32,
    /// Twice the number of the reduced corridor; one more if it is run through from its second end to its first.
    pub(super) by: u32,
}

/// A reduced corridor: `row[first .. end]` between two junctions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct CorridorRecord {
    /// The junctions before the first face and behind the last one; [`NONE`] if it goes round in a circle.
    pub(super) ends: [u32; 2],
    pub(super) first: u32,
    pub(super) end: u32,
}

impl CorridorRecord {
    #[inline]
    pub(super) fn range(&self) -> Range<usize> {
        self.first as usize..self.end as usize
    }
}

/// A row of faces without a choice: each has two exits that are no dead ends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ReducedCorridor {
    /// The junctions beside its first and beside its last face; they may be the same. `None` if the last face is
    /// beside the first, or there is but one face.
    pub ends: Option<[FaceId; 2]>,
    /// The faces in order. There are none between junctions that are neighbours.
    pub faces: Vec<FaceId>,
}

/// Which exit of a junction a side is. Of faces with many sides the exits are counted once.
#[derive(Default)]
struct Exits {
    /// The sides that lead on, in order.
    of_large: BTreeMap<u32, Vec<usize>>,
}

impl Exits {
    fn place(&mut self, mesh: &NavMesh, f: u32, s: usize) -> usize {
        let place = if mesh.range(FaceId::new(f)).len() <= FEW {
            mesh.ways_on(f).position(|on| on == s)
        } else {
            self.of_large.entry(f).or_insert_with(|| mesh.ways_on(f).collect()).binary_search(&s).ok()
        };
        place.expect("it is one of them")
    }
}

impl NavMesh {
    /// Finds the junctions of the map now, if that has not been done: over them [`PathAlgorithm::Breadth`](super::PathAlgorithm::Breadth)
    /// and the algorithms of A* go from junction to junction instead of from face to face. Nobody has to call this: the
    /// first query that needs them does it. Returns how many junctions there are.
    ///
    /// The number of faces on routes of the fewest faces is the same as [face by face](super::Planner::face_by_face); of
    /// several rows with the fewest faces it may be another. When the mesh changes, junctions and reduced corridors are
    /// brought up to date near the change.
    ///
    /// Cost: O(n log n) the first time, then O(number of junctions); 4 bytes a face, 12 more for one that is no dead end,
    /// and 80 for a junction.
    ///
    /// ```
    /// use dcel_kit::navmesh::NavMesh;
    /// use dcel_kit::plane::Subdivision;
    /// // Eight triangles round a square hole: once round, without a choice.
    /// let points = [(0., 0.), (3., 0.), (3., 3.), (0., 3.), (1., 1.), (2., 1.), (2., 2.), (1., 2.)].map(Into::into);
    /// let sides = [0, 1, 2, 3].map(|i| [i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]);
    /// let triangles = sides.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).concat();
    /// let mesh = NavMesh::new(&Subdivision::from_triangles(points.to_vec(), &triangles)?)?;
    /// assert_eq!(mesh.link_junctions(), 0);
    /// assert_eq!(mesh.reduced_corridors().len(), 1);
    /// assert_eq!(mesh.reduced_corridors()[0].faces.len(), 8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn link_junctions(&self) -> usize {
        self.junctions().len()
    }

    /// The faces with three or more exits that are no dead ends, mostly along a curve that fills the plane. O(number of
    /// them), and see [`link_junctions`](Self::link_junctions).
    pub fn junctions(&self) -> impl ExactSizeIterator<Item = FaceId> + Clone + use<> {
        let faces = self.network().faces.iter().filter(|&&f| f != NONE);
        faces.map(|&f| FaceId::new(f)).collect::<Vec<_>>().into_iter()
    }

    /// Junctions and reduced corridors; made now if they have not been.
    pub(super) fn network(&self) -> &Junctions {
        self.junctions.get_or_init(|| Junctions::new(self))
    }

    /// The rows of faces between the junctions. O(n), and see [`link_junctions`](Self::link_junctions).
    #[must_use]
    pub fn reduced_corridors(&self) -> Vec<ReducedCorridor> {
        let junctions = self.network();
        let reduced_corridor = |record: &CorridorRecord| ReducedCorridor {
            ends: (record.ends[0] != NONE).then(|| record.ends.map(|c| FaceId::new(junctions.face(c)))),
            faces: junctions.row[record.range()].iter().map(|&f| FaceId::new(f)).collect(),
        };
        junctions.reduced_corridors.iter().filter(|record| record.ends[0] != DROPPED).map(reduced_corridor).collect()
    }

    /// The faces that are no dead ends, in the order of a curve that fills the plane: so junctions that are near are
    /// near in memory.
    fn core_along_curve(&self) -> Vec<u32> {
        let curve = Curve::over(self);
        let mut core: Vec<u32> = (0..self.faces.len() as u32).filter(|&f| self.is_core(f)).collect();
        core.sort_by_cached_key(|&f| self.corners(FaceId::new(f)).next().map(|v| curve.key(self.point(v))));
        core
    }

    /// Whether one may stand in `f`, and it is no dead end.
    fn is_core(&self, f: u32) -> bool {
        self.is_walkable(FaceId::new(f)) && !self.is_peeled(f)
    }

    /// The sides of `f` that lead on: they are open, and no dead end lies behind.
    fn ways_on(&self, f: u32) -> impl Iterator<Item = usize> + '_ {
        self.range(FaceId::new(f)).filter(|&s| self.sides[s].across & (CLOSED | DEAD_END) == 0)
    }

    /// The face behind the open side `s` of `f`, and its side on the way back.
    fn beyond(&self, f: u32, s: usize) -> (u32, usize) {
        let (beyond, [_, to]) = (self.sides[s].across & ID, self.ends(FaceId::new(f), s));
        let entry = self.side_from(FaceId::new(beyond), to.number());
        (beyond, entry.expect("behind an open side is a face of the mesh"))
    }
}

impl Junctions {
    fn new(mesh: &NavMesh) -> Self {
        let mut result = Self { spots: vec![NONE; mesh.faces.len()], starts: vec![0], ..Self::default() };
        result.add(mesh, &mesh.core_along_curve(), &[]);
        result.faces.shrink_to_fit();
        result.starts.shrink_to_fit();
        result.reduced_corridors.shrink_to_fit();
        result.row.shrink_to_fit();
        result.portals.shrink_to_fit();
        result.links.shrink_to_fit();
        result
    }

    /// Takes in faces that are no dead ends and have no spot, with all reduced corridors to and between them. `cut` are junctions
    /// that have lost links.
    fn add(&mut self, mesh: &NavMesh, core: &[u32], cut: &[u32]) {
        let first = self.faces.len() as u32;
        for &f in core {
            let ways_on = mesh.ways_on(f).count();
            if ways_on >= 3 {
                self.spots[f as usize] = CROSSING | self.faces.len() as u32;
                self.faces.push(f);
                self.links.extend((0..ways_on).map(|_| Link { to: NONE, portals: 0, by: NONE }));
                self.starts.push(self.links.len() as u32);
            }
        }
        let mut exits = Exits::default();
        for c in (first..self.faces.len() as u32).chain(cut.iter().copied()) {
            for (i, s) in mesh.ways_on(self.face(c)).enumerate() {
                if self.links(c)[i].by == NONE {
                    self.follow(mesh, c, s, &mut exits);
                }
            }
        }
        for &f in core {
            if self.spots[f as usize] == NONE {
                self.go_round(mesh, f);
            }
        }
    }

    /// Brings junctions and reduced corridors up to date after a change: `faces` are all those that have come or gone, or whose
    /// exits have changed. Returns whether it is worth to keep the whole.
    pub(super) fn mend(&mut self, mesh: &NavMesh, faces: &[u32]) -> bool {
        self.spots.resize(mesh.faces.len().max(self.spots.len()), NONE);
        let (mut loose, mut cut) = (faces.to_vec(), Vec::new());
        for &f in faces {
            match self.spots[f as usize] {
                NONE => {}
                spot if spot & CROSSING != 0 => self.drop_junction(spot & !CROSSING, &mut loose, &mut cut),
                spot => self.drop_reduced_corridor(self.reduced_corridor_at(spot), &mut loose, &mut cut),
            }
        }
        if 2 * self.spent > self.links.len() + self.row.len() + 64 {
            return false;
        }
        loose.retain(|&f| mesh.is_core(f));
        cut.retain(|&c| self.faces[c as usize] != NONE);
        self.add(mesh, &sorted(loose), &sorted(cut));
        true
    }

    fn drop_junction(&mut self, c: u32, loose: &mut Vec<u32>, cut: &mut Vec<u32>) {
        let f = std::mem::replace(&mut self.faces[c as usize], NONE);
        self.spots[f as usize] = NONE;
        loose.push(f);
        let links = self.starts[c as usize] as usize..self.starts[c as usize + 1] as usize;
        self.spent += links.len();
        for i in links {
            if self.links[i].by != NONE {
                self.drop_reduced_corridor(self.links[i].by >> 1, loose, cut);
            }
        }
    }

    fn drop_reduced_corridor(&mut self, p: u32, loose: &mut Vec<u32>, cut: &mut Vec<u32>) {
        let CorridorRecord { ends, first, end } = self.reduced_corridors[p as usize];
        self.reduced_corridors[p as usize].ends[0] = DROPPED;
        self.spent += (end - first) as usize;
        for place in first..end {
            let f = self.row[place as usize];
            self.spots[f as usize] = NONE;
            loose.push(f);
        }
        for c in ends.into_iter().filter(|&c| c != NONE) {
            let links = self.starts[c as usize] as usize..self.starts[c as usize + 1] as usize;
            for link in self.links[links].iter_mut().filter(|link| link.by != NONE && link.by >> 1 == p) {
                *link = Link { to: NONE, portals: 0, by: NONE };
            }
            cut.push(c);
        }
    }

    /// Follows side `s` of junction `c` to the next junction.
    fn follow(&mut self, mesh: &NavMesh, c: u32, s: usize, exits: &mut Exits) {
        let first = self.row.len();
        let endpoints = |f: u32, s: usize| mesh.ends(FaceId::new(f), s).map(VertexId::number);
        self.portals.push(endpoints(self.face(c), s));
        let (mut f, mut entry) = mesh.beyond(self.face(c), s);
        while self.spots[f as usize] == NONE {
            self.stand(f);
            let on = mesh.ways_on(f).find(|&on| on != entry).expect("no junction and no dead end: two exits");
            self.portals.push(endpoints(f, on));
            (f, entry) = mesh.beyond(f, on);
        }
        debug_assert_ne!(self.spots[f as usize] & CROSSING, 0, "f{f} is in another reduced corridor");
        let (to, portals) = (self.spots[f as usize] & !CROSSING, (self.row.len() - first + 1) as u32);
        let by = 2 * self.end_reduced_corridor([c, to], first);
        let mut link = |c: u32, s: usize| self.starts[c as usize] as usize + exits.place(mesh, self.face(c), s);
        let [there, back] = [link(c, s), link(to, entry)];
        self.links[there] = Link { to, portals, by };
        self.links[back] = Link { to: c, portals, by: by + 1 };
    }

    /// Follows a component without a junction round to where it began.
    fn go_round(&mut self, mesh: &NavMesh, start: u32) {
        let first = self.row.len();
        self.stand(start);
        let (mut at, mut side) = (start, mesh.ways_on(start).next());
        while let Some((f, entry)) = side.map(|s| mesh.beyond(at, s)).filter(|&(f, _)| f != start) {
            self.stand(f);
            (at, side) = (f, mesh.ways_on(f).find(|&on| on != entry));
        }
        self.end_reduced_corridor([NONE; 2], first);
    }

    /// Puts a face at the end of the row.
    fn stand(&mut self, f: u32) {
        self.spots[f as usize] = self.row.len() as u32;
        self.row.push(f);
    }

    fn end_reduced_corridor(&mut self, ends: [u32; 2], first: usize) -> u32 {
        self.reduced_corridors.push(CorridorRecord { ends, first: first as u32, end: self.row.len() as u32 });
        // Nobody asks for those of a circle.
        self.portals.resize(self.row.len() + self.reduced_corridors.len(), [NONE; 2]);
        self.reduced_corridors.len() as u32 - 1
    }

    /// How many junctions there are, and were.
    pub(super) fn len(&self) -> usize {
        self.faces.len()
    }

    /// The face of a junction.
    #[inline]
    pub(super) fn face(&self, c: u32) -> u32 {
        self.faces[c as usize]
    }

    /// The exits from a junction.
    #[inline]
    pub(super) fn links(&self, c: u32) -> &[Link] {
        &self.links[self.starts[c as usize] as usize..self.starts[c as usize + 1] as usize]
    }

    #[inline]
    pub(super) fn reduced_corridor(&self, p: u32) -> CorridorRecord {
        self.reduced_corridors[p as usize]
    }

    /// The endpoints of its portals, the right one first for who runs from its first end to its second: `portals[i]` leads
    /// from place i to place i + 1, where place 0 is the junction before the first face.
    #[inline]
    pub(super) fn portals(&self, p: u32) -> &[[u32; 2]] {
        let range = self.reduced_corridor(p).range();
        &self.portals[range.start + p as usize..=range.end + p as usize]
    }

    /// The face at a place of a reduced corridor that is no circle.
    #[inline]
    pub(super) fn face_at(&self, p: u32, place: u32) -> u32 {
        let CorridorRecord { ends, first, end } = self.reduced_corridor(p);
        if place == 0 {
            self.face(ends[0])
        } else if place <= end - first {
            self.row[(first + place - 1) as usize]
        } else {
            self.face(ends[1])
        }
    }

    /// The faces of all reduced corridors, one reduced corridor after the other.
    #[inline]
    pub(super) fn row(&self) -> &[u32] {
        &self.row
    }

    /// Where a face is that is no dead end: see `spots`.
    #[inline]
    pub(super) fn spot(&self, f: u32) -> u32 {
        self.spots[f as usize]
    }

    /// The reduced corridor that has a place in `row`. O(log n).
    pub(super) fn reduced_corridor_at(&self, place: u32) -> u32 {
        self.reduced_corridors.partition_point(|reduced_corridor| reduced_corridor.end <= place) as u32
    }

    pub(super) fn memory(&self) -> usize {
        size_of_val(&*self.faces)
            + size_of_val(&*self.starts)
            + size_of_val(&*self.links)
            + size_of_val(&*self.reduced_corridors)
            + size_of_val(&*self.row)
            + size_of_val(&*self.portals)
            + size_of_val(&*self.spots)
    }
}
