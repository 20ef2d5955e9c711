//! The thirteen solids whose faces are regular, of two or three kinds, and whose corners are all alike.
//!
//! ```text
//!                                  round a corner    V    E    F      from regular faces with p corners, q at a
//!   truncated tetrahedron           3.6.6           12   18    8      vertex:
//!   truncated cube                  3.8.8           24   36   14
//!   truncated octahedron            4.6.6           24   36   14      truncated: edges cut at the ratio
//!   truncated dodecahedron          3.10.10         60   90   32        1 / (2 + 2 cos(pi / p))
//!   truncated icosahedron           5.6.6           60   90   32
//!   cuboctahedron                   3.4.3.4         12   24   14      rectified: edges halved
//!   icosidodecahedron               3.5.3.5         30   60   32
//!   rhombicuboctahedron             3.4.4.4         24   48   26      cantellated, all edges equal
//!   rhombicosidodecahedron          3.4.5.4         60  120   62
//!   truncated cuboctahedron         4.6.8           48   72   26      omnitruncated: the point of a flag is equally
//!   truncated icosidodecahedron     4.6.10         120  180   62        far from its three walls
//!   snub cube, left and right       3.3.3.3.4       24   60   38      snub: the turns about the corners of a flag
//!   snub dodecahedron, both hands   3.3.3.3.5       60  150   92        move its point equally far
//! ```
//!
//! Source: Pappus, *Collection*, book V, who gives them to Archimedes; J. Kepler, *Harmonices mundi*, book II.

use super::vector::{Vector, cross, dot, length, minus, times};
use super::wythoff::FlagWeights;
use super::{Hand, Platonic, Polyhedron};
use std::f64::consts::PI;
use std::fmt;

/// A solid with regular faces, made from a regular one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum Archimedean {
    /// The corners cut off, so that all edges are equal.
    Truncated(Platonic),
    /// 8 triangles and 6 squares: the cube or the octahedron with its edges halved.
    Cuboctahedron,
    /// 20 triangles and 12 pentagons: the icosahedron or the dodecahedron with its edges halved.
    Icosidodecahedron,
    /// 8 triangles and 18 squares: the faces of the cube moved apart.
    Rhombicuboctahedron,
    /// 20 triangles, 30 squares and 12 pentagons: the faces of the dodecahedron moved apart.
    Rhombicosidodecahedron,
    /// 12 squares, 8 hexagons and 6 octagons: a vertex for each flag of the cube.
    TruncatedCuboctahedron,
    /// 30 squares, 20 hexagons and 12 decagons: a vertex for each flag of the dodecahedron.
    TruncatedIcosidodecahedron,
    /// 32 triangles and 6 squares: the faces of the cube moved apart and twisted.
    SnubCube(Hand),
    /// 80 triangles and 12 pentagons: the faces of the dodecahedron moved apart and twisted.
    SnubDodecahedron(Hand),
}

impl Archimedean {
    /// All thirteen, two of them with both hands.
    pub const ALL: [Self; 15] = [
        Self::Truncated(Platonic::Tetrahedron),
        Self::Truncated(Platonic::Cube),
        Self::Truncated(Platonic::Octahedron),
        Self::Truncated(Platonic::Dodecahedron),
        Self::Truncated(Platonic::Icosahedron),
        Self::Cuboctahedron,
        Self::Icosidodecahedron,
        Self::Rhombicuboctahedron,
        Self::Rhombicosidodecahedron,
        Self::TruncatedCuboctahedron,
        Self::TruncatedIcosidodecahedron,
        Self::SnubCube(Hand::Left),
        Self::SnubCube(Hand::Right),
        Self::SnubDodecahedron(Hand::Left),
        Self::SnubDodecahedron(Hand::Right),
    ];
}

impl fmt::Display for Archimedean {
    /// `truncated-cube`, `cuboctahedron`, `snub-cube-left`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let hand = |hand| if hand == Hand::Left { "left" } else { "right" };
        match *self {
            Self::Truncated(solid) => write!(f, "truncated-{solid}"),
            Self::Cuboctahedron => f.write_str("cuboctahedron"),
            Self::Icosidodecahedron => f.write_str("icosidodecahedron"),
            Self::Rhombicuboctahedron => f.write_str("rhombicuboctahedron"),
            Self::Rhombicosidodecahedron => f.write_str("rhombicosidodecahedron"),
            Self::TruncatedCuboctahedron => f.write_str("truncated-cuboctahedron"),
            Self::TruncatedIcosidodecahedron => f.write_str("truncated-icosidodecahedron"),
            Self::SnubCube(way) => write!(f, "snub-cube-{}", hand(way)),
            Self::SnubDodecahedron(way) => write!(f, "snub-dodecahedron-{}", hand(way)),
        }
    }
}

