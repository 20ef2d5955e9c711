//! The shapes that grow from a ring or from the torus seed, with their counts and positions.
//!
//! ```text
//!   shape                        V                E              F            chi
//!   Ring n                       n                n              2            2
//!   Grid n x m, both sides       2nm + 2          4nm            2nm          2
//!   Cylinder n, m layers         n(m + 1)         n(2m + 1)      nm + 2       2
//!   Cone n, m layers             nm + 1           2nm            nm + 1       2
//!   FlatSphere n, m bands        n(m + 1)         n(2m + 1)      nm + 2       2
//!   Sphere n, m bands            n(m - 1) + 2     n(2m - 1)      nm           2
//!   Cuboid x, y, z               F + 2            2F             2(xy + yz + zx)   2
//!   Torus n x m                  nm               2nm            nm           0
//! ```

use super::cuboid::cuboid;
use super::grid::{Sides, backwards, divide, tessellate};
use super::placed::{Placed, part, stride};
use super::spun::{Profile, spin};
use super::{GrowError, Primitives};
use crate::ids::{EdgeId, FaceId, HalfEdgeId};
use crate::solid::{Polyhedron, Selection};
use crate::topology::{Dcel, TooMany};
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

/// The distance from the axis of a torus to the middle of its tube is 1; this is the radius of the tube.
const TUBE: f64 = 0.4;

/// A surface that grows from a seed by vertex splits and face splits. All shapes reach from -1 to 1 about the
/// origin, but for the torus, and face outwards.
///
/// ```
/// use dcel_kit::solid::grow::Shape;
/// let torus = Shape::Torus { n: 7, m: 5 }.build()?;
/// assert_eq!((torus.polyhedron.vertex_count(), torus.polyhedron.edge_count()), (35, 70));
/// let cube = Shape::CUBE.build()?;
/// assert_eq!(cube.creases.ids(1).count(), 12);
/// # Ok::<(), dcel_kit::solid::grow::GrowError>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Shape {
    /// A regular polygon with two faces, `f1` up and `f0` down. At least 3 sides.
    Ring {
        /// Corners.
        sides: usize,
    },
    /// A square cut in n by m, the front and the back each on its own.
    Grid {
        /// Columns, along x.
        n: usize,
        /// Rows, along y.
        m: usize,
    },
    /// A ring, extruded. At least 3 sides and 1 layer.
    Cylinder {
        /// Corners of the ring.
        sides: usize,
        /// Layers of walls.
        layers: usize,
    },
    /// A cylinder that narrows, with a pole as its apex. At least 3 sides and 1 layer.
    Cone {
        /// Corners of the ring.
        sides: usize,
        /// Layers, the one of triangles at the apex included.
        layers: usize,
    },
    /// A cylinder bent to a sphere: flat faces at both poles. At least 3 sides and 1 band.
    FlatSphere {
        /// Meridians.
        sides: usize,
        /// Bands of walls.
        bands: usize,
    },
    /// A sphere with a vertex at each pole. At least 3 sides and 2 bands.
    Sphere {
        /// Meridians.
        sides: usize,
        /// Bands, those of triangles at the poles included.
        bands: usize,
    },
    /// A box, each side cut in squares. At least 1 step along each axis.
    Cuboid {
        /// Steps along x.
        x: usize,
        /// Steps along y.
        y: usize,
        /// Steps along z.
        z: usize,
    },
    /// A torus about the z axis, from the seed with one vertex. Below 3 by 3 its faces lie flat on each other.
    Torus {
        /// Steps about the axis.
        n: usize,
        /// Steps about the tube.
        m: usize,
    },
}

/// A grown surface in space.
#[derive(Clone, PartialEq, Debug)]
pub struct Grown {
    /// The surface. It is closed.
    pub polyhedron: Polyhedron,
    /// What each face is part of; see [`part`].
    pub parts: Selection<FaceId>,
    /// Bit 0: a hard edge, between two parts.
    pub creases: Selection<EdgeId>,
}

impl Shape {
    /// The cube with 8 vertices.
    pub const CUBE: Self = Self::Cuboid { x: 1, y: 1, z: 1 };

