//! The first line of a script.
//!
//! ```text
//!   of the plane     rectangle     polygon x y x y ...     triangles x y ... / i j k ...
//!   of the kernel    torus         ring N                  surface N / i j k ... / ...
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
/// All words that start a script, those of the plane first.
pub(super) const WORDS: [&str; 6] = ["rectangle", "polygon", "triangles", "torus", "ring", "surface"];

/// Whether the first word of a script is a start of the kernel: then
/// [`Script::parse_kernel`](super::Script::parse_kernel) reads it.
#[must_use]
pub fn is_kernel_script(text: &str) -> bool {
    lines(text).next().is_some_and(|line| WORDS[3..].contains(&line.words[0].text))
}

impl Cursor<'_> {
    /// The first line of a script of the plane.
    pub(super) fn plane_start(&mut self) -> Result<Subdivision, Complaint> {
        let word = self.need("a start", OF_THE_PLANE)?;
        self.statement = word.text;
        let built = match word.text {
            "rectangle" => {
                self.done()?;
                return Ok(Subdivision::lab_rectangle());
            }
            "polygon" => self.polygon()?,
            "triangles" => self.triangles()?,
            other => return Err(self.at(word, Problem::Start { word: show(other), first: true }, OF_THE_PLANE)),
        };
        built.map_err(|error| self.at(word, Problem::Convert(error), ""))
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

    /// The first line of a script of the kernel.
    pub(super) fn kernel_start(&mut self) -> Result<Dcel, Complaint> {
        let word = self.need("a start", OF_THE_KERNEL)?;
        self.statement = word.text;
        let start = match word.text {
            "torus" => KernelStart::Torus,
            "ring" => KernelStart::Ring(self.count("`ring` takes the number of its corners: ring 5")?),
            "surface" => self.surface()?,
            other => return Err(self.at(word, Problem::Start { word: show(other), first: true }, OF_THE_KERNEL)),
        };
        self.done()?;
        start.build().map_err(|error| self.at(word, Problem::KernelStart(error), ""))
    }

    fn surface(&mut self) -> Result<KernelStart, Complaint> {
        let help = "`surface` takes the number of vertices and then, after a `/` each, the corners of every face: \
                    surface 4 / 0 1 2 / 0 2 3";
        let vertices = self.count(help)?;
        let mut faces = PolygonList::new();
        while self.peek().is_some_and(|word| word.text == "/") {
            self.next();
            let mut corners = vec![self.count(help)? as u32];
            while self.peek().is_some_and(|word| word.text != "/") {
                corners.push(self.count(help)? as u32);
            }
            faces.push_face(&corners);
        }
        Ok(KernelStart::Surface { vertices, faces })
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
