//! What is wrong with a navmesh as a sentence, with the names that a file has for its faces and vertices.
//!
//! ```text
//!   numbers          face 1 is not convex at vertex 4: split it there, or triangulate it
//!   names, places    features[1] "bow" polygon 0 is not convex at (8, 4): split it there, or triangulate it
//! ```

use super::fault::MeshFault;
use std::error::Error;
use std::fmt;

/// How a sentence calls faces and vertices. What has no name is called by its number.
pub struct FaultNames<'a> {
    /// The name of a face.
    pub face: &'a dyn Fn(u32) -> Option<String>,
    /// The name of a vertex: where it is, in files that have no numbers for them.
    pub vertex: &'a dyn Fn(u32) -> Option<String>,
}

const NUMBERS: FaultNames<'static> = FaultNames { face: &|_| None, vertex: &|_| None };

impl FaultNames<'_> {
    fn face(&self, f: u32) -> String {
        (self.face)(f).unwrap_or_else(|| format!("face {f}"))
    }

    fn vertex(&self, v: u32) -> String {
        (self.vertex)(v).unwrap_or_else(|| format!("vertex {v}"))
    }

    fn faces(&self, first: u32, second: u32) -> String {
        match ((self.face)(first), (self.face)(second)) {
            (None, None) => format!("faces {first} and {second}"),
            _ => format!("{} and {}", self.face(first), self.face(second)),
        }
    }

    fn vertices(&self, first: u32, second: u32) -> String {
        match ((self.vertex)(first), (self.vertex)(second)) {
            (None, None) => format!("vertices {first} and {second}"),
            _ => format!("{} and {}", self.vertex(first), self.vertex(second)),
        }
    }

    fn side(&self, [from, to]: [u32; 2]) -> String {
        let end = |v: u32| (self.vertex)(v).unwrap_or_else(|| v.to_string());
        format!("{} -> {}", end(from), end(to))
    }
}

impl MeshFault {
    /// The sentence, with these names in place of the numbers.
    ///
    /// ```
    /// use dcel_kit::navmesh::{FaultNames, MeshFault};
    /// let fault = MeshFault::NotConvex { face: 1, vertex: 4 };
    /// let names = FaultNames { face: &|_| Some("the hall".to_owned()), vertex: &|_| Some("(8, 4)".to_owned()) };
    /// assert_eq!(fault.sentence(&names), "the hall is not convex at (8, 4): split it there, or triangulate it");
    /// assert_eq!(fault.to_string(), "face 1 is not convex at vertex 4: split it there, or triangulate it");
    /// ```
    #[must_use]
    pub fn sentence(&self, names: &FaultNames<'_>) -> String {
        let (face, faces) = (|f: &u32| names.face(*f), |a: &u32, b: &u32| names.faces(*a, *b));
        let (vertex, vertices) = (|v: &u32| names.vertex(*v), |a: &u32, b: &u32| names.vertices(*a, *b));
        let side = |ends: &[u32; 2]| names.side(*ends);
        match self {
            Self::Coordinate { vertex: v, error } => format!("{}: {error}", vertex(v)),
            Self::NoSuchVertex { face: f, corner, vertices } => {
                let f = face(f);
                format!("{f} has the corner {corner}, but there are {vertices} vertices: correct the number")
            }
            Self::FewCorners { face: f, corners, distinct } => {
                let f = face(f);
                let help = "leave it out, or split it where it meets itself";
                format!("{f} has {distinct} different corners of {corners}: {help}")
            }
            Self::Rings { face: f, rings } => {
                let rings = if *rings == 1 { "1 ring".to_owned() } else { format!("{rings} rings") };
                format!("{} has {rings} inside: cut it into convex faces", face(f))
            }
            Self::Flat { face: f } => format!("{} has no area, its corners lie on one line: leave it out", face(f)),
            Self::Clockwise { face: f } => {
                let help = "list its corners the other way round, or flip y if it points down";
                format!("{} runs clockwise: {help}", face(f))
            }
            Self::NotConvex { face: f, vertex: v } => {
                format!("{} is not convex at {}: split it there, or triangulate it", face(f), vertex(v))
            }
            Self::Winds { face: f } => {
                let help = "it crosses itself; list its corners in their order round it";
                format!("{} goes round more than once: {help}", face(f))
            }
            Self::SameSide { first, second, from, to } => {
                let side = side(&[*from, *to]);
                let help = "they overlap, or one is turned round";
                format!("{} both lie on the left of {side}: {help}", faces(first, second))
            }
            Self::Overlap { first, second, sides: [one, other], at } => {
                let sides = format!("their sides {} and {}", side(one), side(other));
                format!("{} overlap: {sides} meet at {at}", faces(first, second))
            }
            Self::Covers { face: f, vertex: v } => {
                let help = "they overlap; cut a hole, or leave one out";
                format!("{} covers {} of other faces: {help}", face(f), vertex(v))
            }
            Self::TJunction { vertex: v, face: f, side: ends } => {
                let help = "give the face a corner there";
                format!("T-junction: {} lies on the side {} of {}: {help}", vertex(v), side(ends), face(f))
            }
            Self::SamePlace { first, second, at } => {
                let (first, second) = (*first, *second);
                format!("vertices {first} and {second} lie at the same place {at}: use one of them for both")
            }
            Self::DoubleCorner { vertex: v, holes } => {
                format!("double corner: at {} {holes} holes touch; nobody squeezes through between them", vertex(v))
            }
            Self::NearVertices { first, second, distance } => {
                let (both, apart) = (vertices(first, second), apart(*distance));
                format!("{both} are {apart}: if they are meant to be one, weld them")
            }
            Self::NearSide { vertex: v, face: f, side: ends, distance } => {
                let place = format!("{} the side {} of {}", beside(*distance), side(ends), face(f));
                format!("{} is {place}: if it is meant to be a corner there, weld them", vertex(v))
            }
            Self::Convert(error) => error.to_string(),
            Self::More { named } => {
                format!("there are more faults along sides than the {named} named here: correct these first")
            }
        }
    }
}

impl fmt::Display for MeshFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence(&NUMBERS))
    }
}

impl Error for MeshFault {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        if let Self::Convert(error) = self { error.source() } else { None }
    }
}

fn apart(distance: f64) -> String {
    if distance > 0.0 { format!("{distance:.2e} apart") } else { "at the same place".to_owned() }
}

fn beside(distance: f64) -> String {
    if distance > 0.0 { format!("{distance:.2e} beside") } else { "on".to_owned() }
}
