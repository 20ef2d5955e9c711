//! The first line of a script.
//!
//! ```text
//!   of the plane     rectangle     polygon x y x y ...     triangles x y ... / i j k ...
//!   of the kernel    torus         ring N                  surface N / i j k ... / ...
//!   in space         solid NAME                            mesh x y z ... / i j k ... / ...
//! ```

use super::cursor::{Complaint, Cursor, show};
use super::error::Problem;
use super::kernel::KernelStart;
use super::words::lines;
use crate::plane::{ConvertError, ConvertOptions, Subdivision};
use crate::topology::{Dcel, PolygonList};

/// What to try when a script of the plane does not start well.
pub(super) const OF_THE_PLANE: &str = "a script starts with `rectangle`, `polygon x y x y …` or \
                                       `triangles x y … / i j k …`; without coordinates with `torus`, `ring N` or \
                                       `surface N / i j k … / …`";
/// What to try when a script of the kernel does not.
pub(super) const OF_THE_KERNEL: &str = "a script without coordinates starts with `torus`, `ring N` or \
                                        `surface N / i j k … / …`";
/// What to try when a script in space does not.
#[cfg(feature = "solid")]
pub(super) const OF_SPACE: &str = "a script in space starts with `solid tetrahedron`, `cube`, `octahedron`, \
                                   `dodecahedron` or `icosahedron`, or with `mesh x y z … / i j k … / …`";
/// All words that start a script.
const WORDS: [(&str, Ground); 8] = [
    ("rectangle", Ground::Plane),
    ("polygon", Ground::Plane),
    ("triangles", Ground::Plane),
    ("torus", Ground::Kernel),
    ("ring", Ground::Kernel),
    ("surface", Ground::Kernel),
    ("solid", Ground::Space),
    ("mesh", Ground::Space),
];

/// What a script is played on, as its first word says.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Ground {
    /// A [`Subdivision`]: [`Script::parse`](super::Script::parse).
    Plane,
    /// A [`Dcel`]: [`Script::parse_kernel`](super::Script::parse_kernel).
    Kernel,
    /// A surface in space: `Script::parse_solid`.
    Space,
}

impl Ground {
    /// What the script starts from. A text without a start counts as one of the plane, whose reader says what is wrong.
    #[must_use]
    pub fn of(text: &str) -> Self {
        Self::begun(text).unwrap_or(Self::Plane)
    }

    /// The same, and nothing where the first word of the text is no start.
    #[must_use]
    pub fn begun(text: &str) -> Option<Self> {
        lines(text).next().and_then(|line| start_word(line.words[0].text))
    }
}

/// What a script that begins with this word is played on.
pub(super) fn start_word(word: &str) -> Option<Ground> {
    WORDS.iter().find(|(start, _)| *start == word).map(|&(_, ground)| ground)
}

/// Whether the first word of a script is a start of the kernel: then
/// [`Script::parse_kernel`](super::Script::parse_kernel) reads it.
#[must_use]
pub fn is_kernel_script(text: &str) -> bool {
    Ground::of(text) == Ground::Kernel
}

/// The first line of a script of the plane.
pub(super) fn plane_start(line: &mut Cursor<'_>) -> Result<Subdivision, Complaint> {
    let word = line.need("a start", OF_THE_PLANE)?;
    line.statement = word.text;
    let built = match word.text {
        "rectangle" => {
            line.done()?;
            return Ok(Subdivision::lab_rectangle());
        }
        "polygon" => line.polygon()?,
        "triangles" => line.triangles()?,
        other => return Err(line.at(word, Problem::Start { word: show(other), first: true }, OF_THE_PLANE)),
    };
    built.map_err(|error| line.at(word, Problem::Convert(error), ""))
}

/// The first line of a script of the kernel.
pub(super) fn kernel_start(line: &mut Cursor<'_>) -> Result<Dcel, Complaint> {
    let word = line.need("a start", OF_THE_KERNEL)?;
    line.statement = word.text;
    let start = match word.text {
        "torus" => KernelStart::Torus,
        "ring" => KernelStart::Ring(line.count("`ring` takes the number of its corners: ring 5")?),
        "surface" => line.surface()?,
        other => return Err(line.at(word, Problem::Start { word: show(other), first: true }, OF_THE_KERNEL)),
    };
    line.done()?;
    start.build().map_err(|error| line.at(word, Problem::KernelStart(error), ""))
}