impl Polyhedron {
    /// A solid with regular faces of two or three kinds round the origin.
    #[must_use]
    pub fn archimedean(solid: Archimedean) -> Self {
        let (cube, dodecahedron) = (Platonic::Cube, Platonic::Dodecahedron);
        let made = match solid {
            Archimedean::Truncated(solid) => {
                let ratio = 1.0 / (2.0 + 2.0 * (PI / f64::from(solid.corners())).cos());
                Self::platonic(solid).truncated(ratio)
            }
            Archimedean::Cuboctahedron => Self::platonic(cube).rectified(),
            Archimedean::Icosidodecahedron => Self::platonic(Platonic::Icosahedron).rectified(),
            Archimedean::Rhombicuboctahedron => Self::platonic(cube).evenly_cantellated(),
            Archimedean::Rhombicosidodecahedron => Self::platonic(dodecahedron).evenly_cantellated(),
            Archimedean::TruncatedCuboctahedron => Self::platonic(cube).evenly_omnitruncated(),
            Archimedean::TruncatedIcosidodecahedron => Self::platonic(dodecahedron).evenly_omnitruncated(),
            Archimedean::SnubCube(hand) => Self::platonic(cube).evenly_snub(cube, hand),
            Archimedean::SnubDodecahedron(hand) => Self::platonic(dodecahedron).evenly_snub(dodecahedron, hand),
        };
        made.expect("a regular solid is closed and has three edges at each vertex")
    }

    /// The corner, the middle of the edge and the mean of the face of the first half-edge of a regular solid.
    fn first_flag(&self) -> [Vector; 3] {
        self.half_edges().next().map_or([[0.0; 3]; 3], |h| self.flag(h, h))
    }

    /// A face with edges of length a is shrunk to t a, and parts from its neighbour by (1 - t) times the distance d
    /// of their means: both are equal at t = d / (a + d). That distance is twice the one from the mean to the middle
    /// of the edge, seen at right angles to the line from the origin through that middle.
    fn evenly_cantellated(&self) -> Result<Self, super::TruncateError> {
        let [corner, middle, mean] = self.first_flag();
        let edge = 2.0 * length(minus(corner, middle));
        let apart = 2.0 * length(cross(mean, middle)) / length(middle);
        self.cantellated(apart / (edge + apart))
    }

    fn evenly_omnitruncated(&self) -> Result<Self, super::TruncateError> {
        self.omnitruncated(even_weights(self.first_flag()))
    }

    fn evenly_snub(&self, solid: Platonic, hand: Hand) -> Result<Self, super::TruncateError> {
        let turns = [f64::from(solid.edges_at_a_vertex()), 2.0, f64::from(solid.corners())];
        self.snub(snub_weights(self.first_flag(), turns), hand)
    }
}

/// The point that is equally far from the three planes through the origin and two of the corners of a flag.
fn even_weights(flag: [Vector; 3]) -> FlagWeights {
    std::array::from_fn(|i| {
        let wall = cross(flag[(i + 1) % 3], flag[(i + 2) % 3]);
        length(wall) / dot(flag[i], wall).abs()
    })
}

/// The point that is moved equally far by the turns about the axes through the corners of a flag: by 1 / `turns` of a
/// full one each. Newton's rule, from the point that is equally far from the walls.
fn snub_weights(flag: [Vector; 3], turns: [f64; 3]) -> FlagWeights {
    /// Each step doubles the digits, beginning with one: five reach the last.
    const STEPS: usize = 8;
    let axes = flag.map(|corner| times(corner, 1.0 / length(corner)));
    // The way of a point at distance r from an axis is 2 r sin(pi / turns).
    let sines = turns.map(|turns| (PI / turns).sin().powi(2));
    let mut weights = even_weights(flag);
    for _ in 0..STEPS {
        let point: Vector = std::array::from_fn(|x| (0..3).map(|i| weights[i] * flag[i][x]).sum());
        let way = |i: usize| sines[i] * (dot(point, point) - dot(point, axes[i]).powi(2));
        let slope = |i: usize, by: usize| {
            2.0 * sines[i] * (dot(point, flag[by]) - dot(point, axes[i]) * dot(flag[by], axes[i]))
        };
        let wrong = [way(2) - way(1), way(0) - way(1)];
        let slopes = [2, 0].map(|i| [slope(i, 0) - slope(1, 0), slope(i, 1) - slope(1, 1)]);
        let size = slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0];
        weights[0] -= (wrong[0] * slopes[1][1] - wrong[1] * slopes[0][1]) / size;
        weights[1] -= (wrong[1] * slopes[0][0] - wrong[0] * slopes[1][0]) / size;
    }
    weights
}
