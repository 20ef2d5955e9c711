//! The algorithms that can be filmed, and which options each of them takes.

use super::About;
use crate::Failure;
use clap::ValueEnum;

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Algorithm {
    /// A walk round a face (--face) or a vertex (--vertex), half-edge by half-edge
    Walk,
    /// A walk from a vertex to a point (--start, --point), face by face
    Locate,
    /// Ear clipping of all faces, corner by corner
    Ears,
    /// Triangulation by monotone pieces: the sweep, then the pieces
    Monotone,
    /// Lawson's flips of a triangulation, until it is Delaunay
    Flips,
    /// The Voronoi diagram of points as the dual of their Delaunay triangulation
    Voronoi,
    /// The convex hull of points, from left to right and back
    Hull,
    /// The sweep that finds where segments cross
    Sweep,
    /// The funnel through the corridor of a path on a map (--from, --to)
    Funnel,
    /// The cones of the exact search for a path on a map (--from, --to)
    Cones,
    /// Hill climbing over a convex solid (--direction, --start)
    Climb,
    /// The convex hull of points in space, point by point
    SolidHull,
    /// Catmull–Clark subdivision of a surface (--steps)
    CatmullClark,
}

impl Algorithm {
    /// The word on the command line.
    pub(super) fn word(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// Whether it takes an option.
    fn takes(self, option: &str) -> bool {
        match self {
            Self::Walk => ["--face", "--vertex"].contains(&option),
            Self::Locate => ["--start", "--point"].contains(&option),
            Self::Funnel | Self::Cones => ["--from", "--to"].contains(&option),
            Self::Climb => ["--direction", "--start"].contains(&option),
            Self::CatmullClark => option == "--steps",
            Self::Ears | Self::Flips | Self::Hull | Self::Monotone | Self::SolidHull | Self::Sweep | Self::Voronoi => {
                false
            }
        }
    }

    /// Refuses options of other algorithms, and says what is missing.
    pub(super) fn check(self, about: &About) -> Result<(), Failure> {
        let given = [
            ("--face", about.face.is_some()),
            ("--vertex", about.vertex.is_some()),
            ("--start", about.start.is_some()),
            ("--point", about.point.is_some()),
            ("--from", about.from.is_some()),
            ("--to", about.to.is_some()),
            ("--direction", about.direction.is_some()),
            ("--steps", about.steps.is_some()),
        ];
        if let Some((option, _)) = given.iter().find(|(option, given)| *given && !self.takes(option)) {
            let all = Self::value_variants().iter();
            let whose: Vec<String> = all.filter(|other| other.takes(option)).map(|other| other.word()).collect();
            let what = format!("{option} is no option of the film {}", self.word());
            return Err(Failure::input(what, format!("it is for {}", whose.join(" and "))));
        }
        let missing = match self {
            Self::Walk if about.face.is_none() && about.vertex.is_none() => "--face f1, or --vertex v0",
            Self::Locate if about.point.is_none() => "--point X,Y, the point to be found",
            Self::Funnel | Self::Cones if about.from.is_none() || about.to.is_none() => {
                "--from X,Y and --to X,Y, the two ends of the path"
            }
            Self::Climb if about.direction.is_none() => "--direction X,Y,Z",
            _ => return Ok(()),
        };
        Err(Failure::input(format!("the film {} needs to be told more", self.word()), format!("give {missing}")))
    }
}