    /// V, E and F of the finished shape, by the formulas at the head of this page; numbers beyond all ids come out
    /// as some number beyond all ids.
    #[must_use]
    pub fn counts(self) -> [usize; 3] {
        let times = |a: usize, b: usize| a.saturating_mul(b);
        let sum = |a: usize, b: usize| a.saturating_add(b);
        match self {
            Self::Ring { sides: n } => [n, n, 2],
            Self::Grid { n, m } => {
                let faces = times(2, times(n, m));
                [sum(faces, 2), times(2, faces), faces]
            }
            Self::Cylinder { sides: n, layers: m } | Self::FlatSphere { sides: n, bands: m } => {
                [times(n, sum(m, 1)), times(n, sum(times(2, m), 1)), sum(times(n, m), 2)]
            }
            Self::Cone { sides: n, layers: m } => {
                let walls = times(n, m);
                [sum(walls, 1), times(2, walls), sum(walls, 1)]
            }
            Self::Sphere { sides: n, bands: m } => {
                let inner = m.saturating_sub(1);
                [sum(times(n, inner), 2), times(n, sum(inner, m)), times(n, m)]
            }
            Self::Cuboid { x, y, z } => {
                let faces = times(2, sum(times(x, y), sum(times(y, z), times(z, x))));
                [sum(faces, 2), times(2, faces), faces]
            }
            Self::Torus { n, m } => [times(n, m), times(2, times(n, m)), times(n, m)],
        }
    }