/// The first line of a script in space.
#[cfg(feature = "solid")]
pub(super) fn solid_start(line: &mut Cursor<'_>) -> Result<crate::solid::Polyhedron, Complaint> {
    use super::solid::SolidStart;
    use crate::solid::Platonic;
    let word = line.need("a start", OF_SPACE)?;
    line.statement = word.text;
    let start = match word.text {
        "solid" => {
            let name = line.need("the name of a solid", OF_SPACE)?;
            let known = Platonic::ALL.into_iter().find(|solid| solid.name() == name.text);
            let unknown = || line.at(name, Problem::Name { word: show(name.text) }, OF_SPACE);
            SolidStart::Platonic(known.ok_or_else(unknown)?)
        }
        "mesh" => line.mesh()?,
        other => return Err(line.at(word, Problem::Start { word: show(other), first: true }, OF_SPACE)),
    };
    line.done()?;
    start.build().map_err(|error| line.at(word, Problem::SolidStart(error), ""))
}

impl Cursor<'_> {
    #[cfg(feature = "solid")]
    fn mesh(&mut self) -> Result<super::solid::SolidStart, Complaint> {
        let help = "`mesh` takes x, y and z of the points and then, after a `/` each, the corners of every face: \
                    mesh 0 0 0 1 0 0 0 1 0 / 0 1 2";
        let mut points = Vec::new();
        while self.peek().is_none_or(|word| word.text != "/") {
            points.push([self.number("x", help)?, self.number("y", help)?, self.number("z", help)?]);
        }
        Ok(super::solid::SolidStart::Mesh { points, faces: self.faces(help)? })
    }

    fn polygon(&mut self) -> Result<Result<Subdivision, ConvertError>, Complaint> {
        let help = "`polygon` takes x and y of at least three corners, counter-clockwise";
        let mut corners = Vec::new();
        while corners.len() < 3 || self.peek().is_some() {
            corners.push(self.point(help)?);
        }
        Ok(Subdivision::polygon(&corners))
    }

    fn triangles(&mut self) -> Result<Result<Subdivision, ConvertError>, Complaint> {
        let help = "`triangles` takes x and y of the points, a `/`, and three points for each triangle: \
                    triangles 0 0 4 0 4 3 / 0 1 2";
        let mut points = Vec::new();
        while self.peek().is_none_or(|word| word.text != "/") {
            points.push(self.point(help)?);
        }
        self.next();
        let mut triangles = Vec::new();
        while triangles.is_empty() || self.peek().is_some() {
            let mut corner = || -> Result<u32, Complaint> {
                let word = self.need("three points for each triangle", help)?;
                let known = format!("the points are numbered from 0 to {}", points.len().saturating_sub(1));
                let number = word.text.parse().ok().filter(|&number: &u32| (number as usize) < points.len());
                let wanted = "the number of a point";
                number.ok_or_else(|| self.at(word, Problem::Number { word: show(word.text), wanted }, known))
            };
            triangles.push([corner()?, corner()?, corner()?]);
        }
        let options = ConvertOptions { full_check: true, ..ConvertOptions::default() };
        Ok(Subdivision::convert_triangles(points, &triangles, &options).map(|converted| converted.subdivision))
    }

    fn surface(&mut self) -> Result<KernelStart, Complaint> {
        let help = "`surface` takes the number of vertices and then, after a `/` each, the corners of every face: \
                    surface 4 / 0 1 2 / 0 2 3";
        let vertices = self.count(help)?;
        Ok(KernelStart::Surface { vertices, faces: self.faces(help)? })
    }

    /// `/ i j k ... / ...`
    fn faces(&mut self, help: &str) -> Result<PolygonList, Complaint> {
        let mut faces = PolygonList::new();
        while self.peek().is_some_and(|word| word.text == "/") {
            self.next();
            let mut corners = vec![self.count(help)? as u32];
            while self.peek().is_some_and(|word| word.text != "/") {
                corners.push(self.count(help)? as u32);
            }
            faces.push_face(&corners);
        }
        Ok(faces)
    }

    /// A number of elements, small enough to be built without a second thought.
    fn count(&mut self, help: &str) -> Result<usize, Complaint> {
        const MOST: usize = 1_000_000;
        let wanted = "a whole number up to 1000000";
        let word = self.need(wanted, help)?;
        let number = word.text.parse().ok().filter(|&number| number <= MOST);
        number.ok_or_else(|| self.at(word, Problem::Number { word: show(word.text), wanted }, help))
    }
}
