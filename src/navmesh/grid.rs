//! An index over the faces: the plane in equal cells, each with the faces that may reach into it.
//!
//! ```text
//!   ┌────┬────┬────┐    A point's cell is found by two products. A cell with one face, or with one gap and no face,
//!   │  ╲ │  . │    │    is the answer. Else its faces are looked at, most of them on a lattice only (`coarse.rs`).
//!   ├───╲┼────┼────┤    If none has the point it lies in a gap: most cells see one gap only, and know it. In a cell
//!   │    ╲    │    │    that sees several, a ray to the left tells which: the first border it meets is the border of
//!   └────┴╲───┴────┘    that gap.
//! ```
//!
//! Point to cell is a monotone function of each coordinate, and cells take in too many faces rather than too few, so
//! rounding never loses a face. One cell for two faces: some 16 bytes a face, and 12 for the lattice. Where faces are so
//! long and thin that they would be listed very often, the cells are made larger, and points are asked of another index
//! (`slivers.rs`).
//!
//! When faces come and go, the cells they reach into are written anew, and no others (`mend`). A list that has become
//! too long for its place is put behind the last one; once half of all places are spent, the lists close ranks. Only
//! when there are twice as many entries as in the beginning the whole is made anew, with smaller cells.

use super::coarse::Coarse;
use super::mesh::{CLOSED, ID, NavMesh};
use super::records::FaceTable;
use super::slivers::Slivers;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::plane::predicates::orientation;
use crate::plane::{Point, Subdivision};
use std::collections::BTreeMap;

/// In an item: no face, but the gap that the cell sees. It is the last item of its cell.
const GAP: u32 = 1 << 31;
/// In an item: a face, and the last item of its cell.
const LAST: u32 = 1 << 30;
/// The most cells there are, so that items can be numbered without these two marks.
const MOST_CELLS: f64 = 134_217_728.0;
/// How often faces and edges between gaps may be listed, on average, before the cells are made larger.
const MOST_LISTED: f64 = 16.0;
/// The cell sees several gaps.
const SEVERAL: u32 = GAP | ID;
/// The cell sees no border at all.
const NOTHING: u32 = SEVERAL - 1;

/// An edge between two gaps: between a hole and the outer face.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct GapEdge {
    /// The ends, the lower one first.
    ends: [VertexId; 2],
    /// The names of the gaps on the left and on the right.
    gaps: [u32; 2],
}

impl GapEdge {
    /// All edges of the map between two different gaps. O(n).
    pub(super) fn all(map: &Subdivision, mesh: &NavMesh) -> Vec<Self> {
        let halves = map.edges().flat_map(EdgeId::half_edges);
        let is_up = |h: &HalfEdgeId| map.point(map.origin(*h)).y <= map.point(map.destination(*h)).y;
        let between = |h: &HalfEdgeId| {
            let gaps = [map.face(*h), map.face(h.twin())];
            gaps[0] != gaps[1] && !gaps.into_iter().any(|f| mesh.has_face(f))
        };
        let edge = |h: HalfEdgeId| Self {
            ends: [map.origin(h), map.destination(h)],
            gaps: [map.face(h), map.face(h.twin())].map(|f| mesh.gap_name(f.number())),
        };
        halves.filter(is_up).filter(between).map(edge).filter(|edge| edge.gaps[0] != edge.gaps[1]).collect()
    }

    fn points(&self, mesh: &NavMesh) -> [Point; 2] {
        self.ends.map(|v| mesh.point(v))
    }
}

/// What the index says of a point at first sight.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Look {
    /// Strictly inside this face.
    Face(u32),
    /// In no face, but in this gap.
    Gap(u32),
    /// In no face.
    SomeGap,
    /// The signs have to be asked.
    Unclear,
}

fn look_at_gap(item: u32) -> Look {
    if item == SEVERAL || item == NOTHING { Look::SomeGap } else { Look::Gap(item & ID) }
}

