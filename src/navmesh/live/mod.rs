//! A map with obstacles that come and go.
//!
//! ```text
//!   ┌─────────┐   insert_wall     ┌──●──────┐   the wall is cut into the map by the edits of the plane; faces that
//!   │  f1     │  ────────────>    │  ║╲ f3  │   are no longer convex are cut further; the edges along it are closed
//!   │         │                   │f1║ ╲    │
//!   └─────────┘                   └──●──╲───┘   remove: they are doors again. The cuts stay.
//! ```
//!
//! The flat view is brought up to date near the cut only: faces, fans, turns, dead ends, components, index.

mod cut;

use super::{NavMesh, NavMeshError};
use crate::ids::{EdgeId, FaceId, HalfEdgeId};
use crate::plane::{ConvertError, InsertSegmentError, Point, Subdivision};
use crate::topology::{Change, Journal, Slot};
use cut::{cut, inside};
use std::collections::{BTreeMap, BTreeSet};

/// An obstacle of a [`LiveMesh`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ObstacleId(pub u32);

impl std::fmt::Display for ObstacleId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "obstacle {}", self.0)
    }
}

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
    #[error("the obstacle is no simple polygon in counter-clockwise order: {0}")]
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

/// Who closes what.
#[derive(Clone, Debug, Default, PartialEq)]
struct Book {
    /// The obstacles whose border runs along an edge.
    borders: BTreeMap<EdgeId, BTreeSet<ObstacleId>>,
    /// The obstacles that cover a face.
    covers: BTreeMap<FaceId, BTreeSet<ObstacleId>>,
    next: u32,
}

/// A map, its navmesh, and the obstacles in it.
///
/// ```
/// use dcel_kit::navmesh::{LiveMesh, Planner, Rung};
/// use dcel_kit::plane::{Point, Subdivision};
/// let at = |x, y| Point::new(x, y);
/// let hall = Subdivision::polygon(&[at(0., 0.), at(8., 0.), at(8., 4.), at(0., 4.)])?;
/// let mut live = LiveMesh::new(hall)?;
/// let mut length = |live: &LiveMesh| {
///     Planner::new().route_between(live.mesh(), Rung::Exact, at(1., 2.), at(7., 2.)).map(|route| route.length)
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
}

impl LiveMesh {
    /// A map without obstacles.
    ///
    /// # Errors
    /// [`NavMeshError`], as for [`NavMesh::new`].
    pub fn new(map: Subdivision) -> Result<Self, NavMeshError> {
        let mesh = NavMesh::new(&map)?;
        Ok(Self { map, mesh, book: Book::default() })
    }

    /// The navmesh as it is now.
    #[must_use]
    pub fn mesh(&self) -> &NavMesh {
        &self.mesh
    }

    /// The map, with all cuts that were ever made.
    #[must_use]
    pub fn map(&self) -> &Subdivision {
        &self.map
    }

    /// The obstacles in the map.
    #[must_use]
    pub fn obstacles(&self) -> Vec<ObstacleId> {
        let all: BTreeSet<ObstacleId> = self.book.borders.values().flatten().copied().collect();
        all.into_iter().collect()
    }

    /// Puts up a wall from `p` to `q`: a segment that nobody crosses. It may begin and end anywhere.
    ///
    /// Cost: that of [`insert_segment`](Subdivision::insert_segment); then O(size of the faces along the wall), and
    /// that of [`block`](NavMesh::block) for what it cuts off. If it cuts a gap in two, O(n) to name the gaps anew.
    ///
    /// # Errors
    /// [`ObstacleError`]; then nothing has changed.
    pub fn insert_wall(&mut self, p: Point, q: Point) -> Result<ObstacleId, ObstacleError> {
        self.insert(&[[p, q]], false)
    }

    /// Puts in an obstacle with these corners, counter-clockwise: a simple polygon that nobody enters.
    ///
    /// Cost: that of its sides as walls, and O(faces inside).
    ///
    /// # Errors
    /// [`ObstacleError`]; then nothing has changed.
    pub fn insert_obstacle(&mut self, corners: &[Point]) -> Result<ObstacleId, ObstacleError> {
        Subdivision::polygon(corners)?;
        let next = corners.iter().cycle().skip(1);
        let sides: Vec<[Point; 2]> = corners.iter().zip(next).map(|(&p, &q)| [p, q]).collect();
        self.insert(&sides, true)
    }

    /// Takes an obstacle out: its borders are doors again, and the faces it covered are free, unless another obstacle
    /// closes them. The cuts stay in the map, as doors between convex faces: the next obstacle at the same place
    /// costs less, and a map of many obstacles that came and went is finer than it has to be.
    ///
    /// Cost: that of [`block`](NavMesh::block) for its faces, and O(number of all borders).
    ///
    /// # Errors
    /// [`ObstacleError::NoSuchObstacle`].
    pub fn remove(&mut self, obstacle: ObstacleId) -> Result<(), ObstacleError> {
        let edges: Vec<EdgeId> = with(&self.book.borders, obstacle);
        let faces: Vec<FaceId> = with(&self.book.covers, obstacle);
        if edges.is_empty() {
            return Err(ObstacleError::NoSuchObstacle { obstacle });
        }
        edges.iter().for_each(|e| drop_owner(&mut self.book.borders, *e, obstacle));
        faces.iter().for_each(|f| drop_owner(&mut self.book.covers, *f, obstacle));
        let beside = edges.iter().flat_map(|e| e.half_edges()).map(|h| self.map.face(h));
        let touched: BTreeSet<FaceId> = beside.chain(faces.iter().copied()).collect();
        self.refresh(&touched, &edges)
    }

