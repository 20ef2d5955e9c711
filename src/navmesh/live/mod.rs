//! A map with obstacles that come and go.
//!
//! ```text
//!   ┌─────────┐   insert_wall     ┌──●──────┐   the wall is cut into the map by the edits of the plane; faces that
//!   │  f1     │  ────────────>    │  ║╲ f3  │   are no longer convex are cut further; the edges along it are closed
//!   │         │  <────────────    │f1║ ╲    │
//!   └─────────┘   remove          └──●──╲───┘   remove: the wall goes, and the cuts with it
//! ```
//!
//! The flat view is brought up to date near the cut only: faces, fans, turns, dead ends, components, index.
//!
//! ```text
//!   book.rs    what every edge is there for      clear.rs    what goes with an obstacle
//!   insert.rs  cutting an obstacle into the map   cut.rs      making faces convex
//!   refresh.rs the flat view, read anew in parts  back.rs     what comes back under its id
//!   rim.rs     what an obstacle has inside
//! ```

mod back;
mod book;
mod clear;
mod cut;
mod insert;
mod refresh;
mod rim;

use super::{NavMesh, NavMeshError};
use crate::geometry::grouping::sorted;
use crate::ids::{EdgeId, Element, FaceId};
use crate::plane::{ConvertError, InsertSegmentError, Point, Subdivision};
use crate::topology::{Change, Journal, Slot};
use book::Book;
pub use book::ObstacleId;
use clear::clear;
use rim::Rim;
use std::collections::BTreeSet;

/// Why an obstacle cannot be put in or taken out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ObstacleError {
    /// A side cannot be cut into the map.
    #[error("side {side} of the obstacle: {error}")]
    Side {
        /// Which side, from 0.
        side: usize,
        /// Why not.
        error: InsertSegmentError,
    },
    /// The corners are no simple polygon in counter-clockwise order.
    #[error("the obstacle is no simple polygon in counter-clockwise order: {}", .0.of_one_polygon(|corner| corner))]
    Polygon(#[from] ConvertError),
    /// A face could not be cut into convex ones: what is crossed is finer than doubles can tell.
    #[error("{face} cannot be cut into convex faces; move the obstacle a little")]
    Concave {
        /// The face.
        face: FaceId,
    },
    /// A face of the map with the obstacle in it is no face of a navmesh.
    #[error(transparent)]
    Mesh(#[from] NavMeshError),
    /// There is no such obstacle, or it was taken out before.
    #[error("{obstacle} is not in the map: it was never put in, or taken out before")]
    NoSuchObstacle {
        /// The obstacle.
        obstacle: ObstacleId,
    },
}

/// A map, its navmesh, and the obstacles in it.
///
/// ```
/// use dcel_kit::navmesh::{LiveMesh, Planner, PathAlgorithm};
/// use dcel_kit::plane::{Point, Subdivision};
/// let at = |x, y| Point::new(x, y);
/// let hall = Subdivision::polygon(&[at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)])?;
/// let mut live = LiveMesh::new(hall)?;
/// let mut length = |live: &LiveMesh| {
///     Planner::new().route_between(live.mesh(), PathAlgorithm::Exact, at(1., 2.), at(7., 2.)).map(|route| route.length)
/// };
/// assert_eq!(length(&live)?, 6.0);
/// let wall = live.insert_wall(at(4., 1.), at(4., 4.))?;
/// assert_eq!(length(&live)?, 2.0 * 10f64.sqrt());
/// live.remove(wall)?;
/// assert_eq!(length(&live)?, 6.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct LiveMesh {
    map: Subdivision,
    mesh: NavMesh,
    book: Book,
    work: EditWork,
}

/// What the last edit of a [`LiveMesh`] has touched: counts that depend on the obstacle and on what is near it, and not
/// on the size of the map.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct EditWork {
    /// Links of the map that were written.
    pub links: usize,
    /// Faces of the mesh that were read anew, those that went among them.
    pub faces: usize,
    /// Cells of the index for location that were written.
    pub cells: usize,
    /// Faces that were looked at for dead ends and components, each time counted.
    pub visited: usize,
}