#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Grid {
    min: Point,
    max: Point,
    /// Cells per unit.
    scale: [f64; 2],
    columns: usize,
    rows: usize,
    /// Per cell its only item, which is marked as the last one, or where its items start.
    cells: Vec<u32>,
    /// Per cell with several items its faces, then at most one gap.
    items: Vec<u32>,
    /// How many places of `items` are of no use any more.
    spent: usize,
    /// How many entries the cells have, and had when they were made.
    entries: [usize; 2],
    /// How many cells were written since they were made.
    written: usize,
    coarse: Coarse,
    gap_edges: Vec<GapEdge>,
    /// The edges between gaps that reach into each cell: the cell, and which edge.
    gap_cells: Vec<(u32, u32)>,
    /// The index that is asked if cells of one size would see too many faces each.
    slivers: Option<Box<Slivers>>,
    /// On a map of slivers the faces that came later, per cell.
    late: BTreeMap<u32, Vec<u32>>,
    late_count: usize,
}

impl Grid {
    /// An index over all faces of the mesh. O(n) for faces of about one size; where faces are long and thin, that of
    /// `slivers`.
    pub(super) fn new(mesh: &NavMesh, gap_edges: Vec<GapEdge>, slivers: impl FnOnce() -> Slivers) -> Self {
        let corners = mesh.faces().flat_map(|f| mesh.corners(f));
        let corners = corners.chain(gap_edges.iter().flat_map(|edge| edge.ends)).map(|v| mesh.point(v));
        let first = corners.clone().next().unwrap_or_default();
        let (min, max) = corners.fold((first, first), |(min, max), p| {
            (Point::new(min.x.min(p.x), min.y.min(p.y)), Point::new(max.x.max(p.x), max.y.max(p.y)))
        });
        let count = (mesh.face_count() as f64 / 2.0).clamp(1.0, MOST_CELLS);
        let [width, height] = [max.x - min.x, max.y - min.y];
        let mut columns = (count * (width / height)).sqrt().clamp(1.0, count).ceil();
        let mut rows = (count / columns).ceil().max(1.0);
        // A convex face is listed once for each column and each row it runs through, about, and inside.
        let [across, up] = extents(mesh, &gap_edges);
        let places = across / width * columns + up / height * rows;
        let most = MOST_LISTED * (mesh.face_count() + gap_edges.len()) as f64;
        let is_crowded = places > most;
        if is_crowded {
            // Once each, about: whoever looks for faces near a point still finds them by the cells.
            let smaller = most / (MOST_LISTED * places);
            (columns, rows) = ((columns * smaller).ceil(), (rows * smaller).ceil());
        }
        let mut grid = Self {
            min,
            max,
            scale: [columns / width, rows / height],
            columns: columns as usize,
            rows: rows as usize,
            cells: Vec::new(),
            items: Vec::new(),
            spent: 0,
            entries: [0; 2],
            written: 0,
            coarse: Coarse::new(min, max),
            gap_edges: Vec::new(),
            gap_cells: Vec::new(),
            slivers: is_crowded.then(|| Box::new(slivers())),
            late: BTreeMap::new(),
            late_count: 0,
        };
        let mut gap_cells = Vec::new();
        for (i, edge) in (0..).zip(&gap_edges) {
            grid.visit_cells(&edge.points(mesh), |cell| gap_cells.push((cell, i)));
        }
        gap_cells.sort_unstable();
        (grid.gap_edges, grid.gap_cells) = (gap_edges, gap_cells);
        grid.fill(mesh);
        grid.name_empty_cells(mesh);
        grid.order_items(mesh);
        grid
    }

    /// Bytes of the arrays.
    pub(super) fn memory(&self) -> usize {
        4 * (self.cells.len() + self.items.len() + self.late_count)
            + size_of_val(&*self.gap_edges)
            + size_of_val(&*self.gap_cells)
            + self.coarse.memory()
            + self.slivers.as_ref().map_or(0, |slivers| slivers.memory())
    }

    /// The index to ask before this one, if there is one.
    #[inline]
    pub(super) fn slivers(&self) -> Option<&Slivers> {
        self.slivers.as_deref()
    }

    /// The faces that came later and may have the point, on a map of slivers.
    pub(super) fn late_faces(&self, p: Point) -> &[u32] {
        let [column, row] = self.cell(p);
        self.late.get(&((row * self.columns + column) as u32)).map_or(&[], Vec::as_slice)
    }