    fn insert(&mut self, sides: &[[Point; 2]], covers: bool) -> Result<ObstacleId, ObstacleError> {
        let mut book = self.book.clone();
        let obstacle = ObstacleId(book.next);
        book.next += 1;
        let mut journal = Journal::new();
        let border = self.map.all_or_nothing(&mut journal, |map, rec| {
            let mut border: Vec<HalfEdgeId> = Vec::new();
            for (side, &[p, q]) in sides.iter().enumerate() {
                let inserted = map.insert_segment_with(p, q, rec);
                border.extend(inserted.map_err(|error| ObstacleError::Side { side, error })?.half_edges);
            }
            cut(map, rec)?;
            Ok::<_, ObstacleError>(border)
        })?;
        book.follow(&journal);
        let edges: Vec<EdgeId> = border.iter().map(|h| h.edge()).collect();
        for &edge in &edges {
            book.borders.entry(edge).or_default().insert(obstacle);
        }
        let mut touched = touched_faces(&self.map, &journal);
        touched.extend(edges.iter().flat_map(|e| e.half_edges()).map(|h| self.map.face(h)));
        if covers {
            let inside = inside(&self.map, &border);
            for &face in &inside {
                book.covers.entry(face).or_default().insert(obstacle);
            }
            touched.extend(inside);
        }
        self.book = book;
        self.refresh(&touched, &edges)?;
        let new_gap = |change: &Change| match *change {
            Change::Added { element: crate::Element::Face(f), .. } => self.map.is_hole(f),
            _ => false,
        };
        if journal.changes().iter().any(new_gap) {
            self.mesh.index_all(&self.map);
        }
        Ok(obstacle)
    }

    /// Reads the faces anew, and what is closed among them.
    fn refresh(&mut self, touched: &BTreeSet<FaceId>, edges: &[EdgeId]) -> Result<(), ObstacleError> {
        let is_face = |f: &FaceId| *f != self.map.outer_face() && !self.map.is_hole(*f);
        let faces: Vec<FaceId> = touched.iter().copied().filter(is_face).collect();
        let of_faces = faces.iter().flat_map(|&f| self.map.incident_edges(f));
        let edges: BTreeSet<EdgeId> = of_faces.chain(edges.iter().copied()).collect();
        let walls: Vec<(EdgeId, bool)> = edges.into_iter().map(|e| (e, self.book.borders.contains_key(&e))).collect();
        let blocked: Vec<bool> = faces.iter().map(|f| self.book.covers.contains_key(f)).collect();
        self.mesh.read_again(&self.map, &faces, &blocked, &walls)?;
        Ok(())
    }
}

/// The elements that an obstacle closes.
fn with<K: Copy + Ord>(owners: &BTreeMap<K, BTreeSet<ObstacleId>>, obstacle: ObstacleId) -> Vec<K> {
    owners.iter().filter(|(_, owners)| owners.contains(&obstacle)).map(|(&key, _)| key).collect()
}

fn drop_owner<K: Copy + Ord>(owners: &mut BTreeMap<K, BTreeSet<ObstacleId>>, key: K, obstacle: ObstacleId) {
    if let Some(set) = owners.get_mut(&key) {
        set.remove(&obstacle);
        if set.is_empty() {
            owners.remove(&key);
        }
    }
}

impl Book {
    /// What was split hands its owners on to both parts.
    fn follow(&mut self, journal: &Journal) {
        let mut last_edge = None;
        for change in journal.changes() {
            match *change {
                Change::Added { element: crate::Element::Edge(e), .. } => last_edge = Some(e),
                // The twin of the half-edge that is split starts at the new vertex from now on.
                Change::Write { slot: Slot::Origin(h), old: Some(_), new: Some(_) } => {
                    if let (Some(e), Some(owners)) = (last_edge, self.borders.get(&h.edge()).cloned()) {
                        self.borders.insert(e, owners);
                    }
                }
                Change::Write {
                    slot: Slot::Face(_),
                    old: Some(crate::Element::Face(old)),
                    new: Some(crate::Element::Face(new)),
                } => {
                    if let Some(owners) = self.covers.get(&old).cloned() {
                        self.covers.insert(new, owners);
                    }
                }
                _ => {}
            }
        }
    }
}

/// The faces beside every half-edge that the changes speak of.
fn touched_faces(map: &Subdivision, journal: &Journal) -> BTreeSet<FaceId> {
    let half_edge = |change: &Change| match *change {
        Change::Write { slot: Slot::Origin(h) | Slot::Next(h) | Slot::Prev(h) | Slot::Face(h), .. } => Some(h),
        _ => None,
    };
    let changed = journal.changes().iter().filter_map(half_edge).filter(|&h| map.has_half_edge(h));
    changed.flat_map(|h| [map.face(h), map.face(h.twin())]).collect()
}
