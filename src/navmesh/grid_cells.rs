//! Faces into the cells of the index, and out of them again.
//!
//! ```text
//!   face ── cells it may reach into ── items of each cell: its faces, the one in the middle first, then a hole
//! ```

use super::NavMesh;
use super::coarse::Coarse;
use super::grid::{GAP, Grid, LAST, NOTHING, SEVERAL, slot_of};
use super::hole_edges::HoleEdge;
use super::marks::{CLOSED, ID};
use super::slivers::Slivers;
use crate::geometry::grouping::{Groups, sorted};
use crate::geometry::point::{around, corners};
use crate::ids::FaceId;
use crate::plane::Point;
use crate::plane::predicates::orientation;

/// The most cells there are, so that items can be numbered without the marks.
const MOST_CELLS: f64 = 134_217_728.0;
/// How often faces and edges between holes may be listed, on average, before the cells are made larger.
const MOST_LISTED: f64 = 16.0;

impl Grid {
    /// An index over all faces of the mesh. O(n) for faces of about one size; where faces are long and thin, that of
    /// `slivers`.
    pub(super) fn new(mesh: &NavMesh, hole_edges: Vec<HoleEdge>, slivers: impl FnOnce() -> Slivers) -> Self {
        let corners = mesh.faces().flat_map(|f| mesh.corners(f));
        let corners = corners.chain(hole_edges.iter().flat_map(|edge| edge.ends)).map(|v| mesh.point(v));
        let first = corners.clone().next().unwrap_or_default();
        let [min, max] = corners.fold([first; 2], around);
        let count = (mesh.face_count() as f64 / 2.0).clamp(1.0, MOST_CELLS);
        let [width, height] = [max.x - min.x, max.y - min.y];
        let mut columns = (count * (width / height)).sqrt().clamp(1.0, count).ceil();
        let mut rows = (count / columns).ceil().max(1.0);
        // A convex face is listed once for each column and each row it runs through, about, and inside.
        let [across, up] = extents(mesh, &hole_edges);
        let places = across / width * columns + up / height * rows;
        let most = MOST_LISTED * (mesh.face_count() + hole_edges.len()) as f64;
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
            coarse: Coarse::new(min, max),
            slivers: is_crowded.then(|| Box::new(slivers())),
            ..Self::default()
        };
        let mut hole_cells = Vec::new();
        for (i, edge) in (0..).zip(&hole_edges) {
            grid.visit_cells(&edge.points(mesh), |cell| hole_cells.push((cell, i)));
        }
        hole_cells.sort_unstable();
        (grid.hole_edges, grid.hole_cells) = (hole_edges, hole_cells);
        grid.fill(mesh);
        grid.name_empty_cells(mesh);
        grid.order_items(mesh);
        grid
    }

    /// Another index over the mesh as it is now: the holes are what they were. O(n), as [`new`](Self::new).
    pub(super) fn anew(&mut self, mesh: &NavMesh, slivers: impl FnOnce() -> Slivers) -> Self {
        let mut other = Self::new(mesh, std::mem::take(&mut self.hole_edges), slivers);
        other.written = self.written + other.cells.len();
        other
    }

    /// The cells that list a face of this shape.
    pub(super) fn cells_of(&self, mesh: &NavMesh, f: FaceId, cells: &mut Vec<(u32, u32)>) {
        let corners: Vec<Point> = mesh.corners(f).map(|v| mesh.point(v)).collect();
        self.visit_cells(&corners, |cell| cells.push((cell, f.number())));
    }

    /// Lists faces anew: `gone` are the cells of those that are no more, or had another shape, as
    /// [`cells_of`](Self::cells_of) told before; `come` are those that are new, or have another shape now.
    ///
    /// Returns whether that is done: not if so many entries would come that the index is to be made anew at once.
    ///
    /// Cost: O(k log k) for k entries of the cells they reach into, and no more than for those of a fresh index.
    pub(super) fn mend(&mut self, mesh: &NavMesh, mut gone: Vec<(u32, u32)>, come: &[FaceId]) -> bool {
        if self.slivers.is_some() {
            return self.mend_late(mesh, come);
        }
        gone.sort_unstable();
        let mut most = (self.most_entries() + gone.len()).saturating_sub(self.entries[0]);
        let (mut entries, mut corners) = (Vec::new(), Vec::new());
        for &f in come {
            let before = entries.len();
            self.list(mesh, f, &mut corners, &mut entries);
            // Entries for holes may be there already.
            let cells = entries[before..].iter().filter(|&&(_, item)| item & GAP == 0).count();
            let Some(left) = most.checked_sub(cells) else { return false };
            most = left;
        }
        let entries = sorted(entries);
        let (mut gone, mut come) = (gone.as_slice(), entries.as_slice());
        let (mut faces, mut holes): (Vec<u32>, Vec<u32>) = (Vec::new(), Vec::new());
        while let Some(cell) = gone.first().into_iter().chain(come.first()).map(|&(cell, _)| cell).min() {
            let of_cell = |list: &[(u32, u32)]| list.iter().take_while(|&&(other, _)| other == cell).count();
            let (lost, got);
            (lost, gone) = gone.split_at(of_cell(gone));
            (got, come) = come.split_at(of_cell(come));
            faces.clear();
            holes.clear();
            let is_lost = |f: u32| lost.iter().any(|&(_, other)| other == f);
            for &item in self.own_items(cell as usize) {
                if item & GAP != 0 {
                    holes.push(item);
                } else if !is_lost(item & ID) {
                    faces.push(item & ID);
                }
            }
            for &(_, item) in got {
                let list = if item & GAP != 0 { &mut holes } else { &mut faces };
                if !list.contains(&item) {
                    list.push(item);
                }
            }
            self.write_cell(mesh, cell as usize, &mut faces, &holes);
        }
        if 2 * self.spent > self.items.len() + 64 {
            self.close_ranks();
        }
        true
    }

    /// On a map of slivers: whatever another face has lost, one of these must have got.
    fn mend_late(&mut self, mesh: &NavMesh, come: &[FaceId]) -> bool {
        let mut cells = Vec::new();
        for &f in come {
            cells.clear();
            self.cells_of(mesh, f, &mut cells);
            for &(cell, f) in &cells {
                let here = self.late.entry(cell).or_default();
                if !here.contains(&f) {
                    here.push(f);
                    self.late_count += 1;
                    self.written += 1;
                }
            }
            if self.late_count > self.most_late() {
                return false;
            }
        }
        true
    }

    /// Writes the items of a cell anew.
    fn write_cell(&mut self, mesh: &NavMesh, cell: usize, faces: &mut [u32], holes: &[u32]) {
        self.written += 1;
        let before = self.own_items(cell).len();
        let old_place = (self.cells[cell] & (GAP | LAST) == 0).then_some(self.cells[cell] as usize);
        // The face that has the middle comes first.
        let middle = self.coarse.place(self.middle([cell % self.columns, cell / self.columns]));
        let has_it = |&f: &u32| self.coarse.is_inside(slot_of(&mesh.faces, f), middle) == Some(true);
        if let Some(first) = faces.iter().position(has_it) {
            faces.swap(0, first);
        }
        let hole = holes.first().map(|&first| if holes.iter().all(|&hole| hole == first) { first } else { SEVERAL });
        if let (Some(last), None) = (faces.last_mut(), hole) {
            *last |= LAST;
        }
        let count = faces.len() + usize::from(hole.is_some());
        self.entries[0] = (self.entries[0] + count).saturating_sub(before);
        let spent = old_place.map_or(0, |_| before);
        if count <= 1 {
            self.spent += spent;
            self.cells[cell] = faces.first().copied().or(hole).unwrap_or(NOTHING);
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
        if let Some(hole) = hole {
            self.items[place + count - 1] = hole;
        }
        self.cells[cell] = place as u32;
    }

    /// Appends for each cell into which a face reaches that face, and the holes behind its sides that reach there. The
    /// coarse lattice takes the face in, too. What `corners` held is gone.
    fn list(&mut self, mesh: &NavMesh, f: FaceId, corners: &mut Vec<Point>, entries: &mut Vec<(u32, u32)>) {
        corners.clear();
        corners.extend(mesh.corners(f).map(|v| mesh.point(v)));
        self.coarse.put(slot_of(&mesh.faces, f.number()), corners);
        self.visit_cells(corners, |cell| entries.push((cell, f.number())));
        for (ends, name) in hole_sides(mesh, f) {
            self.visit_cells(&ends, |cell| entries.push((cell, GAP | name)));
        }
    }

    fn fill(&mut self, mesh: &NavMesh) {
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        let mut corners = Vec::new();
        for f in mesh.faces() {
            self.list(mesh, f, &mut corners, &mut pairs);
        }
        let by_edge = self.hole_cells.iter();
        pairs.extend(by_edge.flat_map(|&(cell, i)| self.hole_edges[i as usize].holes.map(|hole| (cell, GAP | hole))));
        let cells = self.columns * self.rows;
        let by_cell = Groups::new(cells, pairs.iter().map(|&(cell, item)| (cell as usize, item)));
        self.cells = Vec::with_capacity(cells);
        self.items = Vec::with_capacity(pairs.len());
        for cell in 0..cells {
            let start = self.items.len();
            let here = by_cell.of(cell);
            self.items.extend(here.iter().filter(|&&item| item & GAP == 0));
            let mut holes = here.iter().copied().filter(|&item| item & GAP != 0);
            if let Some(first) = holes.next() {
                self.items.push(if holes.all(|hole| hole == first) { first } else { SEVERAL });
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

    /// Cells without any face lie in one hole each: that of the cell on their left, or the first on a ray.
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
                let hole = left.unwrap_or_else(|| GAP | self.hole_by_ray(mesh, middle, [column, row]));
                self.cells[cell] = hole;
                left = Some(hole);
            }
        }
    }

    /// The hole in which a point lies that is in no face. O(1) in most cells, else O(faces along the row).
    pub(super) fn hole(&self, mesh: &NavMesh, p: Point) -> FaceId {
        if !self.contains(p) {
            return FaceId::new(0);
        }
        let cell = self.cell(p);
        let mut items = self.items(cell[1] * self.columns + cell[0]).iter().copied();
        let known = items.find(|item| item & (GAP | LAST) != 0);
        match known {
            Some(hole) if hole & GAP != 0 && hole != SEVERAL => FaceId::new(hole & ID),
            _ => FaceId::new(self.hole_by_ray(mesh, p, cell)),
        }
    }

    /// The hole behind the first border that a ray from `p` to the left meets; an end of a border that lies at the
    /// height of `p` counts as below. `p` is in no face, and in the cell or near it.
    fn hole_by_ray(&self, mesh: &NavMesh, p: Point, [column, row]: [usize; 2]) -> u32 {
        let mut nearest: Option<([Point; 2], u32)> = None;
        for column in (0..=column).rev() {
            let sides = self.faces([column, row]).flat_map(|f| hole_sides(mesh, FaceId::new(f)));
            let cell = (row * self.columns + column) as u32;
            let first = self.hole_cells.partition_point(|&(other, _)| other < cell);
            let edges = self.hole_cells[first..].iter().take_while(|&&(other, _)| other == cell).map(|&(_, i)| {
                let edge = &self.hole_edges[i as usize];
                (edge.points(mesh), edge.holes[1])
            });
            for ([a, b], hole) in sides.chain(edges) {
                // With the hole on its right, towards p, the border runs up.
                let met = a.y <= p.y && b.y > p.y && orientation(a, b, p).is_lt();
                if met && nearest.is_none_or(|(other, _)| is_right_of([a, b], other)) {
                    nearest = Some(([a, b], hole));
                }
            }
            // Whatever is met right of the left side of this cell has been seen by now.
            if let Some(([a, b], hole)) = nearest {
                let met = a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)).clamp(0.0, 1.0);
                if met >= self.min.x + (column as f64 + 0.001) / self.scale[0] {
                    return hole;
                }
            }
        }
        nearest.map_or(0, |(_, hole)| hole)
    }
}

/// The sides of a face behind which is a hole, each with the name of that.
fn hole_sides(mesh: &NavMesh, f: FaceId) -> impl Iterator<Item = ([Point; 2], u32)> + '_ {
    mesh.sides_of(f).iter().zip(mesh.range(f)).filter_map(move |(side, s)| {
        let hole = side.across & ID;
        let is_hole = side.across & CLOSED != 0 && !mesh.has_face(FaceId::new(hole));
        is_hole.then(|| (mesh.ends(f, s).map(|v| mesh.point(v)), mesh.hole_name(hole)))
    })
}

/// The widths and the heights of all faces and edges between holes, added. O(n).
fn extents(mesh: &NavMesh, hole_edges: &[HoleEdge]) -> [f64; 2] {
    let of = |points: &mut dyn Iterator<Item = Point>| {
        let [low, high] = corners(points);
        [high.x - low.x, high.y - low.y]
    };
    let faces = mesh.faces().map(|f| of(&mut mesh.corners(f).map(|v| mesh.point(v))));
    let edges = hole_edges.iter().map(|edge| of(&mut edge.points(mesh).into_iter()));
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