    /// Whether no face came later, on a map of slivers.
    pub(super) fn is_fresh(&self) -> bool {
        self.late.is_empty()
    }

    /// How many cells were written since they were made.
    pub(super) fn written(&self) -> usize {
        self.written
    }

    /// Another index over the mesh as it is now: the gaps are what they were. O(n), as [`new`](Self::new).
    pub(super) fn anew(&mut self, mesh: &NavMesh, slivers: impl FnOnce() -> Slivers) -> Self {
        let mut other = Self::new(mesh, std::mem::take(&mut self.gap_edges), slivers);
        other.written = self.written + other.cells.len();
        other
    }

    /// The column and the row of a point; points outside go to the nearest cell.
    #[inline]
    pub(super) fn cell(&self, p: Point) -> [usize; 2] {
        // A cast of a negative number gives 0.
        let column = ((p.x - self.min.x) * self.scale[0]) as usize;
        let row = ((p.y - self.min.y) * self.scale[1]) as usize;
        [column.min(self.columns - 1), row.min(self.rows - 1)]
    }

    /// Whether a point is in the box round all faces; never so for coordinates that are no numbers.
    #[inline]
    pub(super) fn contains(&self, p: Point) -> bool {
        p.x >= self.min.x && p.x <= self.max.x && p.y >= self.min.y && p.y <= self.max.y
    }

    /// The point of the box that is the closest to `p`, which has no coordinate that is no number.
    pub(super) fn clamp(&self, p: Point) -> Point {
        Point::new(p.x.clamp(self.min.x, self.max.x), p.y.clamp(self.min.y, self.max.y))
    }

    /// The lower left and the upper right corner of the box round all faces.
    pub(super) fn corners(&self) -> [Point; 2] {
        [self.min, self.max]
    }

    /// How many columns and rows.
    pub(super) fn size(&self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// The shorter side of a cell.
    pub(super) fn step(&self) -> f64 {
        (1.0 / self.scale[0]).min(1.0 / self.scale[1])
    }

    /// The items of a cell as it was built, and some that are not its own behind the last one.
    #[inline]
    fn items(&self, cell: usize) -> &[u32] {
        let word = &self.cells[cell];
        if *word & (GAP | LAST) == 0 { &self.items[*word as usize..] } else { std::slice::from_ref(word) }
    }

    /// The faces that may reach into a cell.
    #[inline]
    pub(super) fn faces(&self, [column, row]: [usize; 2]) -> impl Iterator<Item = u32> + '_ {
        let cell = row * self.columns + column;
        let late = if self.late.is_empty() { None } else { self.late.get(&(cell as u32)) };
        let mut more = true;
        let built = self.items(cell).iter().map_while(move |&item| {
            let is_face = more && item & GAP == 0;
            more = item & LAST == 0;
            is_face.then_some(item & ID)
        });
        built.chain(late.into_iter().flatten().copied())
    }

    /// The column and the row of a cell that [`visit_cells`](Self::visit_cells) told.
    pub(super) fn place_of(&self, cell: u32) -> [usize; 2] {
        [cell as usize % self.columns, cell as usize / self.columns]
    }

    /// What is plain to see of a point of the box.
    #[inline]
    pub(super) fn look(&self, faces: &FaceTable, p: Point) -> Look {
        let [column, row] = self.cell(p);
        let cell = row * self.columns + column;
        let word = self.cells[cell];
        if word & (GAP | LAST) != 0 {
            return if word & GAP == 0 { Look::Face(word & ID) } else { look_at_gap(word) };
        }
        let place = self.coarse.place(p);
        for &item in &self.items[word as usize..] {
            if item & GAP != 0 {
                return look_at_gap(item);
            }
            match self.coarse.is_inside(slot_of(faces, item & ID), place) {
                Some(true) => return Look::Face(item & ID),
                Some(false) if item & LAST == 0 => {}
                _ => break,
            }
        }
        Look::Unclear
    }