    /// What the shape grows from: [`Dcel::polygon`] or [`Dcel::torus`].
    ///
    /// # Errors
    /// [`GrowError`] if a number is too small, or the finished shape has too many elements.
    pub fn seed(self) -> Result<Dcel, GrowError> {
        let numbers: &[(&'static str, usize, usize)] = match self {
            Self::Ring { sides } => &[("sides", sides, 3)],
            Self::Grid { n, m } => &[("columns", n, 1), ("rows", m, 1)],
            Self::Cylinder { sides, layers } | Self::Cone { sides, layers } => {
                &[("sides", sides, 3), ("layers", layers, 1)]
            }
            Self::FlatSphere { sides, bands } => &[("sides", sides, 3), ("bands", bands, 1)],
            Self::Sphere { sides, bands } => &[("sides", sides, 3), ("bands", bands, 2)],
            Self::Cuboid { x, y, z } => &[("steps along x", x, 1), ("steps along y", y, 1), ("steps along z", z, 1)],
            Self::Torus { n, m } => &[("steps about the axis", n, 1), ("steps about the tube", m, 1)],
        };
        if let Some(&(what, given, least)) = numbers.iter().find(|&&(_, given, least)| given < least) {
            return Err(GrowError::TooFew { what, given, least });
        }
        let [vertices, edges, faces] = self.counts();
        TooMany::check(vertices, edges, faces)?;
        Ok(match self {
            Self::Torus { .. } => Dcel::torus(),
            Self::Grid { .. } | Self::Cuboid { .. } => Dcel::polygon(4)?,
            Self::Ring { sides }
            | Self::Cylinder { sides, .. }
            | Self::Cone { sides, .. }
            | Self::FlatSphere { sides, .. }
            | Self::Sphere { sides, .. } => Dcel::polygon(sides)?,
        })
    }

    /// Grows the shape on its [`seed`](Self::seed), by vertex splits and face splits only.
    ///
    /// Cost: O(V + E + F), and for boxes O(x y z): each step of a box moves a whole side.
    ///
    /// # Errors
    /// [`GrowError`] as for the seed, or if `on` is not the seed.
    pub fn grow(self, on: &mut impl Primitives) -> Result<Placed, GrowError> {
        if *on.dcel() != self.seed()? {
            return Err(GrowError::NotTheSeed);
        }
        let parallel = |k: usize, m: usize| {
            let (sin, cos) = (PI * k as f64 / m as f64).sin_cos();
            [sin, -cos]
        };
        let spun = |rings: Vec<[f64; 2]>, bottom_pole, top_pole| Profile { rings, bottom_pole, top_pole };
        let mut placed = match self {
            Self::Ring { sides } => spin(on, sides, &spun(vec![[1.0, 0.0]], None, None))?,
            Self::Cylinder { sides, layers: m } => {
                spin(on, sides, &spun((0..=m).map(|k| [1.0, stride(k, m)]).collect(), None, None))?
            }
            Self::Cone { sides, layers: m } => {
                let ring = |k| [(m - k) as f64 / m as f64, stride(k, m)];
                spin(on, sides, &spun((0..m).map(ring).collect(), None, Some(1.0)))?
            }
            Self::FlatSphere { sides, bands: m } => {
                spin(on, sides, &spun((0..=m).map(|k| parallel(k + 1, m + 2)).collect(), None, None))?
            }
            Self::Sphere { sides, bands: m } => {
                spin(on, sides, &spun((1..m).map(|k| parallel(k, m)).collect(), Some(-1.0), Some(1.0)))?
            }
            Self::Cuboid { x, y, z } => cuboid(on, [x, y, z])?,
            Self::Grid { n, m } => grid(on, n, m)?,
            Self::Torus { n, m } => torus(on, n, m)?,
        };
        if !matches!(self, Self::FlatSphere { .. }) {
            let dcel = on.dcel();
            for e in dcel.edges() {
                let [one, other] = e.half_edges().map(|h| placed.parts.mask(dcel.face(h)));
                if one != other {
                    placed.creases.add(e, 1);
                }
            }
        }
        Ok(placed)
    }

    /// The shape in space.
    ///
    /// # Errors
    /// [`GrowError`] if a number is too small, or the shape has too many elements.
    pub fn build(self) -> Result<Grown, GrowError> {
        let mut dcel = self.seed()?;
        let Placed { points, parts, creases } = self.grow(&mut dcel)?;
        Ok(Grown { polyhedron: Polyhedron::assembled(dcel, points, BTreeSet::new()), parts, creases })
    }
}

fn half_edge(number: u32) -> HalfEdgeId {
    HalfEdgeId::new(number)
}

/// Both sides of a ring of four, each cut in n by m.
fn grid(on: &mut impl Primitives, n: usize, m: usize) -> Result<Placed, GrowError> {
    let front = Sides {
        bottom: divide(on, half_edge(0), n)?,
        right: divide(on, half_edge(2), m)?,
        top: divide(on, half_edge(4), n)?,
        left: divide(on, half_edge(6), m)?,
    };
    // Seen from behind, left is right.
    let back = Sides {
        bottom: backwards(&front.bottom),
        right: backwards(&front.left),
        top: backwards(&front.top),
        left: backwards(&front.right),
    };
    let mut placed = Placed::default();
    for (sides, bits) in [(front, part::TOP), (back, part::BOTTOM)] {
        for (k, v) in tessellate(on, &sides)?.into_iter().enumerate() {
            let (i, j) = (k % (n + 1), k / (n + 1));
            let column = if bits == part::TOP { i } else { n - i };
            placed.points.set(v, [stride(column, n), stride(j, m), 0.0], [0.0; 3]);
        }
        let dcel = on.dcel();
        let new = dcel.faces().filter(|&f| f != FaceId::new(0) || bits == part::BOTTOM);
        for face in new {
            if placed.parts.mask(face) == 0 {
                placed.parts.add(face, bits);
            }
        }
    }
    Ok(placed)
}

/// The steps of the grid on the torus seed: its one face, of which bottom and top are the same edge from both
/// sides, and left and right, too.
fn torus(on: &mut impl Primitives, n: usize, m: usize) -> Result<Placed, GrowError> {
    let (bottom, right) = (divide(on, half_edge(0), n)?, divide(on, half_edge(2), m)?);
    let sides = Sides { top: backwards(&bottom), left: backwards(&right), bottom, right };
    let table = tessellate(on, &sides)?;
    let mut placed = Placed::default();
    for (j, row) in table.chunks_exact(n + 1).take(m).enumerate() {
        let (height, out) = (TAU * j as f64 / m as f64).sin_cos();
        for (i, &v) in row[..n].iter().enumerate() {
            let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
            let radius = 1.0 + TUBE * out;
            placed.points.set(v, [radius * cos, radius * sin, TUBE * height], [0.0; 3]);
        }
    }
    on.dcel().faces().for_each(|face| placed.parts.add(face, part::SIDE));
    Ok(placed)
}