impl LiveMesh {
    /// A map without obstacles.
    ///
    /// # Errors
    /// [`NavMeshError`], as for [`NavMesh::new`].
    pub fn new(map: Subdivision) -> Result<Self, NavMeshError> {
        Self::begin(map, Vec::new())
    }

    /// A map without obstacles whose faces are of several areas. Edges between two areas stay where they are; where a
    /// wall crosses one it is split, at the crossing as it is rounded. All other edges between two faces are never
    /// split: they are out while something crosses them.
    ///
    /// # Errors
    /// [`NavMeshError`], as for [`NavMesh::new`].
    ///
    /// ```
    /// use dcel_kit::{EdgeId, navmesh::LiveMesh, plane::{Point, Subdivision}};
    /// let points = [(0., 0.), (4., 0.), (4., 4.), (0., 4.)].map(Point::from);
    /// let map = Subdivision::from_triangles(points.to_vec(), &[[0, 1, 2], [0, 2, 3]])?;
    /// let diagonal = map.edges().find(|e| e.half_edges().iter().all(|&h| map.face(h) != map.outer_face())).expect("one");
    /// let wall = |live: &mut LiveMesh| live.insert_wall(Point::new(1.0, 3.0), Point::new(2.0, 1.0));
    /// let mut floor = LiveMesh::new(map.clone())?;
    /// let crossing = wall(&mut floor)?;
    /// assert!(!floor.map().has_edge(diagonal)); // for the time being
    /// floor.remove(crossing)?;
    /// assert!(floor.map().has_edge(diagonal));
    /// // Grass above it, gravel below.
    /// let mut meadow = LiveMesh::with_areas(map, |f| f.number())?;
    /// wall(&mut meadow)?;
    /// assert!(meadow.map().has_edge(diagonal));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_areas(map: Subdivision, area: impl Fn(FaceId) -> u32) -> Result<Self, NavMeshError> {
        let areas = (0..map.face_bound() as u32).map(|f| area(FaceId::new(f))).collect();
        Self::begin(map, areas)
    }

    fn begin(mut map: Subdivision, areas: Vec<u32>) -> Result<Self, NavMeshError> {
        let mut mesh = NavMesh::new(&map)?;
        mesh.make_room_for_edits(&map);
        let book = Book::new(&map, areas);
        map.keep_ids();
        Ok(Self { map, mesh, book, work: EditWork::default() })
    }

    /// The area of a face of the mesh as it is now: that of the first map's face where it lies; 0 on a map that was made
    /// by [`new`](Self::new). `None` if it is no face of the mesh.
    #[must_use]
    pub fn area(&self, f: FaceId) -> Option<u32> {
        self.mesh.has_face(f).then(|| self.book.area(f))
    }

    /// The navmesh as it is now.
    #[must_use]
    pub fn mesh(&self) -> &NavMesh {
        &self.mesh
    }

    /// What the last edit that was not refused has touched.
    #[must_use]
    pub fn last_edit(&self) -> EditWork {
        self.work
    }

    /// Makes what exact queries run over now, not with the first of them; edits mend it: see
    /// [`merge_faces`](NavMesh::merge_faces).
    pub fn merge_faces(&mut self) -> usize {
        self.mesh.merge_faces()
    }

    /// Makes what queries for the fewest faces run over now, not with the first of them; edits mend it: see
    /// [`link_junctions`](NavMesh::link_junctions).
    pub fn link_junctions(&mut self) -> usize {
        self.mesh.link_junctions()
    }

    /// The map as it is now, with the obstacles and the cuts they need.
    #[must_use]
    pub fn map(&self) -> &Subdivision {
        &self.map
    }

    /// The map and its navmesh, as they are now.
    #[must_use]
    pub fn into_parts(mut self) -> (Subdivision, NavMesh) {
        self.map.release_ids();
        (self.map, self.mesh)
    }

    /// The obstacles in the map.
    #[must_use]
    pub fn obstacles(&self) -> Vec<ObstacleId> {
        self.book.obstacles().collect()
    }

    /// The corners of an obstacle as they were given, or the two ends of a wall; `None` if it is not in the map.
    #[must_use]
    pub fn corners(&self, obstacle: ObstacleId) -> Option<&[Point]> {
        self.book.obstacle(obstacle).map(|obstacle| obstacle.corners.as_slice())
    }

    /// Puts up a wall from `p` to `q`: a segment that nobody crosses. It may begin and end anywhere, on vertices, edges
    /// and other walls, too.
    ///
    /// Cuts that it crosses are taken out first, and others are made when it stands: none is ever bent. Edges of the
    /// given map between two faces are cuts, too, and come back under their ids when nothing crosses them any more.
    /// Borders of holes, of areas and of other obstacles are split where it crosses them, at the crossing as it is rounded.
    ///
    /// So that rounding leaves room between things, what is nearer than the 2^-47th part of the greatest coordinate counts
    /// as one: an end is put on a vertex that is as near, or else a line that is as near is led through it, and the wall is
    /// led through vertices that are as near. Nothing moves farther than that at a time.
    ///
    /// Cost: O(k log k) for k sides of the faces along the wall, and of the holes it reaches into; that of
    /// [`block`](NavMesh::block) for what it cuts off; and O(1) for each cell of the index for location into which the new
    /// faces reach, which long and thin ones do into many, up to the size of the map. Else it does not grow with the map, but
    /// for an index and lists that are made anew once the map has twice as many parts: O(1) for each part, over all edits.
    ///
    /// Besides, O(k) for each piece of the wall: borders of holes, of areas and of other obstacles cut it into pieces, and of
    /// each the face or hole in which it lies is looked at. So the cost is O(p k) for p pieces that lie in one hole of k sides.
    /// And O(m) for each edge or face that is split where m obstacles lie over each other: they are listed at it one by one.
    ///
    /// # Errors
    /// [`ObstacleError`]; then nothing has changed.
    pub fn insert_wall(&mut self, p: Point, q: Point) -> Result<ObstacleId, ObstacleError> {
        self.work = EditWork::default();
        self.insert(None, &[p, q])
    }

    /// Puts in an obstacle with these corners, counter-clockwise: a simple polygon that nobody enters.
    ///
    /// Cost: that of its sides as walls, O(faces inside), and O(k) for each vertex, or group of vertices, that loses all cuts
    /// to the rest of its surroundings, k being the sides of the faces along the obstacle: so O(k²) for a thin one round many
    /// vertices that only cuts across it hold.
    ///
    /// # Errors
    /// [`ObstacleError`]; then nothing has changed.
    pub fn insert_obstacle(&mut self, corners: &[Point]) -> Result<ObstacleId, ObstacleError> {
        Subdivision::polygon(corners)?;
        self.work = EditWork::default();
        self.insert(None, corners)
    }

    /// Moves an obstacle or a wall by a vector. It keeps its id.
    ///
    /// Cost: that of taking it out and putting it in.
    ///
    /// # Errors
    /// [`ObstacleError`]; then it stands where it stood.
    ///
    /// ```
    /// use dcel_kit::navmesh::{LiveMesh, Planner, PathAlgorithm};
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let hall = [(0., 0.), (8., 0.), (8., 4.), (0., 4.)].map(Point::from);
    /// let mut live = LiveMesh::new(Subdivision::polygon(&hall)?)?;
    /// let gate = live.insert_wall(Point::new(4.0, 1.0), Point::new(4.0, 4.0))?;
    /// live.move_obstacle(gate, [0.0, 2.0])?;
    /// assert_eq!(live.corners(gate), Some([Point::new(4.0, 3.0), Point::new(4.0, 6.0)].as_slice()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn move_obstacle(&mut self, obstacle: ObstacleId, [dx, dy]: [f64; 2]) -> Result<(), ObstacleError> {
        let corners = self.corners(obstacle).ok_or(ObstacleError::NoSuchObstacle { obstacle })?;
        let moved: Vec<Point> = corners.iter().map(|p| Point::new(p.x + dx, p.y + dy)).collect();
        self.reshape_obstacle(obstacle, &moved)
    }

    /// Gives an obstacle or a wall other corners. It keeps its id. Cost as for [`move_obstacle`](Self::move_obstacle).
    ///
    /// # Errors
    /// [`ObstacleError`]; then it stands where it stood.
    pub fn reshape_obstacle(&mut self, obstacle: ObstacleId, corners: &[Point]) -> Result<(), ObstacleError> {
        let before = self.corners(obstacle).ok_or(ObstacleError::NoSuchObstacle { obstacle })?.to_vec();
        if corners.len() != 2 {
            Subdivision::polygon(corners)?;
        }
        check_sides(&sides_of(corners))?;
        self.work = EditWork::default();
        self.take_out(obstacle)?;
        let moved = self.insert(Some(obstacle), corners);
        if moved.is_err() {
            // It has stood there before.
            self.insert(Some(obstacle), &before)?;
        }
        moved.map(drop)
    }

    /// Takes an obstacle out, and what it brought in: its borders are gone, the faces it covered are free unless another
    /// obstacle covers them, and so are the cuts and the corners that only it needed. With the last obstacle the map is
    /// what it was in the beginning: the same vertices, edges and faces, with the same ids, at the same points.
    ///
    /// While other obstacles are there, their cuts may stay, and a border that was bent by rounding where it was crossed
    /// stays bent if something stands in the way of the straight one. Edges between two faces of the given map come
    /// back as soon as nothing crosses them. Should the faces that are left be finer than
    /// doubles can tell, nothing but the borders goes now, and the rest with a later obstacle nearby.
    ///
    /// Cost: O(k log k) for k sides of the faces the obstacle touches, and of the holes it reaches into, and that of
    /// [`block`](NavMesh::block) for these faces.
    /// Besides, O(k) for each edge of the given map that comes back, as the face that it divides is looked at: so O(k²) where
    /// a long wall crossed many.
    ///
    /// # Errors
    /// [`ObstacleError::NoSuchObstacle`].
    pub fn remove(&mut self, obstacle: ObstacleId) -> Result<(), ObstacleError> {
        if self.book.obstacle(obstacle).is_none() {
            return Err(ObstacleError::NoSuchObstacle { obstacle });
        }
        self.work = EditWork::default();
        self.take_out(obstacle)
    }

    fn take_out(&mut self, obstacle: ObstacleId) -> Result<(), ObstacleError> {
        let (edges, covered) = self.book.strike(obstacle);
        self.book.forget(obstacle);
        let mut touched: BTreeSet<FaceId> = covered.into_iter().collect();
        touched.extend(edges.iter().flat_map(|e| e.half_edges()).map(|h| self.map.face(h)));
        let mut journal = Journal::new();
        let Self { map, book, .. } = self;
        book.begin();
        match map.all_or_nothing(&mut journal, |map, rec| clear(map, book, &edges, rec)) {
            Ok(returned) => book.put_returned(returned),
            Err(_) => book.roll_back(),
        }
        self.refresh(touched, &edges, &journal)
    }

    /// Puts in an obstacle, or a wall if it has two corners, under the given number or a new one.
    fn insert(&mut self, number: Option<ObstacleId>, corners: &[Point]) -> Result<ObstacleId, ObstacleError> {
        let covers = corners.len() > 2;
        let sides = &*sides_of(corners);
        check_sides(sides)?;
        let mut journal = Journal::new();
        let Self { map, mesh, book, .. } = self;
        let inserted = map.all_or_nothing(&mut journal, |map, rec| insert::cut_in(map, mesh, book, sides, rec))?;
        let obstacle = number.unwrap_or_else(|| book.add(corners));
        book.put_corners(obstacle, corners);
        let (mut begin, mut rim) = (0, Rim::default());
        for (side, (half_edges, end)) in inserted.sides.iter().enumerate() {
            book.follow(&journal.changes()[begin..*end]);
            rim.follow(&journal.changes()[begin..*end]);
            for &h in half_edges {
                book.put_border(h.edge(), (obstacle, side));
                rim.put(h);
            }
            begin = *end;
        }
        book.follow(&journal.changes()[begin..]);
        book.claim(obstacle);
        let edges = book.border_of(obstacle);
        let mut touched: BTreeSet<FaceId> = edges.iter().flat_map(|e| e.half_edges()).map(|h| map.face(h)).collect();
        if covers {
            let inside = rim.inside(map);
            inside.iter().for_each(|&face| book.cover(face, obstacle));
            touched.extend(inside);
        }
        self.refresh(touched, &edges, &journal)?;
        Ok(obstacle)
    }

    /// Reads anew what an edit has touched: these faces, those beside the edges, and all that the journal speaks of.
    fn refresh(&mut self, faces: BTreeSet<FaceId>, edges: &[EdgeId], journal: &Journal) -> Result<(), ObstacleError> {
        let (map, book) = (&self.map, &self.book);
        let is_hole = |f| map.has_face(f) && map.is_hole(f);
        let (mut faces, mut edges): (Vec<FaceId>, Vec<EdgeId>) = (faces.into_iter().collect(), edges.to_vec());
        let mut vertices = Vec::new();
        for change in journal.changes() {
            if let Change::Write { slot: Slot::Face(_), old: Some(Element::Face(old)), new: Some(Element::Face(new)) } =
                *change
                && is_hole(new)
                && !book.is_first(new)
            {
                self.mesh.put_hole(new, old);
            }
            match *change {
                Change::Write { slot: Slot::Origin(h) | Slot::Next(h) | Slot::Prev(h) | Slot::Face(h), .. } => {
                    let beside = [h, h.twin()].into_iter().filter(|&h| map.has_half_edge(h));
                    faces.extend(beside.map(|h| map.face(h)));
                }
                Change::Removed { element: Element::Face(f) } => {
                    self.mesh.forget_hole(f);
                    faces.push(f);
                }
                Change::Removed { element: Element::Edge(e) } => edges.push(e),
                Change::Added { element: Element::Vertex(v), .. } => vertices.push(v),
                _ => {}
            }
        }
        let mut faces = sorted(faces);
        // The number of a face that went may be that of a hole now.
        faces.retain(|&f| f != map.outer_face() && (!is_hole(f) || self.mesh.has_face(f)));
        let here = faces.iter().filter(|&&f| map.has_face(f));
        edges.extend(here.flat_map(|&f| map.incident_edges(f)));
        let walls: Vec<(EdgeId, bool)> = sorted(edges).into_iter().map(|e| (e, self.book.is_border(e))).collect();
        let faces: Vec<(FaceId, bool)> = faces.into_iter().map(|f| (f, self.book.is_covered(f))).collect();
        let before = self.mesh.counts();
        self.mesh.read_again(map, &faces, &walls, &vertices)?;
        let [cells, visited] = self.mesh.counts();
        self.work.links += journal.changes().len();
        self.work.faces += faces.len();
        self.work.cells += cells - before[0];
        self.work.visited += visited - before[1];
        Ok(())
    }
}

/// The sides of an obstacle with these corners, or the wall between two ends.
fn sides_of(corners: &[Point]) -> Vec<[Point; 2]> {
    let count = if corners.len() > 2 { corners.len() } else { 1 };
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(&p, &q)| [p, q]).take(count).collect()
}

/// Refuses coordinates that no point of a map may have, and sides without length.
fn check_sides(sides: &[[Point; 2]]) -> Result<(), ObstacleError> {
    for (side, &[p, q]) in sides.iter().enumerate() {
        let checked = p.check().and(q.check()).map_err(InsertSegmentError::from);
        let checked = if p == q { Err(InsertSegmentError::ZeroLength { at: p }) } else { checked };
        checked.map_err(|error| ObstacleError::Side { side, error })?;
    }
    Ok(())
}