    /// The cells that list a face of this shape.
    pub(super) fn cells_of(&self, mesh: &NavMesh, f: FaceId, cells: &mut Vec<(u32, u32)>) {
        let corners: Vec<Point> = mesh.corners(f).map(|v| mesh.point(v)).collect();
        self.visit_cells(&corners, |cell| cells.push((cell, f.number())));
    }

    /// Lists faces anew: `gone` are the cells of those that are no more, or had another shape, as
    /// [`cells_of`](Self::cells_of) told before; `come` are those that are new, or have another shape now.
    ///
    /// Cost: O(k log k) for k entries of the cells they reach into.
    pub(super) fn mend(&mut self, mesh: &NavMesh, mut gone: Vec<(u32, u32)>, come: &[FaceId]) {
        if self.slivers.is_some() {
            return self.mend_late(mesh, come);
        }
        gone.sort_unstable();
        let (mut entries, mut corners) = (Vec::new(), Vec::new());
        for &f in come {
            corners.clear();
            corners.extend(mesh.corners(f).map(|v| mesh.point(v)));
            self.list(mesh, f, &corners, &mut entries);
            self.coarse.put(slot_of(&mesh.faces, f.number()), &corners);
        }
        entries.sort_unstable();
        entries.dedup();
        let (mut gone, mut come) = (gone.as_slice(), entries.as_slice());
        let (mut faces, mut gaps): (Vec<u32>, Vec<u32>) = (Vec::new(), Vec::new());
        while let Some(cell) = gone.first().into_iter().chain(come.first()).map(|&(cell, _)| cell).min() {
            let of_cell = |list: &[(u32, u32)]| list.iter().take_while(|&&(other, _)| other == cell).count();
            let (lost, got);
            (lost, gone) = gone.split_at(of_cell(gone));
            (got, come) = come.split_at(of_cell(come));
            faces.clear();
            gaps.clear();
            let is_lost = |f: u32| lost.iter().any(|&(_, other)| other == f);
            for &item in self.own_items(cell as usize) {
                if item & GAP != 0 {
                    gaps.push(item);
                } else if !is_lost(item & ID) {
                    faces.push(item & ID);
                }
            }
            for &(_, item) in got {
                let list = if item & GAP != 0 { &mut gaps } else { &mut faces };
                if !list.contains(&item) {
                    list.push(item);
                }
            }
            self.write_cell(mesh, cell as usize, &mut faces, &gaps);
        }
        if 2 * self.spent > self.items.len() + 64 {
            self.close_ranks();
        }
    }

    /// On a map of slivers: whatever another face has lost, one of these must have got.
    fn mend_late(&mut self, mesh: &NavMesh, come: &[FaceId]) {
        let mut cells = Vec::new();
        come.iter().for_each(|&f| self.cells_of(mesh, f, &mut cells));
        for (cell, f) in cells {
            let here = self.late.entry(cell).or_default();
            if !here.contains(&f) {
                here.push(f);
                self.late_count += 1;
                self.written += 1;
            }
        }
    }

    /// Whether so much has come that a new index is worth its cost.
    pub(super) fn is_stale(&self) -> bool {
        self.late_count > 64 + self.items.len() / 2 || self.entries[0] > 2 * self.entries[1] + 64
    }

    /// The items of a cell, with their marks; nothing for one that has none.
    fn own_items(&self, cell: usize) -> &[u32] {
        let items = self.items(cell);
        let last = items.iter().position(|item| item & (GAP | LAST) != 0).map_or(items.len(), |last| last + 1);
        if items[0] == NOTHING { &[] } else { &items[..last] }
    }

    /// Writes the items of a cell anew.
    fn write_cell(&mut self, mesh: &NavMesh, cell: usize, faces: &mut [u32], gaps: &[u32]) {
        self.written += 1;
        let before = self.own_items(cell).len();
        let old_place = (self.cells[cell] & (GAP | LAST) == 0).then_some(self.cells[cell] as usize);
        // The face that has the middle comes first.
        let middle = self.coarse.place(self.middle([cell % self.columns, cell / self.columns]));
        let has_it = |&f: &u32| self.coarse.is_inside(slot_of(&mesh.faces, f), middle) == Some(true);
        if let Some(first) = faces.iter().position(has_it) {
            faces.swap(0, first);
        }
        let gap = gaps.first().map(|&first| if gaps.iter().all(|&gap| gap == first) { first } else { SEVERAL });
        if let (Some(last), None) = (faces.last_mut(), gap) {
            *last |= LAST;
        }
        let count = faces.len() + usize::from(gap.is_some());
        self.entries[0] = (self.entries[0] + count).saturating_sub(before);
        let spent = old_place.map_or(0, |_| before);
        if count <= 1 {
            self.spent += spent;
            self.cells[cell] = faces.first().copied().or(gap).unwrap_or(NOTHING);
            return;
        }
        let place = old_place.filter(|_| count <= before).unwrap_or(self.items.len());
        if place == self.items.len() {
            self.spent += spent;
            self.items.resize(place + count, 0);
        } else {
            self.spent += before - count;
        }
        self.items[place..place + faces.len()].copy_from_slice(faces);
        if let Some(gap) = gap {
            self.items[place + count - 1] = gap;
        }
        self.cells[cell] = place as u32;
    }

    /// Leaves out the places that no cell has.
    fn close_ranks(&mut self) {
        let mut items = Vec::with_capacity(self.items.len() - self.spent + self.spent / 4);
        for cell in 0..self.cells.len() {
            if self.cells[cell] & (GAP | LAST) == 0 {
                let start = items.len();
                items.extend_from_slice(self.own_items(cell));
                self.cells[cell] = start as u32;
            }
        }
        (self.items, self.spent) = (items, 0);
    }

    /// Appends for each cell into which a face reaches that face, and the gaps behind its sides that reach there.
    fn list(&self, mesh: &NavMesh, f: FaceId, corners: &[Point], entries: &mut Vec<(u32, u32)>) {
        self.visit_cells(corners, |cell| entries.push((cell, f.number())));
        for (side, s) in mesh.sides_of(f).iter().zip(mesh.range(f)) {
            let gap = side.across & ID;
            if side.across & CLOSED != 0 && !mesh.has_face(FaceId::new(gap)) {
                let (ends, name) = (mesh.ends(f, s).map(|v| mesh.point(v)), mesh.gap_name(gap));
                self.visit_cells(&ends, |cell| entries.push((cell, GAP | name)));
            }
        }
    }

    fn fill(&mut self, mesh: &NavMesh) {
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        let mut corners = Vec::new();
        for f in mesh.faces() {
            corners.clear();
            corners.extend(mesh.corners(f).map(|v| mesh.point(v)));
            self.coarse.put(slot_of(&mesh.faces, f.number()), &corners);
            self.list(mesh, f, &corners, &mut pairs);
        }
        let by_edge = self.gap_cells.iter();
        pairs.extend(by_edge.flat_map(|&(cell, i)| self.gap_edges[i as usize].gaps.map(|gap| (cell, GAP | gap))));
        let cells = self.columns * self.rows;
        let mut ends = vec![0u32; cells + 1];
        pairs.iter().for_each(|&(cell, _)| ends[cell as usize + 1] += 1);
        (0..cells).for_each(|cell| ends[cell + 1] += ends[cell]);
        let mut sorted = vec![0u32; pairs.len()];
        let mut at = ends.clone();
        for (cell, item) in pairs {
            sorted[at[cell as usize] as usize] = item;
            at[cell as usize] += 1;
        }
        self.cells = Vec::with_capacity(cells);
        self.items = Vec::with_capacity(sorted.len());
        for cell in 0..cells {
            let start = self.items.len();
            let here = &sorted[ends[cell] as usize..ends[cell + 1] as usize];
            self.items.extend(here.iter().filter(|&&item| item & GAP == 0));
            let mut gaps = here.iter().copied().filter(|&item| item & GAP != 0);
            if let Some(first) = gaps.next() {
                self.items.push(if gaps.all(|gap| gap == first) { first } else { SEVERAL });
            }
            self.cells.push(match self.items[start..] {
                [] => NOTHING,
                [only] => {
                    self.items.truncate(start);
                    only | if only & GAP == 0 { LAST } else { 0 }
                }
                _ => start as u32,
            });
        }
        self.items.shrink_to_fit();
        let inline = self.cells.iter().filter(|&&word| word & (GAP | LAST) != 0 && word != NOTHING).count();
        self.entries = [self.items.len() + inline; 2];
    }

    /// Of the faces of a cell the one that has its middle comes first: most points are there. The last item is marked.
    fn order_items(&mut self, mesh: &NavMesh) {
        let mut end = self.items.len();
        for cell in (0..self.cells.len()).rev().filter(|&cell| self.cells[cell] & (GAP | LAST) == 0) {
            let middle = self.middle([cell % self.columns, cell / self.columns]);
            let start = self.cells[cell] as usize;
            let here = &mut self.items[start..end];
            let has_it = |item: u32| item & GAP == 0 && mesh.spot_of_near(FaceId::new(item), middle).is_some();
            if let Some(i) = here.iter().position(|&item| has_it(item)) {
                here.swap(0, i);
            }
            if let Some(last) = here.last_mut().filter(|last| **last & GAP == 0) {
                *last |= LAST;
            }
            end = start;
        }
    }

    /// The middle of a cell, rounded.
    fn middle(&self, [column, row]: [usize; 2]) -> Point {
        let [x, y] = [(column, self.scale[0]), (row, self.scale[1])].map(|(i, scale)| (i as f64 + 0.5) / scale);
        Point::new(self.min.x + x, self.min.y + y)
    }

    /// Cells without any face lie in one gap each: that of the cell on their left, or the first on a ray.
    fn name_empty_cells(&mut self, mesh: &NavMesh) {
        for row in 0..self.rows {
            let mut left = Some(GAP);
            for column in 0..self.columns {
                let cell = row * self.columns + column;
                if self.cells[cell] != NOTHING {
                    left = None;
                    continue;
                }
                let middle = self.middle([column, row]);
                let gap = left.unwrap_or_else(|| GAP | self.gap_by_ray(mesh, middle, [column, row]));
                self.cells[cell] = gap;
                left = Some(gap);
            }
        }
    }

    /// The gap in which a point lies that is in no face. O(1) in most cells, else O(faces along the row).
    pub(super) fn gap(&self, mesh: &NavMesh, p: Point) -> FaceId {
        if !self.contains(p) {
            return FaceId::new(0);
        }
        let cell = self.cell(p);
        let mut items = self.items(cell[1] * self.columns + cell[0]).iter().copied();
        let known = items.find(|item| item & (GAP | LAST) != 0);
        match known {
            Some(gap) if gap & GAP != 0 && gap != SEVERAL => FaceId::new(gap & ID),
            _ => FaceId::new(self.gap_by_ray(mesh, p, cell)),
        }
    }

    /// The gap behind the first border that a ray from `p` to the left meets; an end of a border that lies at the
    /// height of `p` counts as below. `p` is in no face, and in the cell or near it.
    fn gap_by_ray(&self, mesh: &NavMesh, p: Point, [column, row]: [usize; 2]) -> u32 {
        let mut nearest: Option<([Point; 2], u32)> = None;
        for column in (0..=column).rev() {
            for f in self.faces([column, row]) {
                let f = FaceId::new(f);
                for (side, s) in mesh.sides_of(f).iter().zip(mesh.range(f)) {
                    let gap = side.across & ID;
                    if side.across & CLOSED == 0 || mesh.has_face(FaceId::new(gap)) {
                        continue;
                    }
                    let [a, b] = mesh.ends(f, s).map(|v| mesh.point(v));
                    // With the gap on its right, towards p, the border runs up.
                    let met = a.y <= p.y && b.y > p.y && orientation(a, b, p).is_lt();
                    if met && nearest.is_none_or(|(other, _)| is_right_of([a, b], other)) {
                        nearest = Some(([a, b], mesh.gap_name(gap)));
                    }
                }
            }
            let cell = (row * self.columns + column) as u32;
            let first = self.gap_cells.partition_point(|&(other, _)| other < cell);
            for &(_, i) in self.gap_cells[first..].iter().take_while(|&&(other, _)| other == cell) {
                let edge = &self.gap_edges[i as usize];
                let [a, b] = edge.points(mesh);
                let met = a.y <= p.y && b.y > p.y && orientation(a, b, p).is_lt();
                if met && nearest.is_none_or(|(other, _)| is_right_of([a, b], other)) {
                    nearest = Some(([a, b], edge.gaps[1]));
                }
            }
            // Whatever is met right of the left side of this cell has been seen by now.
            if let Some(([a, b], gap)) = nearest {
                let met = a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)).clamp(0.0, 1.0);
                if met >= self.min.x + (column as f64 + 0.001) / self.scale[0] {
                    return gap;
                }
            }
        }
        nearest.map_or(0, |(_, gap)| gap)
    }

    /// Calls `visit` with every cell that the convex polygon may reach into, and perhaps some beside it.
    pub(super) fn visit_cells(&self, corners: &[Point], mut visit: impl FnMut(u32)) {
        let size = |of: fn(&Point) -> f64| corners.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        let [bottom, top] = [-size(|p| -p.y), size(|p| p.y)];
        let largest = [self.min, self.max].iter().flat_map(|p| [p.x.abs(), p.y.abs()]).fold(0.0, f64::max);
        // More than the rounding of what follows: the line between two rows, and where a side meets it.
        let slack = largest * 2f64.powi(-49);
        let [_, first] = self.cell(Point::new(self.min.x, bottom));
        let [_, last] = self.cell(Point::new(self.min.x, top));
        for row in first..=last {
            let below = self.min.y + row as f64 / self.scale[1] - slack;
            let above = self.min.y + (row + 1) as f64 / self.scale[1] + slack;
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for (i, &a) in corners.iter().enumerate() {
                let b = corners[(i + 1) % corners.len()];
                let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
                if first != last && (high.y < below || low.y > above) {
                    continue;
                }
                let at = |y: f64, end: Point, beyond: bool| {
                    if beyond {
                        low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y)).clamp(0.0, 1.0)
                    } else {
                        end.x
                    }
                };
                for x in [at(below, low, low.y < below), at(above, high, high.y > above)] {
                    (left, right) = (left.min(x), right.max(x));
                }
            }
            let [from, _] = self.cell(Point::new(left - slack, self.min.y));
            let [to, _] = self.cell(Point::new(right + slack, self.min.y));
            (from..=to).for_each(|column| visit((row * self.columns + column) as u32));
        }
    }
}

/// Where the face is on the lattice.
#[inline]
fn slot_of(faces: &FaceTable, f: u32) -> u32 {
    faces.slot(f as usize).map_or(f, |slot| slot as u32)
}

/// The widths and the heights of all faces and edges between gaps, added. O(n).
fn extents(mesh: &NavMesh, gap_edges: &[GapEdge]) -> [f64; 2] {
    let of = |corners: &mut dyn Iterator<Item = Point>| {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let wide = |[low, high]: [f64; 2], x: f64| [low.min(x), high.max(x)];
        corners.fold([none; 2], |[x, y], p| [wide(x, p.x), wide(y, p.y)]).map(|[low, high]| high - low)
    };
    let faces = mesh.faces().map(|f| of(&mut mesh.corners(f).map(|v| mesh.point(v))));
    let edges = gap_edges.iter().map(|edge| of(&mut edge.points(mesh).into_iter()));
    faces.chain(edges).fold([0.0; 2], |[x, y], [width, height]| [x + width, y + height])
}

/// Whether the first border runs right of the second where both meet a horizontal line. They do not cross.
fn is_right_of(one: [Point; 2], other: [Point; 2]) -> bool {
    let upwards = |[a, b]: [Point; 2]| if a.y <= b.y { [a, b] } else { [b, a] };
    let ([a, b], [c, d]) = (upwards(one), upwards(other));
    let turns = if c.y <= a.y {
        [orientation(c, d, a), orientation(c, d, b)].map(std::cmp::Ordering::reverse)
    } else {
        [orientation(a, b, c), orientation(a, b, d)]
    };
    turns[0].then(turns[1]).is_gt()
}
